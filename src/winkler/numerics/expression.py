r"""Formulas of one variable: read safely, differentiated exactly.

`Expression` takes a text such as ``"r**2/(2*R) + h*(1 - cos(k*r))"`` apart by its grammar; nothing of it is ever
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
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.errors import InvalidInput, suggest
from winkler.numerics.types import Array, ArrayLike
from winkler.values import value

__all__ = ["CONSTANTS", "FUNCTIONS", "Expression", "Terms", "power_sum"]

LONGEST, DEEPEST, STEEPEST = 1000, 100, 100.0  # characters, levels within each other, exponent

Terms = tuple[tuple[float, float], ...]  # (c, p) of each power c x^p in a sum
Derivatives = tuple[Array, Array, Array]

FUNCTIONS: dict[str, Callable[[Array], Derivatives]] = {
    "sqrt": lambda u: (s := np.sqrt(u), 0.5 / s, -0.25 / (s * u)),
    "exp": lambda u: (s := np.exp(u), s, s),
    "log": lambda u: (np.log(u), 1.0 / u, -1.0 / (u * u)),
    "sin": lambda u: (s := np.sin(u), np.cos(u), -s),
    "cos": lambda u: (s := np.cos(u), -np.sin(u), -s),
    "tan": lambda u: (t := np.tan(u), s := 1.0 + t * t, 2.0 * t * s),
    "arcsin": lambda u: (np.arcsin(u), s := 1.0 / np.sqrt((1.0 - u) * (1.0 + u)), u * s**3),
    "arccos": lambda u: (np.arccos(u), s := -1.0 / np.sqrt((1.0 - u) * (1.0 + u)), u * s**3),
    "arctan": lambda u: (np.arctan(u), s := 1.0 / (1.0 + u * u), -2.0 * u * s * s),
    "sinh": lambda u: (s := np.sinh(u), np.cosh(u), s),
    "cosh": lambda u: (s := np.cosh(u), np.sinh(u), s),
    "tanh": lambda u: (t := np.tanh(u), s := np.cosh(u) ** -2.0, -2.0 * t * s),
}
"""Name -> the function and its two derivatives."""
CONSTANTS = {"pi": math.pi, "e": math.e}
SINGULAR = frozenset({"log", "arcsin", "arccos"})

KINKED = "its kink must be stated: write sqrt((...)**2), and give the radius where that vanishes among the corners"
PIECES = "it has kinks or jumps; give the pieces as profiles of their own"
REFUSED = {
    **dict.fromkeys(("abs", "fabs"), KINKED),
    **dict.fromkeys(["max", "min", "maximum", "minimum", "sign", "floor", "ceil", "round", "mod", "where"], PIECES),
    **dict.fromkeys(("asin", "acos", "atan"), "write arcsin, arccos or arctan"),
    **dict.fromkeys(("ln", "log10", "log2"), "write log, the natural logarithm"),
    "pow": "write powers with **",
}
HINTS = {
    **dict.fromkeys("^²³", "write powers with **, as r**2"),
    **dict.fromkeys("<>=!", "comparisons are not allowed; give the pieces as profiles of their own"),
    ".": "a point belongs inside a number; attributes are not allowed",
}
TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|(?P<name>[A-Za-z_]\w*)|(?P<mark>\*\*|[-+*/(),])|"
    r"(?P<other>\S))",
    re.ASCII,
)


class _Refused(Exception):
    """Why a formula cannot be read; `Expression` adds which formula."""


class _Jet(NamedTuple):
    value: Array
    first: Array
    second: Array
    singular: bool  # a root, a logarithm or a broken power is inside, from which infinities at zero may come


class _Series(NamedTuple):
    """A part of the formula at the places x: the sum of c x^p over `terms`, plus whatever else is in `rest`."""

    x: Array
    terms: Terms
    rest: _Jet | None = None

    @property
    def single(self) -> tuple[float, float] | None:
        """(c, p) if this is one power, a constant or zero."""
        if self.rest is not None or len(self.terms) > 1:
            return None
        return self.terms[0] if self.terms else (0.0, 0.0)

    @property
    def constant(self) -> float | None:
        """The number that this is, if it is one."""
        return self.single[0] if self.single and self.single[1] == 0.0 else None

    @property
    def jet(self) -> _Jet:
        """Value and derivatives."""
        powers = _Jet(*power_sum(self.terms, self.x), any(p != int(p) for _, p in self.terms))
        return _sum(powers, self.rest) if self.rest else powers


def power_sum(terms: Terms, x: Array) -> Derivatives:
    """Return the sum of c x^p over ``(c, p)`` in `terms` and its first two derivatives, for x >= 0.

    At x = 0 derivatives may be infinite; a negative power is NaN there.
    """
    total = np.zeros((3, *np.shape(x)))
    with np.errstate(all="ignore"):
        for c, p in terms:
            base = np.where(x == 0.0, np.nan, x) if p < 0.0 else x
            for order, factor in enumerate((c, c * p, c * p * (p - 1.0))):
                if factor != 0.0:
                    total[order] += factor * base ** (p - order)
    return total[0], total[1], total[2]


def _sum(u: _Jet, v: _Jet) -> _Jet:
    return _Jet(u.value + v.value, u.first + v.first, u.second + v.second, u.singular or v.singular)


def _product(u: _Jet, v: _Jet) -> _Jet:
    def times(a: Array, b: Array) -> Array:
        # the infinity of one root or logarithm is weaker than the zero of a smooth factor
        weak = u.singular != v.singular and (np.isinf(a) & (b == 0.0) | (a == 0.0) & np.isinf(b))
        return np.where(weak, 0.0, a * b)

    first = times(u.first, v.value) + times(u.value, v.first)
    second = times(u.second, v.value) + 2.0 * times(u.first, v.first) + times(u.value, v.second)
    return _Jet(times(u.value, v.value), first, second, u.singular or v.singular)


def _chain(outer: Derivatives, inner: _Jet, singular: bool) -> _Jet:
    bend = outer[2] * inner.first**2
    # where F'' is infinite at a simple zero of u, it outweighs F' u'', of which nothing is known if u'' is zero
    bend = np.where(np.isinf(bend) & np.isfinite(inner.second), bend, bend + outer[1] * inner.second)
    return _Jet(outer[0], outer[1] * inner.first, bend, singular or inner.singular)


def _series(x: Array, terms: Terms, rest: _Jet | None = None) -> _Series:
    sums: dict[float, float] = {}
    for c, p in terms:
        sums[p] = sums.get(p, 0.0) + c
        if not math.isfinite(sums[p]):
            raise _Refused("a constant part is too large to be computed")
    return _Series(x, tuple((c, p) for p, c in sorted(sums.items()) if c != 0.0), rest)


def _number(x: Array, number: float) -> _Series:
    return _series(x, ((number, 0.0),))


def _plus(a: _Series, b: _Series) -> _Series:
    rest = _sum(a.rest, b.rest) if a.rest and b.rest else a.rest or b.rest
    return _series(a.x, a.terms + b.terms, rest)


def _times(a: _Series, b: _Series) -> _Series:
    one, other = (a, b) if a.single is not None else (b, a)
    if one.single is None:
        return _Series(a.x, (), _product(a.jet, b.jet))
    c, p = one.single
    rest = other.rest if c != 0.0 else None
    if rest and p == 0.0:
        rest = _Jet(c * rest.value, c * rest.first, c * rest.second, rest.singular)
    elif rest:
        rest = _product(one.jet, rest)
    return _series(a.x, tuple((c * d, p + q) for d, q in other.terms), rest)


def _raised(base: _Series, exponent: _Series) -> _Series:
    n = exponent.constant
    if n is None:
        return _called("exp", _times(exponent, _called("log", base)))
    if abs(n) > STEEPEST:
        raise _Refused(f"the exponent {n:g} is too large; at most {STEEPEST:g} is allowed")
    if n == 0.0 or n == 1.0:
        return base if n == 1.0 else _number(base.x, 1.0)
    if base.single is None:
        inner = base.jet
        if n == 0.5:  # written so that sqrt((r - b)**2) has slopes of exactly 1 and -1
            root = np.sqrt(inner.value)
            first = inner.first / (2.0 * root)
            return _Series(base.x, (), _Jet(root, first, (inner.second - 2.0 * first**2) / (2.0 * root), True))
        u = np.where(inner.value == 0.0, np.nan, inner.value) if n < 0.0 else inner.value
        outer = (u**n, n * u ** (n - 1.0), n * (n - 1.0) * u ** (n - 2.0))
        return _Series(base.x, (), _chain(outer, inner, n != int(n)))
    c, p = base.single
    if (c < 0.0 and n != int(n)) or (c == 0.0 and n < 0.0):
        raise _Refused(f"({c:g})**{n:g} is not a real number" if c else "it divides by zero")
    try:
        return _series(base.x, ((math.sqrt(c) if n == 0.5 else c**n, p * n),))
    except OverflowError:
        raise _Refused("a constant part is too large to be computed") from None


def _called(name: str, inner: _Series) -> _Series:
    if name == "sqrt":
        return _raised(inner, _number(inner.x, 0.5))
    if inner.constant is None:
        jet = inner.jet
        return _Series(inner.x, (), _chain(FUNCTIONS[name](jet.value), jet, name in SINGULAR))
    known = float(FUNCTIONS[name](np.array(inner.constant))[0])
    if not math.isfinite(known):
        raise _Refused(f"{name}({inner.constant:g}) is not a finite, real number")
    return _number(inner.x, known)


OPERATORS: dict[type[ast.operator], Callable[[_Series, _Series], _Series]] = {
    ast.Add: _plus,
    ast.Sub: lambda a, b: _plus(a, _times(_number(a.x, -1.0), b)),
    ast.Mult: _times,
    ast.Div: lambda a, b: _times(a, _raised(b, _number(a.x, -1.0))),
    ast.Pow: _raised,
}


def _tokens(text: str) -> list[str]:
    """Return the numbers (as the floats they are), names and marks of `text`."""
    words: list[str] = []
    before = last = ""
    for match in TOKEN.finditer(text):
        kind = str(match.lastgroup)
        word = match[kind]
        if kind == "other":
            raise _Refused(HINTS.get(word, f"the character {word!r} is not allowed; operators are + - * / **"))
        if keyword.iskeyword(word):
            raise _Refused(f"'{word}' is a reserved word; conditions are not allowed, and constants need other names")
        if before in ("number", "name", ")") and (kind != "mark" or (word == "(" and before != "name")):
            raise _Refused(f"an operator is missing between '{last}' and '{word}'")
        if kind == "number" and not math.isfinite(float(word)):
            raise _Refused(f"{word} is too large a number")
        words.append(repr(float(word)) if kind == "number" else word)
        before, last = word if word == ")" else kind, word
    return words


@functools.lru_cache(maxsize=256)
def _tree(text: str) -> ast.expr:
    words = _tokens(text)
    if not words:
        raise _Refused("it is empty; write it in terms of the variable, as r**2/(2*R)")
    try:
        return ast.parse(" ".join(words), mode="eval").body
    except (SyntaxError, RecursionError, MemoryError):
        raise _Refused("its operators, brackets and numbers do not fit together") from None


class _Walk(NamedTuple):
    """Evaluates a syntax tree at the places x of the variable."""

    variable: str
    numbers: dict[str, float]
    x: Array

    def node(self, tree: ast.expr, depth: int = 0) -> _Series:
        if depth > DEEPEST:
            raise _Refused(f"it is nested more than {DEEPEST} deep; write it more simply")
        match tree:
            case ast.Constant(value=float() as number):
                return _number(self.x, number)
            case ast.Name(id=name):
                return self.named(name)
            case ast.UnaryOp(op=ast.UAdd() | ast.USub() as sign, operand=inner):
                one = _number(self.x, -1.0 if isinstance(sign, ast.USub) else 1.0)
                return _times(one, self.node(inner, depth + 1))
            case ast.BinOp(left=left, op=sign, right=right):
                return OPERATORS[type(sign)](self.node(left, depth + 1), self.node(right, depth + 1))
            case ast.Call(func=ast.Name(id=name), args=arguments):
                if len(arguments) == 1 and name in FUNCTIONS and not isinstance(arguments[0], ast.Starred):
                    return _called(name, self.node(arguments[0], depth + 1))
                raise _Refused(self.misused(name))
        raise _Refused("a comma or a bracket is out of place; decimal numbers take a point, as 2.5")

    def magnitude(self, tree: ast.expr) -> Array:
        match tree:
            case ast.BinOp(left=left, op=ast.Add() | ast.Sub(), right=right):
                return self.magnitude(left) + self.magnitude(right)
            case ast.BinOp(left=left, op=ast.Mult(), right=right):
                return self.magnitude(left) * self.magnitude(right)
            case ast.BinOp(left=left, op=ast.Div(), right=right):
                return self.magnitude(left) / np.abs(self.node(right).jet.value)
        return np.abs(self.node(tree).jet.value)

    def named(self, name: str) -> _Series:
        if name == self.variable:
            return _Series(self.x, ((1.0, 1.0),))
        if name in self.numbers:
            return _number(self.x, self.numbers[name])
        if name in FUNCTIONS:
            raise _Refused(self.misused(name))
        known = [self.variable, *self.numbers]
        raise _Refused(f"the name '{name}' is unknown{suggest(name, known)}; known are {', '.join(known)}")

    def misused(self, name: str) -> str:
        if name in FUNCTIONS:
            return f"{name} takes one argument; write {name}(...)"
        if name == self.variable or name in self.numbers:
            return f"'{name}' is not a function; write {name}*(...)"
        unknown = f"the function is unknown{suggest(name, FUNCTIONS)}; known are {', '.join(FUNCTIONS)}"
        return f"{name}(...) is not allowed: {REFUSED.get(name, unknown)}"


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

    text: str
    variable: str = "r"
    constants: tuple[tuple[str, float], ...] = ()

    def __post_init__(self) -> None:
        if not isinstance(self.text, str):
            raise InvalidInput(f"a formula is a text, as 'r**2/(2*R)', not {self.text!r}.")
        if len(self.text) > LONGEST:
            raise InvalidInput(f"a formula of {len(self.text)} characters is too long; at most {LONGEST} are allowed.")
        for name, number in self.constants:
            self._check(name, number)
        self._at(np.zeros(0))
        met = {node.id for node in ast.walk(_tree(self.text)) if isinstance(node, ast.Name)}
        for name in [name for name, _ in self.constants if name not in met]:
            near = suggest(name, met - FUNCTIONS.keys())
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

    def _walk(self, x: Array) -> _Walk:
        return _Walk(self.variable, CONSTANTS | {name: float(number) for name, number in self.constants}, x)

    def _at(self, x: Array) -> _Series:
        try:
            with np.errstate(all="ignore"):
                return self._walk(x).node(_tree(self.text))
        except _Refused as reason:
            raise InvalidInput(f"the formula {self.text[:60]!r}: {reason}.") from None

    def taylor(self, at: ArrayLike) -> Derivatives:
        """Return the value and the first and second derivative for every place in `at`, NaN where undefined.

        Raises
        ------
        InvalidInput
            If a place is negative.
        """
        x = np.asarray(at, dtype=float)
        if np.any(x < 0.0):
            raise InvalidInput(
                f"the formula {self.text[:60]!r} is asked at {self.variable} = {np.min(x):g}, below zero."
            )
        with np.errstate(all="ignore"):
            return self._at(x).jet[:3]

    def magnitude(self, at: ArrayLike) -> Array:
        """Return the value with all differences taken as sums: against it the value's rounding is small."""
        with np.errstate(all="ignore"):
            return self._walk(np.asarray(at, dtype=float)).magnitude(_tree(self.text))

    @property
    def powers(self) -> Terms:
        """(c, p) of every power, if the formula is nothing but a sum of c x^p; otherwise empty."""
        series = self._at(np.zeros(0))
        return series.terms if series.rest is None else ()
