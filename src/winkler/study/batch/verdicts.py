"""Comparison of computed with expected numbers: the verdicts on ``[[expect]]``."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np

from winkler.numerics.types import Quantity
from winkler.study.batch.outcome import answers_of
from winkler.study.batch.points import ComparedNumber, Solved
from winkler.study.language.study import Expectation
from winkler.values.errors import InvalidInput, suggest


def compared(point: Solved, expectation: Expectation, shape: tuple[int, ...] = ()) -> ComparedNumber:
    """Return the verdict on one expectation at one point.

    Parameters
    ----------
    point, expectation
        The solved point, and the expectation: one number for all points, or as many as the sweep has points.
    shape
        Number of points along each axis of the sweep; ``()`` without one.

    Raises
    ------
    InvalidInput
        If the solution has no such answer or field.
    """
    got = _computed_quantity(point.solution, expectation)
    expected = np.asarray(expectation.expected, dtype=float)
    if shape and np.ndim(got) == 0 and expected.size == math.prod(shape) and expected.ndim:
        expected = expected.reshape(shape)[point.index]
        expectation = dataclasses.replace(expectation, expected=float(expected))
    return ComparedNumber(point.index, expectation, got, deviation(got, expectation))


def deviation(got: Quantity, expectation: Expectation) -> float:
    """Return by how much an answer deviates, relative to the scale of what was expected; infinite if it is not finite.

    Raises
    ------
    InvalidInput
        If there are more or fewer numbers than were expected.
    """
    expected = np.asarray(expectation.expected, dtype=float)
    if np.shape(got) != expected.shape and expected.ndim:
        raise InvalidInput(
            f"expect: {expectation.quantity} has {np.size(got)} values, but {expected.size} are expected; "
            "give one for each load."
        )
    scale = expectation.scale or np.abs(expected)
    difference = np.abs(np.asarray(got, dtype=float) - expected) / scale
    return float(np.max(difference)) if np.all(np.isfinite(difference)) else np.inf


def _computed_quantity(solution: Any, expectation: Expectation) -> Quantity:
    name, place = expectation.quantity, dict(expectation.place)
    if not place and "." in name:
        return _number_at_path(solution, name)
    if not place:
        answers = answers_of(solution)
        if name not in answers:
            raise InvalidInput(_unknown(name, list(answers), f"an answer of {type(solution).__name__}"))
        return answers[name]
    from winkler.study.batch.expected_fields import number_at

    return number_at(solution, name, place)


def _number_at_path(solution: Any, path: str) -> Quantity:
    """Return the number at a path of public attributes of the solution, ``problem.bed.medium.modulus``."""
    content = solution
    for part in path.split("."):
        if isinstance(content, np.ndarray) and part.removeprefix("-").isdecimal():
            if not -len(content) <= int(part) < len(content):
                raise InvalidInput(f"expect: quantity '{path}' asks for one of {len(content)} numbers; count from 0.")
            content = content[int(part)].item() if content.ndim == 1 else content[int(part)]
            continue
        if part.startswith("_") or not hasattr(content, part):
            names = [key for key in dir(content) if not key.startswith("_") and not callable(getattr(content, key))]
            raise InvalidInput(_unknown(part, names, f"a part of {type(content).__name__}"))
        content = getattr(content, part)
    if isinstance(content, int | float) and not isinstance(content, bool):
        return float(content)
    if isinstance(content, np.ndarray) and content.dtype.kind == "f":
        return content
    raise InvalidInput(f"expect: quantity '{path}' is no number but a {type(content).__name__}; name a number.")


def _unknown(name: str, names: list[str], what: str) -> str:
    return f"expect: quantity '{name}' is not {what}{suggest(name, names)}; there are {', '.join(names)}."
