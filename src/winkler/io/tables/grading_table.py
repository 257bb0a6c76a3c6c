"""Gradings in tables: Young's modulus, and perhaps Poisson's ratio, measured at depths below the surface."""

from __future__ import annotations

import math
import os

import numpy as np

from winkler.io.foreign import in_file, reader
from winkler.io.tables.header import names_columns
from winkler.io.tables.table import Column, read_table
from winkler.materials.depth_grading import TabulatedGrading
from winkler.values.errors import InvalidInput

DEPTH = Column("depth", ("depth", "z"), "m", "um")
YOUNG = Column("Young's modulus", ("young", "e", "modulus"), "Pa", "GPa")
POISSON = Column("Poisson's ratio", ("poisson", "nu"), "")


@reader("a grading")
def read_grading(path: str | os.PathLike[str], *, poisson: float = math.nan) -> TabulatedGrading:
    """Read a grading from a table with the columns depth (z), young (E, modulus) and, if measured, poisson (nu).

    Parameters
    ----------
    path : str or path
        The file.  Its header contains units, as in ``depth [um], young [GPa], poisson``; depths begin with 0 at the
        surface and ascend, and the body is homogeneous below the last one.
    poisson : float, optional
        Poisson's ratio [-] at every depth, above -1 and at most 0.5: for a table that has no such column.

    Returns
    -------
    TabulatedGrading

    Raises
    ------
    InvalidInput
        If the file cannot be read, it does not contain a grading, or poisson is given twice or not at all.
    """
    has_poisson = names_columns(path, (DEPTH, YOUNG, POISSON))
    if has_poisson and not math.isnan(poisson):
        raise InvalidInput(
            f"{path}: the table has a column of Poisson's ratios, and poisson = {poisson:g} was given "
            "as well; leave one of them out."
        )
    table = read_table(path, (DEPTH, YOUNG, POISSON) if has_poisson else (DEPTH, YOUNG))
    if not has_poisson and math.isnan(poisson):
        raise InvalidInput(
            f"{path}: the table has no column of Poisson's ratios (poisson, nu); add it, or give "
            "poisson, which then holds at every depth."
        )
    depths, youngs = table.values[:, 0], table.values[:, 1]
    poissons = table.values[:, 2] if has_poisson else np.full(depths.shape, poisson)
    with in_file(table.path):
        return TabulatedGrading(depths, youngs, poissons)
