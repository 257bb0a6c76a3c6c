"""Cases of the ledger that evaluate a function: ``[function]``, and ``[[expect]]`` for its value.

Coefficients of a table are no solution of a problem, but have published numbers:

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

from winkler.numerics.types import Quantity
from winkler.study.batch.outcome import ComparedNumber
from winkler.study.batch.verdicts import deviation
from winkler.study.language.compared.expectations import expectations
from winkler.study.language.quantities import read_at
from winkler.study.language.reading import parsed, read_text
from winkler.study.language.study import Expectation
from winkler.study.ledger.functions import FUNCTIONS, Function
from winkler.values.errors import InvalidInput, suggest

__all__ = ["FunctionCase", "function_verdicts", "read_function_case"]

CASE_KEYS = ("title", "source", "grade", "function", "expect")


class FunctionCase(NamedTuple):
    """A function of the list, its arguments [SI], and its expected values."""

    title: str
    source: str
    grade: str
    function: Function
    arguments: dict[str, Quantity]
    expect: tuple[Expectation, ...]


def read_function_case(path: Path) -> FunctionCase:
    """Read a case with ``[function]``.

    Raises
    ------
    InvalidInput
        If the function is none of the list, an argument is missing, unknown or of the wrong unit, or the case expects
        another quantity than that of the function.
    """
    raw = parsed(read_text(path), path.name)
    for key in raw:
        if key not in CASE_KEYS:
            raise InvalidInput(
                f"{path.name}: {key} is not known{suggest(key, CASE_KEYS)}; a case with [function] takes "
                f"{', '.join(CASE_KEYS)}."
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
    expected = expectations(raw.get("expect", []), path.name)
    for item in expected:
        if item.quantity != function.answer or item.place:
            raise InvalidInput(
                f"{path.name}: expect asks for '{item.quantity}'; {name} answers with {function.answer}, at no place."
            )
    texts = {key: str(raw.get(key, "")) for key in ("title", "source", "grade")}
    return FunctionCase(**texts, function=function, arguments=arguments, expect=expected)


def _number(file: str, key: str, raw: Any, unit: str) -> Quantity:
    try:
        number: Quantity = read_at(f"function.{key}", raw, unit)
    except InvalidInput as error:
        raise InvalidInput(f"{file}: {error}") from None
    return number


def function_verdicts(case: FunctionCase) -> tuple[ComparedNumber, ...]:
    """Return the verdicts on the value of a function.

    Raises
    ------
    InvalidInput, OutsideValidity
        If the function refuses its arguments.
    """
    function = case.function
    result = function.call(**case.arguments)
    got = np.asarray(getattr(result, function.part) if function.part else result, dtype=float)
    number: Quantity = float(got) if got.ndim == 0 else got
    return tuple(ComparedNumber((), expected, number, deviation(number, expected)) for expected in case.expect)
