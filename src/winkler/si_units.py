"""The units that studies of contacts name: exact factors to SI, and powers of the base units.

A symbol of the SI with one of its prefixes, and a few units beside it.  Reading them here takes microseconds; pint,
which takes most of a second to load and knows many more, is asked only about names that are not in this table.
Values: the SI brochure, 9th edition (2019), doi:10.59161/AUEZ1291.
"""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

__all__ = ["Unit", "si_unit"]


class Unit(NamedTuple):
    """A factor to the SI unit, powers of the base units, and where the zero lies."""

    factor: Fraction
    dimension: tuple[tuple[str, Fraction], ...]
    offset: Fraction = Fraction(0)


BASES = ("ampere", "kelvin", "kilogram", "meter", "mole", "radian", "second")
PREFIXES = {"T": 12, "G": 9, "M": 6, "k": 3, "c": -2, "m": -3, "u": -6, "n": -9, "p": -12, "f": -15}
"""Prefix -> power of ten."""

PREFIXED: dict[str, tuple[str, tuple[int, ...]]] = {
    "m": ("1", (0, 0, 0, 1, 0, 0, 0)),
    "s": ("1", (0, 0, 0, 0, 0, 0, 1)),
    "g": ("0.001", (0, 0, 1, 0, 0, 0, 0)),
    "A": ("1", (1, 0, 0, 0, 0, 0, 0)),
    "K": ("1", (0, 1, 0, 0, 0, 0, 0)),
    "mol": ("1", (0, 0, 0, 0, 1, 0, 0)),
    "rad": ("1", (0, 0, 0, 0, 0, 1, 0)),
    "N": ("1", (0, 0, 1, 1, 0, 0, -2)),
    "Pa": ("1", (0, 0, 1, -1, 0, 0, -2)),
    "J": ("1", (0, 0, 1, 2, 0, 0, -2)),
    "W": ("1", (0, 0, 1, 2, 0, 0, -3)),
    "V": ("1", (-1, 0, 1, 2, 0, 0, -3)),
    "ohm": ("1", (-2, 0, 1, 2, 0, 0, -3)),
    "S": ("1", (2, 0, -1, -2, 0, 0, 3)),
    "Hz": ("1", (0, 0, 0, 0, 0, 0, -1)),
}
"""Symbol -> factor, and powers of the `BASES`."""

ALONE: dict[str, tuple[str, tuple[int, ...]]] = {
    "percent": ("0.01", (0, 0, 0, 0, 0, 0, 0)),
    "micron": ("1e-6", (0, 0, 0, 1, 0, 0, 0)),
    "angstrom": ("1e-10", (0, 0, 0, 1, 0, 0, 0)),
    "min": ("60", (0, 0, 0, 0, 0, 0, 1)),
    "hour": ("3600", (0, 0, 0, 0, 0, 0, 1)),
    "bar": ("100000", (0, 0, 1, -1, 0, 0, -2)),
    "deg": (
        "31415926535897932384626433832795028841971693993751/1800000000000000000000000000000000000000000000000000",
        (0, 0, 0, 0, 0, 1, 0),
    ),
    "delta_degC": ("1", (0, 1, 0, 0, 0, 0, 0)),
}
"""The same for units that take no prefix."""

ZEROS = {"degC": Fraction("273.15")}
"""Temperature scale -> where its zero lies [K]."""


def si_unit(name: str) -> Unit | None:
    """Return the unit of one plain name, e.g. ``mm``; None if the table does not have it.

    Examples
    --------
    >>> si_unit("mm").factor, si_unit("furlong")
    (Fraction(1, 1000), None)
    """
    if name in ZEROS:
        return si_unit("K")._replace(offset=ZEROS[name])  # type: ignore[union-attr]
    if name in ALONE or name in PREFIXED:
        factor, powers = (ALONE if name in ALONE else PREFIXED)[name]
        dimension = ((base, Fraction(power)) for base, power in zip(BASES, powers, strict=True) if power)
        return Unit(Fraction(factor), tuple(dimension))
    plain = si_unit(name[1:]) if name[:1] in PREFIXES and name[1:] in PREFIXED else None
    return plain and plain._replace(factor=plain.factor * Fraction(10) ** PREFIXES[name[0]])
