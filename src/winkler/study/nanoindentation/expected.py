"""Expected numbers of nanoindentations: ``[[expect]]`` in studies with ``[indentation]`` or ``[calibration]``.

Of an indentation the quantities are its answers (young, hardness, stiffness, contact_depth, modulus, ...), at the
greatest force of each curve; with a number behind the name, at that unloading, ``young.0`` the first.  A calibration
has frame_compliance, and by their number what it has of each unloading.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from winkler.study.batch.outcome import ComparedNumber, answers_of
from winkler.study.batch.verdicts import deviation
from winkler.study.language.study import Expectation
from winkler.values.errors import InvalidInput, suggest

__all__ = ["verdicts_of"]


def verdicts_of(
    expect: tuple[Expectation, ...], found: Sequence[tuple[str, Any]]
) -> tuple[tuple[ComparedNumber, str], ...]:
    """Return the verdicts on expectations, with the names of the curves.

    Parameters
    ----------
    expect : tuple of Expectation
    found : sequence of (str, solution)
        Name and evaluation of each curve; None where there is none, and its numbers are missed.

    Raises
    ------
    InvalidInput
        If an evaluation has no such number.
    """
    verdicts = []
    for place, (name, solution) in enumerate(found):
        for item in expect:
            got = np.nan if solution is None else _number(solution, item)
            verdicts.append((ComparedNumber((place,), item, got, deviation(got, item)), name))
    return tuple(verdicts)


def _number(solution: Any, item: Expectation) -> float:
    if item.place or np.ndim(item.expected):
        raise InvalidInput(
            f"expect: {item.quantity} is one number of a curve; give one value without a place, and the number of an "
            f"unloading behind the name, as {item.quantity}.0."
        )
    answers = answers_of(solution)
    whole, _, last = item.quantity.rpartition(".")
    index = int(last) if whole and last.removeprefix("-").isdecimal() else None
    name = item.quantity if index is None else whole
    if name not in answers:
        raise InvalidInput(f"expect: '{name}' is no answer{suggest(name, answers)}; there are {', '.join(answers)}.")
    numbers = np.ravel(answers[name])
    if np.ndim(answers[name]) == 0:
        return float(numbers[0])
    if index is None and not hasattr(solution, "deepest"):
        raise InvalidInput(f"expect: {name} has {numbers.size} values; name one, as {name}.0.")
    index = solution.deepest if index is None else index
    if not -numbers.size <= index < numbers.size:
        raise InvalidInput(f"expect: {item.quantity} asks for one of {numbers.size} unloadings; count from 0.")
    return float(numbers[index])
