"""Measured viscoelastic solids in tables: relaxation or creep over time, storage and loss over frequency.

Rheometers measure shear, tensile machines tension; Poisson's ratio converts one into the other, E = 2 (1 + nu) G.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from typing import TypeVar

import numpy as np

from winkler.errors import InvalidInput
from winkler.io.foreign import in_file, reader
from winkler.io.tables.header import names_columns
from winkler.io.tables.table import Column, Table, read_table
from winkler.materials.relaxation_data import CreepData, DynamicData, RelaxationData

__all__ = ["read_creep", "read_dynamic", "read_relaxation"]

T = TypeVar("T", RelaxationData, CreepData, DynamicData)

TIME = Column("time", ("time", "t"), "s", "s")
FREQUENCY = Column("frequency", ("frequency", "f"), "Hz")
ANGULAR = Column("angular frequency", ("angular_frequency", "angular frequency", "omega"), "rad/s")
SHEAR_MODULUS = Column(
    "shear modulus", ("shear", "g", "g(t)", "shear modulus", "shear_modulus", "relaxation"), "Pa", "kPa"
)
YOUNG_MODULUS = Column("Young's modulus", ("young", "e", "e(t)", "young's modulus", "tensile modulus"), "Pa", "kPa")
SHEAR_COMPLIANCE = Column("shear compliance", ("compliance", "j", "j(t)", "shear compliance"), "1/Pa")
TENSILE_COMPLIANCE = Column("tensile compliance", ("tensile_compliance", "d", "d(t)", "tensile compliance"), "1/Pa")
SHEAR_STORAGE = Column("storage modulus in shear", ("storage_shear", "storage", "g'", "storage modulus"), "Pa", "kPa")
SHEAR_LOSS = Column("loss modulus in shear", ("loss_shear", "loss", "g''", 'g"', "loss modulus"), "Pa", "kPa")
TENSILE_STORAGE = Column(
    "storage modulus in tension", ("tensile_storage", "e'", "tensile storage modulus"), "Pa", "MPa"
)
TENSILE_LOSS = Column("loss modulus in tension", ("tensile_loss", "e''", 'e"', "tensile loss modulus"), "Pa", "MPa")


@reader("a relaxation")
def read_relaxation(path: str | os.PathLike[str], *, poisson: float = 0.5) -> RelaxationData:
    """Read a measured relaxation from a table with the columns time (t) and shear (g), or young (e).

    Parameters
    ----------
    path : str or path
        The file.  Units stand in its header, as in ``time [s], shear [kPa]``; other columns are ignored.
    poisson : float, optional
        nu [-], above -1 and at most 0.5.

    Returns
    -------
    RelaxationData

    Raises
    ------
    InvalidInput
        If the file cannot be read, or what it holds is no relaxation.
    """
    table, tensile = _read(path, (TIME, SHEAR_MODULUS), (TIME, YOUNG_MODULUS))
    time, modulus = table.values.T
    return _data(RelaxationData, table, (time, modulus / (young_over_shear(poisson) if tensile else 1.0)), poisson)


@reader("a creep")
def read_creep(path: str | os.PathLike[str], *, poisson: float = 0.5) -> CreepData:
    """Read a measured creep from a table with the columns time (t) and compliance (j), or tensile_compliance (d).

    Parameters
    ----------
    path : str or path
        The file.  Units stand in its header, as in ``time [s], compliance [1/kPa]``; other columns are ignored.
    poisson : float, optional
        nu [-], above -1 and at most 0.5.

    Returns
    -------
    CreepData

    Raises
    ------
    InvalidInput
        If the file cannot be read, or what it holds is no creep.
    """
    table, tensile = _read(path, (TIME, SHEAR_COMPLIANCE), (TIME, TENSILE_COMPLIANCE))
    time, compliance = table.values.T
    return _data(CreepData, table, (time, compliance * (young_over_shear(poisson) if tensile else 1.0)), poisson)


@reader("storage and loss")
def read_dynamic(path: str | os.PathLike[str], *, poisson: float = 0.5) -> DynamicData:
    """Read measured storage and loss from a table over frequency (f) or angular_frequency (omega).

    Parameters
    ----------
    path : str or path
        The file.  Units stand in its header, as in ``frequency [Hz], storage [kPa], loss [kPa]`` of shear (g', g''), or
        ``tensile_storage [MPa], tensile_loss [MPa]`` (e', e'') of tension; other columns are ignored.
    poisson : float, optional
        nu [-], above -1 and at most 0.5.

    Returns
    -------
    DynamicData

    Raises
    ------
    InvalidInput
        If the file cannot be read, or what it holds is no storage and loss.
    """
    abscissa = ANGULAR if names_columns(path, (ANGULAR,)) else FREQUENCY
    table, tensile = _read(path, (abscissa, SHEAR_STORAGE, SHEAR_LOSS), (abscissa, TENSILE_STORAGE, TENSILE_LOSS))
    frequency, storage, loss = table.values.T
    angular = 2.0 * math.pi * frequency if abscissa is FREQUENCY else frequency
    divisor = young_over_shear(poisson) if tensile else 1.0
    return _data(DynamicData, table, (angular, storage / divisor, loss / divisor), poisson)


def _read(path: str | os.PathLike[str], sheared: tuple[Column, ...], tensile: tuple[Column, ...]) -> tuple[Table, bool]:
    """Return the columns of shear or, where the table has those alone, of tension; and whether it was tension."""
    tension = names_columns(path, tensile) and not names_columns(path, sheared)
    return read_table(path, tensile if tension else sheared), tension


def young_over_shear(poisson: float) -> float:
    """Return Young's modulus over the shear modulus."""
    if not -1.0 < poisson <= 0.5:
        raise InvalidInput(f"poisson is {poisson!r}; a Poisson ratio is above -1 and at most 0.5.")
    return 2.0 * (1.0 + poisson)


def _data(kind: Callable[..., T], table: Table, rows: tuple[np.ndarray, ...], poisson: float) -> T:
    order = np.argsort(rows[0], kind="stable")  # dynamic tests are often swept downwards
    with in_file(table.path):
        return kind(*(row[order] for row in rows), poisson=poisson)
