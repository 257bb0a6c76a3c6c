"""The cells of a table: where a line is cut, what a number is, and how a name stands with its unit in a header.

Each function takes a time proportional to the length of the line, whatever it contains.
"""

from __future__ import annotations

import functools
import re
from collections.abc import Callable, Iterator

from winkler.values.errors import InvalidInput
from winkler.values.limits import CELL_LETTERS
from winkler.values.units import comma_hint, comma_readings, scale

ABSENT = frozenset({"", "nan", "na", "n/a", "-", "--", "none", "null", "inf", "-inf", "+inf", "infinity", "-infinity"})
NAME_WITH_UNIT = re.compile(r"[^\s\[(]++(?:\s*+[\[(][^\])]{0,100}+[\])])?+")
"""A name with a unit in brackets behind it, or a word."""


MEAN = re.compile(r"\A(?:mean|average|avg) | (?:mean|average|avg)\Z")
DEVIATION = re.compile(
    r"(?<![^\W_])(?:std|sd|sem|stdev|stddev|std\.? ?dev\.?|standard deviation|stdabw\.?)(?![^\W_])", re.IGNORECASE
)


SMALL_UNITS = {"hz": "Hz", "khz": "kHz", "pa": "Pa", "kpa": "kPa", "gpa": "GPa", "rad_s": "rad/s"}
"""Units as names of programs have them, in small letters: ``freq_hz``; mpa may be mPa and MPa, and is none."""
PREFIXES = {"nano": "n", "micro": "u", "milli": "m", "kilo": "k", "mega": "M", "giga": "G"}
"""Words before a unit in such names: ``load_micro_N``."""
BEHIND_WORDS = ("in", "en")
"""Words before a unit, as in ``f in Hz``."""
LONGEST_MISSPELT = 4
"""A word of so many letters that is no unit is a noun: units that users misspell are shorter."""
DEVICE = re.compile(r"(?:[^\W\d]\w++\.|[^\W\d]_\d{1,2}_)(?=[^\W\d]{2})")
"""A device before the name of its channel, as in "DAQ.Fx (N)" or "C_1_Force[kN]"."""
QUOTED, HIDDEN = re.compile(r'"[+-]?\d[\d,;.]{0,40}"'), "\x00"
"""A number in quotes, and what stands for a separator in it."""
SYMBOL = re.compile(r"\s*+[(\[][A-Za-z][)\]]\Z")
"""A symbol in brackets behind a name, as in "Position (z), mm"."""


def cells_of(line: str, separator: str | None) -> list[str]:
    """Return the cells of a line; without a separator those between spaces."""
    if separator is not None:
        return [_unquoted(cell.strip(" \t")) for cell in _cut(line, separator)]
    # a unit in brackets belongs to the name before it
    return NAME_WITH_UNIT.findall(line) if "[" in line or "(" in line else line.split()


def _cut(line: str, separator: str) -> list[str]:
    """Return a line cut at its separators; one between digits in quotes, as in "1,900", groups thousands."""
    if '"' not in line:
        return line.split(separator)
    return [cell.replace(HIDDEN, separator) for cell in QUOTED.sub(_hide(separator), line).split(separator)]


def _hide(separator: str) -> Callable[[re.Match[str]], str]:
    return lambda quoted: quoted[0].replace(separator, HIDDEN)


def _unquoted(cell: str) -> str:
    """Return a cell without the quotes around it; primes that end a name, as in ``G'`` and ``G''``, stay."""
    mark = cell[:1]
    if mark not in ("'", '"') or len(cell) < 2 or cell[-1] != mark:
        return cell
    inner = cell[1:-1]
    return (inner.replace('""', '"') if mark == '"' else inner).strip(" \t")


def is_number(cell: str) -> bool:
    """Return whether a cell is a number, perhaps an infinite one or none."""
    try:
        float(cell)
    except ValueError:
        return False
    return "_" not in cell


def like_number(cell: str) -> bool:
    """Return whether a cell is a number, also one with a comma."""
    return is_number(cell) or any(map(is_number, comma_readings(cell)))


def number_in(cell: str, where: str, wrong: str) -> float:
    """Return the number of a cell, nan where it is marked as missing.

    Parameters
    ----------
    cell : str
    where : str
        File and line.
    wrong : str
        What to say about a cell that is no number, behind its text.

    Raises
    ------
    InvalidInput
        If it is no number.
    """
    if is_number(cell):
        return float(cell)
    if cell.lower() in ABSENT:
        return float("nan")
    if like_number(cell):
        raise InvalidInput(f"{where}: '{cell}' has {comma_hint(cell)}.")
    raise InvalidInput(f"{where}: '{cell[:40]}' {wrong}.")


def named(cell: str, names: tuple[str, ...]) -> tuple[bool, str]:
    """Return whether a cell of the header has one of the names, and the unit behind it if there is one.

    A mean has the name of its quantity, as in ``F_avg (N)``; the standard deviation beside it has none.
    """
    known = _plain_names(names)
    return next(((True, unit) for name, unit in _plain_readings(cell) if name in known), (False, ""))


@functools.lru_cache(maxsize=4096)
def _plain_readings(cell: str) -> tuple[tuple[str, str], ...]:
    """Return how a cell may be name and unit, names as `_plain` has them; one header is asked for many quantities."""
    if len(cell) > CELL_LETTERS or DEVIATION.search(cell):
        return ()
    # the whole cell first, before "Storage N" is a storage in newton
    whole = ((_plain(cell), ""), *((_plain(name), unit.strip(" -")) for name, unit in _readings(cell)))
    device = DEVICE.match(cell)
    return (*whole, *_plain_readings(cell[device.end() :])) if device else whole


@functools.lru_cache(maxsize=256)
def _plain_names(names: tuple[str, ...]) -> frozenset[str]:
    return frozenset(map(_plain, names))


def _plain(name: str) -> str:
    """Return a name in small letters, with spaces for ``-`` and ``_``, and without what says that it is a mean."""
    return MEAN.sub("", name.lower().replace("-", " ").replace("_", " "))


def _joined(cell: str) -> Iterator[tuple[str, str]]:
    """Yield how a cell may be a name and a unit that are joined by low lines."""
    *name, unit = cell.rsplit("_", 1)
    if not name or not name[0] or not unit or " " in unit:
        return
    *more, before = name[0].rsplit("_", 1)
    if more and more[0]:
        *most, first = more[0].rsplit("_", 1)
        if before.lower() == "per" and most and most[0]:
            yield most[0], f"{first}/{unit}"
        joined = f"{before}_{unit}".lower()
        if joined in SMALL_UNITS:
            yield more[0], SMALL_UNITS[joined]
        if before.lower() in PREFIXES:
            yield more[0], PREFIXES[before.lower()] + unit
    yield name[0], SMALL_UNITS.get(unit, unit)


def unit_in(cell: str, wanted: str) -> str:
    """Return the unit behind the name in a cell of the header that measures the same as another; empty if none does."""
    for _, unit in _readings(cell) if len(cell) <= CELL_LETTERS else ():
        try:
            scale(unit.strip(" -"), wanted)
        except InvalidInput:
            continue
        return unit.strip(" -")
    return ""


def _readings(cell: str) -> Iterator[tuple[str, str]]:
    """Yield how a cell may be name and unit: ``r [um]``, ``r, um``, ``r/um``, ``r in um``, ``r_um``, ``r um``.

    Names of programs join both by low lines: ``f_hz``, ``load_micro_N``, ``k_N_per_m``, ``omega_rad_s``.
    """
    name, _, unit = cell.rpartition(", ")
    if name and unit:
        yield SYMBOL.sub("", name.rstrip()), unit
    if cell[-1:] in ("]", ")"):
        closed = max(cell.rfind("]", 1, -1), cell.rfind(")", 1, -1))
        opened = min((place for mark in "[(" if (place := cell.find(mark, max(closed, 0) + 1)) > 0), default=0)
        if opened:
            yield cell[:opened].rstrip(), cell[opened + 1 : -1]
    name, _, unit = cell.partition("/")
    if name and unit:
        yield name.rstrip(), unit.lstrip()
    words = cell.rsplit(None, 2)
    if len(words) == 3 and words[1] in BEHIND_WORDS:
        yield words[0], words[2]
    yield from _joined(cell)
    words = cell.split(None, 2)
    if len(words) == 2 and not _is_noun(words[1]):
        yield words[0], words[1]


def _is_noun(word: str) -> bool:
    """Return whether a second word names a quantity, as in "Shear Stress", and is no unit, not even a misspelt one."""
    if len(word) < LONGEST_MISSPELT or not word.isalpha():
        return False
    try:
        scale(word, word)
    except InvalidInput:
        return True
    return False
