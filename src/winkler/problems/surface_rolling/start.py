r"""A height map that begins to roll from rest, under given forces or creepages: from Cattaneo to Carter.

The bodies roll pixel by pixel towards +x.  While it passes one pixel, material slips by

.. math:: s(x) = w(x) - u(x) + u'(x+\Delta x) ,

with the displacement u' of the step before one pixel ahead; of dissimilar bodies also that which pressures draw along,
and both are found by turns.  Each step is the least of an energy
(`winkler.numerics.surfaces.sheared_surface`), also where the forces are given and the creepage is sought.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.laws.friction import Sliding
from winkler.loading.path import OnePositiveNormal
from winkler.media.mapped import MappedMedium
from winkler.numerics.surfaces.sheared_surface import RigidStep, ShearedSurface, shear
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.subsurface.last_map import LastMap
from winkler.problems.subsurface.loaded_history import LoadedMap, gathered_maps
from winkler.problems.subsurface.traction_frames import TractionFrame
from winkler.problems.surface_friction.borne import refuse_beyond
from winkler.problems.surface_rolling.creep_force import OneRollingDrive, given_of
from winkler.problems.surface_rolling.notes import surface_rolling_notes
from winkler.problems.surface_rolling.patch import RollingPatch, refuse_map, rolling_patch
from winkler.problems.surface_rolling.small_creep import greatest_slip, small_creep_note
from winkler.problems.surface_rolling.state import MapRollingStart, SurfaceRollingStartState
from winkler.profiles.rough.topography import Topography
from winkler.values.checks.number_checks import Advice, Positive, affordable, between
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.limits import PATH_POINTS
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

MOST_PIXELS = 1e12
"""More is refused, however much more it is."""


@value
class SurfaceRollingStart:
    """A height map pressed on an elastic half-space, or on layers, that begins to roll towards +x.

    Parameters
    ----------
    topography, medium, load, friction : Topography, MappedMedium, Force or Depth, Coulomb
        As in `SurfaceRolling`.
    drive : ShearForce, CreepForce or Creepage
        The constant load during rolling: a force F_x, or (F_x, F_y), applied before rolling, also with a spin or
        moment; or creepages, from rest without a shear force.
    distance : float
        Rolling distance [m]; one state for each pixel.
    tolerance : float, optional
        Maximum `SurfaceRollingStartState.misfit` at which a step counts as solved.

    Raises
    ------
    InvalidInput
        If the map cannot roll, there are several forces or creepages, or the distance is out of range.

    References
    ----------
    J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9

    Examples
    --------
    A ball under half of the friction: it creeps while it rolls.

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading.loads import Force, ShearForce
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> from winkler.profiles.rough.sampled_profile import SampledProfile
    >>> steel = HalfSpace.between(Elastic(210e9, 0.28), Elastic(210e9, 0.28))
    >>> ball = SampledProfile([0.6e-3, 0.6e-3], Paraboloid(10e-3), (33, 33))
    >>> begun = SurfaceRollingStart(ball, steel, Force(100.0), Coulomb(0.3), ShearForce(15.0), distance=1e-3).solve()
    >>> round(1e3 * float(begun.longitudinal_creepage[-1]), 1)
    1.4
    """

    __words__ = words(drive=("", None, "forces or creepages that stay as they are while the bodies roll"))

    topography: Topography
    medium: Annotated[MappedMedium, Advice("the boundary elements apply to no other")]
    load: OnePositiveNormal
    friction: Sliding
    drive: OneRollingDrive
    distance: Positive
    tolerance: Annotated[float, between(1e-12, 1e-2)] = 1e-8

    references: ClassVar[tuple[str, ...]] = ("kalker_1990", "cattaneo_1938", "spence_1975")
    assumptions: ClassVar[frozenset[Assumption]] = MAPPED | {Assumption.UNCOUPLED, Assumption.SLIP, Assumption.STEADY}

    def __post_init__(self) -> None:
        refuse_map("SurfaceRollingStart", self.topography)
        compliance_of(self.medium)  # refuses bodies whose tractions are not known
        affordable("SurfaceRollingStart", "pixels to roll", self.total, PATH_POINTS)

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one at rest, and one for each pixel."""
        return 1 + math.ceil(min(self.distance / self.topography.pixel[0] * (1.0 - 1e-12), MOST_PIXELS))

    def steps(self) -> Iterator[SurfaceRollingStartState]:
        """Yield the contact at rest, and after each pixel.

        Raises
        ------
        OutsideValidity
            If the contact reaches the border of the map, or the force exceeds the friction limit.
        NotConverged
            If stick and slip are not found to the tolerance.
        """
        who, still = "SurfaceRollingStart", np.zeros(3)
        patch = rolling_patch(who, self.topography, self.medium, self.load)
        even, none = np.ones(patch.x.shape), np.zeros(patch.x.shape)
        modes = np.stack((np.stack((even, none)), np.stack((none, even)), np.stack((-patch.y, patch.x))))
        (rolling,), by_force, _ = given_of(self.drive)
        traction = before = np.zeros_like(modes[0])
        sought = 3 if by_force[2] else 2  # a given spin is a known slip

        def stepped(patch: RollingPatch, given: Array) -> tuple[RollingPatch, ShearedSurface]:
            forces, pushed = np.where(by_force, given, 0.0), np.where(by_force, given / patch.unit, given)
            step = RigidStep(modes[:sought], pushed[:sought], by_force[:sought])
            spun = before + (0.0 if by_force[2] else float(given[2])) * modes[2]

            def under(p: Array, start: Array) -> ShearedSurface:
                bound = self.friction.coefficient * p
                refuse_beyond(float(np.hypot(*forces[:2])), float(forces[2]), patch.unit * bound, patch.arms)
                drawn = patch.grid.drawn(p)
                return shear(patch.grid, bound, spun - drawn, step, start, tolerance=self.tolerance)

            return patch.rubbed(under, traction, self.tolerance)

        for place in range(self.total):
            try:
                if place == 0 and patch.coupled:  # straight down first: that alone shears dissimilar bodies
                    patch, moved = stepped(patch, still)
                    traction, before = moved.traction, moved.displacement + patch.grid.drawn(patch.pressure)
                patch, moved = stepped(patch, rolling if place else np.where(by_force, rolling, 0.0))
            except (NotConverged, OutsideValidity) as error:
                raise type(error)(f"{who}: after {place} pixels, {error}.") from None
            traction, ahead = moved.traction, moved.displacement + patch.grid.drawn(patch.pressure)
            before = np.zeros_like(ahead)
            before[:, :-1] = ahead[:, 1:]
            yield self._state(patch, place, moved, np.append(moved.motion, rolling[sought:]))

    def _state(self, patch: RollingPatch, place: int, moved: ShearedSurface, creeps: Array) -> SurfaceRollingStartState:
        """Return what has been reached, in SI units; creepages are those of the last pixel, none at rest."""
        q, unit, modulus = moved.traction, patch.unit, self.medium.modulus
        touching = patch.pressure > 0.0
        creeps = creeps if place else np.zeros(3)
        return SurfaceRollingStartState(
            distance=place * self.topography.pixel[0],
            longitudinal_creepage=float(creeps[0]),
            lateral_creepage=float(creeps[1]),
            spin_creepage=float(creeps[2]),
            longitudinal_force=unit * float(np.sum(q[0])),
            lateral_force=unit * float(np.sum(q[1])),
            moment=unit * float(np.sum(patch.x * q[1] - patch.y * q[0])),
            stick_share=float(np.count_nonzero(touching & ~moved.slipping)) / float(np.count_nonzero(touching)),
            misfit=moved.misfit,
            pressure=modulus * patch.pressed.pressure,
            traction=patch.spread(modulus * q),
            slipping=patch.spread(moved.slipping),
        )

    def gathered(self, states: Iterable[SurfaceRollingStartState]) -> SurfaceRollingStartSolution:
        """Return the solution made of these states, of the whole distance or of its beginning."""
        found = gathered_maps(states, SurfaceRollingStartSolution)
        return SurfaceRollingStartSolution(problem=self, **found.columns, **found.maps)

    def solve(self) -> SurfaceRollingStartSolution:
        """Return the contact along the whole distance.

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class SurfaceRollingStartSolution(MapRollingStart[Array], LastMap):
    """The solution of a `SurfaceRollingStart`, pixel by pixel; its numbers are those of `MapRollingStart`.

    Parameters
    ----------
    problem : SurfaceRollingStart
        The problem that was solved.
    last : SurfaceRollingStartState
        The contact at the end, with its maps.
    heaviest : tuple of LoadedMap
        The states that are searched for the maximum stress of the whole distance.
    frames : tuple of TractionFrame
        Contact, stick and slip zones of states along the history.
    """

    __words__ = words(
        heaviest=("", None, "states among which the greatest stress is sought"),
        frames=("", None, "what touches, sticks and slips in states along the history"),
    )

    problem: SurfaceRollingStart
    last: SurfaceRollingStartState
    heaviest: tuple[LoadedMap, ...]
    frames: tuple[TractionFrame, ...]

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        stated = self.problem
        notes = surface_rolling_notes(
            stated.topography, stated.medium, stated.friction, self.last.pressure, self.misfit,
            bool(np.any(given_of(stated.drive).by_force)),
        )  # fmt: skip
        slip = greatest_slip(
            self.longitudinal_creepage, self.lateral_creepage, self.spin_creepage, self.last.pressure > 0.0,
            np.array(stated.topography.pixel),
        )  # fmt: skip
        return (*notes, small_creep_note(slip), *self._yield_notes(self.distance.size))
