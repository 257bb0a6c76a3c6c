"""What ``[fit]`` does to a curve before it is fitted: nothing that was not asked for, each step told in a sentence."""

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
from winkler.plot.series import told
from winkler.study.language.segmenting import segmented, segments_told

__all__ = ["CORRECTIONS", "Corrected", "corrected"]


class Corrected(NamedTuple):
    """A curve, and what was done to it."""

    curve: ForceCurve
    steps: tuple[str, ...]


def _baseline(curve: ForceCurve) -> Corrected:
    line = free_line(curve)
    sentence = (
        f"baseline: a straight line through the points out of contact was subtracted, {told(line.baseline, 'N')} with "
        f"a slope of {told(line.tilt, 'N/m')}; the force scatters about it by {told(line.noise, 'N')}."
    )
    return Corrected(without_baseline(curve, line), (sentence,))


def _drift(curve: ForceCurve) -> Corrected:
    rate = drift_rate(curve.hold)
    sentence = f"drift: positions were corrected by {told(rate, 'm/s')}, found where the tip was held."
    return Corrected(without_drift(curve, rate), (sentence,))


def _drag(curve: ForceCurve) -> Corrected:
    drag = drag_force(curve)
    sentence = f"drag: the force of the liquid, {told(drag, 'N')} against the motion, was subtracted."
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
"""What ``correct`` may ask for."""


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
    steps = list(segments_told(curve))
    if np.isfinite(frame_stiffness):
        curve = on_frame(curve, 1.0 / frame_stiffness)
        steps.append(f"frame: its stiffness of {told(frame_stiffness, 'N/m')} was taken into account.")
    for name in names:
        curve, told_ = CORRECTIONS[name](curve)
        steps += told_
    match part:
        case "approach":
            curve = curve.approach
        case "retract":
            curve = curve.retract
        case "hold":
            curve = curve.chosen(curve.direction >= 0.0)
    return Corrected(curve, tuple(steps))
