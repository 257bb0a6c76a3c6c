"""The normal curve that impacts run through: closed forms, narrow rings of springs, and the deepest point."""

from __future__ import annotations

import math

import mpmath as mp
import pytest

import winkler as wk
from winkler.problems.normal.force_curve import NormalCurves, deepest, normal_curve
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.stiffness_ratio import common_ratio

MEDIUM = wk.HalfSpace(wk.Elastic(1.0, 0.0))


@pytest.mark.parametrize(
    ("profile", "power", "coefficient"),
    [(wk.Paraboloid(1.0), 0.5, 2.0), (wk.Cone(1.2), 1.0, 4.0 / math.pi * math.tan(1.2)), (wk.FlatPunch(0.1), 0.0, 0.2)],
    ids=["ball", "cone", "flat punch"],
)
def test_closed_forms(profile, power, coefficient):
    """K = c d^p, F and W its integrals."""
    curve = normal_curve(wk.Foundation(profile, MEDIUM), 0.02)
    for depth in (1e-6, 3e-4, 0.011, 0.02):
        stiffness = coefficient * depth**power
        expected = (stiffness, stiffness * depth / (power + 1), stiffness * depth**2 / ((power + 1) * (power + 2)))
        assert curve.at(depth) == pytest.approx(expected, rel=1e-11)
    assert curve.at(-1e-9) == (0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    "profile",
    [wk.Sphere(1.0), wk.TruncatedCone(0.05, 1.4), wk.CappedCylinder(0.1, wk.Paraboloid(1.0)), wk.PowerLaw(2.0, 3.5)],
    ids=lambda profile: type(profile).__name__,
)
def test_it_is_the_indentation(profile):
    bed = wk.Foundation(profile, MEDIUM)
    curve = normal_curve(bed, 0.02)
    for depth in (1e-4, 0.005, 0.013, 0.02):
        contact = Indentation(bed, wk.Depth(depth)).solve()
        stiffness, force, work = curve.at(depth)
        assert stiffness == pytest.approx(contact.stiffness, rel=1e-10)
        assert force == pytest.approx(contact.force, rel=1e-10)
        assert work == pytest.approx(contact.energy, rel=1e-10)


@pytest.mark.parametrize("width", [0.3, 1e-2, 1e-6, 1e-10])
def test_rings_of_springs_however_narrow(width):
    """The sums of d - gap and its square between c and d, of a ball, in closed form at 40 digits."""
    curve = normal_curve(wk.Foundation(wk.Paraboloid(1.0), MEDIUM), 0.02)
    gap, depth = 0.013 * (1.0 - width), 0.013
    with mp.workdps(40):
        c, d = mp.mpf(gap), mp.mpf(depth)
        linear = mp.mpf(4) / 3 * (d ** mp.mpf(1.5) - c ** mp.mpf(1.5)) - 2 * mp.sqrt(c) * (d - c)
        # the integral of (d - gamma)^2 dgamma / sqrt(gamma)
        power = [2 * (mp.sqrt(d) - mp.sqrt(c))]
        power.append(mp.mpf(2) / 3 * (d ** mp.mpf(1.5) - c ** mp.mpf(1.5)))
        power.append(mp.mpf(2) / 5 * (d ** mp.mpf(2.5) - c ** mp.mpf(2.5)))
        square = d * d * power[0] - 2 * d * power[1] + power[2]
    result = curve.between(gap, curve.at(gap)[0], depth)
    rounding = 1e-15 / width  # of K, of which a narrow ring takes the difference
    assert result == pytest.approx((float(linear), float(square)), rel=max(1e-12, 10.0 * rounding))


def test_the_deepest_point_stores_the_energy():
    bed = wk.Foundation(wk.RoundedPunch(0.05, 0.5), MEDIUM)
    for energy in (1e-9, 3e-6, 1e-4):
        depth = deepest(bed, energy)
        assert Indentation(bed, wk.Depth(depth)).solve().energy == pytest.approx(energy, rel=1e-12)


def test_springs_that_are_not_alike_are_refused():
    ball = wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.3)))
    assert common_ratio("Impact", ball, 0.1, "") == pytest.approx(1.4 / 1.7, rel=1e-14)
    coated = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(4.0, 0.3), thickness=0.05)], on=wk.Elastic(1.0, 0.3))
    with pytest.raises(wk.OutsideValidity, match="tangential"):
        common_ratio("Impact", wk.Foundation(wk.Paraboloid(1.0), coated), 0.1, "give another medium")


@pytest.mark.parametrize("width", [1e-9, 1e-6, 1e-3, 2e-3])
def test_a_narrow_ring_is_summed_to_rounding(width):
    """K of a paraboloid is 2 E* sqrt(R d): both sums in closed form with 40 digits."""
    bed = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace.between(wk.Elastic(210e9, 0.3)))
    curve, modulus = NormalCurves(bed, 1e-6), bed.medium.modulus
    with mp.workdps(40):
        for share in (1e-3, 0.0917, 0.31, 0.73, 0.99):
            gap = share * 1e-6
            depth = gap * (1.0 + width)
            low, high = mp.mpf(gap), mp.mpf(depth)
            inner = 2 * modulus * mp.sqrt(mp.mpf(10e-3) * low)
            power = 2 * modulus * mp.sqrt(mp.mpf(10e-3)) * mp.mpf(2) / 3
            first = power * (high**1.5 - low**1.5) - (high - low) * inner
            second = 2 * (power * (mp.mpf(2) / 5 * (high**2.5 - low**2.5) - (high - low) * low**1.5))
            second -= (high - low) ** 2 * inner
            found = curve.between(gap, curve.at(gap)[0], depth)
            scale = float(inner) * (depth - gap)
            assert abs(found[0] - float(first)) <= 2e-15 * scale
            assert abs(found[1] - float(second)) <= 2e-15 * scale * (depth - gap)
