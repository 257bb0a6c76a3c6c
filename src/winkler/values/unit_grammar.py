"""Units: a factor to SI and a dimension, read by a small grammar of names, ``* / ^`` and brackets.

Symbols of the SI with their prefixes, and a few units beside it, stand in a table here, which takes microseconds;
pint, which takes most of a second to load and has many more, resolves other names alone.  Factors are exact
fractions; those of the table after the SI brochure, 9th edition (2019), doi:10.59161/AUEZ1291.
"""

from __future__ import annotations

import functools
import re
from fractions import Fraction
from typing import Any, NamedTuple

from winkler.values.errors import InvalidInput, suggest
from winkler.values.limits import UNIT_LETTERS

LARGEST_EXPONENT = 12
"""Largest exponent of a unit."""
MOST_FACTOR_BITS = 1000
"""Most binary digits of the factor of a unit, above and below its line."""

TOKEN = re.compile(
    r"\s*+(?:(?P<name>[A-Za-z][A-Za-z_]*)|"
    r"(?P<power>(?<=[A-Za-z])-?\d+|(?:\^|\*\*)\s*+\(?\s*+-?\d+(?:\.\d+|/[1-9]\d*)?(?:\s*+\))?)|"
    r"(?P<one>1(?![\d.]))|(?P<sign>[*/()]))"
)
SPELLINGS = [
    (re.compile("[µμ](?=[A-Za-z])"), "u"),
    (re.compile("[µμ]"), "micron"),
    (re.compile("Δ°(?=[CF])"), "delta_deg"),
    (re.compile("°(?=[CF])|℃"), "deg"),
    (re.compile("°"), "deg"),
    (re.compile("[ÅÅ]"), "angstrom"),
    (re.compile("[ΩΩ]"), "ohm"),
    (re.compile("%"), "percent"),
    (re.compile("[·⋅×]"), "*"),
    (re.compile("−"), "-"),
    (re.compile(r"\b([kmunM]?N)m\b"), r"\1 m"),
    (re.compile(r"\bMsi\b"), "Mpsi"),
    (re.compile(r"\bkp\b"), "kgf"),
    (re.compile(r"(?<=[A-Za-z])\.(?=[A-Za-z])"), "*"),
]
"""Spellings in common use, and how they are read."""
POWERS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
ZERO_INSIDE = "a temperature scale with its own zero cannot be part of another unit; write K"

COMMON_UNITS = (
    *("mm", "um", "nm", "cm", "km", "kPa", "MPa", "GPa", "mN", "uN", "nN", "kN", "ms", "us", "deg", "degC", "percent"),
    *(
        prefix + name
        for name in ("m", "N", "Pa", "J", "s", "g", "K", "rad", "Hz", "W", "V", "A")
        for prefix in ("", *"kMGmunp")
    ),
    *("micron", "angstrom", "inch", "psi", "bar", "min", "hour", "eV", "dyn", "ohm", "mol"),
    *("meter", "micrometer", "nanometer", "newton", "pascal", "joule", "second", "kelvin", "degree", "radian"),
)
"""What a misspelt unit may have meant."""


class Unit(NamedTuple):
    """A factor to the SI unit, powers of the base units, and where the zero lies."""

    factor: Fraction
    dimension: tuple[tuple[str, Fraction], ...]
    offset: Fraction = Fraction(0)


BASE_UNITS = ("ampere", "kelvin", "kilogram", "meter", "mole", "radian", "second")
PREFIXES = {"T": 12, "G": 9, "M": 6, "k": 3, "c": -2, "m": -3, "u": -6, "n": -9, "p": -12, "f": -15}
"""Prefix -> power of ten."""

PREFIXED_UNITS: dict[str, tuple[str, tuple[int, ...]]] = {
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
"""Symbol -> factor, and powers of the `BASE_UNITS`."""

UNPREFIXED_UNITS: dict[str, tuple[str, tuple[int, ...]]] = {
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

SCALE_ZEROS = {"degC": Fraction("273.15")}
"""Temperature scale -> where its zero lies [K]."""


def si_unit(name: str) -> Unit | None:
    """Return the unit of one plain name, e.g. ``mm``; None if the table does not have it.

    Examples
    --------
    >>> si_unit("mm").factor, si_unit("furlong")
    (Fraction(1, 1000), None)
    """
    if name in SCALE_ZEROS:
        return si_unit("K")._replace(offset=SCALE_ZEROS[name])  # type: ignore[union-attr]
    if name in UNPREFIXED_UNITS or name in PREFIXED_UNITS:
        factor, powers = (UNPREFIXED_UNITS if name in UNPREFIXED_UNITS else PREFIXED_UNITS)[name]
        dimension = ((base, Fraction(power)) for base, power in zip(BASE_UNITS, powers, strict=True) if power)
        return Unit(Fraction(factor), tuple(dimension))
    plain = si_unit(name[1:]) if name[:1] in PREFIXES and name[1:] in PREFIXED_UNITS else None
    return plain and plain._replace(factor=plain.factor * Fraction(10) ** PREFIXES[name[0]])


class Unreadable(InvalidInput):
    """Why a unit cannot be read; the callers add which quantity."""


@functools.lru_cache(maxsize=1)
def _registry() -> Any:
    import pint

    return pint.UnitRegistry(non_int_type=Fraction, cache_folder=None)  # exact factors, no files


@functools.lru_cache(maxsize=512)
def _named(name: str) -> Unit:
    """Return the unit of one plain name, e.g. ``mm``."""
    exact = si_unit(name)
    return _named_by_pint(name) if exact is None else exact


def _named_by_pint(name: str) -> Unit:
    """Return the unit of a name that is not in the table, e.g. ``inch``: the only use of pint."""
    import pint

    try:
        quantity_of = _registry().Quantity
        zero, one = quantity_of(Fraction(0), name).to_base_units(), quantity_of(Fraction(1), name).to_base_units()
        powers = pint.util.to_units_container(one.units)
        dimension = tuple(sorted((str(base), Fraction(str(power))) for base, power in powers.items()))
        offset = Fraction(zero.magnitude)
        factor = Fraction(one.magnitude) - offset
    except (pint.PintError, AttributeError, TypeError, AssertionError, ValueError):
        if name.istitle() and len(name) > 4:
            return _named(name.lower())  # Newton, Micrometer
        same = [exact for exact in COMMON_UNITS if exact.lower() == name.lower()]
        near = f" (did you mean '{same[0]}'?)" if same else suggest(name, COMMON_UNITS)
        raise Unreadable(f"the unit '{name}' is unknown{near}") from None
    return Unit(factor, dimension, offset)


def _refuse_long(factor: Fraction, exponent: Fraction = Fraction(1)) -> None:
    """Refuse a power of a factor that no floating-point number could be multiplied by."""
    if exponent * max(factor.numerator.bit_length(), factor.denominator.bit_length()) > MOST_FACTOR_BITS:
        raise Unreadable("its size cannot be computed with")


def _power(unit: Unit, exponent: Fraction) -> Unit:
    if abs(exponent) > LARGEST_EXPONENT:
        raise Unreadable(f"the exponent {float(exponent):g} of a unit is too large")
    if unit.offset:
        raise Unreadable(ZERO_INSIDE)
    whole = exponent.denominator == 1
    _refuse_long(unit.factor, abs(exponent))
    factor = unit.factor ** int(exponent) if whole else Fraction(float(unit.factor) ** float(exponent))
    return Unit(factor, tuple((base, power * exponent) for base, power in unit.dimension if power * exponent))


def _product(left: Unit, right: Unit) -> Unit:
    if left.offset or right.offset:
        raise Unreadable(ZERO_INSIDE)
    powers = dict(left.dimension)
    for base, power in right.dimension:
        powers[base] = powers.get(base, Fraction(0)) + power
    _refuse_long(left.factor * right.factor)
    return Unit(left.factor * right.factor, tuple(sorted((base, power) for base, power in powers.items() if power)))


DIMENSIONLESS = Unit(Fraction(1), ())


def _tokens(text: str) -> list[tuple[str, str]]:
    tokens, place = [], 0
    while place < len(text):
        match = TOKEN.match(text, place)
        if match is None:
            rest = text[place:].strip()
            raise Unreadable(f"'{rest}' cannot be part of a unit; write one number, then its unit, as '2.1e5 MPa'")
        tokens.append((str(match.lastgroup), match[str(match.lastgroup)]))
        place = match.end()
    return tokens[::-1]


def _product_of(tokens: list[tuple[str, str]], depth: int = 0) -> Unit:
    """Read factors joined by ``*``, ``/`` or a space from the end of `tokens`, up to a closing bracket."""
    total, divided = DIMENSIONLESS, False
    first = bool(tokens) and tokens[-1] != ("sign", "/")
    while tokens and tokens[-1] != ("sign", ")"):
        sign = tokens.pop()[1] if not first and tokens[-1] in (("sign", "*"), ("sign", "/")) else ""
        if divided and not sign:
            raise Unreadable("it is not clear how far the / reaches; use brackets, as in mm^3/(N m)")
        first, divided = False, divided or sign == "/"
        factor = _factor(tokens, depth)
        factor = _power(factor, Fraction(-1)) if sign == "/" else factor
        total = factor if total is DIMENSIONLESS else _product(total, factor)
    return total


def _factor(tokens: list[tuple[str, str]], depth: int) -> Unit:
    kind, word = tokens.pop() if tokens else ("", "")
    if kind == "name":
        unit = _named(word)
    elif kind == "one":
        unit = DIMENSIONLESS
    elif word == "(" and depth < LARGEST_EXPONENT:
        unit = _product_of(tokens, depth + 1)
        if not tokens:
            raise Unreadable("a bracket is not closed in the unit")
        tokens.pop()
    else:
        raise Unreadable(f"'{word}' is out of place in the unit" if word else "the unit is not complete")
    if tokens and tokens[-1][0] == "power":
        return _power(unit, Fraction(tokens.pop()[1].strip("^*() ")))
    return unit


@functools.lru_cache(maxsize=512)
def unit_of(text: str) -> Unit:
    """Return the unit that a text stands for.

    Raises
    ------
    Unreadable
        With the reason, as the end of a sentence.
    """
    if len(text) > UNIT_LETTERS:
        raise Unreadable(f"it has {len(text)} characters, and a unit at most {UNIT_LETTERS}")
    text = text.translate(POWERS)
    for pattern, plain in SPELLINGS:
        text = pattern.sub(plain, text)
    tokens = _tokens(text.strip())
    unit = _product_of(tokens)
    if tokens:
        raise Unreadable("a bracket is closed in the unit that was not opened")
    return unit
