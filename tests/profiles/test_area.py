"""Area functions: T1 over heights instead of radii, at 30 digits, and the shapes that they contain."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

import winkler as wk

NANO = 1e-9
TIP = tuple(
    # a worn Berkovich tip in nm: 24.5 h^2 + 890 h + ... with alternating signs, as calibrations give them
    c * NANO ** (2.0 - 2.0 ** (1 - n))
    for n, c in enumerate([24.5, 890.0, -3200.0, 5100.0, 410.0, -160.0, 95.0, 210.0, 60.0])
)
DEPTHS = np.array([5e-9, 30e-9, 200e-9, 2e-6])


def area(coefficients, h):
    return mp.fsum(mp.mpf(c) * h ** (mp.mpf(2) ** (1 - n)) for n, c in enumerate(coefficients) if c)


def gap_by_quadrature(coefficients, h):
    """g at the radius where the height is h: x Int_0^h dh' / sqrt(x^2 - A(h')/pi), with h' = h (1 - s^2)."""
    with mp.workdps(40):
        h = mp.mpf(h)
        top = area(coefficients, h)
        cuts = [0, *[mp.sqrt(1 - mp.mpf(10) ** -k) for k in (0.5, 2, 5, 9, 14)], 1]
        inner = mp.quad(lambda s: 2 * h * s / mp.sqrt(abs(top - area(coefficients, h * abs(1 - s**2))) / mp.pi), cuts)
        return mp.sqrt(top / mp.pi), mp.sqrt(top / mp.pi) * inner


@pytest.mark.slow
def test_a_calibrated_tip():
    profile = wk.AreaFunction(TIP)
    for h in DEPTHS:
        x, expected = gap_by_quadrature(TIP, h)
        place = np.array([float(x)])
        assert profile.height(place)[0] == pytest.approx(h, rel=1e-12)
        assert profile.gap(place)[0] == pytest.approx(float(expected), rel=1e-10)


def test_derivatives_of_a_calibrated_tip():
    profile = wk.AreaFunction(TIP)
    x = np.sqrt([float(area(TIP, mp.mpf(h)) / mp.pi) for h in DEPTHS])
    step = 1e-5 * x
    for function, derivative in ((profile.gap, profile.gap_slope), (profile.gap_integral, profile.gap)):
        differences = (
            function(x - 2 * step) - 8 * function(x - step) + 8 * function(x + step) - function(x + 2 * step)
        ) / (12 * step)
        np.testing.assert_allclose(derivative(x), differences, rtol=3e-9)
    # f' and f'' from the inverse function, r(h) = sqrt(A/pi), at 40 digits
    with mp.workdps(40):
        for place, h in zip(x, DEPTHS, strict=True):
            first, second = (mp.diff(lambda t: mp.sqrt(area(TIP, t) / mp.pi), mp.mpf(h), n) for n in (1, 2))
            assert profile.slope(np.array([place]))[0] == pytest.approx(float(1 / first), rel=1e-11)
            assert profile.curvature(np.array([place]))[0] == pytest.approx(float(-second / first**3), rel=1e-9)


def test_the_cross_section_is_the_area():
    profile = wk.AreaFunction(TIP)
    r = np.geomspace(1e-8, 1e-4, 9)
    sections = [float(area(TIP, mp.mpf(h))) for h in profile.height(r)]
    np.testing.assert_allclose(sections, math.pi * r**2, rtol=1e-12)


@pytest.mark.parametrize(
    ("coefficients", "twin"),
    [
        ((24.5,), wk.Cone(math.atan(math.sqrt(24.5 / math.pi)))),
        ((0.0, 2.0 * math.pi * 3e-6), wk.Paraboloid(3e-6)),
        ((-math.pi, 2.0 * math.pi * 3e-6), wk.Sphere(3e-6)),
        # c h^(1/2) = pi r^2: a quartic
        ((0.0, 0.0, 2e-9), wk.PowerLaw((math.pi / 2e-9) ** 2, 4.0)),
        # pi tan^2 (h^2 + 2 h h0): a hyperboloid of half-angle 70 deg
        (
            (math.pi * math.tan(1.2) ** 2, 2.0 * math.pi * math.tan(1.2) ** 2 * 1e-8),
            wk.Hyperboloid(1e-8 * math.tan(1.2) ** 2, 1.2),
        ),
    ],
)
def test_twins(coefficients, twin):
    profile = wk.AreaFunction(coefficients)
    x = np.array([0.0, 1e-9, 1e-7, 1e-6, 2.9e-6])
    for word in ("height", "slope", "curvature", "gap", "gap_slope", "gap_integral"):
        rounding = 1e-14 / x[1] if word == "curvature" else 0.0
        np.testing.assert_allclose(
            getattr(profile, word)(x), getattr(twin, word)(x), rtol=1e-11, atol=rounding + 1e-40, err_msg=word
        )
    assert float(profile.gap_slope(np.array(1e-6))) == pytest.approx(float(twin.gap_slope(np.array(1e-6))))


def test_the_reach_ends_where_the_area_stops_growing():
    assert wk.AreaFunction((-math.pi, 2.0 * math.pi * 3e-6)).reach == pytest.approx(3e-6, rel=1e-12)
    assert wk.AreaFunction((24.5, 1e-7)).reach == math.inf
    # the equator of the sphere is known and the contact beyond it refused
    bed = wk.Foundation(wk.AreaFunction((-math.pi, 2.0 * math.pi * 3e-6)), wk.HalfSpace.between(wk.Elastic(1e9, 0.3)))
    with pytest.raises(wk.OutsideValidity, match="beyond the reach"):
        wk.Indentation(bed, wk.Radius(3.1e-6)).solve()


@pytest.mark.slow
def test_an_area_that_shrinks_further_up():
    """Known up to its first maximum, like the equator of a sphere; what lies beyond is refused."""
    profile = wk.AreaFunction((24.5, -1.0, 0.05))
    top = profile.reach
    heights = np.linspace(1e-7, 0.05, 500_000)
    sections = 24.5 * heights**2 - heights + 0.05 * np.sqrt(heights)
    first = np.flatnonzero(np.diff(sections) < 0.0)[0]
    assert top == pytest.approx(math.sqrt(sections[first] / math.pi), rel=1e-6)
    x = np.array([0.3, 0.9, 0.999]) * top
    for place in x:
        h = float(profile.height(np.array([place]))[0])
        assert float(gap_by_quadrature((24.5, -1.0, 0.05), h)[1]) == pytest.approx(
            float(profile.gap(np.array([place]))[0]), rel=1e-10
        )
    assert profile.gap(np.array([top]))[0] == math.inf
    bed = wk.Foundation(profile, wk.HalfSpace.between(wk.Elastic(1.0, 0.0)))
    with pytest.raises(wk.OutsideValidity, match="beyond the reach"):
        wk.Indentation(bed, wk.Radius(1.01 * top)).solve()


def test_says_that_it_stands_for_a_pyramid():
    assert any("same cross-sections" in note.statement for note in wk.AreaFunction((24.5,)).notes)


@pytest.mark.parametrize("bad", [(), (0.0,), (0.0, 0.0), (math.nan,), (24.5, math.inf)])
def test_bad_coefficients(bad):
    with pytest.raises(
        wk.InvalidInput,
        match=r"^AreaFunction: coefficients are .*; give finite numbers C0, C1, \.\.\. "
        r"of which at least one is not zero\.$",
    ):
        wk.AreaFunction(bad)


@pytest.mark.parametrize("bad", [(-24.5,), (24.5, -1e-7), (24.5, 1e-7, -1e-12)])
def test_an_area_that_shrinks_from_the_apex_on(bad):
    with pytest.raises(
        wk.InvalidInput,
        match=r"the area does not grow from the apex on; the last coefficient that is "
        r"not zero must be positive\.$",
    ):
        wk.AreaFunction(bad)


@pytest.mark.parametrize("bad", [["a"], "24.5", [[1.0, 2.0], 3.0], None])
def test_coefficients_that_are_no_numbers(bad):
    with pytest.raises(
        wk.InvalidInput,
        match=r"^AreaFunction: coefficients are .*; give finite numbers",
    ):
        wk.AreaFunction(bad)


@pytest.mark.parametrize("size", [1e-9, 1e-6, 1e3])
@pytest.mark.parametrize(
    "coefficients", [(24.5, 1e-7), TIP, (24.5, 2e-6, 3e-6), (-math.pi, 2.0 * math.pi * 3e-6), (24.5, -1e-6, 5e-9)]
)
def test_a_tip_knows_no_absolute_height(coefficients, size):
    grown = tuple(c * size ** (2.0 - 2.0 ** (1 - n) if n else 0.0) for n, c in enumerate(coefficients))
    before, after = wk.AreaFunction(coefficients), wk.AreaFunction(grown)
    assert after.reach == pytest.approx(size * before.reach, rel=1e-12)
    assert after.rising == before.rising
    medium = wk.HalfSpace(wk.Elastic(1e9, 0.3))
    for depth in (2e-9, 1e-7):
        one = wk.Indentation(wk.Foundation(before, medium), wk.Depth(depth)).solve()
        other = wk.Indentation(wk.Foundation(after, medium), wk.Force(one.force * size**2)).solve()
        assert other.depth == pytest.approx(size * depth, rel=1e-11)
        assert other.radius == pytest.approx(size * one.radius, rel=1e-11)


TIPS = [(24.5, 2e-6, 3e-9), TIP, (24.5, *(8 * (3e-6,))), (0.0, 2e-6, 0.0, 1e-9), (24.5, -1e-6, 5e-9)]


@pytest.mark.few(3)
@pytest.mark.parametrize("coefficients", TIPS)
def test_tables_of_a_tip_against_its_integrals(coefficients):
    """g and its integral are looked up; what is looked up is what would be integrated, at one place and at many."""
    profile = wk.AreaFunction(coefficients)
    x = np.geomspace(1e-12, 1.0, 97)
    for word, direct in (("gap", profile._gap), ("gap_integral", profile._gap_integral)):
        looked_up = getattr(profile, word)(x)
        expected = np.where(x > profile._pieces.blunt, direct(x), 0.0)
        np.testing.assert_allclose(looked_up, expected, rtol=1e-13, err_msg=word)
        one_by_one = [float(getattr(profile, word)(x[i : i + 1])[0]) for i in range(x.size)]
        np.testing.assert_allclose(one_by_one, looked_up, rtol=1e-13, err_msg=word)


@pytest.mark.parametrize(("coefficients", "reach"), [((-math.pi, 2.0 * math.pi * 3e-6), 3e-6)])
def test_tables_of_a_tip_end_before_its_reach(coefficients, reach):
    """A sphere has g = x artanh(x/R) and the integral (x R - (R^2 - x^2) artanh(x/R)) / 2, up to the equator."""
    profile = wk.AreaFunction(coefficients)
    s = np.array([1e-3, 0.1, 0.3, 0.49999, 0.50001, 0.7, 0.9, 0.999])
    with mp.workdps(30):
        gaps = [float(reach * mp.mpf(u) * mp.atanh(mp.mpf(u))) for u in s.tolist()]
        stored = [float(reach**2 * (mp.mpf(u) - (1 - mp.mpf(u) ** 2) * mp.atanh(mp.mpf(u))) / 2) for u in s.tolist()]
    np.testing.assert_allclose(profile.gap(reach * s), gaps, rtol=1e-12)
    np.testing.assert_allclose(profile.gap_integral(reach * s), stored, rtol=1e-12)


@pytest.mark.parametrize("coefficients", TIPS)
def test_the_slope_far_up_a_tip(coefficients):
    """Where the first term rules the body is its cone or paraboloid, and what the others add is beyond all digits."""
    leading = next((c, 2.0 ** (1 - n)) for n, c in enumerate(coefficients) if c)
    x = 1e9
    expected = 0.5 * math.pi * math.sqrt(math.pi / leading[0]) if leading[1] == 2.0 else 4.0 * math.pi * x / leading[0]
    assert float(wk.AreaFunction(coefficients).gap_slope(np.array([x]))[0]) == pytest.approx(expected, rel=1e-9)
