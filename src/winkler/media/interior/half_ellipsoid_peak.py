r"""The greatest stress below a half-ellipsoid of pressure and traction, and its place.

The search runs in :math:`x=a\rho\cos\varphi,\ y=b\rho\sin\varphi` and the depth: the edge :math:`\rho=1`, at which
stresses on the surface have a cusp, is a line of all its grids.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.media.interior.half_ellipsoid import Tensor, half_ellipsoid_stresses
from winkler.media.interior.peak import StressSpot
from winkler.media.interior.tensor import principal_of_tensor, von_mises_of_tensor
from winkler.numerics.types import Array

__all__ = ["Measure", "greatest_in_half_ellipsoid", "max_shear", "orthogonal_shear", "von_mises"]

Measure = Callable[[Tensor], Array]
RINGS = (0.0, 0.2, 0.4, 0.6, 0.75, 0.85, 0.92, 0.97, 1.0, 1.03, 1.1)
DIRECTIONS = 32
DEPTHS = (0.0, *np.geomspace(1e-3, 3.0, 18))
MOST_PEAKS = 4
"""Local maxima of the coarse grid from which the greatest is sought."""
BESIDE = 3
"""Places on either side of the best one in a finer grid."""
FIRST_REFINEMENTS, REFINEMENTS = 4, 20
ROUNDING = 1e-14


def von_mises(stress: Tensor) -> Array:
    """Return the equivalent stress after von Mises."""
    return von_mises_of_tensor(*stress)


def max_shear(stress: Tensor) -> Array:
    """Return the greatest shear stress, half the difference of the outermost principal stresses."""
    principal = principal_of_tensor(*stress)
    return np.asarray(0.5 * (principal[..., 0] - principal[..., 2]))


def orthogonal_shear(stress: Tensor) -> Array:
    """Return the shear stress in the plane along the surface."""
    return np.hypot(stress.xz, stress.yz)


class _Lines(NamedTuple):
    """Lines of a grid: distance from the middle over that of the edge, angle, depth over the smaller semi-axis."""

    ring: Array
    angle: Array
    depth: Array


@functools.lru_cache(maxsize=512)
def greatest_in_half_ellipsoid(
    measure: Measure, ratio: float, poisson: float, traction: tuple[float, float] = (0.0, 0.0)
) -> StressSpot:
    """Return the greatest of a stress over the greatest pressure, and its place over a, b, and the smaller of both.

    Parameters
    ----------
    measure
        Takes the tensor, returns what is compared.
    ratio : float
        b / a, of the semi-axes along y and x.
    poisson : float
    traction : tuple of float
        What drags the surface along x and y, over the pressure [-].
    """
    from scipy.ndimage import maximum_filter

    shorter = min(1.0, ratio)

    def values(grid: _Lines) -> Array:
        ring, angle, depth = np.meshgrid(*grid, indexing="ij")
        x, y = ring * _cosine(angle), ratio * ring * _cosine(angle - 0.5 * math.pi)
        return measure(half_ellipsoid_stresses(x, y, shorter * depth, (1.0, ratio), poisson, traction))

    whole = 2.0 * math.pi
    if traction == (0.0, 0.0):
        angles = np.linspace(0.0, 0.25 * whole, DIRECTIONS // 4 + 1)
    elif traction[1] == 0.0:
        angles = np.linspace(0.0, 0.5 * whole, DIRECTIONS // 2 + 1)
    elif traction[0] == 0.0:
        angles = np.linspace(-0.25 * whole, 0.25 * whole, DIRECTIONS // 2 + 1)
    else:
        angles = np.arange(-1, DIRECTIONS + 1) * whole / DIRECTIONS
    coarse = _Lines(np.array(RINGS), angles, np.array(DEPTHS))
    level = values(coarse)
    peaks = np.argwhere(level >= maximum_filter(level, size=3, mode="nearest"))
    peaks = peaks[np.argsort(-level[tuple(peaks.T)], kind="stable")]
    tried: list[tuple[float, _Lines]] = []
    for place in _distinct(peaks, coarse):
        found, grid = level[place], _around(coarse, place)
        for _ in range(FIRST_REFINEMENTS):
            found, grid = _finer(values, grid)
        tried.append((float(found), grid))
    found, grid = max(tried, key=lambda one: one[0])
    for _ in range(REFINEMENTS - FIRST_REFINEMENTS):
        found, grid = _finer(values, grid)
    ring, angle, depth = (float(line[BESIDE]) for line in grid)
    level_angle = round(angle / (0.25 * whole)) * 0.25 * whole
    if float(values(_Lines(*np.array([[ring], [level_angle], [depth]])))[0, 0, 0]) >= (1.0 - ROUNDING) * found:
        angle = level_angle  # along an axis, up to rounding
    across, along = (float(_cosine(np.array(turn))) for turn in (angle, angle - 0.5 * math.pi))
    return StressSpot(float(found), ring * across, ring * along, depth)


def _cosine(angle: Array) -> Array:
    """Return the cosine, zero at right angles."""
    found = np.cos(angle)
    return np.asarray(np.where(np.abs(found) < 1e-15, 0.0, found))


def _distinct(peaks: Array, grid: _Lines) -> list[tuple[int, ...]]:
    """Return the highest peaks; of the middle, which all angles share, one for each depth."""
    found: dict[tuple[float, ...], tuple[int, ...]] = {}
    for i, j, k in peaks.tolist():
        found.setdefault((grid.ring[i], grid.angle[j] if i > 0 else 0.0, grid.depth[k]), (i, j, k))
    return list(found.values())[:MOST_PEAKS]


def _around(grid: _Lines, place: tuple[int, ...]) -> _Lines:
    """Return a finer grid about one place of a grid, which stays its middle."""
    lines = []
    for line, index in zip(grid, place, strict=True):
        low, best, high = line[max(index - 1, 0)], line[index], line[min(index + 1, line.size - 1)]
        lines.append(np.concatenate([np.linspace(low, best, BESIDE + 1)[:-1], np.linspace(best, high, BESIDE + 1)]))
    return _Lines(*lines)


def _finer(values: Callable[[_Lines], Array], grid: _Lines) -> tuple[float, _Lines]:
    """Return the greatest on a grid and the finer grid about its place."""
    found = values(grid)
    place = tuple(int(index) for index in np.unravel_index(int(np.argmax(found)), found.shape))
    return float(found[place]), _around(grid, place)
