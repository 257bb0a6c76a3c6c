"""Stresses below line contacts against Flamant's line loads, summed by their own rule, and against closed forms."""

from __future__ import annotations

from itertools import pairwise

import mpmath as mp
import numpy as np
import pytest

import winkler as wk

STEEL = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, wk.Elastic(210e9, 0.3, strength=700e6))
MODULUS = 210e9 / 1.82
NODES, WEIGHTS = np.polynomial.legendre.leggauss(300)


def pressed(profile, half_width, medium=PAIR):
    return wk.LineIndentation(wk.LineFoundation(profile, medium), wk.HalfWidth(half_width)).solve()


def squeezed(low, high):
    """Places and weights dense towards both ends, where a pressure may have roots and logarithms."""
    inner = np.sin(0.5 * np.pi * NODES)
    slope = (0.5 * np.pi) ** 2 * np.cos(0.5 * np.pi * NODES) * np.cos(0.5 * np.pi * inner)
    return 0.5 * (low + high) + 0.5 * (high - low) * np.sin(0.5 * np.pi * inner), 0.5 * (high - low) * WEIGHTS * slope


def flamant(contact, marks, x, z, mu):
    """Normal and tangential line loads p and mu p (Johnson 2.15 and 2.19): xx, zz, xz."""
    total = np.zeros((3, x.size))
    for low, high in pairwise(marks):
        s, weight = squeezed(low, high)
        pressure = contact.pressure(s)
        load = weight * np.where(np.isfinite(pressure), pressure, 0.0)  # places that round to a kink weigh nothing
        away = x[:, None] - s
        kernel = np.array([away**2, z[:, None] ** 2 + 0.0 * away, away * z[:, None]])
        radial = -(2.0 / np.pi) * (z[:, None] + mu * away) / (away**2 + z[:, None] ** 2) ** 2
        total += (kernel * radial * load).sum(axis=2)
    return total


BODIES = {
    "cylinder": (wk.Paraboloid(10e-3), 1e-4, ()),
    "formula": (wk.Formula("r**2/(2*R) + A*r**4", R=10e-3, A=1e6), 1.5e-3, ()),
    "rounded punch": (wk.RoundedPunch(1e-3, 10e-3), 1.3e-3, (1e-3,)),
    "wedge": (wk.Cone(1.5), 1e-3, (0.0,)),
    "blunt wedge": (wk.TruncatedCone(1.5, 0.5e-3), 1e-3, (0.5e-3,)),
    "wave": (wk.Paraboloid(10e-3) + wk.Wavy(1e-7, 1e-3), 1e-3, ()),
}


@pytest.mark.parametrize("name", BODIES)
def test_stresses_are_those_of_line_loads(name):
    profile, a, inner = BODIES[name]
    contact = pressed(profile, a)
    x, z = np.array([0.3, -0.8, 1.1, -2.0, 0.97, 0.0]) * a, np.array([0.5, 0.2, 0.1, 1.0, 0.15, 0.3]) * a
    for mu in (0.0, 0.4):
        found = contact.stresses(x, z, mu)
        marks = sorted({-a, a, *(sign * b for b in inner for sign in (-1.0, 1.0))})
        xx, zz, xz = flamant(contact, marks, x, z, mu)
        scale = np.max(np.abs(zz))
        for mine, other in ((found.xx_stress, xx), (found.zz_stress, zz), (found.xz_stress, xz)):
            np.testing.assert_allclose(mine, other, atol=1e-10 * scale, rtol=0.0)
        np.testing.assert_allclose(found.yy_stress, 0.3 * (xx + zz), atol=1e-10 * scale, rtol=0.0)


def test_the_axis_of_a_cylinder_is_mcewen():
    a, p0 = 1e-4, MODULUS * 1e-4 / 20e-3
    depth = np.array([1e-9, 1e-3, 0.3, 1.0, 5.0, 300.0])
    exact = [[], []]
    with mp.workdps(30):
        for d in map(mp.mpf, depth):
            root = mp.sqrt(1 + d * d)
            exact[0].append(float(-((1 + 2 * d * d) / root - 2 * d)))
            exact[1].append(float(-1 / root))
    for profile in (wk.Paraboloid(10e-3), wk.Formula("r**2/(2*R)", R=10e-3)):
        found = pressed(profile, a).stresses(0.0, depth * a)
        np.testing.assert_allclose(found.zz_stress / p0, exact[1], rtol=1e-12)
        np.testing.assert_allclose(found.xx_stress / p0, exact[0], rtol=1e-8, atol=1e-12)


@pytest.mark.parametrize("name", BODIES)
def test_the_surface_is_the_limit_of_what_lies_below(name):
    profile, a, _ = BODIES[name]
    contact = pressed(profile, a)
    x = np.array([-1.4, -0.7, 0.2, 0.8, 1.5]) * a
    above, below = contact.stresses(x, 0.0, 0.3), contact.stresses(x, 1e-9 * a, 0.3)
    for one in ("xx_stress", "zz_stress", "xz_stress"):
        atol = 1e-7 * np.max(np.abs(above.zz_stress))
        np.testing.assert_allclose(getattr(above, one), getattr(below, one), atol=atol, rtol=0.0)
    np.testing.assert_allclose(above.zz_stress, -contact.pressure(x), rtol=1e-12)
    np.testing.assert_allclose(above.xz_stress, -0.3 * contact.pressure(x), rtol=1e-12, atol=1e-20)


def test_a_flat_punch_has_the_field_of_its_potential():
    """sigma_z = Im F - z Re F' with F = P/(pi sqrt(zeta^2 - b^2)), by mpmath."""
    bed = wk.LineFoundation(wk.FlatPunch(1e-3), PAIR)
    contact = wk.LineIndentation(bed, wk.LineForce(1e5)).solve()
    x, z = 0.6e-3, 0.4e-3
    with mp.workdps(30):
        zeta = mp.mpc(x, z)
        root = mp.sqrt(zeta - mp.mpf(1e-3)) * mp.sqrt(zeta + mp.mpf(1e-3))
        whole, slope = 1e5 / (mp.pi * root), -1e5 * zeta / (mp.pi * root**3)
        exact = float(mp.im(whole) - z * mp.re(slope))
    assert contact.stresses(x, z).zz_stress == pytest.approx(exact, rel=1e-13)


# ---------------------------------------------------------------------------------------------------- onset of yield


def roots_of_mcewen():
    with mp.workdps(30):

        def mises(d):
            root = mp.sqrt(1 + d * d)
            x, z = -((1 + 2 * d * d) / root - 2 * d), -1 / root
            y = mp.mpf("0.3") * (x + z)
            return mp.sqrt(((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) / 2)

        depth = mp.findroot(lambda d: mp.diff(mises, d), 0.7)
        return float(depth), float(mises(depth))  # fmt: skip


def test_a_cylinder_yields_where_mcewen_says():
    depth, peak = roots_of_mcewen()
    assert (round(depth, 3), round(peak, 3)) == (0.704, 0.558)
    onset = wk.LineYieldOnset(wk.LineFoundation(wk.Paraboloid(10e-3), PAIR)).solve()
    p0 = 700e6 / peak
    assert onset.force_per_length == pytest.approx(np.pi * 10e-3 * p0**2 / MODULUS, rel=1e-12)
    assert -onset.z == pytest.approx(depth * onset.half_width, rel=1e-9)
    again = wk.LineIndentation(onset.problem.bed, wk.LineForce(onset.force_per_length)).solve()
    assert again.greatest_stress(below=False).value == pytest.approx(700e6, rel=1e-12)


def test_the_greatest_shear_of_a_cylinder_is_known():
    """0.30028 p0 at 0.78615 a on the axis; the shear along the strip is p0/4 at half a depth, 0.866 a aside."""
    a, p0 = 1e-4, MODULUS * 1e-4 / 20e-3
    contact = pressed(wk.Paraboloid(10e-3), a)
    x, z = np.linspace(0.0, 1.5, 301) * a, np.linspace(0.0, 2.0, 401) * a
    fields = contact.stresses(x[:, None], z[None, :])
    assert np.max(fields.max_shear) / p0 == pytest.approx(0.30028310600, rel=1e-5)
    assert contact.stresses(0.0, 0.786151377757 * a).max_shear / p0 == pytest.approx(0.30028310600078, rel=1e-12)
    assert contact.stresses(np.sqrt(0.75) * a, 0.5 * a).xz_stress / p0 == pytest.approx(-0.25, rel=1e-12)


@pytest.mark.parametrize("mu", [0.1, 0.25, 0.5])
def test_no_point_of_a_fine_map_is_stressed_more_than_the_greatest(mu):
    contact = pressed(wk.Paraboloid(10e-3), 1e-4)
    best = contact.greatest_stress(mu)
    x, z = np.linspace(-1.2, 1.2, 241) * 1e-4, np.linspace(0.0, 1.0, 101) * 1e-4
    mapped = contact.stresses(x[:, None], z[None, :], mu).von_mises
    assert 0.999 < np.max(mapped) / best.value <= 1.0 + 1e-12


def test_friction_brings_the_onset_to_the_surface():
    """There sigma_x = -p - 2 mu p0 x/a and tau = mu p: von Mises' stress in plane strain, by mpmath."""
    mu, nu = 0.5, mp.mpf("0.3")
    with mp.workdps(30):

        def mises(s):
            x, z = -mp.sqrt(1 - s * s) - 2 * mu * s, -mp.sqrt(1 - s * s)
            y = nu * (x + z)
            return mp.sqrt(((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) / 2 + 3 * mu**2 * (1 - s * s))

        place = mp.findroot(lambda s: mp.diff(mises, s), 0.45)
        p0 = 700e6 / float(mises(place))  # fmt: skip
    onset = wk.LineYieldOnset(wk.LineFoundation(wk.Paraboloid(10e-3), PAIR), wk.Coulomb(mu)).solve()
    assert onset.force_per_length == pytest.approx(np.pi * 10e-3 * p0**2 / MODULUS, rel=1e-11)
    assert onset.x == pytest.approx(float(place) * onset.half_width, rel=1e-5)
    assert abs(onset.z) < 1e-6 * onset.half_width


@pytest.mark.slow
def test_other_profiles_yield_at_their_strength():
    parabola = wk.LineYieldOnset(wk.LineFoundation(wk.PowerLaw(coefficient=50.0, exponent=2.0), PAIR)).solve()
    cylinder = wk.LineYieldOnset(wk.LineFoundation(wk.Paraboloid(10e-3), PAIR)).solve()
    assert parabola.force_per_length == pytest.approx(cylinder.force_per_length, rel=1e-10)


@pytest.mark.parametrize(
    ("profile", "medium", "sentence"),
    [
        (wk.Cone(1.5), PAIR, "first touch"),
        (wk.FlatPunch(1e-3), PAIR, "first touch"),
        (wk.Paraboloid(10e-3), wk.HalfSpace(STEEL), "no body has a strength"),
    ],
)
def test_what_cannot_yield_or_yields_at_once_is_refused(profile, medium, sentence):
    with pytest.raises(wk.WinklerError, match=sentence):
        wk.LineYieldOnset(wk.LineFoundation(profile, medium)).solve()


def test_the_surface_of_the_second_body_is_at_minus_zero():
    """On the surface the stresses along x of a sliding cylinder are -p0 (root + 2 mu x/a); those along y have nu."""
    pair = wk.HalfSpace.between(wk.Elastic(70e9, 0.1), wk.Elastic(210e9, 0.3, strength=700e6))
    bed, mu = wk.LineFoundation(wk.Paraboloid(10e-3), pair), 0.5
    onset = wk.LineYieldOnset(bed, wk.Coulomb(mu)).solve()
    assert onset.z == 0.0
    assert np.signbit(onset.z)
    contact = wk.LineIndentation(bed, wk.LineForce(onset.force_per_length)).solve()
    at_onset = contact.stresses(onset.x, onset.z, mu)
    assert float(at_onset.von_mises) == pytest.approx(700e6, rel=1e-12)
    x = contact.half_width * np.array([-0.5, 0.25])
    second, first = contact.stresses(x, [-0.0, -0.0], mu), contact.stresses(x, 0.0, mu)
    t = np.array([-0.5, 0.25])
    across = -np.sqrt(1.0 - t**2)
    for fields, poisson in ((second, 0.3), (first, 0.1)):
        expected = contact.peak_pressure * poisson * (2.0 * across - 2.0 * mu * t)
        assert fields.yy_stress == pytest.approx(expected, rel=1e-12)
    deep = contact.stresses(0.0, [0.0, -1e-4], mu)  # the surface is that of the body of the other depths
    assert deep.yy_stress[0] == pytest.approx(0.3 * (deep.xx_stress[0] + deep.zz_stress[0]), rel=1e-12)


def test_stresses_of_no_contact_both_bodies_and_rigid_ones_are_refused():
    contact = pressed(wk.Paraboloid(10e-3), 1e-4, wk.HalfSpace(STEEL))
    with pytest.raises(wk.OutsideValidity, match="rigid or not isotropic"):
        contact.stresses(0.0, -1e-5)
    with pytest.raises(wk.InvalidInput, match="both bodies"):
        contact.stresses(0.0, [-1e-5, 1e-5])
    for friction in (np.nan, np.inf, [0.1, 0.2]):
        with pytest.raises(wk.InvalidInput, match="give one finite coefficient"):
            contact.greatest_stress(friction)
    with pytest.raises(wk.InvalidInput, match="not finite"):
        contact.stresses(np.nan, [0.0, 1e-5])
    with pytest.raises(wk.OutsideValidity, match="do not touch"):
        pressed(wk.Paraboloid(10e-3), 0.0).stresses(0.0, 1e-5)
    with pytest.raises(wk.OutsideValidity, match="infinite"):
        pressed(wk.Cone(1.5), 1e-4).greatest_stress()


# ---------------------------------------------------------------------------------------------------- shakedown


def limit_over_shear(mu):
    """Greatest pressure over k = Y/sqrt(3) of a cylinder at the shakedown limit."""
    found = wk.LineShakedown(wk.LineFoundation(wk.Paraboloid(10e-3), PAIR), wk.Coulomb(mu)).solve()
    return 4.0 / np.pi * found.mean_pressure / (700e6 / np.sqrt(3.0))


def test_a_roller_shakes_down_at_the_known_pressures():
    """4 k without friction (Johnson 1985, sec. 9.2); at the surface below his k/mu, which is Tresca's in the plane."""
    assert limit_over_shear(0.0) == pytest.approx(4.0, rel=1e-11)
    assert limit_over_shear(0.31) > 0.31**-1 * 0.89
    assert limit_over_shear(0.5) < 0.95 * 2.0


@pytest.mark.few(1)
@pytest.mark.parametrize("mu", [0.0, 0.2, 0.3])
def test_residual_stresses_exist_with_which_a_roller_shakes_down(mu):
    """Melan: at each depth one residual stress along x must keep all of the passage within k, in the plane."""
    contact = pressed(wk.Paraboloid(10e-3), 1e-4)
    p0 = MODULUS * 1e-4 / 20e-3
    x, z = np.linspace(-6.0, 6.0, 601) * 1e-4, np.linspace(0.0, 1.2, 49) * 1e-4
    fields = contact.stresses(x[:, None], z[None, :], mu)
    difference, shear = (fields.xx_stress - fields.zz_stress) / p0, fields.xz_stress / p0
    residual = np.linspace(-1.0, 1.5, 201)
    radius = np.hypot(0.5 * (difference[:, :, None] + residual), shear[:, :, None]).max(axis=0).min(axis=1)
    assert np.max(radius) == pytest.approx(1.0 / limit_over_shear(mu), rel=5e-3)


# ---------------------------------------------------------------------------------------------------- approach


def test_a_cylinder_approaches_as_johnson_says():
    """By the strain along the axis (McEwen's stresses); far below P(1 - nu^2)/(pi E)(2 ln(2d/a) - nu/(1 - nu))."""
    a, nu = 1e-4, mp.mpf("0.3")
    p0 = MODULUS * a / 20e-3
    contact = pressed(wk.Paraboloid(10e-3), a, wk.HalfSpace(STEEL, STEEL))

    def strain(d):
        root = mp.sqrt(1 + d * d)
        x, z = -((1 + 2 * d * d) / root - 2 * d), -1 / root
        return -((1 - nu**2) * z - nu * (1 + nu) * x)

    for depth in (0.3, 7.0):
        with mp.workdps(30):
            exact = 2 * float(mp.quad(strain, mp.linspace(0, mp.mpf(depth), 8))) * p0 * a / 210e9
        assert contact.approach(depth * a, depth * a) == pytest.approx(exact, rel=1e-12)
    far = contact.force_per_length * 0.91 / (np.pi * 210e9) * (2.0 * np.log(2e5) - 0.3 / 0.7)
    assert contact.approach(10.0, 10.0) == pytest.approx(2.0 * far, rel=1e-9)


@pytest.mark.parametrize("name", ["rounded punch", "blunt wedge", "formula"])
def test_the_approach_is_the_compression_of_the_axis(name):
    profile, a, _ = BODIES[name]
    contact, depth = pressed(profile, a, wk.HalfSpace(STEEL)), 2.0 * a
    nodes, weights = squeezed(0.0, depth)
    fields = contact.stresses(np.zeros(nodes.size), nodes)
    strain = (0.91 * fields.zz_stress - 0.39 * fields.xx_stress) / 210e9
    assert contact.approach(first=depth) == pytest.approx(-float(np.sum(weights * strain)), rel=1e-10)


def test_its_size_is_that_of_a_half_width():
    statements = [note.statement for note in pressed(wk.Paraboloid(10e-3), 1e-4).validity]
    assert (
        "The half-width of the contact is 0.01 of the body's radius: the body can be treated as a half-space."
        in statements
    )


def test_a_line_contact_has_no_depth_without_a_reference():
    contact = pressed(wk.Paraboloid(10e-3), 1e-4)
    with pytest.raises(wk.InvalidInput, match="no depth of its own"):
        contact.approach()
    with pytest.raises(wk.InvalidInput, match="second body"):
        contact.approach(first=1e-3)
    assert pressed(wk.Paraboloid(10e-3), 0.0).approach(1e-3, 1e-3) == 0.0


def test_a_roller_states_where_yielding_begins():
    onset = wk.LineYieldOnset(wk.LineFoundation(wk.Paraboloid(10e-3), PAIR)).solve()
    for share, standing, begins in (
        (0.9, wk.Standing.EXACT, "yielding begins at"),
        (1.1, wk.Standing.OUTSIDE, "began at"),
    ):
        load = wk.LineForce(np.array([0.1, share]) * onset.force_per_length)
        notes = wk.LineIndentation(onset.problem.bed, load).solve().validity
        (note,) = [note for note in notes if note.assumption is wk.Assumption.ELASTIC]
        assert note.standing is standing
        assert f"{begins} {onset.force_per_length:.4g} N/m" in note.statement
        assert f"{np.sqrt(share):.3g} " in note.statement


def test_what_is_sharp_is_judged_beside_its_tip():
    wedge = wk.LineFoundation(wk.Cone(1.5), PAIR)
    (note,) = [n for n in pressed_note(wedge) if n.assumption is wk.Assumption.ELASTIC]
    assert note.standing is wk.Standing.OUTSIDE
    assert "infinite at a sharp tip" in note.statement
    weak = wk.LineIndentation(wk.LineFoundation(wk.FlatPunch(1e-3), PAIR), wk.LineForce(1.0)).solve()
    (note,) = [n for n in weak.validity if n.assumption is wk.Assumption.ELASTIC]
    assert note.standing is wk.Standing.APPROXIMATE


def pressed_note(bed):
    return wk.LineIndentation(bed, wk.LineForce(1e7)).solve().validity
