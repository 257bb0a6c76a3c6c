"""What adhesion does to the surface: pressure to the edge, displacement and gap outside, overlap."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.laws.adhesion import ShortRange
from winkler.materials.graded import PowerLawGraded
from winkler.materials.layered import Layer
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.values.validity import Standing

R, W, E = 1e-3, 0.05, 4e6 / 3.0
GEL = wk.HalfSpace.between(wk.Elastic(young=1e6, poisson=0.5))
BALL = wk.Foundation(wk.Paraboloid(R), GEL)


@pytest.mark.parametrize("force", [-2e-4, 0.0, 1e-3])
def test_johnson_kendall_roberts_surface(force):
    contact = AdhesiveIndentation(BALL, ShortRange(W), wk.Force(force)).solve()
    a, d = contact.radius, contact.depth
    stretch = math.sqrt(2.0 * math.pi * a * W / E)
    r = a * np.array([0.0, 0.4, 0.9, 0.999, 1.0 - 1e-9])
    root = np.sqrt((a - r) * (a + r))
    fields = wk.restore(contact, r)
    exact = 2.0 * E * root / (math.pi * R) - E * stretch / (math.pi * root)
    np.testing.assert_allclose(fields.pressure, exact, rtol=1e-9, atol=1e-6)
    np.testing.assert_array_equal(fields.gap, 0.0)
    # K_I is the strength of that singularity: tension sqrt(2 pi (a - r)) -> K_I
    limit = -fields.pressure[-1] * math.sqrt(2.0 * math.pi * (a - r[-1]))
    assert contact.stress_intensity == pytest.approx(limit, rel=1e-6)
    r = a * np.array([1.0001, 1.5, 4.0])
    outside = wk.restore(contact, r)
    asin = np.arcsin(a / r)
    moved = 2.0 / math.pi * (d * asin - (r**2 * asin - a * np.sqrt(r**2 - a**2)) / (2.0 * R))
    np.testing.assert_allclose(outside.displacement, moved, rtol=1e-10)
    np.testing.assert_allclose(outside.gap, r**2 / (2.0 * R) - d + moved, rtol=1e-9)
    np.testing.assert_array_equal(outside.pressure, 0.0)


def test_every_plane_below_carries_the_force():
    contact = AdhesiveIndentation(BALL, ShortRange(W), wk.Force(2e-4)).solve()
    depth = 0.8 * contact.radius
    x, weights = np.polynomial.legendre.leggauss(120)
    t = 0.5 * (1.0 + x)
    places, measure = depth * 3.0 * t / (1.0 - t), 1.5 * weights * depth / (1.0 - t) ** 2
    axial = wk.restore(contact, places, np.full(places.shape, depth)).axial_stress
    assert -float(measure @ (axial * 2.0 * math.pi * places)) == pytest.approx(contact.force, rel=1e-6)


@pytest.mark.slow
def test_graded_and_coated_pressure_carries_the_force():
    """The restored pressure with its singular edge, integrated, is the force of the springs."""
    graded = GradedHalfSpace.between(PowerLawGraded(1e6, 1e-4, 0.4, 0.3))
    coated = CoatedHalfSpace((Layer(wk.Elastic(3e6, 0.4), 1e-4),), on=wk.Elastic(1e6, 0.4))
    x, weights = np.polynomial.legendre.leggauss(100)
    for medium, power in ((graded, 0.4), (coated, 0.0)):
        contact = AdhesiveIndentation(wk.Foundation(wk.Sphere(R), medium), ShortRange(W), wk.Force(3e-4)).solve()
        a = contact.radius
        # a^2 - r^2 = a^2 s^(2/(1+k)) takes (a^2 - r^2)^((k-1)/2) away
        s = 0.5 * (1.0 + x)
        power_ = 2.0 / (1.0 + power)
        r = a * np.sqrt(1.0 - s**power_)
        measure = math.pi * a**2 * power_ * s ** (power_ - 1.0) * 0.5 * weights
        assert float(measure @ wk.restore(contact, r).pressure) == pytest.approx(contact.force, rel=1e-7)
        edge = wk.restore(contact, np.array([0.999999 * a])).pressure[0]
        assert edge < 0.0
    assert contact.stress_intensity == pytest.approx(math.sqrt(2.0 * 3e6 / (1.0 - 0.16) * W), rel=1e-10)


def test_overlap_is_reported():
    """A steep wave outside a narrow contact touches again: reported, not hidden."""
    steep = wk.Sum((wk.Paraboloid(R), wk.Wavy(3e-6, 4e-5)))
    gentle = wk.Sum((wk.Paraboloid(R), wk.Wavy(2e-8, 4e-5)))
    soft = wk.HalfSpace.between(wk.Elastic(young=1e6, poisson=0.5))
    for profile, standing in ((gentle, Standing.EXACT), (steep, Standing.OUTSIDE)):
        contact = AdhesiveIndentation(wk.Foundation(profile, soft), ShortRange(1e-3), wk.Radius(1e-5)).solve()
        notes = [note for note in contact.validity if "overlap" in note.statement]
        assert [note.standing for note in notes] == [standing]
    r = np.linspace(1.02, 4.0, 400) * 1e-5
    assert np.min(wk.restore(contact, r).gap) < 0.0
