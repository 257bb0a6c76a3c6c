"""Pictures of fits that were examined further: over depth, several models, and shared numbers."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.fitting.compare import AnyFit, Comparison
from winkler.fitting.examined.over_depth import DepthSeries
from winkler.fitting.outcome import CreepFit
from winkler.fitting.several.joint import JointFit
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.fitting.fits import measured_dots, origin_of
from winkler.plot.marks import Area, Line, Rule
from winkler.plot.panel import Panel, PanelAxis, Sheet
from winkler.plot.series import Scale, Series, common_scale, middle_scale
from winkler.values.vocabulary import Word

MOST_WIDTHS = 3.0
"""Greatest interval that is drawn whole, in multiples of the range of the numbers."""
CONFIDENCE = 0.95


def depth_sheet(series: DepthSeries, name: str, word: Word) -> Sheet:
    """Return a number over the greatest fitted depth, with its interval and that of the whole curve.

    Parameters
    ----------
    series : DepthSeries
    name : str
        Of the number.
    word : Word
        Its symbol and unit.
    """
    place = Series("greatest fitted depth", Word("d", "m", "greatest fitted depth"), series.depths)
    number = Series(name, word, series.values)
    spread = float(np.ptp(series.values)) or float(series.highs[-1] - series.lows[-1])
    low = max(float(series.lows.min()), float(series.values.min()) - MOST_WIDTHS * spread)
    high = min(float(series.highs.max()), float(series.values.max()) + MOST_WIDTHS * spread)
    whole = np.full(2, series.lows[-1]), np.full(2, series.highs[-1])
    marks = (
        Area(series.depths, series.lows, series.highs, style.BLUE, 0.18, "95 % interval"),
        Area(series.depths[[0, -1]], *whole, style.RED, 0.25, "of the whole curve"),
        Line(series.depths, series.values, style.BLUE, width=1.2, marker="o", size=4.0, name="fitted up to this depth"),
    )
    margin = 0.06 * (high - low)
    upright = PanelAxis.of(number, middle_scale(word.unit, series.values), low=low - margin, high=high + margin)
    return Sheet((Panel(marks, PanelAxis.of(place, margin=0.04), upright, legend="best"),), width=5.4, height=3.1)


@without_extent(Comparison)
def comparison_sheet(comparison: Comparison) -> Sheet:
    """Return a curve with all models, and the residuals of each below.

    Parameters
    ----------
    comparison : Comparison
    """
    first = comparison.best
    along = _along(first)
    measured, residuals = _forces(first), [np.asarray(one.residuals) for one in comparison.fits]
    every = np.ones(first.curve.count, dtype=bool)
    upper: list[Any] = [*measured_dots(first, along.content, measured.content, first.curve.direction, every)]
    panels = []
    height = max(float(np.quantile(np.abs(one), 0.999)) for one in residuals)
    below = Series("residual", Word("", measured.word.unit, "measured less fitted"), np.array([-height, height]))
    scale, unnamed = common_scale(below), PanelAxis(scale=Scale(along.scale.factor, ""), margin=0.02)
    for index, (name, one) in enumerate(zip(comparison.models, comparison.fits, strict=True)):
        colour = style.CYCLE[(index + 1) % len(style.CYCLE)]
        order = np.argsort(_along(one).content, kind="stable")
        own, dash = _along(one).content[order], style.DASHES[index % len(style.DASHES)]
        shift = origin_of(one) - origin_of(first)
        upper.append(Line(own + shift, np.asarray(one.predicted)[order], colour, 1.4, dash, name=name))
        dots = Line(own + shift, residuals[index][order], colour, 0.0, marker="o", size=1.6)
        last = index == len(comparison.fits) - 1
        across = PanelAxis.of(along, margin=0.02) if last else unnamed
        upright = PanelAxis("residual", scale, low=-1.15 * height, high=1.15 * height, parts=3)
        panels.append(Panel((dots, Rule(0.0, colour=style.INK)), across, upright, title=name))
    top = Panel(
        tuple(upper),
        unnamed,
        PanelAxis.of(measured, margin=0.05),
        legend="upper left",
        marker_scale=2.0,
    )
    heights = (2.6, *(1.0 for _ in panels))
    return Sheet((top, *panels), 1, width=5.4, height=1.5, heights=heights, shared="x")


def shared_sheet(joint: JointFit, index: int, names: tuple[str, ...], name: str, word: Word) -> Sheet:
    """Return what each curve alone says of a shared number, and the joint answer as a band.

    Parameters
    ----------
    joint : JointFit
    index : int
        Of the number.
    names : tuple of str, (k,)
        Of the curves.
    name : str
        Of the number.
    word : Word
        Its symbol and unit.
    """
    values, errors = joint.single_values[:, index], joint.single_errors[:, index]
    said = np.isfinite(values)
    rows = np.arange(1.0, values.size + 1.0)
    low, high = joint.interval(joint.names[index], CONFIDENCE)
    number = Series(name, word, values[said])
    ends = np.array([0.4, values.size + 0.6])
    marks = (
        Area(ends, np.full(2, low), np.full(2, high), style.RED, 0.25, "all together, 95 %"),
        Line(
            rows[said],
            values[said],
            style.BLUE,
            1.2,
            marker="o",
            size=4.0,
            name="one curve, standard error",
            error_y=np.stack([errors[said]] * 2),
            error_colour=style.MUTED,
        ),
    )
    few: dict[str, Any] = {"ticks": rows, "names": tuple(str(int(row)) for row in rows)} if len(names) <= 20 else {}
    across = PanelAxis("number of the curve", low=float(ends[0]), high=float(ends[1]), **few)
    least = min(low, float((values - errors)[said].min(initial=low)))
    most = max(high, float((values + errors)[said].max(initial=high)))
    span = most - least
    scale = middle_scale(word.unit, values[said])
    upright = PanelAxis.of(number, scale, low=least - 0.08 * span, high=most + 0.4 * span)  # room for the legend
    return Sheet((Panel(marks, across, upright, legend="best"),), width=5.4, height=3.0)


def _along(fit: AnyFit) -> Series:
    """Return the positions from the first touch of this fit."""
    return Series("position from first touch", Word("D - D_0", "m", "position"), fit.curve.position - origin_of(fit))


def _forces(fit: AnyFit) -> Series:
    if isinstance(fit, CreepFit):
        return Series("position", Word("D", "m", "position"), fit.curve.position)
    return Series("force", Word("F_N", "N", "force"), fit.curve.force)
