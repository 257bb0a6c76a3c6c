"""Sheets of a measured contact resistance: over the force with the fitted one, and what is left."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.fitting.logs.contact_resistance import MeasuredConstrictionSolution, ResistanceLog
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, points, titled
from winkler.plot.series import Series
from winkler.values.vocabulary import Word


@without_extent(ResistanceLog, MeasuredConstrictionSolution)
def measured_resistance_sheet(item: Any) -> Sheet:
    """Return the resistances over the force with the fitted ones, and the relative residuals."""
    log = item if isinstance(item, ResistanceLog) else item.problem.log
    axis = PanelAxis.of(Series("force", Word("F_N", "N", "normal force"), log.force), log=True, plain=True)
    marks = [points(log.force, log.resistance, style.RED, size=2.5, name="measured")]
    order = np.argsort(log.force, kind="stable")
    if isinstance(item, MeasuredConstrictionSolution):
        marks.append(Line(log.force[order], item.fitted[order], style.BLUE, width=1.4, name="fitted"))
    resistance = Series("resistance", Word("R", "ohm", "contact resistance"), log.resistance)
    panels = [Panel(tuple(marks), axis, PanelAxis.of(resistance, log=True, plain=True), legend="best")]
    titles = ["contact resistance over force"]
    if isinstance(item, MeasuredConstrictionSolution):
        left = log.resistance / item.fitted - 1.0
        word = Word("", "", "residual over the fitted resistance")
        panels.append(
            Panel(
                (
                    points(log.force, left, style.RED, size=2.5),
                    Line(log.force[order], 0.0 * left, style.BLUE, width=1.0),
                ),
                axis,
                PanelAxis.of(Series("residual", word, left), margin=0.08),
            )
        )
        titles.append("what is left")
    return Sheet(titled(tuple(panels), *titles), width=4.6, height=3.3)
