r"""A flat punch of any shape on a half-space: pressures that displace all its pixels alike, on a grid.

Preconditioned conjugate gradients in single digits reduce what is wrong, which is then found anew in double ones.  A
punch that nearly fills a periodic surface hardly bends it; there all of it takes double digits.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from winkler.numerics.arrays import cast, dot, given, namespace_of, to_numpy
from winkler.numerics.pixels.layered import SurfaceBelow
from winkler.numerics.plates.face import step_on
from winkler.numerics.plates.screened_inverse import kernel_of
from winkler.numerics.surfaces.pressed_box import box_around
from winkler.numerics.surfaces.surface_grid import DOUBLE, SINGLE, SurfaceGrid
from winkler.numerics.surfaces.traction_grid import Compliance, TractionGrid
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

MOST_ITERATIONS = 2000
"""Iterations after which a punch has not converged; ten are usual."""
MOST_ROUNDS = 20
SINGLE_DIGITS_TOLERANCE = 1e-5
"""Tolerance above which single digits are enough for all."""
ITERATIONS_WITHOUT_GAIN = 100
"""Iterations without a gain after which digits are too few."""
LEAST_GAIN_RATIO = 0.5
"""A round that leaves more than this of what was wrong has not enough digits."""
INNER_RATIO = 0.5
"""Part of the tolerance that is sought in single digits."""


def punch(
    touching: Any,
    pixel: tuple[float, float],
    *,
    periodic: bool,
    tolerance: float = 1e-6,
    start: Any = (),
    layers: SurfaceBelow | None = None,
    film: float = 0.0,
) -> Any:
    """Return the pressures over E* [1/m] under a flat punch of any shape at unit depth.

    Their sum is better than they are: its error is of the order of the square of the tolerance.

    Parameters
    ----------
    touching
        Where it presses, (nx, ny), somewhere but, on a periodic surface whose mean stays at rest, not everywhere; of
        numpy or another library of the array API, which then computes.
    pixel, periodic, layers, film
        As for `winkler.numerics.surfaces.pressed_grid.press`.
    tolerance
        Greatest error of the depth under the punch.
    start
        Pressures under a punch of nearly the same shape.

    Raises
    ------
    NotConverged
        If the tolerance is not met.
    """
    xp = namespace_of(touching)
    box = (slice(None), slice(None)) if periodic else box_around(touching)
    there = touching[box]
    shape, aspect = (there.shape[0], there.shape[1]), (1.0, pixel[1] / pixel[0])
    below = layers.in_units_of(pixel[0]) if layers else None

    def grid_of(digits: np.dtype[np.floating] = DOUBLE) -> SurfaceGrid:
        bare = SurfaceGrid.of(shape, aspect, periodic=periodic, digits=digits, layers=below)
        return bare.filmed(film / pixel[0])

    def grid(digits: np.dtype[np.floating]) -> SurfaceGrid:
        return grid_of(digits).beside(touching)

    single = grid(SINGLE)
    exact = single if tolerance > SINGLE_DIGITS_TOLERANCE else grid(DOUBLE)
    even = 1.0 / math.sqrt(int(xp.count_nonzero(there)) * aspect[1])
    kept = cast(there, xp.float32)
    p = cast(there, xp.float64) * even
    if given(start):
        p = xp.where(there, start[box] * pixel[0], 0.0)
    inner, before = single, math.inf
    for _ in range(MOST_ROUNDS):
        wrong = xp.where(there, exact.displaced(cast(p, exact.response.dtype)) - 1.0, 0.0)
        left = float(xp.max(xp.abs(wrong)))
        if left <= tolerance:
            whole = xp.zeros(touching.shape, dtype=p.dtype, device=touching.device)
            # p G p is stationary where G p = 1: the sum of p (2 - G p) errs by the square of what is wrong
            whole[box] = p * (1.0 - wrong) / pixel[0]
            return whole
        if left > LEAST_GAIN_RATIO * before:  # digits are too few
            inner = exact = grid(DOUBLE)
            kept = cast(there, xp.float64)
        before = left
        try:
            wanted = cast(wrong, inner.response.dtype)
            p -= _correction(inner.displaced, inner.roughly_pressing, kept, wanted, INNER_RATIO * tolerance)
        except NotConverged:
            if inner.response.dtype == xp.float64 and layers is None:
                raise
            if inner.response.dtype == xp.float64:
                p -= _as_plate(there, grid_of(), wrong, INNER_RATIO * tolerance)
            before = 0.0
    raise _not_converged(touching)


def _as_plate(there: Any, grid: SurfaceGrid, wrong: Any, tolerance: float) -> Any:
    """Return the pressures under a punch that displace by `wrong` on layers of high contrast."""
    xp = namespace_of(wrong)
    found, _ = step_on(grid, kernel_of(grid), to_numpy(there), to_numpy(wrong), tolerance, balanced=False)
    return found if xp is np else xp.asarray(found, device=wrong.device)


def _not_converged(touching: Any) -> NotConverged:
    pixels = int(namespace_of(touching).count_nonzero(touching))
    return NotConverged(
        f"the pressure under a flat punch of {pixels} pixels was not found; smooth the heights, or give "
        "the map other pixels."
    )


def stuck_stiffness(
    touching: Array,
    pixel: tuple[float, float],
    compliance: Compliance,
    *,
    periodic: bool = False,
    tolerance: float = 1e-3,
) -> tuple[float, float]:
    """Return the force over E* [m] that shifts a contact in which nothing slips by a unit, along x and along y.

    The bodies neither turn nor shift across.  As of `punch`, the error is of the order of the square of the tolerance.

    Parameters
    ----------
    touching, pixel, periodic
        As for `punch`.
    compliance
        Of the bodies; the coupling with pressures is left out.
    tolerance
        Greatest error of the shift of a pixel.

    Raises
    ------
    NotConverged
        If the tolerance is not met.
    """
    box = (slice(None), slice(None)) if periodic else box_around(touching)
    there = touching[box]
    shape, aspect = (there.shape[0], there.shape[1]), (1.0, pixel[1] / pixel[0])
    alone = compliance._replace(coupling=0.0).in_units_of(pixel[0])
    grid = TractionGrid.of(shape, aspect, alone, periodic=periodic)
    found = []
    for axis in range(2):
        shift = np.zeros((2, *shape))
        shift[axis] = there
        traction = _correction(grid.sheared, grid.roughly_shearing, there.astype(np.float64), shift, tolerance)
        wrong = np.where(there, grid.sheared(traction) - shift, 0.0)
        found.append(pixel[1] * float(np.sum(traction * (shift - wrong))))
    return found[0], found[1]


def _correction(
    displaced: Callable[[Any], Any], undone: Callable[[Any], Any], kept: Any, wrong: Any, tolerance: float
) -> Any:
    """Return the pressures or tractions that displace the pixels under the punch by `wrong`, up to the tolerance.

    Those pixels are one in `kept`, and the others zero.
    """
    xp = namespace_of(wrong)
    wrong = xp.asarray(wrong, copy=True)
    p, along = xp.zeros_like(wrong), xp.zeros_like(wrong)
    product, best, last = 0.0, math.inf, 0
    for count in range(MOST_ITERATIONS):
        left = float(xp.max(xp.abs(wrong)))
        if left <= tolerance:
            return p
        if left < best:
            best, last = left, count
        elif count - last > ITERATIONS_WITHOUT_GAIN:
            break
        uphill = undone(wrong)
        uphill *= kept
        new = dot(wrong, uphill)
        along *= new / product if product > 0.0 else 0.0
        along += uphill
        sunk = displaced(along)
        sunk *= kept
        bent = dot(along, sunk)
        if not bent > 0.0:
            break
        length = new / bent
        p += length * along
        sunk *= length
        wrong -= sunk
        product = new
    raise _not_converged(kept)
