"""What a calculator shows, without a browser: its numbers, and its study, from the kept tables."""

from __future__ import annotations

import functools
from collections.abc import Mapping

import numpy as np

from winkler.calculators.build import TABLE_FILE
from winkler.calculators.calculator import Calculator
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput

__all__ = ["answer_of", "study_text_of", "values_of"]


@functools.cache
def _kept() -> Mapping[str, Array]:
    with np.load(TABLE_FILE, allow_pickle=False) as kept:
        return {name: kept[name] for name in kept.files}


def values_of(one: Calculator, given: Mapping[str, float]) -> dict[str, float]:
    """Return the numbers of all sliders, in their units: those that are given, else where they begin.

    Raises
    ------
    InvalidInput
        If a name is not that of a slider, or a number is outside its range.
    """
    known = {slider.name: slider for slider in one.sliders}
    for name, number in given.items():
        if name not in known:
            raise InvalidInput(f"widget: {one.name} has no slider '{name}'; give some of {', '.join(known)}.")
        slider = known[name]
        if not slider.low <= number <= slider.high:
            unit = f" {slider.unit}" if slider.unit else ""
            raise InvalidInput(
                f"widget: {name} is {number!r}{unit}; give a number from {slider.low:g} to {slider.high:g}{unit}."
            )
    return {name: float(given.get(name, slider.start)) for name, slider in known.items()}


def answer_of(one: Calculator, values: Mapping[str, float]) -> dict[str, float]:
    """Return the numbers of the answer in SI units; `values` are those of all sliders in their units."""
    given = np.array([values[slider.name] for slider in one.sliders]) * one.factors
    found = np.full(len(one.numbers), np.nan)
    prefix = f"{one.name}."
    one.kernel(given, *(table for name, table in _kept().items() if name.startswith(prefix)), found)
    return {number.name: float(each) for number, each in zip(one.numbers, found, strict=True)}


def study_text_of(one: Calculator, values: Mapping[str, float]) -> str:
    """Return the study file of what is shown; `values` as of `answer_of`."""
    body, answer = one.study, answer_of(one, values)
    for slider in one.sliders:
        body = body.replace(f"{{{slider.name}}}", _quantity(values[slider.name], slider.unit))
    for number in one.numbers:
        body = body.replace(f"{{={number.name}}}", _quantity(answer[number.name], number.base))
    return f'title = "{one.title}"\n\n[problem]\nkind = "{one.kind}"\n{body}'


def _quantity(number: float, unit: str) -> str:
    return f'"{number!r} {unit}"' if unit else repr(number)
