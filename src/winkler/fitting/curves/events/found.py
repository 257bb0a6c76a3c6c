"""The events of a curve, in the order in which they began."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.directions import OUT
from winkler.fitting.curves.events.clock import ClockOffset, clock_offset_of, is_certain
from winkler.fitting.curves.events.free import FEWEST_FREE, FreeBranch, FreeParts, free_parts
from winkler.fitting.curves.events.interference import Interference, interference_of
from winkler.fitting.curves.events.kinds import CurveEvent, CurveEvents, EventKind, confidence_of, with_error
from winkler.fitting.curves.events.popins import pop_ins
from winkler.fitting.curves.events.record import Record, deviation, moving_mean
from winkler.fitting.curves.events.saturation import saturated_rows
from winkler.fitting.curves.events.stated import FREE, MARKS, NOTHING
from winkler.fitting.curves.events.steps import found_steps
from winkler.fitting.curves.segments import Segment, SegmentKind
from winkler.numerics.types import Array
from winkler.values.readable import with_unit

KEPT_FREE_SHARE = 0.92
"""Part of the free travel in which interference and drag are sought: attraction bends the rest."""
LEAST_DRAG_RATIO = 6.0
KINDS = {kind: EventKind(kind.value) for kind in SegmentKind}


def free_points(record: Record) -> tuple[Array, Array]:
    """Return the points out of contact before and after it, as indices: those stated, else those found."""
    stated = np.flatnonzero(record.marks == FREE)
    if stated.size:
        touched = np.flatnonzero(record.marks != FREE)
        middle = touched[0] if touched.size else record.length
        return stated[stated < middle], stated[stated >= middle]
    parts = free_parts(record)
    return parts.before_points, parts.after_points


def kept_points(record: Record) -> tuple[Array, Array]:
    """Return the free points before and after contact without those next to it, unless they are stated."""
    before, after = free_points(record)
    if np.any(record.marks == FREE):
        return before, after
    return before[: int(KEPT_FREE_SHARE * before.size)], after[after.size - int(KEPT_FREE_SHARE * after.size) :]


def interference_in(record: Record) -> Interference | None:
    """Return the interference in the free points; None if there is none."""
    return interference_of([(record.position[part], record.force[part]) for part in kept_points(record) if part.size])


def drag_in(record: Record) -> Drag | None:
    """Return the drag; None with fewer than ten free points in either direction."""
    free = np.concatenate(kept_points(record))
    free = free[record.direction[free] != 0.0]
    moving = record.direction[free]
    if min(np.count_nonzero(moving > 0.0), np.count_nonzero(moving < 0.0)) < FEWEST_FREE:
        return None
    order = record.time[free] if record.timed else free.astype(float)
    return drag_of(order, record.position[free], record.force[free], moving)


def clock_offset_in(record: Record) -> ClockOffset | None:
    """Return the time by which the force is late; None where no edge determines it."""
    contact = np.ones(record.length, dtype=bool)
    contact[np.concatenate(free_points(record))] = False
    return clock_offset_of(record, contact)


def events_of(record: Record) -> CurveEvents:
    """Return the events of a curve; those that are stated are not sought."""
    stated = bool(record.marks.size)
    if stated and not np.any(record.marks != NOTHING):
        return _ordered(_segment_events(record))
    interference = interference_in(record)
    plain = record
    if interference is not None:  # what else happened is sought without it
        plain = record._replace(force=record.force - interference.at(record.position))
    free = free_points(plain)
    events = [*_segment_events(record), *_baselines(plain, free)]
    events += _stated(plain) if stated else _happened(plain, free_parts(plain))
    events += _saturations(record, free)
    if interference is not None:
        events.append(_interference_event(record, interference))
    offset = clock_offset_in(plain)
    if offset is not None and is_certain(offset, plain):
        events.append(_clock_event(offset))
    drag = drag_in(plain)
    if drag is not None and drag.force > LEAST_DRAG_RATIO * drag.error:
        events.append(_drag_event(drag, free))
    return _ordered(events)


def _interference_event(record: Record, found: Interference) -> CurveEvent:
    points = np.concatenate(kept_points(record))
    size = found.amplitude, found.amplitude_error, "N", found.confidence
    remark = f"period {with_error(found.period, found.period_error, 'm')}"
    return CurveEvent(EventKind.INTERFERENCE, int(points.min()), int(points.max()), *size, remark)


def _clock_event(found: ClockOffset) -> CurveEvent:
    count = len(found.edges)
    remark = f"by {count} edges of the motion" if count > 1 else "by one edge of the motion"
    size = found.offset, found.error, "s", confidence_of(found.ratio, count)
    return CurveEvent(EventKind.CLOCK_OFFSET, found.edges[0], found.edges[-1], *size, remark)


def _drag_event(found: Drag, free: tuple[Array, Array]) -> CurveEvent:
    points = np.concatenate(free)
    remark = f"beside a drift of {with_unit(found.drift, 'N')}" if found.drift else ""
    confidence = confidence_of(found.force / found.error if found.error > 0.0 else 40.0, 1)
    size = found.force, found.error, "N", confidence
    return CurveEvent(EventKind.DRAG, int(points.min()), int(points.max()), *size, remark)


def _ordered(events: list[CurveEvent]) -> CurveEvents:
    order = list(EventKind)
    return CurveEvents(sorted(events, key=lambda event: (event.first, order.index(event.kind))))


def _segment_events(record: Record) -> list[CurveEvent]:
    return [_segment_event(record, segment) for segment in record.segments]


def _segment_event(record: Record, segment: Segment) -> CurveEvent:
    """Return the event of a segment; it begins at the last point of the one before."""
    before, last = max(segment.first - 1, 0), segment.last
    force = float(record.force[last] - record.force[before])
    travel = float(record.position[last] - record.position[before])
    kind = KINDS[segment.kind]
    ends = segment.first, segment.last
    if segment.kind is not SegmentKind.HOLD:
        return CurveEvent(kind, *ends, force, unit="N", remark=f"position by {with_unit(travel, 'm')}")
    level = with_unit(float(np.median(record.force[segment.first : last + 1])), "N")
    remark = f"at {level}, position by {with_unit(travel, 'm')}, force by {with_unit(force, 'N')}"
    if not record.timed:
        return CurveEvent(kind, *ends, float(segment.count), remark=remark)
    duration = float(record.time[last] - record.time[before])
    return CurveEvent(kind, *ends, duration, unit="s", remark=remark)


def _baselines(record: Record, free: tuple[Array, Array]) -> list[CurveEvent]:
    events = []
    for kind, points in zip((EventKind.BASELINE_BEFORE, EventKind.BASELINE_AFTER), free, strict=True):
        if points.size > 1:
            along = np.arange(points.size)
            force = record.force[points]
            left = force - np.polyval(np.polyfit(along, force - force.mean(), 1), along) - force.mean()
            remark = f"noise {with_unit(float(np.sqrt(left @ left / max(points.size - 2, 1))), 'N')}"
            travel = float(np.ptp(record.position[points]))
            events.append(CurveEvent(kind, int(points[0]), int(points[-1]), travel, unit="m", remark=remark))
    return events


def _happened(record: Record, parts: FreeParts) -> list[CurveEvent]:
    """Return snap-in, pop-ins and pull-off as they are found."""
    events = []
    going, coming = record.incoming, record.outgoing
    first = going.start + parts.before.points
    if (snap := tension(record.force[going], parts.before)) is not None and parts.before.points < going.stop:
        ends = going.start + snap.first, going.start + snap.last
        first = max(first, ends[1] + 1)
        confidence = confidence_of(snap.size / snap.error if snap.error else 40.0, parts.before.points)
        remark = "sudden" if snap.sudden else "gradual"
        events.append(CurveEvent(EventKind.SNAP_IN, *ends, snap.size, snap.error, "N", confidence, remark))
    for each in pop_ins(record, first):
        confidence = confidence_of(min(each.ratio, 40.0), record.length)
        remark = f"at {with_unit(float(record.force[each.place - 1]), 'N')}"
        ends = each.place - 1, each.place
        events.append(CurveEvent(EventKind.POP_IN, *ends, each.size, each.error, each.unit, confidence, remark))
    if (pull := tension(record.force[coming][::-1], parts.after)) is not None:
        ends = coming.stop - 1 - pull.last, coming.stop - 1 - pull.first
        confidence = confidence_of(pull.size / pull.error if pull.error else 40.0, parts.after.points)
        remark = "sudden" if pull.sudden else "gradual"
        events.append(CurveEvent(EventKind.PULL_OFF, *ends, pull.size, pull.error, "N", confidence, remark))
    return events


def _stated(record: Record) -> list[CurveEvent]:
    """Return the events that are stated, with the sizes that the curve shows there."""
    events = []
    names = {mark: EventKind(name) for name, mark in MARKS.items() if mark != FREE}
    turns = np.flatnonzero(np.diff(record.marks)) + 1
    for part in np.split(np.arange(record.length), turns):
        kind = names.get(float(record.marks[part[0]]))
        if kind is None:
            continue
        first, last = int(part[0]), int(part[-1])
        ends = [max(first - 1, 0), last]
        force, travel = (float(np.diff(column[ends])[0]) for column in (record.force, record.position))
        if kind is EventKind.POP_IN:
            size, unit = (-force, "N") if force < 0.0 else (travel, "m")
        else:
            level = float(np.median(record.force[free])) if (free := _next_free(record, kind)).size else 0.0
            size, unit = level - float(record.force[part].min()), "N"
        events.append(CurveEvent(kind, first, last, size, unit=unit, remark="stated"))
    return events


def _next_free(record: Record, kind: EventKind) -> Array:
    before, after = free_points(record)
    return before if kind is EventKind.SNAP_IN else after


def _saturations(record: Record, free: tuple[Array, Array]) -> list[CurveEvent]:
    out = np.concatenate(free)
    level = float(np.median(record.force[out])) if out.size else float(record.force[0])
    moving = np.flatnonzero(record.direction != 0.0)
    if moving.size < 2 or not float(np.ptp(record.force)) > 0.0:
        return []
    branch = moving[record.direction[moving] > 0.0]
    branch = branch if branch.size > 1 else moving[record.direction[moving] == OUT]
    rows = saturated_rows(record.position[branch], record.force[branch], level)
    return [
        CurveEvent(
            EventKind.SATURATION,
            int(branch[row[0]]),
            int(branch[row[-1]]),
            float(record.force[branch[row[0]]]),
            unit="N",
            remark=f"{row.size} points",
        )
        for row in rows
    ]


LEAST_RATIO = 6.0
"""Least tension over the noise of its measurement."""
LEAST_SHARE = 2e-3
"""Least tension relative to the range of the force."""
BASE_LENGTH = 8
"""Length of the free part next to the tension, in averaged neighbours, from which it counts."""
COMPRESSION_RATIO = 5.0
SHARP_WIDTH, SHARP_RATIO = 3, 20.0
"""Neighbours whose mean is the tension where it is clearly above the noise, and its least ratio to their noise."""


class Tension(NamedTuple):
    """Points from the far end on, tension [N] with its standard error, and whether it begins with a step."""

    first: int
    last: int
    size: float
    error: float
    sudden: bool


def tension(force: Array, branch: FreeBranch) -> Tension | None:
    """Return the tension between the free part of a branch and compression; None if there is none.

    Parameters
    ----------
    force : ndarray, (n,)
        From the far end on [N].
    branch : FreeBranch
    """
    width, free = branch.averaged, branch.points
    if not free or free + 2 * width > force.size:
        return None
    above = force - branch.line(force.size)
    base_length = min(BASE_LENGTH * width, free)
    means = moving_mean(above, width)
    compressed = means > max(COMPRESSION_RATIO * branch.mean_noise, LEAST_SHARE * float(np.ptp(force)))
    behind = np.flatnonzero(compressed[free:])
    end = free + int(behind[0]) if behind.size else means.size
    begin = max(free - base_length, 0)
    if end <= begin:
        return None
    lowest = begin + int(np.argmin(means[begin:end]))
    base = float(above[max(free - base_length, 0) : free].mean())
    size = base - float(means[lowest])
    changes = means[base_length : max(free - width, base_length)]
    bases = moving_mean(above[:free], base_length)[: changes.size]
    error = max(deviation(changes - bases), branch.noise * np.sqrt(1.0 / width + 1.0 / base_length))
    if not size > max(LEAST_RATIO * error, LEAST_SHARE * float(np.ptp(force))):
        return None
    half = np.flatnonzero(means[begin : lowest + 1] < base - 0.5 * size)
    first = begin + int(half[0]) + width // 2
    span = slice(max(first - 60, 0), min(first + 60, force.size))
    sudden = any(abs(step.place + span.start - first) <= 2 * width for step in found_steps(force[span], -1.0))
    sharp_error = branch.noise / np.sqrt(SHARP_WIDTH)
    if size > SHARP_RATIO * sharp_error and width > SHARP_WIDTH:  # a long mean would smooth the tip of it
        sharp = moving_mean(above, SHARP_WIDTH)[begin : end + width - SHARP_WIDTH]
        size, error, lowest = base - float(sharp.min()), max(sharp_error, error), begin + int(np.argmin(sharp))
        return Tension(min(first, lowest), lowest + 1, size, error, sudden)
    return Tension(first, lowest + width // 2, size, error, sudden)


BLOCKS = 5
"""Blocks of a direction from whose means the memory of the noise is read; that of 1/f noise grows with the length."""
LEAST_DRIFT_TO_ERROR = 4.0
"""Least drift of the force over its standard error for which it is taken into account."""


class Drag(NamedTuple):
    """Force against the motion [N] with its standard error, and the drift of the force over the curve [N]."""

    force: float
    error: float
    drift: float


def drag_of(order: Array, position: Array, force: Array, direction: Array) -> Drag | None:
    """Return the drag from free points of both directions, by least squares with level, tilt and, if certain, drift.

    None if the drift that would be needed exceeds the range of the free forces: it is not one straight line then.

    Parameters
    ----------
    order : ndarray, (n,)
        Times, or numbers of the points.
    position, force, direction : ndarray, (n,)
        [m], [N], +1 or -1.
    """
    columns = [np.ones(order.size), _scaled(position), direction, _scaled(order)]
    (numbers, errors), (few, few_errors) = (_fitted(columns[:count], force, direction) for count in (4, 3))
    if abs(numbers[3]) > LEAST_DRIFT_TO_ERROR * errors[3]:
        if max(abs(numbers[2]), abs(numbers[3])) > float(np.ptp(force)):
            return None
        return Drag(float(numbers[2]), float(errors[2]), 2.0 * float(numbers[3]))
    # a drift that is not certain may be there nevertheless
    error = min(float(np.hypot(few_errors[2], numbers[2] - few[2])), float(np.hypot(errors[2], few_errors[2])))
    return Drag(float(few[2]), error, 0.0)


def _scaled(column: Array) -> Array:
    half = 0.5 * float(np.ptp(column)) or 1.0
    return np.asarray((column - column.mean()) / half)


def _fitted(columns: list[Array], force: Array, direction: Array) -> tuple[Array, Array]:
    """Return numbers and standard errors, enlarged by the memory of the noise."""
    design = np.stack(columns, axis=1)
    level = float(force.mean())
    numbers = np.linalg.lstsq(design, force - level, rcond=None)[0]
    left = force - level - design @ numbers
    variance = float(left @ left) / max(force.size - len(columns), 1)
    size = max(int(0.5 * force.size / BLOCKS), 1)
    blocks = np.array([part.mean() for sign in (1.0, -1.0) for part in _blocks(left[direction == sign], size)])
    excess = float(np.mean(blocks**2)) * size / variance - 1.0 if variance > 0.0 and blocks.size else 0.0
    memory = 1.0 + BLOCKS * max(excess, 0.0)
    spread = np.diag(np.linalg.pinv(design.T @ design))
    return numbers, np.sqrt(variance * memory * spread)


def _blocks(samples: Array, size: int) -> list[Array]:
    return [samples[start : start + size] for start in range(0, samples.size - size + 1, size)]
