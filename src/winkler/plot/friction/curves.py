"""Curves of contacts with friction: loops, forces and energies along a path, traction and slip over the contact."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.fields import restore
from winkler.foundation.sheared import ShearedSprings
from winkler.foundation.sheared_fields import ShearedFields
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.series import Series, common_scale, places, scale_of, series, told

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = [
    "Restored",
    "around_contact",
    "draw_energies",
    "draw_lines",
    "draw_loop",
    "draw_slip",
    "draw_traction",
    "lost_told",
    "roomy_legend",
    "shade_stick",
]

MARKED = 40
"""Paths of at most so many points show each of them."""
ROUNDING = 1e-12
"""Losses below this part of the greatest load times the longest way are none."""
FEW = 24
"""Corners of a traction are approached closely if there are no more of them."""
LETTERS = 32
"""Legends with more letters stand in two columns."""
CEILING = 3.0
"""Where a traction is infinite, its axis ends at so many mean ones."""


class Restored:
    """Springs whose fields are wanted, as `restore` takes them."""

    def __init__(self, sheared: ShearedSprings) -> None:
        self.sheared = sheared


def draw_loop(axes: Axes, along: Series, of: Series, lost: float | None = None) -> None:
    """Draw a load over the motion that goes with it, from the first point (open) to the last (full).

    Parameters
    ----------
    axes : Axes
        Empty.
    along, of : Series
        Of one length.
    lost : float, optional
        Energy lost on the way [J], told in the picture.
    """
    x, y = along.shown(), of.shown()
    axes.axhline(0.0, color=style.MUTED, linewidth=0.8, zorder=1)
    axes.plot(x, y, color=style.BLUE, marker="o" if x.size <= MARKED else "", markersize=3.5)
    axes.plot(x[:1], y[:1], "o", color=style.BLUE, markerfacecolor="white", zorder=5)
    axes.plot(x[-1:], y[-1:], "o", color=style.RED, zorder=6)
    axes.margins(x=0.06, y=0.12)
    axes.set_xlabel(along.label())
    axes.set_ylabel(of.label())
    if lost is not None:
        style.note(axes, lost_told(lost, along.content, of.content), where="upper left")


def lost_told(lost: float, way: Array, load: Array) -> str:
    """Return what a picture says about the energy lost on a way; what is less than rounding is nothing."""
    most = float(np.max(np.abs(way)) * np.max(np.abs(load)))
    return f"lost on the way: {told(lost, 'J')}" if lost > ROUNDING * most else "nothing lost"


def draw_lines(axes: Axes, along: Series, lines: list[tuple[Series, str]], ylabel: str) -> None:
    """Draw several quantities of one unit over one, told apart by colour and dashes.

    Parameters
    ----------
    axes : Axes
        Empty.
    along : Series
    lines : list of (Series, str)
        With their names for the legend.
    ylabel : str
        What they are, without a unit.
    """
    scale = common_scale(*(line for line, _ in lines))
    axes.axhline(0.0, color=style.MUTED, linewidth=0.8, zorder=1)
    for place, (line, name) in enumerate(lines):
        axes.plot(
            along.shown(),
            np.where(np.isfinite(line.content), line.shown(scale), np.nan),
            color=style.CYCLE[place],
            linestyle=style.DASHES[place % len(style.DASHES)],
            label=name,
        )
    axes.margins(x=0.0, y=0.08)
    axes.set_xlabel(along.label())
    axes.set_ylabel(f"{ylabel} [{scale.unit}]" if scale.unit else ylabel)
    if len(lines) > 1:
        roomy_legend(axes)


def roomy_legend(axes: Axes, share: float = 0.2) -> None:
    """Add a legend above the curves, which get so much more room there."""
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + share * (high - low))
    names = [name for name in axes.get_legend_handles_labels()[1] if not name.startswith("_")]
    columns = len(names) if sum(map(len, names)) <= LETTERS else 2
    style.framed_legend(axes, loc="upper center", ncols=columns, columnspacing=1.2)


def draw_energies(axes: Axes, solution: Any, names: dict[str, str], along: str = "time") -> None:
    """Draw energies of an answer on top of each other, over time.

    Parameters
    ----------
    axes : Axes
        Empty.
    solution
        With arrays over the steps.
    names : dict of str
        Fields of the answer, and their names for the legend, from the bottom up.
    along : str
        Field of the answer along which is drawn.
    """
    owner = type(solution)
    across = series(owner, along, getattr(solution, along))
    parts = [series(owner, name, getattr(solution, name)) for name in names]
    total = np.sum([part.content for part in parts], axis=0)
    scale = scale_of("J", total)
    colours = (style.RED, style.BLUE, style.GREEN, style.ORANGE)
    axes.stackplot(
        across.shown(),
        *(part.shown(scale) for part in parts),
        labels=list(names.values()),
        colors=colours[: len(parts)],
        alpha=0.55,
        linewidth=0.0,
    )
    axes.plot(across.shown(), total / scale.factor, color=style.INK, linewidth=1.0)
    axes.margins(x=0.0)
    axes.set_ylim(0.0, 1.15 * float(np.max(total)) / scale.factor if np.max(total) > 0.0 else 1.0)
    axes.set_xlabel(across.label())
    axes.set_ylabel(f"energy [{scale.unit}]")
    style.framed_legend(axes, loc="upper left")


def draw_traction(axes: Axes, fields: ShearedFields, coefficient: float, stick: float) -> None:
    """Draw the traction over the contact between the bounds that friction sets, and the zone of stick.

    Parameters
    ----------
    axes : Axes
        Empty.
    fields : ShearedFields
        Over the contact and beside it, from the axis on.
    coefficient : float
        mu [-]; infinite if nothing slides: then there are no bounds.
    stick : float
        Radius of the part that sticks [m].
    """
    extent = float(fields.r[-1])
    bound = coefficient * fields.pressure if math.isfinite(coefficient) else np.zeros(fields.r.shape)
    rows = _rows(fields.traction)
    mean = coefficient * _mean(fields) if math.isfinite(coefficient) else float(np.max(np.abs(rows[0][:1])))
    greatest = float(np.max([np.max(np.where(np.isfinite(row), np.abs(row), 0.0)) for row in (*rows, bound)]))
    top = min(greatest, CEILING * mean) if mean > 0.0 else greatest
    scale = scale_of("Pa", [top])
    across = scale_of("m", [extent])
    shade_stick(axes, stick / across.factor)
    for sign in (1.0, -1.0) if np.any(bound) else ():
        x, y = style.mirrored(fields.r / across.factor, sign * bound / scale.factor)
        axes.plot(
            x,
            y,
            color=style.MUTED,
            linewidth=1.1,
            linestyle=style.DASHES[1],
            label=r"$\pm\mu p$" if sign > 0.0 else "_",
        )
    names = [r"$\tau$"] if len(rows) == 1 else [r"$\tau_x$", r"$\tau_y$"]
    for row, name, colour in zip(rows, names, (style.RED, style.BLUE), strict=False):
        x, y = style.mirrored(fields.r / across.factor, row / scale.factor)
        axes.plot(x, y, color=colour, label=name)
        axes.fill_between(x, y, color=colour, alpha=0.12, linewidth=0.0)
    axes.set_xlim(-extent / across.factor, extent / across.factor)
    low = min(0.0, *(float(np.min(row)) for row in rows))
    axes.set_ylim(1.15 * max(low, -top) / scale.factor, 1.45 * top / scale.factor if top > 0.0 else 1.0)
    axes.set_xlabel(series("ShearedFields", "r", fields.r).label(across))
    axes.set_ylabel(series("ShearedFields", "traction", rows[0]).label(scale))
    style.framed_legend(axes, loc="upper right")


def draw_slip(axes: Axes, fields: ShearedFields, radius: float, stick: float) -> None:
    """Draw how far the surface is dragged along, and how far it slips, over the distance from the axis.

    Parameters
    ----------
    axes : Axes
        Empty.
    fields : ShearedFields
        Over the contact and beside it, from the axis on.
    radius, stick : float
        Of the contact, and of the part that sticks [m].
    """
    extent = float(fields.r[-1])
    moved, slips = _rows(fields.tangential_displacement), _rows(fields.slip)
    marks = ["_x", "_y"] if len(moved) > 1 else [""]
    scale, across = scale_of("m", *moved, *slips), scale_of("m", [extent])
    shade_stick(axes, stick / across.factor, mirrored=False)
    for place, (row, slip, mark) in enumerate(zip(moved, slips, marks, strict=True)):
        told_moved = f"$u{mark or '_x'}$ dragged"
        told_slip = f"$s{mark}$ slipped"
        axes.plot(fields.r / across.factor, row / scale.factor, color=style.CYCLE[2 * place], label=told_moved)
        axes.plot(
            fields.r / across.factor,
            slip / scale.factor,
            color=style.CYCLE[2 * place + 1],
            linestyle=style.DASHES[1],
            label=told_slip,
        )
    axes.axvline(radius / across.factor, color=style.MUTED, linewidth=0.9, linestyle=":")
    axes.axhline(0.0, color=style.MUTED, linewidth=0.8, zorder=1)
    axes.set_xlim(0.0, extent / across.factor)
    axes.margins(y=0.08)
    axes.set_xlabel(series("ShearedFields", "r", fields.r).label(across))
    axes.set_ylabel(f"along the surface [{scale.unit}]")
    roomy_legend(axes, 0.35 if len(moved) == 1 else 0.5)


def shade_stick(axes: Axes, stick: float, *, mirrored: bool = True) -> None:
    """Shade the zone that sticks, up to a radius in the unit of the axis."""
    if stick > 0.0:
        axes.axvspan(-stick if mirrored else 0.0, stick, color=style.GREEN, alpha=0.13, linewidth=0.0, label="stick")


def around_contact(sheared: ShearedSprings, extent: float) -> ShearedFields:
    """Return the fields on the surface at places that suit a picture, up to an extent [m]."""
    corners = [float(b) for b in sheared.radii] if sheared.radii.size <= FEW else []
    marks = (*(b for b, _ in sheared.pressed.bed.kinks), *corners, sheared.pressed.radius)
    return restore(Restored(sheared), places(extent, marks, count=300))


def _rows(content: Array) -> list[Array]:
    """Return the components of a field along the surface, those that are not finite as nan."""
    known = np.where(np.isfinite(content), content, np.nan)
    return [known] if content.ndim == 1 else [known[:, i] for i in range(content.shape[1])]


def _mean(fields: ShearedFields) -> float:
    """Return a pressure that is typical of the contact [Pa]."""
    felt = (fields.pressure > 0.0) & np.isfinite(fields.pressure)
    if not felt.any():
        return 0.0
    r = fields.r[felt]
    return float(np.interp(0.5 * r[-1], r, fields.pressure[felt]))
