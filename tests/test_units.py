"""Quantities as text: what is read, what is refused and how, and that what is written is read back."""

from __future__ import annotations

import math
import subprocess
import sys
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from winkler.values.errors import InvalidInput
from winkler.values.unit_grammar import PREFIXED_UNITS, PREFIXES, SCALE_ZEROS, UNPREFIXED_UNITS, _named_by_pint, si_unit
from winkler.values.units import format_quantity, quantity, scale, to_si

READ = [
    ("10 mm", "m", 0.01),
    ("10mm", "m", 0.01),
    ("  10   mm ", "m", 0.01),
    ("+1.5e-3 m", "m", 0.0015),
    (".5 m", "m", 0.5),
    ("5. m", "m", 5.0),
    ("3 nm", "m", 3e-9),
    ("-3 nm", "m", -3e-9),
    ("−3 nm", "m", -3e-9),
    ("5 µm", "m", 5e-6),
    ("5 μm", "m", 5e-6),
    ("5 um", "m", 5e-6),
    ("5 µ", "m", 5e-6),
    ("5 micron", "m", 5e-6),
    ("5 micrometer", "m", 5e-6),
    ("5 Micrometers", "m", 5e-6),
    ("5 Newton", "N", 5.0),
    ("2 Å", "m", 2e-10),
    ("1 inch", "m", 0.0254),
    ("1 Mm", "m", 1e6),
    ("210 GPa", "Pa", 210e9),
    ("1 bar", "Pa", 1e5),
    ("100 N", "N", 100.0),
    ("1 kg m / s^2", "N", 1.0),
    ("1 kgf", "N", 9.80665),
    ("50 mJ/m^2", "J/m^2", 0.05),
    ("50 mJ/m2", "J/m^2", 0.05),
    ("50 mJ m-2", "J/m^2", 0.05),
    ("50 mJ·m⁻²", "J/m^2", 0.05),
    ("50 mN/m", "J/m^2", 0.05),
    ("2 N m", "J", 2.0),
    ("2 Nm", "J", 2.0),
    ("2 mN.m", "J", 2e-3),
    ("2 uN*m", "J", 2e-6),
    ("1e-14 1/Pa", "1/Pa", 1e-14),
    ("2e-14 mm^3/(N m)", "1/Pa", 2e-23),
    ("2e-14 mm³/(N·m)", "1/Pa", 2e-23),
    ("3 1/mm", "1/m", 3000.0),
    ("3/mm", "1/m", 3000.0),
    ("3 mm^-1", "m^-1", 3000.0),
    ("3 mm**-1", "1/m", 3000.0),
    ("3 mm^(-1)", "1/m", 3000.0),
    ("4 m^0.5", "m^0.5", 4.0),
    ("4 m^(1/2)", "m^0.5", 4.0),
    ("4 m^1.75", "m^1.75", 4.0),
    ("30 deg", "rad", math.radians(30)),
    ("70.3°", "rad", math.radians(70.3)),
    ("0.5 rad", "rad", 0.5),
    ("10 mrad", "rad", 0.01),
    ("1 rad/s", "rad/s", 1.0),
    ("50 Hz", "1/s", 50.0),
    ("1 min", "s", 60.0),
    ("20 degC", "K", 293.15),
    ("20 °C", "K", 293.15),
    ("-273.15 degC", "K", 0.0),
    ("68 degF", "K", 293.15),
    ("300 K", "K", 300.0),
    ("5 K", "delta_degC", 5.0),
    ("5 delta_degC", "K", 5.0),
    ("0.3", "", 0.3),
    ("30 %", "", 0.3),
    ("30 percent", "", 0.3),
    ("2 mm/m", "", 0.002),
    (0.3, "", 0.3),
    (1, "", 1.0),
    ("25.4 mm", "inch", 1.0),
]


@pytest.mark.parametrize(("text", "unit", "number"), READ, ids=[str(text) for text, _, _ in READ])
def test_what_is_read(text, unit, number):
    got = quantity(text, unit, what="x")
    assert isinstance(got, float)
    assert got == number


SCALE_WITH_ZERO = "a temperature scale with its own zero cannot be part of another unit; write K."

ONE_NUMBER = "write one number, then its unit, as '2.1e5 MPa'."
REFUSED = [
    ("10,5 mm", "m", "'10,5 mm' has a comma; write decimals with a point and thousands without, as '10.5 mm'."),
    ("1,234.5 mm", "m", "'1,234.5 mm' has a comma; write decimals with a point and thousands without, as '1234.5 mm'."),
    (
        "1,234,567 mm",
        "m",
        "'1,234,567 mm' has a comma; write decimals with a point and thousands without, as '1234567 mm'.",
    ),
    (
        "1,000 N",
        "N",
        "'1,000 N' has a comma, which is ambiguous; write '1000 N' if it groups thousands, '1.000 N' if it is the "
        "decimal sign.",
    ),
    (
        "-12,345e3 N",
        "N",
        "'-12,345e3 N' has a comma, which is ambiguous; write '-12345e3 N' if it groups thousands, '-12.345e3 N' if it "
        "is the decimal sign.",
    ),
    ("0,500 N", "N", "'0,500 N' has a comma; write decimals with a point and thousands without, as '0.500 N'."),
    (
        "1234,567 N",
        "N",
        "'1234,567 N' has a comma; write decimals with a point and thousands without, as '1234.567 N'.",
    ),
    ("1.234,5 N", "N", "'1.234,5 N' has a comma; write decimals with a point and thousands without, as '1234.5 N'."),
    ("1 N,5", "N", "'1 N,5' has a comma; write decimals with a point and thousands without, as '1234.5'."),
    ("nan mm", "m", "'nan mm' is not a finite number; give one, or leave the key out."),
    ("NaN", "m", "'NaN' is not a finite number; give one, or leave the key out."),
    ("inf", "m", "'inf' is not a finite number; give one, or leave the key out."),
    ("-Infinity m", "m", "'-Infinity m' is not a finite number; give one, or leave the key out."),
    ("10", "m", "'10' has no unit; give a length such as '10 mm'."),
    (10, "m", "'10' has no unit; give a length such as '10 mm'."),
    (10.5, "Pa", "'10.5' has no unit; give a pressure or modulus such as '210 GPa'."),
    ("0", "m", "'0' has no unit; give a length such as '10 mm'."),
    ("30", "rad", "'30' has no unit; give an angle such as '30 deg'."),
    ("10 %", "m", "'10 %' is a plain number, not a length; give a length such as '10 mm'."),
    ("0.3 mm", "", "'0.3 mm' is a length, not a plain number; give a plain number such as '0.3'."),
    ("0.3 rad", "", "'0.3 rad' is an angle, not a plain number; give a plain number such as '0.3'."),
    ("0.3", "rad", "'0.3' has no unit; give an angle such as '30 deg'."),
    (
        "100 N",
        "N/m",
        "'100 N' is a force, not a force per length or energy per area; give a force per length or energy per area "
        "such as '1 kN/m'.",
    ),
    ("10 kg", "m", "'10 kg' is a mass, not a length; give a length such as '10 mm'."),
    ("10 N", "Pa", "'10 N' is a force, not a pressure or modulus; give a pressure or modulus such as '210 GPa'."),
    ("5 mm²", "m", "'5 mm²' is an area, not a length; give a length such as '10 mm'."),
    ("10 m m", "m", "'10 m m' is an area, not a length; give a length such as '10 mm'."),
    ("1 N/m", "N", "'1 N/m' is a force per length or energy per area, not a force; give a force such as '5 mN'."),
    ("5 kg m", "m", "'5 kg m' is a quantity in kg m, not a length; give a length such as '10 mm'."),
    ("5 Hz", "rad/s", "'5 Hz' is a frequency, not a quantity in rad/s; give a quantity in rad/s such as '1 rad/s'."),
    (
        "10 pa",
        "Pa",
        "'10 pa' is a time, not a pressure or modulus (did you mean 'Pa'?); give a pressure or modulus such as "
        "'210 GPa'.",
    ),
    ("1 MM", "m", "'1 MM' is a quantity in MM, not a length (did you mean 'mm'?); give a length such as '10 mm'."),
    ("10 mmm", "m", "'10 mmm' cannot be read: the unit 'mmm' is unknown (did you mean 'mm'?)."),
    ("10 kpa", "Pa", "'10 kpa' cannot be read: the unit 'kpa' is unknown (did you mean 'kPa'?)."),
    ("10 mpa", "Pa", "'10 mpa' cannot be read: the unit 'mpa' is unknown (did you mean 'MPa'?)."),
    ("10 Neutons", "N", "'10 Neutons' cannot be read: the unit 'neutons' is unknown (did you mean 'newton'?)."),
    ("10 qqq", "m", "'10 qqq' cannot be read: the unit 'qqq' is unknown."),
    ("10 dB", "", "'10 dB' cannot be read: the unit 'dB' is unknown."),
    ("mm", "m", "'mm' does not start with a number; write number and unit, as '10 mm'."),
    ("ten mm", "m", "'ten mm' does not start with a number; write number and unit, as '10 mm'."),
    ("", "m", "'' does not start with a number; write number and unit, as '10 mm'."),
    ("   ", "", "'   ' does not start with a number; write number and unit, as '10 mm'."),
    ("１０ mm", "m", "'１０ mm' does not start with a number; write number and unit, as '10 mm'."),
    ("1e999 m", "m", "the number in '1e999 m' is too large to be computed with."),
    ("1e-999 m", "m", "the number in '1e-999 m' is too small to be computed with."),
    ("1e99999999999 m", "m", "the number in '1e99999999999 m' is too large to be computed with."),
    ("1e308 km", "m", "'1e308 km' is too large to be computed with."),
    ("9" * 200 + " m", "m", "'99999999999999999999...' is too long for a quantity; at most 100 characters are read."),
    ("9**9**9 m", "m", "'9**9**9 m' cannot be read: '**9' is out of place in the unit."),
    ("1 m**9**9**9", "m", "'1 m**9**9**9' cannot be read: '**9' is out of place in the unit."),
    ("1 m^999999999", "m", "'1 m^999999999' cannot be read: the exponent 1e+09 of a unit is too large."),
    ("1 m^13", "m", "'1 m^13' cannot be read: the exponent 13 of a unit is too large."),
    ("1 m^(1/0)", "m", "'1 m^(1/0)' cannot be read: '0)' cannot be part of a unit; " + ONE_NUMBER),
    ("10 mm 5 um", "m", "'10 mm 5 um' cannot be read: '5 um' cannot be part of a unit; " + ONE_NUMBER),
    ("1_000 m", "m", "'1_000 m' cannot be read: '_000 m' cannot be part of a unit; " + ONE_NUMBER),
    ("0x10 m", "m", "'0x10 m' cannot be read: the unit 'x' is unknown."),
    ("1 m;2", "m", "'1 m;2' cannot be read: ';2' cannot be part of a unit; " + ONE_NUMBER),
    ("1 (m", "m", "'1 (m' cannot be read: a bracket is not closed in the unit."),
    ("1 m)", "m", "'1 m)' cannot be read: a bracket is closed in the unit that was not opened."),
    ("1 m/", "m", "'1 m/' cannot be read: the unit is not complete."),
    ("1 *m", "m", "'1 *m' cannot be read: '*' is out of place in the unit."),
    ("1 m^", "m", "'1 m^' cannot be read: '^' cannot be part of a unit; " + ONE_NUMBER),
    ("1 " + "(" * 60 + "m", "m", "'1 " + "(" * 60 + "m' cannot be read: '(' is out of place in the unit."),
    (
        "1 mm^3/N m",
        "1/Pa",
        "'1 mm^3/N m' cannot be read: it is not clear how far the / reaches; use brackets, as in mm^3/(N m).",
    ),
    ("1 W/(m degC)", "W/(m K)", f"'1 W/(m degC)' cannot be read: {SCALE_WITH_ZERO}"),
    ("1 1/degC", "1/K", f"'1 1/degC' cannot be read: {SCALE_WITH_ZERO}"),
    ("20 degC", "m", "'20 degC' is a temperature, not a length; give a length such as '10 mm'."),
    ("20 degC", "delta_degC", "'20 degC' is a temperature, not a difference of two; write the difference in K."),
    (True, "", "True is not a quantity; give a plain number such as '0.3'."),
    (None, "m", "None is not a quantity; give a length such as '10 mm'."),
    ([1], "m", "[1] is not a quantity; give a length such as '10 mm'."),
    (math.nan, "", "nan is not a quantity; give a plain number such as '0.3'."),
    (math.inf, "m", "inf is not a quantity; give a length such as '10 mm'."),
]


@pytest.mark.parametrize(("text", "unit", "sentence"), REFUSED, ids=[str(text)[:20] for text, _, _ in REFUSED])
def test_what_is_refused_and_how(text, unit, sentence):
    with pytest.raises(InvalidInput) as caught:
        quantity(text, unit, what="curvature_radius")
    assert str(caught.value) == f"curvature_radius: {sentence}"


def test_any_dimension():
    assert to_si("10 mm", what="R") == 0.01
    assert to_si("3", what="R") == 3.0
    assert to_si("70.3 deg", what="R") == math.radians(70.3)
    assert to_si("20 degC", what="R") == 293.15
    with pytest.raises(InvalidInput, match="R: '10,5 mm' has a comma"):
        to_si("10,5 mm", what="R")


def test_scale():
    assert (scale("um", "m"), scale("m", "nm"), scale("nm", "um")) == (1e-6, 1e9, 1e-3)
    assert scale("mm^3/(N m)", "1/Pa") == 1e-9
    assert scale("kp/mm^2", "Pa") == 9.80665e6
    assert scale("deg", "rad") == pytest.approx(math.pi / 180, rel=1e-15)
    for before, after, sentence in (
        ("kg", "m", "line 1: 'kg' is the unit of a mass, not of a length."),
        ("MM", "m", "line 1: 'MM' is the unit of a quantity in MM, not of a length (did you mean 'mm'?)."),
        ("mil", "m", "line 1: 'mil' is the unit of an angle, not of a length (did you mean 'thou'?)."),
        ("lb", "N", "line 1: 'lb' is the unit of a mass, not of a force (did you mean 'lbf'?)."),
        ("", "m", "line 1: '' is the unit of a plain number, not of a length."),
        ("umm", "m", "line 1: 'umm' cannot be read: the unit 'umm' is unknown (did you mean 'um'?)."),
        ("degC", "K", "line 1: 'degC' has a zero of its own, so that no factor leads to 'K'; write K."),
    ):
        with pytest.raises(InvalidInput) as caught:
            scale(before, after, what="line 1")
        assert str(caught.value) == sentence


@pytest.mark.parametrize(
    ("number", "unit", "text"),
    [
        (0.01, "m", "10 mm"),
        (3e-9, "m", "3 nm"),
        (-2e-6, "m", "-2 um"),
        (0.0, "m", "0 m"),
        (1.5, "m", "1.5 m"),
        (2e3, "m", "2 km"),
        (1e9, "m", "1000000000 m"),
        (1e-15, "m", "1e-15 m"),
        (0.1 + 0.2, "m", "300.00000000000004 mm"),
        (2.1e11, "Pa", "210 GPa"),
        (5e-3, "N", "5 mN"),
        (0.05, "N/m", "50 mN/m"),
        (5e-8, "J/m^2", "50 nJ/m^2"),
        (1e-6, "m^2", "1 mm^2"),
        (1e-12, "m^2", "1 um^2"),
        (3e3, "1/m", "3000 1/m"),
        (0.25, "m^-1", "0.25 m^-1"),
        (2.5, "m^1.75", "2.5 m^1.75"),
        (2e-3, "s", "2 ms"),
        (100.0, "s", "100 s"),
        (300.0, "K", "300 K"),
        (12.0, "kg", "12 kg"),
        (0.3, "", "0.3"),
        (math.radians(70.3), "rad", "70.3 deg"),
        (5, "N", "5 N"),
    ],
)
def test_what_is_written(number, unit, text):
    assert format_quantity(number, unit) == text
    assert quantity(text, unit, what="x") == number


def test_only_finite_numbers_are_written():
    for number in (math.inf, -math.inf, math.nan):
        with pytest.raises(InvalidInput, match="cannot be written as a quantity; only finite numbers can"):
            format_quantity(number, "m")


@given(st.floats(allow_nan=False, allow_infinity=False), st.data())
def test_what_is_written_is_read_back_to_the_same_float(entries, number, data):
    units = {entry.unit for entry in entries.values() if entry.unit is not None} - {"m^(1-n)"}
    unit = data.draw(st.sampled_from([*sorted(units), "m^2", "J/m^2", "s", "K", "kg", "m^-0.5"]))
    assert quantity(format_quantity(number, unit), unit, what="x") == number


@given(st.floats(1e-12, 1e12), st.sampled_from(["nm", "um", "mm", "cm", "m", "km"]))
def test_reading_rounds_once(number, unit):
    """The decimal that is written, times the exact power of ten, rounded to the nearest float."""
    power = {"nm": -9, "um": -6, "mm": -3, "cm": -2, "m": 0, "km": 3}[unit]
    exact = Fraction(repr(number)) * Fraction(10) ** power
    assert quantity(f"{number!r} {unit}", "m", what="x") == float(exact)


@given(st.text(alphabet="0123456789.eE+-*/^()  mkNPaGdegCs,µ°%", max_size=30), st.sampled_from(["m", "Pa", "rad", ""]))
def test_any_text_is_read_or_refused(text, unit):
    try:
        number = quantity(text, unit, what="x")
    except InvalidInput:
        return
    assert math.isfinite(number)


@pytest.mark.few(1)
@pytest.mark.parametrize(("written", "loaded"), [("1 mm", "False"), ("1 kN/GPa/mm", "False"), ("1 inch", "True")])
def test_pint_is_loaded_only_for_names_that_the_table_lacks(written, loaded):
    request = f"u.quantity({written!r}, 'm', what='x')"
    code = f"import sys, winkler.values.units as u; {request}; print('pint' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert done.stdout.split() == [loaded]


def test_the_table_of_units_says_what_pint_says():
    """A second source for each factor, dimension and zero, with the exact fractions of pint's own definitions."""
    names = [
        *UNPREFIXED_UNITS,
        *SCALE_ZEROS,
        *PREFIXED_UNITS,
        *(prefix + symbol for symbol in PREFIXED_UNITS for prefix in PREFIXES),
    ]
    assert {name for name in names if si_unit(name) != _named_by_pint(name)} == set()
    assert si_unit("kfurlong") is si_unit("inch") is si_unit("") is None


def test_a_unit_alone_may_have_superscripts():
    """As in the header of a table."""
    assert scale("µm⁻¹", "1/m") == 1e6
    assert scale("um⁴", "m^4") == 1e-24
