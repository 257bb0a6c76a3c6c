"""Arithmetic that leaves the range of floating-point numbers becomes one sentence about the problem."""

from __future__ import annotations

import contextlib
import dataclasses
import functools
import math
import threading
from collections.abc import Callable, Hashable, Iterator
from typing import Any, ParamSpec, TypeVar

import numpy as np

from winkler.values.checks.physical_size import beyond_physics
from winkler.values.errors import NotConverged, OutsideValidity, WinklerError

P = ParamSpec("P")
R = TypeVar("R")

_guarded = threading.local()
"""The problem whose solver is guarded now, in this thread."""
ARITHMETIC_FAULTS = (TypeError, ValueError, AttributeError, ArithmeticError, LookupError, RuntimeError)
"""What numbers that have left the range may end in."""


def guarded(solve: Callable[..., Any]) -> Callable[..., Any]:
    """Return a solver that states in one sentence whether numbers left the range of floating-point numbers.

    Numbers that a solver expects to overflow it treats itself; any other overflow, division by zero or undefined
    number ends it.
    """

    @functools.wraps(solve)
    def checked_call(self: Any, *positional: Any, **named: Any) -> Any:
        with _as_sentence(self):
            return _without_nan(solve(self, *positional, **named))

    return checked_call


def guarded_result(function: Callable[P, R]) -> Callable[P, R]:
    """Return a function of a solution, its first argument, guarded as what has solved its problem."""

    @functools.wraps(function)
    def checked_call(*positional: P.args, **named: P.kwargs) -> R:
        with _as_sentence(getattr(positional[0], "problem", positional[0])):
            return function(*positional, **named)

    return checked_call


def guarded_stream(steps: Callable[..., Iterator[Any]]) -> Callable[..., Iterator[Any]]:
    """Return a march whose every step is guarded as `guarded` does it; who iterates is left alone between them."""

    @functools.wraps(steps)
    def streamed(self: Any, *positional: Any, **named: Any) -> Iterator[Any]:
        states = steps(self, *positional, **named)
        if getattr(_guarded, "problem", None) is self:  # its solver asks, and is guarded itself
            yield from map(_without_nan, states)
            return
        while True:
            with _as_sentence(self):
                try:
                    state = _without_nan(next(states))
                except StopIteration:
                    return
            yield state

    return streamed


def _without_nan(result: Any) -> Any:
    """Return a result without undefined numbers; compiled kernels raise no error for those."""
    for name in _fields_of(result.__class__):
        inside = getattr(result, name)
        if type(inside) is float:  # most numbers of a long march
            undefined = inside != inside
        elif isinstance(inside, float):
            undefined = math.isnan(inside)
        else:
            undefined = isinstance(inside, np.ndarray) and inside.dtype == float and bool(np.isnan(inside).any())
        if undefined:
            raise FloatingPointError(f"the {name} comes out undefined")
    return result


@functools.cache
def _fields_of(kind: Hashable) -> tuple[str, ...]:
    return tuple(field.name for field in dataclasses.fields(kind)) if dataclasses.is_dataclass(kind) else ()


@contextlib.contextmanager
def _as_sentence(problem: Any) -> Iterator[None]:
    """Turn arithmetic that leaves the range of numbers into one sentence about a problem."""
    outer = getattr(_guarded, "problem", None)
    _guarded.problem = problem
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
    except ARITHMETIC_FAULTS as error:
        far = next(beyond_physics(problem), "")
        if not far and not isinstance(error, ArithmeticError):
            raise
        why = far or "the numbers are too large, too small or too far from each other"
        raise OutsideValidity(
            f"{type(problem).__name__}: {why}, so that it cannot be computed ({error}); check the numbers and their "
            "units."
        ) from error
    finally:
        _guarded.problem = outer
