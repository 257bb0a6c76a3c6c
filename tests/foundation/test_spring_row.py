"""Springs: a bed as a row of separate springs, whose force curve is a polygon with its corners on the true one."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

MEDIUM = wk.HalfSpace.between(wk.Elastic(2.0, 0.3), wk.Elastic(5.0, 0.2))
BED = wk.Foundation(wk.Paraboloid(1.0), MEDIUM)
SHAPES = {
    "paraboloid": (wk.Paraboloid(1.0), 0.5),
    "cone": (wk.Cone(1.2), 0.5),
    "sphere": (wk.Sphere(1.0), 0.6),
    "truncated cone": (wk.TruncatedCone(1.2, 0.1), 0.4),
    "rounded punch": (wk.RoundedPunch(0.2, 1.0), 0.5),
    "pinned": (wk.CappedCylinder(0.3, wk.Paraboloid(1.0)), 0.3),
}


def test_places_and_stiffnesses():
    """Under a paraboloid F = 4/3 E* g^(3/2); the stiffness of a spring is what the slope of its chord jumps by."""
    springs = wk.Springs.of(BED, 0.5, 11)
    x = 0.05 * np.arange(11)
    np.testing.assert_allclose(springs.position, x, atol=1e-15)
    np.testing.assert_allclose(springs.gap, x**2, atol=1e-16)
    np.testing.assert_allclose(springs.mindlin_ratio, MEDIUM.shear_modulus / MEDIUM.modulus, rtol=1e-14)
    chord = 4.0 / 3.0 * MEDIUM.modulus * np.diff(x**3) / np.diff(x**2)
    expected = np.diff(np.concatenate([[0.0], chord, [2.0 * MEDIUM.modulus * 0.5]]))
    np.testing.assert_allclose(springs.stiffness, expected, rtol=1e-12)
    np.testing.assert_allclose(springs.stiffness.sum(), MEDIUM.modulus, rtol=1e-14)
    np.testing.assert_array_equal(springs.tangential_stiffness, springs.stiffness * springs.mindlin_ratio)


@pytest.mark.parametrize("name", SHAPES)
def test_the_force_is_true_where_a_spring_just_touches(name):
    shape, radius = SHAPES[name]
    bed = wk.Foundation(shape, MEDIUM)
    springs = wk.Springs.of(bed, radius, 20)
    assert springs.stiffness.min() > 0.0
    exact = wk.Indentation(bed, wk.Depth(springs.gap[1:])).solve().force
    np.testing.assert_allclose([springs.force(d) for d in springs.gap[1:]], exact, rtol=1e-12)
    between = 0.5 * (springs.gap[1:] + springs.gap[:-1])
    exact = wk.Indentation(bed, wk.Depth(between)).solve().force
    assert all(springs.force(d) > f for d, f in zip(between, exact, strict=True)), "a chord lies above its curve"


def test_beyond_a_rim_every_spring_is_pressed():
    bed = wk.Foundation(wk.CappedCylinder(0.3, wk.Paraboloid(1.0)), MEDIUM)
    springs = wk.Springs.of(bed, 0.3, 20)
    exact = wk.Indentation(bed, wk.Depth(0.2)).solve().force
    assert springs.force(0.2) == pytest.approx(exact, rel=1e-13)
    np.testing.assert_allclose(springs.depth(np.array([exact])), 0.2, rtol=1e-13)


def test_a_flat_end_is_one_spring():
    springs = wk.Springs.of(wk.Foundation(wk.FlatPunch(0.5), MEDIUM), 0.5, 7)
    np.testing.assert_array_equal(springs.position, [0.5])
    np.testing.assert_allclose(springs.stiffness, [2.0 * MEDIUM.modulus * 0.5], rtol=1e-15)
    assert springs.force(0.1) == pytest.approx(2.0 * MEDIUM.modulus * 0.5 * 0.1, rel=1e-14)
    springs = wk.Springs.of(wk.Foundation(wk.TruncatedCone(1.2, 0.1), MEDIUM), 0.4, 40)
    assert springs.position[0] == 0.1
    assert springs.stiffness[0] > 2.0 * MEDIUM.modulus * 0.1


def test_depth_is_the_inverse_of_force():
    springs = wk.Springs.of(BED, 0.5, 30)
    depths = np.linspace(0.0, 0.3, 50)
    forces = np.array([springs.force(d) for d in depths])
    np.testing.assert_allclose(springs.depth(forces), depths, atol=1e-15)
    assert springs.force(-0.1) == 0.0


@pytest.mark.parametrize("exponent", [-0.2, 0.3])
def test_in_graded_media(exponent):
    """The ratio of stiffnesses is a number even at the axis, where they vanish or diverge."""
    medium = wk.GradedHalfSpace(wk.PowerLawGraded(1.0, 1.0, exponent, 0.3))
    bed = wk.Foundation(wk.Paraboloid(1.0), medium)
    springs = wk.Springs.of(bed, 0.5, 20)
    np.testing.assert_allclose(springs.mindlin_ratio, springs.mindlin_ratio[-1], rtol=1e-13)
    exact = wk.Indentation(bed, wk.Depth(springs.gap[1:])).solve().force
    np.testing.assert_allclose([springs.force(d) for d in springs.gap[1:]], exact, rtol=1e-12)


def test_in_a_coating_the_ratio_changes_from_spring_to_spring():
    medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(10.0, 0.2), 0.2)], wk.Elastic(1.0, 0.4))
    springs = wk.Springs.of(wk.Foundation(wk.Paraboloid(1.0), medium), 0.5, 20)
    assert np.ptp(springs.mindlin_ratio) > 0.05
    inner = springs.position[1:]
    expected = medium.tangential_stiffness(inner) / medium.normal_stiffness(inner)
    np.testing.assert_allclose(springs.mindlin_ratio[1:], expected, rtol=1e-14)


@pytest.mark.parametrize(("reach", "count"), [(0.0, 10), (-1.0, 10), (0.5, 1), (float("nan"), 5)])
def test_bad_numbers(reach, count):
    with pytest.raises(wk.InvalidInput, match=r"^Springs: reach is .* m and count .*; give a positive reach and 2 spr"):
        wk.Springs.of(BED, reach, count)


def test_beyond_the_bed():
    for profile in (wk.Sphere(0.4), wk.FlatPunch(0.4)):
        with pytest.raises(wk.OutsideValidity, match=r"the reach of 0.5 m is beyond the bed's, 0.4 m; give less\.$"):
            wk.Springs.of(wk.Foundation(profile, MEDIUM), 0.5, 10)


def test_a_falling_gap_is_refused():
    wavy = wk.Foundation(wk.Formula("r**2 / 2 + 0.05 * (1 - cos(30 * r))", reach=1.0), MEDIUM)
    with pytest.raises(wk.OutsideValidity, match=r"^Springs: g decreases somewhere below the reach"):
        wk.Springs.of(wavy, 0.8, 200)
