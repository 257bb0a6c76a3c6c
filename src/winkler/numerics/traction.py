r"""Relaxing springs that are dragged along a surface with friction: one step, each stuck or sliding at its end.

A spring displaced by u along the surface bears :math:`q=M_\infty u+\eta\dot u+\sum_i S_i` with
:math:`\dot S_i=-S_i/\tau_i+M_i\dot u`, and never more than its bound.  Over a step u is taken as straight, for which
all is exact.  A spring that would bear more than its bound at the end of the step slides as far as makes it bear the
bound; one that is free has none, and recovers.  Since the rule is met at the end of the step, no step is too long to be
stable.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.jit import compiled

__all__ = ["drag"]

SMALL = 1e-4
"""Below this part of its relaxation time a step's factors are told by their series."""
FULL = 1e-9
"""A spring that bears its bound but for this part is on it."""


@compiled
def _factors(dt, times, fade, one, two):  # type: ignore[no-untyped-def]
    """Write e^-x, (1 - e^-x)/x and (1 - that)/x, with x the step in terms of every relaxation time."""
    for i in range(times.size):
        x = dt / times[i]
        if x < SMALL:
            two[i] = 0.5 - x / 6.0 + x * x / 24.0
            one[i] = 1.0 - x * two[i]
        else:
            one[i] = -np.expm1(-x) / x
            two[i] = (1.0 - one[i]) / x
        fade[i] = 1.0 - x * one[i]


@compiled
def _go(law, dt, factors, u, memory, trial, bound):  # type: ignore[no-untyped-def]
    """Drag one spring; return its way, its load, what it would have borne, and the work done on it."""
    relaxed, viscosity, moduli, _ = law
    fade, one, two = factors
    rest, stiff = relaxed * u, relaxed
    for i in range(moduli.size):
        rest += memory[i] * fade[i]
        stiff += moduli[i] * one[i]
    if viscosity > 0.0:
        stiff = stiff + viscosity / dt if dt > 0.0 else np.inf
    way, load = trial, rest + (stiff * trial if trial != 0.0 else 0.0)
    wanted = load
    if abs(load) > bound:
        load = bound if load > 0.0 else -bound
        way = (load - rest) / stiff
    mean = relaxed * (u + 0.5 * way) + (viscosity * way / dt if viscosity > 0.0 and dt > 0.0 else 0.0)
    for i in range(moduli.size):
        mean += memory[i] * one[i] + moduli[i] * way * two[i]
        memory[i] = memory[i] * fade[i] + moduli[i] * way * one[i]
    return way, load, wanted, mean * way


@compiled
def drag(law, weights, before, after, share, dt, moved, u, memory, loads, stuck, sums):  # type: ignore[no-untyped-def]
    """Drag springs by `moved` in a time `dt`.

    `law` is relaxed modulus, viscosity, moduli and times; `before` and `after` (n,) are the bounds at both ends of the
    step, `share` (n,) the part of it through which a spring has touched.  Displacements u (n,) and memories (n, m) are
    changed in place, `loads` (n,) and `stuck` (n,) written; `sums` gets the force, what slides has lost, the work done
    on the springs, what they store, and by what the force still grows with `moved`.
    """
    relaxed, viscosity, moduli, times = law
    terms = moduli.size
    whole = np.empty(terms), np.empty(terms), np.empty(terms)
    part = np.empty(terms), np.empty(terms), np.empty(terms)
    _factors(dt, times, whole[0], whole[1], whole[2])
    growth = relaxed + (viscosity / dt if viscosity > 0.0 and dt > 0.0 else 0.0)
    for i in range(terms):
        growth += moduli[i] * whole[1][i]
    force, lost, work, stored, steep = 0.0, 0.0, 0.0, 0.0, 0.0
    for j in range(u.size):
        mine = memory[j]
        first, factors, span, trial = before[j], whole, dt, moved
        if share[j] < 1.0 and after[j] > 0.0:
            _factors((1.0 - share[j]) * dt, times, part[0], part[1], part[2])
            way, load, wanted, own = _go(law, (1.0 - share[j]) * dt, part, u[j], mine, 0.0, 0.0)
            u[j] += way
            work += weights[j] * own
            first, factors, span, trial = 0.0, part, share[j] * dt, share[j] * moved
            _factors(span, times, part[0], part[1], part[2])
        elif first == 0.0 and after[j] == 0.0:
            trial = 0.0
        way, load, wanted, own = _go(law, span, factors, u[j], mine, trial, after[j])
        u[j] += way
        loads[j] = load
        held = after[j] > 0.0 and way == trial
        stuck[j] = abs(load) < (1.0 - FULL) * after[j]
        work += weights[j] * own
        if first > 0.0 or after[j] > 0.0:
            force += weights[j] * load
            lost += weights[j] * abs(trial - way) * 0.5 * (min(first, abs(wanted)) + abs(load))
            if held:
                steep += weights[j] * share[j] * growth
        energy = relaxed * u[j] * u[j]
        for i in range(terms):
            energy += mine[i] * mine[i] / moduli[i]
        stored += 0.5 * weights[j] * energy
    sums[0], sums[1], sums[2], sums[3], sums[4] = force, lost, work, stored, steep
