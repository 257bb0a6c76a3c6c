r"""Kernels: many small contacts, each with its own row of springs that stick and slip.

A contact of balls under the depth d touches with its springs :math:`x_j<\sqrt{Rd}`, and each of them bears at most
:math:`\beta(d-x_j^2/R)`.  Over a step, depth and motion change in proportion to each other.  A spring sticks until it
reaches its bound, exactly there; then it is returned to the bound at the end of the step, towards where it would be.
In one direction that is exact, in the plane it is the vector rule, of first order in the step.  A slipping spring loses

.. math:: \tfrac12(b_1 + \mathbf u_h\cdot\hat{\mathbf t})\,(|\mathbf t|-b_1) \ge 0

per stiffness (u_h where it met its bound, t where it would have gone, b_1 the bound at the end), and that is all the
work that is not stored: no history creates energy, however coarse its steps.

A twist, and a rolling, is borne by one spring alone.  Stiffness that a growing contact gains is unstrained, so that the
moment stays; stiffness that it loses takes its energy with it.
"""

from __future__ import annotations

import math

from winkler.numerics.jit import compiled
from winkler.numerics.types import Array

BOUND_TOLERANCE = 1e-14
"""Part of the squared bound by which a spring that stands on it may seem to be within."""
ZERO_SUBSTITUTE = 1e-300
"""Instead of nothing, below a fraction bar."""


@compiled
def _slip(ux: float, uy: float, bound: float, last: float, mx: float, my: float) -> tuple[float, float, float]:
    """Move a spring whose bound goes from `bound` to `last`; return where it is and what it loses."""
    tx = ux + mx
    ty = uy + my
    size = tx * tx + ty * ty
    if size <= last * last:
        return tx, ty, 0.0
    fall = last - bound
    square = mx * mx + my * my - fall * fall
    slope = ux * mx + uy * my - bound * fall
    inside = ux * ux + uy * uy - bound * bound
    part = 0.0
    if slope < 0.0 or inside < -BOUND_TOLERANCE * bound * bound:
        # one that is on its bound may turn back, and reach it on the other side
        root = math.sqrt(max(slope * slope - square * inside, 0.0))
        part = -inside / (slope + root) if slope > 0.0 else (root - slope) / max(square, ZERO_SUBSTITUTE)
        part = min(max(part, 0.0), 1.0)
    size = math.sqrt(size)
    inverse = 1.0 / size
    ex = tx * inverse
    ey = ty * inverse
    ahead = (ux + part * mx) * ex + (uy + part * my) * ey
    return last * ex, last * ey, max(0.5 * (last + ahead) * (size - last), 0.0)


@compiled
def move_row(
    u: Array, radius: float, spacing: float, slope: float, d0: float, d1: float, mx: float, my: float
) -> tuple[float, float, float, float]:
    """Move a row of springs, u (n, 2); return the sums of u, of its square, and what is lost, per stiffness."""
    n = u.shape[0]
    curve = spacing * spacing / radius
    sum_x = 0.0
    sum_y = 0.0
    square = 0.0
    loss = 0.0
    low = min(d0, d1)
    high = max(d0, d1)
    place = 0.5
    for j in range(n):
        gap = place * place * curve
        place += 1.0
        if gap >= high:
            break
        part, bound, last = 1.0, slope * (d0 - gap), slope * (d1 - gap)
        if gap >= low:  # it comes into contact, or leaves it, within the step
            part, bound, last = (high - gap) / (high - low), max(bound, 0.0), max(last, 0.0)
        vx = u[j, 0] + part * mx
        vy = u[j, 1] + part * my
        size = vx * vx + vy * vy
        if size > last * last:
            vx, vy, lost = _slip(u[j, 0], u[j, 1], bound, last, part * mx, part * my)
            size = vx * vx + vy * vy
            loss += lost
        u[j, 0] = vx
        u[j, 1] = vy
        sum_x += vx
        sum_y += vy
        square += size
    return sum_x, sum_y, square, loss


@compiled
def move_balls(
    u: Array,
    radius: Array,
    spacing: Array,
    stiffness: Array,
    slope: Array,
    depth: Array,
    motion: Array,
    force: Array,
    stored: Array,
    lost: Array,
) -> None:
    """Move many contacts along their paths, step by step; u (contacts, n, 2) is changed in place.

    `radius` R, `spacing` of the springs, `stiffness` of one of them and `slope` beta are of every contact; depth
    (contacts, steps + 1), motion (contacts, steps, 2) by which the bodies move along the surface in each step.  The
    shear force (contacts, steps, 2), what is stored and what each step loses, (contacts, steps), are filled.
    """
    for i in range(u.shape[0]):
        for t in range(motion.shape[1]):
            x, y, square, loss = move_row(
                u[i], radius[i], spacing[i], slope[i], depth[i, t], depth[i, t + 1], motion[i, t, 0], motion[i, t, 1]
            )
            force[i, t, 0] = stiffness[i] * x
            force[i, t, 1] = stiffness[i] * y
            stored[i, t] = 0.5 * stiffness[i] * square
            lost[i, t] = stiffness[i] * loss


@compiled
def turn_one(
    x: float, y: float, before: float, after: float, most: float, turn_x: float, turn_y: float
) -> tuple[float, float, float, float]:
    """Turn one contact, borne by one spring at (x, y); return where it is, what it stores, and what it loses.

    Its stiffness goes from `before` to `after`, and it bears at most the moment `most` at the end.
    """
    energy = 0.5 * before * (x * x + y * y)
    inverse = 1.0 / after if after > 0.0 else 0.0
    if after > before:
        x *= before * inverse
        y *= before * inverse
    bound = most * inverse
    square = x * x + y * y
    if square > bound * bound:
        shrunk = bound / math.sqrt(square)
        x *= shrunk
        y *= shrunk
        square = bound * bound
    waste = energy - 0.5 * after * square
    x, y, loss = _slip(x, y, bound, bound, turn_x, turn_y)
    return x, y, 0.5 * after * (x * x + y * y), after * loss + max(waste, 0.0)


@compiled
def turn_balls(
    u: Array, stiffness: Array, moment: Array, turn: Array, borne: Array, stored: Array, lost: Array
) -> None:
    """Turn many contacts, each borne by one spring u (contacts, 2) that is changed in place.

    stiffness (contacts, steps + 1) and the greatest moment (contacts, steps + 1) at every point; turn
    (contacts, steps, 2).  The moment that is borne (contacts, steps, 2), what is stored and what each step loses,
    (contacts, steps), are filled.
    """
    for i in range(u.shape[0]):
        for t in range(turn.shape[1]):
            after = stiffness[i, t + 1]
            x, y, energy, loss = turn_one(
                u[i, 0], u[i, 1], stiffness[i, t], after, moment[i, t + 1], turn[i, t, 0], turn[i, t, 1]
            )
            u[i, 0] = x
            u[i, 1] = y
            borne[i, t, 0] = after * x
            borne[i, t, 1] = after * y
            stored[i, t] = energy
            lost[i, t] = loss


@compiled
def impact_balls(
    u: Array,
    radius: Array,
    normal: Array,
    shear: Array,
    slope: Array,
    mass: Array,
    mobility: Array,
    interval: Array,
    deepest: Array,
    most: int,
    velocity: Array,
    sliding: Array,
    loss: Array,
    peak: Array,
    time: Array,
) -> None:
    """Let many balls strike, by the steps of Verlet; u (n, 2) is work space.

    `normal` and `shear` are E* and G*; velocity (contacts,) of approach and sliding (contacts, 2) are changed in
    place, what is lost, the greatest shear force and the end of contact (contacts,) are filled.
    """
    n = u.shape[0]
    for i in range(radius.size):
        u[:] = 0.0
        spacing = math.sqrt(radius[i] * deepest[i]) / n
        hertz = 4.0 / 3.0 * normal[i] * math.sqrt(radius[i])
        k = 2.0 * shear[i] * spacing
        step = interval[i]
        v = velocity[i]
        wx = sliding[i, 0]
        wy = sliding[i, 1]
        d = 0.0
        force = 0.0
        fx = 0.0
        fy = 0.0
        lost = 0.0
        greatest = 0.0
        count = 0
        for _ in range(most):
            v -= 0.5 * step * force / mass[i]
            wx -= 0.5 * step * mobility[i] * fx
            wy -= 0.5 * step * mobility[i] * fy
            new = d + step * v
            sum_x, sum_y, _, waste = move_row(u, radius[i], spacing, slope[i], d, new, step * wx, step * wy)
            d = new
            force = hertz * d * math.sqrt(d) if d > 0.0 else 0.0
            fx = k * sum_x
            fy = k * sum_y
            lost += k * waste
            greatest = max(greatest, fx * fx + fy * fy)
            v -= 0.5 * step * force / mass[i]
            wx -= 0.5 * step * mobility[i] * fx
            wy -= 0.5 * step * mobility[i] * fy
            count += 1
            if d <= 0.0:
                break
        velocity[i] = v
        sliding[i, 0] = wx
        sliding[i, 1] = wy
        loss[i] = lost
        peak[i] = math.sqrt(greatest)
        time[i] = count * step
