"""The temperature under round sources of heat: against closed forms, and against sums of point sources."""

import numpy as np
import pytest
from scipy import integrate, special

from winkler.numerics.fields.round_source import line_source, projected
from winkler.reference.heating import (
    disc_centre_rise,
    fast_uniform_maximum,
    tian_kennedy_parabolic,
    tian_kennedy_uniform,
)

HERTZ = line_source(lambda x: 0.75 * (1.0 - x**2), [], 1.0)
UNIFORM = line_source(lambda x: 2.0 / np.pi * np.sqrt(np.maximum(1.0 - x**2, 0.0)), [], 1.0)
RING = line_source(
    lambda x: 2.0 / np.pi / 0.19 * (np.sqrt(np.maximum(1.0 - x**2, 0.0)) - np.sqrt(np.maximum(0.81 - x**2, 0.0))),
    [0.9],
    1.0,
)
"""Heat of 1 W on a disc of 1 m: under Hertz' pressure, uniform, and on the ring beyond 0.9 alone."""


def hertz_flux(r):
    return 1.5 / np.pi * np.sqrt(np.maximum(1.0 - r**2, 0.0))


def point_sources(flux, wave, x, y, count=160):
    """Sum point sources in polar coordinates about the place, where the kernel is smooth: all chords of the disc."""
    node, weight = np.polynomial.legendre.leggauss(count)
    part = 0.5 * (1.0 - np.cos(0.5 * np.pi * (1.0 + node)))
    weights = 0.5 * weight * 0.5 * np.pi * np.sin(0.5 * np.pi * (1.0 + node))
    rho = np.hypot(x, y)
    if rho < 1.0:
        turn, share = np.pi * (1.0 + node), np.pi * weight
    else:  # only these directions meet the disc; the chords end like a root
        observed = np.arcsin(1.0 / rho)
        turn, share = np.arctan2(y, x) + observed * (2.0 * part - 1.0), 2.0 * observed * weights
    ahead, across = np.cos(turn), np.sin(turn)
    # the chord from (x, y) backwards along (cos, sin): R from first to last
    middle = x * ahead + y * across
    half = np.sqrt(np.maximum(middle**2 + 1.0 - x**2 - y**2, 0.0))
    first, last = np.maximum(middle - half, 0.0), np.maximum(middle + half, 0.0)
    # the flux ends like a root at the edge of the disc: the cosine makes it smooth
    away = first[:, None] + (last - first)[:, None] * part
    r = np.hypot(x - away * ahead[:, None], y - away * across[:, None])
    kernel = flux(r) * np.exp(-0.5 * wave * away * (1.0 - ahead[:, None]))
    return float(share @ ((last - first) * (kernel @ weights))) / (2.0 * np.pi)


def transform_at_centre(wave):
    """Sum plane waves instead: the transform of the flux over sqrt(k^2 + i k_x V/kappa), at the centre."""

    def spectrum(k):
        return 3.0 * (np.sin(k) - k * np.cos(k)) / k**3

    turns, share = np.polynomial.legendre.leggauss(60)
    waves = wave * np.sin(0.25 * np.pi * (1.0 + turns))  # cos(theta) over a quarter

    def over_angles(k):
        return float(np.sum(0.25 * np.pi * share * np.real(1.0 / np.sqrt(1.0 + 1j * waves / k))))

    head = integrate.quad(lambda k: spectrum(k) * over_angles(k), 1e-9, 400.0, limit=4000, epsabs=1e-11)[0]
    # beyond, 3 cos(k)/k^2 times a constant; what is left out is of the order of 400^-3
    return (head + 3.0 * np.sin(400.0) / 400.0**2 * 0.5 * np.pi) * 4.0 / (4.0 * np.pi**2)


@pytest.mark.parametrize("source", [HERTZ, UNIFORM, RING], ids=["hertz", "uniform", "ring"])
def test_heat_is_the_integral(source):
    assert source.heat == pytest.approx(1.0, rel=1e-12)


def test_a_source_at_rest_is_the_closed_form():
    r = np.array([0.0, 0.3, 0.9, 1.0])
    np.testing.assert_allclose(HERTZ.surface(0.0, r, 0.0 * r), 3.0 / 16.0 * (2.0 - r**2), rtol=1e-10)
    np.testing.assert_allclose(UNIFORM.surface(0.0, r, 0.0 * r), 2.0 / np.pi**2 * special.ellipe(r**2), rtol=1e-10)
    assert UNIFORM.mean(0.0) == pytest.approx(8.0 / (3.0 * np.pi**2), rel=1e-9)
    assert HERTZ.mean(0.0) == pytest.approx(9.0 / 32.0, rel=1e-9)


@pytest.mark.parametrize(
    ("source", "peclet", "published"),
    [
        (HERTZ, 0.1, 0.36016),
        (HERTZ, 1.0, 0.279134),
        (HERTZ, 10.0, 0.125456),
        (UNIFORM, 0.1, 0.303815),
        (UNIFORM, 1.0, 0.233144),
        (UNIFORM, 10.0, 0.10771),
    ],
)
def test_the_greatest_temperature_of_a_moving_source(source, peclet, published):
    assert source.peak(2.0 * peclet).height == pytest.approx(published, rel=6e-6)


@pytest.mark.parametrize(
    ("source", "excess"),
    [
        (HERTZ, {0.01: 0.42, 0.05: 2.1, 0.1: 4.1, 0.5: 18.7, 1.0: 34.3, 5.0: 122.0, 10.0: 199.0}),
        (UNIFORM, {0.01: 0.50, 0.05: 2.4, 0.1: 4.8, 0.5: 20.7, 1.0: 36.5, 5.0: 121.0, 10.0: 196.0}),
    ],
    ids=["hertz", "uniform"],
)
def test_how_far_the_rule_for_rest_is_too_high(source, excess):
    for peclet, percent in excess.items():
        found = 100.0 * (source.peak(0.0).height / source.peak(2.0 * peclet).height - 1.0)
        assert found == pytest.approx(percent, abs=0.6 * 10.0 ** (np.floor(np.log10(percent)) - 1))


@pytest.mark.parametrize("wave", [0.2, 2.0, 20.0])
@pytest.mark.parametrize("place", [(0.0, 0.0), (0.28, 0.0), (-0.7, 0.2), (0.5, -0.6), (1.5, 0.4), (-1.2, 0.0)])
def test_a_moving_source_is_a_sum_of_point_sources(wave, place):
    x, y = np.array([place[0]]), np.array([place[1]])
    wanted = point_sources(hertz_flux, wave, *place)
    assert HERTZ.surface(wave, x, y)[0] == pytest.approx(wanted, rel=2e-8, abs=1e-10)  # upstream it is a difference


@pytest.mark.parametrize(
    "place",
    [
        (0.65, 0.0),
        (0.2, 0.5),
        pytest.param((-0.5, -0.7), marks=pytest.mark.slow),
        pytest.param((0.9, 0.0), marks=pytest.mark.slow),
    ],
)
def test_a_fast_source_is_a_sum_of_point_sources_too(place):
    x, y = np.array([place[0]]), np.array([place[1]])
    wanted = point_sources(hertz_flux, 200.0, *place, count=300)
    assert HERTZ.surface(200.0, x, y)[0] == pytest.approx(wanted, rel=2e-6)


def test_a_moving_source_is_a_sum_of_plane_waves():
    assert HERTZ.surface(2.0, np.zeros(1), np.zeros(1))[0] == pytest.approx(transform_at_centre(2.0), rel=1e-6)


@pytest.mark.slow
def test_the_mean_is_that_of_the_field():
    node, weight = np.polynomial.legendre.leggauss(24)
    r, turn = 0.5 * (1.0 + node), 0.5 * np.pi * (1.0 + node)
    field = HERTZ.surface(6.0, np.outer(r, np.cos(turn)), np.outer(r, np.sin(turn)))
    mean = 2.0 / np.pi * np.einsum("i,j,ij->", 0.5 * weight * r, 0.5 * np.pi * weight, field)
    assert HERTZ.mean(6.0) == pytest.approx(mean, rel=1e-6)


def test_what_goes_where_does_not_matter_to_the_mean():
    """Betti's theorem of heat: source A warms B's disc as B's source warms A's, and conversely."""
    node, weight = np.polynomial.legendre.leggauss(24)
    r, turn = np.sin(0.25 * np.pi * (1.0 + node)), 0.5 * np.pi * (1.0 + node)
    x, y = np.outer(r, np.cos(turn)), np.outer(r, np.sin(turn))
    area = 2.0 * np.outer(0.25 * np.pi * weight * np.sqrt(1.0 - r**2) * r, 0.5 * np.pi * weight)
    there = np.sum(area * hertz_flux(r)[:, None] * UNIFORM.surface(-3.0, x, y))
    assert HERTZ.mean(3.0) == pytest.approx(there, rel=1e-7)


def test_backwards_is_the_mirror_image():
    x, y = np.array([0.3, -0.8, 1.4]), np.array([0.1, -0.2, 0.5])
    np.testing.assert_allclose(HERTZ.surface(-4.0, x, y), HERTZ.surface(4.0, -x, y), rtol=1e-13)
    assert HERTZ.peak(-4.0).x == pytest.approx(-HERTZ.peak(4.0).x, rel=1e-9)


def test_the_fits_of_tian_and_kennedy_are_as_good_as_stated():
    peclet = np.geomspace(0.01, 100.0, 9)
    hertz, uniform = ([source.peak(2.0 * each).height for each in peclet] for source in (HERTZ, UNIFORM))
    apart = [np.max(np.abs(fit(1.0, 1.0, 1.0, peclet) / own - 1.0)) for fit, own in
             ((tian_kennedy_parabolic, hertz), (tian_kennedy_uniform, uniform))]  # fmt: skip
    assert apart[0] < 0.011
    assert apart[1] < 0.023


def test_a_fast_source_is_a_plane_one():
    assert UNIFORM.peak(2e4).height == pytest.approx(float(fast_uniform_maximum(1.0, 1.0, 1.0, 1e4)), rel=2e-3)
    wake = UNIFORM.surface(2e4, np.array([0.5]), np.zeros(1))[0]
    assert wake == pytest.approx(2.0 / np.pi * np.sqrt(1.5 / 2e4 / np.pi), rel=1e-3)


@pytest.mark.slow
def test_a_ring_is_warmest_beside_its_middle():
    peak = RING.peak(20.0)
    assert peak.y > 0.5
    turn = np.linspace(0.0, np.pi, 61)
    for radius in (0.9, 0.95, 1.0):
        assert np.all(RING.surface(20.0, radius * np.cos(turn), radius * np.sin(turn)) <= peak.height * (1.0 + 1e-7))
    assert not RING.fading
    assert HERTZ.fading


def test_a_centred_flux_is_warmest_on_its_middle_line():
    x, y = np.meshgrid(np.linspace(-1.0, 1.0, 15), np.linspace(0.05, 1.0, 8))
    inside = np.hypot(x, y) < 1.0
    assert np.all(HERTZ.surface(3.0, x[inside], y[inside]) < HERTZ.peak(3.0).height)


def test_a_disc_that_was_switched_on():
    for fourier, known in ((1.0, 0.729), (10.0, 0.911), (31.8, 0.950)):
        grown = UNIFORM.risen(np.sqrt(fourier), np.zeros(1))[0] * np.pi
        assert grown == pytest.approx(float(disc_centre_rise(fourier)), rel=1e-10)
        assert grown == pytest.approx(known, abs=5e-4)


@pytest.mark.parametrize("length", [1e-3, 0.1, 1.0, 30.0])
def test_hertz_heat_that_was_switched_on(length):
    """At the centre every ring is as far away from it: erfc of that distance."""
    wanted, _ = integrate.quad(
        lambda r: 1.5 / np.pi * np.sqrt(1.0 - r * r) * special.erfc(0.5 * r / length), 0.0, 1.0, epsabs=1e-13,
        points=[min(3.0 * length, 0.5)],
    )  # fmt: skip
    assert HERTZ.risen(length, np.zeros(1))[0] == pytest.approx(wanted, rel=1e-9)


def test_switched_on_for_long_is_at_rest_and_for_short_is_a_plane():
    r = np.array([0.0, 0.5, 0.95])
    np.testing.assert_allclose(HERTZ.risen(1e6, r), HERTZ.surface(0.0, r, 0.0 * r), rtol=2e-6)
    np.testing.assert_allclose(HERTZ.risen(1e-3, r[:2]), 2e-3 / np.sqrt(np.pi) * hertz_flux(r[:2]), rtol=1e-4)
    assert HERTZ.risen_mean(1e6) == pytest.approx(HERTZ.mean(0.0), rel=2e-6)
    node, weight = np.polynomial.legendre.leggauss(30)
    inside = 0.5 * (1.0 + node)
    assert HERTZ.risen_mean(0.7) == pytest.approx(
        2.0 * np.sum(0.5 * weight * inside * HERTZ.risen(0.7, inside)), rel=1e-6
    )


def test_a_flux_is_projected():
    uniform = projected(lambda r: np.full(r.shape, 1.0 / np.pi), [], 1.0)
    x = np.linspace(0.0, 1.0, 11)
    np.testing.assert_allclose(uniform.load(x), 2.0 / np.pi * np.sqrt(1.0 - x**2), rtol=1e-9, atol=1e-9)
    assert projected(lambda r: np.where(r > 0.9, 1.0 / (0.19 * np.pi), 0.0), [0.9], 1.0).heat == pytest.approx(
        1.0, rel=1e-9
    )
    sharp = projected(lambda r: 0.5 / np.pi / np.sqrt(1.0 - r**2), [], 1.0)
    np.testing.assert_allclose(sharp.load(x), 0.5, rtol=1e-9)


@pytest.mark.parametrize("length", [1e-3, 0.05, 1.0, 1e3])
@pytest.mark.parametrize("source", [HERTZ, UNIFORM, RING], ids=["Hertz", "uniform", "ring"])
def test_the_warmest_circle_is_that_of_all(source, length):
    """A table of a few digits chooses; the number is computed in full."""
    circles = np.sin(np.linspace(0.0, 0.5 * np.pi, 33))
    assert source.warmest(length, circles) == pytest.approx(np.max(source.risen(length, circles)), rel=1e-14)


def overlap_transform(order, power):
    """Return the integral of k^(-power) J_order(k) J_1(k), the critical case of Weber and Schafheitlin."""
    doubled = (order + 2.0 - power, power + order, order + 2.0 + power, 2.0 - order + power)
    first, *others = (special.loggamma(0.5 * part) for part in doubled)
    return special.loggamma(power) + first - power * np.log(2.0) - sum(others)


def transformed_mean(order, wave):
    """Return the mean by plane waves, J_order(k)/k^order times J_1(k)/k, as an integral of Mellin and Barnes."""
    scale = {1.0: 4.0, 1.5: 6.0 * np.sqrt(0.5 * np.pi)}[order]
    s = 0.125 + 1j * np.linspace(-40.0, 40.0, 4001)
    turned = special.loggamma(s) + special.loggamma(0.25 - s) + special.loggamma(0.75 - s) - special.loggamma(1.0 - s)
    whole = np.exp(turned + overlap_transform(order, order + 1.0 - 2.0 * s) - 2.0 * s * np.log(wave)).real
    step = 80.0 / 4000
    return scale * np.sum(whole) * step / (4.0 * np.pi**2) / (special.gamma(0.25) * special.gamma(0.75))


@pytest.mark.parametrize("wave", [1e-2, 20.0, 2e5, 8e7, 1e12])
def test_the_mean_is_a_closed_integral_at_all_speeds(wave):
    assert UNIFORM.mean(wave) == pytest.approx(transformed_mean(1.0, wave), rel=2e-10)
    assert HERTZ.mean(wave) == pytest.approx(transformed_mean(1.5, wave), rel=2e-10)


def test_the_mean_of_a_fast_disc_is_that_of_plane_flow():
    """Uniform heat, no conduction along the surface: 2 q/lambda sqrt(kappa l / pi V) a length l behind the edge."""
    wave, (node, weight) = 1e12, np.polynomial.legendre.leggauss(200)
    half = np.sin(0.25 * np.pi * (1.0 + node))  # of the chord, which is 2 cos of the angle long
    cosine = np.sqrt(1.0 - half**2)
    chords = 0.5 * np.pi * np.sum(weight * cosine * (2.0 * cosine) ** 1.5 * 2.0 / 3.0) / np.pi
    plane = 2.0 / np.pi * np.sqrt(1.0 / (np.pi * wave)) * chords
    assert UNIFORM.mean(wave) == pytest.approx(plane, rel=1e-9)
    ring = RING.mean(wave) * np.sqrt(wave)
    assert ring == pytest.approx(RING.mean(1e14) * 1e7, rel=1e-9)
