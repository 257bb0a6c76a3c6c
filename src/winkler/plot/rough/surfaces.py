"""Sheets of contacts of height maps: where they touch, how hard, and what force, stiffness and resistance do."""

from __future__ import annotations

import dataclasses
import math
from typing import TYPE_CHECKING

import numpy as np

from winkler.plot import style
from winkler.plot.draw import draw
from winkler.plot.normal.springs import at_first_touch, draw_springs
from winkler.plot.rough.roughness import Band, draw_map, draw_models, heights_of
from winkler.plot.series import Series, series, told
from winkler.plot.viscoelastic.contacts import refuse_extent
from winkler.problems.rough.reduce import ReductionSolution
from winkler.problems.rough.surface_conduction import SurfaceConductionSolution
from winkler.problems.rough.surface_contact import SurfaceContactSolution
from winkler.problems.rough.surface_states import SurfaceState
from winkler.vocabulary import Word

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from winkler.numerics.types import Array, ArrayLike
    from winkler.plot.picture import Picture
    from winkler.profiles.rough.topography import Topography

__all__ = ["conduction_sheet", "contact_maps", "reduction_sheet", "surface_sheet"]

FEWEST = 2
"""Loads from which there are curves."""


def _draw_contact(axes: Axes, item: Topography, state: SurfaceState) -> None:
    """Draw where the surfaces touch, on the relief."""
    from matplotlib.colors import ListedColormap

    draw_map(axes, item, heights_of(item), style.reliefs(), label="height $z$", lowest=np.inf)
    touching = np.where(state.pressure > 0.0, 1.0, np.nan)
    image = axes.images[0]
    axes.imshow(
        touching.T,
        origin="lower",
        extent=image.get_extent(),
        cmap=ListedColormap([style.RED]),
        interpolation="nearest",
        vmin=0.0,
        vmax=1.0,
    )
    share = 100.0 * float(state.area) / item.area
    axes.set_title(f"contact (red): {share:.3g} % of the map")


def _draw_maps(panels: Array, item: Topography, state: SurfaceState) -> None:
    """Draw contact, pressure and distance."""
    _draw_contact(panels[0], item, state)
    pressed = series("SurfaceState", "pressure", np.where(state.pressure > 0.0, state.pressure, np.nan))
    draw_map(panels[1], item, pressed, style.shades())
    panels[1].set_title("pressure")
    draw_map(panels[2], item, series("SurfaceState", "separation", state.separation), style.shades())
    panels[2].set_title("distance of the surfaces")


def contact_maps(item: SurfaceContactSolution) -> Picture:
    """Return contact, pressure and distance under the last load."""
    with style.styled():
        figure = style.figure(3, width=4.0, height=3.3)
        _draw_maps(figure.subplots(1, 3), item.problem.topography, item.last)
        figure.suptitle(_headline(item.last))
    return figure


def _headline(state: SurfaceState) -> str:
    parts = [f"{told(state.force, 'N')} at a depth of {told(state.depth, 'm')}"]
    if math.isfinite(state.stiffness):
        parts.append(f"stiffness {told(state.stiffness, 'N/m')}")
    parts.append(f"mean distance {told(state.mean_gap, 'm', 3)}")
    return ";  ".join(parts)


def _share(area: ArrayLike, item: SurfaceContactSolution) -> Series:
    """Return which part of the map touches, in per cent."""
    part = 100.0 * np.ravel(np.asarray(area, dtype=float)) / item.problem.topography.area
    return Series("area", Word("", "", "part of the map in contact"), part)


def _along(item: SurfaceContactSolution | SurfaceConductionSolution, name: str) -> Series:
    return series(type(item), name, np.ravel(np.asarray(getattr(item, name), dtype=float)))


@draw.register(SurfaceContactSolution)
def surface_sheet(item: SurfaceContactSolution, *, extent: float | None = None) -> Picture:
    """Return the maps of the last load; of many loads also force, stiffness and area."""
    refuse_extent(item, extent)
    if np.size(item.force) < FEWEST:
        return contact_maps(item)
    with style.styled():
        figure = style.figure(3, 2, width=4.0, height=3.2)
        panels = figure.subplots(2, 3)
        _draw_maps(panels[0], item.problem.topography, item.last)
        for axes, (over, what) in zip(
            panels[1], (("depth", "force"), ("force", "stiffness"), ("force", "area")), strict=True
        ):
            of = _along(item, what)
            along = _along(item, over)
            of = _share(item.area, item) if what == "area" else of
            finite = np.isfinite(of.content)
            if finite.any():
                along, of = (dataclasses.replace(one, content=one.content[finite]) for one in (along, of))
                draw_models(axes, along, [(of, "")], label="part of the map in contact [%]" if what == "area" else "")
            axes.set_title(f"{'contact area' if what == 'area' else what} over {over}")
        figure.suptitle(
            f"greatest load: {_headline(item.last)}" if _rises(item) else f"last load: {_headline(item.last)}"
        )
    return figure


def _rises(item: SurfaceContactSolution) -> bool:
    return bool(item.last.force >= np.max(item.force))


@draw.register(SurfaceConductionSolution)
def conduction_sheet(item: SurfaceConductionSolution, *, extent: float | None = None) -> Picture:
    """Return stiffness, conductance and area over the force, by boundary elements and by the line, and the bounds."""
    refuse_extent(item, extent)
    item_forces = np.ravel(np.asarray(item.force, dtype=float))
    with style.styled():
        if item_forces.size < FEWEST:
            figure = style.figure(width=5.4, height=3.0)
            _draw_single(figure.subplots(), item)
            return figure
        figure = style.figure(3, width=4.0, height=3.3)
        panels = figure.subplots(1, 3)
        force = _along(item, "force")
        band = item.line.stiffness_band.reshape(2, -1)
        least, most = (np.ravel(np.asarray(part)) for part in (item.least_stiffness, item.greatest_stiffness))
        top = np.where(np.isfinite(most), most, 1e3 * np.max(np.asarray(item.stiffness)[np.isfinite(item.stiffness)]))
        draw_models(
            panels[0],
            force,
            [(_along(item, "stiffness"), "boundary elements"), (_along(item, "line_stiffness"), "lines of springs")],
            [Band(least, top, "bounds", style.MUTED), Band(band[0], band[1], "eight lines of ten", style.RED)],
        )
        panels[0].set_title("stiffness over force")
        conductance = _along(item, "conductance")
        factor = conductance.content / _along(item, "stiffness").content
        line = series(type(item), "conductance", factor * _along(item, "line_stiffness").content)
        draw_models(
            panels[1],
            force,
            [(conductance, "boundary elements"), (line, "lines of springs")],
            [
                Band(factor * least, factor * top, "bounds", style.MUTED),
                Band(factor * band[0], factor * band[1], "eight lines of ten", style.RED),
            ],
        )
        panels[1].set_title("conductance over force")
        touched, persson = (_share(part, item.contact) for part in (item.contact.area, item.line.area))
        draw_models(
            panels[2],
            force,
            [(touched, "boundary elements"), (persson, "Persson, same spectrum")],
            label="part of the map in contact [%]",
        )
        panels[2].set_title("contact area over force")
    return figure


def _draw_single(axes: Axes, item: SurfaceConductionSolution) -> None:
    """Draw the resistance of one load between its bounds."""
    names = ("least_resistance", "resistance", "line_resistance", "greatest_resistance")
    labels = ("lower bound", "boundary elements", "lines of springs", "upper bound")
    of = series(type(item), "resistance", np.array([float(np.ravel(getattr(item, name))[0]) for name in names]))
    axes.barh(range(4), of.shown(), color=[style.MUTED, style.BLUE, style.RED, style.MUTED], height=0.62)
    axes.set_yticks(range(4), labels)
    axes.invert_yaxis()
    axes.grid(visible=False, axis="y")
    axes.set_xlabel(of.label())
    axes.set_title(f"resistance under {told(float(np.ravel(np.asarray(item.force))[0]), 'N')}")


@draw.register(ReductionSolution)
def reduction_sheet(item: ReductionSolution, *, extent: float | None = None) -> Picture:
    """Return the computed contacts on the curve of the springs, their stiffness, and g(x) over the springs."""
    refuse_extent(item, extent)
    bed = item.bed
    radius = bed.radii[bed.depths >= 0.5 * float(np.min(item.depth))]
    d, k = bed.gap(radius), bed.stiffness(radius)
    curves = {"force": k * d - bed.gap_load(radius), "stiffness": k}
    with style.styled():
        figure = style.figure(3, width=3.9, height=3.3)
        panels = figure.subplots(1, 3)
        for axes, (name, of) in zip(panels, curves.items(), strict=False):
            along, upright = series("ReductionSolution", "depth", d), series("ReductionSolution", name, of)
            axes.plot(along.shown(), upright.shown(), color=style.BLUE, label="springs")
            axes.plot(
                item.depth / along.scale.factor,
                getattr(item, name) / upright.scale.factor,
                "o",
                color=style.RED,
                markersize=4.0,
                label="boundary elements",
            )
            axes.set_xlim(0.0, None)
            axes.set_ylim(0.0, None)
            axes.set_xlabel(along.label())
            axes.set_ylabel(upright.label())
            axes.set_title(f"{name} over depth")
            style.framed_legend(axes, loc="upper left" if name == "force" else "lower right")
        draw_springs(panels[2], at_first_touch(bed), bed.reach)
        panels[2].set_title("springs under $g(x)$")
    return figure
