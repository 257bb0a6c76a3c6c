"""The functions that kernels may call: which of Python's, of `math` and of numpy are translated, and what they give."""

from __future__ import annotations

import builtins
import math
from collections.abc import Callable
from typing import Any

import numpy as np

from winkler.exporting.translation.tree import BOOL, INT, REAL, TranslatedType, Typed

WORDS = (
    "sqrt exp expm1 log log1p sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh hypot copysign floor "
    "ceil erf erfc"
)
NAMES = WORDS.split()
NUMPY_NAMES = {"arcsin": "asin", "arccos": "acos", "arctan": "atan", "arctan2": "atan2"}


def _real_functions() -> dict[Any, str]:
    found: dict[Any, str] = {getattr(math, name): name for name in NAMES}
    found |= {getattr(np, name): name for name in NAMES if hasattr(np, name)}
    found |= {getattr(np, name): ours for name, ours in NUMPY_NAMES.items()}
    return found | {math.fabs: "fabs", math.pow: "pow"}


REAL_FUNCTIONS: dict[Any, str] = _real_functions()
"""Function -> its name in C; takes and returns real numbers."""
CLASSES: dict[Any, str] = {
    math.isnan: "isnan",
    np.isnan: "isnan",
    math.isfinite: "isfinite",
    np.isfinite: "isfinite",
    math.isinf: "isinf",
    np.isinf: "isinf",
}
REDUCTIONS: dict[Any, str] = {np.sum: "sum", np.min: "min", np.max: "max"}
"""Function of one row -> the helper that does it."""


def cast(expression: Typed, wanted: TranslatedType) -> Typed:
    """Return an expression as another type of number; a tuple entry by entry."""
    if expression.type == wanted:
        return expression
    if expression.form == "tuple":
        parts = tuple(cast(*pair) for pair in zip(expression.parts, wanted.parts, strict=True))
        return Typed(wanted, "tuple", parts=parts)
    if expression.form == "number" and expression.type == INT and wanted == REAL:
        return Typed(REAL, "number", repr(float(expression.text)))
    return Typed(wanted, "cast", parts=(expression,))


def extreme(name: str, arguments: list[Typed]) -> Typed:
    """Return the least or greatest of numbers, chosen as Python chooses."""
    wanted = REAL if any(argument.type == REAL for argument in arguments) else INT
    found = cast(arguments[0], wanted)
    for other in arguments[1:]:
        found = Typed(wanted, "function", f"{name}_{wanted.kind}", (found, cast(other, wanted)))
    return found


def _real(name: str) -> Callable[[list[Typed]], Typed | None]:
    def build(arguments: list[Typed]) -> Typed | None:
        if not all(argument.type.is_number for argument in arguments):
            return None
        return Typed(REAL, "function", name, tuple(cast(argument, REAL) for argument in arguments))

    return build


def _class(name: str) -> Callable[[list[Typed]], Typed | None]:
    def build(arguments: list[Typed]) -> Typed | None:
        if len(arguments) != 1 or not arguments[0].type.is_number:
            return None
        return Typed(BOOL, "function", name, (cast(arguments[0], REAL),))

    return build


def _row(name: str) -> Callable[[list[Typed]], Typed | None]:
    def build(arguments: list[Typed]) -> Typed | None:
        if len(arguments) == 2 and name in ("min", "max") and all(part.type.is_number for part in arguments):
            return extreme(name, arguments)
        if len(arguments) != 1 or arguments[0].type.axes != 1 or arguments[0].type.item != REAL:
            return None
        return Typed(REAL, "function", f"row_{name}", tuple(arguments))

    return build


def _minmax(name: str) -> Callable[[list[Typed]], Typed | None]:
    def build(arguments: list[Typed]) -> Typed | None:
        return extreme(name, arguments) if arguments and all(part.type.is_number for part in arguments) else None

    return build


def _absolute(arguments: list[Typed]) -> Typed | None:
    (number,) = arguments
    if not number.type.is_number:
        return None
    return Typed(number.type, "function", "fabs" if number.type == REAL else "llabs", (number,))


def _integer(arguments: list[Typed]) -> Typed | None:
    return cast(arguments[0], INT) if len(arguments) == 1 and arguments[0].type.is_number else None


def _float(arguments: list[Typed]) -> Typed | None:
    return cast(arguments[0], REAL) if len(arguments) == 1 and arguments[0].type.is_number else None


def _length(arguments: list[Typed]) -> Typed | None:
    return Typed(INT, "size", parts=(arguments[0],), detail=0) if arguments[0].type.kind == "array" else None


def _search(arguments: list[Typed]) -> Typed | None:
    if len(arguments) != 2 or arguments[0].type.axes != 1 or not arguments[1].type.is_number:
        return None
    return Typed(INT, "function", "row_search", (arguments[0], cast(arguments[1], REAL)))


SPECIAL: dict[Any, Callable[[list[Typed]], Typed | None]] = {
    **{function: _real(name) for function, name in REAL_FUNCTIONS.items()},
    **{function: _class(name) for function, name in CLASSES.items()},
    **{function: _row(name) for function, name in REDUCTIONS.items()},
    builtins.min: _minmax("min"),
    builtins.max: _minmax("max"),
    builtins.abs: _absolute,
    np.abs: _absolute,
    builtins.int: _integer,
    builtins.float: _float,
    builtins.len: _length,
    np.searchsorted: _search,
}
"""Function -> what makes the expression of its arguments; None where it takes others."""
