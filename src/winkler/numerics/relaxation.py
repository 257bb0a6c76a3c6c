r"""Relaxing springs under a rigid body that approaches at a steady rate: exact within every step.

A spring bears :math:`q=M_\infty u+\eta\dot u+\sum_i S_i`, :math:`\dot S_i=-S_i/\tau_i+M_i\dot u`, while it is pressed,
:math:`u=d-g`.  When q would pull it lets go and recovers freely, :math:`u=\sum_k w_k e^{-r_k t}` with the rates of
`winkler.numerics.spectra.zeros`, until the body catches it again.  Both motions are known in closed form, so a spring
is carried from event to event, whatever the step, and only the moments of the events are searched for.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.jit import compiled
from winkler.numerics.spectra import RelaxationSeries, zeros
from winkler.numerics.types import Array
from winkler.values import value

__all__ = ["Recovery", "advance", "bearing"]

EVENTS = 8
"""A spring that lets go and is caught more often within one step is left as it is."""


@value
class Recovery:
    """How memories of a pressed spring become those of a free one, and back.

    Parameters
    ----------
    rates : ndarray, (k,)
        r_k [1/s] of free recovery.
    from_displacement : ndarray, (k,)
        What a displacement gives to each w_k [-].
    from_memory : ndarray, (k, m)
        What each S_i gives to it [1/Pa].
    to_memory : ndarray, (m, k)
        What each w_k gives to the S_i [Pa].
    """

    rates: Array
    from_displacement: Array
    from_memory: Array
    to_memory: Array

    @classmethod
    def of(cls, series: RelaxationSeries) -> Recovery:
        """Return the recovery of springs with this relaxation."""
        rates, residues = zeros(series)
        lead = 1.0 - rates[:, None] * series.times
        weights = series.times / lead
        displaced = residues * (series.viscosity + weights @ series.moduli)
        back = -series.moduli[:, None] * (rates[:, None] * weights).T
        return cls(rates, displaced, -residues[:, None] * weights, back)


@compiled
def _pressed_load(relaxed, viscosity, moduli, times, u, memory, rate, t):  # type: ignore[no-untyped-def]
    """Return q at the time t of steady motion."""
    q = relaxed * (u + rate * t) + viscosity * rate
    for i in range(moduli.size):
        gone = -np.expm1(-t / times[i])
        q += memory[i] * (1.0 - gone) + moduli[i] * times[i] * rate * gone
    return q


@compiled
def _free_place(rates, memory, t):  # type: ignore[no-untyped-def]
    """Return u at the time t of free recovery."""
    u = 0.0
    for k in range(rates.size):
        u += memory[k] * np.exp(-rates[k] * t)
    return u


@compiled
def _let_go(displaced, remembered, u, memory, spare):  # type: ignore[no-untyped-def]
    """Turn memories of a pressed spring into those of a free one."""
    for k in range(displaced.size):
        spare[k] = displaced[k] * u
        for i in range(remembered.shape[1]):
            spare[k] += remembered[k, i] * memory[i]
    for k in range(displaced.size):
        memory[k] = spare[k]


@compiled
def _catch(back, memory, spare):  # type: ignore[no-untyped-def]
    """Turn memories of a free spring into those of a pressed one."""
    for i in range(back.shape[0]):
        spare[i] = 0.0
        for k in range(back.shape[1]):
            spare[i] += back[i, k] * memory[k]
    for i in range(memory.size):
        memory[i] = spare[i] if i < back.shape[0] else 0.0


@compiled
def _jump(relaxed, moduli, displaced, remembered, back, gap, depth, change, u, memory, pressed, spare):  # type: ignore[no-untyped-def]
    """Move one spring by a sudden change of depth; return place and state."""
    glassy = relaxed
    for i in range(moduli.size):
        glassy += moduli[i]
    if pressed:
        q = relaxed * u
        for i in range(moduli.size):
            q += memory[i]
        part = change if q + glassy * change >= 0.0 else -q / glassy
        for i in range(moduli.size):
            memory[i] += moduli[i] * part
        if part == change:
            return u + change, True
        _let_go(displaced, remembered, u + part, memory, spare)
        return u + part, False
    push = depth + change - gap - u
    if push > 0.0:
        _catch(back, memory, spare)
        for i in range(moduli.size):
            memory[i] += moduli[i] * push
        return u + push, True
    return u, False


@compiled
def advance(  # type: ignore[no-untyped-def]
    relaxed, viscosity, moduli, times, rates, displaced, remembered, back,
    gaps, weights, u, memory, pressed, depth, change, dt, sums, spare,
):  # fmt: skip
    """Carry all springs through one step of steady motion, in place.

    `sums` gets force at the end, impulse, work, and by what force and impulse change with the depth at the end.
    """
    m, modes = moduli.size, rates.size
    rate = change / dt if dt > 0.0 else 0.0
    decay, gain, fade = np.empty(m), np.empty(m), np.empty(modes)
    slope = relaxed + (viscosity / dt if dt > 0.0 else 0.0)
    pull = 0.5 * relaxed * dt + viscosity
    for i in range(m):
        gone = -np.expm1(-dt / times[i]) if dt > 0.0 else 0.0
        decay[i] = 1.0 - gone
        gain[i] = moduli[i] * times[i] * gone
        slope += gain[i] / dt if dt > 0.0 else moduli[i]
        pull += times[i] * (moduli[i] - gain[i] / dt) if dt > 0.0 else 0.0
    for k in range(modes):
        fade[k] = np.exp(-rates[k] * dt)
    force, impulse, work, steep, swift = 0.0, 0.0, 0.0, 0.0, 0.0
    for j in range(gaps.size):
        mine = memory[j]
        if dt == 0.0:
            place, state = _jump(
                relaxed, moduli, displaced, remembered, back, gaps[j], depth, change, u[j], mine, pressed[j], spare
            )
            if state or pressed[j]:
                # a jump of linear springs: the mean of the forces at its ends does the work of the part that is pressed
                q = relaxed * place if state else 0.0
                if state:
                    for i in range(m):
                        q += mine[i]
                before = q - slope * (place - u[j])
                work += weights[j] * 0.5 * (before + q) * (place - u[j])
                force += weights[j] * q
                if state:
                    steep += weights[j] * slope
            u[j], pressed[j] = place, state
            continue
        left, start, events, caught = dt, depth, 0, False
        while True:
            if pressed[j]:
                begin = relaxed * u[j] + viscosity * rate
                for i in range(m):
                    begin += mine[i]
                # what has just been caught bears nothing yet; below zero is rounding
                if caught:
                    begin = max(begin, 0.0)
                caught = False
                if begin < 0.0 and events < EVENTS:
                    _let_go(displaced, remembered, u[j], mine, spare)
                    pressed[j] = False
                    events += 1
                    continue
                if left == dt:
                    end = relaxed * (u[j] + change) + viscosity * rate
                    for i in range(m):
                        end += mine[i] * decay[i] + gain[i] * rate
                else:
                    end = _pressed_load(relaxed, viscosity, moduli, times, u[j], mine, rate, left)
                span, goes = left, False
                if end < 0.0 and events < EVENTS:
                    goes = True
                    low, high = 0.0, left
                    f_low, f_high = begin, end
                    for trial in range(200):
                        middle = 0.5 * (low + high) if trial % 3 == 2 else low + (high - low) * f_low / (f_low - f_high)
                        if not low < middle < high:
                            middle = 0.5 * (low + high)
                        f = _pressed_load(relaxed, viscosity, moduli, times, u[j], mine, rate, middle)
                        if f >= 0.0:
                            low, f_low = middle, f
                        else:
                            high, f_high = middle, f
                        if high - low <= 1e-15 * left or f_low == 0.0:
                            break
                    span = low
                impulse_here = relaxed * (u[j] * span + 0.5 * rate * span * span) + viscosity * rate * span
                for i in range(m):
                    if span == dt:
                        gone, grown = 1.0 - decay[i], gain[i]
                    else:
                        gone = -np.expm1(-span / times[i])
                        grown = moduli[i] * times[i] * gone
                    impulse_here += times[i] * (mine[i] * gone + rate * (moduli[i] * span - grown))
                    mine[i] += -mine[i] * gone + grown * rate
                impulse += weights[j] * impulse_here
                work += weights[j] * impulse_here * rate
                u[j] += rate * span
                left -= span
                start += rate * span
                if not goes:
                    force += weights[j] * end
                    steep += weights[j] * slope
                    swift += weights[j] * pull
                    u[j] = depth + change - gaps[j]
                    break
                _let_go(displaced, remembered, u[j], mine, spare)
                pressed[j] = False
                events += 1
            else:
                end = 0.0
                if left == dt:
                    for k in range(modes):
                        end += mine[k] * fade[k]
                else:
                    end = _free_place(rates, mine, left)
                reached = depth + change - gaps[j] - end
                if reached > 0.0 and events < EVENTS:
                    low, high = 0.0, left
                    f_low = start - gaps[j] - _free_place(rates, mine, 0.0)
                    f_high = reached
                    if f_low >= 0.0:
                        high = 0.0
                    else:
                        for trial in range(200):
                            middle = (
                                0.5 * (low + high) if trial % 3 == 2 else low + (high - low) * f_low / (f_low - f_high)
                            )
                            if not low < middle < high:
                                middle = 0.5 * (low + high)
                            f = start + rate * middle - gaps[j] - _free_place(rates, mine, middle)
                            if f < 0.0:
                                low, f_low = middle, f
                            else:
                                high, f_high = middle, f
                            if high - low <= 1e-15 * left or f_high == 0.0:
                                break
                    for k in range(modes):
                        mine[k] *= np.exp(-rates[k] * high)
                    left -= high
                    start += rate * high
                    u[j] = start - gaps[j]
                    _catch(back, mine, spare)
                    pressed[j] = caught = True
                    events += 1
                    if left <= 0.0:
                        left = 0.0
                    continue
                for k in range(modes):
                    mine[k] *= fade[k] if left == dt else np.exp(-rates[k] * left)
                u[j] = end
                break
    sums[0], sums[1], sums[2], sums[3], sums[4] = force, impulse, work, steep, swift


@compiled
def bearing(relaxed, viscosity, moduli, back, gaps, u, memory, pressed, rate, loads, stored):  # type: ignore[no-untyped-def]
    """Write the load of every spring per weight, while the body moves at a rate, and its stored energy."""
    softness = 0.5 / moduli
    for j in range(gaps.size):
        loads[j] = 0.0
        stored[j] = 0.5 * relaxed * u[j] * u[j]
        if pressed[j]:
            loads[j] = relaxed * u[j] + viscosity * rate
        for i in range(moduli.size):
            own = 0.0
            if pressed[j]:
                own = memory[j, i]
                loads[j] += own
            else:
                for k in range(back.shape[1]):
                    own += back[i, k] * memory[j, k]
            stored[j] += softness[i] * own * own
