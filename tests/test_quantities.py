"""Quantities of other libraries as arguments, and answers as quantities of pint."""

from __future__ import annotations

import collections
import dataclasses
import functools
import math
import subprocess
import sys
import typing
from decimal import Decimal

import numpy as np
import pandas as pd
import pint
import pytest
import xarray as xr

import winkler as wk
from winkler.values.checks.field_checks import checks_of
from winkler.values.units import is_fixed
from winkler.values.vocabulary import GLOSSARY, own_word, word

UNITS = pint.UnitRegistry()
CENTIMETRES = pint.UnitRegistry(system="cgs")
STEEL = wk.Elastic(young=210e9, poisson=0.3)
BED = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace.between(STEEL, STEEL))
MODULUS = 0.5 * 210e9 / (1.0 - 0.3**2)


def hertz(force: float) -> float:
    """The depth of a paraboloid in closed form."""
    return float(np.cbrt(9.0 * force**2 / (16.0 * MODULUS**2 * 10e-3)))


@pytest.mark.parametrize(
    "force",
    [
        1.0 * UNITS.kN,
        UNITS.Quantity(Decimal("1.0"), "kN"),
        UNITS.Quantity(224.80894309971047, "lbf"),
        xr.DataArray(1.0, attrs={"units": "kN"}),
        xr.DataArray(UNITS.Quantity(np.array(1.0), "kN")),
        [1.0 * UNITS.kN],
    ],
    ids=["pint", "Decimal", "pounds", "xarray", "pint inside xarray", "row"],
)
def test_a_kilonewton_is_a_thousand_newtons(force):
    depth = np.ravel(wk.Indentation(BED, wk.Force(force)).solve().depth)
    assert depth == pytest.approx([hertz(1000.0)], rel=1e-12)


def test_lengths_of_other_units():
    assert wk.Depth([1, 2] * UNITS.um) == wk.Depth([1e-6, 2e-6])
    assert wk.Depth(3 * UNITS.nm) == wk.Depth(3e-9)  # to the last digit
    assert wk.Elastic(young=210 * UNITS.GPa, poisson=0.3) == STEEL
    assert wk.Cone(half_angle=70 * UNITS.deg) == wk.Cone(half_angle=math.radians(70))
    curve = wk.ForceCurve(np.linspace(0.0, 1000.0, 50) * UNITS.nm, np.linspace(0.0, 5.0, 50) * UNITS.nN)
    assert curve.position[-1] == pytest.approx(1e-6, rel=1e-15)
    assert curve.force[-1] == pytest.approx(5e-9, rel=1e-15)
    column = pd.Series([1.0, 2.0])
    column.attrs["units"] = "mm"
    assert wk.Depth(column) == wk.Depth([1e-3, 2e-3])
    area = wk.AreaFunction([24.5, 800 * UNITS.nm])
    assert area == wk.AreaFunction([24.5, 800e-9])


def test_a_unit_that_its_user_has_defined():
    own = pint.UnitRegistry()
    own.define("smoot = 1.7018 * meter")
    assert wk.Sphere(2.0 * own.smoot).curvature_radius == pytest.approx(3.4036, rel=1e-15)


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: wk.Force(1 * UNITS.m), "Force: force: 'm' is the unit of a length, not of a force."),
        (lambda: wk.Depth(1.0 * UNITS.degC), "Depth: depth: '°C' is the unit of a temperature, not of a length."),
        (
            lambda: wk.Force(xr.DataArray([1.0], attrs={"units": "mm"})),
            "Force: force: 'mm' is the unit of a length, not of a force.",
        ),
        (
            lambda: wk.Force(xr.DataArray([1.0], attrs={"units": "counts"})),
            "Force: force: 'counts' ",
        ),
        (lambda: wk.Depth([1 * UNITS.um, 2.0]), "Depth: depth is "),
        (
            lambda: wk.PowerLaw(2.0, 3.0 * UNITS.um),
            "PowerLaw: exponent: 'µm' is the unit of a length, not of a plain number.",
        ),
        (
            lambda: wk.PowerLaw(coefficient=3.0 / UNITS.um, exponent=2.0),
            "PowerLaw: coefficient is a quantity in '1 / µm'; its unit m^(1-n) follows from other arguments: give a "
            "plain number in it.",
        ),
        (
            lambda: wk.AreaFunction([24.5 * UNITS.m]),
            "AreaFunction: coefficients[0]: 'm' is the unit of a length, not of a plain number.",
        ),
        (
            lambda: wk.Formula("r**2/(2*R)", R=10 * UNITS.mm),
            "Formula: the constant 'R' is a quantity in 'mm'; give plain numbers, in SI units.",
        ),
        # a turn is 2 pi, so that a frequency in Hz is no angular one
        (lambda: wk.DynamicData([1.0] * UNITS.Hz, [1e6], [1e5]), "DynamicData: angular_frequency: 'Hz' is the unit "),
    ],
)
def test_what_does_not_fit_is_refused_by_name(make, sentence):
    with pytest.raises(wk.InvalidInput) as refusal:
        make()
    assert str(refusal.value).startswith(sentence)


SOUND: tuple[typing.Any, ...] = (0.25, np.array([0.25]), np.linspace(0.1, 0.9, 20), np.eye(2))
"""Contents of which each argument of numbers takes one."""


@functools.cache
def quantities(unit: str, place: int) -> tuple[typing.Any, ...]:
    """Return a sound content in centimetres, grams and seconds, and two of another dimension."""
    fitting = CENTIMETRES.Quantity(SOUND[place], unit).to_base_units()
    return fitting, fitting * CENTIMETRES.mole, xr.DataArray(SOUND[place], attrs={"units": "mol^7"})


def arguments() -> typing.Iterator[tuple[str, str, str, typing.Any]]:
    """Yield the arguments of the public classes that have a unit: class, name, unit, check."""
    for name in wk.__all__:
        cls = getattr(wk, name)
        if isinstance(cls, type) and dataclasses.is_dataclass(cls):
            for field, check in checks_of(cls):
                unit = word(cls, field).unit if field in GLOSSARY or own_word(cls, field) else None
                if check is not None and unit is not None and is_fixed(unit):
                    yield name, field, unit, check


def kept_of(check: typing.Any, content: typing.Any) -> typing.Any:
    """Return what a check keeps of a content; a text if it refuses it."""
    try:
        return check(content)
    except wk.InvalidInput as refusal:
        return str(refusal)


@pytest.mark.parametrize(("most", "fewest"), [(2, 150), pytest.param(math.inf, 1300, marks=pytest.mark.slow)])
def test_each_argument_converts_a_quantity_of_its_dimension_and_refuses_another(most, fewest):
    """All arguments; by default two of each unit and kind of content."""
    wrong, seen = [], collections.Counter()
    for name, field, unit, check in arguments():
        if all(seen[unit, place] >= most for place in range(len(SOUND))):
            continue
        for place, plain in enumerate(SOUND):
            kept = kept_of(check, plain)
            if isinstance(kept, str):
                continue
            seen[unit, place] += 1
            if seen[unit, place] > most:
                break
            fitting, *others = quantities(unit, place)
            found = kept_of(check, fitting)
            if type(found) is not type(kept) or not np.allclose(found, kept, rtol=1e-14, atol=0.0):
                wrong.append(f"{name}.{field}: {fitting} became {found}")
            refusals = [kept_of(check, other) for other in others]
            wrong += [f"{name}.{field}: {one}" for one in refusals if not (isinstance(one, str) and field in one)]
            break
    assert wrong == []
    assert seen.total() > fewest


def test_answers_are_quantities():
    contact = wk.Indentation(BED, wk.Force([500.0, 1000.0])).solve()
    depth = contact.quantity("depth")
    assert isinstance(depth, pint.Quantity)
    assert depth.to("um").magnitude == pytest.approx([1e6 * hertz(500.0), 1e6 * hertz(1000.0)], rel=1e-12)
    assert str(contact.quantity("stiffness").units) == "newton / meter"
    assert wk.Force(contact.quantity("force")) == contact.problem.load
    assert STEEL.quantity("young").to("GPa").magnitude == pytest.approx(210.0, rel=1e-15)
    for no_quantity in ("problem", "validity"):
        with pytest.raises(wk.InvalidInput, match=f"^IndentationSolution: {no_quantity} is no quantity"):
            contact.quantity(no_quantity)
    with pytest.raises(AttributeError, match="did you mean 'depth'"):
        contact.quantity("depht")


def test_pint_is_loaded_for_quantities_alone():
    code = (
        "import sys, winkler as wk; wk.Force([1.0, 2.0]); wk.Depth(1)\n"
        "assert not {'pint', 'winkler.values.units', 'fractions', 'xarray', 'pandas'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
