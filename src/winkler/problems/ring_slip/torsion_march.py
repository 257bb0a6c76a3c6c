r"""One step of a twisted contact: along a straight line in the normal load and the angle, or the torque.

Under a prescribed angle one move along the line is exact, however long; only the loss depends on the path, if load and
angle change together and something slides: it is then summed over ever shorter moves.  Under a prescribed torque the
angle is sought that it needs, at the end of the line, or, if the load changes too, at ever more points of it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.errors import NotConverged, OutsideValidity
from winkler.foundation.torsion_bound import PressedState, TwistBound
from winkler.problems.ring_slip.torsion_memory import TwistMove, moved, slid_along, stuck_work
from winkler.problems.ring_slip.torsion_pieces import TwistMemory, pieces_of

__all__ = [
    "ANGLE_TOLERANCE",
    "CUT_TOLERANCE",
    "LOSS_TOLERANCE",
    "TORQUE_MARGIN",
    "TorsionStep",
    "square",
    "step_by_angle",
    "step_to_torque",
    "torque_of",
    "torsion_step",
]

LOSS_TOLERANCE = 1e-8
"""Tolerance of the energy lost in a step, relative to the energy stored in it and lost in it."""
ANGLE_TOLERANCE = 1e-4
"""Tolerance of angle and loss in a step under a torque and a changing load, relative to what the contact can bear."""
CUT_TOLERANCE = 1e-4
"""Tolerance of the torque in a step that is cut, relative to what the contact can bear."""
MOST_CUTS = 7
"""How often such a step is halved at most."""
MOST_HALVINGS = 13
"""How often the moves of a step are halved at most."""
TORQUE_MARGIN = 1e-12
"""Part of the greatest torque that stays unreachable."""
TORQUE_TOLERANCE = 1e-12
"""Part of the greatest torque by which a prescribed one may be missed."""
MOST_TRIALS = 200
"""At most so many angles are tried for a torque."""


class TorsionStep(NamedTuple):
    """The springs after a step, 8 G_t times the change of angle [Pa], 4 G_t times loss and work, `TwistMove.nested`."""

    memory: TwistMemory
    twist: float
    loss: float
    work: float
    nested: bool


def torque_of(bound: TwistBound, memory: TwistMemory) -> float:
    """Return the torque [N m]."""
    total = 0.0
    for piece in pieces_of(memory):
        ends = np.array([piece.low, piece.high])
        low, high = bound.panels.integral(piece.values(bound) * bound.weight, ends).tolist()
        total += high - low
    return 2.0 * total


def square(bound: TwistBound, memory: TwistMemory) -> float:
    """Return the integral of q^2 over x > 0: 8 G_t times the stored energy.

    Place by place: in a difference of integrals up to both ends, the bound of a narrow ring, squared where it does not
    hold, would leave rounding far above what a small twist stores.
    """
    total = 0.0
    for piece in pieces_of(memory):
        sample = bound.panels.sample(piece.low, piece.high)
        total += float(np.sum(sample.weights * bound.weigh(sample) * sample.read(piece.values(bound)) ** 2))
    return total


def torsion_step(bound: TwistBound, memory: TwistMemory, press: PressedState, twist: float) -> TorsionStep:
    """Return the springs after load and angle have changed in proportion."""
    press = _settled(memory.press, press)
    whole = moved(bound, memory, press, twist)
    stuck = stuck_work(bound, memory, press, twist)
    if whole.loss == 0.0 or press == memory.press:
        return TorsionStep(whole.memory, twist, whole.loss, stuck + whole.extra, whole.nested)
    stored = [square(bound, each) for each in (memory, whole.memory)]
    if twist == 0.0:  # nothing is put in: what is lost was stored
        return TorsionStep(whole.memory, twist, max(0.5 * (stored[0] - stored[1]), 0.0), 0.0, whole.nested)
    rough = best = whole.loss
    extra = whole.extra
    for halving in range(1, MOST_HALVINGS + 1):
        path = [step for step, _ in _path(bound, memory.press, press, 2**halving)]
        fine, work = slid_along(bound, memory, path, twist, whole.rings)
        better, rough = fine + (fine - rough) / 3.0, fine
        settled, extra = work + (work - extra) / 3.0, work
        if abs(better - best) <= LOSS_TOLERANCE * (0.5 * max(stored) + fine):
            return TorsionStep(whole.memory, twist, max(better, 0.0), stuck + settled, whole.nested)
        best = better
    raise NotConverged(
        f"{bound.owner}: the energy lost between the normal loads {memory.level:.6g} and {press.level:.6g} does not "
        "settle; give points in between."
    )


def step_by_angle(bound: TwistBound, memory: TwistMemory, press: PressedState, twist: float) -> TorsionStep:
    """Return the springs after load and angle have changed in proportion, on bounds of any curvature.

    Where a bound is not a concave function of the load, a spring that slides may stick again while both change: the
    step is then cut until the torque settles.

    Raises
    ------
    NotConverged
        If the torque, or the loss, does not settle.
    """
    press = _settled(memory.press, press)
    if twist == 0.0 or press == memory.press or bound.concave:
        return torsion_step(bound, memory, press, twist)
    old: TorsionStep | None = None
    bears = max(bound.most(max(memory.press, press, key=lambda each: each.radius)), 1e-300)
    for halving in range(1, MOST_CUTS + 1):
        now, loss, work, nested = memory, 0.0, 0.0, True
        for step, share in _path(bound, memory.press, press, 2**halving):
            work += stuck_work(bound, now, step, twist * share)
            move = moved(bound, now, step, twist * share)
            now, nested = move.memory, nested and move.nested
            loss, work = loss + move.loss, work + move.extra
        new = TorsionStep(now, twist, loss, work, nested)
        change = abs(torque_of(bound, new.memory) - torque_of(bound, old.memory)) if old else math.inf
        if old and change <= CUT_TOLERANCE * bears:
            return new._replace(loss=loss + (loss - old.loss) / 3.0, work=work + (work - old.work) / 3.0)
        old = new
    raise NotConverged(
        f"{bound.owner}: the {bound.load} does not settle while the normal load changes from {memory.level:.6g} to "
        f"{press.level:.6g}; give points in between, or prescribe the Force."
    )


def step_to_torque(bound: TwistBound, memory: TwistMemory, press: PressedState, torque: float) -> TorsionStep:
    """Return the springs after load and torque have changed in proportion.

    Raises
    ------
    OutsideValidity
        If the contact cannot bear the torque.
    NotConverged
        If the angle does not settle.
    """
    press = _settled(memory.press, press)
    if press == memory.press:
        return _step_to(bound, memory, press, torque)
    start = torque_of(bound, memory)
    angle, size = _scales(bound, memory, press, torque)
    old: TorsionStep | None = None
    best = 0.0
    for halving in range(MOST_HALVINGS + 1):
        now, twist, loss, work, nested, done, rate = memory, 0.0, 0.0, 0.0, True, 0.0, 0.0
        for step, share in _path(bound, memory.press, press, 2**halving):
            done = min(done + share, 1.0)
            aim = torque if step == press else start + (torque - start) * done
            part = _step_to(bound, now, step, aim, rate * share)
            rate = part.twist / share
            now, twist, nested = part.memory, twist + part.twist, nested and part.nested
            loss, work = loss + part.loss, work + part.work
        new = TorsionStep(now, twist, loss, work, nested)
        if old is None:
            old, best = new, new.loss
            continue
        better = new.loss + (new.loss - old.loss) / 3.0
        if abs(new.twist - old.twist) <= ANGLE_TOLERANCE * angle and abs(better - best) <= ANGLE_TOLERANCE * (
            size + new.loss
        ):
            return new._replace(loss=max(better, 0.0), work=new.work + (new.work - old.work) / 3.0)
        old, best = new, better
    raise NotConverged(
        f"{bound.owner}: the {bound.motion} under {torque:.6g} {bound.unit} does not settle while the "
        f"normal load changes from {memory.level:.6g} to {press.level:.6g}; give points in between."
    )


def _settled(before: PressedState, press: PressedState) -> PressedState:
    """Return the load as it was, if only the rounding of its radius has changed."""
    return before if (press.level, press.excess) == (before.level, before.excess) else press


def _scales(bound: TwistBound, memory: TwistMemory, press: PressedState, torque: float) -> tuple[float, float]:
    """Return a twist [Pa] and 4 G_t times an energy by which errors are measured: what the wider contact bears."""
    wider = max(memory.press, press, key=lambda each: each.radius)
    if wider.radius == 0.0:
        return 1.0, 1.0
    stored = square(bound, memory)
    stiffness = bound.inertia(wider.radius)
    bears = max(abs(torque), (stiffness * stored) ** 0.5) if bound.endless else bound.most(wider)
    return bears / stiffness, 0.25 * bears**2 / stiffness + 0.5 * stored


def _path(bound: TwistBound, first: PressedState, last: PressedState, parts: int) -> list[tuple[PressedState, float]]:
    """Return loads between two, and which share of the change each brings; even in the radius, then beyond the rim."""
    change = last.level - first.level
    shares = np.arange(parts + 1) / parts
    steps: list[PressedState] = []
    start = first
    for corner in [*_corners(bound, first, last), last]:
        if corner.radius != start.radius:
            radii = start.radius + (corner.radius - start.radius) * shares[1:-1]
            steps += [
                PressedState(*each, 0.0) for each in zip(bound.level(radii).tolist(), radii.tolist(), strict=True)
            ]
        else:
            levels = start.level + (corner.level - start.level) * shares[1:-1]
            ahead = start.excess + (corner.excess - start.excess) * shares[1:-1]
            rows = zip(levels.tolist(), ahead.tolist(), strict=True)
            steps += [PressedState(level, start.radius, excess) for level, excess in rows]
        steps.append(corner)
        start = corner
    path, before = [], first
    for step in steps:  # where the body is flat the radius grows at no load
        if min(before.level, last.level) < step.level < max(before.level, last.level) or step is last:
            path.append((step, (step.level - before.level) / change))
            before = step
    return path


def _corners(bound: TwistBound, first: PressedState, last: PressedState) -> list[PressedState]:
    """Return the load at which the contact fills the body, if it lies between."""
    rim = max(first.radius, last.radius)
    if first.radius == last.radius or max(first.excess, last.excess) == 0.0:
        return []
    return [PressedState(float(bound.level(np.array([rim]))[0]), rim, 0.0)]


def _step_to(
    bound: TwistBound, memory: TwistMemory, press: PressedState, torque: float, guess: float = 0.0
) -> TorsionStep:
    """Return the step that ends at a torque, on a straight line in the angle, which is sought from `guess` on."""
    limit = bound.most(press)
    torque = bound.borne(torque, limit)
    most = limit * (1.0 - TORQUE_MARGIN)
    if bound.slides and most < abs(torque) <= limit:
        guess = 0.0  # from below the smallest motion is found under which all slides
    elif abs(torque) > most:
        reaches = "exceeds" if bound.slides else "reaches or exceeds"
        raise OutsideValidity(
            f"the {bound.load} of {torque:.6g} {bound.unit} {reaches} what friction bears, {limit:.6g} "
            f"{bound.unit} under this normal load: the bodies would {bound.free_motion} against each other; give a "
            f"smaller {bound.load}, a greater load, or prescribe the {bound.motion.capitalize()}."
        )
    slack = TORQUE_TOLERANCE * (abs(torque) if bound.endless else limit)
    twist, low, high = guess, -math.inf, math.inf

    def trial_(move: TwistMove) -> TorsionStep:
        work = stuck_work(bound, memory, press, twist) + move.extra
        return TorsionStep(move.memory, twist, move.loss, work, move.nested)

    low_miss = high_miss = 0.0
    for tried in range(MOST_TRIALS):
        move = moved(bound, memory, press, twist)
        miss = torque_of(bound, move.memory) - torque
        if abs(miss) <= slack or (low < high and math.nextafter(low, high) >= high):
            return trial_(move)
        if miss < 0.0:
            low, low_miss = twist, miss
        else:
            high, high_miss = twist, miss
        stiffness = move.free if move.free > 0.0 else bound.inertia(press.radius)
        ahead = twist - miss / stiffness
        if math.isfinite(low) and math.isfinite(high) and not (low < ahead < high and tried % 4 != 3):
            share = -low_miss / (high_miss - low_miss) if tried % 2 else 0.5
            ahead = low + (high - low) * min(max(share, 0.01), 0.99)
        if ahead == twist:
            return trial_(move)
        twist = ahead
    raise NotConverged(
        f"{bound.owner}: the {bound.motion} under {torque:.6g} {bound.unit} was not found in {MOST_TRIALS} tries."
    )
