"""Sweeps of moduli over temperature in tables: one table with a column of temperatures, or several."""

from __future__ import annotations

import glob
import os

import numpy as np

from winkler.errors import InvalidInput
from winkler.io.foreign import in_file, reader
from winkler.io.tables.header import names_columns
from winkler.io.tables.relaxation_table import (
    SHEAR_MODULUS,
    TIME,
    YOUNG_MODULUS,
    dynamic_rows,
    moduli_table,
    young_over_shear,
)
from winkler.io.tables.table import Column
from winkler.materials.sweeps import DynamicSweeps, RelaxationSweeps
from winkler.numerics.types import Array

__all__ = ["read_dynamic_sweeps", "read_relaxation_sweeps"]

TEMPERATURE = Column("temperature", ("temperature", "temp", "temp.", "t_c", "temperatur"), "K", "degC")
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
        storage [MPa], loss [MPa]``; or a pattern such as ``"rubber_*.csv"`` of several such tables.
    poisson : float, optional
        nu [-], above -1 and at most 0.5.
    header : str, optional
        The names and units of all columns, where the files have none, as in the line above.

    Returns
    -------
    DynamicSweeps

    Raises
    ------
    InvalidInput
        If a file cannot be read, or its rows are no sweeps.
    """
    rows = []
    for file in _files(path):
        rows.append(dynamic_rows(file, (TEMPERATURE_OR_T,), poisson, header)[1])
    with in_file(str(path)):
        temperature, angular, storage, loss = np.concatenate(rows).T
        if np.ptp(temperature) < LEAST_RANGE and np.ptp(angular) <= SAME_FREQUENCY * angular.max():
            raise InvalidInput(
                f"all of its {angular.size} rows have one frequency, {angular[0]:.4g} rad/s, and one temperature, "
                f"{temperature[0]:.4g} K, as in a sweep of time or strain; give sweeps of frequency or temperature."
            )
        return DynamicSweeps(temperature, angular, storage, loss, poisson=poisson)


@reader("sweeps of relaxation")
def read_relaxation_sweeps(path: str | os.PathLike[str], *, poisson: float = 0.5, header: str = "") -> RelaxationSweeps:
    """Read relaxation at several temperatures.

    Parameters
    ----------
    path : str or path
        A table with the columns temperature, time (t), and shear (g) or young (e), as in ``temperature [degC], time
        [s], shear [kPa]``; or a pattern such as ``"gel_*.csv"`` of several such tables.
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
    rows = [
        _moduli(file, (TEMPERATURE, TIME, SHEAR_MODULUS), (TEMPERATURE, TIME, YOUNG_MODULUS), poisson, header)
        for file in _files(path)
    ]
    with in_file(str(path)):
        temperature, time, shear = np.concatenate(rows).T
        return RelaxationSweeps(temperature, time, shear, poisson=poisson)


def _moduli(file: str, sheared: tuple[Column, ...], tensile: tuple[Column, ...], poisson: float, header: str) -> Array:
    """Return the rows of a table with moduli in shear."""
    head = [header] if header else None
    tension = names_columns(file, tensile, head=head) and not names_columns(file, sheared, head=head)
    values = np.array(moduli_table(file, tensile if tension else sheared, header).values)
    if tension:
        values[:, 2:] /= young_over_shear(poisson)
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
