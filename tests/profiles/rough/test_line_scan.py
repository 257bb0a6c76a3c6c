"""Spectra of line scans: against the integral over the surface's own, and scans of surfaces made at random."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad

from winkler.profiles.rough.line_scan import LineScan, spectrum_of_lines
from winkler.profiles.rough.random_rough import random_topography
from winkler.profiles.rough.spectrum import SelfAffine
from winkler.values.errors import InvalidInput


def along_a_line(density, q, bend):
    """2 times the integral of C s / sqrt(s^2 - q^2) over s from q on, with s^2 = q^2 + y^2."""
    edge = np.sqrt(max(bend**2 - q**2, 0.0))
    level = 2.0 * quad(lambda y: density(np.hypot(q, y)), 0.0, edge, epsrel=1e-10)[0] if edge > 0.0 else 0.0
    return level + 2.0 * quad(lambda y: density(np.hypot(q, y)), edge, np.inf, epsrel=1e-10)[0]


@pytest.mark.parametrize("hurst", [0.3, 0.8])
def test_a_surface_that_is_level_at_long_waves(hurst):
    """The better, the closer the numbers lie: between them a spectrum is taken for a power law."""

    def density(q):
        return np.maximum(q, 1.0) ** (-2.0 * hurst - 2.0)

    errors = []
    for count in (11, 61):
        q = np.geomspace(0.1, 100.0, count)
        found = spectrum_of_lines(q, np.array([along_a_line(density, s, 1.0) for s in q]))
        errors.append(np.max(np.abs(found.densities / density(q) - 1.0)[np.abs(np.log(q)) > 0.3]))
    assert errors[1] < 0.025
    assert errors[1] < 0.1 * errors[0]  # second order: (10 / 60)^2 = 0.03


def test_scans_of_a_random_surface():
    """The mean of 512 x 4 scans gives the surface; not its last octave, beyond which nothing was measured."""
    surface = SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=1e-5, roll_off=2.5e-4)
    count, length = 512, 2e-3
    scans = [random_topography(surface, (count, count), (length, length), seed).heights for seed in range(4)]
    # the power of a wave and of its mirror image, per wave number
    powers = np.mean(np.abs(np.fft.fft(scans, axis=1) / count) ** 2, axis=(0, 2)) * length / (2.0 * np.pi)
    q = 2.0 * np.pi * np.arange(count) / length
    observed = slice(2, 195)
    found = spectrum_of_lines(q[observed], powers[observed])
    inside = (found.wave_numbers > 3e4) & (found.wave_numbers < 3e5)
    stated = found.wave_numbers[inside]
    np.testing.assert_allclose(found.densities[inside], surface.at(stated), rtol=0.06)
    assert found.rms_height == pytest.approx(1e-6, rel=0.05)
    assert np.max(np.diff(np.log10(found.wave_numbers[10:]))) < 0.11  # thinned


def test_scatter_does_not_make_densities_negative():
    q = np.geomspace(1.0, 1e3, 60)
    scattered = q**-2.4 * np.random.default_rng(0).exponential(size=60)
    found = spectrum_of_lines(q, scattered)
    assert np.all(found.densities > 0.0)
    exponent, factor = 2.4, 0.5583  # Gamma(1.7) / (sqrt(pi) Gamma(1.2)) where lines fall with q^-2.4
    ratio = found.densities / (factor * q ** (-exponent - 1.0))
    assert 0.6 < np.mean(ratio) < 1.6


@pytest.mark.parametrize(
    ("q", "density", "sentence"),
    [
        ([1.0, 2.0, 3.0], [1.0, 1.0, 2.0], "spectrum_of_lines: the densities do not fall with the wave number"),
        ([1.0, 2.0, 2.0], [3.0, 2.0, 1.0], "PowerSpectrum: wave_numbers does not rise"),
        ([1.0, 2.0, 3.0], [3.0, 2.0, 0.0], "PowerSpectrum: densities is .*; give a row of at least 2 positive"),
    ],
)
def test_what_is_no_spectrum_of_lines(q, density, sentence):
    with pytest.raises(InvalidInput, match=f"^{sentence}"):
        spectrum_of_lines(np.array(q), np.array(density))


@pytest.mark.slow
def test_single_scans_of_a_random_surface():
    """A scan gives the surface within its scatter: the mean over 128 scans, window and tilt included."""
    surface = SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=3.2e-5, roll_off=2.5e-4)
    maps = [random_topography(surface, (256, 256), (4e-3, 4e-3), seed) for seed in range(8)]
    x = np.arange(256) * maps[0].pixel[1]
    found = [LineScan(x, made.heights[i] + 1e-3 * x + 5e-6).spectrum for made in maps for i in range(0, 256, 16)]
    q = np.geomspace(2e4, 1.5e5, 8)
    ratio = np.mean([each.at(q) / surface.at(q) for each in found], axis=0)
    assert np.all((ratio > 0.7) & (ratio < 1.1))  # levelled scatter is low in the mean, as the docstring states
    assert np.mean([each.rms_height for each in found]) == pytest.approx(1e-6, rel=0.1)
    assert np.mean([each.rms_slope for each in found]) == pytest.approx(surface.rms_slope, rel=0.05)


def test_a_wave_in_a_scan_has_its_height_where_it_is():
    x = np.sort(np.random.default_rng(5).uniform(0.0, 1e-3, 4000))  # uneven steps are made even
    scan = LineScan(x, 1e-7 * np.sin(2e5 * x))
    assert scan.rms_height == pytest.approx(1e-7 / np.sqrt(2.0), rel=1e-2)
    spectrum = scan.spectrum
    assert spectrum.greatest > 10.0 * 2e5
    steep = spectrum.wave_numbers < 1e5
    beyond = spectrum.wave_numbers > 3e5
    assert np.max(spectrum.densities[beyond]) < 1e-3 * np.min(spectrum.densities[steep])


@pytest.mark.parametrize(
    ("position", "heights", "sentence"),
    [
        (range(64), range(63), "give a row of at least 64 finite numbers"),
        (range(10), range(10), "give a row of at least 64 finite numbers"),
        (range(64, 0, -1), range(64), "position does not rise from index 0"),
        (range(64), [float("nan")] * 64, "give a row of at least 64 finite numbers"),
        ("place", "height", "give a row of"),
    ],
)
def test_what_is_no_scan(position, heights, sentence):
    with pytest.raises(InvalidInput, match=sentence):
        LineScan(position if isinstance(position, str) else list(position), list(heights))
