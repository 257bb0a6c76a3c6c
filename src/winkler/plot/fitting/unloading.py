"""Picture of a measured indentation: its segments, and the evaluation of its last unloading."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.fitting.curves.segments import SegmentKind
from winkler.fitting.unloading.oliver_pharr import OliverPharrSolution
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.fitting.curve_events import phase_lines, phases_over_time
from winkler.plot.panel import Band, Line, Panel, PanelAxis, Rule, Sheet, titled
from winkler.plot.series import Series
from winkler.values.vocabulary import Word

COLOURS = {
    SegmentKind.LOADING: style.BLUE,
    SegmentKind.HOLD: style.ORANGE,
    SegmentKind.PARTIAL_UNLOADING: style.SKY,
    SegmentKind.LAST_UNLOADING: style.GREEN,
}


@without_extent(OliverPharrSolution)
def unloading_sheet(item: OliverPharrSolution) -> Sheet:
    """Return an evaluation: the segments, the fitted unloading, its slope at the peak, and the contact depth.

    Parameters
    ----------
    item : OliverPharrSolution
    """
    problem = item.problem
    curve, segments = problem.curve, problem.curve.segments
    depth = Series("depth", Word("h", "m", "depth"), curve.depth(problem.contact_point))
    share = np.linspace(0.0, 1.0, 200)
    law = item.final_depth + share * (item.depth - item.final_depth)
    name = f"$F \\propto (h-h_f)^{{{item.exponent:.3g}}}$"
    fitted = depth.content[item.fitted_points.astype(int)]
    slope = np.array([item.depth - item.fitted_force / item.stiffness, item.depth])
    peak: dict[str, Any] = {"width": 0.0, "marker": "o", "size": 4.0, "name": "peak"}
    marks = (
        Line(law, item.fitted_force * share**item.exponent, style.RED, width=1.2, name=name),
        Band(fitted.min(), fitted.max(), alpha=0.08),
        Line(slope, np.array([0.0, item.fitted_force]), style.INK, width=1.0, dash=(4.0, 2.0), name="stiffness $S$"),
        Line(np.array([item.depth]), np.array([item.force]), style.INK, **peak),
        Rule(item.contact_depth, upright=True, width=0.9, name="contact depth $h_c$"),
    )
    force = Series("force", Word("F", "N", "force"), curve.force)
    lines = phase_lines(depth.content, force.content, [part for part in segments if part.kind in COLOURS], COLOURS)
    axes = PanelAxis.of(depth, margin=0.02), PanelAxis.of(force, margin=0.04)
    panels = phases_over_time(curve, segments, COLOURS), Panel((*lines, *marks), *axes, legend="upper left")
    return Sheet(titled(panels, "segments", "the unloading and its stiffness"), width=4.6, height=3.6)
