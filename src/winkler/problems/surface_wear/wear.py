r"""A height map that slides and wears: Archard's law in every pixel, and how a rough surface runs in.

.. math:: \frac{\mathrm dh}{\mathrm ds} = \kappa\,p(x,y)

with the pressures of the worn map by boundary elements.  Peaks that bear most lose most: pressures even out, under a
force to :math:`F/A`.  Where a periodic map touches all over, each of its waves q decays like
:math:`e^{-\kappa E^* q s/2}`.

How the wear of a height map is followed: in steps that are taken once whole and once in halves.

What both differ by, over three, is the error of the halves, which are kept; it decides how far the next step goes.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Iterator
from typing import Annotated, Any, ClassVar, NamedTuple

import numpy as np

from winkler.laws.wear import Archard
from winkler.loading.loads import Depth
from winkler.loading.path import numbers_of
from winkler.media.mapped import layers_of
from winkler.media.offers import GradedInDepth, LayerStack, offers
from winkler.numerics.pixels.contact_area import contact_area
from winkler.numerics.surfaces.pressed_box import ByDepth, ByLoad
from winkler.numerics.surfaces.pressed_grid import PressedSurface
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.rough.mapped_medium import medium_notes
from winkler.problems.rough.surface_contact import SurfaceContact
from winkler.problems.surface_wear.states import MapWear, SurfaceWearState
from winkler.problems.surface_wear.worn_map import WornMap
from winkler.problems.wear.states import goals_of
from winkler.problems.wear.validity import DEBRIS, SLIDES_EVERYWHERE
from winkler.profiles.rough.topography import Topography
from winkler.values.checks.number_checks import FiniteQuantity, between
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing, standing_of
from winkler.values.value import value, words


@value
class SurfaceWear:
    """Wear of a height map that slides under a steady load.

    Parameters
    ----------
    contact : SurfaceContact
        The map before wear and its load: one force, or one constant depth.
    wear : Archard
        Law of wear of the map.
    distance : float or ndarray, (steps,)
        Sliding distances [m] after which the contact is returned, summed over both directions; one number gives 41
        states up to it.
    tolerance : float, optional
        Maximum error of the worn depth in one step, over the maximum worn depth.

    Raises
    ------
    InvalidInput
        If the contact has several loads, the distances do not rise, or a number is out of range.

    References
    ----------
    J. F. Archard, J. Appl. Phys. 24 (1953) 981-988, doi:10.1063/1.1721448
    R. Alexander, SIAM J. Numer. Anal. 14 (1977) 1006-1021, doi:10.1137/0714068

    Examples
    --------
    A wave that is pressed flat wears down: its amplitude and that of the pressure decay like exp(-k E* q s / 2).

    >>> import numpy as np
    >>> from winkler.laws.wear import Archard
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.rough.topography import Topography
    >>> x = np.arange(32) / 32
    >>> wave = Topography(0.01 * np.cos(2.0 * np.pi * x[:, None]) + 0.0 * x, [1.0, 1.0], periodic=True)
    >>> contact = SurfaceContact(wave, HalfSpace(Elastic(1.0, 0.0)), Force(0.1))
    >>> worn = SurfaceWear(contact, Archard(1.0), [0.0, 0.5 / np.pi], tolerance=1e-4).solve()
    >>> round(float(worn.rms_height[1] / worn.rms_height[0]), 4), round(float(np.exp(-0.5)), 4)
    (0.6065, 0.6065)
    """

    __words__ = words(
        contact=("", None, "how the map is pressed before wear"),
        distance=("s", "m", "distance slid"),
        goals=("s", "m", "after which distances the contact is returned"),
        tolerance=(r"\epsilon", "", "error of the worn depth in one step, over the greatest worn depth"),
    )

    contact: SurfaceContact
    wear: Archard
    distance: FiniteQuantity
    tolerance: Annotated[float, between(1e-7, 1e-2)] = 1e-3

    references: ClassVar[tuple[str, ...]] = ("archard_1953", "polonsky_keer_1999")
    assumptions: ClassVar[frozenset[Assumption]] = MAPPED | {Assumption.WEAR}

    def __post_init__(self) -> None:
        loads = numbers_of(self.contact.load)
        if loads.size != 1:
            raise InvalidInput(
                f"SurfaceWear: the contact has {loads.size} loads; give Force(F) or Depth(d) with one number, and "
                "sweep over several."
            )
        _ = self.goals  # refused if they do not rise

    @property
    def goals(self) -> Array:
        """Distances at which the contact is returned [m], ``(steps,)``."""
        return goals_of("SurfaceWear", "distance", " in m", self.distance)

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for each of `goals`."""
        return int(self.goals.size)

    def _surface(self) -> WornMap:
        stated, rough = self.contact, self.contact.topography
        modulus, patch = stated.medium.modulus, rough.pixel[0] * rough.pixel[1]
        load = float(np.ravel(numbers_of(stated.load))[0])
        drive = ByDepth(load) if isinstance(stated.load, Depth) else ByLoad(load / (modulus * patch))
        return WornMap(
            rough.gaps, rough.pixel, rough.periodic, layers_of(stated.medium), stated.hardness / modulus, drive,
            modulus * self.wear.rate, stated.tolerance,
        )  # fmt: skip

    def steps(self, start: SurfaceWearState | None = None) -> Iterator[SurfaceWearState]:
        """Yield the contact at every requested distance.

        Parameters
        ----------
        start : SurfaceWearState, optional
            A state from an earlier run of this problem, also with other distances. The computation continues from it,
            with the same numbers as without interruption.

        Raises
        ------
        InvalidInput
            If the state belongs to another map.
        NotConverged
            If a contact is not solved to its tolerance, or steps become too short.
        OutsideValidity
            If the pixels are too coarse for the layers.
        """
        surface = self._surface()
        if start is not None and start.worn.shape != surface.gaps.shape:
            raise InvalidInput(
                f"SurfaceWear: the state has a map of {start.worn.shape} pixels, the contact one of "
                f"{surface.gaps.shape}; give the last state of this problem."
            )
        try:
            if start is None:
                state = self._state(begin(surface))
                if self.goals[0] == 0.0:
                    yield state
            else:
                state = start
            for goal in self.goals[self.goals > state.distance].tolist():
                # from what the state holds, so that a march that goes on from it rounds alike
                state = self._state(go(surface, goal, self._moment(state), self.tolerance))
                yield state
        except NotConverged as error:
            raise NotConverged(f"SurfaceWear: {error}") from None
        except OutsideValidity as error:
            raise OutsideValidity(f"SurfaceWear: {error}") from None

    def _moment(self, state: SurfaceWearState) -> MapMoment:
        rough, modulus = self.contact.topography, self.contact.medium.modulus
        contact = PressedSurface(
            state.pressure / modulus, state.separation, state.depth, state.penetration, state.misfit, 0
        )
        carried = state.load_distance / (modulus * rough.pixel[0] * rough.pixel[1])
        return MapMoment(state.distance, state.jump, carried, state.worn, contact)

    def _state(self, moment: MapMoment) -> SurfaceWearState:
        rough, modulus = self.contact.topography, self.contact.medium.modulus
        contact, patch = moment.contact, rough.pixel[0] * rough.pixel[1]
        worn = Topography(rough.heights - moment.worn, rough.lengths, rough.periodic)
        bumpy = worn.rms_height > 0.0
        carried = modulus * patch * moment.load_distance
        lost, expected = patch * float(np.sum(moment.worn)), self.wear.rate * carried
        force, peak = modulus * patch * float(np.sum(contact.pressure)), modulus * float(np.max(contact.pressure))
        least = force / peak if peak > 0.0 else 0.0  # worn spots bear up to their edge
        return SurfaceWearState(
            moment.elapsed, contact.depth, force,
            *contact_area(contact.pressure > 0.0, rough.pixel, rough.periodic, least), peak,
            max(float(np.mean(contact.gap)), 0.0), worn.rms_height, worn.skewness if bumpy else 0.0,
            worn.kurtosis if bumpy else 0.0, float(np.max(moment.worn)), lost, carried,
            abs(lost / expected - 1.0) if expected > 0.0 else 0.0,
            contact.penetration, contact.work,
            moment.jump, moment.worn, modulus * contact.pressure, np.maximum(contact.gap, 0.0),
        )  # fmt: skip

    def gathered(self, states: Iterable[SurfaceWearState]) -> SurfaceWearSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        first = last = None
        rows: list[list[float]] = []
        names = [field.name for field in dataclasses.fields(MapWear)]
        for state in states:  # the maps of the first and the last alone are kept
            first, last = first or state, state
            rows.append([getattr(state, name) for name in names])
        if first is None or last is None:
            raise InvalidInput("SurfaceWear: there is no state to gather; give at least one.")
        columns: dict[str, Any] = dict(zip(names, np.array(rows).T, strict=True))
        return SurfaceWearSolution(**columns, problem=self, first=first, last=last)

    def solve(self) -> SurfaceWearSolution:
        """Return the contact over the whole distance.

        Returns
        -------
        SurfaceWearSolution

        Raises
        ------
        NotConverged, OutsideValidity
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class SurfaceWearSolution(MapWear[Array]):
    """The solution of a `SurfaceWear`, distance by distance; its numbers are those of `MapWear`.

    Parameters
    ----------
    problem : SurfaceWear
        The problem that was solved.
    first, last : SurfaceWearState
        The states at the first and the last distance, with their maps; ``problem.steps(start=last)`` continues.
    """

    __words__ = words(
        first=("", None, "the state at the first distance"),
        last=("", None, "the state at the last distance"),
        mean_pressure=("p_m", "Pa", "force over the area of contact"),
    )

    problem: SurfaceWear
    first: SurfaceWearState
    last: SurfaceWearState

    @property
    def mean_pressure(self) -> Array:
        """F / A [Pa], ``(steps,)``; zero if a map at constant depth has lost contact."""
        return np.divide(self.force, self.area, out=np.zeros_like(self.force), where=self.area > 0.0)

    def worn_topography(self) -> Topography:
        """Return the worn map of the last state; its heights have the same reference as before wear."""
        rough = self.problem.contact.topography
        return Topography(rough.heights - self.last.worn, rough.lengths, rough.periodic)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: the contact, the law, the steps."""
        stated = self.problem.contact
        touching = self.area > 0.0
        blurred = float(np.max(self.area_error[touching] / self.area[touching], initial=0.0))
        return (
            *medium_notes(stated.medium, stated.topography, stated.hardness, blurred, self.penetration, self.misfit),
            *wear_notes(stated, self.problem.tolerance, self.last),
        )


FIRST_SHARE = 1e-2
"""Part of the depth that the first step takes off where the pressure is greatest."""
ERROR_OF_HALVES = 1.0 / 3.0
"""Error of two halves over what they differ by from the whole, at second order."""
SAFETY, LEAST_FACTOR, MOST_FACTOR = 0.8, 0.2, 5.0
SHORTEST_STEP = 1e-13
"""Part of the way at which steps are given up."""


class MapMoment(NamedTuple):
    """How far wear has come.

    Parameters
    ----------
    elapsed
        Distance slid [m].
    jump
        How far the next step would go [m].
    load_distance
        Sum of p / E* over the pixels, integrated over the distance [m].
    worn
        What has been lost [m], (nx, ny).
    contact
        The contact.
    """

    elapsed: float
    jump: float
    load_distance: float
    worn: Array
    contact: PressedSurface


def begin(surface: WornMap) -> MapMoment:
    """Return the moment before wear.

    Raises
    ------
    NotConverged
        If the contact is not solved.
    """
    worn = np.zeros(surface.gaps.shape)
    contact = surface.pressed(worn, 0.0, ())
    jump = FIRST_SHARE * contact.depth / (surface.softness * float(np.max(contact.pressure)))
    return MapMoment(0.0, jump, 0.0, worn, contact)


def go(surface: WornMap, goal: float, moment: MapMoment, tolerance: float) -> MapMoment:
    """Return how far wear has come at a goal.

    Parameters
    ----------
    surface
        The map.
    goal
        Distance [m], beyond that of the moment.
    moment
        Where it begins.
    tolerance
        Greatest error of the worn depth in a step, over the greatest worn depth.

    Raises
    ------
    NotConverged
        If steps become too short to go on.
    """
    while moment.elapsed < goal:
        moment = _stepped(surface, moment, goal, tolerance)
    return moment


def _stepped(surface: WornMap, moment: MapMoment, goal: float, tolerance: float) -> MapMoment:
    """Return the moment after one step, the longest of those tried whose error is small enough."""
    left, jump = goal - moment.elapsed, moment.jump
    while True:
        last = jump >= left
        length = left if last else jump
        if length < SHORTEST_STEP * goal and not last:
            raise NotConverged(
                f"after {moment.elapsed:.6g} m the steps become too short to go on; allow a larger tolerance of the "
                "wear, or a smaller one of the contact."
            )
        try:
            whole = surface.step(moment.worn, moment.contact, length)
            half = surface.step(moment.worn, moment.contact, 0.5 * length)
            end = surface.step(half.worn, half.contact, 0.5 * length)
        except NotConverged:
            jump = LEAST_FACTOR * length
            if jump < SHORTEST_STEP * goal:
                raise
            continue
        differing = float(np.max(np.abs(end.worn - whole.worn)))
        error = ERROR_OF_HALVES * differing / (tolerance * float(np.max(end.worn)))
        factor = SAFETY * error ** (-1.0 / 3.0) if error > 0.0 else math.inf
        factor = min(max(factor, LEAST_FACTOR), MOST_FACTOR)
        if error <= 1.0:
            following = max(factor * length, jump if last else 0.0)  # a goal that was near does not limit what follows
            elapsed = goal if last else moment.elapsed + length
            carried = moment.load_distance + half.load_distance + end.load_distance
            return MapMoment(elapsed, following, carried, end.worn, end.contact)
        jump = min(factor, 1.0) * length


ALEXANDER = "R. Alexander, SIAM J. Numer. Anal. 14 (1977) 1006-1021, doi:10.1137/0714068"
OWN_CHECK = "comparison of the worn depth with layer or grading"
THIN_WEAR, DEEP_WEAR = 0.01, 0.3
"""Part of the uppermost layer that may be worn off without and with a warning."""


def wear_notes(contact: SurfaceContact, tolerance: float, last: SurfaceWearState) -> tuple[Note, ...]:
    """Return what was assumed of the wear of a map, beside its contact.

    Parameters
    ----------
    contact
        Before wear.
    tolerance
        Of each step.
    last
        The state that has worn most.
    """
    notes = [
        DEBRIS,
        SLIDES_EVERYWHERE,
        Note(
            Assumption.RESOLUTION,
            Standing.APPROXIMATE,
            f"The error of each step is at most {tolerance:.0e} of the maximum worn depth. Maximum pressures are "
            "less accurate: a pixel that has just come into contact briefly carries a high pressure. Compare "
            "with a smaller tolerance.",
            ALEXANDER,
        ),
    ]
    if offers(contact.medium, LayerStack):
        share = last.worn_depth / contact.medium.layers[0].thickness
        notes.append(
            Note(
                Assumption.WEAR,
                standing_of(share, THIN_WEAR, DEEP_WEAR),
                "The elastic response uses the initial thickness of the layers. The maximum wear of the "
                f"uppermost layer is {share:.2g} of its thickness.",
                OWN_CHECK,
            )
        )
    if offers(contact.medium, GradedInDepth):
        notes.append(
            Note(
                Assumption.WEAR,
                Standing.APPROXIMATE,
                "The elastic response uses the grading measured from the unworn surface. This requires wear that "
                f"is shallow compared with the grading; the maximum worn depth is {last.worn_depth:.3g} m.",
                OWN_CHECK,
            )
        )
    if math.isfinite(contact.hardness):
        notes.append(
            Note(
                Assumption.ELASTIC,
                Standing.APPROXIMATE,
                "Pressures are limited to the hardness. Only wear changes the heights permanently; plastic "
                "deformation is not kept.",
                "assumption of the cut of pressures",
            )
        )
    why = "the tractions of friction are not stated, and the stresses under the worn map are not computed"
    return (*notes, *unknown_yield(contact.medium, why))
