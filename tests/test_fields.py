"""The surface of a contact: closed forms, point forces, axis, edge, outside, and what is refused."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

import winkler as wk
from winkler.reference.point_forces import displacement as superpose

UNIT = wk.HalfSpace.between(wk.Elastic(1.0, 0.0))
T = np.array([0.0, 1e-300, 1e-12, 1e-3, 0.3, 0.9, 0.999, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.001, 1.7, 30.0, 1e4])
"""Distances from the axis in contact radii."""


def solved(profile, radius, medium=UNIT):
    return wk.Indentation(wk.Foundation(profile, medium), wk.Radius(radius)).solve()


def power_pressure(c, n, a, r):
    """(1/pi) Int_r^a kappa c n x^(n-1)/sqrt(x^2 - r^2) dx in x = r cosh(w); on the axis in closed form."""
    with mp.workdps(25):
        c, n, a = mp.mpf(c), mp.mpf(n), mp.mpf(a)
        kappa = mp.sqrt(mp.pi) * n * mp.gamma(n / 2) / (2 * mp.gamma((n + 1) / 2))
        if r == 0.0:
            return float(kappa * c * n * a ** (n - 1) / (n - 1) / mp.pi) if n > 1 else math.inf
        w = mp.acosh(a / mp.mpf(r))
        cuts = mp.linspace(0, w, 1 + int(w / 3) + 1)
        return float(kappa * c * n * mp.quad(lambda t: (mp.mpf(r) * mp.cosh(t)) ** (n - 1), cuts) / mp.pi)


@pytest.mark.parametrize("exponent", [0.5, 0.9, 1.0, 1.02, 1.1, 1.5, 2.0, 2.7, 4.0, 12.0])
def test_pressure_of_powers(exponent):
    """To 1e-8 everywhere, on the axis too: infinite for n <= 1, finite for any n > 1."""
    a = 0.4
    r = a * T[(T < 1.0) & (T != 1e-300)]
    got = wk.restore(solved(wk.PowerLaw(0.3, exponent), a), r).pressure
    expected = np.array([power_pressure(0.3, exponent, a, v) for v in r])
    np.testing.assert_allclose(got, expected, rtol=1e-9)


def test_quartic_in_closed_form():
    """p = (32 E* c/(9 pi)) (a^2 + 2 r^2) sqrt(a^2 - r^2)."""
    a, c = 0.7, 0.2
    r = a * T[T < 1.0 - 1e-6]
    expected = 32.0 * c / (9.0 * math.pi) * (a**2 + 2.0 * r**2) * np.sqrt((a - r) * (a + r))
    np.testing.assert_allclose(wk.restore(solved(wk.PowerLaw(c, 4.0), a), r).pressure, expected, rtol=1e-12)


def test_hertz_in_closed_form():
    """R = 1, a = 1/2: p0 = 0.318309886, u(r = 1) = 0.0544988905 (theory sheet)."""
    a = 0.5
    fields = wk.restore(solved(wk.Paraboloid(1.0), a), a * T)
    inside = T <= 1.0
    np.testing.assert_allclose(
        fields.pressure, 2.0 * a / math.pi * np.sqrt(np.maximum((1.0 - T) * (1.0 + T), 0.0)), rtol=1e-12, atol=1e-300
    )
    s = np.maximum(T, 1.0)
    outside = a**2 / math.pi * ((2.0 - s**2) * np.arcsin(1.0 / s) + np.sqrt((s - 1.0) * (s + 1.0)))
    inner = a**2 * (1.0 - 0.5 * T**2)
    near = T < 40.0  # the closed form cancels far away: there a point force
    np.testing.assert_allclose(fields.displacement[near], np.where(inside, inner, outside)[near], rtol=1e-11)
    assert fields.displacement[-1] == pytest.approx(1.0 / 6.0 / (math.pi * 0.5 * T[-1]), rel=1e-7)
    np.testing.assert_array_equal(fields.gap[inside], 0.0)
    expected = (a * T[~inside]) ** 2 / 2.0 - a**2 + outside[~inside]
    np.testing.assert_allclose(fields.gap[~inside], expected, rtol=1e-8, atol=1e-14)
    assert np.all(fields.gap >= 0.0)
    assert wk.restore(solved(wk.Paraboloid(1.0), 0.5), [0.0, 1.0]).pressure[0] == pytest.approx(0.318309886, abs=1e-9)
    assert wk.restore(solved(wk.Paraboloid(1.0), 0.5), [0.0, 1.0]).displacement[1] == pytest.approx(
        0.0544988905, abs=1e-10
    )


def test_cone_in_closed_form():
    """p = (E* tan t/2) arcosh(a/r); u(r > a) = a tan t [asin(a/r) - (r - sqrt(r^2 - a^2))/a]."""
    a, t = 0.3, 1.0 / math.tan(1.3)
    fields = wk.restore(solved(wk.Cone(1.3), a), a * T)
    assert fields.pressure[0] == math.inf
    for got, s in zip(fields.pressure[1:], T[1:], strict=True):
        assert got == pytest.approx(float(mp.mpf(t) / 2 * mp.acosh(1 / mp.mpf(s))) if s < 1.0 else 0.0, rel=1e-9)
    for got, s in zip(fields.displacement, T, strict=True):
        s = mp.mpf(s)
        u = mp.mpf(a) * t * (mp.pi / 2 - s if s <= 1 else mp.asin(1 / s) - s + mp.sqrt(s**2 - 1))
        assert got == pytest.approx(float(u), rel=1e-9)


def test_flat_punch_in_closed_form():
    b, d = 0.2, 1e-3
    fields = wk.restore(wk.Indentation(wk.Foundation(wk.FlatPunch(b), UNIT), wk.Depth(d)).solve(), b * T)
    inside = T < 1.0
    expected = d / (math.pi * b * np.sqrt((1.0 - T[inside]) * (1.0 + T[inside])))
    np.testing.assert_allclose(fields.pressure[inside], expected, rtol=1e-7)
    np.testing.assert_allclose(fields.pressure[:7], expected[:7], rtol=1e-12)
    edge = int(np.flatnonzero(T == 1.0)[0])
    assert fields.pressure[edge] == math.inf
    assert not np.any(fields.pressure[edge + 1 :])
    u = [float(2 * d / mp.pi * mp.asin(1 / max(mp.mpf(1), mp.mpf(s)))) for s in T]
    np.testing.assert_allclose(fields.displacement, u, rtol=1e-10)
    # nothing is known of the body beyond its rim
    np.testing.assert_array_equal(np.isinf(fields.gap), T > 1.0)


SHAPES = {
    # profile, contact radius, depth beyond g(a)
    "sphere": (wk.Sphere(1.0), 0.8, 0.0),
    "ellipsoid": (wk.Ellipsoid(1.0, 0.2), 0.5, 0.0),
    "hyperboloid": (wk.Hyperboloid(0.1, 1.2), 0.6, 0.0),
    "truncated cone": (wk.TruncatedCone(1.3, 0.2), 0.5, 0.0),
    "truncated paraboloid": (wk.TruncatedParaboloid(1.0, 0.2), 0.5, 0.0),
    "worn paraboloid": (wk.CappedParaboloid(1.0, 4.0, 0.2), 0.5, 0.0),
    "rounded punch": (wk.RoundedPunch(0.3, 1.0), 0.5, 0.0),
    "rounded cone": (wk.RoundedCone(0.5, 1.2), 0.6, 0.0),
    "sphero-conical": (wk.SpheroConical(0.5, 1.2), 0.6, 0.0),
    "wavy": (wk.Paraboloid(1.0) + wk.Wavy(2e-3, 0.4), 0.6, 0.0),
    "cone and kinks": (wk.Cone(1.4) + wk.TruncatedCone(1.4, 0.2) + wk.TruncatedParaboloid(1.0, 0.35), 0.5, 0.0),
    "area function": (wk.AreaFunction((24.5, 0.3, 0.02)), 0.5, 0.0),
    "formula": (wk.Formula("L*(cosh(r/L) - 1)", L=0.4, reach=3.0), 0.5, 0.0),
    "pinned paraboloid": (wk.CappedCylinder(0.5, wk.Paraboloid(1.0)), 0.5, 0.1),
    "pinned flat": (wk.FlatPunch(0.5), 0.5, 0.1),
    "pinned kink": (wk.CappedCylinder(0.5, wk.TruncatedCone(1.3, 0.2)), 0.5, 0.05),
}


@pytest.mark.few(5, slow=2)
@pytest.mark.parametrize("name", [name for name in SHAPES if name != "area function"])
def test_point_forces_agree(name):
    """Seed Eqs. (1) and (2): the pressure, superposed as point forces, gives the displacement, inside and outside."""
    profile, a, more = SHAPES[name]
    depth = float(profile.gap(np.array([a]))[0]) + more
    contact = wk.Indentation(wk.Foundation(profile, UNIT), wk.Depth(depth)).solve()
    assert contact.radius == pytest.approx(a, rel=1e-12)
    edge = -0.5 if more > 0.0 else 0.5
    breaks = [b for b, _ in profile.kinks if b < a][:6]
    r = a * np.array([0.0, 0.37, 0.97, 1.0, 1.03, 2.0])

    def pressure(s):  # a node of the reference that falls on a kink, where the pressure is infinite, is moved aside
        return wk.restore(contact, np.where(np.isin(s, breaks), np.nextafter(s, 9.0), s)).pressure

    direct = superpose(pressure, contact.radius, r, 1.0, edge=edge, breaks=breaks)
    fields = wk.restore(contact, r)
    np.testing.assert_allclose(fields.displacement, direct, rtol=1e-8)
    # in contact the displacement is what the shape dictates
    inside = r <= contact.radius
    np.testing.assert_allclose(fields.displacement[inside], depth - profile.height(r[inside]), rtol=1e-9)


@pytest.mark.parametrize("name", SHAPES)
def test_near_a_kink_the_axis_and_the_edge(name):
    """Every place may be evaluated, also those a rounding away from where something happens."""
    profile, a, more = SHAPES[name]
    contact = wk.Indentation(
        wk.Foundation(profile, UNIT), wk.Depth(float(profile.gap(np.array([a]))[0]) + more)
    ).solve()
    special = [0.0, contact.radius, *[b for b, _ in profile.kinks if b < a]]
    r = np.array(
        [t for p in special for t in (p, np.nextafter(p, 9.0), np.nextafter(p, 0.0), p + 1e-12, abs(p - 1e-9))]
    )
    fields = wk.restore(contact, r)
    assert not np.any(np.isnan(fields.pressure))
    assert np.all(fields.pressure >= 0.0)
    assert np.all(np.isfinite(fields.displacement))
    singular = {b for b, jump in profile.kinks if jump > 0.0} | ({contact.radius} if more else set())
    for place, p in zip(r, fields.pressure, strict=True):
        if place in singular:
            assert p == math.inf
        elif place > 0.0:
            assert math.isfinite(p)


def test_the_gap_opens_beyond_the_edge():
    for name, (profile, a, more) in SHAPES.items():
        if more:
            continue
        r = a * (1.0 + np.geomspace(1e-6, 0.4, 9))
        gap = wk.restore(solved(profile, a), r[r < profile.reach]).gap
        assert np.all(np.diff(gap) > 0.0), name
        assert gap[-1] > 0.0


def test_beyond_the_reach_the_gap_is_unknown_and_the_rest_is_not():
    r = np.linspace(0.0, 1e-4, 30)
    contact = solved(wk.Measured(r, r**2 / 2e-2), 5e-5)
    fields = wk.restore(contact, [6e-5, 1e-4, 1.0001e-4, 1.0])
    assert np.isfinite(fields.gap).tolist() == [True, True, False, False]
    assert np.all(fields.displacement > 0.0)


def test_shapes_of_the_answer():
    contact = solved(wk.TruncatedCone(1.0, 0.1), 0.2)
    fields = wk.restore(contact, 0.05)
    for word in ("r", "pressure", "displacement", "gap"):
        assert np.shape(getattr(fields, word)) == (), word
        assert isinstance(getattr(fields, word), float), word
        assert getattr(wk.restore(contact, [[0.0, 0.05], [0.1, 0.3]]), word).shape == (2, 2)
        assert getattr(wk.restore(contact, []), word).shape == (0,)
    assert fields.pressure == wk.restore(contact, [0.05]).pressure[0]
    assert wk.restore(contact, 0.1).pressure == math.inf
    assert wk.restore(contact, 0).pressure > 0.0


def test_nothing_touches():
    apart = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), UNIT), wk.Depth(-1e-3)).solve()
    fields = wk.restore(apart, [0.0, 0.1])
    assert not np.any(fields.pressure)
    assert not np.any(fields.displacement)
    np.testing.assert_allclose(fields.gap, [1e-3, 6e-3], rtol=1e-14)
    below = wk.restore(apart, [0.0, 0.1], [0.0, 0.2])
    assert not np.any(below.von_mises)
    just = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), UNIT), wk.Depth(0.0)).solve()
    np.testing.assert_allclose(wk.restore(just, [0.0, 0.1]).gap, [0.0, 5e-3], rtol=1e-14)
    assert wk.peak_stress(just).von_mises == 0.0


@pytest.mark.parametrize(
    ("r", "match"),
    [
        (-1e-9, r"r = -1e-09 m is negative"),
        ([0.0, math.nan], "r holds values that are not finite"),
        ([math.inf], "r holds values that are not finite"),
        ("a", "r is 'a'; give a number or an array in m"),
        ([0.1, None], "restore: r"),
    ],
)
def test_bad_places(r, match):
    with pytest.raises(wk.InvalidInput, match=match):
        wk.restore(solved(wk.Paraboloid(1.0), 0.1), r)
    with pytest.raises(wk.InvalidInput, match=r"z (holds|is)"):
        wk.restore(solved(wk.Paraboloid(1.0), 0.1), 0.1, math.nan)


def test_fields_of_two_elastic_bodies():
    """The surface field is of both together; u is shared by the compliances, each body has its own side of z = 0."""
    soft, hard = wk.Elastic(1.0, 0.45), wk.Elastic(3.0, 0.2)
    contact = solved(wk.Paraboloid(1.0), 0.3, wk.HalfSpace.between(soft, hard))
    r = np.array([0.0, 0.2, 0.4])
    tiny = 1e-12
    first, second = wk.restore(contact, r, tiny), wk.restore(contact, r, -tiny)
    together = first.axial_displacement + second.axial_displacement
    np.testing.assert_allclose(together, wk.restore(contact, r).displacement, rtol=1e-9)
    share = (1.0 - 0.45**2) / 1.0 * contact.problem.bed.medium.modulus
    np.testing.assert_allclose(first.axial_displacement / together, share, rtol=1e-9)
    np.testing.assert_allclose(-first.axial_stress, wk.restore(contact, r).pressure, rtol=1e-9, atol=1e-10)
    np.testing.assert_allclose(-second.axial_stress, wk.restore(contact, r).pressure, rtol=1e-9, atol=1e-10)


def test_the_side_of_a_rigid_body_is_refused():
    contact = solved(wk.Paraboloid(1.0), 0.3)
    wk.restore(contact, 0.1, 0.1)
    with pytest.raises(wk.OutsideValidity, match="rigid; there is no stress field in it: request the other side"):
        wk.restore(contact, [0.1, 0.1], [0.1, -0.1])


def test_a_transversely_isotropic_body_has_stresses_that_bear_the_pressure():
    medium = wk.TransverselyIsotropicHalfSpace.between(wk.TransverselyIsotropic(10.0, 4.0, 3.5, 12.0, 3.0))
    contact = solved(wk.Paraboloid(1.0), 0.3, medium)
    assert wk.restore(contact, 0.0).pressure == pytest.approx(2.0 * 0.3 * medium.modulus / math.pi, rel=1e-12)
    assert wk.restore(contact, 0.0, 1e-9).axial_stress == pytest.approx(-wk.restore(contact, 0.0).pressure, rel=1e-6)


def test_an_even_pressure_that_does_not_settle_is_refused():
    """g' is infinite at its edge: a sentence states why there is no number, and numpy does not warn before it."""
    bed = wk.PlaneFoundation(wk.Ellipsoid(1.0, 1.0), wk.HalfSpace(wk.Elastic(1.0, 0.0)))
    contact = wk.Indentation(bed, wk.Depth(1.0)).solve()
    with pytest.raises(wk.NotConverged, match="not smooth"):
        wk.restore(contact, np.array([0.0]))
