r"""A height map as a row of pixels: what it remembers, and one step of it.

Each step first presses the map, then finds its tractions (`winkler.numerics.surfaces.sheared_surface`).  The memory is
what the step before ended with: pressures and tractions, and with them the displacement of the surfaces; of bodies that
relax also what each term of their relaxation keeps (`winkler.problems.surface_friction.relaxing`).  Where the bodies
are dissimilar tractions sink the surface, and pressures draw it along; both are solved by turns until they agree
(Panagiotopoulos).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.laws.friction import Coulomb
from winkler.laws.varying_friction import SlipWeakening
from winkler.media.mapped import MappedMedium, layers_of
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.numerics.pixels.contact_area import contact_area
from winkler.numerics.pixels.layered import SurfaceBelow
from winkler.numerics.springs.exponential_sums import RelaxationSeries
from winkler.numerics.surfaces.pressed_box import ByDepth, ByLoad, box_around
from winkler.numerics.surfaces.pressed_grid import PressedSurface
from winkler.numerics.surfaces.sheared_surface import RigidStep, ShearedSurface, shear
from winkler.numerics.surfaces.surface_grid import SurfaceGrid
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.numerics.types import Array
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.row import Reached, Row
from winkler.problems.surface_friction.borne import refuse_beyond
from winkler.problems.surface_friction.by_turns import by_turns, press_from
from winkler.problems.surface_friction.crept import CreptMemory, MapCreep
from winkler.problems.surface_friction.relaxing import SurfaceMemory
from winkler.problems.surface_friction.state import SurfaceShearState
from winkler.problems.surface_friction.weakening import loss_of, shear_weakened
from winkler.profiles.rough.topography import Topography

Memory = SurfaceMemory | CreptMemory

NEARBY_LOAD = 0.25
"""A load that differs by more than this part of it from the one before is begun on coarse grids: as fast."""


class MapGoal(NamedTuple):
    """What is prescribed at a point of the path.

    `drive` is a depth [m] or a sum of p / E*; where it is not positive the bodies are apart.  `motions` (3,) are shifts
    in pixels and a twist [rad], or sums of tractions over E*, of the torque with places in pixels.
    """

    time: float
    drive: ByDepth | ByLoad
    motions: Array


class MapPlaces(NamedTuple):
    """What a map remembers.

    Parameters
    ----------
    time : float
        t [s]; not a number before the path begins.
    place : ndarray, (3,)
        Shifts in pixels, and twist [rad].
    drive : float
        Depth [m] or load over E* that pressed it; zero while the bodies are apart.
    pressed : PressedSurface
        Pressures over the E* of the step.
    traction, slip : ndarray, (2, nx, ny)
        Over the E* of the step, and in pixels.
    slip_path, rubbed : ndarray, (nx, ny)
        [m], and what friction has lost per area, in pixels times E*.
    slipping : ndarray of bool, (nx, ny)
    misfit : float
        As of `ShearedSurface`.
    memory : SurfaceMemory or CreptMemory
    stored, bulk_loss : float
        Energy of the tractions, and what the bodies have lost inside, in pixels cubed times E*.
    """

    time: float
    place: Array
    drive: float
    pressed: PressedSurface
    traction: Array
    slip: Array
    slip_path: Array
    rubbed: Array
    slipping: Array
    misfit: float
    memory: Memory
    stored: float = 0.0
    bulk_loss: float = 0.0


class MapRow(Row[MapGoal, MapPlaces]):
    """A map under a path; the points of the path are its steps.

    Pressures and tractions are over the E* of the step, lengths and displacements in pixels along x.  Of bodies that
    relax the E* of a step is `scale` times that of the elastic ones; forces are in pixels times the latter.  Losses
    are in J; the work is no number.

    Parameters
    ----------
    rough : Topography
        Heights of both bodies together.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace or DepthGradedHalfSpace
        Both bodies, as if they were elastic.
    course : RelaxationSeries or RelaxingByWaves
        By what their moduli are multiplied in the course of time; or layers that relax each by a law of its own.
    law : Coulomb, LinearSlipWeakening or ExponentialSlipWeakening
        Law of friction.
    by_force : ndarray of bool, (3,)
        Of which motions along x, along y and about the middle the force is given.
    tolerance : float
        As of `shear`.
    """

    owner = "SurfaceTangential"

    def __init__(
        self,
        rough: Topography,
        medium: MappedMedium,
        course: RelaxationSeries | RelaxingByWaves,
        law: Coulomb | SlipWeakening,
        by_force: Array,
        tolerance: float,
    ):
        self.gaps, self.pixel, self.periodic, self.modulus = rough.gaps, rough.pixel, rough.periodic, medium.modulus
        self.compliance, self.law, self.tolerance = compliance_of(medium).in_units_of(self.pixel[0]), law, tolerance
        self.layers, self.by_force = layers_of(medium), by_force
        self.coupled = self.compliance.coupling != 0.0  # pressures draw the surface along
        nx, ny = self.gaps.shape
        self.shape, self.aspect = (nx, ny), (1.0, self.pixel[1] / self.pixel[0])
        self.fresh: Memory
        if isinstance(course, RelaxationSeries):
            self.fresh = SurfaceMemory.fresh(course, self.shape)
        else:
            self.fresh = CreptMemory.fresh(MapCreep(course, self.shape, self.pixel, periodic=self.periodic), self.shape)
        self.relaxes = self.fresh.spans.size > 0
        self.patch = self.modulus * self.pixel[0] * self.pixel[1]
        x = np.broadcast_to((np.arange(nx) - 0.5 * (nx - 1))[:, None], self.shape)
        y = np.broadcast_to(((np.arange(ny) - 0.5 * (ny - 1)) * self.aspect[1])[None, :], self.shape)
        even, none = np.ones(self.shape), np.zeros(self.shape)
        self.modes = np.stack((np.stack((even, none)), np.stack((none, even)), np.stack((-y, x))))

    def begin(self, goal: MapGoal) -> Reached[MapPlaces]:
        """Return the map at the first point: straight down first, since that alone shears dissimilar bodies."""
        flat, lines, none = np.zeros(self.shape), np.zeros((2, *self.shape)), np.zeros(self.shape, dtype=bool)
        apart = self._apart(self.gaps, 0.0)
        places = MapPlaces(math.nan, np.zeros(3), 0.0, apart, lines, lines, flat, flat, none, 0.0, self.fresh)
        if not self.coupled:
            return self.step(places, goal)
        pressed = self.step(places, goal._replace(motions=np.zeros(3)))
        return pressed.then(self.step(pressed.state, goal))

    def step(self, state: MapPlaces, goal: MapGoal) -> Reached[MapPlaces]:
        """Return the map after a step; what it does in no time comes suddenly.

        Raises
        ------
        OutsideValidity
            If friction does not bear a given force.
        NotConverged
            If the step is not solved to the tolerance.
        """
        drive, memory = goal.drive, state.memory.begin(0.0 if math.isnan(state.time) else goal.time - state.time)
        stiffer, pushed = state.memory.scale / memory.scale, max(drive)
        pressed = state.pressed._replace(pressure=stiffer * state.pressed.pressure)
        state = state._replace(
            time=goal.time, pressed=pressed, traction=stiffer * state.traction, memory=memory,
            slipping=np.zeros(self.shape, dtype=bool),
        )  # fmt: skip
        given = np.where(self.by_force, goal.motions / memory.scale, goal.motions - state.place)
        push = drive if isinstance(drive, ByDepth) else ByLoad(drive.load / memory.scale)
        everywhere = (slice(None), slice(None))
        gaps = self._sunk(memory) if self.relaxes else self.gaps
        if not pushed > 0.0:
            pressed = self._apart(gaps, pushed if isinstance(drive, ByDepth) else float(np.min(gaps)))
            self._refuse(given, pressed.pressure, everywhere, memory.scale)
            none, place = np.zeros_like(state.traction), np.where(self.by_force, state.place, goal.motions)
            state = state._replace(pressed=pressed, place=place, traction=none, slip=none, misfit=0.0, drive=0.0)
            return self._kept(state, self._grid(everywhere), everywhere, none, 0.0)
        near = state.drive > 0.0 and abs(pushed / state.drive - 1.0) <= NEARBY_LOAD
        if self.coupled:
            box, grid = everywhere, self._grid(everywhere)
            pressed, sheared = self._by_turns(state, grid, push, given, gaps, near)
        else:
            if self.relaxes or pushed != state.drive:
                pressed = self._press(push, gaps, pressed.pressure if near else np.empty(0), memory.layers(self.layers))
            box = everywhere if self.periodic else box_around(memory.touched() | (pressed.pressure > 0.0))
            here = (slice(None), *box)
            grid, old = memory.grid(self._grid(box)), state.traction[here]
            before = memory.left(grid, box)
            sheared = self._sheared(state, grid, pressed.pressure, before, given, old, box)
        state, lost = self._rubbed(state._replace(pressed=pressed, drive=pushed), sheared, box)
        return self._kept(state, grid, box, sheared.displacement, lost)

    def state(self, reached: Reached[MapPlaces]) -> SurfaceShearState:
        """Return what has been reached, in SI units."""
        places, energy = reached.state, self.patch * self.pixel[0]
        pressed, scale = places.pressed, places.memory.scale
        touching, modulus = pressed.pressure > 0.0, scale * self.modulus
        count = int(np.count_nonzero(touching))
        area = contact_area(touching, self.pixel, self.periodic) if count else (0.0, 0.0)
        sums = np.array([float(np.sum(mode * places.traction)) for mode in self.modes]) * (scale * self.patch)
        return SurfaceShearState(
            time=places.time,
            depth=pressed.depth,
            force=scale * self.patch * float(np.sum(pressed.pressure)),
            shift=places.place[:2] * self.pixel[0],
            shear_force=sums[:2],
            angle=float(places.place[2]),
            torque=float(sums[2]) * self.pixel[0],
            peak_pressure=modulus * float(np.max(pressed.pressure)),
            area=area[0],
            area_error=area[1],
            stick_share=float(np.count_nonzero(touching & ~places.slipping)) / max(count, 1),
            stored_energy=energy * places.stored,
            dissipation=reached.lost,
            bulk_loss=energy * places.bulk_loss,
            misfit=places.misfit,
            penetration=pressed.penetration,
            pressure=modulus * pressed.pressure,
            traction=modulus * places.traction,
            slip=self.pixel[0] * places.slip,
            slip_path=places.slip_path,
            slipping=places.slipping,
            friction_work=self.modulus * self.pixel[0] * places.rubbed,
        )

    def _rubbed(self, state: MapPlaces, sheared: ShearedSurface, box: tuple[slice, slice]) -> tuple[MapPlaces, float]:
        """Return the map with the tractions of a part of it, and what friction has lost, as `bulk_loss`."""
        here, length = (slice(None), *box), self.pixel[0]
        slid = np.where(sheared.slipping, sheared.slip, 0.0)
        slip, traction = np.zeros_like(state.slip), np.zeros_like(state.traction)
        slip[here], traction[here] = state.slip[here] + slid, sheared.traction
        if isinstance(self.law, Coulomb):
            lost = np.sum(sheared.traction * slid, 0)
        else:
            far = length * np.hypot(*slid)
            lost = loss_of(self.law, state.pressed.pressure[box], state.slip_path[box], far) / length
        lost = state.memory.scale * lost
        rubbed, path, slipping = state.rubbed.copy(), state.slip_path.copy(), state.slipping.copy()
        rubbed[box] += lost
        path[box] += length * np.hypot(*slid)
        slipping[box] = sheared.slipping
        state = state._replace(
            place=state.place + sheared.motion, traction=traction, slip=slip * (state.pressed.pressure > 0.0),
            slip_path=path, rubbed=rubbed, slipping=slipping, misfit=sheared.misfit,
        )  # fmt: skip
        return state, float(np.sum(lost))

    def _kept(
        self, state: MapPlaces, grid: TractionGrid, box: tuple[slice, slice], displacement: Array, rubbed: float
    ) -> Reached[MapPlaces]:
        """Return the map at the end of a step, under whose tractions a part of it is displaced along the surface."""
        memory = state.memory.end(np.concatenate((state.pressed.pressure[None], state.traction)))
        carried = memory.carried(grid, box) if self.relaxes else 0.0
        stored, lost = memory.energies(grid, box, displacement + carried)
        state = state._replace(memory=memory, stored=stored, bulk_loss=state.bulk_loss + lost)
        return Reached(state, math.nan, self.patch * self.pixel[0] * (rubbed + lost))

    def _sunk(self, memory: Memory) -> Array:
        """Return the gaps between bodies whose surfaces have been displaced before the step [m]."""
        below = self.layers.in_units_of(self.pixel[0]) if self.layers else None
        surface = SurfaceGrid.of(self.shape, self.aspect, periodic=self.periodic, layers=below)
        sunk = memory.sunk(surface)
        if self.coupled:
            sunk = sunk + self._grid((slice(None), slice(None))).sunk(memory.base[1:])
        return np.asarray(self.gaps + self.pixel[0] * sunk)

    def _by_turns(
        self, state: MapPlaces, grid: TractionGrid, drive: ByDepth | ByLoad, given: Array, gaps: Array, near: bool
    ) -> tuple[PressedSurface, ShearedSurface]:
        """Find pressures and tractions by turns."""
        everywhere, start = (slice(None), slice(None)), state.pressed.pressure
        earlier = state.memory.held - state.memory.base
        before = grid.sheared(earlier[1:]) + grid.drawn(earlier[0])

        def pressed_on(gaps: Array) -> PressedSurface:
            nonlocal start
            pressed = self._press(drive, gaps, start if near else np.empty(0), self.layers)
            start = pressed.pressure
            return pressed

        def sheared_under(p: Array, first: Array) -> ShearedSurface:
            return self._sheared(state, grid, p, before - grid.drawn(p), given, first, everywhere)

        return by_turns(
            grid, gaps, self.pixel[0], pressed_on, sheared_under, state.traction, self.tolerance,
            by_load=isinstance(drive, ByLoad),
        )  # fmt: skip

    def _press(self, drive: ByDepth | ByLoad, gaps: Array, start: Array, layers: SurfaceBelow | None) -> PressedSurface:
        return press_from(gaps, self.pixel, drive, periodic=self.periodic, start=start, layers=layers)

    def _apart(self, gaps: Array, depth: float) -> PressedSurface:
        return PressedSurface(np.zeros(self.shape), gaps - depth, depth, 0.0, 0.0, 0)

    def _sheared(
        self,
        state: MapPlaces,
        grid: TractionGrid,
        pressure: Array,
        before: Array,
        given: Array,
        start: Array,
        box: tuple[slice, slice],
    ) -> ShearedSurface:
        """Find the tractions in a part of the map, under friction that may depend on the slip."""
        rigid = RigidStep(self.modes[(slice(None), slice(None), *box)], given, self.by_force)

        def solve(bound: Array, start: Array) -> ShearedSurface:
            self._refuse(given, bound, box, state.memory.scale)
            return shear(grid, bound, before, rigid, start, tolerance=self.tolerance)

        length, path = self.pixel[0], state.slip_path[box]
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

    def _refuse(self, given: Array, bound: Array, box: tuple[slice, slice], scale: float) -> None:
        """Refuse forces that friction does not bear."""
        patch = scale * self.patch
        forces = np.where(self.by_force, given, 0.0) * patch
        arms = self.pixel[0] * np.hypot(self.modes[2, 0], self.modes[2, 1])[box]
        push, torque = float(np.hypot(forces[0], forces[1])), float(forces[2]) * self.pixel[0]
        refuse_beyond(push, torque, patch * bound, arms)

    def _grid(self, box: tuple[slice, slice]) -> TractionGrid:
        nx, ny = self.gaps[box].shape
        return TractionGrid.of((nx, ny), self.aspect, self.compliance, periodic=self.periodic)
