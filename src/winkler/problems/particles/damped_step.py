r"""One step of a contact with a solid of springs and dashpots side by side: the kernel for other programs.

Every spring of the contact bears :math:`M_\infty(u+\tau\dot u)`, and lets go rather than pull.  While the body comes
nearer all of them are pressed, and the force is :math:`F(d)+\tau F'(d)\,\dot d`, F that of the solid at rest (for a
ball the law of Kuwabara and Kono).  While it leaves, those that bear something are those of the depth
:math:`d+\tau\dot d`, and the force is F there: it never pulls.
"""

from __future__ import annotations

import math

from winkler.numerics.jit import compiled
from winkler.numerics.types import Array
from winkler.problems.particles.table_step import follow_table


@compiled
def step_damped(
    depth: Array, force: Array, stiffness: Array, energy: Array, delay: Array, past: Array, motion: Array, answer: Array
) -> None:
    """Move one contact by one step at a steady rate; a step without duration meets the solid at rest.

    Parameters
    ----------
    depth, force, stiffness, energy
        The table of `follow_table`, of the solid at rest.
    delay : ndarray, (1,)
        tau [s]: viscosity over modulus.
    past : ndarray, (2,)
        Depth before the step [m], heat so far [J].
    motion : ndarray, (2,)
        Depth at the end of the step [m], its duration [s].
    answer : ndarray, (3,)
        Force [N], elastic energy [J], heat so far [J].
    """
    f, k, e = follow_table(depth, force, stiffness, energy, motion[0])
    if math.isnan(f) or not motion[1] >= 0.0 or not math.isfinite(motion[0]):
        for i in range(answer.size):
            answer[i] = math.nan
        return
    f0, _, e0 = follow_table(depth, force, stiffness, energy, past[0])
    change = motion[0] - past[0]
    heat = 0.0
    if motion[1] > 0.0 and f + f0 > 0.0:
        ahead = delay[0] * (change / motion[1])
        if change > 0.0:
            heat = ahead * (f - f0)
            f += k * ahead
        else:
            f, _, after = follow_table(depth, force, stiffness, energy, motion[0] + ahead)
            _, _, before = follow_table(depth, force, stiffness, energy, past[0] + ahead)
            heat = max(e0 - e - (before - after), 0.0)
    past[0] = motion[0]
    past[1] += heat
    answer[0] = f
    answer[1] = e
    answer[2] = past[1]
