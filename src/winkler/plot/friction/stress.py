"""The stress below a sheared contact, which is not symmetric any more: a map of the plane along the motion."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.fields import restore_body
from winkler.foundation.sheared import ShearedSprings
from winkler.foundation.sheared_fields import BodyFields
from winkler.materials.elastic import Rigid
from winkler.peaks import peak_stress
from winkler.plot import style
from winkler.plot.friction.curves import Restored
from winkler.plot.series import Scale, scale_of, series, told

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_body_stress", "draw_dragged_stress"]

ACROSS, DOWN = 113, 49
DEEP = 1.6
"""Depth of the map in contact radii."""
LEVELS = 20


def draw_dragged_stress(axes: Axes, sheared: ShearedSprings, extent: float) -> None:
    """Draw the von Mises stress in the plane y = 0 of a sheared contact, and mark where it is greatest.

    Parameters
    ----------
    axes : Axes
        Empty.
    sheared : ShearedSprings
        Of a contact.
    extent : float
        [m].

    Raises
    ------
    OutsideValidity
        If the stresses inside this medium are not known.
    """
    solution, radius = Restored(sheared), sheared.pressed.radius
    sign = -1.0 if isinstance(getattr(sheared.pressed.bed.medium, "first", None), Rigid) else 1.0
    x = np.linspace(-extent, extent, ACROSS)
    z = DEEP * radius * (np.linspace(0.0, 1.0, DOWN) ** 1.6 + 1e-3)
    fields = restore_body(solution, x[:, None], 0.0, sign * z[None, :])
    draw_body_stress(axes, fields)
    across = scale_of("m", fields.x, fields.z)
    peak = peak_stress(solution, below=sign > 0.0)
    corner = "lower centre" if sign > 0.0 else "upper centre"
    if np.isfinite(peak.von_mises):
        axes.plot(
            peak.x / across.factor,
            peak.z / across.factor,
            "P",
            color=style.RED,
            markeredgecolor="white",
            markersize=9,
            clip_on=False,
            zorder=9,
        )
        beside = f"$y$ = {told(peak.y, 'm', 3)}, " if abs(peak.y) > 1e-3 * radius else ""
        where = f"$x$ = {told(peak.x, 'm', 3)}, {beside}$z$ = {told(peak.z, 'm', 3)}"
        style.note(axes, f"greatest: {told(peak.von_mises, 'Pa')} at {where}", where=corner)
    else:
        style.note(axes, "infinite at a sharp edge, kink or tip", where=corner)
    line = np.array([-radius, radius]) / across.factor
    axes.plot(line, np.zeros(2), color=style.INK, linewidth=3.0, clip_on=False, solid_capstyle="butt", zorder=8)


def draw_body_stress(axes: Axes, fields: BodyFields) -> None:
    """Draw the von Mises stress of fields that were restored on a grid of x and z.

    Parameters
    ----------
    axes : Axes
        Empty.
    fields : BodyFields
        x and z of shape (n, m), one varying along either axis.

    Raises
    ------
    InvalidInput
        If they are no such grid.
    """
    x, z, stress = fields.x, fields.z, fields.von_mises
    if x.ndim != 2 or min(x.shape) < 2:
        raise InvalidInput(
            "draw: the fields were not restored on a grid of x and z; give restore_body(solution, x[:, None], y, "
            "z[None, :])."
        )
    known = np.isfinite(stress)
    if not known.any():
        raise InvalidInput("draw: none of the restored stresses is finite; restore them below the surface.")
    top, most = float(np.percentile(stress[known], 99.5)), float(np.max(stress[known]))
    levels = _levels(most if most < 1.25 * top else top)
    scale = scale_of("Pa", [levels[-1]])
    across: Scale = scale_of("m", x, z)
    shown = np.where(known, stress, 10.0 * levels[-1]) / scale.factor
    over = "max" if float(np.max(shown)) > levels[-1] / scale.factor else "neither"
    drawn = axes.contourf(
        x / across.factor, z / across.factor, shown, levels=levels / scale.factor, cmap=style.shades(), extend=over
    )
    axes.contour(
        x / across.factor,
        z / across.factor,
        shown,
        levels=levels[1:] / scale.factor,
        colors="white",
        linewidths=0.4,
        alpha=0.7,
    )
    assert axes.figure is not None
    label = series("BodyFields", "von_mises", stress).label(scale)
    bar: Any = axes.figure.colorbar(drawn, cax=axes.inset_axes((1.025, 0.0, 0.035, 1.0)), label=label)
    bar.outline.set_visible(False)
    bar.set_ticks(bar.get_ticks()[:: max(1, round(len(bar.get_ticks()) / 8))])
    axes.set_aspect("equal")
    axes.set_ylim(max(float(np.max(z)), 0.0) / across.factor, min(float(np.min(z)), 0.0) / across.factor)
    axes.set_xlabel(f"along the motion $x$ [{across.unit}]")
    axes.set_ylabel(series("BodyFields", "z", z).label(across))
    axes.grid(visible=False)


def _levels(top: float) -> Any:
    from matplotlib.ticker import MaxNLocator

    levels = np.asarray(MaxNLocator(LEVELS, steps=[1, 2, 2.5, 5, 10]).tick_values(0.0, top), dtype=float)
    return levels[levels >= 0.0]
