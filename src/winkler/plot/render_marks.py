"""The marks of a panel drawn by matplotlib, each in the units of its axes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PatchCollection, PolyCollection
from matplotlib.colors import ListedColormap, LogNorm, Normalize, to_rgba_array
from matplotlib.patches import Circle
from matplotlib.ticker import ScalarFormatter

from winkler.plot import marks, style
from winkler.plot.axis import PanelAxis
from winkler.plot.render_axis import set_axis


def draw_mark(axes: Axes, mark: marks.Mark, across: float, upright: float) -> None:
    """Draw a mark, whose SI numbers are divided by the factors of both axes."""
    DRAWING_FUNCTIONS[type(mark)](axes, mark, across, upright)


def _colour(colour: Any) -> Any:
    """Return a colour in the form of matplotlib."""
    return colormaps[colour[0]](colour[1]) if isinstance(colour, tuple) and isinstance(colour[0], str) else colour


def _dashed(dash: tuple[float, ...]) -> Any:
    return (0, dash) if dash else "-"


def _line(axes: Axes, mark: marks.Line, across: float, upright: float) -> None:
    look: dict[str, Any] = {
        "color": _colour(mark.colour),
        "linewidth": mark.width,
        "linestyle": _dashed(mark.dash) if mark.width else "none",
        "marker": mark.marker,
        "markersize": mark.size,
        "label": mark.name or None,
        "zorder": mark.order,
        "clip_on": mark.clipped,
        "alpha": None if mark.alpha == 1.0 else mark.alpha,
        "rasterized": mark.coarse or None,
    }
    look |= {"markerfacecolor": "white"} if mark.hollow else {}
    look |= {"markeredgecolor": mark.edge} if mark.edge else {"markeredgewidth": 0.0} if mark.alpha < 1.0 else {}
    look |= {"markeredgewidth": 1.8} if mark.marker == "+" and mark.colour == "white" else {}
    look |= {"solid_capstyle": "butt"} if mark.blunt else {}
    x, y = mark.x / across, mark.y / upright
    if mark.error_x is None and mark.error_y is None:
        axes.plot(x, y, **look)
        return
    lengths: dict[str, Any] = {
        "xerr": None if mark.error_x is None else mark.error_x / across,
        "yerr": None if mark.error_y is None else mark.error_y / upright,
    }
    bars: dict[str, Any] = {"ecolor": mark.error_colour or None, "elinewidth": mark.width, "capsize": mark.cap}
    axes.errorbar(x, y, **lengths, **(look | {"linestyle": "none"}), **bars)


def _dots(axes: Axes, mark: marks.Dots, across: float, upright: float) -> None:
    axes.scatter(
        mark.x / across,
        mark.y / upright,
        s=mark.size,
        color=mark.colour,
        alpha=None if mark.alpha == 1.0 else mark.alpha,
        linewidths=0.0,
        rasterized=mark.coarse or None,
        label=mark.name or None,
    )


def _strokes(axes: Axes, mark: marks.Strokes, across: float, upright: float) -> None:
    lines = np.stack([mark.x / across, mark.y / upright], axis=-1)
    look: Any = {"colors": to_rgba_array(list(mark.colours), mark.alphas), "linewidths": mark.widths}
    axes.add_collection(LineCollection(list(lines), **look, zorder=mark.order))


def _area(axes: Axes, mark: marks.Area, across: float, upright: float) -> None:
    look: dict[str, Any] = {"color": _colour(mark.colour), "linewidth": 0.0, "label": mark.name or None}
    if mark.hatch:
        look = {"facecolor": mark.colour, "edgecolor": style.MUTED, "hatch": mark.hatch, "linewidth": 0.0}
    look |= {"zorder": mark.order, "alpha": None if mark.alpha == 1.0 else mark.alpha}
    if mark.across:
        axes.fill_betweenx(mark.x / upright, mark.low / across, mark.high / across, **look)
    else:
        axes.fill_between(mark.x / across, mark.low / upright, mark.high / upright, **look)


def _polygon(axes: Axes, mark: marks.Polygon, across: float, upright: float) -> None:
    axes.fill(
        mark.x / across,
        mark.y / upright,
        facecolor=_colour(mark.colour),
        alpha=None if mark.alpha == 1.0 else mark.alpha,
        edgecolor=_colour(mark.edge) if mark.edge else "none",
        linewidth=mark.width,
        zorder=mark.order,
    )


def _rule(axes: Axes, mark: marks.Rule, across: float, upright: float) -> None:
    look: dict[str, Any] = {
        "color": mark.colour,
        "linewidth": mark.width,
        "linestyle": _dashed(mark.dash),
        "label": mark.name or None,
        "zorder": mark.order,
    }
    if mark.point is not None:
        limits = axes.get_xlim(), axes.get_ylim()
        axes.axline((mark.point[0] / across, mark.point[1] / upright), slope=mark.slope * across / upright, **look)
        axes.set(xlim=limits[0], ylim=limits[1])
    elif mark.upright:
        axes.axvline(mark.at / across, **look)
    else:
        axes.axhline(mark.at / upright, **look)


def _band(axes: Axes, mark: marks.Band, across: float, _: float) -> None:
    look: Any = {"color": mark.colour, "alpha": mark.alpha, "linewidth": 0.0, "label": mark.name or "_"}
    axes.axvspan(mark.low / across, mark.high / across, **look)


def _text(axes: Axes, mark: marks.Text, across: float, upright: float) -> None:
    x, y = (
        number if framed else number / factor
        for number, framed, factor in zip((mark.x, mark.y), mark.framed, (across, upright), strict=True)
    )
    box = {"facecolor": "white", "edgecolor": "none", "alpha": mark.boxed, "pad": mark.pad}
    axes.annotate(
        mark.text,
        (x, y),
        (mark.right, 0.0),
        xycoords=("axes fraction" if mark.framed[0] else "data", "axes fraction" if mark.framed[1] else "data"),
        textcoords="offset points",
        ha=mark.across,
        va=mark.upright,
        color=mark.colour,
        fontsize=mark.size,
        zorder=mark.order,
        rotation=90.0 if mark.turned else 0.0,
        linespacing=mark.spacing,
        bbox=box if mark.boxed else None,
        annotation_clip=False,
    )


def _arrow(axes: Axes, mark: marks.Arrow, across: float, upright: float) -> None:
    look = {"color": mark.colour, "linewidth": mark.width, "arrowstyle": "<->" if mark.both else "-|>"}
    stop, start = ((x / across, y / upright) for x, y in (mark.stop, mark.start))
    arrow: Any = {**look, "shrinkA": 0, "shrinkB": 0}
    clip = None if mark.clipped else False
    axes.annotate("", stop, start, arrowprops=arrow, zorder=mark.order, annotation_clip=clip)


def _bars(axes: Axes, mark: marks.Bars, across: float, upright: float) -> None:
    errors: dict[str, Any] = {} if mark.ends is None else {"xerr": mark.ends / across}
    look: Any = {"ecolor": "black", "elinewidth": 0.8, "capsize": 2.0} if errors else {}
    axes.barh(
        mark.places / upright,
        mark.lengths / across,
        left=mark.start / across,
        height=mark.thick / upright,
        color=mark.colour,
        label=mark.name or None,
        error_kw=look,
        **errors,
    )


def _map(axes: Axes, mark: marks.Map, across: float, upright: float) -> None:
    factor = mark.bar.scale.factor
    x, y, z = mark.x / across, mark.y / upright, mark.z / factor
    colours = colormaps[mark.colours] if isinstance(mark.colours, str) else None
    low, high = (None if end is None else end / factor for end in (mark.bar.low, mark.bar.high))
    norm = (LogNorm if mark.bar.log else Normalize)(low, high)
    drawn: Any
    if mark.kind == "contours":
        levels = mark.levels / factor if isinstance(mark.levels, np.ndarray) else mark.levels
        single = {"colors": mark.colours} if colours is None else {"cmap": colours}
        drawn = axes.contourf(x, y, z, levels=levels, extend=mark.extend, alpha=mark.alpha, **single)
    elif mark.kind == "pixels":
        colour_map: Any = colours or ListedColormap(list(mark.colours))
        ends = (x[0], x[-1], y[0], y[-1])
        look: Any = {"cmap": colour_map, "norm": norm, "alpha": None if mark.alpha == 1.0 else mark.alpha}
        drawn = axes.imshow(z.T, origin="lower", extent=ends, interpolation="nearest", aspect="auto", **look)
    elif mark.kind == "discs":
        discs = [Circle((x[i], y[i]), radius) for i, radius in enumerate(mark.z / across)]
        drawn = PatchCollection(discs, cmap=colours, edgecolor=style.INK, linewidth=0.6)
        drawn.set_array(mark.levels)
        axes.add_collection(drawn)
        axes.autoscale_view()
    else:
        shading: Any = "gouraud" if mark.kind == "smooth" else "nearest" if z.shape[-1] == x.shape[-1] else "flat"
        content = np.ma.masked_invalid(z)
        drawn = axes.pcolormesh(x, y, content, cmap=colours, norm=norm, shading=shading, rasterized=True)
    if mark.line_width:
        levels = mark.lines / factor if isinstance(mark.lines, np.ndarray) else drawn.levels[0 if mark.lines else 1 :]
        look = {"colors": mark.line_colour, "linewidths": mark.line_width, "alpha": mark.line_alpha}
        x, y = (mark.centres[0] / across, mark.centres[1] / upright) if mark.centres else (x, y)
        axes.contour(x, y, z, levels=levels, **look)
    if mark.ground:
        axes.set_facecolor(mark.ground)
    if mark.place:
        _colour_bar(axes, mark, drawn)


def _colour_bar(axes: Axes, mark: marks.Map, drawn: Any) -> None:
    figure: Any = axes.figure
    if mark.place == "inset":
        bar = figure.colorbar(drawn, cax=axes.inset_axes((1.025, 0.0, 0.035, 1.0)))
        ticks = bar.get_ticks()[:: max(1, round(len(bar.get_ticks()) / 8))]
        bar.set_ticks(ticks[(ticks >= bar.vmin) & (ticks <= bar.vmax)])
    else:
        pad = {} if mark.pad is None else {"pad": mark.pad}
        beyond = {} if mark.kind == "contours" else {"extend": mark.extend}
        bar = figure.colorbar(drawn, ax=axes, shrink=mark.shrink, **pad, **beyond)
    if mark.place == "inset" or mark.kind == "pixels":
        bar.outline.set_visible(False)
    bar.set_label(mark.bar.title)
    if isinstance(bar.formatter, ScalarFormatter):
        bar.formatter.set_useOffset(False)
    if mark.bar.plain:
        set_axis(bar.ax, "y", PanelAxis(mark.bar.label, mark.bar.scale, log=mark.bar.log, plain=mark.bar.log))
        bar.ax.minorticks_off()


def _vectors(axes: Axes, mark: marks.Vectors, across: float, upright: float) -> None:
    look: Any = {"color": mark.colour, "angles": "xy", "pivot": "mid", "width": 0.005}
    axes.quiver(mark.x / across, mark.y / upright, mark.u, mark.v, **look)


def _facets(axes: Axes, mark: marks.Facets, across: float, upright: float) -> None:
    flat: Any = mark.corners / np.array([across, upright])  # as one array: a list of polygons takes ten times as long
    look: Any = {"facecolors": mark.colours, "edgecolors": mark.colours, "linewidths": 0.4}
    axes.add_collection(PolyCollection(flat, **look, rasterized=True, zorder=mark.order))
    axes.autoscale_view()


DRAWING_FUNCTIONS: dict[type, Callable[[Axes, Any, float, float], None]] = {
    marks.Line: _line,
    marks.Dots: _dots,
    marks.Strokes: _strokes,
    marks.Area: _area,
    marks.Polygon: _polygon,
    marks.Rule: _rule,
    marks.Band: _band,
    marks.Text: _text,
    marks.Arrow: _arrow,
    marks.Bars: _bars,
    marks.Map: _map,
    marks.Vectors: _vectors,
    marks.Facets: _facets,
}
