r"""Formulas of one variable: read safely, differentiated exactly.

`Expression` parses a text such as ``"r**2/(2*R) + h*(1 - cos(k*r))"`` by its grammar; nothing of it is ever
executed.  It is evaluated with truncated Taylor series (value, first and second derivative travel together):

.. math:: (uv)'' = u''v + 2u'v' + uv'', \qquad F(u)'' = F''(u)\,u'^2 + F'(u)\,u''

Sums of powers of the variable stay symbols: as it is never negative, ``sqrt(r**2)`` is r, and ``r**1.5`` has slope
zero and infinite curvature at r = 0.  There ``r**2*log(r)`` vanishes; what stays undetermined, as ``sin(r)/r``, is NaN.
"""

from __future__ import annotations

import ast
import functools
import keyword
import math
import re
from typing import Annotated, NamedTuple

import numpy as np

from winkler.numerics.equations.taylor import (
    FUNCTIONS,
    OPERATORS,
    Derivatives,
    RefusedFormula,
    TaylorSeries,
    Terms,
    called,
    constant,
    times,
)
from winkler.numerics.types import Array, ArrayLike
from winkler.values.checks.number_checks import Advice
from winkler.values.errors import InvalidInput, suggest
from winkler.values.value import value

MOST_CHARACTERS, MOST_LEVELS = 1000, 100  # characters, levels within each other

CONSTANTS = {"pi": math.pi, "e": math.e}

KINK_REFUSAL = (
    "its kink must be stated: write sqrt((...)**2), and give the radius where that vanishes among the corners"
)
PIECES_REFUSAL = "it has kinks or jumps; give the pieces as profiles of their own"
REFUSED_FUNCTIONS = {
    **dict.fromkeys(("abs", "fabs"), KINK_REFUSAL),
    **dict.fromkeys(
        ["max", "min", "maximum", "minimum", "sign", "floor", "ceil", "round", "mod", "where"], PIECES_REFUSAL
    ),
    **dict.fromkeys(("asin", "acos", "atan"), "write arcsin, arccos or arctan"),
    **dict.fromkeys(("ln", "log10", "log2"), "write log, the natural logarithm"),
    "pow": "write powers with **",
}
SPELLING_HINTS = {
    **dict.fromkeys("^²³", "write powers with **, as r**2"),
    **dict.fromkeys("<>=!", "comparisons are not allowed; give the pieces as profiles of their own"),
    ".": "a point belongs inside a number; attributes are not allowed",
}
TOKEN = re.compile(
    r"(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|(?P<name>[A-Za-z_]\w*)|(?P<mark>\*\*|[-+*/(),])|"
    r"(?P<other>\S)",
    re.ASCII,
)


def _tokens(text: str) -> list[str]:
    """Return the numbers (as the floats they are), names and marks of `text`."""
    words: list[str] = []
    before = last = ""
    for match in TOKEN.finditer(text):
        kind = str(match.lastgroup)
        word = match[kind]
        if kind == "other":
            raise RefusedFormula(
                SPELLING_HINTS.get(word, f"the character {word!r} is not allowed; operators are + - * / **")
            )
        if keyword.iskeyword(word):
            raise RefusedFormula(
                f"'{word}' is a reserved word; conditions are not allowed, and constants need other names"
            )
        if before in ("number", "name", ")") and (kind != "mark" or (word == "(" and before != "name")):
            raise RefusedFormula(f"an operator is missing between '{last}' and '{word}'")
        if kind == "number" and not math.isfinite(float(word)):
            raise RefusedFormula(f"{word} is too large a number")
        words.append(repr(float(word)) if kind == "number" else word)
        before, last = word if word == ")" else kind, word
    return words


@functools.lru_cache(maxsize=256)
def _tree(text: str) -> ast.expr:
    words = _tokens(text)
    if not words:
        raise RefusedFormula("it is empty; write it in terms of the variable, as r**2/(2*R)")
    try:
        return ast.parse(" ".join(words), mode="eval").body
    except (SyntaxError, RecursionError, MemoryError):
        raise RefusedFormula("its operators, brackets and numbers do not fit together") from None


class _TreeEvaluator(NamedTuple):
    """Evaluates a syntax tree at the places x of the variable."""

    variable: str
    numbers: dict[str, float]
    x: Array

    def node(self, tree: ast.expr, depth: int = 0) -> TaylorSeries:
        if depth > MOST_LEVELS:
            raise RefusedFormula(f"it is nested more than {MOST_LEVELS} deep; write it more simply")
        match tree:
            case ast.Constant(value=float() as number):
                return constant(self.x, number)
            case ast.Name(id=name):
                return self.named(name)
            case ast.UnaryOp(op=ast.UAdd() | ast.USub() as sign, operand=inner):
                one = constant(self.x, -1.0 if isinstance(sign, ast.USub) else 1.0)
                return times(one, self.node(inner, depth + 1))
            case ast.BinOp(left=left, op=sign, right=right):
                return OPERATORS[type(sign)](self.node(left, depth + 1), self.node(right, depth + 1))
            case ast.Call(func=ast.Name(id=name), args=arguments):
                if len(arguments) == 1 and name in FUNCTIONS and not isinstance(arguments[0], ast.Starred):
                    return called(name, self.node(arguments[0], depth + 1))
                raise RefusedFormula(self.misused(name))
        raise RefusedFormula(
            "a comma or a bracket is out of place; write decimals with a point, as 2.5, thousands without, as 2500"
        )

    def magnitude(self, tree: ast.expr) -> Array:
        match tree:
            case ast.BinOp(left=left, op=ast.Add() | ast.Sub(), right=right):
                return self.magnitude(left) + self.magnitude(right)
            case ast.BinOp(left=left, op=ast.Mult(), right=right):
                return self.magnitude(left) * self.magnitude(right)
            case ast.BinOp(left=left, op=ast.Div(), right=right):
                return self.magnitude(left) / np.abs(self.node(right).jet.value)
        return np.abs(self.node(tree).jet.value)

    def named(self, name: str) -> TaylorSeries:
        if name == self.variable:
            return TaylorSeries(self.x, ((1.0, 1.0),))
        if name in self.numbers:
            return constant(self.x, self.numbers[name])
        if name in FUNCTIONS:
            raise RefusedFormula(self.misused(name))
        names = [self.variable, *self.numbers]
        raise RefusedFormula(f"the name '{name}' is unknown{suggest(name, names)}; known are {', '.join(names)}")

    def misused(self, name: str) -> str:
        if name in FUNCTIONS:
            return f"{name} takes one argument; write {name}(...)"
        if name == self.variable or name in self.numbers:
            return f"'{name}' is not a function; write {name}*(...)"
        unknown = f"the function is unknown{suggest(name, FUNCTIONS)}; known are {', '.join(FUNCTIONS)}"
        return f"{name}(...) is not allowed: {REFUSED_FUNCTIONS.get(name, unknown)}"


@value
class Expression:
    """A formula of one variable that is zero or positive.

    Parameters
    ----------
    text : str
        At most 1000 characters: numbers, names, ``+ - * / **``, round brackets, the constants pi and e, and the
        functions sqrt exp log sin cos tan arcsin arccos arctan sinh cosh tanh.
    variable : str, optional
        Name of the variable.
    constants : tuple of (name, number), optional
        What the other names stand for; each must occur.

    Raises
    ------
    InvalidInput
        If the text is no such formula, or a constant cannot be one or does not occur in it.

    Examples
    --------
    >>> height, slope, curvature = Expression("r**2/(2*R)", constants=(("R", 0.5),)).taylor([3.0])
    >>> float(height[0]), float(slope[0]), float(curvature[0])
    (9.0, 6.0, 2.0)
    """

    text: Annotated[str, Advice("a formula such as 'r**2/(2*R)'")]
    variable: str = "r"
    constants: tuple[tuple[str, float], ...] = ()

    def __post_init__(self) -> None:
        if len(self.text) > MOST_CHARACTERS:
            raise InvalidInput(
                f"a formula of {len(self.text)} characters is too long; at most {MOST_CHARACTERS} are allowed."
            )
        for name, number in self.constants:
            self._check(name, number)
        self._at(np.zeros(0))
        named = {node.id for node in ast.walk(_tree(self.text)) if isinstance(node, ast.Name)}
        for name in [name for name, _ in self.constants if name not in named]:
            near = suggest(name, named - FUNCTIONS.keys())
            raise InvalidInput(f"the formula {self.text[:60]!r}: the constant '{name}' does not occur in it{near}.")

    def _check(self, name: str, number: object) -> None:
        usual = re.fullmatch(r"[A-Za-z_]\w*", name, re.ASCII) and not keyword.iskeyword(name)
        if not usual or name in (self.variable, *FUNCTIONS, *CONSTANTS):
            raise InvalidInput(
                f"a constant of a formula cannot be called '{name}'; use letters, digits and _, but none of the names "
                f"{', '.join((self.variable, *CONSTANTS, *FUNCTIONS))}."
            )
        if isinstance(number, bool) or not isinstance(number, int | float) or not math.isfinite(number):
            raise InvalidInput(f"the constant '{name}' of a formula is {number!r}; give a finite number.")

    def _evaluator(self, x: Array) -> _TreeEvaluator:
        return _TreeEvaluator(self.variable, CONSTANTS | {name: float(number) for name, number in self.constants}, x)

    def _at(self, x: Array) -> TaylorSeries:
        if np.any(x < 0.0):
            place = f"{self.variable} = {np.min(x):g}"
            raise InvalidInput(f"the formula {self.text[:60]!r} is evaluated at {place}, below zero.")
        try:
            with np.errstate(all="ignore"):
                return self._evaluator(x).node(_tree(self.text))
        except RefusedFormula as reason:
            raise InvalidInput(f"the formula {self.text[:60]!r}: {reason}.") from None

    def taylor(self, at: ArrayLike) -> Derivatives:
        """Return the value and the first and second derivative for every place in `at`, NaN where undefined."""
        with np.errstate(all="ignore"):
            return self._at(np.asarray(at, dtype=float)).jet[:3]

    def magnitude(self, at: ArrayLike) -> Array:
        """Return the value with all differences taken as sums: against it the value's rounding is small."""
        with np.errstate(all="ignore"):
            return self._evaluator(np.asarray(at, dtype=float)).magnitude(_tree(self.text))

    @property
    def powers(self) -> Terms:
        """(c, p) of every power c x^p that the formula adds up, alone or beside other addends."""
        return self._at(np.zeros(0)).terms

    def remainder(self, at: ArrayLike) -> Derivatives | None:
        """Return what `taylor` returns, of what the formula holds beside its powers; None if there is nothing."""
        rest = self._at(np.asarray(at, dtype=float)).rest
        return rest[:3] if rest else None
