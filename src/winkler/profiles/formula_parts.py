"""The parts of the formula of a profile: powers with transforms in closed form, a remainder, and its corners."""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from winkler.numerics.equations.expression import Expression
from winkler.numerics.equations.taylor import Terms
from winkler.numerics.types import Array
from winkler.profiles.power import PowerLaw
from winkler.values.checks.number_checks import FINITE, checked
from winkler.values.checks.physical_size import as_text
from winkler.values.errors import InvalidInput

ROUNDING_RATIO = 1e-12
"""What counts as zero, against the sum of the moduli of the parts of a height."""
CORNER_OFFSETS = np.array([1e-5, 1e-6, 1e-7])
"""Relative distances from a corner at which the slope beside it is read."""


@functools.lru_cache(maxsize=256)
def law_of(expression: str, constants: tuple[tuple[str, float], ...]) -> Expression:
    """Return the law that a text stands for; the same one for the same text and constants."""
    return Expression(expression, "r", constants)


@functools.lru_cache(maxsize=256)
def pure(law: Expression) -> bool:
    """Whether the formula is nothing but a sum of powers."""
    return law.remainder(np.zeros(0)) is None


@functools.lru_cache(maxsize=256)
def powers_of(law: Expression) -> Terms:
    """Return the powers that are transformed in closed form.

    The first power stays with the rest, where there is one: in (r - b) + sqrt((r - b)**2) their slopes cancel exactly.
    """
    return tuple((c, p) for c, p in law.powers if p != 0.0 and (p != 1.0 or pure(law)))


@functools.lru_cache(maxsize=256)
def stretched(law: Expression) -> Terms:
    """Return (kappa_p c, p), their transform."""
    return tuple((c * PowerLaw(1.0, p).stretch, p) for c, p in powers_of(law))


@functools.lru_cache(maxsize=256)
def _linear(law: Expression) -> float:
    return sum(c for c, p in law.powers if p == 1.0)


def rest_of(law: Expression, r: Array) -> tuple[Array, Array, Array]:
    """Return value, slope and curvature of what is beside those powers."""
    rest = law.remainder(r)
    if rest is None:
        return np.zeros(r.shape), np.zeros(r.shape), np.zeros(r.shape)
    return rest[0], rest[1] + _linear(law), rest[2]


@functools.lru_cache(maxsize=256)
def start_of(law: Expression) -> float:
    """Return the rounding error of the height at r = 0, after checking that it is one."""
    axis = np.zeros(1)
    height, slope, curvature = (float(part[0]) for part in law.taylor(axis))
    if math.isnan(height) or math.isnan(slope) or math.isnan(curvature) or math.isinf(height):
        raise InvalidInput(
            f"Formula: '{law.text}' cannot be evaluated at r = 0, where it is undetermined or infinite; rewrite it, as "
            "r*sqrt(1 + r) for sqrt(r**2 + r**3)."
        )
    if math.isinf(rest_of(law, axis)[1][0]):
        raise InvalidInput(f"Formula: '{law.text}' is infinitely steep at r = 0; give one with a finite slope there.")
    if abs(height) > ROUNDING_RATIO * float(law.magnitude(axis)[0]):
        raise InvalidInput(
            f"Formula: the height of '{law.text}' is {height:.6g} m at r = 0; a profile starts at zero, so subtract it."
        )
    return height


def last_finite(law: Expression, low: float, high: float) -> float:
    """Return where the height ceases to be finite, between a place where it is and one where it is not."""
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if np.isfinite(law.taylor([middle])[0][0]) else (low, middle)
    return low


def constants_of(owner: str, constants: Any, named: Mapping[str, float]) -> tuple[tuple[str, Any], ...]:
    """Return the constants of a formula, given as a table or as pairs, and those given by name, sorted by name."""
    try:
        table = sorted((dict(constants) | dict(named)).items())
    except (TypeError, ValueError):
        given = as_text(constants)
        raise InvalidInput(
            f"{owner}: constants is {given}; give a table of names and numbers in SI units, as {{'R': 0.01}}."
        ) from None
    return tuple((name, checked(FINITE, owner, f"the constant '{name}'", number, None)) for name, number in table)


@functools.lru_cache(maxsize=256)
def sides_of(law: Expression, corners: tuple[float, ...]) -> tuple[tuple[float, float], ...]:
    """Return the slope just below every corner, and by how much it jumps there."""
    sides = []
    for corner in corners:
        r = corner * (1.0 + np.outer((-1.0, 1.0), CORNER_OFFSETS))
        _, slope, curvature = rest_of(law, r)
        size = float(np.max(np.abs(slope)))
        below, above = (_limit(near, size) for near in slope + (corner - r) * curvature)
        if not math.isfinite(below + above):
            raise InvalidInput(
                f"Formula: the slope of '{law.text}' has no finite limit at the corner r = {corner:g} m."
            )
        sides.append((below, 0.0 if abs(above - below) <= 1e-9 * size else above - below))
    return tuple(sides)


def _limit(near: Array, size: float) -> float:
    """Return the limit of slopes read ever closer to a corner, by Aitken's rule; NaN if they run away."""
    first, second = np.diff(near)
    if abs(second) <= 1e-12 * size + 1e-15:
        return float(near[-1])
    return float(near[-1] - second**2 / (second - first)) if abs(second) < 0.9 * abs(first) else math.nan
