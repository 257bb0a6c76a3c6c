"""Simplified rolling under friction that falls with the velocity of slip: full slip, Coulomb, strips, elements."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.numerics.springs.fastsim import rolled
from winkler.reference.rolling import simplified_creep_force
from winkler.values.errors import InvalidInput
from winkler.values.validity import Standing

STATIC, KINETIC, VELOCITY = 0.4, 0.16, 1.0
FALLING = wk.FallingFriction(STATIC, KINETIC, VELOCITY)
STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.28), wk.Elastic(210e9, 0.28))
ELLIPSE = wk.ContactEllipse(6e-3, 5e-3)
NORMAL = 80e3


def rolling(friction, creepage, speed: float = 0.0, **more) -> wk.SimplifiedRollingSolution:
    return wk.SimplifiedRolling(ELLIPSE, STEEL, friction, creepage, wk.Force(NORMAL), speed=speed, **more).solve()


def left(slip, speed: float) -> np.ndarray:
    return KINETIC + (STATIC - KINETIC) * np.exp(-speed * np.asarray(slip) / VELOCITY)


def plain_march(drive: np.ndarray, fall: np.ndarray, count: int) -> np.ndarray:
    """Kalker's algorithm as published, of first order, its bound times what is left of friction at the rigid slip."""
    y = -1.0 + (np.arange(count) + 0.5) * 2.0 / count
    front = np.sqrt(1.0 - y * y)
    step, p, total = 2.0 * front / count, np.zeros((2, count)), np.zeros(2)
    for k in range(count):
        x = front - (k + 0.5) * step
        p = p + step * np.array([drive[0] - drive[2] * y, drive[1] + drive[3] * x])
        slip = np.hypot(fall[0] - fall[2] * y, fall[1] + fall[3] * x)
        bound = (fall[4] + (1.0 - fall[4]) * np.exp(-slip)) * (1.0 - x * x - y * y)
        p = p * np.minimum(1.0, bound / np.hypot(p[0], p[1]))
        total += np.sum(p * step, axis=1) * 2.0 / count
    return total / (0.5 * math.pi)


def over_disc(drives: np.ndarray, falls: np.ndarray, count: int) -> np.ndarray:
    sums = np.empty((len(drives), 4))
    rolled(drives, falls, count, sums)
    return sums[:, :2] / (0.5 * math.pi)


DRIVES = np.array([[0.5, 0.2, 1.0, 1.0], [0.5, -0.6, 3.0, 3.0], [0.0, 0.0, 2.0, 2.0], [1.0, -2.0, 2.0, 1.0]])
FALLS = np.array([
    [0.4, 0.1, 0.6, 0.7, 0.4], [0.2, -0.2, 1.0, 1.2, 0.4], [0.0, 0.0, 0.5, 0.5, 0.2], [0.5, -1.0, 0.8, 0.5, 0.3],
])  # fmt: skip


def test_a_coefficient_that_does_not_fall_is_that_of_coulomb():
    creepage = wk.Creepage([3e-4, 2e-3], [0.0, 1e-3], [0.1, 2.0])
    same = rolling(wk.FallingFriction(STATIC, STATIC, 1.0), creepage, 30.0)
    coulomb = rolling(wk.Coulomb(STATIC), creepage)
    for name in ("longitudinal_force", "lateral_force", "moment", "saturation", "loss_per_distance"):
        np.testing.assert_allclose(getattr(same, name), getattr(coulomb, name), rtol=1e-12)


@pytest.mark.parametrize("direction", [(1.0, 0.0), (0.0, -1.0)])
def test_full_slip(direction):
    """F = mu(V xi) F_N, whatever the flexibilities."""
    creep, speed = np.array([0.1, 0.5, 1.0, 2.0]), 1.3
    done = rolling(FALLING, wk.Creepage(creep * direction[0], creep * direction[1]), speed)
    mu = left(creep, speed)
    np.testing.assert_allclose(done.longitudinal_force, mu * NORMAL * direction[0], rtol=1e-12, atol=1e-9)
    np.testing.assert_allclose(done.lateral_force, mu * NORMAL * direction[1], rtol=1e-12, atol=1e-9)
    np.testing.assert_allclose(done.saturation, mu / STATIC, rtol=1e-12)


def test_without_spin_the_closed_form_of_coulomb_at_each_coefficient():
    """Sticking, partial and full slip: the friction that is left is the same all over the contact."""
    creep, speed = np.geomspace(1e-4, 0.1, 9), 30.0
    done = rolling(FALLING, wk.Creepage(longitudinal=creep), speed, count=256)
    mu = left(creep, speed)
    a, b = done.longitudinal_semi_axis, done.lateral_semi_axis
    shear = 210e9 / (2.0 * 1.28)
    tau = done.coefficients.longitudinal * shear * a * b * creep / (mu * NORMAL)
    np.testing.assert_allclose(done.longitudinal_force, mu * NORMAL * simplified_creep_force(tau), rtol=1e-6)
    most = int(np.argmax(done.longitudinal_force))
    assert 2 < most < 8


def test_full_spin_sees_the_velocity_at_each_place():
    """The moment of mu(V phi r) p about the middle of a circle, by quadrature."""
    circle, spin, speed = wk.ContactEllipse(6e-3, 6e-3), 3e5, 1.0 / (3e5 * 6e-3)
    spun = wk.SimplifiedRolling(
        circle, STEEL, FALLING, wk.Creepage(spin=spin), wk.Force(NORMAL), count=512, speed=speed
    )
    r, weight = np.polynomial.legendre.leggauss(60)
    r, weight = 0.5 * (r + 1.0), 0.5 * weight
    pressure = 2.0 * NORMAL / math.pi * (1.0 - r * r)
    moment = 6e-3 * np.sum(weight * left(r, 1.0) * pressure * 2.0 * math.pi * r * r)
    assert spun.solve().moment == pytest.approx(moment, rel=1e-4)


@pytest.mark.parametrize("which", range(4))
def test_against_a_plain_march(which):
    """Two grids of the first-order algorithm, extrapolated."""
    drive, fall = DRIVES[which], FALLS[which]
    coarse, fine = plain_march(drive, fall, 40), plain_march(drive, fall, 120)
    extrapolated = (3.0 * fine - coarse) / 2.0
    result = over_disc(DRIVES, FALLS, 256)[which]
    np.testing.assert_allclose(result, extrapolated, atol=1.5e-3)
    coulomb = over_disc(DRIVES, np.ones((4, 5)), 256)[which]
    assert np.max(np.abs(coulomb - result)) > 10.0 * np.max(np.abs(extrapolated - result))


@pytest.mark.slow
def test_second_order():
    """Eight times as many strips and steps: about 64 times as exact."""
    best = over_disc(DRIVES, FALLS, 1024)
    coarse, fine = (np.max(np.abs(over_disc(DRIVES, FALLS, n) - best), axis=1) for n in (32, 256))
    assert np.max(coarse) < 1e-3
    assert np.all(fine < coarse / 40.0)


def test_tractions_are_what_was_summed_and_on_their_bound():
    done = rolling(FALLING, wk.Creepage(2e-3, 1e-3, 0.4), 100.0, count=96)
    field = done.traction
    a, b = 6e-3, 5e-3
    slip = np.hypot(2e-3 - 0.4 * field.y, 1e-3 + 0.4 * field.x)
    peak = 2.0 * NORMAL / (math.pi * a * b)
    bound = left(slip, 100.0) * peak * np.maximum(1.0 - (field.x / a) ** 2 - (field.y / b) ** 2, 0.0)
    np.testing.assert_allclose(field.traction[field.sliding], bound[field.sliding], atol=1e-9 * peak)
    assert np.all(field.traction <= bound * (1.0 + 1e-9) + 1e-9 * peak)
    assert 0.1 < np.mean(field.sliding) < 0.9
    angle = np.pi * ((np.arange(96) + 0.5) / 96 - 0.5)
    along = np.trapezoid(field.longitudinal[:, ::-1], field.x[:, ::-1], axis=1)
    assert np.sum(along * np.cos(angle)) * b * np.pi / 96 == pytest.approx(done.longitudinal_force, rel=5e-3)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("speed", "law"), [(60.0, wk.FallingFriction(0.3, 0.12, 5.0)), (20.0, wk.FallingFriction(0.4, 0.16, 0.1))]
)
def test_beside_boundary_elements(speed, law):
    """As near to exact theory, in which friction follows the whole slip, as under Coulomb's law, and far from that."""
    wheel, creepage = wk.CurvedBodies(0.625, 1.789), wk.Creepage(longitudinal=[5e-4, 3e-3, 1e-2, 5e-2])
    tread, load = wk.SampledProfile([14.5e-3, 28.5e-3], wheel, (32, 32)), wk.Force(106.7e3)
    simple = wk.SimplifiedRolling(wheel, STEEL, law, creepage, load, speed=speed).solve()
    exact = wk.SurfaceRolling(tread, STEEL, load, law, creepage, speed=speed).solve()
    still = wk.SimplifiedRolling(wheel, STEEL, wk.Coulomb(law.static_coefficient), creepage, load).solve()
    apart = np.abs(simple.saturation - exact.saturation)
    assert np.max(apart) < 0.05
    assert apart[2] < 0.006
    assert apart[3] < 1e-3
    assert np.max(np.abs(still.saturation - exact.saturation)) > 4.0 * np.max(apart)


def test_loses_energy():
    rng = np.random.default_rng(9)
    xi, eta = rng.uniform(-1e-2, 1e-2, (2, 200))
    done = rolling(FALLING, wk.Creepage(xi, eta, rng.uniform(-2.0, 2.0, 200)), 40.0, count=24)
    assert np.min(done.loss_per_distance) > 0.0
    assert np.max(done.saturation) < 1.0


def test_the_note_states_what_is_left_out():
    """2 V L p_0 / a times the fall of mu where the bodies slip most slowly."""
    done = rolling(FALLING, wk.Creepage(longitudinal=1e-3), 10.0)
    shear, peak = 210e9 / (2.0 * 1.28), 2.0 * NORMAL / (math.pi * 6e-3 * 5e-3)
    softest = 8.0 / (3.0 * min(done.coefficients.longitudinal, done.coefficients.lateral) * shear)
    change = 2.0 * 10.0 * softest * peak * (STATIC - KINETIC) / VELOCITY * math.exp(-10.0 * 1e-3 / VELOCITY)
    (note,) = (note for note in done.validity if "Friction depends on the slip velocity" in note.statement)
    assert f"by at most about {100.0 * change:.2g} per cent" in note.statement
    assert note.standing is Standing.APPROXIMATE
    steep = rolling(wk.FallingFriction(STATIC, KINETIC, 0.01), wk.Creepage(longitudinal=1e-4), 10.0)
    (note,) = (note for note in steep.validity if "Friction depends on the slip velocity" in note.statement)
    assert note.standing is Standing.OUTSIDE


def test_a_speed_is_asked_for_where_it_acts_and_named_where_it_does_not():
    with pytest.raises(
        InvalidInput, match=r"SimplifiedRolling: FallingFriction depends on .* give the speed of rolling"
    ):
        rolling(FALLING, wk.Creepage(longitudinal=1e-3))
    with pytest.raises(InvalidInput, match="or FallingFriction, whose coefficient"):
        rolling(wk.LinearSlipWeakening(0.4, 0.3, 1e-6), wk.Creepage(longitudinal=1e-3))
    slow, fast = (rolling(wk.Coulomb(0.3), wk.Creepage(longitudinal=1e-3), speed) for speed in (0.0, 20.0))
    assert fast.longitudinal_force == slow.longitudinal_force
    assert [any("the speed has no effect" in note.statement for note in done.validity) for done in (slow, fast)] == [
        False,
        True,
    ]
