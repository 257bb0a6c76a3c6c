"""Paths in tables: a time in every row, with the prescribed normal and tangential load or displacement."""

from __future__ import annotations

import os

from winkler.io.foreign import in_file, reader
from winkler.io.tables.header import names_columns
from winkler.io.tables.table import Column, read_table
from winkler.loading.loads import Angle, Depth, Force, ShearForce, Shift, Torque
from winkler.loading.path import Path
from winkler.values.errors import InvalidInput

TIME = Column("time", ("time", "t"), "s", "ms")
NORMAL_COLUMNS: dict[type[Depth] | type[Force], tuple[Column, ...]] = {
    Depth: (Column("depth", ("depth", "d"), "m", "um"),),
    Force: (Column("normal force", ("force", "normal_force", "normal force", "f_n"), "N"),),
}
LATERAL_COLUMNS: dict[type[Shift] | type[ShearForce] | type[Angle] | type[Torque], tuple[Column, ...]] = {
    Shift: (Column("shift", ("shift", "u_x", "ux"), "m", "um"),),
    ShearForce: (Column("shear force", ("shear_force", "shear force", "f_x", "fx"), "N"),),
    Angle: (Column("angle", ("angle", "phi"), "rad", "deg"),),
    Torque: (Column("torque", ("torque", "m_z", "mz"), "N m"),),
}
SECOND_COLUMNS: dict[type, Column] = {
    Shift: Column("shift along y", ("shift_y", "shift y", "u_y", "uy"), "m", "um"),
    ShearForce: Column("shear force along y", ("shear_force_y", "shear force y", "f_y", "fy"), "N"),
}
"""The second direction in the plane, beside the first."""


@reader("a path")
def read_path(path: str | os.PathLike[str]) -> Path:
    """Read a path from a table with the columns time (t), depth (d) or force, and what moves the bodies sideways.

    Sideways one of shift (u_x), shear_force (f_x), angle (phi), torque (m_z), or none; in the plane shift and shift_y
    (u_y), or shear_force and shear_force_y (f_y).

    Parameters
    ----------
    path : str or path
        The file.  Its header contains units, as in ``time [s], force [N], shift [um]``; other columns are ignored.

    Returns
    -------
    Path

    Raises
    ------
    InvalidInput
        If the file cannot be read, a load is missing or given twice, or it does not contain a path.
    """
    normals = [kind for kind, columns in NORMAL_COLUMNS.items() if names_columns(path, columns)]
    laterals = [kind for kind, columns in LATERAL_COLUMNS.items() if names_columns(path, columns)]
    if len(normals) != 1:
        stated = "both a depth and a normal force" if normals else "neither a depth nor a normal force"
        raise InvalidInput(
            f"{path}: the table has {stated}; a path needs one of both, such as '{TIME.example}, "
            f"{NORMAL_COLUMNS[Force][0].example}, {LATERAL_COLUMNS[Shift][0].example}'."
        )
    if len(laterals) > 1:
        words = " and ".join(LATERAL_COLUMNS[kind][0].word for kind in laterals)
        raise InvalidInput(f"{path}: the table has columns of {words}; only one of them can drive the bodies sideways.")
    columns = [TIME, *NORMAL_COLUMNS[normals[0]]]
    for kind in laterals:
        columns += LATERAL_COLUMNS[kind]
        if kind in SECOND_COLUMNS and names_columns(path, (SECOND_COLUMNS[kind],)):
            columns.append(SECOND_COLUMNS[kind])
    table = read_table(path, columns)
    normal = normals[0](table.values[:, 1])
    lateral = table.values[:, 2:]
    with in_file(table.path):
        if not laterals:
            return Path(table.values[:, 0], normal)
        return Path(table.values[:, 0], normal, laterals[0](lateral if lateral.shape[1] == 2 else lateral[:, 0]))
