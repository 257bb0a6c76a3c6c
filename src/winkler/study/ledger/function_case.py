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

The functions that a case of the ledger may name: a closed list, each with its arguments and its quantity.

Coefficients that are no solution of a problem are compared by ``[function]``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from winkler.fitting.unloading.contact_reading import CalibratedArea, contact_reading, sample_young
from winkler.materials.elastic import Elastic
from winkler.numerics.types import Quantity
from winkler.problems.adhesion.tabor import maugis_parameter
from winkler.problems.rolling.kalker import creep_coefficients
from winkler.problems.rolling.linear_theory import linear_creep_coefficients
from winkler.problems.rough.persson import area_fraction
from winkler.study.batch.points import ComparedNumber
from winkler.study.batch.verdicts import deviation
from winkler.study.language.compared.expectations import expectations
from winkler.study.language.quantities import read_at
from winkler.study.language.reading import parsed, read_text
from winkler.study.language.study import Expectation
from winkler.values.errors import InvalidInput, suggest


class Function(NamedTuple):
    """One line of the list."""

    call: Callable[..., Any]
    physics: str
    """The chapter of the ledger."""
    answer: str
    """The glossary entry of its value."""
    units: Mapping[str, str]
    """Every argument and its unit."""
    part: str = ""
    """Attribute of the result that is compared; empty if it is the number itself."""


READING_ARGUMENTS = {
    "stiffness": "N/m",
    "force": "N",
    "depth": "m",
    "c0": "",
    "c1": "m",
    "c2": "m^1.5",
    "c3": "m^1.75",
}
"""Stiffness, load and depth, and the area function of the tip."""


def _hardness(stiffness: float, force: float, depth: float, c0: float, c1: float, c2: float, c3: float) -> float:
    """Return the hardness [Pa] that `contact_reading` reads."""
    return contact_reading(stiffness, force, depth, CalibratedArea((c0, c1, c2, c3))).hardness


def _young(
    stiffness: float, force: float, depth: float, c0: float, c1: float, c2: float, c3: float, *, poisson: float,
    indenter_young: float, indenter_poisson: float,
) -> float:  # fmt: skip
    """Return Young's modulus [Pa] of the sample that `contact_reading` and `sample_young` read."""
    pair = contact_reading(stiffness, force, depth, CalibratedArea((c0, c1, c2, c3))).modulus
    return sample_young(pair, poisson, Elastic(indenter_young, indenter_poisson))


CREEP_ARGUMENTS = {"ratio": "", "poisson": ""}


def _linear(part: str) -> Function:
    """Return a coefficient of the linear theory of rolling."""
    return Function(linear_creep_coefficients, "rolling", "creep_coefficient", CREEP_ARGUMENTS, part)


FUNCTIONS: dict[str, Function] = {
    "area_fraction": Function(
        area_fraction,
        "measured and rough surfaces",
        "area_fraction",
        {"pressure": "Pa", "modulus": "Pa", "rms_slope": ""},
    ),
    "contact_reading.hardness": Function(_hardness, "fits", "hardness", READING_ARGUMENTS),
    "contact_reading.young": Function(
        _young, "fits", "young", READING_ARGUMENTS | {"poisson": "", "indenter_young": "Pa", "indenter_poisson": ""}
    ),
    "creep_coefficients.lateral": Function(
        creep_coefficients, "rolling", "creep_coefficient", CREEP_ARGUMENTS, "lateral"
    ),
    "creep_coefficients.longitudinal": Function(
        creep_coefficients, "rolling", "creep_coefficient", CREEP_ARGUMENTS, "longitudinal"
    ),
    "creep_coefficients.spin": Function(creep_coefficients, "rolling", "creep_coefficient", CREEP_ARGUMENTS, "spin"),
    "linear_creep_coefficients.lateral": _linear("lateral"),
    "linear_creep_coefficients.longitudinal": _linear("longitudinal"),
    "linear_creep_coefficients.spin": _linear("spin"),
    "linear_creep_coefficients.turning": _linear("turning"),
    "maugis_parameter": Function(
        maugis_parameter,
        "adhesion",
        "maugis_parameter",
        {"curvature_radius": "m", "modulus": "Pa", "work": "J/m^2", "strength": "Pa"},
    ),
}
"""Name of a public function, with the attribute of its result -> its entry."""


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
                f"{path.name}: {key} is not known{suggest(key, CASE_KEYS)}; a case with [function] has "
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
