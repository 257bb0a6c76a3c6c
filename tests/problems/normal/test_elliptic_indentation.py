"""Hertz's elliptic contact: theory's numbers, complete elliptic integrals of mpmath, and the limits of a ball."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth, Force, Radius
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.problems.normal.elliptic import EllipticIndentation
from winkler.problems.normal.indentation import Indentation
from winkler.profiles.ellipse import ContactEllipse, CurvedBodies
from winkler.profiles.power import Paraboloid
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Standing

ONE = HalfSpace(Elastic(1.0, 0.0))


@pytest.mark.parametrize(
    ("bends", "expected"),
    [
        ((0.4, 0.6), (1.0446579, 0.79738613, 0.81801886, 1.0276201)),
        ((0.25, 0.75), (1.3499607, 0.65152852, 0.7739655, 1.2132707)),
        ((0.1, 0.9), (2.0820102, 0.49458119, 0.65362614, 2.014347)),
    ],
)
def test_the_numbers_of_the_theory(bends, expected):
    """Theory 1.3: E* = F = 1, f = A x^2 + B y^2."""
    bodies = CurvedBodies(0.5 / bends[0], 0.5 / bends[1])
    result = EllipticIndentation(bodies, ONE, Force(1.0)).solve()
    statements = (result.longitudinal_semi_axis, result.lateral_semi_axis, result.depth, result.equivalent_radius)
    assert statements == pytest.approx(expected, rel=6e-8)


def test_elliptic_integrals():
    """a^3 = 3 F (K - E) / (2 pi E* m A), d = 3 F K / (2 pi E* a), with the parameter m of the ellipse that is found."""
    rx, ry, modulus, force = 0.02, 0.003, 114e9, 77.0
    result = EllipticIndentation(CurvedBodies(rx, ry), HalfSpace(Elastic(modulus, 0.0)), Force(force)).solve()
    with mpmath.workdps(30):
        m = 1 - (mpmath.mpf(result.lateral_semi_axis) / mpmath.mpf(result.longitudinal_semi_axis)) ** 2
        k, e = mpmath.ellipk(m), mpmath.ellipe(m)
        assert float((e / (1 - m) - k) / (k - e)) == pytest.approx(rx / ry, rel=1e-12)
        a = (3 * force * (k - e) / (2 * mpmath.pi * modulus * m * (mpmath.mpf(1) / (2 * rx)))) ** (mpmath.mpf(1) / 3)
        assert result.longitudinal_semi_axis == pytest.approx(float(a), rel=1e-12)
        assert result.depth == pytest.approx(float(3 * force * k / (2 * mpmath.pi * modulus * a)), rel=1e-12)


def test_the_springs_bear_the_same_forces():
    depths = np.array([1e-6, 2e-6, 5e-6])
    prescribed = EllipticIndentation(CurvedBodies(0.02, 0.005), ONE, Depth(depths))
    result, springs = prescribed.solve(), Indentation(prescribed.bed, Depth(depths)).solve()
    assert result.force == pytest.approx(springs.force, rel=1e-13)
    assert result.stiffness == pytest.approx(springs.stiffness, rel=1e-13)
    back = EllipticIndentation(CurvedBodies(0.02, 0.005), ONE, Force(result.force)).solve()
    assert back.depth == pytest.approx(depths, rel=1e-13)
    assert back.lateral_semi_axis == pytest.approx(result.lateral_semi_axis, rel=1e-13)


def test_two_equal_curvatures_are_a_ball():
    result = EllipticIndentation(CurvedBodies(0.01, 0.01), ONE, Force(1e-4)).solve()
    ball = Indentation(Foundation(Paraboloid(0.01), ONE), Force(1e-4)).solve()
    assert result.equivalent_radius == pytest.approx(0.01, rel=1e-12)
    assert result.depth == pytest.approx(ball.depth, rel=1e-12)
    assert result.longitudinal_semi_axis == pytest.approx(ball.radius, rel=1e-9)
    assert result.lateral_semi_axis == pytest.approx(ball.radius, rel=1e-9)


def test_turned_by_a_right_angle_it_is_the_same():
    one = EllipticIndentation(CurvedBodies(0.03, 0.01), ONE, Force(1.0)).solve()
    other = EllipticIndentation(CurvedBodies(0.01, 0.03), ONE, Force(1.0)).solve()
    assert one.longitudinal_semi_axis == other.lateral_semi_axis
    assert one.depth == other.depth


def test_pressures_sum_up_to_the_force():
    result = EllipticIndentation(CurvedBodies(0.03, 0.01), ONE, Force(2.0)).solve()
    a, b = result.longitudinal_semi_axis, result.lateral_semi_axis
    x, y = np.linspace(-a, a, 801), np.linspace(-b, b, 801)
    pressure = result.pressure(x[:, None], y)
    assert pressure.sum() * (x[1] - x[0]) * (y[1] - y[0]) == pytest.approx(2.0, rel=1e-4)
    assert float(pressure[400, 400]) == pytest.approx(result.peak_pressure, rel=1e-14)
    assert result.area == pytest.approx(np.pi * a * b, rel=1e-14)
    assert float(result.pressure(1.01 * a, 0.0)) == 0.0


def test_without_contact_there_is_nothing():
    result = EllipticIndentation(CurvedBodies(0.03, 0.01), ONE, Depth([-1e-6, 0.0])).solve()
    assert result.force.tolist() == [0.0, 0.0]
    assert result.peak_pressure.tolist() == [0.0, 0.0]
    assert result.stiffness.tolist() == [0.0, 0.0]
    alone = EllipticIndentation(CurvedBodies(0.03, 0.01), ONE, Force(0.0)).solve()
    assert alone.pressure(np.zeros(3), 0.0).tolist() == [0.0, 0.0, 0.0]


def test_wide_contacts_are_noted():
    small = EllipticIndentation(CurvedBodies(1.0, 0.5), ONE, Force(1e-6)).solve()
    wide = EllipticIndentation(CurvedBodies(1.0, 0.5), ONE, Force(0.1)).solve()
    assert small.validity[-1].standing is Standing.ASYMPTOTIC
    assert wide.validity[-1].standing is Standing.APPROXIMATE


def test_wrong_questions_are_refused():
    bodies = CurvedBodies(0.03, 0.01)
    with pytest.raises(InvalidInput, match="bodies is a ContactEllipse; give CurvedBodies"):
        EllipticIndentation(ContactEllipse(1.0, 2.0), ONE, Force(1.0))
    with pytest.raises(InvalidInput, match="medium is a str"):
        EllipticIndentation(bodies, "steel", Force(1.0))
    with pytest.raises(InvalidInput, match="load is a Radius"):
        EllipticIndentation(bodies, ONE, Radius(1.0))
    with pytest.raises(OutsideValidity, match="force -1 N is tensile"):
        EllipticIndentation(bodies, ONE, Force([1.0, -1.0])).solve()
    with pytest.raises(InvalidInput, match="the contact is a line"):
        EllipticIndentation(CurvedBodies(1e12, 1e-12), ONE, Force(1.0)).solve()
    with pytest.raises(InvalidInput, match="holds 2 loads"):
        EllipticIndentation(bodies, ONE, Force([1.0, 2.0])).solve().pressure(0.0, 0.0)
