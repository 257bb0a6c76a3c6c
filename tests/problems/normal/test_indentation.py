"""Indentation against the closed forms of theory 1.1: depth, force, radius, stiffness, energy, by all three loads."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from closed_forms import CASES

import winkler as wk

STEEL = wk.Elastic(young=210e9, poisson=0.3)
PAIR = wk.HalfSpace.between(STEEL, wk.Elastic(young=70e9, poisson=0.33))
MODULUS = 1.0 / ((1.0 - 0.09) / 210e9 + (1.0 - 0.33**2) / 70e9)


def numbers(case):
    radii = [mp.mpf(a) for a in case.radii]
    depth = np.array([float(case.depth(a)) for a in radii])
    force = MODULUS * np.array([float(case.force(a)) for a in radii])
    return depth, force


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("load", ["radius", "depth", "force"])
def test_closed_forms(name, load):
    """To 1e-10, as an array of loads, as a column, and one at a time."""
    case = CASES[name]
    bed = wk.Foundation(case.profile, PAIR)
    depth, force = numbers(case)
    given = {"radius": wk.Radius(case.radii), "depth": wk.Depth(depth), "force": wk.Force(force)}[load]
    contact = wk.Indentation(bed, given).solve()
    # just above a flat, or where g hardly rises, the radius itself is not better known than its square root
    np.testing.assert_allclose(contact.radius, case.radii, rtol=1e-10)
    np.testing.assert_allclose(contact.stiffness, 2.0 * MODULUS * case.radii, rtol=1e-10)
    if load != "radius" or "truncated" not in name:
        np.testing.assert_allclose(contact.depth, depth, rtol=1e-10)
        np.testing.assert_allclose(contact.force, force, rtol=1e-10)
    column = wk.Indentation(bed, type(given)(getattr(given, load)[:, None])).solve()
    assert column.depth.shape == column.force.shape == column.radius.shape == (len(depth), 1)
    assert column.stiffness.shape == column.mean_pressure.shape == (len(depth), 1)
    np.testing.assert_allclose(column.force[:, 0], contact.force, rtol=1e-14)
    for i in (0, -1):
        single = wk.Indentation(bed, type(given)(float(getattr(given, load)[i]))).solve()
        for word in ("depth", "force", "radius", "stiffness", "mean_pressure"):
            assert isinstance(getattr(single, word), float), word
            assert getattr(single, word) == pytest.approx(getattr(contact, word)[i], rel=1e-13)


@pytest.mark.parametrize("name", CASES)
def test_energy_is_the_work_done(name):
    """U = Int F dd = Int F(a) d'(a) da, by quadrature of the closed forms."""
    case = CASES[name]
    a = mp.mpf(case.radii[-1])
    # U = F d - Int_0^d d dF ... = E* Int_0^a (d - g)^2 dx: integrate the closed form of F over the closed form of d
    flat = mp.mpf(max([0.0, *[b for b, _ in case.profile.kinks if case.depth(mp.mpf(b)) == 0]]))
    edges = [flat, *[mp.mpf(b) for b, _ in case.profile.kinks if flat < b < a], a]
    top = case.depth(a)
    work = mp.mpf(0)
    for low, high in zip(edges[:-1], edges[1:], strict=True):
        # substitution x = low + s^2 takes the square root from the start of a piece
        work += mp.quad(lambda s, low=low: 2 * s * (top - case.depth(low + s**2)) ** 2, [0, mp.sqrt(high - low)])
    work += flat * top**2
    contact = wk.Indentation(wk.Foundation(case.profile, PAIR), wk.Radius(case.radii[-1])).solve()
    assert contact.energy == pytest.approx(MODULUS * float(work), rel=1e-10)
    # and really the area under F(d)
    with mp.workdps(20):
        under = mp.mpf(0)
        for low, high in zip(edges[:-1], edges[1:], strict=True):
            under += mp.quad(
                lambda s, low=low: (
                    2 * s * (case.force(a) - case.force(low + s**2)) * mp.diff(case.depth, low + s**2)
                    if s > 0
                    else mp.mpf(0)
                ),
                [mp.mpf(10) ** -9, mp.sqrt(high - low)],
            )
    expected = MODULUS * float(case.force(a) * top - under)
    assert contact.energy == pytest.approx(expected, rel=1e-5)


def test_hertz_energy():
    """U = (2/5) F d."""
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(1e-2), PAIR), wk.Force(np.array([1.0, 50.0]))).solve()
    np.testing.assert_allclose(contact.energy, 0.4 * contact.force * contact.depth, rtol=1e-13)


@pytest.mark.parametrize("load", [wk.Force(0.0), wk.Depth(0.0), wk.Radius(0.0), wk.Depth(-1e-6)])
@pytest.mark.parametrize("profile", [wk.Paraboloid(1.0), wk.Cone(1.0), wk.TruncatedCone(1.0, 1e-3), wk.FlatPunch(1e-3)])
def test_nothing_touches(profile, load):
    contact = wk.Indentation(wk.Foundation(profile, PAIR), load).solve()
    assert contact.force == contact.radius == contact.stiffness == contact.energy == contact.mean_pressure == 0.0
    assert contact.depth == (load.depth if isinstance(load, wk.Depth) else 0.0)
    assert not np.any(contact.line_load(np.array([0.0, 1e-3])))
    assert any("do not touch" in note.statement for note in contact.validity)


def test_contact_and_none_in_one_array():
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), PAIR), wk.Depth(np.array([-1.0, 0.0, 1e-6]))).solve()
    np.testing.assert_array_equal(contact.force[:2], 0.0)
    np.testing.assert_array_equal(contact.radius[:2], 0.0)
    assert contact.radius[2] == pytest.approx(1e-3)
    np.testing.assert_array_equal(contact.energy[:2], 0.0)


@pytest.mark.parametrize("force", [1e-300, 1e-30, 1e-12, 1e12, 1e59])
def test_forces_of_any_size(force):
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(1e-2), PAIR), wk.Force(force)).solve()
    assert contact.radius == pytest.approx((0.75 * force * 1e-2 / MODULUS) ** (1.0 / 3.0), rel=1e-14)
    assert contact.depth == pytest.approx(contact.radius**2 / 1e-2, rel=1e-14)


def test_a_sphere_pressed_beyond_reason():
    """As a -> R the force goes on as F = 2 E* R d - E* R^2; doubles end, the solution does not."""
    bed = wk.Foundation(wk.Sphere(1.0), wk.HalfSpace.between(wk.Elastic(1.0, 0.0)))
    for depth in (3.0, 18.0, 40.0, 700.0):
        contact = wk.Indentation(bed, wk.Depth(depth)).solve()
        exact = mp.findroot(lambda u, d=depth: u * mp.tanh(u) - mp.mpf(d), mp.mpf(depth))
        a = mp.tanh(exact)
        force = (1 + a**2) * exact - a
        assert contact.force == pytest.approx(float(force), rel=1e-12)
        assert wk.Indentation(bed, wk.Force(float(force))).solve().depth == pytest.approx(depth, rel=1e-12)
        assert "outside" in {note.standing.value for note in contact.validity}


# --------------------------------------------------------------------------------------------------- line load, choice


def test_line_load():
    """q = E* (d - g) inside, zero outside, even, and its integral is the force."""
    contact = wk.Indentation(wk.Foundation(wk.Cone(1.2), PAIR), wk.Radius(2e-6)).solve()
    x = np.array([-3e-6, -2e-6, -1e-6, 0.0, 1e-6, 1.9e-6, 2.1e-6])
    peak = MODULUS * contact.depth
    expected = peak * np.maximum(1.0 - np.abs(x) / 2e-6, 0.0)
    np.testing.assert_allclose(contact.line_load(x), expected, rtol=1e-12, atol=1e-12 * peak)
    nodes, weights = np.polynomial.legendre.leggauss(20)
    assert weights @ contact.line_load(1e-6 * (nodes + 1.0)) * 2e-6 == pytest.approx(contact.force, rel=1e-12)


def test_line_load_of_a_pinned_contact_jumps_at_the_rim():
    contact = wk.Indentation(wk.Foundation(wk.FlatPunch(1e-3), PAIR), wk.Depth(1e-6)).solve()
    np.testing.assert_allclose(contact.line_load(np.array([0.0, 1e-3])), MODULUS * 1e-6, rtol=1e-14)
    assert contact.line_load(np.array([1.001e-3]))[0] == 0.0


def test_one_load_of_many():
    bed = wk.Foundation(wk.Paraboloid(1.0), PAIR)
    loads = np.array([[1.0, 2.0], [3.0, 4.0]])
    many = wk.Indentation(bed, wk.Force(loads)).solve()
    one = many.at((1, 0))
    assert one.force == 3.0
    assert one.problem.load == wk.Force(3.0)
    assert one.line_load(np.zeros(1))[0] == pytest.approx(MODULUS * one.depth)
    for index in (7, (0, 5), (0, 0, 0), "first", 0):
        with pytest.raises(wk.InvalidInput, match=r"there is no load .* in a solution of shape \(2, 2\)"):
            many.at(index)
    for request in (lambda: many.line_load(np.zeros(1)), lambda: wk.restore(many, [0.0]), lambda: many.pressed):
        with pytest.raises(wk.InvalidInput, match=r"holds 4 loads; pick one with solution.at\(index\)"):
            request()
    by_depth = wk.Indentation(bed, wk.Depth(np.array([1e-6, 2e-6]))).solve().at(-1)
    assert by_depth.problem.load == wk.Depth(2e-6)
    assert wk.Indentation(bed, wk.Radius(np.array([1e-3]))).solve().at(0).problem.load == wk.Radius(1e-3)


# ------------------------------------------------------------------------------------------------------------ refusals


def refused(bed, load, match):
    with pytest.raises(wk.OutsideValidity, match=match) as caught:
        wk.Indentation(bed, load).solve()
    assert str(caught.value).count("\n") == 0
    assert str(caught.value).endswith(".")


def test_tension_is_refused():
    bed = wk.Foundation(wk.Paraboloid(1.0), PAIR)
    refused(bed, wk.Force(-1e-9), r"^force -1e-09 N is tensile; without adhesion bodies can only be pressed together")
    refused(bed, wk.Force(np.array([1.0, -2.0, 3.0, -4.0])), r"force -2 N at index 1, 3 is tensile")
    many = np.full(20, -1.0)
    refused(bed, wk.Force(many), "at index 0, 1, 2, 3, 4 and more is tensile")


def test_beyond_the_reach_is_refused_and_named():
    r = np.linspace(0.0, 1e-4, 30)
    bed = wk.Foundation(wk.Measured(r, r**2 / 2e-2), PAIR)
    depth = 1e-4**2 / 1e-2
    refused(bed, wk.Depth(1.1 * depth), r"depth 1.1e-06 m leads beyond the reach of the profile \(0.0001 m\)")
    refused(bed, wk.Depth(np.array([0.5, 2.0, 3.0]) * depth), "depth 2e-06 m at index 1, 2 leads beyond the reach")
    force = 4.0 / 3.0 * MODULUS * 1e-12 / 1e-2
    refused(bed, wk.Force(np.array([0.5, 1.5]) * force), r"at index 1 leads beyond the reach .* give at most [\d.]+ N")
    refused(bed, wk.Radius(np.array([1e-5, 1.2e-4])), r"radius 0.00012 m at index 1 is beyond the reach of the profile")
    assert wk.Indentation(bed, wk.Radius(1e-4)).solve().depth == pytest.approx(depth, rel=1e-9)


def test_a_radius_that_does_not_determine_the_load():
    for profile in (wk.FlatPunch(1e-3), wk.TruncatedCone(1.0, 1e-3), wk.RoundedPunch(1e-3, 1.0)):
        for radius in (1e-3, 5e-4):
            refused(
                wk.Foundation(profile, PAIR),
                wk.Radius(radius),
                "does not determine the load: the body is flat up to 0.001",
            )
    refused(wk.Foundation(wk.FlatPunch(1e-3), PAIR), wk.Radius(2e-3), r"is beyond the rim of the body \(0.001 m\)")


@pytest.mark.parametrize("bad", [1.0, None, "10 N", wk.Paraboloid(1.0)])
def test_what_is_no_load(bad):
    with pytest.raises(wk.InvalidInput, match=r"the load is a \w+; give Force, Depth or Radius\."):
        wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), PAIR), bad).solve()


# -------------------------------------------------------------------------------------------------------------- pinned


def test_flat_punch():
    """F = 2 E* b d whatever is prescribed."""
    b = 3e-4
    bed = wk.Foundation(wk.FlatPunch(b), PAIR)
    forces = np.array([1e-9, 1.0, 1e6])
    contact = wk.Indentation(bed, wk.Force(forces)).solve()
    np.testing.assert_allclose(contact.depth, forces / (2.0 * MODULUS * b), rtol=1e-14)
    np.testing.assert_array_equal(contact.radius, b)
    np.testing.assert_allclose(contact.stiffness, 2.0 * MODULUS * b, rtol=1e-14)
    np.testing.assert_allclose(contact.energy, 0.5 * forces * contact.depth, rtol=1e-14)
    assert wk.Indentation(bed, wk.Depth(contact.depth)).solve().force == pytest.approx(forces)


@pytest.mark.parametrize(
    "cap", [wk.Paraboloid(1e-2), wk.Cone(1.4), wk.Sphere(1e-2), wk.TruncatedParaboloid(1e-2, 2e-4)]
)
def test_capped_cylinder_within_and_beyond_its_rim(cap):
    b = 1e-3
    bed, free = wk.Foundation(wk.CappedCylinder(b, cap), PAIR), wk.Foundation(cap, PAIR)
    full = wk.Indentation(free, wk.Radius(b)).solve()
    within = wk.Indentation(bed, wk.Depth(0.5 * full.depth)).solve()
    assert within.force == pytest.approx(wk.Indentation(free, wk.Depth(0.5 * full.depth)).solve().force, rel=1e-13)
    beyond = wk.Indentation(bed, wk.Depth(np.array([1.0, 1.5, 10.0]) * full.depth)).solve()
    expected = full.force + 2.0 * MODULUS * b * (beyond.depth - full.depth)
    np.testing.assert_allclose(beyond.force, expected, rtol=1e-13)
    np.testing.assert_allclose(beyond.radius, b, rtol=1e-15)
    assert beyond.radius[1] == beyond.radius[2] == b
    again = wk.Indentation(bed, wk.Force(beyond.force)).solve()
    np.testing.assert_allclose(again.depth, beyond.depth, rtol=1e-13)
    np.testing.assert_array_equal(again.radius[1:], b)
    # the stored energy of a pinned contact: that of the full disc, then a linear spring
    more = beyond.depth - full.depth
    np.testing.assert_allclose(beyond.energy, full.energy + full.force * more + MODULUS * b * more**2, rtol=1e-12)
    assert any("pinned at the rim" in note.statement for note in beyond.validity)


# ----------------------------------------------------------------------------------------------------------- the puzzle


def test_doubling_the_depth():
    """F rises by 2^1.5 for a paraboloid, by 4 for a cone, by 2 for a punch."""
    for profile, factor in ((wk.Paraboloid(1e-2), 2.0**1.5), (wk.Cone(1.2), 4.0), (wk.FlatPunch(1e-3), 2.0)):
        once, twice = wk.Indentation(wk.Foundation(profile, PAIR), wk.Depth(np.array([1e-6, 2e-6]))).solve().force
        assert twice / once == pytest.approx(factor, rel=1e-13)


def test_hertz_numbers_of_the_theory_sheet():
    """Paraboloid, E* = R = 1, a = 1/2: F = 1/6, mean pressure 2/3 of p0 = 0.318309886."""
    unit = wk.HalfSpace.between(wk.Elastic(1.0, 0.0))
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), unit), wk.Radius(0.5)).solve()
    assert contact.force == pytest.approx(1.0 / 6.0, rel=1e-14)
    assert contact.mean_pressure == pytest.approx(2.0 / 3.0 / math.pi, rel=1e-14)
