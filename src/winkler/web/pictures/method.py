"""The pictures of the method for one contact: load of the springs, pressure, force over depth, stress below."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.fields import restore, restore_body
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.adhesion.equilibria import curve_around
from winkler.plot.extent import is_singular
from winkler.plot.normal.curves import force_depth, line_load, surface
from winkler.plot.normal.stresses import stressed_first
from winkler.plot.series import scale_of, series, told
from winkler.problems.adhesion.indentation import AdhesiveSolution
from winkler.problems.answer import is_dragged
from winkler.web.pictures.chart import Chart, axis, chart, label, line, remark
from winkler.web.pictures.view import View

__all__ = ["draw_force", "draw_line_load", "draw_pressure", "draw_stress"]

CEILING = 3.0
"""Where a pressure is infinite, its axis ends at so many typical pressures."""
ACROSS, DOWN, DEEP = 31, 25, 2.0
"""Places of the map of the stress, and its depth in contact radii."""


def draw_line_load(contact: Any, view: View) -> Chart:
    """Return q(x), whose area is the force."""
    curve = line_load(contact, view.extent)
    across, scale = scale_of("m", [view.extent]), curve.of.scale
    x, q = curve.along.shown(across), curve.of.shown(scale)
    data = [line(x, q, style.RED, fill="tozeroy", fillcolor="rgba(213,94,0,0.16)")]
    away = q[np.abs(curve.along.content) >= 0.03 * contact.pressed.radius]
    force = told(float(contact.force), "N")
    note = f"area = <i>F</i><sub>N</sub> = {force}" if contact.pressed.radius > 0.0 else "no contact"
    return chart(
        data,
        _places(label(curve.along, across), view.extent / across.factor),
        axis(label(curve.of, scale), range=_span(away)),
        annotations=[remark(note)],
    )


def draw_pressure(contact: Any, view: View) -> Chart:
    """Return p(r) on both sides of the axis; where it is infinite, the picture ends and says so."""
    fields = surface(contact, view.extent)
    pressed = contact.pressed
    r, p = series("SurfaceFields", "r", fields.r), series("SurfaceFields", "pressure", fields.pressure)
    known = p.content[np.isfinite(p.content)]
    low, high = float(np.min(known, initial=0.0)), float(np.max(known, initial=0.0))
    singular = is_singular(pressed)
    if singular:
        inside = np.abs(p.content[(fields.r < pressed.radius) & np.isfinite(p.content)])
        usual = float(np.median(inside)) if inside.size else 0.0
        low, high = max(low, -CEILING * usual), min(high, CEILING * usual)
    scale, across = scale_of("Pa", [low, high]), scale_of("m", [view.extent])
    x, y = style.mirrored(r.shown(across), p.shown(scale))
    notes = [remark("no contact")] if pressed.radius == 0.0 else []
    notes += [remark("infinite where the curve leaves the frame")] if singular else []
    data = [line(x, y, style.BLUE, fill="tozeroy", fillcolor="rgba(0,114,178,0.13)")]
    if pressed.radius > 0.0:
        mean = float(contact.force) / (np.pi * float(pressed.radius) ** 2) / scale.factor
        end = float(pressed.radius) / across.factor
        data.append(line([-end, end], [mean, mean], style.INK, width=1, name="mean", hoverinfo="y+name"))
    return chart(
        data,
        _places(label(r, across), view.extent / across.factor),
        axis(label(p, scale), range=_span(np.array([low, high]) / scale.factor)),
        annotations=notes,
    )


def draw_force(contact: Any) -> Chart:
    """Return F(d) up to a contact, or around it where the bodies stick, and the contact itself as a point."""
    if isinstance(contact, AdhesiveSolution):
        around = curve_around(contact)
        depth, force, stable = around.depth, around.force, np.asarray(around.stable, dtype=bool)
    else:
        curve = force_depth(contact.pressed)
        depth, force, stable = curve.along.content, curve.of.content, np.ones(curve.of.content.shape, dtype=bool)
    now = float(contact.depth), float(contact.force)
    along, of = series("IndentationSolution", "depth", depth), series("IndentationSolution", "force", force)
    across, scale = scale_of("m", depth, now[0]), scale_of("N", force, now[1])
    x, y = along.shown(across), of.shown(scale)
    data = [line(x, np.where(stable, y, np.nan), style.BLUE)]
    if not stable.all():
        data.insert(0, line(x, y, style.MUTED, width=1.2))
    here = {"color": style.RED, "size": 11}
    data.append(
        {
            "type": "scatter",
            "mode": "markers",
            "x": [now[0] / across.factor],
            "y": [now[1] / scale.factor],
            "marker": here,
            "name": "now",
            "hoverinfo": "x+y+name",
            "cliponaxis": False,
        }
    )
    notes = [] if stable.all() else [remark("grey: unstable", x=0.98, y=0.03, xanchor="right")]
    return chart(data, axis(label(along, across)), axis(label(of, scale)), annotations=notes)


def draw_stress(contact: Any, view: View) -> Chart:
    """Return the map of the von Mises stress below a contact.

    Raises
    ------
    OutsideValidity
        If the stresses inside this medium are not known.
    """
    radius = float(contact.pressed.radius)
    if radius == 0.0:
        raise InvalidInput("the bodies do not touch, so that there is no stress.")
    sign = 1.0 if stressed_first(contact) else -1.0
    r = np.linspace(0.0, min(view.extent, 2.2 * radius), ACROSS)
    x = np.concatenate([-r[:0:-1], r])
    z = DEEP * radius * (np.linspace(0.0, 1.0, DOWN) ** 1.6 + 1e-3)
    if is_dragged(contact):
        stress = restore_body(contact, x[:, None], 0.0, sign * z[None, :]).von_mises
    else:
        half = np.asarray(restore(contact, r[:, None], sign * z[None, :]).von_mises)
        stress = np.concatenate([half[:0:-1], half])
    top = float(np.nanpercentile(stress[np.isfinite(stress)], 99.5))
    scale, across = scale_of("Pa", [top]), scale_of("m", r, z)
    data = {
        "type": "contour",
        "x": x / across.factor,
        "y": sign * z / across.factor,
        "z": np.minimum(stress.T, top) / scale.factor,
        "colorscale": "Viridis",
        "reversescale": True,
        "ncontours": 11,
        "line": {"width": 0.4, "color": "white"},
        "colorbar": {
            "title": {"text": f"[{scale.unit}]", "side": "top"},
            "thickness": 12,
            "outlinewidth": 0,
            "len": 1.0,
        },
        "hovertemplate": "%{z:.4g} " + scale.unit + "<extra></extra>",
    }
    edge = line(np.array([-radius, radius]) / across.factor, [0.0, 0.0], style.RED, width=5, hoverinfo="skip")
    note = [remark("infinite at a sharp edge, kink or tip", y=0.03)] if is_singular(contact.pressed) else []
    words = series("SubsurfaceFields", "r", r), series("SubsurfaceFields", "z", z)
    return chart(
        [data, edge],
        axis(label(words[0], across), showgrid=False),
        axis(label(words[1], across), autorange="reversed" if sign > 0.0 else True, scaleanchor="x", showgrid=False),
        annotations=note,
    )


def _places(title: str, end: float) -> dict[str, Any]:
    return axis(title, range=[-end, end])


def _span(numbers: Array) -> list[float]:
    """Return an axis from zero on, or on both sides of it."""
    known = numbers[np.isfinite(numbers)]
    low, high = float(np.min(known, initial=0.0)), float(np.max(known, initial=0.0))
    return [1.12 * low, 1.12 * high] if high > low else [0.0, 1.0]
