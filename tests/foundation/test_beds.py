"""Beds: Foundation, PlaneFoundation and what is pressed into them."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

import winkler as wk
from winkler.foundation.bed import PressedSprings
from winkler.values.value import value

UNIT = wk.HalfSpace.between(wk.Elastic(1.0, 0.0))
X = np.array([0.0, 0.05, 0.2, 0.5])


def test_a_foundation_is_its_profile_over_its_medium():
    profile, medium = wk.TruncatedCone(1.2, 0.1), wk.HalfSpace.between(wk.Elastic(3.0, 0.3), wk.Elastic(2.0, 0.1))
    bed = wk.Foundation(profile, medium)
    for word in ("height", "slope", "gap", "gap_slope"):
        np.testing.assert_array_equal(getattr(bed, word)(X), getattr(profile, word)(X))
    np.testing.assert_allclose(bed.gap_load(X), 2.0 * medium.modulus * profile.gap_integral(X), rtol=1e-15)
    np.testing.assert_allclose(bed.stiffness(X), 2.0 * medium.modulus * X, rtol=1e-15)
    np.testing.assert_array_equal(bed.normal_stiffness(X), medium.modulus)
    np.testing.assert_array_equal(bed.tangential_stiffness(X), medium.shear_modulus)
    assert bed.kinks == ((0.1, pytest.approx(0.1 / math.tan(1.2))),)
    assert bed.reach == bed.rim == bed.size == math.inf
    assert bed.rising
    assert bed.notes == medium.notes


def test_what_is_pressed():
    bed = wk.Foundation(wk.TruncatedCone(1.2, 0.1), UNIT)
    depth = float(bed.gap(np.array([0.5]))[0])
    pressed = PressedSprings(bed, depth, 0.5)
    np.testing.assert_allclose(pressed.value(X), depth - bed.gap(X), rtol=1e-15)
    np.testing.assert_allclose(pressed.slope(X), -bed.gap_slope(X), rtol=1e-15)
    assert pressed.edge == 0.0
    assert pressed.kinks == bed.kinks
    assert PressedSprings(bed, 0.0, 0.05).kinks == ()
    pinned = PressedSprings(wk.Foundation(wk.CappedCylinder(0.5, wk.Cone(1.2)), UNIT), 1.0, 0.5)
    assert pinned.edge == pytest.approx(1.0 - 0.5 * math.pi * 0.5 / math.tan(1.2), rel=1e-14)


# ------------------------------------------------------------------------------------------------ plane foundation

PLANES = {
    # g(x) as the height of a shape: kappa_n f^{-1}; the body that belongs to it: r^n / kappa_n
    "parabola": (wk.Paraboloid(0.5), lambda r: r**2 / 2.0, lambda r: r),
    "wedge": (
        wk.Cone(1.2),
        lambda r: 2.0 / math.pi * r / math.tan(1.2),
        lambda r: 2.0 / math.pi / math.tan(1.2) + 0.0 * r,
    ),
    "cubic": (wk.PowerLaw(2.0, 3.0), lambda r: 8.0 / (3.0 * math.pi) * r**3, lambda r: 8.0 / math.pi * r**2),
}


@pytest.mark.parametrize("name", PLANES)
def test_the_body_of_a_plane_profile(name):
    """f by T2 undoes T1: a wedge of springs belongs to a cone whose slope is 2/pi of the wedge's."""
    plane, height, slope = PLANES[name]
    bed = wk.PlaneFoundation(plane, UNIT)
    np.testing.assert_allclose(bed.height(X), height(X), rtol=1e-13, atol=1e-16)
    np.testing.assert_allclose(bed.slope(X), slope(X), rtol=1e-13, atol=1e-16)
    np.testing.assert_array_equal(bed.gap(X), plane.height(X))
    np.testing.assert_array_equal(bed.gap_slope(X), plane.slope(X))
    assert bed.height(np.array(0.2)).shape == bed.slope(np.array(0.2)).shape == ()
    for word in ("height", "slope", "gap", "gap_slope"):
        assert getattr(bed, word)(X[:, None]).shape == (4, 1), word


@pytest.mark.parametrize("name", ["parabola", "wedge", "cubic"])
@pytest.mark.parametrize("load", [wk.Depth(0.05), wk.Force(0.02), wk.Radius(0.3)])
def test_a_plane_foundation_answers_like_the_body_that_belongs_to_it(name, load):
    plane, _, _ = PLANES[name]
    twin = {
        "parabola": wk.Paraboloid(1.0),
        "wedge": wk.Cone(math.atan(math.pi / 2.0 * math.tan(1.2))),
        "cubic": wk.PowerLaw(8.0 / (3.0 * math.pi), 3.0),
    }[name]
    medium = wk.HalfSpace.between(wk.Elastic(3.0, 0.3))
    got = wk.Indentation(wk.PlaneFoundation(plane, medium), load).solve()
    expected = wk.Indentation(wk.Foundation(twin, medium), load).solve()
    for word in ("depth", "force", "radius", "stiffness", "energy"):
        assert getattr(got, word) == pytest.approx(getattr(expected, word), rel=1e-11), word
    r = np.array([0.05, 0.5, 0.999, 1.01, 3.0]) * expected.radius
    fields, compared = wk.restore(got, r), wk.restore(expected, r)
    np.testing.assert_allclose(fields.pressure, compared.pressure, rtol=1e-9)
    np.testing.assert_allclose(fields.displacement, compared.displacement, rtol=1e-10)
    np.testing.assert_allclose(fields.gap, compared.gap, atol=1e-12)


def _wedge_beyond(r, b, t):
    """(2/pi) Int_b^r t (x - b)/sqrt(r^2 - x^2) dx with x = r sin."""
    if r <= b:
        return 0.0
    return float(2 / mp.pi * mp.quad(lambda angle: t * (r * mp.sin(angle) - b), [mp.asin(b / r), mp.pi / 2]))


def test_a_plane_profile_with_a_flat_and_a_kink():
    """g = (x - b)+ tan: the load F = E* tan (a - b)(a + b) ... = 2 E* Int (d - g) on paper."""
    b, t = 0.2, 1.0 / math.tan(1.2)
    bed = wk.PlaneFoundation(wk.TruncatedCone(1.2, b), UNIT)
    a = 0.5
    contact = wk.Indentation(bed, wk.Radius(a)).solve()
    assert contact.depth == pytest.approx(t * (a - b), rel=1e-14)
    assert contact.force == pytest.approx(2.0 * (b * t * (a - b) + 0.5 * t * (a - b) ** 2), rel=1e-12)
    assert wk.Indentation(bed, wk.Force(contact.force)).solve().radius == pytest.approx(a, rel=1e-12)
    r = np.array([0.1, 0.3, 0.6])
    exact = [_wedge_beyond(mp.mpf(v), b, t) for v in r]
    np.testing.assert_allclose(bed.height(r), exact, rtol=1e-12, atol=1e-18)


def test_a_plane_profile_that_belongs_to_a_ring():
    """A dimple in g: the springs are sound, the body is no disc."""
    bed = wk.PlaneFoundation(wk.Formula("r**2 - 8*r**2*exp(-(r/w)**2)/10", w=0.3, reach=2.0), UNIT)
    with pytest.raises(wk.WinklerError):
        wk.Indentation(wk.PlaneFoundation(wk.Wavy(0.1, 1.0), UNIT), wk.Depth(0.15)).solve()
    assert wk.Indentation(bed, wk.Depth(1.5)).solve().force > 0.0


def test_notes_reach_and_rim_come_from_the_plane_profile():
    bed = wk.PlaneFoundation(wk.CappedCylinder(0.5, wk.Berkovich()), UNIT)
    assert bed.reach == bed.rim == 0.5
    assert bed.notes == (*UNIT.notes, *wk.Berkovich().notes)
    assert wk.PlaneFoundation(wk.Sphere(0.7), UNIT).size == 0.7
    np.testing.assert_array_equal(bed.stiffness(X), 2.0 * X)
    np.testing.assert_array_equal(bed.normal_stiffness(X), 1.0)
    np.testing.assert_allclose(bed.tangential_stiffness(X), UNIT.shear_modulus)


@pytest.mark.parametrize("medium", [None, 1.0, wk.Elastic(1.0, 0.3)])
def test_what_is_no_medium(medium):
    with pytest.raises(
        wk.InvalidInput, match=r"^PlaneFoundation: the medium is a \w+; give a medium, such as HalfSpace"
    ):
        wk.PlaneFoundation(wk.Paraboloid(1.0), medium)


# ------------------------------------------------------------------------------------- plane profiles on other media

GRADED = wk.GradedHalfSpace(wk.PowerLawGraded(1.0, 1.0, -0.6, 0.3))
COATED = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(5.0, 0.3), 0.5)], on=wk.Elastic(1.0, 0.3))


def test_a_plane_parabola_on_a_graded_half_space():
    """g = x^2 / ((1 + k) R) belongs to the paraboloid of radius R, whatever the depth."""
    k, big = GRADED.exponent, 0.7
    plane = wk.PlaneFoundation(wk.Paraboloid(0.5 * (1.0 + k) * big), GRADED)
    body = wk.Foundation(wk.Paraboloid(big), GRADED)
    mine, theirs = (wk.Indentation(bed, wk.Force(0.3)).solve() for bed in (plane, body))
    assert (mine.depth, mine.radius, mine.energy) == pytest.approx((theirs.depth, theirs.radius, theirs.energy), 1e-10)
    r = np.array([0.0, 0.1, 0.5, 2.0])
    np.testing.assert_allclose(plane.height(r), r**2 / (2.0 * big), rtol=1e-10)
    np.testing.assert_allclose(plane.slope(r), r / big, rtol=1e-9, atol=1e-11)


@pytest.mark.slow
def test_a_plane_parabola_on_a_coating():
    """The force by a rule for Int k' g; the restored surface follows the body that belongs to g."""
    bed = wk.PlaneFoundation(wk.Paraboloid(0.5), COATED)
    contact = wk.Indentation(bed, wk.Radius(0.8)).solve()
    s, w = np.polynomial.legendre.leggauss(60)
    x = 0.4 * (s + 1.0)
    force = 0.8 * float(w @ (COATED.normal_stiffness(x) * (0.64 - x**2)))
    assert contact.force == pytest.approx(force, rel=1e-11)
    r = np.array([0.0, 0.2, 0.5, 0.79])
    np.testing.assert_allclose(wk.restore(contact, r).displacement, 0.64 - bed.height(r), rtol=0, atol=1e-9)


@value
class Equivalent(wk.Shape):
    """The equivalent profile of a ball on the coating, given as if it were a plane profile."""

    def height(self, r):
        return COATED.gap(wk.Paraboloid(1.0), r)

    def slope(self, r):
        return COATED.gap_slope(wk.Paraboloid(1.0), r)


def test_the_body_behind_the_springs_of_a_ball_on_a_coating():
    bed = wk.PlaneFoundation(Equivalent(), COATED)
    r = np.array([0.1, 0.4, 0.9])
    np.testing.assert_allclose(bed.height(r), 0.5 * r**2, rtol=1e-8)
