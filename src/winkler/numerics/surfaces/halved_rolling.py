"""A surface that rolls, on a grid of half as many pixels along a side, and what is found there as a start.

Pixels are twice as long, so that material slips twice as far while the bodies roll by one of them.  Tractions are
carried over in parts of their bound: what slips on the coarse grid is at its bound on the fine one too.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.numerics.types import Array

__all__ = ["doubled_traction", "halved_grid", "halved_means", "in_own_units"]

ROUNDING = 1e-9
AHEAD = 1
"""Pixels added ahead of a coarse grid: what rolls in must be seen before it touches."""


def halved_grid(grid: TractionGrid) -> TractionGrid:
    """Return the grid of twice the pixel size that covers this one, with free pixels ahead."""
    (nx, ny), (dx, dy) = grid.grid.shape, grid.grid.pixel
    shape = (nx + 1) // 2 + AHEAD, (ny + 1) // 2
    return TractionGrid.of(shape, (2.0 * dx, 2.0 * dy), grid.compliance, periodic=False)


def in_own_units(grid: TractionGrid) -> tuple[TractionGrid, float]:
    """Return the grid for tractions over E* at the depth that pixels feel, and that E* over the given one.

    Steps of the solution take the response of a pixel for about one, which under a power of the depth depends on E*.
    """
    power = grid.compliance.power
    share = float(power.whole(np.ones(1))[0]) if power else 1.0
    if not power or abs(share - 1.0) < ROUNDING:
        return grid, 1.0
    power = power._replace(depth=power.depth * share ** (-1.0 / power.exponent))
    own = grid.compliance._replace(power=power)
    return TractionGrid.of(grid.grid.shape, grid.grid.pixel, own, periodic=False), 1.0 / share


def halved_means(field: Array) -> Array:
    """Return means over two by two pixels of `halved_grid`, (..., nx, ny), with zeros beyond the border."""
    nx, ny = field.shape[-2:]
    even = np.pad(field, [(0, 0)] * (field.ndim - 2) + [(0, nx % 2 + 2 * AHEAD), (0, ny % 2)])
    pairs = even.reshape(*field.shape[:-2], even.shape[-2] // 2, 2, even.shape[-1] // 2, 2)
    return np.asarray(pairs.mean(axis=(-3, -1)))


def doubled_traction(coarse: Array, coarse_bound: Array, bound: Array) -> Array:
    """Return tractions on the fine grid: in parts of their bound, straight between the pixels that have one.

    Parameters
    ----------
    coarse
        q on the grid of half as many pixels, (2, nx, ny).
    coarse_bound, bound
        g on both grids.
    """
    inside = coarse_bound > 0.0
    part = np.divide(coarse, coarse_bound, out=np.zeros_like(coarse), where=inside)
    known = _between(inside.astype(float), bound.shape)
    between = _between(part, bound.shape)
    return np.asarray(bound * np.divide(between, known, out=np.zeros_like(between), where=known > 0.0))


def _between(field: Array, shape: tuple[int, ...]) -> Array:
    """Return a field on half the pixel size, straight between the centres."""
    for axis, count in ((-2, shape[0]), (-1, shape[1])):
        fine = np.arange(count)
        own = fine // 2
        beside = np.clip(own + np.where(fine % 2, 1, -1), 0, field.shape[axis] - 1)
        field = 0.75 * np.take(field, own, axis) + 0.25 * np.take(field, beside, axis)
    return field
