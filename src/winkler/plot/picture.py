"""A figure of matplotlib that notebooks and the gallery display, without pyplot and its global state."""

from __future__ import annotations

import base64
import contextlib
import io
import os
from collections.abc import Iterator
from typing import Any

import matplotlib
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from winkler.plot.style import INK, MUTED, PALE

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


@contextlib.contextmanager
def styled() -> Iterator[None]:
    """Apply the package's matplotlib settings within the context, and restore the previous ones."""
    with matplotlib.rc_context(SETTINGS):
        yield


DATES = {"svg": "Date", "pdf": "CreationDate"}
"""Format -> what states the date in it."""


class Picture(Figure):
    """A matplotlib figure; save it with ``savefig``, or let a notebook show it."""

    def _repr_html_(self) -> str:
        store = io.BytesIO()
        self.savefig(store, format="png")
        data = base64.b64encode(store.getvalue()).decode("ascii")
        width = round(96 * self.get_figwidth())
        return f'<img alt="figure" style="width:{width}px;max-width:100%" src="data:image/png;base64,{data}">'

    def __repr__(self) -> str:
        return f"<Picture of {self.get_figwidth():g} x {self.get_figheight():g} inches; save it with savefig(path)>"

    def savefig(self, fname: Any, **options: Any) -> None:
        """Write the picture to a path or stream; the format follows from the path's ending.

        The same picture gives the same bytes: SVG and PDF are written without the date.
        """
        ending = options.get("format") or os.path.splitext(str(fname))[1][1:]
        if ending.lower() in DATES:
            options["metadata"] = {DATES[ending.lower()]: None} | (options.get("metadata") or {})
        with styled():
            super().savefig(fname, **options)


def empty_figure(width: float, height: float) -> Picture:
    """Return an empty figure of a size in inches; call it, and draw, inside `styled`."""
    empty = Picture(figsize=(width, height), dpi=144, layout="constrained")
    FigureCanvasAgg(empty)  # so that it can be drawn and measured without a window
    return empty
