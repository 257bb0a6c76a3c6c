r"""Truncated Taylor series: a value with its first and second derivative, and sums of powers kept as symbols.

.. math:: (uv)'' = u''v + 2u'v' + uv'', \qquad F(u)'' = F''(u)\,u'^2 + F'(u)\,u''
"""

from __future__ import annotations

import ast
import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

LARGEST_EXPONENT = 100.0  # exponent

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
SINGULAR_FUNCTIONS = frozenset({"log", "arcsin", "arccos"})


class RefusedFormula(Exception):
    """Why a formula cannot be read; `Expression` adds which formula."""


class Jet(NamedTuple):
    """A value with its first two derivatives."""

    value: Array
    first: Array
    second: Array
    singular: bool  # a root, a logarithm or a broken power is inside, from which infinities at zero may come


class TaylorSeries(NamedTuple):
    """A part of the formula at the places x: the sum of c x^p over `terms`, plus whatever else is in `rest`."""

    x: Array
    terms: Terms
    rest: Jet | None = None

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
    def jet(self) -> Jet:
        """Value and derivatives."""
        powers = Jet(*power_sum(self.terms, self.x), any(p != int(p) for _, p in self.terms))
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


def _sum(u: Jet, v: Jet) -> Jet:
    return Jet(u.value + v.value, u.first + v.first, u.second + v.second, u.singular or v.singular)


def _product(u: Jet, v: Jet) -> Jet:
    def times(a: Array, b: Array) -> Array:
        # the infinity of one root or logarithm is weaker than the zero of a smooth factor
        weak = u.singular != v.singular and (np.isinf(a) & (b == 0.0) | (a == 0.0) & np.isinf(b))
        return np.where(weak, 0.0, a * b)

    first = times(u.first, v.value) + times(u.value, v.first)
    second = times(u.second, v.value) + 2.0 * times(u.first, v.first) + times(u.value, v.second)
    return Jet(times(u.value, v.value), first, second, u.singular or v.singular)


def _chain(outer: Derivatives, inner: Jet, singular: bool) -> Jet:
    bend = outer[2] * inner.first**2
    # where F'' is infinite at a simple zero of u, it outweighs F' u'', of which nothing is known if u'' is zero
    bend = np.where(np.isinf(bend) & np.isfinite(inner.second), bend, bend + outer[1] * inner.second)
    return Jet(outer[0], outer[1] * inner.first, bend, singular or inner.singular)


def _series(x: Array, terms: Terms, rest: Jet | None = None) -> TaylorSeries:
    sums: dict[float, float] = {}
    for c, p in terms:
        sums[p] = sums.get(p, 0.0) + c
        if not math.isfinite(sums[p]):
            raise RefusedFormula("a constant part is too large to be computed")
    return TaylorSeries(x, tuple((c, p) for p, c in sorted(sums.items()) if c != 0.0), rest)


def constant(x: Array, number: float) -> TaylorSeries:
    """Return a number as a series."""
    return _series(x, ((number, 0.0),))


def _plus(a: TaylorSeries, b: TaylorSeries) -> TaylorSeries:
    rest = _sum(a.rest, b.rest) if a.rest and b.rest else a.rest or b.rest
    return _series(a.x, a.terms + b.terms, rest)


def times(a: TaylorSeries, b: TaylorSeries) -> TaylorSeries:
    """Return the product of two series."""
    one, other = (a, b) if a.single is not None else (b, a)
    if one.single is None:
        return TaylorSeries(a.x, (), _product(a.jet, b.jet))
    c, p = one.single
    rest = other.rest if c != 0.0 else None
    if rest and p == 0.0:
        rest = Jet(c * rest.value, c * rest.first, c * rest.second, rest.singular)
    elif rest:
        rest = _product(one.jet, rest)
    return _series(a.x, tuple((c * d, p + q) for d, q in other.terms), rest)


def _raised(base: TaylorSeries, exponent: TaylorSeries) -> TaylorSeries:
    n = exponent.constant
    if n is None:
        return called("exp", times(exponent, called("log", base)))
    if abs(n) > LARGEST_EXPONENT:
        raise RefusedFormula(f"the exponent {n:g} is too large; at most {LARGEST_EXPONENT:g} is allowed")
    if n == 0.0 or n == 1.0:
        return base if n == 1.0 else constant(base.x, 1.0)
    if base.single is None:
        inner = base.jet
        if n == 0.5:  # written so that sqrt((r - b)**2) has slopes of exactly 1 and -1
            root = np.sqrt(inner.value)
            first = inner.first / (2.0 * root)
            return TaylorSeries(base.x, (), Jet(root, first, (inner.second - 2.0 * first**2) / (2.0 * root), True))
        u = np.where(inner.value == 0.0, np.nan, inner.value) if n < 0.0 else inner.value
        outer = (u**n, n * u ** (n - 1.0), n * (n - 1.0) * u ** (n - 2.0))
        return TaylorSeries(base.x, (), _chain(outer, inner, n != int(n)))
    c, p = base.single
    if (c < 0.0 and n != int(n)) or (c == 0.0 and n < 0.0):
        raise RefusedFormula(f"({c:g})**{n:g} is not a real number" if c else "it divides by zero")
    try:
        return _series(base.x, ((math.sqrt(c) if n == 0.5 else c**n, p * n),))
    except OverflowError:
        raise RefusedFormula("a constant part is too large to be computed") from None


def called(name: str, inner: TaylorSeries) -> TaylorSeries:
    """Return a function of a series, by its name."""
    if name == "sqrt":
        return _raised(inner, constant(inner.x, 0.5))
    if inner.constant is None:
        jet = inner.jet
        return TaylorSeries(inner.x, (), _chain(FUNCTIONS[name](jet.value), jet, name in SINGULAR_FUNCTIONS))
    constant_value = float(FUNCTIONS[name](np.array(inner.constant))[0])
    if not math.isfinite(constant_value):
        raise RefusedFormula(f"{name}({inner.constant:g}) is not a finite, real number")
    return constant(inner.x, constant_value)


OPERATORS: dict[type[ast.operator], Callable[[TaylorSeries, TaylorSeries], TaylorSeries]] = {
    ast.Add: _plus,
    ast.Sub: lambda a, b: _plus(a, times(constant(a.x, -1.0), b)),
    ast.Mult: times,
    ast.Div: lambda a, b: times(a, _raised(b, constant(a.x, -1.0))),
    ast.Pow: _raised,
}
