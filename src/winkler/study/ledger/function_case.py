"""Cases of the ledger that ask no problem but a function: ``[function]``, and ``[[expect]]`` for what it answers.

Coefficients of a table are no answer of a problem, and still have numbers that were published:

.. code-block:: toml

    [function]
    name = "creep_coefficients.spin"
    ratio = 1.0
    poisson = 0.25

    [[expect]]
    quantity = "creep_coefficient"
    value = 1.47
    tolerance = 1e-12
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from pydantic_core import PydanticCustomError

from winkler.errors import InvalidInput, suggest
from winkler.numerics.types import Quantity
from winkler.study.batch.outcome import Verdict
from winkler.study.batch.verdicts import deviation
from winkler.study.language import quantities
from winkler.study.language.quantities import WHERE
from winkler.study.language.reading import parsed, read_text
from winkler.study.language.study import Expectation
from winkler.study.ledger.expected_case import expectations
from winkler.study.ledger.functions import FUNCTIONS, Function

__all__ = ["FunctionCase", "function_verdicts", "is_function", "read_function_case"]

KNOWN = ("title", "source", "grade", "function", "expect")


class FunctionCase(NamedTuple):
    """A function of the list, its arguments [SI], and what it must answer."""

    title: str
    source: str
    grade: str
    function: Function
    arguments: dict[str, Quantity]
    expect: tuple[Expectation, ...]


def is_function(path: Path) -> bool:
    """Return whether a case asks a function."""
    return "function" in parsed(read_text(path), path.name)


def read_function_case(path: Path) -> FunctionCase:
    """Read a case with ``[function]``.

    Raises
    ------
    InvalidInput
        If the function is none of the list, an argument is missing, unknown or of the wrong unit, or the case asks for
        anything but what the function answers.
    """
    raw = parsed(read_text(path), path.name)
    for key in raw:
        if key not in KNOWN:
            raise InvalidInput(
                f"{path.name}: {key} is not known{suggest(key, KNOWN)}; a case with [function] takes "
                f"{', '.join(KNOWN)}."
            )
    table = raw["function"] if isinstance(raw["function"], dict) else {}
    name = str(table.get("name", ""))
    if name not in FUNCTIONS:
        raise InvalidInput(
            f"{path.name}: function.name is '{name}'{suggest(name, FUNCTIONS)}; give one of {', '.join(FUNCTIONS)}."
        )
    function = FUNCTIONS[name]
    given = {key: content for key, content in table.items() if key != "name"}
    for key in (*function.units, *given):
        if key not in given or key not in function.units:
            raise InvalidInput(
                f"{path.name}: function.{key} is {'missing' if key in function.units else 'not known'}; {name} takes "
                f"{', '.join(function.units)}."
            )
    arguments = {key: _number(path.name, key, given[key], unit) for key, unit in function.units.items()}
    asked = expectations(raw.get("expect", []), path.name)
    for item in asked:
        if item.quantity != function.answer or item.place:
            raise InvalidInput(
                f"{path.name}: expect asks for '{item.quantity}'; {name} answers with {function.answer}, at no place."
            )
    told = {key: str(raw.get(key, "")) for key in ("title", "source", "grade")}
    return FunctionCase(**told, function=function, arguments=arguments, expect=asked)


def _number(file: str, key: str, raw: Any, unit: str) -> Quantity:
    try:
        found: Quantity = quantities.number_or_numbers(raw, unit)
    except PydanticCustomError as error:
        told = str((error.context or {})["sentence"]).replace(WHERE, f"function.{key}")
        raise InvalidInput(f"{file}: {told}") from None
    return found


def function_verdicts(case: FunctionCase) -> tuple[Verdict, ...]:
    """Return the verdicts on what a function answers.

    Raises
    ------
    InvalidInput, OutsideValidity
        If the function refuses its arguments.
    """
    function = case.function
    result = function.call(**case.arguments)
    got = np.asarray(getattr(result, function.part) if function.part else result, dtype=float)
    found: Quantity = float(got) if got.ndim == 0 else got
    return tuple(Verdict((), asked, found, deviation(found, asked)) for asked in case.expect)
