r"""Kernels: the work that bodies do on springs which stick and slip in the plane, from the loads on their paths.

It is :math:`k\int\mathbf u\cdot\mathrm d\mathbf U`, summed up from where springs stand at the beginning of a straight
step: while they stick u follows U; while they slip with the angle :math:`\theta` to the motion,

.. math:: \int\mathbf u\cdot\mathrm d\mathbf U = \int b\,|\mathrm dU|
          - \int_0^Y b^2\,\frac{2\tau^2}{1+\tau^2}\,\mathrm dy ,
          \qquad \tau = \tan\tfrac\theta2 = e^{-y}\tan\tfrac{\theta_0}2 , \qquad \mathrm dy = \frac{|\mathrm dU|}b ,

in closed form where the bound stays, else by quadrature over y.  Where the kernels of
`winkler.numerics.springs.slip_kernels` and `winkler.numerics.springs.slip_plane` let the step end, and what they find
to be lost, plays no part.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.jit import compiled
from winkler.numerics.springs.slip_turn import MOST_DROPS, slip_onset
from winkler.numerics.types import Array

__all__ = ["work_in_plane", "work_on_line"]

NODES, WEIGHTS = (tuple(map(float, row)) for row in gauss_legendre(12))
FEW_NODES, FEW_WEIGHTS = (tuple(map(float, row)) for row in gauss_legendre(6))
INTERVAL_WIDTH, NARROW = 2.0, 0.5
"""So much of y is integrated at once; of so little the rule with few nodes leaves 1e-13."""
DECAY_SPAN = 20.0
"""By how much y grows until nothing is left to turn."""


@compiled
def _work_on_row(
    u: Array, stiffness: Array, gap: Array, slope: Array, first: float, last: float, move: float, stay: int
) -> float:
    """Return the work on the inner springs, in contact all the time."""
    work = 0.0
    for i in range(stay):
        before, bound = slope[i] * (first - gap[i]), slope[i] * (last - gap[i])
        aim = u[i] + move
        side = 1.0 if aim > 0.0 else -1.0
        closing = side * move - (bound - before)
        slides = (side * aim > bound) & (closing > 0.0)
        part = (before - side * u[i]) / (closing if slides else 1.0)
        part = part if part > 0.0 else 0.0
        part = part if slides & (part < 1.0) else 1.0
        onset = u[i] + part * move
        work += stiffness[i] * (part * (u[i] + onset) + (1.0 - part) * (onset + side * bound))
    return 0.5 * move * work


@compiled
def work_on_line(u: Array, gap: Array, stiffness: Array, slope: Array, first: float, last: float, move: float) -> float:
    """Return the work [J] of one straight step on springs that stay in one line and have one bound.

    Springs stand at u (n,) before; the bodies move by `move`, and the depth goes from `first` to `last`.
    """
    before, after = np.searchsorted(gap, first), np.searchsorted(gap, last)
    work = _work_on_row(u, stiffness, gap, slope, first, last, move, int(min(before, after)))
    for i in range(before, after):
        travel, bound = move * ((last - gap[i]) / (last - first)), slope[i] * (last - gap[i])
        # what comes meets its bound at once, or never
        work += 0.5 * stiffness[i] * abs(travel) * min(abs(travel), bound)
    for i in range(after, before):
        travel, bound = move * ((first - gap[i]) / (first - last)), slope[i] * (first - gap[i])
        aim = u[i] + travel
        side = 1.0 if aim > 0.0 else -1.0
        closing = side * travel + bound
        part = 1.0
        if side * aim > 0.0 and closing > 0.0:
            part = min(max((bound - side * u[i]) / closing, 0.0), 1.0)
        onset = u[i] + part * travel
        work += 0.5 * stiffness[i] * travel * (part * (u[i] + onset) + (1.0 - part) * onset)
    return work


@compiled
def _slipped(ux: float, uy: float, bound: float, last: float, mx: float, my: float) -> float:
    """Return the work on a spring that slips on a circle whose radius goes from `bound` to `last`."""
    length = math.sqrt(mx * mx + my * my)
    work = 0.5 * (bound + last) * length
    if bound <= 0.0 or length <= 0.0:
        return work
    cosine = min(max((ux * mx + uy * my) / (bound * length), -1.0), 1.0)
    if cosine == 1.0:
        return work
    if cosine == -1.0:
        return -work
    growth, turn = (last - bound) / bound, 0.5 * (1.0 - cosine)
    if growth == 0.0:
        gone = -math.expm1(-2.0 * length / bound)
        return work - bound * bound * math.log1p(turn * gone / (1.0 - turn * gone))
    slope = (1.0 - cosine) / (1.0 + cosine)
    far = min(length / bound * (math.log1p(growth) / growth), DECAY_SPAN + 0.5 * math.log1p(slope))
    power = 2.0 * (last - bound) / length
    parts = math.ceil(far / INTERVAL_WIDTH)
    width = far / max(parts, 1)
    back = 0.0
    if far <= NARROW:
        for k in range(len(FEW_NODES)):
            y = width * FEW_NODES[k]
            square = slope * math.exp(-2.0 * y)
            back += FEW_WEIGHTS[k] * math.exp(power * y) * square / (1.0 + square)
    else:
        for part in range(parts):
            for k in range(len(NODES)):
                y = width * (part + NODES[k])
                square = slope * math.exp(-2.0 * y)
                back += WEIGHTS[k] * math.exp(power * y) * square / (1.0 + square)
    return work - 2.0 * width * bound * bound * back


@compiled
def _worked(ux: float, uy: float, bound: float, last: float, mx: float, my: float, hold: float, slips: bool) -> float:
    """Return the work on a spring in contact, over its stiffness, while its bound goes straight."""
    work = 0.0
    left = 1.0
    fall = last - bound
    for _ in range(MOST_DROPS):
        if slips and hold > 1.0 and ux * mx + uy * my < fall * bound:
            slips = False
        if not slips or hold == 1.0:
            rx, ry = left * mx, left * my
            tx, ty = ux + rx, uy + ry
            rim = hold * last
            if tx * tx + ty * ty <= rim * rim:
                return work + 0.5 * (rx * (ux + tx) + ry * (uy + ty))
            part = slip_onset(ux, uy, hold * bound, rim, rx, ry)
            tx, ty = ux + part * rx, uy + part * ry
            work += 0.5 * ((tx - ux) * (ux + tx) + (ty - uy) * (uy + ty))
            left *= 1.0 - part
            ux, uy = tx / hold, ty / hold
            bound = math.sqrt(ux * ux + uy * uy)
            if hold > 1.0 and ux * mx + uy * my < fall * bound:
                continue
        return work + _slipped(ux, uy, bound, last, left * mx, left * my)
    return work


@compiled
def work_in_plane(
    u: Array,
    slips: Array,
    gap: Array,
    stiffness: Array,
    bound: Array,
    reached: Array,
    hold: float,
    first: float,
    last: float,
    mx: float,
    my: float,
) -> float:
    """Return the work [J] of one straight step on springs that stood at u (2, n), and slipped or not.

    Slipping ones are displaced by `bound` (n,) before and by `reached` (n,) after; one that sticks holds on until
    `hold` times that.  The bodies move by (mx, my), and the depth goes from `first` to `last`.
    """
    before, after = np.searchsorted(gap, first), np.searchsorted(gap, last)
    work = 0.0
    for i in range(min(before, after)):
        work += stiffness[i] * _worked(u[0, i], u[1, i], bound[i], reached[i], mx, my, hold, slips[i])
    for i in range(before, after):
        travel = math.sqrt(mx * mx + my * my) * ((last - gap[i]) / (last - first))
        work += 0.5 * stiffness[i] * travel * (reached[i] if travel > hold * reached[i] else travel)
    for i in range(after, before):
        share = (first - gap[i]) / (first - last)
        work += stiffness[i] * _worked(u[0, i], u[1, i], bound[i], 0.0, share * mx, share * my, hold, slips[i])
    return work
