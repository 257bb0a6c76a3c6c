"""The scale of an axis: its ends, which follow the marks, its ticks, and the numbers at them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.plot.axis import PanelAxis
from winkler.plot.series import ROUND_STEPS

MOST_TICKS_ACROSS = 7
"""Parts of a horizontal axis; more of them with labels as long as -0.25 run into each other in a narrow panel."""
MOST_TICKS = 9
LEAST_LABELLED_SPANS = ((0.7, (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0)), (2.5, (1.0, 2.0, 5.0)))
"""Decades that an axis spans at most -> the digits labelled there; over more decades powers of ten alone."""
MOST_DECADES = 11
"""Decades of an axis above which not each of them is labelled."""
LONG, SYMBOL_WIDTH = 34, 10
"""Letters of a label beside which a panel of usual height has room, and those that a symbol and its unit take."""
NARROW = 0.8
"""Width over height of a panel with equal scales below which its horizontal axis has fewer ticks."""
MARGIN = 0.05
"""Part of the range left free at the ends of an upright axis, if none is declared."""
APART = 0.05
"""Part of a number by which an axis that holds it alone reaches beyond it."""
POWERS = (-4, 5)
"""Powers of ten from which on they stand once at the end of an axis, and not in its numbers."""
SUPERSCRIPT = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


class Side(NamedTuple):
    """An axis in its place: the shown numbers at its ends, whether it is logarithmic, where the ends lie [pt]."""

    low: float
    high: float
    log: bool
    start: float
    stop: float

    def place(self, numbers: Array | float) -> Array:
        """Return where shown numbers lie [pt]; NaN where a logarithmic axis has no place for them."""
        with np.errstate(invalid="ignore", divide="ignore"):
            along = np.log10(np.where(np.asarray(numbers) > 0.0, numbers, np.nan)) if self.log else np.asarray(numbers)
        low, high = (math.log10(end) if self.log else end for end in (self.low, self.high))
        return np.asarray(self.start + (along - low) * ((self.stop - self.start) / (high - low)))

    def at(self, places: Array | float) -> Array:
        """Return the shown numbers at places [pt]."""
        low, high = (math.log10(end) if self.log else end for end in (self.low, self.high))
        along = low + (np.asarray(places) - self.start) * ((high - low) / (self.stop - self.start))
        return np.asarray(10.0**along if self.log else along)

    @property
    def length(self) -> float:
        """Length [pt]."""
        return abs(self.stop - self.start)

    def raised(self, share: float) -> Side:
        """Return the axis with its upper end farther, so that a share of its length lies above the former one."""
        low, high = (math.log10(end) if self.log else end for end in (self.low, self.high))
        high = low + (high - low) / (1.0 - share)
        return self._replace(high=10.0**high if self.log else high)


class Ticks(NamedTuple):
    """Ticks of an axis: shown numbers, their labels, those without labels, and a power of ten that is common to all."""

    places: Array
    labels: tuple[str, ...]
    minor: Array = np.empty(0)
    power: int = 0


def side_of(one: PanelAxis, contents: Sequence[Array], fixed: Sequence[float], *, tight: bool, across: bool) -> Side:
    """Return the ends of an axis that has no place yet.

    Parameters
    ----------
    one
        The axis.
    contents
        Numbers of the marks along it [SI].
    fixed
        Those that no margin goes beyond [SI].
    tight
        Whether there is no margin unless one is declared.
    across
        Whether it is horizontal.
    """
    factor = one.scale.factor
    every = np.concatenate([np.ravel(part) for part in contents]) if contents else np.empty(0)
    every = every[np.isfinite(every) & ((every > 0.0) if one.log else True)] / factor
    low, high = _fitted(every, one.log)
    margin = (0.0 if tight or across else MARGIN) if one.margin is None else one.margin
    ends = [math.log10(end) if one.log else end for end in (low, high)]
    free = margin * (ends[1] - ends[0])
    kept = [end / factor for end in fixed]
    ends = [end if any(math.isclose(mark, was, rel_tol=1e-9, abs_tol=1e-300) for mark in kept) else end + away
            for end, was, away in zip(ends, (low, high), (-free, free), strict=True)]  # fmt: skip
    low, high = (10.0**end if one.log else end for end in ends)
    low = low if one.low is None else one.low / factor
    high = high if one.high is None else one.high / factor
    if low == high:
        low, high = _fitted(np.array([low]), one.log)
    high += one.headroom * (high - low)
    if one.ticks is not None and np.size(one.ticks):
        low, high = min(low, float(np.min(one.ticks)) / factor), max(high, float(np.max(one.ticks)) / factor)
    if one.falling and low < high:
        low, high = high, low
    return Side(low, high, one.log, 0.0, 1.0)


def _fitted(every: Array, log: bool) -> tuple[float, float]:
    """Return the least and the greatest number, apart from each other; of none a range that shows an empty axis."""
    if every.size == 0:
        return (1.0, 10.0) if log else (0.0, 1.0)
    low, high = float(np.min(every)), float(np.max(every))
    if high - low > 1e-15 * max(abs(low), abs(high)):
        return low, high
    if log:
        return low / 10.0, high * 10.0
    away = APART * abs(low) or APART
    return low - away, high + away


def ticks_of(one: PanelAxis, side: Side, size: float, *, across: bool, parts: int = 0) -> Ticks:
    """Return the ticks of an axis in its place.

    Parameters
    ----------
    one, side
        The axis.
    size
        Of the letters of its numbers [pt].
    across
        Whether it is horizontal.
    parts
        Greatest number of parts; chosen if zero.
    """
    if one.ticks is not None:
        places = np.asarray(one.ticks, dtype=float) / one.scale.factor
        return Ticks(places, one.names) if one.names else _labelled(places)
    if one.log:
        return _decades(one, side, one.parts)
    low, high = sorted((side.low, side.high))
    room = MOST_TICKS_ACROSS if across else int(np.clip(side.length // (2.0 * size), 1, MOST_TICKS))
    start = one.parts or parts or room
    for most in range(start, start + 5):
        places = round_steps(low, high, most, whole=bool(one.parts))
        if places.size > 1:  # one number alone is no scale
            break
    return _labelled(places)


def round_steps(low: float, high: float, most: int, *, whole: bool = False) -> Array:
    """Return the multiples of a round step in a range that divide it into at most so many parts.

    Examples
    --------
    >>> round_steps(0.0, 7.3, 5)
    array([0., 2., 4., 6.])
    """
    least = (high - low) / most
    power = 10.0 ** math.floor(math.log10(least))
    steps = [part * power * tens for tens in (1.0, 10.0) for part in ROUND_STEPS[:-1]]
    if whole:
        steps = [max(step, 1.0) for step in steps if max(step, 1.0) % 1.0 < 1e-9]
    step = next(step for step in steps if step >= least * (1.0 - 1e-9))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return np.asarray(step * np.arange(first, last + 1))


def levels_between(low: float, high: float, most: int) -> Array:
    """Return round levels for about so many contours, which enclose a range."""
    inner = round_steps(low, high, most + 1)
    step = inner[1] - inner[0] if inner.size > 1 else high - low
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    return np.asarray(step * np.arange(first, last + 1))


def _labelled(places: Array) -> Ticks:
    """Return ticks with their numbers, and the power of ten that is common to them."""
    greatest = float(np.max(np.abs(places))) if places.size else 0.0
    power = math.floor(math.log10(greatest) + 1e-12) if greatest > 0.0 else 0
    power = 0 if POWERS[0] < power < POWERS[1] else power
    shown = places / 10.0**power
    step = float(np.min(np.abs(np.diff(shown)))) if shown.size > 1 else abs(greatest) / 10.0**power
    digits = next((count for count in range(16) if _is_whole(shown, count, step)), 16)
    return Ticks(places, tuple(_written(f"{number:.{digits}f}") for number in shown), power=power)


def _is_whole(numbers: Array, digits: int, step: float) -> bool:
    return bool(np.all(np.abs(numbers - np.round(numbers, digits)) <= 1e-3 * step))


def _written(text: str) -> str:
    return (text.lstrip("-") if float(text) == 0.0 else text).replace("-", "−")


def digits_of_decades(low: float, high: float) -> tuple[float, ...]:
    """Return the digits that are labelled in each decade of a logarithmic axis."""
    span = math.log10(high / low)
    return next((digits for most, digits in LEAST_LABELLED_SPANS if span < most), (1.0,))


def _decades(one: PanelAxis, side: Side, parts: int) -> Ticks:
    """Return the ticks of a logarithmic axis."""
    low, high = sorted((side.low, side.high))
    digits = (1.0,) if parts else digits_of_decades(low, high)
    first, last = math.floor(math.log10(low)), math.ceil(math.log10(high))
    inside = [10.0**power for power in range(first, last + 1) if low * (1 - 1e-9) <= 10.0**power <= high * (1 + 1e-9)]
    every = max(1, -(-len(inside) // (parts or MOST_DECADES)))
    powers = range(-(-first // every) * every, last + 1, every)
    places = [digit * 10.0**power for power in (powers if every > 1 else range(first, last + 1)) for digit in digits]
    places = [place for place in places if low * (1.0 - 1e-9) <= place <= high * (1.0 + 1e-9)]
    short = one.plain and low >= 1e-4 and high < 1e6
    minor = (
        [digit * 10.0**power for power in range(first, last + 1) for digit in range(1, 10)] if every == 1 else inside
    )
    minor = [place for place in minor if low <= place <= high and not any(math.isclose(place, is_) for is_ in places)]
    return Ticks(np.array(places), tuple(_power_text(place, short) for place in places), np.array(minor))


def _power_text(number: float, short: bool) -> str:
    if short:
        return f"{number:g}"
    power = math.floor(math.log10(number) + 1e-9)
    digit = number / 10.0**power
    raised = f"10{str(power).translate(SUPERSCRIPT)}"
    return raised if abs(digit - 1.0) < 1e-9 else f"{digit:g}·{raised}"


def narrow_parts(one: PanelAxis, across: tuple[float, float], upright: tuple[float, float]) -> int:
    """Return the parts of the horizontal axis of a panel that equal scales make narrow; zero for the usual ones.

    Parameters
    ----------
    one
        The horizontal axis.
    across, upright
        Shown numbers at the ends of both.
    """
    ratio = abs((across[1] - across[0]) / (upright[1] - upright[0])) if upright[0] != upright[1] else 1.0
    if ratio < NARROW and one.ticks is None and not (one.parts or one.log):
        return max(2, round(MOST_TICKS_ACROSS * ratio / NARROW) - 1)
    return 0


def broken(title: str) -> str:
    """Return a long label of an upright axis in two lines: the second one begins with the symbol, or is one half."""
    name, dollar, symbol = title.partition(" $")
    if len(name) + min(len(symbol), SYMBOL_WIDTH) <= LONG:
        return title
    if dollar and len(name) <= LONG:
        return f"{name}\n${symbol}"
    words = name.split(" ")
    half = next(count for count in range(1, len(words) + 1) if 2 * len(" ".join(words[:count])) >= len(name))
    return "\n".join(part for part in (" ".join(words[:half]), " ".join(words[half:]) + dollar + symbol) if part)


def points_along(corners: Array) -> Array:
    """Return the corners ``(n, 2)`` of a curve and points between them, about two points of the picture apart."""
    if len(corners) < 2:
        return corners
    steps = np.diff(corners, axis=0)
    with np.errstate(invalid="ignore"):
        counts = np.clip(np.nan_to_num(np.hypot(*steps.T) / 2.0), 1.0, 1000.0).astype(int)
    start = np.repeat(np.arange(len(steps)), counts)
    part = (np.arange(len(start)) - np.repeat(np.cumsum(counts) - counts, counts)) / np.repeat(counts, counts)
    return np.concatenate([corners[start] + part[:, None] * steps[start], corners[-1:]])
