"""Whether what was expected came out: the verdicts on ``[[expect]]``."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np

from winkler.errors import InvalidInput, suggest
from winkler.fields import restore
from winkler.numerics.types import Array, Quantity
from winkler.study.outcome import Solved, Verdict, answers_of
from winkler.study.study import Expectation

__all__ = ["judge"]


def judge(point: Solved, expectation: Expectation, shape: tuple[int, ...] = ()) -> Verdict:
    """Return the verdict on one expectation at one point.

    Parameters
    ----------
    point, expectation
        What came out, and what was expected: one number for all points, or as many as the sweep has points.
    shape
        Number of points along each axis of the sweep; ``()`` without one.

    Raises
    ------
    InvalidInput
        If the solution has no such answer or field.
    """
    got = _found(point.solution, expectation)
    expected = np.asarray(expectation.expected, dtype=float)
    if shape and np.ndim(got) == 0 and expected.size == math.prod(shape) and expected.ndim:
        expected = expected.reshape(shape)[point.index]
        expectation = dataclasses.replace(expectation, expected=float(expected))
    if np.shape(got) != expected.shape:
        if expected.ndim:
            raise InvalidInput(
                f"expect: {expectation.quantity} has {np.size(got)} values, but {expected.size} are expected; "
                "give one for each load."
            )
        got, expected = np.broadcast_arrays(got, expected)
    scale = expectation.scale or np.abs(expected)
    difference = np.abs(np.asarray(got, dtype=float) - expected) / scale
    deviation = float(np.max(difference)) if np.all(np.isfinite(difference)) else np.inf
    return Verdict(point.index, expectation, got, deviation)


def _found(solution: Any, expectation: Expectation) -> Quantity:
    name, place = expectation.quantity, dict(expectation.place)
    if not place and "." in name:
        return _along(solution, name)
    if not place:
        known = answers_of(solution)
        if name not in known:
            raise InvalidInput(_unknown(name, list(known), f"an answer of {type(solution).__name__}"))
        return known[name]
    if "x" in place:
        function = getattr(solution, name, None)
        if not callable(function):
            raise InvalidInput(f"expect: {name} is no function of x of {type(solution).__name__}; leave x out.")
        return _only(function(np.array([place["x"]])))
    r = np.array([place["r"]])
    fields = restore(solution, r, np.array([place["z"]])) if "z" in place else restore(solution, r)
    content = getattr(fields, name, None)
    if not isinstance(content, np.ndarray) or name.startswith("_"):
        known_fields = [key for key in dir(fields) if not key.startswith("_") and key not in ("r", "z")]
        raise InvalidInput(_unknown(name, known_fields, f"one of {type(fields).__name__}"))
    if content.ndim != 1:
        raise InvalidInput(f"expect: {name} is no single number; expect one of its components' invariants instead.")
    return _only(content)


def _along(solution: Any, path: str) -> Quantity:
    """Return the number at a path of public attributes of the solution, ``problem.bed.medium.modulus``."""
    content = solution
    for part in path.split("."):
        if isinstance(content, np.ndarray) and part.removeprefix("-").isdecimal():
            if not -len(content) <= int(part) < len(content):
                raise InvalidInput(f"expect: quantity '{path}' asks for one of {len(content)} numbers; count from 0.")
            content = content[int(part)].item() if content.ndim == 1 else content[int(part)]
            continue
        if part.startswith("_") or not hasattr(content, part):
            known = [key for key in dir(content) if not key.startswith("_") and not callable(getattr(content, key))]
            raise InvalidInput(_unknown(part, known, f"a part of {type(content).__name__}"))
        content = getattr(content, part)
    if isinstance(content, int | float) and not isinstance(content, bool):
        return float(content)
    if isinstance(content, np.ndarray) and content.dtype.kind == "f":
        return content
    raise InvalidInput(f"expect: quantity '{path}' is no number but a {type(content).__name__}; name a number.")


def _only(content: Array) -> float:
    return float(np.ravel(content)[0])


def _unknown(name: str, known: list[str], what: str) -> str:
    return f"expect: quantity '{name}' is not {what}{suggest(name, known)}; there are {', '.join(known)}."
