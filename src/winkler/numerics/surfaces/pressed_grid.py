r"""A rigid height map pressed into an elastic half-space, without friction and adhesion, on a grid.

Pressures p >= 0 and gaps w = u + h - d >= 0 are sought of which one is zero in every pixel.  They are the minimum of
p G p / 2 + p (h - d) over p >= 0, found by conjugate gradients on the pixels in contact.  The operator smooths like
1/\|q\|; preconditioned with \|q\| the number of iterations hardly depends on the grid, and begun from the solution on
a grid of half as many pixels it takes about ten.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.errors import NotConverged, OutsideValidity
from winkler.numerics.surfaces.layered_pixels import SurfaceBelow
from winkler.numerics.surfaces.pressed_box import BoxContact, ByDepth, ByLoad, box_around, overlap_and_work, shared
from winkler.numerics.surfaces.surface_grid import DOUBLE, SINGLE, SurfaceGrid
from winkler.numerics.types import Array

__all__ = ["ByDepth", "ByLoad", "PressedSurface", "press"]

COARSEST_PIXELS = 32
"""Grids of fewer pixels along a side are not halved any more."""
COARSE_TOLERANCE = 1e-3
"""To what the coarser grids are solved."""
LARGEST_DEPTH_RATIO = 0.99
"""Coarse periodic grids are not pressed deeper than this part of the depth that closes them."""
FIRST_CONTACT_RATIO = 0.01
"""Part of the pixels, the highest ones, under which a load begins."""
MOST_ROUNDS = 20
"""How often the whole surface is checked before it has not converged; two are usual."""
SINGLE_DIGITS_CONTRAST, CONTRAST_WAVES = 1e2, 40
"""Ratio of 1 + M among these many waves up to which single digits are enough."""
INNER_RATIO = 0.6
"""Part of the tolerance to which the box around the contact is solved, and then to less."""


class PressedSurface(NamedTuple):
    """The pressed surface.

    Parameters
    ----------
    pressure
        p / E*, (nx, ny).
    gap
        w [m], (nx, ny).
    depth
        d [m].
    penetration
        Greatest overlap that is left, over d.
    work
        Sum of p |w| over the sum of p d: zero if pressed pixels touch, and only they.
    iterations
        On the finest grid.
    """

    pressure: Array
    gap: Array
    depth: float
    penetration: float
    work: float
    iterations: int


class _Surface(NamedTuple):
    """What a grid is made on: the size of its pixels, whether it is periodic, and what lies below."""

    pixel: tuple[float, float]
    periodic: bool
    layers: SurfaceBelow | None

    def grid(self, shape: tuple[int, ...], digits: np.dtype[np.floating] = DOUBLE) -> SurfaceGrid:
        """Return the grid of this shape."""
        size = shape[0], shape[1]
        return SurfaceGrid.of(size, self.pixel, periodic=self.periodic, digits=digits, layers=self.layers)

    def rough_grid(self, shape: tuple[int, ...]) -> SurfaceGrid:
        """Return the grid for changes of pressures, whose digits suffice for the contrast of the layers."""
        if not self.layers:
            return self.grid(shape, SINGLE)
        longest = max(n * side for n, side in zip(shape, self.pixel, strict=True))
        waves = 2.0 * np.pi * np.geomspace(1.0 / longest, 0.5 / min(self.pixel), CONTRAST_WAVES)
        whole = self.layers.whole(waves)
        return self.grid(shape, SINGLE if float(np.max(whole) / np.min(whole)) < SINGLE_DIGITS_CONTRAST else DOUBLE)

    @property
    def coarser(self) -> _Surface:
        """The same in pixels of twice the size."""
        return self._replace(pixel=(2.0 * self.pixel[0], 2.0 * self.pixel[1]))


def _halved(heights: Array) -> Array:
    """Return means over two by two pixels."""
    nx, ny = heights.shape[0] // 2, heights.shape[1] // 2
    return np.asarray(heights[: 2 * nx, : 2 * ny].reshape(nx, 2, ny, 2).mean(axis=(1, 3)))


def _doubled(pressure: Array, shape: tuple[int, int]) -> Array:
    """Return the pressure on a grid of half the pixel size, straight between the centres, under what bears."""
    fine, bearing = pressure, pressure > 0.0
    for axis in (0, 1):
        ahead = np.concatenate((np.delete(fine, 0, axis), np.take(fine, [-1], axis)), axis)
        behind = np.concatenate((np.take(fine, [0], axis), np.delete(fine, -1, axis)), axis)
        pair = np.stack((0.75 * fine + 0.25 * behind, 0.75 * fine + 0.25 * ahead), axis + 1)
        fine = pair.reshape((*pair.shape[:axis], -1, *pair.shape[axis + 2 :]))
        short = shape[axis] - fine.shape[axis]
        fine = np.concatenate((fine, np.take(fine, [-1] * short, axis)), axis) if short > 0 else fine
        bearing = np.take(bearing, np.minimum(np.arange(shape[axis]) // 2, bearing.shape[axis] - 1), axis)
    return np.where(bearing, fine, 0.0)


def press(
    heights: Array,
    pixel: tuple[float, float],
    drive: ByDepth | ByLoad,
    *,
    periodic: bool,
    ceiling: float = math.inf,
    tolerance: float = 1e-6,
    start: Array | tuple[()] = (),
    layers: SurfaceBelow | None = None,
) -> PressedSurface:
    """Solve the contact.

    Parameters
    ----------
    heights
        h [m] of the undeformed gap over the highest point, (nx, ny), not negative, zero somewhere.
    pixel
        (dx, dy) [m].
    drive
        What is prescribed.
    periodic
        Whether the surface is repeated for ever.
    ceiling
        Hardness over E*: pressures do not rise above it.
    tolerance
        Bound on `Pressed.penetration` and `Pressed.work`.
    start
        Pressures of a contact nearby, over E*; nothing to begin on coarser grids.
    layers
        In m, what differs from a homogeneous half-space of this E*; nothing unless given.

    Raises
    ------
    NotConverged
        If the bounds are not met, or the contrasts of the layers are too large.
    OutsideValidity
        If the pixels are too coarse for the layers.
    """
    # in pixels along the map, and in about the depth across: small and large surfaces are the same to single digits
    patch = pixel[0] * pixel[1]
    match drive:
        case ByDepth(depth):
            unit = depth
            scaled: ByDepth | ByLoad = ByDepth(1.0)
        case ByLoad(load):
            unit = load * math.sqrt(patch / heights.size)
            unit = min(unit, float(np.mean(heights))) if periodic else unit  # which is never deeper than closed
            scaled = ByLoad(load * pixel[0] / unit)
    strain = unit / pixel[0]
    begin = np.asarray(start) / strain
    surface = _Surface((1.0, pixel[1] / pixel[0]), periodic, layers.in_units_of(pixel[0]) if layers else None)
    pressed = _pressed(heights / unit, surface, scaled, ceiling / strain, tolerance, begin)
    return pressed._replace(pressure=strain * pressed.pressure, gap=unit * pressed.gap, depth=unit * pressed.depth)


def _pressed(
    heights: Array,
    surface: _Surface,
    drive: ByDepth | ByLoad,
    ceiling: float,
    tolerance: float,
    start: Array,
) -> PressedSurface:
    """Return the contact: solved where it may be, then checked everywhere, until nothing changes."""
    shape = heights.shape
    whole, everywhere = surface.grid(shape), (slice(None), slice(None))
    begun = start if len(start) else _from_coarser(heights, surface, drive, ceiling)
    p = _first(heights, drive, surface.pixel, ceiling, begun)
    depth, count, inner = drive.depth if isinstance(drive, ByDepth) else math.nan, 0, INNER_RATIO * tolerance
    for _ in range(MOST_ROUNDS):
        u = whole.displaced(p)
        if math.isnan(depth):
            depth = float(np.mean((u + heights)[p > 0.0]))
        gap = u + heights - depth
        left = overlap_and_work(p, gap, depth, ceiling)
        if max(left) <= tolerance:
            return PressedSurface(p, gap, depth, *left, count)
        box = box_around((p > 0.0) | (gap < 0.0)) if math.isinf(ceiling) and not surface.periodic else everywhere
        grid = surface.rough_grid(heights[box].shape)
        contact = BoxContact(grid, heights[box], drive, ceiling, p[box], u[box], depth)
        count += contact.solve(inner)
        p[box], depth, inner = contact.p, contact.depth, max(inner * INNER_RATIO, 1e-15)
    raise NotConverged(
        f"the contact of {shape[0]} x {shape[1]} pixels still overlaps by {left[0]:.3g} of its depth, and pressures do "
        f"{left[1]:.3g} of the work on gaps, after {MOST_ROUNDS} rounds; allowed are {tolerance:.3g} of both. "
        "Allow a larger tolerance, or smooth the heights."
    )


def _first(heights: Array, drive: ByDepth | ByLoad, pixel: tuple[float, float], ceiling: float, start: Array) -> Array:
    """Return pressures to begin with, that bear the load."""
    if isinstance(drive, ByDepth):
        sunk = np.maximum(drive.depth - heights, 0.0) / (max(heights.shape) * max(pixel))
        return np.minimum(start if np.any(start) else sunk, ceiling)
    p = start if np.any(start) else np.where(heights <= np.quantile(heights, FIRST_CONTACT_RATIO), 1.0, 0.0)
    p = p * (drive.load / float(np.sum(p)))
    return p if float(np.max(p)) <= ceiling else shared(np.minimum(p, ceiling) - heights, ceiling, drive.load)


def _from_coarser(heights: Array, surface: _Surface, drive: ByDepth | ByLoad, ceiling: float) -> Array:
    """Return the pressures of a grid of half as many pixels along a side, or zeros where there is none."""
    nothing = np.zeros(heights.shape)
    if min(heights.shape) < 2 * COARSEST_PIXELS:
        return nothing
    coarse = _halved(heights)
    lowest = float(np.min(coarse))
    easier = ByDepth(drive.depth - lowest) if isinstance(drive, ByDepth) else ByLoad(drive.load / 4.0)
    if float(np.ptp(coarse)) == 0.0:  # a fine grating: its means do not resolve it
        return nothing
    most = float(np.mean(coarse)) - lowest if surface.periodic else math.inf
    if isinstance(easier, ByDepth) and not 0.0 < easier.depth < LARGEST_DEPTH_RATIO * most:
        return nothing
    try:
        pressed = _pressed(coarse - lowest, surface.coarser, easier, ceiling, COARSE_TOLERANCE, np.empty(0))
    except (NotConverged, OutsideValidity):  # the coarse grid is only a first guess, or too coarse for the layers
        return nothing
    return _doubled(pressed.pressure, heights.shape)
