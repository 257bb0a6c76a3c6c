"""The states of an impact at evenly spaced moments, computed from its stages."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from winkler.foundation.bed import Bed
from winkler.numerics.types import Array
from winkler.problems.impact.march import stages
from winkler.problems.impact.motion import ImpactMoment, ImpactProblem, turning
from winkler.problems.impact.states import ImpactStage, ImpactState
from winkler.problems.normal.solve_contact import at_depth

__all__ = ["joined_stages", "states_along"]


def states_along(bed: Bed, motion: ImpactProblem, count: int) -> Iterator[ImpactState]:
    """Yield the state at `count` moments, evenly spaced from first touch to the end of contact."""
    turn = turning(motion)
    times = np.linspace(0.0, 2.0 * turn, count)
    done, begun = 0, tuple[ImpactStage, ...]()
    for stage in stages(motion, turn):
        begun = (*begun, ImpactStage(stage.start, stage.end, stage.sign))
        stop = int(np.searchsorted(times, stage.end, side="right"))
        requested = times[done:stop]
        moments = [stage.moment(time) for time in requested.tolist()]
        if stop == count:
            moments[-1] = _parted(moments[-1])
        if moments:
            yield from _states_at(bed, requested, moments, begun, 2.0 * turn)
            done, begun = stop, ()


def _states_at(
    bed: Bed, times: Array, moments: list[ImpactMoment], begun: tuple[ImpactStage, ...], duration: float
) -> list[ImpactState]:
    gaps = np.array([(max(moment.depth, 0.0), max(moment.stuck, 0.0)) for moment in moments])
    _, radii = at_depth(bed, gaps.ravel())
    return [
        ImpactState(
            time=time,
            depth=depth,
            shift=moment.shift,
            velocity=moment.velocity,
            sliding_velocity=moment.sliding,
            force=moment.force,
            shear_force=moment.shear,
            radius=radius,
            stick_radius=min(stick, radius),
            energy=moment.pressed,
            stored_energy=moment.stored,
            dissipation=moment.loss,
            side=begun[-1].side,
            stages=() if place else begun,
            duration=duration,
        )
        for place, (time, moment, (depth, _), (radius, stick)) in enumerate(
            zip(times.tolist(), moments, gaps.tolist(), radii.reshape(-1, 2).tolist(), strict=True)
        )
    ]


def _parted(end: ImpactMoment) -> ImpactMoment:
    """Return the moment after the last springs have parted: what they still stored is lost."""
    loss = end.loss + end.stored
    return end._replace(depth=0.0, loss=loss, force=0.0, shear=0.0, pressed=0.0, stored=0.0, stuck=0.0)


def joined_stages(parts: list[ImpactStage], last: float) -> tuple[ImpactStage, ...]:
    """Return the stages up to a time [s], those of one side after the other as one."""
    joined: list[ImpactStage] = []
    for stage in parts:
        end = min(stage.end, last)
        if joined and stage.side == joined[-1].side:
            joined[-1] = ImpactStage(joined[-1].start, end, stage.side)
        else:
            joined.append(ImpactStage(stage.start, end, stage.side))
    return tuple(joined)
