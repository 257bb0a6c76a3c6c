"""Names, symbols, units and prefixes of what is drawn."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.testing import assert_allclose

from winkler.fields.restoration import SurfaceFields
from winkler.plot.series import (
    Scale,
    common_scale,
    middle_scale,
    places,
    pretty_unit,
    scale_of,
    series,
    with_unit,
)
from winkler.problems.surface_heating.state import SurfaceHeatState


@pytest.mark.parametrize(
    ("unit", "greatest", "shown"),
    [
        ("m", 187e-6, "µm"),
        ("m", 1e-3, "mm"),
        ("m", 0.9999e-3, "µm"),
        ("m", 2e-10, "pm"),
        ("m", 5e3, "m"),
        ("N", 1e4, "kN"),
        ("N", 3e-8, "nN"),
        ("Pa", 1.4e9, "GPa"),
        ("Pa", 0.0, "Pa"),
        ("N/m", 4.3e7, "MN/m"),
        ("J", 1e-4, "µJ"),
        ("m^2", 1e-6, "mm²"),
        ("m^2", 9e-9, "µm²"),
        ("m^2", 3.0, "m²"),
        ("m^3", 1e-12, "mm³"),
        ("m^3", 0.9e-12, "µm³"),
        ("m^2/N", 1e-12, "µm²/N"),
        ("m", 5e-23, "m"),
        ("N m", 1e-3, "mN m"),
        ("1/m", 1e3, "1/m"),
        ("", 1e-9, ""),
        (None, 1.0, ""),
    ],
)
def test_the_prefix_fits_the_greatest(unit, greatest, shown):
    scale = scale_of(unit, [0.0, -greatest, 0.1 * greatest])
    assert scale.unit == shown
    if shown not in ("m²", "1/m", "") and greatest > 0.0 and unit != "m":
        power = 3 if "³" in shown else 2 if "²" in shown else 1
        least = 0.1**power if power > 1 else 1.0
        assert 0.999 * least <= greatest / scale.factor < 1e3**power * least


def test_a_factor_is_the_power_of_ten_itself():
    assert scale_of("m", 5e-6).factor == 1e-6
    assert scale_of("m", 1e-6 * (1 - 1e-12)).unit == "µm"


def test_angles_are_shown_in_degrees():
    scale = scale_of("rad", math.radians(70.3))
    assert scale.unit == "°"
    assert_allclose(math.radians(70.3) / scale.factor, 70.3, rtol=1e-15)


def test_infinite_and_missing_numbers_do_not_choose_the_prefix():
    assert scale_of("Pa", [np.inf, np.nan, 2e6]).unit == "MPa"
    assert scale_of("Pa", [np.inf]).unit == "Pa"


def test_tables_take_the_middle():
    assert middle_scale("N", [0.0, 1.0, 10.0, 5e3, np.nan]) == Scale(1.0, "N")
    assert middle_scale("N", [0.0]) == Scale(1.0, "N")


@pytest.mark.parametrize(
    ("number", "unit", "text"),
    [
        (1.8662e-4, "m", "186.6 µm"),
        (0.3, "", "0.3"),
        (-2e-9, "m", "−2 nm"),
        (math.radians(60.0), "rad", "60°"),
        (1e6, "m^-3", "1·10⁶ m⁻³"),
        (0.0, "N", "0 N"),
        (math.inf, "Pa", "infinite"),
        (-math.inf, "Pa", "−infinite"),
        (math.nan, "Pa", "undefined"),
    ],
)
def test_with_unit(number, unit, text):
    assert with_unit(number, unit) == text


def test_superscripts():
    assert pretty_unit("m^(1-n)") == "m^(1-n)"
    assert pretty_unit("m^2 Pa^-1") == "m² Pa⁻¹"


def test_a_label_has_name_symbol_and_unit():
    force = series("force", [0.0, 2e4])
    assert force.label() == "force $F_N$ [kN]"
    assert_allclose(force.shown(), [0.0, 20.0], rtol=1e-15)
    assert force.label(Scale(1.0, "N")) == "force $F_N$ [N]"
    assert series("poisson", 0.3).label() == r"Poisson's ratio $\nu$"
    assert series("gap", 1.0, SurfaceFields).word.symbol == "h"
    assert series("x", 1e-3).label() == "place along the springs $x$ [mm]"
    assert series("x", 1e-3, SurfaceHeatState).label() == "place $x$ [mm]"


@pytest.mark.slow
def test_every_symbol_of_the_glossary_can_be_drawn(entries):
    from matplotlib.mathtext import MathTextParser

    parse = MathTextParser("path").parse
    refused = []
    for symbol in {entry.symbol for entry in entries.values()} - {""}:
        try:
            parse(f"${symbol}$")
        except ValueError as error:
            refused.append(f"{symbol}: {error}")
    assert refused == []


def test_a_common_scale_fits_the_greatest_of_all():
    small, great = series("gap", [1e-9]), series("gap", [1e-6])
    assert common_scale(small, great).unit == "µm"


def test_places_come_near_the_marks_but_never_meet_them():
    r = places(3.0, (1.0, 2.0, 5.0))
    assert np.all(np.diff(r) > 0.0)
    assert r[0] > 0.0
    assert r[-1] < 3.0
    for mark in (1.0, 2.0):
        assert 0.0 < np.min(np.abs(r - mark)) < 1e-3
    assert 200 < r.size < 300
