r"""Simplified rolling over an ellipse: tractions that follow the slip point by point, with a parabolic bound.

On the unit disc, X along and Y across the direction of rolling, the traction of a particle that has come so far
:math:`t = l - X` from the leading edge :math:`l=\sqrt{1-Y^2}` obeys, in units of the greatest bound,

.. math:: \frac{\mathrm d\mathbf p}{\mathrm dt} = \mathbf v - \lambda\,\mathbf p,\quad
          \mathbf v = (A - CY,\ B + DX),\quad
          |\mathbf p| \le g = m\,(1-X^2-Y^2),\quad \lambda\ge0,\ \lambda\,(g-|\mathbf p|)=0 ,

where :math:`m=k+(1-k)\,e^{-|\mathbf w|}` is what is left of friction at the rigid slip :math:`\mathbf w`, which has the
form of :math:`\mathbf v`; :math:`k=1` under Coulomb's law.

Where it sticks, p is a parabola and stepped exactly.  Where it slides, only the direction of p is unknown; with v held
at the middle of a step it turns towards v by :math:`\tan\tfrac12\delta\propto\exp(-\int|\mathbf v|\,\mathrm dt/g)`,
again in closed form: the rule, with m held as v is, is of second order under spin and exact without it.  Strips lie
evenly in the angle :math:`\arcsin Y`, where the force of a strip is smooth.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.jit import compiled
from winkler.numerics.types import Array

HALVINGS = 48
"""How often the place where sliding begins is halved within a step."""


@compiled
def turn(ex: float, ey: float, vx: float, vy: float, distance: float) -> tuple[float, float]:
    """Return the direction of p after it has turned towards v; `distance` is the integral of dt / g, or infinite."""
    speed = math.sqrt(vx * vx + vy * vy)
    if speed == 0.0:
        return ex, ey
    nx, ny = vx / speed, vy / speed
    left = math.exp(-speed * distance)
    cos, sin = ex * nx + ey * ny, ey * nx - ex * ny
    squared = (1.0 - cos) * left * left
    whole = (1.0 + cos) + squared
    if left == 0.0 or whole <= 0.0:
        return nx, ny
    c, s = ((1.0 + cos) - squared) / whole, 2.0 * sin * left / whole
    return c * nx - s * ny, c * ny + s * nx


@compiled
def friction_left(fall: Array, x: float, y: float) -> float:
    """Return m at a place; `fall` is as in `strip`."""
    kept: float = fall[4]
    if kept == 1.0:
        return 1.0
    wx, wy = fall[0] - fall[2] * y, fall[1] + fall[3] * x
    return kept + (1.0 - kept) * math.exp(-math.sqrt(wx * wx + wy * wy))


@compiled
def friction_gained(fall: Array, x: float, y: float) -> float:
    """Return dm/dt, towards the trailing edge; `fall` is as in `strip`."""
    wx, wy = fall[0] - fall[2] * y, fall[1] + fall[3] * x
    slip = math.sqrt(wx * wx + wy * wy)
    if fall[4] == 1.0 or slip == 0.0:
        return 0.0
    gained: float = (1.0 - fall[4]) * math.exp(-slip) * fall[3] * (wy / slip)
    return gained


@compiled
def passage(start: float, end: float) -> float:
    """Return the integral of dt / (t (1 - t)); infinite from or to an edge."""
    if start <= 0.0 or end >= 1.0:
        return math.inf
    return math.log(end * (1.0 - start) / (start * (1.0 - end)))


@compiled
def passages(count: int) -> Array:
    """Return `passage` through the halves of so many even steps."""
    result = np.empty(2 * count)
    for half in range(2 * count):
        result[half] = passage(half / (2.0 * count), (half + 1) / (2.0 * count))
    return result


@compiled
def crossing(
    px: float,
    py: float,
    vx: float,
    vy: float,
    turning: float,
    start: float,
    end: float,
    whole: float,
    fall: Array,
    y: float,
) -> float:
    """Return how far p grows within a step until it reaches its bound."""
    if turning == 0.0:
        # p = v t equals m t (whole - t)
        return min(max(whole - math.sqrt(vx * vx + vy * vy) / friction_left(fall, 0.0, y), start), end)
    low, high = start, end
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        width = middle - start
        qx, qy = px + vx * width, py + (vy - turning * (start + 0.5 * width)) * width
        bound = friction_left(fall, 0.5 * whole - middle, y) * middle * (whole - middle)
        if qx * qx + qy * qy > bound**2:
            high = middle
        else:
            low = middle
    return low


@compiled
def strip(y: float, drive: Array, fall: Array, halves: Array, tractions: Array, sliding: Array, sums: Array) -> None:
    """Follow one strip from the leading edge to the trailing one.

    Parameters
    ----------
    y
        Y of the strip, between -1 and 1.
    drive : ndarray, (4,)
        A, B, C, D of v.
    fall : ndarray, (5,)
        A, B, C, D of w, and k.
    halves : ndarray, (2 n,)
        What `passages` returns.
    tractions : ndarray, (2, n + 1)
        Receives p at n + 1 even places.
    sliding : ndarray, (n + 1,)
        Receives 1 where it slides.
    sums : ndarray, (4,)
        Receives the integrals over X of p_x, p_y, X p_y and Y p_x.
    """
    front = math.sqrt(max(1.0 - y * y, 0.0))
    whole, count = 2.0 * front, sliding.size - 1
    vx, turning = drive[0] - drive[2] * y, drive[3]
    base = drive[1] + turning * front
    along = across = twist = 0.0
    tractions[0, 0] = tractions[1, 0] = 0.0
    px = py = 0.0
    speed = math.sqrt(vx * vx + base * base)
    # a particle that enters faster than its bound grows slides from the first, along v
    slides = speed > whole * friction_left(fall, front, y)
    ex, ey = (vx / speed, base / speed) if slides else (0.0, 0.0)
    sliding[0] = 1.0 if slides else 0.0
    for k in range(count):
        start, end = whole * k / count, whole * (k + 1) / count
        if k == count - 1:
            end = whole
        first, second = halves[2 * k], halves[2 * k + 1]
        if not slides:
            reached, width = end, end - start
            qx, qy = px + vx * width, py + (base - turning * (start + 0.5 * width)) * width
            if qx * qx + qy * qy > (friction_left(fall, front - end, y) * end * (whole - end)) ** 2:
                slides = True
                reached = crossing(px, py, vx, base, turning, start, end, whole, fall, y)
                width = reached - start
                qx, qy = px + vx * width, py + (base - turning * (start + 0.5 * width)) * width
                first = passage(reached / whole, 0.5 * (reached + end) / whole)
                second = passage(0.5 * (reached + end) / whole, end / whole)
            half = 0.5 * width
            mx, my = px + vx * half, py + (base - turning * (start + 0.5 * half)) * half
            along += width / 6.0 * (px + 4.0 * mx + qx)
            across += width / 6.0 * (py + 4.0 * my + qy)
            twist += width / 6.0 * ((front - start) * py + 4.0 * (front - start - half) * my + (front - reached) * qy)
            px, py, start = qx, qy, reached
            if slides:
                size = math.sqrt(px * px + py * py)
                if size > 0.0:
                    ex, ey = px / size, py / size
                else:
                    ex, ey = turn(1.0, 0.0, vx, base, math.inf)
        if slides and start < end:
            middle = 0.5 * (start + end)
            left = friction_left(fall, front - end, y)
            at = friction_left(fall, front - start, y) * start * (whole - start)
            between = friction_left(fall, front - middle, y) * middle * (whole - middle)
            then = left * end * (whole - end)
            mx, my, qx, qy = ex, ey, ex, ey
            if turning != 0.0:
                early, late = 0.5 * (start + middle), 0.5 * (middle + end)
                mx, my = turn(
                    ex, ey, vx, base - turning * early, first / (whole * friction_left(fall, front - early, y))
                )
                qx, qy = turn(
                    mx, my, vx, base - turning * late, second / (whole * friction_left(fall, front - late, y))
                )
            part = (end - start) / 6.0
            along += part * (at * ex + 4.0 * between * mx + then * qx)
            across += part * (at * ey + 4.0 * between * my + then * qy)
            twist += part * (
                (front - start) * at * ey + 4.0 * (front - middle) * between * my + (front - end) * then * qy
            )
            ex, ey, px, py = qx, qy, then * qx, then * qy
            # it sticks again once the bound grows faster than the traction is driven
            grows = left * (whole - 2.0 * end) + friction_gained(fall, front - end, y) * end * (whole - end)
            slides = vx * ex + (base - turning * end) * ey >= grows
        tractions[0, k + 1], tractions[1, k + 1] = px, py
        sliding[k + 1] = 1.0 if slides else 0.0
    sums[0], sums[1], sums[2], sums[3] = along, across, twist, y * along


@compiled
def rolled(drives: Array, falls: Array, count: int, sums: Array) -> None:
    """Sum the tractions over the disc for many creepages.

    Parameters
    ----------
    drives : ndarray, (m, 4)
        A, B, C, D of each.
    falls : ndarray, (m, 5)
        `fall` of each, as in `strip`.
    count
        Strips, and steps along each.
    sums : ndarray, (m, 4)
        Receives the integrals of p_x, p_y, X p_y and Y p_x; that of the bound is pi / 2 where m = 1.
    """
    tractions, sliding, part = np.empty((2, count + 1)), np.empty(count + 1), np.empty(4)
    halves = passages(count)
    sums[:] = 0.0
    for j in range(count):
        angle = math.pi * ((j + 0.5) / count - 0.5)
        weight = math.pi / count * math.cos(angle)
        for i in range(drives.shape[0]):
            strip(math.sin(angle), drives[i], falls[i], halves, tractions, sliding, part)
            for word in range(4):
                sums[i, word] += weight * part[word]


@compiled
def mapped(drive: Array, fall: Array, across: Array, tractions: Array, sliding: Array) -> None:
    """Follow strips at Y = `across`, and write down what they bear and where they slide.

    Parameters
    ----------
    drive : ndarray, (4,)
        A, B, C, D.
    fall : ndarray, (5,)
        As in `strip`.
    across : ndarray, (strips,)
        Y of the strips.
    tractions : ndarray, (strips, 2, n + 1)
        Receives p.
    sliding : ndarray, (strips, n + 1)
        Receives 1 where they slide.
    """
    part, halves = np.empty(4), passages(sliding.shape[1] - 1)
    for j in range(across.size):
        strip(across[j], drive, fall, halves, tractions[j], sliding[j], part)
