"""Friction of rough elastomers: closed forms in both limits, and springs that slide step by step over random lines."""

from __future__ import annotations

import math

import numpy as np
import pytest

from winkler.materials.elastic import Elastic
from winkler.materials.spring_and_dashpot import KelvinVoigt, StandardSolid
from winkler.materials.viscoelastic import Prony
from winkler.problems.rough.elastomer_friction import ElastomerFriction
from winkler.profiles.rough.map_spectrum import spectrum_of
from winkler.profiles.rough.random_rough import random_lines
from winkler.profiles.rough.spectrum import PowerSpectrum, SelfAffine
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput
from winkler.values.validity import Standing

ROUGH = SelfAffine(hurst=0.7, rms_height=0.01, longest=1.0, shortest=1.0 / 64)
RUBBER = StandardSolid(relaxed_shear=1.0, shear=10.0, relaxation_time=1e-2)


def mean_wave_number(hurst, low, high):
    """Return the mean of q under the weight q^3 C of a power law C ~ q^(-2 H - 2)."""
    p = 2.0 - 2.0 * hurst
    return (high ** (p + 1.0) - low ** (p + 1.0)) / (p + 1.0) / ((high**p - low**p) / p)


def test_slowly_it_grows_with_the_velocity():
    """G'' / |G| -> q v tau G_1 / G_inf."""
    slow = np.array([1e-8, 2e-8])
    result = ElastomerFriction(ROUGH, RUBBER, slow).solve().coefficient
    mean = mean_wave_number(0.7, ROUGH.smallest, ROUGH.greatest)
    assert result == pytest.approx(ROUGH.rms_slope * 10.0 * 1e-2 * mean * slow, rel=1e-4)


def test_fast_it_falls_with_the_velocity():
    """Of a standard solid G'' / |G| -> G_1 / ((G_1 + G_inf) q v tau); a Kelvin solid tends to h'."""
    fast = np.array([1e6, 1e7])
    result = ElastomerFriction(ROUGH, RUBBER, fast).solve().coefficient
    assert result[1] / result[0] == pytest.approx(0.1, rel=1e-4)
    kelvin = ElastomerFriction(ROUGH, KelvinVoigt(1.0, 1.0), fast).solve().coefficient
    assert kelvin == pytest.approx(ROUGH.rms_slope, rel=1e-6)


def test_between_there_is_a_peak():
    """Of one wave: G'' / |G| has its greatest value r / (2 + r) at v q tau = (1 + r)^(-1/2), r = G_1 / G_inf."""
    q = 100.0
    one = PowerSpectrum(q * np.array([1.0, 1.0 + 1e-9]), np.array([1e-8, 1e-8]))
    velocity = np.geomspace(1e-3, 1e3, 2001) / (q * 1e-2)
    result = ElastomerFriction(one, RUBBER, velocity).solve().coefficient / one.rms_slope
    assert np.max(result) == pytest.approx(10.0 / 12.0, rel=1e-5)
    assert velocity[np.argmax(result)] * q * 1e-2 == pytest.approx(11.0**-0.5, rel=1e-2)


def test_a_solid_of_many_times_is_level():
    """G ~ omega^n: the same loss at all velocities, mu = h' sin(pi n / 2)."""
    n, times = 0.3, np.geomspace(1e-12, 1e12, 241)
    broad = Prony(1e-9, times**-n, times)
    result = ElastomerFriction(ROUGH, broad, np.geomspace(1e-4, 1e2, 7)).solve().coefficient
    assert result == pytest.approx(ROUGH.rms_slope * math.sin(0.5 * math.pi * n), rel=2e-3)


def test_a_line_of_a_measured_spectrum_counts_whole():
    """Parallel waves of one length: mu = h' sin(delta) at the frequency with which they pass."""
    x = np.arange(256) / 256
    wave = Topography(np.tile(np.sin(2.0 * np.pi * 20.0 * x)[:, None], 256), [1.0, 1.0], periodic=True)
    velocity, q = np.array([1e-4, 1e-2, 1.0]), 40.0 * math.pi
    result = ElastomerFriction(spectrum_of(wave), RUBBER, velocity).solve().coefficient
    omega = 1e-2 * q * velocity  # relaxation time 10 ms, moduli 1 and 11
    storage, loss = 1.0 + 10.0 * omega**2 / (1.0 + omega**2), 10.0 * omega / (1.0 + omega**2)
    assert result == pytest.approx(q / 2.0**0.5 * loss / np.hypot(storage, loss), rel=5e-3)


def sliding(depth, velocities, count=2048, lines=40):
    """Return mu / h' and the touching share of springs of RUBBER under random lines, followed step by step."""
    heights = np.array(list(random_lines(ROUGH, count, 1.0, range(lines))))
    pressed = heights - heights.max(axis=1, keepdims=True) + depth
    slopes = (pressed - np.roll(pressed, 1, axis=1)) * count
    result = []
    for velocity in velocities:
        left = 1.0 / (1.0 + 1.0 / (count * velocity * RUBBER.relaxation_time))
        u, q, sums = np.zeros(lines), np.zeros(lines), np.zeros(3)
        for lap in range(2):
            for j in range(count):
                target = pressed[:, j]
                force = target + (q + 10.0 * (target - u)) * left
                touching = force > 0.0
                new = np.where(touching, target, (10.0 * left * u - q * left) / (1.0 + 10.0 * left))
                q, u = (q + 10.0 * (new - u)) * left, new
                if lap:
                    force = np.where(touching, force, 0.0)
                    sums += np.sum(force * slopes[:, j]), np.sum(force), np.sum(touching)
        result.append((sums[0] / sums[1] / ROUGH.rms_slope, sums[2] / (count * lines)))
    return np.array(result).T


def test_against_springs_that_slide():
    velocities = np.array([0.01, 0.1, 1.0])
    followed, share = sliding(0.005, velocities)
    result = ElastomerFriction(ROUGH, RUBBER, velocities).solve().coefficient / ROUGH.rms_slope
    assert np.all(share < 0.1)
    assert followed == pytest.approx(result, rel=0.3)
    closer, share = sliding(0.02, velocities[:1])
    assert share[0] > 0.4
    assert 0.2 * result[0] < closer[0] < 0.5 * result[0]


def test_it_is_labelled():
    (note,) = ElastomerFriction(ROUGH, RUBBER, 1.0).solve().validity
    assert note.standing is Standing.APPROXIMATE
    assert "trend" in note.statement


def test_wrong_questions_are_refused():
    with pytest.raises(InvalidInput, match="solid is a Elastic; give a viscoelastic solid"):
        ElastomerFriction(ROUGH, Elastic(1.0, 0.3), 1.0)
    for velocity in (0.0, -1.0, np.nan, "fast"):
        with pytest.raises(InvalidInput, match="give a number or an array of positive, finite numbers in m/s"):
            ElastomerFriction(ROUGH, RUBBER, velocity)
