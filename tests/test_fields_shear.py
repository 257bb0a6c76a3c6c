"""Fields of sheared contacts: traction, slip, displacement of the surface and stresses, from any history."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

import winkler as wk
from winkler.foundation.bed import PressedSprings
from winkler.foundation.sheared import ShearedSprings
from winkler.laws.friction import Coulomb
from winkler.loading.path import Path
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.problems.friction.sheared_springs import sheared_by_pieces
from winkler.problems.friction.tangential import Tangential

MU, A, C, R = 0.4, 1.2, 0.7, 3.0
PAIR = wk.HalfSpace.between(wk.Elastic(1.0, 0.3), wk.Elastic(1.7, 0.2))
ONE = wk.HalfSpace.between(wk.Elastic(1.0, 0.3))


def mindlin(medium=PAIR, profile=None, a=A, c=C, mu=MU):
    """A contact that sticks up to c: u_t = min(U, beta (d - gamma))."""
    bed = wk.Foundation(profile or wk.Paraboloid(R), medium)
    depth, stick = (float(part) for part in bed.gap(np.array([a, c])))
    beta = mu * float(bed.normal_stiffness(np.array([a]))[0] / bed.tangential_stiffness(np.array([a]))[0])
    shift = beta * (depth - stick)
    sheared = sheared_by_pieces(bed, depth, shift, [0.0, stick, depth], [shift, shift], [shift, 0.0])
    return SimpleNamespace(sheared=sheared)


def along_y(state, share=1.0):
    """The same contact, sheared along y (and by the rest of `share` along x)."""
    one = state.sheared
    turned = [np.stack([(1.0 - share) * part, share * part], axis=-1) for part in (one.shift, one.slopes, one.steps)]
    return SimpleNamespace(
        sheared=ShearedSprings(one.pressed, one.mindlin_ratio, turned[0], one.depths, one.radii, turned[1], turned[2])
    )


T = np.array([0.0, 0.2, C / A - 1e-9, C / A + 1e-9, 0.8, 0.999, 1.0, 1.001, 1.5, 20.0])


def test_mindlin_traction():
    """tau = mu p0 [sqrt(1 - r^2/a^2) - (c/a) sqrt(1 - r^2/c^2)]."""
    r = A * T
    p0 = 2.0 * PAIR.modulus * A / (math.pi * R)
    outer, inner = (np.sqrt(np.maximum((b - r) * (b + r), 0.0)) for b in (A, C))
    fields = wk.restore(mindlin(), r)
    np.testing.assert_allclose(fields.traction, MU * p0 / A * (outer - inner), rtol=1e-11, atol=1e-14)
    np.testing.assert_allclose(fields.pressure, p0 / A * outer, rtol=1e-11, atol=1e-14)


def test_displacement_and_slip_of_the_surface():
    """Differences of the displacements under two Hertz pressures; no slip where the springs stick."""
    r = A * T
    state = mindlin()
    shift = state.sheared.shift
    beta = MU * PAIR.modulus / PAIR.shear_modulus

    def hertz(a):
        s = np.maximum(r / a, 1.0)
        outside = a**2 / math.pi * ((2.0 - s**2) * np.arcsin(1.0 / s) + np.sqrt((s - 1.0) * (s + 1.0)))
        return np.where(r <= a, a**2 - 0.5 * r**2, outside) / R

    fields = wk.restore(state, r)
    expected = beta * (hertz(A) - hertz(C))
    near = T < 2.0
    np.testing.assert_allclose(fields.tangential_displacement[near], expected[near], rtol=1e-10)
    assert fields.tangential_displacement[-1] == pytest.approx(expected[-1], rel=1e-4)  # the closed form cancels
    np.testing.assert_allclose(fields.slip, shift - fields.tangential_displacement, rtol=0, atol=1e-15)
    np.testing.assert_allclose(fields.slip[:3], 0.0, atol=1e-14 * shift)
    assert np.all(fields.slip[3:] > 0.0)


@pytest.mark.parametrize(
    "medium",
    [wk.GradedHalfSpace.between(wk.PowerLawGraded(1.0, 1.0, 0.4, 0.25)), ONE],
    ids=["graded", "homogeneous"],
)
@pytest.mark.parametrize(
    "profile", [wk.Cone(1.4), wk.TruncatedCone(1.4, 0.3), wk.PowerLaw(0.2, 4.0)], ids=["cone", "truncated", "fourth"]
)
def test_traction_is_a_difference_of_pressures(medium, profile):
    """Ciavarella, Jaeger: tau = mu [p(r; a) - p(r; c)] of any profile, also on a graded half-space."""
    r = np.array([0.05, 0.29, 0.31, 0.5, 0.69, 0.71, 1.0, 1.19, 1.3])
    bed = wk.Foundation(profile, medium)
    contacts = [wk.restore(wk.Indentation(bed, wk.Radius(radius)).solve(), r).pressure for radius in (A, C)]
    got = wk.restore(mindlin(medium, profile), r).traction
    np.testing.assert_allclose(got, MU * (contacts[0] - contacts[1]), rtol=1e-8, atol=1e-12)


def test_stuck_punch_jumps_at_its_edge():
    """A pinned punch whose springs never slide: tau = ratio U E* / (pi sqrt(b^2 - r^2)), and a step inside another."""
    bed = wk.Foundation(wk.FlatPunch(A), PAIR)
    ratio = PAIR.shear_modulus / PAIR.modulus
    r = np.array([0.0, 0.5, 1.1, 1.3])
    one = SimpleNamespace(sheared=sheared_by_pieces(bed, 0.02, 0.01, [0.0, 0.02], [0.01], [0.01]))
    expected = np.where(r < A, ratio * PAIR.modulus * 0.01 / (math.pi * np.sqrt(np.abs(A**2 - r**2))), 0.0)
    np.testing.assert_allclose(wk.restore(one, r).traction, expected, rtol=1e-12)
    np.testing.assert_allclose(wk.restore(one, r).slip[:3], 0.0, atol=1e-16)
    assert math.isinf(wk.peak_stress(one).von_mises)
    ball = wk.Foundation(wk.Paraboloid(R), PAIR)
    d, e = A**2 / R, C**2 / R
    stepped = SimpleNamespace(sheared=sheared_by_pieces(ball, d, 0.01, [0.0, e, d], [0.01, 0.0], [0.01, 0.0]))
    expected = np.where(r < C, PAIR.shear_modulus * 0.01 / (math.pi * np.sqrt(np.abs(C**2 - r**2))), 0.0)
    np.testing.assert_allclose(wk.restore(stepped, r).traction, expected, rtol=1e-12)


def test_pinned_punch_that_slides():
    """Full sliding of a flat punch: tau = mu p."""
    bed = wk.Foundation(wk.FlatPunch(A), PAIR)
    d = 0.02
    beta = MU * PAIR.modulus / PAIR.shear_modulus
    state = SimpleNamespace(sheared=sheared_by_pieces(bed, d, 1.0, [0.0, d], [beta * d], [0.0]))
    fields = wk.restore(state, [0.0, 0.6, 1.19])
    np.testing.assert_allclose(fields.traction, MU * fields.pressure, rtol=1e-12)


def test_every_history_obeys_friction():
    """A to and fro with changing depth: |tau| <= mu p everywhere, and the traction adds up to the shear force."""
    rng = np.random.default_rng(5)
    bed = wk.Foundation(wk.Paraboloid(R), PAIR)
    most = MU * PAIR.modulus / PAIR.shear_modulus
    depths = rng.uniform(0.2, 1.0, 24)
    shifts = most * rng.uniform(-1.0, 1.0, 24)
    solution = Tangential(bed, Coulomb(MU), Path(np.arange(24.0), wk.Depth(depths), wk.Shift(shifts))).solve()
    nodes, weights = gauss_legendre(80)
    for index in range(0, 24, 3):
        state = solution.at(index)
        r = np.linspace(0.0, 1.2 * state.radius, 400)
        fields = wk.restore(state, r)
        assert np.all(np.abs(fields.traction) <= MU * fields.pressure * (1.0 + 1e-9) + 1e-12)
        cuts = [0.0, *(b for b in state.sheared.radii if b < state.radius), state.radius]
        total = 0.0
        for low, high in zip(cuts, cuts[1:], strict=False):
            # r^2 runs through the piece with its ends drawn together: square roots at both are gone
            share = nodes**2 * (3.0 - 2.0 * nodes)
            place = np.sqrt(low**2 + (high**2 - low**2) * share)
            weight = 6.0 * nodes * (1.0 - nodes) * weights * math.pi * (high**2 - low**2)
            total += float(wk.restore(state, place).traction @ weight)
        assert total == pytest.approx(state.shear_force, abs=1e-9 * MU * state.force)


def test_shift_of_the_surface_in_closed_form():
    """Johnson (1985), eq. 3.91, under full sliding; sum over both bodies, and along y as along x."""
    a, q0 = A, MU * 2.0 * PAIR.modulus * A / (math.pi * R)
    state = mindlin(c=1e-9)
    x, y = np.array([[0.3, -0.7, 0.0], [0.5, 0.4, 1.1]])
    along, across = np.zeros(3), np.zeros(3)
    for body in (PAIR.first, PAIR.second):
        nu, length = body.poisson, math.pi * q0 / (32.0 * body.shear * a)
        along += length * (4.0 * (2.0 - nu) * a**2 - (4.0 - 3.0 * nu) * x**2 - (4.0 - nu) * y**2)
        across += length * 2.0 * nu * x * y
    got = wk.restore_shift(state, x, y)
    np.testing.assert_allclose(got, np.stack([along, across], axis=-1), rtol=1e-9, atol=1e-15)
    turned = wk.restore_shift(along_y(state), -y, x)
    np.testing.assert_allclose(turned, np.stack([-across, along], axis=-1), rtol=1e-9, atol=1e-15)


def test_shift_is_the_difference_of_the_bodies():
    """On the surface the field of the first body less that of the second, both of the traction alone."""
    state = along_y(mindlin(), share=0.3)
    x, y = np.array([[0.3, -0.7, 1.5, 1.0], [0.5, 0.4, 0.2, -0.4]])
    first, second = (wk.restore_body(state, x, y, z) for z in (0.0, -1e-12))
    normal = [wk.restore_body(wk.Indentation(state.sheared.pressed.bed, wk.Radius(A)).solve(), x, y, z)
              for z in (0.0, -1e-12)]  # fmt: skip
    got = wk.restore_shift(state, x, y)
    for axis, word in enumerate(("x_displacement", "y_displacement")):
        parts = [getattr(one, word) - getattr(two, word) for one, two in zip((first, second), normal, strict=True)]
        np.testing.assert_allclose(parts[0] - parts[1], got[:, axis], rtol=1e-9)


def test_stick_zone_is_rigid():
    """No point within c moves against another, whatever Poisson's ratio."""
    state = mindlin()
    got = wk.restore_shift(state, [0.0, 0.3, -0.5, 0.1], [0.0, 0.3, 0.4, -0.68])
    np.testing.assert_allclose(got, [[state.sheared.shift, 0.0]] * 4, rtol=1e-12, atol=1e-16)


def test_body_without_shear_is_the_axisymmetric_one():
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(R), PAIR), wk.Radius(A)).solve()
    x, y, z = np.array([[0.3, 0.0, -1.0, 0.8], [0.4, 0.0, 0.5, 0.0], [0.2, 0.5, -0.7, 0.0]])
    body, meridian = wk.restore_body(contact, x, y, z), wk.restore(contact, np.hypot(x, y), z)
    np.testing.assert_allclose(body.von_mises, meridian.von_mises, rtol=1e-12)
    np.testing.assert_allclose(body.principal, meridian.principal, rtol=1e-10, atol=1e-14)
    np.testing.assert_allclose(body.max_shear, meridian.max_shear, rtol=1e-10)
    np.testing.assert_allclose(body.zz_stress, meridian.axial_stress, rtol=1e-12)
    np.testing.assert_allclose(np.hypot(body.x_displacement, body.y_displacement), np.abs(meridian.radial_displacement))


def test_stress_along_y_is_that_along_x_turned():
    state = mindlin()
    x, y, z = np.array([[0.3, -0.6, 1.4], [0.5, 0.1, -0.3], [0.2, 0.6, 0.4]])
    one, two = wk.restore_body(state, x, y, z), wk.restore_body(along_y(state), -y, x, z)
    for first, second, sign in (
        ("xx_stress", "yy_stress", 1.0), ("yy_stress", "xx_stress", 1.0), ("zz_stress", "zz_stress", 1.0),
        ("xy_stress", "xy_stress", -1.0), ("xz_stress", "yz_stress", 1.0), ("yz_stress", "xz_stress", -1.0),
        ("x_displacement", "y_displacement", 1.0), ("y_displacement", "x_displacement", -1.0),
    ):  # fmt: skip
        np.testing.assert_allclose(getattr(two, second), sign * getattr(one, first), rtol=1e-9, atol=1e-14)


def test_second_body_feels_the_reaction():
    """Alike bodies: turned by half a turn about the normal, the second one is the first."""
    same = wk.HalfSpace.between(wk.Elastic(1.0, 0.3), wk.Elastic(1.0, 0.3))
    state = mindlin(same)
    x, y, z = np.array([[0.3, -0.6, 1.4], [0.5, 0.1, -0.3], [0.2, 0.6, 0.4]])
    one, two = wk.restore_body(state, x, y, z), wk.restore_body(state, -x, -y, -z)
    for word, sign in (("xx_stress", 1.0), ("xy_stress", 1.0), ("xz_stress", -1.0), ("x_displacement", -1.0)):
        np.testing.assert_allclose(getattr(two, word), sign * getattr(one, word), rtol=1e-10)
    np.testing.assert_array_equal(two.z, -z)


@pytest.mark.slow
def test_peak_of_a_sliding_ball():
    """With much friction at the trailing edge: Hamilton's closed form there.  With little below: a search on a grid."""
    nu, mu = 0.3, 0.6
    p0 = 2.0 * ONE.modulus * A / (math.pi * R)
    radial, hoop = (1.0 - 2.0 * nu) / 3.0, -(1.0 - 2.0 * nu) / 3.0
    xx, yy = radial + mu * math.pi * (4.0 + nu) / 8.0, hoop + mu * math.pi * 3.0 * nu / 8.0
    peak = wk.peak_stress(mindlin(ONE, c=1e-9, mu=mu))
    assert peak.von_mises == pytest.approx(p0 * math.sqrt(xx**2 - xx * yy + yy**2), rel=1e-6)
    assert (peak.x, peak.y, peak.z) == pytest.approx((-A, 0.0, 0.0), abs=1e-9)
    little = mindlin(ONE, c=1e-9, mu=0.1)
    x, y, z = np.meshgrid(np.linspace(-0.5, 0.5, 41), np.linspace(-0.1, 0.1, 5), np.linspace(0.3, 0.8, 41))
    stress = wk.restore_body(little, x, y, z).von_mises
    peak = wk.peak_stress(little)
    assert peak.z > 0.3
    assert np.max(stress) <= peak.von_mises <= np.max(stress) * (1.0 + 1e-4)
    place = np.unravel_index(np.argmax(stress), stress.shape)
    assert (peak.x, peak.y, peak.z) == pytest.approx((x[place], y[place], z[place]), abs=0.03)
    other = wk.peak_stress(mindlin(wk.HalfSpace.between(wk.Rigid(), wk.Elastic(1.0, 0.3)), c=1e-9, mu=0.1), below=False)
    assert (other.von_mises, other.x, other.z) == pytest.approx((peak.von_mises, -peak.x, -peak.z), rel=1e-5)


def test_no_contact():
    bed = wk.Foundation(wk.Paraboloid(R), PAIR)
    state = SimpleNamespace(sheared=sheared_by_pieces(bed, -0.1, 0.2, [0.0], [], []))
    fields = wk.restore(state, [0.0, 1.0])
    np.testing.assert_array_equal(fields.traction, 0.0)
    np.testing.assert_array_equal(fields.slip, 0.2)
    assert wk.peak_stress(state).von_mises == 0.0
    np.testing.assert_array_equal(wk.restore_body(state, 0.0, 0.0, [0.1, -0.1]).von_mises, 0.0)


def test_refused():
    state = mindlin()
    with pytest.raises(wk.InvalidInput, match="restore_body"):
        wk.restore(state, [0.1], [0.2])
    with pytest.raises(wk.InvalidInput, match="negative"):
        wk.restore(state, [-0.1])
    with pytest.raises(wk.InvalidInput, match="finite"):
        wk.restore_body(state, [0.1], [np.nan], 0.0)
    with pytest.raises(wk.InvalidInput, match="restore_shift"):
        wk.restore_shift(state, "far", 0.0)
    with pytest.raises(wk.OutsideValidity, match="rigid"):
        wk.restore_body(mindlin(ONE), 0.0, 0.0, -0.1)
    graded = mindlin(wk.GradedHalfSpace.between(wk.PowerLawGraded(1.0, 1.0, 0.4, 0.25)))
    with pytest.raises(wk.OutsideValidity, match="Graded"):
        wk.restore_body(graded, 0.0, 0.0, 0.1)
    with pytest.raises(wk.OutsideValidity, match="not implemented"):
        wk.restore_shift(graded, 0.0, 0.0)
    coat = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(5.0, 0.2), 0.5)], on=wk.Elastic(1.0, 0.3))
    bed = wk.Foundation(wk.Paraboloid(R), coat)
    with pytest.raises(wk.OutsideValidity, match="layers"):
        sheared_by_pieces(bed, 0.4, 0.1, [0.0, 0.4], [0.1], [0.0])
    pressed = PressedSprings(wk.Foundation(wk.Paraboloid(R), PAIR), 0.48, A)
    with pytest.raises(wk.InvalidInput, match="shape"):
        ShearedSprings(pressed, 0.8, 0.1, np.array([0.48]), np.array([A]), np.zeros((1, 2)), np.zeros((1, 2)))
