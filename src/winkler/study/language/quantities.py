"""Numbers of a study file: quantities, lists, ranges, rows, and tables of named constants.

Each function takes the TOML value of one key and returns SI numbers, or raises one sentence in which `WHERE` stands
for the key.
"""

from __future__ import annotations

import dataclasses
import math
import re
from collections.abc import Callable
from typing import Any, NoReturn

import numpy as np
from pydantic import BaseModel
from pydantic_core import PydanticCustomError

from winkler.numerics.types import Array
from winkler.profiles.area_coefficients import coefficient_unit
from winkler.values.checks.field_checks import numbers_taken
from winkler.values.errors import InvalidInput, WinklerError, suggest
from winkler.values.units import is_fixed, quantity, to_si
from winkler.values.vocabulary import word

WHERE = "\x00"
"""Stands for the path of the key in a sentence."""

SAMPLE_QUANTITIES = {
    "m": "10 mm",
    "Pa": "210 GPa",
    "N": "10 N",
    "rad": "70.3 deg",
    "N/m": "1 kN/m",
    "1/m": "1 1/mm",
    "J": "1 uJ",
    "J/m^2": "50 mJ/m^2",
}
"""Sample quantity of each unit, for hints and examples."""
SAMPLES_BY_NAME = {"strength": "700 MPa", "bulk_stress": "100 MPa"}
"""Those of fields for which that of the unit is no usual one."""

RANGE_KEYS = ("from", "to", "count", "spacing")


INDEXED: dict[tuple[str, str], Callable[[int], str]] = {
    ("AreaFunction", "coefficients"): coefficient_unit,
    ("CalibratedTip", "coefficients"): coefficient_unit,
}
"""Fields whose entries each have their own unit, by their place in the list."""


GRIDS: frozenset[tuple[str, str]] = frozenset({("Designed", "slopes")})
"""Fields that are tables of plain numbers, row by row."""


INFINITE = "infinite"


def wrong(sentence: str, *key: str) -> NoReturn:
    """Raise `sentence` about the value of the key, or about a `key` inside it."""
    raise PydanticCustomError("winkler", "{sentence}", {"sentence": sentence, "key": key})


def sentence_of(refusal: PydanticCustomError) -> str:
    """Return the sentence of a refusal that `wrong` has raised."""
    return str((refusal.context or {})["sentence"])


def read_at(where: str, raw: Any, unit: str | None, read: Callable[[Any, str | None], Any] | None = None) -> Any:
    """Return what `read`, by default `number_or_numbers`, makes of the value at a key.

    Raises
    ------
    InvalidInput
        If it is refused, with the key `where` in the sentence.
    """
    try:
        return (read or number_or_numbers)(raw, unit)
    except PydanticCustomError as refusal:
        raise InvalidInput(sentence_of(refusal).replace(WHERE, where)) from None


def sample(unit: str, name: str = "") -> str:
    """Return a sample quantity of `unit`, for a field of this name."""
    return SAMPLES_BY_NAME.get(name) or SAMPLE_QUANTITIES.get(unit, f"1 {unit}" if unit else "0.3")


def unit_of(owner: type, field: str) -> str | None:
    """Return the unit of a field from the glossary; None if it is no quantity."""
    return word(owner, field).unit


def endless(owner: type, field: str) -> bool:
    """Return whether a number may be infinite, from its type."""
    number = numbers_taken(owner, field)
    return number is not None and number.admits(math.inf)


def dependent(owner: type) -> tuple[str, ...]:
    """Return the fields of `owner` whose unit depends on another field, such as the coefficient of c r^n."""
    units = {field.name: unit_of(owner, field.name) for field in dataclasses.fields(owner)}
    return tuple(name for name, unit in units.items() if unit is not None and not is_fixed(unit))


def settled(unit: str, owner: type, content: dict[str, Any]) -> str:
    """Return a unit such as ``m^(1-n)`` with the fields of `owner` that it names put in: ``m^-1``."""
    symbols = {word(owner, item.name).symbol: item.name for item in dataclasses.fields(owner)}

    def power(match: re.Match[str]) -> str:
        exponent = float(match[1]) + (-1.0 if match[2] == "-" else 1.0) * float(content[symbols[match[3]]])
        return f"^{exponent:.12g}"

    result = re.sub(r"\^\(([\d.]+)([-+])([A-Za-z]+)\)", power, unit)
    return re.sub(r"\^1(?![\d.])", "", "" if result.endswith("^0") else result)


def unit_in(owner: Any, field: str) -> str | None:
    """Return the unit of a field of a value, with the other fields put in that it depends on; None if it has none."""
    cls = type(owner)
    unit = unit_of(cls, field)
    if unit is None or field not in dependent(cls):
        return unit
    return settled(unit, cls, {item.name: getattr(owner, item.name) for item in dataclasses.fields(owner)})


def settle(form: BaseModel, *, cls: type, keys: tuple[str, ...]) -> BaseModel:
    """Convert the `keys` of `form` whose unit depends on the others."""
    for key in keys:
        unit = unit_of(cls, key) or ""
        try:
            setattr(form, key, number(getattr(form, key), settled(unit, cls, dict(form))))
        except PydanticCustomError as refusal:
            sentence = sentence_of(refusal)
            unnamed = f"{WHERE} has a unit that follows from other keys, and {sentence}; check them."
            wrong(sentence if WHERE in sentence else unnamed, key)
    return form


def number(raw: Any, unit: str | None) -> Any:
    """Return one quantity in SI units.  A unit that depends on other keys is left for `settle`."""
    if isinstance(raw, np.ndarray | list | dict):
        what = "a list" if isinstance(raw, list) else "a table"
        wrong(f'{WHERE} is {what}; give one quantity, such as "{sample(unit or "")}".')
    if unit is not None and not is_fixed(unit):
        return raw
    if isinstance(raw, bool) or not isinstance(raw, str | int | float):
        what = f'a quantity, such as "{sample(unit)}"' if unit else "a number, such as 0.3"
        wrong(f"{WHERE} is {str(raw).lower()}; give {what}.")
    if isinstance(raw, float) and not math.isfinite(raw):
        wrong(f"{WHERE} is {raw!r}; give a finite number.")
    try:
        return quantity(raw, unit or "", what=WHERE)
    except WinklerError as error:
        wrong(str(error))


def numbers(raw: Any, unit: str | None) -> Array:
    """Return a list of quantities in SI units, from a list, a range, or plain numbers with one unit."""
    if isinstance(raw, dict) and "values" in raw:
        return _with_one_unit(raw, unit)
    if isinstance(raw, dict):
        return _range(raw, unit)
    if not isinstance(raw, list):
        one = sample(unit or "")
        wrong(f'{WHERE} is {raw!r}; give a list, such as ["{one}"], or a range {{ from, to, count }}.')
    if not raw:
        wrong(f"{WHERE} is an empty list; give at least one quantity.")
    return np.concatenate([_entry(item, unit, f"[{place}]") for place, item in enumerate(raw)])


def _entry(raw: Any, unit: str | None, below: str) -> Array:
    """Return one entry of a list, a quantity or a range of them."""
    if not isinstance(raw, dict):
        return np.array([inside(raw, unit, below)])
    try:
        return _range(raw, unit)
    except PydanticCustomError as refusal:
        wrong(sentence_of(refusal).replace(WHERE, WHERE + below))


def number_or_infinite(raw: Any, unit: str | None) -> Any:
    """Return one quantity in SI units, or infinity for the word ``infinite``."""
    if raw == INFINITE:
        return float("inf")
    if str(raw).strip().lower().startswith(("inf", "∞")):
        wrong(f'{WHERE} is {raw!r}; write "{INFINITE}", or a quantity, such as "{sample(unit or "")}".')
    return number(raw, unit)


def number_or_numbers(raw: Any, unit: str | None) -> Any:
    """Return one quantity or an array of them, in SI units; a list of lists is an array of rows."""
    if isinstance(raw, list) and any(isinstance(row, list) for row in raw):
        return _table_of(raw, unit)
    return numbers(raw, unit) if isinstance(raw, list | dict) else number(raw, unit)


def _table_of(rows: list[Any], unit: str | None) -> Array:
    """Return rows of quantities, such as loads in the plane."""
    if not all(isinstance(row, list) and row and len(row) == len(rows[0]) for row in rows):
        one = sample(unit or "")
        wrong(f'{WHERE} is a list of rows that differ; give rows of one length, such as [["{one}", "{one}"]].')
    return np.array([[inside(item, unit, f"[{i}][{j}]") for j, item in enumerate(row)] for i, row in enumerate(rows)])


def inside(raw: Any, unit: str | None, below: str) -> float:
    """Return one quantity of a list or range; its sentence names the place `below` the key."""
    try:
        return float(number(raw, unit))
    except PydanticCustomError as refusal:
        wrong(sentence_of(refusal).replace(WHERE, WHERE + below))


def check_keys(raw: dict[str, Any], allowed: tuple[str, ...], needed: tuple[str, ...], what: str) -> None:
    """Refuse keys of a table that are unknown, and a table that lacks one."""
    for key in raw:
        if key not in allowed:
            wrong(f"{WHERE}.{key} is not known{suggest(key, allowed)}; {what} takes {', '.join(allowed)}.")
    for key in needed:
        if key not in raw:
            wrong(f"{WHERE} has no '{key}'; {what} needs {', '.join(needed)}.")


def _range(raw: dict[str, Any], unit: str | None) -> Array:
    check_keys(raw, RANGE_KEYS, RANGE_KEYS[:3], "a range")
    first, last = (inside(raw[key], unit, f".{key}") for key in ("from", "to"))
    count, spacing = raw["count"], raw.get("spacing", "linear")
    if isinstance(count, bool) or not isinstance(count, int) or not 1 <= count <= 1_000_000:
        wrong(f"{WHERE}.count is {count!r}; give a whole number from 1 to 1000000.")
    if spacing not in ("linear", "log"):
        wrong(f'{WHERE}.spacing is {spacing!r}{suggest(str(spacing), ("linear", "log"))}; give "linear" or "log".')
    if not math.isfinite(2.0 * (last - first)):  # steps of so wide a range would overflow
        wrong(f"{WHERE} goes from {first:g} to {last:g}, which is wider than numbers can be; give a narrower range.")
    if spacing == "log":
        if not min(first, last) > 0.0 and not max(first, last) < 0.0:
            wrong(
                f"{WHERE} has logarithmic spacing from {first:g} to {last:g}; both ends must have one sign, not zero."
            )
        return np.geomspace(first, last, count)
    values = np.linspace(first, last, count)
    # a range across zero contains zero, not the rounding error of its steps
    return np.where(np.abs(values) < 1e-12 * np.ptp(values), 0.0, values)


def _is_finite(item: float) -> bool:
    """Return whether a float can hold a number; an integer of a study may have any number of digits."""
    try:
        return math.isfinite(item)
    except OverflowError:
        return False


def _with_one_unit(raw: dict[str, Any], unit: str | None) -> Array:
    check_keys(raw, ("values", "unit"), ("values",) if not unit else ("values", "unit"), "a table of values")
    values, unit_name = raw["values"], raw.get("unit", "")
    if not isinstance(values, list) or not values:
        wrong(f"{WHERE}.values is {values!r}; give a list with at least one number.")
    for place, item in enumerate(values):
        if isinstance(item, bool) or not isinstance(item, int | float) or not _is_finite(item):
            wrong(f"{WHERE}.values[{place}] is {item!r}; give finite numbers, their unit stands in unit.")
    if not isinstance(unit_name, str):
        wrong(
            f'{WHERE}.unit is {unit_name!r}; give a unit that fits {unit}, such as "{sample(unit or "").split()[-1]}".'
        )
    if unit_name == unit:
        return np.array(values, dtype=float)
    texts = [f"{repr(float(item)).removesuffix('.0')} {unit_name}".strip() for item in values]
    return np.array([inside(text, unit, f".values[{place}]") for place, text in enumerate(texts)])


def indexed(raw: Any, units: Callable[[int], str]) -> Array:
    """Return a list of quantities where each has its own unit, ``units(place)``."""
    if isinstance(raw, dict):
        check_keys(raw, ("values", "unit"), ("values",), "a table of values")
        raw = raw["values"]
        if isinstance(raw, list) and all(isinstance(item, int | float) and not isinstance(item, bool) for item in raw):
            return np.array(raw, dtype=float)
    if not isinstance(raw, list) or not raw:
        wrong(f"{WHERE} is {raw!r}; give a list with at least one quantity.")
    return np.array([inside(item, units(place), f"[{place}]") for place, item in enumerate(raw)], dtype=float)


def grid(raw: Any) -> Array:
    """Return a table of plain numbers, given row by row in rows of one length."""
    rows = raw if isinstance(raw, list) else []
    if not rows or not all(isinstance(row, list) and row and len(row) == len(rows[0]) for row in rows):
        wrong(f"{WHERE} is no table of numbers; give rows of one length, such as [[0.1, 0.2], [0.3, 0.4]].")
    return np.array([[inside(item, "", f"[{i}][{j}]") for j, item in enumerate(row)] for i, row in enumerate(rows)])


def named(raw: Any) -> tuple[tuple[str, float], ...]:
    """Return a table of named constants, each a number or a quantity of any dimension, in SI units."""
    if not isinstance(raw, dict):
        wrong(f'{WHERE} is {raw!r}; give a table of named constants, such as {{ R = "10 mm" }}.')
    constants = []
    for name, item in raw.items():
        if isinstance(item, str):
            try:
                constants.append((name, to_si(item, what=f"{WHERE}.{name}")))
            except InvalidInput as error:
                wrong(str(error))
        else:
            constants.append((name, inside(item, "", f".{name}")))
    return tuple(constants)
