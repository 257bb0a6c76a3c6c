"""Stresses inside power laws: Froehlich's point load, Booker's stiffness, a grading in cells, and the limit k = 0."""

import math

import numpy as np
import pytest

import winkler as wk
from winkler.media.graded import power_law_interior

BALL = wk.Paraboloid(1.0)


def pressed(body, profile=BALL, second=None):
    medium = wk.GradedHalfSpace(body, second or wk.Rigid())
    return wk.Indentation(wk.Foundation(profile, medium), wk.Force(2e-3)).solve()


def young_at(body, z):
    return body.young * (z / body.depth_scale) ** body.exponent


def field(contact, r, z, below=True):
    return np.array(contact.problem.bed.medium.interior(contact.pressed, r, z, below=below))


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.5])
@pytest.mark.parametrize("exponent", [-0.9, -0.4, 0.15, 0.5, 0.9])
def test_a_wave_sinks_as_bookers_springs_say(exponent, poisson):
    """The surface sinks by W(0), from which the stiffness of the flat punch follows."""
    body = wk.PowerLawGraded(1.0, 1.0, exponent, poisson)
    ratio = 0.5 / (1.0 + poisson) / wk.GradedHalfSpace(body).modulus
    sinks = math.pi * 2.0 ** (1.0 - exponent) * ratio / math.gamma(0.5 * (1.0 + exponent)) ** 2
    found = power_law_interior._amplitudes(exponent, poisson)(0.0)
    assert found == pytest.approx([found[0], sinks, 0.0, -1.0], rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("exponent", [0.1, 0.5, 0.9])
@pytest.mark.parametrize("profile", [BALL, wk.Cone(0.05)], ids=["ball", "cone"])
def test_with_froehlichs_poissons_ratio_each_point_of_the_pressure_pushes_radially(exponent, profile):
    """nu = 1/(2 + k): sigma_R = (3 + k) P cos^(1 + k) / (2 pi R^2), the only stress of a point load."""
    contact = pressed(wk.PowerLawGraded(3.0, 0.2, exponent, 1.0 / (2.0 + exponent)), profile)
    medium, a = contact.problem.bed.medium, contact.radius
    nodes, weights = np.polynomial.legendre.leggauss(400)
    angle = 0.25 * np.pi * (nodes + 1.0)
    s, measure = a * np.sin(angle), 0.25 * np.pi * weights * a * np.cos(angle)
    load = medium.pressure(contact.pressed, s) * s * measure
    turn = (np.arange(256) + 0.5) * 2.0 * np.pi / 256
    for r, z in ((0.0, 0.1), (0.0, 0.7), (0.4, 0.2), (0.9, 0.3), (1.0, 0.5), (2.0, 0.4)):
        x, y = r * a - np.outer(s, np.cos(turn)), -np.outer(s, np.sin(turn))
        distance = np.sqrt(x**2 + y**2 + (z * a) ** 2)
        push = -(3.0 + exponent) / (2.0 * np.pi * distance**2) * (z * a / distance) ** (1.0 + exponent)
        push *= load[:, None] * 2.0 * np.pi / turn.size / distance**2
        expected = [np.sum(push * part) for part in (x * x, y * y, (z * a) ** 2, x * z * a)]
        found = field(contact, np.array([r * a]), np.array([z * a]))[:4, 0]
        assert found == pytest.approx(expected, abs=2e-7 * contact.force / a**2), (r, z)


@pytest.mark.parametrize("profile", [BALL, wk.Cone(0.05), wk.FlatPunch(0.04)], ids=["ball", "cone", "punch"])
def test_without_an_exponent_it_is_the_half_space(profile):
    contact = pressed(wk.PowerLawGraded(2.0, 0.7, 1e-12, 0.3), profile)
    a = contact.radius
    r, z = np.array([[0.0, 0.3, 0.7, 0.98, 1.0, 1.6, 4.0], [0.02, 0.1, 0.4, 0.03, 0.05, 0.8, 2.0]]) * a
    expected = np.array(wk.HalfSpace(wk.Elastic(2.0, 0.3)).interior(contact.pressed, r, z, below=True))
    size = np.array([1.0] * 4 + [a] * 2) * contact.force / a**2
    assert np.all(np.max(np.abs(field(contact, r, z) - expected), axis=1) <= 1e-6 * size)


@pytest.mark.parametrize(("exponent", "poisson"), [(-0.4, 0.3), (0.2, 0.1), (0.6, 0.45)])
def test_it_is_in_equilibrium_and_obeys_hookes_law(exponent, poisson):
    """In both bodies: the second is another one of the same exponent."""
    first, second = wk.PowerLawGraded(2.0, 0.3, exponent, poisson), wk.PowerLawGraded(1.0, 0.8, exponent, 0.2)
    contact = pressed(first, second=second)
    a, p0, h = contact.radius, contact.force / contact.radius**2, 1e-3
    r, z = np.array([0.2, 0.6, 0.9, 1.1, 1.7]) * a, np.array([0.3, 0.5, 0.2, 0.3, 0.6]) * a
    weights, steps = np.array([1.0, -8.0, 8.0, -1.0]) / 12.0, (-2, -1, 1, 2)
    for body, below in ((first, True), (second, False)):
        along, deep = (
            sum(
                w * field(contact, r + s * h * a * dr, z + s * h * a * dz, below)
                for w, s in zip(weights, steps, strict=True)
            )
            / (h * a)
            for dr, dz in ((1.0, 0.0), (0.0, 1.0))
        )
        radial, hoop, axial, shear, out, _ = field(contact, r, z, below)
        assert along[0] + deep[3] + (radial - hoop) / r == pytest.approx(0.0, abs=1e-5 * p0 / a)
        assert along[3] + deep[2] + shear / r == pytest.approx(0.0, abs=1e-5 * p0 / a)
        young = young_at(body, z)
        strains = [
            (one - body.poisson * rest) / young
            for one, rest in ((radial, hoop + axial), (hoop, radial + axial), (axial, radial + hoop))
        ]
        for found, expected in zip(strains, (along[4], out / r, deep[5]), strict=True):
            assert found * young == pytest.approx(expected * young, abs=1e-5 * p0)
        assert shear == pytest.approx(0.5 * young / (1.0 + body.poisson) * (deep[4] + along[5]), abs=1e-5 * p0)


@pytest.mark.slow
@pytest.mark.parametrize(("exponent", "poisson"), [(0.2, 0.3)])
def test_the_greatest_stresses_are_those_of_a_grading_in_cells(exponent, poisson):
    """The grading follows the power law from a thousandth of the radius to a thousand radii: layers know no power."""
    body = wk.PowerLawGraded(2.0, 0.05, exponent, poisson)
    contact = pressed(body)
    depths = contact.radius * np.geomspace(1e-3, 1e3, 601)
    youngs = young_at(body, depths)
    depths[0] = 0.0
    cells = wk.DepthGradedHalfSpace(wk.TabulatedGrading(depths, youngs, np.full(601, poisson)), tolerance=1e-4)
    own = wk.ContactStress(contact.problem).solve()
    other = wk.ContactStress(wk.Indentation(wk.Foundation(BALL, cells), wk.Force(2e-3))).solve()
    assert [part.name for part in own.parts] == ["first body"]
    for kind in ("von_mises", "max_shear", "orthogonal_shear"):
        assert getattr(own, kind) == pytest.approx(getattr(other, kind), rel=1e-3), kind
        assert getattr(own, f"{kind}_depth") == pytest.approx(getattr(other, f"{kind}_depth"), rel=2e-2), kind


@pytest.mark.parametrize("exponent", [0.2, 0.5, 0.8])
def test_the_greatest_stress_below_a_ball_is_that_of_froehlichs_point_loads(exponent):
    """On the axis, where it is: half the difference of the axial and the radial stress is the greatest shear."""
    contact = pressed(wk.PowerLawGraded(3.0, 0.2, exponent, 1.0 / (2.0 + exponent)))
    found, a = wk.ContactStress(contact.problem).solve(), contact.radius
    nodes, weights = np.polynomial.legendre.leggauss(400)
    angle = 0.25 * np.pi * (nodes + 1.0)
    s = a * np.sin(angle)
    load = contact.problem.bed.medium.pressure(contact.pressed, s) * s * 0.25 * np.pi * weights * a * np.cos(angle)
    z = a * np.linspace(0.3, 0.7, 401)[:, None]
    distance = np.hypot(s, z)
    push = (3.0 + exponent) * load / distance**4 * (z / distance) ** (1.0 + exponent)
    apart = np.sum(push * (z**2 - 0.5 * s**2), axis=1)
    assert found.von_mises == pytest.approx(np.max(apart), rel=1e-6)
    assert found.max_shear == pytest.approx(0.5 * np.max(apart), rel=1e-6)
    assert found.von_mises_depth == pytest.approx(z[np.argmax(apart), 0], abs=2e-3 * a)


def test_what_is_not_known_is_refused():
    contact = pressed(wk.PowerLawGraded(2.0, 0.3, 0.3, 0.3))
    a = contact.radius
    for r, z in ((0.0, 0.01), (21.0, 1.0)):
        with pytest.raises(wk.OutsideValidity, match=r"from 0\.02 contact radii below the surface"):
            wk.restore(contact, r * a, z * a)
    with pytest.raises(wk.OutsideValidity, match="exponents from -0"):
        wk.restore(pressed(wk.PowerLawGraded(2.0, 0.3, 0.95, 0.3)), 0.0, 0.01)
    with pytest.raises(wk.InvalidInput, match="infinite at the surface"):
        wk.ContactStress(pressed(wk.PowerLawGraded(2.0, 0.3, -0.2, 0.3)).problem)
    with pytest.raises(wk.OutsideValidity, match="the rim is sharp"):
        wk.ContactStress(pressed(wk.PowerLawGraded(2.0, 0.3, 0.2, 0.3), wk.FlatPunch(0.04)).problem).solve()
    with pytest.raises(wk.OutsideValidity, match="lies less than"):
        wk.ContactStress(pressed(wk.PowerLawGraded(2.0, 0.3, 0.5, 0.0)).problem).solve()
    medium = contact.problem.bed.medium
    ellipse = wk.EllipticIndentation(wk.CurvedBodies(1e-3, 2e-3), medium, wk.Force(1.0))
    with pytest.raises(wk.InvalidInput, match="under round contacts only"):
        wk.ContactStress(ellipse)
