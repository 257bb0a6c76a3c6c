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
def _held_row(u: Array, bound: Array, mx: float, my: float, stay: int, each: Array) -> int:
    """Do what `_worked` does for a whole row with one coefficient and bounds that stay; return how many are odd.

    Those turn by more than the series here, for tangent and logarithm, are made for; they are marked by infinity.
    """
    square = mx * mx + my * my
    length = math.sqrt(square)
    once = 1.0 / square if square > 0.0 else 0.0
    ex, ey = mx * length * once, my * length * once
    odd = 0
    for i in range(stay):
        x, y, b = u[0, i], u[1, i], bound[i]
        tx, ty = x + mx, y + my
        slip = tx * tx + ty * ty > b * b
        slope = x * mx + y * my
        below = slope * slope - square * (x * x + y * y - b * b)
        part = (math.sqrt(below if below > 0.0 else 0.0) - slope) * once
        part = part if part > 0.0 else 0.0
        part = part if slip & (part < 1.0) else 1.0
        hx, hy = x + part * mx, y + part * my
        stuck = 0.5 * part * (mx * (x + hx) + my * (y + hy))
        distance = length * (1.0 - part)
        inverse = 1.0 / b
        z = 0.125 * distance * inverse
        zz = z * z
        t = z * (945.0 + zz * (105.0 + zz)) / (945.0 + zz * (420.0 + 15.0 * zz))
        for _ in range(3):
            t = 2.0 * t / (1.0 + t * t)
        turn = 0.5 * (1.0 - (hx * ex + hy * ey) * inverse)
        turn = turn if turn > 0.0 else 0.0
        back = turn * 2.0 * t / (1.0 + t)
        v = back / (2.0 - back)
        w = v * v
        series = 1.0 / 13.0 + w * (1.0 / 15.0 + w * (1.0 / 17.0 + w * (1.0 / 19.0)))
        series = 1.0 / 5.0 + w * (1.0 / 7.0 + w * (1.0 / 9.0 + w * (1.0 / 11.0 + w * series)))
        logarithm = 2.0 * v * (1.0 + w * (1.0 / 3.0 + w * series))
        plain = (z <= 0.25) & (back <= 0.4) & (b > 0.0)
        work = stuck + b * (distance - b * logarithm)
        each[i] = (work if plain else math.inf) if slip else stuck
        odd += 1 if (slip & (not plain)) else 0
    return odd


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
    `hold` times that.  The bodies move by (mx, my), and the depth goes from `first` to `last`; where it stays, so do
    the bounds.
    """
    before, after = np.searchsorted(gap, first), np.searchsorted(gap, last)
    work = 0.0
    stay = int(min(before, after))
    each = np.empty(stay)
    held = hold == 1.0 and first == last
    odd = _held_row(u, bound, mx, my, stay, each) if held else stay
    for i in range(stay if odd > 0 else 0):
        if not held or each[i] == math.inf:
            each[i] = _worked(u[0, i], u[1, i], bound[i], reached[i], mx, my, hold, slips[i])
    for i in range(stay):
        work += stiffness[i] * each[i]
    for i in range(before, after):
        travel = math.sqrt(mx * mx + my * my) * ((last - gap[i]) / (last - first))
        work += 0.5 * stiffness[i] * travel * (reached[i] if travel > hold * reached[i] else travel)
    for i in range(after, before):
        share = (first - gap[i]) / (first - last)
        work += stiffness[i] * _worked(u[0, i], u[1, i], bound[i], 0.0, share * mx, share * my, hold, slips[i])
    return work
