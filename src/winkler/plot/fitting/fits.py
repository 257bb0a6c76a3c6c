"""Pictures of fits: the curve with its model and what is left over, the numbers of many curves, and their maps."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.series import Series, common_scale, middle_scale
from winkler.vocabulary import Word

if TYPE_CHECKING:
    from winkler.fitting.outcome import Fit
    from winkler.plot.picture import Picture

__all__ = ["Grid", "fit_picture", "grid_of", "map_picture", "numbers_picture"]

BINS = 40
DENSE = 400
"""More points are drawn as dots without an outline."""


def fit_picture(fit: Fit) -> Picture:
    """Return a figure of a curve, the fitted model, and the residuals below.

    Parameters
    ----------
    fit : Fit
    """
    with style.styled():
        figure = style.figure(width=5.4, height=4.2)
        above, below = figure.subplots(2, 1, sharex=True, height_ratios=(3.0, 1.0))
        curve = fit.curve
        origin = fit.value("contact_point") if "contact_point" in fit.names else 0.0
        meaning = "position from first touch" if origin else "position"
        along = Series(meaning, Word("D - D_0" if origin else "D", "m", meaning), curve.position - origin)
        measured = Series("force", Word("F_N", "N", "force"), curve.force)
        model = Series("force", measured.word, fit.predicted)
        left = Series("residual", Word("", "N", "measured less fitted force"), fit.residuals)
        across, upright = along.scale, common_scale(measured, model)
        ways = [way for way in (1.0, -1.0) if np.any(curve.direction == way)]
        size = 5.0 if curve.count > DENSE else 12.0
        for way, colour in zip(ways, (style.BLUE, style.GREEN), strict=False):
            mine = curve.direction == way
            label = {1.0: "measured, going in", -1.0: "measured, coming out"}[way]
            dots = {"s": size, "color": colour, "alpha": 0.45, "linewidths": 0.0, "rasterized": curve.count > DENSE}
            above.scatter(along.shown(across)[mine], measured.shown(upright)[mine], label=label, **dots)
            below.scatter(along.shown(across)[mine], left.shown()[mine], **dots)
        for number, way in enumerate(ways):
            mine = np.flatnonzero(curve.direction == way)
            mine = mine[np.argsort(curve.position[mine], kind="stable")]
            told = "fitted" if number == 0 else None
            above.plot(along.shown(across)[mine], model.shown(upright)[mine], color=style.RED, lw=1.4, label=told)
        if origin:
            for axes in (above, below):
                axes.axvline(0.0, color=style.MUTED, lw=0.8, ls=(0, (4, 3)), zorder=0)
        below.axhline(0.0, color=style.INK, lw=0.8)
        above.set_ylabel(measured.label(upright))
        below.set_ylabel(left.label())
        below.set_xlabel(along.label(across))
        above.margins(x=0.02, y=0.05)
        style.framed_legend(above, loc="upper left", markerscale=2.0)
        figure.align_ylabels([above, below])
    return figure


def numbers_picture(of: Series, errors: Array) -> Picture:
    """Return a figure of a fitted number of many curves: one by one with its error, and how often it occurs.

    Parameters
    ----------
    of : Series
        One number for each curve, NaN where there is none.
    errors : ndarray
        Their standard errors.
    """
    from matplotlib.ticker import MaxNLocator

    with style.styled():
        figure = style.figure(width=6.4, height=2.9)
        left, right = figure.subplots(1, 2, sharey=True, width_ratios=(2.6, 1.0))
        known = np.isfinite(of.content)
        scale = middle_scale(of.word.unit, np.fmax(np.abs(of.content), errors))
        number, shown = np.arange(1, known.size + 1)[known], of.shown(scale)[known]
        many = known.size > 60
        left.errorbar(
            number,
            shown,
            yerr=errors[known] / scale.factor,
            fmt="o",
            ms=2.0 if many else 4.0,
            lw=0.6 if many else 1.0,
            color=style.BLUE,
            ecolor=style.MUTED,
        )
        left.margins(x=0.03, y=0.08)
        for axes in (left, right):
            axes.xaxis.set_major_locator(MaxNLocator(nbins=6 if axes is left else 3, integer=True))
        left.set_xlabel("number of the curve")
        left.set_ylabel(of.label(scale))
        right.hist(shown, bins=min(BINS, max(5, int(np.sqrt(shown.size)))), orientation="horizontal", color=style.BLUE)
        right.axhline(float(np.median(shown)), color=style.RED, lw=1.2)
        right.set_xlabel("curves")
        left.axhline(float(np.median(shown)), color=style.RED, lw=1.2)
        right.set_title(f"median {np.median(shown):.4g}{f' {scale.unit}' if scale.unit else ''}", fontweight="normal")
    return figure


class Grid:
    """Places of curves on a regular grid.

    Parameters
    ----------
    x, y : ndarray, (columns,) and (rows,)
        [m].
    index : ndarray, (curves, 2)
        Row and column of every curve.
    """

    def __init__(self, x: Array, y: Array, index: Array) -> None:
        self.x, self.y, self.index = x, y, index

    def laid(self, numbers: Array) -> Array:
        """Return numbers of the curves on the grid ``(rows, columns)``, NaN where there is none."""
        result = np.full((self.y.size, self.x.size), np.nan)
        known = np.isfinite(numbers)
        result[tuple(self.index[known].T)] = numbers[known]
        return result


def grid_of(x: Array, y: Array) -> Grid | tuple[()]:
    """Return the grid on which curves were taken; empty if they do not lie on one, or along a line.

    Parameters
    ----------
    x, y : ndarray, (curves,)
        Places [m]; nan where unknown.
    """
    known = np.isfinite(x) & np.isfinite(y)
    if np.count_nonzero(known) < 4 or not known.all():
        return ()
    columns, rows = _levels(x), _levels(y)
    if columns.size < 2 or rows.size < 2 or columns.size * rows.size > 2 * x.size:
        return ()
    index = np.stack([_nearest(rows, y), _nearest(columns, x)], axis=1)
    if len(np.unique(index, axis=0)) < x.size:
        return ()
    return Grid(columns, rows, index)


def _levels(places: Array) -> Array:
    """Return the distinct levels of places that scatter a little."""
    ordered = np.sort(places)
    span = ordered[-1] - ordered[0]
    if span == 0.0:
        return ordered[:1]
    gap = 0.3 * span / np.sqrt(places.size)
    edges = np.flatnonzero(np.diff(ordered) > gap) + 1
    return np.array([part.mean() for part in np.split(ordered, edges)])


def _nearest(levels: Array, places: Array) -> Array:
    return np.asarray(np.argmin(np.abs(levels[:, np.newaxis] - places), axis=0))


def map_picture(grid: Grid, of: Series) -> Picture:
    """Return a map of a fitted number over the sample.

    Parameters
    ----------
    grid : Grid
    of : Series
        One number for each curve; blank where there is none.
    """
    with style.styled():
        figure = style.figure(width=4.8, height=3.9)
        axes = figure.add_subplot()
        scale = middle_scale(of.word.unit, of.content)
        micro = 1e-6
        mesh = axes.pcolormesh(
            (grid.x - grid.x.min()) / micro,
            (grid.y - grid.y.min()) / micro,
            np.ma.masked_invalid(grid.laid(of.shown(scale))),
            cmap="viridis",
            shading="nearest",
            rasterized=True,
        )
        axes.set_facecolor("#d9dee4")
        axes.grid(visible=False)
        axes.set_aspect("equal")
        axes.set_xlabel("x [µm]")
        axes.set_ylabel("y [µm]")
        figure.colorbar(mesh, ax=axes, label=of.label(scale))
    return figure
