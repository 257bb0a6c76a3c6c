"""Heat of friction on plated bodies: Fourier integrals of the test along the real axis, Hankel's by mpmath, limits."""

import mpmath as mp
import numpy as np
import pytest
from scipy.special import j1

import winkler as wk

COAT, BASE, DEEP = wk.ThermalConductor(2.0, 1e-6), wk.ThermalConductor(45.0, 12e-6), wk.ThermalConductor(0.5, 3e-6)
ELASTIC = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(ELASTIC, ELASTIC)
BALL = wk.Foundation(wk.Paraboloid(10e-3), PAIR)
ROLLER = wk.LineFoundation(wk.Paraboloid(10e-3), PAIR)
A = 1e-4
GAUSS = np.polynomial.legendre.leggauss(20)


def rubbed(first, speed, second=BASE, bed=BALL, **more):
    pair = wk.HeatConductors(first, second)
    return wk.FrictionHeating(
        wk.Indentation(bed, wk.Radius(A)), wk.Coulomb(0.3), pair, first_speed=speed, **more
    ).solve()


def rolled(first, speed=2.0, **more):
    pair = wk.HeatConductors(first, BASE)
    disc = wk.LineIndentation(ROLLER, wk.HalfWidth(A))
    return wk.LineFrictionHeating(disc, wk.Coulomb(0.3), pair, first_speed=speed, second_speed=1.0, **more).solve()


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


STACK = ((COAT, 0.2 * A), (DEEP, 0.1 * A))


@pytest.mark.slow
def test_a_ball_that_slides_over_two_platings_warms_them_by_a_double_fourier_integral():
    """Greatest and mean temperature under Hertz' flux."""
    body = wk.Plated(COAT, STACK[0][1], wk.Plated(DEEP, STACK[1][1], BASE))
    fixed, speed = wk.FixedShare(1.0), 0.5
    found = rubbed(body, speed, partition=fixed)
    k, dk = composed(np.concatenate([[1e-9], np.geomspace(1e-8, 0.4, 20), np.arange(1.0, 80.0, 2.0), [80.0]]))
    turn = np.concatenate([np.linspace(0.0, 1.4, 5), 0.5 * np.pi - np.geomspace(0.15, 1e-4, 6), [0.5 * np.pi]])
    angle, share = composed(turn)
    flux = 3.0 * (np.sin(k) - k * np.cos(k)) / k**3
    # over the top plating's own body, whose temperature the package knows without layers
    top = rubbed(COAT, speed, partition=fixed)
    x = found.first.warmest.x / A
    point = mean = 0.0
    for theta, weight in zip(angle, share, strict=True):
        wave = k / A
        rate = wave * np.cos(theta) * speed
        extra = (impedance(wave, rate, STACK, BASE) - impedance(wave, rate, (), COAT)) * flux * k * dk
        point += 2.0 * weight * np.sum((extra * np.cos(k * x * np.cos(theta)) * 1.0).real)
        point -= 2.0 * weight * np.sum((extra * np.sin(k * x * np.cos(theta))).imag)
        mean += 2.0 * weight * np.sum((extra * 2.0 * j1(k) / k).real)
    heat = found.heat_rate / (2.0 * np.pi**2 * A**2)
    wanted = top.first.temperature(x * A) + heat * point
    assert found.first_max_temperature == pytest.approx(float(wanted), rel=1e-8)
    assert found.first_mean_temperature == pytest.approx(top.first_mean_temperature + heat * mean, rel=1e-8)
    assert found.first.warmest.height == pytest.approx(found.first_max_temperature, rel=1e-12)


@pytest.mark.parametrize("part", [0.3, 3.0])
def test_at_rest_the_middle_is_as_warm_as_a_hankel_integral_says(part):
    thickness, ratio = mp.mpf(part), mp.mpf(43) / mp.mpf(47)

    def extra(k):
        echo = -ratio * mp.e ** (-2 * k * thickness)
        return 3 * (mp.sin(k) - k * mp.cos(k)) / k**3 * 2 * echo / (1 - echo)

    whole = mp.mpf(3) / 8 + mp.quad(extra, [0, 1, 3, 6, 10, 15, 22, 30, mp.inf]) / (2 * mp.pi)
    found = rubbed(wk.Plated(COAT, part * A, BASE), 0.0, second_speed=1e-9, partition=wk.FixedShare(1.0))
    assert found.first_max_temperature == pytest.approx(float(whole) * found.heat_rate / (2.0 * A), rel=1e-9)


def test_a_band_over_platings_is_a_fourier_integral():
    body, fixed = wk.Plated(COAT, STACK[0][1], wk.Plated(DEEP, STACK[1][1], BASE)), wk.FixedShare(1.0)
    found, top = rolled(body, partition=fixed), rolled(COAT, partition=fixed)
    k, dk = composed(np.concatenate([[1e-20], np.geomspace(1e-19, 0.4, 90), np.arange(1.0, 100.0, 2.0)]))
    wave, x = k / A, found.first.warmest.x / A
    extra = (impedance(wave, 2.0 * wave, STACK, BASE) - impedance(wave, 2.0 * wave, (), COAT)) * 2.0 * j1(k) / k * dk
    heat = found.heat_per_length / (np.pi * A)
    wanted = top.first.temperature(x * A) + heat * np.sum((extra * np.exp(1j * k * x)).real)
    assert found.first_max_temperature == pytest.approx(float(wanted), rel=1e-8)
    wanted = top.first_mean_temperature + heat * np.sum((extra * np.sin(k) / k).real)
    assert found.first_mean_temperature == pytest.approx(wanted, rel=1e-8)
    assert found.first.warmest.height == pytest.approx(found.first_max_temperature, rel=1e-10)


@pytest.mark.few(1)
@pytest.mark.parametrize("solve", [rubbed, rolled])
def test_layers_of_one_conductor_and_thick_and_thin_ones(solve):
    plain, coat = solve(BASE, 2.0), solve(COAT, 2.0)
    assert solve(wk.Plated(BASE, 0.1 * A, BASE), 2.0).flash_temperature == plain.flash_temperature
    two = solve(wk.Plated(COAT, 0.1 * A, wk.Plated(COAT, 0.1 * A, BASE)), 2.0)
    one = solve(wk.Plated(COAT, 0.2 * A, BASE), 2.0)
    assert two.flash_temperature == pytest.approx(one.flash_temperature, rel=1e-9)
    thick = solve(wk.Plated(COAT, 50.0 * A, BASE), 2.0)
    assert thick.flash_temperature == pytest.approx(coat.flash_temperature, rel=1e-8)
    # a thin layer adds its resistance, flux times thickness over conductivity: errors fall with the thickness
    errors = [
        abs(solve(wk.Plated(COAT, part * A, BASE), 2.0).flash_temperature / plain.flash_temperature - 1.0)
        for part in (1e-4, 1e-6)
    ]
    assert 0.0 < errors[1] < 1e-4
    assert errors[0] == pytest.approx(100.0 * errors[1], rel=0.05)


def test_bodies_share_the_heat_by_the_rules_of_blok_and_jaeger():
    body = wk.Plated(COAT, 0.1 * A, BASE)
    blok, jaeger = rubbed(body, 1.0), rubbed(body, 1.0, partition=wk.EqualMean())
    assert blok.first_max_temperature == pytest.approx(blok.second_max_temperature, rel=1e-12)
    assert jaeger.first_mean_temperature == pytest.approx(jaeger.second_mean_temperature, rel=1e-12)
    alone = rubbed(body, 1.0, partition=wk.FixedShare(1.0))
    assert blok.first_max_temperature == pytest.approx(blok.first_share * alone.first_max_temperature, rel=1e-12)
    back = rubbed(body, -1.0)
    assert back.flash_temperature == pytest.approx(blok.flash_temperature, rel=1e-10)
    assert back.first.warmest.x == pytest.approx(-blok.first.warmest.x, rel=1e-3)
    assert blok.first_peclet == pytest.approx(0.5 * A / COAT.diffusivity)  # of the slower conductor


def test_what_follows_no_platings_says_so():
    pair = wk.HeatConductors(wk.Plated(COAT, A, BASE), BASE)
    with pytest.raises(wk.InvalidInput, match="TransientHeating: the bodies are Plated and ThermalConductor"):
        wk.TransientHeating(wk.Indentation(BALL, wk.Radius(A)), wk.Coulomb(0.3), pair, speed=0.1, time=[1.0])
    with pytest.raises(wk.InvalidInput, match="or Plated made of it"):
        wk.FrictionHeating(
            wk.Indentation(BALL, wk.Radius(A)), wk.Coulomb(0.3), wk.HeatConductors(BASE, wk.Rod(BASE, 1.0, 1.0)), 1.0
        )
