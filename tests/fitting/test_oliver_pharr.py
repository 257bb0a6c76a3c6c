"""Oliver and Pharr's reading: exact on exact elastic curves, honest about noise, and it refuses what it cannot read."""

from __future__ import annotations

import dataclasses
import math

import mpmath
import numpy as np
import pytest

import winkler as wk
from winkler.errors import InvalidInput, OutsideValidity
from winkler.fitting.curve import ForceCurve
from winkler.fitting.oliver_pharr import OliverPharr, intercept_factor, sample_young

MODULUS = 70e9 / 0.91


def paraboloid(depth, radius=1e-6):
    return 4.0 / 3.0 * MODULUS * math.sqrt(radius) * depth**1.5


def cone(depth, half_angle=1.2):
    return 2.0 / math.pi * MODULUS * math.tan(half_angle) * depth**2


DEPTH = np.linspace(2e-7, 1e-9, 400)


@pytest.mark.parametrize("exponent", ["1.05", "1.2", "1.5", "1.8", "2", "2.5"])
def test_the_intercept_factor_to_many_digits(exponent):
    with mpmath.workdps(30):
        m = mpmath.mpf(exponent)
        ratio = mpmath.gamma(m / (2 * (m - 1))) / mpmath.gamma(1 / (2 * (m - 1)))
        exact = m * (1 - 2 * (m - 1) * ratio / mpmath.sqrt(mpmath.pi))
    assert intercept_factor(float(exponent)) == pytest.approx(float(exact), rel=1e-12)
    assert intercept_factor(1.0) == 1.0


@pytest.mark.parametrize(
    ("force", "profile", "exponent", "share"),
    [
        (paraboloid, wk.Paraboloid(1e-6), 1.5, 0.5),
        (cone, wk.Cone(half_angle=1.2), 2.0, 2.0 / math.pi),
        (cone, wk.AreaFunction((math.pi * math.tan(1.2) ** 2,)), 2.0, 2.0 / math.pi),
    ],
    ids=["paraboloid", "cone", "area function"],
)
def test_elastic_curves_are_read_exactly(force, profile, exponent, share):
    found = OliverPharr(ForceCurve(DEPTH, force(DEPTH)), profile).solve()
    assert found.exponent == pytest.approx(exponent, rel=1e-8)
    assert found.final_depth == pytest.approx(0.0, abs=1e-14)
    assert found.contact_depth == pytest.approx(share * 2e-7, rel=1e-8)
    assert found.stiffness == pytest.approx(exponent * force(2e-7) / 2e-7, rel=1e-8)
    assert found.modulus == pytest.approx(MODULUS, rel=1e-8)
    assert found.force == pytest.approx(force(2e-7), rel=1e-10)
    assert found.hardness == pytest.approx(found.force / found.area, rel=1e-12)


def test_a_residual_impression():
    """The same unloading, shifted: a sunken paraboloid of another size is read at its own area."""
    final, flat = 3e-7, 5e-8
    depth = np.linspace(final + flat, final + 1e-10, 400)
    force = 4.0 / 3.0 * MODULUS * math.sqrt(1e-6) * (depth - final) ** 1.5
    found = OliverPharr(ForceCurve(depth, force), wk.Cone(half_angle=1.2)).solve()
    stiffness = 2.0 * MODULUS * math.sqrt(1e-6 * flat)
    contact = depth[0] - 0.75 * force[0] / stiffness
    area = math.pi * (contact * math.tan(1.2)) ** 2
    assert found.final_depth == pytest.approx(final, rel=1e-8)
    assert found.contact_depth == pytest.approx(contact, rel=1e-8)
    assert found.modulus == pytest.approx(0.5 * math.sqrt(math.pi / area) * stiffness, rel=1e-8)


def test_frame_contact_point_and_shape_factor():
    force = cone(DEPTH)
    curve = ForceCurve(DEPTH + 3e-8 + force / 2e6, force, 2e6)
    found = OliverPharr(curve, wk.Cone(half_angle=1.2), contact_point=3e-8, shape_factor=1.034).solve()
    assert found.modulus == pytest.approx(MODULUS / 1.034, rel=1e-8)


def test_errors_are_honest():
    """Of 30 noisy unloadings about 95 % lie within 1.96 standard errors; fewer than 24 once in a thousand tests."""
    force, inside = cone(DEPTH), np.zeros(3)
    for seed in range(30):
        noisy = force + 2e-3 * force[0] * np.random.default_rng(seed).standard_normal(400)
        found = OliverPharr(ForceCurve(DEPTH, noisy), wk.Cone(half_angle=1.2)).solve()
        truth = (2.0 * force[0] / DEPTH[0], MODULUS, force[0] / (math.pi * (math.tan(1.2) * 4e-7 / math.pi) ** 2))
        read = (found.stiffness, found.modulus, found.hardness)
        inside += np.abs(np.subtract(read, truth)) < 1.96 * found.standard_errors[[2, 5, 6]]
    assert inside.min() >= 24


def test_the_samples_modulus():
    diamond = wk.Elastic(1141e9, 0.07)
    pair = wk.HalfSpace.between(wk.Elastic(72e9, 0.17), diamond)
    assert sample_young(pair.modulus, 0.17, diamond) == pytest.approx(72e9, rel=1e-12)
    assert sample_young(MODULUS, 0.3, wk.Rigid()) == pytest.approx(70e9, rel=1e-12)
    with pytest.raises(OutsideValidity, match="leaves nothing for the sample"):
        sample_young(2e12, 0.3, diamond)


def test_what_cannot_be_read_is_refused():
    curve = ForceCurve(DEPTH, cone(DEPTH))
    with pytest.raises(InvalidInput, match="limits of the fitted part"):
        OliverPharr(curve, wk.Cone(half_angle=1.2), upper=0.3)
    with pytest.raises(InvalidInput, match="shape_factor is 0.0"):
        OliverPharr(curve, wk.Cone(half_angle=1.2), shape_factor=0.0)
    with pytest.raises(InvalidInput, match="has no unloading of at least 10 points"):
        OliverPharr(ForceCurve(DEPTH[::-1], cone(DEPTH[::-1])), wk.Cone(half_angle=1.2)).solve()
    with pytest.raises(InvalidInput, match="look at signs and contact_point"):
        OliverPharr(dataclasses.replace(curve, force=-curve.force), wk.Cone(half_angle=1.2)).solve()
    with pytest.raises(InvalidInput, match="points lie between 0.4 and 0.98"):
        OliverPharr(curve.chosen(np.arange(0, 400, 35)), wk.Cone(half_angle=1.2)).solve()
    small = wk.Measured(np.linspace(0.0, 1e-8, 50), np.linspace(0.0, 1e-8, 50) / math.tan(1.2))
    with pytest.raises(OutsideValidity, match="beyond the tip, which is known up to a radius of 1e-08 m"):
        OliverPharr(curve, small).solve()
