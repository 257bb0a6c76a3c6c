"""One look for all figures: colours that colour-blind readers can tell apart, thin frames, readable letters."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.numerics.types import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.colors import Colormap

    from winkler.plot.picture import Picture

__all__ = [
    "BLUE",
    "BODY",
    "CYCLE",
    "GREEN",
    "INK",
    "MUTED",
    "ORANGE",
    "RED",
    "SOLID",
    "figure",
    "framed_legend",
    "mirrored",
    "note",
    "reliefs",
    "shades",
    "styled",
    "tensions",
]

INK = "#22272e"
MUTED = "#6b7480"
PALE = "#d9dee4"
BODY = "#b9c6d3"
SOLID = "#efe3c8"
BLUE, RED, GREEN, ORANGE, PURPLE, SKY = "#0072b2", "#d55e00", "#009e73", "#e69f00", "#a3568a", "#56b4e9"
CYCLE = (BLUE, RED, GREEN, ORANGE, PURPLE, SKY, INK)
"""After Okabe and Ito (2008), the purple a little darker."""

DASHES: tuple[Any, ...] = ("-", (0, (5, 2)), (0, (1.2, 1.2)), (0, (6, 2, 1.2, 2)))
"""Line styles, so that curves can be told apart in print without colour."""

SETTINGS: Any = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 9.0,
    "mathtext.fontset": "dejavusans",
    "text.color": INK,
    "axes.labelcolor": INK,
    "axes.edgecolor": MUTED,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.titlesize": 9.5,
    "axes.titlelocation": "left",
    "axes.titlepad": 8.0,
    "axes.titleweight": "bold",
    "axes.labelsize": 9.0,
    "axes.axisbelow": True,
    "axes.grid": True,
    "axes.formatter.limits": (-4, 5),
    "axes.unicode_minus": True,
    "axes.xmargin": 0.0,
    "grid.color": PALE,
    "grid.linewidth": 0.6,
    "xtick.color": MUTED,
    "ytick.color": MUTED,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "xtick.labelsize": 8.5,
    "ytick.labelsize": 8.5,
    "lines.linewidth": 1.8,
    "lines.markersize": 5.0,
    "lines.solid_capstyle": "round",
    "legend.frameon": False,
    "legend.fontsize": 8.5,
    "legend.handlelength": 2.2,
    "figure.facecolor": "white",
    "figure.titlesize": 10.5,
    "figure.titleweight": "bold",
    "savefig.facecolor": "white",
    "svg.fonttype": "path",
    "svg.hashsalt": "winkler",
    "path.simplify": True,
    "figure.constrained_layout.w_pad": 0.06,
    "figure.constrained_layout.h_pad": 0.06,
    "figure.constrained_layout.hspace": 0.06,
    "figure.constrained_layout.wspace": 0.06,
}

SHORT_SIDE = 3.1
"""Height of one panel [inch]."""


@contextlib.contextmanager
def styled() -> Iterator[None]:
    """Use the look of the house for what is drawn inside, and leave the reader's own settings as they were."""
    import matplotlib

    with matplotlib.rc_context(SETTINGS):
        yield


def figure(columns: int = 1, rows: int = 1, *, width: float = 4.4, height: float = SHORT_SIDE) -> Picture:
    """Return an empty figure for so many panels; call it, and draw, inside `styled`."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    from winkler.plot.picture import Picture

    empty = Picture(figsize=(width * columns, height * rows), dpi=144, layout="constrained")
    FigureCanvasAgg(empty)  # so that it can be drawn and measured without a window
    return empty


def shades() -> Colormap:
    """Return the colour map of stresses and pressures: perceptually even, safe for colour-blind readers."""
    from matplotlib import colormaps

    return colormaps["viridis_r"]


def reliefs() -> Colormap:
    """Return the colour map of heights: dark valleys, bright peaks."""
    from matplotlib import colormaps

    return colormaps["cividis"]


def tensions() -> Colormap:
    """Return the colour map of tension, beside that of pressure."""
    from matplotlib import colormaps

    return colormaps["Reds"]


def framed_legend(axes: Axes, **options: Any) -> None:
    """Add a legend on white ground, so that a grid or curve behind it does not disturb."""
    legend = axes.legend(**options)
    legend.set_frame_on(True)
    legend.get_frame().set(facecolor="white", edgecolor="none", alpha=0.85)


def note(axes: Axes, text: str, *, where: str = "upper right") -> None:
    """Write a short remark into a corner of the axes."""
    vertical, horizontal = where.split()
    axes.text(
        {"left": 0.03, "right": 0.97, "centre": 0.5}[horizontal],
        {"upper": 0.97, "lower": 0.04}[vertical],
        text,
        transform=axes.transAxes,
        ha={"left": "left", "right": "right", "centre": "center"}[horizontal],
        va={"upper": "top", "lower": "bottom"}[vertical],
        fontsize=8.5,
        color=INK,
        zorder=9,
        bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 1.5},
    )


def mirrored(along: Array, of: Array, *, odd: bool = False) -> tuple[Array, Array]:
    """Return a curve over positive places together with its mirror image."""
    sign = -1.0 if odd else 1.0
    return np.concatenate([-along[::-1], along]), np.concatenate([sign * of[::-1], of])
