"""Wear of height maps against closed forms, and against dense matrices marched by another method."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.optimize import nnls

import winkler as wk

UNIT = wk.HalfSpace(wk.Elastic(1.0, 0.0))
"""E* = 1 Pa."""


def wave(count=16, height=0.01):
    x = np.arange(count) / count
    return wk.Topography(height * np.cos(2.0 * np.pi * x[:, None]) + 0.0 * x, [1.0, 1.0], periodic=True)


def compliance(shape, pixel):
    """Displacements at the middles of pixels under unit pressures on each, E* = 1: corners of the integral of 1/r."""
    x, y = (np.arange(n) * side for n, side in zip(shape, pixel, strict=True))
    places = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    apart = places[:, None] - places[None]

    def corner(a, b):
        r = np.hypot(a, b)
        return a * np.log(b + r) + b * np.log(a + r)

    total = np.zeros(apart.shape[:2])
    for i in (1.0, -1.0):
        for j in (1.0, -1.0):
            a, b = apart[..., 0] + 0.5 * i * pixel[0], apart[..., 1] + 0.5 * j * pixel[1]
            total += i * j * corner(a, b)
    return total / np.pi


def pressed(matrix, gaps, load):
    """Pressures >= 0 with the sum `load`: the least of p G p / 2 + p h, by Lawson and Hanson's method."""
    low = np.linalg.cholesky(matrix)
    heavy = 1e6
    rows = np.vstack([low.T, heavy * np.ones(len(gaps))])
    right = np.append(-np.linalg.solve(low, gaps), heavy * load)
    return nnls(rows, right, maxiter=10_000)[0]


@pytest.mark.slow
def test_a_wave_that_is_pressed_flat_decays():
    """Each wave in full contact: dp/ds = -k E* q p / 2, with the force steady."""
    distance = np.array([0.0, 0.1, 0.5, 2.0]) / np.pi
    for tolerance in (1e-3, 1e-4, 1e-6):
        contact = wk.SurfaceContact(wave(), UNIT, wk.Force(0.1), tolerance=1e-9)
        found = wk.SurfaceWear(contact, wk.Archard(1.0), distance, tolerance=tolerance).solve()
        fade = np.exp(-np.pi * distance)
        allowed = max(tolerance, 1e-5) * found.worn_depth + 1e-8
        assert np.all(np.abs(found.rms_height - 0.01 / np.sqrt(2.0) * fade) <= allowed)
        assert np.all(np.abs(found.peak_pressure - 0.1 - np.pi * 0.01 * fade) <= np.sqrt(2.0) * np.pi * allowed)
        assert found.worn_volume == pytest.approx(0.1 * distance, rel=1e-13)


def test_two_waves_decay_each_at_its_own_rate():
    x = np.arange(24) / 24
    heights = 0.004 * np.cos(2.0 * np.pi * x[:, None]) + 0.001 * np.cos(2.0 * np.pi * (2.0 * x[:, None] + 3.0 * x))
    contact = wk.SurfaceContact(wk.Topography(heights, [1.0, 1.0], periodic=True), UNIT, wk.Force(0.1), tolerance=1e-9)
    distance = 0.2
    worn = wk.SurfaceWear(contact, wk.Archard(1.0), [distance], tolerance=1e-5).solve().worn_topography()
    waves = np.abs(np.fft.fft2(worn.heights)) / heights.size
    assert waves[1, 0] == pytest.approx(0.002 * np.exp(-np.pi * distance), rel=2e-4)
    assert waves[2, 3] == pytest.approx(0.0005 * np.exp(-np.pi * np.sqrt(13.0) * distance), rel=2e-3)


@pytest.mark.slow
def test_a_flat_stamp_evens_out_its_pressure():
    """Full contact of a stamp: a linear system, solved by the exponential of its matrix; the force stays."""
    count, force, distance = 9, 0.02, np.array([0.0, 0.03, 0.3, 10.0])
    stamp = wk.Topography(np.zeros((count, count)), [1.0, 1.0])
    contact = wk.SurfaceContact(stamp, UNIT, wk.Force(force), tolerance=1e-9)
    found = wk.SurfaceWear(contact, wk.Archard(1.0), distance, tolerance=1e-5).solve()

    stiff = np.linalg.inv(compliance((count, count), stamp.pixel))
    even = stiff @ np.ones(count**2)
    pixels = count**2
    start = even * force * pixels / np.sum(even)
    system = -(stiff - np.outer(even, even) / np.sum(even))
    for place, far in enumerate(distance):
        pressure = expm(far * system) @ start
        assert found.peak_pressure[place] == pytest.approx(np.max(pressure), rel=1e-4)
    assert found.last.pressure == pytest.approx(np.full((count, count), force), rel=1e-5)
    worn = found.last.worn - np.mean(found.last.worn)
    assert worn.ravel() == pytest.approx(np.linalg.pinv(system) @ (force - start), abs=1e-4 * np.ptp(worn))


@pytest.mark.slow
def test_a_stamp_that_is_held_loses_its_load():
    """Held at a depth: dp/ds = -k E* G^-1 p, from all that presses to nothing."""
    count, depth, distance = 8, 0.01, np.array([0.0, 0.05, 0.5])
    stamp = wk.Topography(np.zeros((count, count)), [1.0, 0.5])
    contact = wk.SurfaceContact(stamp, UNIT, wk.Depth(depth), tolerance=1e-9)
    found = wk.SurfaceWear(contact, wk.Archard(2.0), distance, tolerance=1e-5).solve()
    stiff = np.linalg.inv(compliance((count, count), stamp.pixel))
    patch = stamp.pixel[0] * stamp.pixel[1]
    forces = [patch * np.sum(expm(-2.0 * far * stiff) @ stiff @ np.full(count**2, depth)) for far in distance]
    assert found.force == pytest.approx(forces, rel=2e-4)
    assert found.worn_volume == pytest.approx(2.0 * found.load_distance, rel=1e-13)
    assert np.all(found.imbalance < 1e-13)


@pytest.mark.slow
def test_bumps_that_come_into_contact_one_by_one():
    """Partial contact, against non-negative least squares marched by an explicit method in time."""
    rng = np.random.default_rng(3)
    heights, force, rate, distance = 0.01 * rng.random((6, 7)), 2e-3, 1.0, [0.0, 0.05, 0.3]
    surface = wk.Topography(heights, [1.0, 1.2])
    contact = wk.SurfaceContact(surface, UNIT, wk.Force(force), tolerance=1e-9)
    found = wk.SurfaceWear(contact, wk.Archard(rate), distance, tolerance=1e-5).solve()
    matrix, patch = compliance(heights.shape, surface.pixel), surface.pixel[0] * surface.pixel[1]

    def pressure(worn):
        return pressed(matrix, surface.gaps.ravel() + worn, force / patch)

    march = solve_ivp(
        lambda _, worn: rate * pressure(worn), (0.0, 0.3), np.zeros(42), "RK45", distance, rtol=1e-7, atol=1e-9
    )
    for place, state in enumerate(wk.SurfaceWear(contact, wk.Archard(rate), distance, tolerance=1e-5).steps()):
        worn = march.y[:, place]
        assert state.worn.ravel() == pytest.approx(worn, abs=1e-3 * max(np.max(worn), 1e-12))
        assert state.pressure.ravel() == pytest.approx(pressure(worn), abs=1e-3 * np.max(state.pressure))
    assert np.all(np.diff(found.area) > 0.0)


@pytest.mark.slow
def test_a_ball_is_worn_to_a_cap():
    """Deep wear of a paraboloid: V = pi a^4 / (4 R) = k F s, however it was pressed."""
    ball = wk.SampledProfile([1.0, 1.0], wk.Paraboloid(1.0), (65, 65))
    contact = wk.SurfaceContact(ball, UNIT, wk.Force(1e-4))
    volume = np.pi * 0.3**4 / 4.0
    found = wk.SurfaceWear(contact, wk.Archard(1.0), [0.0, volume / 1e-4], tolerance=3e-4).solve()
    assert found.area[-1] == pytest.approx(np.pi * 0.3**2, rel=0.02)
    assert found.worn_depth[-1] == pytest.approx(0.5 * 0.3**2, rel=0.01)
    assert found.depth[-1] == pytest.approx(0.5 * 0.3**2, rel=0.01)
    assert found.last.pressure[32, 32] == pytest.approx(found.mean_pressure[-1], rel=0.04)


@pytest.mark.slow
def test_nothing_comes_back_and_the_volume_is_balanced():
    spectrum = wk.SelfAffine(hurst=0.8, rms_height=0.01, longest=1.0, shortest=0.15)
    rough = wk.RandomTopography([1.0, 1.0], spectrum, (32, 32), seed=2)
    problem = wk.SurfaceWear(
        wk.SurfaceContact(rough, UNIT, wk.Force(2e-3)), wk.Archard(1.0), [0.0, 0.05, 0.5, 5.0, 100.0], tolerance=3e-3
    )
    states = list(problem.steps())
    for before, after in zip(states[:-1], states[1:], strict=True):
        assert np.all(after.worn >= before.worn)
        assert after.imbalance < 1e-14
    found = problem.gathered(states)
    assert np.all(np.diff(found.area) >= 0.0)
    assert np.all(np.diff(found.rms_height) < 0.0)
    assert found.area[-1] == 1.0  # worn flat in the end, under an even pressure
    assert found.peak_pressure[-1] == pytest.approx(2e-3, rel=1e-6)
    assert found.skewness[2] < found.skewness[0]
    assert np.all(found.mean_pressure <= found.peak_pressure * (1.0 + 1e-12))


def test_a_march_goes_on_from_a_state_with_the_same_numbers(tmp_path):
    from winkler.io.wear_states import read_wear, write_wear

    contact = wk.SurfaceContact(wave(12, 0.02), UNIT, wk.Force(0.01))
    problem = wk.SurfaceWear(contact, wk.Archard(1.0), [0.0, 0.01, 0.05, 0.2], tolerance=1e-2)
    states = list(problem.steps())
    assert list(problem.steps(start=states[1])) == states[2:]
    kept = read_wear(write_wear(states[:3], tmp_path / "worn.npz"))
    assert (kept[0], kept[2]) == (states[0], states[2])
    assert kept[1].area == states[1].area
    assert kept[1].worn.size == 0
    assert list(problem.steps(start=kept[-1])) == states[3:]
    farther = dataclasses.replace(problem, distance=[0.0, 0.01, 0.05, 0.2, 0.4])
    assert list(farther.steps(start=problem.solve().last)) == list(farther.steps())[4:]


@pytest.mark.slow
def test_pressures_stay_below_the_hardness():
    contact = wk.SurfaceContact(wave(32, 0.05), UNIT, wk.Force(5e-3), hardness=0.05)
    found = wk.SurfaceWear(contact, wk.Archard(1.0), [0.0, 0.1, 10.0]).solve()
    assert found.peak_pressure[0] == pytest.approx(0.05, rel=1e-12)
    assert np.all(found.peak_pressure <= 0.05 * (1.0 + 1e-12))
    assert found.peak_pressure[-1] < 0.02
    assert found.worn_volume == pytest.approx(5e-3 * found.distance, rel=1e-13)


def test_a_coating_of_the_same_solid_changes_nothing():
    solid = wk.Elastic(1.0, 0.3)
    coated = wk.CoatedHalfSpace([wk.Layer(solid, 0.1)], on=solid)
    answers = [
        wk.SurfaceWear(wk.SurfaceContact(wave(16, 0.02), medium, wk.Force(0.01)), wk.Archard(1.0), [0.1]).solve()
        for medium in (wk.HalfSpace(solid), coated)
    ]
    assert answers[1].peak_pressure == pytest.approx(answers[0].peak_pressure, rel=1e-6)
    assert any("uppermost" in note.statement for note in answers[1].validity)


def test_what_cannot_be_worn_is_refused():
    contact = wk.SurfaceContact(wave(), UNIT, wk.Force([0.01, 0.02]))
    with pytest.raises(wk.InvalidInput, match="has 2 loads"):
        wk.SurfaceWear(contact, wk.Archard(1.0), [0.1])
    one = dataclasses.replace(contact, load=wk.Force(0.01))
    with pytest.raises(wk.InvalidInput, match="rise"):
        wk.SurfaceWear(one, wk.Archard(1.0), [0.1, 0.05])
    with pytest.raises(wk.InvalidInput, match="tolerance"):
        wk.SurfaceWear(one, wk.Archard(1.0), [0.1], tolerance=0.5)
    state = next(wk.SurfaceWear(one, wk.Archard(1.0), [0.0, 0.1]).steps())
    other = wk.SurfaceWear(dataclasses.replace(one, topography=wave(24)), wk.Archard(1.0), [0.1])
    with pytest.raises(wk.InvalidInput, match="map of"):
        next(other.steps(start=state))
