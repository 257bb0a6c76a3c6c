"""What a picture is made of: arrays with a name, a symbol and a unit, made once, whatever draws them afterwards.

Contents are SI.  A `Scale` is chosen by the range of the data, so that an axis reads 187 µm and not 0.000187 m; names,
symbols and units come from the glossary.
"""

from __future__ import annotations

import itertools
import math
import re
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array, ArrayLike
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

PREFIXES = {-18: "a", -15: "f", -12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T"}

PREFIXED = ("m", "N", "Pa", "J", "W", "s", "V", "A", "Hz", "K", "ohm", "S")
"""Units that take a prefix when they stand first and without a power: µm, kN, MN/m; but not m^2."""

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

SUPERSCRIPT = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


class Scale(NamedTuple):
    """How numbers of one unit are shown: SI value = `factor` times the shown number, in `unit`."""

    factor: float
    unit: str


def pretty_unit(unit: str) -> str:
    """Return a unit with its whole powers set as superscripts.

    Examples
    --------
    >>> pretty_unit("N/m^2"), pretty_unit("m^-3"), pretty_unit("m^1.5")
    ('N/m²', 'm⁻³', 'm^1.5')
    """
    unit = unit.replace("ohm", "Ω")
    return re.sub(r"\^(-?\d+)(?![\d.])", lambda found: found[1].translate(SUPERSCRIPT), unit)


def scale_of(unit: str | None, *contents: ArrayLike) -> Scale:
    """Return the prefix that fits the greatest of the finite numbers; degrees for radians.

    Parameters
    ----------
    unit
        Of the glossary; None counts as none.
    contents : array_like
        What is to be shown together, SI.

    Examples
    --------
    >>> scale_of("m", [0.0, 187e-6])
    Scale(factor=1e-06, unit='µm')
    """
    if not unit:
        return Scale(1.0, "")
    if unit == "rad":
        return Scale(math.pi / 180.0, "°")
    unit = re.sub(r"\^1(?![\d.])", "", unit)
    if unit == "1/Pa":  # compliances of rubber are numbers per megapascal
        least = scale_of("Pa", *(1.0 / part[part > 0.0] for part in map(_finite, contents)))
        return Scale(1.0 / least.factor, f"1/{least.unit}")
    head, slash, tail = unit.partition("/")
    if head not in PREFIXED:
        return Scale(1.0, pretty_unit(unit))
    greatest = max((float(np.max(part)) for part in map(_finite, contents) if part.size), default=0.0)
    power = 3 * math.floor(math.log10(greatest * (1.0 + 1e-9)) / 3.0) if greatest > 0.0 else 0
    power = max(min(PREFIXES), min(max(PREFIXES) if head not in ("m", "s", "K") else 0, power))
    return Scale(float(f"1e{power}"), pretty_unit(f"{PREFIXES[power]}{head}{slash}{tail}"))


def middle_scale(unit: str | None, content: ArrayLike) -> Scale:
    """Return the prefix that fits the median of the numbers: for tables and logarithmic axes.

    Examples
    --------
    >>> middle_scale("N", [1.0, 10.0, 100.0, 1e3])
    Scale(factor=1.0, unit='N')
    """
    sizes = _finite(content)
    sizes = sizes[sizes > 0.0]
    return scale_of(unit, float(np.median(sizes)) if sizes.size else 0.0)


def _finite(content: ArrayLike) -> Array:
    numbers: Array = np.abs(np.asarray(content, dtype=float)).ravel()
    return np.asarray(numbers[np.isfinite(numbers)])


def told(number: float, unit: str | None, digits: int = 4) -> str:
    """Return a number with its unit for reading.

    Examples
    --------
    >>> told(1.8662e-4, "m"), told(0.3, ""), told(2.1e11, "Pa")
    ('186.6 µm', '0.3', '210 GPa')
    >>> told(math.inf, "ohm"), told(math.nan, "")
    ('infinite', 'undefined')
    """
    if not math.isfinite(number):
        return "undefined" if math.isnan(number) else f"{'−' * (number < 0.0)}infinite"
    scale = scale_of(unit, number)
    text = f"{number / scale.factor:.{digits}g}".replace("-", "−")
    if "e" in text:
        mantissa, exponent = text.split("e")
        power = str(int(exponent.replace("−", "-"))).translate(SUPERSCRIPT)
        text = f"{mantissa}·10{power}"
    return f"{text}{'' if scale.unit == '°' else ' '}{scale.unit}".rstrip()


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


def series(owner: type[Any] | str, name: str, content: ArrayLike) -> Series:
    """Return the numbers of the field `name` of `owner`, with its entry of the glossary."""
    told_by = owner if isinstance(owner, str) else owner.__name__
    return Series(name, word(told_by, name), np.asarray(content, dtype=float))


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
