"""The columns of one test of an instrument, before it is known which of them are depth, force and time."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.units import scale


class InstrumentColumn(NamedTuple):
    """A column: its name and unit as the file states them, and its numbers ``(n,)``, nan where there is none."""

    name: str
    unit: str
    values: Array


class InstrumentTest(NamedTuple):
    """One test.

    Parameters
    ----------
    instrument : str
        Maker and kind of file, for the reading of the curve.
    name : str
        The file, within a file of many tests also the test.
    columns : tuple of InstrumentColumn
        In the order of the file, all of one length.
    notes : tuple of str
        What the file states about corrections, tip and machine.
    x, y : float
        Place on the sample [m].
    direction : ndarray, (n,) or (0,)
        +1, 0 and -1 as the file states its segments; empty where it does not.
    rows : ndarray, (n,) or (0,)
        Numbers of the rows in the file, which jump where rows are blank; empty where the file parts its tests itself.
    spring_constant : float, optional
        Of a cantilever whose bending the depth still contains [N/m].
    """

    instrument: str
    name: str
    columns: tuple[InstrumentColumn, ...]
    notes: tuple[str, ...] = ()
    x: float = math.nan
    y: float = math.nan
    direction: Array = np.zeros(0)
    rows: Array = np.zeros(0)
    spring_constant: float | None = None


def measures(unit: str, wanted: str) -> bool:
    """Return whether a unit is one of the same quantity as another."""
    try:
        scale(unit, wanted)
    except InvalidInput:
        return False
    return True
