"""Lines that slip on layers: independent numbers, half-planes as limits, the substrate, energy, refinement, ghosts."""

from __future__ import annotations

import dataclasses
import functools

import numpy as np
import pytest
from scipy.special import k0
from slip_of_layers import SlippingCylinder

import winkler as wk
from winkler.problems.line_friction import element_row, elements

MU, NU = 0.4, 0.3
SHEAR = 0.5 * (1.0 - NU)
"""E* = 1 of the layer under a rigid body."""
CYLINDER = wk.Paraboloid(1.0)


def solid(share=1.0):
    return wk.Elastic(2.0 * SHEAR * (1.0 + NU) * share, NU)


def coating(contrast, thickness=1.0, second=None):
    return wk.CoatedHalfSpace([wk.Layer(solid(), thickness)], solid(contrast), second or wk.Rigid())


def force(bed, half_width):
    return bed.medium.modulus * float(bed.load_profile(np.array([half_width]))[0])


def pushed(bed, path):
    return wk.LineTangential(bed, wk.Coulomb(MU), path).solve()


@functools.cache
def by_equations(contrast, a):
    return SlippingCylinder([(SHEAR, NU, 1.0)], (contrast * SHEAR, NU), a, 0.7 * a)


@pytest.mark.few(3)
@pytest.mark.parametrize("a", [0.3, 3.0, 10.0])
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_a_cylinder_slips_as_singular_integral_equations_say(contrast, a):
    """Force, stick and loss; of a half-plane the shear force would be 0.51 mu P, here 0.44 to 0.60."""
    expected = by_equations(contrast, a)
    bed = wk.LayeredLineFoundation(CYLINDER, coating(contrast))
    found = pushed(bed, wk.LinePath(expected.load, [0.0, MU * expected.shear]))
    assert found.half_width[-1] == pytest.approx(a, rel=1e-11)
    assert found.stick_half_width[-1] == pytest.approx(0.7 * a, rel=1e-3)
    assert found.dissipation_per_length[-1] == pytest.approx(MU**2 * expected.loss(), rel=1e-4)


def test_shear_does_not_follow_the_compliance_to_pressures():
    """With the response to pressures in the place of that to shear a cylinder would slip as on a half-plane."""
    expected = by_equations(10.0, 10.0)
    assert expected.shear / expected.load == pytest.approx(0.5674, abs=1e-4)
    bed = wk.LayeredLineFoundation(CYLINDER, coating(10.0))
    found = pushed(bed, wk.LinePath(expected.load, [0.0, 0.51 * MU * expected.load]))
    assert found.stick_half_width[-1] / 10.0 > 0.72  # sqrt(0.49) on a half-plane


def loss(medium, a):
    bed = wk.LayeredLineFoundation(CYLINDER, medium)
    load = force(bed, a)
    return pushed(bed, wk.LinePath(load, [0.0, 0.5 * MU * load])).dissipation_per_length[-1]


def plain_loss(share, a):
    bed = wk.LineFoundation(CYLINDER, wk.HalfSpace(solid(share)))
    load = force(bed, a)
    return pushed(bed, wk.LinePath(load, [0.0, 0.5 * MU * load])).dissipation_per_length[-1]


def test_the_substrate_is_felt():
    """At a / h = 3: a softer base lets less slip under the same shares of the loads."""
    assert loss(coating(0.1), 3.0) < 0.5 * loss(coating(0.5), 3.0)


@pytest.mark.slow
def test_the_base_decides_under_a_thin_layer():
    """What differs from the base's own half-plane falls with the thickness h, as h ln(1/h)."""
    away = [loss(coating(0.8, thickness), 1.0) / plain_loss(0.8, 1.0) - 1.0 for thickness in (0.04, 0.02, 0.01)]
    assert 0.02 < away[0] < 0.03
    assert away[2] < 0.7 * away[1] < 0.7 * away[0]


def test_what_is_lost_in_a_closed_cycle_is_the_work_of_the_shear_force():
    """Under a steady force the displacement of a strip that sticks is elastic: what slips does the work."""
    bed = wk.LayeredLineFoundation(CYLINDER, coating(0.1))
    load = force(bed, 2.0)
    swing = 0.8 * MU * load
    cycle = pushed(bed, wk.LinePath(load, [swing, -swing, swing], count=60))
    work = float(np.trapezoid(cycle.shear_force_per_length, cycle.slip_shift))
    lost = float(np.ptp(cycle.dissipation_per_length))
    assert work == pytest.approx(lost, rel=1e-3)
    assert cycle.slip_shift[0] == pytest.approx(cycle.slip_shift[-1], rel=1e-6)


def test_the_loss_converges_with_the_width_of_the_elements(monkeypatch):
    """By the power 7/4, as on half-planes, to either side of which errors scatter: 11 for four times as many."""
    expected = by_equations(0.1, 3.0)
    bed, errors = wk.LayeredLineFoundation(CYLINDER, coating(0.1)), []
    path = wk.LinePath(expected.load, [0.0, MU * expected.shear])
    for count in (25, 50, 100, 200):
        monkeypatch.setattr(elements, "INNER", count)
        lost = wk.LineTangential(bed, wk.Coulomb(MU), path).solve().dissipation_per_length[-1]
        errors.append(abs(lost / (MU**2 * expected.loss()) - 1.0))
    assert errors[0] < 0.02
    assert errors[2] < errors[0] / 8.0
    assert errors[3] < errors[1] / 8.0


@pytest.mark.parametrize("sliding", ["stack", "film"])
def test_a_layer_that_slides_is_pushed_away(sliding):
    """No shear reaches the base, and nothing holds the layer: there is no static solution."""
    layers = [wk.StackLayer(solid(), 1.0), wk.StackLayer(solid(2.0), 1.0, bonded=False)]
    medium = {
        "stack": wk.StackedHalfSpace(layers, solid(0.1)),
        "film": wk.SlidingFilm([wk.Layer(solid(), 1.0)], solid(0.1)),
    }[sliding]
    with pytest.raises(wk.OutsideValidity, match="slides on its base and carries no shear"):
        wk.LineTangential(wk.LayeredLineFoundation(CYLINDER, medium), wk.Coulomb(MU), wk.LinePath(1.0, [0.0, 0.1]))


def test_a_bulk_stress_in_the_base_strains_layers_and_base_alike():
    """Of one solid it is that of a half-plane, out of phase and with slip from both edges; a rigid base bears none."""
    path = wk.LinePath(1.0, [0.0, 0.1, 0.1], bulk_stress=[0.0, 0.0, 0.15])
    layered = pushed(wk.LayeredLineFoundation(CYLINDER, coating(1.0)), path)
    plain = pushed(wk.LineFoundation(CYLINDER, wk.HalfSpace(solid())), path)
    assert layered.dissipation_per_length[-1] == pytest.approx(plain.dissipation_per_length[-1], rel=1e-9)
    assert layered.stick_middle[-1] == pytest.approx(plain.stick_middle[-1], rel=1e-8)
    film = wk.LayeredLineFoundation(CYLINDER, wk.CoatedHalfSpace([wk.Layer(solid(), 1.0)], wk.Rigid()))
    with pytest.raises(wk.InvalidInput, match="carries no bulk stress"):
        wk.LineTangential(film, wk.Coulomb(MU), path)


def test_notes_of_a_line_that_slips_on_layers():
    strong = wk.Elastic(solid().young, NU, strength=2.0)
    bed = wk.LayeredLineFoundation(CYLINDER, wk.CoatedHalfSpace([wk.Layer(strong, 1.0)], solid(0.5)))
    notes = pushed(bed, wk.LinePath(0.1, [0.0, 0.02])).validity
    assert next(note for note in notes if note.assumption is wk.Assumption.SLIP).standing is wk.Standing.APPROXIMATE
    elastic = next(note for note in notes if note.assumption is wk.Assumption.ELASTIC)
    assert elastic.standing is wk.Standing.APPROXIMATE
    assert "were all of it to slide" in elastic.statement


def test_stresses_inside_layers_are_refused_while_a_contact_slips_in_part():
    bed = wk.LayeredLineFoundation(CYLINDER, coating(0.5))
    state = pushed(bed, wk.LinePath(0.1, [0.0, 0.02])).at(-1)
    with pytest.raises(wk.OutsideValidity, match="slips in part"):
        state.stresses(0.0, 0.1)


@pytest.mark.few(2, slow=2)
@pytest.mark.parametrize("a", [0.3, 3.0, 10.0])
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_heat_of_a_line_that_slides_on_layers(contrast, a):
    """Temperature of a moving band under the pressure of the integral equation, by quadrature about its logarithm."""
    of = by_equations(contrast, a)
    first, second = wk.ThermalConductor(2.0, 0.5), wk.ThermalConductor(1.0, 1.0)
    bed = wk.LayeredLineFoundation(CYLINDER, coating(contrast))
    found = wk.LineFrictionHeating(
        wk.LineIndentation(bed, wk.LineForce(of.load)), wk.Coulomb(MU), wk.HeatConductors(first, second),
        first_speed=3.0 / a, second_speed=0.0, partition=wk.FixedShare(1.0),
    ).solve()  # fmt: skip
    pressure = np.polynomial.chebyshev.Chebyshev.fit(of.s / a, of.p, 40)
    x, rate = np.array([-0.4, 0.2, 0.8]) * a, 3.0 / a / (2.0 * 0.5)

    def warmed(place):
        node, weight = np.polynomial.legendre.leggauss(60)
        total = 0.0
        for low, high in ((-a, place), (place, a)):  # s = end + (end - place) (1 - t^4): roots and logarithm are gone
            t = 0.5 * (node + 1.0)
            share = t**4 * (35.0 - 84.0 * t + 70.0 * t**2 - 20.0 * t**3)
            s, step = low + (high - low) * share, (high - low) * 140.0 * (t * (1.0 - t)) ** 3 * 0.5 * weight
            z = rate * (place - s)
            heat = MU * np.sqrt(np.maximum(a * a - s * s, 0.0)) / a * pressure(s / a) * 3.0 / a
            total += float(np.sum(heat * np.exp(z) * k0(np.abs(z)) * step))
        return total / (np.pi * 2.0)

    np.testing.assert_allclose(found.first.temperature(x), [warmed(place) for place in x], rtol=1e-6)
    pressed = wk.LineIndentation(wk.LineFoundation(CYLINDER, wk.HalfSpace(solid())), wk.LineForce(of.load))
    plain = dataclasses.replace(found.problem, contact=pressed).solve()
    assert found.flash_temperature != pytest.approx(plain.flash_temperature, rel=5e-3)


@pytest.mark.few(2)
@pytest.mark.parametrize("a", [0.3, 3.0, 10.0])
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_current_through_a_line_on_layers_converges_on_their_strip(contrast, a):
    """rho / pi arsinh(d / a) in each body, with the half-width of the integral equation."""
    load = wk.LineForce(by_equations(contrast, a).load)
    pair = wk.ElectricalConductors(wk.ElectricalConductor(2.0), wk.ElectricalConductor(3.0))
    bed = wk.LayeredLineFoundation(CYLINDER, coating(contrast))
    found = wk.LineConstriction(wk.LineIndentation(bed, load), pair, first_depth=20.0, second_depth=30.0).solve()
    expected = (2.0 * np.arcsinh(20.0 / a) + 3.0 * np.arcsinh(30.0 / a)) / np.pi
    assert found.resistance_per_length == pytest.approx(expected, rel=1e-11)


def test_friction_drags_a_layer_away_that_slides_on_what_lies_below_it():
    bed = wk.LayeredLineFoundation(CYLINDER, wk.SlidingFilm([wk.Layer(solid(), 1.0)], solid(0.1)))
    pair = wk.HeatConductors(wk.ThermalConductor(2.0, 0.5), wk.ThermalConductor(1.0, 1.0))
    pressed = wk.LineIndentation(bed, wk.LineForce(0.1))
    with pytest.raises(wk.OutsideValidity, match="slides on its base and carries no shear"):
        wk.LineFrictionHeating(pressed, wk.Coulomb(MU), pair, first_speed=1.0, second_speed=2.0)


def test_anisotropic_layers_slip_as_isotropic_ones_where_they_are_and_by_their_own_constants_elsewhere():
    """A transversely isotropic layer with isotropic constants; one of the same E* that shears another way."""
    iso = wk.TransverselyIsotropic(*alike(solid()))
    path = wk.LinePath(0.5, [0.0, 0.1])
    known = pushed(wk.LayeredLineFoundation(CYLINDER, coating(0.2)), path)
    stack = wk.StackedHalfSpace([wk.StackLayer(iso, 1.0)], solid(0.2))
    found = pushed(wk.LayeredLineFoundation(CYLINDER, stack), path)
    np.testing.assert_allclose(found.half_width, known.half_width, rtol=1e-10)
    np.testing.assert_allclose(found.dissipation_per_length, known.dissipation_per_length, rtol=1e-8)
    wood = wk.TransverselyIsotropic(11.0, 4.0, 4.0, 20.0, 3.0)
    thick = wk.StackedHalfSpace([wk.StackLayer(wood, 1.0)], wood)
    layered = pushed(wk.LayeredLineFoundation(CYLINDER, thick), path)
    plain = pushed(wk.LineFoundation(CYLINDER, wk.TransverselyIsotropicHalfSpace(wood)), path)
    np.testing.assert_allclose(layered.half_width, plain.half_width, rtol=1e-10)
    lost = plain.dissipation_per_length[-1]
    assert layered.dissipation_per_length[-1] == pytest.approx(lost, rel=2e-4)


def alike(body):
    """C11, C12, C13, C33, C44 of an isotropic solid."""
    lame = 2.0 * body.shear * body.poisson / (1.0 - 2.0 * body.poisson)
    return lame + 2.0 * body.shear, lame, lame, lame + 2.0 * body.shear, body.shear


@pytest.mark.parametrize(("contrast", "a"), [(0.1, 0.3), pytest.param(1000.0, 3.0, marks=pytest.mark.slow)])
def test_what_turning_points_remember_is_what_elements_march_to(contrast, a, monkeypatch):
    """Twice the first slip under twice the force, against steps in each of which the zones are sought anew.

    Under a stiff layer it is not the edge that slips first.  Loops are closed, left, met exactly and gone round again.
    """
    bed = wk.LayeredLineFoundation(CYLINDER, coating(contrast))
    load, rng = force(bed, a), np.random.default_rng(7)
    shares = [0.0, *rng.uniform(-0.98, 0.98, 16), 1.0, 0.0, -0.6, 0.3, -0.6, -0.6, 0.5, -0.6, 0.9, -1.0, 0.2]
    path = wk.LinePath(load, MU * load * np.array(shares))
    remembered = pushed(bed, path)
    monkeypatch.setattr(element_row.ElementRow, "_first", None)
    marched = pushed(bed, path)
    for name in ("slip_shift", "dissipation_per_length"):
        wanted = getattr(marched, name)
        assert getattr(remembered, name) == pytest.approx(wanted, abs=1e-12 * np.max(np.abs(wanted)))
    assert remembered.stick_half_width == pytest.approx(marched.stick_half_width, abs=0.01 * a)  # within an element
    x = a * np.linspace(-0.99, 0.99, 23)
    for one, other in zip(remembered.states[1:], marched.states[1:], strict=True):
        wanted = other.traction(x)
        assert one.traction(x) == pytest.approx(wanted, abs=1e-11 * np.max(np.abs(wanted)))


@pytest.mark.parametrize("contrast", [1e-6, 1e3])
def test_wide_strips_are_sheared_on_hard_and_soft_layers(contrast):
    """At a/h 3 and a contrast of 1,000 the kernel was refused as too rough; the loss is that of a closed cycle."""
    bed = wk.LayeredLineFoundation(CYLINDER, coating(contrast))
    load = force(bed, 3.0)
    found = pushed(bed, wk.LinePath(load, 0.6 * MU * load * np.array([0.0, 1.0, -1.0, 1.0])))
    first, loop = found.dissipation_per_length[1], found.dissipation_per_length[-1] - found.dissipation_per_length[1]
    assert loop == pytest.approx(4.0 * first, rel=1e-9)  # twice over twice the slip, back and forth


@pytest.mark.parametrize("swing", [1e-9, 1e-7])
def test_a_force_that_hardly_varies_is_a_steady_one(swing):
    """The march divided by zero where the edge rose by rounding alone; turning points that are remembered agree."""
    medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(2100e9, 0.3), 50e-6)], on=wk.Elastic(70e9, 0.3))
    bed = wk.LayeredLineFoundation(wk.Paraboloid(0.01), medium)
    shears = 3e4 * np.array([0.0, 0.7, -0.5, 0.3, -0.6, 0.6, 0.0])

    def found(share):
        path = wk.LinePath(1e5 * (1.0 + share * np.sin(np.arange(7.0))), shears)
        return wk.LineTangential(bed, wk.Coulomb(0.3), path).solve()

    steady, varied = found(0.0), found(swing)
    assert varied.dissipation_per_length[-1] == pytest.approx(steady.dissipation_per_length[-1], rel=10.0 * swing)
    np.testing.assert_allclose(
        varied.slip_shift, steady.slip_shift, rtol=0.0, atol=10.0 * swing * np.max(np.abs(steady.slip_shift))
    )
