"""Flash temperatures of line contacts: sums of line sources, closed forms of slow and fast sliding, Blok's rule."""

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import k0, k0e

import winkler as wk
from winkler.numerics.fields.band_source import FAST, BandSource

STEEL = wk.ThermalConductor(45.0, 12e-6)
BRASS = wk.ThermalConductor(110.0, 34e-6)
ELASTIC = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(ELASTIC, ELASTIC)
ROLLER = wk.LineFoundation(wk.Paraboloid(10e-3), PAIR)
LAW, LOAD = wk.Coulomb(0.05), wk.LineForce(400e3)

HERTZ = BandSource(1.0, (), lambda angle: 2.0 / np.pi * np.cos(angle) ** 2)
EVEN = BandSource(1.0, (), lambda angle: 0.5 * np.cos(angle))


def slid(bed=ROLLER, load=LOAD, first=6.0, second=4.0, bodies=(STEEL, STEEL), **more):
    pair = wk.HeatConductors(*bodies)
    pressed = wk.LineIndentation(bed, load)
    return wk.LineFrictionHeating(pressed, LAW, pair, first_speed=first, second_speed=second, **more).solve()


def summed(flux, wave, x, edges):
    """Line sources by scipy: the flux over the places s, exp(z) K0(|z|)/pi each."""
    cuts = sorted({*edges, *(c for c in (x, x - 2.0 / wave, x + 2.0 / wave, x - 20.0 / wave) if -1.0 < c < 1.0)})

    def kernel(s):
        z = 0.5 * wave * (x - s)
        return flux(s) * (k0e(z) if z > 0.0 else np.exp(z) * k0(-z))

    return (
        sum(
            quad(kernel, a, b, epsabs=0.0, epsrel=1e-11, limit=200)[0] for a, b in zip(cuts[:-1], cuts[1:], strict=True)
        )
        / np.pi
    )


@pytest.mark.parametrize("wave", [0.01, 2.0, 60.0])
@pytest.mark.parametrize("x", [-1.1, -0.4, 0.7, 1.0, 3.0])
def test_a_band_is_a_sum_of_line_sources(wave, x):
    for source, flux in ((HERTZ, lambda s: 2.0 / np.pi * np.sqrt(1.0 - s * s)), (EVEN, lambda s: 0.5)):
        wanted = summed(flux, wave, x, (-1.0, 1.0))
        assert source.surface(wave, np.array([x]))[0] == pytest.approx(wanted, rel=1e-8)
        assert source.surface(-wave, np.array([-x]))[0] == pytest.approx(wanted, rel=1e-8)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(
    "profile", [wk.Cone(1.55), wk.RoundedPunch(1e-3, 0.1), wk.FlatPunch(1e-3), wk.PowerLaw(1e6, 4.0)]
)
def test_the_flux_of_a_profile_has_the_shape_of_its_pressure(profile):
    """Kinks, sharp tips and flat parts: at one place against the pressure, summed by scipy."""
    bed = wk.LineFoundation(profile, PAIR)
    rubbed = slid(bed)
    a, place = rubbed.half_width, 0.4
    pressed = wk.LineIndentation(bed, LOAD).solve()
    inner = [sign * b / a for b, _ in (*bed.kinks, (0.0, 0.0)) if b < a for sign in (1.0, -1.0)]

    def flux(s):
        return float(pressed.pressure(np.array([s * a]))[0]) * a / 400e3

    wanted = summed(flux, 6.0 * a / 12e-6, place, (-1.0, 1.0, *inner))
    found = rubbed.first.temperature(place * a) * 45.0 / (rubbed.first_share * rubbed.heat_per_length)
    assert found == pytest.approx(wanted, rel=1e-7)


@pytest.mark.parametrize("peclet", [1e-5, 1e-6])
def test_slow_discs_reach_the_closed_form(peclet):
    """lambda T = Q/pi (ln(4/Pe) - gamma + 1/2) of Hertz' flux, less by terms of the order of Pe ln Pe."""
    wanted = (np.log(4.0 / peclet) - np.euler_gamma + 0.5) / np.pi
    top = HERTZ.peak(2.0 * peclet)
    assert top.height == pytest.approx(wanted, rel=20.0 * peclet**2 * np.log(1.0 / peclet) ** 2 + 1e-14)
    assert abs(top.x) < 20.0 * peclet * np.log(1.0 / peclet)
    mean = (np.log(4.0 / peclet) - np.euler_gamma + 1.0 / 6.0) / np.pi
    assert HERTZ.mean(2.0 * peclet) == pytest.approx(mean, rel=1e-10)


def test_fast_discs_reach_bloks_formula():
    """Under Hertz' flux the integral of sqrt(1 - s^2)/sqrt(t - s) is at most 2.18831, 0.652 a behind the middle."""
    top = HERTZ.peak(FAST)
    assert top.height * np.pi**1.5 / 2.0 == pytest.approx(2.18831, abs=5e-6)
    assert top.x == pytest.approx(0.652, abs=5e-4)
    errors = [HERTZ.peak(2.0 * pe).height * np.sqrt(2.0 * pe) / top.height - 1.0 for pe in (1e3, 1e4, 1e5)]
    assert abs(errors[2]) < 1e-8
    assert abs(errors[0]) > 10.0 * abs(errors[1]) > 100.0 * abs(errors[2])


def test_an_even_band_is_jaegers():
    """At high speed the trailing edge is warmest: lambda T = q sqrt(2 l kappa/(pi V)) 2 with l the half-width."""
    assert EVEN.peak(FAST).height == pytest.approx(np.sqrt(2.0 / np.pi), rel=1e-9)
    assert EVEN.peak(FAST).x == pytest.approx(1.0, abs=1e-7)


@pytest.mark.few(1)
@pytest.mark.parametrize("wave", [1e-3, 1.0, 100.0, 1e6])
def test_the_mean_is_that_of_the_temperatures(wave):
    angle = 0.5 * np.pi * np.linspace(-1.0, 1.0, 2001)
    mean = 0.5 * np.trapezoid(HERTZ.surface(wave, np.sin(angle)) * np.cos(angle), angle)
    assert HERTZ.mean(wave) == pytest.approx(mean, rel=2e-6)


def test_the_bodies_share_the_heat():
    rubbed = slid(bodies=(STEEL, BRASS))
    assert rubbed.first_max_temperature == pytest.approx(rubbed.second_max_temperature, rel=1e-12)
    assert rubbed.first.warmest.height == pytest.approx(rubbed.flash_temperature, rel=1e-12)
    even = slid(bodies=(STEEL, BRASS), partition=wk.EqualMean())
    assert even.first_mean_temperature == pytest.approx(even.second_mean_temperature, rel=1e-12)
    fixed = slid(partition=wk.FixedShare(0.25))
    assert fixed.first_max_temperature / slid(partition=wk.FixedShare(0.5)).first_max_temperature == pytest.approx(0.5)
    blok = np.sqrt(45.0**2 * 6.0 / 12e-6) + np.sqrt(110.0**2 * 4.0 / 34e-6)
    wanted = 2.18831 * 2.0 / np.pi**1.5 * rubbed.heat_per_length / (blok * np.sqrt(rubbed.half_width))
    assert rubbed.fast_temperature == pytest.approx(wanted, rel=1e-5)
    assert rubbed.flash_temperature == pytest.approx(rubbed.fast_temperature, rel=1e-3)


def test_many_loads_and_speeds():
    loads, speeds = np.array([0.0, 100e3, 400e3]), np.array([[6.0], [7.0]])
    many = slid(load=wk.LineForce(loads), first=speeds)
    assert np.shape(many.flash_temperature) == (2, 3)
    assert np.all(many.flash_temperature[:, 0] == 0.0)
    one = many.at((1, 2))
    assert one == slid(first=7.0)
    assert one.first.temperature(0.0) > 0.0
    with pytest.raises(wk.InvalidInput, match="solution.at: there is no result"):
        many.at((2, 2))
    with pytest.raises(wk.InvalidInput, match="pick one with"):
        _ = many.first


def test_a_rim_has_no_limit_of_fast_sliding():
    assert slid(wk.LineFoundation(wk.FlatPunch(1e-3), PAIR)).fast_temperature == np.inf


def test_what_is_refused():
    with pytest.raises(wk.InvalidInput, match="second_speed is zero, but a body that rests against an endless band"):
        slid(second=0.0)
    with pytest.raises(wk.InvalidInput, match="do not broadcast"):
        slid(first=np.ones(2), second=np.ones(3))
    with pytest.raises(wk.OutsideValidity, match="hardly moves"):
        slid(first=1e-12)
    alone = slid(second=0.0, partition=wk.FixedShare(1.0))
    assert alone.second_max_temperature == 0.0
    assert alone.flash_temperature == pytest.approx(slid(second=-6.0).flash_temperature, rel=1e-12)


def test_yield_counts_the_friction():
    strong = wk.Elastic(210e9, 0.3, strength=0.9e9)
    bed = wk.LineFoundation(wk.Paraboloid(10e-3), wk.HalfSpace.between(strong, ELASTIC))
    onset = wk.LineYieldOnset(bed, LAW).solve().force_per_length
    for share, standing in ((0.99, wk.Standing.EXACT), (1.01, wk.Standing.OUTSIDE)):
        notes = slid(bed, wk.LineForce(share * onset)).validity
        (note,) = [note for note in notes if note.assumption is wk.Assumption.ELASTIC]
        assert note.standing is standing
        assert f"{onset:.4g} N/m" in note.statement


@pytest.mark.parametrize("place", [np.nan, [0.0, np.inf], "left"])
def test_places_are_finite_numbers(place):
    with pytest.raises(wk.InvalidInput, match="HeatedStrip: x"):
        slid().first.temperature(place)
