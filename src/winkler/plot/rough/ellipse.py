"""Sheets of Hertz's ellipse: pressure over it and stresses below both axes, many loads, onset of yield."""

from __future__ import annotations

import numpy as np

from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.plot import style
from winkler.plot.curves import curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.normal.stresses import stress_map
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, titled
from winkler.plot.rough.roughness import framed, image_of
from winkler.plot.series import row_of, scale_of, series, with_unit
from winkler.problems.normal.elliptic import EllipticSolution
from winkler.problems.normal.elliptic_yielding import EllipticYieldOnsetSolution
from winkler.values.errors import OutsideValidity

PIXELS_ACROSS = 201
ACROSS, DOWN = 81, 49
"""Places of a map of stresses."""
SEMI_AXES_DRAWN, DEPTH_DRAWN = 1.6, 1.6
"""Half the width of a map of stresses, and its depth, in semi-axes; the depth in those of the plane or less."""
SLENDER = 5.0
"""Ratio of the semi-axes beyond which the map below the larger one is stretched in depth."""
NEEDLE = 20.0
"""Ratio of the semi-axes beyond which the map of the pressure has a scale of its own for either axis."""
TOP = 1e-6
"""Depth of the first row of a map, in semi-axes."""


@without_extent(EllipticSolution)
def ellipse_sheet(item: EllipticSolution) -> Sheet:
    """Return the pressure over the ellipse and stresses below its axes; of many loads force and semi-axes."""
    if np.ndim(item.depth) == 0:
        if item.force == 0.0:
            raise OutsideValidity("draw: the bodies do not touch, so there is nothing to show; press harder.")
        title = f"{with_unit(float(item.force), 'N')} at a depth of {with_unit(float(item.depth), 'm')}"
        return Sheet((_ellipse_panel(item), *_stress_panels(item)), width=4.8, height=3.4, title=title)
    depth = row_of(item, "depth")
    semi_axes = [(row_of(item, f"{name}_semi_axis"), f"${a}$") for name, a in (("longitudinal", "a"), ("lateral", "b"))]
    panels = curves_panel(depth, [(row_of(item, "force"), "")]), curves_panel(depth, semi_axes, label="semi-axes")
    return Sheet(titled(panels, "force over depth", "semi-axes over depth"), height=3.2)


def _ellipse_panel(item: EllipticSolution) -> Panel:
    semi_axes = np.array([float(item.longitudinal_semi_axis), float(item.lateral_semi_axis)])
    stretched = np.max(semi_axes) > NEEDLE * np.min(semi_axes)
    half = 1.2 * (semi_axes if stretched else np.full(2, np.max(semi_axes)))
    places = (2.0 * np.arange(PIXELS_ACROSS) + 1.0) / PIXELS_ACROSS - 1.0
    pressure = item.pressure(half[0] * places[:, None], half[1] * places[None, :])
    drawn = series("pressure", np.where(pressure > 0.0, pressure, np.nan))
    sides = half[:, None] * np.array([-1.0, 1.0])
    panel = framed(image_of(drawn, style.SHADES, tuple(sides))).plus(title="pressure over the ellipse")
    if not stretched:
        return panel
    x, y = (PanelAxis(f"${name}$", scale_of("m", np.array([length]))) for name, length in zip("xy", half, strict=True))
    return panel.plus(across=x, upright=y, title="pressure over the ellipse, scales differ", equal=False)


@without_extent(EllipticYieldOnsetSolution)
def ellipse_yield_sheet(item: EllipticYieldOnsetSolution) -> Sheet:
    """Return the von Mises stress below both axes at the onset, in the body that yields; on layers the place."""
    problem = item.problem
    title = f"onset of yield: {with_unit(item.force, 'N')}"
    first = bool(np.copysign(1.0, item.z) > 0.0)
    if not isinstance(problem.medium, HalfSpace):  # stresses in layers are sought, not mapped
        place = Line(np.array([item.x]), np.array([item.y]), "white", width=0.0, marker="+", size=9.0)
        deep = with_unit(abs(item.z), "m")
        panel = _ellipse_panel(item.contact).plus(place)
        return Sheet((panel.plus(title=f"pressure; + yields, {deep} deep"),), width=5.0, height=3.6, title=title)
    panels = _stress_panels(item.contact, first, problem.friction.coefficient, problem.angle)
    near = (item.y, item.x)
    drawn = []
    for panel, along, aside in zip(panels, (item.x, item.y), near, strict=True):
        inside = abs(aside) <= 1e-6 * max(item.longitudinal_semi_axis, item.lateral_semi_axis)
        place = Line(np.array([along]), np.array([item.z]), "white", width=0.0, marker="+", size=9.0)
        drawn.append(panel.plus(place) if inside else panel)
    return Sheet(tuple(drawn), width=5.0, height=3.3, title=title)


def _stress_panels(
    item: EllipticSolution, first: bool | None = None, friction: float = 0.0, angle: float = 0.0
) -> tuple[Panel, ...]:
    """Return the von Mises stress below x and below y; nothing where no body has stresses that are known."""
    medium = item.problem.medium
    if first is None:
        known = [isinstance(getattr(medium, name, None), Elastic) for name in ("first", "second")]
        if not any(known) or not isinstance(medium, HalfSpace):
            return ()
        first = known[0]
    sign = 1.0 if first else -1.0
    semi_axes = float(item.longitudinal_semi_axis), float(item.lateral_semi_axis)
    panels = []
    for axis, name in enumerate("xy"):
        along = SEMI_AXES_DRAWN * semi_axes[axis] * np.linspace(-1.0, 1.0, ACROSS)
        depth = DEPTH_DRAWN * min(2.0 * min(semi_axes), semi_axes[axis]) * np.linspace(0.0, 1.0, DOWN) ** 1.6
        across, down = np.broadcast_arrays(along[:, None], sign * depth)
        below = down + sign * TOP * min(semi_axes)
        x, y = (across, 0.0) if axis == 0 else (0.0, across)
        stress = series("von_mises", item.stresses(x, y, below, friction, angle).von_mises)
        panel = stress_map(series(name, across), series("z", down), stress, f"${name}$")
        low = semi_axes[axis] > SLENDER * min(semi_axes)
        panels.append(panel.plus(title=f"von Mises stress below ${name}$", equal=not low))
    return tuple(panels)
