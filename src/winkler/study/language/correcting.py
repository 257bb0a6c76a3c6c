"""Corrections of a curve before the fit of ``[fit]``: only those requested, each described in a sentence."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.calibration import on_frame
from winkler.fitting.curves.checks import unsaturated
from winkler.fitting.curves.corrections import (
    drag_force,
    drift_rate,
    free_line,
    without_baseline,
    without_drag,
    without_drift,
)
from winkler.fitting.curves.curve import ForceCurve
from winkler.readable import with_unit
from winkler.study.language.segmenting import segmented, segments_text

__all__ = ["CORRECTIONS", "Corrected", "corrected"]


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


CORRECTIONS: dict[str, Callable[[ForceCurve], Corrected]] = {
    "baseline": _baseline,
    "drift": _drift,
    "drag": _drag,
    "saturation": _saturation,
}
"""Corrections that ``correct`` may list."""


def corrected(
    curve: ForceCurve, names: tuple[str, ...], frame_stiffness: float, part: str, segments: tuple[str, ...] = ()
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

    Raises
    ------
    InvalidInput
        If the curve does not hold what a correction needs.
    """
    curve = segmented(curve, segments) if segments else curve
    steps = list(segments_text(curve))
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
