"""Interactive pictures of wear: worn profile, worn depth and pressure at a moment, beside the first and last state."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.series import Series, series
from winkler.problems.wear.states import WearState
from winkler.web.pictures.chart import LEGENDED, Chart, axis, chart, label, line

__all__ = ["draw_worn_depth", "draw_worn_pressure", "draw_worn_profile"]

AROUND = 1.35
"""Pictures go to so many of the greatest contact radii."""
CEILING = 3.0
"""Pressures are shown up to so many times the greatest mean: that at the edge of a core has no end."""

WORN = "rgba(0,114,178,0.15)"
THREE = ((style.MUTED, "dash", 1), (style.MUTED, "solid", 1), (style.RED, "solid", 2))
"""How the first and the last state are drawn, and the one that is looked at."""


def draw_worn_profile(states: Sequence[WearState], moment: int) -> Chart:
    """Return the profile before wear, at a moment and in the end; filled is what has been worn off.

    Parameters
    ----------
    states
        All states of a history.
    moment
        Which of them is looked at.
    """
    first, now, last = states[0], states[moment], states[-1]
    r, shown = _along(states)
    before = series("WearState", "height", first.bed.height(r))
    rows = [series("WearState", "height", before.content + np.interp(r, one.radii, one.worn)) for one in (now, last)]
    across, upright = shown.scale, rows[1].scale
    x = shown.shown(across)
    data = [
        line(x, rows[1].shown(upright), style.MUTED, width=1, name="in the end", showlegend=True),
        line(x, before.shown(upright), style.MUTED, dash="dash", width=1, name="before wear", showlegend=True),
        line(x, rows[0].shown(upright), style.BLUE, name="now", showlegend=True, fill="tonexty", fillcolor=WORN),
    ]
    top = float(np.max(rows[1].shown(upright)))
    return chart(
        data,
        axis(label(shown, across), range=[0.0, float(x[-1])]),
        axis(label(rows[1], upright), range=[0.0, 1.08 * top if top > 0.0 else 1.0]),
        **LEGENDED,
    )


def draw_worn_depth(states: Sequence[WearState], moment: int) -> Chart:
    """Return what has been worn off at a moment and in the end; parameters as for `draw_worn_profile`."""
    _, shown = _along(states)
    now, last = states[moment], states[-1]
    rows = [series("WearState", "worn", one.worn) for one in (last, now)]
    across, upright = shown.scale, rows[0].scale
    data = [
        line(one.radii / across.factor, row.shown(upright), colour, width=width, name=name, showlegend=True)
        for one, row, name, (colour, _, width) in zip((last, now), rows, ("in the end", "now"), THREE[1:], strict=True)
    ]
    top = float(np.max(last.worn)) / upright.factor
    return chart(
        data,
        axis(label(shown, across), range=[0.0, float(shown.content[-1]) / across.factor]),
        axis(label(rows[0], upright), range=[0.0, 1.08 * top if top > 0.0 else 1.0]),
        **LEGENDED,
    )


def draw_worn_pressure(states: Sequence[WearState], moment: int) -> Chart:
    """Return the pressure at a moment, in the first state and in the end; parameters as for `draw_worn_profile`."""
    first, now, last = states[0], states[moment], states[-1]
    mean = max((one.force / (math.pi * one.radius**2) for one in states if one.radius > 0.0), default=0.0)
    ceiling = CEILING * mean
    _, shown = _along(states)
    three = (first, last, now)
    rows = [series("WearState", "pressure", np.minimum(one.pressure, ceiling)) for one in three]
    across, upright = shown.scale, max((row.scale for row in rows), key=lambda one: one.factor)
    names = ("before wear" if first.elapsed == 0.0 else "at first", "in the end", "now")
    data = [
        line(one.radii / across.factor, row.shown(upright), colour, dash=dash, width=width, name=name, showlegend=True)
        for one, row, name, (colour, dash, width) in zip(three, rows, names, THREE, strict=True)
    ]
    top = max(float(np.max(np.minimum(one.pressure, ceiling))) for one in states) / upright.factor
    return chart(
        data,
        axis(label(shown, across), range=[0.0, float(shown.content[-1]) / across.factor]),
        axis(label(rows[1], upright), range=[0.0, 1.08 * top if top > 0.0 else 1.0]),
        **LEGENDED,
    )


def _along(states: Sequence[WearState]) -> tuple[Array, Series]:
    """Return the distances from the axis that are drawn."""
    reach = min(AROUND * max(one.radius for one in states), states[0].bed.reach, float(states[-1].radii[-1]))
    inside = np.unique(np.concatenate([one.radii[one.radii <= reach] for one in (states[0], states[-1])]))
    r = np.union1d(inside, [0.0, reach])
    return r, series("SurfaceFields", "r", r)
