"""Corrections of a curve before the fit of ``[fit]``: only those requested, each described in a sentence."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.checks import unsaturated
from winkler.fitting.curves.corrections import (
    drag_force,
    drift_rate,
    free_line,
    on_frame,
    without_baseline,
    without_clock_offset,
    without_drag,
    without_drift,
    without_interference,
)
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.events.clock import is_certain
from winkler.fitting.curves.events.found import clock_offset_in, interference_in
from winkler.fitting.curves.events.kinds import with_error
from winkler.study.language.segmenting import events_text, segmented, segments_text, with_stated_events
from winkler.values.readable import with_unit


class Corrected(NamedTuple):
    """A curve, and the sentences about its corrections."""

    curve: ForceCurve
    steps: tuple[str, ...]


def _baseline(curve: ForceCurve) -> Corrected:
    line = free_line(curve)
    sentence = (
        f"baseline: a straight line through the points out of contact was subtracted, {with_unit(line.baseline, 'N')} "
        f"with a slope of {with_unit(line.tilt, 'N/m')}; the force scatters about it by {with_unit(line.noise, 'N')}."
    )
    return Corrected(without_baseline(curve, line), (sentence,))


def _drift(curve: ForceCurve) -> Corrected:
    rate = drift_rate(curve.hold)
    sentence = f"drift: positions were corrected by {with_unit(rate, 'm/s')}, determined where the tip was held."
    return Corrected(without_drift(curve, rate), (sentence,))


def _drag(curve: ForceCurve) -> Corrected:
    drag = drag_force(curve)
    sentence = f"drag: the force of the liquid, {with_unit(drag, 'N')} against the motion, was subtracted."
    return Corrected(without_drag(curve, drag), (sentence,))


def _saturation(curve: ForceCurve) -> Corrected:
    left = unsaturated(curve)
    if left is curve:
        return Corrected(curve, ("saturation: the detector never came to its end; nothing was left out.",))
    sentence = f"saturation: {curve.count - left.count} points at the largest force of the detector were left out."
    return Corrected(left, (sentence,))


def _interference(curve: ForceCurve) -> Corrected:
    found = interference_in(curve.record)
    if found is None:
        sentence = "interference: no sinusoid over the position stands out of the noise; nothing was subtracted."
        return Corrected(curve, (sentence,))
    deepest = float(found.error_at(curve.position[np.argmax(curve.force)]))
    sentence = (
        f"interference: a sinusoid of the amplitude {with_error(found.amplitude, found.amplitude_error, 'N')} and the "
        f"period {with_error(found.period, found.period_error, 'm')} over the position was fitted out of contact and "
        f"subtracted everywhere; at the largest force it is uncertain by {with_unit(deepest, 'N', 2)}."
    )
    return Corrected(without_interference(curve, found), (sentence,))


def _clock(curve: ForceCurve) -> Corrected:
    found = clock_offset_in(curve.record)
    if found is None:
        sentence = "clock: no edge of the motion determines an offset of force and position; nothing was shifted."
        return Corrected(curve, (sentence,))
    offset = with_error(found.offset, found.error, "s")
    if not is_certain(found, curve.record):
        sentence = f"clock: the force is late by {offset}, which is not certain; nothing was shifted."
        return Corrected(curve, (sentence,))
    sentence = f"clock: the force was recorded late by {offset}, and was shifted by interpolation in time."
    return Corrected(without_clock_offset(curve, found.offset), (sentence,))


CORRECTIONS: dict[str, Callable[[ForceCurve], Corrected]] = {
    "baseline": _baseline,
    "drift": _drift,
    "drag": _drag,
    "saturation": _saturation,
    "interference": _interference,
    "clock": _clock,
}
"""Corrections that ``correct`` may list."""


def corrected(
    curve: ForceCurve,
    names: tuple[str, ...],
    frame_stiffness: float,
    part: str,
    segments: tuple[str, ...] = (),
    events: tuple[str, ...] = (),
) -> Corrected:
    """Return the part of a curve that is fitted, after the corrections in their order.

    Parameters
    ----------
    curve : ForceCurve
        As it was measured.
    names : tuple of str
        Keys of `CORRECTIONS`.
    frame_stiffness : float
        [N/m], infinite for none.
    part : str
        approach, hold (with the approach), retract or both.
    segments : tuple of str, optional
        As they are stated, from `winkler.study.language.segmenting`.
    events : tuple of str, optional
        As they are stated, from `winkler.study.language.segmenting`.

    Raises
    ------
    InvalidInput
        If the curve does not hold what a correction needs.
    """
    curve = with_stated_events(segmented(curve, segments) if segments else curve, events)
    steps = [*segments_text(curve), *events_text(events)]
    if np.isfinite(frame_stiffness):
        curve = on_frame(curve, 1.0 / frame_stiffness)
        steps.append(f"frame: its stiffness of {with_unit(frame_stiffness, 'N/m')} was taken into account.")
    for name in names:
        curve, sentences = CORRECTIONS[name](curve)
        steps += sentences
    match part:
        case "approach":
            curve = curve.approach
        case "retract":
            curve = curve.retract
        case "hold":
            curve = curve.chosen(curve.direction >= 0.0)
    return Corrected(curve, tuple(steps))
