r"""A roller of finite length pressed on a body, crowned or sharp, straight or tilted: boundary elements.

.. math:: w(x,y) = z(x) + \frac{y^2}{2R} - \theta x - d
          + \frac1{\pi E^*}\int\frac{p(x',y')}{\sqrt{(x-x')^2+(y-y')^2}}\,\mathrm dA' , \qquad
          F = \int p\,\mathrm dA , \quad M = \int p\,x\,\mathrm dA ,

with p >= 0, w >= 0 and p w = 0; layers and gradings add to the kernel what they
yield beyond a half-space.  Unlike an endless line contact, it has an approach d of its own.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.loading.loads import Depth, Force, Moment, Tilt
from winkler.loading.path import numbers_of
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium, layers_of
from winkler.numerics.surfaces.boxed_slender import Generator, SlenderContact, pressed_levels
from winkler.numerics.surfaces.pressed_slender import Pose
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.normal.map_yield import map_yield_notes
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.normal.validity import large_body_note, steepness_note
from winkler.problems.pressed_shape.notes import PIXELS_ON_LAYERS, graded_notes
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.problems.rollers.roller_state import RollerNumbers, RollerState
from winkler.profiles.roller_ends import RollerEnds
from winkler.values.checks.number_checks import Advice, Positive, Whole
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing, standing_of
from winkler.values.value import value, words

STRAIGHT = Tilt(0.0)
SAMPLES = 2001


@value
class RollerContact(PerLoad[Q]):
    """A cylindrical roller of finite length pressed on a body, without friction.

    Parameters
    ----------
    radius : float
        R [m] across: 1/R is the sum of the curvatures of roller and raceway.
    length : float
        Length of the roller [m]; the raceway is longer.
    ends : SharpEnds, CrownedEnds, RoundedEnds or LogarithmicEnds
        Shape of the ends of the roller.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, SlidingFilm, StackedHalfSpace, \
DepthGradedHalfSpace or GradedHalfSpace
        Both bodies; the E* of a logarithmic crown is their `modulus`, of layers that of the uppermost ones.
    load : Force or Depth
        Prescribed load; an array is solved load by load.  A depth is the approach of the bodies in the middle.
    alignment : Tilt or Moment, optional
        The tilt (none by default), or the moment that determines the tilt.
    elements : int, optional
        Number of elements along the contact, even.

    Raises
    ------
    InvalidInput
        If the ends do not fit on the roller, a force is not positive, or the bodies do not touch at a given depth. If
        a moment would require tension, or the number of elements is out of range.

    References
    ----------
    M. J. Hartnett, J. Lubr. Technol. 101 (1979) 105-109, doi:10.1115/1.3453270; P. M. Johns, R. Gohar, Tribol. Int. 14
    (1981) 131-136, doi:10.1016/0301-679X(81)90057-2

    Examples
    --------
    A steel roller of 10 mm radius and length with a logarithmic crown made for its load of 1 kN/mm.

    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.roller_ends import LogarithmicEnds
    >>> steel = Elastic(210e9, 0.3)
    >>> pair = HalfSpace.between(steel, steel)
    >>> roller = RollerContact(10e-3, 10e-3, LogarithmicEnds(1e6), pair, Force(10e3), elements=64).solve()
    >>> round(roller.middle_pressure / 1e9, 2), round(roller.depth * 1e6, 1)  # GPa, micrometres
    (1.93, 25.5)
    """

    __words__ = words(
        radius=("R", "m", "radius of the roller across, 1/R the sum of the curvatures of both bodies"),
        length=("L", "m", "length of the roller"),
        ends=("", None, "how the roller ends"),
        alignment=("", None, "the tilt of the roller, or the moment under which it finds it"),
        elements=("", "", "elements along the contact"),
    )

    radius: Positive
    length: Positive
    ends: RollerEnds
    medium: Annotated[MappedMedium, Advice("the boundary elements apply to no other")]
    load: Force[Q] | Depth[Q]
    alignment: Tilt | Moment = STRAIGHT
    elements: Annotated[int, Whole(16, 320, "elements")] = 160

    references: ClassVar[tuple[str, ...]] = (
        "hartnett_1979", "johns_gohar_1981", "lundberg_1939", "fujiwara_kawase_2007", "johnson_1985",
    )  # fmt: skip
    assumptions: ClassVar[frozenset[Assumption]] = MAPPED | {Assumption.SHAPE, Assumption.HALF_SPACE}

    def __post_init__(self) -> None:
        self.ends.refuse(0.5 * self.length)
        loads = self._loads
        if isinstance(self.load, Depth):
            x = np.linspace(-0.5, 0.5, SAMPLES) * self.length
            turned = self.alignment.tilt * x if isinstance(self.alignment, Tilt) else 0.0
            least = float(np.min(self.ends.drop(x, 0.5 * self.length, self.medium.modulus) - turned)) + 0.0
            if np.any(loads <= least):
                raise InvalidInput(
                    f"RollerContact: at the depth {np.min(loads):.6g} m the bodies do not touch; give more than "
                    f"{least:.6g} m."
                )
            return
        if np.any(loads <= 0.0):
            raise InvalidInput(
                f"RollerContact: a force of {np.min(loads):.6g} N does not press; without adhesion give positive "
                "forces."
            )
        if isinstance(self.alignment, Moment) and abs(self.alignment.moment) >= 0.5 * self.length * np.min(loads):
            raise InvalidInput(
                f"RollerContact: the moment {self.alignment.moment:.6g} N m needs the force {np.min(loads):.6g} N "
                f"beyond the end of the roller; give less than {0.5 * self.length * np.min(loads):.6g} N m."
            )

    @property
    def _loads(self) -> Array:
        return numbers_of(self.load).ravel()

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for every load."""
        return int(self._loads.size)

    def steps(self) -> Iterator[RollerState]:
        """Yield the contact under every load.

        Raises
        ------
        NotConverged
            If a contact is not found.
        OutsideValidity
            If the elements are too coarse for an incompressible layer, or a modulus is proportional to the depth.
        """
        unit, modulus = 0.5 * self.length, self.medium.modulus
        below = layers_of(self.medium)
        generator = Generator(
            lambda x: self.ends.drop(unit * x, unit, modulus) / unit,
            self.radius / unit,
            tuple(mark / unit for mark in self.ends.marks(unit)),
            None if below is None else below.in_units_of(unit),
        )
        for load in self._loads.tolist():
            by_force = isinstance(self.load, Force)
            pose = Pose(
                force=load / (modulus * unit**2) if by_force else math.nan,
                approach=math.nan if by_force else load / unit,
                moment=self.alignment.moment / (modulus * unit**3) if isinstance(self.alignment, Moment) else math.nan,
                tilt=self.alignment.tilt if isinstance(self.alignment, Tilt) else math.nan,
            )
            try:
                coarse, fine = pressed_levels(generator, pose, self.elements)
            except NotConverged as error:
                raise NotConverged(f"RollerContact: under the load {load:.6g}, {error}") from None
            except OutsideValidity as error:
                raise OutsideValidity(
                    f"RollerContact: elements count as pixels, and {error} More elements are smaller."
                ) from None
            yield self._state(coarse, fine)

    def _state(self, coarse: SlenderContact, fine: SlenderContact) -> RollerState:
        """Return a contact with its units."""
        unit, modulus = 0.5 * self.length, self.medium.modulus
        grid, pressed = fine.grid, fine.pressed
        results = [self._pressures(level) for level in (coarse, fine)]
        peak, middle = results[1]
        pairs = [(coarse.pressed.force, pressed.force), *zip(*results, strict=True)]
        changes = [abs(one / other - 1.0) for one, other in pairs if math.isfinite(other) and other > 0.0]
        overlap = float(np.max(pressed.approach + pressed.tilt * grid.middles - self._drop(grid.middles)))
        changes.append(abs(coarse.pressed.approach - pressed.approach) / overlap)
        y = unit * grid.places_across
        return RollerState(
            depth=unit * pressed.approach,
            tilt=pressed.tilt,
            force=modulus * unit**2 * pressed.force,
            moment=modulus * unit**3 * pressed.moment,
            stiffness=modulus * unit * pressed.stiffness,
            peak_pressure=modulus * peak,
            middle_pressure=modulus * middle,
            edge_factor=peak / middle if middle > 0.0 else math.inf,
            area=unit**2 * float(np.sum(2.0 * fine.half_width * np.diff(grid.edges))),
            grid_error=max(changes),
            edges=unit * grid.edges,
            x=unit * grid.middles,
            y=np.concatenate([-y[::-1], y]),
            pressure_along=modulus * fine.on_axis,
            force_per_length=modulus * unit * fine.force_per_length,
            half_width=unit * fine.half_width,
            pressure=modulus * np.concatenate([pressed.pressure[:, ::-1], pressed.pressure], axis=1),
        )

    def _drop(self, x: Array) -> Array:
        unit = 0.5 * self.length
        return self.ends.drop(unit * x, unit, self.medium.modulus) / unit

    def _pressures(self, contact: SlenderContact) -> tuple[float, float]:
        """Return the greatest pressure and that in the middle, over E*."""
        on_axis, grid = contact.on_axis, contact.grid
        middle = float(np.interp(0.0, grid.middles, on_axis, left=0.0, right=0.0))
        ends = ((0, grid.edges[0]), (-1, grid.edges[-1]))
        drops = self._drop(np.array([-1.0, 1.0]))
        sharp = any(
            abs(place) == 1.0 and contact.pressed.pressure[slice_, 0] > 0.0 and math.isfinite(drop)
            for (slice_, place), drop in zip(ends, drops, strict=True)
        )
        return (math.inf if sharp else float(max(np.max(on_axis), np.max(contact.pressed.pressure)))), middle

    def gathered(self, states: Iterable[RollerState]) -> RollerSolution[Q]:
        """Return the solution made of these states, of all loads or of the first ones."""
        reached, shape = list(states), numbers_of(self.load).shape
        whole = len(reached) == math.prod(shape)

        def column(name: str) -> Q:
            numbers = np.array([getattr(state, name) for state in reached])
            return shaped(numbers, shape if whole else numbers.shape)

        columns = {field.name: column(field.name) for field in dataclasses.fields(RollerNumbers)}
        return RollerSolution(problem=self, **columns, last=reached[-1])

    def solve(self) -> RollerSolution[Q]:
        """Return the solution of all loads.

        Raises
        ------
        NotConverged, OutsideValidity
            As in `steps`.
        """
        return self.gathered(self.steps())


@value
class RollerSolution(RollerNumbers[Q]):
    """The solution of a `RollerContact`; its numbers are those of `RollerNumbers`, in the shape of the load.

    Parameters
    ----------
    problem : RollerContact
        The problem that was solved.
    last : RollerState
        The contact under the last load, with its pressures.
    """

    problem: RollerContact[Q]
    last: RollerState

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: grid, sharp ends, slopes, yield."""
        stated, last = self.problem, self.last
        growth = math.sqrt(max(1.0, float(np.max(self.force)) / last.force))  # where the last load is not the greatest
        bears = last.force_per_length > 0.0
        rise = np.diff(stated.ends.drop(last.edges, 0.5 * stated.length, stated.medium.modulus))
        along = np.abs(rise / np.diff(last.edges))[bears]
        notes = roller_notes(
            stated.medium,
            stated.radius,
            float(np.max(self.peak_pressure)),
            growth * float(np.max(last.half_width)),
            max(float(np.max(along[np.isfinite(along)], initial=0.0)), float(np.max(np.abs(self.tilt)))),
            float(np.max(self.grid_error)),
        )
        if growth > 1.0 or math.isinf(last.peak_pressure):
            return (*notes, *unknown_yield(stated.medium, LAST_LOAD if growth > 1.0 else SHARP))
        return (*notes, *map_yield_notes(stated.medium, self.surface_load))

    @property
    def surface_load(self) -> SurfaceLoad:
        """The pressures under the last load, averaged over pixels of one length.

        Raises
        ------
        OutsideValidity
            If the pressure is infinite at sharp ends.
        """
        last = self.last
        if math.isinf(last.peak_pressure):
            raise OutsideValidity(f"RollerContact: {SHARP}.")
        edges = np.linspace(last.edges[0], last.edges[-1], PIXELS_ALONG + 1)
        borne = np.cumsum(np.pad(last.pressure * np.diff(last.edges)[:, None], ((1, 0), (0, 0))), axis=0)
        shares = np.stack([np.interp(edges, last.edges, column) for column in borne.T], axis=1)
        width = (last.y[-1] - last.y[0]) * last.y.size / (last.y.size - 1)
        length = float(last.edges[-1] - last.edges[0])
        pressure = np.diff(shares, axis=0) * (PIXELS_ALONG / length)
        return SurfaceLoad(pressure, np.array([length, width]), corner=np.array([edges[0], -0.5 * width]))


HARTNETT = "M. J. Hartnett, J. Lubr. Technol. 101 (1979) 105-109, doi:10.1115/1.3453270"
JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 5.4, doi:10.1017/CBO9781139171731"
ELEMENTS_ON_HALF_SPACES = Note(
    Assumption.RESPONSE,
    Standing.EXACT,
    "Frictionless contact of homogeneous, linear elastic half-spaces. The pressure of every element "
    "displaces all other elements.",
    HARTNETT,
)
EDGES_ON_LAYERS = Note(
    Assumption.RESOLUTION,
    Standing.APPROXIMATE,
    "On layers and graded bodies half-widths and area have an error of one element across. The elements are such "
    "that each half of the widest contact has an eighth as many across as there are along the roller.",
    "loaded elements",
)
SHARP = "the elastic stress is infinite at sharp ends"
LAST_LOAD = "pressures are stored of the last load, which is not the greatest"
PIXELS_ALONG = 256
"""Along the roller, on which pressures are averaged for stresses below."""
FINE, COARSE = 0.02, 0.1
"""Change from half as many elements up to which results count as fine, and as coarse."""


def roller_notes(
    medium: MappedMedium,
    radius: float,
    peak_pressure: float,
    half_width: float,
    slope: float,
    grid_error: float,
) -> tuple[Note, ...]:
    """Return what was assumed of a roller, and what the grid leaves.

    Parameters
    ----------
    medium
        Both bodies.
    radius
        Of the roller across [m].
    peak_pressure
        The greatest one [Pa], infinite at sharp ends.
    half_width
        The greatest one [m].
    slope
        The greatest one along the roller, of its ends or its tilt [-].
    grid_error
        Relative change from half as many elements.
    """
    changes = (
        f"With half as many elements force, depth and pressures change by up to {100.0 * grid_error:.2g} per "
        "cent; the remaining error is smaller if they converge."
        if math.isfinite(grid_error)
        else "With half as many elements the very end of the roller carries load, with these elements it does "
        "not. The maximum pressure is not resolved: use more elements."
    )
    homogeneous = isinstance(medium, HomogeneousMedium)
    notes = [
        *((ELEMENTS_ON_HALF_SPACES,) if homogeneous else (PIXELS_ON_LAYERS, *graded_notes(medium))),
        Note(
            Assumption.HALF_SPACE,
            Standing.APPROXIMATE,
            f"The roller is also treated as {'a half-space' if homogeneous else 'flat below its surface'}, as if "
            "it continued beyond its ends. A real free end face would deflect and reduce the pressure near the "
            "end.",
            JOHNSON,
        ),
        Note(
            Assumption.RESOLUTION,
            standing_of(grid_error, FINE, COARSE),
            changes,
            "comparison of two grids",
            grid_error if math.isfinite(grid_error) else None,
        ),
        *(() if homogeneous else (EDGES_ON_LAYERS,)),
        steepness_note(max(half_width / radius, slope)),
        large_body_note(half_width / radius, strip=True),
    ]
    if math.isinf(peak_pressure):
        notes.append(
            Note(
                Assumption.SHAPE,
                Standing.ASYMPTOTIC,
                "A sharp end of the roller carries load. The elastic pressure is infinite there, as at the edge "
                "of a punch, so the maximum pressure and edge factor do not exist. A real edge yields or is "
                "rounded.",
                JOHNSON,
            )
        )
    return tuple(notes)
