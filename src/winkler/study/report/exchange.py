"""Exchange with other programs: any solution, field or outcome of a study as an xarray dataset or a pandas table.

Numbers stay in SI units.  Units, meanings and symbols of the glossary are added: in the attributes of every
variable of a dataset, and in ``attrs["units"]``, ``attrs["meanings"]`` of a table.
"""

from __future__ import annotations

import contextlib
import dataclasses
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.problems.answer import Assessed, Posed
from winkler.study.batch.outcome import Outcome, answers_of
from winkler.study.language.study import Study
from winkler.study.language.writing import study_text
from winkler.study.report.archive import LOAD_DIMENSION, dataset
from winkler.study.report.netcdf import netcdf_attributes
from winkler.values.checks.contract import keeps
from winkler.values.errors import InvalidInput, OutsideValidity, WinklerError
from winkler.values.vocabulary import Word, word

if TYPE_CHECKING:
    import pandas
    import xarray


PLACE_NAMES = ("r", "x", "y", "z")
"""Fields that are coordinates."""
PLANE_AXIS = ("direction", ("x", "y"))
"""Last axis of vectors along the surface: its name, and those of the components."""
PRINCIPAL_AXIS = ("principal_axis", ("greatest", "middle", "least"))
"""Last axis of the principal stresses."""


def to_xarray(answer: Any) -> xarray.Dataset:
    """Return a solution or other result as an xarray dataset.

    Parameters
    ----------
    answer : solution, fields or outcome of a study
        What ``solve()``, ``restore(...)`` and similar functions, or ``winkler.study.batch.run.run(study)`` returns.

    Returns
    -------
    xarray.Dataset
        Every quantity with a unit in the glossary, in SI units.  Dimensions: ``load`` for many loads or the points of
        a path; the places of fields (``r``, ``z`` or ``x``, ``y``, ``z``); the keys of the sweep of an outcome.  Each
        variable has the attributes ``units``, ``long_name`` and ``symbol``.  For a solution the dataset has the
        attributes ``validity`` (its notes) and, if available, ``study`` (its study file).

    Raises
    ------
    InvalidInput
        If `answer` is no answer, or holds nothing that can be a variable.

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.problems.normal.indentation import Indentation
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(10e-3), HalfSpace(Elastic(210e9, 0.3)))
    >>> pressed = to_xarray(Indentation(bed, Force(np.array([1.0, 10.0, 100.0]))).solve())
    >>> pressed.depth.attrs["units"], dict(pressed.sizes)
    ('m', {'load': 3})
    """
    import xarray

    if isinstance(answer, Outcome):
        return dataset(answer)
    _check("to_xarray", answer)
    if _is_field(answer):
        variables, coords = _of_field(answer)
        return xarray.Dataset(variables, coords, {"title": type(answer).__name__, "program": "winkler"})
    owner = type(answer)
    variables = {}
    for name, content in answers_of(answer).items():
        attributes = netcdf_attributes(_entry(owner, name))
        variables[name] = (
            ((LOAD_DIMENSION,), content, attributes) if np.ndim(content) == 1 else _grid(name, content, attributes)
        )
    return xarray.Dataset(variables, attrs=_attributes(answer))


def to_pandas(answer: Any) -> pandas.DataFrame:
    """Return a solution or other result as a pandas table.

    Parameters
    ----------
    answer : solution, fields or outcome of a study
        As for `to_xarray`.

    Returns
    -------
    pandas.DataFrame
        One row per load, point of a path, or place of a field; of an outcome, one per point and load, as in its
        results.csv.  Numbers are in SI units; ``attrs["units"]`` and ``attrs["meanings"]`` hold those of each column.

    Raises
    ------
    InvalidInput
        If `answer` is no answer, or holds nothing that can be a column.
    """
    import pandas

    if isinstance(answer, Outcome):
        columns = {column.name: (column.content, column.word) for column in answer.table()}
    else:
        _check("to_pandas", answer)
        owner = type(answer)
        columns = {name: (content, _entry(owner, name)) for name, content in _flat(answer).items()}
    rows = max(np.size(content) for content, _ in columns.values())
    table = pandas.DataFrame(
        {name: np.broadcast_to(np.ravel(content), (rows,)).copy() for name, (content, _) in columns.items()}
    )
    table.attrs["units"] = {name: entry.unit for name, (_, entry) in columns.items() if entry.unit is not None}
    table.attrs["meanings"] = {name: entry.meaning for name, (_, entry) in columns.items()}
    return table


def _check(caller: str, answer: Any) -> None:
    """Refuse what is no answer."""
    solved = keeps(answer, Posed) or keeps(answer, Assessed) or _is_field(answer)
    if isinstance(answer, type) or not dataclasses.is_dataclass(answer) or not solved:
        made = "a class" if isinstance(answer, type) else f"a {type(answer).__name__}"
        raise InvalidInput(
            f"{caller}: this is {made}; give what solve(), restore() or run() returns (solve a problem first)."
        )
    if not _is_field(answer) and not answers_of(answer):
        raise InvalidInput(f"{caller}: the {type(answer).__name__} holds no quantities of the glossary.")


def _is_field(answer: Any) -> bool:
    """Return whether a value holds quantities at places, and no problem."""
    if isinstance(answer, type) or not dataclasses.is_dataclass(answer) or keeps(answer, Posed):
        return False
    names = [field.name for field in dataclasses.fields(answer)]
    return names[0] in PLACE_NAMES and all(isinstance(getattr(answer, name), np.ndarray | float) for name in names)


def _entry(owner: type, name: str) -> Word:
    """Return the glossary entry of an answer; that of a component (``shift_x``) is the entry of the vector."""
    whole, _, part = name.rpartition("_")
    return word(owner, whole if whole and part in (*PLANE_AXIS[1], *PRINCIPAL_AXIS[1]) else name)


def _parts(name: str) -> tuple[str, tuple[str, ...]]:
    """Return the last axis of a field that has one more than its places."""
    return PRINCIPAL_AXIS if name == "principal" else PLANE_AXIS


def _grid(name: str, content: Any, attributes: dict[str, str]) -> tuple[tuple[str, ...], Any, dict[str, str]]:
    dims = () if np.ndim(content) == 0 else tuple(f"{LOAD_DIMENSION}_{place}" for place in range(np.ndim(content)))
    return dims, content, attributes


def _attributes(answer: Any) -> dict[str, str]:
    notes = getattr(answer, "validity", ())
    texts = {"title": type(answer).__name__, "program": "winkler"}
    if notes:
        texts["validity"] = "\n".join(f"{note.standing.value}: {note.statement}" for note in notes)
    if keeps(answer, Posed):
        with contextlib.suppress(WinklerError):  # a law that is a function cannot be written in a study file
            texts["study"] = study_text(Study("", answer.problem))
    return texts


def _flat(answer: Any) -> dict[str, Any]:
    """Return name -> numbers, one for every row of a table."""
    if not _is_field(answer):
        return dict(answers_of(answer))
    variables, _ = _of_field(answer)
    shape = np.broadcast_shapes(*(np.shape(getattr(answer, name)) for name in _where(answer)))
    rows = {name: np.broadcast_to(getattr(answer, name), shape) for name in _where(answer)}
    for name, (_, content, _) in variables.items():
        if np.shape(content) == shape:
            rows[name] = content
        else:
            rows |= {f"{name}_{part}": content[..., place] for place, part in enumerate(_parts(name)[1])}
    return rows


def _where(field: Any) -> list[str]:
    return [item.name for item in dataclasses.fields(field) if item.name in PLACE_NAMES]


def _of_field(field: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the variables and the coordinates of a field."""
    owner = type(field)
    where = {name: np.asarray(getattr(field, name)) for name in _where(field)}
    shape = np.broadcast_shapes(*(places.shape for places in where.values()))
    dims, coords = _axes(owner, {name: np.broadcast_to(places, shape) for name, places in where.items()}, shape)
    names = [item.name for item in dataclasses.fields(field) if item.name not in where]
    names += [name for name, member in vars(type(field)).items() if isinstance(member, property) and name[0] != "_"]
    variables: dict[str, Any] = {}
    for name in names:
        try:
            content = np.asarray(getattr(field, name))
        except OutsideValidity:
            continue
        last: tuple[str, ...] = ()
        if content.shape != shape:
            axis, parts = _parts(name)
            coords[axis] = ((axis,), list(parts))
            last = (axis,)
        variables[name] = ((*dims, *last), content, netcdf_attributes(word(owner, name)))
    return variables, coords


def _axes(owner: type, where: dict[str, Any], shape: tuple[int, ...]) -> tuple[tuple[str, ...], dict[str, Any]]:
    """Return a name for every axis, that of the place which alone changes along it, and the places as coordinates."""
    along = {
        name: [axis for axis, count in enumerate(shape) if count > 1 and np.any(np.diff(places, axis=axis) != 0.0)]
        for name, places in where.items()
    }
    dims = []
    for axis in range(len(shape)):
        alone = [name for name, axes in along.items() if axes == [axis]]
        others = [name for name, axes in along.items() if axis in axes]
        dims.append(alone[0] if len(alone) == 1 and others == alone else f"place_{axis}")
    coords: dict[str, Any] = {}
    for name, places in where.items():
        attributes = netcdf_attributes(word(owner, name))
        if name in dims:
            axis = dims.index(name)
            coords[name] = ((name,), np.moveaxis(places, axis, 0).reshape(shape[axis], -1)[:, 0], attributes)
        elif not along[name] and places.size:
            coords[name] = ((), float(places.ravel()[0]), attributes)
        else:
            coords[name] = (tuple(dims), places, attributes)
    return tuple(dims), coords
