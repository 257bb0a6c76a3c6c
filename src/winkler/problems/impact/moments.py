"""The states of an impact at evenly spaced moments, computed from its stages, or from a march of rings."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from winkler.foundation.bed import Bed
from winkler.numerics.types import Array
from winkler.problems.impact.march import stages
from winkler.problems.impact.motion import ImpactMoment, ImpactProblem, turning
from winkler.problems.impact.ring_march import RingMarch, march_rings
from winkler.problems.impact.states import ImpactStage, ImpactState
from winkler.problems.normal.solve_contact import at_depth
from winkler.problems.ring_slip.ring_table import RingTable

__all__ = ["joined_stages", "ring_states", "states_along"]

SHORTEST_STAGE = 0.01
"""Part of the duration that a stage of rings lasts at least: at the edge single steps stick and slide by turns."""


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


def ring_states(bed: Bed, motion: ImpactProblem, table: RingTable, count: int) -> Iterator[ImpactState]:
    """Yield the state at `count` moments, of rings that slide."""
    march = march_rings(motion, table, count)
    end = float(march.time[-1])
    times = np.linspace(0.0, end, count)
    words = ("depth", "velocity", "shift", "sliding", "shear", "stored", "lost", "stick")
    columns = [np.interp(times, march.time, getattr(march, word)) for word in words]
    every, sides = _ring_stages(march)
    starts = [stage.start for stage in every]
    known = np.searchsorted(starts, times, side="left")
    known[0], known[-1] = 1, len(starts)
    radii = at_depth(bed, columns[0])[1]
    before = 0
    for i, row in enumerate(zip(*(column.tolist() for column in columns), strict=True)):
        depth, velocity, shift, sliding, shear, kept, lost, stick = row
        _, force, pressed = motion.curve.at(depth) if depth > 0.0 else (0.0, 0.0, 0.0)
        radius = float(radii[i])
        yield ImpactState(
            time=float(times[i]),
            depth=depth,
            shift=shift,
            velocity=velocity,
            sliding_velocity=sliding,
            force=force,
            shear_force=shear,
            radius=radius,
            stick_radius=min(stick, radius),
            energy=pressed,
            stored_energy=kept,
            dissipation=lost,
            side=int(sides[min(max(int(np.searchsorted(march.time, times[i])) - 1, 0), sides.size - 1)]),
            stages=tuple(every[before : int(known[i])]),
            duration=end,
        )
        before = max(before, int(known[i]))


def _ring_stages(march: RingMarch) -> tuple[list[ImpactStage], NDArray[np.int_]]:
    """Return the stages, and the side of every step; what lasts a few steps at the edge counts to what was before."""
    sides = march.side.copy()
    turns = [0, *(np.flatnonzero(np.diff(sides)) + 1).tolist(), sides.size]
    for first, last in pairwise(turns):
        if first > 0 and last - first < SHORTEST_STAGE * sides.size:
            sides[first:last] = sides[first - 1]
    turns = [0, *(np.flatnonzero(np.diff(sides)) + 1).tolist(), sides.size]
    stages = [
        ImpactStage(float(march.time[first]), float(march.time[last]), int(sides[first]))
        for first, last in pairwise(turns)
    ]
    return stages, sides


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
