"""Numbers with units, as they are written: ``"10 mm"`` becomes 0.01, and 0.01 becomes ``"10 mm"``.

Used only at the interfaces (study files, command line, tables, forms); inside, everything is SI.  The number is read as
an exact decimal and multiplied by an exact fraction, so that ``3 nm`` is the float nearest to 3e-9, and what
`format_quantity` writes is read back to the same float.
"""

from __future__ import annotations

import functools
import math
import re
from decimal import Decimal
from fractions import Fraction
from typing import Any, TypeVar

from winkler.values.errors import InvalidInput
from winkler.values.unit_grammar import COMMON_UNITS, POWERS, Unit, Unreadable, unit_of

T = TypeVar("T")

LONGEST_QUANTITY = 100
"""Most characters of a quantity."""

LARGEST_EXACT = 2**53  # whole numbers up to this one are floats

QUANTITY = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*)", re.ASCII)

KIND_NAMES = (
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
WRITTEN = {"N/m": "1 kN/m"}
"""How quantities of a unit are written that shares its dimension with another one above."""

CALLED_SO = {"mil": "thou", "lb": "lbf", "oz": "ozf", "kg": "kgf", "g": "gf", "A": "angstrom"}
"""Symbol of a unit -> another unit that is called so, too."""

WITH_COMMA = re.compile(r"([+-]?)([\d.,]*,[\d.,]*)(.*)", re.ASCII | re.DOTALL)
THOUSANDS = re.compile(r"[1-9]\d{0,2}(,\d{3})+(\.\d*)?", re.ASCII)
DECIMALS = re.compile(r"(\d*|[1-9]\d{0,2}(\.\d{3})+),\d+", re.ASCII)

PREFIXED = re.compile(r"(m|N|Pa|J|W|Hz|s|V|A)(?:\^([23]))?(?![\w^])(.*)")
LARGEST_PREFIX = {"m": 3, "s": 0}
PREFIXES = ((9, "G"), (6, "M"), (3, "k"), (0, ""), (-3, "m"), (-6, "u"), (-9, "n"), (-12, "p"))


@functools.lru_cache(maxsize=1)
def _kinds() -> dict[tuple[tuple[str, Fraction], ...], tuple[str, str]]:
    return {unit_of(unit).dimension: (name, example) for unit, name, example in KIND_NAMES}


def _kind(unit: str) -> tuple[str, str]:
    """Return what a unit measures, and how such a quantity is written."""
    return _kinds().get(unit_of(unit).dimension, (f"a quantity in {unit}", f"1 {unit}"))


def comma_readings(text: str) -> tuple[str, ...]:
    """Return what a number with a comma may mean, each written with a point; empty if it is no such number.

    Examples
    --------
    >>> comma_readings("1,000 N"), comma_readings("10,5 mm"), comma_readings("1,234.5")
    (('1000 N', '1.000 N'), ('10.5 mm',), ('1234.5',))
    """
    match = WITH_COMMA.fullmatch(text.strip())
    if match is None:
        return ()
    sign, number, rest = match.groups()
    plain = [number.replace(",", "")] if THOUSANDS.fullmatch(number) else []
    if DECIMALS.fullmatch(number):
        plain.append(number.replace(".", "").replace(",", "."))
    return tuple(sign + one + rest for one in plain)


def comma_hint(text: str) -> str:
    """Return what to do about a number with a comma, as the end of a sentence: "a comma, ...".

    Examples
    --------
    >>> comma_hint("1,000 N")
    "a comma, which is ambiguous; write '1000 N' if it groups thousands, '1.000 N' if it is the decimal sign"
    """
    readings = comma_readings(text)
    if len(readings) > 1:
        whole, broken = readings
        return (
            f"a comma, which is ambiguous; write '{whole}' if it groups thousands, '{broken}' if it is the decimal sign"
        )
    example = readings[0] if readings else "1234.5"
    return f"a comma; write decimals with a point and thousands without, as '{example}'"


def _read(text: str, what: str) -> tuple[Fraction, Unit, str]:
    """Return the number, the unit and the unit's text of a quantity."""
    if len(text) > LONGEST_QUANTITY:
        raise InvalidInput(
            f"{what}: '{text[:20]}...' is too long for a quantity; at most {LONGEST_QUANTITY} characters are read."
        )
    plain = text.translate(POWERS).replace("−", "-").strip()
    if "," in plain:
        raise InvalidInput(f"{what}: '{text}' has {comma_hint(plain)}.")
    match = QUANTITY.fullmatch(plain)
    if match is None:
        if re.match(r"[+-]?(nan|inf)", plain, re.IGNORECASE):
            raise InvalidInput(f"{what}: '{text}' is not a finite number; give one, or leave the key out.")
        raise InvalidInput(f"{what}: '{text}' does not start with a number; write number and unit, as '10 mm'.")
    size = abs(float(match[1]))
    if size == math.inf or (size == 0.0 and re.match(r"[^eE]*[1-9]", match[1])):
        raise InvalidInput(f"{what}: the number in '{text}' is too {'large' if size else 'small'} to be computed with.")
    try:  # a power of ten behind a zero may be of any size
        return Fraction(match[1] if size else 0), unit_of(match[2]), match[2]
    except Unreadable as reason:
        raise InvalidInput(f"{what}: '{text}' cannot be read: {reason}.") from None


def _float(number: Fraction, unit: Unit, text: str, what: str) -> float:
    if unit == unit_of("deg"):
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
        The unit of the result, an SI unit as a rule; ``""`` for a plain number.  Where it is ``"K"``, temperatures in
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
    example = WRITTEN.get(unit, example)
    if not isinstance(text, str):
        if isinstance(text, bool) or not isinstance(text, int | float) or not math.isfinite(text):
            raise InvalidInput(f"{what}: {text!r} is not a quantity; give {name} such as '{example}'.")
        text = repr(text)
    number, stated, written = _read(text, what)
    if not written and unit_of(unit).dimension:
        raise InvalidInput(f"{what}: '{text}' has no unit; give {name} such as '{example}'.")
    if stated.dimension != unit_of(unit).dimension:
        near = _fitting(written, unit)
        raise InvalidInput(
            f"{what}: '{text}' is {_kind(written)[0]}, not {name}{near}; give {name} such as '{example}'."
        )
    if stated.offset and unit != "K":
        raise InvalidInput(f"{what}: '{text}' is a temperature, not a difference of two; write the difference in K.")
    target_factor = unit_of(unit).factor
    return _float(
        number, stated._replace(factor=stated.factor / target_factor, offset=stated.offset / target_factor), text, what
    )


def _fitting(written: str, unit: str) -> str:
    """Return a hint at a unit that fits, and differs from what was `written` by capitals only or is called so, too."""
    alike = [name for name in COMMON_UNITS if name.lower() == written.lower()]
    same = [name for name in (*alike, CALLED_SO.get(written, written)) if _kind(name) == _kind(unit)]
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
    before, after = _fitting_units(unit_from, unit_to, what)
    if before.offset or after.offset:
        raise InvalidInput(
            f"{what}: '{unit_from}' has a zero of its own, so that no factor leads to '{unit_to}'; write K."
        )
    return _factor(before, after, unit_from, what)


def converted(numbers: T, unit_from: str, unit_to: str, *, what: str) -> T:
    """Return a number, or an array, of `unit_from` in `unit_to`; degC and degF become absolute temperatures.

    Raises
    ------
    InvalidInput
        If a unit is unknown, or the two do not fit.
    """
    before, after = _fitting_units(unit_from, unit_to, what)
    if before.offset and unit_to != "K":
        raise InvalidInput(f"{what}: '{unit_from}' is a temperature, not a difference of two; write K.")
    exact = before.factor / after.factor
    if max(exact.numerator, exact.denominator) <= LARGEST_EXACT:  # one rounding: 3 nm are the float nearest to 3e-9
        result: Any = numbers * float(exact.numerator) / float(exact.denominator)  # type: ignore[operator]
    else:
        result = numbers * _factor(before, after, unit_from, what)  # type: ignore[operator]
    return result + float(before.offset) if before.offset else result  # type: ignore[no-any-return]


def is_fixed(unit: str) -> bool:
    """Return whether a unit of the glossary depends on no other argument, as ``m^(1-n)`` does."""
    return re.search(r"\^\([^)]*[A-Za-z]", unit) is None


def _fitting_units(unit_from: str, unit_to: str, what: str) -> tuple[Unit, Unit]:
    """Return two units of one dimension."""
    try:
        before, after = unit_of(unit_from), unit_of(unit_to)
    except Unreadable as reason:
        raise InvalidInput(f"{what}: '{unit_from[:LONGEST_QUANTITY]}' cannot be read: {reason}.") from None
    if before.dimension != after.dimension:
        near = _fitting(unit_from, unit_to)
        raise InvalidInput(
            f"{what}: '{unit_from}' is the unit of {_kind(unit_from)[0]}, not of {_kind(unit_to)[0]}{near}."
        )
    return before, after


def _factor(before: Unit, after: Unit, unit_from: str, what: str) -> float:
    """Return the factor between two units of one dimension."""
    try:
        factor = float(before.factor / after.factor)
    except OverflowError:
        factor = math.inf
    if not 0.0 < factor < math.inf:
        raise InvalidInput(f"{what}: '{unit_from}' is too {'large' if factor else 'small'} to be computed with.")
    return factor


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
            if abs(number) >= 10.0 ** (exponent * power) and exponent <= LARGEST_PREFIX.get(match[1], 9):
                shifted = Decimal(repr(number)).scaleb(-exponent * power).normalize()
                if abs(shifted) < 1_000_000:
                    return f"{shifted:f} {prefix}{unit}"
                break
    return f"{int(number) if number == int(number) and abs(number) < 1e15 else repr(number)} {unit}".strip()
