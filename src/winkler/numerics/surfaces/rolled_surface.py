r"""A surface that rolls steadily on a grid, with Coulomb friction.

Seen from the contact, material comes in at the leading edge, at large x, and passes pixel by pixel towards small x.  On
its path of one pixel it slips by

.. math:: s(x) = w(x) - u(x) + u(x + \Delta x) ,

with the rigid slip w of one pixel and the displacement u = G q of tractions that stay (Kalker).  What slips is at its
bound and along its slip, :math:`g\,|s| = q\cdot s`, and what sticks has s = 0.  The operator is not symmetric, so there
is no energy to be least; Newton's method is that of `winkler.numerics.surfaces.sheared_surface`, with generalised
minimal residuals inside.  Summed up from the leading edge the slip is a displacement, which the wave number turns into
tractions.  Where something slips, tractions change over the slip instead, and what was summed up ahead fades: the more,
the farther it slips over its bound.  So preconditioned, and begun from a grid of half as many pixels, five steps of
Newton with three to ten inner ones are usual whatever the grid.

A surface that rolls, on a grid of half as many pixels along a side, and what is found there as a start.

Pixels are twice as long, so that material slips twice as far while the bodies roll by one of them.  Tractions are
carried over in parts of their bound: what slips on the coarse grid is at its bound on the fine one too.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.surfaces.sheared_surface import AT_BOUND, STIFFEST, within
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

MOST_ROUNDS = 100
"""Steps of Newton after which a surface has not converged; five are usual, ten on the coarsest grid."""
USUAL_ROUNDS = 12
"""Steps of Newton after which each is preceded by one along the slip."""
MOST_ITERATIONS = 60
"""Generalised minimal residuals of one step of Newton."""
INNER_RATIO = 0.1
"""To what part of its residual a step of Newton is solved."""
SINGLE_MISFIT = 1e-9
"""Misfit from which on steps take numbers of double digits: with single ones it stays at about 1e-10."""
ALONG_SLIP = 0.5
"""Change of a traction over its slip, in a step along it."""
OWN_RESPONSE = 1.0
"""Change of the slip of a pixel under its own traction, about."""
BOUND_WEIGHT = 1.0
"""At which product of slip over bound with it the preconditioner weighs the bound as the elasticity."""
FADING = 0.15
"""At which product of slip over bound with it half of what was summed up ahead fades in one pixel."""
COARSEST_PIXELS = 32
"""Grids of fewer pixels along a side are not begun from coarser ones."""
COARSE_TOLERANCE = 1e-4
"""Bound on the misfit of the coarser grids, which only begin."""
NEAR_MISFIT = 1e-2
"""Misfit of a start below which it is as good as one from a coarser grid."""
LOST_DIRECTION = 1e-14


class RolledSurface(NamedTuple):
    """The surface that rolls.

    Parameters
    ----------
    traction
        q / E*, (2, nx, ny).
    slip
        s of one pixel of rolling, (2, nx, ny).
    slipping
        Pixels at their bound that slip, (nx, ny).
    misfit
        Sum of g |s| - q s over that of g |w|.
    rounds
        Steps of Newton.
    """

    traction: Array
    slip: Array
    slipping: Array
    misfit: float
    rounds: int


def roll(grid: TractionGrid, bound: Array, rigid: Array, start: Array, *, tolerance: float = 1e-7) -> RolledSurface:
    """Solve steady rolling towards large x.

    Parameters
    ----------
    grid
        The surface; the pixels of largest x are ahead of the contact.
    bound
        g over E*, (nx, ny); zero where nothing touches.
    rigid
        w, (2, nx, ny): rigid slip while the bodies roll by one pixel.
    start
        Tractions to begin with, over E*: on this grid if they are near, else on the coarsest one.
    tolerance
        Bound on `RolledSurface.misfit`.

    Raises
    ------
    NotConverged
        If the bound is not met.
    """
    grid, own = in_own_units(grid)
    if own != 1.0:
        rolled = roll(grid, bound / own, rigid, start / own, tolerance=tolerance)
        return rolled._replace(traction=own * rolled.traction)
    inside = bound > 0.0
    scale = float(np.sum(bound * np.hypot(rigid[0], rigid[1])))
    misfit, light = math.inf, grid.in_single_digits()
    traction = (
        within(_begun(grid, bound, rigid, within(start, bound), tolerance), bound)
        if scale > 0.0
        else np.zeros_like(rigid)
    )
    for count in range(MOST_ROUNDS):
        slip = rigid - _passed(grid, traction)
        if count == 0 or count > USUAL_ROUNDS:
            traction = within(traction + ALONG_SLIP * slip, bound)
            slip = rigid - _passed(grid, traction)
        size = np.hypot(traction[0], traction[1])
        normal = np.divide(traction, size, out=np.zeros_like(traction), where=size > 0.0)
        outward = np.sum(normal * slip, 0)
        slipping = inside & (size >= AT_BOUND * bound) & (outward > 0.0)
        misfit = _wrong(bound, traction, slip) / scale if scale > 0.0 else 0.0
        if (count and misfit <= tolerance) or scale == 0.0:
            return RolledSurface(traction, slip, slipping, misfit, count)
        stiffer = np.divide(outward, bound, out=np.zeros_like(bound), where=slipping)
        digits = light if count <= USUAL_ROUNDS and misfit > SINGLE_MISFIT else grid
        traction = traction + _change(digits, inside & ~slipping, slipping, normal, stiffer, slip)
        size = np.hypot(traction[0], traction[1])
        onto = np.divide(bound, size, out=np.ones_like(bound), where=slipping & (size > 0.0))
        traction = within(traction * onto, bound)
    raise NotConverged(
        f"the rolling contact of {int(np.count_nonzero(inside))} pixels slips with an error of {misfit:.3g} of what "
        f"friction loses, after {MOST_ROUNDS} rounds; allowed are {tolerance:.3g}"
    )


def _begun(grid: TractionGrid, bound: Array, rigid: Array, start: Array, tolerance: float) -> Array:
    """Return tractions to begin with, from a grid of half as many pixels along a side if it is no coarse one."""
    lost = float(np.sum(bound * np.hypot(rigid[0], rigid[1])))
    near = np.any(start) and _wrong(bound, start, rigid - _passed(grid, start)) <= NEAR_MISFIT * lost
    if near or min(bound.shape) < 2 * COARSEST_PIXELS:
        return start
    coarse = halved_means(bound)
    try:
        begun = roll(
            halved_grid(grid), coarse, 2.0 * halved_means(rigid), halved_means(start),
            tolerance=max(tolerance, COARSE_TOLERANCE),
        )  # fmt: skip
    except NotConverged:  # the coarse grid is only a first guess
        return start
    return doubled_traction(begun.traction, coarse, bound)


def _wrong(bound: Array, traction: Array, slip: Array) -> float:
    """Return the sum of g |s| - q s."""
    return max(float(np.sum(bound * np.hypot(slip[0], slip[1])) - np.sum(traction * slip)), 0.0)


def _passed(grid: TractionGrid, traction: Array) -> Array:
    """Return by how much the displacement of material grows while it passes one pixel, u(x) - u(x + dx)."""
    passed = grid.sheared(traction)
    passed[:, :-1] -= passed[:, 1:]
    passed[:, -1] = 0.0
    return passed


def _change(grid: TractionGrid, sticking: Array, slipping: Array, normal: Array, stiffer: Array, slip: Array) -> Array:
    """Return the step of Newton by generalised minimal residuals, preconditioned from the right."""
    number = grid.along.dtype.type
    stiffer = np.minimum(stiffer, STIFFEST).astype(number)
    tangent = (np.stack((-normal[1], normal[0])) * slipping).astype(number)
    weight = 1.0 / (1.0 + number(BOUND_WEIGHT) * stiffer)
    alone = (1.0 - weight) / (stiffer + number(OWN_RESPONSE))
    kept, shape = 1.0 / (1.0 + number(FADING) * stiffer), stiffer.shape

    def free(field: Array) -> Array:
        return np.asarray(sticking * field + tangent * np.sum(tangent * field, 0))

    def undone(field: Array) -> Array:
        summed = np.asarray(weight * field)
        for ahead, here in zip(range(shape[0] - 1, 0, -1), range(shape[0] - 2, -1, -1), strict=True):
            summed[:, here] += kept[ahead] * summed[:, ahead]
        return free(weight * grid.roughly_shearing(summed) + alone * field)

    right = free(slip)
    length = float(np.linalg.norm(right))
    if length == 0.0:
        return np.zeros_like(slip)
    basis: list[Array] = [(right / length).astype(number)]
    directions: list[Array] = []
    matrix = np.zeros((MOST_ITERATIONS + 1, MOST_ITERATIONS))
    factors: Array = np.zeros(0)
    for k in range(MOST_ITERATIONS):
        directions.append(undone(basis[k]))
        bent = free(_passed(grid, directions[k]) + stiffer * directions[k])
        for i, known in enumerate(basis):
            matrix[i, k] = float(np.sum(known * bent))
            bent -= number(matrix[i, k]) * known
        matrix[k + 1, k] = float(np.linalg.norm(bent))
        goal = np.zeros(k + 2)
        goal[0] = length
        factors = np.linalg.lstsq(matrix[: k + 2, : k + 1], goal, rcond=None)[0]
        left = float(np.linalg.norm(goal - matrix[: k + 2, : k + 1] @ factors))
        if left <= INNER_RATIO * length or matrix[k + 1, k] <= LOST_DIRECTION * length:
            break
        basis.append(bent / number(matrix[k + 1, k]))
    change = np.zeros_like(slip)
    for factor, one in zip(factors, directions, strict=True):
        change += factor * one
    return change


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
