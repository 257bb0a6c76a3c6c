r"""A height map that rolls steadily on an elastic half-space: creep forces and the zones of stick and slip.

Material that passes the contact towards -x slips, while the bodies roll by one pixel, by the rigid slip of the creepage
less what the displacement under the tractions grows meanwhile (`winkler.numerics.surfaces.rolled_surface`).  This is
the exact theory of Kalker, on half-spaces, for a contact of any outline.

From pixel to pixel tractions that stick grow towards the trailing edge: they act somewhat behind the middle of their
pixel, and the slip of a spin, which has made them, is that of a place ahead of it.  A quarter of a pixel is taken for
both: half a pixel, the whole distance, errs by as much to the other side as none.  With a quarter the coefficients of
spin keep one per cent on 72 pixels.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Iterator
from typing import Annotated, Any, ClassVar

import numpy as np

from winkler.checks.number_checks import Advice, between
from winkler.errors import NotConverged
from winkler.laws.friction import Sliding
from winkler.media.halfspace import HalfSpace
from winkler.numerics.surfaces.rolled_surface import roll
from winkler.numerics.types import Quantity, shaped
from winkler.path import OnePositiveNormal
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.rolling.creepage import Creepage, CreepageSolution
from winkler.problems.subsurface.below_surface import BelowSurface
from winkler.problems.subsurface.loaded_history import LoadedMap, gathered_maps
from winkler.problems.subsurface.map_yield import history_yield_notes
from winkler.problems.subsurface.surface_load import SurfaceLoad
from winkler.problems.subsurface.traction_frames import TractionFrame
from winkler.problems.surface_rolling.notes import surface_rolling_notes
from winkler.problems.surface_rolling.patch import refuse_map, rolling_patch
from winkler.problems.surface_rolling.small_creep import greatest_slip, small_creep_note
from winkler.problems.surface_rolling.state import SurfaceRollingState
from winkler.profiles.rough.topography import Topography
from winkler.validity import Assumption, Note
from winkler.values import value, words

__all__ = ["SurfaceRolling", "SurfaceRollingSolution"]

AHEAD = 0.25
"""How far ahead of the middle of a pixel the slip of a spin is taken, and how far behind what sticks acts [pixels]."""


@value
class SurfaceRolling:
    """A height map pressed on an elastic half-space that rolls steadily towards +x, with creepage and spin.

    Parameters
    ----------
    topography : Topography
        Heights of both bodies together, up towards the other one, as seen from the contact: they do not pass with the
        material.  It stands alone; `SampledProfile` makes one of curved bodies.
    medium : HalfSpace
        Both bodies.
    load : Force or Depth
        One positive number.
    friction : Coulomb
        Its coefficient positive and finite.
    creepage : Creepage
        Longitudinal, lateral and spin, also arrays; spin turns about the middle of the map.
    tolerance : float, optional
        Greatest `SurfaceRollingState.misfit` at which a contact counts as solved.

    Raises
    ------
    InvalidInput
        If heights are missing, the map is periodic or too large, or friction is not Coulomb's.

    References
    ----------
    J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9

    Examples
    --------
    A locomotive wheel pulls with 0.65 of the friction at a creepage of 0.12 %:

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading import Force
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.profiles.ellipse import CurvedBodies
    >>> from winkler.profiles.rough.sampled_profile import SampledProfile
    >>> steel = HalfSpace.between(Elastic(210e9, 0.28), Elastic(210e9, 0.28))
    >>> wheel = SampledProfile([13.9e-3, 27.7e-3], CurvedBodies(0.625, 1.789), (48, 48))
    >>> pulls = SurfaceRolling(wheel, steel, Force(106.7e3), Coulomb(0.33), Creepage(longitudinal=1.2e-3)).solve()
    >>> round(float(pulls.saturation), 2)
    0.65
    """

    topography: Topography
    medium: Annotated[HalfSpace, Advice("rolling is computed on homogeneous, isotropic bodies")]
    load: OnePositiveNormal
    friction: Sliding
    creepage: Creepage
    tolerance: Annotated[float, between(1e-12, 1e-2)] = 1e-7

    references: ClassVar[tuple[str, ...]] = ("kalker_1990", "polonsky_keer_1999")
    assumptions: ClassVar[frozenset[Assumption]] = MAPPED | {Assumption.UNCOUPLED, Assumption.SLIP, Assumption.STEADY}

    def __post_init__(self) -> None:
        refuse_map("SurfaceRolling", self.topography)

    @property
    def total(self) -> int:
        """How many states `steps` yields: one for every creepage."""
        return int(self.creepage.broadcast()[0].size)

    def steps(self) -> Iterator[SurfaceRollingState]:
        """Yield the contact under every creepage.

        Raises
        ------
        OutsideValidity
            If the contact reaches the border of the map.
        NotConverged
            If stick and slip are not found to the tolerance.
        """
        patch = rolling_patch("SurfaceRolling", self.topography, self.medium, self.load)
        shifted = AHEAD * self.topography.pixel[0]
        start, bound = np.zeros((2, *patch.pressure.shape)), self.friction.coefficient * patch.pressure
        for xi, eta, spin in zip(*(part.tolist() for part in self.creepage.broadcast()), strict=True):
            rigid = np.stack((xi - spin * patch.y, eta + spin * (patch.x + shifted)))
            try:
                rolled = roll(patch.grid, bound, rigid, start, tolerance=self.tolerance)
            except NotConverged as error:
                raise NotConverged(
                    f"SurfaceRolling: at the creepage ({xi:.6g}, {eta:.6g}) with a spin of {spin:.6g} 1/m, {error}; "
                    "allow a larger tolerance, or give a finer map."
                ) from None
            start = q = rolled.traction
            count = np.count_nonzero(bound > 0.0)
            at, unit, modulus = patch.x - shifted * ~rolled.slipping, patch.unit, self.medium.modulus
            yield SurfaceRollingState(
                patch.pressed.depth, unit * float(np.sum(patch.pressure)), unit * float(np.sum(q[0])),
                unit * float(np.sum(q[1])), unit * float(np.sum(at * q[1] - patch.y * q[0])),
                float(np.count_nonzero((bound > 0.0) & ~rolled.slipping)) / count, rolled.misfit,
                modulus * patch.pressed.pressure, patch.spread(modulus * q),
                patch.spread(np.where(rolled.slipping, rolled.slip, 0.0)), patch.spread(rolled.slipping),
            )  # fmt: skip

    def gathered(self, states: Iterable[SurfaceRollingState]) -> SurfaceRollingSolution:
        """Return the solution made of these states, of all creepages or of the first ones."""
        shape = self.creepage.shape
        found = gathered_maps(states, SurfaceRollingSolution)
        count = found.columns["force"].size
        whole = count == self.total
        columns: dict[str, Any] = {name: shaped(row, shape) if whole else row for name, row in found.columns.items()}
        problem = self if whole else dataclasses.replace(self, creepage=_first(self.creepage, count))
        return SurfaceRollingSolution(problem=problem, **columns, **found.maps)

    def solve(self) -> SurfaceRollingSolution:
        """Return the creep forces.

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


def _first(creepage: Creepage, count: int) -> Creepage:
    return Creepage(*(part[:count] for part in creepage.broadcast()))


@value
class SurfaceRollingSolution(CreepageSolution, BelowSurface):
    """The solution of a `SurfaceRolling`; quantities have the shape of the creepage.

    Parameters
    ----------
    problem : SurfaceRolling
        The problem that was solved.
    longitudinal_force, lateral_force : float or ndarray
        F_x and F_y [N], with which the second body drags the first.
    depth, force, moment, stick_share, misfit : float or ndarray
        As in `SurfaceRollingState`.
    last : SurfaceRollingState
        The contact under the last creepage, with its maps of pressure, traction and slip.
    heaviest : tuple of LoadedMap
        The states among which the greatest stress of all creepages is sought.
    frames : tuple of TractionFrame
        What touches, sticks and slips in states along the history.
    """

    __words__ = words(
        **{name: SurfaceRollingState.__words__[name] for name in ("stick_share", "misfit", "moment")},
        heaviest=("", None, "states among which the greatest stress is sought"),
        frames=("", None, "what touches, sticks and slips in states along the history"),
    )

    problem: SurfaceRolling
    depth: Quantity
    force: Quantity
    moment: Quantity
    stick_share: Quantity
    misfit: Quantity
    last: SurfaceRollingState
    heaviest: tuple[LoadedMap, ...]
    frames: tuple[TractionFrame, ...]

    @property
    def surface_load(self) -> SurfaceLoad:
        """Pressures and tractions on the first body in the last state."""
        return SurfaceLoad.of_map(self.problem.topography.lengths, self.last.pressure, self.last.traction)

    @property
    def _medium(self) -> object:
        return self.problem.medium

    @property
    def spin_creepage(self) -> Quantity:
        """phi [1/m], in the shape of the results."""
        return shaped(np.broadcast_to(self.problem.creepage.spin, self.problem.creepage.shape))

    @property
    def saturation(self) -> Quantity:
        """The resultant over mu F_N [-]."""
        return shaped(np.asarray(self.shear_force) / (self.problem.friction.coefficient * np.asarray(self.force)))

    @property
    def loss_per_distance(self) -> Quantity:
        """Energy lost per distance rolled [J/m]: creepage times force, and spin times moment."""
        return shaped(np.asarray(super().loss_per_distance) + np.asarray(self.problem.creepage.spin) * self.moment)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: border, residual, slopes, pixels, steady state, yield."""
        stated = self.problem
        notes = surface_rolling_notes(
            stated.topography, stated.medium, stated.friction.coefficient, self.last.pressure, self.misfit
        )
        creep, pixel = stated.creepage, np.array(stated.topography.pixel)
        slip = greatest_slip(creep.longitudinal, creep.lateral, creep.spin, self.last.pressure > 0.0, pixel)
        yielded = history_yield_notes(stated.medium, stated.topography.lengths, self.heaviest, np.size(self.force))
        return (*notes, small_creep_note(slip), *yielded)
