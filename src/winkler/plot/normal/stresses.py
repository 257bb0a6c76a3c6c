"""The stress below a contact: a map of one half of the meridian plane, mirrored at the axis."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.fields import SubsurfaceFields, restore
from winkler.materials.elastic import Rigid
from winkler.media.medium import Medium
from winkler.numerics.types import Array
from winkler.peaks import PeakStress, peak_stress
from winkler.plot import style
from winkler.plot.extent import is_singular
from winkler.plot.medium import interfaces
from winkler.plot.series import scale_of, series, told
from winkler.problems.answer import Restorable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_along", "draw_field", "draw_stress", "mark_interfaces", "stressed_first"]

ACROSS, DOWN = 57, 49
DEEP = 2.0
"""Depth of the map in contact radii."""
LEVELS = 20
NEXT_TO = 1e-9
"""How far beside an interface its two sides are shown, relative to its depth."""


def stressed_first(solution: Restorable) -> bool:
    """Return whether the first body (z > 0) deforms; if it is rigid, the second one is shown."""
    return not isinstance(getattr(solution.pressed.bed.medium, "first", None), Rigid)


def draw_stress(axes: Axes, solution: Restorable, extent: float, radius: float) -> None:
    """Draw the von Mises stress below a contact, and mark where it is greatest.

    Parameters
    ----------
    axes : Axes
        Empty.
    solution
        For one load, with a contact.
    extent : float
        Drawn up to this distance from the axis [m].
    radius : float
        Contact radius [m].

    Raises
    ------
    OutsideValidity
        If the stresses inside this medium are not known.
    """
    below = stressed_first(solution)
    sign, corner = (1.0, "lower centre") if below else (-1.0, "upper centre")
    r = np.linspace(0.0, extent, ACROSS)
    # denser towards the surface; the last bit above zero is enough to stay off the poles of sharp edges
    z = DEEP * radius * (np.linspace(0.0, 1.0, DOWN) ** 1.6 + 1e-3)
    borders = np.array([h for h in interfaces(solution.pressed.bed.medium) if below and h < z[-1]])
    if borders.size:  # stresses jump there: one row of places on either side
        z = np.unique(np.concatenate([z, borders * (1.0 - NEXT_TO), borders * (1.0 + NEXT_TO)]))
    fields = restore(solution, r[:, None], sign * z[None, :])
    draw_field(axes, fields)
    across = scale_of("m", fields.r, fields.z)
    mark_interfaces(axes, fields, solution.pressed.bed.medium)
    if is_singular(solution.pressed):
        style.note(axes, "infinite at a sharp edge, kink or tip", where=corner)
    else:
        peak = _peak(solution, fields, below=below)
        axes.plot(peak.r / across.factor, peak.z / across.factor, "+", color="white", markersize=9, markeredgewidth=1.8)
        where = f"at $z$ = {told(peak.z, 'm', 3)}" + (
            f", $r$ = {told(peak.r, 'm', 3)}" if peak.r > 1e-3 * radius else ""
        )
        style.note(axes, f"greatest: {told(peak.von_mises, 'Pa')} {where}", where=corner)
    line = np.array([-radius, radius]) / across.factor
    axes.plot(line, np.zeros(2), color=style.RED, linewidth=3.0, clip_on=False, solid_capstyle="butt", zorder=8)


def mark_interfaces(axes: Axes, fields: SubsurfaceFields, medium: Medium) -> None:
    """Draw the interfaces of a coating into the map of a stress; nothing if there are none, or above the surface.

    Parameters
    ----------
    axes : Axes
        That of the map.
    fields : SubsurfaceFields
        What the map shows.
    medium : Medium
    """
    across = scale_of("m", fields.r, fields.z)
    for depth in interfaces(medium):
        if depth < np.max(fields.z):
            axes.axhline(depth / across.factor, color=style.INK, linewidth=0.9, linestyle=(0, (4, 2)), zorder=7)


def _peak(solution: Restorable, fields: SubsurfaceFields, *, below: bool) -> PeakStress:
    """Return the greatest stress: searched for where it is smooth, among the drawn places where layers make it jump."""
    if not interfaces(solution.pressed.bed.medium):
        return peak_stress(solution, below=below)
    place = np.unravel_index(np.nanargmax(fields.von_mises), fields.r.shape)
    return PeakStress(*(float(part[place]) for part in (fields.von_mises, fields.r, fields.z)))


def draw_field(axes: Axes, fields: SubsurfaceFields) -> None:
    """Draw the von Mises stress of fields that were restored on a grid, mirrored at the axis.

    Parameters
    ----------
    axes : Axes
        Empty.
    fields : SubsurfaceFields
        r and z of shape (n, m), one varying along either axis.
    """
    r, z, stress = (np.asarray(part, dtype=float) for part in (fields.r, fields.z, fields.von_mises))
    if np.ptp(r, axis=0).max() == 0.0:
        r, z, stress = r.T, z.T, stress.T
    r, z, stress = _ordered(r, z, stress)
    fits = np.isfinite(stress)
    if not fits.any():
        raise InvalidInput(
            "draw: none of the restored stresses is finite; restore the fields below the surface, z > 0."
        )
    top, most = float(np.percentile(stress[fits], 99.5)), float(np.max(stress[fits]))
    top = most if most < 1.25 * top else top
    levels = _levels(top)
    scale = scale_of("Pa", [levels[-1]])
    across = scale_of("m", r, z)
    x = np.concatenate([-r[::-1], r]) if r[0, 0] > 0.0 else np.concatenate([-r[:0:-1], r])
    y = np.concatenate([z[::-1], z]) if r[0, 0] > 0.0 else np.concatenate([z[:0:-1], z])
    c = np.concatenate([stress[::-1], stress]) if r[0, 0] > 0.0 else np.concatenate([stress[:0:-1], stress])
    c = np.where(np.isfinite(c), c, 10.0 * levels[-1])
    over = "max" if float(np.max(c)) > levels[-1] else "neither"
    shown = axes.contourf(
        x / across.factor,
        y / across.factor,
        c / scale.factor,
        levels=levels / scale.factor,
        cmap=style.shades(),
        extend=over,
    )
    axes.contour(
        x / across.factor,
        y / across.factor,
        c / scale.factor,
        levels=levels[1:] / scale.factor,
        colors="white",
        linewidths=0.4,
        alpha=0.7,
    )
    told_by = series("SubsurfaceFields", "von_mises", c)
    assert axes.figure is not None
    bar: Any = axes.figure.colorbar(shown, cax=axes.inset_axes((1.025, 0.0, 0.035, 1.0)), label=told_by.label(scale))
    bar.outline.set_visible(False)
    bar.set_ticks(bar.get_ticks()[:: max(1, round(len(bar.get_ticks()) / 8))])
    axes.set_aspect("equal")
    axes.set_ylim(max(float(np.max(z)), 0.0) / across.factor, min(float(np.min(z)), 0.0) / across.factor)
    axes.set_xlabel(series("SubsurfaceFields", "r", r).label(across))
    axes.set_ylabel(series("SubsurfaceFields", "z", z).label(across))
    axes.grid(visible=False)


def _ordered(r: Array, z: Array, stress: Array) -> tuple[Array, Array, Array]:
    """Return the grid with r and z ascending."""
    rows, columns = np.argsort(r[:, 0], kind="stable"), np.argsort(z[0], kind="stable")
    return r[np.ix_(rows, columns)], z[np.ix_(rows, columns)], stress[np.ix_(rows, columns)]


def _levels(top: float) -> Array:
    """Return round levels from zero to just above `top`."""
    from matplotlib.ticker import MaxNLocator

    levels = np.asarray(MaxNLocator(LEVELS, steps=[1, 2, 2.5, 5, 10]).tick_values(0.0, top), dtype=float)
    return np.asarray(levels[levels >= 0.0])


def draw_along(axes: Axes, fields: SubsurfaceFields) -> None:
    """Draw all stresses along a line of places, over the coordinate that varies more.

    Parameters
    ----------
    axes : Axes
        Empty.
    fields : SubsurfaceFields
        r and z of shape (n,).
    """
    name = "z" if np.ptp(fields.z) >= np.ptp(fields.r) else "r"
    along = series("SubsurfaceFields", name, np.ravel(getattr(fields, name)))
    order = np.argsort(along.content, kind="stable")
    names = ("radial_stress", "hoop_stress", "axial_stress", "shear_stress", "von_mises")
    stresses = [series("SubsurfaceFields", one, np.ravel(getattr(fields, one))) for one in names]
    scale = scale_of("Pa", *(one.content for one in stresses))
    marker = "o" if order.size <= 40 else ""
    for place, one in enumerate(stresses):
        axes.plot(
            along.shown()[order],
            one.shown(scale)[order],
            color=style.CYCLE[place],
            marker=marker,
            markersize=3.5,
            linestyle=style.DASHES[place % len(style.DASHES)],
            label=one.label(scale).partition(" [")[0],
        )
    axes.axhline(0.0, color=style.MUTED, linewidth=0.8)
    axes.set_xlabel(along.label())
    axes.set_ylabel(f"stress [{scale.unit}]")
    style.framed_legend(axes, loc="best", ncols=1)
