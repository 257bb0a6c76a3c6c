"""Fields of twisted contacts, added to those of the pressure."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Angle, Depth, Torque
from winkler.loading.path import Path
from winkler.problems.friction.torsion import Torsion

MU = 0.5
PAIR = wk.HalfSpace.between(wk.Elastic(1.0, 0.3), wk.Elastic(1.7, 0.2))
BALL = wk.Foundation(wk.Paraboloid(1.0), PAIR)


def twisted(angles, depth=0.01):
    path = Path(np.arange(float(len(angles))), Depth(depth), Angle(np.array(angles)))
    return Torsion(BALL, Coulomb(MU), path).solve().at(-1)


STATE = twisted([0.0, 0.02, -0.005])


def test_surface():
    """Nothing slips at the axis, the traction stays below mu p, and adds up to the torque."""
    a = STATE.radius
    nodes, weights = np.polynomial.legendre.leggauss(30)
    cuts = [0.0, *(b for b, _ in STATE.springs.kinks if 0.0 < b < a), a]
    torque = 0.0
    for low, high in zip(cuts, cuts[1:], strict=False):
        share = 0.5 * (1.0 + nodes)
        r = low + (high - low) * share**2 * (3.0 - 2.0 * share)
        fields = wk.restore(STATE, r)
        assert np.all(np.abs(fields.traction) <= MU * fields.pressure * (1.0 + 1e-9) + 1e-13)
        weight = 0.5 * weights * (high - low) * 6.0 * share * (1.0 - share)
        torque += float((fields.traction * 2.0 * math.pi * r**2) @ weight)
    assert torque == pytest.approx(STATE.torque, rel=1e-8)
    np.testing.assert_allclose(fields.slip, STATE.angle * fields.r - fields.hoop_displacement, rtol=0, atol=1e-18)
    inner = wk.restore(twisted([0.0, 0.02]), 0.1 * a * np.array([0.1, 0.5, 1.0]))
    np.testing.assert_allclose(inner.slip, 0.0, atol=1e-12)
    hertz = 2.0 * PAIR.modulus * a / math.pi * np.sqrt(1.0 - (fields.r / a) ** 2)
    np.testing.assert_allclose(fields.pressure, hertz, rtol=1e-6)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_body_is_the_sum_of_pressure_and_twist(side):
    a = STATE.radius
    r, z, turn = a * np.array([0.3, 0.9, 1.4]), side * a * np.array([0.2, 0.4, 0.6]), np.array([0.4, 2.0, -1.0])
    meridian = wk.restore(wk.Indentation(BALL, wk.Radius(a)).solve(), r, z)
    twist = STATE.below(r, z)
    body = wk.restore_body(STATE, r * np.cos(turn), r * np.sin(turn), z)
    parts = (meridian.radial_stress, meridian.hoop_stress, meridian.axial_stress)
    squares = sum((one - two) ** 2 for one, two in zip(parts, (*parts[1:], parts[0]), strict=True))
    shears = meridian.shear_stress**2 + twist.axial_twist_stress**2 + twist.radial_twist_stress**2
    np.testing.assert_allclose(body.von_mises, np.sqrt(0.5 * squares + 3.0 * shears), rtol=1e-9)
    # along x: r is x and theta is y
    along = wk.restore_body(STATE, r, 0.0, z)
    np.testing.assert_allclose(along.xy_stress, twist.radial_twist_stress, rtol=1e-9, atol=1e-16)
    np.testing.assert_allclose(along.yz_stress, twist.axial_twist_stress, rtol=1e-9, atol=1e-16)
    np.testing.assert_allclose(along.y_displacement, twist.hoop_displacement, rtol=1e-9)
    np.testing.assert_allclose(along.xx_stress, meridian.radial_stress, rtol=1e-9)
    # the displacement along y, along x and along y
    upright = wk.restore_body(STATE, 0.0, r, z)
    np.testing.assert_allclose(upright.x_displacement, -along.y_displacement, rtol=1e-9)
    np.testing.assert_allclose(upright.xz_stress, -along.yz_stress, rtol=1e-9, atol=1e-16)


def test_stress_is_that_of_the_displacement():
    """Hooke, by finite differences of the displacement."""
    place, h = STATE.radius * np.array([0.5, 0.3, 0.4]), 1e-4 * STATE.radius
    words = ("x_displacement", "y_displacement", "z_displacement")

    def moved(at):
        fields = wk.restore_body(STATE, *at)
        return np.array([float(getattr(fields, word)) for word in words])

    slopes = np.array([(moved(place + h * e) - moved(place - h * e)) / (2.0 * h) for e in np.eye(3)])
    strain, shear, nu = 0.5 * (slopes + slopes.T), PAIR.first.shear, 0.3
    hooke = 2.0 * shear * (strain + nu / (1.0 - 2.0 * nu) * np.trace(strain) * np.eye(3))
    stress = wk.restore_body(STATE, *place)
    expected = [
        [stress.xx_stress, stress.xy_stress, stress.xz_stress],
        [stress.xy_stress, stress.yy_stress, stress.yz_stress],
        [stress.xz_stress, stress.yz_stress, stress.zz_stress],
    ]
    np.testing.assert_allclose(hooke, np.array(expected, dtype=float), atol=1e-6 * float(stress.von_mises))


@pytest.mark.slow
def test_peak():
    peak, alone = wk.peak_stress(STATE), wk.peak_stress(wk.Indentation(BALL, wk.Radius(STATE.radius)).solve())
    assert peak.von_mises >= alone.von_mises * (1.0 - 1e-12)  # below the axis both are the same, to rounding
    r, z = np.meshgrid(np.linspace(0.0, 1.2, 40) * STATE.radius, np.geomspace(1e-3, 2.0, 40) * STATE.radius)
    most = float(np.max(wk.restore_body(STATE, r, 0.0, z).von_mises))
    assert most <= peak.von_mises * (1.0 + 1e-9) <= most * 1.01
    punch = Torsion(
        wk.Foundation(wk.FlatPunch(0.1), PAIR), Coulomb(MU), Path([0.0, 1.0], Depth(0.01), Torque([0.0, 1e-5]))
    )
    assert math.isinf(wk.peak_stress(punch.solve().at(1)).von_mises)


def test_apart_and_refused():
    apart = twisted([0.0, 0.1], depth=-0.01)
    assert wk.peak_stress(apart).von_mises == 0.0
    np.testing.assert_array_equal(wk.restore(apart, [0.0, 0.1]).traction, 0.0)
    np.testing.assert_array_equal(wk.restore_body(apart, 0.0, 0.0, [0.1]).von_mises, 0.0)
    with pytest.raises(wk.InvalidInput, match="restore_body"):
        wk.restore(STATE, [0.1], [0.1])
    with pytest.raises(wk.InvalidInput, match="one state of a path"):
        wk.restore(Torsion(BALL, Coulomb(MU), Path([0.0], Depth(0.01), Angle(0.0))).solve(), [0.1])
