"""Oblique impacts on coatings: closed forms, the homogeneous limit, energies, and rings that slide each by itself."""

from __future__ import annotations

import functools
import math

import numpy as np
import pytest

import winkler as wk
from winkler.problems.impact.impact import Impact
from winkler.problems.impact.motion import ImpactProblem
from winkler.problems.impact.ring_march import march_rings
from winkler.problems.normal.force_curve import normal_curve
from winkler.problems.ring_slip.ring_table import ring_table

STEEL, CARBON = wk.Elastic(210e9, 0.3), wk.Elastic(600e9, 0.2)
COATED = wk.CoatedHalfSpace([wk.Layer(CARBON, thickness=100e-6)], on=STEEL)
SAME = wk.CoatedHalfSpace([wk.Layer(STEEL, thickness=100e-6)], on=STEEL)
MASS, SPEED, FLAT = 0.03, 0.02, 100e-6
PUNCH = wk.Foundation(wk.FlatPunch(FLAT), COATED)


def stiffnesses(mean=True):
    """k and k_x of the punch; k_x by tractions along the motion alone, as rings have, or by all of them."""
    place = np.array([FLAT])
    normal = float(COATED.punch_stiffness(place)[0])
    table = ring_table("Impact", PUNCH, 0.3 if mean else math.inf, FLAT)
    return normal, float(np.sum(table.weights)) * table.modulus


@pytest.mark.slow
@pytest.mark.parametrize("mean", [True, False])
def test_a_flat_punch_that_sticks_swings_along_the_surface(mean):
    """It is pressed for half a period, and swings sideways with sqrt(kappa k_x); what it holds at the end is lost."""
    normal, shear = stiffnesses(mean)
    assert shear == pytest.approx(float(COATED.punch_shear_stiffness(np.array([FLAT]))[0]), rel=2e-3 if mean else 1e-9)
    thrown = Impact(PUNCH, wk.Coulomb(5e4 if mean else math.inf), MASS, SPEED, lateral_velocity=0.005, count=5).solve()
    assert thrown.duration == pytest.approx(math.pi * math.sqrt(MASS / normal), rel=1e-10)
    angle = math.pi * math.sqrt(shear / normal)
    assert thrown.sliding_velocity[-1] / 0.005 == pytest.approx(math.cos(angle), abs=2e-5)
    assert thrown.dissipation[-1] == pytest.approx(0.5 * MASS * (0.005 * math.sin(angle)) ** 2, rel=1e-3)
    assert thrown.restitution == pytest.approx(1.0, abs=1e-10)


@pytest.mark.slow
def test_a_punch_that_sticks_to_a_body_graded_in_depth_swings_along_the_surface():
    graded = wk.DepthGradedHalfSpace(wk.ExponentialGrading(100e9, 300e9, depth_scale=1e-4, poisson=0.3))
    punch, place = wk.Foundation(wk.FlatPunch(FLAT), graded), np.array([FLAT])
    thrown = Impact(punch, wk.Coulomb(math.inf), MASS, SPEED, lateral_velocity=0.005, count=5).solve()
    ratio = float(graded.punch_shear_stiffness(place)[0] / graded.punch_stiffness(place)[0])
    assert thrown.sliding_velocity[-1] / 0.005 == pytest.approx(math.cos(math.pi * math.sqrt(ratio)), abs=2e-5)


@pytest.mark.parametrize("coefficient", [0.3, 1e-6])
def test_what_slides_all_the_time_loses_twice_the_coefficient_times_the_momentum(coefficient):
    grazing = Impact(PUNCH, wk.Coulomb(coefficient), MASS, SPEED, lateral_velocity=5.0, count=5).solve()
    impulse = 2.0 * coefficient * MASS * SPEED
    assert 5.0 - grazing.lateral_velocity[-1] == pytest.approx(impulse / MASS, rel=1e-5)
    np.testing.assert_allclose(grazing.balance, 1.0, atol=1e-11)
    assert [stage.side for stage in grazing.stages] == [1]


@functools.cache
def rings(medium, count):
    """The normal curve of a ball, and its rings without a coefficient."""
    bed, depth = wk.Foundation(wk.Paraboloid(10e-3), medium), 1e-6
    widest = float(wk.Indentation(bed, wk.Depth(depth)).solve().radius)
    curve = normal_curve(bed, depth)
    return bed, curve, depth, widest, count


def marched(medium, coefficient, angle, mobility, count=100, refinement=1):
    """March from a ratio of sliding to approach, over the coefficient; the energy is that of the depth of 1 um."""
    bed, curve, depth, widest, _ = rings(medium, count)
    speed = math.sqrt(2.0 * curve.at(depth)[2] / MASS)
    sliding = angle * coefficient * speed
    motion = ImpactProblem(curve, depth, MASS, mobility / MASS, speed, sliding, 1.0, coefficient)
    table = ring_table("Impact", bed, coefficient, widest, count)
    return motion, march_rings(motion, table, refinement=refinement)


CASES = [
    (0.3, 2.0, 3.5),
    pytest.param((0.3, 0.5, 3.5), marks=pytest.mark.slow),
    pytest.param((0.1, 4.0, 1.0), marks=pytest.mark.slow),
    pytest.param((0.6, 9.0, 3.5), marks=pytest.mark.slow),
]


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES, ids=str)
def test_a_layer_of_the_same_solid_is_a_half_space(case):
    """The march without a grid on a half-space; errors fall with the square of rings and steps."""
    coefficient, angle, mobility = case
    errors = []
    for count, refinement in ((50, 1), (100, 2)):
        motion, march = marched(SAME, coefficient, angle, mobility, count, refinement)
        bed = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace(STEEL))
        inertia = math.inf if mobility == 1.0 else MASS / (mobility - 1.0)
        exact = Impact(
            bed, wk.Coulomb(coefficient), MASS, motion.velocity, lateral_velocity=motion.sliding, inertia=inertia,
            lever=0.0 if mobility == 1.0 else 1.0, count=41,
        ).solve()  # fmt: skip
        shear = np.interp(exact.time, march.time, march.shear) - exact.shear_force
        errors.append(
            [abs(march.sliding[-1] - exact.sliding_velocity[-1]) / motion.sliding,
             abs(march.lost[-1] / exact.dissipation[-1] - 1.0), np.max(np.abs(shear)) / np.max(exact.force)]
        )  # fmt: skip
    assert np.all(np.array(errors[0]) < 3e-4)
    assert np.all(np.array(errors[1]) < 3e-5)


@pytest.mark.slow
def test_friction_never_gives_energy_and_momentum_is_kept():
    rng = np.random.default_rng(23)
    for _ in range(3):
        mobility = rng.uniform(1.0, 6.0)
        motion, march = marched(COATED, rng.uniform(0.05, 1.5), 10.0 ** rng.uniform(-1.0, 1.0), mobility, 40)
        energy = 0.5 * march.sliding**2 / motion.mobility + march.stored
        assert np.all(np.diff(march.lost) >= 0.0)
        np.testing.assert_allclose(energy + march.lost, energy[0], rtol=1e-11)
        force = np.array([motion.curve.at(depth)[1] for depth in march.depth.tolist()])
        assert np.all(np.abs(march.shear) <= motion.coefficient * (force + 1e-4 * np.max(force)))
        impulse = np.trapezoid(march.shear, march.time)
        assert motion.sliding - march.sliding[-1] == pytest.approx(motion.mobility * impulse, abs=3e-4 * motion.sliding)
        assert march.depth[-1] == march.shear[-1] == march.stored[-1] == 0.0


@pytest.mark.slow
def test_a_thin_coating_is_its_base():
    def speed(medium):
        bed, law = wk.Foundation(wk.Paraboloid(10e-3), medium), wk.Coulomb(0.3)
        return float(Impact(bed, law, MASS, SPEED, lateral_velocity=0.002, count=3).solve().sliding_velocity[-1])

    found = speed(wk.CoatedHalfSpace([wk.Layer(CARBON, thickness=2e-6)], on=STEEL))
    assert found == pytest.approx(speed(wk.HalfSpace(STEEL)), abs=2e-4)
