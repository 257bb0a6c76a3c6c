"""Interactive pictures of a fit: the curve with the fitted law over it, what is left over below, force over depth."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.fitting.compare import AnyFit
from winkler.fitting.outcome import CreepFit, Fit
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.series import Series, common_scale, scale_of
from winkler.vocabulary import Word
from winkler.web.pictures.chart import LEGENDED, Chart, axis, chart, label, line

__all__ = ["draw_fit", "draw_loop", "drawn_points"]

MOST = 3000
"""So many points of a curve are drawn at most, spread evenly."""
WAYS = {
    1.0: (style.BLUE, "measured, going in"),
    0.0: (style.ORANGE, "measured, held"),
    -1.0: (style.GREEN, "measured, coming out"),
}


def drawn_points(count: int) -> Array:
    """Return which points of a curve are drawn."""
    return np.unique(np.linspace(0, count - 1, min(count, MOST)).astype(int))


def draw_fit(fit: AnyFit) -> Chart:
    """Return the curve, the fitted law, and the residuals below: over the position, of a body that relaxes over time.

    Parameters
    ----------
    fit
        What was found.
    """
    some = drawn_points(fit.curve.count)
    along, measured, model = _series(fit, some)
    counted = fit.weights[some] > 0.0
    unit = measured.word.unit
    told = "measured less fitted"
    left = Series("left over", Word("", unit, told), np.where(counted, fit.residuals[some], np.nan))
    across, upright = along.scale, common_scale(measured, model)
    below = scale_of(unit, left.content)
    x, way = along.shown(across), fit.curve.direction[some]
    data = []
    for direction, (colour, name) in WAYS.items():
        mine = way == direction
        if np.any(mine):
            data.append(_dots(x[mine], measured.shown(upright)[mine], colour, name=name, showlegend=True))
            data.append(_dots(x[mine], left.shown(below)[mine], colour, yaxis="y2", showlegend=False))
    first = True
    for mine in _lines(fit, way, x):
        data.append(line(x[mine], model.shown(upright)[mine], style.RED, name="fitted", showlegend=first))
        first = False
    ends = np.array([np.min(x), np.max(x)])
    data.append(line(ends, np.zeros(2), style.MUTED, width=1, yaxis="y2", showlegend=False, hoverinfo="skip"))
    return chart(
        data,
        axis(label(along, across), anchor="y2"),
        axis(label(measured, upright), domain=[0.34, 1.0]),
        yaxis2=axis(label(left, below), domain=[0.0, 0.24]),
        **LEGENDED,
    )


def draw_loop(fit: AnyFit) -> Chart:
    """Return force over depth of a body that relaxes: as measured, and as fitted."""
    some = drawn_points(fit.curve.count)
    depth = Series("depth", Word("d", "m", "depth"), fit.depth[some])
    force = Series("force", Word("F_N", "N", "force"), fit.curve.force[some])
    across, upright = depth.scale, force.scale
    x, way = depth.shown(across), fit.curve.direction[some]
    data = []
    for direction, (colour, name) in WAYS.items():
        if np.any(way == direction):
            mine = way == direction
            data.append(_dots(x[mine], force.shown(upright)[mine], colour, name=name, showlegend=True))
    if not isinstance(fit, CreepFit):
        model = Series("force", force.word, fit.predicted[some])
        data.append(line(x, model.shown(upright), style.RED, name="fitted", showlegend=True))
    return chart(data, axis(label(depth, across)), axis(label(force, upright)), **LEGENDED)


def _series(fit: AnyFit, some: Array) -> tuple[Series, Series, Series]:
    """Return along what the curve is drawn, what was measured, and what is fitted."""
    curve = fit.curve
    origin = fit.value("contact_point") if "contact_point" in fit.names else 0.0
    name = "position from first touch" if origin else "position"
    place = Word("", "m", name)
    force = Word("F_N", "N", "force")
    if isinstance(fit, Fit):
        along = Series(name, place, curve.position[some] - origin)
    else:
        along = Series("time", Word("t", "s", "time"), curve.time[some] - curve.time[0])
    if isinstance(fit, CreepFit):
        counted = fit.radius[some] > 0.0  # elsewhere the force tells no position
        shown = [np.where(counted, content[some] - origin, np.nan) for content in (curve.position, fit.predicted)]
        return along, Series(name, place, shown[0]), Series(name, place, shown[1])
    return along, Series("force", force, curve.force[some]), Series("force", force, fit.predicted[some])


def _lines(fit: AnyFit, way: Array, x: Array) -> list[Any]:
    """Return the points of each line of the fitted law, in their order."""
    if not isinstance(fit, Fit):
        return [np.arange(x.size)]
    found = [np.flatnonzero(way == direction) for direction in WAYS if np.any(way == direction)]
    return [mine[np.argsort(x[mine], kind="stable")] for mine in found]


def _dots(x: Array, y: Array, colour: str, **more: Any) -> dict[str, Any]:
    look = {"color": colour, "size": 4, "opacity": 0.5}
    return {"type": "scatter", "mode": "markers", "x": x, "y": y, "marker": look, "hoverinfo": "x+y", **more}
