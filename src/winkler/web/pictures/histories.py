"""Curves of results along a path, over time or over many loads, with the current moment as a point."""

from __future__ import annotations

import numpy as np

from winkler.plot import style
from winkler.plot.curves import curves_panel
from winkler.plot.families import in_equal_ratios
from winkler.plot.normal.curves import curve_panel
from winkler.plot.panel import Line
from winkler.plot.series import Curve, Series, name_in_words
from winkler.study.batch.outcome import Outcome
from winkler.study.batch.points import SolvedPoint
from winkler.study.chapters.answer import ALONG
from winkler.study.chapters.contents import answer_of
from winkler.study.report.variation import variation_shows
from winkler.web.pictures.chart import Chart, chart

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
    geometric = bool(np.all(np.diff(x) > 0.0)) and in_equal_ratios(x)
    panel = curves_panel(curve.along, [(curve.of, "")]) if geometric else curve_panel(curve)
    return chart(panel.plus(*(Line(x[[k]], y[[k]], style.RED, width=0.0, marker="o") for k in here)))


def title_of(pair: tuple[str, str]) -> str:
    """Return the title of a curve."""
    over, of = (name_in_words(name) for name in pair)
    return f"{of[:1].upper()}{of[1:]} over {over}"
