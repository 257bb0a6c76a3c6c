"""Half-spaces graded by a power law: moduli, transforms, fields, limits, and the laws of every medium."""

from __future__ import annotations

import math
import pickle

import mpmath as mp
import numpy as np
import pytest

import winkler as wk
from winkler.materials.graded import PowerLawGraded
from winkler.media.graded.power_law import GradedHalfSpace, normal_factor
from winkler.numerics.integrals.quadrature import tanh_sinh
from winkler.numerics.transforms import graded_abel

EXPONENTS = (-0.6, -0.2, 0.0, 0.1, 0.5, 0.85)


def medium(k: float, poisson: float = 0.3, young: float = 1.0, depth_scale: float = 0.7) -> GradedHalfSpace:
    return GradedHalfSpace.between(PowerLawGraded(young, depth_scale, k, poisson))


def factor(k, nu):
    """h_N of theory 8.1 in mpmath."""
    k, nu = mp.mpf(k), mp.mpf(nu)
    if k == 1:
        return mp.pi / 2
    beta = mp.sqrt((1 + k) * (1 - k * nu / (1 - nu)))
    c = 2 ** (1 + k) * mp.gamma((3 + k + beta) / 2) * mp.gamma((3 + k - beta) / 2) / (mp.pi * mp.gamma(2 + k))
    top = 2 * (1 + k) * mp.cos(k * mp.pi / 2) * mp.gamma(1 + k / 2)
    return top / (mp.sqrt(mp.pi) * c * beta * mp.sin(beta * mp.pi / 2) * mp.gamma((1 + k) / 2))


TABLE = {
    -0.2: (0.8100622978, 0.7678700736, 0.7568163665, 0.7309030227),
    0.1: (1.062728703, 1.088528206, 1.096278249, 1.116440045),
    0.25: (1.104151431, 1.167483348, 1.188243901, 1.246293023),
    0.5: (1.000893963, 1.1014446, 1.141408652, 1.272792206),
    0.75: (0.6417553318, 0.7214312988, 0.7634169469, 0.9369001128),
}
SHEAR = {
    0.25: (0.9031452196, 0.8169924799, 0.8066857105, 0.7916567993),
    0.5: (0.6866071539, 0.6060889225, 0.5951459275, 0.5772300255),
}


@pytest.mark.parametrize(("k", "row"), TABLE.items())
def test_normal_factor(k, row):
    for nu, number in zip((0.0, 0.25, 0.3, 0.4), row, strict=True):
        assert normal_factor(k, nu) == pytest.approx(number, rel=1e-9)
        assert normal_factor(k, nu) == pytest.approx(float(factor(k, nu)), rel=2e-14)


@pytest.mark.parametrize(("k", "row"), SHEAR.items())
def test_shear_modulus(k, row):
    for nu, number in zip((0.0, 0.25, 0.3, 0.4), row, strict=True):
        assert medium(k, nu).shear_modulus == pytest.approx(number, rel=1e-9)


def test_homogeneous_limit():
    """k = 0 is the half-space, and k -> 0 goes there."""
    steel = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(70e9, 0.2))
    same = GradedHalfSpace(PowerLawGraded(210e9, 1e-3, 0.0, 0.3), PowerLawGraded(70e9, 2e-3, 0.0, 0.2))
    assert same.modulus == pytest.approx(steel.modulus, rel=1e-14)
    assert same.shear_modulus == pytest.approx(steel.shear_modulus, rel=1e-14)
    for profile in (wk.Sphere(1e-2), wk.TruncatedCone(1.4, 1e-4), wk.Wavy(1e-6, 1e-3) + wk.Paraboloid(1e-3)):
        exact = wk.Indentation(wk.Foundation(profile, steel), wk.Force(5.0)).solve()
        graded = wk.Indentation(wk.Foundation(profile, same), wk.Force(5.0)).solve()
        assert graded.radius == pytest.approx(exact.radius, rel=1e-12)
        assert graded.depth == pytest.approx(exact.depth, rel=1e-12)
        r = exact.radius * np.array([0.0, 0.3, 0.9, 1.5])
        np.testing.assert_allclose(
            wk.restore(graded, r).displacement, wk.restore(exact, r).displacement, rtol=1e-11, atol=1e-24
        )
        p, q = wk.restore(graded, r[1:]).pressure, wk.restore(exact, r[1:]).pressure
        np.testing.assert_allclose(p, q, rtol=1e-10)
    small = GradedHalfSpace(PowerLawGraded(210e9, 1e-3, 1e-9, 0.3), PowerLawGraded(70e9, 1e-3, 1e-9, 0.2))
    assert small.modulus == pytest.approx(steel.modulus, rel=1e-8)
    assert small.shear_modulus == pytest.approx(steel.shear_modulus, rel=1e-8)


def test_depth_scale_is_only_a_unit():
    k = 0.3
    one = GradedHalfSpace(PowerLawGraded(1e9, 1e-3, k, 0.3), PowerLawGraded(2e9, 1e-3, k, 0.2))
    two = GradedHalfSpace(PowerLawGraded(1e9 * 5.0**k, 5e-3, k, 0.3), PowerLawGraded(2e9 * 0.1**k, 0.1e-3, k, 0.2))
    a = np.array([1e-5, 1e-3])
    np.testing.assert_allclose(one.punch_stiffness(a), two.punch_stiffness(a), rtol=1e-14)
    np.testing.assert_allclose(one.tangential_stiffness(a), two.tangential_stiffness(a), rtol=1e-14)


@pytest.mark.parametrize("k", EXPONENTS)
@pytest.mark.parametrize("n", [0.7, 1.0, 2.0, 3.5])
def test_power_law(k, n):
    """g = kappa c x^n, kappa = (n/2) B(n/2, (1+k)/2), by quadrature and in closed form; and the force."""
    kappa = 0.5 * n * float(mp.beta(mp.mpf(n) / 2, (1 + mp.mpf(k)) / 2))
    x = np.array([0.0, 1e-3, 0.4, 1.0])
    m = medium(k)
    profile = wk.PowerLaw(0.3, n)
    np.testing.assert_allclose(m.gap(profile, x), kappa * 0.3 * x**n, rtol=1e-13)
    if n >= 1.0:
        np.testing.assert_allclose(graded_abel.gap(profile.slope, (), k, x), m.gap(profile, x), rtol=1e-11)
        np.testing.assert_allclose(
            graded_abel.gap_slope(profile.slope, profile.curvature, (), k, x[1:]),
            m.gap_slope(profile, x[1:]),
            rtol=1e-11,
        )
        whole = graded_abel.gap_integral(profile.slope, (), k, x)
        np.testing.assert_allclose(2.0 * m.modulus / 0.7**k * whole, m.gap_load(profile, x), rtol=1e-11)
    force = 2.0 * m.modulus * n * kappa * 0.3 * 0.4 ** (n + k + 1.0) / (0.7**k * (k + 1.0) * (n + k + 1.0))
    contact = wk.Indentation(wk.Foundation(profile, m), wk.Radius(0.4)).solve()
    assert contact.force == pytest.approx(force, rel=1e-12)


SHAPES = {
    "paraboloid": wk.Paraboloid(1.0),
    "sphere": wk.Sphere(1.0),
    "hyperboloid": wk.Hyperboloid(1.0, 1.0),
    "cone": wk.Cone(1.3),
    "truncated cone": wk.TruncatedCone(1.3, 0.2),
    "rounded punch": wk.RoundedPunch(0.2, 1.0),
    "capped": wk.CappedParaboloid(1.0, 2.0, 0.2),
    "sphero-conical": wk.SpheroConical(0.5, 1.0),
    "sum": wk.Paraboloid(1.0) + wk.PowerLaw(0.5, 4.0),
    "formula": wk.Formula("r**2/2 + r**3*exp(-r)"),
    "measured": wk.Measured(np.linspace(0.0, 1.0, 41), np.linspace(0.0, 1.0, 41) ** 2 / 2.0),
}


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize("k", [-0.4, 0.3])
def test_closed_forms_are_the_quadratures(name, k):
    profile, m = SHAPES[name], medium(k)
    x = np.array([0.05, 0.21, 0.5])
    edges = [b for b, _ in profile.kinks]
    np.testing.assert_allclose(m.gap(profile, x), graded_abel.gap(profile.slope, edges, k, x), rtol=1e-9)
    whole = graded_abel.gap_integral(profile.slope, edges, k, x)
    np.testing.assert_allclose(m.gap_load(profile, x), 2.0 * m.modulus / 0.7**k * whole, rtol=1e-9)
    middle = 0.5 * (m.gap(profile, x * (1 + 1e-5)) - m.gap(profile, x * (1 - 1e-5))) / (1e-5 * x)
    np.testing.assert_allclose(m.gap_slope(profile, x), middle, rtol=1e-6)


LONG = {("sphero-conical", 0.3), ("measured", 0.3), ("measured", -0.4)}
"""Many kinks, or one on which the pressure has a cusp."""


@pytest.mark.parametrize(
    ("name", "k"),
    [
        pytest.param(name, k, marks=[pytest.mark.slow] if (name, k) in LONG else [])
        for name in SHAPES
        for k in (-0.4, 0.3)
    ],
)
def test_body_and_springs_agree(name, k):
    """The restored surface lies on the body, the pressure carries the force, dF/dd is k, and U its integral."""
    profile, m = SHAPES[name], medium(k)
    bed = wk.Foundation(profile, m)
    contact = wk.Indentation(bed, wk.Radius(0.4)).solve()
    a = contact.radius
    r = a * np.array([0.0, 0.1, 0.4, 0.7, 0.95, 0.999])
    inside = wk.restore(contact, r).displacement
    np.testing.assert_allclose(inside, contact.depth - profile.height(r), rtol=1e-9, atol=1e-9 * contact.depth)
    nodes, complements, weights = tanh_sinh(161)
    edges = [0.0, *(b for b, _ in bed.kinks if b < a), a]
    force = 0.0
    for low, high in zip(edges[:-1], edges[1:], strict=True):
        place = low + (high - low) * nodes
        usable = (complements > 1e-12) & (nodes > 1e-12)
        place = place[usable]
        force += (high - low) * float(
            np.sum(2.0 * np.pi * place * m.pressure(contact.pressed, place) * weights[usable])
        )
    tolerance = 1e-8 if k > 0 or not any(s for _, s in bed.kinks) else 1e-4  # p diverges at a kink if k <= 0
    assert force == pytest.approx(contact.force, rel=tolerance)
    step = 1e-5 * contact.depth
    near = wk.Indentation(bed, wk.Depth(contact.depth + step * np.array([-1.0, 1.0]))).solve()
    assert (near.force[1] - near.force[0]) / (2.0 * step) == pytest.approx(contact.stiffness, rel=1e-7)
    work = near.energy
    assert (work[1] - work[0]) / (2.0 * step) == pytest.approx(contact.force, rel=1e-6)


@pytest.mark.parametrize("k", [-0.5, 0.0, 0.4])
def test_flat_punch(k):
    m = medium(k)
    contact = wk.Indentation(wk.Foundation(wk.FlatPunch(0.5), m), wk.Depth(0.01)).solve()
    assert contact.force == pytest.approx(2.0 * m.modulus * 0.01 * 0.5 ** (1 + k) / ((1 + k) * 0.7**k), rel=1e-13)
    r = np.array([0.0, 0.2, 0.49, 0.5, 0.6, 2.0])
    fields = wk.restore(contact, r)
    expected = m.modulus * 0.01 / (np.pi * 0.7**k) * (0.25 - r[:3] ** 2) ** (0.5 * (k - 1.0))
    np.testing.assert_allclose(fields.pressure[:3], expected, rtol=1e-12)
    assert fields.pressure[3] == math.inf
    assert np.all(fields.pressure[4:] == 0.0)
    outside = [
        0.01 * float(mp.betainc((1 + mp.mpf(k)) / 2, (1 - mp.mpf(k)) / 2, 0, (0.5 / x) ** 2, regularized=True))
        for x in r[4:]
    ]
    np.testing.assert_allclose(fields.displacement[4:], outside, rtol=1e-10)


def test_at_a_kink():
    """For k > 0 the pressure at a kink is finite and continuous; for k <= 0 it is infinite."""
    bed = wk.Foundation(wk.TruncatedCone(1.3, 0.2), medium(0.5))
    contact = wk.Indentation(bed, wk.Radius(0.4)).solve()
    p = wk.restore(contact, np.array([0.2 - 1e-13, 0.2, 0.2 + 1e-13])).pressure
    assert np.all(np.isfinite(p))
    np.testing.assert_allclose(p, p[1], rtol=1e-5)
    bed = wk.Foundation(wk.TruncatedCone(1.3, 0.2), medium(-0.2))
    contact = wk.Indentation(bed, wk.Radius(0.4)).solve()
    assert wk.restore(contact, np.array([0.2])).pressure[0] == math.inf


def test_cone_apex():
    """A cone's pressure at its apex is infinite up to k = 0, and finite beyond: E* g' a^k / (pi c0^k k)."""
    for k, finite in ((-0.2, False), (0.0, False), (0.4, True)):
        m = medium(k)
        contact = wk.Indentation(wk.Foundation(wk.Cone(1.3), m), wk.Radius(0.4)).solve()
        p = wk.restore(contact, np.array([0.0])).pressure[0]
        assert math.isfinite(p) == finite
        if finite:
            slope = m.gap_slope(wk.Cone(1.3), np.array([0.4]))[0]
            assert p == pytest.approx(m.modulus * slope * 0.4**k / (np.pi * 0.7**k * k), rel=1e-9)


def test_gibson():
    """k = 1, nu = 1/2: Winkler's foundation; the limit k -> 1 goes there; nothing is NaN."""
    gibson = medium(1.0, 0.5, 3.0, 2.0)
    nearly = medium(1.0 - 1e-8, 0.5, 3.0, 2.0)
    assert nearly.modulus == pytest.approx(gibson.modulus, rel=1e-6)
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), gibson), wk.Depth(0.02)).solve()
    winkler = 2.0 * 3.0 / (3.0 * 2.0)
    assert contact.radius == pytest.approx(0.2, rel=1e-12)
    assert contact.force == pytest.approx(winkler * np.pi * 0.02**2, rel=1e-12)
    r = np.array([0.0, 0.1, 0.199, 0.2, 0.3])
    fields = wk.restore(contact, r)
    np.testing.assert_allclose(fields.pressure, winkler * np.maximum(0.02 - 0.5 * r * r, 0.0), rtol=1e-9, atol=1e-15)
    np.testing.assert_allclose(fields.displacement, np.maximum(0.02 - 0.5 * r * r, 0.0), rtol=1e-9, atol=1e-15)
    with pytest.raises(wk.OutsideValidity, match="tangential"):
        _ = gibson.shear_modulus
    with pytest.raises(wk.InvalidInput, match=r"poisson = 0\.5"):
        PowerLawGraded(1.0, 1.0, 1.0, 0.3)


@pytest.mark.parametrize(
    ("change", "what"),
    [
        ({"young": 0.0}, "young"),
        ({"young": math.nan}, "young"),
        ({"depth_scale": -1.0}, "depth_scale"),
        ({"exponent": -1.0}, "exponent"),
        ({"exponent": 1.2}, "exponent"),
        ({"exponent": math.nan}, "exponent"),
        ({"poisson": 0.6}, "poisson"),
        ({"poisson": -1.0}, "poisson is -1.0; a Poisson ratio is above -1 and at most 0.5"),
        ({"poisson": math.nan}, "poisson"),
        ({"young": "1 GPa"}, "young is '1 GPa'; it must be a positive, finite number in Pa"),
        ({"young": True}, "young is True"),
        ({"depth_scale": math.inf}, "depth_scale is inf; it must be a positive, finite number in m"),
        ({"exponent": None}, "exponent is None"),
        ({"exponent": -math.inf}, "above -1 and below 1"),
        ({"exponent": 1.0, "poisson": 0.49}, r"Gibson's solid needs poisson = 0\.5"),
    ],
)
def test_bad_solids(change, what):
    good = {"young": 1.0, "depth_scale": 1.0, "exponent": 0.2, "poisson": 0.3}
    with pytest.raises(wk.InvalidInput, match=what):
        PowerLawGraded(**(good | change))


def test_bad_pairs():
    body = PowerLawGraded(1.0, 1.0, 0.2, 0.3)
    with pytest.raises(wk.InvalidInput, match="both bodies are rigid"):
        GradedHalfSpace(wk.Rigid())
    with pytest.raises(wk.InvalidInput, match=r"exponents 0\.2 and 0\.3"):
        GradedHalfSpace(body, PowerLawGraded(1.0, 1.0, 0.3, 0.3))
    with pytest.raises(wk.InvalidInput, match="second is a Elastic; give PowerLawGraded"):
        GradedHalfSpace(body, wk.Elastic(1.0, 0.3))
    with pytest.raises(wk.InvalidInput, match="first is a NoneType"):
        GradedHalfSpace(None)


def test_a_value():
    one = medium(0.2)
    assert one == pickle.loads(pickle.dumps(one))
    assert hash(one) == hash(medium(0.2))


def test_scaling():
    """Lengths times s, moduli times m: forces times m s^2, exactly."""
    s, factor_ = 7.0, 3.0
    small = wk.Indentation(wk.Foundation(wk.Sphere(1.0), medium(0.35)), wk.Radius(0.3)).solve()
    large = wk.Indentation(
        wk.Foundation(wk.Sphere(s), medium(0.35, young=factor_, depth_scale=0.7 * s)), wk.Radius(0.3 * s)
    ).solve()
    assert large.force == pytest.approx(factor_ * s * s * small.force, rel=1e-12)
    assert large.energy == pytest.approx(factor_ * s**3 * small.energy, rel=1e-11)
