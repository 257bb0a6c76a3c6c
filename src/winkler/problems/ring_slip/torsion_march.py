r"""One step of a twisted contact: along a straight line in the normal load and the angle, or the torque.

Under a prescribed angle one move along the line is exact, however long; only the loss depends on the path, if load and
angle change together and something slides: it is then summed over ever shorter moves.  Under a prescribed torque the
angle is sought that it needs at the end of the line.  Paths are followed by `winkler.problems.ring_slip.ring_path`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.foundation.torsion_bound import PressedState, TwistBound
from winkler.numerics.equations.driven import driven
from winkler.problems.ring_slip.torsion_memory import TwistAhead, TwistCut, TwistMove, slid_along, stuck_work
from winkler.problems.ring_slip.torsion_pieces import TwistMemory
from winkler.values.errors import NotConverged, OutsideValidity

LOSS_TOLERANCE = 1e-8
"""Tolerance of the energy lost in a step, relative to the energy stored in it and lost in it."""
MOST_HALVINGS = 13
"""How often the moves of a step are halved at most."""
TORQUE_MARGIN = 1e-12
"""Part of the greatest torque that stays unreachable."""
TORQUE_TOLERANCE = 1e-12
"""Part of the greatest torque by which a prescribed one may be missed."""


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
    for piece in memory.pieces:
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
    for piece in memory.pieces:
        sample = bound.panels.sample(piece.low, piece.high)
        total += float(np.sum(sample.weights * bound.weigh(sample) * sample.read(piece.values(bound)) ** 2))
    return total


def torsion_step(bound: TwistBound, memory: TwistMemory, press: PressedState, twist: float) -> TorsionStep:
    """Return the springs after load and angle have changed in proportion."""
    press = unrounded(memory.press, press)
    whole = _whole(bound, memory, press, twist)
    stuck = stuck_work(bound, memory, press, twist)
    loss, extra = slid_along(bound, memory, [press], twist, whole.rings)
    if loss == 0.0 or press == memory.press:
        return TorsionStep(whole.memory, twist, loss, stuck + extra, whole.nested)
    stored = [square(bound, each) for each in (memory, whole.memory)]
    if twist == 0.0:  # nothing is put in: what is lost was stored
        return TorsionStep(whole.memory, twist, max(0.5 * (stored[0] - stored[1]), 0.0), 0.0, whole.nested)
    rough = best = loss
    for halving in range(1, MOST_HALVINGS + 1):
        path = presses_between(bound, memory.press, press, 2**halving)
        fine, work = slid_along(bound, memory, path, twist, whole.rings)
        better, rough = fine + (fine - rough) / 3.0, fine
        settled, extra = work + (work - extra) / 3.0, work
        if abs(better - best) <= LOSS_TOLERANCE * (0.5 * max(stored) + fine):
            return TorsionStep(whole.memory, twist, max(better, 0.0), stuck + settled, whole.nested)
        best = better
    raise NotConverged(
        f"{bound.owner}: the energy lost between the normal loads {memory.press.level:.6g} and {press.level:.6g} does "
        "not converge; give points in between."
    )


def _whole(bound: TwistBound, memory: TwistMemory, press: PressedState, twist: float) -> TwistMove:
    ahead = TwistAhead(bound, memory, press)
    return ahead.moved(ahead.cuts(twist), twist)


def trapezoid(
    bound: TwistBound, memory: TwistMemory, press: PressedState, twist: float, move: TwistMove | None = None
) -> TorsionStep:
    """Return what a move does, its loss and work as if bounds changed in proportion: of second order in its length."""
    move = move or _whole(bound, memory, press, twist)
    loss, extra = slid_along(bound, memory, [press], twist, move.rings)
    return TorsionStep(move.memory, twist, loss, stuck_work(bound, memory, press, twist) + extra, move.nested)


def unrounded(before: PressedState, press: PressedState) -> PressedState:
    """Return the load as it was, if only the rounding of its radius has changed."""
    return before if (press.level, press.excess) == (before.level, before.excess) else press


def presses_between(bound: TwistBound, first: PressedState, last: PressedState, parts: int) -> list[PressedState]:
    """Return loads from one to another, without the first; even in the radius, then beyond the rim."""
    shares = np.arange(1, parts) / parts
    steps: list[PressedState] = []
    start = first
    for corner in [*_corners(bound, first, last), last]:
        if corner.radius != start.radius:
            radii = start.radius + (corner.radius - start.radius) * shares
            steps += [
                PressedState(*each, 0.0) for each in zip(bound.level(radii).tolist(), radii.tolist(), strict=True)
            ]
        else:
            levels = start.level + (corner.level - start.level) * shares
            ahead = start.excess + (corner.excess - start.excess) * shares
            rows = zip(levels.tolist(), ahead.tolist(), strict=True)
            steps += [PressedState(level, start.radius, excess) for level, excess in rows]
        steps.append(corner)
        start = corner
    path, before = [], first
    for step in steps:  # where the body is flat the radius grows at no load
        if min(before.level, last.level) < step.level < max(before.level, last.level) or step is last:
            path.append(step)
            before = step
    return path


def _corners(bound: TwistBound, first: PressedState, last: PressedState) -> list[PressedState]:
    """Return the load at which the contact fills the body, if it lies between."""
    rim = max(first.radius, last.radius)
    if first.radius == last.radius or max(first.excess, last.excess) == 0.0:
        return []
    return [PressedState(float(bound.level(np.array([rim]))[0]), rim, 0.0)]


def step_to(
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
            f"the {bound.load} of {torque:.6g} {bound.unit} {reaches} the friction limit, {limit:.6g} "
            f"{bound.unit} under this normal load: the bodies would {bound.free_motion} against each other; give "
            f"a smaller {bound.load}, a greater load, or prescribe the {bound.motion.capitalize()}."
        )
    slack = TORQUE_TOLERANCE * (abs(torque) if bound.endless else limit)
    springs, cuts = TwistAhead(bound, memory, press), list[TwistCut]()

    def borne(twist: float) -> tuple[float, float]:
        nonlocal cuts
        cuts = springs.cuts(twist)
        free = springs.free(cuts)
        return springs.load(cuts, twist), free if free > 0.0 else bound.inertia(press.radius)

    twist = driven(borne, torque, guess, slack)
    if twist is None:
        raise NotConverged(f"{bound.owner}: the {bound.motion} under {torque:.6g} {bound.unit} was not found.")
    return trapezoid(bound, memory, press, twist, springs.moved(cuts, twist))
