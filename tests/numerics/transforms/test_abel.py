"""The transforms T1 to T5 and T7 against mpmath at 30 digits: smooth, kinked and jumpy shapes, axis and edge."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

from winkler.numerics.transforms import abel
from winkler.values.errors import NotConverged

mp.mp.dps = 30
B, J = 0.4, 0.7
"""A kink at B where the slope jumps by J."""
X = np.array([1e-12, 1e-3, 0.2, 0.39, 0.4, np.nextafter(0.4, 1.0), 0.4 + 1e-9, 0.41, 0.8, 1.0, 2.5])


class Shape:
    """f', f'' and f in floats, f' in mpmath, the kinks as (radius, jump of f')."""

    def __init__(self, slope, curvature, height, exact, kinks=()):
        self.slope, self.curvature, self.height, self.exact, self.kinks = slope, curvature, height, exact, kinks
        self.edges = [b for b, _ in kinks]


def _beyond(r, value):
    return np.where(r > B, value, 0.0)


SHAPES = {
    "smooth": Shape(
        lambda r: np.sin(r) + r**3,
        lambda r: np.cos(r) + 3.0 * r**2,
        lambda r: 2.0 * np.sin(0.5 * r) ** 2 + 0.25 * r**4,
        lambda r: mp.sin(r) + r**3,
    ),
    "cone": Shape(lambda r: 0.3 + 0.0 * r, lambda r: 0.0 * r, lambda r: 0.3 * r, lambda r: mp.mpf("0.3") + 0 * r),
    "kinked": Shape(
        lambda r: r + _beyond(r, J),
        lambda r: np.ones_like(r),
        lambda r: 0.5 * r**2 + _beyond(r, J * (r - B)),
        lambda r: r + (mp.mpf(J) if r > mp.mpf(B) else 0),
        ((B, J),),
    ),
    "rounded": Shape(
        lambda r: _beyond(r, r - B),
        lambda r: _beyond(r, 1.0),
        lambda r: _beyond(r, 0.5 * (r - B) ** 2),
        lambda r: max(r - mp.mpf(B), mp.mpf(0)),
        ((B, 0.0),),
    ),
    "nearly vertical": Shape(
        lambda r: r / np.sqrt(9.0 - r**2),
        lambda r: 9.0 / (9.0 - r**2) ** 1.5,
        lambda r: r**2 / (3.0 + np.sqrt(9.0 - r**2)),
        lambda r: r / mp.sqrt(9 - r**2),
    ),
}


def _split(x, edges):
    return [mp.mpf(0), *[mp.asin(mp.mpf(b) / x) for b in edges if b < x], mp.pi / 2]


def forward(shape, x):
    """T1 by tanh-sinh quadrature at 30 digits."""
    x = mp.mpf(x)
    return x * mp.quad(lambda t: shape.exact(x * mp.sin(t)), _split(x, shape.edges))


def forward_integral(shape, x):
    """T7, integrated by parts: no height is needed."""
    x = mp.mpf(x)
    return x**2 * mp.quad(lambda t: shape.exact(x * mp.sin(t)) * mp.cos(t) ** 2, _split(x, shape.edges))


def assert_as_good_as_rounding(got, expected, x, rtol):
    """Within rtol; just above the kink, within what the rounding of places there leaves of a distance from it."""
    above = np.maximum(x - B, np.spacing(B))
    allowed = rtol + np.where(x > B, 8.0 * np.spacing(B) / above, 0.0)
    assert np.all(np.abs(got - expected) <= allowed * np.abs(expected)), (got / expected - 1.0, allowed)


@pytest.mark.parametrize("name", SHAPES)
def test_gap_is_t1(name):
    shape = SHAPES[name]
    expected = np.array([float(forward(shape, x)) for x in X])
    assert_as_good_as_rounding(abel.gap(shape.slope, shape.edges, X), expected, X, 1e-13)


@pytest.mark.parametrize("name", SHAPES)
def test_gap_integral_is_t7(name):
    shape = SHAPES[name]
    expected = np.array([float(forward_integral(shape, x)) for x in X])
    assert_as_good_as_rounding(abel.gap_integral(shape.height, shape.edges, X), expected, X, 1e-12)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("name", SHAPES)
def test_gap_slope_is_the_derivative_of_t1(name):
    shape = SHAPES[name]
    places = X[(X > 1e-6) & (np.abs(X - B) > 1e-6)]
    with mp.workdps(45):
        expected = [float(mp.diff(lambda t: forward(shape, t), mp.mpf(x), h=mp.mpf("1e-15"))) for x in places]
    got = abel.gap_slope(shape.slope, shape.curvature, shape.kinks, places)
    np.testing.assert_allclose(got, expected, rtol=2e-12, atol=1e-16)


@pytest.mark.parametrize("distance", [0.0, 1e-16, 1e-13, 1e-10, 1e-7, 1e-4])
def test_gap_slope_close_to_a_kink(distance):
    """Just above a kink g' diverges as b j / sqrt(x^2 - b^2); the rounded x is what counts."""
    shape = SHAPES["kinked"]
    x = B + distance
    b = mp.mpf(B)
    expected = 2 * mp.mpf(x)
    if x > B:
        expected += J * (mp.acos(b / mp.mpf(x)) + b / mp.sqrt(mp.mpf(x) ** 2 - b**2))
    got = abel.gap_slope(shape.slope, shape.curvature, shape.kinks, np.array([x]))
    np.testing.assert_allclose(got, float(expected), rtol=1e-13)


def test_a_jump_of_the_height_is_carried_by_the_integral_form():
    """f = h H(r - b): the integral of g is h sqrt(x^2 - b^2)."""
    x = np.array([0.1, 0.4, 0.400001, 0.5, 3.0])
    got = abel.gap_integral(lambda r: np.where(r > B, 2.0, 0.0), [B], x)
    np.testing.assert_allclose(got, 2.0 * np.sqrt(np.maximum(x - B, 0.0) * (x + B)), rtol=1e-13)


def test_axis_and_shape():
    shape = SHAPES["cone"]
    x = np.array([[0.0, 0.5], [1.0, 0.0]])
    assert abel.gap(shape.slope, [], x).shape == (2, 2)
    np.testing.assert_array_equal(abel.gap(shape.slope, [], x)[x == 0.0], 0.0)
    np.testing.assert_allclose(abel.gap_slope(shape.slope, shape.curvature, (), x), 0.15 * math.pi, rtol=1e-14)
    for number in (0.0, 0.5):
        place = np.array(number)
        assert abel.gap(shape.slope, [], place).shape == ()
        assert abel.gap_slope(shape.slope, shape.curvature, (), place).shape == ()
        assert abel.gap_integral(shape.height, [], place).shape == ()
        assert abel.surface(shape.height, [], place).shape == ()
        assert abel.pressure(lambda x: -x, (), 0.0, 1.0, place).shape == ()
        assert abel.line_load(lambda r: 0.0 * r, (), 1.0, place).shape == ()
        assert abel.integral(shape.height, [], place).shape == ()


@pytest.mark.parametrize("name", SHAPES)
def test_t2_undoes_t1(name):
    """f comes back from g to 1e-12, also when g itself is only known by quadrature."""
    shape = SHAPES[name]
    r = X[X >= 1e-3]
    back = abel.surface(lambda x: abel.gap(shape.slope, shape.edges, x), shape.edges, r)
    np.testing.assert_allclose(back, shape.height(r), rtol=1e-12, atol=1e-15)


def _outside_parabola(r):
    """(2/pi) Int_0^1 (1 - x^2)/sqrt(r^2 - x^2) dx."""
    return float(2 / mp.pi * mp.quad(lambda t: 1 - r**2 * mp.sin(t) ** 2, [0, mp.asin(1 / r)]))


def test_surface_outside_a_disc():
    """Boussinesq's punch: u = (2/pi) asin(a/r); and a parabola of springs."""
    r = np.array([0.0, 1e-9, 0.5, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 1.5, 100.0, 1e8])
    expected = np.where(r <= 1.0, 1.0, [float(2 / mp.pi * mp.asin(1 / max(mp.mpf(x), 1))) for x in r])
    np.testing.assert_allclose(abel.surface(np.ones_like, [], r, 1.0), expected, rtol=1e-13)
    far = np.array([1.0, 1.0 + 1e-9, 1.5, 1e6])
    exact = [_outside_parabola(mp.mpf(x)) for x in far]
    np.testing.assert_allclose(abel.surface(lambda x: 1.0 - x**2, [], far, 1.0), exact, rtol=1e-13)


def test_integral_over_several_ends():
    ends = np.array([[0.0, 0.2], [0.4, 1.3]])
    root = np.sqrt(np.maximum(ends**2 - B**2, 0.0))
    got = abel.integral(lambda x: x * np.sqrt(np.maximum(x - B, 0.0) * (x + B)) + 1.0, [B], ends)
    np.testing.assert_allclose(got, root**3 / 3.0 + ends, rtol=1e-13)


# ---------------------------------------------------------------------------------------------------- refusals

ROUGH = {
    "waves": lambda r: np.sin(1e5 * r),
    "an unstated kink": lambda r: np.where(r > 0.3, 1.0, 0.0),
    "noise": lambda r: np.modf(1e4 * np.sin(1e4 * r))[0],
}


@pytest.mark.parametrize("name", ROUGH)
def test_rough_functions_are_refused(name):
    with pytest.raises(NotConverged, match=r"the shape is not smooth between its stated kinks: state them"):
        abel.gap(ROUGH[name], [], np.array([1.0]))


def test_what_is_refused_without_its_kink_is_exact_with_it():
    x = np.array([0.5, 1.0])
    got = abel.gap(ROUGH["an unstated kink"], [0.3], x)
    np.testing.assert_allclose(got, x * np.arccos(0.3 / x), rtol=1e-13)


@pytest.mark.parametrize(
    ("x", "b"), [(1.0, 1.0), (np.nextafter(1.0, 2.0), 1.0), (1.0 + 1e-12, 1.0), (3.0, 1e-9), (0.5, 1.0)]
)
def test_root_difference(x, b):
    expected = float(mp.sqrt(max(mp.mpf(x) ** 2 - mp.mpf(b) ** 2, mp.mpf(0))))
    assert float(abel.root_difference(np.array(x), b)) == pytest.approx(expected, rel=1e-15)
