r"""One step of a ball that yields, or on a body that yields: the function for other programs.

First loading is a table over the depth.  A dent of the radius a that springs back by :math:`d_e` is left at
:math:`d_e s` from where the bodies just touch with the half-angle of the contact's edge by

.. math:: s = \theta\xi^2 + (1-\theta)\left(1-\sqrt{1-\xi^2}\right), \qquad \xi = x/a ,

a quadratic equation in :math:`\sqrt{1-\xi^2}`; force and energy are integrals of the springs up to :math:`\xi`.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.jit import compiled
from winkler.numerics.types import Array
from winkler.problems.particles.table_step import follow_table

__all__ = ["step_yielding"]


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
def spring_energy(s: float, xi: float, theta: float) -> float:
    """Return the integral of the squared displacements up to xi, over those of a dent that springs back by one."""
    even = 1.0 - theta
    level = s - even
    root = math.sqrt(max((1.0 - xi) * (1.0 + xi), 0.0))
    angle = math.asin(min(xi, 1.0))
    cube = xi * xi * xi
    circle = 0.5 * (xi * root + angle)  # of sqrt(1 - t^2)
    moment = 0.125 * (angle - xi * root * (1.0 - 2.0 * xi * xi))  # of t^2 sqrt(1 - t^2)
    squares = level * level * xi - 2.0 * level * theta * cube / 3.0 + theta * theta * cube * xi * xi / 5.0
    return squares + 2.0 * even * (level * circle - theta * moment) + even * even * (xi - cube / 3.0)


@compiled
def step_yielding(
    depth: Array, force: Array, stiffness: Array, energy: Array, square: Array, square_slope: Array, share: Array,
    share_slope: Array, law: Array, memory: Array, motion: Array, answer: Array,
) -> None:  # fmt: skip
    """Move a contact by one step of its depth.

    Parameters
    ----------
    depth, force, stiffness, energy : ndarray, (rows,)
        Of first loading, from no contact on; the second row is where yielding begins.
    square, square_slope, share, share_slope : ndarray, (rows,)
        a^2 [m^2] and theta [-] there, and their changes by the depth.
    law : ndarray, (3,)
        R [m], E* [Pa] and the depth at which yielding begins [m].
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
    if greatest <= law[2]:
        f, slope, e = follow_table(depth, force, stiffness, energy, d)
        answer[0] = f
        answer[1] = slope
        answer[2] = math.sqrt(law[0] * max(d, 0.0))
        answer[3] = 0.0
        answer[4] = e
        answer[5] = 0.0
        return
    most, rise, work = follow_table(depth, force, stiffness, energy, greatest)
    edge = math.sqrt(cubic_between(depth, square, square_slope, greatest))
    theta = cubic_between(depth, share, share_slope, greatest)
    recovery = most / (2.0 * law[1] * edge * (1.0 - theta / 3.0 - (1.0 - theta) * (1.0 - 0.25 * math.pi)))
    residual = greatest - recovery
    scale = law[1] * edge * recovery * recovery
    stored = scale * spring_energy(1.0, 1.0, theta)
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
        root = min(2.0 * (1.0 - s) / (even + math.sqrt(even * even + 4.0 * theta * (1.0 - s))), 1.0)
        xi = math.sqrt((1.0 - root) * (1.0 + root))
        gap = theta * xi * xi * xi / 3.0 + even * (xi - 0.5 * (xi * root + math.asin(xi)))
        answer[0] = 2.0 * law[1] * edge * recovery * (s * xi - gap)
        answer[1] = 2.0 * law[1] * edge * xi
        answer[2] = edge * xi
        answer[4] = scale * spring_energy(s, xi, theta)
