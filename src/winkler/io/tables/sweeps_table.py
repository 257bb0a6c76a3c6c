"""Sweeps of moduli over temperature in tables: one table with a column of temperatures, or several."""

from __future__ import annotations

import glob
import math
import os
from collections.abc import Callable, Sequence

import numpy as np

from winkler.io.foreign import in_file, reader
from winkler.io.tables.header import names_columns
from winkler.io.tables.relaxation_table import (
    DYNAMIC_HEADERS,
    RELAXATION_HEADERS,
    dynamic_rows,
    moduli_table,
    positive_rows,
    young_over_shear,
)
from winkler.io.tables.table import Column
from winkler.io.tables.tests_of_table import parts_of_table
from winkler.materials.sweeps import DynamicSweeps, RelaxationSweeps
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput

RELAXED_MODULI = RELAXATION_HEADERS[:2]
"""Columns of a modulus; strain and stress are read of one test."""
TEMPERATURE = Column("temperature", ("temperature", "temp", "temp.", "t_c", "temperatur", "温度"), "K", "degC")
TEMPERATURE_OR_T = Column(TEMPERATURE.word, (*TEMPERATURE.names, "t"), "K", "degC")
"""Where there is no time, T is the temperature."""
LEAST_RANGE, SAME_FREQUENCY = 1.0, 1e-6
"""Temperatures [K], and relative frequencies, that differ by less are one."""


@reader("sweeps of storage and loss")
def read_dynamic_sweeps(path: str | os.PathLike[str], *, poisson: float = 0.5, header: str = "") -> DynamicSweeps:
    """Read storage and loss at several temperatures.

    Parameters
    ----------
    path : str or path
        A table with the columns temperature, frequency (f) or angular_frequency (omega), and storage and loss of shear
        (g', g'') or of tension (tensile_storage, tensile_loss, e', e''), as in ``temperature [degC], frequency [Hz],
        storage [MPa], loss [MPa]``; or one with a group of columns for each temperature, which is stated above or in
        the column names, as ``G' (20 °C)``; or a pattern such as ``"rubber_*.csv"`` of several such tables.
    poisson : float, optional
        nu [-], above -1 and at most 0.5.
    header : str, optional
        The names and units of all columns, where the files have none, as in the line above.

    Returns
    -------
    DynamicSweeps
        Up to a fifth of the rows of a table, whose storage or loss is not positive, are left out; ``reading`` says so.

    Raises
    ------
    InvalidInput
        If a file cannot be read, or its rows are no sweeps.
    """
    readings: dict[str, None] = {}

    def read(part: str | os.PathLike[str], first: tuple[Column, ...]) -> Array:
        found, reading = positive_rows(*dynamic_rows(part, first, poisson, header))
        readings.update({f"{os.path.basename(part)}: {reading}": None} if reading else {})
        return found

    rows = [_rows(file, DYNAMIC_HEADERS, read, TEMPERATURE_OR_T, header) for file in _files(path)]
    with in_file(str(path)):
        temperature, angular, storage, loss = np.concatenate(rows).T
        if np.ptp(temperature) < LEAST_RANGE and np.ptp(angular) <= SAME_FREQUENCY * angular.max():
            raise InvalidInput(
                f"all of its {angular.size} rows have one frequency, {angular[0]:.4g} rad/s, and one temperature, "
                f"{temperature[0]:.4g} K, as in a sweep of time or strain; give sweeps of frequency or temperature."
            )
        return DynamicSweeps(temperature, angular, storage, loss, poisson=poisson, reading="; ".join(readings))


@reader("sweeps of relaxation")
def read_relaxation_sweeps(path: str | os.PathLike[str], *, poisson: float = 0.5, header: str = "") -> RelaxationSweeps:
    """Read relaxation at several temperatures.

    Parameters
    ----------
    path : str or path
        A table with the columns temperature, time (t), and shear (g) or young (e), as in ``temperature [degC], time
        [s], shear [kPa]``; or one with a group of columns for each temperature; or a pattern such as
        ``"gel_*.csv"`` of several such tables.
    poisson : float, optional
        nu [-], above -1 and at most 0.5.
    header : str, optional
        The names and units of all columns, where the files have none, as in the line above.

    Returns
    -------
    RelaxationSweeps

    Raises
    ------
    InvalidInput
        If a file cannot be read, or its rows are no sweeps.
    """

    def read(part: str | os.PathLike[str], first: tuple[Column, ...]) -> Array:
        return _moduli(part, first, poisson, header)

    rows = [_rows(file, RELAXED_MODULI, read, TEMPERATURE, header) for file in _files(path)]
    with in_file(str(path)):
        temperature, time, shear = np.concatenate(rows).T
        return RelaxationSweeps(temperature, time, shear, poisson=poisson)


def _rows(
    file: str,
    headers: Sequence[tuple[Column, ...]],
    read: Callable[[str | os.PathLike[str], tuple[Column, ...]], Array],
    temperature: Column,
    header: str,
) -> Array:
    """Return the rows of a table, temperature first; of tests side by side those of each, below each other."""
    parts = [] if header else parts_of_table(file, headers, below=False)
    if len(parts) < 2:
        try:
            return read(file, (temperature,))
        except InvalidInput:
            parts = [] if header else parts_of_table(file, headers)
            if len(parts) < 2:
                raise
    rows = []
    for part in parts:
        if math.isnan(part.temperature) or any(names_columns(part, (TEMPERATURE, *columns)) for columns in headers):
            rows.append(read(part, (temperature,)))
        else:  # it stands above the names or in them
            found = read(part, ())
            rows.append(np.column_stack([np.full(found.shape[0], part.temperature), found]))
    return np.concatenate(rows)


def _moduli(file: str | os.PathLike[str], first: tuple[Column, ...], poisson: float, header: str) -> Array:
    """Return the rows of a table with moduli in shear."""
    head = [header] if header else None
    sheared, tensile = ((*first, *columns) for columns in RELAXED_MODULI)
    tension = names_columns(file, tensile, head=head) and not names_columns(file, sheared, head=head)
    values = np.array(moduli_table(file, tensile if tension else sheared, header).values)
    if tension:
        values[:, -1] /= young_over_shear(poisson)
    return values


def _files(path: str | os.PathLike[str]) -> list[str]:
    """Return the file, or those that match a pattern, in the order of their names."""
    text = os.fspath(path)
    if not glob.has_magic(text) or os.path.exists(text):
        return [text]
    files = sorted(glob.glob(text))
    if not files:
        raise InvalidInput(f"{text}: no file matches the pattern; check the folder and the ending.")
    return files
