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
    gaps = np.maximum([(moment.depth, moment.stuck) for moment in moments], 0.0)
    radii = at_depth(bed, gaps.ravel())[1].reshape(-1, 2)
    states: list[ImpactState] = []
    for time, moment, (depth, _), (radius, stick) in zip(
        times.tolist(), moments, gaps.tolist(), radii.tolist(), strict=True
    ):
        quantities = {**moment._asdict(), "depth": depth}
        del quantities["stuck"]
        states.append(
            ImpactState(
                time=time,
                radius=radius,
                stick_radius=min(stick, radius),
                side=begun[-1].side,
                stages=() if states else begun,
                duration=duration,
                **quantities,
            )
        )
    return states


def _parted(end: ImpactMoment) -> ImpactMoment:
    """Return the moment after the last springs have parted: what they still stored is lost."""
    nothing = dict.fromkeys(("depth", "force", "shear_force", "energy", "stored_energy", "stuck"), 0.0)
    return end._replace(dissipation=end.dissipation + end.stored_energy, **nothing)


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
