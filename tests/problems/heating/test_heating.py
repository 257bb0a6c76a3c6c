"""Frictional heating: the rule for slow sliding, moving bodies, how they share the heat, and heat that begins."""

import math

import numpy as np
import pytest

import winkler as wk
from winkler.reference.heating import disc_centre_rise, hertz_heat_temperature, tian_kennedy_parabolic
from winkler.values.validity import Standing

STEEL, BRONZE, GLASS = wk.Elastic(210e9, 0.3), wk.Elastic(110e9, 0.34), wk.Elastic(70e9, 0.22)
IRON = wk.ThermalConductor(conductivity=45.0, diffusivity=12e-6)
COPPER = wk.ThermalConductor(conductivity=200.0, diffusivity=90e-6)
PAIR = wk.HeatConductors(IRON, COPPER)
ALONE = wk.FixedShare(1.0)
BALL = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace(STEEL, STEEL))
RADIUS = 1e-4


def rubbing(bed=BALL, load=None, conductors=PAIR, **others):
    contact = wk.Indentation(bed, load or wk.Radius(RADIUS))
    return wk.FrictionHeating(contact, wk.Coulomb(0.3), conductors, **others).solve()


def speed_at(peclet, body=IRON, radius=RADIUS):
    return 2.0 * body.diffusivity * peclet / radius


# ------------------------------------------------------------------------------------------------- slow sliding


def test_slow_sliding_follows_the_displacement_of_the_surface():
    slow = rubbing(first_speed=1e-7)
    contact, v = slow.contact, 1e-7
    wanted = 0.3 * v * BALL.medium.modulus * contact.depth / (2.0 * (IRON.conductivity + COPPER.conductivity))
    assert slow.flash_temperature == pytest.approx(wanted, rel=1e-5)
    assert slow.stationary_temperature == pytest.approx(wanted, rel=1e-9)
    assert slow.first_share == pytest.approx(45.0 / 245.0, rel=1e-5)
    r = np.array([0.0, 0.4, 1.0, 1.7]) * RADIUS
    field = 0.3 * v * BALL.medium.modulus / (2.0 * 245.0) * wk.restore(contact, r).displacement
    for body in (slow.first, slow.second):
        np.testing.assert_allclose(body.temperature(r), field, rtol=3e-5)
    assert any("Slow sliding" in note.statement for note in slow.validity)


def test_hertz_heat_is_the_closed_form():
    slow = rubbing(first_speed=1e-7, partition=ALONE)
    r = np.array([0.0, 0.5, 1.0, 2.0]) * RADIUS
    wanted = hertz_heat_temperature(slow.heat_rate, RADIUS, IRON.conductivity, r)
    np.testing.assert_allclose(slow.first.temperature(r), wanted, rtol=1e-5)
    assert slow.first_max_temperature == pytest.approx(3.0 * slow.heat_rate / (8.0 * 45.0 * RADIUS), rel=1e-5)
    assert slow.heat_rate == pytest.approx(0.3 * slow.contact.force * 1e-7, rel=1e-12)


@pytest.mark.parametrize("profile", [wk.Cone(1.45), wk.PowerLaw(1e9, 4.0), wk.Sphere(10e-3), wk.FlatPunch(RADIUS)])
def test_the_rule_holds_for_every_shape(profile):
    bed = wk.Foundation(profile, wk.HalfSpace(STEEL))
    slow = rubbing(bed, wk.Depth(1e-7), first_speed=1e-9)
    r = np.linspace(0.0, 0.99, 12) * slow.contact.radius
    field = 0.3e-9 * bed.medium.modulus / (2.0 * 245.0) * wk.restore(slow.contact, r).displacement
    np.testing.assert_allclose(slow.first.temperature(r), field, rtol=1e-5)
    assert slow.flash_temperature == pytest.approx(np.max(field), rel=1e-5)


def test_bodies_conduct_alike_whatever_layers_do_to_the_pressure():
    """A coating of the substrate's own stiffness changes nothing, though the heat comes from the pressure then."""
    layered = wk.CoatedHalfSpace([wk.Layer(STEEL, 50e-6)], on=STEEL, second=STEEL)
    result = rubbing(wk.Foundation(wk.Paraboloid(10e-3), layered), first_speed=0.24)
    assert result.flash_temperature == pytest.approx(rubbing(first_speed=0.24).flash_temperature, rel=1e-6)


def test_a_graded_body_is_heated_by_its_own_pressure():
    graded = wk.GradedHalfSpace(wk.PowerLawGraded(200e9, 1e-3, 0.2, 0.3))
    bed = wk.Foundation(wk.Paraboloid(10e-3), graded)
    slow = rubbing(bed, first_speed=1e-7, partition=ALONE)
    # the temperature at the centre is the integral of the flux over r, over the conductivity
    node, weight = np.polynomial.legendre.leggauss(60)
    turn = 0.25 * np.pi * (1.0 + node)
    r = RADIUS * np.sin(turn)
    pressure = wk.restore(slow.contact, r).pressure
    wanted = 0.3e-7 / 45.0 * RADIUS * np.sum(0.25 * np.pi * weight * np.cos(turn) * pressure)
    assert slow.first.temperature(0.0) == pytest.approx(wanted, rel=1e-5)


# ------------------------------------------------------------------------------------------------------- motion


@pytest.mark.parametrize(("peclet", "number"), [(0.1, 0.36016), (1.0, 0.279134), (10.0, 0.125456)])
def test_a_moving_body_stays_cooler(peclet, number):
    result = rubbing(first_speed=speed_at(peclet), partition=ALONE)
    assert result.first_peclet == pytest.approx(peclet, rel=1e-12)
    assert result.first_max_temperature * 45.0 * RADIUS / result.heat_rate == pytest.approx(number, rel=4e-6)
    assert result.first.warmest.height == pytest.approx(result.first_max_temperature, rel=1e-12)
    assert result.first.warmest.x > 0.0
    assert result.second_max_temperature == 0.0


def test_the_note_states_the_error_of_the_slow_rule():
    result = rubbing(first_speed=speed_at(1.0), partition=ALONE)
    assert result.overestimate == pytest.approx(0.343, abs=5e-4)
    assert any("34.3 % too high" in note.statement for note in result.validity)


def test_backwards_is_forwards():
    forth, back = rubbing(first_speed=0.5), rubbing(first_speed=-0.5)
    assert back.flash_temperature == forth.flash_temperature
    x = np.array([-0.6, 0.3, 2.0]) * RADIUS
    np.testing.assert_allclose(back.first.temperature(x), forth.first.temperature(-x), rtol=1e-12)


def test_the_estimates_are_near_where_they_hold():
    fast = rubbing(first_speed=speed_at(3000.0), partition=ALONE)
    assert fast.fast_temperature == pytest.approx(fast.flash_temperature, rel=1e-3)
    middle = rubbing(first_speed=speed_at(3.0), partition=ALONE)
    assert middle.tian_kennedy_temperature == pytest.approx(middle.flash_temperature, rel=0.011)
    fit = tian_kennedy_parabolic(middle.heat_rate, RADIUS, 45.0, 3.0)
    assert middle.tian_kennedy_temperature == pytest.approx(float(fit), rel=1e-9)
    punch = rubbing(wk.Foundation(wk.FlatPunch(RADIUS), wk.HalfSpace(STEEL)), wk.Force(10.0), first_speed=0.3)
    assert punch.flash_temperature < punch.stationary_temperature
    assert rubbing(first_speed=1.0, second_speed=1.0).flash_temperature == 0.0


# ------------------------------------------------------------------------------------------------------ sharing


def test_blok_makes_the_greatest_temperatures_equal_and_jaeger_the_means():
    blok, jaeger = (rubbing(first_speed=2.0, partition=rule) for rule in (wk.EqualMaximum(), wk.EqualMean()))
    assert blok.first_max_temperature == pytest.approx(blok.second_max_temperature, rel=1e-12)
    assert jaeger.first_mean_temperature == pytest.approx(jaeger.second_mean_temperature, rel=1e-12)
    assert jaeger.first_max_temperature != pytest.approx(jaeger.second_max_temperature, rel=1e-2)
    alone = [rubbing(first_speed=2.0, partition=wk.FixedShare(share)) for share in (1.0, 0.0)]
    both = 1.0 / (1.0 / alone[0].first_max_temperature + 1.0 / alone[1].second_max_temperature)
    assert blok.flash_temperature == pytest.approx(both, rel=1e-12)
    assert any(
        note.standing is Standing.APPROXIMATE and "mean temperatures differ" in note.statement for note in blok.validity
    )


def test_bodies_that_move_alike_share_by_conductivity():
    """Two bodies that pass at equal speeds in opposite directions: one stands as warm as the other, mirrored."""
    result = rubbing(conductors=wk.HeatConductors(IRON, IRON), first_speed=0.4, second_speed=-0.4)
    assert result.first_share == 0.5
    x = np.array([-0.7, 0.2, 1.5]) * RADIUS
    np.testing.assert_allclose(result.first.temperature(x), result.second.temperature(-x), rtol=1e-12)


def test_without_contact_a_fixed_share_stays_and_others_are_those_of_bodies_at_rest():
    for partition, wanted in ((wk.FixedShare(0.8), 0.8), (wk.EqualMean(), 45.0 / 245.0)):
        apart = rubbing(load=wk.Depth(-1e-6), first_speed=1.0, partition=partition)
        assert apart.first_share == pytest.approx(wanted, rel=1e-12)
        assert apart.flash_temperature == 0.0
        begins = wk.TransientHeating(apart.problem.contact, wk.Coulomb(0.3), PAIR, 1.0, np.ones(1), partition).solve()
        assert begins.first_share == pytest.approx(wanted, rel=1e-12)


# ----------------------------------------------------------------------------------------------- many at a time


def test_many_loads_and_speeds_at_once():
    loads, speeds = np.array([[1.0], [30.0]]), np.array([0.01, 0.3, 5.0])
    many = rubbing(load=wk.Force(loads), first_speed=speeds)
    assert many.flash_temperature.shape == (2, 3)
    for index in ((0, 2), (1, 0)):
        one = rubbing(load=wk.Force(float(loads[index[0], 0])), first_speed=float(speeds[index[1]]))
        picked = many.at(index)
        assert picked.problem == one.problem
        for word in ("flash_temperature", "first_share", "stationary_temperature", "fast_temperature", "heat_rate"):
            assert getattr(many, word)[index] == pytest.approx(getattr(one, word), rel=1e-12)
            assert getattr(picked, word) == pytest.approx(getattr(one, word), rel=1e-12)
    assert len(many.validity) == len(one.validity)
    with pytest.raises(wk.InvalidInput, match="no result"):
        many.at((5, 5))
    with pytest.raises(wk.InvalidInput, match="pick one"):
        _ = many.first


def test_without_a_load_nothing_warms_up():
    result = rubbing(load=wk.Force([0.0, 10.0]), first_speed=1.0)
    assert result.flash_temperature[0] == 0.0
    assert result.overestimate[0] == 0.0
    assert result.at(0).first.temperature(0.0) == 0.0
    assert result.at(0).first.warmest.height == 0.0


def test_scaling():
    """Lengths by s at the same Peclet number, and loads with s^2: temperatures stay times speed times length."""
    small, large = rubbing(first_speed=0.5), None
    bed = wk.Foundation(wk.Paraboloid(30e-3), wk.HalfSpace(STEEL, STEEL))
    large = rubbing(bed, wk.Radius(3.0 * RADIUS), first_speed=0.5 / 3.0)
    assert large.flash_temperature == pytest.approx(small.flash_temperature, rel=1e-9)
    assert large.first_share == pytest.approx(small.first_share, rel=1e-9)


def test_only_a_steady_body_at_rest_needs_no_diffusivity():
    unknown = wk.ThermalConductor(conductivity=COPPER.conductivity)
    law, contact, pair = wk.Coulomb(0.3), wk.Indentation(BALL, wk.Radius(RADIUS)), wk.HeatConductors(IRON, unknown)
    assert wk.FrictionHeating(contact, law, pair, first_speed=1.0).solve().flash_temperature == pytest.approx(
        wk.FrictionHeating(contact, law, PAIR, first_speed=1.0).solve().flash_temperature, rel=1e-15
    )
    plated = wk.HeatConductors(IRON, wk.Plated(COPPER, 1e-6, unknown))
    path = wk.Path.oscillation(force=100.0, amplitude=1e-6, cycles=2)
    for make in (
        lambda: wk.FrictionHeating(contact, law, pair, first_speed=0.0, second_speed=np.array([0.0, 1.0])),
        lambda: wk.FrictionHeating(contact, law, plated, first_speed=0.0, second_speed=1.0),
        lambda: wk.TransientHeating(contact, law, pair, speed=1.0, time=[1.0]),
        lambda: wk.FrettingHeat(wk.Tangential(BALL, law, path), 100.0, pair),
    ):
        with pytest.raises(wk.InvalidInput, match="diffusivity of the second body is infinite, or not given"):
            make()


@pytest.mark.parametrize(
    ("change", "statements"),
    [
        ({"law": wk.Coulomb(math.inf)}, "finite coefficient"),
        ({"law": wk.StaticKinetic(0.4, 0.3)}, "finite coefficient"),
        ({"conductors": IRON}, "give HeatConductors"),
        ({"conductors": wk.HeatConductors(IRON, wk.Rod(IRON, 1e-3, 1e-2))}, "two thick bodies"),
        ({"conductors": wk.HeatConductors(IRON, IRON, wk.ThermalInterface(1e4))}, "leave the interface out"),
        ({"first_speed": math.nan}, "finite numbers in m/s"),
        ({"first_speed": "fast"}, "finite numbers in m/s"),
        ({"first_speed": [1.0, 2.0], "second_speed": [1.0, 2.0, 3.0]}, "do not broadcast"),
        ({"partition": 0.5}, "EqualMaximum"),
        ({"contact": BALL}, "give Indentation"),
        ({"second_direction": 1.0}, "a body at rest has no direction"),
    ],
)
def test_what_is_refused(change, statements):
    given = {
        "contact": wk.Indentation(BALL, wk.Force(1.0)), "law": wk.Coulomb(0.3), "conductors": PAIR, "first_speed": 1.0,
    }  # fmt: skip
    with pytest.raises(wk.InvalidInput, match=statements):
        wk.FrictionHeating(**(given | change))


def test_a_share_lies_between_nothing_and_all():
    with pytest.raises(wk.InvalidInput, match="from 0 to 1"):
        wk.FixedShare(1.5)


# ------------------------------------------------------------------------------------------ heat that begins


def starting(time, **others):
    given = {"conductors": PAIR, "speed": 1e-3, "load": wk.Radius(RADIUS), "bed": BALL} | others
    contact = wk.Indentation(given.pop("bed"), given.pop("load"))
    return wk.TransientHeating(contact, wk.Coulomb(0.3), time=time, **given).solve()


@pytest.mark.slow
def test_a_contact_that_begins_to_rub():
    settling = RADIUS**2 / IRON.diffusivity
    times = settling * np.array([1e-6, 1.0, 1e8])
    start = starting(times, conductors=wk.HeatConductors(IRON, IRON))
    last = rubbing(conductors=wk.HeatConductors(IRON, IRON), first_speed=1e-3).stationary_temperature
    assert start.stationary_temperature == pytest.approx(last, rel=1e-12)
    assert start.flash_temperature[2] == pytest.approx(last, rel=1e-4)
    assert start.first_mean_temperature[2] == pytest.approx(0.75 * last, rel=1e-4)
    peak_flux = 1.5 * start.heat_rate / (math.pi * RADIUS**2)
    early = peak_flux / 2.0 * 2.0 * math.sqrt(IRON.diffusivity * times[0] / math.pi) / IRON.conductivity
    assert start.flash_temperature[0] == pytest.approx(early, rel=1e-3)
    assert np.all(start.first_share == 0.5)
    field = start.first_temperature([0.0, RADIUS])
    assert field.shape == (3, 2)
    np.testing.assert_allclose(field[:, 0], start.flash_temperature, rtol=1e-12)
    np.testing.assert_allclose(start.second_temperature([0.0, RADIUS]), field, rtol=1e-12)


def test_the_share_goes_from_effusivities_to_conductivities():
    start = starting(np.array([1e-9, 1e5]), partition=wk.EqualMean())
    effusivity = [body.conductivity / math.sqrt(body.diffusivity) for body in (IRON, COPPER)]
    assert start.first_share[0] == pytest.approx(effusivity[0] / sum(effusivity), rel=1e-3)
    assert start.first_share[1] == pytest.approx(45.0 / 245.0, rel=1e-4)
    np.testing.assert_allclose(start.first_mean_temperature, start.second_mean_temperature, rtol=1e-12)
    assert any("effusivities" in note.statement for note in start.validity)


def test_a_flat_punch_warms_up_at_its_rim_first():
    punch = starting(
        RADIUS**2 / IRON.diffusivity * np.array([0.01, 1e8]),
        bed=wk.Foundation(wk.FlatPunch(RADIUS), wk.HalfSpace(STEEL)),
        load=wk.Force(10.0),
        partition=ALONE,
    )
    assert punch.flash_temperature[0] > 1.5 * punch.first_temperature(0.0)[0]
    assert punch.flash_temperature[1] == pytest.approx(punch.heat_rate / (4.0 * 45.0 * RADIUS), rel=1e-3)


def test_the_times_of_theory_hold_for_a_uniform_flux():
    assert [round(float(disc_centre_rise(tau)), 3) for tau in (1.0, 10.0, 31.8)] == [0.729, 0.911, 0.950]


def test_sliding_too_fast_for_a_body_at_rest_is_noted():
    fast = starting([1.0], speed=1.0)
    assert any(note.standing is Standing.APPROXIMATE and "overestimated" in note.statement for note in fast.validity)
    still = starting([1.0], speed=0.0)
    assert still.flash_temperature[0] == 0.0
    assert still.validity


@pytest.mark.parametrize(
    ("change", "statements"),
    [
        ({"time": [0.0, 1.0]}, "positive, finite numbers in s"),
        ({"time": "soon"}, "positive, finite numbers in s"),
        ({"speed": -1.0}, "zero or a positive, finite number"),
        ({"load": wk.Force([1.0, 2.0])}, "sweep over several"),
    ],
)
def test_what_a_beginning_refuses(change, statements):
    with pytest.raises(wk.InvalidInput, match=statements):
        starting(**({"time": [1.0]} | change))
