"""Pictures of a medium: Young's modulus over the depth, and the stiffness of its springs over x.

Layers are bands, gradings are curves, a rigid base is hatched.  For a measured bed, the stiffness of the whole
contact replaces the modulus, with the measured points.
"""

from __future__ import annotations

import dataclasses
from typing import Any, NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.footprint import RoundOutline
from winkler.materials.elastic import Elastic, Rigid, TransverselyIsotropic
from winkler.materials.layered import Layer, StackLayer
from winkler.media.medium import Medium
from winkler.media.offers import GradedInDepth, LayerStack, PowerOfDepth, PressedWaves, offers
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.panel import Area, Line, Panel, PanelAxis, Rule, Text, points
from winkler.plot.series import scale_of, series, with_unit
from winkler.values.checks.contract import is_a
from winkler.values.errors import InvalidInput

LEAST_VARIATION = 1e-3
"""Relative variation of stiffness below which springs are drawn and described as equal."""
BESIDE_LAYERS = 2.7
"""Width of the axis of moduli over the greatest modulus: the names of layers stand beside their moduli."""
MOST_BELOW_LAYERS = 8.0
"""Depth that is drawn of a body below its layers, over the depth of the lowest: a thin coating stays visible."""
OFFSET_FROM_AXIS = 1e-6
"""Relative distance from the axis, where stiffnesses may be zero or infinite, at which they are evaluated."""
LABEL_HEIGHT = 0.075
"""Least distance of two labels of layers, over the drawn depth."""
DEPTH_SCALES_DRAWN = 3.0
"""Drawn depth of a power-law gradation in its depth scales, without a contact."""
MEASURED_BED = "winkler.foundation.measured:MeasuredBed"
TINTS = ("#d8c28f", "#efe3c8", "#c9b27a", "#e5d5ae")


class DepthInterval(NamedTuple):
    """An interval of depth with E(z) and its label."""

    z: Array
    young: Array
    label: str


def interfaces(medium: object) -> tuple[float, ...]:
    """Return the depths of the interfaces between layers and under the last one [m]; none if there are no layers."""
    if not offers(medium, LayerStack):
        return ()
    return tuple(float(z) for z in np.cumsum([layer.thickness for layer in medium.layers]))


def is_varied(stiffness: Array) -> bool:
    """Return whether springs differ visibly; an infinite stiffness in the middle counts."""
    finite = stiffness[np.isfinite(stiffness)]
    return bool(finite.size < stiffness.size or np.ptp(finite) > LEAST_VARIATION * np.max(finite))


def typical_width(medium: Medium) -> float:
    """Return a characteristic length [m] of a medium for its picture.

    Raises
    ------
    InvalidInput
        If it has no length of its own.
    """
    if offers(medium, LayerStack):
        return 4.0 * interfaces(medium)[-1]
    if offers(medium, GradedInDepth):
        return 2.0 * medium.grading.settled_at(0.05)
    if offers(medium, PowerOfDepth):
        return DEPTH_SCALES_DRAWN * medium.depth_scale
    raise _uniform_medium(medium)


def _uniform_medium(medium: Medium) -> InvalidInput:
    return InvalidInput(
        f"draw: a {type(medium).__name__} is the same at every depth, so that there is nothing to show; draw a "
        "Foundation(profile, medium)."
    )


def _layer_intervals(medium: LayerStack, end: float) -> list[DepthInterval]:
    intervals, top, laid = [], 0.0, ""
    for place, layer in enumerate(medium.stack):
        bottom = top + layer.thickness
        name = f"layer {place + 1}: " if len(medium.layers) > 1 else "layer: "
        intervals.append(_layer_interval(layer, top, bottom, f"{laid}{name}"))
        top = bottom
        laid = "" if layer.bonded else "slides on "
    laid = laid.strip() or "on"
    if not isinstance(medium.on, Rigid):
        z, young = np.array([top, max(end, top)]), np.full(2, _young(medium.on))
        intervals.append(DepthInterval(z, young, f"{laid} {_solid_text(medium.on)}"))
    else:
        intervals.append(DepthInterval(np.array([top, max(end, top)]), np.zeros(2), f"{laid} a rigid base"))
    return intervals


def _layer_interval(layer: Layer | StackLayer, top: float, bottom: float, name: str) -> DepthInterval:
    label = f"{name}{with_unit(layer.thickness, 'm')}, {_solid_text(layer.solid)}"
    return DepthInterval(np.array([top, bottom]), np.full(2, _young(layer.solid)), label)


def _young(solid: Elastic | TransverselyIsotropic) -> float:
    """Return Young's modulus [Pa]; along the depth, if it depends on the direction."""
    if isinstance(solid, Elastic):
        return solid.young
    return solid.c33 - 2.0 * solid.c13**2 / (solid.c11 + solid.c12)


def _solid_text(solid: Elastic | TransverselyIsotropic) -> str:
    if isinstance(solid, TransverselyIsotropic):
        return f"$E_z$ = {with_unit(_young(solid), 'Pa', 3)}"
    return f"$E$ = {with_unit(solid.young, 'Pa')}, $\\nu$ = {with_unit(solid.poisson, '')}"


def _intervals(medium: Medium, end: float) -> list[DepthInterval]:
    """Return the first body from the surface down to `end` [m]."""
    if offers(medium, LayerStack):
        return _layer_intervals(medium, end)
    if offers(medium, GradedInDepth):
        grading = medium.grading
        z = np.unique(np.concatenate([np.linspace(0.0, end, 400), [b for b in grading.breaks if b < end]]))
        return [DepthInterval(z, grading.young_at(z), "")]
    if is_a(medium, "winkler.media.graded.power_law:GradedHalfSpace"):
        bodies: Any = medium
        body = bodies.second if isinstance(bodies.first, Rigid) else bodies.first
        z = end * np.linspace(0.0, 1.0, 401)[1:] ** 2
        note = (
            f"$E$ = {with_unit(body.young, 'Pa')} · ($z$ / {with_unit(body.depth_scale, 'm')})$^{{{body.exponent:g}}}$"
        )
        return [DepthInterval(z, np.array([body.young_at(float(one)) for one in z]), note)]
    raise _uniform_medium(medium)


def _apart(middles: list[float], end: float) -> list[float]:
    """Return where labels of layers stand [m]: in their middles, or as near below each other as they can be read."""
    least = LABEL_HEIGHT * end
    places: list[float] = []
    for middle in middles:
        places.append(max(middle, places[-1] + least if places else 0.5 * least))
    low = end - 0.5 * least
    for index in reversed(range(len(places))):
        places[index] = min(places[index], low)
        low = places[index] - least
    return places


def makeup_panel(medium: Medium, end: float, radius: float = 0.0) -> Panel:
    """Return Young's modulus over the depth below the surface, depth downwards.

    Parameters
    ----------
    medium : CoatedHalfSpace, SlidingFilm, StackedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
    end : float
        Greatest depth [m].
    radius : float
        Radius of a contact [m], drawn on the surface's scale; zero for none.
    """
    stack = interfaces(medium)
    end = min(max(end, 1.3 * stack[-1]), MOST_BELOW_LAYERS * stack[-1]) if stack else end
    parts = _intervals(medium, end)
    stiffest = float(max(np.max(part.young) for part in parts))
    # a law without bounds at the surface: what lies within the upper percent of the depth does not set the scale
    top = float(max(np.max(part.young[part.z >= 0.01 * end], initial=0.0) for part in parts))
    right = BESIDE_LAYERS * stiffest if stack else 1.15 * min(stiffest, top)
    marks: list[Any] = []
    labels = _apart([0.5 * float(part.z[0] + min(part.z[-1], end)) for part in parts], end)
    for place, part in enumerate(parts):
        if np.max(part.young) == 0.0:
            marks.append(Area(part.z, 0.0, right, "#ffffff", 1.0, hatch="////", across=True))
            marks.append(Rule(float(part.z[0]), colour=style.INK, width=1.0))
        else:
            tint = TINTS[place % len(TINTS)]
            marks.append(Area(part.z, 0.0, np.minimum(part.young, right), tint, 1.0, across=True))
            marks.append(Line(part.young, part.z, style.INK, width=1.6, blunt=True))
        if part.label:
            look: dict[str, Any] = {"across": "left", "size": 8.0, "boxed": 0.75, "pad": 1.0}
            marks.append(
                Text(1.08 / BESIDE_LAYERS if stack else 0.04, labels[place], part.label, framed=(True, False), **look)
            )
    for above, below in zip(parts, parts[1:], strict=False):
        step = np.array([above.young[-1], below.young[0]])
        marks.append(Line(step, np.full(2, below.z[0]), style.INK, width=1.6))
    if 0.0 < radius < end:
        marks.append(Rule(radius, colour=style.RED, width=1.0, dash=style.DASHED))
        look = {"across": "left", "upright": "bottom", "colour": style.RED, "framed": (True, False)}
        marks.append(Text(0.03, radius, "$z = a$", **look))
    across = PanelAxis.of(series("young", np.zeros(1)), scale_of("Pa", [stiffest]), low=0.0, high=right)
    upright = PanelAxis.of(series("z", np.zeros(1)), scale_of("m", [end]), low=end, high=0.0)
    return Panel(tuple(marks), across, upright, grid="")


def spring_stiffness_panel(medium: Medium, end: float, radius: float = 0.0) -> Panel:
    """Return the stiffness of the springs over x; a dotted line marks that of the uppermost layer alone.

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
    upright = PanelAxis.of(series("normal_stiffness", stiffness), scale_of("Pa", [top]), low=0.0)
    marks: list[Any] = [Line(x, stiffness, style.RED, name="springs, $c_N(x)$")]
    layered = offers(medium, PressedWaves)
    if offers(medium, PressedWaves):
        above = float(medium.modulus)
        name = f"uppermost solid alone, {with_unit(above, 'Pa')}"
        marks.append(Rule(above, width=1.0, dash=style.DOTTED, name=name))
        top = max(top, above)
    if 0.0 < radius < end:
        marks.append(Rule(radius, upright=True, colour=style.INK, width=0.9, dash=style.DASHED))
        look: dict[str, Any] = {"across": "left", "upright": "baseline", "size": 9.0, "framed": (False, True)}
        marks.append(Text(radius, 0.02, "$a$", right=3.0, **look))
    across = PanelAxis.of(series("x", x), scale_of("m", [end]), low=0.0, high=end)
    upright = dataclasses.replace(upright, high=1.12 * top)
    return Panel(tuple(marks), across, upright, legend="best" if layered else "")


def body_is_defined(bed: Bed) -> bool:
    """Return whether body and pressure follow from a bed: not for a measured one, or one without a circular contact."""
    return isinstance(bed.footprint, RoundOutline) and not is_a(bed, MEASURED_BED)


def stiffness_panel(bed: Any, to: float, radius: float = 0.0) -> Panel:
    """Return the stiffness of the contact over its radius, with the measured points.

    Parameters
    ----------
    bed : Bed
    to : float
        Greatest radius [m], unless the bed is measured.
    radius : float
        Radius of a contact [m], marked; zero for none.
    """
    end = bed.reach if is_a(bed, MEASURED_BED) else min(to, bed.reach)
    a = np.linspace(0.0, end, 301)[1:]
    stiffness = np.asarray(bed.stiffness(a), dtype=float)
    marks = [Line(a, stiffness)]
    if is_a(bed, MEASURED_BED):
        few = bed.radii.size <= 60
        look: dict[str, Any] = {"marker": "o" if few else ".", "size": 4.0 if few else 2.0}
        name = f"{bed.radii.size} measured points"
        marks.append(Line(bed.radii, bed.stiffnesses, style.ORANGE, width=0.0, name=name, **look))
    if radius > 0.0:
        here = bed.stiffness(np.array([radius]))
        marks.append(points(radius, here, name="this contact"))
    across = PanelAxis.of(series("radius", a), scale_of("m", [end]), low=0.0, high=1.02 * end)
    of = series("stiffness", stiffness)
    upright = PanelAxis.of(of, low=0.0, high=1.08 * float(np.max(stiffness)))
    return Panel(tuple(marks), across, upright, legend="lower right")


def stiffness_text(bed: Bed, end: float) -> str:
    """Return the stiffness of the springs of a bed up to x = `end` [m] as text."""
    stiffness = np.asarray(bed.normal_stiffness(min(end, bed.reach) * np.linspace(0.01, 1.0, 65)), dtype=float)
    if not is_varied(stiffness):
        return f"of {with_unit(float(stiffness[0]), 'Pa')}"
    return f"of {with_unit(float(stiffness[0]), 'Pa', 3)} (middle) to {with_unit(float(stiffness[-1]), 'Pa', 3)}"
