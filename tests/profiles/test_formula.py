"""Profiles written as formulas: against closed forms at 30 digits, and each refusal with its sentence."""

from __future__ import annotations

import copy
import dataclasses
import math
import pickle

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from winkler.profiles.formula import Formula
from winkler.profiles.profile import Shape
from winkler.values.errors import InvalidInput, NotConverged

R = 10e-3


def kappa(n):
    """Return g/f of f = r^n, theory 1.1."""
    return mp.sqrt(mp.pi) * n * mp.gamma(mp.mpf(n) / 2) / (2 * mp.gamma((mp.mpf(n) + 1) / 2))


def test_a_formula_is_a_value():
    tip = Formula("r**2/(2*R) + c*r**4", R=R, c=3.0)
    assert isinstance(tip, Shape)
    assert tip == Formula("r**2/(2*R) + c*r**4", constants={"c": 3.0, "R": R})
    assert tip == Formula("r**2/(2*R) + c*r**4", constants=(("c", 3), ("R", R)))
    assert tip.constants == (("R", R), ("c", 3.0))
    assert [field.name for field in dataclasses.fields(tip)] == ["expression", "constants", "reach", "corners"]
    assert (tip.reach, tip.corners, tip.kinks) == (math.inf, (), ())
    assert hash(tip) == hash(copy.copy(tip))
    assert tip != Formula("r**2/(2*R) + c*r**4", R=R, c=3.1)
    with pytest.raises(dataclasses.FrozenInstanceError):
        tip.reach = 1.0


def test_it_is_pickled_and_replaced():
    tip = Formula("r**2/(2*R) + (r - b + sqrt((r - b)**2))*t", reach=1e-3, corners=(2e-4,), R=R, b=2e-4, t=0.1)
    again = pickle.loads(pickle.dumps(tip))
    assert again == tip
    np.testing.assert_array_equal(again.gap(np.array([1e-4, 5e-4])), tip.gap(np.array([1e-4, 5e-4])))
    assert dataclasses.replace(tip) == tip
    assert dataclasses.replace(tip, reach=5e-4).reach == 5e-4
    assert dict(dataclasses.replace(tip, R=5e-3).constants) == {"R": 5e-3, "b": 2e-4, "t": 0.1}
    assert dict(dataclasses.replace(tip, constants={**dict(tip.constants), "t": 0.2}).constants)["t"] == 0.2
    assert tip == Formula(**{field.name: getattr(tip, field.name) for field in dataclasses.fields(tip)})


def test_reach_may_be_given_by_place():
    assert Formula("r**2/(2*R)", 1e-3, R=R) == Formula("r**2/(2*R)", reach=1e-3, R=R)
    assert Formula("r**2").reach == math.inf


@pytest.mark.parametrize("n", [1, 1.5, 2, 2.5, 3, 4, 8])
def test_powers_have_their_closed_form(n):
    x = np.array([0.0, 1e-6, 2e-3, 0.5])
    tip = Formula(f"c*r**{n}", c=0.7)
    c = mp.mpf(0.7)
    with mp.workdps(30):
        for got, exact in (
            (tip.gap(x), lambda t: kappa(n) * c * t**n),
            (tip.gap_slope(x), lambda t: kappa(n) * c * n * t ** (n - 1)),
            (tip.gap_integral(x), lambda t: kappa(n) * c * t ** (n + 1) / (n + 1)),
        ):
            for number, place in zip(got, x, strict=True):
                wanted = exact(mp.mpf(place))
                assert abs(number - wanted) <= 4e-15 * abs(wanted)
    assert tip.rising


def test_a_sum_of_powers_may_fall_and_is_then_not_known_to_rise():
    assert not Formula("r**2 - 0.1*r**4", reach=2.0).rising
    assert not Formula("r**2 + 1 - cos(r)").rising


def test_at_an_infinitely_curved_apex():
    tip = Formula("r**1.5")
    assert tip.slope(np.zeros(1))[0] == 0.0
    assert tip.curvature(np.zeros(1))[0] == math.inf
    assert tip.gap_slope(np.zeros(1))[0] == 0.0


SPHERE = Formula("R - sqrt(R**2 - r**2)", reach=R, R=R)


@pytest.mark.parametrize("a", [1e-8, 1e-6, 1e-4, 3e-3, 9.5e-3])
def test_the_sphere_keeps_its_digits_however_small_the_contact(a):
    """g = x artanh(x/R), theory 1.1; the height itself cancels to 8 digits at a/R = 1e-4."""
    x = np.array([a])
    with mp.workdps(30):
        t, big = mp.mpf(a), mp.mpf(R)
        gap = t * mp.atanh(t / big)
        rise = mp.atanh(t / big) + t * big / (big**2 - t**2)
        total = ((t**2 - big**2) * mp.atanh(t / big) + t * big) / 2
        assert SPHERE.gap(x)[0] == pytest.approx(float(gap), rel=1e-13)
        assert SPHERE.gap_slope(x)[0] == pytest.approx(float(rise), rel=1e-13)
        assert SPHERE.gap_integral(x)[0] == pytest.approx(float(total), rel=1e-13)
        assert SPHERE.slope(x)[0] == pytest.approx(float(t / mp.sqrt(big**2 - t**2)), rel=1e-14)
        assert SPHERE.curvature(x)[0] == pytest.approx(float(big**2 / mp.sqrt(big**2 - t**2) ** 3), rel=1e-13)


def test_the_numbers_of_the_theory_sheet():
    """E* = 1, theory 1.1: sphere R = 1 at a = 0.5, and the force F = 2 (x g - integral of g)."""
    sphere = Formula("1 - sqrt(1 - r**2)", reach=1.0)
    a = np.array([0.5])
    d = sphere.gap(a)
    assert d[0] == pytest.approx(0.274653072167027, rel=1e-14)
    assert 2.0 * (a * d - sphere.gap_integral(a))[0] == pytest.approx(0.186632680417569, rel=1e-13)


def test_a_hyperboloid():
    """f = c (sqrt(1 + r^2/A^2) - 1), g = (c/A) x atan(x/A), theory 1.1."""
    tip = Formula("c*(sqrt(1 + r**2/A**2) - 1)", c=2e-6, A=1e-6)
    x = np.array([1e-8, 1e-6, 1e-4])
    np.testing.assert_allclose(tip.gap(x), 2.0 * x * np.arctan(x / 1e-6), rtol=1e-13)
    force = 2e-6 / 1e-6 * ((x**2 - 1e-12) * np.arctan(x / 1e-6) + x * 1e-6)
    np.testing.assert_allclose(2.0 * (x * tip.gap(x) - tip.gap_integral(x))[1:], force[1:], rtol=1e-12)


def test_waves_by_struve_functions():
    """g = (pi/2) h k x H0(k x), theory 1.1."""
    tip = Formula("h*(1 - cos(k*r))", h=1e-7, k=2 * math.pi / 1e-5)
    x = np.array([1e-7, 3e-6, 2.2e-5])
    with mp.workdps(30):
        k = mp.mpf(2 * math.pi / 1e-5)
        wanted = [mp.pi / 2 * mp.mpf(1e-7) * k * t * mp.struveh(0, k * t) for t in map(mp.mpf, x.tolist())]
    np.testing.assert_allclose(tip.gap(x), np.array(wanted, dtype=float), rtol=1e-12)


def ramp(b=0.2, t=0.1):
    """A truncated cone: flat up to b, then rising by t."""
    return Formula("t*(r - b + sqrt((r - b)**2))/2", corners=(b,), b=b, t=t)


def test_a_stated_corner_is_carried_exactly():
    """The truncated cone of theory 1.1: g = tan t x acos(b/x)."""
    cone = ramp()
    assert cone.kinks == ((0.2, pytest.approx(0.1, rel=1e-12)),)
    x = np.array([0.0, 0.1, 0.2, 0.2000001, 0.5, 3.0])
    with mp.workdps(30):
        b = mp.mpf(0.2)
        wanted = [mp.mpf("0.1") * t * mp.acos(b / t) if t > b else mp.mpf(0) for t in map(mp.mpf, x.tolist())]
    np.testing.assert_allclose(cone.gap(x), np.array(wanted, dtype=float), rtol=2e-13)
    a = np.array([0.5])
    assert cone.gap(a)[0] == pytest.approx(0.0579639740363704, rel=1e-13)
    assert 2.0 * (a * cone.gap(a) - cone.gap_integral(a))[0] == pytest.approx(0.0381471384081969, rel=1e-12)
    assert cone.gap_slope(a)[0] == pytest.approx(0.1 * (math.acos(0.4) + 0.4 / math.sqrt(1 - 0.16)), rel=1e-13)


def test_at_a_corner_slope_and_curvature_are_those_just_below():
    tip = Formula("r**2 + sqrt((r - 1)**2) + r - 1", corners=(1.0,))
    np.testing.assert_allclose(tip.slope(np.array([0.5, 1.0, 1.5])), [1.0, 2.0, 5.0], rtol=1e-13)
    np.testing.assert_allclose(tip.curvature(np.array([0.5, 1.0, 1.5])), 2.0, rtol=1e-6)
    assert tip.height(np.array([1.0]))[0] == pytest.approx(1.0)


def test_a_corner_where_only_the_curvature_is_infinite_has_no_jump():
    tip = Formula("2*r + ((r - 0.1)**2)**0.75 - 0.1**1.5", corners=(0.1,))
    assert tip.kinks == ((0.1, 0.0),)
    assert tip.slope(np.array([0.1]))[0] == pytest.approx(2.0, rel=1e-12)
    x = np.array([0.3])
    with mp.workdps(30):
        b = mp.mpf(0.1)

        def slope(r):
            return 2 + mp.mpf(3) / 2 * mp.sign(r - b) * mp.sqrt(mp.fabs(r - b))

        t = mp.mpf(0.3)
        angles = [0, mp.asin(b / t), mp.pi / 2]
        wanted = t * mp.quad(lambda angle: slope(t * mp.sin(angle)), angles)
    assert tip.gap(x)[0] == pytest.approx(float(wanted), rel=1e-10)


def test_a_corner_does_not_spoil_the_apex():
    """Beside a ramp of slope 0.1 the paraboloid's slope of 1e-13 is still itself: theory 1.1, both parts."""
    tip = Formula("r**2/(2*R) + t*(r - b + sqrt((r - b)**2))/2", corners=(2e-4,), R=R, b=2e-4, t=0.1)
    x = np.array([1e-15, 1e-9, 1e-4, 3e-4])
    cone = np.where(x > 2e-4, 0.1 * x * np.arccos(np.minimum(2e-4 / x, 1.0)), 0.0)
    np.testing.assert_allclose(tip.gap(x), x**2 / R + cone, rtol=1e-12)
    np.testing.assert_allclose(tip.gap_slope(x[:3]), 2.0 * x[:3] / R, rtol=1e-12)


def test_corners_are_sorted_and_counted_once():
    tip = Formula("r**2 + sqrt((r-2)**2) + sqrt((r-1)**2) + 2*r - 3", corners=[2.0, 1, 2.0])
    assert tip.corners == (1.0, 2.0)
    assert tip.kinks == ((1.0, pytest.approx(2.0)), (2.0, pytest.approx(2.0)))


def test_a_corner_that_was_not_stated_is_not_passed_over():
    tip = Formula("r**2 + sqrt((r - 1)**2) + r - 1")
    with pytest.raises(NotConverged, match="not smooth between its stated kinks"):
        tip.gap(np.array([1.7]))
    with pytest.raises(InvalidInput) as caught:
        tip.slope(np.array([0.5, 1.0]))
    assert str(caught.value) == (
        "Formula: the slope of 'r**2 + sqrt((r - 1)**2) + r - 1' is not a finite number at r = 1 m; end the formula "
        "before by reach=..., or state a kink there by corners=(1,)."
    )


def test_rounding_at_the_apex_is_taken_off():
    tip = Formula("R - sqrt(R**2 - r**2) + 0.1 + 0.2 - 0.3", reach=R, R=R)
    assert tip.height(np.zeros(1))[0] == 0.0


def test_beyond_what_the_formula_can_say_the_radius_is_named():
    with pytest.raises(InvalidInput) as caught:
        SPHERE.height(np.array([5e-3, 1.2e-2, 1.1e-2]))
    assert str(caught.value) == (
        "Formula: the height of 'R - sqrt(R**2 - r**2)' is not a finite number at r = 0.011 m; end the formula before "
        "by reach=..., or state a kink there by corners=(0.011,)."
    )
    assert SPHERE.height(np.array([R]))[0] == pytest.approx(R)
    assert SPHERE.slope(np.array([R]))[0] == math.inf


NOT_ZERO = "; a profile starts at zero, so subtract it."
UNDETERMINED = (
    " cannot be evaluated at r = 0, where it is undetermined or infinite; rewrite it, as r*sqrt(1 + r) for "
    "sqrt(r**2 + r**3)."
)
NEGATIVE = (
    ", where the bodies would touch before r = 0; check the sign, end it before by reach=..., or write both bodies "
    "into one formula."
)

REFUSED = [
    ({"expression": "r**2 + 1e-3"}, "Formula: the height of 'r**2 + 1e-3' is 0.001 m at r = 0" + NOT_ZERO),
    ({"expression": "cos(r)"}, "Formula: the height of 'cos(r)' is 1 m at r = 0" + NOT_ZERO),
    ({"expression": "R - r", "R": 2}, "Formula: the height of 'R - r' is 2 m at r = 0" + NOT_ZERO),
    ({"expression": "1/r"}, "Formula: '1/r'" + UNDETERMINED),
    ({"expression": "log(r)"}, "Formula: 'log(r)'" + UNDETERMINED),
    ({"expression": "1 - sin(r)/r"}, "Formula: '1 - sin(r)/r'" + UNDETERMINED),
    (
        {"expression": "sqrt(sin(r))", "reach": 1.0},
        "Formula: 'sqrt(sin(r))' is infinitely steep at r = 0; give one with a finite slope there.",
    ),
    (
        {"expression": "-r**2/(2*R)", "R": R},
        "Formula: the height of '-r**2/(2*R)' is negative, -5e-23 m at r = 1e-12 m" + NEGATIVE,
    ),
    (
        {"expression": "r**2*(1 - r)", "reach": 2.0},
        "Formula: the height of 'r**2*(1 - r)' is negative, -0.00239 m at r = 1.002 m" + NEGATIVE,
    ),
    ({"expression": "0*r"}, "Formula: the height of '0*r' is zero everywhere; give one that rises."),
    (
        {"expression": "R - sqrt(R**2 - r**2)", "R": R},
        "Formula: the height of 'R - sqrt(R**2 - r**2)' is not a finite number beyond r = 0.01 m; state how far it "
        "holds, as reach=0.01 or less.",
    ),
    (
        {"expression": "exp(r/L) - 1", "L": 1e-6},
        "Formula: the height of 'exp(r/L) - 1' is not a finite number beyond r = 0.000709783 m; state how far it "
        "holds, as reach=0.000709783 or less.",
    ),
    ({"expression": "r**2", "reach": 0.0}, "Formula: reach is 0.0; it must be a positive number in m, or infinite."),
    ({"expression": "r**2", "reach": -1}, "Formula: reach is -1; it must be a positive number in m, or infinite."),
    (
        {"expression": "r**2", "reach": math.nan},
        "Formula: reach is nan; it must be a positive number in m, or infinite.",
    ),
    (
        {"expression": "r**2", "reach": "1 mm"},
        "Formula: reach is '1 mm'; it must be a positive number in m, or infinite.",
    ),
    ({"expression": "r**2", "reach": None}, "Formula: reach is None; it must be a positive number in m, or infinite."),
    (
        {"expression": "r**2", "reach": 1.0, "corners": (2.0,)},
        "Formula: the corner 2.0 must be a radius in m between 0 and the reach.",
    ),
    (
        {"expression": "r**2", "corners": (0.0,)},
        "Formula: the corner 0.0 must be a radius in m between 0 and the reach.",
    ),
    (
        {"expression": "r**2", "corners": ("a",)},
        "Formula: corners is ('a',); give a row of numbers in m.",
    ),
    (
        {"expression": "r**2", "kinks": (1.0,)},
        "Formula: radii where the slope jumps are given as corners=(...), not as kinks.",
    ),
    (
        {"expression": "r*2 + ((r - 1)**2)**0.25 - 1", "corners": (1.0,), "reach": 2.0},
        "Formula: the slope of 'r*2 + ((r - 1)**2)**0.25 - 1' has no finite limit at the corner r = 1 m.",
    ),
    ({"expression": "r**2", "R": 1.0}, "the formula 'r**2': the constant 'R' does not occur in it."),
    ({"expression": "r**2/R"}, "the formula 'r**2/R': the name 'R' is unknown; known are r, pi, e."),
    (
        {"expression": "r**2/Radius", "radius": 1.0},
        "the formula 'r**2/Radius': the name 'Radius' is unknown (did you mean 'radius'?); known are r, pi, e, radius.",
    ),
    ({"expression": "r**2/R", "R": "10 mm"}, "Formula: the constant 'R' is '10 mm'; give a finite number."),
    ({"expression": "r^2"}, "the formula 'r^2': write powers with **, as r**2."),
    ({"expression": 3}, "Formula: expression is 3; give a text: a formula such as 'r**2/(2*R)'."),
    (
        {"expression": "abs(r - 1) - 1"},
        "the formula 'abs(r - 1) - 1': abs(...) is not allowed: its kink must be stated: write sqrt((...)**2), and "
        "give the radius where that vanishes among the corners.",
    ),
]


@pytest.mark.parametrize(("given", "sentence"), REFUSED, ids=[str(given) for given, _ in REFUSED])
def test_what_is_refused_and_how(given, sentence):
    with pytest.raises(InvalidInput) as caught:
        Formula(**given)
    assert str(caught.value) == sentence


@pytest.mark.slow
@given(st.floats(1e-9, 1e-1), st.floats(0.01, 0.9))
def test_lengths_scale(size, part):
    """A sphere s times as large has g(s x) = s g(x)."""
    unit = Formula("R - sqrt(R**2 - r**2)", reach=1.0, R=1.0)
    scaled = Formula("R - sqrt(R**2 - r**2)", reach=size, R=size)
    x = np.array([part])
    np.testing.assert_allclose(scaled.gap(size * x), size * unit.gap(x), rtol=1e-12)
    np.testing.assert_allclose(scaled.gap_integral(size * x), size**2 * unit.gap_integral(x), rtol=1e-11)


def test_shapes_follow_the_arguments():
    for tip in (SPHERE, Formula("r**2")):
        for method in (tip.height, tip.slope, tip.curvature, tip.gap, tip.gap_slope, tip.gap_integral):
            assert method(np.full((2, 3), 1e-3)).shape == (2, 3)
