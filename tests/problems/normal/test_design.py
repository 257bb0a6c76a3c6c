"""Bodies made to order: pressed, they do what was prescribed; infeasible wishes are refused with the reason."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
from scipy.special import j0

import winkler as wk
from winkler.materials.graded import PowerLawGraded
from winkler.materials.layered import Layer
from winkler.media import body_of
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.problems.normal.design import design_for_pressure, design_profile

GLASS = wk.HalfSpace.between(wk.Elastic(70e9, 0.2))
GRADED = {k: GradedHalfSpace(PowerLawGraded(70e9, 1e-4, k, 0.2)) for k in (-0.3, 0.4)}
MEDIA = {"homogeneous": GLASS, "hard skin": GRADED[-0.3], "soft skin": GRADED[0.4]}
DEPTH = np.linspace(0.0, 2e-6, 101)[1:]


def layer(young: float, poisson: float = 0.3, thickness: float = 1.0) -> Layer:
    return Layer(wk.Elastic(young, poisson), thickness)


LAYERED = {
    "hard": CoatedHalfSpace([layer(10.0)], on=wk.Elastic(1.0, 0.3)),
    "soft": CoatedHalfSpace([layer(0.1)], on=wk.Elastic(1.0, 0.3)),
    "film": CoatedHalfSpace([layer(1.0, 0.5)], on=wk.Rigid()),
    "three": CoatedHalfSpace(
        [layer(5.0, 0.2), layer(0.5, 0.4, 0.3), layer(2.0, 0.3, 2.0)],
        on=wk.Elastic(1.0, 0.3),
        second=wk.Elastic(8.0, 0.3),
    ),
}
"""Thickness and moduli of order one: contact radii are given in thicknesses."""


@pytest.mark.parametrize("name", MEDIA)
@pytest.mark.parametrize("profile", [wk.Paraboloid(1e-3), wk.Cone(1.5)])
def test_the_body_that_made_the_curve_comes_back(name, profile):
    medium = MEDIA[name]
    curve = wk.Indentation(wk.Foundation(profile, medium), wk.Depth(DEPTH)).solve()
    body = design_profile(DEPTH, curve.force, medium)
    r = body.reach * np.linspace(0.0, 1.0, 21)
    np.testing.assert_allclose(body.height(r), profile.height(r), rtol=1e-9, atol=1e-9 * body.height(r[-1:])[0])


def test_hertz():
    force = 4.0 / 3.0 * GLASS.modulus * np.sqrt(1e-3) * DEPTH**1.5
    body = design_profile(DEPTH, force, GLASS)
    r = body.reach * np.linspace(0.01, 1.0, 21)
    np.testing.assert_allclose(body.height(r), r**2 / 2e-3, rtol=1e-6)
    assert body.reach == pytest.approx(np.sqrt(1e-3 * DEPTH[-1]), rel=1e-9)


WISHES = {
    "mixed powers": lambda t: t**1.5 + t**2 + 0.3 * t**4,
    "stiffening": lambda t: np.expm1(2.0 * t) * t**0.5,
    "flat end": lambda t: t + 0.4 * t**2,
}


@pytest.mark.few(1)
@pytest.mark.parametrize("wish", WISHES)
def test_pressed_again(wish):
    """The designed body, pressed anew, follows the wish within the tolerance it states (some ten of it at a point)."""
    force = 10.0 * WISHES[wish](DEPTH / DEPTH[-1])
    body = design_profile(DEPTH, force, GLASS)
    assert body.tolerance < 1e-5
    solution = wk.Indentation(wk.Foundation(body, GLASS), wk.Depth(DEPTH[3:-1:8])).solve()
    assert np.max(np.abs(solution.force - force[3:-1:8])) < max(20.0 * body.tolerance, 1e-8) * force[-1]
    assert any("designed body differs" in note.statement for note in solution.validity)


@pytest.mark.slow
def test_pressed_again_in_a_graded_medium():
    medium = GRADED[0.4]
    force = 10.0 * WISHES["mixed powers"](DEPTH / DEPTH[-1])
    body = design_profile(DEPTH, force, medium)
    solution = wk.Indentation(wk.Foundation(body, medium), wk.Depth(DEPTH[3:-1:16])).solve()
    assert np.max(np.abs(solution.force - force[3:-1:16])) < max(20.0 * body.tolerance, 1e-8) * force[-1]


@pytest.mark.few(0)
@pytest.mark.parametrize(
    ("name", "profile"),
    [
        ("hard", wk.Cone(1.4)),
        pytest.param("hard", wk.Paraboloid(3.0), marks=pytest.mark.slow),
        ("soft", wk.Paraboloid(3.0)),
        ("film", wk.Cone(1.4)),
    ],
)
def test_the_body_that_made_the_curve_comes_back_from_layers(name, profile):
    """The curve comes from the direct solution of a contact as wide as the layer is thick."""
    medium = LAYERED[name]
    bed = wk.Foundation(profile, medium)
    d = np.linspace(0.05, 1.0, 150) ** 2 * wk.Indentation(bed, wk.Radius(1.0)).solve().depth
    body = design_profile(d, wk.Indentation(bed, wk.Depth(d)).solve().force, medium)
    r = body.reach * np.linspace(0.0, 1.0, 21)
    assert body.reach == pytest.approx(1.0, rel=1e-5)
    # through 150 points: a misfit of some 1e-9, differentiated, over a stiffness that may hardly grow with the radius
    np.testing.assert_allclose(body.height(r), profile.height(r), atol=3e-6 * profile.height(r[-1:])[0])


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("name", "wish"), [("hard", "mixed powers"), ("film", "stiffening"), ("soft", "flat end")])
def test_pressed_again_into_layers(name, wish):
    """To 1e-8 of the greatest force."""
    medium = LAYERED[name]
    d = np.linspace(0.001, 0.1, 100)
    shape, e = WISHES[wish], 1e-6
    rise = (shape(np.array(1.0)) - shape(np.array(1.0 - e))) / e / d[-1]
    force = shape(d / d[-1]) * float(medium.punch_stiffness(np.array(1.0))) / rise
    body = design_profile(d, force, medium)
    solution = wk.Indentation(wk.Foundation(body, medium), wk.Depth(d[3:-1:16])).solve()
    assert np.max(np.abs(solution.force - force[3:-1:16])) < 1e-8 * force[-1]


EVERY = {**{name: (medium, 2e-5) for name, medium in MEDIA.items()}, **{n: (m, 0.8) for n, m in LAYERED.items()}}


@pytest.mark.few(2)
@pytest.mark.parametrize("name", EVERY)
@pytest.mark.parametrize("share", [1.0, 1.7])
def test_the_surface_takes_the_shape_of_what_displaces_the_springs(name, share):
    """The inverse of g, whatever the radius up to which the springs are displaced."""
    medium, a = EVERY[name]
    profile = wk.Paraboloid(4.0 * a) + wk.Cone(1.5)
    imprint = body_of.Imprint(wk.Foundation(profile, medium), share * a)
    r = a * np.array([0.0, 1e-3, 0.2, 0.7, 1.0])
    scale = float(profile.height(r[-1:])[0])
    np.testing.assert_allclose(body_of.height(medium, imprint, r), profile.height(r), atol=1e-11 * scale)
    np.testing.assert_allclose(body_of.slope(medium, imprint, r), profile.slope(r), rtol=1e-7)


def test_a_noisy_curve():
    """Scatter of a thousandth: the misfit is stated, the body right within what a slope of such data can resolve."""
    force = 4.0 / 3.0 * GLASS.modulus * np.sqrt(1e-3) * DEPTH**1.5
    noisy = force + 1e-3 * force[-1] * np.random.default_rng(4).standard_normal(DEPTH.size)
    body = design_profile(DEPTH, noisy, GLASS)
    assert body.tolerance == pytest.approx(1e-3, rel=0.3)
    r = body.reach * np.linspace(0.3, 1.0, 8)
    np.testing.assert_allclose(body.height(r), r**2 / 2e-3, rtol=0.03)
    assert any("approximate" in str(note) for note in body.notes)


def _excess(xi: np.ndarray, contrast: float) -> np.ndarray:
    """M of one layer of unit thickness, nu = 0.3 in both, in closed form (theory 8.2)."""
    g, e = 3.0 - 4.0 * 0.3, np.exp(-2.0 * xi)
    one, other = (contrast * g - g) / (1.0 + contrast * g), (contrast - 1.0) / (contrast + g)
    top = 1.0 + 4.0 * other * xi * e - one * other * e * e
    return top / (1.0 - (one + other + 4.0 * other * xi * xi) * e + one * other * e * e) - 1.0


@pytest.mark.few(1)
@pytest.mark.parametrize(("name", "contrast"), [("hard", 10.0), ("soft", 0.1)])
def test_pressure_on_a_layer(name, contrast):
    """Hertz's pressure: the paraboloid's part in closed form, the layer's by its Hankel transform."""
    medium, a, p0 = LAYERED[name], 0.6, 0.02
    r = a * np.linspace(0.0, 1.0, 61)
    p = p0 * np.sqrt(np.maximum(1.0 - (r / a) ** 2, 0.0))
    body = design_for_pressure(r, p, medium)
    edges = np.concatenate([[0.0], np.geomspace(1e-6, 30.0, 600)])
    nodes, weights = np.polynomial.legendre.leggauss(8)
    low, width = edges[:-1, None], np.diff(edges)[:, None]
    xi, weight = (low + 0.5 * width * (nodes + 1.0)).ravel(), (0.5 * width * weights).ravel()
    spread = p0 * a**2 * (np.sin(xi * a) - xi * a * np.cos(xi * a)) / (xi * a) ** 3
    places = a * np.array([0.3, 0.7, 0.95])
    own = np.pi * p0 / (4.0 * medium.modulus * a) * places**2
    kernel = weight * 2.0 / medium.modulus * _excess(xi, contrast) * spread
    exact = own + [float(np.sum(kernel * (1.0 - j0(xi * place)))) for place in places]
    np.testing.assert_allclose(body.height(places), exact, rtol=1e-8)
    contact = wk.Indentation(wk.Foundation(body, medium), wk.Radius(a)).solve()
    np.testing.assert_allclose(wk.restore(contact, places).pressure, p0 * np.sqrt(1.0 - (places / a) ** 2), rtol=1e-7)
    assert contact.force == pytest.approx(2.0 / 3.0 * np.pi * a**2 * p0, rel=1e-8)


@pytest.mark.slow
def test_a_soft_edge_on_three_layers():
    medium, a = LAYERED["three"], 0.3
    r = a * np.linspace(0.0, 1.0, 61)
    body = design_for_pressure(r, 0.01 * (1.0 - (r / a) ** 2) ** 1.5, medium)
    contact = wk.Indentation(wk.Foundation(body, medium), wk.Radius(a)).solve()
    places = a * np.array([0.05, 0.5, 0.9])
    np.testing.assert_allclose(wk.restore(contact, places).pressure, 0.01 * (1.0 - (places / a) ** 2) ** 1.5, atol=1e-8)


@pytest.mark.slow
def test_uniform_pressure_pressed_again():
    """Until a' < a: T4 of the springs of a uniform pressure, p = (2 p0/pi) arcsin sqrt((a'^2 - r^2) / (a^2 - r^2))."""
    a, part = 1e-4, 0.999
    r = a * np.linspace(0.0, 1.0, 41)
    body = design_for_pressure(r, np.full(r.shape, 1e8), GLASS)
    contact = wk.Indentation(wk.Foundation(body, GLASS), wk.Radius(part * a)).solve()
    places = np.array([0.05, 0.5, 0.9])
    exact = 2e8 / np.pi * np.arcsin(np.sqrt((part**2 - places**2) / (1.0 - places**2)))
    np.testing.assert_allclose(wk.restore(contact, a * places).pressure, exact, rtol=1e-6)


@pytest.mark.parametrize("name", MEDIA)
def test_hertz_pressure(name):
    """p0 (1 - r^2/a^2)^((1+k)/2) belongs to a paraboloid; theory 8.1 gives its curvature."""
    medium = MEDIA[name]
    k = getattr(medium, "exponent", 0.0)
    a, radius = 1e-4, 2e-3
    r = a * np.linspace(0.0, 1.0, 101)
    scale = medium.modulus / getattr(medium, "depth_scale", 1.0) ** k
    p = 2.0 * scale / (np.pi * radius * (1.0 + k) ** 2) * (a * a - r * r) ** (0.5 * (1.0 + k))
    body = design_for_pressure(r, p, medium)
    np.testing.assert_allclose(body.height(r[1:]), r[1:] ** 2 / (2.0 * radius), rtol=1e-6)
    contact = wk.Indentation(wk.Foundation(body, medium), wk.Radius(0.999 * a)).solve()
    places = a * np.array([0.05, 0.5, 0.9])
    exact = 2.0 * scale / (np.pi * radius * (1.0 + k) ** 2) * ((0.999 * a) ** 2 - places**2) ** (0.5 * (1.0 + k))
    np.testing.assert_allclose(wk.restore(contact, places).pressure, exact, rtol=1e-5)


def test_uniform_pressure():
    """f(r) = (4 p a / (pi E*)) (pi/2 - E(r^2/a^2)): the classical complete elliptic integral."""
    a, p = 1e-4, 1e8
    r = a * np.linspace(0.0, 1.0, 41)
    body = design_for_pressure(r, np.full(r.shape, p), GLASS)
    exact = [4.0 * p * a / (np.pi * GLASS.modulus) * float(mp.pi / 2 - mp.ellipe((x / a) ** 2)) for x in r]
    np.testing.assert_allclose(body.height(r), exact, rtol=1e-7, atol=1e-8 * exact[-1])


@pytest.mark.slow
def test_between():
    """A pressure that is neither: r^2-growing, ending in a step, checked by a second quadrature of the half-space."""
    a = 1e-4
    r = a * np.linspace(0.0, 1.0, 81)
    p = 1e8 * (1.0 - 0.5 * (r / a) ** 2)
    body = design_for_pressure(r, p, GLASS)

    def sinking(x):
        """u(x) E* = 2 Int r p / sqrt(r^2 - x^2), in closed form for this pressure."""
        s = mp.sqrt(a * a - x * x)
        return 2e8 * (s - (s**3 / 3 + x * x * s) / (2 * a * a))

    def surface(place):
        return (2 / mp.pi) * mp.quad(lambda t: sinking(place * mp.sin(t)), [0, mp.pi / 2]) / GLASS.modulus

    exact = float(surface(mp.mpf(0)) - surface(mp.mpf(0.7 * a)))
    assert body.height(np.array([0.7 * a]))[0] == pytest.approx(exact, rel=1e-6)


@pytest.mark.parametrize(
    ("force", "what"),
    [
        (np.sqrt(DEPTH), "not convex"),
        (DEPTH**1.5 - DEPTH * DEPTH[-1] ** 0.5, "not compressive"),
        (DEPTH[1:], "equal length"),
        (np.where(DEPTH > 1e-6, np.nan, DEPTH), "finite"),
    ],
)
def test_infeasible_curves(force, what):
    with pytest.raises(wk.InvalidInput, match=what):
        design_profile(DEPTH, force, GLASS)


def test_the_first_offending_depth_is_named():
    force = DEPTH**1.5
    force[40:] += force[60:61] * np.where(DEPTH[40:] > DEPTH[50], -0.1, 0.0)
    with pytest.raises(wk.InvalidInput, match=f"not convex between the depths {DEPTH[49]:.6g} m"):
        design_profile(DEPTH, force, GLASS)
    force = DEPTH**1.5
    force[[30, 60]] = -1e-12
    with pytest.raises(wk.InvalidInput, match=f"at the depth {DEPTH[30]:.6g} m is not compressive"):
        design_profile(DEPTH, force, GLASS)


def test_a_wall_is_refused():
    with pytest.raises(wk.OutsideValidity, match="vertical wall"):
        design_profile(DEPTH, DEPTH * 1e6, GLASS)


def test_infeasible_pressures():
    r = 1e-4 * np.linspace(0.0, 1.0, 21)
    with pytest.raises(wk.InvalidInput, match="no body can pull"):
        design_for_pressure(r, 1.0 - 2e4 * r, GLASS)
    with pytest.raises(wk.InvalidInput, match="from r = 0"):
        design_for_pressure(r[1:], np.ones(20), GLASS)
    with pytest.raises(wk.InvalidInput, match="at r = 7e-05 m"):
        design_for_pressure(r, np.where(r > 6.6e-5, -1.0, 1.0), GLASS)
    with pytest.raises(wk.OutsideValidity, match="deeper outside"):
        design_for_pressure(r, (r / r[-1]) ** 8, GLASS)
    with pytest.raises(wk.OutsideValidity, match="ends at zero"):
        design_for_pressure(1e4 * r, np.ones(21), LAYERED["hard"])
    with pytest.raises(wk.InvalidInput, match="zero everywhere"):
        design_for_pressure(r, 0.0 * r, GLASS)


@pytest.mark.slow
def test_what_cannot_be_read_backwards():
    with pytest.raises(wk.OutsideValidity, match="inverse transform"):
        design_profile(DEPTH, DEPTH**1.5, wk.MeasuredBed(DEPTH[:9], DEPTH[:9], DEPTH[:9]).medium)
    with pytest.raises(wk.OutsideValidity, match="times as wide as the layers"):
        design_profile(DEPTH, 1e12 * DEPTH**1.5, LAYERED["hard"])


def test_gibson():
    """Every point sinks for itself, p = (2 E0 / 3 c0) u: a paraboloid's force is pi a^2 times half the deepest."""
    soil = PowerLawGraded(young=30e6, depth_scale=1.0, exponent=1.0, poisson=0.5)
    medium = GradedHalfSpace(soil)
    radius, bed = 0.5, 2.0 / 3.0 * 30e6
    body = design_profile(DEPTH, np.pi * radius * bed * DEPTH**2, medium)
    r = body.reach * np.linspace(0.1, 1.0, 5)
    np.testing.assert_allclose(body.height(r), r**2 / (2.0 * radius), rtol=1e-8)
    with pytest.raises(wk.OutsideValidity, match="Gibson"):
        design_for_pressure(r, r, medium)


def test_lists_will_do():
    d = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    body = design_profile([1e-6 * x for x in d], [1e-3 * x**1.5 for x in d], GLASS)
    assert body == design_profile(1e-6 * np.array(d), 1e-3 * np.array(d) ** 1.5, GLASS)
    with pytest.raises(wk.InvalidInput, match="not numbers"):
        design_profile(["deep"] * 6, d, GLASS)
