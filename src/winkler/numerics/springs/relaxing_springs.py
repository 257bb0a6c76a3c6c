r"""Rows of relaxing springs under a rigid body, carried through many steps at once: exact within every step.

A spring bears :math:`q=M_\infty u+\eta\dot u+\sum_i S_i`, :math:`\dot S_i=-S_i/\tau_i+M_i\dot u`, while it is pressed,
:math:`u=d-g`.  When q would pull it lets go and recovers freely, :math:`u=\sum_k w_k e^{-r_k t}`, until the body
catches it again.  Within a step of steady motion both are known in closed form, and of springs that stay pressed also
where the motion bends by a steady acceleration.  The springs about the axis that stay
pressed through a step, and those around them that stay free, go through it together, a row of memory at a time; the few
that let go or are caught are carried from event to event, each for itself.

What the kernels take: `law`, that of `winkler.numerics.springs.free_relaxation.Recovery.law`; `springs`, their gaps,
weights and places; `state`, their displacements, memories (terms, n), whether they are pressed, and how many are from
the axis on and have ever been; `motion`, depth, whether it last rose, and rate.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.integrals.exponential_integrals import BENDS, bends, fading, losses
from winkler.numerics.jit import compiled
from winkler.numerics.springs.relaxing_spring import carry, jump

STEP_NUMBERS = 10
"""Of a step: force, impulse, work, growth of both with the depth, energy stored, radius, weight pressed, a ring, loss.

The loss is that of every dashpot, not what is missing from the work.
"""
FORCED_NUMBERS = 6
"""Of a stretch under a force: depth, radius, work, energy stored, loss, a ring."""
STEP_FACTORS = 13
"""Of a step: of every memory its decay, gain with the rate, and three of `losses`; of every mode its fade and loss; of
every memory that bends its gain, three more of the loss, and two of the work."""
MOST_TRIALS = 200
FORCE_TOLERANCE = 1e-13
"""Part of the forces to which a prescribed one is met."""
SHORTEST_STEP = 1e-12
"""Part of a stretch of forces below which no step falls."""
SURELY_LITTLE = 0.2
"""Part of the error allowed below which that of a step is estimated from how the rate has changed alone."""
CORNER = 0.2
"""Part of a step's change of depth beyond which it does not bend, and a kink is a corner: the step is halved."""
NEGLIGIBLE_MEMORY = 1e-200
"""Memories below this are none: numbers that small are slow."""


@compiled
def _survey(law, state, dt, bent, workspace):  # type: ignore[no-untyped-def]
    """Write what a step of this length does to all springs at any rate; nothing, if it is sudden.

    Returned is how load and impulse of those pressed grow with the rate, and what an acceleration `bent` of the body
    does: how far it goes, and its part of load, impulse and work.  `spans` gets, of those pressed, the load now and at
    the end and the impulse, as if nothing moved; of those free, in the second row, the place at the end.  `factors` are
    those of `STEP_FACTORS`.
    """
    relaxed, _, moduli, times, rates = law[0], law[1], law[2], law[3], law[4]
    u, memory, _, counts = state
    factors, spans, scratch, _ = workspace
    phi, bend = scratch[4], scratch[5]
    inside, outer = counts[0], counts[1]
    if dt == 0.0:
        return 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    gains, pulls, bow = 0.0, 0.0, bent * dt * dt
    load, push, spent = 0.0, -relaxed * bow / 12.0, 0.0
    for j in range(inside):
        spans[0, j] = relaxed * u[j]
        spans[1, j] = relaxed * u[j]
        spans[2, j] = relaxed * u[j] * dt
    for i in range(moduli.size):
        x = dt / times[i]
        fading(x, phi)
        decay, lag = np.exp(-x), dt * phi[0]
        gain = moduli[i] * lag
        factors[0, i], factors[1, i] = decay, gain
        factors[3, i], factors[4, i], factors[5, i] = losses(x, phi)
        gains += gain
        pulls += moduli[i] * dt * dt * phi[1]
        if bow != 0.0:
            bends(x, phi, bend)
            own = moduli[i] * bow
            factors[7, i], factors[8, i], factors[9, i] = own * bend[0], own * bend[5], own * bend[6]
            factors[10, i], factors[11, i], factors[12, i] = own * own * bend[7], bow * bend[2], bow * bend[3]
            load, push, spent = load + own * bend[0], push + own * bend[1], spent + bow * own * bend[4]
        for j in range(inside):
            s = memory[i, j]
            spans[0, j] += s
            spans[1, j] += s * decay
            spans[2, j] += s * lag
    for j in range(inside, outer):
        spans[1, j] = 0.0
    for k in range(rates.size):
        fade = np.exp(-rates[k] * dt)
        factors[2, k], factors[6, k] = fade, -law[8][k] * np.expm1(-2.0 * rates[k] * dt)
        for j in range(inside, outer):
            spans[1, j] += memory[k, j] * fade
    return gains, pulls, bow, load, dt * push, spent


@compiled
def _step(law, springs, state, depth, change, dt, grown, workspace, keep, sums):  # type: ignore[no-untyped-def]
    """Carry the springs through a surveyed step, or only compute its effect; return how many are pressed after it.

    `sums` gets force at the end, impulse, work, and by what force and impulse grow with the depth at the end.
    """
    relaxed, viscosity, moduli = law[0], law[1], law[2]
    gaps, weights, _ = springs
    u, memory, pressed, counts = state
    factors, spans, scratch, _ = workspace
    columns, odd, spare, steady, phi, _ = scratch
    inside, outer, modes, odds, sudden = counts[0], counts[1], memory.shape[0], 0, dt == 0.0
    rate = 0.0 if sudden else change / dt
    first = viscosity * rate
    stay = relaxed * change + first + grown[0] * rate + grown[3]
    push = dt * (0.5 * relaxed * change + first) + rate * grown[1] + grown[4]
    force, impulse, heavy, work, lost, count = 0.0, 0.0, 0.0, 0.0, 0.0, 0
    for j in range(0 if sudden else inside):
        fine = (spans[0, j] + first >= 0.0) & (spans[1, j] + stay >= 0.0)
        part = weights[j] if fine else 0.0
        force += part * (spans[1, j] + stay)
        impulse += part * (spans[2, j] + push)
        heavy += part
        count += 1 if fine else 0
    lost += viscosity * rate * change * heavy
    bending = heavy * (grown[2] * relaxed * change / 12.0 + grown[5]) if grown[2] != 0.0 else 0.0
    for j in range(outer):
        if j < inside and not sudden:
            if count == inside or ((spans[0, j] + first >= 0.0) & (spans[1, j] + stay >= 0.0)):
                continue
        elif not sudden and not pressed[j] and depth + change - gaps[j] <= spans[1, j]:
            continue
        odd[odds] = j
        odds += 1
    # gaps never fall outwards: the springs that have never been touched are reached one after the other
    last = outer
    while last < gaps.size and depth + change > gaps[last]:
        odd[odds] = last
        odds += 1
        last += 1
    for c in range(odds):
        j = odd[c]
        mine = columns[c, :modes]
        for k in range(modes):
            mine[k] = memory[k, j]
        if sudden:
            place, held, q, own = jump(law, gaps[j], depth, change, u[j], mine, pressed[j], spare)
            work += weights[j] * own
        else:
            place, held, q, own, gone = carry(law, gaps[j], depth, rate, dt, u[j], mine, pressed[j], spare, phi)
            impulse += weights[j] * own
            lost += weights[j] * gone
        columns[c, modes], columns[c, modes + 1] = place, 1.0 if held else 0.0
        force += weights[j] * q
        heavy += weights[j] if held else 0.0
        count += 1 if held else 0
    sums[0], sums[1], sums[2], sums[7] = force, impulse, work if sudden else impulse * rate, heavy
    sums[3] = heavy * (relaxed + (np.sum(moduli) if sudden else (viscosity + grown[0]) / dt))
    sums[4] = 0.0 if sudden else heavy * (0.5 * relaxed * dt + viscosity + grown[1] / dt)
    if not keep:
        return count
    for j in range(outer):
        steady[j] = weights[j]
    for c in range(odds):
        steady[odd[c]] = 0.0
    for k in range(0 if sudden else modes):
        fade, stored = factors[2, k], 0.0
        for j in range(inside, outer):
            stored += steady[j] * memory[k, j] * memory[k, j]
            s = memory[k, j] * fade
            memory[k, j] = s if abs(s) > NEGLIGIBLE_MEMORY else 0.0
        lost += factors[6, k] * stored
        if k < moduli.size:
            decay, gain, rise = factors[0, k], factors[1, k] * rate, moduli[k] * change
            gain += factors[7, k] if grown[2] != 0.0 else 0.0
            zeroth, first, second = 0.0, 0.0, 0.0
            for j in range(inside):
                s = memory[k, j]
                zeroth += steady[j]
                first += steady[j] * s
                second += steady[j] * s * s
                s = s * decay + gain
                memory[k, j] = s if abs(s) > NEGLIGIBLE_MEMORY else 0.0
            mixed = factors[4, k] * first + factors[5, k] * rise * zeroth
            lost += (factors[3, k] * second + rise * mixed) / moduli[k]
            if grown[2] != 0.0:
                bowed = factors[8, k] * first + (factors[9, k] * rise + factors[10, k]) * zeroth
                lost += bowed / moduli[k]
                bending += factors[11, k] * first + factors[12, k] * rise * zeroth
    sums[2], sums[9] = sums[2] + bending, lost
    for j in range(0 if sudden else outer):
        u[j] = depth + change - gaps[j] if j < inside else spans[1, j]
    for c in range(odds):
        j = odd[c]
        u[j], pressed[j] = columns[c, modes], columns[c, modes + 1] > 0.0
        for k in range(modes):
            memory[k, j] = columns[c, k]
    inside = 0 if odds > 0 else inside
    while odds > 0 and inside < last and pressed[inside]:
        inside += 1
    counts[0], counts[1] = inside, last
    return count


@compiled
def _energy(law, springs, state):  # type: ignore[no-untyped-def]
    """Return what all springs store."""
    weights = springs[1]
    u, memory, _, counts = state
    inside, outer, total = counts[0], counts[1], 0.0
    for j in range(inside):
        total += 0.5 * law[0] * weights[j] * u[j] * u[j]
    for k in range(memory.shape[0]):
        stiff, soft = 0.0, 0.0
        for j in range(inside):
            stiff += weights[j] * memory[k, j] * memory[k, j]
        for j in range(inside, outer):
            soft += weights[j] * memory[k, j] * memory[k, j]
        # a spring that is pressed has no memory of its dashpot
        total += (0.5 * stiff / law[2][k] if k < law[2].size else 0.0) + law[8][k] * soft
    return total


@compiled
def _load(law, state, j, rate):  # type: ignore[no-untyped-def]
    """Return q of a spring that is pressed."""
    q = law[0] * state[0][j] + law[1] * rate
    for i in range(law[2].size):
        q += state[1][i, j]
    return q


@compiled
def _radius(law, springs, state, motion, inside):  # type: ignore[no-untyped-def]
    """Return the contact radius, between the last spring that is pressed and the first that is free.

    Where the contact widens, the gap under the free springs gives the edge; where it shrinks, the loads of the
    pressed ones.
    """
    gaps, _, x = springs
    u = state[0]
    if inside == 0 or inside == gaps.size:
        return x[-1] if inside else 0.0
    low, high = gaps[inside - 1], gaps[inside]
    if motion[1] > 0.0 or inside < 2:
        first, slope = high + u[inside] - motion[0], 1.0
        if inside + 1 < gaps.size:
            slope = (gaps[inside + 1] + u[inside + 1] - motion[0] - first) / (gaps[inside + 1] - high)
        edge = high - first / slope if slope > 0.0 else low
    else:
        outermost = _load(law, state, inside - 1, motion[2])
        fall = _load(law, state, inside - 2, motion[2]) - outermost
        edge = low + (outermost * (low - gaps[inside - 2]) / fall if fall > 0.0 else high - low)
    part = min(max((edge - low) / (high - low), 0.0), 1.0)
    return np.sqrt(x[inside - 1] ** 2 + part * (x[inside] ** 2 - x[inside - 1] ** 2))


@compiled
def _moved(motion, change, dt):  # type: ignore[no-untyped-def]
    """Write the motion after a step."""
    motion[0] += change
    motion[1] = motion[1] if change == 0.0 else 1.0 if change > 0.0 else 0.0
    motion[2] = change / dt if dt > 0.0 else 0.0


@compiled
def advance_springs(law, springs, state, motion, changes, times, numbers):  # type: ignore[no-untyped-def]
    """Carry the springs through steps of steady motion, in place, and write the numbers of each."""
    modes, count = state[1].shape
    rows = np.empty((count, modes + 2)), np.empty(count, np.int64), np.empty(modes), np.empty(count)
    scratch = rows[0], rows[1], rows[2], rows[3], np.empty(4), np.empty(BENDS)
    workspace = np.empty((STEP_FACTORS, modes)), np.empty((3, count)), scratch, np.empty(STEP_NUMBERS)
    for n in range(changes.size):
        sums = numbers[n]
        dt, change = times[n], changes[n]
        grown = _survey(law, state, dt, 0.0, workspace)
        held = _step(law, springs, state, motion[0], change, dt, grown, workspace, True, sums)
        _moved(motion, change, dt)
        sums[5] = _energy(law, springs, state)
        sums[6] = _radius(law, springs, state, motion, held)
        sums[8] = 1.0 if held > state[3][0] else 0.0


@compiled
def _most(law, springs, target, dt):  # type: ignore[no-untyped-def]
    """Return about how fast the sum of `advance_to_force` grows where all springs are pressed."""
    glassy = law[0] + np.sum(law[2]) + (law[1] / dt if dt > 0.0 else 0.0)
    return (target[1] + target[2] * dt) * glassy * np.sum(springs[1]) + target[3]


@compiled
def _find(law, springs, state, motion, target, dt, guess, scale, grown, workspace, known, keep):  # type: ignore[no-untyped-def]
    """Return as `advance_to_force` for a surveyed step, or for a change that is known; `keep` carries the springs.

    All that is compiled of a step stands here once: each further call of `_step` would cost seconds.
    """
    sums, change, low, high, stride = workspace[3], guess, -np.inf, np.inf, 0.0
    for turn in range(MOST_TRIALS + 1):
        held = _step(law, springs, state, motion[0], change, dt, grown, workspace, keep and known, sums)
        if known:
            if keep:
                _moved(motion, change, dt)
            return change, held
        excess = target[1] * sums[0] + target[2] * sums[1] + target[3] * change - target[0]
        steepness = target[1] * sums[3] + target[2] * sums[4] + target[3]
        if abs(excess) <= FORCE_TOLERANCE * scale:
            if not keep:
                return change, held
            known = True
            continue
        low, high = (low, min(high, change)) if excess > 0.0 else (max(low, change), high)
        newton = change - excess / steepness if steepness > 0.0 else np.inf
        bracketed = np.isfinite(low) and np.isfinite(high)
        if low < newton < high and not (bracketed and turn % 4 == 3):
            change = newton
        elif bracketed:
            change = 0.5 * (low + high)
            known = not low < change < high
        else:
            stride = max(2.0 * stride, 0.5 * scale / _most(law, springs, target, dt), 1e-6 * abs(change))
            change += stride if excess < 0.0 else -stride
    return np.nan, 0


@compiled
def advance_to_force(law, springs, state, motion, target, dt, guess, scale):  # type: ignore[no-untyped-def]
    """Return the change of depth of a step for which a sum is what is wanted, or not-a-number, and how many springs
    are pressed after it; they stay where they are.

    The sum is that of force at the end, impulse and change, times the last three of `target`; it never falls with the
    change.  `scale` is one that matters.
    """
    modes, count = state[1].shape
    rows = np.empty((count, modes + 2)), np.empty(count, np.int64), np.empty(modes), np.empty(count)
    scratch = rows[0], rows[1], rows[2], rows[3], np.empty(4), np.empty(BENDS)
    workspace = np.empty((STEP_FACTORS, modes)), np.empty((3, count)), scratch, np.empty(STEP_NUMBERS)
    grown = _survey(law, state, dt, 0.0, workspace)
    return _find(law, springs, state, motion, target, dt, guess, scale, grown, workspace, False, False)


@compiled
def _curved(law, missed, dt):  # type: ignore[no-untyped-def]
    """Return about by how much the depth after a step is wrong that ends so far from where rate and bend led.

    What relaxes forgets where between the ends of the step it was pressed in: of the parabola over the straight line,
    whose area is d'' dt^3 / 12, each memory forgets at most the part dt / tau.
    """
    forgotten, glassy = 0.0, law[0]
    for i in range(law[2].size):
        forgotten += law[2][i] * min(dt / law[3][i], 1.0)
        glassy += law[2][i]
    return abs(missed) * forgotten / glassy / 12.0


@compiled
def _put(state, motion, place, onto):  # type: ignore[no-untyped-def]
    """Write a state and a motion into others, number by number: to compile an assignment of slices takes seconds."""
    for j in range(state[0].size):
        place[0][j], place[2][j] = state[0][j], state[2][j]
        for k in range(state[1].shape[0]):
            place[1][k, j] = state[1][k, j]
    place[3][0], place[3][1] = state[3][0], state[3][1]
    for i in range(motion.size):
        onto[i] = motion[i]


@compiled
def advance_under_forces(law, springs, state, motion, forces, times, limits, course, numbers):  # type: ignore[no-untyped-def]
    """Carry the springs through stretches in which a force changes steadily, in place; write `FORCED_NUMBERS` of each.

    Within steps the depth bends as it did before them, under a dashpot alongside it is straight.  Where it turns out to
    go otherwise, steps are halved until both halves reach the depth of the whole.

    Parameters
    ----------
    law, springs, state, motion
        As above.
    forces : ndarray, (n + 1,)
        At the ends of the stretches.
    times : ndarray, (n,)
        How long they take; none for a force that is put on suddenly, and not by a dashpot.
    limits : ndarray, (2,)
        The error of depth that a step may have, and a force that matters.
    course : ndarray, (5,)
        The rate of the last step, how long the next one should take, the acceleration, how long the last one took, and
        the rate of the force; zero before the first.
    numbers : ndarray, (n, FORCED_NUMBERS)
        What comes of it; work and loss of the stretch alone.

    Returns
    -------
    tuple of int
        How many stretches were carried through, and what has ended the next: 0 nothing, 1 no depth bears the force,
        2 steps become too short.
    """
    there = np.empty_like(state[0]), np.empty_like(state[1]), np.empty_like(state[2]), np.empty_like(state[3])
    modes, count = state[1].shape
    rows = np.empty((count, modes + 2)), np.empty(count, np.int64), np.empty(modes), np.empty(count)
    scratch = rows[0], rows[1], rows[2], rows[3], np.empty(4), np.empty(BENDS)
    workspace = np.empty((STEP_FACTORS, modes)), np.empty((3, count)), scratch, np.empty(STEP_NUMBERS)
    away, sums, target, held = np.empty(3), workspace[3], np.zeros(4), 0
    little, scale, viscous = limits[0], limits[1], law[1] > 0.0
    for n in range(times.size):
        start, duration, done = forces[n], times[n], 0.0
        rise, work, lost = forces[n + 1] - start, 0.0, 0.0
        sudden = duration == 0.0 and not viscous
        slope = rise / duration if duration > 0.0 else 0.0
        pace = min(course[1], duration) if course[1] > 0.0 else 0.125 * duration
        while sudden or done < duration:
            dt = min(pace, duration - done)
            if duration - done - dt < 1e-9 * duration:
                dt = duration - done
            last = dt == duration - done
            # with a dashpot alongside, whose forces jump with the rate, the mean force of a step is meant
            target[1], target[2] = (0.0, 1.0 / dt) if viscous else (1.0, 0.0)
            target[0] = start + rise * (1.0 if sudden else (done + (0.5 if viscous else 1.0) * dt) / duration)
            bent = 0.0 if sudden or viscous else course[2]
            guess = (course[0] + 0.5 * bent * (dt + course[3])) * dt
            if abs(bent) * dt * dt > CORNER * abs(guess):  # springs that come and go within a step do so without it
                bent, guess = 0.0, course[0] * dt
            now, path, span, known, whole, moved, worked, wasted = state, motion, dt, False, 0.0, 0.0, 0.0, 0.0
            kink, error = 0.0, 0.0
            for stage in range(3):  # the whole step is tried; then it is made, or its halves are, elsewhere
                if not known:
                    grown = _survey(law, now, span, bent, workspace)
                change, held = _find(
                    law, springs, now, path, target, span, guess, scale, grown, workspace, known, stage > 0
                )
                if np.isnan(change):
                    return n, 1
                if stage == 0:
                    # where the force kinks, so does the depth: that is no bend
                    whole, kink = change, (slope - course[4]) * dt / sums[3] if sums[3] > 0.0 else 0.0
                    corner = viscous or abs(kink) > CORNER * abs(whole)
                    error = 0.0 if sudden else np.inf if corner else _curved(law, whole - guess - kink, dt)
                    known = error <= SURELY_LITTLE * little
                    if not known:
                        _put(state, motion, there, away)
                        now, path, span = there, away, 0.5 * dt
                    guess = whole if known else 0.5 * whole
                else:
                    moved, worked, wasted = moved + change, worked + sums[2], wasted + sums[9]
                    guess = whole - moved
                    if known:
                        break
                if not known:
                    target[2] = 1.0 / span if viscous else 0.0
                    target[0] = start + rise * (done + ((0.25 if viscous else 0.5) + 0.5 * stage) * dt) / duration
            rate = change / span if span > 0.0 else 0.0
            if known:
                bent = 2.0 * (rate - course[0] - kink / dt) / (dt + course[3]) if dt > 0.0 and course[3] > 0.0 else 0.0
            else:
                error = abs(moved - whole)
                if error > little:
                    if dt < SHORTEST_STEP * duration:
                        return n, 2
                    pace = dt * max(0.2, 0.9 * (little / error) ** (1.0 / 3.0))
                    continue
                _put(there, away, state, motion)
                bent = (2.0 * change - moved) / (span * span)
            work, lost = work + worked, lost + wasted
            if sudden:
                sudden, course[2] = False, 0.0
                continue
            course[0], course[2], course[3], course[4] = rate, bent, span, slope
            done = duration if last else done + dt
            grow = dt * min(4.0, max(0.3, 0.9 * (little / max(error, 1e-6 * little)) ** (1.0 / 3.0)))
            pace = max(pace, grow) if last else grow  # a step that the end has cut short says little of the next
        if duration > 0.0:
            course[1] = pace
        numbers[n, 0], numbers[n, 1], numbers[n, 2] = motion[0], _radius(law, springs, state, motion, held), work
        numbers[n, 3], numbers[n, 4], numbers[n, 5] = (
            _energy(law, springs, state),
            lost,
            1.0 if held > state[3][0] else 0.0,
        )
    return times.size, 0
