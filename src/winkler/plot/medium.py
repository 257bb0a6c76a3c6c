"""What a medium is like: Young's modulus from the surface down, and the stiffness of its springs from the middle out.

Layers are bands, gradings are curves, a rigid base is hatched.  For a bed that was measured, the stiffness of the whole
contact takes the place of the modulus, with the points that were given.
"""

from __future__ import annotations

import dataclasses
from typing import Any, NamedTuple

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
from winkler.plot.panel import Area, Axis, Line, Panel, Rule, Text
from winkler.plot.series import scale_of, series, told

__all__ = [
    "OFF_AXIS",
    "body_is_known",
    "interfaces",
    "is_varied",
    "makeup_panel",
    "spring_stiffness_panel",
    "stiffness_panel",
    "stiffness_words",
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


def makeup_panel(medium: Medium, end: float, radius: float = 0.0) -> Panel:
    """Return Young's modulus over the depth below the surface, depth downwards.

    Parameters
    ----------
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
    # a law without bounds at the surface: what lies within the upper percent of the depth shall not set the scale
    top = float(max(np.max(part.young[part.z >= 0.01 * end], initial=0.0) for part in parts))
    right = 1.15 * (stiffest if stack else min(stiffest, top))
    marks: list[Any] = []
    for place, part in enumerate(parts):
        if np.max(part.young) == 0.0:
            marks.append(Area(part.z, 0.0, right, "#ffffff", 1.0, hatch="////", across=True))
            marks.append(Rule(float(part.z[0]), colour=style.INK, width=1.0))
        else:
            tint = TINTS[place % len(TINTS)]
            marks.append(Area(part.z, 0.0, np.minimum(part.young, right), tint, 1.0, across=True))
            marks.append(Line(part.young, part.z, style.INK, width=1.6, blunt=True))
        if part.told:
            middle = 0.5 * (part.z[0] + min(part.z[-1], end))
            marks.append(
                Text(0.04, middle, part.told, across="left", size=8.0, boxed=0.75, pad=1.0, framed=(True, False))
            )
    for above, below in zip(parts, parts[1:], strict=False):
        step = np.array([above.young[-1], below.young[0]])
        marks.append(Line(step, np.full(2, below.z[0]), style.INK, width=1.6))
    if 0.0 < radius < end:
        marks.append(Rule(radius, colour=style.RED, width=1.0, dash=style.DASHED))
        words: dict[str, Any] = {"across": "right", "upright": "bottom", "colour": style.RED, "framed": (True, False)}
        marks.append(Text(0.97, radius, "$z = a$", **words))
    across = Axis.of(series("young", np.zeros(1)), scale_of("Pa", [stiffest]), low=0.0, high=right)
    upright = Axis.of(series("z", np.zeros(1)), scale_of("m", [end]), low=end, high=0.0)
    return Panel(tuple(marks), across, upright, grid="")


def spring_stiffness_panel(medium: Medium, end: float, radius: float = 0.0) -> Panel:
    """Return the stiffness of the springs over x; a dotted line shows what the uppermost layer alone would give.

    Parameters
    ----------
    medium : Medium
    end : float
        Greatest x [m].
    radius : float
        Radius of a contact [m], marked; zero for none.
    """
    x = end * np.linspace(0.0, 1.0, 401)[1:] ** 2
    stiffness = np.asarray(medium.normal_stiffness(x), dtype=float)
    top = float(np.max(stiffness[x >= 0.01 * end]))
    upright = Axis.of(series("normal_stiffness", stiffness), scale_of("Pa", [top]), low=0.0)
    marks: list[Any] = [Line(x, stiffness, style.RED, name="springs, $c_N(x)$")]
    layered = isinstance(medium, CoatedHalfSpace | DepthGradedHalfSpace)
    if isinstance(medium, CoatedHalfSpace | DepthGradedHalfSpace):
        above = float(medium.modulus)
        name = f"uppermost solid alone, {told(above, 'Pa')}"
        marks.append(Rule(above, width=1.0, dash=style.DOTTED, name=name))
        top = max(top, above)
    if 0.0 < radius < end:
        marks.append(Rule(radius, upright=True, colour=style.INK, width=0.9, dash=style.DASHED))
        words: dict[str, Any] = {"across": "left", "upright": "baseline", "size": 9.0, "framed": (False, True)}
        marks.append(Text(radius, 0.02, "$a$", right=3.0, **words))
    across = Axis.of(series("x", x), scale_of("m", [end]), low=0.0, high=end)
    upright = dataclasses.replace(upright, high=1.12 * top)
    return Panel(tuple(marks), across, upright, legend="best" if layered else "")


def body_is_known(bed: Bed) -> bool:
    """Return whether a bed tells body and pressure: one that was measured, or whose contact is no disc, does not."""
    return isinstance(bed.footprint, Round) and not isinstance(bed, MeasuredBed)


def stiffness_panel(bed: Bed, to: float, radius: float = 0.0) -> Panel:
    """Return the stiffness of the contact over its radius, and what was measured of it.

    Parameters
    ----------
    bed : Bed
    to : float
        Greatest radius [m] of a bed that was not measured.
    radius : float
        Radius of a contact [m], marked; zero for none.
    """
    end = bed.reach if isinstance(bed, MeasuredBed) else min(to, bed.reach)
    a = np.linspace(0.0, end, 301)[1:]
    stiffness = np.asarray(bed.stiffness(a), dtype=float)
    marks = [Line(a, stiffness)]
    if isinstance(bed, MeasuredBed):
        few = bed.radii.size <= 60
        look: dict[str, Any] = {"marker": "o" if few else ".", "size": 4.0 if few else 2.0}
        name = f"{bed.radii.size} points given"
        marks.append(Line(bed.radii, bed.stiffnesses, style.ORANGE, width=0.0, name=name, **look))
    if radius > 0.0:
        here = bed.stiffness(np.array([radius]))
        marks.append(Line(np.array([radius]), here, style.RED, width=0.0, marker="o", name="this contact"))
    across = Axis.of(series("radius", a), scale_of("m", [end]), low=0.0, high=1.02 * end)
    of = series("stiffness", stiffness)
    upright = Axis.of(of, low=0.0, high=1.08 * float(np.max(stiffness)))
    return Panel(tuple(marks), across, upright, legend="lower right")


def stiffness_words(bed: Bed, end: float) -> str:
    """Return how stiff the springs of a bed are up to a place [m], for reading."""
    stiffness = np.asarray(bed.normal_stiffness(min(end, bed.reach) * np.linspace(0.01, 1.0, 65)), dtype=float)
    if not is_varied(stiffness):
        return f"of {told(float(stiffness[0]), 'Pa')}"
    return f"of {told(float(stiffness[0]), 'Pa', 3)} (middle) to {told(float(stiffness[-1]), 'Pa', 3)}"
