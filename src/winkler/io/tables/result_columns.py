"""Modulus and hardness in the columns of a text table, beside the depth and force of a nanoindenter."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence

import numpy as np

from winkler.errors import InvalidInput
from winkler.io.stated_results import HARDNESS_NAMES, YOUNG_NAMES, StatedResults, stated_results
from winkler.io.tables.column import Column
from winkler.io.tables.given_units import GivenFacts
from winkler.io.tables.header import names_columns
from winkler.io.tables.table import read_table

__all__ = ["table_results"]

COLUMNS = (Column("modulus", YOUNG_NAMES, "Pa", "GPa"), Column("hardness", HARDNESS_NAMES, "Pa", "GPa"))


def table_results(
    path: str | os.PathLike[str], place: Column, head: Sequence[str], given: GivenFacts
) -> StatedResults | None:
    """Return the results in a text table whose depth is read from the column `place`; None where it has none."""
    columns = [one for one in COLUMNS if names_columns(path, (place, one), head=head)]
    if not columns:
        return None
    try:
        units = {key: unit for key, unit in given.units.items() if key == "position"}
        table = read_table(path, [place, *columns], units=units, decimal_comma=True, repeated=True)
    except InvalidInput:  # blank cells, or no unit: they are no part of the curve
        return None
    found = {one.word: table.values[:, 1 + index] for index, one in enumerate(columns)}
    nothing = np.full(table.values.shape[0], math.nan)
    return stated_results(table.values[:, 0], found.get("modulus", nothing), found.get("hardness", nothing))
