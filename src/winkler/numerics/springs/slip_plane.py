r"""Kernels: springs that stick and slip while the bodies move in the plane, step by step along straight lines.

The displacement u of a spring and the shift U are vectors.  A spring sticks as long as it stays within the circle of
radius b that friction grants it, which changes in proportion to the distance.  While it slips, u stays on the circle
and turns towards the motion: with the angle :math:`\theta` between them

.. math:: b\,\dot\theta = -|\dot U|\sin\theta , \qquad \tan\tfrac{\theta_1}2 = e^{-y}\tan\tfrac{\theta_0}2 , \qquad
          y = \int\frac{|\mathrm dU|}{b} ,

so that straight paths of any length are followed exactly, without any further steps.  The loss is exact where b does
not change; where it does, it deviates by some 1e-4 of itself where a step changes b by a tenth.

What enters and leaves contact, the order of springs and the arrays of a block are those of
`winkler.numerics.springs.slip_kernels`.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.jit import compiled
from winkler.numerics.springs.slip_turn import travel
from winkler.numerics.types import Array

Pair = tuple[Array, Array]
Three = tuple[Array, Array, Array]

LOG1, LOG2, LOG3, LOG4 = -1.0 / 3.0, -4.0 / 45.0, -44.0 / 945.0, -428.0 / 14175.0
LOG5, LOG6, LOG7 = -10196.0 / 467775.0, -10719068.0 / 638512875.0, -25865068.0 / 1915538625.0
"""Of w / artanh w in powers of w^2."""
SPRINGS_PER_ROW = 128
"""Springs that are moved together, all of one kind where none of them slips."""


@compiled
def _circle(u: Pair, first: Array, last: Array, still: bool, mx: float, my: float, new: Three) -> int:
    """Do what `travel` does for a whole row at once; return how many are odd.

    No bound changes if `still`: whoever calls it says so by a constant, so that what that spares is left out.

    Those are the ones that slip and turn, or whose bound changes, by more in this step than the series here, for
    exponential and logarithm, are made for; they are marked by a negative `waste`.
    """
    ux, uy = u
    nx, ny, waste = new
    square = mx * mx + my * my
    length = math.sqrt(square)
    ex = mx / length if length > 0.0 else 1.0
    ey = my / length if length > 0.0 else 0.0
    once = 1.0 / square if square > 0.0 else 0.0
    odd = 0
    for i in range(ux.size):
        x, y = ux[i], uy[i]
        b1 = last[i]
        tx, ty = x + mx, y + my
        slip = tx * tx + ty * ty > b1 * b1
        # where on its path it reaches the bound
        if still:
            slope = x * mx + y * my
            below = slope * slope - square * (x * x + y * y - b1 * b1)
            part = (math.sqrt(below if below > 0.0 else 0.0) - slope) * once
            fall = 0.0
        else:
            b0 = first[i]
            fall = b1 - b0
            fast = square - fall * fall
            slope = x * mx + y * my - b0 * fall
            inside = x * x + y * y - b0 * b0
            below = slope * slope - fast * inside
            root = math.sqrt(below if below > 0.0 else 0.0)
            outward = slope > 0.0
            part = (-inside if outward else root - slope) / (slope + root if outward else fast)
        part = part if part > 0.0 else 0.0
        part = part if part < 1.0 else 1.0
        hx, hy = x + part * mx, y + part * my
        distance = length * (1.0 - part)
        bound = mean = middle = b1
        w = 0.0
        if not still:
            bound = first[i] + part * fall
            # the logarithmic mean of the bound over the rest of the path: w / artanh w
            mean = 0.5 * (bound + b1)
            w = 0.5 * (b1 - bound) / mean
            w *= w
            series = LOG6 + w * LOG7
            series = LOG4 + w * (LOG5 + w * series)
            middle = mean * (1.0 + w * (LOG1 + w * (LOG2 + w * (LOG3 + w * series))))
        # exp(-distance / middle): a Pade fraction, squared five times
        limit = 32.0 * middle
        z = (distance if distance < limit else limit) * 0.03125
        zz = z * z
        mm = middle * middle
        even = mm * mm + zz * (mm * (3.0 / 28.0) + zz * (1.0 / 1680.0))
        uneven = z * middle * (0.5 * mm + zz * (1.0 / 84.0))
        shrink = (even - uneven) / (even + uneven)
        for _ in range(5):
            shrink *= shrink
        turn = shrink * shrink
        ahead = hx * ex + hy * ey
        across = ex * hy - ey * hx
        plus, minus = bound + ahead, bound - ahead
        minus = minus if minus > 0.0 else 0.0
        # the logarithm is 2 artanh v; both fractions by one division
        gone = minus * (1.0 - turn)
        whole = plus + minus * turn
        rest = 4.0 * bound - gone
        inverse = 1.0 / (whole * rest)
        share = b1 * rest * inverse
        ahead = share * (plus - minus * turn)
        across = share * 2.0 * shrink * across
        v = gone * whole * inverse
        vv = v * v
        series = 1.0 / 9.0 + vv * (1.0 / 11.0 + vv * (1.0 / 13.0 + vv * (1.0 / 15.0)))
        series = 1.0 + vv * (1.0 / 3.0 + vv * (0.2 + vv * (1.0 / 7.0 + vv * series)))
        series_term = 2.0 * v * series
        if still:
            loss = bound * (distance - bound * series_term)
        else:
            # what is not lost because the spring does not yet point ahead: the integral of b^2 times something that
            # falls nearly exponentially, and the integral of which is known
            fades = (1.0 - turn) * (plus * distance * rest - 4.0 * (b1 - bound) * bound * whole * series)
            square_b = (bound * bound * whole - 2.0 * turn * bound * b1 * b1) * distance * rest / fades
            low = bound * bound if bound < b1 else b1 * b1
            high = bound * bound if bound > b1 else b1 * b1
            square_b = square_b if square_b > low else low
            square_b = square_b if square_b < high else high
            loss = mean * (distance + bound - b1) - square_b * series_term
        loss = loss if loss > 0.0 else 0.0
        plain = (w <= 0.0225) & (gone <= 0.6 * bound) & (bound > 0.0)
        nx[i] = (ahead * ex - across * ey) if slip else tx
        ny[i] = (ahead * ey + across * ex) if slip else ty
        waste[i] = (loss if plain else -1.0) if slip else 0.0
        odd += 1 if (slip & (not plain)) else 0
    return odd


@compiled
def _count_slipping(ux: Array, uy: Array, last: Array, mx: float, my: float) -> int:
    """Return how many springs of a row would be beyond their bound if they stuck."""
    count = 0
    for i in range(ux.size):
        x, y = ux[i] + mx, uy[i] + my
        count += 1 if x * x + y * y > last[i] * last[i] else 0
    return count


@compiled
def _move_sticking(ux: Array, uy: Array, stiffness: Array, mx: float, my: float) -> tuple[float, float, float]:
    """Move springs that stick; return their force and twice what they store."""
    pull_x = pull_y = held = 0.0
    for i in range(ux.size):
        x, y = ux[i] + mx, uy[i] + my
        ux[i], uy[i] = x, y
        pull_x += stiffness[i] * x
        pull_y += stiffness[i] * y
        held += stiffness[i] * (x * x + y * y)
    return pull_x, pull_y, held


@compiled
def _store_state(ux: Array, uy: Array, nx: Array, ny: Array, stiffness: Array, waste: Array) -> float:
    """Put springs where they are found to be; return what they lost."""
    loss = 0.0
    for i in range(ux.size):
        ux[i], uy[i] = nx[i], ny[i]
        loss += stiffness[i] * waste[i]
    return loss


@compiled
def _row(
    u: Pair, slips: Array, stiffness: Array, ends: Pair, still: bool, hold: float, mx: float, my: float, new: Three
) -> tuple[float, float, float, float]:
    """Move a row of springs that stay in contact; return their force, twice what they store, and what they lose."""
    (ux, uy), (first, last), (nx, ny, waste) = u, ends, new
    if hold == 1.0 and _count_slipping(ux, uy, last, mx, my) == 0:
        pull_x, pull_y, held = _move_sticking(ux, uy, stiffness, mx, my)
        return pull_x, pull_y, held, 0.0
    odd = ux.size
    if hold == 1.0:
        odd = _circle(u, first, last, True, mx, my, new) if still else _circle(u, first, last, False, mx, my, new)
    for i in range(ux.size if odd > 0 else 0):
        if hold > 1.0 or waste[i] < 0.0:
            nx[i], ny[i], waste[i], slips[i] = travel(ux[i], uy[i], first[i], last[i], mx, my, hold, slips[i])
    loss = _store_state(ux, uy, nx, ny, stiffness, waste)
    pull_x, pull_y, held = _move_sticking(ux, uy, stiffness, 0.0, 0.0)
    return pull_x, pull_y, held, loss


@compiled
def march_plane(
    u: Array,
    slips: Array,
    gap: Array,
    stiffness: Array,
    bound: Array,
    hold: float,
    depth: Array,
    shift: Array,
    force: Array,
    stored: Array,
    lost: Array,
) -> None:
    """Move springs in the plane; u (2, n) and `slips` (n,) are changed in place.

    `bound` (steps + 1, n) holds how far a slipping spring is displaced at every point, zero out of contact, straight
    in between; one that does not slip holds on until `hold` times that.  shift (steps + 1, 2), force (steps, 2).
    """
    force[:, :], stored[:], lost[:] = 0.0, 0.0, 0.0
    work = np.empty((3, SPRINGS_PER_ROW))
    for start in range(0, gap.size, SPRINGS_PER_ROW):
        size = min(SPRINGS_PER_ROW, gap.size - start)
        cut = slice(start, start + size)
        g, k, s, pair = gap[cut], stiffness[cut], slips[cut], (u[0, cut], u[1, cut])
        new = (work[0, :size], work[1, :size], work[2, :size])
        before = np.searchsorted(g, depth[0])
        for t in range(stored.size):
            d0, d1 = depth[t], depth[t + 1]
            mx, my = shift[t + 1, 0] - shift[t, 0], shift[t + 1, 1] - shift[t, 1]
            ends = (bound[t, cut], bound[t + 1, cut])
            after = before if d1 == d0 else np.searchsorted(g, d1)
            stay = min(before, after)
            if stay == size:
                fx, fy, held, loss = _row(pair, s, k, ends, d1 == d0, hold, mx, my, new)
            else:
                part = slice(0, stay)
                inner, near = (pair[0][part], pair[1][part]), (ends[0][part], ends[1][part])
                fx, fy, held, loss = _row(inner, s[part], k[part], near, d1 == d0, hold, mx, my, new)
            for i in range(before, after):
                share, last = (d1 - g[i]) / (d1 - d0), ends[1][i]
                x, y = share * mx, share * my
                distance = math.sqrt(x * x + y * y)
                s[i] = distance > hold * last
                if s[i]:
                    loss += 0.5 * k[i] * (distance - last) * last
                    x, y = x * (last / distance), y * (last / distance)
                pair[0][i], pair[1][i] = x, y
                fx += k[i] * x
                fy += k[i] * y
                held += k[i] * (x * x + y * y)
            for i in range(after, before):
                share = (d0 - g[i]) / (d0 - d1)
                _, _, waste, _ = travel(pair[0][i], pair[1][i], ends[0][i], 0.0, share * mx, share * my, hold, s[i])
                loss += k[i] * waste
                pair[0][i], pair[1][i], s[i] = 0.0, 0.0, False
            force[t, 0] += fx
            force[t, 1] += fy
            stored[t] += 0.5 * held
            lost[t] += loss
            before = after
