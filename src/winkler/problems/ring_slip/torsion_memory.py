r"""What the springs of a twisted contact remember, without a grid.

A spring at x carries the load :math:`q = x\,h`, and on every stretch of the contact

.. math:: h(x) = \alpha + \beta\,\ell(x) + \sigma\,b(x)

where b is the bound of a contact that once was, :math:`\sigma=\pm1` or 0, and :math:`\ell(x)` the level
(depth or force) at which the spring came into contact.  A twist adds :math:`8G_t\varphi` to h, a spring beyond its
bound takes :math:`h=\pm b` of the contact as it is now, one that comes into contact has the twist since: all are of
this form.

On a straight line in the level and the angle the bound is concave, so that a spring which has reached it stays on it:
one `move` along the line, however long, leaves every spring where it must be.  Only the loss depends on the path.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from winkler.foundation.torsion_bound import PressedState, TwistBound
from winkler.numerics.panels.kink_panels import Sample
from winkler.numerics.types import Array
from winkler.problems.ring_slip.torsion_pieces import NO_CONTACT, TwistMemory, TwistPiece, pieces_of

__all__ = ["TwistMove", "TwistRing", "moved", "slid_along", "stuck_work"]

BOUND_ROUNDING = 3e-13
"""Part of the bound inside the contact by which rounding may exceed it."""
NARROWEST_RING = 1e-9
"""A ring narrower than this part of the contact is none."""
BISECTIONS = 60
"""At most so many, of the places where sliding begins."""


class TwistRing(NamedTuple):
    """Springs that slid, or left the contact: places, loads h before the move, when they touch, and to which side."""

    sample: Sample
    before: Array
    clock: Array
    side: Array


class TwistMove(NamedTuple):
    """What a move leads to.

    `rings` are the springs that slid or left the contact, `nested` whether those that slid are its outer part and slid
    to one side, and `free` is the part of 2 int x^2 dx that follows a further twist.
    """

    memory: TwistMemory
    rings: tuple[TwistRing, ...]
    nested: bool
    free: float


def _memory_of(press: PressedState, pieces: list[TwistPiece]) -> TwistMemory:
    merged: list[TwistPiece] = []
    for piece in pieces:
        if merged and merged[-1][2:] == piece[2:]:
            merged[-1] = merged[-1]._replace(high=piece.high)
        else:
            merged.append(piece)
    columns = list(zip(*merged, strict=True)) if merged else [(), (), (), (), (), ()]
    edges = np.array([0.0, *columns[1]])
    held, entered, sides = (np.array(column, dtype=float) for column in columns[2:5])
    return TwistMemory(*press, edges, held, entered, sides, np.array(columns[5], dtype=float).reshape(-1, 3))


def moved(bound: TwistBound, memory: TwistMemory, press: PressedState, twist: float) -> TwistMove:
    """Return the springs after the contact was pressed to `press` and twisted, both in proportion.

    Parameters
    ----------
    bound : TwistBound
    memory : TwistMemory
        The springs before.
    press : PressedState
        How the contact is pressed afterwards.
    twist : float
        8 G_t times the change of the angle [Pa].
    """
    before, change = memory.press, press.level - memory.level
    trials: list[tuple[TwistPiece, bool]] = [
        (piece._replace(high=min(piece.high, press.radius), held=piece.held + twist), False)
        for piece in pieces_of(memory)
        if piece.low < press.radius
    ]
    if press.radius > before.radius:
        rate = twist / change if change > 0.0 else 0.0
        trials.append((TwistPiece(before.radius, press.radius, rate * press.level, -rate, 0.0, NO_CONTACT), True))
    now = bound.at(press)
    slack = BOUND_ROUNDING * bound.panels.at(now, 0.5 * press.radius) if press.radius > 0.0 else 0.0
    done: list[TwistPiece] = []
    rings: list[TwistRing] = []
    states: list[tuple[float, int]] = []
    free = 0.0
    for trial, entering in trials:
        values = trial.values(bound)
        for low, high, state in _stretches_of(bound, trial, now, values, slack):
            states.append((high - low, state))
            if state == 0:
                done.append(trial._replace(low=low, high=high))
                free += (
                    _free(bound, low, high, press.level, change)
                    if entering
                    else bound.inertia(high) - bound.inertia(low)
                )
                continue
            done.append(TwistPiece(low, high, 0.0, 0.0, float(state), press))
            sample = bound.panels.sample(low, high)
            load = np.zeros_like(sample.x) if entering else sample.read(values) - twist
            rings.append(TwistRing(sample, load, sample.read(bound.clock), np.full(sample.x.shape, state)))
    if press.radius < before.radius:
        rings += _left(bound, memory, press, twist)
    return TwistMove(_memory_of(press, done), tuple(rings), _nested(states, press.radius), free)


def stuck_work(bound: TwistBound, memory: TwistMemory, press: PressedState, twist: float) -> float:
    """Return 4 G_t times the work of a move on the springs that end in contact, if none of them slid."""
    total, before, change = 0.0, memory.radius, press.level - memory.level
    for piece in pieces_of(memory):
        if piece.low < press.radius:
            sample = bound.panels.sample(piece.low, min(piece.high, press.radius))
            load = sample.read(piece.values(bound))
            total += float(np.sum(sample.weights * bound.weigh(sample) * twist * (load + 0.5 * twist)))
    if press.radius > before and change > 0.0:
        work = 0.5 * bound.weight * (twist * (press.level - bound.clock) / change) ** 2
        low, high = bound.panels.integral(work, np.array([before, press.radius])).tolist()
        total += high - low
    return total


def _free(bound: TwistBound, low: float, high: float, level: float, change: float) -> float:
    """Return 2 int x^2 s dx of springs that have only the share s of a twist, since they came into contact."""
    if change <= 0.0:
        return 0.0
    moments = bound.panels.integral(bound.weight * (level - bound.clock), np.array([low, high]))
    return 2.0 * float(moments[1] - moments[0]) / change


def slid_along(
    bound: TwistBound, memory: TwistMemory, path: Sequence[PressedState], twist: float, rings: tuple[TwistRing, ...]
) -> tuple[float, float]:
    """Return 4 G_t times the energy that `rings` lose on a path whose last press is where the move ends, and the work.

    Of the work it is the part beyond `stuck_work`, summed up from the loads that the springs have on it, the
    loss from how far they slide.  Between the points of the path bounds are taken as straight; the error falls with the
    square of their distance.
    """
    total, extra, start, end = 0.0, 0.0, memory.level, path[-1].level
    for ring in rings:
        x, weight = ring.sample.x, bound.weigh(ring.sample)
        side = ring.side
        first = np.clip((ring.clock - start) / (end - start), 0.0, 1.0) if end > start else np.zeros_like(x)
        last = np.clip((start - ring.clock) / (start - end), 0.0, 1.0) if end < start else np.ones_like(x)
        if bound.endless:
            total += 0.5 * float(np.sum(ring.sample.weights * weight * (ring.before + twist * last) ** 2))
            extra += float(np.sum(ring.sample.weights * weight * twist * last * (ring.before + 0.5 * twist * last)))
            continue
        allowed = np.where(x < memory.radius, np.maximum(ring.sample.read(bound.at(memory.press)), 0.0), 0.0)
        slid = np.maximum(side * ring.before - allowed, 0.0)  # rounding
        load = displaced = side * ring.before
        density = np.zeros_like(x)
        if_stuck = twist * (1.0 - first)
        work = np.where(x < path[-1].radius, -if_stuck * (ring.before + 0.5 * if_stuck), 0.0)
        for press in path:
            share = (press.level - start) / (end - start) if end != start else 1.0
            here = side * (ring.before + twist * np.maximum(np.minimum(share, last) - first, 0.0))
            limit = np.where(x < press.radius, np.maximum(ring.sample.read(bound.at(press)), 0.0), 0.0)
            excess = np.maximum(here - limit - slid, 0.0)
            margin = np.maximum(allowed - load, 0.0)
            onset = np.divide(margin, margin + excess, out=np.zeros_like(margin), where=margin + excess > 0.0)
            at_onset = allowed + (limit - allowed) * onset
            density += 0.5 * (at_onset + limit) * excess
            slid = slid + excess
            after = np.minimum(here - slid, limit)
            mean = np.where(excess > 0.0, onset * (load + at_onset) + (1.0 - onset) * (at_onset + limit), load + after)
            work += 0.5 * mean * (here - displaced)
            load, displaced, allowed = after, here, limit
        total += float(np.sum(ring.sample.weights * weight * density))
        extra += float(np.sum(ring.sample.weights * weight * work))
    return total, extra


def _left(bound: TwistBound, memory: TwistMemory, press: PressedState, twist: float) -> list[TwistRing]:
    """Return the springs that come out of contact."""
    rings = []
    for piece in pieces_of(memory):
        if piece.high > press.radius:
            sample = bound.panels.sample(max(piece.low, press.radius), piece.high)
            clock, before = sample.read(bound.clock), sample.read(piece.values(bound))
            last = np.clip((memory.level - clock) / (memory.level - press.level), 0.0, 1.0)
            rings.append(TwistRing(sample, before, clock, np.where(before + twist * last >= 0.0, 1, -1)))
    return rings


def _stretches_of(
    bound: TwistBound, trial: TwistPiece, now: Array, values: Array, slack: float
) -> list[tuple[float, float, int]]:
    """Return where a stretch sticks (0) and where it slides to which side."""
    if bound.endless:
        return [(trial.low, trial.high, 0)]
    sample = bound.panels.sample(trial.low, trial.high)
    places = np.concatenate([[trial.low], sample.x.ravel(), [trial.high]])
    limit, load = (
        np.concatenate(
            [[bound.panels.at(each, trial.low)], sample.read(each).ravel(), [bound.panels.at(each, trial.high)]]
        )
        for each in (now, values)
    )
    state = np.where(load > limit + slack, 1, 0) - np.where(-load > limit + slack, 1, 0)
    cuts: list[tuple[float, float, int]] = []
    low = trial.low
    for i in np.flatnonzero(state[1:] != state[:-1]).tolist():
        here, there = int(state[i]), int(state[i + 1])
        for side in (here, there):
            if side != 0:
                meet = _meet(bound, side * values - now, float(places[i]), float(places[i + 1]), side == there)
                cuts.append((low, meet, here if side == here else 0))
                low = meet
    cuts.append((low, trial.high, int(state[-1])))
    return [cut for cut in cuts if cut[1] > cut[0]]


def _meet(bound: TwistBound, excess: Array, low: float, high: float, rising: bool) -> float:
    """Return where a load meets its bound between two places."""
    sign = 1.0 if rising else -1.0

    over = bound.panels.reader(sign * excess)

    left, right = over(low), over(high)
    if left >= 0.0:
        return low
    if right <= 0.0:
        return high
    last_side = 0
    for _ in range(BISECTIONS):  # the rule of false position, halving the end that stays (Illinois)
        middle = low - left * (high - low) / (right - left)
        if not low < middle < high or high - low <= 1e-15 * high:
            break
        middle_value = over(middle)
        if middle_value == 0.0:
            return middle
        if middle_value < 0.0:
            low, left = middle, middle_value
            right = 0.5 * right if last_side < 0 else right
            last_side = -1
        else:
            high, right = middle, middle_value
            left = 0.5 * left if last_side > 0 else left
            last_side = 1
    return low if -left < right else high


def _nested(states: list[tuple[float, int]], radius: float) -> bool:
    """Whether what slides is one outer ring that slides to one side."""
    sliding = 0
    for width, state in states:
        if width > NARROWEST_RING * radius:
            if sliding not in (0, state):
                return False
            sliding = state
    return True
