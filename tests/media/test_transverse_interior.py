"""Stresses inside transversely isotropic half-spaces: Navier's equations solved wave by wave, and isotropic limits."""

import numpy as np
import pytest
from scipy.special import j0, j1

import winkler as wk

ZINC = wk.TransverselyIsotropic(165e9, 31.1e9, 50e9, 61.8e9, 39.6e9)  # its exponents are a complex pair
COBALT = wk.TransverselyIsotropic(307e9, 165e9, 103e9, 358e9, 75.5e9)  # real ones
FIBRES = wk.TransverselyIsotropic(12e9, 5e9, 5e9, 140e9, 5e9)  # far apart
LEANING = wk.TransverselyIsotropic(10.0, 2.0, 4.0, 10.0, 40.0)  # a strongly complex pair
SOLIDS = {"zinc": ZINC, "cobalt": COBALT, "fibres": FIBRES, "leaning": LEANING}


def isotropic(young, poisson, off=0.0):
    lame, shear = young * poisson / ((1 + poisson) * (1 - 2 * poisson)), 0.5 * young / (1 + poisson)
    return wk.TransverselyIsotropic(lame + 2 * shear, lame, lame, lame + 2 * shear, shear * (1.0 + off))


def pressed(first, second=None, profile=None):
    medium = wk.TransverselyIsotropicHalfSpace(first, second or wk.Rigid())
    force = 2e-3 * medium.modulus
    return wk.Indentation(wk.Foundation(profile or wk.Paraboloid(1.0), medium), wk.Force(force)).solve()


def stroh(solid, r, z, a, p0):
    """Hertz' pressure as waves: each a numerical eigenvector of Navier's equations, summed by quadrature."""
    c11, c12, c13, c33, c44 = solid.c11, solid.c12, solid.c13, solid.c33, solid.c44
    # u_r = U J1, u_z = W J0 and tractions tau = T J1, sigma_z = S J0, of wave number one
    rows = np.array(
        [
            [0, 1, 1 / c44, 0],
            [-c13 / c33, 0, 0, 1 / c33],
            [c11 - c13**2 / c33, 0, 0, c13 / c33],
            [0, 0, -1, 0],
        ]
    )
    scale = np.diag([1, 1, c44, c44])
    roots, shapes = np.linalg.eig(np.linalg.inv(scale) @ rows @ scale)
    shapes = scale @ shapes[:, roots.real < 0]
    roots = roots[roots.real < 0]
    amounts = np.linalg.solve(shapes[2:], [0.0, -1.0])
    end = 45.0 / (z * min(-roots.real))
    nodes, weights = np.polynomial.legendre.leggauss(20)
    edges = np.linspace(0.0, end, 2 + int(end * (a + r)))
    xi = (edges[:-1, None] + np.diff(edges)[:, None] * 0.5 * (nodes + 1)).ravel()
    weights = (np.diff(edges)[:, None] * 0.5 * weights).ravel()
    x = xi * a
    with np.errstate(invalid="ignore", divide="ignore"):
        load = np.where(x > 1e-2, p0 * a**2 * (np.sin(x) - x * np.cos(x)) / x**3, p0 * a**2 * (1 / 3 - x**2 / 30))
    u, w, t, s = np.real((shapes * amounts) @ np.exp(np.outer(roots, xi * z))) * load * weights
    zero, one = j0(xi * r), j1(xi * r)
    out, down = np.sum(u * one), np.sum(w * zero)
    strain = np.sum(u * xi * zero)  # du_r/dr + u_r/r
    around = out / r
    axial, shear = np.sum(s * xi * zero), np.sum(t * xi * one)
    stretch = (axial - c13 * strain) / c33
    radial = c11 * (strain - around) + c12 * around + c13 * stretch
    hoop = c12 * (strain - around) + c11 * around + c13 * stretch
    return radial, hoop, axial, shear, out, down


@pytest.mark.parametrize("name", SOLIDS)
def test_the_field_below_a_ball_is_the_sum_of_its_waves(name):
    solid = SOLIDS[name]
    contact = pressed(solid)
    a, p0 = contact.radius, contact.peak_pressure
    for r, z in ((1e-3, 0.05), (1e-3, 0.6), (0.3, 0.1), (0.7, 0.5), (0.9, 0.02), (1.0, 0.2), (1.6, 0.8), (2.5, 0.1)):
        found = np.array(
            contact.problem.bed.medium.interior(contact.pressed, np.array([r * a]), np.array([z * a]), below=True)
        )[:, 0]
        expected = np.array(stroh(solid, r * a, z * a, a, p0))
        assert found[:4] == pytest.approx(expected[:4], abs=1e-8 * p0)
        assert found[4:] == pytest.approx(expected[4:], abs=1e-8 * contact.depth)


PLACES = np.array([[0.0, 0.0, 0.3, 0.7, 0.98, 1.0, 1.05, 1.6, 4.0], [1e-3, 0.6, 0.1, 0.4, 1e-5, 0.2, 1e-4, 0.8, 2.0]])


def field(contact, r, z, below=True):
    return np.array(contact.problem.bed.medium.interior(contact.pressed, r, z, below=below))


@pytest.mark.parametrize(
    "profile", [wk.Paraboloid(1.0), wk.Cone(0.05), wk.FlatPunch(0.04)], ids=["ball", "cone", "punch"]
)
@pytest.mark.parametrize("off", [0.0, 1e-6, -1e-6], ids=["equal", "apart", "complex"])
def test_an_isotropic_solid_has_the_closed_forms_of_the_half_space(profile, off):
    """Equal exponents are parted a little: the field is even in their difference."""
    contact = pressed(isotropic(2.0, 0.3, off), profile=profile)
    springs, a = contact.pressed, contact.radius
    half_space = wk.HalfSpace(wk.Elastic(2.0, 0.3))
    r, z = PLACES * a
    expected = np.array(half_space.interior(springs, r, z, below=True))
    size = np.array([1.0] * 4 + [a] * 2) * contact.force / a**2
    close = 1e-6 if off else 1e-8
    error = np.abs(field(contact, r, z) - expected)
    assert np.all(np.max(error[:, np.isfinite(expected).all(axis=0)], axis=1) <= close * size)


@pytest.mark.parametrize("name", SOLIDS)
def test_it_is_in_equilibrium_and_obeys_hookes_law(name):
    solid, h = SOLIDS[name], 1e-3
    contact = pressed(solid)
    a, p0 = contact.radius, contact.peak_pressure
    r, z = np.array([0.2, 0.6, 0.9, 1.1, 1.7]) * a, np.array([0.3, 0.5, 0.2, 0.3, 0.6]) * a
    weights, steps = np.array([1.0, -8.0, 8.0, -1.0]) / 12.0, (-2, -1, 1, 2)
    along, deep = (
        sum(w * field(contact, r + s * h * a * dr, z + s * h * a * dz) for w, s in zip(weights, steps, strict=True))
        / (h * a)
        for dr, dz in ((1.0, 0.0), (0.0, 1.0))
    )
    radial, hoop, axial, shear, out, _ = field(contact, r, z)
    assert along[0] + deep[3] + (radial - hoop) / r == pytest.approx(0.0, abs=1e-7 * p0 / a)
    assert along[3] + deep[2] + shear / r == pytest.approx(0.0, abs=1e-7 * p0 / a)
    e_r, e_t, e_z, twice = along[4], out / r, deep[5], deep[4] + along[5]
    for found, expected in (
        (radial, solid.c11 * e_r + solid.c12 * e_t + solid.c13 * e_z),
        (hoop, solid.c12 * e_r + solid.c11 * e_t + solid.c13 * e_z),
        (axial, solid.c13 * (e_r + e_t) + solid.c33 * e_z),
        (shear, solid.c44 * twice),
    ):
        assert found == pytest.approx(expected, abs=1e-7 * p0)


@pytest.mark.parametrize("name", SOLIDS)
def test_on_the_surface_it_is_the_pressure_and_the_limit_from_below(name):
    """The counterpart is elastic: both surfaces together sink as the springs say."""
    contact = pressed(SOLIDS[name], wk.Elastic(2.0 * SOLIDS[name].c44, 0.25))
    a, p0 = contact.radius, contact.peak_pressure
    r = np.array([0.0, 0.3, 0.8, 1.2, 2.0]) * a
    on = field(contact, r, np.zeros(r.size))
    medium = contact.problem.bed.medium
    assert on[2] == pytest.approx(-medium.pressure(contact.pressed, r), abs=1e-9 * p0)
    sunk = on[5] + field(contact, r, np.zeros(r.size), below=False)[5]
    assert sunk == pytest.approx(medium.displacement(contact.pressed, r), abs=1e-9 * contact.depth)
    near = field(contact, r, np.full(r.size, 1e-7 * a))
    assert near[:4] == pytest.approx(on[:4], abs=1e-5 * p0)
    assert near[4:] == pytest.approx(on[4:], abs=1e-5 * contact.depth)


@pytest.mark.parametrize("name", ["zinc", "cobalt"])
def test_a_layer_of_the_same_solid_has_the_field_of_the_half_space(name):
    """Below the interface the layered field is a sum of waves alone; so it is with the counterpart turned around."""
    solid = SOLIDS[name]
    contact = pressed(solid)
    a, p0 = contact.radius, contact.peak_pressure
    stack = wk.StackedHalfSpace([wk.StackLayer(solid, 0.5 * a)], on=solid)
    layered = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), stack), wk.Force(contact.force)).solve()
    r, z = PLACES * a
    assert field(layered, r, z) == pytest.approx(field(contact, r, z), abs=1e-6 * max(p0, contact.depth))
    over = wk.StackedHalfSpace([wk.StackLayer(solid, 0.5 * a)], on=solid, second=solid)
    pair = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), over), wk.Force(contact.force)).solve()
    assert field(pair, r, z, below=False) == pytest.approx(field(pair, r, z), abs=1e-6 * p0)


def test_the_greatest_stresses_of_an_isotropic_solid_are_those_of_the_half_space():
    """The counterpart is isotropic, and searched as the second body of a half-space."""
    second, moduli = wk.Elastic(3.0, 0.2), ("von_mises", "max_shear", "orthogonal_shear")
    one = wk.ContactStress(pressed(isotropic(2.0, 0.3), second).problem).solve()
    half_space = wk.HalfSpace(wk.Elastic(2.0, 0.3), second)
    problem = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), half_space), one.problem.contact.load)
    two = wk.ContactStress(problem).solve()
    assert [part.name for part in one.parts] == ["first body", "second body"]
    for first, other in zip(one.parts, two.parts, strict=True):
        for kind in moduli:
            assert getattr(first, kind) == pytest.approx(getattr(other, kind), rel=1e-6), kind
            # a maximum is flat: its place is known to the square root of its value's digits
            assert getattr(first, f"{kind}_depth") == pytest.approx(getattr(other, f"{kind}_depth"), rel=1e-3), kind


@pytest.mark.parametrize("name", SOLIDS)
def test_the_greatest_stresses_are_those_of_the_waves_on_a_mesh(name):
    solid = SOLIDS[name]
    contact = pressed(solid)
    found = wk.ContactStress(contact.problem).solve()
    a, p0 = contact.radius, contact.peak_pressure
    best = np.zeros(2)
    for z in np.linspace(0.04, 1.6, 27):
        for r in np.linspace(1e-3, 1.3, 9):
            radial, hoop, axial, shear, *_ = stroh(solid, r * a, z * a, a, p0)
            mises = np.sqrt(0.5 * ((radial - hoop) ** 2 + (hoop - axial) ** 2 + (axial - radial) ** 2) + 3 * shear**2)
            best = np.maximum(best, [mises, abs(shear)])
    for value, greatest in zip(best, (found.von_mises, found.orthogonal_shear), strict=True):
        assert 0.97 * greatest <= value <= greatest * (1.0 + 1e-6)
