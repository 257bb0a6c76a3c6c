"""Tips from calibrated areas: cross-sections, the evaluation by Oliver and Pharr, limits, bad input."""

import math

import numpy as np
import pytest

import winkler as wk

UNIT = wk.HalfSpace(wk.Elastic(1.0, 0.0))
DEPTHS = np.geomspace(50e-9, 2e-6, 12)


def areas(h):
    return 24.5 * h**2 + 4e-7 * h + 1e-12 * h**0.5


TIP = wk.CalibratedTip((24.5, 4e-7, 1e-12), 50e-9, 2e-6)


@pytest.mark.parametrize("factor", [1.0, 1.034])
def test_cross_sections_are_the_calibrated_ones(factor):
    tip = wk.CalibratedTip((24.5, 4e-7, 1e-12), 50e-9, 2e-6, factor)
    assert tip.height(factor * np.sqrt(areas(DEPTHS) / math.pi)) == pytest.approx(DEPTHS, rel=3e-5)
    assert tip.reach == pytest.approx(factor * math.sqrt(areas(2e-6) / math.pi), rel=1e-12)
    assert np.all(np.diff(tip.height(np.linspace(0.0, tip.reach, 2001))) > 0.0)


def test_a_cone_of_one_coefficient():
    tip, cone = wk.CalibratedTip((24.5,), 1e-8, 1e-6), wk.Cone(math.atan(math.sqrt(24.5 / math.pi)))
    force = [wk.Indentation(wk.Foundation(one, UNIT), wk.Depth(1e-6)).solve().force for one in (tip, cone)]
    assert force[0] == pytest.approx(force[1], rel=1e-9)


def test_a_table_is_the_polynomial_between_its_rows():
    table = wk.TabulatedTip(DEPTHS, areas(DEPTHS))
    radii = np.sqrt(areas(np.linspace(0.1e-6, 1.9e-6, 40)) / math.pi)
    assert table.height(radii) == pytest.approx(TIP.height(radii), rel=3e-3)


@pytest.mark.parametrize("factor", [1.0, 1.05])
def test_oliver_and_pharr_find_the_modulus(factor):
    """S = 2 beta E* sqrt(A(h_c) / pi), h_c = f(a): the tip has the stiffness of that evaluation."""
    tip = wk.CalibratedTip((24.5, 4e-7, 1e-12), 50e-9, 2e-6, factor)
    contact = wk.Indentation(wk.Foundation(tip, UNIT), wk.Depth(1.2e-6)).solve()
    contact_depth = float(tip.height(np.array([contact.radius]))[0])
    modulus = 0.5 * math.sqrt(math.pi) * contact.stiffness / (factor * math.sqrt(areas(contact_depth)))
    assert modulus == pytest.approx(1.0, rel=1e-8)


def test_an_elastic_pyramid_as_a_calibrated_tip():
    """With the stated shape factors the tip bears what the pyramid does (closed form, constants of the pyramid)."""
    for sides, factor, constant in ((4, 1.027, 0.737617), (3, 1.078, 0.882413)):
        area = sides * math.tan(math.pi / sides) * math.tan(1.1) ** 2
        tip = wk.CalibratedTip((area,), 1e-8, 1e-6, factor)
        force = wk.Indentation(wk.Foundation(tip, UNIT), wk.Depth(5e-7)).solve().force
        assert force == pytest.approx(constant * math.tan(1.1) * 25e-14, rel=1e-3)
        assert wk.contact_reading(
            2.0 * force / 5e-7, force, 5e-7, wk.Pyramid(sides, 1.1), intercept=0.72676, shape_factor=factor
        ).modulus == pytest.approx(1.0, rel=1e-3)


def test_readings_take_the_cross_section_without_the_shape_factor():
    for tip in (
        wk.CalibratedTip((24.5, 4e-7, 1e-12), 50e-9, 2e-6, 1.2),
        wk.TabulatedTip(np.geomspace(50e-9, 2e-6, 60), areas(np.geomspace(50e-9, 2e-6, 60)), 1.2),
    ):
        assert wk.contact_reading(1e5, 1e-3, 3e-7, tip).area == pytest.approx(areas(292.5e-9), rel=1e-4)
        with pytest.raises(wk.OutsideValidity, match="outside the calibration"):
            wk.contact_reading(1e5, 1e-3, 3e-8, tip)


def test_from_a_calibrated_area():
    assert wk.CalibratedArea((24.5, 4e-7, 1e-12), 50e-9, 2e-6).profile() == TIP
    assert wk.CalibratedArea((24.5,), 50e-9, 2e-6).profile(1.1).shape_factor == 1.1
    with pytest.raises(wk.InvalidInput, match="deepest is inf"):
        wk.CalibratedArea((24.5,), 50e-9).profile()


def test_beyond_the_calibration_is_refused():
    bed = wk.Foundation(TIP, UNIT)
    with pytest.raises(wk.OutsideValidity):
        wk.Indentation(bed, wk.Depth(5e-6)).solve()
    (note, _) = TIP.notes
    assert "from 5e-08 to 2e-06 m" in note.statement
    assert "shape factor 1 " in note.statement


def test_the_apex_is_continued():
    """A ~ h^q below the first depth, with the q there: the slope has no corner."""
    radius = math.sqrt(areas(50e-9) / math.pi)
    growth = (2.0 * 24.5 * 50e-9**2 + 4e-7 * 50e-9 + 0.5e-12 * 50e-9**0.5) / areas(50e-9)
    assert TIP.height(np.array([0.5 * radius]))[0] == pytest.approx(50e-9 * 0.5 ** (2.0 / growth), rel=2e-3)
    slope = TIP.slope(radius * np.array([0.97, 1.0, 1.03]))
    assert np.abs(slope / slope[1] - 1.0).max() < 0.04


BAD = [
    (((0.0,), 1e-8, 1e-6), "give finite numbers C0"),
    (((24.5,), 1e-6, 1e-8), "give two depths that grow"),
    (((-1.0, 1e-6), 1e-8, 1e-5), "is positive"),
    (((-1.0, 1e-6), 1e-8, 9e-7), "does not grow"),
    (((24.5,), 0.0, 1e-6), "shallowest is 0"),
    (((24.5,), 1e-8, 1e-6, -1.0), "shape_factor is -1"),
    (((24.5, -4e-7), 1.7e-8, 1e-6), "begin the calibration deeper"),
]


@pytest.mark.parametrize(("content", "sentence"), BAD)
def test_bad_calibrations(content, sentence):
    with pytest.raises(wk.InvalidInput, match=sentence):
        wk.CalibratedTip(*content)


@pytest.mark.parametrize(
    ("depths", "found", "sentence"),
    [
        (DEPTHS[:4], areas(DEPTHS[:4]), "at least five"),
        (DEPTHS, areas(DEPTHS)[:-1], "equal length"),
        (DEPTHS[::-1].copy(), areas(DEPTHS), "depths do not grow"),
        (DEPTHS, areas(DEPTHS)[::-1].copy(), "does not grow"),
    ],
)
def test_bad_tables(depths, found, sentence):
    with pytest.raises(wk.InvalidInput, match=sentence):
        wk.TabulatedTip(depths, found)


def test_a_rounded_pyramid_has_no_known_cross_section():
    with pytest.raises(wk.OutsideValidity, match="give the tip's CalibratedArea"):
        wk.contact_reading(1e3, 1e-5, 2e-8, wk.RoundedPyramid(4, 1.1, 1e-8))


def test_an_area_function_of_ten_million_coefficients_is_refused_at_once():
    """Issue 38, item 7: it took over 15 s."""
    with pytest.raises(wk.InvalidInput, match=r"are 10000000 numbers; give at most 100\.$"):
        wk.CalibratedTip((1.0,) * 10_000_000, 50e-9, 2e-6)


def test_a_refusal_is_one_line_without_the_place_of_an_object_in_memory():
    for given, shown in ((object(), "<object object>"), (np.zeros(50), r"an array of the shape \(50,\)")):
        with pytest.raises(wk.InvalidInput, match=f"^CalibratedTip: coefficients are {shown}; give finite numbers"):
            wk.CalibratedTip(given, 50e-9, 2e-6)
