"""Named columns of numbers in HDF5 and MATLAB files, as the sheets of a workbook.

A group of an HDF5 file, or a structure of a MATLAB file, whose vectors have one length is a sheet; so is a table of
records, and a frame that pandas has stored.  Of cell arrays beside each other, one for each quantity, the first cells
are a sheet, then the second ones, and so on; a cell that is a matrix is one with its columns numbered.

Where pandas keeps the names of columns as a pickle, only the texts in it are read; nothing of it is run.
"""

from __future__ import annotations

import math
import pickletools
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from winkler.io.hdf5_file import refuse_other_files
from winkler.io.memory import limited_memory
from winkler.io.workbooks.open_document import Cell, WorkbookSheet
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput

HDF5, MATLAB = b"\x89HDF\r\n\x1a\n", b"MATLAB 5.0 MAT-file"
MATLAB_HDF5 = b"MATLAB 7.3 MAT-file"
"""How the files begin; that of MATLAB's own HDF5 has a block of 512 bytes before it."""
START_BYTES = 32
FEWEST_COLUMNS, FEWEST_ROWS = 2, 3
DEEPEST = 8
"""Levels of structures and groups."""
UNITS = ("unit", "units")
MATLAB_CLASS = "MATLAB_class"
AFMFORMATS = ("software", "software version")
"""Attributes of the files that afmformats writes and reads."""
TEXTS = ("UNICODE", "BINUNICODE", "SHORT_BINUNICODE")
"""Codes of pickle that hold a text."""
Refuse = Callable[[str, int, int], None]


def is_array_workbook(path: Path) -> bool:
    """Return whether a file is of HDF5 or MATLAB, and none of afmformats' own."""
    with path.open("rb") as file:
        start = file.read(START_BYTES)
    if not start.startswith(HDF5):
        return start.startswith((MATLAB, MATLAB_HDF5))
    import h5py

    try:
        with h5py.File(path, "r") as book:
            return not all(name in book.attrs for name in AFMFORMATS)
    except OSError:  # damaged: its readers say so
        return False


def array_sheets(path: Path, refuse: Refuse) -> Iterator[WorkbookSheet]:
    """Yield the groups of vectors of one length, each as a sheet with their names in its first row.

    Parameters
    ----------
    path : path
        The file.
    refuse : callable
        Takes the name of a sheet, a number of rows and one of columns, and raises where these are too many.

    Raises
    ------
    InvalidInput
        If its contents lie in other files, a sheet is too large, or there is none.
    """
    with path.open("rb") as file:
        is_old = file.read(START_BYTES).startswith(MATLAB)
    with limited_memory(path):
        if is_old:
            from scipy.io import loadmat

            named = {name: one for name, one in loadmat(path, simplify_cells=True).items() if not name.startswith("__")}
            groups = list(_structures(named, path.stem, 0))
        else:
            import h5py

            refuse_other_files(path)
            with h5py.File(path, "r") as file:
                groups = list(_groups(file, refuse))
        sheets = [sheet for name, columns in groups for sheet in _sheets(name, columns, refuse)]
    if not sheets:
        raise InvalidInput(
            f"{path}: it holds no table: no two vectors of one length, {FEWEST_ROWS} or more, with names; save the "
            "columns under names in one group or structure, or as text (CSV)."
        )
    yield from sheets


def _sheets(name: str, columns: Mapping[str, Array], refuse: Refuse) -> Iterator[WorkbookSheet]:
    """Yield the vectors of each length that two or more of them have."""
    sizes = [vector.size for vector in columns.values()]
    for size in dict.fromkeys(sizes):
        if size < FEWEST_ROWS or sizes.count(size) < FEWEST_COLUMNS:
            continue
        alike = {column: vector for column, vector in columns.items() if vector.size == size}
        refuse(name, size, len(alike))
        rows: list[list[Cell]] = [list(alike)]
        rows += [
            [number if math.isfinite(number) else "" for number in row]
            for row in np.column_stack([*alike.values()]).tolist()
        ]
        yield WorkbookSheet(name, rows)


def _structures(fields: Mapping[str, Any], name: str, depth: int) -> Iterator[tuple[str, dict[str, Array]]]:
    """Yield the vectors of a structure of MATLAB, then those of the structures in it."""
    yield name, {field: vector for field, one in fields.items() if (vector := _vector(one)) is not None}
    yield from _cells(fields, name)
    for field, one in fields.items():
        several = _several(one) or [one]
        for number, part in enumerate(several, start=1):
            if isinstance(part, Mapping) and depth < DEEPEST:
                place = f" {number}" if len(several) > 1 else ""
                yield from _structures(part, f"{name}.{field}{place}" if depth else f"{field}{place}", depth + 1)


def _several(item: Any) -> list[Any]:
    """Return the cells of an array of cells or structures; none of other items."""
    if isinstance(item, np.ndarray):
        return list(item.ravel()) if item.dtype == object else []
    return item if isinstance(item, list) and not all(isinstance(one, int | float) for one in item) else []


def _cells(fields: Mapping[str, Any], name: str) -> Iterator[tuple[str, dict[str, Array]]]:
    """Yield what stands in the cells of each place: a vector of each array of cells, or the columns of a matrix."""
    arrays = {field: cells for field, one in fields.items() if (cells := _several(one))}
    for number in range(max(map(len, arrays.values()), default=0)):
        beside = {field: cells[number] for field, cells in arrays.items() if number < len(cells)}
        vectors = {field: vector for field, cell in beside.items() if (vector := _vector(cell)) is not None}
        yield f"{name} {number + 1}", vectors
        for field, cell in beside.items():
            matrix = np.asarray(cell) if isinstance(cell, np.ndarray) else np.zeros(0)
            if matrix.dtype.kind in "iuf" and matrix.ndim == 2 and FEWEST_COLUMNS <= matrix.shape[1] < len(matrix):
                columns = {f"{field} {place}": one.astype(float) for place, one in enumerate(matrix.T, start=1)}
                yield f"{field} {number + 1}", columns


def _groups(group: Any, refuse: Refuse, depth: int = 0) -> Iterator[tuple[str, dict[str, Array]]]:
    """Yield the vectors of a group of HDF5, tables of records in it, and its groups."""
    import h5py

    items = {name: group[name] for name in group if not name.startswith("#")}  # what cells of MATLAB refer to
    if "block0_values" in items and "block0_items" in items:
        yield _sheet_name(group), _frame(items, refuse, group.name)
        return
    columns: dict[str, Array] = {}
    cells: dict[str, list[Array]] = {}
    for name, item in items.items():
        if isinstance(item, h5py.Dataset) and item.dtype == h5py.ref_dtype:
            refuse(item.name, 1, item.size)
            parts = [item.file[one] for one in np.ravel(item[()]).tolist() if one]
            parts = [one for one in parts if isinstance(one, h5py.Dataset) and one.dtype.kind in "iuf"]
            for part in parts:
                refuse(item.name, part.size, 1)
            cells[name] = [part[()].T for part in parts]  # MATLAB counts along columns
        elif isinstance(item, h5py.Group):
            if depth < DEEPEST:
                yield from _groups(item, refuse, depth + 1)
        elif item.dtype.names:
            refuse(item.name, item.size, len(item.dtype.names))
            yield _sheet_name(item), dict(_fields(np.ravel(item[()]), item.attrs))
        elif item.ndim and item.size == max(item.shape) and item.attrs.get(MATLAB_CLASS) != b"char":
            refuse(item.name, item.size, 1)
            if (vector := _vector(item[()])) is not None:
                columns[_with_unit(name, item.attrs)] = vector
    yield _sheet_name(group), columns
    yield from _cells(cells, _sheet_name(group))


def _fields(records: Array, attributes: Mapping[str, Any]) -> Iterator[tuple[str, Array]]:
    """Yield the columns of a table of records; a field of several numbers has the names of its attribute "_kind"."""
    for field in records.dtype.names or ():
        of_field = records[field]
        names = _texts(attributes.get(f"{field}_kind", b"")) if of_field.ndim == 2 else []
        if len(names) == of_field.shape[-1] and of_field.ndim == 2:
            yield from (
                (name, vector)
                for name, one in zip(names, of_field.T, strict=True)
                if (vector := _vector(one)) is not None
            )
        elif (vector := _vector(of_field)) is not None:
            yield field, vector


def _texts(stored: Any) -> list[str]:
    """Return the texts of a pickled list, which is looked through and not run."""
    try:
        return [str(text) for code, text, _ in pickletools.genops(bytes(stored)) if code.name in TEXTS]
    except (TypeError, ValueError):
        return []


def _sheet_name(item: Any) -> str:
    """Return the place of a group or table in its file, without the last part of what PyTables writes."""
    return str(item.name).strip("/").removesuffix("/table") or Path(item.file.filename).stem


def _frame(items: Mapping[str, Any], refuse: Refuse, name: str) -> dict[str, Array]:
    """Return the columns of a frame of pandas: blocks of one type each, a column in each of their columns."""
    columns: dict[str, Array] = {}
    for number in range(len(items)):
        if f"block{number}_values" not in items:
            break
        stored = items[f"block{number}_values"]
        if stored.dtype.kind in "iuf" and stored.ndim == 2:
            refuse(name, *stored.shape)
            names = [one.decode("utf-8", "replace") for one in items[f"block{number}_items"][()].tolist()]
            columns |= dict(zip(names, np.asarray(stored[()], dtype=float).T, strict=False))
    return columns


def _vector(item: Any) -> Array | None:
    """Return real numbers in one row or column; None of other items."""
    array = np.asarray(item) if isinstance(item, np.ndarray | list) else None
    if array is None or array.dtype.kind not in "iufb" or not array.size or array.size != max(array.shape):
        return None
    return np.ravel(array).astype(float)


def _with_unit(name: str, attributes: Mapping[str, Any]) -> str:
    stated = next((attributes[word] for word in UNITS if word in attributes), "")
    unit = stated.decode("utf-8", "replace") if isinstance(stated, bytes) else str(stated)
    return f"{name} [{unit}]" if unit else name
