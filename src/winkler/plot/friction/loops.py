"""Sheets of measured loops of friction: the loops with a fitted one, and the loss of each cycle."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.fitting.logs.friction_log import FrictionLog
from winkler.fitting.logs.friction_loops import FrictionLoopsSolution
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, points, titled
from winkler.plot.series import Series
from winkler.values.vocabulary import Word

MOST_POINTS = 4000
"""Points of the loops that are drawn; of more, those of the last cycles."""


@without_extent(FrictionLog, FrictionLoopsSolution)
def loops_sheet(item: Any) -> Sheet:
    """Return the loops of the second half of the cycles with the fitted last one, and the loss over the cycles."""
    log = item if isinstance(item, FrictionLog) else item.problem.log
    first, last = log.cycles[len(log.cycles) // 2][0], log.cycles[-1][2] + 1
    first = max(first, last - MOST_POINTS)
    way, force = log.displacement[first:last], log.force[first:last]
    marks = [points(way, force, style.RED, size=1.5, name="measured")]
    if isinstance(item, FrictionLoopsSolution) and item.loop[0].size:
        marks.append(Line(*item.loop, style.BLUE, width=1.4, name="fitted"))
    loops = Panel(
        tuple(marks),
        PanelAxis.of(Series("displacement", Word("x", "m", "displacement of the drive"), way), margin=0.05),
        PanelAxis.of(Series("shear_force", Word("F_x", "N", "shear force"), force), margin=0.08),
        legend="best",
    )
    number, loss = np.arange(1.0, len(log.cycles) + 1.0), log.loss_per_cycle
    losses = Panel(
        (points(number, loss, style.RED, size=2.5),),
        PanelAxis.of(Series("cycle", Word("n", "", "cycle"), number), margin=0.05),
        PanelAxis.of(Series("loss_per_cycle", Word("W", "J", "loss per cycle"), np.append(loss, 0.0)), margin=0.08),
    )
    return Sheet(titled((loops, losses), "loops of the second half", "loss of each cycle"), width=4.6, height=3.3)
