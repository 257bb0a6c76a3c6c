"""The march of a contact whose layers relax each by a law of its own: cells, steps chosen by their error, energies."""

from __future__ import annotations

import math
from typing import ClassVar, NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.line_bed import LineBed
from winkler.foundation.on_medium import UnderProfile
from winkler.loading.loads import Depth, Force
from winkler.media.offers import offers
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.numerics.springs.coupled_cells import EDGE_SHIFT, BorneCells, CoupledCells, LoadedCells
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity

CELL_ERROR = 0.1
"""Error of a step [-], times the square of the number of cells, below which cells are what is wrong."""
BEYOND = 1.3
"""Cells that are wanted so much farther than the profile is known end there."""
MOST_HALVINGS = 40
LEAVING_SHARE = 0.02
"""A step in which the contact opens may bend the force by a tolerance over this part."""
PULL, OVERLAP = 2e-3, 2e-3
"""Of the greatest pressure, and of the depth, that count as error of the cells."""
PLACES = 24


class TooNarrow(Exception):
    """The contact has reached the last cell."""


class MarchedPoint(NamedTuple):
    """A point of a path: its cells, and energies since the beginning [J]."""

    time: float
    state: LoadedCells
    work: float
    stored: float
    lost: float

    def numbers(self) -> tuple[float, float, float, float, float, float, float]:
        """Return time, depth, force, radius, work, energy stored and lost."""
        state = self.state
        return self.time, state.depth, state.force, state.radius, self.work, self.stored, self.lost


def beyond(bed: Bed) -> OutsideValidity:
    """Return the refusal of a contact that reaches where the profile ends."""
    return OutsideValidity(
        f"The contact grows beyond {bed.reach:.6g} m, where nothing is known of the profile; press less."
    )


def cells_of(bed: Bed, reach: float, count: int) -> CoupledCells:
    """Return cells up to a radius [m], or up to the rim of the body."""
    assert isinstance(bed, UnderProfile)
    assert offers(bed.medium, RelaxingByWaves)
    if reach > BEYOND * bed.reach:
        raise beyond(bed)
    reach = min(reach, bed.rim, bed.reach)
    width = reach / (count + EDGE_SHIFT)
    creep = bed.medium.creep_of_waves(width, reach)
    shape = np.asarray(bed.profile.gap(width * (np.arange(count) + 0.5)), dtype=float)
    return CoupledCells(creep.kernels(count, width), creep.times, width, shape)


class LayeredMarch:
    """A contact that is carried along.

    Parameters
    ----------
    owner : str
        For errors.
    bed : Bed
    cells : CoupledCells
    tolerance : float
        Of the depth or force in a step, of strips that of the pressure, over the greatest one so far [-].
    """

    def __init__(self, owner: str, bed: Bed | LineBed, cells: CoupledCells, tolerance: float) -> None:
        self.owner, self.bed, self.cells = owner, bed, cells
        self.tolerance = max(tolerance, CELL_ERROR / cells.count**2)
        self.pinned = cells.width * (cells.count + cells.edge_shift) >= bed.rim * (1.0 - 1e-12)
        self.state, self.time, self.work, self.lost, self.scale = cells.at_rest, 0.0, 0.0, 0.0, 0.0
        self.strip = isinstance(bed, LineBed)
        self.check = _StripCheck(cells) if self.strip else _Check(cells)

    def go(self, time: float, normal: Depth | Force, start: float, end: float) -> MarchedPoint:
        """Carry the contact on to a time [s], while depths or forces go from one to another, and return it there."""
        by_depth, span = isinstance(normal, Depth), time - self.time
        if span > 0.0:
            self._through(span, by_depth, start, end, self._borne(span, by_depth, end), 0)
        else:
            full = self._step(self.state, span, by_depth, end)
            self.work += self.cells.stored(full) - self.cells.stored(self.state)
            self.state = full
            self._scaled(full, by_depth)
        self.time = time
        self.examine()
        return MarchedPoint(time, self.state, self.work, self.cells.stored(self.state), self.lost)

    def _through(
        self, span: float, by_depth: bool, start: float, end: float, full: BorneCells | LoadedCells, level: int
    ) -> None:
        """Make a step of which the result at once is known, in two halves, or in smaller ones."""
        half, middle = 0.5 * span, 0.5 * (start + end)
        one = self._step(self.state, half, by_depth, middle)
        two = self._step(one, half, by_depth, end)
        self._scaled(two, by_depth)
        if isinstance(full, LoadedCells):  # how deep a strip is says little of its pressure
            changed = two.load - full.load
            error = math.sqrt(float(np.mean(changed**2))) / 3.0
        else:
            first, last = (each.force if by_depth else each.depth for each in (two, full))
            error = abs(first - last) / 3.0
        if by_depth and self.state.held and not two.held:
            error = max(error, LEAVING_SHARE * abs(one.force - 0.5 * self.state.force))
        if error <= self.tolerance * self.scale or level >= MOST_HALVINGS:
            self.work += _work(self.state, one, two, by_depth)
            for after in (one, two):
                self.lost += self.cells.lost(self.state, after, half)
                self.state = after
            return
        self._through(half, by_depth, start, middle, one, level + 1)
        self._through(half, by_depth, middle, end, self._borne(half, by_depth, end), level + 1)

    def _scaled(self, state: LoadedCells, by_depth: bool) -> None:
        greatest = float(np.max(state.load)) if self.strip else state.force if by_depth else state.depth
        self.scale = max(self.scale, abs(greatest))

    def _borne(self, span: float, by_depth: bool, end: float) -> BorneCells | LoadedCells:
        """Return what is borne after a step in one, with which its halves are compared; of strips each cell."""
        if self.strip:
            return self._step(self.state, span, by_depth, end)
        after = self.cells.borne(self.state, span, end if by_depth else None, None if by_depth else end)
        self._wide_enough(after.held)
        return after

    def _step(self, state: LoadedCells, span: float, by_depth: bool, end: float) -> LoadedCells:
        after = self.cells.step(state, span, end if by_depth else None, None if by_depth else end)
        self._wide_enough(after.held)
        return after

    def _wide_enough(self, held: int) -> None:
        if held == self.cells.count and not self.pinned:
            raise TooNarrow

    def examine(self) -> None:
        """Refuse a contact that is no disc: touched around a dent, pulled inside, or overlapping outside."""
        state, cells = self.state, self.cells
        what = ""
        if (state.ring and state.held == 0 and state.force > 0.0) or (state.ring and state.held > 0):
            what = "touches around a dent that has not recovered"
        elif state.held > 2:
            if self.check.pulls(state):
                what = "is pulled inside the contact"
            elif not self.pinned and self.check.overlaps(state, cells.displacement(state)):
                what = "touches outside the contact again"
        if what:
            raise OutsideValidity(
                f"{self.owner}: at {self.time:.6g} s the body {what}, so the contact is no {self.check.shape}, which "
                f"is not solved on a {type(self.bed.medium).__name__}; end the path before."
            )


def _work(first: LoadedCells, one: LoadedCells, two: LoadedCells, by_depth: bool) -> float:
    """Return the integral of F dd [J] over two halves of a step, by Simpson's rule over what is prescribed."""
    if by_depth:
        return (two.depth - first.depth) * (first.force + 4.0 * one.force + two.force) / 6.0
    mean = (first.depth + 4.0 * one.depth + two.depth) / 6.0
    return two.force * two.depth - first.force * first.depth - (two.force - first.force) * mean


class _StripCheck:
    """Pressure and separation of strips, which the cells bear themselves."""

    shape: ClassVar[str] = "single strip"

    def __init__(self, cells: CoupledCells) -> None:
        self.cells = cells

    def pulls(self, state: LoadedCells) -> bool:
        """Return whether the pressure is a pull somewhere."""
        return bool(np.any(state.load[: state.held - 1] < -PULL * np.max(state.load)))

    def overlaps(self, state: LoadedCells, displacement: Array) -> bool:
        """Return whether the bodies overlap somewhere outside."""
        apart = (self.cells.shape - state.depth + displacement)[state.held + 2 :]
        return bool(np.any(apart < -OVERLAP * float(np.ptp(self.cells.shape[: state.held + 1]))))


class _Check:
    """Pressure and separation at some places, from line load and displacement."""

    shape: ClassVar[str] = "disc"

    def __init__(self, cells: CoupledCells) -> None:
        edges = cells.width * np.arange(cells.count + 1)
        self.places = edges[-1] * (np.arange(PLACES) + 0.5) / PLACES
        r = self.places[:, None]
        # over one interval of the slope of q between the middles of cells
        ends = np.maximum(np.append(cells.middle, edges[-1]), r)
        self.pressure = -np.diff(np.log(ends + np.sqrt(ends**2 - r**2)), axis=1) / (np.pi * cells.width)
        self.opening = 2.0 / np.pi * np.diff(np.arcsin(np.minimum(edges / r, 1.0)), axis=1)
        self.cells = cells

    def pulls(self, state: LoadedCells) -> bool:
        """Return whether the pressure is a pull somewhere."""
        if state.held == state.load.size:  # pinned at the rim: the slope is that of a punch
            return False
        pressure = self.pressure @ np.diff(np.append(state.load, 0.0))
        inside = self.places < self.cells.middle[state.held - 1] - self.cells.width
        return bool(np.any(pressure[inside] < -PULL * np.max(pressure)))

    def overlaps(self, state: LoadedCells, displacement: Array) -> bool:
        """Return whether the bodies overlap somewhere outside."""
        apart = np.where(np.arange(state.load.size) < state.held, 0.0, self.cells.shape - state.depth + displacement)
        outside = self.places > self.cells.middle[state.held - 1] + 2.0 * self.cells.width
        return bool(np.any((self.opening @ apart)[outside] < -OVERLAP * abs(state.depth)))
