r"""What the springs of a twisted contact remember, without a grid.

A spring at x carries the load :math:`q = x\,h`, and on every stretch of the contact

.. math:: h(x) = \alpha + \beta\,\ell(x) + \sigma\,b(x)

where b is the bound of a contact that once was, :math:`\sigma=\pm1` or 0, and :math:`\ell(x)` the level
(depth or force) at which the spring came into contact.  A twist adds :math:`8G_t\varphi` to h, a spring beyond its
bound takes :math:`h=\pm b` of the contact as it is now, one that comes into contact has the twist since: all are of
this form.

On a straight line in the level and the angle the bound is concave, so that a spring which has reached it stays on it:
one move along the line, however long, leaves every spring where it must be.  Only the loss depends on the path.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from winkler.foundation.torsion_bound import PressedState, TwistBound
from winkler.numerics.equations.roots import between
from winkler.numerics.panels.kink_panels import Sample
from winkler.numerics.types import Array
from winkler.problems.ring_slip.torsion_pieces import NO_CONTACT, TwistMemory, TwistPiece

BOUND_ROUNDING = 3e-13
"""Part of the bound inside the contact by which rounding may exceed it."""
NARROWEST_RING = 1e-9
"""A ring narrower than this part of the contact is none."""
CHUNK = 256
"""Points of a path whose bounds are held at once."""


class TwistRing(NamedTuple):
    """Springs that slid, or left the contact: places, loads h before the move, when they touch, and to which side."""

    sample: Sample
    before: Array
    clock: Array
    side: Array


class TwistMove(NamedTuple):
    """What a move leads to.

    `rings` are the springs that slid or left the contact, `nested` whether those that slid are its outer part and slid
    to one side.
    """

    memory: TwistMemory
    rings: tuple[TwistRing, ...]
    nested: bool


def _memory_of(press: PressedState, pieces: list[TwistPiece]) -> TwistMemory:
    merged: list[TwistPiece] = []
    for piece in pieces:
        if merged and merged[-1][2:] == piece[2:]:
            merged[-1] = merged[-1]._replace(high=piece.high)
        else:
            merged.append(piece)
    return TwistMemory(press, tuple(merged))


class _Trial(NamedTuple):
    """A stretch of springs ahead of a twist: what they bear without one, and per twist, at the nodes and summed up."""

    piece: TwistPiece
    entering: bool
    values: Array
    shares: Array
    borne: Callable[[float], float]
    freed: Callable[[float], float]


class TwistCut(NamedTuple):
    """Part of a stretch, of that number, that sticks (0) or slides to one side (1, -1)."""

    trial: int
    low: float
    high: float
    state: int


class TwistAhead:
    """Springs whose contact is about to be pressed to `press` and twisted, both in proportion, by a twist to be chosen.

    Parameters
    ----------
    bound : TwistBound
    memory : TwistMemory
        The springs before.
    press : PressedState
        How the contact is pressed afterwards.
    """

    def __init__(self, bound: TwistBound, memory: TwistMemory, press: PressedState) -> None:
        self.bound, self.memory, self.press = bound, memory, press
        before, change = memory.press, press.level - memory.press.level
        self._rate = 1.0 / change if change > 0.0 else 0.0
        self._now = now = bound.at(press)
        self._slack = BOUND_ROUNDING * bound.panels.at(now, 0.5 * press.radius) if press.radius > 0.0 else 0.0
        self._slid = bound.panels.antiderivative(now * bound.weight)
        ones, inertia = np.ones_like(now), bound.panels.antiderivative(bound.weight)
        self._trials = [
            self._trial(piece._replace(high=min(piece.high, press.radius)), False, piece.values(bound), ones, inertia)
            for piece in memory.pieces
            if piece.low < press.radius
        ]
        if press.radius > before.radius:
            shares = self._rate * (press.level - bound.clock)
            freed = bound.panels.antiderivative(shares * bound.weight)
            piece = TwistPiece(before.radius, press.radius, 0.0, 0.0, 0.0, NO_CONTACT)
            self._trials.append(self._trial(piece, True, np.zeros_like(now), shares, freed))

        places = [] if bound.endless else [self._places_of(trial) for trial in self._trials]
        self._ends = np.cumsum([0, *(each.shape[1] for each in places)]).tolist()
        places_loads = np.concatenate(places, axis=1) if places else np.zeros((4, 0))
        self._places, (self._most, self._load, self._share) = places_loads[0].tolist(), places_loads[1:]

    def _trial(
        self, piece: TwistPiece, entering: bool, values: Array, shares: Array, freed: Callable[[float], float]
    ) -> _Trial:
        borne = self.bound.panels.antiderivative(values * self.bound.weight)
        return _Trial(piece, entering, values, shares, borne, freed)

    def _places_of(self, trial: _Trial) -> Array:
        """Return places of a stretch, what springs bear there at most, bear without a twist, and per twist."""
        panels, low, high = self.bound.panels, trial.piece.low, trial.piece.high
        sample, curves = panels.sample(low, high), np.array([self._now, trial.values, trial.shares])
        ends = (panels.at(curves, low), panels.at(curves, high))
        read = np.concatenate([ends[0][:, None], sample.read(curves).reshape(3, -1), ends[1][:, None]], axis=1)
        read[0] += self._slack
        return np.concatenate([[[low, *sample.x.ravel().tolist(), high]], read])

    def cuts(self, twist: float) -> list[TwistCut]:
        """Return what sticks and what slides after a twist: 8 G_t times the change of the angle [Pa]."""
        load = self._load + twist * self._share
        state = np.where(load > self._most, 1, 0) - np.where(-load > self._most, 1, 0)
        changes = np.flatnonzero(state[1:] != state[:-1]).tolist()
        cuts: list[TwistCut] = []
        for number, trial in enumerate(self._trials):
            low, high, last = trial.piece.low, trial.piece.high, 0
            if not self.bound.endless:
                begin, end = self._ends[number : number + 2]
                last = int(state[end - 1])
                for i in (each for each in changes if begin <= each < end - 1):
                    here, there = int(state[i]), int(state[i + 1])
                    for side in (here, there):
                        if side != 0:
                            excess = side * (trial.values + twist * trial.shares) - self._now
                            meet = _meet(self.bound, excess, self._places[i], self._places[i + 1], side == there)
                            cuts.append(TwistCut(number, low, meet, here if side == here else 0))
                            low = meet
            cuts.append(TwistCut(number, low, high, last))
        return [cut for cut in cuts if cut.high > cut.low]

    def load(self, cuts: list[TwistCut], twist: float) -> float:
        """Return the torque after a twist [N m]."""
        total = 0.0
        for number, low, high, state in cuts:
            trial = self._trials[number]
            if state:
                total += state * (self._slid(high) - self._slid(low))
            else:
                total += trial.borne(high) - trial.borne(low) + twist * (trial.freed(high) - trial.freed(low))
        return 2.0 * total

    def free(self, cuts: list[TwistCut]) -> float:
        """Return the part of 2 int x^2 dx that follows a further twist."""
        freed = [(self._trials[number].freed, low, high) for number, low, high, state in cuts if not state]
        return 2.0 * sum(upto(high) - upto(low) for upto, low, high in freed)

    def moved(self, cuts: list[TwistCut], twist: float) -> TwistMove:
        """Return the springs after a twist."""
        bound, press = self.bound, self.press
        done: list[TwistPiece] = []
        rings: list[TwistRing] = []
        for number, low, high, state in cuts:
            trial = self._trials[number]
            if state == 0:
                rate = self._rate * twist
                done.append(
                    TwistPiece(low, high, rate * press.level, -rate, 0.0, NO_CONTACT)
                    if trial.entering
                    else trial.piece._replace(low=low, high=high, held=trial.piece.held + twist)
                )
                continue
            done.append(TwistPiece(low, high, 0.0, 0.0, float(state), press))
            sample = bound.panels.sample(low, high)
            rings.append(
                TwistRing(sample, sample.read(trial.values), sample.read(bound.clock), np.full(sample.x.shape, state))
            )
        if press.radius < self.memory.press.radius:
            rings += _left(bound, self.memory, press, twist)
        nested = _nested([(high - low, state) for _, low, high, state in cuts], press.radius)
        return TwistMove(_memory_of(press, done), tuple(rings), nested)


def stuck_work(bound: TwistBound, memory: TwistMemory, press: PressedState, twist: float) -> float:
    """Return 4 G_t times the work of a move on the springs that end in contact, if none of them slid."""
    total, before, change = 0.0, memory.press.radius, press.level - memory.press.level
    for piece in memory.pieces:
        if piece.low < press.radius:
            sample = bound.panels.sample(piece.low, min(piece.high, press.radius))
            load = sample.read(piece.values(bound))
            total += float(np.sum(sample.weights * bound.weigh(sample) * twist * (load + 0.5 * twist)))
    if press.radius > before and change > 0.0:
        work = 0.5 * bound.weight * (twist * (press.level - bound.clock) / change) ** 2
        low, high = bound.panels.integral(work, np.array([before, press.radius])).tolist()
        total += high - low
    return total


def slid_along(
    bound: TwistBound, memory: TwistMemory, path: Sequence[PressedState], twist: float, rings: tuple[TwistRing, ...]
) -> tuple[float, float]:
    """Return 4 G_t times the energy that `rings` lose on a path whose last press is where the move ends, and the work.

    Of the work it is the part beyond `stuck_work`, summed up from the loads that the springs have on it, the
    loss from how far they slide.  Between the points of the path bounds are taken as straight; the error falls with the
    square of their distance.
    """
    if not rings:
        return 0.0, 0.0
    start, end = memory.press.level, path[-1].level
    x, weights, counts = (
        np.concatenate(column)
        for column in zip(*((r.sample.x, r.sample.weights, bound.weigh(r.sample)) for r in rings), strict=True)
    )
    before, clock, side = (np.concatenate(column) for column in list(zip(*rings, strict=True))[1:])
    weight = weights * counts

    def read(values: Array) -> Array:
        return np.concatenate([np.maximum(ring.sample.read(values), 0.0) for ring in rings], axis=-2)

    first = np.clip((clock - start) / (end - start), 0.0, 1.0) if end > start else np.zeros_like(x)
    last = np.clip((start - clock) / (start - end), 0.0, 1.0) if end < start else np.ones_like(x)
    if bound.endless:
        lost = 0.5 * float(np.sum(weight * (before + twist * last) ** 2))
        return lost, float(np.sum(weight * twist * last * (before + 0.5 * twist * last)))
    allowed = np.where(x < memory.press.radius, read(bound.at(memory.press)), 0.0)
    load = displaced = side * before
    slid = np.maximum(load - allowed, 0.0)  # rounding
    density = np.zeros_like(x)
    if_stuck = twist * (1.0 - first)
    work = np.where(x < path[-1].radius, -if_stuck * (before + 0.5 * if_stuck), 0.0)
    for presses in (path[begin : begin + CHUNK] for begin in range(0, len(path), CHUNK)):
        levels, radii, _ = (np.array(column)[:, None, None] for column in zip(*presses, strict=True))
        shares = (levels - start) / (end - start) if end != start else np.ones_like(levels)
        here = side * (before + twist * np.maximum(np.minimum(shares, last) - first, 0.0))
        limit = np.where(x < radii, read(bound.each(presses)), 0.0)
        slips = np.maximum.accumulate(np.concatenate([slid[None], here - limit]))
        after = np.minimum(here - slips[1:], limit)
        loads, limits = np.concatenate([load[None], after[:-1]]), np.concatenate([allowed[None], limit[:-1]])
        excess, margin = np.diff(slips, axis=0), np.maximum(limits - loads, 0.0)
        onset = np.divide(margin, margin + excess, out=np.zeros_like(margin), where=margin + excess > 0.0)
        at_onset = limits + (limit - limits) * onset
        density += np.sum(0.5 * (at_onset + limit) * excess, axis=0)
        sliding = onset * (loads + at_onset) + (1.0 - onset) * (at_onset + limit)
        mean = np.where(excess > 0.0, sliding, loads + after)
        work += np.sum(0.5 * mean * np.diff(np.concatenate([displaced[None], here]), axis=0), axis=0)
        slid, load, displaced, allowed = slips[-1], after[-1], here[-1], limit[-1]
    return float(np.sum(weight * density)), float(np.sum(weight * work))


def _left(bound: TwistBound, memory: TwistMemory, press: PressedState, twist: float) -> list[TwistRing]:
    """Return the springs that come out of contact."""
    rings = []
    for piece in memory.pieces:
        if piece.high > press.radius:
            sample = bound.panels.sample(max(piece.low, press.radius), piece.high)
            clock, before = sample.read(bound.clock), sample.read(piece.values(bound))
            last = np.clip((memory.press.level - clock) / (memory.press.level - press.level), 0.0, 1.0)
            rings.append(TwistRing(sample, before, clock, np.where(before + twist * last >= 0.0, 1, -1)))
    return rings


def _meet(bound: TwistBound, excess: Array, low: float, high: float, rising: bool) -> float:
    """Return where a load meets its bound between two places."""
    over = bound.panels.reader(excess if rising else -excess)
    left, right = over(low), over(high)
    if left >= 0.0:
        return low
    return high if right <= 0.0 else between(over, low, high)


def _nested(states: list[tuple[float, int]], radius: float) -> bool:
    """Whether what slides is one outer ring that slides to one side."""
    sliding = 0
    for width, state in states:
        if width > NARROWEST_RING * radius:
            if sliding not in (0, state):
                return False
            sliding = state
    return True
