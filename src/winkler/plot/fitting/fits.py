"""Pictures of fits: the curve with its model and residuals, parameters of many curves, and their maps."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.fitting.compare import AnyFit
from winkler.fitting.outcome import CreepFit, Fit
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Bars, Dots, Line, Map, Panel, PanelAxis, Rule, Sheet
from winkler.plot.series import Scale, Series, common_scale, middle_scale
from winkler.values.vocabulary import Word

MOST_BINS = 40
MOST_OUTLINED_DOTS = 400
"""More points are drawn as dots without an outline."""
DIRECTIONS = (
    (1.0, style.BLUE, "measured, going in"),
    (0.0, style.ORANGE, "measured, held"),
    (-1.0, style.GREEN, "measured, coming out"),
)


@without_extent(Fit)
def fit_sheet(fit: Fit) -> Sheet:
    """Return a curve, the fitted model, and the residuals below.

    Parameters
    ----------
    fit : Fit
    """
    return Sheet(fit_panels(fit), 1, width=5.4, height=2.1, heights=(3.0, 1.0), shared="x")


def fit_panels(fit: AnyFit, some: Array | None = None) -> tuple[Panel, Panel]:
    """Return the curve with the fitted law, and the residuals: over the position, of a body that relaxes over time.

    Parameters
    ----------
    fit
        A fit.
    some : ndarray, optional
        Indices of the drawn points; all if left out.
    """
    some = np.arange(fit.curve.count) if some is None else some
    along, measured, model = _series(fit, some)
    in_contact = fit.radius[some] > 0.0 if isinstance(fit, CreepFit) else np.ones(some.size, dtype=bool)
    counted = in_contact if isinstance(fit, Fit) else fit.weights[some] > 0.0
    left = Series("residual", Word("", measured.word.unit, "measured less fitted"), fit.residuals[some] * counted)
    upright = common_scale(*(Series(one.name, one.word, one.content[in_contact]) for one in (measured, model)))
    directions = fit.curve.direction[some]
    above: list[Any] = measured_dots(fit, along.content, measured.content, directions, in_contact)
    below: list[Any] = measured_dots(fit, along.content, left.content, directions, counted, named=False)
    for number, chosen in enumerate(_lines(fit, directions, along.content)):
        content = np.where(in_contact, model.content, np.nan)[chosen]
        above.append(Line(along.content[chosen], content, style.RED, width=1.4, name="" if number else "fitted"))
    below.append(Rule(0.0, colour=style.INK))
    if isinstance(fit, Fit) and origin_of(fit):
        first_touch = Rule(0.0, upright=True, dash=style.DASHED, order=0.0)
        above.append(first_touch)
        below.append(first_touch)
    across = PanelAxis.of(along, margin=0.02)
    upper = Panel(
        tuple(above),
        PanelAxis(scale=Scale(across.scale.factor, ""), margin=0.02),  # its label stands below
        PanelAxis.of(measured, upright, margin=0.05),
        legend="upper left" if isinstance(fit, Fit) else "best",
        marker_scale=2.0,
    )
    return upper, Panel(tuple(below), across, PanelAxis.of(left))


def origin_of(fit: AnyFit) -> float:
    """Return the fitted position of first touch [m]; zero if it was not fitted."""
    return fit.value("contact_point") if "contact_point" in fit.names else 0.0


def measured_dots(
    fit: AnyFit, x: Array, y: Array, directions: Array, marked: Array, *, named: bool = True
) -> list[Dots]:
    """Return measured points in the colours of the direction of motion, those that `marked` marks."""
    dense = fit.curve.count > MOST_OUTLINED_DOTS
    return [
        Dots(x[chosen], y[chosen], colour, 5.0 if dense else 12.0, 0.45, name if named else "", dense)
        for direction, colour, name in DIRECTIONS
        if (chosen := (directions == direction) & marked).any()
    ]


def _series(fit: AnyFit, some: Array) -> tuple[Series, Series, Series]:
    """Return abscissa, measured quantity and fitted quantity of the curve."""
    curve, origin = fit.curve, origin_of(fit)
    name = "position from first touch" if origin or isinstance(fit, CreepFit) else "position"
    place, force = Word("D - D_0" if name != "position" else "D", "m", name), Word("F_N", "N", "force")
    if isinstance(fit, Fit):
        along = Series(name, place, curve.position[some] - origin)
    else:
        along = Series("time", Word("t", "s", "time"), curve.time[some] - curve.time[0])
    if isinstance(fit, CreepFit):
        measured, model = (Series(name, place, part[some] - origin) for part in (curve.position, fit.predicted))
    else:
        measured, model = (Series("force", force, part[some]) for part in (curve.force, fit.predicted))
    return along, measured, model


def _lines(fit: AnyFit, directions: Array, x: Array) -> list[Any]:
    """Return the indices of each line of the fitted law, sorted."""
    if not isinstance(fit, Fit):
        return [np.arange(x.size)]
    lines = [
        np.flatnonzero(directions == direction) for direction, _, _ in DIRECTIONS if np.any(directions == direction)
    ]
    return [chosen[np.argsort(x[chosen], kind="stable")] for chosen in lines]


def numbers_sheet(of: Series, errors: Array) -> Sheet:
    """Return a fitted parameter of many curves with standard errors, and its histogram.

    Parameters
    ----------
    of : Series
        One value for each curve, NaN where there is none.
    errors : ndarray
        Their standard errors.
    """
    finite = np.isfinite(of.content)
    scale = middle_scale(of.word.unit, np.fmax(np.abs(of.content), errors))
    number, content = np.arange(1.0, finite.size + 1.0)[finite], of.content[finite]
    many = finite.size > 60
    points = Line(
        number,
        content,
        width=0.6 if many else 1.0,
        marker="o",
        size=2.0 if many else 4.0,
        error_y=np.stack([errors[finite]] * 2),
        error_colour=style.MUTED,
    )
    median = float(np.median(content))
    middle = Rule(median, colour=style.RED, width=1.2)
    counts, edges = np.histogram(content, bins=min(MOST_BINS, max(5, int(np.sqrt(content.size)))))
    places, thick = 0.5 * (edges[1:] + edges[:-1]), float(edges[1] - edges[0])
    left = Panel(
        (points, middle), PanelAxis("number of the curve", margin=0.03, parts=6), PanelAxis.of(of, scale, margin=0.08)
    )
    right = Panel((Bars(places, counts, thick=thick), middle), PanelAxis("curves", parts=3), PanelAxis(scale=scale))
    drawn = f"{median / scale.factor:.4g}{f' {scale.unit}' if scale.unit else ''}"
    return Sheet((left, right.plus(title=f"median {drawn}")), width=3.2, height=2.9, widths=(2.6, 1.0), shared="y")


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

    def arranged(self, numbers: Array) -> Array:
        """Return numbers of the curves on the grid ``(rows, columns)``, NaN where there is none."""
        result = np.full((self.y.size, self.x.size), np.nan)
        finite = np.isfinite(numbers)
        result[tuple(self.index[finite].T)] = numbers[finite]
        return result


def grid_of(x: Array, y: Array) -> Grid | tuple[()]:
    """Return the grid on which curves were taken; empty if they do not lie on one, or along a line.

    Parameters
    ----------
    x, y : ndarray, (curves,)
        Places [m]; nan where unknown.
    """
    finite = np.isfinite(x) & np.isfinite(y)
    if np.count_nonzero(finite) < 4 or not finite.all():
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


def map_sheet(grid: Grid, of: Series) -> Sheet:
    """Return a map of a fitted number over the sample.

    Parameters
    ----------
    grid : Grid
    of : Series
        One number for each curve; blank where there is none.
    """
    bar = PanelAxis.of(of, middle_scale(of.word.unit, of.content))
    look: dict[str, Any] = {"kind": "cells", "colours": "viridis", "ground": style.PALE}
    drawn = Map(grid.x - grid.x.min(), grid.y - grid.y.min(), grid.arranged(of.content), bar, **look)
    axes = PanelAxis("x", Scale(1e-6, "µm")), PanelAxis("y", Scale(1e-6, "µm"))
    return Sheet((Panel((drawn,), *axes, equal=True, grid=""),), width=4.8, height=3.9)
