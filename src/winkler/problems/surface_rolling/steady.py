r"""A height map that rolls steadily on a half-space or on layers: creep forces and the zones of stick and slip.

Material that passes the contact towards -x slips, while the bodies roll by one pixel, by the rigid slip of the creepage
less what the displacement under the tractions grows meanwhile (`winkler.numerics.surfaces.rolled_surface`).  This is
the theory that Kalker named exact, on half-spaces; the outline of the contact is that of its pressures.

Where forces are given, the creepages are sought (`winkler.problems.surface_rolling.creepages`).  Of dissimilar bodies
pressures draw the surface along, and what they draw grows along the path of the material; tractions sink the surface;
pressures and tractions are found by turns.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Iterator
from typing import Annotated, Any, ClassVar

import numpy as np

from winkler.laws.varying_friction import Rolled, greatest_coefficient
from winkler.loading.loads import ShearForce
from winkler.loading.path import OnePositiveNormal
from winkler.media.mapped import MappedMedium
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.rolling.creepage import Creepage
from winkler.problems.rolling.speed import idle_speed_notes, refuse_rest
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.subsurface.last_map import LastMap
from winkler.problems.subsurface.loaded_history import LoadedMap, gathered_maps
from winkler.problems.subsurface.traction_frames import TractionFrame
from winkler.problems.surface_rolling.creep_force import ONE_PUSH, CreepForce, first_of, given_of
from winkler.problems.surface_rolling.creepages import CreepSearch, CreptPatch
from winkler.problems.surface_rolling.notes import surface_rolling_notes
from winkler.problems.surface_rolling.patch import RollingPatch, refuse_map, rolling_patch
from winkler.problems.surface_rolling.small_creep import greatest_slip, small_creep_note
from winkler.problems.surface_rolling.state import MapRolling, SurfaceRollingState
from winkler.profiles.rough.topography import Topography
from winkler.values.checks.number_checks import Advice, NonNegative, between
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words


@value
class SurfaceRolling(PerLoad[Q]):
    """A height map pressed on a half-space or on layers that rolls steadily towards +x, with creepages or under forces.

    Parameters
    ----------
    topography : Topography
        Sum of the heights of both bodies, positive towards the other body. The map is fixed in the contact: it does
        not move with the material.  The map is not periodic; `SampledProfile` makes one for curved bodies.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, StackedHalfSpace or DepthGradedHalfSpace
        Both bodies. For dissimilar half-spaces the tangential displacements due to pressure and the normal
        displacements due to traction are included.  For layers normal displacements due to tractions are neglected.
    load : Force or Depth
        One positive number.
    friction : Coulomb or FallingFriction
        A positive, finite coefficient, or one that decreases with the slip velocity.
    drive : Creepage, CreepForce or ShearForce
        Creepages and spin; or forces F_x and F_y with the spin or the moment, also arrays; or a shear force F_x, or
        (F_x, F_y), without spin.  Spin and moment refer to the middle of the map.
    tolerance : float, optional
        Maximum `SurfaceRollingState.misfit` at which a contact counts as solved.
    speed : float, optional
        Rolling speed [m/s], for frictional heat and for friction that falls with the slip velocity (creepage times
        speed). Under Coulomb's law forces do not depend on it.

    Raises
    ------
    InvalidInput
        If heights are missing, the map is periodic or too large, or friction falls and no speed is given.

    References
    ----------
    J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9

    Examples
    --------
    A locomotive wheel pulls with 0.65 of the friction at a creepage of 0.12 %:

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading.loads import Force, ShearForce
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.problems.rolling.creepage import Creepage
    >>> from winkler.profiles.ellipse import CurvedBodies
    >>> from winkler.profiles.rough.sampled_profile import SampledProfile
    >>> steel = HalfSpace.between(Elastic(210e9, 0.28), Elastic(210e9, 0.28))
    >>> wheel = SampledProfile([13.9e-3, 27.7e-3], CurvedBodies(0.625, 1.789), (48, 48))
    >>> pulls = SurfaceRolling(wheel, steel, Force(106.7e3), Coulomb(0.33), Creepage(longitudinal=1.2e-3)).solve()
    >>> round(float(pulls.saturation), 2)
    0.65

    The creepage at which it pulls with 20 kN:

    >>> pulls = SurfaceRolling(wheel, steel, Force(106.7e3), Coulomb(0.33), ShearForce(20e3)).solve()
    >>> round(1e3 * float(pulls.longitudinal_creepage), 2)
    1.0
    """

    topography: Topography
    medium: Annotated[MappedMedium, Advice("the boundary elements apply to no other")]
    load: OnePositiveNormal
    friction: Rolled
    drive: Annotated[Creepage[Q] | CreepForce[Q] | ShearForce, ONE_PUSH]
    tolerance: Annotated[float, between(1e-12, 1e-2)] = 1e-7
    speed: NonNegative = 0.0

    __words__ = words(
        drive=("", None, "creepages, or forces that the pair transmits while it rolls"),
        speed=("V", "m/s", "speed of rolling"),
    )

    references: ClassVar[tuple[str, ...]] = ("kalker_1990", "polonsky_keer_1999", "bentall_johnson_1967")
    assumptions: ClassVar[frozenset[Assumption]] = MAPPED | {Assumption.UNCOUPLED, Assumption.SLIP, Assumption.STEADY}

    def __post_init__(self) -> None:
        refuse_map("SurfaceRolling", self.topography)
        compliance_of(self.medium)  # refuses bodies whose tractions are not known
        refuse_rest("SurfaceRolling", self.friction, self.speed)

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for every creepage or force."""
        return len(given_of(self.drive).numbers)

    def steps(self) -> Iterator[SurfaceRollingState]:
        """Yield the contact under every creepage or force.

        Raises
        ------
        OutsideValidity
            If the contact reaches the border of the map, a force exceeds the friction limit, or friction falls too
            steeply with the slip velocity.
        NotConverged
            If stick and slip, or creepages are not found to the tolerance.
        """
        patch = rolling_patch("SurfaceRolling", self.topography, self.medium, self.load)
        given = given_of(self.drive)
        search = CreepSearch(patch, given.by_force, self.friction, self.speed, self.tolerance)
        start = np.zeros((2, *patch.pressure.shape))
        for one in given.numbers:

            def under(p: Array, begun: Array, one: Array = one) -> CreptPatch:
                return search.found(p, one, begun)

            try:
                patch, crept = patch.rubbed(under, start, self.tolerance)
            except (NotConverged, OutsideValidity) as error:
                raise type(error)(f"SurfaceRolling: {_stated(one, given.by_force)}, {error}.") from None
            start = crept.traction
            yield self._state(patch, crept)

    def _state(self, patch: RollingPatch, crept: CreptPatch) -> SurfaceRollingState:
        """Return what has been found, in SI units."""
        modulus, (q, slip, slipping, misfit, _) = self.medium.modulus, crept.surface
        (xi, eta, spin), (along, across, moment) = crept.creeps.tolist(), crept.forces.tolist()
        touching = patch.pressure > 0.0
        return SurfaceRollingState(
            depth=patch.pressed.depth,
            force=patch.unit * float(np.sum(patch.pressure)),
            longitudinal_creepage=xi,
            lateral_creepage=eta,
            spin_creepage=spin,
            longitudinal_force=along,
            lateral_force=across,
            moment=moment,
            rolling_resistance=crept.resistance,
            stick_share=float(np.count_nonzero(touching & ~slipping)) / np.count_nonzero(touching),
            misfit=max(misfit, crept.missing),
            pressure=modulus * patch.pressed.pressure,
            traction=patch.spread(modulus * q),
            creep=patch.spread(np.where(slipping, slip, 0.0)),
            slipping=patch.spread(slipping),
        )

    def gathered(self, states: Iterable[SurfaceRollingState]) -> SurfaceRollingSolution[Q]:
        """Return the solution made of these states, of all creepages or forces, or of the first ones."""
        shape = given_of(self.drive).shape
        found = gathered_maps(states, SurfaceRollingSolution)
        count = found.columns["force"].size
        whole = count == self.total
        columns: dict[str, Any] = {name: shaped(row, shape) if whole else row for name, row in found.columns.items()}
        first: Any = self.drive if whole else first_of(self.drive, count)
        problem = self if whole else dataclasses.replace(self, drive=first)
        return SurfaceRollingSolution(problem=problem, **columns, **found.maps)

    def solve(self) -> SurfaceRollingSolution[Q]:
        """Return creep forces and creepages.

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


def _stated(given: Array, by_force: Array) -> str:
    """Return which case it is, in words."""
    if not by_force[0]:
        return f"at the creepage ({given[0]:.6g}, {given[1]:.6g}) with a spin of {given[2]:.6g} 1/m"
    turned = f"moment of {given[2]:.6g} N m" if by_force[2] else f"spin of {given[2]:.6g} 1/m"
    return f"under the force ({given[0]:.6g}, {given[1]:.6g}) N with a {turned}"


@value
class SurfaceRollingSolution(MapRolling[Q], LastMap):
    """The solution of a `SurfaceRolling`; its numbers are those of `MapRolling`, with the shape of the prescribed
    quantity.

    Parameters
    ----------
    problem : SurfaceRolling
        The problem that was solved.
    last : SurfaceRollingState
        The last contact, with its maps of pressure, traction and slip.
    heaviest : tuple of LoadedMap
        The states that are searched for the maximum stress of all cases.
    frames : tuple of TractionFrame
        Contact, stick and slip zones of states along the history.
    """

    __words__ = words(
        heaviest=("", None, "states among which the greatest stress is sought"),
        frames=("", None, "what touches, sticks and slips in states along the history"),
    )

    problem: SurfaceRolling[Q]
    last: SurfaceRollingState
    heaviest: tuple[LoadedMap, ...]
    frames: tuple[TractionFrame, ...]

    @property
    def shear_force(self) -> Q:
        """The resultant of both forces [N]."""
        return shaped(np.hypot(self.longitudinal_force, self.lateral_force))

    @property
    def saturation(self) -> Q:
        """The resultant over mu F_N [-]; mu is that of slow slip if friction falls."""
        return shaped(
            np.asarray(self.shear_force) / (greatest_coefficient(self.problem.friction) * np.asarray(self.force))
        )

    @property
    def loss_per_distance(self) -> Q:
        """Energy lost per distance rolled [J/m]: creepages times forces, spin times moment, rolling resistance."""
        pairs = (
            (self.longitudinal_creepage, self.longitudinal_force),
            (self.lateral_creepage, self.lateral_force),
            (self.spin_creepage, self.moment),
        )
        lost = sum(np.asarray(creep) * np.asarray(force) for creep, force in pairs)
        return shaped(lost + np.asarray(self.rolling_resistance))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: border, residual, slopes, pixels, steady state, yield."""
        stated = self.problem
        notes = surface_rolling_notes(
            stated.topography, stated.medium, stated.friction, self.last.pressure, self.misfit,
            bool(np.any(given_of(stated.drive).by_force)),
        )  # fmt: skip
        creeps = self.longitudinal_creepage, self.lateral_creepage, self.spin_creepage
        slip = greatest_slip(*creeps, self.last.pressure > 0.0, np.array(stated.topography.pixel))
        idle = idle_speed_notes(stated.friction, stated.speed)
        return (*notes, *idle, small_creep_note(slip), *self._yield_notes(np.size(self.force)))
