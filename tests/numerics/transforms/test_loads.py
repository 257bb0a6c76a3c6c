"""T4 and T5 against mpmath: pressures down to the axis, up to the edge, a rounding away from a kink, and back again."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from test_abel import SHAPES, B, J, forward

from winkler.numerics.transforms import abel


def test_hertz_pressure_down_to_the_axis():
    r = np.array([0.0, 1e-300, 1e-30, 1e-12, 0.3, 0.999999, 1.0 - 1e-15, 1.0, 1.5])
    expected = 2.0 / math.pi * np.sqrt(np.maximum((1.0 - r) * (1.0 + r), 0.0))
    np.testing.assert_allclose(abel.pressure(lambda x: -2.0 * x, (), 0.0, 1.0, r), expected, rtol=1e-13, atol=1e-300)


def test_cone_pressure_is_infinite_at_the_axis_only():
    r = np.array([0.0, 1e-300, 1e-10, 0.2, 0.9, 1.0 - 1e-12, 1.0])
    got = abel.pressure(lambda x: -np.ones_like(x), (), 0.0, 1.0, r)
    assert got[0] == math.inf
    expected = [float(mp.acosh(1 / mp.mpf(x)) / mp.pi) for x in r[1:]]
    np.testing.assert_allclose(got[1:], expected, rtol=1e-13)


@pytest.mark.parametrize("power", [0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.9, 1.0, 1.5, 2.0, 3.7])
def test_pressure_on_the_axis_under_any_power(power):
    """u' = -x^m, m > 0: p(0) = 1/(pi m), finite however blunt the kink of the apex."""
    got = abel.pressure(lambda x: -(x**power), (), 0.0, 1.0, np.array([0.0]))
    np.testing.assert_allclose(got, 1.0 / (math.pi * power), rtol=1e-9)


@pytest.mark.parametrize("power", [-0.5, -0.2])
def test_pressure_on_the_axis_of_a_cusp_is_infinite(power):
    got = abel.pressure(lambda x: -(np.maximum(x, 1e-300) ** power), (), 0.0, 1.0, np.array([0.0, 0.5]))
    assert got[0] == math.inf
    exact = mp.quad(lambda w: (mp.mpf(0.5) * mp.cosh(w)) ** power, [0, mp.acosh(2)]) / mp.pi
    np.testing.assert_allclose(got[1], float(exact), rtol=1e-13)


def _kinked_slope(x):
    """-g' of the kinked shape."""
    root = np.sqrt(np.maximum(x - B, 0.0) * (x + B))
    return -(2.0 * x + np.where(x > B, J * (np.arctan2(root, B) + B / np.where(root > 0.0, root, 1.0)), 0.0))


def _kinked_pressure(r, end=1.0):
    """T4 of the kinked shape at 30 digits; where the integrand is infinite at the kink, in y = sqrt(x^2 - b^2)."""
    r, b = mp.mpf(r), mp.mpf(B)
    first = 2 * mp.sqrt(mp.mpf(end) ** 2 - r**2)
    low = max(r, b)
    top = mp.sqrt(mp.mpf(end) ** 2 - low**2)

    def integrand(y):
        x = mp.sqrt(low**2 + y**2)
        own = mp.sqrt(low**2 - b**2 + y**2)
        return J * (mp.atan2(own, b) + b / own) * y / (x * mp.sqrt(low**2 - r**2 + y**2))

    points = [mp.mpf(0), *[p for p in (abs(b - r), mp.sqrt(abs(b**2 - r**2))) if 0 < p < top], top]
    return (first + mp.quad(integrand, points)) / mp.pi


@pytest.mark.parametrize("away", [-0.4, -0.1, -1e-3, -1e-6, -1e-12, -1e-16, 1e-16, 1e-12, 1e-6, 1e-3, 0.3, 0.599])
def test_pressure_of_a_kinked_shape(away):
    """However close to the kink, where it diverges logarithmically."""
    r = np.nextafter(B, math.copysign(1.0, away)) if abs(away) == 1e-16 else B + away
    got = abel.pressure(_kinked_slope, ((B, B * J),), 0.0, 1.0, np.array([r]))
    np.testing.assert_allclose(got, float(_kinked_pressure(r)), rtol=1e-11)


@pytest.mark.parametrize("away", [-1e-6, -1e-16, 0.0, 1e-16, 1e-6])
def test_pressure_at_a_kink_of_the_curvature_is_continuous(away):
    """f = (r - b)^2/2 beyond b, on a disc of 1: no strength, and nothing special in the pressure."""
    r = np.nextafter(B, math.copysign(1.0, away)) if abs(away) == 1e-16 else B + away

    def slope(x):
        root = np.sqrt(np.maximum(x - B, 0.0) * (x + B))
        return -np.where(x > B, 2.0 * root - B * np.arctan2(root, B), 0.0)

    b, place = mp.mpf(B), mp.mpf(r)
    low = max(place, b)

    def integrand(y):  # x^2 = low^2 + y^2
        own = mp.sqrt(low**2 - b**2 + y**2)
        x = mp.sqrt(low**2 + y**2)
        return (2 * own - b * mp.atan2(own, b)) * y / (x * mp.sqrt(low**2 - place**2 + y**2))

    end = mp.sqrt(1 - low**2)
    exact = mp.quad(integrand, [0, *[p for p in [mp.sqrt(abs(b**2 - place**2))] if 0 < p < end], end]) / mp.pi
    got = abel.pressure(slope, ((B, 0.0),), 0.0, 1.0, np.array([r]))
    np.testing.assert_allclose(got, float(exact), rtol=1e-11)


def test_pressure_at_the_kink_itself_is_infinite():
    got = abel.pressure(_kinked_slope, ((B, B * J),), 0.0, 1.0, np.array([0.2, B, 0.5]))
    assert got[1] == math.inf
    assert np.all(np.isfinite(got[[0, 2]]))
    pulled = abel.pressure(lambda x: -_kinked_slope(x), ((B, -B * J),), 0.0, 1.0, np.array([B]))
    assert pulled[0] == -math.inf


def test_a_jump_at_the_edge():
    r = np.array([0.0, 0.5, 1.0 - 1e-12, 1.0, 1.0 + 1e-12])
    got = abel.pressure(np.zeros_like, (), 1.0, 1.0, r)
    np.testing.assert_allclose(got[:3], 1.0 / (math.pi * np.sqrt((1.0 - r[:3]) * (1.0 + r[:3]))), rtol=1e-14)
    assert got[3] == math.inf
    assert got[4] == 0.0


PAIRS = {
    "flat": (np.ones_like, np.zeros_like, (), 1.0),
    "parabola": (lambda x: 1.0 - x**2, lambda x: -2.0 * x, (), 0.0),
    "cone": (lambda x: 1.0 - x, lambda x: -np.ones_like(x), (), 0.0),
    "pinned": (lambda x: 2.0 - x**2, lambda x: -2.0 * x, (), 1.0),
    "blend": (
        lambda x: 1.0 - np.where(x < B, x**2, B**2 + 2.0 * B * (x - B)),
        lambda x: -np.where(x < B, 2.0 * x, 2.0 * B),
        ((B, 0.0),),
        1.0 - (B**2 + 2.0 * B * (1.0 - B)),
    ),
}


@pytest.mark.parametrize("name", PAIRS)
def test_t5_undoes_t4(name):
    load, slope, kinks, edge = PAIRS[name]
    x = np.array([0.0, 1e-6, 0.1, 0.35, 0.4, 0.5, 0.9, 0.9999])

    def pressure(r):
        return abel.pressure(slope, kinks, edge, 1.0, r)

    got = abel.line_load(pressure, [b for b, _ in kinks], 1.0, x)
    # the apex of a cone has the logarithm of r, the edge of a punch an inverse square root: both within 1e-9
    np.testing.assert_allclose(got, load(x), rtol=1e-9, atol=1e-11)


def test_t5_of_a_kinked_shape():
    """The pressure diverges logarithmically at the kink, on both sides."""
    shape = SHAPES["kinked"]
    depth = float(forward(shape, 1.0))
    x = np.array([0.0, 0.2, 0.39, 0.4, 0.41, 0.9])

    def pressure(r):
        return abel.pressure(_kinked_slope, ((B, B * J),), 0.0, 1.0, r)

    expected = depth - np.array([float(forward(shape, v)) if v else 0.0 for v in x])
    np.testing.assert_allclose(abel.line_load(pressure, [B], 1.0, x), expected, rtol=1e-8)


def test_line_load_of_a_uniform_pressure():
    x = np.array([0.0, 0.3, 0.999, 1.0, 2.0])
    got = abel.line_load(np.ones_like, (), 1.0, x)
    np.testing.assert_allclose(got, 2.0 * np.sqrt(np.maximum((1.0 - x) * (1.0 + x), 0.0)), rtol=1e-13)


def test_forces_agree_in_one_and_three_dimensions():
    """2 pi Int p f r dr = 2 Int q g dx for any pair (T7): p of a cone, f of the kinked shape."""
    shape = SHAPES["kinked"]

    def moment(r):
        return abel.pressure(lambda x: -np.ones_like(x), (), 0.0, 1.0, r) * shape.height(r) * 2.0 * math.pi * r

    left = abel.integral(moment, [B], np.array(1.0))
    right = abel.integral(lambda x: 2.0 * (1.0 - x) * abel.gap(shape.slope, shape.edges, x), [B], np.array(1.0))
    assert float(left) == pytest.approx(float(right), rel=1e-10)
