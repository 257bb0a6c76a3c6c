"""An even band of heat: Jaeger's closed form by mpmath, the limits of fast and slow bodies, shares of two bodies."""

import numpy as np
import pytest
from mpmath import mp, mpf

import winkler as wk

STEEL = wk.ThermalConductor(45.0, 12e-6)
BRASS = wk.ThermalConductor(110.0, 34e-6)
FLUX, HALF_WIDTH = 100e6, 0.1e-3
ALONE = wk.FixedShare(1.0)


def heated(bodies=(STEEL, STEEL), first=6.0, second=4.0, half_width=HALF_WIDTH, flux=FLUX, **more):
    pair = wk.HeatConductors(*bodies)
    return wk.BandHeating(half_width, flux, pair, first_speed=first, second_speed=second, **more).solve()


def alone(speed, **more):
    return heated(first=speed, second=0.0, partition=ALONE, **more)


def integral(z):
    """Of exp(t) K0(|t|) from 0 to z, plus 1."""
    return mp.exp(z) * (z * mp.besselk(0, abs(z)) + abs(z) * mp.besselk(1, abs(z))) if z else mpf(1)


def rise(body, speed, x):
    """Jaeger's band: q/(pi lambda) times the integral of exp(z) K0(|z|) over the band."""
    with mp.workdps(30):
        rate = mpf(speed) / mpf(body.diffusivity) / 2
        part = integral(rate * (x + mpf(HALF_WIDTH))) - integral(rate * (x - mpf(HALF_WIDTH)))
        return part / rate * mpf(FLUX) / (mp.pi * mpf(body.conductivity))


def greatest(body, speed):
    """Where the kernels of both edges are equal, by halving; and the rise there."""
    with mp.workdps(30):
        rate, a = mpf(speed) / mpf(body.diffusivity) / 2, mpf(HALF_WIDTH)
        low, high = mpf(0), a
        for _ in range(22):
            x = (low + high) / 2
            gains = mp.exp(2 * rate * a) * mp.besselk(0, rate * (a + x)) > mp.besselk(0, rate * (a - x))
            low, high = (x, high) if gains else (low, x)
        return float(low), rise(body, speed, low)


@pytest.mark.slow
@pytest.mark.parametrize("speed", [0.024, 24.0])
def test_temperatures_are_jaegers(speed):
    """Pe = 0.1 and 100: along x, the greatest one and its place, the mean as a mean of the closed form."""
    band = alone(speed)
    assert band.first_peclet == pytest.approx(speed * HALF_WIDTH / 24e-6, rel=1e-14)
    for part in (-1.5, -1.0, -0.3, 0.0, 0.8, 1.0, 4.0):
        wanted = float(rise(STEEL, speed, mpf(part * HALF_WIDTH)))
        assert band.first.temperature(part * HALF_WIDTH) == pytest.approx(wanted, rel=1e-10)
    place, height = greatest(STEEL, speed)
    assert band.flash_temperature == band.first_max_temperature == pytest.approx(float(height), rel=1e-10)
    assert band.first.warmest.x == pytest.approx(place, rel=1e-5)
    assert band.second_max_temperature == 0.0
    node, weight = np.polynomial.legendre.leggauss(16)
    angle = 0.5 * np.pi * node
    table = [float(rise(STEEL, speed, mpf(HALF_WIDTH * s))) for s in np.sin(angle)]
    mean = 0.25 * np.pi * float(np.sum(weight * np.cos(angle) * table))
    assert band.first_mean_temperature == pytest.approx(mean, rel=2e-4)


def test_a_body_alone():
    """Steel at 0.5 m/s, Pe = 2.083, 100 W/mm^2 on 0.2 mm: 160.795358204640 K by mpmath at 25 digits, at 0.78023 a."""
    band = alone(0.5)
    assert band.flash_temperature == pytest.approx(160.795358204640, rel=1e-12)
    assert band.first.warmest.x == pytest.approx(0.78022881562e-4, rel=1e-6)
    assert band.heat_per_length == pytest.approx(20e3, rel=1e-14)


def test_fast_bodies_reach_jaegers_limit():
    """T = 2 (q/lambda) sqrt(2 kappa a/(pi V)) at the edge: Jaeger's 1.596, and 1.064 in the mean, of the unit."""
    speed = 24e-6 * 1e6 / HALF_WIDTH
    band, unit = alone(speed), FLUX * np.sqrt(12e-6 * HALF_WIDTH / speed) / 45.0
    assert band.fast_temperature == pytest.approx(2.0 * np.sqrt(2.0 / np.pi) * unit, rel=1e-9)
    assert band.fast_temperature / unit == pytest.approx(1.596, abs=5e-4)
    assert band.flash_temperature == pytest.approx(band.fast_temperature, rel=1e-5)
    assert band.first_mean_temperature / unit == pytest.approx(1.064, abs=5e-4)
    assert band.first.warmest.x == pytest.approx(HALF_WIDTH, rel=1e-4)


def test_a_slow_body_warms_with_the_logarithm():
    """lambda T = Q/pi (ln(2/Pe) - gamma + 1) in the middle, Q/pi (ln(1/Pe) - gamma + 3/2) in the mean."""
    peclet = 1e-6
    band = alone(24e-6 * peclet / HALF_WIDTH)
    unit = 2.0 * HALF_WIDTH * FLUX / (np.pi * 45.0)
    assert band.flash_temperature / unit == pytest.approx(np.log(2.0 / peclet) - np.euler_gamma + 1.0, rel=1e-9)
    assert band.first_mean_temperature / unit == pytest.approx(np.log(1.0 / peclet) - np.euler_gamma + 1.5, rel=1e-6)


@pytest.mark.slow
def test_two_bodies_share_the_heat():
    """Blok's rule: both are as warm, 1/T = 1/T1 + 1/T2 of what each has alone by mpmath; so are the means."""
    ones = [float(greatest(body, speed)[1]) for body, speed in ((STEEL, 6.0), (BRASS, 4.0))]
    band = heated((STEEL, BRASS))
    assert band.flash_temperature == pytest.approx(1.0 / (1.0 / ones[0] + 1.0 / ones[1]), rel=1e-10)
    assert band.first_share == pytest.approx(ones[1] / (ones[0] + ones[1]), rel=1e-10)
    assert band.second_max_temperature == pytest.approx(band.first_max_temperature, rel=1e-12)
    even = heated((STEEL, BRASS), partition=wk.EqualMean())
    assert even.first_mean_temperature == pytest.approx(even.second_mean_temperature, rel=1e-12)


def test_a_plating_of_the_same_metal_changes_nothing_and_a_thick_one_is_the_body():
    """A thin one lies between both."""
    bare = alone(0.5).flash_temperature
    assert alone(0.5, bodies=(wk.Plated(STEEL, 20e-6, STEEL), STEEL)).flash_temperature == pytest.approx(bare)
    thick = alone(0.5, bodies=(wk.Plated(STEEL, 20e-3, BRASS), STEEL)).flash_temperature
    assert thick == pytest.approx(bare, rel=1e-10)
    thin = alone(0.5, bodies=(wk.Plated(STEEL, 20e-6, BRASS), STEEL)).flash_temperature
    assert float(greatest(BRASS, 0.5)[1]) < thin < bare


def test_many_bands_and_speeds():
    many = heated(half_width=np.array([0.1e-3, 0.2e-3]), first=np.array([[3.0], [6.0]]), flux=50e6)
    assert np.shape(many.flash_temperature) == np.shape(many.half_width) == (2, 2)
    one = many.at((1, 0))
    assert one == heated(flux=50e6)
    assert many.flash_temperature[1, 0] == pytest.approx(0.5 * heated().flash_temperature, rel=1e-12)
    assert heated(flux=0.0).flash_temperature == 0.0


def test_what_is_refused():
    with pytest.raises(wk.InvalidInput, match="BandHeating: second_speed is zero, but a body that rests against"):
        heated(second=0.0)
    with pytest.raises(wk.InvalidInput, match=r"half_width, heat_flux, first_speed and second_speed have the shapes"):
        heated(half_width=np.full(2, 1e-3), flux=np.ones(3))
    with pytest.raises(wk.OutsideValidity, match="BandHeating: a Peclet number .* hardly moves"):
        heated(first=1e-12)
    with pytest.raises(wk.InvalidInput, match="heat_flux"):
        heated(flux=-1.0)


def test_notes_speak_of_the_band():
    text = " ".join(note.statement for note in heated().validity)
    assert "The flux is the given one over the whole band" in text
    assert "pressure" not in text
