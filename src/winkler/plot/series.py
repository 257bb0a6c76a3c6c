"""Data of pictures: arrays with name, symbol and unit, independent of the drawing library.

Contents are SI.  A `Scale` is chosen by the range of the data, so that an axis reads 187 µm and not 0.000187 m; names,
symbols and units come from the glossary.
"""

from __future__ import annotations

import dataclasses
import itertools
import math
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array, ArrayLike
from winkler.values.readable import Scale, middle_scale, name_in_words, pretty_unit, scale_of, with_unit
from winkler.values.value import value
from winkler.values.vocabulary import Word, word

__all__ = [
    "Curve",
    "Scale",
    "Series",
    "common_scale",
    "headline",
    "middle_scale",
    "name_in_words",
    "places",
    "positive",
    "pretty_unit",
    "round_numbers",
    "row_of",
    "scale_of",
    "series",
    "series_of",
    "with_unit",
]

ALONG_THE_SPRINGS = Word("x", "m", "place along the line of springs")


HEADLINE_SYMBOLS = {
    "time": ("t", "s"),
    "force": ("F_N", "N"),
    "shear_force": ("F_x", "N"),
    "depth": ("d", "m"),
    "shift": ("u_x", "m"),
    "torque": ("M_z", "N m"),
    "angle": (r"\phi", "rad"),
    "radius": ("a", "m"),
}


def headline(solution: Any, *names: str) -> str:
    """Return some fields of a solution in one line: force, depth and contact radius if none are named."""
    shown = [(name, *HEADLINE_SYMBOLS[name]) for name in names or ("force", "depth", "radius")]
    return "   ".join(f"${symbol}$ = {with_unit(float(getattr(solution, name)), unit)}" for name, symbol, unit in shown)


@value
class Series:
    """Numbers of one quantity.

    Parameters
    ----------
    name
        As in the glossary.
    word
        Symbol, unit and meaning.
    content : ndarray
        SI.
    """

    name: str
    word: Word
    content: Array

    @property
    def scale(self) -> Scale:
        """The scale of these numbers."""
        return scale_of(self.word.unit, self.content)

    def label(self, scale: Scale | None = None) -> str:
        """Return the label of an axis that shows these numbers: name, symbol, unit."""
        unit = (scale or self.scale).unit
        symbol = f" ${self.word.symbol}$" if self.word.symbol else ""
        name = "place along the springs" if self.word == ALONG_THE_SPRINGS else name_in_words(self.name)
        return f"{name}{symbol}" + (f" [{unit}]" if unit else "")

    def shown(self, scale: Scale | None = None) -> Array:
        """Return the numbers in the unit of the label."""
        return np.asarray(self.content / (scale or self.scale).factor)


class Curve(NamedTuple):
    """One quantity over another."""

    along: Series
    of: Series


def series(name: str, content: ArrayLike, owner: type = object) -> Series:
    """Return numbers of the field `name`, with its shared entry of the glossary, or that of the class `owner`."""
    return Series(name, word(owner, name), np.asarray(content, dtype=float))


def series_of(item: Any, name: str) -> Series:
    """Return a field of an answer, with the words of its class."""
    return series(name, getattr(item, name), type(item))


def row_of(item: Any, name: str) -> Series:
    """Return the same of all loads in one row."""
    return series(name, np.ravel(getattr(item, name)), type(item))


def positive(one: Series) -> Series:
    """Return numbers with NaN where they are not positive: there they have no place on a logarithmic axis."""
    return dataclasses.replace(one, content=np.where(one.content > 0.0, one.content, np.nan))


def common_scale(*many: Series) -> Scale:
    """Return one scale for several series of one unit."""
    return scale_of(many[0].word.unit, *(one.content for one in many))


def places(end: float, marks: tuple[float, ...] = (), *, count: int = 240, start: float = 0.0) -> Array:
    """Return points from `start` to `end`, denser towards the marks, where curves have kinks or poles.

    Parameters
    ----------
    end : float
        [m].
    marks : tuple of float
        Points approached from both sides to about 1e-4 of an interval, but left out.
    count : int
        Approximate number.
    start : float
        [m].

    Returns
    -------
    ndarray
        Ascending, without the marks, `start` and `end` themselves.
    """
    bounds = [start, *sorted({mark for mark in marks if start < mark < end}), end]
    pieces = []
    for low, high in itertools.pairwise(bounds):
        part = max(24, round(count * (high - low) / (end - start)))
        phase = (np.arange(part) + 0.5) / part
        pieces.append(low + (high - low) * np.sin(0.5 * np.pi * phase) ** 2)
    return np.concatenate(pieces)


ROUND_STEPS = (1.0, 2.0, 2.5, 5.0, 10.0)


def round_numbers(low: float, high: float, parts: int) -> Array:
    """Return round numbers that enclose a range, divided into about `parts` intervals.

    Examples
    --------
    >>> round_numbers(0.0, 7.3, 5)
    array([0., 2., 4., 6., 8.])
    """
    least = (high - low) / parts
    power = 10.0 ** math.floor(math.log10(least))
    step = power * next((one for one in ROUND_STEPS if one * power >= least * (1.0 - 1e-12)), ROUND_STEPS[-1])
    first, last = math.floor(low / step * (1.0 + 1e-12)), math.ceil(high / step * (1.0 - 1e-12))
    return step * np.arange(first, last + 1)
