"""Power-law graded half-spaces at the ends of their range: no number is lost where factors vanish together."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest

import winkler as wk
from winkler.materials.graded import PowerLawGraded
from winkler.media.graded.power_law import GradedHalfSpace, normal_factor, root_squared

EXPONENTS = [-1 + 1e-13, -1 + 1e-6, -0.999, -0.5, -1e-12, 0.0, 1e-12, 0.5, 0.999, 1 - 1e-6, 1 - 1e-13]
POISSONS = [-1 + 1e-12, -0.99, -0.3, 0.0, 0.3, 0.49, 0.5 - 1e-9, math.nextafter(0.5, 0.0), 0.5]


def _beta(k, nu):
    return mpmath.sqrt((1 + k) * (1 - k * nu / (1 - nu)))


def _factor(k, nu):
    """h_N as theory.md 8.1 writes it."""
    beta = _beta(k, nu)
    c = 2 ** (1 + k) * mpmath.gamma((3 + k + beta) / 2) * mpmath.gamma((3 + k - beta) / 2)
    c /= mpmath.pi * mpmath.gamma(2 + k)
    above = 2 * (1 + k) * mpmath.cos(k * mpmath.pi / 2) * mpmath.gamma(1 + k / 2)
    return above / (mpmath.sqrt(mpmath.pi) * c * beta * mpmath.sin(beta * mpmath.pi / 2) * mpmath.gamma((1 + k) / 2))


@pytest.mark.parametrize("nu", POISSONS)
@pytest.mark.parametrize("k", EXPONENTS)
def test_against_fifty_digits(k, nu):
    with mpmath.workdps(50):
        exact, vanishing = _factor(mpmath.mpf(k), mpmath.mpf(nu)), _beta(mpmath.mpf(k), mpmath.mpf(nu)) ** 2
    assert root_squared(k, nu) == pytest.approx(float(vanishing), rel=4e-15)
    assert normal_factor(k, nu) == pytest.approx(float(exact), rel=2e-14)


@pytest.mark.parametrize("nu", POISSONS)
@pytest.mark.parametrize("k", EXPONENTS)
def test_moduli(k, nu):
    """E* and G* are finite and positive, and those of 50 digits."""
    medium = GradedHalfSpace.between(PowerLawGraded(3.0, 2.0, k, nu))
    with mpmath.workdps(50):
        q, v = mpmath.mpf(k), mpmath.mpf(nu)
        h, beta = _factor(q, v), _beta(q, v)
        normal = 3 * h / (1 - v * v)
        shear = 6 / ((1 + q) ** 2 * (1 - v * v) / (beta**2 * h) + (1 + v) / mpmath.cos(q * mpmath.pi / 2))
    assert medium.modulus == pytest.approx(float(normal), rel=3e-14)
    assert medium.shear_modulus == pytest.approx(float(shear), rel=3e-14)


def test_gibson_is_the_limit():
    """Towards k = 1 at nu = 1/2; with any other nu the surface deforms without limit."""
    for near in (1e-4, 1e-8, 1e-12):
        assert normal_factor(1.0 - near, 0.5) == pytest.approx(0.5 * math.pi, rel=2.0 * near + 1e-14)
        assert 0.0 < normal_factor(1.0 - near, 0.3) < 4.0 * near
    assert normal_factor(1.0, 0.5) == 0.5 * math.pi


@pytest.mark.parametrize("k", [-0.99, -0.9, 0.9, 0.99, 0.9999])
def test_a_paraboloid_at_extreme_exponents(k):
    """F = 4 E* a^(k+3) / (c0^k R (1+k)^2 (k+3)), d = a^2 / ((1+k) R), and the pressure in closed form."""
    medium = GradedHalfSpace.between(PowerLawGraded(3.0, 2.0, k, 0.4))
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(5.0), medium), wk.Radius(0.3)).solve()
    scale = medium.modulus / (2.0**k * 5.0 * (1.0 + k) ** 2)
    assert contact.depth == pytest.approx(0.09 / ((1.0 + k) * 5.0), rel=1e-13)
    assert contact.force == pytest.approx(4.0 * scale * 0.3 ** (k + 3.0) / (k + 3.0), rel=1e-13)
    r = np.array([0.0, 0.1, 0.2, 0.29])
    fields = wk.restore(contact, r)
    expected = 2.0 / math.pi * scale * (0.09 - r**2) ** (0.5 * (1.0 + k))
    np.testing.assert_allclose(fields.pressure, expected, rtol=1e-10)
    np.testing.assert_allclose(fields.displacement, contact.depth - r**2 / 10.0, rtol=1e-9)
