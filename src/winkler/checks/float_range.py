"""Arithmetic that leaves the range of floating-point numbers becomes one sentence about the problem at hand."""

from __future__ import annotations

import contextlib
import dataclasses
import functools
import math
from collections.abc import Callable, Iterator
from typing import Any, ParamSpec, TypeVar

import numpy as np

from winkler.checks.physical_size import beyond_physics
from winkler.errors import NotConverged, OutsideValidity, WinklerError

__all__ = ["guarded", "guarded_answer", "guarded_stream"]

P = ParamSpec("P")
R = TypeVar("R")

FAULTS = (TypeError, ValueError, AttributeError, ArithmeticError, LookupError, RuntimeError)
"""What numbers that have left the range may end in."""


def guarded(solve: Callable[..., Any]) -> Callable[..., Any]:
    """Return a solver that says in one sentence if numbers left the range of floating-point numbers.

    Numbers that a solver expects to overflow it treats itself; any other overflow, division by zero or undefined
    number ends it.
    """

    @functools.wraps(solve)
    def answered(self: Any, *given: Any, **named: Any) -> Any:
        with _in_words(self):
            return _known(solve(self, *given, **named))

    return answered


def guarded_answer(answer: Callable[P, R]) -> Callable[P, R]:
    """Return a function of a solution, its first argument, guarded as what has solved its problem."""

    @functools.wraps(answer)
    def answered(*given: P.args, **named: P.kwargs) -> R:
        with _in_words(getattr(given[0], "problem", given[0])):
            return answer(*given, **named)

    return answered


def guarded_stream(steps: Callable[..., Iterator[Any]]) -> Callable[..., Iterator[Any]]:
    """Return a march whose every step is guarded as `guarded` does it; who iterates is left alone between them."""

    @functools.wraps(steps)
    def streamed(self: Any, *given: Any, **named: Any) -> Iterator[Any]:
        states = steps(self, *given, **named)
        while True:
            with _in_words(self):
                try:
                    state = _known(next(states))
                except StopIteration:
                    return
            yield state

    return streamed


def _known(answer: Any) -> Any:
    """Return an answer none of whose numbers is undefined; compiled kernels say nothing of those they meet."""
    for field in dataclasses.fields(answer) if dataclasses.is_dataclass(answer) else ():
        inside = getattr(answer, field.name)
        if isinstance(inside, np.ndarray):
            undefined = inside.dtype == float and bool(np.isnan(inside).any())
        else:
            undefined = isinstance(inside, float) and math.isnan(inside)
        if undefined:
            raise FloatingPointError(f"the {field.name} comes out undefined")
    return answer


@contextlib.contextmanager
def _in_words(problem: Any) -> Iterator[None]:
    """Turn arithmetic that leaves the range of numbers into one sentence about a problem."""
    try:
        with np.errstate(over="raise", divide="raise", invalid="raise"):
            yield
    except NotConverged as error:
        far = next(beyond_physics(problem), "")
        if not far:
            raise
        # what does not settle is the size of the numbers, not the shape
        raise OutsideValidity(
            f"{type(problem).__name__}: {far}, so that it cannot be computed; check the numbers and their units."
        ) from error
    except WinklerError:
        raise
    except FAULTS as error:
        far = next(beyond_physics(problem), "")
        if not far and not isinstance(error, ArithmeticError):
            raise
        why = far or "the numbers are too large, too small or too far from each other"
        raise OutsideValidity(
            f"{type(problem).__name__}: {why}, so that it cannot be computed ({error}); check the numbers and their "
            "units."
        ) from error
