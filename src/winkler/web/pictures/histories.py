"""Answers along a path, over time or over many loads: curves, with the moment that is looked at as a point on them."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.plot import style
from winkler.plot.series import Series, scale_of, spoken
from winkler.study.batch.outcome import Outcome
from winkler.study.batch.points import Answered
from winkler.study.chapters.answer import ALONG
from winkler.study.chapters.contents import answer_of
from winkler.web.pictures.chart import Chart, axis, chart, label, line

__all__ = ["curves_of", "draw_curves", "title_of"]

MOST = 8
"""So many curves over one quantity are drawn at most."""
FLAT = 1e-9


def curves_of(outcome: Outcome, point: Answered) -> tuple[tuple[str, str], ...]:
    """Return what is drawn over what: ``(along, of)``; nothing where the answer is one number for each word."""
    answers = point.answers
    known = tuple(pair for pair in answer_of(point.problem).curves if all(name in answers for name in pair))
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
    along, of = (Series(name, outcome.word(name), point.answers[name]) for name in pair)
    across, scale = scale_of(along.word.unit, along.content), scale_of(of.word.unit, of.content)
    x, y = along.shown(across), of.shown(scale)
    few = x.size <= 24
    data = [line(x, y, style.BLUE, mode="lines+markers" if few else "lines")]
    if 0 <= moment < x.size:
        here = {"color": style.RED, "size": 11}
        data.append(
            {
                "type": "scatter",
                "mode": "markers",
                "x": x[[moment]],
                "y": y[[moment]],
                "marker": here,
                "hoverinfo": "x+y",
            }
        )
    return chart(data, axis(label(along, across)), axis(label(of, scale), automargin=True))


def title_of(pair: tuple[str, str]) -> str:
    """Return what stands above a curve."""
    over, of = (spoken(name) for name in pair)
    return f"{of[:1].upper()}{of[1:]} over {over}"
