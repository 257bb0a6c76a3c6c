"""Measured viscoelastic solids in tables: relaxation or creep over time, storage and loss over frequency.

Rheometers measure shear, tensile machines tension; Poisson's ratio converts one into the other, E = 2 (1 + nu) G.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from typing import TypeVar

import numpy as np

from winkler.io.foreign import in_file, reader
from winkler.io.tables.column import example_of
from winkler.io.tables.header import names_columns
from winkler.io.tables.table import Column, Table, read_table
from winkler.io.tables.tests_of_table import of_one_test
from winkler.materials.relaxation_data import CreepData, DynamicData, RelaxationData
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput

T = TypeVar("T", RelaxationData, CreepData, DynamicData)

TIME = Column("time", ("time", "t", "step time", "test time", "zeit", "temps", "时间", "時間"), "s", "s", "step time")
FREQUENCY = Column(
    "frequency", ("frequency", "f", "freq", "freq.", "frequenz", "fréquence", "frecuencia", "频率", "周波数"), "Hz"
)
FREQUENCY_IN_RADIANS = Column(FREQUENCY.word, FREQUENCY.names, "rad/s")
ANGULAR = Column(
    "angular frequency",
    (
        "angular_frequency", "angular frequency", "omega", "w", "ω", "ang. freq.", "ang. freq", "ang. frequency",
        "kreisfrequenz", "角频率", "角周波数",
    ),
    "rad/s",
)  # fmt: skip
SHEAR_MODULUS = Column(
    "shear modulus",
    ("shear", "g", "g(t)", "shear modulus", "shear_modulus", "relaxation", "relaxation modulus", "松弛模量"),
    "Pa",
    "kPa",
)  # fmt: skip
YOUNG_MODULUS = Column("Young's modulus", ("young", "e", "e(t)", "young's modulus", "tensile modulus"), "Pa", "kPa")
SHEAR_COMPLIANCE = Column(
    "shear compliance", ("compliance", "j", "j(t)", "shear compliance", "creep compliance"), "1/Pa"
)
TENSILE_COMPLIANCE = Column("tensile compliance", ("tensile_compliance", "d", "d(t)", "tensile compliance"), "1/Pa")
STRAIN = Column("shear strain", ("strain", "shear strain", "γ", "gamma", "scherdeformation"), "%", "%")
STRESS = Column("shear stress", ("stress", "shear stress", "τ", "tau", "schubspannung"), "Pa", "Pa")
SHEAR_STORAGE = Column(
    "storage modulus in shear",
    (
        "storage_shear",
        "storage",
        "g'",
        "gp",
        "g_stor",
        "g storage",
        "storage modulus",
        "speichermodul",
        "shear modulus (elastic component)",
        "module de conservation",
        "储能模量",
        "貯蔵弾性率",
    ),
    "Pa",
    "kPa",
)
SHEAR_LOSS = Column(
    "loss modulus in shear",
    (
        "loss_shear",
        "loss",
        "g''",
        'g"',
        "gpp",
        "g_loss",
        "g loss",
        "loss modulus",
        "verlustmodul",
        "shear modulus (viscous component)",
        "module de perte",
        "损耗模量",
        "損失弾性率",
    ),
    "Pa",
    "kPa",
)
TENSILE_STORAGE = Column(
    "storage modulus in tension",
    ("tensile_storage", "e'", "ep", "e_stor", "e storage", "tensile storage modulus"),
    "Pa",
    "MPa",
)
TENSILE_LOSS = Column(
    "loss modulus in tension", ("tensile_loss", "e''", 'e"', "epp", "e_loss", "tensile loss modulus"), "Pa", "MPa"
)
LOSS_FACTOR = Column(
    "loss factor",
    ("tan delta", "tan_delta", "tan(delta)", "tan δ", "tan(δ)", "tanδ", "tand", "loss factor", "损耗因子", "損失正接"),
    "",
)
SHEAR_COMPLEX = Column(
    "complex modulus in shear", ("g*", "|g*|", "complex modulus", "complex shear modulus"), "Pa", "kPa"
)
TENSILE_COMPLEX = Column("complex modulus in tension", ("e*", "|e*|", "complex tensile modulus"), "Pa", "MPa")
PHASE = Column("phase angle", ("delta", "δ", "phase", "phase angle"), "rad", "deg")


def _of_loss(size: Array, other: Array) -> tuple[Array, Array]:
    return size, other


def _of_factor(size: Array, other: Array) -> tuple[Array, Array]:
    return size, size * other


def _of_phase(size: Array, other: Array) -> tuple[Array, Array]:
    return size * np.cos(other), size * np.sin(other)


MODULI: tuple[tuple[Column, Column, bool, Callable[[Array, Array], tuple[Array, Array]]], ...] = (
    (SHEAR_STORAGE, SHEAR_LOSS, False, _of_loss),
    (TENSILE_STORAGE, TENSILE_LOSS, True, _of_loss),
    (SHEAR_STORAGE, LOSS_FACTOR, False, _of_factor),
    (TENSILE_STORAGE, LOSS_FACTOR, True, _of_factor),
    (SHEAR_COMPLEX, PHASE, False, _of_phase),
    (TENSILE_COMPLEX, PHASE, True, _of_phase),
)
"""Pairs of columns, whether they are of tension, and storage and loss from them."""
SAME_MODULUS = 0.2
"""Greatest difference of moduli at one time or frequency that are averaged, in parts of the greater,"""
NEAR, DEVIATIONS, MOST_APART = 10, 3.0, 0.5
"""or of so many standard deviations of a difference, by the scatter of as many rows before and behind that stand once,
and in parts of the greater at most."""
MOST_LEFT_OUT = 0.2
"""Greatest share of rows whose moduli are not positive, as noise makes small ones, and that are left out."""
NORMAL_MEDIAN = 0.6745
"""Median of the size of a normal deviation, over the standard one."""
HELD = 0.1
"""Greatest deviation of a stress or strain that is held, relative to its median."""
STRAINED = (TIME, STRAIN, STRESS)
HELD_STRESS = '; of a creep, where no column holds the stress, give held_stress = "10 Pa"'
RELAXATION_HEADERS = ((TIME, SHEAR_MODULUS), (TIME, YOUNG_MODULUS), STRAINED)
CREEP_HEADERS = ((TIME, SHEAR_COMPLIANCE), (TIME, TENSILE_COMPLIANCE), STRAINED)
DYNAMIC_HEADERS = tuple((frequency, *one[:2]) for frequency in (ANGULAR, FREQUENCY) for one in MODULI)


def dynamic_rows(
    path: str | os.PathLike[str], further: tuple[Column, ...], poisson: float, header: str = ""
) -> tuple[Table, Array]:
    """Return further columns, angular frequency [rad/s], storage and loss in shear [Pa] of a table.

    A frequency in radians over time is angular, whatever its name.  Storage and loss stand there, or storage and loss
    factor, or the complex modulus and the phase angle.

    Parameters
    ----------
    path : str or path
    further : tuple of Column
    poisson : float
        nu [-], for moduli in tension.
    header : str, optional
        The names of all columns, in place of those of the file.

    Raises
    ------
    InvalidInput
        If columns, units or numbers are missing.
    """
    head = [header] if header else None
    named = [one for one in MODULI if names_columns(path, one[:2], head=head)] or [MODULI[0]]
    frequency, (size, other, tensile, moduli) = next(
        (
            (frequency, one)
            for frequency in (ANGULAR, FREQUENCY)
            for one in named
            if names_columns(path, (*further, frequency, *one[:2]), head=head)
        ),
        (ANGULAR if names_columns(path, (*further, ANGULAR), head=head) else FREQUENCY, named[0]),
    )
    first = (*further, frequency)
    try:
        table = moduli_table(path, (*first, size, other), header)
    except InvalidInput as reason:
        try:  # instruments write a frequency in rad/s as well: the unit says which it is
            table = moduli_table(path, (*further, FREQUENCY_IN_RADIANS, size, other), header)
        except InvalidInput as other:
            in_radians = "is the unit of a quantity in rad/s, not of a frequency" in str(reason)
            raise (other if in_radians else reason) from None
        frequency = FREQUENCY_IN_RADIANS
    values, place = np.array(table.values), len(further)
    values[:, place] *= 2.0 * math.pi if frequency is FREQUENCY else 1.0
    storage, loss = moduli(values[:, -2], values[:, -1])
    divisor = young_over_shear(poisson) if tensile else 1.0
    return table, np.column_stack([values[:, : place + 1], storage / divisor, loss / divisor])


def positive_rows(table: Table, rows: Array) -> tuple[Array, str]:
    """Return the rows whose last two numbers are positive, and which lines were left out, as a phrase.

    Parameters
    ----------
    table : Table
        Where they stand.
    rows : ndarray, (n, m)
        The last two columns are storage and loss.
    """
    (off,) = np.nonzero(np.any(rows[:, -2:] <= 0.0, axis=1))
    if not 0 < off.size <= MOST_LEFT_OUT * rows.shape[0]:
        return rows, ""
    lines = ", ".join(str(int(line)) for line in table.lines[off[:5]]) + " ..." * (off.size > 5)
    which = f"{off.size} row{'s' * (off.size > 1)} (line {lines})"
    return np.delete(rows, off, axis=0), f"{which} left out, whose storage or loss is not positive"


def moduli_table(path: str | os.PathLike[str], columns: tuple[Column, ...], header: str) -> Table:
    """Return a table, with a stated header if there is one; a refusal of the file's own names that key.

    Raises
    ------
    InvalidInput
        If columns, units or numbers are missing.
    """
    try:
        return read_table(path, columns, stated=header)
    except InvalidInput as error:
        if header:
            raise
        example = example_of(columns)
        raise error.reworded(lambda one: f'{one.rstrip(".")}; or give header = "{example}".') from None


@reader("a relaxation")
def read_relaxation(
    path: str | os.PathLike[str], *, poisson: float = 0.5, header: str = "", test: int = 0
) -> RelaxationData:
    """Read a measured relaxation from a table with the columns time (t) and shear (g), or young (e).

    Parameters
    ----------
    path : str or path
        The file.  Its header contains units, as in ``time [s], shear [kPa]``; other columns are ignored.  In place of
        the modulus, a shear strain [% or -] that is held, within a tenth, and the shear stress.  A row at time zero is
        left out; rows of one time whose numbers agree within a fifth, or as rows around them scatter, are averaged,
        and the ``reading`` of the data says so.
    poisson : float, optional
        nu [-], above -1 and at most 0.5.
    header : str, optional
        The names and units of all columns, where the file has none: ``"time [s], shear [Pa]"``.
    test : int, optional
        Which of several tests in one table, counted from 1: side by side, below each other under headers that stand
        again, where the numbers of the points begin again, or in sheets of one workbook.

    Returns
    -------
    RelaxationData

    Raises
    ------
    InvalidInput
        If the file cannot be read, or it contains no relaxation test.
    """

    def read(part: str | os.PathLike[str]) -> RelaxationData:
        table, columns = _read(part, RELAXATION_HEADERS, header)
        if columns is STRAINED:
            time, strain, stress = table.values.T
            _refuse_unheld(table, strain, "strain", "relaxation")
            return _data(
                RelaxationData, table.path, (time, 100.0 * stress / strain), poisson, "shear = stress / strain"
            )
        time, modulus = table.values.T
        divisor = young_over_shear(poisson) if columns[1] is YOUNG_MODULUS else 1.0
        return _data(RelaxationData, table.path, (time, modulus / divisor), poisson)

    return of_one_test(path, RELAXATION_HEADERS, test, read, since=TIME) if test or not header else read(path)


@reader("a creep")
def read_creep(
    path: str | os.PathLike[str], *, poisson: float = 0.5, header: str = "", test: int = 0, held_stress: float = 0.0
) -> CreepData:
    """Read a measured creep from a table with the columns time (t) and compliance (j), or tensile_compliance (d).

    Parameters
    ----------
    path : str or path
        The file.  Its header contains units, as in ``time [s], compliance [1/kPa]``; other columns are ignored.  In
        place of the compliance, a shear strain [% or -] and the shear stress that is held, within a tenth.  A row at
        time zero is left out; rows of one time whose numbers agree within a fifth, or as rows around them scatter, are
        averaged, and the ``reading`` of the data says so.
    poisson : float, optional
        nu [-], above -1 and at most 0.5.
    header : str, optional
        The names and units of all columns, where the file has none: ``"time [s], compliance [1/Pa]"``.
    test : int, optional
        Which of several tests in one table, counted from 1: side by side, below each other under headers that stand
        again, where the numbers of the points begin again, or in sheets of one workbook.
    held_stress : float, optional
        Shear stress that is held [Pa], where a column holds the shear strain and none the stress.

    Returns
    -------
    CreepData

    Raises
    ------
    InvalidInput
        If the file cannot be read, or it contains no creep test.
    """

    def read(part: str | os.PathLike[str]) -> CreepData:
        if held_stress:
            if not 0.0 < held_stress < math.inf:
                raise InvalidInput(f"{part}: the stress of its creep is {held_stress:g} Pa; give a positive one.")
            time, strain = moduli_table(part, STRAINED[:2], header).values.T
            reading = f"compliance = strain / {held_stress:g} Pa, given"
            return _data(CreepData, str(part), (time, strain / (100.0 * held_stress)), poisson, reading)
        table, columns = _read(part, CREEP_HEADERS, header)
        if columns is STRAINED:
            time, strain, held = table.values.T
            _refuse_unheld(table, held, "stress", "creep")
            return _data(
                CreepData, table.path, (time, strain / (100.0 * held)), poisson, "compliance = strain / stress"
            )
        time, compliance = table.values.T
        factor = young_over_shear(poisson) if columns[1] is TENSILE_COMPLIANCE else 1.0
        return _data(CreepData, table.path, (time, compliance * factor), poisson)

    return of_one_test(path, CREEP_HEADERS, test, read, since=TIME) if test or not header else read(path)


@reader("storage and loss")
def read_dynamic(path: str | os.PathLike[str], *, poisson: float = 0.5, header: str = "", test: int = 0) -> DynamicData:
    """Read measured storage and loss from a table over frequency (f) or angular_frequency (omega).

    Parameters
    ----------
    path : str or path
        The file.  Its header contains units, as in ``frequency [Hz], storage [kPa], loss [kPa]`` of shear (g', g''),
        or ``tensile_storage [MPa], tensile_loss [MPa]`` (e', e'') of tension; other columns are ignored.  In place of
        the loss, ``tan delta`` is read, and the complex modulus (g*, e*) with the phase angle (delta).  Rows of one
        frequency whose moduli agree within a fifth are averaged, up to a fifth of the rows whose storage or loss is
        not positive are left out, and the ``reading`` of the data says so.
    poisson : float, optional
        nu [-], above -1 and at most 0.5.
    header : str, optional
        The names and units of all columns, where the file has none: ``"omega [rad/s], g' [Pa], g'' [Pa]"``.
    test : int, optional
        Which of several tests in one table, counted from 1: side by side, below each other under headers that stand
        again, where the numbers of the points begin again, or in sheets of one workbook.

    Returns
    -------
    DynamicData

    Raises
    ------
    InvalidInput
        If the file cannot be read, or it contains no storage and loss moduli.
    """

    def read(part: str | os.PathLike[str]) -> DynamicData:
        rows, reading = positive_rows(*dynamic_rows(part, (), poisson, header))
        return _data(DynamicData, str(part), tuple(rows.T), poisson, reading)

    return of_one_test(path, DYNAMIC_HEADERS, test, read) if test or not header else read(path)


def _read(
    path: str | os.PathLike[str], headers: tuple[tuple[Column, ...], ...], header: str
) -> tuple[Table, tuple[Column, ...]]:
    """Return the table by the first columns that it has: of shear, of tension, or strain and stress; and these."""
    head = [header] if header else None
    columns = next((one for one in headers if names_columns(path, one, head=head)), headers[0])
    try:
        return moduli_table(path, columns, header), columns
    except InvalidInput as error:
        if (columns is not STRAINED and columns is not headers[0]) or not names_columns(path, STRAINED[:2], head=head):
            raise
        raise error.reworded(lambda one: f"{one.rstrip('.')}{HELD_STRESS}.") from None


def _refuse_unheld(table: Table, held: Array, what: str, test: str) -> None:
    """Refuse a test in which what must be one number is none, as in a ramp, a recovery, or a test until fracture."""
    usual = float(np.median(held))
    if not np.all(np.abs(held - usual) <= HELD * abs(usual)) or usual == 0.0:
        raise InvalidInput(
            f"{table.path}: a {test} has one {what}, and here it goes from {held.min():.4g} to {held.max():.4g} "
            f"{'Pa' if what == 'stress' else '%'}; leave out the rows in which it is not held."
        )


def young_over_shear(poisson: float) -> float:
    """Return Young's modulus over the shear modulus."""
    if not -1.0 < poisson <= 0.5:
        raise InvalidInput(f"poisson is {poisson!r}; a Poisson ratio is above -1 and at most 0.5.")
    return 2.0 * (1.0 + poisson)


def _data(kind: Callable[..., T], path: str, rows: tuple[np.ndarray, ...], poisson: float, reading: str = "") -> T:
    """Return the data of rows in the order of their times or frequencies; those that stand twice are averaged."""
    order = np.argsort(rows[0], kind="stable")  # dynamic tests are often swept downwards
    sorted_rows = np.array([row[order] for row in rows])
    if kind is not DynamicData and sorted_rows[0, 0] == 0.0:  # at the step itself
        sorted_rows = sorted_rows[:, 1:]
    begins = np.flatnonzero(np.diff(sorted_rows[0], prepend=-np.inf))
    if 0 < begins.size < sorted_rows.shape[1]:
        moduli = sorted_rows[1:]
        highest, lowest = (of_each.reduceat(moduli, begins, axis=1) for of_each in (np.maximum, np.minimum))
        counts = np.diff(begins, append=sorted_rows.shape[1])
        means = np.add.reduceat(moduli, begins, axis=1) / counts
        scatter = DEVIATIONS * math.sqrt(2.0) * _scatter(np.where(counts == 1, means, math.nan))
        alike = np.maximum(SAME_MODULUS, np.minimum(1.0 - np.exp(-scatter), MOST_APART))
        apart = highest - lowest
        if np.all(apart <= alike * np.abs(highest)):
            again, size = int(np.count_nonzero(counts > 1)), "frequencies" if kind is DynamicData else "times"
            averaged = f"{counts[counts > 1].sum()} rows at {again} {size} are averaged"
            if np.any(apart > SAME_MODULUS * np.abs(highest)):
                averaged += f", up to {np.max(apart / np.abs(highest)):.0%} apart, as the rows around them scatter"
            reading = f"{reading}; {averaged}" if reading else averaged
            sorted_rows = np.vstack([sorted_rows[0, begins], means])
    with in_file(path):
        return kind(*sorted_rows, poisson=poisson, reading=reading)


def _scatter(numbers: Array) -> Array:
    """Return the standard deviation of the logarithms of numbers nearby ``(m, n)``, zero where none is known.

    Their distances from the line between both neighbours have 3/2 of their variance; the median of these is taken.
    """
    if numbers.shape[1] < 3 or np.any(numbers <= 0.0):
        return np.zeros(numbers.shape)
    sizes = np.abs(np.diff(np.log(numbers), 2, axis=1)) / 2.0
    bends = np.pad(sizes, ((0, 0), (NEAR + 1, NEAR + 1)), constant_values=math.nan)
    windows = np.lib.stride_tricks.sliding_window_view(bends, 2 * NEAR + 1, axis=1)
    known = np.any(np.isfinite(windows), axis=-1)
    middle = np.zeros(numbers.shape)
    middle[known] = np.nanmedian(windows[known], axis=-1)
    return middle / (NORMAL_MEDIAN * math.sqrt(1.5))
