r"""A height map that is pressed and sheared step by step: what it remembers, and one step of it.

Each step first presses the map, then finds its tractions (`winkler.numerics.surfaces.sheared_surface`).  The memory is
the traction with which the step before ended, and with it the displacement of the surfaces.  Where the bodies are
dissimilar tractions sink the surface, and pressures draw it along; both are solved by turns until they agree
(Panagiotopoulos).
"""

from __future__ import annotations

import math

import numpy as np

from winkler.errors import NotConverged, OutsideValidity
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.surfaces.pressed_box import box_around, overlap_and_work
from winkler.numerics.surfaces.pressed_grid import ByDepth, ByLoad, PressedSurface, press
from winkler.numerics.surfaces.sheared_surface import RigidStep, ShearedSurface, shear
from winkler.numerics.surfaces.surface_grid import SurfaceGrid
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.numerics.types import Array
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.rough.contact_area import contact_area
from winkler.problems.surface_friction.state import SurfaceShearState
from winkler.profiles.rough.topography import Topography

__all__ = ["SurfaceMarch"]

MOST_TURNS = 60
"""How often pressures and tractions are found by turns; six are usual."""
NEARBY_LOAD = 0.25
"""A load that differs by more than this part of it from the one before is begun on coarse grids: as fast."""
SLIDING_RATIO = 1.0 - 1e-7
"""Part of the friction beyond which given forces let the bodies slide: what slips is never all parallel."""
COUPLED_TOLERANCE = 1e-5
"""Least bound on overlap and work on gaps where pressures and tractions are found by turns."""


class SurfaceMarch:
    """A map on its path.

    Pressures and tractions are over E*, lengths and displacements in pixels along x, and forces in pixels times E*.

    Parameters
    ----------
    rough : Topography
        Heights of both bodies together.
    medium : HomogeneousMedium
        Both bodies.
    coefficient : float
        Of friction.
    by_force : ndarray of bool, (3,)
        Of which motions along x, along y and about the middle the force is given.
    tolerance : float
        As of `shear`.
    """

    def __init__(
        self, rough: Topography, medium: HomogeneousMedium, coefficient: float, by_force: Array, tolerance: float
    ):
        self.gaps, self.pixel, self.periodic, self.modulus = rough.gaps, rough.pixel, rough.periodic, medium.modulus
        self.compliance, self.coefficient, self.tolerance = compliance_of(medium), coefficient, tolerance
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
            self._refuse(given)
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
            self._refuse(given)
            box = everywhere if self.periodic else box_around(before | (self.pressed.pressure > 0.0))
            grid, old = self._grid(box), self.traction[(slice(None), *box)]
            sheared = shear(
                grid, self.coefficient * self.pressed.pressure[box], grid.sheared(old), self._rigid(given, box), old,
                tolerance=self.tolerance,
            )  # fmt: skip
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
            slipping=self.slipping,
            friction_work=self.modulus * self.pixel[0] * self.rubbed,
        )

    def _remember(self, sheared: ShearedSurface, box: tuple[slice, slice]) -> None:
        here = (slice(None), *box)
        slid = np.where(sheared.slipping, sheared.slip, 0.0)
        total = np.zeros_like(self.slip)
        total[here] = self.slip[here] + slid
        self.slip = total * (self.pressed.pressure > 0.0)
        self.traction = np.zeros_like(self.traction)
        self.traction[here] = sheared.traction
        self.rubbed = self.rubbed.copy()
        self.rubbed[box] += np.sum(sheared.traction * slid, 0)
        self.slipping[box] = sheared.slipping
        self.place = self.place + sheared.motion
        self.stored = 0.5 * float(np.sum(sheared.traction * sheared.displacement))
        self.misfit = sheared.misfit

    def _by_turns(self, drive: ByDepth | ByLoad, given: Array) -> tuple[PressedSurface, ShearedSurface]:
        """Find pressures and tractions by turns."""
        everywhere = (slice(None), slice(None))
        grid, whole = self._grid(everywhere), SurfaceGrid.of(self.shape, self.aspect, periodic=self.periodic)
        before = grid.sheared(self.traction) + grid.drawn(self.pressed.pressure)
        rigid, start = self._rigid(given, everywhere), self.traction
        allowed = max(self.tolerance, COUPLED_TOLERANCE)
        left = math.inf
        for _ in range(MOST_TURNS):
            self.pressed = pressed = self._press(drive, self.gaps + self.pixel[0] * grid.sunk(start))
            self._refuse(given)
            p = pressed.pressure
            sheared = shear(grid, self.coefficient * p, before - grid.drawn(p), rigid, start, tolerance=self.tolerance)
            gap = self.gaps + self.pixel[0] * (whole.displaced(p) + grid.sunk(sheared.traction)) - pressed.depth
            deeper = float(np.mean(gap[p > 0.0])) if isinstance(drive, ByLoad) else 0.0
            overlap, work = overlap_and_work(p, gap - deeper, pressed.depth + deeper, math.inf)
            left, start = max(overlap, work), sheared.traction
            if left <= allowed:
                depth = pressed.depth + deeper
                return pressed._replace(gap=gap - deeper, depth=depth, penetration=overlap, work=work), sheared
        raise NotConverged(
            f"pressures and tractions of dissimilar bodies still miss each other by {left:.3g} of the depth after "
            f"{MOST_TURNS} turns; allowed are {allowed:.3g}. Take shorter steps, or bodies that are more alike"
        )

    def _press(self, drive: ByDepth | ByLoad, gaps: Array) -> PressedSurface:
        """Press a surface whose lowest gap need not be zero."""
        lowest = float(np.min(gaps))
        deeper = ByDepth(drive.depth - lowest) if isinstance(drive, ByDepth) else drive
        if not max(deeper) > 0.0:
            return self._apart(max(drive))
        near = self.drive > 0.0 and abs(max(drive) / self.drive - 1.0) <= NEARBY_LOAD
        start = self.pressed.pressure if near else np.empty(0)
        pressed = press(gaps - lowest, self.pixel, deeper, periodic=self.periodic, start=start)
        return pressed._replace(depth=pressed.depth + lowest)

    def _apart(self, depth: float) -> PressedSurface:
        return PressedSurface(np.zeros(self.shape), self.gaps - depth, depth, 0.0, 0.0, 0)

    def _refuse(self, given: Array) -> None:
        """Refuse forces that friction does not bear."""
        bound = self.coefficient * self.pressed.pressure
        most = float(np.sum(bound))
        forces = np.where(self.by_force, given, 0.0)
        push = float(np.hypot(forces[0], forces[1]))
        if push > most * SLIDING_RATIO and push > 0.0:
            raise OutsideValidity(
                f"a shear force of {push * self.patch:.6g} N is prescribed where friction bears less than "
                f"{most * self.patch:.6g} N, and the bodies would slide away; give a smaller one"
            )
        borne = float(np.sum(bound * np.hypot(self.modes[2, 0], self.modes[2, 1])))
        if abs(forces[2]) > borne * SLIDING_RATIO and forces[2] != 0.0:
            unit = self.patch * self.pixel[0]
            raise OutsideValidity(
                f"a torque of {forces[2] * unit:.6g} N m is prescribed where friction bears less than "
                f"{borne * unit:.6g} N m, and the bodies would turn away; give a smaller one"
            )

    def _rigid(self, given: Array, box: tuple[slice, slice]) -> RigidStep:
        return RigidStep(self.modes[(slice(None), slice(None), *box)], given, self.by_force)

    def _grid(self, box: tuple[slice, slice]) -> TractionGrid:
        nx, ny = self.gaps[box].shape
        return TractionGrid.of((nx, ny), self.aspect, self.compliance, periodic=self.periodic)
