"""Ellipses that are plated, and ellipses that begin to rub: Fourier integrals and sums of point sources of the test."""

import math

import numpy as np
import pytest
from scipy.special import erfc, j1

import winkler as wk
from winkler.numerics.fields.elliptic_source import EllipticSource

COAT, STEEL = wk.ThermalConductor(2.0, 1e-6), wk.ThermalConductor(45.0, 12e-6)
ELASTIC = wk.Elastic(210e9, 0.3)
MEDIUM, LAW, LOAD, ALONE = wk.HalfSpace.between(ELASTIC, ELASTIC), wk.Coulomb(0.1), wk.Force(200.0), wk.FixedShare(1.0)
GAUSS = np.polynomial.legendre.leggauss(24)


def pressed(radii):
    return wk.EllipticIndentation(wk.CurvedBodies(*radii), MEDIUM, LOAD)


def axes_of(contact):
    solved = contact.solve()
    return solved.longitudinal_semi_axis, solved.lateral_semi_axis


def composed(cuts):
    cuts = np.asarray(cuts)
    low, width = cuts[:-1, None], np.diff(cuts)[:, None]
    return (low + 0.5 * width * (GAUSS[0] + 1.0)).ravel(), (0.5 * width * GAUSS[1]).ravel()


def impedance(k, rate, layers, base):
    """Surface temperature over flux: layers in turn by hyperbolic functions, from below."""
    below = 1.0 / (base.conductivity * np.sqrt(k**2 + 1j * rate / base.diffusivity))
    for body, thickness in reversed(layers):
        decay = np.sqrt(k**2 + 1j * rate / body.diffusivity)
        own, through = 1.0 / (body.conductivity * decay), np.tanh(decay * thickness)
        below = own * (below + own * through) / (own + below * through)
    return below


def plated_less_coat(axes, place, speed, angle, thickness):
    """How much warmer than all of the coat a plated body is at a place and in the mean, over the heat."""
    across = (angle + 0.5 * math.pi) % math.pi
    near = [across + sign * gap for gap in np.geomspace(1e-5, 0.3, 9) for sign in (1.0, -1.0)]
    turn, share = composed(sorted({*np.linspace(0.0, math.pi, 33), *(cut for cut in near if 0.0 < cut < math.pi)}))
    size = max(axes)
    part, weight = composed([1e-9, *np.geomspace(1e-8, 0.3, 20), *np.arange(0.6, 90.0, 0.8)])
    k, point, mean = part / size, 0.0, 0.0
    for theta, dtheta in zip(turn, share, strict=True):
        seen = k * math.hypot(axes[0] * math.cos(theta), axes[1] * math.sin(theta))
        flux = 3.0 * (np.sin(seen) - seen * np.cos(seen)) / seen**3
        rate = k * speed * math.cos(theta - angle)
        plated = impedance(k, rate, [(COAT, thickness)], STEEL) - impedance(k, rate, [], COAT)
        extra = plated * flux * k * weight / size * dtheta
        wave = np.exp(1j * k * (place[0] * math.cos(theta) + place[1] * math.sin(theta)))
        point += 2.0 * np.sum((extra * wave).real)
        mean += 2.0 * np.sum((extra * 2.0 * j1(seen) / seen).real)
    return point / (2.0 * math.pi) ** 2, mean / (2.0 * math.pi) ** 2


@pytest.mark.slow
@pytest.mark.parametrize(
    ("radii", "speed", "angle"),
    [((5e-3, 5e-3), 0.5, 0.4), ((5e-3, 20e-3), 0.02, 0.5), ((20e-3, 5e-3), -0.3, 1.1), ((5e-3, 20e-3), 0.0, 0.0)],
)
def test_a_plated_ellipse_is_warmed_by_a_double_fourier_integral(radii, speed, angle):
    contact = pressed(radii)
    axes, rests = axes_of(contact), {"second_speed": 1e-9} if speed == 0.0 else {}
    thickness = 0.3 * min(axes)
    pair = wk.HeatConductors(wk.Plated(COAT, thickness, STEEL), STEEL)
    found = wk.FrictionHeating(contact, LAW, pair, speed, first_direction=angle, partition=ALONE, **rests).solve()
    warmest = found.first.warmest
    point, mean = plated_less_coat(axes, (warmest.x, warmest.y), speed, angle, thickness)
    bare, wave = EllipticSource(*axes), speed / COAT.diffusivity
    under = bare.surface(wave, np.array([warmest.x]), np.array([warmest.y]), angle)[0] / COAT.conductivity
    assert found.first_max_temperature == pytest.approx(found.heat_rate * (under + point), rel=2e-8)
    average = bare.mean(wave, angle) / COAT.conductivity
    assert found.first_mean_temperature == pytest.approx(found.heat_rate * (average + mean), rel=2e-8)
    rng = np.random.default_rng(3)
    reach, turn = np.sqrt(rng.random(60)), 2.0 * np.pi * rng.random(60)
    around = found.first.temperature(axes[0] * reach * np.cos(turn), axes[1] * reach * np.sin(turn))
    assert np.max(around) < found.first_max_temperature


def test_a_plated_ellipse_of_equal_curvatures_is_the_plated_ball():
    pair = wk.HeatConductors(wk.Plated(COAT, 1e-5, STEEL), STEEL)
    circle = wk.FrictionHeating(pressed((5e-3, 5e-3)), LAW, pair, 0.5, first_direction=0.8).solve()
    ball = wk.Indentation(wk.Foundation(wk.Paraboloid(5e-3), MEDIUM), LOAD)
    for angle in (0.0, 2.0):
        round_one = wk.FrictionHeating(ball, LAW, pair, 0.5, first_direction=angle).solve()
        for name in ("first_share", "flash_temperature", "first_mean_temperature"):
            assert getattr(circle, name) == pytest.approx(getattr(round_one, name), rel=2e-7), name
        # of the ball it is that at V a / kappa = 1e6, within about 1e-6 of the limit
        assert circle.fast_temperature == pytest.approx(round_one.fast_temperature, rel=3e-6)
        warmest = round_one.first.warmest
        assert warmest.y == pytest.approx(math.tan(angle) * warmest.x, abs=1e-12)
        places = warmest.x * np.array([1.0, -2.0, 4.0]), warmest.y * np.array([1.0, -2.0, 4.0])
        turned = math.cos(0.8 - angle), math.sin(0.8 - angle)
        there = places[0] * turned[0] - places[1] * turned[1], places[0] * turned[1] + places[1] * turned[0]
        assert circle.first.temperature(*there) == pytest.approx(round_one.first.temperature(*places), rel=1e-7)


def test_pixels_take_no_platings():
    medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(21e9, 0.3), 5e-5)], on=ELASTIC, second=ELASTIC)
    contact = wk.EllipticIndentation(wk.CurvedBodies(5e-3, 8e-3), medium, LOAD)
    pair = wk.HeatConductors(wk.Plated(COAT, 1e-5, STEEL), STEEL)
    with pytest.raises(wk.OutsideValidity, match="plated conductors are not implemented"):
        wk.FrictionHeating(contact, LAW, pair, 0.5).solve()
    with pytest.raises(wk.OutsideValidity, match="an ellipse on layers or graded bodies is not implemented"):
        wk.TransientHeating(contact, LAW, wk.HeatConductors(STEEL, STEEL), 0.5, [1.0])


def grown(axes, length, x, y):
    """Point sources erfc(r/(2 l))/(2 pi r) by polar coordinates about a place within the ellipse."""
    a, b = axes
    turn = 2.0 * np.pi * (np.arange(240) + 0.5) / 240
    node, weight = np.polynomial.legendre.leggauss(200)
    cos, sin = np.cos(turn)[:, None], np.sin(turn)[:, None]
    square, mixed = (cos / a) ** 2 + (sin / b) ** 2, x * cos / a**2 + y * sin / b**2
    far = (-mixed + np.sqrt(mixed**2 + square * (1.0 - (x / a) ** 2 - (y / b) ** 2))) / square
    u = 0.25 * np.pi * (node + 1.0)
    r = far * np.sin(u)
    flux = 1.5 / (np.pi * a * b) * np.sqrt(np.maximum(1.0 - ((x + r * cos) / a) ** 2 - ((y + r * sin) / b) ** 2, 0.0))
    return float(np.mean(np.sum(flux * erfc(0.5 * r / length) * far * np.cos(u) * 0.25 * np.pi * weight, axis=1)))


@pytest.mark.parametrize("radii", [(5e-3, 15e-3), (20e-3, 5e-3)])
def test_an_ellipse_that_begins_to_rub_is_a_sum_of_point_sources(radii):
    contact, brass = pressed(radii), wk.ThermalConductor(110.0, 34e-6)
    axes = axes_of(contact)
    times = min(axes) ** 2 / STEEL.diffusivity * np.array([1e-2, 1.0, 30.0])
    start = wk.TransientHeating(contact, LAW, wk.HeatConductors(STEEL, brass), 1e-3, times).solve()
    places = np.array([0.0, 0.5, -0.6]) * axes[0], np.array([0.0, -0.3, 0.7]) * axes[1]
    for body, share, field in (
        (STEEL, start.first_share, start.first_temperature(*places)),
        (brass, 1.0 - start.first_share, start.second_temperature(*places)),
    ):
        for row, time, part in zip(field, times, share, strict=True):
            length = math.sqrt(body.diffusivity * time)
            wanted = [
                grown(axes, length, *place) * part * start.heat_rate / body.conductivity
                for place in zip(*places, strict=True)
            ]
            assert row == pytest.approx(wanted, rel=1e-9)
    assert start.flash_temperature == pytest.approx(start.first_temperature(0.0), rel=1e-12)
    assert start.first_max_temperature == pytest.approx(start.second_max_temperature, rel=1e-12)


def test_the_mean_and_the_end_of_an_ellipse_that_begins_to_rub():
    contact, pair = pressed((5e-3, 15e-3)), wk.HeatConductors(STEEL, STEEL)
    axes, time = axes_of(contact), np.array([1e-3, 1e4])
    start = wk.TransientHeating(contact, LAW, pair, 1e-3, time).solve()
    slow = wk.FrictionHeating(contact, LAW, pair, 1e-3).solve()
    assert start.flash_temperature[1] == pytest.approx(slow.stationary_temperature, rel=1e-3)
    assert start.first_mean_temperature[1] == pytest.approx(0.75 * slow.stationary_temperature, rel=1e-3)
    assert start.stationary_temperature == pytest.approx(slow.stationary_temperature, rel=1e-12)
    radius, turn = 0.5 * (GAUSS[0] + 1.0), 2.0 * np.pi * (np.arange(32) + 0.5) / 32
    x, y = (axis * radius[:, None] * each(turn) for axis, each in zip(axes, (np.cos, np.sin), strict=True))
    mean = np.sum(start.first_temperature(x, y)[0] * (radius * GAUSS[1])[:, None]) / 32
    assert start.first_mean_temperature[0] == pytest.approx(mean, rel=1e-6)


def test_a_ball_that_slides_at_an_angle_is_turned():
    """Round contacts take directions, too: the heat of both velocities, and a wake that lies where a surface goes."""
    ball = wk.Indentation(wk.Foundation(wk.Paraboloid(5e-3), MEDIUM), LOAD)
    pair = wk.HeatConductors(STEEL, STEEL)
    along = wk.FrictionHeating(ball, LAW, pair, 2.0).solve()
    askew = wk.FrictionHeating(ball, LAW, pair, 2.0, first_direction=0.7).solve()
    assert askew.flash_temperature == along.flash_temperature
    x, y = np.array([1e-4, -1e-4, 2e-4]), np.array([0.0, 5e-5, -1e-4])
    turned = x * math.cos(0.7) - y * math.sin(0.7), x * math.sin(0.7) + y * math.cos(0.7)
    assert askew.first.temperature(*turned) == pytest.approx(along.first.temperature(x, y), rel=1e-9)
    crossed = wk.FrictionHeating(ball, LAW, pair, 3.0, 4.0, second_direction=0.5 * math.pi).solve()
    assert crossed.heat_rate == pytest.approx(0.1 * 200.0 * 5.0, rel=1e-14)
