r"""A height map that is pressed and sheared step by step: what it remembers, and one step of it.

Each step first presses the map, then finds its tractions (`winkler.numerics.surfaces.sheared_surface`).  The memory is
what the step before ended with: pressures and tractions, and with them the displacement of the surfaces; of bodies that
relax also what each term of their relaxation keeps (`winkler.problems.surface_friction.relaxing`).  Where the bodies
are dissimilar tractions sink the surface, and pressures draw it along; both are solved by turns until they agree
(Panagiotopoulos).
"""

from __future__ import annotations

import math

import numpy as np

from winkler.laws.friction import Coulomb
from winkler.laws.varying_friction import SlipWeakening
from winkler.media.mapped import MappedMedium, layers_of
from winkler.numerics.pixels.contact_area import contact_area
from winkler.numerics.springs.exponential_sums import RelaxationSeries
from winkler.numerics.surfaces.pressed_box import box_around
from winkler.numerics.surfaces.pressed_grid import ByDepth, ByLoad, PressedSurface
from winkler.numerics.surfaces.sheared_surface import RigidStep, ShearedSurface, shear
from winkler.numerics.surfaces.surface_grid import SurfaceGrid
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.numerics.types import Array
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.surface_friction.borne import refuse_beyond
from winkler.problems.surface_friction.by_turns import by_turns, press_from
from winkler.problems.surface_friction.relaxing import SurfaceMemory
from winkler.problems.surface_friction.state import SurfaceShearState
from winkler.problems.surface_friction.weakening import loss_of, shear_weakened
from winkler.profiles.rough.topography import Topography

__all__ = ["SurfaceMarch"]

NEARBY_LOAD = 0.25
"""A load that differs by more than this part of it from the one before is begun on coarse grids: as fast."""


class SurfaceMarch:
    """A map on its path.

    Pressures and tractions are over the E* of the step, lengths and displacements in pixels along x.  Of bodies that
    relax the E* of a step is `scale` times that of the elastic ones; forces are in pixels times the latter.

    Parameters
    ----------
    rough : Topography
        Heights of both bodies together.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace or DepthGradedHalfSpace
        Both bodies, as if they were elastic.
    course : RelaxationSeries
        By what their moduli are multiplied in the course of time.
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
        course: RelaxationSeries,
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
        self.by_force, self.place, self.drive, self.near = by_force, np.zeros(3), 0.0, False
        self.memory, self.time, self.bulk_loss = SurfaceMemory(course, self.shape), math.nan, 0.0
        self.traction, self.slip = np.zeros((2, *self.shape)), np.zeros((2, *self.shape))
        self.rubbed, self.slipping = np.zeros(self.shape), np.zeros(self.shape, dtype=bool)
        self.slip_path = np.zeros(self.shape)
        self.pressed, self.stored, self.misfit = self._apart(self.gaps, 0.0), 0.0, 0.0

    def step(self, drive: ByDepth | ByLoad, goals: Array, time: float) -> None:
        """Go to a normal load, and to a place or force of each of the three motions.

        Parameters
        ----------
        drive
            Depth [m], or sum of p / E*; where it is not positive the bodies are apart.
        goals
            Shifts in pixels and twist [rad], or sums of tractions over E*, of the torque with places in pixels.
        time
            At the end of the step [s]; what it does in no time comes suddenly.

        Raises
        ------
        OutsideValidity
            If friction does not bear a given force.
        NotConverged
            If the step is not solved to the tolerance.
        """
        memory = self.memory
        stiffer = memory.begin(0.0 if math.isnan(self.time) else time - self.time)
        self.pressed = self.pressed._replace(pressure=stiffer * self.pressed.pressure)
        self.traction, self.time = stiffer * self.traction, time
        given = np.where(self.by_force, goals / memory.scale, goals - self.place)
        push = drive if isinstance(drive, ByDepth) else ByLoad(drive.load / memory.scale)
        self.slipping = np.zeros(self.shape, dtype=bool)
        everywhere = (slice(None), slice(None))
        gaps = self._sunk() if memory.relaxes else self.gaps
        self.near = self.drive > 0.0 and abs(max(drive) / self.drive - 1.0) <= NEARBY_LOAD
        if not max(drive) > 0.0:
            self.pressed = self._apart(gaps, max(drive) if isinstance(drive, ByDepth) else float(np.min(gaps)))
            self._refuse(given, self.pressed.pressure, everywhere)
            self.place = np.where(self.by_force, self.place, goals)
            self.traction, self.slip = np.zeros_like(self.traction), np.zeros_like(self.slip)
            self.misfit = self.drive = 0.0
            self._keep(self._grid(everywhere), everywhere, np.zeros_like(self.traction))
            return
        if self.coupled:
            box, grid = everywhere, self._grid(everywhere)
            self.pressed, sheared = self._by_turns(grid, push, given, gaps)
        else:
            if memory.relaxes or max(drive) != self.drive:
                self.pressed = self._press(push, gaps)
            box = everywhere if self.periodic else box_around(memory.touched() | (self.pressed.pressure > 0.0))
            here = (slice(None), *box)
            grid, old = self._grid(box), self.traction[here]
            before = grid.sheared((memory.held - memory.base)[1:][here])
            sheared = self._sheared(grid, self.pressed.pressure, before, given, old, box)
        self.drive = max(drive)
        self._remember(sheared, box)
        self._keep(grid, box, sheared.displacement)

    def state(self, time: float) -> SurfaceShearState:
        """Return what has been reached, in SI units."""
        touching = self.pressed.pressure > 0.0
        count = int(np.count_nonzero(touching))
        area = contact_area(touching, self.pixel, self.periodic) if count else (0.0, 0.0)
        scale, modulus = self.memory.scale, self.memory.scale * self.modulus
        sums = np.array([float(np.sum(mode * self.traction)) for mode in self.modes]) * (scale * self.patch)
        energy = self.patch * self.pixel[0]
        return SurfaceShearState(
            time=time,
            depth=self.pressed.depth,
            force=scale * self.patch * float(np.sum(self.pressed.pressure)),
            shift=self.place[:2] * self.pixel[0],
            shear_force=sums[:2],
            angle=float(self.place[2]),
            torque=float(sums[2]) * self.pixel[0],
            peak_pressure=modulus * float(np.max(self.pressed.pressure)),
            area=area[0],
            area_error=area[1],
            stick_share=float(np.count_nonzero(touching & ~self.slipping)) / max(count, 1),
            stored_energy=energy * self.stored,
            dissipation=energy * (float(np.sum(self.rubbed)) + self.bulk_loss),
            bulk_loss=energy * self.bulk_loss,
            misfit=self.misfit,
            penetration=self.pressed.penetration,
            pressure=modulus * self.pressed.pressure,
            traction=modulus * self.traction,
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
            self.rubbed[box] += self.memory.scale * np.sum(sheared.traction * slid, 0)
        else:
            lost = loss_of(self.law, self.pressed.pressure[box], self.slip_path[box], length * np.hypot(*slid))
            self.rubbed[box] += self.memory.scale * lost / length
        self.slip_path = self.slip_path.copy()
        self.slip_path[box] += length * np.hypot(*slid)
        self.slipping[box] = sheared.slipping
        self.place = self.place + sheared.motion
        self.misfit = sheared.misfit

    def _keep(self, grid: TractionGrid, box: tuple[slice, slice], displacement: Array) -> None:
        """End the step, under whose tractions a part of the map is displaced along the surface."""
        memory = self.memory
        memory.end(np.concatenate((self.pressed.pressure[None], self.traction)))
        carried = grid.sheared(memory.base[1:][(slice(None), *box)]) if memory.relaxes else 0.0
        self.stored, lost = memory.energies(grid, box, displacement + carried)
        self.bulk_loss += lost

    def _sunk(self) -> Array:
        """Return the gaps between bodies whose surfaces have been displaced before the step [m]."""
        below = self.layers.in_units_of(self.pixel[0]) if self.layers else None
        surface = SurfaceGrid.of(self.shape, self.aspect, periodic=self.periodic, layers=below)
        sunk = surface.displaced(self.memory.base[0])
        if self.coupled:
            sunk = sunk + self._grid((slice(None), slice(None))).sunk(self.memory.base[1:])
        return np.asarray(self.gaps + self.pixel[0] * sunk)

    def _by_turns(
        self, grid: TractionGrid, drive: ByDepth | ByLoad, given: Array, gaps: Array
    ) -> tuple[PressedSurface, ShearedSurface]:
        """Find pressures and tractions by turns."""
        everywhere = (slice(None), slice(None))
        earlier = self.memory.held - self.memory.base
        before = grid.sheared(earlier[1:]) + grid.drawn(earlier[0])

        def pressed_on(gaps: Array) -> PressedSurface:
            self.pressed = self._press(drive, gaps)
            return self.pressed

        def sheared_under(p: Array, start: Array) -> ShearedSurface:
            return self._sheared(grid, p, before - grid.drawn(p), given, start, everywhere)

        return by_turns(
            grid, gaps, self.pixel[0], pressed_on, sheared_under, self.traction, self.tolerance,
            by_load=isinstance(drive, ByLoad),
        )  # fmt: skip

    def _press(self, drive: ByDepth | ByLoad, gaps: Array) -> PressedSurface:
        start = self.pressed.pressure if self.near else np.empty(0)
        return press_from(gaps, self.pixel, drive, periodic=self.periodic, start=start, layers=self.layers)

    def _apart(self, gaps: Array, depth: float) -> PressedSurface:
        return PressedSurface(np.zeros(self.shape), gaps - depth, depth, 0.0, 0.0, 0)

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
        patch = self.memory.scale * self.patch
        forces = np.where(self.by_force, given, 0.0) * patch
        arms = self.pixel[0] * np.hypot(self.modes[2, 0], self.modes[2, 1])[box]
        push, torque = float(np.hypot(forces[0], forces[1])), float(forces[2]) * self.pixel[0]
        refuse_beyond(push, torque, patch * bound, arms)

    def _grid(self, box: tuple[slice, slice]) -> TractionGrid:
        nx, ny = self.gaps[box].shape
        return TractionGrid.of((nx, ny), self.aspect, self.compliance, periodic=self.periodic)
