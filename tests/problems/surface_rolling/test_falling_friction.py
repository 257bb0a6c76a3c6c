"""Rolling under friction that falls with the velocity of slip: full slip, Coulomb, the falling branch, energy."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.values.errors import InvalidInput, OutsideValidity

STATIC, KINETIC, VELOCITY = 0.4, 0.16, 1.0
STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.28), wk.Elastic(210e9, 0.28))
NORMAL = 106.7e3
WHEEL = wk.SampledProfile([14.5e-3, 28.5e-3], wk.CurvedBodies(0.625, 1.789), (32, 32))
FALLING = wk.FallingFriction(STATIC, KINETIC, VELOCITY)


def rolled(friction, creepage, speed: float = 0.0, **more) -> wk.SurfaceRollingSolution:
    return wk.SurfaceRolling(WHEEL, STEEL, wk.Force(NORMAL), friction, creepage, speed=speed, **more).solve()


def test_the_coefficients_of_polach():
    """Of a dry rail, mu_0 = 0.55, A = 0.40, B = 0.60 s/m: at 2 m/s 0.55 (0.6 exp(-1.2) + 0.4)."""
    dry = wk.FallingFriction(0.55, 0.40 * 0.55, velocity=1.0 / 0.60)
    assert float(dry.at_velocity(np.array(2.0))) == pytest.approx(0.55 * (0.6 * np.exp(-1.2) + 0.4), rel=1e-14)
    assert float(dry.fall(np.array(2.0))) == pytest.approx(0.55 * 0.6 * 0.6 * np.exp(-1.2), rel=1e-14)


def test_a_coefficient_that_does_not_fall_is_that_of_coulomb():
    creepage = wk.Creepage([3e-4, 2e-3], [0.0, 1e-3], 0.1)
    same, coulomb = (
        rolled(wk.FallingFriction(STATIC, STATIC, 1.0), creepage, 30.0),
        rolled(wk.Coulomb(STATIC), creepage),
    )
    for name in ("longitudinal_force", "lateral_force", "moment", "stick_share", "misfit"):
        np.testing.assert_array_equal(getattr(same, name), getattr(coulomb, name))


@pytest.mark.parametrize("direction", [(1.0, 0.0), (0.0, 1.0), (0.6, -0.8)])
def test_full_slip(direction):
    """F = mu(V xi) F_N: what the displacements add to the slip vanishes on average over the pressure (Betti)."""
    creep, speed = np.array([0.5, 1.0, 2.0]), 1.0
    done = rolled(FALLING, wk.Creepage(creep * direction[0], creep * direction[1]), speed)
    mu = KINETIC + (STATIC - KINETIC) * np.exp(-speed * creep / VELOCITY)
    np.testing.assert_array_equal(done.stick_share, 0.0)
    np.testing.assert_allclose(done.longitudinal_force, mu * NORMAL * direction[0], rtol=1e-4, atol=1e-4 * NORMAL)
    np.testing.assert_allclose(done.lateral_force, mu * NORMAL * direction[1], rtol=1e-4, atol=1e-4 * NORMAL)
    np.testing.assert_allclose(done.saturation, mu / STATIC, rtol=1e-4)


@pytest.mark.slow
def test_the_creep_curve_has_a_maximum_and_falls():
    creep = np.geomspace(1e-4, 0.3, 12)
    done, coulomb = (rolled(law, wk.Creepage(longitudinal=creep), 30.0) for law in (FALLING, wk.Coulomb(STATIC)))
    force, most = done.longitudinal_force, int(np.argmax(done.longitudinal_force))
    assert 4 <= most <= 7
    assert np.all(np.diff(force[: most + 1]) > 0.0)
    assert np.all(np.diff(force[most:]) < 0.0)
    assert KINETIC * NORMAL < force[-1] < 1.01 * KINETIC * NORMAL
    assert np.all(force < coulomb.longitudinal_force)
    # little slips under small creepage, and slowly
    assert force[0] == pytest.approx(coulomb.longitudinal_force[0], rel=2e-3)
    slow = rolled(FALLING, wk.Creepage(longitudinal=creep[:8]), 1e-3)
    np.testing.assert_allclose(slow.longitudinal_force, coulomb.longitudinal_force[:8], rtol=1e-4)


def test_each_pixel_has_the_coefficient_of_its_own_slip():
    speed = 60.0
    done = rolled(FALLING, wk.Creepage(1.5e-3, 1e-3, 0.2), speed)
    last = done.last
    size, creep = np.hypot(*last.traction), np.hypot(*last.creep)
    mu = KINETIC + (STATIC - KINETIC) * np.exp(-speed * creep / VELOCITY)
    peak = np.max(last.pressure)
    assert np.all(size <= mu * last.pressure + 1e-6 * peak)
    np.testing.assert_allclose(size[last.slipping], (mu * last.pressure)[last.slipping], atol=1e-6 * peak)
    assert 0.05 < done.stick_share < 0.5
    assert done.misfit <= 1e-7
    assert np.ptp(mu[last.slipping]) > 0.02


def test_friction_takes_what_creepage_and_spin_give():
    """But for the pixels, whose part in it falls with the creepage."""
    pixel = WHEEL.pixel[0] * WHEEL.pixel[1]
    for creepage, part in ((wk.Creepage(1.5e-3, 1e-3, 0.2), 7e-2), (wk.Creepage(1e-2, 5e-3, 0.2), 1e-2)):
        done = rolled(FALLING, creepage, 60.0)
        lost = float(np.sum(done.last.traction * done.last.creep)) * pixel
        assert lost == pytest.approx(float(done.loss_per_distance), rel=part)


@pytest.mark.parametrize(("change", "error", "sentence"), [
    ({"speed": 0.0}, InvalidInput, "no speed is given; give the speed of rolling in m/s, or Coulomb"),
    ({"speed": -1.0}, InvalidInput, "SurfaceRolling: speed is -1"),
    ({"speed": 1e4}, OutsideValidity, r"at the creepage \(0.001, 0\) .* friction falls 13.* times as fast"),
    ({"friction": wk.LinearSlipWeakening(0.4, 0.3, 1e-6)}, InvalidInput, "or FallingFriction, whose coefficient"),
])  # fmt: skip
def test_what_it_refuses(change, error, sentence):
    stated = {"friction": FALLING, "creepage": wk.Creepage(1e-3), "speed": 20.0}
    with pytest.raises(error, match=sentence):
        rolled(**(stated | change))


def test_what_the_law_refuses():
    with pytest.raises(InvalidInput, match="kinetic coefficient 0.5 is above the static one, 0.3"):
        wk.FallingFriction(0.3, 0.5, 1.0)
    with pytest.raises(InvalidInput, match="FallingFriction: velocity is 0"):
        wk.FallingFriction(0.3, 0.2, 0.0)
