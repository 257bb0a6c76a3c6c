"""A contact whose rings slide, followed along a path: what a twist and a push on coatings have in common."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from winkler.errors import OutsideValidity
from winkler.foundation.bed import Bed
from winkler.foundation.torsion_bound import PressedState, TwistBound
from winkler.loading import Angle, Depth, Shift
from winkler.media.offers import TwistedWaves, offers
from winkler.numerics.types import Array
from winkler.path import Path
from winkler.problems.normal.solve_contact import at_depth, at_force
from winkler.problems.ring_slip.steady_path import HistoryPoint, falls, steady_points
from winkler.problems.ring_slip.torsion_march import (
    TORQUE_MARGIN,
    TorsionStep,
    square,
    step_by_angle,
    step_to_torque,
    torque_of,
    torsion_step,
)
from winkler.problems.ring_slip.torsion_pieces import TwistMemory, fresh, pieces_of

__all__ = ["RingPoint", "ring_points"]

LEVEL_TOLERANCE = 1e-12
"""Part of the level by which two contacts may differ whose bounds are the same."""


class RingPoint(NamedTuple):
    """The contact at a point of a path.

    `motion` is the angle [rad] or shift [m], `load` what it takes [N m] or [N], `limit` what friction bears at most;
    work, stored energy and dissipation in J.
    """

    time: float
    depth: float
    force: float
    radius: float
    motion: float
    load: float
    limit: float
    stick_radius: float
    work: float
    stored: float
    lost: float
    nested: bool
    bound: TwistBound
    memory: TwistMemory


def ring_points(
    bed: Bed, coefficient: float, path: Path, unit: float, bound_of: Callable[[Bed, float, float, bool], TwistBound]
) -> Iterator[RingPoint]:
    """Yield the contact at every point of a path.

    Parameters
    ----------
    bed : Bed
    coefficient : float
        mu [-].
    path : Path
    unit : float
        What a stuck spring bears over its motion: 8 G_t of a twist [Pa], G* of a push [Pa].
    bound_of : callable
        Returns the bound of bed, coefficient, widest radius [m], and whether the force is prescribed.

    Raises
    ------
    OutsideValidity
        If friction does not bear a prescribed load, at that point.
    NotConverged
        If a step is too long.
    """
    forced = not isinstance(path.normal, Depth)
    depth, force, radius = _pressed(bed, path, forced)
    widest = float(np.max(radius))
    bound = bound_of(bed, coefficient, widest if widest > 0.0 else _own_length(bed), forced)
    excess = np.where(radius >= bed.rim, depth - bed.gap(radius), 0.0)
    rows = (path.across, radius, np.maximum(excess, 0.0))
    presses = [PressedState(*row) for row in zip(*(each.tolist() for each in rows), strict=True)]
    moved = isinstance(path.lateral, Angle | Shift)
    targets = [unit * each if moved else each for each in path.along.tolist()]
    history = _steady if all(each == presses[0] for each in presses) and falls(bound, presses[0]) else _marched
    for i, point in enumerate(history(bound, presses, targets, moved)):
        yield RingPoint(
            time=float(path.time[i]),
            depth=float(depth[i]),
            force=float(force[i]),
            radius=presses[i].radius,
            motion=float(path.along[i]) if moved else point.motion / unit,
            load=point.load,
            limit=bound.most(presses[i]),
            stick_radius=point.stick_radius,
            work=2.0 * point.work / unit,
            stored=point.stored / unit,
            lost=2.0 * point.lost / unit,
            nested=point.nested,
            bound=bound,
            memory=point.memory,
        )


def _own_length(bed: Bed) -> float:
    """Return a radius [m] for the tables of bodies that never touch; of no effect where the body has no length."""
    return float(bed.medium.response.length) if offers(bed.medium, TwistedWaves) else 1.0


def _pressed(bed: Bed, path: Path, forced: bool) -> tuple[Array, Array, Array]:
    """Return depths, forces and radii along the path."""
    across = path.across
    pressed = across[:1] if np.all(across == across[0]) else across  # a steady load is solved once
    depth, radius = at_force(bed, pressed) if forced else at_depth(bed, pressed)
    depth, radius = np.broadcast_to(depth, across.shape), np.broadcast_to(radius, across.shape)
    force = across if forced else bed.stiffness(radius) * depth - bed.gap_load(radius)
    return depth, np.where(radius > 0.0, force, 0.0), radius


def _steady(
    bound: TwistBound, presses: list[PressedState], targets: list[float], moved: bool
) -> Iterator[HistoryPoint]:
    """Yield the points of a path under a steady load, all at once."""
    press = presses[0]
    limit = bound.most(press)
    most = limit if bound.slides else limit * (1.0 - TORQUE_MARGIN)
    targets = targets if moved else [bound.borne(each, limit) for each in targets]
    borne = len(targets) if moved else next((i for i, each in enumerate(targets) if abs(each) > most), len(targets))
    points = steady_points(bound, press, targets[:borne], not moved)
    yield from points
    if borne < len(targets):
        memory = points[-1].memory if points else torsion_step(bound, fresh(), press, 0.0).memory
        _to_load(bound, memory, press, targets[borne], borne)  # refuses


def _marched(
    bound: TwistBound, presses: list[PressedState], targets: list[float], moved: bool
) -> Iterator[HistoryPoint]:
    """Yield the points of a path one after the other."""
    memory = torsion_step(bound, fresh(min(presses[0].level, 0.0)), presses[0], 0.0).memory
    motion = lost = work = 0.0
    for i, (press, target) in enumerate(zip(presses, targets, strict=True)):
        if moved:
            step = step_by_angle(bound, memory, press, target - motion)
        else:
            step = _to_load(bound, memory, press, target, i)
        memory = step.memory
        lost, work = lost + step.loss, work + step.work
        motion = target if moved else motion + step.twist
        at = (motion, torque_of(bound, memory), _stick_radius(memory))
        yield HistoryPoint(*at, work, square(bound, memory), lost, step.nested, memory)


def _to_load(bound: TwistBound, memory: TwistMemory, press: PressedState, target: float, index: int) -> TorsionStep:
    try:
        return step_to_torque(bound, memory, press, target)
    except OutsideValidity as error:
        raise OutsideValidity(f"{bound.owner}: at index {index} of the path {error}") from None


def _stick_radius(memory: TwistMemory) -> float:
    """Return the radius up to which no spring is at the bound of the contact as it is."""
    for piece in pieces_of(memory):
        same = abs(piece.bound.level - memory.level) <= LEVEL_TOLERANCE * abs(memory.level)
        if piece.side != 0.0 and piece.held == 0.0 and piece.entered == 0.0 and same:
            return piece.low
    return memory.radius
