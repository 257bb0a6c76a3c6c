"""Curves of contacts with friction: loops, forces and energies along a path, traction and slip over the contact."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.fields.restoration import restore
from winkler.foundation.sheared import ShearedSprings
from winkler.foundation.sheared_fields import ShearedFields
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.curves import Quantity
from winkler.plot.panel import Area, Band, Line, Panel, PanelAxis, Rule, note, points, zero
from winkler.plot.series import Series, places, scale_of, series, with_unit

MOST_MARKED_POINTS = 40
"""Points of a path are marked individually up to this number."""
LEAST_SHARE = 0.015
"""Part of all energy below which one is too thin to be seen, and left out."""
LOSS_TOLERANCE = 1e-12
"""Relative rounding error of a loss, in the greatest load times the greatest displacement."""
MOST_CORNERS = 24
"""Points are clustered at the corners of a traction up to this number of corners."""
MOST_LEGEND_LETTERS = 32
"""Legends with more letters have two columns."""
TRACTION_CEILING = 3.0
"""Greatest drawn traction over its mean where it is infinite."""


class RestorableSprings:
    """Sheared springs as the argument of `restore`."""

    def __init__(self, sheared: ShearedSprings) -> None:
        self.sheared = sheared


def loop_panel(along: Series, of: Series, lost: float | None = None) -> Panel:
    """Return a load over its conjugate displacement, from the first point (open) to the last (full).

    Parameters
    ----------
    along, of : Series
        Of one length.
    lost : float, optional
        Energy lost along the path [J], written into the picture.
    """
    x, y = along.content, of.content
    marks: list[Any] = [
        zero(),
        Line(x, y, marker="o" if x.size <= MOST_MARKED_POINTS else "", size=3.5),
        *path_ends(x, y),
    ]
    marks += [] if lost is None else [note(loss_text(lost, x, y), "upper left")]
    return Panel(tuple(marks), PanelAxis.of(along, margin=0.06), PanelAxis.of(of, margin=0.12))


def path_ends(x: Array, y: Array) -> tuple[Line, Line]:
    """Return the first point of a path (open) and the last (full)."""
    return points(x[0], y[0], style.BLUE, hollow=True, order=5.0), points(x[-1], y[-1], order=6.0)


def loss_text(lost: float, path: Array, load: Array) -> str:
    """Return the energy lost along a path as text; a loss below rounding counts as zero."""
    greatest = float(np.max(np.abs(path)) * np.max(np.abs(load)))
    return f"lost along the path: {with_unit(lost, 'J')}" if lost > LOSS_TOLERANCE * greatest else "nothing lost"


def bounds(field: str, limit: Array, name: str = r"$\pm\mu F_N$") -> list[Quantity]:
    """Return a bound in both directions, dashed."""
    look = {"colour": style.MUTED, "dash": style.DASHES[1], "width": 1.1, "marker": ""}
    return [Quantity(series(field, sign * limit), name if sign > 0.0 else "", look=look) for sign in (1.0, -1.0)]


def energies_panel(solution: Any, names: dict[str, str], along: str = "time", height_factor: float = 1.0) -> Panel:
    """Return stacked energies of a solution over time.

    Parameters
    ----------
    solution
        With arrays over the steps.
    names : dict of str
        Fields of the solution and their names in the legend, from the bottom up.
    along : str
        Field of the solution for the abscissa.
    height_factor : float
        Height of the upright axis, relative to what the energies need.
    """
    owner = type(solution)
    across = series(along, getattr(solution, along), owner)
    rows = np.cumsum([np.zeros(across.content.shape), *(getattr(solution, name) for name in names)], axis=0)
    scale, greatest = scale_of("J", rows[-1]), float(np.max(rows[-1]))
    areas = [
        Area(across.content, low, high, colour, 0.55, name)
        for low, high, colour, name in zip(
            rows, rows[1:], (style.RED, style.BLUE, style.GREEN, style.ORANGE), names.values(), strict=False
        )
        if np.max(high - low) >= LEAST_SHARE * greatest
    ]
    upright = PanelAxis(
        "energy", scale, low=0.0, high=height_factor * (1.15 * greatest if greatest > 0.0 else scale.factor)
    )
    line = Line(across.content, rows[-1], style.INK, width=1.0)
    return Panel((*areas, line), PanelAxis.of(across, margin=0.0), upright, legend="upper left")


def traction_panel(fields: ShearedFields, coefficient: float, stick: float) -> Panel:
    """Return the traction over the contact between the bounds that friction sets, and the zone of stick.

    Parameters
    ----------
    fields : ShearedFields
        Over the contact and beside it, from the axis on.
    coefficient : float
        mu [-]; infinite without sliding: then there are no bounds.
    stick : float
        Radius of the part that sticks [m].
    """
    extent = float(fields.r[-1])
    bound = coefficient * fields.pressure if math.isfinite(coefficient) else np.zeros(fields.r.shape)
    rows = _rows(fields.traction)
    mean = coefficient * _mean(fields) if math.isfinite(coefficient) else float(np.max(np.abs(rows[0][:1])))
    greatest = float(np.max([np.max(np.where(np.isfinite(row), np.abs(row), 0.0)) for row in (*rows, bound)]))
    top = min(greatest, TRACTION_CEILING * mean) if mean > 0.0 else greatest
    scale = scale_of("Pa", [top])
    marks: list[Any] = [*stick_band(stick), *mirrored_bounds(fields.r, bound, r"$\pm\mu p$")]
    names = [r"$\tau$"] if len(rows) == 1 else [r"$\tau_x$", r"$\tau_y$"]
    for row, name, colour in zip(rows, names, (style.RED, style.BLUE), strict=False):
        x, y = style.mirrored(fields.r, row)
        marks += [Line(x, y, colour, name=name), Area(x, y, 0.0, colour, 0.12)]
    low = max(min(0.0, *(float(np.min(row)) for row in rows)), -top)
    of = series("traction", rows[0])
    upright = PanelAxis.of(of, scale, low=1.15 * low, high=1.45 * top if top > 0.0 else scale.factor)
    across = PanelAxis.of(series("r", fields.r), scale_of("m", [extent]), low=-extent, high=extent)
    return Panel(tuple(marks), across, upright, legend="upper right")


def mirrored_bounds(along: Array, bound: Array, name: str) -> list[Line]:
    """Return a bound in both directions and on both sides of the axis; nothing if it is zero."""
    look: dict[str, Any] = {"colour": style.MUTED, "width": 1.1, "dash": style.DASHES[1]}
    return [
        Line(*style.mirrored(along, sign * bound), name=name if sign > 0.0 else "", **look)
        for sign in ((1.0, -1.0) if np.any(bound) else ())
    ]


def slip_panel(fields: ShearedFields, radius: float, stick: float) -> Panel:
    """Return tangential displacement and slip of the surface over the distance from the axis.

    Parameters
    ----------
    fields : ShearedFields
        Over the contact and beside it, from the axis on.
    radius, stick : float
        Of the contact, and of the part that sticks [m].
    """
    extent = float(fields.r[-1])
    moved, slips = _rows(fields.tangential_displacement), _rows(fields.slip)
    directions = ["_x", "_y"] if len(moved) > 1 else [""]
    marks: list[Any] = stick_band(stick, mirrored=False)
    for place, (row, slip, index) in enumerate(zip(moved, slips, directions, strict=True)):
        marks.append(Line(fields.r, row, style.CYCLE[2 * place], name=f"$u{index or '_x'}$ dragged"))
        look: dict[str, Any] = {"dash": style.DASHES[1], "name": f"$s{index}$ slipped"}
        marks.append(Line(fields.r, slip, style.CYCLE[2 * place + 1], **look))
    marks += [Rule(radius, upright=True, width=0.9, dash=style.DOTTED), zero()]
    across = PanelAxis.of(series("r", fields.r), scale_of("m", [extent]), low=0.0, high=extent)
    scale = scale_of("m", *moved, *slips)
    upright = PanelAxis("along the surface", scale, margin=0.08, headroom=0.35 if len(moved) == 1 else 0.5)
    letters = sum(len(mark.name) for mark in marks if isinstance(mark, Line | Band))
    columns = (
        sum(bool(mark.name) for mark in marks if isinstance(mark, Line | Band)) if letters <= MOST_LEGEND_LETTERS else 2
    )
    return Panel(tuple(marks), across, upright, legend="upper center", columns=columns, spaced=True)


def stick_band(stick: float, *, mirrored: bool = True) -> list[Any]:
    """Return the zone that sticks, shaded up to a radius [m]; empty if the whole contact slides."""
    return [Band(-stick if mirrored else 0.0, stick, name="stick")] if stick > 0.0 else []


def around_contact(sheared: ShearedSprings, extent: float) -> ShearedFields:
    """Return the fields on the surface at points suited to a picture, up to an extent [m]."""
    corners = [float(b) for b in sheared.radii] if sheared.radii.size <= MOST_CORNERS else []
    marks = (*(b for b, _ in sheared.pressed.bed.kinks), *corners, sheared.pressed.radius)
    return restore(RestorableSprings(sheared), places(extent, marks, count=300))


def _rows(content: Array) -> list[Array]:
    """Return the components of a field along the surface, those that are not finite as nan."""
    finite = np.where(np.isfinite(content), content, np.nan)
    return [finite] if content.ndim == 1 else [finite[:, i] for i in range(content.shape[1])]


def _mean(fields: ShearedFields) -> float:
    """Return a pressure that is typical of the contact [Pa]."""
    loaded = (fields.pressure > 0.0) & np.isfinite(fields.pressure)
    if not loaded.any():
        return 0.0
    r = fields.r[loaded]
    return float(np.interp(0.5 * r[-1], r, fields.pressure[loaded]))
