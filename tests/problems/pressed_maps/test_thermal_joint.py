"""Heat through spots and gap: Holm's spot, a film on a disc, uniform and wavy gaps, and every part that is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.media.conduction.spot_resistances import plated_surface
from winkler.numerics.films.joint_flux import joint_flux
from winkler.problems.pressed_maps.thermal_joint import ThermalJoint

STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
METAL = wk.ThermalConductor(50.0, 1e-5)
PAIR = wk.HeatConductors(METAL, METAL)
BLASTED = wk.SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=60e-6)
ROUGH = wk.RandomTopography([1e-3, 1e-3], BLASTED, (64, 64), seed=1)


def disc(pixels, radius):
    place = (np.arange(pixels) + 0.5) / pixels - 0.5
    return np.hypot(place[:, None], place[None, :]) <= radius


def test_a_round_spot_is_holms():
    """Two half-spaces of conductivity 50: 4 a / (1/50 + 1/50), from Hertz's radius."""
    place = (np.arange(96) + 0.5) / 96 * 0.3e-3 - 0.15e-3
    ball = wk.Topography(-(place[:, None] ** 2 + place**2) / 20e-3, [0.3e-3, 0.3e-3])
    found = ThermalJoint(wk.SurfaceContact(ball, STEEL, wk.Depth([0.5e-6, 1e-6])), PAIR).solve()
    radius = np.sqrt(10e-3 * np.array([0.5e-6, 1e-6]))
    np.testing.assert_allclose(found.conductance, 4.0 * radius / 0.04, rtol=5e-3)
    np.testing.assert_allclose(found.resistance, 1.0 / np.asarray(found.conductance), rtol=1e-14)
    assert np.all(np.asarray(found.gap_conductance) == 0.0)


@pytest.mark.parametrize("periodic", [True, False])
def test_bare_spots_conduct_as_they_are_stiff(periodic):
    """Barber: 2 dF/dd over E* and the sum of the resistivities, with stiffnesses of contacts close together."""
    rough = ROUGH if periodic else wk.Topography(ROUGH.heights, ROUGH.lengths)
    load = wk.Force([3.0, 20.0])
    found = ThermalJoint(wk.SurfaceContact(rough, STEEL, load), PAIR).solve()
    near = wk.SurfaceContact(rough, STEEL, wk.Force([2.99, 3.01, 19.9, 20.1])).solve()
    stiff = np.array([(0.02) / (near.depth[1] - near.depth[0]), 0.2 / (near.depth[3] - near.depth[2])])
    np.testing.assert_allclose(found.conductance, 2.0 * stiff / (STEEL.modulus * 0.04), rtol=0.01)
    np.testing.assert_allclose(found.conductance, 2.0 * found.contact.stiffness / (STEEL.modulus * 0.04), rtol=1e-4)


def test_a_resistive_film_on_a_disc():
    """To the first order in the spreading of a uniform flux, R = r / A + 8 rho / (3 pi^2 a)."""
    there = disc(128, 0.4)
    area = float(np.count_nonzero(there)) / 128**2
    radius = math.sqrt(area / math.pi)
    film = 40.0
    found = joint_flux(np.where(there, film, np.inf), (1.0 / 128, 1.0 / 128), 1.0, periodic=False)
    assert 1.0 / found.whole == pytest.approx(film / area + 8.0 / (3.0 * math.pi**2 * radius), rel=2e-5)
    assert np.all(found.flux[~there] == 0.0)


@pytest.mark.parametrize("spreading", [1e-6, 1.0, 30.0])
def test_a_wavy_gap(spreading):
    """A gap that varies along x, by the dense matrix of its flux; bodies do not resist the mean flux."""
    n = 48
    resistance = 0.3 * (1.0 + 0.8 * np.cos(2.0 * np.pi * np.arange(n) / n)) + 0.01
    waves = 2.0 * np.pi * n * np.abs(np.fft.fftfreq(n))
    spread = np.where(waves > 0.0, spreading / np.where(waves > 0.0, waves, 1.0), 0.0)
    matrix = np.diag(resistance) + np.real(np.fft.ifft(spread[:, None] * np.fft.fft(np.eye(n), axis=0), axis=0))
    expected = np.linalg.solve(matrix, np.ones(n))
    side = (1.0 / n, 1.0 / n)
    found = joint_flux(np.repeat(resistance[:, None], n, 1), side, spreading, periodic=True, tolerance=1e-9)
    np.testing.assert_allclose(found.flux, np.repeat(expected[:, None], n, 1), rtol=1e-6)
    assert found.whole == pytest.approx(float(np.mean(expected)), rel=1e-10)


COPPER, STEEL_HEAT, SOLDER = (wk.ThermalConductor(k, 1e-5) for k in (400.0, 15.0, 50.0))


def opposing(layers, base, wave):
    """Temperature over flux of a wave on layers (k, h) from below, by tanh of every one (Carslaw and Jaeger)."""
    below = 1.0 / (base * wave)
    for k, h in layers:
        own, fall = 1.0 / (k * wave), np.tanh(wave * h)
        below = own * (below + own * fall) / (own + below * fall)
    return below


@pytest.mark.parametrize("interface", [3e-5, 3e-3])
def test_a_wavy_gap_between_platings(interface):
    """A gap that varies along x: the dense matrix of its flux through both bodies, one of them plated twice."""
    n, side = 48, 1e-3
    resistance = interface * (1.0 + 0.8 * np.cos(2.0 * np.pi * np.arange(n) / n))
    first = wk.Plated(COPPER, 0.05e-3, wk.Plated(SOLDER, 0.1e-3, STEEL_HEAT))
    second = wk.Plated(STEEL_HEAT, 0.02e-3, COPPER)
    waves = 2.0 * np.pi / side * n * np.abs(np.fft.fftfreq(n))
    some = np.where(waves > 0.0, waves, 1.0)
    spread = opposing([(50.0, 0.1e-3), (400.0, 0.05e-3)], 15.0, some) + opposing([(15.0, 0.02e-3)], 400.0, some)
    spread = np.where(waves > 0.0, spread, 0.0)
    matrix = np.diag(resistance) + np.real(np.fft.ifft(spread[:, None] * np.fft.fft(np.eye(n), axis=0), axis=0))
    expected = np.linalg.solve(matrix, np.ones(n))
    found = joint_flux(
        np.repeat(resistance[:, None], n, 1), (side / n, side / n), 1.0 / 400.0 + 1.0 / 15.0, periodic=True,
        tolerance=1e-9, layers=plated_surface(first, second),
    )  # fmt: skip
    np.testing.assert_allclose(found.flux, np.repeat(expected[:, None], n, 1), rtol=1e-6)
    assert found.whole == pytest.approx(float(np.mean(expected)) * side**2, rel=1e-10)


def test_a_round_spot_through_platings():
    """Beside the integral equation of a disc through platings; elastic layers alone leave Holm's disc."""
    pair = wk.HeatConductors(wk.Plated(COPPER, 3e-6, STEEL_HEAT), STEEL_HEAT)
    expected = float(pair.resistances(np.array([10e-6])).whole[0])
    x = (np.arange(65) - 31.9) / 65 * 40e-6
    ball = wk.Topography(-(x[:, None] ** 2 + x**2) / 4e-3, [40e-6, 40e-6])
    found = ThermalJoint(wk.SurfaceContact(ball, STEEL, wk.Depth(1e-10 / 2e-3)), pair).solve()
    assert found.resistance == pytest.approx(expected, rel=2e-3)
    assert expected < 0.7 * float(wk.HeatConductors(STEEL_HEAT, STEEL_HEAT).resistances(np.array([10e-6])).whole[0])
    assert any("platings conduct as flat layers" in note.statement for note in found.validity)
    coated = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(110e9, 0.34), 3e-6)], on=wk.Elastic(210e9, 0.3))
    uniform = ThermalJoint(wk.SurfaceContact(ball, coated, wk.Depth(5e-8)), PAIR).solve()
    conducting = np.sqrt(uniform.area / np.pi)
    assert uniform.conductance == pytest.approx(4.0 * conducting / 0.04, rel=0.02)
    assert any("given separately from the elastic layers" in note.statement for note in uniform.validity)


def test_a_closed_periodic_map_holds_nothing_back():
    """Without an interface; with one it is that alone."""
    closing = wk.SurfaceContact(ROUGH, STEEL, wk.Force(1e6))
    found = ThermalJoint(closing, PAIR, gap_conductivity=0.026).solve()
    assert np.isinf(found.conductance)
    assert found.gap_conductance == 0.0
    held = ThermalJoint(closing, wk.HeatConductors(METAL, METAL, wk.ThermalInterface(1e6))).solve()
    assert held.conductance == pytest.approx(1e6 * 1e-6, rel=1e-9)


def test_gap_and_spots_stand_side_by_side():
    contact = wk.SurfaceContact(ROUGH, STEEL, wk.Force(3.0))
    bare = ThermalJoint(contact, PAIR).solve()
    filled = ThermalJoint(contact, PAIR, gap_conductivity=0.026, jump_distance=0.4e-6).solve()
    separation, touching = filled.contact.last.separation, filled.contact.last.pressure > 0.0
    patch = 1e-6 / 64**2
    alone = patch * float(np.sum(0.026 / (separation[~touching] + 0.4e-6)))
    assert filled.gap_conductance <= alone
    assert filled.gap_conductance == pytest.approx(alone, rel=0.05)
    assert filled.spot_conductance == pytest.approx(bare.conductance, rel=0.05)
    assert filled.spot_conductance < bare.conductance
    assert filled.conductance == pytest.approx(filled.spot_conductance + filled.gap_conductance, rel=1e-12)
    assert filled.joint_conductance == pytest.approx(filled.conductance / 1e-6, rel=1e-14)
    assert patch * float(np.sum(filled.flux())) == pytest.approx(filled.conductance, rel=1e-5)
    held = ThermalJoint(contact, wk.HeatConductors(METAL, METAL, wk.ThermalInterface(1e6))).solve()
    touching_area = patch * np.count_nonzero(touching)
    assert held.resistance > bare.resistance + 1.0 / (1e6 * touching_area)  # Rayleigh: equal potentials on both sides
    statements = [note.statement for note in filled.validity]
    assert any(s.startswith("The medium in the gap conducts heat with 0.026 W/(m K)") for s in statements)


def test_what_is_refused():
    contact = wk.SurfaceContact(ROUGH, STEEL, wk.Force(3.0))
    with pytest.raises(wk.OutsideValidity, match="ThermalJoint: a rod constricts the heat of one round contact"):
        ThermalJoint(contact, wk.HeatConductors(wk.Rod(METAL, 1e-3, 1e-2), METAL))
    with pytest.raises(wk.OutsideValidity, match="ThermalJoint: a plating of 1e-20 m is less than"):
        ThermalJoint(contact, wk.HeatConductors(wk.Plated(METAL, 1e-20, COPPER), METAL))
    with pytest.raises(wk.InvalidInput, match="gap_conductivity is -1"):
        ThermalJoint(contact, PAIR, gap_conductivity=-1.0)
    metal = wk.ElectricalConductor(16e-9)
    with pytest.raises(wk.InvalidInput, match="conductors"):
        ThermalJoint(contact, wk.ElectricalConductors(metal, metal))
