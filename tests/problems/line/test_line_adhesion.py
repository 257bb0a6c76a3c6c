"""Sticking line contacts against closed forms by mpmath, energies, and forces along lines summed by quadrature."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest

import winkler as wk

RUBBER = wk.HalfSpace.between(wk.Elastic(1e6, 0.5))
MODULUS = 1e6 / 0.75
WORK = 0.05
RADIUS = 5e-3
CYLINDER = wk.Paraboloid(RADIUS)


def stuck(profile, load, work=WORK):
    return wk.LineAdhesion(wk.LineFoundation(profile, RUBBER), wk.ShortRange(work), load).solve()


def test_a_cylinder_sticks_as_barquins_and_chaudhury_say():
    with mp.workdps(30):
        e, g, r = mp.mpf(10) ** 6 / mp.mpf("0.75"), mp.mpf("0.05"), mp.mpf("0.005")
        resting = mp.cbrt(32 * r * r * g / (mp.pi * e))
        least = mp.cbrt(2 * r * r * g / (mp.pi * e))
        pull = -mp.mpf(3) / 4 * mp.cbrt(4 * mp.pi * e * g * g * r)
        pressed = mp.findroot(
            lambda a: mp.pi * e * a * a / (4 * r) - mp.sqrt(2 * mp.pi * e * a * g) - 10, mp.mpf("3e-4")
        )
    contact = stuck(CYLINDER, wk.LineForce(np.array([0.0, 10.0])))
    np.testing.assert_allclose(contact.half_width, [float(resting), float(pressed)], rtol=1e-13)
    assert contact.pull_off_force_per_length == pytest.approx(float(pull), rel=1e-14)
    assert contact.pull_off_half_width == pytest.approx(float(least), rel=1e-13)
    np.testing.assert_allclose(contact.energy_release_rate, WORK, rtol=1e-14)
    np.testing.assert_allclose(contact.stress_intensity, np.sqrt(2.0 * MODULUS * WORK), rtol=1e-14)
    assert contact.mean_pressure[1] == pytest.approx(5.0 / float(pressed), rel=1e-13)


def test_its_pressure_and_opening_are_hertz_less_a_punch():
    contact = stuck(CYLINDER, wk.LineForce(10.0))
    a = contact.half_width
    share = np.array([0.0, -0.3, 0.9, 0.999])
    root = np.sqrt(1.0 - share**2)
    exact = MODULUS * a / (2.0 * RADIUS) * root - np.sqrt(2.0 * MODULUS * WORK / (np.pi * a)) / root
    np.testing.assert_allclose(contact.pressure(share * a), exact, rtol=1e-11)
    np.testing.assert_array_equal(contact.pressure(np.array([-1.1, 1.5]) * a), 0.0)
    wide = np.array([-1.0001, 1.5, 8.0])
    away = np.abs(wide)
    opened = a * a / (2.0 * RADIUS) * (away * np.sqrt(away**2 - 1.0) - np.arccosh(away))
    pulled = 2.0 / np.pi * np.sqrt(2.0 * np.pi * a * WORK / MODULUS) * np.arccosh(away)
    np.testing.assert_allclose(contact.separation(wide * a), opened + pulled, rtol=1e-10)
    np.testing.assert_array_equal(contact.separation(share * a), 0.0)


def test_the_stresses_below_are_its_forces_along_lines_summed():
    contact = stuck(CYLINDER, wk.LineForce(2.0))
    a = contact.half_width
    angle = np.pi * (np.arange(400) + 0.5) / 400  # Chebyshev's rule takes the singular edges
    s = a * np.cos(angle)
    load = contact.pressure(s) * a * np.sin(angle) * np.pi / 400
    x, z = np.array([0.0, 0.7, 1.3]) * a, 0.5 * a
    r2 = (x[:, None] - s) ** 2 + z * z
    down = -2.0 / np.pi * np.sum(load * z**3 / r2**2, axis=1)
    shear = -2.0 / np.pi * np.sum(load * (x[:, None] - s) * z * z / r2**2, axis=1)
    found = contact.stresses(x, z)
    np.testing.assert_allclose(found.zz_stress, down, rtol=1e-11)
    np.testing.assert_allclose(found.xz_stress, shear, rtol=1e-11, atol=1e-9)


@pytest.mark.parametrize("n", [1.0, 1.5, 4.0])
def test_a_power_comes_apart_where_its_force_is_least(n):
    c = 0.3
    with mp.workdps(30):
        k = mp.mpf(c) * n * mp.sqrt(mp.pi) * mp.gamma((mp.mpf(n) + 1) / 2) / (2 * mp.gamma(mp.mpf(n) / 2 + 1))
        e = mp.mpf(10) ** 6 / mp.mpf("0.75")
        pull = mp.sqrt(2 * mp.pi * e * mp.mpf(WORK))
        a = (pull / (2 * e * k * n)) ** (1 / (mp.mpf(n) - mp.mpf("0.5")))
        force = e * k * a**n - pull * mp.sqrt(a)
    contact = stuck(wk.PowerLaw(coefficient=c, exponent=n), wk.LineForce(1.0))
    assert contact.pull_off_half_width == pytest.approx(float(a), rel=1e-12)
    assert contact.pull_off_force_per_length == pytest.approx(float(force), rel=1e-13)


def test_a_flat_punch_is_pulled_off_as_a_crack_opens():
    b = 1e-3
    most = -np.sqrt(2.0 * np.pi * MODULUS * WORK * b)
    held = stuck(wk.FlatPunch(b), wk.LineForce(np.array([-5.0, 0.0, 3.0])))
    np.testing.assert_array_equal(held.half_width, b)
    assert held.pull_off_force_per_length == pytest.approx(most, rel=1e-13)
    np.testing.assert_allclose(held.energy_release_rate, [25.0 / most**2 * WORK, 0.0, 0.0], rtol=1e-12)
    assert held.at(0).pressure(0.0) == pytest.approx(-5.0 / (np.pi * b), rel=1e-12)
    with pytest.raises(wk.OutsideValidity, match=r"force per length -21 N/m is below the pull-off.*half-width 0.001 m"):
        stuck(wk.FlatPunch(b), wk.LineForce(-21.0))


def test_the_edge_releases_the_work_of_adhesion():
    """Irwin's closure: beside the edge, tension times opening at the same distance is 4 G/pi."""
    bed = wk.LineFoundation(wk.RoundedPunch(1e-3, RADIUS), RUBBER)
    contact = wk.LineAdhesion(bed, wk.ShortRange(WORK), wk.LineForce(1.0)).solve()
    a = contact.half_width
    assert a > 1e-3
    step = np.array([1e-5, 1e-7]) * (a - 1e-3)
    released = 0.25 * np.pi * -contact.pressure(a - step) * contact.separation(a + step)
    np.testing.assert_allclose(released, WORK, rtol=1e-3)
    assert released[1] == pytest.approx(WORK, rel=1e-5)


def test_half_widths_say_whether_they_are_stable():
    least = stuck(CYLINDER, wk.LineForce(0.0)).pull_off_half_width
    contact = stuck(CYLINDER, wk.HalfWidth(least * np.array([0.0, 0.9, 1.1])))
    np.testing.assert_array_equal(contact.stable, [False, False, True])
    again = stuck(CYLINDER, wk.LineForce(contact.force_per_length[2]))
    assert again.half_width == pytest.approx(contact.half_width[2], rel=1e-12)
    assert contact.at(2).half_width == contact.half_width[2]


@pytest.mark.slow
def test_waves_hold_a_wavy_cylinder_stronger():
    """Of all equilibria the pull-off is the least stable force: a dense scan of P(a) by Bessel functions."""
    h, length = 1e-7, 5e-5
    profile = CYLINDER + wk.Wavy(amplitude=h, wavelength=length)
    contact = stuck(profile, wk.LineForce(0.1))
    from scipy.special import j1

    k = 2.0 * np.pi / length
    a = np.linspace(1e-6, 6e-4, 400_001)
    force = MODULUS * (np.pi * a * a / (4.0 * RADIUS) + 0.5 * np.pi * h * k * a * j1(k * a))
    force -= np.sqrt(2.0 * np.pi * MODULUS * WORK * a)
    assert contact.pull_off_force_per_length == pytest.approx(np.min(force), rel=1e-8)
    assert contact.pull_off_force_per_length < 1.1 * stuck(CYLINDER, wk.LineForce(0.1)).pull_off_force_per_length
    last = a[:-1][(force[:-1] <= 0.1) & (force[1:] > 0.1)][-1]
    assert contact.half_width == pytest.approx(last, abs=2e-9)
    notes = {note.assumption: note for note in contact.validity}
    assert notes[wk.Assumption.SINGLE_CONTACT].standing is wk.Standing.EXACT
    assert "Up to 3 half-widths are stable under one load" in " ".join(
        map(str, stuck(profile, wk.LineForce(-4.0)).validity)
    )


def test_refusals_are_one_sentence():
    with pytest.raises(wk.OutsideValidity, match=r"below the pull-off: no equilibrium exists beyond -4\.45.* N/m"):
        stuck(CYLINDER, wk.LineForce(np.array([0.0, -10.0])))
    with pytest.raises(wk.OutsideValidity, match="as sharp as"):
        stuck(wk.PowerLaw(coefficient=0.01, exponent=0.5), wk.LineForce(0.0))
    with pytest.raises(wk.OutsideValidity, match="beyond the reach of the profile"):
        stuck(wk.Sphere(RADIUS), wk.HalfWidth(1.1 * RADIUS))
    with pytest.raises(wk.OutsideValidity, match="beyond the reach of the profile"):
        stuck(wk.Sphere(RADIUS), wk.LineForce(1e9))
    with pytest.raises(wk.InvalidInput, match="pick one"):
        stuck(CYLINDER, wk.LineForce(np.array([0.0, 1.0]))).pressure(0.0)


def test_yield_at_the_edge_is_stated():
    strong = wk.HalfSpace(wk.Elastic(1e6, 0.5, strength=1e4))
    contact = wk.LineAdhesion(wk.LineFoundation(CYLINDER, strong), wk.ShortRange(WORK), wk.LineForce(10.0)).solve()
    (note,) = (one for one in contact.validity if one.assumption is wk.Assumption.ELASTIC)
    assert note.standing is wk.Standing.OUTSIDE
    assert "infinite at the edge, which adhesion pulls" in str(note)


# ------------------------------------------------------------------------------------------------ with a range


def reaching(profile, strength, load, work=WORK):
    return wk.LineAdhesion(wk.LineFoundation(profile, RUBBER), wk.Dugdale(work, strength), load).solve()


@pytest.mark.parametrize("strength", [1e3, 1e4, 1e6])
def test_a_constant_attraction_is_that_of_baney_and_hui(strength):
    """P and the opening of a cylinder over m = c/a at 30 digits, for a half-width that was found."""
    found = reaching(CYLINDER, strength, wk.LineForce(np.array([0.0, 5.0])))
    for index in (0, 1):
        one = found.at(index)
        with mp.workdps(30):
            e, r, s = mp.mpf(10) ** 6 / mp.mpf("0.75"), mp.mpf("0.005"), mp.mpf(strength)
            a = mp.mpf(one.half_width)

            def apart(m, a=a, e=e, r=r, s=s):
                root = mp.sqrt(m * m - 1)
                profile = a * a / (2 * r) * (m * root - mp.acosh(m))
                return profile + 4 * s * a / (mp.pi * e) * (root * mp.acosh(m) - m * mp.log(m)) - mp.mpf("0.05") / s

            m = mp.findroot(apart, mp.mpf(one.outer_half_width / one.half_width))
            force = mp.pi * e * a * a / (4 * r) - 2 * s * a * mp.sqrt(m * m - 1)
        assert one.outer_half_width == pytest.approx(float(m * a), rel=1e-12)
        assert one.force_per_length == pytest.approx(float(force), rel=1e-10, abs=1e-10)


def test_attraction_of_a_short_range_is_that_without():
    short, strong = stuck(CYLINDER, wk.LineForce(1.0)), reaching(CYLINDER, 1e7, wk.LineForce(1.0))
    assert strong.half_width == pytest.approx(short.half_width, rel=1e-5)
    assert strong.pull_off_force_per_length == pytest.approx(short.pull_off_force_per_length, rel=1e-7)
    assert strong.stress_intensity == 0.0
    for strength in (1e10, 1e14, 1e25):
        narrow = reaching(CYLINDER, strength, wk.LineForce(1.0))
        assert narrow.half_width == pytest.approx(short.half_width, rel=1e-10)
        assert narrow.pull_off_force_per_length == pytest.approx(short.pull_off_force_per_length, rel=1e-12)
    weak = reaching(CYLINDER, 10.0, wk.LineForce(1.0))
    # that deforms nothing and reaches to x^2/(2R) = gamma/sigma_0: it pulls with 2 sigma_0 x
    assert weak.pull_off_half_width == 0.0
    assert weak.pull_off_force_per_length == pytest.approx(-20.0 * np.sqrt(2.0 * RADIUS * WORK / 10.0), rel=1e-3)


def test_the_surfaces_end_to_attract_each_other_at_their_range():
    for profile, strength in ((CYLINDER, 1e4), (wk.PowerLaw(1e4, 3.0), 1e5)):
        contact = reaching(profile, strength, wk.LineForce(2.0))
        a, c = contact.half_width, contact.outer_half_width
        assert contact.separation(c) == pytest.approx(WORK / strength, rel=1e-9)
        inner, outer = contact.pressure(a * np.array([0.999999999, 1.000000001]))
        assert inner == pytest.approx(outer, rel=1e-3)
        np.testing.assert_allclose(contact.pressure(np.array([0.3 * a + 0.7 * c, 1.01 * c])), [-strength, 0.0])
        angle = np.pi * (np.arange(4000) + 0.5) / 4000
        inside = np.sum(contact.pressure(a * np.cos(angle)) * np.sin(angle)) * a * np.pi / 4000
        assert inside - 2.0 * strength * (c - a) == pytest.approx(2.0, rel=1e-5)
        assert contact.approach(1.0) == pytest.approx(stuck(profile, wk.LineForce(2.0)).approach(1.0), rel=0.2)


def test_the_stresses_below_an_attraction_are_its_forces_along_lines_summed():
    contact = reaching(CYLINDER, 1e4, wk.LineForce(2.0))
    a, c = contact.half_width, contact.outer_half_width
    node, weight = np.polynomial.legendre.leggauss(60)
    angle = 0.25 * np.pi * (node + 1.0)  # from 0 to pi/2; a root at the edge inside
    s = np.concatenate([a * np.cos(angle), a + 0.5 * (c - a) * (node + 1.0)])
    load = contact.pressure(s) * np.concatenate([0.25 * np.pi * a * np.sin(angle) * weight, 0.5 * (c - a) * weight])
    x, z = np.array([0.0, 0.7, 1.3]) * a, 0.5 * a
    down, shear = np.zeros(3), np.zeros(3)
    for side in (-1.0, 1.0):
        r2 = (x[:, None] - side * s) ** 2 + z * z
        down -= 2.0 / np.pi * np.sum(load * z**3 / r2**2, axis=1)
        shear -= 2.0 / np.pi * np.sum(load * (x[:, None] - side * s) * z * z / r2**2, axis=1)
    found = contact.stresses(x, z)
    np.testing.assert_allclose(found.zz_stress, down, rtol=1e-8)
    np.testing.assert_allclose(found.xz_stress, shear, rtol=1e-8, atol=1e-6)
    np.testing.assert_allclose(contact.stresses(x, 0.0).zz_stress, -contact.pressure(x), rtol=1e-12)


def test_an_attraction_beside_rims_is_refused():
    with pytest.raises(wk.OutsideValidity, match="without rims and kinks"):
        reaching(wk.FlatPunch(1e-3), 1e4, wk.LineForce(1.0))
    with pytest.raises(wk.OutsideValidity, match="below the pull-off"):
        reaching(CYLINDER, 1e4, wk.LineForce(-10.0))
    with pytest.raises(wk.OutsideValidity, match="beyond the end of the profile"):
        reaching(wk.Sphere(RADIUS), 1.0, wk.LineForce(1.0))


def test_the_stresses_at_the_edges_are_infinite_as_the_tension():
    contact = stuck(CYLINDER, wk.LineForce(0.0))
    edge = contact.stresses(contact.half_width, 0.0)
    assert (edge.xx_stress, edge.zz_stress, edge.xz_stress) == (np.inf, np.inf, 0.0)
