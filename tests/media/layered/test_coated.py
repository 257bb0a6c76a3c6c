"""Coated bodies: published and independently computed numbers, limits, and what must agree with what."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.materials.layered import Layer
from winkler.media.layered.coated import CoatedHalfSpace

BALL = wk.Paraboloid(curvature_radius=1.0)


def coated(young: float, poisson: float = 0.3, base: float | None = 1.0, thickness: float = 1.0) -> CoatedHalfSpace:
    """One layer on a half-space of the same Poisson ratio, or on a rigid base."""
    on = wk.Rigid() if base is None else wk.Elastic(base, poisson)
    return CoatedHalfSpace([Layer(wk.Elastic(young, poisson), thickness)], on=on)


HARD, SOFT, FILM = coated(10.0), coated(0.1), coated(1.0, 0.5, None)
STACK = CoatedHalfSpace(
    [Layer(wk.Elastic(20.0, 0.2), 0.3), Layer(wk.Elastic(0.5, 0.45), 0.2), Layer(wk.Elastic(5.0, 0.3), 0.4)],
    on=wk.Elastic(1.0, 0.3),
    second=wk.Elastic(8.0, 0.25),
)
MEDIA = {"hard": HARD, "soft": SOFT, "film": FILM, "stack": STACK}


def relative(medium: CoatedHalfSpace, a: float) -> float:
    """k / (2 E* a)."""
    return float(medium.punch_stiffness(np.array(a)) / (2.0 * medium.modulus * a))


# -------------------------------------------------------------------------------------------- numbers (theory 8.2)


@pytest.mark.parametrize(
    ("young", "a", "want"),
    [(10.0, a, k) for a, k in ((0.1, 0.680722), (0.5, 0.311850), (1.0, 0.208799), (2.0, 0.156872), (5.0, 0.126553))]
    + [(0.1, a, k) for a, k in ((0.1, 1.083543), (0.5, 1.517171), (1.0, 2.135176), (2.0, 3.195387), (5.0, 5.113847))],
)
def test_stiffness_of_coatings(young, a, want):
    assert relative(coated(young), a) == pytest.approx(want, abs=6e-7)


@pytest.mark.parametrize(
    ("a", "want"), [(1.0, 1.4982), (10.0, 1.0780), pytest.param(50.0, 1.0214, marks=pytest.mark.slow)]
)
def test_wide_punches_feel_the_substrate(a, want):
    assert 3.0 * relative(coated(3.0), a) == pytest.approx(want, abs=6e-5)


@pytest.mark.parametrize(
    ("poisson", "a", "want", "hayes"),
    [
        (0.3, 0.2, 1.20656, 1.207),
        (0.3, 0.4, 1.47261, 1.472),
        (0.3, 0.6, 1.78475, 1.784),
        (0.3, 1.0, 2.48352, None),
        (0.5, 0.2, 1.2806, 1.281),
        (0.5, 0.4, 1.6837, 1.683),
        (0.5, 0.6, 2.2129, 2.211),
        (0.5, 1.0, 3.6187, 3.609),
    ],
)
def test_cartilage_after_hayes(poisson, a, want, hayes):
    """W. C. Hayes et al., J. Biomech. 5 (1972) 541; the table of 1972 is good to three digits."""
    found = relative(coated(1.0, poisson, None), a)
    assert found == pytest.approx(want, abs=6e-6 if poisson == 0.3 else 6e-5)
    if hayes:
        assert found == pytest.approx(hayes, rel=3e-3)


@pytest.mark.parametrize(
    ("chi", "want"), [(0.04906, 1.05903), (0.09622, 1.12355), (0.2674, 1.44003), (0.41722, 1.85716), (0.748, 3.37145)]
)
def test_a_ball_on_an_incompressible_film(chi, want):
    radius = 100.0
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(radius), FILM), wk.Depth(chi**2 / radius)).solve()
    hertz = 4.0 / 3.0 * FILM.modulus * math.sqrt(radius) * contact.depth**1.5
    assert contact.force / hertz == pytest.approx(want, abs=1.2e-5)


@pytest.mark.parametrize(
    ("young", "a", "depth", "force"),
    [
        (10.0, 0.5, 0.55951, 8.831005),
        (10.0, 1.0, 2.30283, 5.942376),
        (0.1, 1.0, 0.693461, 0.121938),
        (0.5, 1.0, 0.847415, 0.549976),
        (2.0, 1.0, 1.237564, 1.751246),
    ],
)
def test_a_ball_on_a_coating(young, a, depth, force):
    """Forces over Hertz' for the substrate."""
    contact = wk.Indentation(wk.Foundation(BALL, coated(young)), wk.Radius(a)).solve()
    assert contact.depth == pytest.approx(depth, abs=6e-6)
    assert contact.force / (4.0 / 3.0 / 0.91 * a**3) == pytest.approx(force, abs=6e-7)


def test_the_pressure_on_a_coating():
    """Theory 0.3: by the springs' own load it would be off by a factor of thirty."""
    medium = coated(26.0, base=2.6)  # G of the substrate is 1
    contact = wk.Indentation(wk.Foundation(BALL, medium), wk.Radius(1.0)).solve()
    np.testing.assert_allclose(wk.restore(contact, [0.0, 0.6]).pressure, [9.95, 8.60], rtol=6e-4)


# --------------------------------------------------------------- an independent discretisation in three dimensions


def least_energy(excess, modulus: float, a: float, h) -> tuple[float, float]:
    """Minimise pi Int C p^2 xi dxi - Int p h over p = Sum c_n p_n, p_n the pressures of Legendre line loads.

    Uses C(xi) alone: neither kernel nor integral equation.  Returns the force and twice the energy.
    """
    from scipy.special import eval_legendre, spherical_jn

    count = 12
    s, w = np.polynomial.legendre.leggauss(300)
    xi, weights = 10.0 * (s + 1.0), 10.0 * w
    bessel = [(-1) ** n * spherical_jn(2 * n, xi * a) for n in range(count)]
    matrix = np.array([[np.sum(weights * excess(xi) * one * other) for other in bessel] for one in bessel])
    matrix += np.diag([np.pi / (2.0 * a * (4 * n + 1)) for n in range(count)])  # the half-space of the coating
    matrix *= 4.0 * a**2 / (np.pi * modulus)
    x, w = np.polynomial.legendre.leggauss(60)
    right = np.array([np.sum(w * a * eval_legendre(2 * n, x) * h(a * x)) for n in range(count)])
    c = np.linalg.solve(matrix, right)
    return 2.0 * a * c[0], float(c @ right)


@pytest.mark.parametrize("young", [10.0, 0.1])
@pytest.mark.parametrize("a", [pytest.param(0.4, marks=pytest.mark.slow), 1.5])
def test_against_the_least_energy_of_the_closed_compliance(young, a):
    g = 3.0 - 4.0 * 0.3
    big_a, big_b = (young * g - g) / (1 + young * g), (young - 1) / (young + g)

    def excess(xi):
        e = np.exp(-2.0 * xi)
        below = 1 - (big_a + big_b + 4 * big_b * xi**2) * e + big_a * big_b * e**2
        return (1 + 4 * big_b * xi * e - big_a * big_b * e**2) / below - 1.0

    medium = coated(young)
    force, _ = least_energy(excess, medium.modulus, a, np.ones_like)
    assert float(medium.punch_stiffness(np.array(a))) == pytest.approx(force, rel=1e-9)
    contact = wk.Indentation(wk.Foundation(BALL, medium), wk.Radius(a)).solve()
    force, energy = least_energy(excess, medium.modulus, a, lambda x: contact.depth - x**2)
    assert contact.force == pytest.approx(force, rel=1e-9)
    assert 2.0 * contact.energy == pytest.approx(energy, rel=1e-9)


# ----------------------------------------------------------------------------------------------------- consistency


@pytest.mark.parametrize(
    "name",
    ["hard", "soft", pytest.param("film", marks=pytest.mark.slow), pytest.param("stack", marks=pytest.mark.slow)],
)
def test_stiffness_by_two_formulas(name):
    medium = MEDIA[name]
    a = np.geomspace(0.01, 20.0, 50)
    h = 1e-3 * a
    moved = [medium.punch_stiffness(a + k * h) - medium.punch_stiffness(a - k * h) for k in (1, 2, 3)]
    slope = (45.0 * moved[0] - 9.0 * moved[1] + moved[2]) / (60.0 * h)
    np.testing.assert_allclose(slope, 2.0 * medium.normal_stiffness(a), rtol=1e-10)


SHAPES = {
    "paraboloid": BALL,
    "cone": wk.Cone(1.2),
    "power": wk.PowerLaw(1.0, 1.5),
    "truncated cone": wk.TruncatedCone(1.2, flat_radius=0.4),
    "sphero-conical": wk.SpheroConical(0.5, 1.0),
}
QUICK = {("paraboloid", "hard"), ("paraboloid", "film"), ("cone", "soft"), ("truncated cone", "stack")}
"""One of each by default."""
NEXT = {("cone", "hard"), ("power", "stack"), ("sphero-conical", "film"), ("truncated cone", "soft")}
"""One of each among the slow tests."""


@pytest.mark.parametrize(
    ("shape", "name"),
    [
        pytest.param(shape, name, marks=[pytest.mark.slow if (shape, name) in NEXT else pytest.mark.long])
        if (shape, name) not in QUICK
        else (shape, name)
        for shape in SHAPES
        for name in MEDIA
    ],
)
def test_force_energy_pressure_and_surface_agree(shape, name):
    shape, medium = SHAPES[shape], MEDIA[name]
    bed = wk.Foundation(shape, medium)
    depth = np.array([-2, -1, 0, 1, 2]) * 2e-3 + float(bed.gap(np.array([1.1]))[0])
    curve = wk.Indentation(bed, wk.Depth(depth)).solve()
    h = depth[1] - depth[0]
    stencil = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) / (12.0 * h)
    middle = curve.at(2)
    assert stencil @ curve.energy == pytest.approx(middle.force, rel=1e-8)
    assert stencil @ curve.force == pytest.approx(middle.stiffness, rel=1e-8)
    # the pressure carries the force
    a = middle.radius
    s, w = np.polynomial.legendre.leggauss(120)
    edges = [0.0, *(b for b, _ in shape.kinks if b < a), a]
    force = 0.0
    for low, high in zip(edges[:-1], edges[1:], strict=True):
        angle = 0.25 * np.pi * (s + 1.0)
        r = low + (high - low) * np.sin(angle) ** 2
        dr = (high - low) * 2.0 * np.sin(angle) * np.cos(angle) * 0.25 * np.pi * w
        force += float(np.sum(2.0 * np.pi * r * wk.restore(middle, r).pressure * dr))
    assert force == pytest.approx(middle.force, rel=1e-5 if len(edges) > 2 else 1e-7)
    # the surface follows the body inside, and is nowhere above it outside
    r = np.linspace(0.0, 0.999, 23) * a
    np.testing.assert_allclose(wk.restore(middle, r).displacement, middle.depth - shape.height(r), atol=1e-9, rtol=0)
    assert np.all(wk.restore(middle, a * np.array([1.001, 1.05, 1.5, 4.0])).gap > 0.0)


def test_a_pinned_edge():
    """A flat punch: k d, with a singular edge; its pressure carries the force."""
    contact = wk.Indentation(wk.Foundation(wk.FlatPunch(0.7), STACK), wk.Depth(0.01)).solve()
    assert contact.force == pytest.approx(0.01 * float(STACK.punch_stiffness(np.array(0.7))), rel=1e-13)
    s, w = np.polynomial.legendre.leggauss(60)
    angle = 0.25 * np.pi * (s + 1.0)
    r = 0.7 * np.sin(angle)  # dr = 0.7 cos: the inverse root is gone
    p = wk.restore(contact, r).pressure
    force = float(np.sum(2 * np.pi * r * p * 0.7 * np.cos(angle) * 0.25 * np.pi * w))
    assert force == pytest.approx(contact.force, rel=1e-9)
    np.testing.assert_allclose(wk.restore(contact, [0.0, 0.3, 0.69]).displacement, 0.01, rtol=1e-10)


# ---------------------------------------------------------------------------------------------------------- limits


@pytest.mark.slow
@pytest.mark.parametrize("second", [wk.Rigid(), wk.Elastic(3.0, 0.4)])
def test_equal_layers_are_no_layers(second):
    solid = wk.Elastic(2.0, 0.3)
    medium = CoatedHalfSpace([Layer(solid, 0.1), Layer(solid, 3.0)], on=solid, second=second)
    plain = wk.HalfSpace.between(solid, second)
    a = np.geomspace(1e-3, 30.0, 20)
    np.testing.assert_allclose(medium.punch_stiffness(a), plain.punch_stiffness(a), rtol=1e-12)
    np.testing.assert_allclose(medium.tangential_stiffness(a), plain.tangential_stiffness(a), rtol=1e-12)
    shape = wk.SpheroConical(0.5, 1.0)
    here, there = (wk.Indentation(wk.Foundation(shape, m), wk.Force(1.5)).solve() for m in (medium, plain))
    assert (here.depth, here.radius, here.energy) == pytest.approx((there.depth, there.radius, there.energy), rel=1e-12)
    r, z = np.array([0.0, 0.3, 1.0]), np.array([0.05, 0.5, 4.0])
    mine, theirs = wk.restore(here, r, z), wk.restore(there, r, z)
    for part in ("radial_stress", "hoop_stress", "axial_stress", "shear_stress", "axial_displacement"):
        np.testing.assert_allclose(getattr(mine, part), getattr(theirs, part), rtol=0, atol=1e-10)


@pytest.mark.slow
def test_a_layer_cut_in_two_is_the_same():
    whole, a = HARD, np.geomspace(0.01, 20.0, 15)
    parts = CoatedHalfSpace([Layer(wk.Elastic(10.0, 0.3), h) for h in (0.4, 0.6)], on=wk.Elastic(1.0, 0.3))
    np.testing.assert_allclose(parts.punch_stiffness(a), whole.punch_stiffness(a), rtol=1e-10)
    np.testing.assert_allclose(parts.gap(BALL, a), whole.gap(BALL, a), rtol=1e-10)


@pytest.mark.slow
@pytest.mark.parametrize("young", [10.0, 0.1])
def test_very_thick_and_very_thin(young):
    shape = wk.Cone(1.2)
    thick = coated(young, thickness=1e4)
    thin = coated(young, thickness=1e-4)
    of_coating, of_base = (wk.HalfSpace.between(wk.Elastic(e, 0.3)) for e in (young, 1.0))
    for medium, limit in ((thick, of_coating), (thin, of_base)):
        bed, plain = wk.Foundation(shape, medium), wk.Foundation(shape, limit)
        assert float(bed.stiffness(np.array(1.0))) == pytest.approx(float(plain.stiffness(np.array(1.0))), rel=3e-3)
        here, there = (wk.Indentation(b, wk.Depth(1.0)).solve() for b in (bed, plain))
        assert here.force == pytest.approx(there.force, rel=3e-3)


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.45])
def test_a_compressible_film_squeezed_thin_is_a_winkler_bed(poisson):
    """k -> pi a^2 M_c / h, M_c the oedometric modulus, with a correction of the order of h/a."""
    a = np.array([10.0, 20.0])
    medium = coated(1.0, poisson, None)
    confined = (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson))
    ratio = medium.punch_stiffness(a) / (np.pi * a**2 * confined)
    limit = 2.0 * ratio[1] - ratio[0]
    assert limit == pytest.approx(1.0, abs=0.02)


@pytest.mark.slow
def test_an_incompressible_film_squeezed_thin():
    """Lubrication theory, the film slips under the punch: k -> 3 pi G a^4 / (8 h^3), with corrections in h/a."""
    a = np.array([10.0, 20.0, 40.0])
    shear = 1.0 / 3.0
    ratio = FILM.punch_stiffness(a) / (0.375 * np.pi * shear * a**4)
    first = 2.0 * ratio[1:] - ratio[:-1]
    assert (4.0 * first[1] - first[0]) / 3.0 == pytest.approx(1.0, abs=2e-3)


@pytest.mark.parametrize("contrast", [1e-4, 1e4])
@pytest.mark.parametrize("thickness", [pytest.param(1e-3, marks=pytest.mark.slow), 1.0, 30.0])
def test_extreme_contrasts_and_thicknesses(contrast, thickness):
    """Between the bounds of the two solids, rising, and k' consistent with k."""
    medium = coated(contrast, thickness=thickness)
    a = np.geomspace(0.1, 3.0, 7)
    k = medium.punch_stiffness(a)
    bounds = np.sort([2 * a * e / 0.91 for e in (contrast, 1.0)], axis=0)
    assert np.all((k > bounds[0]) & (k < bounds[1] * (1 + 1e-12)))
    h = 1e-3 * a
    moved = [medium.punch_stiffness(a + j * h) - medium.punch_stiffness(a - j * h) for j in (1, 2, 3)]
    slope = (45.0 * moved[0] - 9.0 * moved[1] + moved[2]) / (60.0 * h)
    np.testing.assert_allclose(slope, 2.0 * medium.normal_stiffness(a), rtol=2e-9)


def test_units_do_not_matter():
    small = CoatedHalfSpace([Layer(wk.Elastic(10e9, 0.3), 1e-6)], on=wk.Elastic(1e9, 0.3))
    a = np.array([0.1, 0.9, 3.0])
    np.testing.assert_allclose(small.punch_stiffness(a * 1e-6), HARD.punch_stiffness(a) * 1e3, rtol=1e-12)


@pytest.mark.slow
def test_tangential_springs_of_narrow_and_wide_contacts():
    g = [0.5 * 4 / 1.7 * e / 1.3 for e in (10.0, 1.0)]
    found = HARD.tangential_stiffness(np.array([1e-9, 1e4]))
    np.testing.assert_allclose(found, g, rtol=2e-3)


# ------------------------------------------------------------------------------------------------------- bad input


@pytest.mark.parametrize("thickness", [0.0, -1e-6, math.nan, math.inf, "1 um", True])
def test_layers_without_thickness(thickness):
    with pytest.raises(wk.InvalidInput, match="thickness is .* positive, finite number in m"):
        Layer(wk.Elastic(1.0, 0.3), thickness)


def test_other_bad_input():
    layer = Layer(wk.Elastic(1.0, 0.3), 1.0)
    with pytest.raises(wk.InvalidInput, match="give Elastic"):
        Layer(wk.Rigid(), 1.0)
    with pytest.raises(wk.InvalidInput, match="at least one Layer"):
        CoatedHalfSpace([], on=wk.Rigid())
    with pytest.raises(wk.InvalidInput, match=r"layers\[1\] is a Elastic"):
        CoatedHalfSpace([layer, wk.Elastic(1.0, 0.3)], on=wk.Rigid())
    with pytest.raises(wk.InvalidInput, match="on is a Layer"):
        CoatedHalfSpace([layer], on=layer)
    with pytest.raises(wk.InvalidInput, match="second is a float"):
        CoatedHalfSpace([layer], on=wk.Rigid(), second=1.0)


def test_it_is_a_value():
    import pickle

    assert coated(10.0) == HARD
    assert hash(coated(10.0)) == hash(HARD)
    assert pickle.loads(pickle.dumps(STACK)) == STACK
