"""A contact whose rings slide, followed along a path: what a twist and a push on coatings have in common."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from winkler.errors import OutsideValidity
from winkler.foundation.bed import Bed
from winkler.foundation.torsion_bound import PressedState, TwistBound
from winkler.loading import Angle, Depth, Shift
from winkler.numerics.types import Array
from winkler.path import Path
from winkler.problems.friction.torsion_march import (
    TorsionStep,
    square,
    step_by_angle,
    step_to_torque,
    torque_of,
    torsion_step,
)
from winkler.problems.friction.torsion_pieces import TwistMemory, fresh, pieces_of
from winkler.problems.normal.solve_contact import at_depth, at_force

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
    bound = bound_of(bed, coefficient, widest if widest > 0.0 else 1.0, forced)
    excess = np.where(radius >= bed.rim, depth - bed.gap(radius), 0.0)
    rows = (path.across, radius, np.maximum(excess, 0.0))
    presses = [PressedState(*row) for row in zip(*(each.tolist() for each in rows), strict=True)]
    memory = torsion_step(bound, fresh(min(presses[0].level, 0.0)), presses[0], 0.0).memory
    motion = lost = work = 0.0
    moved = isinstance(path.lateral, Angle | Shift)
    for i, (press, target) in enumerate(zip(presses, path.along.tolist(), strict=True)):
        if moved:
            step = step_by_angle(bound, memory, press, unit * (target - motion))
        else:
            step = _to_load(bound, memory, press, target, i)
        memory = step.memory
        lost, work = lost + 2.0 * step.loss / unit, work + 2.0 * step.work / unit
        motion = target if moved else motion + step.twist / unit
        yield RingPoint(
            time=float(path.time[i]),
            depth=float(depth[i]),
            force=float(force[i]),
            radius=press.radius,
            motion=motion,
            load=torque_of(bound, memory),
            limit=bound.most(press),
            stick_radius=_stick_radius(memory),
            work=work,
            stored=square(bound, memory) / unit,
            lost=lost,
            nested=step.nested,
            bound=bound,
            memory=memory,
        )


def _pressed(bed: Bed, path: Path, forced: bool) -> tuple[Array, Array, Array]:
    """Return depths, forces and radii along the path."""
    across = path.across
    depth, radius = at_force(bed, across) if forced else at_depth(bed, across)
    force = across if forced else bed.stiffness(radius) * depth - bed.gap_load(radius)
    return depth, np.where(radius > 0.0, force, 0.0), radius


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
