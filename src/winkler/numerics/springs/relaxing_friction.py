r"""Relaxing springs that are dragged along a surface with friction: one step, each stuck or sliding at its end.

A spring displaced by u along the surface bears :math:`q=M_\infty u+\eta\dot u+\sum_i S_i` with
:math:`\dot S_i=-S_i/\tau_i+M_i\dot u`, and never more than its bound.  Over a step u is taken as straight, for which
all is exact.  A spring that would bear more than its bound at the end of the step slides as far as makes it bear the
bound.  One that is free recovers, :math:`u=\sum_k w_ke^{-r_kt}`, and its memories are the w_k.  Since the rule is met
at the end of the step, no step is too long to be stable.

`law` is that of `winkler.numerics.springs.free_relaxation.Recovery.law`.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.integrals.exponential_integrals import fading, losses
from winkler.numerics.jit import compiled
from winkler.numerics.springs.relaxing_spring import rotated

BOUND_TOLERANCE = 1e-9
"""A spring that bears its bound but for this part is on it."""


@compiled
def _factors(dt, times, factors, phi):  # type: ignore[no-untyped-def]
    """Write e^-x, phi_1 and phi_2 and the three of `losses`, with x the step over every relaxation time."""
    for i in range(times.size):
        x = dt / times[i]
        fading(x, phi)
        factors[0, i], factors[1, i], factors[2, i] = np.exp(-x), phi[0], phi[1]
        factors[3, i], factors[4, i], factors[5, i] = losses(x, phi)


@compiled
def _advance_spring(law, dt, factors, u, memory, trial, bound):  # type: ignore[no-untyped-def]
    """Drag one spring; return its travel, its load, what it would have borne, the work done on it, and its loss."""
    relaxed, viscosity, moduli = law[0], law[1], law[2]
    rest, stiff = relaxed * u, relaxed
    for i in range(moduli.size):
        rest += memory[i] * factors[0, i]
        stiff += moduli[i] * factors[1, i]
    if viscosity > 0.0:
        stiff = stiff + viscosity / dt if dt > 0.0 else np.inf
    travel, load = trial, rest + (stiff * trial if trial != 0.0 else 0.0)
    target = load
    if abs(load) > bound:
        load = bound if load > 0.0 else -bound
        travel = (load - rest) / stiff
    drag = viscosity * travel / dt if viscosity > 0.0 and dt > 0.0 else 0.0
    mean, lost = relaxed * (u + 0.5 * travel) + drag, drag * travel
    for i in range(moduli.size):
        s, rise = memory[i], moduli[i] * travel
        mean += s * factors[1, i] + rise * factors[2, i]
        lost += (s * (factors[3, i] * s + factors[4, i] * rise) + factors[5, i] * rise * rise) / moduli[i]
        memory[i] = s * factors[0, i] + rise * factors[1, i]
    return travel, load, target, mean * travel, lost


@compiled
def _recover(law, dt, memory):  # type: ignore[no-untyped-def]
    """Let a free spring recover; return where it is, and its loss."""
    u, lost = 0.0, 0.0
    for k in range(law[4].size):
        w = memory[k]
        lost -= law[8][k] * w * w * np.expm1(-2.0 * law[4][k] * dt)
        memory[k] = w * np.exp(-law[4][k] * dt)
        u += memory[k]
    return u, lost


@compiled
def drag(law, weights, before, after, share, dt, moved, u, memory, free, loads, stuck, sums):  # type: ignore[no-untyped-def]
    """Drag springs by `moved` in a time `dt`.

    `before` and `after` (n,) are the bounds at both ends of the step, `share` (n,) the part of it through which a
    spring has touched.  Displacements u (n,), memories (n, k) and which of them are those of a `free` spring (n,) are
    changed in place, `loads` (n,) and `stuck` (n,) written; `sums` gets the force, what slides has lost, the work done
    on the springs, what they store, by what the force still grows with `moved`, and what their dashpots have lost.
    """
    relaxed, viscosity, moduli, times = law[0], law[1], law[2], law[3]
    terms, modes = moduli.size, law[4].size
    phi, spare = np.empty(4), np.empty(modes)
    whole, part = np.empty((6, terms)), np.empty((6, terms))
    _factors(dt, times, whole, phi)
    growth = relaxed + (viscosity / dt if viscosity > 0.0 and dt > 0.0 else 0.0)
    for i in range(terms):
        growth += moduli[i] * whole[1, i]
    force, lost, work, stored, steep, bulk = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for j in range(u.size):
        mine = memory[j]
        first, factors, span, trial = before[j], whole, dt, moved
        touches = first > 0.0 or after[j] > 0.0
        if not touches or (share[j] < 1.0 and after[j] > 0.0):
            if not free[j]:
                rotated(law[5], law[6], u[j], mine, spare)
                free[j] = True
            u[j], own = _recover(law, (1.0 - share[j]) * dt if touches else dt, mine)
            bulk += weights[j] * own
        if touches:
            if free[j]:
                rotated(law[5], law[7], 0.0, mine, spare)
                free[j] = False
            if share[j] < 1.0 and after[j] > 0.0:
                first, factors, span, trial = 0.0, part, share[j] * dt, share[j] * moved
                _factors(span, times, part, phi)
            travel, load, target, own, gone = _advance_spring(law, span, factors, u[j], mine, trial, after[j])
            u[j] += travel
            loads[j] = load
            stuck[j] = abs(load) < (1.0 - BOUND_TOLERANCE) * after[j]
            work += weights[j] * own
            bulk += weights[j] * gone
            force += weights[j] * load
            lost += weights[j] * abs(trial - travel) * 0.5 * (min(first, abs(target)) + abs(load))
            if after[j] > 0.0 and travel == trial:
                steep += weights[j] * share[j] * growth
        else:
            loads[j], stuck[j] = 0.0, False
        energy = 0.0 if free[j] else 0.5 * relaxed * u[j] * u[j]
        for k in range(modes):
            energy += law[8][k] * mine[k] * mine[k] if free[j] else 0.0
        for i in range(terms):
            energy += 0.0 if free[j] else 0.5 * mine[i] * mine[i] / moduli[i]
        stored += weights[j] * energy
    sums[0], sums[1], sums[2], sums[3], sums[4], sums[5] = force, lost, work, stored, steep, bulk
