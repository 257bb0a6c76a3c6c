"""Archives of numbers: NetCDF with units, meanings and provenance, and CSV for spreadsheets.

::

    results.nc     every answer over the axes of the sweep, and every restored field; read it with xarray
    results.csv    one row per point and load: what was varied, then the answers; units in the header
    surface.csv    the fields on the surface, if [fields] requests them
    jumps.csv, branches.csv, limit.csv, stages.csv, onsets.csv
                   one row per jump of an adhesive cycle or curve, stable branch, limit of a sheared contact, stage
                   of sticking and sliding in an impact, or body that begins to yield
    sensitivity.csv
                   one row per answer and varied key: indices of Sobol, if the design is sensitivity

All numbers are SI and have all their digits.  Fields below the surface are in results.nc only, and so are heights,
pressure and distance over the pixels of a height map.
"""

from __future__ import annotations

import csv
import dataclasses
import io
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.numerics.types import Array
from winkler.study.batch import sensitivity
from winkler.study.batch.events import EVENTS, Event
from winkler.study.batch.outcome import Outcome, ResultColumn
from winkler.study.batch.points import SolvedPoint
from winkler.study.batch.sensitivity import INDEX_MEANINGS, SENSITIVITY
from winkler.study.language import keys
from winkler.study.language.writing import study_text
from winkler.study.report.archive_maps import add_maps
from winkler.study.report.netcdf import has_netcdf, netcdf_attributes, netcdf_file
from winkler.values.vocabulary import Word, word

if TYPE_CHECKING:
    import xarray


NETCDF, CSV, SURFACE = "results.nc", "results.csv", "surface.csv"

LOAD_DIMENSION = "load"
"""Dimension of the loads of one point."""

EXTRA_STRESSES = ("von_mises", "max_shear")
"""Stresses that are stored beside the components."""


def archive_files(outcome: Outcome) -> dict[str, bytes]:
    """Return the files that hold the numbers of a study: name -> content."""
    files = {NETCDF: netcdf_file(*_dataset(outcome))} if has_netcdf() else {}
    files[CSV] = table_file(outcome.table())
    if any(point.surface for point in outcome.solved):
        files[SURFACE] = _surface_file(outcome)
    if outcome.indices:
        heads = ["answer", "key", "pairs", *(f"{name} [-]" for name in INDEX_MEANINGS)]
        files[SENSITIVITY] = _rows_file(heads, sensitivity.rows(outcome.indices, _varied(outcome)))
    for name in EVENTS:
        if points := rows_of(outcome, name):
            headings = [heading(one.name, one.word) for one in points[0][1][0]]
            rows = ((point, [[one.content for one in event] for event in events]) for point, events in points)
            files[f"{name}.csv"] = _points_file(outcome, headings, rows)
    return files


def heading(name: str, entry: Word) -> str:
    """Return the heading of a column: its name, and its unit in brackets; ``-`` for numbers without one.

    Examples
    --------
    >>> heading("force", Word("F_N", "N", "normal force")), heading("failure", Word("", None, "why"))
    ('force [N]', 'failure')
    """
    return name if entry.unit is None else f"{name} [{entry.unit or '-'}]"


def table_file(columns: Iterable[ResultColumn], *, nothing: str = "nan") -> bytes:
    """Return columns as CSV, with units in the heading and all digits; `nothing` stands where there is no number."""
    columns = tuple(columns)
    headings = [heading(column.name, column.word) for column in columns]
    return _rows_file(headings, zip(*(column.content.tolist() for column in columns), strict=True), nothing)


def _rows_file(headings: list[str], rows: Any, nothing: str = "nan") -> bytes:
    def written(item: Any) -> Any:
        return (repr(item) if item == item else nothing) if isinstance(item, float) else item

    store = io.StringIO(newline="")
    writer = csv.writer(store, lineterminator="\n")
    writer.writerow(headings)
    writer.writerows([written(item) for item in row] for row in rows)
    return store.getvalue().encode("utf-8")


def _surface_file(outcome: Outcome) -> bytes:
    many = any(len(point.surface) > 1 for point in outcome.solved)
    first = next(fields for point in outcome.solved for fields in point.surface)
    names = [field.name for field in dataclasses.fields(first)]
    headings = [*([LOAD_DIMENSION] if many else []), *(heading(name, word(type(first), name)) for name in names)]

    def rows(point: SolvedPoint) -> Iterator[list[Any]]:
        for load, fields in enumerate(point.surface):
            for row in zip(*(getattr(fields, name).tolist() for name in names), strict=True):
                yield [*([load] if many else []), *row]

    return _points_file(outcome, headings, ((point, rows(point)) for point in outcome.solved))


def rows_of(outcome: Outcome, name: str) -> list[tuple[SolvedPoint, tuple[tuple[Event, ...], ...]]]:
    """Return the points that have events of a kind, jumps, branches, limits or stages, each with a row for each."""
    pairs = [(point, point.events(name)) for point in outcome.solved]
    return [(point, rows) for point, rows in pairs if rows]


def _points_file(
    outcome: Outcome, headings: list[str], rows: Iterable[tuple[SolvedPoint, Iterable[list[Any]]]]
) -> bytes:
    """Return rows of points, with the varied keys before them."""
    swept = [heading(key, _swept_word(outcome, key)) for key in _varied(outcome)]
    units = [outcome.word(key).unit for key in _varied(outcome)]
    settings = {
        point.index: [
            item if isinstance(item, int | float) else keys.label(item, unit)
            for item, unit in zip(point.settings, units, strict=True)
        ]
        for point in outcome.solved
    }
    return _rows_file([*swept, *headings], ([*settings[point.index], *row] for point, many in rows for row in many))


def _varied(outcome: Outcome) -> list[str]:
    return [line.key for line in outcome.study.sweep]


def _swept_word(outcome: Outcome, key: str) -> Word:
    entry = outcome.word(key)
    axis = next(axis for axis in outcome.study.axes if axis.key == key)
    return entry if axis.numeric else entry._replace(unit=None)


# ---------------------------------------------------------------------------------------------------- NetCDF


def dataset(outcome: Outcome) -> xarray.Dataset:
    """Return all numbers of a study as an xarray dataset, with units and provenance.

    Parameters
    ----------
    outcome
        The outcome of a study.

    Returns
    -------
    xarray.Dataset
        Dimensions: the keys of the sweep (``point`` if they are not crossed), ``load`` if points have many
        loads, ``r`` and ``z`` of restored fields (``r_over_a`` and ``z_over_a`` if they were given as multiples of the
        contact radius; r and z then are coordinates), ``jumps``, ``branches`` or ``limit`` where answers have them.
        NaN where a point has no answer.
    """
    import xarray

    return xarray.Dataset(*_dataset(outcome))


def _dataset(outcome: Outcome) -> tuple[dict[str, Any], dict[str, Any], dict[str, Any]]:
    """Return variables, coordinates and attributes of the dataset."""
    study = outcome.study
    dims = study.dims
    coords: dict[str, Any] = {}
    for place, axis in enumerate(study.axes):
        entry, unit = _swept_word(outcome, axis.key), outcome.word(axis.key).unit
        values = [item if entry.unit is not None else keys.label(item, unit) for item in axis.values]
        along = dims[place] if len(dims) == len(study.axes) else dims[0]
        coords[axis.key] = ((along,), np.array(values), netcdf_attributes(entry))
    variables: dict[str, Any] = {}
    for name in outcome.answers:
        content = outcome.answer(name)
        across = () if content.shape[-1] == 1 else (LOAD_DIMENSION,)
        numbers = content if across else content[..., 0]
        variables[name] = ((*dims, *across), numbers, netcdf_attributes(outcome.word(name)))
    if outcome.failed:
        reasons = np.full(outcome.shape, "", dtype=object)
        for point in outcome.failed:
            reasons[point.index] = point.reason
        variables["failure"] = (dims, reasons.astype(str), {"long_name": "why a point has no answer"})
    _add_fields(outcome, dims, variables, coords)
    _add_events(outcome, dims, variables)
    add_maps(outcome, dims, variables, coords)
    if outcome.indices:
        more, places = sensitivity.variables(outcome.indices, _varied(outcome))
        variables, coords = {**variables, **more}, {**coords, **places}
    return variables, coords, outcome.provenance.attributes(outcome.study.title, study_text(outcome.study))


def _add_fields(outcome: Outcome, dims: tuple[str, ...], variables: dict[str, Any], coords: dict[str, Any]) -> None:
    for below in (False, True):
        of_point = [(point, point.subsurface if below else point.surface) for point in outcome.solved]
        if not any(fields for _, fields in of_point):
            continue
        first = next(fields[0] for _, fields in of_point if fields)
        owner = type(first)
        loads = max(len(fields) for _, fields in of_point)
        outer = (*dims, *((LOAD_DIMENSION,) if loads > 1 else ()))
        inner = _place_dims(outcome, owner, below, outer, of_point, coords)
        names = [field.name for field in dataclasses.fields(first) if field.name not in ("r", "z")]
        for name in [*names, *(EXTRA_STRESSES if below else ())]:
            variable = f"field_{name}" if name in outcome.answers else name
            content = _stacked(outcome, of_point, name, loads)
            variables[variable] = ((*outer, *inner), content, netcdf_attributes(word(owner, name)))


def _add_events(outcome: Outcome, dims: tuple[str, ...], variables: dict[str, Any]) -> None:
    for name in EVENTS:
        point_rows = rows_of(outcome, name)
        count = max((len(events) for _, events in point_rows), default=0)
        for place, one in enumerate(point_rows[0][1][0] if point_rows else ()):
            text = isinstance(one.content, str)
            content = np.full((*outcome.shape, count), "" if text else np.nan, dtype=object if text else float)
            for point, events in point_rows:
                content[point.index][: len(events)] = [event[place].content for event in events]
            numbers = content.astype(str) if text else content
            variables[f"{name}_{one.name}"] = ((*dims, name), numbers, netcdf_attributes(one.word))


def _place_dims(
    outcome: Outcome, owner: type, below: bool, outer: tuple[str, ...], of_point: list[Any], coords: dict[str, Any]
) -> tuple[str, ...]:
    """Add the places of the fields to `coords`, and return their dimensions."""
    dims = []
    for number, name in enumerate(("r", "z") if below else ("r",)):
        grid = getattr(outcome.study.fields, name)
        entry = word(owner, name)
        variable = f"field_{name}" if name in outcome.answers else name
        if not grid.relative:
            coords[variable] = ((variable,), grid.values, netcdf_attributes(entry))
            dims.append(variable)
            continue
        relative = f"{variable}_over_a"
        meaning = Word(f"{entry.symbol}/a", "", f"{entry.meaning}, over the contact radius")
        coords[relative] = ((relative,), grid.values, netcdf_attributes(meaning))
        dims.append(relative)
        loads = max(len(fields) for _, fields in of_point)
        content = _stacked(outcome, of_point, name, loads)
        if below:
            content = content[..., :, 0] if number == 0 else content[..., 0, :]
        coords[variable] = ((*outer, relative), content, netcdf_attributes(entry))
    return tuple(dims)


def _stacked(outcome: Outcome, of_point: list[tuple[SolvedPoint, Any]], name: str, loads: int) -> Array:
    """Return one field of all points and loads, NaN where there is none; no axis of loads if each has one."""
    shape = next(
        np.broadcast_shapes(fields[0].r.shape, np.shape(getattr(fields[0], name))) for _, fields in of_point if fields
    )
    content = np.full((*outcome.shape, loads, *shape), np.nan)
    for point, fields in of_point:
        for load, one in enumerate(fields):
            content[(*point.index, load)] = np.broadcast_to(getattr(one, name), shape)
    return content if loads > 1 else content[(slice(None),) * len(outcome.shape) + (0,)]
