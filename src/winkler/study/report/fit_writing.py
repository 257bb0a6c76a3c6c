"""The files with the numbers of fits.

::

    fit.csv            one row per curve: every free number with unit, error and interval, misfit, flags, failure
    fit.nc             the same, with the correlations of the numbers, and every curve with its model and residuals
    curves/NAME.csv    the first curves: the fitted points, the model, the residuals
    maps.nc            of a force map: every free number over x and y

All numbers are SI and have all their digits.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.fitting.outcome import CreepFit, Fit
from winkler.plot.fitting.fits import Grid, grid_of
from winkler.study.batch.fit_outcome import FitOutcome, Fitted
from winkler.study.batch.outcome import ResultColumn
from winkler.study.report.archive import table_file
from winkler.study.report.examined.sections import further_files
from winkler.study.report.netcdf import Variables, has_netcdf, netcdf_attributes, netcdf_file
from winkler.values.vocabulary import Word

if TYPE_CHECKING:
    import xarray


CSV, NETCDF, MAPS = "fit.csv", "fit.nc", "maps.nc"
MOST_CURVES_AS_TEXT = 24
"""Curves that are written as text; fit.nc holds all."""
TIMED_COLUMNS = {
    "time": Word("t", "s", "time, as measured"),
    "weight": Word("", "", "what the residual counts; zero where a point only drives"),
}
POINT_COLUMNS = {
    "position": Word("D", "m", "position as fitted, after the corrections"),
    "force": Word("F_N", "N", "measured force, after the corrections"),
    "fitted_force": Word("F_N", "N", "force of the model, with the baseline"),
    "fitted_position": Word("D", "m", "position of the model, under the measured forces"),
    "residual": Word("", "N", "measured less fitted force"),
    "fitted_depth": Word("d", "m", "depth of the model"),
    "fitted_radius": Word("a", "m", "contact radius of the model"),
}


def number_files(outcome: FitOutcome) -> dict[str, bytes]:
    """Return the files that hold the numbers of fits, tables and NetCDF: name -> content."""
    files = {CSV: table_file(outcome.table(), nothing="")}
    if has_netcdf():
        files[NETCDF] = netcdf_file(*_dataset(outcome))
        grid = map_grid(outcome)
        if isinstance(grid, Grid):
            files[MAPS] = netcdf_file(*_maps(outcome, grid))
    return files | further_files(outcome) | _curve_files(outcome)


def map_grid(outcome: FitOutcome) -> Grid | tuple[()]:
    """Return the grid of a force map; empty if the curves do not lie on one.

    Files without an answer that state no place, as one among them that holds no curve, do not count.
    """
    x, y = (np.array([getattr(result, axis) for result in outcome.results]) for axis in "xy")
    counted = np.isfinite(x) | np.isfinite(y) | [isinstance(result, Fitted) for result in outcome.results]
    grid = grid_of(x[counted], y[counted])
    if isinstance(grid, Grid):
        index = np.zeros((x.size, 2), dtype=int)  # of the others no number is arranged
        index[counted] = grid.index
        grid = Grid(grid.x, grid.y, index)
    return grid


def _points(result: Fitted) -> list[ResultColumn]:
    """Return the fitted points, the model and the residuals, point by point."""
    fit = result.fit
    creeps = isinstance(fit, CreepFit)
    relaxing = {} if isinstance(fit, Fit) else {"time": fit.curve.time, "weight": fit.weights}
    content = {
        **relaxing,
        "position": fit.curve.position,
        "force": fit.curve.force,
        "fitted_position" if creeps else "fitted_force": fit.predicted,
        "residual": fit.residuals,
        "fitted_depth": fit.depth,
        "fitted_radius": fit.radius,
    }
    words = (
        TIMED_COLUMNS | POINT_COLUMNS | ({"residual": Word("", "m", "measured less fitted position")} if creeps else {})
    )
    return [ResultColumn(name, words[name], numbers) for name, numbers in content.items()]


def _curve_files(outcome: FitOutcome) -> dict[str, bytes]:
    files: dict[str, bytes] = {}
    for result in outcome.fitted[:MOST_CURVES_AS_TEXT]:
        stem = re.sub(r"[^\w.+-]+", "_", result.name.replace(".csv", "")).strip("._") or "curve"
        name = next(
            name
            for name in (stem, *(f"{stem}_{count}" for count in range(2, MOST_CURVES_AS_TEXT + 2)))
            if f"curves/{name}.csv" not in files
        )
        files[f"curves/{name}.csv"] = table_file(_points(result), nothing="")
    return files


def dataset(outcome: FitOutcome) -> xarray.Dataset:
    """Return all numbers of fits as an xarray dataset, with units and provenance.

    Returns
    -------
    xarray.Dataset
        Dimensions: ``curve``; ``point`` of a curve, NaN beyond its last; ``free`` and ``other_free`` of the
        correlations.
    """
    import xarray

    return xarray.Dataset(*_dataset(outcome))


def _dataset(outcome: FitOutcome) -> tuple[Variables, Variables, dict[str, Any]]:
    """Return variables, coordinates and attributes of the dataset."""
    variables: Variables = {}
    coords: Variables = {}
    for column in outcome.table():
        target = coords if column.name in ("curve", "x", "y") else variables
        target[column.name] = (("curve",), column.content, netcdf_attributes(column.word))
    keys = np.array([free.key for free in outcome.study.free])
    coords |= {name: ((name,), keys, {}) for name in ("free", "other_free")}
    order = [free.path for free in outcome.study.free]
    correlation = np.full((len(outcome.results), len(keys), len(keys)), np.nan)
    longest = max(result.fit.curve.count for result in outcome.fitted)
    words = {column.name: column.word for column in _points(outcome.fitted[0])}
    points = {name: np.full((len(outcome.results), longest), np.nan) for name in words}
    for place, result in enumerate(outcome.results):
        if isinstance(result, Fitted):
            at = [result.fit.index(name) for name in order]
            correlation[place] = result.fit.correlation[np.ix_(at, at)]
            for column in _points(result):
                points[column.name][place, : column.content.size] = column.content
    variables["correlation"] = (
        ("curve", "free", "other_free"),
        correlation,
        {"units": "1", "long_name": "correlation of the errors of two parameters"},
    )
    variables |= {name: (("curve", "point"), points[name], netcdf_attributes(word)) for name, word in words.items()}
    return variables, coords, outcome.provenance.attributes(outcome.study.title, outcome.study.text)


def _maps(outcome: FitOutcome, grid: Grid) -> tuple[Variables, Variables, dict[str, Any]]:
    """Return every free number over the places of a force map, dimensions ``y`` and ``x``."""
    variables: Variables = {
        column.name: (("y", "x"), grid.arranged(column.content), netcdf_attributes(column.word))
        for column in outcome.table()
        if column.word.unit is not None and column.name not in ("x", "y")
    }
    place = {"units": "m", "long_name": "place on the sample"}
    coords: Variables = {"x": (("x",), grid.x, place), "y": (("y",), grid.y, place)}
    return variables, coords, outcome.provenance.attributes(outcome.study.title, outcome.study.text)
