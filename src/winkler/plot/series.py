"""What a picture is made of: arrays with a name, a symbol and a unit, made once, whatever draws them afterwards.

Contents are SI.  A `Scale` is chosen by the range of the data, so that an axis reads 187 µm and not 0.000187 m; names,
symbols and units come from the glossary.
"""

from __future__ import annotations

import itertools
import math
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array, ArrayLike
from winkler.readable import Scale, middle_scale, pretty_unit, scale_of
from winkler.readable import with_unit as told
from winkler.values import value
from winkler.vocabulary import Word, word

__all__ = [
    "Curve",
    "Scale",
    "Series",
    "common_scale",
    "headline",
    "middle_scale",
    "places",
    "pretty_unit",
    "round_numbers",
    "scale_of",
    "series",
    "spoken",
    "told",
]

SPOKEN = {
    "r": "distance from the axis",
    "x": "place along the springs",
    "z": "depth below the surface",
    "von_mises": "von Mises stress",
    "radius": "contact radius",
    "gap": "equivalent profile",
    "line_load": "load of the springs",
    "max_shear": "greatest shear stress",
    "young": "Young's modulus",
    "poisson": "Poisson's ratio",
    "modulus": "effective modulus",
    "shear": "shear modulus",
}
"""Names that are spoken otherwise than they are written."""


def headline(solution: Any) -> str:
    """Return depth, force and contact radius in one line."""
    parts = [
        f"${symbol}$ = {told(float(getattr(solution, name)), unit)}"
        for name, symbol, unit in (("force", "F_N", "N"), ("depth", "d", "m"), ("radius", "a", "m"))
    ]
    return "   ".join(parts)


def spoken(name: str) -> str:
    """Return a name of the glossary as it is spoken: ``line_load`` is the load of the springs."""
    return SPOKEN.get(name, name.replace("_", " "))


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
        """The scale that fits these numbers alone."""
        return scale_of(self.word.unit, self.content)

    def label(self, scale: Scale | None = None) -> str:
        """Return the label of an axis that shows these numbers: name, symbol, unit."""
        unit = (scale or self.scale).unit
        symbol = f" ${self.word.symbol}$" if self.word.symbol else ""
        return f"{spoken(self.name)}{symbol}" + (f" [{unit}]" if unit else "")

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


def common_scale(*many: Series) -> Scale:
    """Return one scale for several series of one unit."""
    return scale_of(many[0].word.unit, *(one.content for one in many))


def places(end: float, marks: tuple[float, ...] = (), *, count: int = 240, start: float = 0.0) -> Array:
    """Return places from `start` to `end`, denser towards the marks, where curves have kinks or poles.

    Parameters
    ----------
    end : float
        [m].
    marks : tuple of float
        Places that are approached from both sides to about 1e-4 of a piece, but never met.
    count : int
        How many, about.
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
        share = max(24, round(count * (high - low) / (end - start)))
        turn = (np.arange(share) + 0.5) / share
        pieces.append(low + (high - low) * np.sin(0.5 * np.pi * turn) ** 2)
    return np.concatenate(pieces)


STEPS = (1.0, 2.0, 2.5, 5.0, 10.0)


def round_numbers(low: float, high: float, parts: int) -> Array:
    """Return round numbers that enclose a range, about so many parts apart.

    Examples
    --------
    >>> round_numbers(0.0, 7.3, 5)
    array([0., 2., 4., 6., 8.])
    """
    least = (high - low) / parts
    power = 10.0 ** math.floor(math.log10(least))
    step = power * next((one for one in STEPS if one * power >= least * (1.0 - 1e-12)), STEPS[-1])
    first, last = math.floor(low / step * (1.0 + 1e-12)), math.ceil(high / step * (1.0 - 1e-12))
    return step * np.arange(first, last + 1)
