"""The row of springs under g(x) - d, as it is at one moment: pressed, stretched, dragged sideways, or recovering."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.friction.springs import coil
from winkler.plot.normal.springs import plane_profile, stretched
from winkler.plot.series import scale_of
from winkler.problems.answer import is_dragged, is_recovering
from winkler.web.pictures.chart import Chart, axis, chart, label, line, remark
from winkler.web.pictures.view import View

__all__ = ["Row", "draw_row", "row_of"]

SPRINGS = 31
LITTLE = 1e-3
"""Springs that are nearer to their rest than this part of the deepest count as at rest."""


class Row(NamedTuple):
    """The springs that a picture shows, at their places.

    Parameters
    ----------
    place
        x [m].
    sunk
        How far each is pressed [m]; negative: stretched.
    aside
        How far the head of each stands beside its foot [m].
    colour
        Of each.
    told
        Colour -> what it says.
    """

    place: Array
    sunk: Array
    aside: Array
    colour: tuple[str, ...]
    told: dict[str, str]


def row_of(state: Any, extent: float) -> Row:
    """Return the springs of a contact at one moment.

    Parameters
    ----------
    state
        A solution or a state along a path that knows how its springs are pressed.
    extent
        Drawn up to this x on both sides [m].
    """
    step = 2.0 * extent / SPRINGS
    place = (np.arange(SPRINGS) - 0.5 * (SPRINGS - 1)) * step
    if is_recovering(state):
        return _recovering(state, place)
    pressed = state.pressed
    touching = (np.abs(place) <= pressed.radius) & (pressed.radius > 0.0)
    sunk, aside = np.zeros(place.shape), np.zeros(place.shape)
    sunk[touching] = pressed.value(np.abs(place[touching]))
    dragged = is_dragged(state)
    if not dragged:
        pulls = stretched(sunk)
        colour = [(style.BLUE if pull else style.RED) if hit else style.MUTED for pull, hit in _pairs(pulls, touching)]
        told = {style.RED: "pressed"} | ({style.BLUE: "pull"} if np.any(pulls) else {})
        return Row(place, sunk, aside, tuple(colour), told)
    for part in state.sheared.components[0]:
        within = np.abs(place) < part.radius
        aside[within] += part.value(np.abs(place[within]))
    stick = float(state.stick_radius)
    sticks = (np.abs(place) <= stick) & (stick > 0.0)
    colour = [style.MUTED if not hit else style.GREEN if held else style.RED for hit, held in _pairs(touching, sticks)]
    return Row(place, sunk, aside, tuple(colour), {style.GREEN: "sticks", style.RED: "slides"})


def _pairs(first: Any, second: Any) -> Any:
    return zip(first, second, strict=True)


def _recovering(state: Any, place: Array) -> Row:
    """Return springs that have a memory of their own."""
    sunk = np.interp(np.abs(place), state.position, state.recess, right=0.0)
    touching = (np.abs(place) <= state.radius) & (state.radius > 0.0)
    least = LITTLE * max(float(np.max(state.recess)), 1e-300)
    colour = [
        style.RED if hit else style.GREEN if down > least else style.MUTED for down, hit in _pairs(sunk, touching)
    ]
    told = {style.RED: "pressed", style.GREEN: "recover freely"}
    return Row(place, sunk, np.zeros(place.shape), tuple(colour), told)


def draw_row(bed: Bed, row: Row, depth: float, view: View) -> Chart:
    """Return the picture: springs on their ground, and the plane profile that came down on them.

    Parameters
    ----------
    bed
        Whose plane profile is drawn.
    row
        The springs.
    depth
        d [m].
    view
        The frame.
    """
    across, upright = scale_of("m", [view.extent]), scale_of("m", [view.sunk])
    x, g = plane_profile(bed, view.extent)
    rise = float(np.max(g.content)) if g.content.size else 0.0
    bottom = -2.3 * view.sunk
    top = max(min(1.3 * view.sunk, 1.1 * rise), 0.35 * view.sunk)
    lower = g.content - depth
    body_x, body_y = style.mirrored(x.content, np.minimum(lower, 4.0 * top))
    thick = 0.14 * view.sunk
    data: list[dict[str, Any]] = [_ground(view.extent / across.factor, bottom / upright.factor, thick / upright.factor)]
    for colour in dict.fromkeys(row.colour):
        points = _coils(row, colour, view, bottom)
        width = 1.0 if colour == style.MUTED else 1.6
        data.append(line(points[0] / across.factor, points[1] / upright.factor, colour, width=width, hoverinfo="skip"))
    moved = _lean(row, view) * _head(row)
    for side, fill in (
        (np.full(body_x.shape, 4.0 * top), {}),
        (body_y, {"fill": "tonexty", "fillcolor": "rgba(185,198,211,0.65)"}),
    ):
        first = not fill
        look = {"width": 0} if first else {"width": 2.4}
        colour = style.MUTED if first else style.BLUE
        data.append(
            line((body_x + moved) / across.factor, side / upright.factor, colour, **look, **fill, hoverinfo="skip")
        )
    data.append(
        line(np.array([-1.0, 1.0]) * view.extent / across.factor, [0.0, 0.0], style.MUTED, width=0.8, hoverinfo="skip")
    )
    told = {colour: what for colour, what in row.told.items() if colour in row.colour}
    notes = (
        [remark(_legend(told), x=0.02, y=0.1, xanchor="left", yanchor="middle")] if len(row.told) > 1 and told else []
    )
    return chart(
        data,
        axis(label(x, across), range=[-view.extent / across.factor, view.extent / across.factor], showgrid=False),
        axis(
            f"height [{upright.unit}]", range=[(bottom - thick) / upright.factor, top / upright.factor], showgrid=False
        ),
        annotations=notes,
    )


def _legend(told: dict[str, str]) -> str:
    return "   ".join(f'<span style="color:{colour}">▬</span> {what}' for colour, what in told.items())


def _ground(end: float, top: float, thick: float) -> dict[str, Any]:
    return {
        "type": "scatter",
        "mode": "lines",
        "x": [-end, end, end, -end],
        "y": [top, top, top - thick, top - thick],
        "fill": "toself",
        "fillcolor": style.SOLID,
        "line": {"color": style.MUTED, "width": 1},
        "hoverinfo": "skip",
    }


def _lean(row: Row, view: View) -> float:
    """Return by how much what happens sideways is enlarged."""
    most = float(np.max(np.abs(row.aside), initial=0.0))
    return 2.0 * view.extent / SPRINGS / most if most > 0.0 else 0.0


def _head(row: Row) -> float:
    """Return how far the bodies were moved [m], as their middle tells."""
    return float(row.aside[row.aside.size // 2])


def _coils(row: Row, colour: str, view: View, bottom: float) -> Array:
    """Return all springs of one colour as one line with gaps, (2, points)."""
    step, lean = 2.0 * view.extent / SPRINGS, _lean(row, view)
    lines = [
        np.append(np.stack(coil(one, lean * aside, bottom, -down, 0.3 * step)), np.full((2, 1), np.nan), axis=1)
        for one, down, aside, mine in zip(row.place, row.sunk, row.aside, row.colour, strict=True)
        if mine == colour
    ]
    return np.concatenate(lines, axis=1)
