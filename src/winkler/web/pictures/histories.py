"""Curves of results along a path, over time or over many loads, with the current moment as a point."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.families import spans_decades
from winkler.plot.normal.curves import curve_panel
from winkler.plot.panel import Line, PanelAxis
from winkler.plot.series import Curve, Series, middle_scale, name_in_words
from winkler.study.batch.outcome import Outcome
from winkler.study.batch.points import SolvedPoint
from winkler.study.chapters.answer import ALONG
from winkler.study.chapters.contents import answer_of
from winkler.study.report.variation import variation_shows
from winkler.web.pictures.chart import Chart, chart

__all__ = ["curves_of", "draw_curves", "title_of"]

MOST_CURVES = 8
"""Most curves over one quantity."""


def curves_of(outcome: Outcome, point: SolvedPoint) -> tuple[tuple[str, str], ...]:
    """Return the pairs ``(along, of)`` of drawn curves; empty if all results are single numbers."""
    answers = point.answers
    pairs = tuple(pair for pair in answer_of(point.problem).curves if all(name in answers for name in pair))
    if not pairs and len(next(iter(answers.values()), ())) > 1:
        over = next((name for name in ("time", *ALONG, "distance", "cycle") if name in answers), next(iter(answers)))
        pairs = tuple((over, name) for name in answers if name not in (over, "stable"))
    return tuple(pair for pair in pairs if all(variation_shows(name, answers) for name in pair))[:MOST_CURVES]


def draw_curves(outcome: Outcome, point: SolvedPoint, pair: tuple[str, str], moment: int = -1) -> Chart:
    """Return one result over another.

    Parameters
    ----------
    outcome, point
        Outcome and the point of it.
    pair
        Names of abscissa and ordinate.
    moment
        Index of the marked point; negative for none.
    """
    curve = Curve(*(Series(name, outcome.word(name), point.answers[name]) for name in pair))
    x, y = (one.content for one in curve)
    here = [moment] if 0 <= moment < x.size else []
    panel = curve_panel(curve)
    if _in_equal_ratios(x):
        log = spans_decades(y)
        scale = middle_scale(curve.of.word.unit, y) if log else curve.of.scale
        panel = panel.plus(
            across=PanelAxis.of(curve.along, middle_scale(curve.along.word.unit, x), margin=0.04, log=True, plain=True),
            upright=PanelAxis.of(curve.of, scale, margin=0.06, log=log, plain=log),
        )
    return chart(panel.plus(*(Line(x[[k]], y[[k]], style.RED, width=0.0, marker="o") for k in here)))


def _in_equal_ratios(numbers: Array) -> bool:
    """Return whether numbers over decades stand closer to equal ratios than to equal steps."""
    if numbers.size < 4 or not spans_decades(numbers):
        return False
    steps, ratios = np.diff(numbers), np.diff(np.log(numbers))
    return bool(np.all(ratios > 0.0) and np.ptp(ratios) / np.mean(ratios) < np.ptp(steps) / np.mean(steps))


def title_of(pair: tuple[str, str]) -> str:
    """Return the title of a curve."""
    over, of = (name_in_words(name) for name in pair)
    return f"{of[:1].upper()}{of[1:]} over {over}"
