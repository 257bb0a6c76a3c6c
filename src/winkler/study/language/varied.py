"""The lines of a sweep: a key of the study, and the values it takes or the range it is drawn from."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, suggest
from winkler.values.value import value

SCALES = ("linear", "log")
"""Scales on which a range is covered evenly."""


def check_path(key: str) -> None:
    """Refuse a key that is not a path from the problem on, as one that was written without quotes."""
    if not key.startswith("problem."):
        raise InvalidInput(f"sweep: the key '{key}' does not start with 'problem.'; write its whole path in quotes.")


@value
class Axis:
    """One line of ``[sweep]``: a key of the study and the values it takes in turn.

    Parameters
    ----------
    key
        Path of the key, from ``problem`` on, with dots: ``problem.load.force``; a part of a list is named by its
        number, from zero: ``problem.bed.profile.parts.1.amplitude``.
    values
        Its values in turn: SI numbers for quantities, else the values that the key takes (a profile, a load).
    """

    key: str
    values: tuple[Any, ...]

    def __post_init__(self) -> None:
        if isinstance(self.values, np.ndarray):
            object.__setattr__(self, "values", tuple(float(number) for number in self.values.ravel()))
        check_path(self.key)
        if len(self.values) == 0:
            raise InvalidInput(f"sweep: '{self.key}' has no values; give at least one.")

    @property
    def numeric(self) -> bool:
        """Whether all values are numbers."""
        return all(isinstance(item, int | float) for item in self.values)

    def spread(self, shares: Array) -> Axis:
        """Return the axis of the values at `shares` from zero to one: every value has an equal part."""
        count = len(self.values)
        places = np.minimum((shares * count).astype(int), count - 1)
        return Axis(self.key, tuple(self.values[place] for place in places))


@value
class Range:
    """One line of ``[sweep]``: a key of the study and the range of numbers that it is drawn from.

    Parameters
    ----------
    key
        As of an `Axis`.
    start, stop
        Ends of the range, SI.
    scale
        ``linear``: every number is as likely as any other; ``log``: its logarithm is.
    """

    key: str
    start: float
    stop: float
    scale: str = "linear"

    def __post_init__(self) -> None:
        check_path(self.key)
        if not (math.isfinite(self.start) and math.isfinite(self.stop) and self.start != self.stop):
            raise InvalidInput(
                f"sweep: '{self.key}' is drawn from {self.start:g} to {self.stop:g}; give two finite numbers that "
                "differ."
            )
        if self.scale not in SCALES:
            raise InvalidInput(
                f"sweep: the scale of '{self.key}' is {self.scale!r}{suggest(str(self.scale), SCALES)}; "
                'give "linear" or "log".'
            )
        if self.scale == "log" and not self.start * self.stop > 0.0:
            raise InvalidInput(
                f"sweep: '{self.key}' has a logarithmic scale from {self.start:g} to {self.stop:g}; both ends must "
                "have one sign, not zero."
            )

    def spread(self, shares: Array) -> Axis:
        """Return the axis of the numbers at `shares` from zero to one of the range."""
        if self.scale == "log":
            numbers = self.start * (self.stop / self.start) ** shares
        else:
            numbers = self.start + (self.stop - self.start) * shares
        return Axis(self.key, tuple(numbers.tolist()))
