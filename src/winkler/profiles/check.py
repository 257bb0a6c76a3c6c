"""The check of the half-angle that a conical shape is made from."""

from __future__ import annotations

import math

from winkler.errors import InvalidInput

__all__ = ["angle"]


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
