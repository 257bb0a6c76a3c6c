r"""The work that bodies do on springs which stick and slip in the plane, from the loads on their paths.

It is :math:`k\int\mathbf u\cdot\mathrm d\mathbf U`, summed up from where springs stand at the beginning of a straight
step: while they stick u follows U; while they slip with the angle :math:`\theta` to the motion,

.. math:: \int\mathbf u\cdot\mathrm d\mathbf U = \int b\,|\mathrm dU|
          - \int_0^Y b^2\,\frac{2\tau^2}{1+\tau^2}\,\mathrm dy ,
          \qquad \tau = \tan\tfrac\theta2 = e^{-y}\tan\tfrac{\theta_0}2 , \qquad \mathrm dy = \frac{|\mathrm dU|}b ,

by quadrature over y.  Where the kernels of `winkler.numerics.springs.slip_kernels` and
`winkler.numerics.springs.slip_plane` let the step end, and what they find to be lost, plays no part.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array

__all__ = ["work_on_line", "work_on_springs"]

NODES, WEIGHTS = gauss_legendre(12)
INTERVAL_WIDTH = 2.0
"""So much of y is integrated at once."""
DECAY_SPAN = 20.0
"""By how much y grows until nothing is left to turn."""
MOST_DROPS = 64
"""How often a spring may drop from its static to its kinetic bound within one step."""


def work_on_springs(
    u: Array, slips: Array, gap: Array, bounds: Array, hold: float, depths: tuple[float, float], move: Array
) -> Array:
    """Return the work of one straight step on springs, over their stiffness.

    Parameters
    ----------
    u : ndarray, (n, 2)
        Where springs stand before [m].
    slips : ndarray, (n,)
        Whether they slip; counts where `hold` exceeds one.
    gap : ndarray, (n,)
        Ascending [m].
    bounds : ndarray, (2, n)
        How far slipping springs are displaced before and after [m], zero out of contact.
    hold : float
        Bound of sticking springs over that of slipping ones [-].
    depths : tuple of float
        Before and after [m].
    move : ndarray, (2,)
        Of the bodies along the surface [m].
    """
    before, after = (int(np.searchsorted(gap, depth)) for depth in depths)
    stay, sunk = min(before, after), depths[1] - depths[0]
    work = np.zeros(gap.size)
    work[:stay] = _worked(u[:stay], slips[:stay], bounds[0, :stay], bounds[1, :stay], hold, np.ones(stay), move)
    if after > before:
        came = slice(before, after)
        travel = (depths[1] - gap[came]) / sunk * float(np.hypot(*move))
        last = bounds[1, came]
        work[came] = 0.5 * travel * np.where(travel > hold * last, last, travel)
    elif before > after:
        left = slice(after, before)
        share = (depths[0] - gap[left]) / -sunk
        work[left] = _worked(u[left], slips[left], bounds[0, left], np.zeros(before - after), hold, share, move)
    return work


def work_on_line(u: Array, gap: Array, bounds: Array, depths: tuple[float, float], move: float) -> Array:
    """Return as `work_on_springs`, of springs that stay in one line and have one bound, whether they slip or not.

    Parameters
    ----------
    u : ndarray, (n,)
        Where springs stand before [m].
    gap, bounds, depths
        As of `work_on_springs`.
    move : float
        Of the bodies along the line [m].
    """
    (first, last), sunk = bounds, depths[1] - depths[0]
    came, left = gap >= depths[0], gap >= depths[1]
    share = np.where(came ^ left, (max(depths) - gap) / (abs(sunk) or 1.0), ~came)
    start, travel = np.where(came, 0.0, u), share * move
    side = np.sign(start + travel)
    closing = side * travel - (last - first)
    slides = (side * (start + travel) > last) & (closing > 0.0)
    part = np.where(slides, np.clip((first - side * start) / np.where(slides, closing, 1.0), 0.0, 1.0), 1.0)
    onset = start + part * travel
    return np.asarray(0.5 * travel * (part * (start + onset) + (1.0 - part) * (onset + side * last)))


def _worked(u: Array, slips: Array, first: Array, last: Array, hold: float, share: Array, move: Array) -> Array:
    """Return the work on springs that are in contact for a share of the step, in which bounds go straight."""
    work, left = np.zeros(share.size), np.ones(share.size)
    at, now, sliding = u.copy(), first.copy(), slips & (hold > 1.0)
    rows = np.arange(share.size)
    for _ in range(MOST_DROPS):
        if not rows.size:
            break
        travel, fall = share[rows, None] * move, last[rows] - first[rows]
        sliding[rows] &= np.sum(at[rows] * travel, axis=1) >= fall * now[rows]
        rest = left[rows, None] * travel
        aim = at[rows] + rest
        stuck = ~sliding[rows]
        ends = stuck & (np.sum(aim**2, axis=1) <= (hold * last[rows]) ** 2)
        work[rows[ends]] += 0.5 * np.sum(rest * (at[rows] + aim), axis=1)[ends]
        hits = stuck & ~ends
        hit = rows[hits]
        if hit.size:
            part = _slip_onset(at[hit], hold * now[hit], hold * last[hit], rest[hits])
            reached = at[hit] + part[:, None] * rest[hits]
            work[hit] += 0.5 * np.sum((reached - at[hit]) * (at[hit] + reached), axis=1)
            left[hit] *= 1.0 - part
            at[hit] = reached / hold
            now[hit] = np.hypot(*at[hit].T)
        again = hits & (hold > 1.0) & (np.sum(at[rows] * travel, axis=1) < fall * now[rows])
        slide = ~ends & ~again
        goes = rows[slide]
        work[goes] += _slipped(at[goes], now[goes], last[goes], left[goes, None] * travel[slide])
        rows = rows[again]
    return work


def _slip_onset(u: Array, bound: Array, last: Array, move: Array) -> Array:
    """Return the part of the travel after which springs reach a circle whose radius goes from `bound` to `last`."""
    scale = np.maximum(np.maximum(bound, last), np.maximum(np.abs(u).max(axis=1), np.abs(move).max(axis=1)))
    scale = np.where(scale > 0.0, scale, 1.0)
    u, move, bound, fall = u / scale[:, None], move / scale[:, None], bound / scale, (last - bound) / scale
    square = np.sum(move**2, axis=1) - fall**2
    slope = np.sum(u * move, axis=1) - bound * fall
    inside = np.sum(u**2, axis=1) - bound**2
    root = np.sqrt(np.maximum(slope**2 - square * inside, 0.0))
    top, below = np.where(slope > 0.0, -inside, root - slope), np.where(slope > 0.0, slope + root, square)
    part = np.divide(top, below, out=np.zeros_like(top), where=below != 0.0)
    return np.asarray(np.clip(part, 0.0, 1.0))


def _slipped(u: Array, bound: Array, last: Array, move: Array) -> Array:
    """Return the work on springs that slip on a circle whose radius goes from `bound` to `last`."""
    travel = np.hypot(*move.T)
    work: Array = 0.5 * (bound + last) * travel
    turning = np.flatnonzero((bound > 0.0) & (travel > 0.0))
    if not turning.size:
        return work
    b, end, length = bound[turning], last[turning], travel[turning]
    cosine = np.clip(np.sum(u[turning] * move[turning], axis=1) / (b * length), -1.0, 1.0)
    work[turning[cosine == -1.0]] *= -1.0
    turns = (cosine > -1.0) & (cosine < 1.0)
    turning, b, end, length, cosine = (each[turns] for each in (turning, b, end, length, cosine))
    if not turning.size:
        return work
    rate, slope, growth = (end - b) / length, (1.0 - cosine) / (1.0 + cosine), (end - b) / b
    with np.errstate(divide="ignore"):
        slowed = np.where(growth != 0.0, np.log1p(growth) / np.where(growth != 0.0, growth, 1.0), 1.0)
    far = length / b * slowed
    far = np.minimum(far, DECAY_SPAN + 0.5 * np.log1p(slope))
    parts = int(np.ceil(far.max() / INTERVAL_WIDTH)) or 1
    nodes = ((np.arange(parts)[:, None] + NODES) / parts).ravel()
    weights = np.tile(WEIGHTS / parts, parts)
    y = far[:, None] * nodes
    square = slope[:, None] * np.exp(-2.0 * y)
    back = (b[:, None] * np.exp(rate[:, None] * y)) ** 2 * 2.0 * square / (1.0 + square)
    work[turning] -= far * (back @ weights)
    return work
