"""What a table does not state: ``units = { position = "nm", force = "uN" }``, ``columns = { depth = 1, force = 2 }``.

A given unit fills a column without one.  One that contradicts the file is refused.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from winkler.io.tables.column import Column, example_of
from winkler.values.errors import InvalidInput, suggest
from winkler.values.units import scale

USUAL = {"position": "nm", "force": "uN", "time": "s", "deflection": "nm", "stiffness": "N/m"}
"""The quantities whose unit can be given, each with a customary unit."""
KINDS = {"position": ("m",), "force": ("N",), "time": ("s",), "deflection": ("m", "V"), "stiffness": ("N/m",)}
PLACES = ("position", "depth", "gap")
LOADS = ("force", "deflection")
NUMBERED = (*PLACES, *LOADS, "time", "stiffness", "segment")
"""The columns that can be given by their number."""
LACKS_UNIT = "no unit stands with"
EXAMPLE = 'units = { position = "nm", force = "uN", time = "s" }'


class GivenFacts(NamedTuple):
    """Facts that a caller gives.

    Parameters
    ----------
    spring_constant : float, optional
        Of the cantilever [N/m]; replaces that of the file.
    sensitivity : float, optional
        Deflection per volt [m/V].
    units : mapping
        Of columns without one; see `checked_units`.
    columns : mapping
        Numbers of columns, counted from 1, by the word of the quantity; names are not looked at then.
    rigid : bool
        Whether a position is the travel of the tip where neither file nor caller states a spring, as in nanoindenters.
    """

    spring_constant: float | None = None
    sensitivity: float | None = None
    units: Mapping[str, str] = {}
    columns: Mapping[str, int] = {}
    rigid: bool = False


def key_of(word: str) -> str:
    """Return the key under which the unit of a column is given: a depth and a gap count as a position."""
    return "position" if word in PLACES else word


def checked_units(raw: Any, what: str = "units") -> dict[str, str]:
    """Return given units, checked.

    Parameters
    ----------
    raw
        Quantity -> unit, as a mapping or pairs of texts.
    what : str, optional
        How it is named in messages.

    Raises
    ------
    InvalidInput
        If it is no mapping of texts, a quantity is unknown, or a unit does not measure it.
    """
    if not isinstance(raw, Mapping) or not all(isinstance(part, str) for pair in raw.items() for part in pair):
        raise InvalidInput(f"{what} is {raw!r}; give the unit of each quantity, as in {EXAMPLE}.")
    for word, unit in raw.items():
        quantity = key_of(word)
        if quantity not in KINDS:
            hint = suggest(word, list(KINDS))
            raise InvalidInput(f"{what}: '{word}' is not known{hint}; there are {', '.join(KINDS)}.")
        reasons = []
        for kind in KINDS[quantity]:
            try:
                scale(unit, kind, what=f"{what}, {quantity}")
            except InvalidInput as error:
                reasons.append(str(error))
        if len(reasons) == len(KINDS[quantity]):
            raise InvalidInput(reasons[0])
    return {key_of(word): unit for word, unit in raw.items()}


def checked_columns(raw: Any, what: str = "columns") -> dict[str, int]:
    """Return given numbers of columns, checked.

    Parameters
    ----------
    raw
        Quantity -> number of its column, counted from 1.
    what : str, optional
        How it is named in messages.

    Raises
    ------
    InvalidInput
        If it is no such mapping, a quantity is unknown, two have one number, or a place or a load is missing.
    """
    example = "columns = { depth = 1, force = 2 }"
    if not isinstance(raw, Mapping) or not all(
        isinstance(word, str) and isinstance(number, int) and not isinstance(number, bool) and number > 0
        for word, number in raw.items()
    ):
        raise InvalidInput(f"{what} is {raw!r}; give the number of each column, counted from 1, as in {example}.")
    for word in raw:
        if word not in NUMBERED:
            hint = suggest(word, list(NUMBERED))
            raise InvalidInput(f"{what}: '{word}' is not known{hint}; there are {', '.join(NUMBERED)}.")
    twice = len(set(raw.values())) < len(raw)
    if raw and (twice or any(len(set(needed) & set(raw)) != 1 for needed in (PLACES, LOADS))):
        raise InvalidInput(
            f"{what} is {dict(raw)!r}; give one of {', '.join(PLACES)} and one of {', '.join(LOADS)}, each a column of "
            f"its own, as in {example}."
        )
    return dict(raw)


def filled_units(
    stated: Sequence[str],
    cells: Sequence[str],
    places: Sequence[int],
    columns: Sequence[Column],
    given: Mapping[str, str] | None,
    where: str,
) -> tuple[str, ...]:
    """Return the units of columns, those that the header lacks as given.

    Raises
    ------
    InvalidInput
        If one is neither stated nor given: one sentence that names the columns and the key.
    """
    units, lacking, keys = [], [], []
    for unit, place, column in zip(stated, places, columns, strict=True):
        key = key_of(column.word)
        units.append(unit or ((given or {}).get(key, "") if column.unit else ""))
        if column.unit and not units[-1]:
            lacking.append(cells[place])
            keys.append(key)
    if not lacking:
        return tuple(units)
    example = f"write it in the header, as '{example_of(columns)}'"
    if given is None:
        raise InvalidInput(f"{where}: {LACKS_UNIT} {_listed(lacking)}; {example}.")
    raise InvalidInput(f"{unit_asked(where, lacking, keys)}, or {example}.")


def unit_asked(where: str, names: Sequence[str], keys: Sequence[str]) -> str:
    """Return the sentence, without its end, that columns have no unit, and the key by which it is given."""
    pairs = ", ".join(f'{key} = "{USUAL[key]}"' for key in dict.fromkeys(keys) if key in USUAL)
    return f"{where}: {LACKS_UNIT} {_listed(names)}; give it as units = {{ {pairs} }}"


def _listed(names: Sequence[str]) -> str:
    return " and ".join(f"'{name}'" for name in names)


def refuse_contradiction(column: Column, stated: str, given: Mapping[str, str] | None, where: str) -> None:
    """Refuse a given unit that differs from the one in the file.

    Raises
    ------
    InvalidInput
    """
    key = key_of(column.word)
    if not given or key not in given or not column.unit:
        return
    try:
        same = scale(given[key], column.unit) == scale(stated, column.unit)
    except InvalidInput:  # a deflection in volts, asked for as a length
        same = False
    if not same:
        raise InvalidInput(
            f"{where}: the file states '{stated}' for the {column.word}, and units gives {key} = '{given[key]}'; leave "
            f"{key} out of units, or correct the file."
        )
