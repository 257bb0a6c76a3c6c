"""Sheared adhesive contacts against Savkoor and Briggs' closed form and the balance of energy."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

import winkler as wk
from winkler.laws.adhesion import Dugdale, ShortRange
from winkler.loading.loads import ShearForce, Shift
from winkler.materials.graded import PowerLawGraded
from winkler.materials.layered import Layer
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.problems.adhesion.shear import AdhesiveShear
from winkler.values.validity import Standing

RADIUS, WORK = 3.0e-3, 0.05
MEDIUM = wk.HalfSpace.between(wk.Elastic(2e6, 0.45), wk.Elastic(70e9, 0.2))
E, G = MEDIUM.modulus, MEDIUM.shear_modulus
BALL = wk.Foundation(wk.Paraboloid(RADIUS), MEDIUM)
PULL = math.pi * WORK * RADIUS


@pytest.mark.parametrize("load", [-1.4, -1.0, 0.0, 2.0, 50.0])
def test_savkoor_and_briggs(load):
    """(F_H - F - 3 pi w R)^2 = 6 pi w R F + 9 pi^2 w^2 R^2 - (E*/G*) F_x^2, lost where the right side vanishes."""
    force = load * PULL
    most = math.sqrt(G / E * (6.0 * PULL * force + 9.0 * PULL**2))
    shear = most * np.array([0.0, 0.3, -0.7, 0.999, 1.0])
    sheared = AdhesiveShear(BALL, ShortRange(WORK), wk.Force(force), ShearForce(shear)).solve()
    hertz = force + 3.0 * PULL + np.sqrt(np.maximum(6.0 * PULL * force + 9.0 * PULL**2 - E / G * shear**2, 0.0))
    radius = (0.75 * RADIUS * hertz / E) ** (1 / 3)
    np.testing.assert_allclose(sheared.radius[:4], radius[:4], rtol=1e-11)
    assert sheared.radius[4] == pytest.approx(radius[4], rel=1e-6)  # it turns like a square root there
    assert sheared.limit.shear_force == pytest.approx(most, rel=1e-12)
    assert sheared.limit.radius == pytest.approx((0.75 * RADIUS * (force + 3.0 * PULL) / E) ** (1 / 3), rel=1e-7)
    np.testing.assert_allclose(sheared.shift, shear / (2.0 * G * sheared.radius), rtol=1e-13)
    np.testing.assert_allclose(sheared.force, force, rtol=1e-12, atol=1e-13 * PULL)
    with pytest.raises(wk.OutsideValidity, match=r"at index 1 pulls the contact off; the limit is"):
        AdhesiveShear(BALL, ShortRange(WORK), wk.Force(force), ShearForce([0.0, 1.001 * most])).solve()


@pytest.mark.parametrize("depth", [-3e-7, 0.0, 2e-6])
def test_a_ball_at_a_depth(depth):
    """Every state pays for its surface; the greatest shift is that of an independent search at 30 digits."""
    law = ShortRange(WORK)
    with mp.workdps(30):

        def squared(a):
            return (2 * mp.pi * a * WORK - E * (a**2 / RADIUS - depth) ** 2) / G

        # d/da = 0: pi w R = 2 E* a (a^2/R - d)
        start = float(AdhesiveShear(BALL, law, wk.Depth(depth), Shift(0.0)).solve().radius)
        least = mp.findroot(lambda a: mp.pi * WORK * RADIUS - 2 * E * a * (a**2 / RADIUS - depth), 0.7 * start)
        most = mp.sqrt(squared(least))
    shift = np.array([0.0, 0.5, 0.99]) * float(most)
    sheared = AdhesiveShear(BALL, law, wk.Depth(depth), Shift(shift)).solve()
    assert sheared.limit.shift == pytest.approx(float(most), rel=1e-12)
    assert sheared.limit.radius == pytest.approx(float(least), rel=1e-7)
    stretch = sheared.radius**2 / RADIUS - depth
    paid = E * stretch**2 + G * shift**2
    np.testing.assert_allclose(paid, 2.0 * math.pi * sheared.radius * WORK, rtol=1e-11)
    assert np.all(np.diff(sheared.radius) < 0.0)
    np.testing.assert_allclose(
        sheared.force, 2 * E * (sheared.radius * depth - sheared.radius**3 / (3 * RADIUS)), rtol=1e-9
    )


def test_a_flat_punch_is_held_by_its_rim_until_it_detaches():
    punch = 1e-4
    bed = wk.Foundation(wk.FlatPunch(punch), MEDIUM)
    kendall = math.sqrt(8.0 * math.pi * E * WORK * punch**3)
    # F = -kendall/2: E S_z^2 is a quarter of 2 pi b w, three quarters are left for G u^2
    most = math.sqrt(0.75 * 2.0 * math.pi * punch * WORK / G)
    sheared = AdhesiveShear(bed, ShortRange(WORK), wk.Force(-0.5 * kendall), Shift([0.0, 0.9 * most])).solve()
    np.testing.assert_array_equal(sheared.radius, punch)
    assert sheared.limit.shift == pytest.approx(most, rel=1e-12)
    assert sheared.limit.shear_force == pytest.approx(2.0 * G * punch * most, rel=1e-12)


GRADED = GradedHalfSpace.between(PowerLawGraded(young=2e6, depth_scale=1e-4, exponent=-0.3, poisson=0.3))
FILM = CoatedHalfSpace([Layer(wk.Elastic(2e7, 0.3), 1e-5)], on=wk.Elastic(2e6, 0.3))


@pytest.mark.parametrize("medium", [GRADED, pytest.param(FILM, marks=pytest.mark.slow)], ids=["graded", "coated"])
def test_graded_and_coated_bodies_pay_for_their_surface(medium):
    bed = wk.Foundation(wk.Paraboloid(RADIUS), medium)
    first = AdhesiveShear(bed, ShortRange(WORK), wk.Force(0.0), Shift(0.0)).solve()
    shift = 0.8 * first.limit.shift
    sheared = AdhesiveShear(bed, ShortRange(WORK), wk.Force(0.0), Shift(shift)).solve()
    a = np.array([sheared.radius])
    stretch = bed.gap(a) - sheared.depth
    paid = bed.normal_stiffness(a) * stretch**2 + bed.tangential_stiffness(a) * shift**2
    np.testing.assert_allclose(paid, 2.0 * math.pi * a * WORK, rtol=1e-10)
    assert sheared.shift == shift
    assert sheared.radius < first.radius
    # k_x is twice the integral of c_T: by Gauss' rule on panels that halve towards the axis
    nodes, weights = np.polynomial.legendre.leggauss(20)
    ends = sheared.radius * 2.0 ** -np.arange(60.0)
    x = 0.5 * (ends[:-1] + ends[1:])[:, None] + 0.5 * (ends[:-1] - ends[1:])[:, None] * nodes
    whole = np.sum(
        0.5 * (ends[:-1] - ends[1:])[:, None] * weights * bed.tangential_stiffness(x.ravel()).reshape(x.shape)
    )
    assert sheared.shear_force == pytest.approx(2.0 * whole * shift, rel=1e-9)


def test_what_is_refused_and_noted():
    law = ShortRange(WORK)
    with pytest.raises(wk.InvalidInput, match="law is a Dugdale; give ShortRange"):
        AdhesiveShear(BALL, Dugdale(WORK, 1e6), wk.Force(0.0), Shift(0.0))
    with pytest.raises(wk.InvalidInput, match="normal is a Radius; give Force or Depth"):
        AdhesiveShear(BALL, law, wk.Radius(1e-5), Shift(0.0))
    with pytest.raises(wk.InvalidInput, match="lateral is a Force"):
        AdhesiveShear(BALL, law, wk.Force(0.0), wk.Force(0.0))
    with pytest.raises(wk.InvalidInput, match="give one number"):
        AdhesiveShear(BALL, law, wk.Force([0.0, 1.0]), Shift(0.0))
    with pytest.raises(wk.OutsideValidity):
        AdhesiveShear(BALL, law, wk.Force(-1.6 * PULL), Shift(0.0)).solve()
    sheared = AdhesiveShear(BALL, law, wk.Force(0.0), Shift(0.0)).solve()
    assert isinstance(sheared.radius, float)
    assert any(note.standing is Standing.APPROXIMATE and "mode mixture" in note.statement for note in sheared.validity)
