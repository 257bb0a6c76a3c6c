r"""One step of a round body that yields, or is pressed into one: the function for other programs.

First loading is a table over the depth, and the profile g one over the distance from the axis.  A dent of the radius a
that springs back by :math:`d_e` is left at :math:`d_e s` from where the bodies just touch with an edge at
:math:`a\sin\varphi`,

.. math:: s = h(\varphi) = \theta\,\frac{g(a\sin\varphi)}{g(a)} + (1-\theta)(1-\cos\varphi) ;

force and energy are integrals of :math:`s - h` and of its square over the springs inside.  Between its rows g is a
cubic, which is exact of cones and paraboloids.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.jit import compiled
from winkler.numerics.types import Array
from winkler.problems.particles.table_step import follow_table


@compiled
def cubic_between(depth: Array, rows: Array, slopes: Array, d: float) -> float:
    """Return the cubic through numbers and slopes of two rows at a depth between the first and the last."""
    j = max(int(np.searchsorted(depth, d)) - 1, 0)
    width = depth[j + 1] - depth[j]
    t = (d - depth[j]) / width
    mean = (rows[j + 1] - rows[j]) / width
    second = 3.0 * mean - 2.0 * slopes[j] - slopes[j + 1]
    third = slopes[j] + slopes[j + 1] - 2.0 * mean
    return rows[j] + width * t * (slopes[j] + t * (second + third * t))  # type: ignore[no-any-return]


@compiled
def gap_within(
    place: Array, gap: Array, gap_slope: Array, gap_sum: Array, edge: float, angle: float
) -> tuple[float, float, float]:
    """Return g, its slope and its integral at an angle of a dent, not beyond the last row."""
    x = min(edge * math.sin(angle), place[place.size - 1])
    return follow_table(place, gap, gap_slope, gap_sum, x)


@compiled
def edge_angle(
    place: Array, gap: Array, gap_slope: Array, gap_sum: Array, edge: float, theta: float, s: float
) -> float:
    """Return the angle at which the springs of a dent end: Newton's method inside a bracket that only shrinks."""
    even = 1.0 - theta
    whole, _, _ = gap_within(place, gap, gap_slope, gap_sum, edge, 0.5 * math.pi)
    low = 0.0
    high = 0.5 * math.pi
    angle = high * math.sqrt(s)
    for _ in range(60):
        g, slope, _ = gap_within(place, gap, gap_slope, gap_sum, edge, angle)
        half = math.sin(0.5 * angle)
        off = theta * g / whole + 2.0 * even * half * half - s
        if off > 0.0:
            high = angle
        else:
            low = angle
        rise = theta * slope * edge * math.cos(angle) / whole + even * math.sin(angle)
        new = 0.5 * (low + high)
        if rise > 0.0:
            step = angle - off / rise
            if step > low and step < high:
                new = step
        if abs(new - angle) <= 1e-15 * angle:
            angle = new
            break
        angle = new
    return angle


@compiled
def spring_energy(
    place: Array, gap: Array, gap_slope: Array, gap_sum: Array, bends: Array, nodes: Array, weights: Array,
    edge: float, theta: float, s: float, angle: float,
) -> float:  # fmt: skip
    """Return the integral of (s - h)^2 up to an angle over the radius, of a dent that springs back by one."""
    even = 1.0 - theta
    whole, _, _ = gap_within(place, gap, gap_slope, gap_sum, edge, 0.5 * math.pi)
    total = 0.0
    low = 0.0
    for j in range(bends.size):
        high = min(math.asin(min(bends[j] / edge, 1.0)), angle)
        for k in range(nodes.size):
            at = low + (high - low) * nodes[k] * nodes[k]  # beyond a bend g goes on like a root
            g, _, _ = gap_within(place, gap, gap_slope, gap_sum, edge, at)
            half = math.sin(0.5 * at)
            left = s - theta * g / whole - 2.0 * even * half * half
            total += 2.0 * (high - low) * nodes[k] * weights[k] * left * left * math.cos(at)
        low = high
    return total


@compiled
def step_yielding(
    depth: Array, force: Array, stiffness: Array, energy: Array, square: Array, square_slope: Array, share: Array,
    share_slope: Array, place: Array, gap: Array, gap_slope: Array, gap_sum: Array, bends: Array, nodes: Array,
    weights: Array, law: Array, memory: Array, motion: Array, answer: Array,
) -> None:  # fmt: skip
    """Move a contact by one step of its depth.

    Parameters
    ----------
    depth, force, stiffness, energy : ndarray, (rows,)
        Of first loading, from no contact on.
    square, square_slope, share, share_slope : ndarray, (rows,)
        a^2 [m^2] and theta [-] there, and their changes by the depth.
    place, gap, gap_slope, gap_sum : ndarray, (places,)
        Distances from the axis [m], g [m], its slope, and its integral [m^2].
    bends : ndarray, (bends,)
        Where g bends [m], up to the last row.
    nodes, weights : ndarray, (nodes,)
        Of sums over the springs, from zero to one.
    law : ndarray, (2,)
        E* [Pa] and the depth at which yielding begins [m].
    memory : ndarray, (2,)
        The greatest depth so far [m], and what has been lost [J].
    motion : ndarray, (1,)
        Depth at the end of the step [m].
    answer : ndarray, (6,)
        Force [N], stiffness [N/m], contact radius [m], residual depth [m], elastic energy [J], what has been lost so
        far [J].
    """
    d = motion[0]
    last = depth.size - 1
    if not d <= depth[last]:  # nor not-a-number
        for k in range(answer.size):
            answer[k] = math.nan
        return
    memory[0] = max(memory[0], d)
    greatest = memory[0]
    if greatest <= law[1]:
        f, slope, e = follow_table(depth, force, stiffness, energy, d)
        answer[0] = f
        answer[1] = slope
        answer[2] = math.sqrt(max(cubic_between(depth, square, square_slope, max(d, 0.0)), 0.0))
        answer[3] = 0.0
        answer[4] = e
        answer[5] = 0.0
        return
    most, rise, work = follow_table(depth, force, stiffness, energy, greatest)
    edge = math.sqrt(cubic_between(depth, square, square_slope, greatest))
    theta = cubic_between(depth, share, share_slope, greatest)
    whole, _, below = gap_within(place, gap, gap_slope, gap_sum, edge, 0.5 * math.pi)
    fullness = theta * (1.0 - below / (edge * whole)) + (1.0 - theta) * 0.25 * math.pi
    recovery = most / (2.0 * law[0] * edge * fullness)
    residual = greatest - recovery
    scale = law[0] * edge * recovery * recovery
    stored = scale * spring_energy(
        place, gap, gap_slope, gap_sum, bends, nodes, weights, edge, theta, 1.0, 0.5 * math.pi
    )
    answer[3] = residual
    memory[1] = max(memory[1], work - stored)  # rounding, and the error of the table, give nothing back
    answer[5] = memory[1]
    if d >= greatest:
        answer[0] = most
        answer[1] = rise
        answer[2] = edge
        answer[4] = stored
        return
    s = (d - residual) / recovery
    answer[0] = 0.0
    answer[1] = 0.0
    answer[2] = 0.0
    answer[4] = 0.0
    if s > 0.0:
        even = 1.0 - theta
        angle = edge_angle(place, gap, gap_slope, gap_sum, edge, theta, min(s, 1.0))
        xi = math.sin(angle)
        _, _, area = gap_within(place, gap, gap_slope, gap_sum, edge, angle)
        lost = theta * area / (edge * whole) + even * (xi - 0.5 * (xi * math.cos(angle) + angle))
        answer[0] = 2.0 * law[0] * edge * recovery * (s * xi - lost)
        answer[1] = 2.0 * law[0] * edge * xi
        answer[2] = edge * xi
        answer[4] = scale * spring_energy(place, gap, gap_slope, gap_sum, bends, nodes, weights, edge, theta, s, angle)
