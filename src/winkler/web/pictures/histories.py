"""Answers along a path, over time or over many loads: curves, with the moment that is looked at as a point on them."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.plot import style
from winkler.plot.normal.curves import curve_panel
from winkler.plot.panel import Line
from winkler.plot.series import Curve, Series, spoken
from winkler.study.batch.outcome import Outcome
from winkler.study.batch.points import Answered
from winkler.study.chapters.answer_curves import ALONG, LOOPS
from winkler.web.pictures.chart import Chart, chart

__all__ = ["curves_of", "draw_curves", "title_of"]

MOST = 8
"""So many curves over one quantity are drawn at most."""
FLAT = 1e-9


def curves_of(outcome: Outcome, point: Answered) -> tuple[tuple[str, str], ...]:
    """Return what is drawn over what: ``(along, of)``; nothing where the answer is one number for each word."""
    answers = point.answers
    known = tuple(pair for pair in LOOPS.get(type(point.solution), ()) if all(name in answers for name in pair))
    if not known and len(next(iter(answers.values()), ())) > 1:
        over = next((name for name in ("time", *ALONG, "distance", "cycle") if name in answers), next(iter(answers)))
        known = tuple((over, name) for name in answers if name not in (over, "stable"))
    return tuple((over, of) for over, of in known if _tells(answers[of]) and _tells(answers[over]))[:MOST]


def _tells(content: Any) -> bool:
    finite = content[np.isfinite(content)]
    return finite.size > 1 and float(np.ptp(finite)) > FLAT * float(np.max(np.abs(finite)))


def draw_curves(outcome: Outcome, point: Answered, pair: tuple[str, str], moment: int = -1) -> Chart:
    """Return one answer over another.

    Parameters
    ----------
    outcome, point
        Whose answers they are.
    pair
        Names: what is along, and what of.
    moment
        Place of the point that is marked; negative for none.
    """
    curve = Curve(*(Series(name, outcome.word(name), point.answers[name]) for name in pair))
    x, y = (one.content for one in curve)
    here = [moment] if 0 <= moment < x.size else []
    return chart(curve_panel(curve).plus(*(Line(x[[k]], y[[k]], style.RED, width=0.0, marker="o") for k in here)))


def title_of(pair: tuple[str, str]) -> str:
    """Return what stands above a curve."""
    over, of = (spoken(name) for name in pair)
    return f"{of[:1].upper()}{of[1:]} over {over}"
