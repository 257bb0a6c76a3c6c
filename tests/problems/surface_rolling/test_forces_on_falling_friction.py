"""Given forces, friction that falls with the velocity of slip, and dissimilar bodies, all together."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.values.errors import NotConverged

STEEL = wk.Elastic(210e9, 0.28)
ALIKE = wk.HalfSpace.between(STEEL, STEEL)
DISSIMILAR = wk.HalfSpace.between(STEEL, wk.Elastic(70e9, 0.33))
NORMAL, STATIC, SPEED = 106.7e3, 0.4, 30.0
WHEEL = wk.SampledProfile([20e-3, 38e-3], wk.CurvedBodies(0.625, 1.789), (20, 20))
FALLING = wk.FallingFriction(STATIC, 0.16, 1.0)


def rolled(drive, medium=ALIKE, friction=FALLING) -> wk.SurfaceRollingSolution:
    return wk.SurfaceRolling(WHEEL, medium, wk.Force(NORMAL), friction, drive, speed=SPEED).solve()


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("medium", [ALIKE, DISSIMILAR], ids=["alike", "dissimilar"])
@pytest.mark.parametrize("by_moment", [False, True], ids=["spin", "moment"])
def test_forces_lead_back_to_the_creepages_of_the_rising_branch(medium, by_moment):
    xi, eta, spin = np.array([3e-4, 1.5e-3, 2.5e-3]), np.array([-2e-4, 1e-3, 0.0]), np.array([0.05, -0.1, 0.1])
    given = rolled(wk.Creepage(xi, eta, spin), medium)
    twist = wk.Torque(given.moment) if by_moment else wk.Spin(spin)
    found = rolled(wk.CreepForce(given.longitudinal_force, given.lateral_force, twist), medium)
    assert np.max(found.misfit) <= 1e-7
    np.testing.assert_allclose(found.longitudinal_force, given.longitudinal_force, atol=1e-7 * STATIC * NORMAL)
    # pressures and tractions of dissimilar bodies agree to 1e-5
    error = 1e-6 if medium is ALIKE else 1e-5
    np.testing.assert_allclose(found.longitudinal_creepage, xi, atol=error * 2.5e-3)
    np.testing.assert_allclose(found.lateral_creepage, eta, atol=error * 2.5e-3)
    np.testing.assert_allclose(found.spin_creepage, spin, atol=10 * error)
    last = found.last
    mu = FALLING.at_velocity(SPEED * np.hypot(*last.creep))
    assert np.all(np.hypot(*last.traction) <= mu * last.pressure + 1e-6 * np.max(last.pressure))
    power = np.sum(np.sum(last.traction * last.creep, axis=0))
    assert power == pytest.approx(np.sum(mu * last.pressure * np.hypot(*last.creep)), rel=1e-6)


@pytest.mark.slow
def test_dissimilar_bodies_under_friction_that_does_not_fall():
    drive = wk.CreepForce(20e3, 5e3, wk.Torque(20.0))
    flat = rolled(drive, DISSIMILAR, wk.FallingFriction(STATIC, STATIC, 1.0))
    coulomb = rolled(drive, DISSIMILAR, wk.Coulomb(STATIC))
    for name in ("longitudinal_creepage", "spin_creepage", "rolling_resistance", "stick_share", "misfit"):
        assert getattr(flat, name) == getattr(coulomb, name)


@pytest.mark.slow
def test_up_to_the_maximum_of_the_creep_curve_and_not_beyond():
    """Just below it the lesser one of two creepages is found; above it none, and the sentence says why."""
    creep = np.linspace(2e-3, 5e-3, 61)
    curve = rolled(wk.Creepage(longitudinal=creep)).longitudinal_force
    most, top = float(np.max(curve)), creep[int(np.argmax(curve))]
    assert most < 0.95 * STATIC * NORMAL
    assert creep[0] < top < creep[-1]
    near = rolled(wk.ShearForce(0.998 * most))
    assert near.longitudinal_force == pytest.approx(0.998 * most, rel=1e-6)
    assert 0.8 * top < near.longitudinal_creepage < top
    sentence = r"after 21 rolls; .* beyond the maximum of the creep curve has creepages only: give smaller"
    with pytest.raises(NotConverged, match=sentence):
        rolled(wk.ShearForce(1.01 * most))


@pytest.mark.long
def test_forces_after_one_near_the_maximum_of_the_creep_curve():
    """Where the curve is flat no stiffness leads on: each force begins from rest, in any order."""
    most = float(np.max(rolled(wk.Creepage(longitudinal=np.linspace(2e-3, 5e-3, 61))).longitudinal_force))
    push = most * np.array([0.999, 0.1, -0.999, 0.5])
    together = rolled(wk.CreepForce(push)).longitudinal_creepage
    np.testing.assert_array_equal(together, [float(rolled(wk.CreepForce(one)).longitudinal_creepage) for one in push])


@pytest.mark.slow
def test_a_force_that_nearly_slides_after_its_opposite():
    """While all slides the distance from a force stays as it is: that is no sign that friction does not bear it."""
    push = STATIC * NORMAL * np.array([0.99999, -0.99999, 0.01])
    done = rolled(wk.CreepForce(push), friction=wk.Coulomb(STATIC))
    np.testing.assert_allclose(done.longitudinal_force, push, atol=1e-7 * STATIC * NORMAL)


@pytest.mark.slow
def test_a_force_and_a_moment_of_which_friction_bears_each_alone():
    with pytest.raises(NotConverged, match=r"after [24]1 rolls; .* together they may exceed the friction limit"):
        rolled(wk.CreepForce(0.95 * STATIC * NORMAL, 0.0, wk.Torque(100.0)), friction=wk.Coulomb(STATIC))
