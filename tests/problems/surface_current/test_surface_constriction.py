"""Electric contacts of height maps against dense matrices of images, discs, films and Kohlrausch's law."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from scipy.special import gammaln

import winkler as wk
from winkler.media.conduction.disc_resistance import disc_resistances
from winkler.media.conduction.spot_resistances import spot_resistances

GOLD, STEEL, COPPER = wk.ElectricalConductor(22e-9), wk.ElectricalConductor(170e-9), wk.ElectricalConductor(17e-9)
METAL = wk.HalfSpace.between(wk.Elastic(80e9, 0.42), wk.Elastic(120e9, 0.34))
SPOTS = np.array(
    [
        [0, 1, 1, 0, 0, 0, 0],
        [1, 1, 1, 0, 0, 1, 0],
        [0, 1, 0, 0, 1, 1, 1],
        [0, 0, 0, 0, 0, 1, 0],
        [0, 1, 0, 0, 0, 0, 0],
    ],
    dtype=bool,
)
NODES, WEIGHTS = (part / 2.0 for part in np.polynomial.legendre.leggauss(10))


def own(side):
    """Mean of 1/r over a rectangle about its middle, times its area: by the logarithms of its corners."""
    a, b = side
    r = np.hypot(a, b)
    return 2.0 * (a * np.log((b + r) / a) + b * np.log((a + r) / b))


def inverse_distance(places, side, deep):
    """Integrals of 1/r over each pixel at the depth `deep` from the middle of each other one: Gauss' rule."""
    apart = places[:, None] - places[None]
    total = np.zeros(apart.shape[:2])
    for x, u in zip(NODES, WEIGHTS, strict=True):
        for y, v in zip(NODES, WEIGHTS, strict=True):
            dx, dy = apart[..., 0] + x * side[0], apart[..., 1] + y * side[1]
            total += u * v * side[0] * side[1] / np.sqrt(dx**2 + dy**2 + deep**2)
    if deep == 0.0:
        np.fill_diagonal(total, own(side))
    return total


def images(body, places, side):
    """Voltage over a body per flux of each pixel: Weber's, and the images of a plating (Kelvin)."""
    surface = body.plating if isinstance(body, wk.Plated) else body
    total = inverse_distance(places, side, 0.0)
    if isinstance(body, wk.Plated):
        echo = (body.on.resistivity - surface.resistivity) / (body.on.resistivity + surface.resistivity)
        for n in range(1, 60):
            total = total + 2.0 * echo**n * inverse_distance(places, side, 2.0 * n * body.thickness)
    return surface.resistivity / (2.0 * np.pi) * total


@pytest.mark.parametrize(
    ("first", "second", "film"),
    [
        (STEEL, GOLD, 0.0),
        (wk.Plated(GOLD, 2e-6, COPPER), STEEL, 0.0),
        (wk.Plated(STEEL, 3e-6, GOLD), wk.Plated(GOLD, 1e-6, COPPER), 0.0),
        (wk.Plated(GOLD, 2e-6, COPPER), GOLD, 3e-13),
        (STEEL, STEEL, 1e-11),
    ],
    ids=["bare", "plated", "plated twice", "plated and tarnished", "tarnished"],
)
def test_spots_are_those_of_a_dense_matrix(first, second, film):
    side = (1e-6, 1.3e-6)
    places = np.argwhere(SPOTS) * np.array(side)
    patch = side[0] * side[1]
    voltages = [images(body, places, side) for body in (first, second)]
    whole = sum(voltages) + film * np.eye(len(places))
    flux = np.linalg.solve(whole, np.ones(len(places)))
    current = patch * np.sum(flux)
    lost = film / (patch * len(places))
    falls = np.array([flux @ part @ flux for part in voltages])
    found = spot_resistances(SPOTS, side, (first, second), film, periodic=False)
    assert found.first + found.second + found.film == pytest.approx(1.0 / current, rel=2e-5)
    assert found.film == pytest.approx(lost, rel=1e-12)
    expected = (1.0 / current - lost) * falls / np.sum(falls)
    assert [found.first, found.second] == pytest.approx(expected, rel=1e-3)
    over = np.array([part @ flux for part in voltages])
    shares = over[0] / np.sum(over, axis=0)
    assert [found.least_share, found.greatest_share] == pytest.approx([np.min(shares), np.max(shares)], abs=2e-4)


def disc(count, radius, width):
    x = (np.arange(count) - 0.5 * (count - 1)) * width / count
    return np.hypot(x[:, None], x) <= radius


@pytest.mark.parametrize("thickness", [0.3e-6, 3e-6, 30e-6])
def test_a_plating_changes_a_disc_by_its_factor(thickness):
    """Against the integral equation of the disc, in proportion to the bare one on the same pixels."""
    touching, side = disc(65, 10e-6, 30e-6), 30e-6 / 65
    radius = np.sqrt(np.count_nonzero(touching) / np.pi) * side
    body = wk.Plated(GOLD, thickness, STEEL)
    found = spot_resistances(touching, (side, side), (body, body), 0.0, periodic=False)
    expected = disc_resistances(body, body, 0.0, np.array([radius]))
    factor = (expected.first + expected.second)[0] / (2.0 * STEEL.resistivity / (4.0 * radius))
    assert (found.first + found.second) / found.bare == pytest.approx(factor, rel=3e-3)


def test_thick_and_thin_platings():
    side, touching = (1e-6, 1e-6), disc(9, 3.1e-6, 9e-6)
    bare = {body: spot_resistances(touching, side, (body, body), 0.0, periodic=False) for body in (GOLD, STEEL)}
    thick, thin = (wk.Plated(GOLD, thickness, STEEL) for thickness in (3e-3, 1e-10))
    for plated, solid, allowed in ((thick, GOLD, 5e-3), (thin, STEEL, 5e-3)):
        found = spot_resistances(touching, side, (plated, plated), 0.0, periodic=False)
        assert found.first + found.second == pytest.approx(bare[solid].first + bare[solid].second, rel=allowed)
    same = spot_resistances(touching, side, (wk.Plated(GOLD, 1e-6, GOLD), GOLD), 0.0, periodic=False)
    assert same.first == pytest.approx(bare[GOLD].first, rel=1e-12)


def test_a_thick_film_rules_alone():
    touching, side = disc(17, 5e-6, 20e-6), (20e-6 / 17, 20e-6 / 17)
    for periodic in (False, True):
        found = spot_resistances(touching, side, (GOLD, GOLD), 1e-6, periodic=periodic)
        assert found.film == pytest.approx(1e-6 / (np.count_nonzero(touching) * side[0] ** 2), rel=1e-12)
        assert found.first + found.second < 1e-4 * found.film
    everywhere = spot_resistances(np.ones((4, 6), bool), side, (GOLD, STEEL), 1e-12, periodic=True)
    assert everywhere.first == everywhere.second == 0.0
    assert everywhere.film == pytest.approx(1e-12 / (24 * side[0] ** 2), rel=1e-12)


def robin_disc(film):
    """Resistance of a disc of unit radius under a film, resistivities one, by Galerkin's method on (1 - r^2)^(k/2).

    Hankel's transform of (1 - r^2)^k is 2^k k! J_{k+1}(q) / q^(k+1); products of them integrate by Abramowitz and
    Stegun 11.4.33.
    """
    k = 0.5 * np.arange(14)
    one, other = np.meshgrid(k, k, indexing="ij")
    power = one + other + 2.0
    products = np.exp(
        gammaln(power) + gammaln(0.5) + gammaln(one + 1.0) + gammaln(other + 1.0) - 2.0 * np.log(2.0)
        - gammaln((other - one + power + 1.0) / 2.0) - gammaln((one - other + power + 1.0) / 2.0)
        - gammaln((one + other + power + 3.0) / 2.0)
    )  # fmt: skip
    flux = 0.5 / (k + 1.0)
    found = np.linalg.lstsq(2.0 * products + film * 0.5 / (one + other + 1.0), flux, rcond=1e-14)[0]
    return 1.0 / (2.0 * np.pi * float(found @ flux))


@pytest.mark.parametrize("film", [1e-3, 0.1, 1.0, 10.0, 1e3])
def test_a_disc_under_a_film_meets_robins_condition(film):
    """By two grids, whose error falls with the pixel; thin films leave Holm's value, thick ones an even flux."""
    unit, on = wk.ElectricalConductor(1.0), []
    for count in (24, 48):
        x = np.arange(count + 4) - 0.5 * (count + 3)
        touching = (x[:, None] + 0.13) ** 2 + (x + 0.33) ** 2 <= 0.25 * count**2
        side = float(np.sqrt(np.pi / np.count_nonzero(touching)))
        found = spot_resistances(touching, (side, side), (unit, unit), film, periodic=False)
        on.append(found.first + found.second + found.film)
    assert 2.0 * on[1] - on[0] == pytest.approx(robin_disc(film), rel=2e-3)
    if film <= 1e-3:
        assert robin_disc(film) == pytest.approx(0.5, rel=2e-3)
    if film >= 1e3:
        assert robin_disc(film) == pytest.approx(film / np.pi + 0.5 * 32.0 / (3.0 * np.pi**2), rel=1e-7)


def rivet(**more):
    ball = wk.SampledProfile([60e-6, 60e-6], wk.Paraboloid(2e-3), (49, 49))
    contact = wk.SurfaceContact(ball, METAL, wk.Force([0.1, 0.5]))
    stated = {"conductors": wk.ElectricalConductors(GOLD, GOLD), "drive": wk.Voltage(0.05), **more}
    return wk.SurfaceConstriction(contact, **stated)


def test_bare_spots_conduct_in_proportion_to_stiffness():
    """Barber, for elastic contacts."""
    found = rivet().solve()
    stiffness = np.asarray(found.contact.stiffness)
    assert found.resistance == pytest.approx(22e-9 * METAL.modulus / stiffness, rel=1e-4)
    assert found.plating_factor == pytest.approx(1.0, rel=1e-6)
    assert found.conductance == pytest.approx(1.0 / found.resistance, rel=1e-14)


def test_temperatures_follow_from_the_voltage():
    """Kohlrausch: T^2 = T_0^2 + V^2 / (4 L), and the voltage at which gold softens and melts."""
    found = rivet(softening_temperature=373.0, melting_temperature=1336.0).solve()
    assert found.max_temperature == pytest.approx(np.sqrt(293.15**2 + 0.05**2 / (4.0 * 2.44e-8)), rel=1e-12)
    for reached, voltage, current in (
        (373.0, found.softening_voltage, found.softening_current),
        (1336.0, found.melting_voltage, found.melting_current),
    ):
        assert voltage == pytest.approx(2.0 * np.sqrt(2.44e-8 * (reached**2 - 293.15**2)), rel=1e-12)
        assert current == pytest.approx(voltage / found.cold_resistance, rel=1e-12)
    assert found.heat_rate == pytest.approx(found.voltage * found.current, rel=1e-14)


def test_a_spot_between_unlike_platings_states_the_spread_of_its_temperature():
    """A disc of 5 um as pixels: 614.99 K on the axis and 600.21 K at the edge, which the outermost pixels average."""
    good, bad = wk.ElectricalConductor(2e-8), wk.ElectricalConductor(1e-6)
    unlike = wk.ElectricalConductors(wk.Plated(bad, 2e-6, on=good), wk.Plated(good, 2e-6, on=bad))
    ball = wk.SampledProfile([16e-6, 16e-6], wk.Paraboloid(2e-3), (65, 65))
    contact = wk.SurfaceContact(ball, METAL, wk.Depth(12.5e-9))
    hot = wk.SurfaceConstriction(contact, unlike, wk.Voltage(0.2)).solve()
    assert hot.area == pytest.approx(np.pi * 25e-12, rel=2e-2)
    assert hot.hottest_contact_temperature == pytest.approx(614.99, abs=0.5)
    assert hot.coldest_contact_temperature == pytest.approx(600.21, abs=2.0)
    assert hot.coldest_contact_temperature < hot.contact_temperature < hot.hottest_contact_temperature
    spread = next(note for note in hot.validity if "no single temperature" in note.statement)
    assert f"{hot.coldest_contact_temperature:.5g} to {hot.hottest_contact_temperature:.5g} K" in spread.statement
    alike = wk.ElectricalConductors(unlike.first, unlike.first)
    even = wk.SurfaceConstriction(contact, alike, wk.Voltage(0.2)).solve()
    assert even.coldest_contact_temperature == even.hottest_contact_temperature == even.contact_temperature
    assert not any("no single temperature" in note.statement for note in even.validity)


def test_a_film_takes_a_share_of_the_voltage():
    """With f the share of the film T_c^2 = T_0^2 + V^2 (1 - f^2) / (4 L)."""
    pair = wk.ElectricalConductors(GOLD, GOLD, wk.SurfaceFilm(2e-12))
    found = rivet(conductors=pair, softening_temperature=373.0).solve()
    share = found.film_resistance / found.resistance
    assert np.all(share > 0.3)
    expected = 2.0 * np.sqrt(2.44e-8 * (373.0**2 - 293.15**2) / (1.0 - share**2))
    assert found.softening_voltage == pytest.approx(expected, rel=1e-10)
    hot = rivet(conductors=pair, drive=wk.Voltage(float(expected[1]))).solve()
    assert hot.max_temperature[1] == pytest.approx(373.0, rel=1e-10)


def test_a_current_that_softens_does():
    warm = wk.ElectricalConductor(22e-9, 3.4e-3)
    pair = wk.ElectricalConductors(wk.Plated(warm, 1e-6, wk.ElectricalConductor(110e-9, 1e-3)), warm)
    stated = rivet(conductors=pair, softening_temperature=373.0)
    found = stated.solve()
    again = dataclasses.replace(stated, drive=wk.Current(float(found.softening_current[1]))).solve()
    assert again.max_temperature[1] == pytest.approx(373.0, rel=1e-9)
    assert again.voltage[1] == pytest.approx(found.softening_voltage[1], rel=1e-9)
    assert again.resistance[1] > again.cold_resistance[1]
    assert any("mean of both temperature coefficients" in note.statement for note in found.validity)


def test_a_rough_rivet_in_spots():
    """More load, more of each spot; the plating lowers the resistance, the hardness limits the pressure."""
    turned = wk.RandomTopography(
        [80e-6, 80e-6], wk.SelfAffine(hurst=0.8, rms_height=60e-9, longest=40e-6, shortest=8e-6), (64, 64), seed=3
    )
    contact = wk.SurfaceContact(
        wk.RoughProfile(turned, wk.Paraboloid(2e-3)), METAL, wk.Force([0.02, 0.2, 2.0]), hardness=1e9
    )
    body = wk.Plated(GOLD, 1e-6, STEEL)
    found = wk.SurfaceConstriction(contact, wk.ElectricalConductors(body, body), wk.Voltage(0.01)).solve()
    assert np.all(np.diff(found.resistance) < 0.0)
    assert np.all(np.diff(found.plating_factor) > 0.0)
    assert np.all((found.plating_factor > 22.0 / 170.0) & (found.plating_factor < 1.0))
    assert found.area[-1] >= 2.0 / 1e9
    assert np.max(found.contact.last.pressure) <= 1e9 * (1.0 + 1e-12)


def test_what_is_no_contact_of_a_map_is_refused():
    with pytest.raises(wk.OutsideValidity, match="a rod constricts"):
        rivet(conductors=wk.ElectricalConductors(GOLD, wk.Rod(GOLD, 1e-3, 1e-2)))
    with pytest.raises(wk.OutsideValidity, match="leave the plating out"):
        rivet(conductors=wk.ElectricalConductors(wk.Plated(GOLD, 1e-20, STEEL), GOLD))
    with pytest.raises(wk.InvalidInput, match="softening_temperature is 100 K"):
        rivet(softening_temperature=100.0)
    with pytest.raises(wk.InvalidInput, match="melting_temperature"):
        rivet(melting_temperature=293.15)


def test_a_rough_profile_is_its_profile_and_its_roughness():
    flat = wk.Topography(np.zeros((31, 41)), [1e-3, 2e-3], periodic=True)
    smooth = wk.SampledProfile([1e-3, 2e-3], wk.Sphere(5e-3), (31, 41))
    assert np.array_equal(wk.RoughProfile(flat, wk.Sphere(5e-3)).heights, smooth.heights)
    wavy = wk.Topography(1e-6 * np.cos(np.arange(31.0))[:, None] + np.zeros(41), [1e-3, 2e-3])
    both = wk.RoughProfile(wavy, wk.Sphere(5e-3))
    assert both.heights - smooth.heights == pytest.approx(wavy.heights - np.mean(wavy.heights), abs=1e-18)
    with pytest.raises(wk.InvalidInput, match="smaller lengths"):
        wk.RoughProfile(wavy, wk.FlatPunch(1e-4))
