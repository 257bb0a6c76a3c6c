r"""A relaxing spring that a body passes over: its load from the leading edge on, for any speed.

As a function of the distance y that the body has gone since it touched the spring, the spring bears

.. math:: q = M_\infty u + \eta v\,u' + \sum_i S_i, \qquad S_i' = -S_i/\ell_i + M_i u', \qquad \ell_i = v\tau_i ,

until that would pull.  Between two places the slope u' is taken as straight, everything else is exact, so that neither
lengths :math:`\ell_i` far below a step nor far above the contact cost digits.  The work of the springs is not summed up
over :math:`qu'`, of which next to nothing is left where they are almost elastic, but is what the dashpots lose,
:math:`\sum_i S_i^2/(M_i\ell_i)+\eta v\,u'^2`, and what is stored when the springs let go.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.integrals.exponential_integrals import fading, first, second
from winkler.numerics.jit import compiled


@compiled
def _load(relaxed, drag, moduli, lengths, u, slope, turn, memory, y, phi):  # type: ignore[no-untyped-def]
    """Return q where the body has gone on by y, the slope of u being `slope` + `turn` y."""
    q = relaxed * (u + (slope + 0.5 * turn * y) * y) + drag * (slope + turn * y)
    for i in range(moduli.size):
        x = y / lengths[i]
        fading(x, phi)
        q += memory[i] * np.exp(-x) + moduli[i] * y * (slope * phi[0] + turn * y * phi[1])
    return q


@compiled
def pass_over(relaxed, drag, moduli, lengths, place, u, before, after, memory, loads, rule, sums):  # type: ignore[no-untyped-def]
    """Let a body pass over a spring.

    `place` (n,) are distances y, `u` the recess there, `before` and `after` the slopes u' at both sides of the
    intervals between them (n - 1,).  `memory` (m,) begins as zero and ends as the S_i; `loads` (n,) gets q; `sums` the
    integrals of q and of q u' over y, and where the spring lets go.  `drag` is eta v; `rule` are nodes and weights from
    0 to 1, for what fades within an interval by no more than e.
    """
    count, modes = place.size, moduli.size
    nodes, shares = rule
    phi, fade, within = np.empty(4), np.empty((modes, 4)), np.empty((modes, 3, nodes.size))
    for j in range(count):
        loads[j] = 0.0
    force, lost, width, last = 0.0, 0.0, -1.0, u[count - 1]
    sums[2] = place[count - 1]
    for j in range(count - 1):
        h = place[j + 1] - place[j]
        slope, turn = before[j], (after[j] - before[j]) / h
        begin = relaxed * u[j] + drag * slope
        for i in range(modes):
            begin += memory[i]
        if begin < 0.0:
            sums[2], last = place[j], u[j]
            break
        loads[j] = begin
        end = _load(relaxed, drag, moduli, lengths, u[j], slope, turn, memory, h, phi)
        span = h
        if end < 0.0:
            low, high = 0.0, h
            f_low, f_high = begin, end
            for trial in range(200):
                middle = 0.5 * (low + high) if trial % 3 == 2 else low + (high - low) * f_low / (f_low - f_high)
                if not low < middle < high:
                    middle = 0.5 * (low + high)
                f = _load(relaxed, drag, moduli, lengths, u[j], slope, turn, memory, middle, phi)
                if f >= 0.0:
                    low, f_low = middle, f
                else:
                    high, f_high = middle, f
                if high - low <= 1e-15 * h or f_low == 0.0:
                    break
            span = low
        if span != width:
            width = span
            for i in range(modes):
                x = span / lengths[i]
                fading(x, fade[i])
                for k in range(nodes.size if x < 1.0 else 0):
                    part = nodes[k]
                    within[i, 0, k], within[i, 1, k] = np.exp(-x * part), part * first(x * part)
                    within[i, 2, k] = part * part * second(x * part)
        s, r, t = span, slope * span, turn * span * span
        # of the spring and the dashpot: u = u_j + r s + t s^2/2 with s from 0 to 1, slope (r + t s)/span
        force += s * (relaxed * (u[j] + r / 2.0 + t / 6.0) + drag * (slope + turn * s / 2.0))
        lost += drag * s * (slope * (slope + turn * s) + turn * turn * s * s / 3.0)
        for i in range(modes):
            x = s / lengths[i]
            one, two, three, four = fade[i, 0], fade[i, 1], fade[i, 2], fade[i, 3]
            stress = moduli[i]
            force += s * (memory[i] * one + stress * (r * two + t * three))
            old, new = memory[i], memory[i] * np.exp(-x) + stress * (r * one + t * two)
            memory[i] = new
            for k in range(nodes.size if x < 1.0 else 0):
                now = old * within[i, 0, k] + stress * (r * within[i, 1, k] + t * within[i, 2, k])
                lost += shares[k] * x * now * now / stress
            if x >= 1.0:  # what is put in is far more than what is stored of it
                lost += r * (old * one + stress * (r * two + t * three))
                lost += t * (old * (one - two) + stress * (r * (two - three) + t * (three - four)))
                lost += 0.5 * (old - new) * (old + new) / stress
        if span < h:
            sums[2], last = place[j] + span, u[j] + (slope + 0.5 * turn * span) * span
            break
        loads[j + 1] = max(end, 0.0)
    stored = 0.5 * relaxed * last * last
    for i in range(modes):
        stored += 0.5 * memory[i] * memory[i] / moduli[i]
    sums[0], sums[1] = force, lost + stored
