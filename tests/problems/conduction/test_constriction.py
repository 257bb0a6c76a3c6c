"""Contact resistance and heat through contacts against Holm, Barber, Kohlrausch and Greenwood."""

from __future__ import annotations

import math
import time

import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

import winkler as wk
from winkler.media.conduction.disc_resistance import PlatedResponse
from winkler.media.conduction.spot_resistances import spot_resistances

STEEL = wk.Elastic(young=210e9, poisson=0.3)
MEDIUM = wk.HalfSpace.between(STEEL, STEEL)
BALL = wk.Foundation(wk.Paraboloid(10e-3), MEDIUM)
SILVER, COPPER = wk.ElectricalConductor(15.9e-9), wk.ElectricalConductor(16.8e-9)
PAIR = wk.ElectricalConductors(SILVER, COPPER)
HEAT = wk.ThermalConductor(conductivity=45.0, diffusivity=12e-6)


@pytest.mark.parametrize(
    "profile",
    [wk.Paraboloid(10e-3), wk.Cone(1.3), wk.PowerLaw(1e6, 4.0), wk.RoundedPunch(1e-4, 1e-2), wk.FlatPunch(1e-4)],
)
def test_conductance_is_barbers_analogy_of_the_stiffness(profile):
    """2 / (E* (rho_1 + rho_2)) dF/dd, with dF/dd from differences of the force itself."""
    bed = wk.Foundation(profile, MEDIUM)
    contact = wk.Constriction(wk.Indentation(bed, wk.Force(50.0)), PAIR).solve()
    step = 1e-4 * contact.depth
    near = [wk.Indentation(bed, wk.Depth(contact.depth + side * step)).solve().force for side in (-1.0, 1.0)]
    slope = (near[1] - near[0]) / (2.0 * step)
    assert contact.conductance == pytest.approx(2.0 * slope / (MEDIUM.modulus * 32.7e-9), rel=2e-6)


def test_holms_resistance_to_all_digits():
    contact = wk.Constriction(wk.Indentation(BALL, wk.Force(100.0)), PAIR).solve()
    with mp.workdps(30):
        modulus = mp.mpf(210e9) / (2 * (1 - mp.mpf(0.3) ** 2))
        radius = mp.cbrt(3 * mp.mpf(100) * mp.mpf(10e-3) / (4 * modulus))
        expected = (mp.mpf(15.9e-9) + mp.mpf(16.8e-9)) / (4 * radius)
    assert contact.resistance == pytest.approx(float(expected), rel=1e-13)
    assert contact.first_constriction / contact.second_constriction == pytest.approx(15.9 / 16.8, rel=1e-14)
    assert contact.constriction == contact.resistance


def test_a_layered_elastic_body_conducts_by_its_radius_not_by_its_stiffness():
    coated = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(450e9, 0.25), 20e-6)], on=STEEL)
    bed = wk.Foundation(wk.Paraboloid(10e-3), coated)
    contact = wk.Constriction(wk.Indentation(bed, wk.Force(10.0)), PAIR).solve()
    assert contact.conductance == pytest.approx(4.0 * contact.radius / 32.7e-9, rel=1e-14)
    stiff = wk.Indentation(bed, wk.Force(10.0)).solve().stiffness
    assert abs(2.0 * stiff / (coated.modulus * 32.7e-9) / contact.conductance - 1.0) > 0.05
    assert any("not proportional" in note.statement for note in contact.validity)


def test_an_elliptic_contact_given_by_its_force_curve():
    """f = A x^2 + B y^2 with A, B = 0.25, 0.75: the isothermal ellipse conducts pi a / K(e) times as a line does."""
    m = 1.0 - (0.65152852 / 1.3499607) ** 2
    k, e = ellipk(m), ellipe(m)
    major = (3.0 * (k - e) / (2.0 * np.pi * m * 0.25)) ** (1.0 / 3.0)
    depth = 3.0 * k / (2.0 * np.pi * major)
    share = np.geomspace(0.05, 2.0, 60)
    stiffness = np.pi * major * share ** (1.0 / 3.0) / k
    bed = wk.MeasuredBed(stiffness / 2.0, stiffness, depth * share ** (2.0 / 3.0))
    unit = wk.ElectricalConductor(1.0)
    contact = wk.Constriction(wk.Indentation(bed, wk.Force(1.0)), wk.ElectricalConductors(unit, unit)).solve()
    assert contact.depth == pytest.approx(0.7739655, rel=1e-6)
    # Smythe: an isothermal ellipse on a half-space has R = rho K(e) / (2 pi a)
    assert contact.resistance == pytest.approx(2.0 * k / (2.0 * np.pi * 1.3499607), rel=1e-6)
    filmed = wk.ElectricalConductors(unit, unit, wk.SurfaceFilm(1.0))
    plated = wk.ElectricalConductors(unit, wk.Plated(wk.ElectricalConductor(2.0), 1.0, on=unit))
    for pair, why in ((filmed, "The area of the contact is not known"), (plated, "a plating needs a round contact")):
        with pytest.raises(wk.OutsideValidity, match=why):
            wk.Constriction(wk.Indentation(bed, wk.Force(1.0)), pair).solve()
        with pytest.raises(wk.OutsideValidity, match=why):
            wk.JouleHeating(wk.Indentation(bed, wk.Force(1.0)), pair, wk.Current(1.0)).solve()


def test_a_thousand_loads_come_at_once_and_as_one_by_one():
    force = np.geomspace(0.01, 1e3, 1000)
    problem = wk.Constriction(
        wk.Indentation(BALL, wk.Force(force)), wk.ElectricalConductors(SILVER, COPPER, wk.SurfaceFilm(1e-12))
    )
    problem.solve()
    start = time.perf_counter()
    curve = problem.solve()
    assert time.perf_counter() - start < 1.0
    assert np.all(np.diff(curve.resistance) < 0.0)
    assert curve.at(400).resistance == pytest.approx(curve.resistance[400], rel=1e-12)
    parts = curve.first_constriction + curve.second_constriction + curve.film_resistance
    assert curve.resistance == pytest.approx(parts, rel=1e-14)


def test_bodies_apart_conduct_nothing():
    apart = wk.Constriction(wk.Indentation(BALL, wk.Depth([-1e-6, 1e-6])), PAIR).solve()
    assert apart.resistance[0] == math.inf
    assert apart.conductance[0] == 0.0
    joint = wk.ThermalConstriction(wk.Indentation(BALL, wk.Depth(-1e-6)), wk.HeatConductors(HEAT, HEAT), 10.0).solve()
    assert joint.heat_rate == 0.0
    assert joint.first_drop == 0.0


def test_a_film_lies_between_the_bounds_of_thomson():
    """One voltage on both sides of the film: too little resistance. Even flux everywhere: too much."""
    for area_resistance in (1e-15, 1e-12, 1e-9):
        pair = wk.ElectricalConductors(SILVER, COPPER, wk.SurfaceFilm(area_resistance))
        contact = wk.Constriction(wk.Indentation(BALL, wk.Force(1.0)), pair).solve()
        holm, film = 32.7e-9 / (4.0 * contact.radius), area_resistance / (math.pi * contact.radius**2)
        assert holm + film <= contact.resistance <= 32.0 / (3.0 * math.pi**2) * holm + film


def test_rods_constrict_less_and_add_their_length():
    rod = wk.Rod(SILVER, radius=1e-3, length=20e-3)
    contact = wk.Constriction(wk.Indentation(BALL, wk.Radius(1e-4)), wk.ElectricalConductors(rod, rod)).solve()
    assert contact.bulk_resistance == pytest.approx(2.0 * 15.9e-9 * 20e-3 / (math.pi * 1e-6), rel=1e-14)
    assert contact.constriction == pytest.approx(0.8594136006 * 15.9e-9 / 2e-4, rel=1e-9)
    with pytest.raises(wk.OutsideValidity, match="nearly as wide as the rod"):
        wk.Constriction(
            wk.Indentation(BALL, wk.Radius(0.95e-4)), wk.ElectricalConductors(wk.Rod(SILVER, 1e-4, 1e-2), SILVER)
        ).solve()


@pytest.mark.parametrize(("plating", "on", "below"), [(1.0, 10.0, None), (10.0, 1.0, None), (1.0, 10.0, 0.3)])
def test_a_plating_conducts_as_the_best_flux_allows(plating, on, below):
    """Galerkin's method in wave numbers, with fluxes (1 - r^2)^(k - 1/2) under the contact: an upper bound."""
    from scipy.special import gamma, jv

    thickness = 0.5
    base, under = wk.ElectricalConductor(on), on
    if below is not None:
        base = wk.Plated(base, 0.3, on=wk.ElectricalConductor(below))
    body = wk.Plated(wk.ElectricalConductor(plating), thickness, on=base)
    bed = wk.Foundation(wk.FlatPunch(1.0), wk.HalfSpace.between(wk.Elastic(1.0, 0.0)))
    result = (
        wk.Constriction(wk.Indentation(bed, wk.Force(1e-3)), wk.ElectricalConductors(body, body)).solve().resistance
    )
    nodes, weights = np.polynomial.legendre.leggauss(16)
    starts = np.arange(40.0)  # the difference to a bare body dies out like exp(-xi)
    xi, dxi = (starts[:, None] + 0.5 * (nodes + 1.0)).ravel(), np.tile(0.5 * weights, 40)
    if below is not None:  # what the plating meets, by hyperbolic functions
        through = np.tanh(0.3 * xi)
        under = on * (below + on * through) / (on + below * through)
    echo = (under - plating) / (under + plating) * np.exp(-2.0 * xi * thickness)
    more = 2.0 * echo / (1.0 - echo)
    fluxes = [2.0 ** (k - 0.5) * gamma(k + 0.5) * jv(k + 0.5, xi) / xi ** (k + 0.5) for k in range(6)]
    whole = np.array([2.0 * np.pi / (2.0 * k + 1.0) for k in range(6)])
    scale = [2.0 ** (k - 0.5) * gamma(k + 0.5) for k in range(6)]
    with mp.workdps(20):
        bare = np.array(
            [
                [
                    scale[k]
                    * scale[j]
                    * float(
                        mp.gamma(k + j + 2 - 1)
                        * mp.gamma(mp.mpf(1) / 2)
                        / (2 ** (k + j + 1) * mp.gamma(j + 1) * mp.gamma(k + 1) * mp.gamma(k + j + mp.mpf(3) / 2))
                    )
                    for j in range(6)
                ]
                for k in range(6)
            ]
        )
    extra = np.array([[np.sum(dxi * more * one * other) for other in fluxes] for one in fluxes])
    energy = 2.0 * np.pi * plating * (bare + extra)
    expected = 2.0 / (whole @ np.linalg.solve(energy, whole))
    assert result == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize(("plating", "on"), [(1.0, 4e2), (1.0, 1e5), (1e5, 1.0)])
def test_what_comes_back_from_below_a_plating_keeps_its_digits_at_high_contrast(plating, on):
    """By hyperbolic functions in 40 digits; maps of spots through such platings were refused for lost digits."""
    body = wk.Plated(wk.ElectricalConductor(plating), 1.0, on=wk.ElectricalConductor(on))
    response = PlatedResponse(body, body)
    xi = np.geomspace(1e-8, 3.0, 23)
    with mp.workdps(40):
        through = [mp.tanh(mp.mpf(float(x))) for x in xi]
        whole = [float((on + plating * t) / (plating + on * t)) for t in through]
        excess = [float((on - plating) * (1 - t) / (plating + on * t)) for t in through]
    np.testing.assert_allclose(response.whole(xi), whole, rtol=1e-14)
    np.testing.assert_allclose(response.excess(xi), excess, rtol=1e-14)


@pytest.mark.slow
def test_platings_of_one_metal_are_one():
    """Also where a map of pixels follows them, of which each is scaled by the thickness."""
    two = wk.Plated(COPPER, 1e-6, wk.Plated(COPPER, 2e-6, SILVER))
    one = wk.Plated(COPPER, 3e-6, SILVER)
    first, second = (
        wk.Constriction(wk.Indentation(BALL, wk.Force(1.0)), wk.ElectricalConductors(body, SILVER)).solve().resistance
        for body in (two, one)
    )
    assert first == pytest.approx(second, rel=1e-9)
    touching = np.ones((8, 8), dtype=bool)
    parts = [spot_resistances(touching, (1e-5, 1e-5), (body, SILVER), 0.0, periodic=False) for body in (two, one)]
    assert parts[0].first == pytest.approx(parts[1].first, rel=1e-6)


def test_a_plating_of_the_same_metal_is_none():
    same = wk.Plated(SILVER, 1e-6, on=SILVER)
    plain = wk.Constriction(wk.Indentation(BALL, wk.Force(1.0)), PAIR).solve().resistance
    assert (
        wk.Constriction(wk.Indentation(BALL, wk.Force(1.0)), wk.ElectricalConductors(same, COPPER)).solve().resistance
        == plain
    )


def test_heat_flows_with_the_harmonic_mean_of_conductivities():
    other = wk.ThermalConductor(conductivity=390.0, diffusivity=1.1e-4)
    joint = wk.ThermalConstriction(wk.Indentation(BALL, wk.Force(100.0)), wk.HeatConductors(HEAT, other), 25.0).solve()
    harmonic = 1.0 / (1.0 / 45.0 + 1.0 / 390.0)
    assert joint.heat_rate == pytest.approx(4.0 * harmonic * joint.radius * 25.0, rel=1e-14)
    assert joint.first_drop + joint.second_drop == pytest.approx(25.0, rel=1e-14)
    assert joint.first_drop / joint.second_drop == pytest.approx(390.0 / 45.0, rel=1e-13)
    pair = wk.HeatConductors(HEAT, other, wk.ThermalInterface(1e6))
    held = wk.ThermalConstriction(wk.Indentation(BALL, wk.Force(100.0)), pair, 25.0).solve()
    assert held.interface_resistance == pytest.approx(1.0 / (1e6 * math.pi * held.radius**2), rel=1e-14)
    assert held.heat_rate < joint.heat_rate


def test_steady_heat_needs_no_diffusivity():
    """Two glass beads, 1/(4 lambda_h a) = 6649.5 K/W."""
    glass = wk.ThermalConductor(conductivity=1.0)
    joint = wk.ThermalConstriction(
        wk.Indentation(BALL, wk.Radius(75.1931e-6)), wk.HeatConductors(glass, glass), 200.0
    ).solve()
    assert joint.resistance == pytest.approx(6649.5, rel=1e-5)
    assert "after an unknown time" in joint.validity[-1].statement
    plated = wk.Plated(wk.ThermalConductor(1.0, 1e-6), 1e-6, wk.ThermalConductor(1.0, 1e-7))
    joint = wk.ThermalConstriction(
        wk.Indentation(BALL, wk.Radius(1e-4)), wk.HeatConductors(HEAT, plated), 200.0
    ).solve()
    slowest = joint.validity[-1].statement  # the slowest part of a body decides
    assert slowest.startswith("Steady state is assumed. The steady state is reached within 9 % after 1 s, ten times")


# ---------------------------------------------------------------------------------------------------- Joule heat


@pytest.mark.parametrize("alpha", [0.0, 1.0 / 293.15])
def test_a_contact_in_proportion_to_temperature_heats_like_an_arc_tangent(alpha):
    """lambda constant, rho = rho_0 T / T_0: hot over cold resistance is v / atan(v), v = V / (2 sqrt(L) T_0)."""
    metal = wk.ElectricalConductor(15.9e-9, alpha)
    hot = wk.JouleHeating(
        wk.Indentation(BALL, wk.Radius(20e-6)), wk.ElectricalConductors(metal, metal), wk.Voltage(0.2)
    ).solve()
    v = 0.2 / (2.0 * math.sqrt(2.44e-8) * 293.15)
    assert hot.max_temperature == pytest.approx(293.15 * math.hypot(1.0, v), rel=1e-14)
    assert hot.resistance / hot.cold_resistance == pytest.approx(v / math.atan(v) if alpha else 1.0, rel=1e-13)
    back = wk.JouleHeating(
        wk.Indentation(BALL, wk.Radius(20e-6)), hot.problem.conductors, wk.Current(hot.current)
    ).solve()
    assert back.voltage == pytest.approx(0.2, rel=1e-12)


def test_unlike_bodies_and_a_film_against_the_equations_of_heat_and_current():
    """Shot along the lines of current, with conductivity L T / rho: from one end through the film to the other."""
    lorenz, ambient, current = 2.44e-8, 300.0, 60.0
    resistances, alphas, film = (4e-4, 1.5e-3), (4e-3, 1e-3), 6e-4

    def shot(start):
        """T at the far end, for a heat outflow of `start` watts at the near one; s runs over cold resistance."""
        state, trace = [ambient, 0.0, start], []
        for resistance, alpha in zip(resistances, alphas, strict=True):

            def slope(_s, y, alpha=alpha):
                grown = 1.0 + alpha * (y[0] - ambient)
                return [y[2] * grown / (lorenz * y[0]), current * grown, -(current**2) * grown]

            march = solve_ivp(slope, (0.0, resistance), state, rtol=1e-11, atol=1e-12, max_step=resistance / 50.0)
            trace += list(march.y[0])
            touch = march.y[0][-1]
            state = [touch, march.y[1][-1], march.y[2][-1] - current**2 * film]
        return touch, march.y[1][-1], max(trace)

    lowest = brentq(lambda start: shot(start)[0] - ambient, 0.5, 40.0, xtol=1e-12)
    _, voltage, greatest = shot(lowest)
    radius = 20e-6
    # R = rho / (4 a) of each body; the film spreads the current, which is taken out of what the bodies are given
    spread = 1.0
    for _ in range(30):
        pair = wk.ElectricalConductors(
            wk.ElectricalConductor(4.0 * radius * resistances[0] / spread, alphas[0]),
            wk.ElectricalConductor(4.0 * radius * resistances[1] / spread, alphas[1]),
            wk.SurfaceFilm(film * math.pi * radius**2),
        )
        cold = wk.Constriction(wk.Indentation(BALL, wk.Radius(radius)), pair).solve()
        spread *= float(cold.first_constriction) / resistances[0]
    hot = wk.JouleHeating(
        wk.Indentation(BALL, wk.Radius(radius)), pair, wk.Current(current), temperature=ambient
    ).solve()
    assert hot.film_voltage == pytest.approx(current * film, rel=1e-12)
    assert hot.voltage - hot.film_voltage == pytest.approx(voltage, rel=1e-7)
    assert hot.max_temperature == pytest.approx(greatest, rel=1e-4)


def test_melting_voltages_as_they_are_commonly_quoted():
    """Silver 0.37 V, copper 0.43 V, gold 0.43 V (Holm 1967, table X)."""
    law = wk.WiedemannFranz()
    for melting, listed in ((1235.0, 0.37), (1358.0, 0.43), (1337.0, 0.43)):
        assert law.voltage_at(melting) == pytest.approx(listed, rel=0.06)
    metal = wk.ElectricalConductor(15.9e-9, 4e-3)
    pair = wk.ElectricalConductors(metal, metal)
    melting = wk.JouleHeating(wk.Indentation(BALL, wk.Radius(2e-5)), pair, wk.Voltage(law.voltage_at(1235.0))).solve()
    assert melting.max_temperature == pytest.approx(1235.0, rel=1e-13)
    assert any(note.standing is wk.Standing.OUTSIDE for note in melting.validity)


def test_small_voltages_heat_with_their_square():
    """V^2 / (8 lambda rho), with lambda rho = L T_0."""
    hot = wk.JouleHeating(wk.Indentation(BALL, wk.Force(1.0)), PAIR, wk.Voltage(1e-3)).solve()
    equal = wk.JouleHeating(
        wk.Indentation(BALL, wk.Force(1.0)), wk.ElectricalConductors(SILVER, SILVER), wk.Voltage(1e-3)
    ).solve()
    assert equal.rise == pytest.approx(1e-6 / (8.0 * 2.44e-8 * 293.15), rel=1e-4)
    assert hot.rise == pytest.approx(equal.rise, rel=1e-9)
    assert hot.contact_temperature < hot.max_temperature


def test_too_much_current_is_refused():
    metal = wk.ElectricalConductor(15.9e-9, 4e-3)
    pair = wk.ElectricalConductors(metal, metal)
    with pytest.raises(wk.OutsideValidity, match="No voltage drives"):
        wk.JouleHeating(wk.Indentation(BALL, wk.Radius(2e-5)), pair, wk.Current(1e5)).solve()
    with pytest.raises(wk.InvalidInput, match="do not touch"):
        wk.JouleHeating(wk.Indentation(BALL, wk.Depth(-1e-6)), pair, wk.Current(1.0)).solve()


def test_beyond_the_greatest_current_there_is_a_second_voltage():
    """Nickel's resistivity rises faster than its temperature: the current has a maximum, the cold side is taken."""
    pair = wk.ElectricalConductors(wk.ElectricalConductor(1.6e-8), wk.ElectricalConductor(1.6e-6, 6e-3))
    voltage = np.geomspace(1e-2, 3.0, 60)
    current = np.array(
        [
            wk.JouleHeating(wk.Indentation(BALL, wk.Radius(2e-5)), pair, wk.Voltage(float(one))).solve().current
            for one in voltage
        ]
    )
    top = int(np.argmax(current))
    assert 0 < top < 59
    last = wk.JouleHeating(wk.Indentation(BALL, wk.Radius(2e-5)), pair, wk.Current(float(current[-1]))).solve()
    assert last.voltage < voltage[top]
    assert last.current == pytest.approx(current[-1], rel=1e-12)
    near = wk.JouleHeating(
        wk.Indentation(BALL, wk.Radius(2e-5)), pair, wk.Current(0.99999 * float(current[top]))
    ).solve()
    assert near.voltage < 1.01 * voltage[top]
    with pytest.raises(wk.OutsideValidity, match="The maximum current is"):
        wk.JouleHeating(wk.Indentation(BALL, wk.Radius(2e-5)), pair, wk.Current(1.01 * float(current[top]))).solve()


# -------------------------------------------------------------------------------------------------------- fields


def test_the_fields_carry_the_whole_current_and_meet_at_the_contact():
    metals = wk.ElectricalConductor(15.9e-9, 4e-3), wk.ElectricalConductor(60e-9, 1e-3)
    problem = wk.JouleHeating(
        wk.Indentation(BALL, wk.Radius(20e-6)), wk.ElectricalConductors(*metals), wk.Voltage(0.15)
    )
    hot = problem.solve()
    nodes, weights = np.polynomial.legendre.leggauss(60)
    mu, dmu = 0.5 * (nodes + 1.0), 0.5 * weights
    disc = wk.restore_conduction(hot, 20e-6 * np.sqrt(1.0 - mu**2))
    assert np.sum(disc.axial_current_density * mu * dmu) * 2.0 * np.pi * 4e-10 == pytest.approx(hot.current, rel=1e-8)
    assert disc.temperature == pytest.approx(np.full(60, hot.contact_temperature), rel=1e-12)
    below = wk.restore_conduction(hot, 0.0, np.array([0.0, -1e-13]))
    assert below.potential[0] == pytest.approx(below.potential[1], rel=1e-7)
    deep = wk.restore_conduction(hot, 0.0, -np.geomspace(1e-8, 1e-3, 4000))
    assert np.max(deep.temperature) == pytest.approx(hot.max_temperature, rel=1e-6)
    # Ohm's law where the metal is hot: J = -grad(phi) / rho(T)
    z = np.array([5e-6, 5e-6 + 1e-10])
    near = wk.restore_conduction(hot, 3e-6, z)
    slope = (near.potential[1] - near.potential[0]) / 1e-10
    rho = metals[0].resistivity_above(near.temperature[0] - 293.15)
    assert near.axial_current_density[0] == pytest.approx(-slope / rho, rel=1e-4)


def test_heat_fields():
    joint = wk.ThermalConstriction(wk.Indentation(BALL, wk.Radius(1e-4)), wk.HeatConductors(HEAT, HEAT), 10.0).solve()
    result = wk.restore_conduction(joint, np.array([0.0, 1e-4, 2e-4]), 0.0)
    assert result.excess_temperature[0] == pytest.approx(5.0, rel=1e-14)
    assert result.excess_temperature[2] == pytest.approx(10.0 - 5.0 * 2.0 / math.pi * math.asin(0.5), rel=1e-13)
    assert result.axial_heat_flux[1] == -math.inf
    assert result.axial_heat_flux[0] == pytest.approx(-joint.heat_rate / (2.0 * math.pi * 1e-8), rel=1e-12)
    far = wk.restore_conduction(joint, 0.0, np.array([1.0, -1.0]))
    assert far.excess_temperature == pytest.approx([10.0, 0.0], abs=1e-3)
    pair = wk.HeatConductors(HEAT, HEAT, wk.ThermalInterface(1e6))
    filmed = wk.ThermalConstriction(wk.Indentation(BALL, wk.Radius(1e-4)), pair, 1.0).solve()
    with pytest.raises(wk.OutsideValidity, match="plain disc"):
        wk.restore_conduction(filmed, 0.0)
    with pytest.raises(wk.InvalidInput, match="drives nothing"):
        wk.restore_conduction(wk.Constriction(wk.Indentation(BALL, wk.Force(1.0)), PAIR).solve(), 0.0)


def test_the_size_of_free_flight_is_noted():
    contact = wk.Constriction(wk.Indentation(BALL, wk.Radius(1e-7)), PAIR, mean_free_path=4e-8).solve()
    note = contact.validity[-1]
    assert note.standing is wk.Standing.OUTSIDE
    assert f"{100.0 * 8.0 * 0.4 / (3.0 * math.pi):.3g} %" in note.statement


@pytest.mark.parametrize(
    ("make", "statements"),
    [
        (lambda: wk.ElectricalConductor(0.0), "resistivity"),
        (lambda: wk.ElectricalConductor(1.0, -1e-3), "temperature_coefficient"),
        (lambda: wk.ThermalConductor(1.0, math.nan), "diffusivity"),
        (lambda: wk.Plated(SILVER, 1e-6, on=HEAT), "one sort"),
        (lambda: wk.Rod(SILVER, -1.0, 1.0), "radius"),
        (lambda: wk.SurfaceFilm(-1.0), "area_resistance"),
        (lambda: wk.ThermalInterface(0.0), "interface_conductance"),
        (lambda: wk.ElectricalConductors(SILVER, HEAT), "ThermalConductor"),
        (lambda: wk.Current(-1.0), "current"),
        (lambda: wk.WiedemannFranz(0.0), "lorenz_number"),
        (lambda: wk.WiedemannFranz().voltage_at(200.0), "below that of the bodies"),
        (lambda: wk.Constriction(wk.Indentation(BALL, wk.Force(1.0)), SILVER), "conductors"),
        (lambda: wk.SpotCluster([0.0], [0.0, 1.0], [1.0], SILVER, SILVER), "one of each"),
    ],
)
def test_what_cannot_be_used_is_refused(make, statements):
    with pytest.raises(wk.InvalidInput, match=statements):
        make()


GOOD, BAD = wk.ElectricalConductor(2e-8), wk.ElectricalConductor(1e-6)
UNLIKE = wk.ElectricalConductors(wk.Plated(BAD, 2e-6, on=GOOD), wk.Plated(GOOD, 2e-6, on=BAD))
SPOT = wk.Foundation(wk.FlatPunch(5e-6), wk.HalfSpace.between(wk.Elastic(100e9, 0.3)))


def test_a_spot_between_unlike_platings_has_no_single_temperature():
    """Numbers of an independent solution; one temperature of 604.2 K was given, and a share of .7824."""
    hot = wk.JouleHeating(wk.Indentation(SPOT, wk.Force(1.0)), UNLIKE, wk.Voltage(0.2)).solve()
    assert (hot.middle_temperature, hot.edge_temperature) == pytest.approx((615.0, 600.2), abs=0.05)
    assert hot.edge_temperature < hot.contact_temperature < hot.middle_temperature
    many = wk.Constriction(wk.Indentation(BALL, wk.Radius(np.geomspace(1e-6, 9e-6, 60))), UNLIKE).solve()
    one = many.at(41)
    assert many.first_constriction[41] == pytest.approx(one.first_constriction, rel=1e-8)
    contact = wk.Constriction(wk.Indentation(SPOT, wk.Force(1.0)), UNLIKE).solve()
    assert contact.first_constriction / contact.resistance == pytest.approx(0.7801, abs=5e-5)
    assert any("614.99 K on its axis, 600.21 K at its edge" in note.statement for note in hot.validity)
    turned = wk.JouleHeating(
        wk.Indentation(SPOT, wk.Force(1.0)), wk.ElectricalConductors(UNLIKE.second, UNLIKE.first), wk.Voltage(0.2)
    ).solve()
    assert turned.edge_temperature == pytest.approx(hot.edge_temperature, rel=1e-9)
    like = wk.JouleHeating(wk.Indentation(SPOT, wk.Force(1.0)), PAIR, wk.Voltage(0.2)).solve()
    assert like.middle_temperature == like.edge_temperature == like.contact_temperature


@pytest.mark.slow
@pytest.mark.parametrize("radius", [1e-6, 5e-6, 40e-6])
def test_the_first_body_has_the_part_of_the_heat_that_its_resistivity_has_of_the_resistance(radius):
    """R is least for the current as it flows, so that its derivative by one body's resistivity is that body's heat."""

    def whole(factor):
        body = wk.Plated(wk.ElectricalConductor(factor * 1e-6), 2e-6, on=wk.ElectricalConductor(factor * 2e-8))
        pair = wk.ElectricalConductors(body, UNLIKE.second)
        return float(pair.resistances(np.array([radius])).whole[0])

    step = 1e-2
    slope = (8.0 * (whole(1.0 + step) - whole(1.0 - step)) - whole(1.0 + 2 * step) + whole(1.0 - 2 * step)) / (
        12 * step
    )
    assert float(UNLIKE.resistances(np.array([radius])).first[0]) == pytest.approx(slope, rel=1e-7)


@pytest.mark.parametrize("alpha", [0.0, 4e-3])
def test_the_hot_spot_between_unlike_platings_on_a_grid(alpha):
    """On the axis T follows from the share of the cold voltage: theta of both bodies adds up to that of all."""
    plated = [
        wk.Plated(wk.ElectricalConductor(one, alpha), 2e-6, on=wk.ElectricalConductor(other, alpha))
        for one, other in ((1e-6, 2e-8), (2e-8, 1e-6))
    ]
    pair = wk.ElectricalConductors(*plated)
    hot = wk.JouleHeating(wk.Indentation(SPOT, wk.Force(1.0)), pair, wk.Voltage(0.2)).solve()
    share = float(UNLIKE.resistances(np.array([5e-6])).middle[0])
    lorenz, ambient = hot.problem.law.lorenz_number, 293.15
    phi = np.linspace(0.0, 0.2, 200_001)
    temperature = np.sqrt(ambient**2 + phi * (0.2 - phi) / lorenz)
    conducted = np.cumsum(1.0 / (1.0 + alpha * (temperature - ambient)))
    there = int(np.searchsorted(conducted, share * conducted[-1]))
    assert hot.middle_temperature == pytest.approx(temperature[there], rel=2e-5)


def test_conductance_is_in_proportion_to_stiffness_of_bare_bodies_alone():
    """Plated half-spaces resist 4.710e-4 ohm where their stiffness would say 2.386e-4."""
    plated = wk.ElectricalConductors(wk.Plated(BAD, 2e-6, on=GOOD), GOOD)
    rods = wk.ElectricalConductors(wk.Rod(GOOD, 1e-3, 1e-2), wk.Rod(GOOD, 1e-3, 1e-2))
    filmed = wk.ElectricalConductors(GOOD, GOOD, wk.SurfaceFilm(1e-14))
    for pair, said in ((PAIR, True), (UNLIKE, False), (plated, False), (rods, False), (filmed, False)):
        notes = wk.Constriction(wk.Indentation(BALL, wk.Force(1.0)), pair).solve().validity
        assert any("The conductance of the contact is 2 / (E*" in note.statement for note in notes) == said
