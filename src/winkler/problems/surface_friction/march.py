r"""A height map that is pressed and sheared step by step: what it remembers, and one step of it.

Each step first presses the map, then finds its tractions (`winkler.numerics.surfaces.sheared_surface`).  The memory is
the traction with which the step before ended, and with it the displacement of the surfaces.  Where the bodies are
dissimilar tractions sink the surface, and pressures draw it along; both are solved by turns until they agree
(Panagiotopoulos).
"""

from __future__ import annotations

import numpy as np

from winkler.laws.friction import Coulomb
from winkler.laws.varying_friction import SlipWeakening
from winkler.media.mapped import MappedMedium, layers_of
from winkler.numerics.pixels.contact_area import contact_area
from winkler.numerics.surfaces.pressed_box import box_around
from winkler.numerics.surfaces.pressed_grid import ByDepth, ByLoad, PressedSurface
from winkler.numerics.surfaces.sheared_surface import RigidStep, ShearedSurface, shear
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.numerics.types import Array
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.surface_friction.borne import refuse_beyond
from winkler.problems.surface_friction.by_turns import by_turns, press_from
from winkler.problems.surface_friction.state import SurfaceShearState
from winkler.problems.surface_friction.weakening import loss_of, shear_weakened
from winkler.profiles.rough.topography import Topography

__all__ = ["SurfaceMarch"]

NEARBY_LOAD = 0.25
"""A load that differs by more than this part of it from the one before is begun on coarse grids: as fast."""


class SurfaceMarch:
    """A map on its path.

    Pressures and tractions are over E*, lengths and displacements in pixels along x, and forces in pixels times E*.

    Parameters
    ----------
    rough : Topography
        Heights of both bodies together.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace or DepthGradedHalfSpace
        Both bodies.
    law : Coulomb, LinearSlipWeakening or ExponentialSlipWeakening
        Friction.
    by_force : ndarray of bool, (3,)
        Of which motions along x, along y and about the middle the force is given.
    tolerance : float
        As of `shear`.
    """

    def __init__(
        self,
        rough: Topography,
        medium: MappedMedium,
        law: Coulomb | SlipWeakening,
        by_force: Array,
        tolerance: float,
    ):
        self.gaps, self.pixel, self.periodic, self.modulus = rough.gaps, rough.pixel, rough.periodic, medium.modulus
        self.compliance, self.law, self.tolerance = compliance_of(medium).in_units_of(self.pixel[0]), law, tolerance
        self.layers = layers_of(medium)
        self.coupled = self.compliance.coupling != 0.0  # pressures draw the surface along
        nx, ny = self.gaps.shape
        self.shape, self.aspect = (nx, ny), (1.0, self.pixel[1] / self.pixel[0])
        self.patch = self.modulus * self.pixel[0] * self.pixel[1]
        x = np.broadcast_to((np.arange(nx) - 0.5 * (nx - 1))[:, None], self.shape)
        y = np.broadcast_to(((np.arange(ny) - 0.5 * (ny - 1)) * self.aspect[1])[None, :], self.shape)
        even, none = np.ones(self.shape), np.zeros(self.shape)
        self.modes = np.stack((np.stack((even, none)), np.stack((none, even)), np.stack((-y, x))))
        self.by_force, self.place, self.drive = by_force, np.zeros(3), 0.0
        self.traction, self.slip = np.zeros((2, *self.shape)), np.zeros((2, *self.shape))
        self.rubbed, self.slipping = np.zeros(self.shape), np.zeros(self.shape, dtype=bool)
        self.slip_path = np.zeros(self.shape)
        self.pressed, self.stored, self.misfit = self._apart(0.0), 0.0, 0.0

    def step(self, drive: ByDepth | ByLoad, goals: Array) -> None:
        """Go to a normal load, and to a place or force of each of the three motions.

        Parameters
        ----------
        drive
            Depth [m], or sum of p / E*; where it is not positive the bodies are apart.
        goals
            Shifts in pixels and twist [rad], or sums of tractions over E*, of the torque with places in pixels.

        Raises
        ------
        OutsideValidity
            If friction does not bear a given force.
        NotConverged
            If the step is not solved to the tolerance.
        """
        given = np.where(self.by_force, goals, goals - self.place)
        self.slipping = np.zeros(self.shape, dtype=bool)
        everywhere = (slice(None), slice(None))
        if not max(drive) > 0.0:
            self.pressed = self._apart(max(drive) if isinstance(drive, ByDepth) else 0.0)
            self._refuse(given, self.pressed.pressure, everywhere)
            self.place = np.where(self.by_force, self.place, goals)
            self.traction, self.slip = np.zeros_like(self.traction), np.zeros_like(self.slip)
            self.stored = self.misfit = self.drive = 0.0
            return
        before = self.pressed.pressure > 0.0
        if self.coupled:
            self.pressed, sheared = self._by_turns(drive, given)
            box = everywhere
        else:
            if max(drive) != self.drive:
                self.pressed = self._press(drive, self.gaps)
            box = everywhere if self.periodic else box_around(before | (self.pressed.pressure > 0.0))
            grid, old = self._grid(box), self.traction[(slice(None), *box)]
            sheared = self._sheared(grid, self.pressed.pressure, grid.sheared(old), given, old, box)
        self.drive = max(drive)
        self._remember(sheared, box)

    def state(self, time: float) -> SurfaceShearState:
        """Return what has been reached, in SI units."""
        touching = self.pressed.pressure > 0.0
        count = int(np.count_nonzero(touching))
        area = contact_area(touching, self.pixel, self.periodic) if count else (0.0, 0.0)
        sums = np.array([float(np.sum(mode * self.traction)) for mode in self.modes]) * self.patch
        energy = self.patch * self.pixel[0]
        return SurfaceShearState(
            time=time,
            depth=self.pressed.depth,
            force=self.patch * float(np.sum(self.pressed.pressure)),
            shift=self.place[:2] * self.pixel[0],
            shear_force=sums[:2],
            angle=float(self.place[2]),
            torque=float(sums[2]) * self.pixel[0],
            peak_pressure=self.modulus * float(np.max(self.pressed.pressure)),
            area=area[0],
            area_error=area[1],
            stick_share=float(np.count_nonzero(touching & ~self.slipping)) / max(count, 1),
            stored_energy=energy * self.stored,
            dissipation=energy * float(np.sum(self.rubbed)),
            misfit=self.misfit,
            penetration=self.pressed.penetration,
            pressure=self.modulus * self.pressed.pressure,
            traction=self.modulus * self.traction,
            slip=self.pixel[0] * self.slip,
            slip_path=self.slip_path,
            slipping=self.slipping,
            friction_work=self.modulus * self.pixel[0] * self.rubbed,
        )

    def _remember(self, sheared: ShearedSurface, box: tuple[slice, slice]) -> None:
        here, length = (slice(None), *box), self.pixel[0]
        slid = np.where(sheared.slipping, sheared.slip, 0.0)
        total = np.zeros_like(self.slip)
        total[here] = self.slip[here] + slid
        self.slip = total * (self.pressed.pressure > 0.0)
        self.traction = np.zeros_like(self.traction)
        self.traction[here] = sheared.traction
        self.rubbed = self.rubbed.copy()
        if isinstance(self.law, Coulomb):
            self.rubbed[box] += np.sum(sheared.traction * slid, 0)
        else:
            lost = loss_of(self.law, self.pressed.pressure[box], self.slip_path[box], length * np.hypot(*slid))
            self.rubbed[box] += lost / length
        self.slip_path = self.slip_path.copy()
        self.slip_path[box] += length * np.hypot(*slid)
        self.slipping[box] = sheared.slipping
        self.place = self.place + sheared.motion
        self.stored = 0.5 * float(np.sum(sheared.traction * sheared.displacement))
        self.misfit = sheared.misfit

    def _by_turns(self, drive: ByDepth | ByLoad, given: Array) -> tuple[PressedSurface, ShearedSurface]:
        """Find pressures and tractions by turns."""
        everywhere = (slice(None), slice(None))
        grid = self._grid(everywhere)
        before = grid.sheared(self.traction) + grid.drawn(self.pressed.pressure)

        def pressed_on(gaps: Array) -> PressedSurface:
            self.pressed = self._press(drive, gaps)
            return self.pressed

        def sheared_under(p: Array, start: Array) -> ShearedSurface:
            return self._sheared(grid, p, before - grid.drawn(p), given, start, everywhere)

        return by_turns(
            grid, self.gaps, self.pixel[0], pressed_on, sheared_under, self.traction, self.tolerance,
            by_load=isinstance(drive, ByLoad),
        )  # fmt: skip

    def _press(self, drive: ByDepth | ByLoad, gaps: Array) -> PressedSurface:
        near = self.drive > 0.0 and abs(max(drive) / self.drive - 1.0) <= NEARBY_LOAD
        start = self.pressed.pressure if near else np.empty(0)
        return press_from(gaps, self.pixel, drive, periodic=self.periodic, start=start, layers=self.layers)

    def _apart(self, depth: float) -> PressedSurface:
        return PressedSurface(np.zeros(self.shape), self.gaps - depth, depth, 0.0, 0.0, 0)

    def _sheared(
        self, grid: TractionGrid, pressure: Array, before: Array, given: Array, start: Array, box: tuple[slice, slice]
    ) -> ShearedSurface:
        """Find the tractions in a part of the map, under friction that may depend on the slip."""
        rigid = RigidStep(self.modes[(slice(None), slice(None), *box)], given, self.by_force)

        def solve(bound: Array, start: Array) -> ShearedSurface:
            self._refuse(given, bound, box)
            return shear(grid, bound, before, rigid, start, tolerance=self.tolerance)

        length, path = self.pixel[0], self.slip_path[box]
        return shear_weakened(
            solve,
            grid,
            self.law,
            pressure[box],
            path,
            length,
            start,
            self.tolerance,
            by_force=bool(np.any(self.by_force)),
        )

    def _refuse(self, given: Array, bound: Array, box: tuple[slice, slice]) -> None:
        """Refuse forces that friction does not bear."""
        forces = np.where(self.by_force, given, 0.0) * self.patch
        arms = self.pixel[0] * np.hypot(self.modes[2, 0], self.modes[2, 1])[box]
        push, torque = float(np.hypot(forces[0], forces[1])), float(forces[2]) * self.pixel[0]
        refuse_beyond(push, torque, self.patch * bound, arms)

    def _grid(self, box: tuple[slice, slice]) -> TractionGrid:
        nx, ny = self.gaps[box].shape
        return TractionGrid.of((nx, ny), self.aspect, self.compliance, periodic=self.periodic)
