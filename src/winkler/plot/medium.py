"""What a medium is like: Young's modulus from the surface down, and the stiffness of its springs from the middle out.

Layers are bands, gradings are curves, a rigid base is hatched.  For a bed that was measured, the stiffness of the whole
contact takes the place of the modulus, with the points that were given.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from winkler.errors import InvalidInput
from winkler.footprint import Round
from winkler.foundation.bed import Bed
from winkler.foundation.measured import MeasuredBed
from winkler.materials.elastic import Elastic, Rigid
from winkler.materials.layered import Layer
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.media.medium import Medium
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.series import scale_of, series, told

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = [
    "OFF_AXIS",
    "draw_makeup",
    "draw_spring_stiffness",
    "draw_stiffness",
    "interfaces",
    "is_varied",
    "stiffness_told",
    "typical_width",
]

EVEN = 1e-3
"""Springs whose stiffness differs by less than this part look, and are called, equal."""
OFF_AXIS = 1e-6
"""Stiffnesses may be zero, infinite or unknown in the very middle; they are asked for so far beside it, relatively."""
GRADED_DEPTHS = 3.0
"""Power laws are shown down to so many of their depth scales, unless a contact says otherwise."""
TINTS = ("#d8c28f", "#efe3c8", "#c9b27a", "#e5d5ae")


class Made(NamedTuple):
    """One stretch of depth: E(z) on it, and what is written beside it."""

    z: Array
    young: Array
    told: str


def interfaces(medium: Medium) -> tuple[float, ...]:
    """Return the depths of the interfaces between layers and under the last one [m]; none if there are no layers."""
    if not isinstance(medium, CoatedHalfSpace):
        return ()
    return tuple(float(z) for z in np.cumsum([layer.thickness for layer in medium.layers]))


def is_varied(stiffness: Array) -> bool:
    """Return whether springs differ visibly; an infinite stiffness in the middle counts."""
    finite = stiffness[np.isfinite(stiffness)]
    return bool(finite.size < stiffness.size or np.ptp(finite) > EVEN * np.max(finite))


def typical_width(medium: Medium) -> float:
    """Return a distance [m] over which a medium shows what is special about it.

    Raises
    ------
    InvalidInput
        If it has no length of its own.
    """
    if isinstance(medium, CoatedHalfSpace):
        return 4.0 * interfaces(medium)[-1]
    if isinstance(medium, DepthGradedHalfSpace):
        return 2.0 * medium.grading.settled_at(0.05)
    if isinstance(medium, GradedHalfSpace):
        return GRADED_DEPTHS * medium.depth_scale
    raise _even(medium)


def _even(medium: Medium) -> InvalidInput:
    return InvalidInput(
        f"draw: a {type(medium).__name__} is the same at every depth, so that there is nothing to show; draw a "
        "Foundation(profile, medium)."
    )


def _of_layers(medium: CoatedHalfSpace, end: float) -> list[Made]:
    found, top = [], 0.0
    for place, layer in enumerate(medium.layers):
        bottom = top + layer.thickness
        found.append(_band(layer, top, bottom, f"layer {place + 1}: " if len(medium.layers) > 1 else "layer: "))
        top = bottom
    if isinstance(medium.on, Elastic):
        z, young = np.array([top, max(end, top)]), np.full(2, medium.on.young)
        found.append(Made(z, young, f"on {_told(medium.on)}"))
    else:
        found.append(Made(np.array([top, max(end, top)]), np.zeros(2), "on a rigid base"))
    return found


def _band(layer: Layer, top: float, bottom: float, name: str) -> Made:
    told_by = f"{name}{told(layer.thickness, 'm')}, {_told(layer.solid)}"
    return Made(np.array([top, bottom]), np.full(2, layer.solid.young), told_by)


def _told(solid: Elastic) -> str:
    return f"$E$ = {told(solid.young, 'Pa')}, $\\nu$ = {told(solid.poisson, '')}"


def _made(medium: Medium, end: float) -> list[Made]:
    """Return the first body from the surface down to `end` [m]."""
    if isinstance(medium, CoatedHalfSpace):
        return _of_layers(medium, end)
    if isinstance(medium, DepthGradedHalfSpace):
        grading = medium.grading
        z = np.unique(np.concatenate([np.linspace(0.0, end, 400), [b for b in grading.breaks if b < end]]))
        return [Made(z, grading.young_at(z), "")]
    if isinstance(medium, GradedHalfSpace):
        body = medium.second if isinstance(medium.first, Rigid) else medium.first
        assert not isinstance(body, Rigid)
        z = end * np.linspace(0.0, 1.0, 401)[1:] ** 2
        note = f"$E$ = {told(body.young, 'Pa')} · ($z$ / {told(body.depth_scale, 'm')})$^{{{body.exponent:g}}}$"
        return [Made(z, np.array([body.young_at(float(one)) for one in z]), note)]
    raise _even(medium)


def draw_makeup(axes: Axes, medium: Medium, end: float, radius: float = 0.0) -> None:
    """Draw Young's modulus over the depth below the surface, depth downwards.

    Parameters
    ----------
    axes : Axes
        Empty.
    medium : CoatedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
    end : float
        Greatest depth [m].
    radius : float
        Radius of a contact [m], drawn on the surface's scale; zero for none.
    """
    stack = interfaces(medium)
    end = max(end, 1.3 * stack[-1] if stack else 0.0)
    parts = _made(medium, end)
    stiffest = float(max(np.max(part.young) for part in parts))
    down, along = scale_of("m", [end]), scale_of("Pa", [stiffest])
    # a law without bounds at the surface: what lies within the upper percent of the depth shall not set the scale
    top = float(max(np.max(part.young[part.z >= 0.01 * end], initial=0.0) for part in parts))
    right = 1.15 * (stiffest if stack else min(stiffest, top)) / along.factor
    for place, part in enumerate(parts):
        z, young = part.z / down.factor, part.young / along.factor
        if np.max(young) == 0.0:
            rigid: Any = {"facecolor": "white", "edgecolor": style.MUTED, "hatch": "////", "linewidth": 0.0}
            axes.fill_betweenx(z, 0.0, right, **rigid)
            axes.axhline(z[0], color=style.INK, linewidth=1.0)
        else:
            tint = TINTS[place % len(TINTS)]
            axes.fill_betweenx(z, 0.0, np.minimum(young, right), facecolor=tint, linewidth=0.0)
            axes.plot(young, z, color=style.INK, linewidth=1.6, solid_capstyle="butt")
        if part.told:
            axes.annotate(
                part.told,
                (0.04, 0.5 * (z[0] + min(z[-1], end / down.factor))),
                xycoords=("axes fraction", "data"),
                va="center",
                fontsize=8.0,
                zorder=8,
                bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "pad": 1.0},
            )
    for above, below in zip(parts, parts[1:], strict=False):
        axes.plot(
            [above.young[-1] / along.factor, below.young[0] / along.factor],
            np.full(2, below.z[0] / down.factor),
            color=style.INK,
            linewidth=1.6,
        )
    if 0.0 < radius < end:
        axes.axhline(radius / down.factor, color=style.RED, linewidth=1.0, linestyle=(0, (4, 3)))
        axes.annotate(
            "$z = a$",
            (0.97, radius / down.factor),
            xycoords=("axes fraction", "data"),
            color=style.RED,
            ha="right",
            va="bottom",
            fontsize=8.5,
        )
    axes.set_xlim(0.0, right)
    axes.set_ylim(end / down.factor, 0.0)
    axes.set_xlabel(series("Elastic", "young", np.zeros(1)).label(along))
    axes.set_ylabel(series("SubsurfaceFields", "z", np.zeros(1)).label(down))
    axes.grid(visible=False)


def draw_spring_stiffness(axes: Axes, medium: Medium, end: float, radius: float = 0.0) -> None:
    """Draw the stiffness of the springs over x; a dotted line tells what the uppermost layer alone would give.

    Parameters
    ----------
    axes : Axes
        Empty.
    medium : Medium
    end : float
        Greatest x [m].
    radius : float
        Radius of a contact [m], marked; zero for none.
    """
    x = end * np.linspace(0.0, 1.0, 401)[1:] ** 2
    stiffness = np.asarray(medium.normal_stiffness(x), dtype=float)
    shown = stiffness[x >= 0.01 * end]
    across, upright = scale_of("m", [end]), scale_of("Pa", [float(np.max(shown))])
    axes.plot(x / across.factor, stiffness / upright.factor, color=style.RED, label="springs, $c_N(x)$")
    top = float(np.max(shown))
    if isinstance(medium, CoatedHalfSpace | DepthGradedHalfSpace):
        above = medium.modulus
        axes.axhline(
            above / upright.factor,
            color=style.MUTED,
            linewidth=1.0,
            linestyle=":",
            label=f"uppermost solid alone, {told(above, 'Pa')}",
        )
        top = max(top, above)
        style.framed_legend(axes, loc="best")
    if 0.0 < radius < end:
        axes.axvline(radius / across.factor, color=style.INK, linewidth=0.9, linestyle=(0, (4, 3)))
        axes.annotate(
            "$a$",
            (radius / across.factor, 0.02),
            xycoords=("data", "axes fraction"),
            fontsize=9.0,
            xytext=(3, 0),
            textcoords="offset points",
        )
    axes.set_xlim(0.0, end / across.factor)
    axes.set_ylim(0.0, 1.12 * top / upright.factor)
    axes.set_xlabel(series("Foundation", "x", x).label(across))
    axes.set_ylabel(series("Foundation", "normal_stiffness", stiffness).label(upright))


def body_is_known(bed: Bed) -> bool:
    """Return whether a bed tells body and pressure: one that was measured, or whose contact is no disc, does not."""
    return isinstance(bed.footprint, Round) and not isinstance(bed, MeasuredBed)


def draw_stiffness(axes: Axes, bed: Bed, to: float, radius: float = 0.0) -> None:
    """Draw the stiffness of the contact over its radius, and what was measured of it.

    Parameters
    ----------
    axes : Axes
        Empty.
    bed : Bed
    to : float
        Greatest radius [m] of a bed that was not measured.
    radius : float
        Radius of a contact [m], marked; zero for none.
    """
    end = bed.reach if isinstance(bed, MeasuredBed) else min(to, bed.reach)
    a = np.linspace(0.0, end, 301)[1:]
    stiffness = np.asarray(bed.stiffness(a), dtype=float)
    across, upright = scale_of("m", [end]), scale_of("N/m", stiffness)
    axes.plot(a / across.factor, stiffness / upright.factor, color=style.BLUE)
    if isinstance(bed, MeasuredBed):
        few = bed.radii.size <= 60
        axes.plot(
            bed.radii / across.factor,
            bed.stiffnesses / upright.factor,
            "o" if few else ".",
            color=style.ORANGE,
            markersize=4.0 if few else 2.0,
            label=f"{bed.radii.size} points given",
        )
    if radius > 0.0:
        here = float(bed.stiffness(np.array([radius]))[0])
        axes.plot([radius / across.factor], [here / upright.factor], "o", color=style.RED, label="this contact")
    axes.set_xlim(0.0, 1.02 * end / across.factor)
    axes.set_ylim(0.0, 1.08 * float(np.max(stiffness)) / upright.factor)
    axes.set_xlabel(series("IndentationSolution", "radius", a).label(across))
    axes.set_ylabel(series("IndentationSolution", "stiffness", stiffness).label(upright))
    if axes.get_legend_handles_labels()[0]:
        style.framed_legend(axes, loc="lower right")


def stiffness_told(bed: Bed, end: float) -> str:
    """Return how stiff the springs of a bed are up to a place [m], for reading."""
    stiffness = np.asarray(bed.normal_stiffness(min(end, bed.reach) * np.linspace(0.01, 1.0, 65)), dtype=float)
    if not is_varied(stiffness):
        return f"of {told(float(stiffness[0]), 'Pa')}"
    return f"of {told(float(stiffness[0]), 'Pa', 3)} (middle) to {told(float(stiffness[-1]), 'Pa', 3)}"
