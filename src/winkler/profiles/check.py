"""Checks of the numbers a shape is made from, each with one sentence."""

from __future__ import annotations

import math

from winkler.errors import InvalidInput

__all__ = ["angle", "positive"]


def positive(owner: object, word: str, unit: str = "m") -> None:
    """Refuse a field that is not a positive, finite number."""
    number = getattr(owner, word)
    if isinstance(number, bool) or not isinstance(number, int | float) or not math.isfinite(number) or number <= 0.0:
        raise InvalidInput(
            f"{type(owner).__name__}: {word} is {number!r}; it must be a positive, finite number"
            + (f" in {unit}." if unit else ".")
        )


def angle(owner: object, word: str) -> None:
    """Refuse a half-angle outside (0, pi/2), or one that looks like degrees."""
    number = getattr(owner, word)
    if isinstance(number, bool) or not isinstance(number, int | float) or not 0.0 < number < 0.5 * math.pi:
        hint = ""
        if isinstance(number, int | float) and 0.5 * math.pi <= number < 90.0:
            hint = f"; if {number:g} are degrees, give math.radians({number:g})"
        raise InvalidInput(
            f"{type(owner).__name__}: {word} is {number!r} rad; measured from the axis it must lie between 0 and "
            f"pi/2{hint}."
        )
