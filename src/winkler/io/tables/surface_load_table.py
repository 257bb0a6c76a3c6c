"""Maps of pressure and traction of other programs: tables of places and stresses, or arrays of NumPy."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from winkler.io.array_file import read_arrays
from winkler.io.foreign import in_file, reader
from winkler.io.tables.header import names_columns
from winkler.io.tables.table import Column, Table, read_table
from winkler.io.text_file import existing
from winkler.numerics.types import Array
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.values.errors import InvalidInput
from winkler.values.limits import MOST_NUMBERS

X, Y = Column("x", ("x",), "m", "mm"), Column("y", ("y",), "m", "mm")
PRESSURE = Column("pressure", ("pressure", "p", "pn"), "Pa", "MPa")
X_TRACTION = Column("traction along x", ("x_traction", "traction_x", "tx", "qx", "px"), "Pa", "MPa")
Y_TRACTION = Column("traction along y", ("y_traction", "traction_y", "ty", "qy", "py"), "Pa", "MPa")
ARRAYS = ("pressure", "lengths", "x_traction", "y_traction", "corner")
UNEVEN = 0.02
"""By which part of a pixel a place may lie beside the grid: rounding of printed places."""


@reader("a map of pressures")
def read_surface_load(path: str | os.PathLike[str], *, periodic: bool = False) -> SurfaceLoad:
    """Read pressures and tractions on a surface.

    Parameters
    ----------
    path : str or path
        A table with the columns x, y and pressure, and x_traction and y_traction where there are some, whose header
        names the units: one line for each pixel of a rectangular grid, in any order; pixels that are not listed carry
        no load.  Or an NPZ file with the arrays ``pressure`` (nx, ny) and ``lengths``, and optionally ``x_traction``,
        ``y_traction`` and ``corner``, in SI units.
    periodic : bool, optional
        Whether the map is repeated without end.

    Returns
    -------
    SurfaceLoad

    Raises
    ------
    InvalidInput
        If the file cannot be read, columns or units are missing, or the places form no grid.
    """
    file = existing(path, "a map of pressures")
    if file.suffix.lower() == ".npz":
        return _of_arrays(file, periodic)
    columns = [X, Y, PRESSURE]
    columns += [column for column in (X_TRACTION, Y_TRACTION) if names_columns(file, (X, Y, PRESSURE, column))]
    table = read_table(file, columns)
    first, pixels, places = zip(*(_axis(table, axis) for axis in (0, 1)), strict=True)
    shape = tuple(int(place.max()) + 1 for place in places)
    if np.prod(shape, dtype=float) > MOST_NUMBERS:
        raise InvalidInput(f"{file}: a grid of {shape[0]} x {shape[1]} pixels is too large; give a part of it.")
    if np.unique(places[0] * shape[1] + places[1]).size < len(table.values):
        raise InvalidInput(f"{file}: some places are listed twice; give each pixel once.")
    maps = {column.word: np.zeros(shape) for column in columns[2:]}
    for column, content in zip(columns[2:], table.values[:, 2:].T, strict=True):
        maps[column.word][places] = content
    with in_file(file):
        return SurfaceLoad(
            maps[PRESSURE.word],
            np.array(shape) * pixels,
            maps.get(X_TRACTION.word, np.zeros(0)),
            maps.get(Y_TRACTION.word, np.zeros(0)),
            np.array(first) - 0.5 * np.array(pixels),
            periodic,
        )


def _axis(table: Table, axis: int) -> tuple[float, float, Array]:
    """Return the first place of a grid [m], the size of its pixels [m], and the pixel of every line."""
    places = table.values[:, axis]
    least, most = float(places.min()), float(places.max())
    different = np.unique(places)
    name = "xy"[axis]
    if different.size < 2:
        raise InvalidInput(f"{table.path}: all places lie at one {name}; give a grid of at least 2 x 2 pixels.")
    steps = np.diff(different)
    pixel = float(np.min(steps[steps > UNEVEN * (most - least) / different.size]))
    count = round((most - least) / pixel)
    pixel = (most - least) / count
    index = (places - least) / pixel
    off = np.abs(index - np.round(index))
    if float(off.max()) > UNEVEN:
        line = int(table.lines[int(np.argmax(off))])
        raise InvalidInput(
            f"{table.path}, line {line}: {name} = {places[int(np.argmax(off))]:.6g} m lies between the pixels of "
            f"{pixel:.6g} m that the other places form; give an even grid."
        )
    return least, pixel, np.round(index).astype(int)


def _of_arrays(file: Path, periodic: bool) -> SurfaceLoad:
    found = read_arrays(
        file, ARRAYS, needed=ARRAYS[:2], wrong="it holds no map of pressures",
        remedy="save pressure (nx, ny) in Pa and lengths (2,) in m with numpy.savez",
    )  # fmt: skip
    with in_file(file):
        return SurfaceLoad(**{name: found[name] for name in ARRAYS if name in found}, periodic=periodic)
