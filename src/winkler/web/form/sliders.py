"""Range of the slider beside a number: a decade to either side, or a natural range."""

from __future__ import annotations

import math
import re
from typing import NamedTuple

STEPS = 100
"""Steps of a slider to either side of its middle."""

BOUNDS = {"poisson": {"": (0.0, 0.49)}, "half_angle": {"deg": (5.0, 85.0), "°": (5.0, 85.0), "rad": (0.1, 1.5)}}
"""Key -> unit -> range, of quantities that have a natural one."""

NUMBER = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*+([^,]*)")


class Span(NamedTuple):
    """The range of a slider, whose places are -STEPS to STEPS.

    Parameters
    ----------
    low, high
        Numbers at its ends.
    unit
        Of the numbers, as typed; unchanged by the slider.
    even
        Whether its steps are equal differences, not equal ratios.
    """

    low: float
    high: float
    unit: str
    even: bool

    def number(self, place: float) -> float:
        """Return the number at a place, in four digits."""
        share = 0.5 * (place / STEPS + 1.0)
        if self.even:
            return float(f"{self.low + share * (self.high - self.low):.4g}")
        return float(f"{self.low * (self.high / self.low) ** share:.4g}")

    def place(self, number: float) -> int:
        """Return the place of a number."""
        if self.even:
            share = (number - self.low) / (self.high - self.low)
        else:
            share = math.log(number / self.low) / math.log(self.high / self.low)
        return round(STEPS * (2.0 * min(max(share, 0.0), 1.0) - 1.0))

    def text(self, place: float) -> str:
        """Return the content of the field for a position of the slider.

        Examples
        --------
        >>> Span(10.0, 1000.0, "N", False).text(50)
        '316.2 N'
        """
        return f"{self.number(place):.15g} {self.unit}".rstrip()


def span_of(name: str, text: str) -> tuple[Span, int] | None:
    """Return the range of the slider beside a field, and its place; None for a content without a slider.

    Parameters
    ----------
    name
        The key.
    text
        Content of the field.

    Examples
    --------
    >>> span_of("force", "100 N")
    (Span(low=10.0, high=1000.0, unit='N', even=False), 0)
    """
    match = NUMBER.fullmatch(text)
    if match is None:
        return None
    number, unit = float(match[1]), match[2].strip()
    if not math.isfinite(number) or number == 0.0:
        return None
    low, high = BOUNDS.get(name, {}).get(unit, (0.0, 0.0))
    if low <= number <= high and high > low:
        span = Span(low, high, unit, True)
    else:
        span = Span(0.1 * number, 10.0 * number, unit, False)
    return span, span.place(number)
