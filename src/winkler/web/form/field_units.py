"""Units of a field: which one is shown, bare numbers in it, decimal commas, and the same quantity in another unit."""

from __future__ import annotations

import functools
import re
from decimal import Decimal, localcontext
from fractions import Fraction

from winkler.values.errors import InvalidInput
from winkler.values.unit_grammar import unit_of
from winkler.values.units import comma_readings, quantity

USUAL = (
    *("m", "mm", "um", "nm"),
    *("kN", "N", "mN", "uN", "nN", "pN"),
    *("GPa", "MPa", "kPa", "Pa"),
    *("deg", "rad"),
    *("hour", "min", "s", "ms", "us"),
    *("m/s", "mm/s", "um/s", "nm/s"),
    *("J/m^2", "mJ/m^2", "uJ/m^2"),
    *("MN/m", "kN/m", "N/mm", "N/m", "mN/m", "pN/nm"),
    *("kg", "g", "mg"),
    *("K", "degC"),
    *("1/m", "1/mm", "1/um"),
    *("kHz", "Hz"),
    *("rad/s", "deg/s"),
    *("kA", "A", "mA"),
    *("kV", "V", "mV"),
    *("1/GPa", "1/MPa", "1/Pa"),
    *("Pa s", "kPa s", "mPa s"),
    *("N m", "mN m", "uN m"),
    *("m^2", "cm^2", "mm^2", "um^2"),
    *("ohm m", "uohm m", "nohm m"),
)
"""Units that a menu offers; those of one dimension stand in one row."""
ALIKE = {"J/m^2": ("J/m^2", "mJ/m^2", "uJ/m^2"), "Hz": ("kHz", "Hz"), "rad/s": ("rad/s", "deg/s")}
"""Glossary unit -> its row, where other rows have the same dimension."""
BARE = re.compile(r"[+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][+-]?\d+)?")
WITH_UNIT = re.compile(r"\s*[+-]?(?:\d++[.,]?\d*+|[.,]\d++)(?:[eE][+-]?\d++)?+\s*([^\d\s,;.][^,;]*|1/[^,;]+)")
NUMBER_AND_UNIT = re.compile(r"([+-]?(?:\d++\.?\d*+|\.\d++)(?:[eE][+-]?\d++)?+)\s*(\D.*|1/.*)")
DIGITS = (12, 15, 17, 19, 21)
"""Digits of a converted number: as few as the quantity needs."""
LEAST_PLAIN, LARGEST_PLAIN = Decimal("1e-4"), Decimal("1e7")


@functools.cache
def offered_units(si: str, name: str = "temperature") -> tuple[str, ...]:
    """Return the units that a menu offers for a quantity, the glossary's among them; none for a plain number.

    Degrees Celsius are offered for keys whose name ends with ``temperature``: others may be differences.

    Examples
    --------
    >>> offered_units("Pa"), offered_units("1/K"), offered_units("")
    (('GPa', 'MPa', 'kPa', 'Pa'), ('1/K',), ())
    """
    if not si:
        return ()
    if si in ALIKE:
        return ALIKE[si]
    try:
        dimension = unit_of(si).dimension
    except ValueError:  # a unit that follows from other keys, as m^(1-n)
        return ()
    others = {unit for units in ALIKE.values() for unit in units}
    if not name.endswith("temperature"):
        others.add("degC")
    return tuple(unit for unit in USUAL if unit not in others and unit_of(unit).dimension == dimension) or (si,)


def shown_unit(text: str, otherwise: str) -> str:
    """Return the unit of the first quantity of a text.

    Examples
    --------
    >>> shown_unit("10 mm", "m"), shown_unit("1 N, 2 N", ""), shown_unit("", "m"), shown_unit("30°", "rad")
    ('mm', 'N', 'm', '°')
    """
    for item in re.split(r"[,;]\s+|;", text):
        match = WITH_UNIT.match(item)
        if match:
            return match[1].strip()
    return otherwise


def completed_text(text: str, takes: str, unit: str) -> str:
    """Return a typed text with points for decimal commas, and with `unit` behind bare numbers.

    A comma between digits is the decimal sign if nothing else can be meant, one before a space separates numbers, as a
    semicolon does.  What is ambiguous stays as it is, for the checks of the study to refuse it.

    Parameters
    ----------
    text
        The typed text.
    takes
        Type of the key as named by `winkler.study.language.explain`.
    unit
        The shown unit; empty for a plain number.

    Examples
    --------
    >>> completed_text("0,5", "quantity [m]", "mm"), completed_text("1,000 N", "quantity [N]", "N")
    ('0.5 mm', '1,000 N')
    >>> completed_text("1; 2,5; 4", "quantity [N], list or range", "mN"), completed_text("1,5", "list of quantity", "N")
    ('1 mN, 2.5 mN, 4 mN', '1,5')
    """
    plain = text.strip()
    if not plain or plain[0] in "[{" or not takes.startswith(("quantity", "number", "list of quantity", "list of num")):
        return text
    if "list" not in takes:
        return _completed_item(plain, unit)
    items = re.split(r"\s*;\s*|,\s+", plain)
    if len(items) == 1 and "," in plain:
        if takes.startswith("list") and BARE.fullmatch(plain):  # one number, or two
            return text
        if not comma_readings(plain):
            items = plain.split(",")
    done = [_completed_item(item.strip(), unit) for item in items]
    return ", ".join(done) if all("," not in one for one in done) else text


def _completed_item(item: str, unit: str) -> str:
    readings = comma_readings(item)
    if len(readings) == 1 and "," not in readings[0]:
        item = readings[0]
    return f"{item} {unit}" if unit and BARE.fullmatch(item) and "," not in item else item


def in_unit(text: str, unit: str, si: str) -> str | None:
    """Return the same quantity in another unit; None if the text is no quantity of that dimension.

    The float of the glossary's unit stays the same: the text has as many digits as that needs.

    Parameters
    ----------
    text
        Number and unit.
    unit
        The other unit.
    si
        The glossary's unit.

    Examples
    --------
    >>> in_unit("10 mm", "um", "m"), in_unit("60 deg", "rad", "rad"), in_unit("10 mm", "N", "m")
    ('10000 um', '1.0471975511965977 rad', None)
    """
    match = NUMBER_AND_UNIT.fullmatch(text.strip())
    try:
        wanted = quantity(text, si, what="")
        before, after = unit_of(match[2] if match else ""), unit_of(unit)
        if match is None or before.dimension != after.dimension:
            return None
        exact = (Fraction(match[1]) * before.factor + before.offset - after.offset) / after.factor
        for digits in DIGITS:
            with localcontext(prec=digits):
                written = f"{_written(Decimal(exact.numerator) / Decimal(exact.denominator))} {unit}"
            if quantity(written, si, what="") == wanted:
                return written
    except InvalidInput:
        pass
    return None


def _written(number: Decimal) -> str:
    """Return a number as a person writes it: without a power of ten where few zeros do.

    Examples
    --------
    >>> _written(Decimal("1E+4")), _written(Decimal("0.00250")), _written(Decimal("1e-12"))
    ('10000', '0.0025', '1e-12')
    """
    number = number.normalize()
    if number == 0 or LEAST_PLAIN <= abs(number) < LARGEST_PLAIN:
        return f"{number:f}"
    return f"{number:e}".replace("e+", "e")
