"""Numbers with units, as people write them: ``"10 mm"`` becomes 0.01, and 0.01 becomes ``"10 mm"``.

Used only at the doors (study files, command line, tables, forms); inside, everything is SI.  A text is taken apart
here: the number is read as an exact decimal, the unit by a small grammar (names, ``* / ^``, brackets), and pint is
asked about single names only.  Factors are exact fractions, so that ``3 nm`` is the float nearest to 3e-9, and what
`format_quantity` writes is read back to the same float.
"""

from __future__ import annotations

import functools
import math
import re
from decimal import Decimal
from fractions import Fraction
from typing import Any, NamedTuple

from winkler.errors import InvalidInput, suggest

__all__ = ["format_quantity", "quantity", "scale", "to_si"]

LONGEST = 100
"""Most characters of a quantity."""
STEEPEST = 12
"""Largest exponent of a unit."""

QUANTITY = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*)", re.ASCII)
TOKEN = re.compile(
    r"\s*(?:(?P<name>[A-Za-z][A-Za-z_]*)|(?P<power>(?<=[A-Za-z])-?\d+|(?:\^|\*\*)\s*\(?\s*-?\d+(?:\.\d+|/[1-9]\d*)?\s*\)?)|"
    r"(?P<one>1(?![\d.]))|(?P<sign>[*/()]))"
)
SPELLINGS = [
    (re.compile("[µμ](?=[A-Za-z])"), "u"),
    (re.compile("[µμ]"), "micron"),
    (re.compile("°(?=[CF])|℃"), "deg"),
    (re.compile("°"), "deg"),
    (re.compile("[ÅÅ]"), "angstrom"),
    (re.compile("[ΩΩ]"), "ohm"),
    (re.compile("%"), "percent"),
    (re.compile("[·⋅×]"), "*"),
    (re.compile("−"), "-"),
    (re.compile(r"\b([kmunM]?N)m\b"), r"\1 m"),
    (re.compile(r"(?<=[A-Za-z])\.(?=[A-Za-z])"), "*"),
]
"""What people write, and how it is read."""
POWERS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
ZERO_INSIDE = "a temperature scale with its own zero cannot be part of another unit; write K"

KINDS = (
    ("", "a plain number", "0.3"),
    ("m", "a length", "10 mm"),
    ("N", "a force", "5 mN"),
    ("Pa", "a pressure or modulus", "210 GPa"),
    ("rad", "an angle", "30 deg"),
    ("s", "a time", "2 ms"),
    ("kg", "a mass", "2 g"),
    ("K", "a temperature", "300 K"),
    ("m/s", "a speed", "1 mm/s"),
    ("N/m", "a force per length or energy per area", "50 mJ/m^2"),
    ("J", "an energy or torque", "1 uJ"),
    ("W", "a power", "1 mW"),
    ("m^2", "an area", "1 mm^2"),
    ("m^3", "a volume", "1 mm^3"),
    ("1/s", "a frequency", "50 Hz"),
    ("1/m", "an inverse length", "1 1/mm"),
    ("1/Pa", "an inverse pressure", "1e-14 1/Pa"),
    ("V", "a voltage", "20 mV"),
    ("A", "a current", "5 A"),
    ("ohm", "a resistance", "1 mohm"),
    ("ohm m", "a resistivity", "16 nohm m"),
    ("W/(m K)", "a thermal conductivity", "45 W/(m K)"),
)
"""Unit, what it measures, and how such a quantity is written."""
COMMON = (
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

PREFIXED = re.compile(r"(m|N|Pa|J|W|Hz|s|V|A)(?:\^([23]))?(?![\w^])(.*)")
LARGEST = {"m": 3, "s": 0}
PREFIXES = ((9, "G"), (6, "M"), (3, "k"), (0, ""), (-3, "m"), (-6, "u"), (-9, "n"), (-12, "p"))


class _Unit(NamedTuple):
    factor: Fraction
    dimension: tuple[tuple[str, Fraction], ...]
    offset: Fraction = Fraction(0)


class _Unreadable(InvalidInput):
    """Why a unit cannot be read; the callers add which quantity."""


@functools.lru_cache(maxsize=1)
def _registry() -> Any:
    import pint

    return pint.UnitRegistry(non_int_type=Fraction, cache_folder=None)  # exact factors, no files


@functools.lru_cache(maxsize=512)
def _named(name: str) -> _Unit:
    """Return the unit of one plain name, e.g. ``mm``: the only question that pint is asked."""
    import pint

    try:
        ask = _registry().Quantity
        zero, one = ask(Fraction(0), name).to_base_units(), ask(Fraction(1), name).to_base_units()
        powers = pint.util.to_units_container(one.units)
        dimension = tuple(sorted((str(base), Fraction(str(power))) for base, power in powers.items()))
        offset = Fraction(zero.magnitude)
        factor = Fraction(one.magnitude) - offset
    except (pint.PintError, AttributeError, TypeError, AssertionError, ValueError):
        if name.istitle() and len(name) > 4:
            return _named(name.lower())  # Newton, Micrometer
        same = [known for known in COMMON if known.lower() == name.lower()]
        near = f" (did you mean '{same[0]}'?)" if same else suggest(name, COMMON)
        raise _Unreadable(f"the unit '{name}' is unknown{near}") from None
    return _Unit(factor, dimension, offset)


def _power(unit: _Unit, exponent: Fraction) -> _Unit:
    if abs(exponent) > STEEPEST:
        raise _Unreadable(f"the exponent {float(exponent):g} of a unit is too large")
    if unit.offset:
        raise _Unreadable(ZERO_INSIDE)
    whole = exponent.denominator == 1
    factor = unit.factor ** int(exponent) if whole else Fraction(float(unit.factor) ** float(exponent))
    return _Unit(factor, tuple((base, power * exponent) for base, power in unit.dimension if power * exponent))


def _product(left: _Unit, right: _Unit) -> _Unit:
    if left.offset or right.offset:
        raise _Unreadable(ZERO_INSIDE)
    powers = dict(left.dimension)
    for base, power in right.dimension:
        powers[base] = powers.get(base, Fraction(0)) + power
    return _Unit(left.factor * right.factor, tuple(sorted((base, power) for base, power in powers.items() if power)))


ONE = _Unit(Fraction(1), ())


def _tokens(text: str) -> list[tuple[str, str]]:
    tokens, place = [], 0
    while place < len(text):
        match = TOKEN.match(text, place)
        if match is None:
            raise _Unreadable(f"'{text[place:].strip()}' cannot be part of a unit")
        tokens.append((str(match.lastgroup), match[str(match.lastgroup)]))
        place = match.end()
    return tokens[::-1]


def _product_of(tokens: list[tuple[str, str]], depth: int = 0) -> _Unit:
    """Read factors joined by ``*``, ``/`` or a space from the end of `tokens`, up to a closing bracket."""
    total, divided = ONE, False
    first = bool(tokens) and tokens[-1] != ("sign", "/")
    while tokens and tokens[-1] != ("sign", ")"):
        sign = tokens.pop()[1] if not first and tokens[-1] in (("sign", "*"), ("sign", "/")) else ""
        if divided and not sign:
            raise _Unreadable("it is not clear how far the / reaches; use brackets, as in mm^3/(N m)")
        first, divided = False, divided or sign == "/"
        factor = _factor(tokens, depth)
        factor = _power(factor, Fraction(-1)) if sign == "/" else factor
        total = factor if total is ONE else _product(total, factor)
    return total


def _factor(tokens: list[tuple[str, str]], depth: int) -> _Unit:
    kind, word = tokens.pop() if tokens else ("", "")
    if kind == "name":
        unit = _named(word)
    elif kind == "one":
        unit = ONE
    elif word == "(" and depth < STEEPEST:
        unit = _product_of(tokens, depth + 1)
        if not tokens:
            raise _Unreadable("a bracket is not closed in the unit")
        tokens.pop()
    else:
        raise _Unreadable(f"'{word}' is out of place in the unit" if word else "the unit is not complete")
    if tokens and tokens[-1][0] == "power":
        return _power(unit, Fraction(tokens.pop()[1].strip("^*() ")))
    return unit


@functools.lru_cache(maxsize=512)
def _unit(text: str) -> _Unit:
    text = text.translate(POWERS)
    for pattern, plain in SPELLINGS:
        text = pattern.sub(plain, text)
    tokens = _tokens(text.strip())
    unit = _product_of(tokens)
    if tokens:
        raise _Unreadable("a bracket is closed in the unit that was not opened")
    return unit


@functools.lru_cache(maxsize=1)
def _kinds() -> dict[tuple[tuple[str, Fraction], ...], tuple[str, str]]:
    return {_unit(unit).dimension: (name, example) for unit, name, example in KINDS}


def _kind(unit: str) -> tuple[str, str]:
    """Return what a unit measures, and how such a quantity is written."""
    return _kinds().get(_unit(unit).dimension, (f"a quantity in {unit}", f"1 {unit}"))


def _read(text: str, what: str) -> tuple[Fraction, _Unit, str]:
    """Return the number, the unit and the unit's text of a quantity."""
    if len(text) > LONGEST:
        raise InvalidInput(
            f"{what}: '{text[:20]}...' is too long for a quantity; at most {LONGEST} characters are read."
        )
    plain = text.translate(POWERS).replace("−", "-").strip()
    if "," in plain:
        point = plain.replace(",", "." if plain.count(",") == 1 and "." not in plain else "")
        raise InvalidInput(
            f"{what}: '{text}' has a comma; write decimals with a point and thousands without, as '{point}'."
        )
    match = QUANTITY.fullmatch(plain)
    if match is None:
        if re.match(r"[+-]?(nan|inf)", plain, re.IGNORECASE):
            raise InvalidInput(f"{what}: '{text}' is not a finite number; give one, or leave the key out.")
        raise InvalidInput(f"{what}: '{text}' does not start with a number; write number and unit, as '10 mm'.")
    size = abs(float(match[1]))
    if size == math.inf or (size == 0.0 and re.match(r"[^eE]*[1-9]", match[1])):
        raise InvalidInput(f"{what}: the number in '{text}' is too {'large' if size else 'small'} to be computed with.")
    try:
        return Fraction(match[1]), _unit(match[2]), match[2]
    except _Unreadable as reason:
        raise InvalidInput(f"{what}: '{text}' cannot be read: {reason}.") from None


def _float(number: Fraction, unit: _Unit, text: str, what: str) -> float:
    if unit == _unit("deg"):
        return math.radians(float(number))  # as everybody else computes it
    try:
        return float(number * unit.factor + unit.offset)
    except OverflowError:
        raise InvalidInput(f"{what}: '{text}' is too large to be computed with.") from None


def quantity(text: str | float, unit: str, *, what: str) -> float:
    """Return the number of `unit` that a quantity is.

    Parameters
    ----------
    text : str or float
        Number and unit, as ``"10 mm"``, ``"30 deg"``, ``"2e-14 mm^3/(N m)"``, ``"20 degC"``; where `unit` has no
        dimension, a plain number or a percentage.
    unit : str
        The unit of the answer, an SI unit as a rule; ``""`` for a plain number.  Where it is ``"K"``, temperatures in
        degC and degF are moved to absolute ones; where it is ``"delta_degC"``, a difference, they are refused.
    what : str
        What the quantity is; error messages start with it.

    Returns
    -------
    float
        The nearest float: no digit is lost in the conversion.

    Raises
    ------
    InvalidInput
        If the text is no number with a unit that fits.

    Examples
    --------
    >>> quantity("10 mm", "m", what="curvature_radius"), quantity("20 degC", "K", what="temperature")
    (0.01, 293.15)
    """
    name, example = _kind(unit)
    if not isinstance(text, str):
        if isinstance(text, bool) or not isinstance(text, int | float) or not math.isfinite(text):
            raise InvalidInput(f"{what}: {text!r} is not a quantity; give {name} such as '{example}'.")
        text = repr(text)
    number, given, written = _read(text, what)
    if not written and _unit(unit).dimension:
        raise InvalidInput(f"{what}: '{text}' has no unit; give {name} such as '{example}'.")
    if given.dimension != _unit(unit).dimension:
        near = _fitting(written, unit)
        raise InvalidInput(
            f"{what}: '{text}' is {_kind(written)[0]}, not {name}{near}; give {name} such as '{example}'."
        )
    if given.offset and unit != "K":
        raise InvalidInput(f"{what}: '{text}' is a temperature, not a difference of two; write the difference in K.")
    wanted = _unit(unit).factor
    return _float(number, given._replace(factor=given.factor / wanted, offset=given.offset / wanted), text, what)


def _fitting(written: str, unit: str) -> str:
    """Return a hint at a unit that differs from what was `written` by capitals only, and fits."""
    same = [known for known in COMMON if known.lower() == written.lower() and _kind(known) == _kind(unit)]
    return f" (did you mean '{same[0]}'?)" if same else ""


def to_si(text: str, *, what: str) -> float:
    """Return a quantity of any dimension in SI units: ``"10 mm"`` is 0.01, ``"3"`` is 3."""
    number, unit, _ = _read(text, what)
    return _float(number, unit, text, what)


def scale(unit_from: str, unit_to: str, *, what: str = "unit") -> float:
    """Return by what a number of `unit_from` is multiplied to become one of `unit_to`.

    Raises
    ------
    InvalidInput
        If a unit is unknown, the two do not fit, or one has a zero of its own (degC).
    """
    try:
        before, after = _unit(unit_from), _unit(unit_to)
    except _Unreadable as reason:
        raise InvalidInput(f"{what}: '{unit_from}' cannot be read: {reason}.") from None
    if before.dimension != after.dimension:
        near = _fitting(unit_from, unit_to)
        raise InvalidInput(
            f"{what}: '{unit_from}' is the unit of {_kind(unit_from)[0]}, not of {_kind(unit_to)[0]}{near}."
        )
    if before.offset or after.offset:
        raise InvalidInput(
            f"{what}: '{unit_from}' has a zero of its own, so that no factor leads to '{unit_to}'; write K."
        )
    return float(before.factor / after.factor)


def format_quantity(number: float, unit: str) -> str:
    """Return a number of `unit` (an SI unit without prefix) as text with a handy prefix; angles in degrees.

    `quantity` reads exactly the same float back.

    Examples
    --------
    >>> format_quantity(2.1e11, "Pa"), format_quantity(5e-8, "J/m^2"), format_quantity(math.pi / 6, "rad")
    ('210 GPa', '50 nJ/m^2', '30 deg')
    """
    number = float(number)
    if not math.isfinite(number):
        raise InvalidInput(f"{number} {unit} cannot be written as a quantity; only finite numbers can.")
    if unit == "rad" and abs(number) < 1e6:
        for degrees in (f"{math.degrees(number):.12g} deg", f"{math.degrees(number)!r} deg"):
            if quantity(degrees, unit, what="angle") == number:
                return degrees
    match = PREFIXED.fullmatch(unit)
    if match and number:
        power = int(match[2] or 1)
        for exponent, prefix in PREFIXES:
            if abs(number) >= 10.0 ** (exponent * power) and exponent <= LARGEST.get(match[1], 9):
                shifted = Decimal(repr(number)).scaleb(-exponent * power).normalize()
                if abs(shifted) < 1_000_000:
                    return f"{shifted:f} {prefix}{unit}"
                break
    return f"{int(number) if number == int(number) and abs(number) < 1e15 else repr(number)} {unit}".strip()
