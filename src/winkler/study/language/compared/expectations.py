"""The ``[[expect]]`` of a study, and of a case that is no plain study: of a fit, or of a function."""

from __future__ import annotations

from typing import Any

from winkler.study.language import quantities
from winkler.study.language.compared.expected_units import unit_of_quantity
from winkler.study.language.grammar import PLACE_KEYS
from winkler.study.language.schema import MISSING
from winkler.study.language.study import Expectation
from winkler.values.errors import InvalidInput

OPTIONAL_KEYS = ("unit", "scale", *PLACE_KEYS)
"""Keys of ``[[expect]]`` that may be left out."""


def expectation(table: dict[str, Any], problem: Any = None) -> Expectation:
    """Return one ``[[expect]]`` of a problem.  Its value is a quantity, or a number with its unit in ``unit``."""
    name = table["quantity"]
    unit = unit_of_quantity(name, problem)
    raw, unit_text = table["value"], table["unit"]
    if unit_text is not MISSING and isinstance(raw, int | float) and not isinstance(raw, bool):
        raw = f"{raw!r} {unit_text}".strip()
    elif unit_text is not MISSING and isinstance(raw, list):
        raw = {"values": raw, "unit": unit_text}
    scale = table["scale"]
    if unit_text is not MISSING and isinstance(scale, int | float) and not isinstance(scale, bool):
        scale = f"{scale!r} {unit_text}".strip()
    place = tuple(
        (key, float(quantities.read_at(key, table[key], "m"))) for key in PLACE_KEYS if table[key] is not MISSING
    )
    if tuple(key for key, _ in place) not in ((), ("r",), ("r", "z"), ("x",), ("x", "y", "z")):
        raise InvalidInput(
            f"expect gives {' and '.join(key for key, _ in place)}; give r on the surface, r and z below it, "
            "x along the springs, or x, y and z."
        )
    return Expectation(
        quantity=name,
        expected=quantities.read_at("value", raw, unit),
        tolerance=float(quantities.read_at("tolerance", table["tolerance"], "")),
        place=place,
        scale=0.0 if scale is MISSING else float(quantities.read_at("scale", scale, unit)),
        unit=unit,
    )


def expectations(items: Any, file: str) -> tuple[Expectation, ...]:
    """Return the entries of ``[[expect]]`` of a case.

    Raises
    ------
    InvalidInput
        If one lacks a key or has a wrong number.
    """
    if not isinstance(items, list) or not all(isinstance(item, dict) for item in items):
        raise InvalidInput(f"{file}: expect is no list of tables; write it with two brackets, as [[expect]].")
    return tuple(_expectation(item, file) for item in items)


def _expectation(item: dict[str, Any], file: str) -> Expectation:
    try:
        return expectation(dict.fromkeys(OPTIONAL_KEYS, MISSING) | item)
    except KeyError as error:
        raise InvalidInput(f"{file}: expect needs {error.args[0]}; add it.") from None
    except InvalidInput as error:
        sentence = str(error).removeprefix("expect: ")
        raise InvalidInput(f"{file}: expect: {sentence}") from None
