"""Surfaces and lines made at random: they have the stated spectrum."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.profiles.rough.random_rough import random_line, random_topography
from winkler.profiles.rough.spectrum import PowerSpectrum, SelfAffine
from winkler.values.errors import InvalidInput

BLASTED = SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=1e-5, roll_off=2.5e-4)


@pytest.mark.parametrize("hurst", [0.2, 0.5, 0.8, 1.0])
@pytest.mark.parametrize("roll_off", [1e-3, 2e-4])
@pytest.mark.parametrize(("shape", "lengths"), [((256, 256), (1e-3, 1e-3)), ((255, 512), (1e-3, 2.5e-3))])
def test_a_surface_has_the_height_and_slope_of_its_spectrum(hurst, roll_off, shape, lengths):
    """Also where few waves fit: the power of a wave is that of its cell, not of its point."""
    spectrum = SelfAffine(hurst, rms_height=1e-6, longest=1e-3, shortest=1e-5, roll_off=roll_off)
    rough = random_topography(spectrum, shape, lengths, seed=1)
    assert rough.periodic
    assert rough.heights.shape == shape
    assert rough.lengths.tolist() == list(lengths)
    assert rough.rms_height == pytest.approx(1e-6, rel=2e-3)
    waves = np.fft.fft2(rough.heights)
    q2 = sum(
        ((2.0 * np.pi * np.fft.fftfreq(n, length / n)) ** 2).reshape(side)
        for n, length, side in zip(shape, lengths, ((-1, 1), (1, -1)), strict=True)
    )
    slope = np.sqrt(np.sum(q2 * np.abs(waves) ** 2)) / (shape[0] * shape[1])
    # the longest waves bear the power of a cell whose mean square wave number is not theirs: visible where H is one
    assert slope == pytest.approx(spectrum.rms_slope, rel=1e-2)


def test_every_wave_has_the_power_of_its_cell():
    """In the middle of a self-affine spectrum that is C(q) times the cell, up to its curvature."""
    rough = random_topography(BLASTED, (256, 256), (1e-3, 1e-3), seed=4)
    power = np.abs(np.fft.fft2(rough.heights) / 256**2) ** 2
    q = 2.0 * np.pi * np.hypot(*np.meshgrid(*2 * [np.fft.fftfreq(256, 1.0 / 256) * 1e3], indexing="ij"))
    middle = (q > 2.0 * np.pi * 2e4) & (q < 2.0 * np.pi * 9e4)
    expected = BLASTED.at(q) * (2.0 * np.pi / 1e-3) ** 2
    np.testing.assert_allclose(power[middle], expected[middle], rtol=5e-3)
    assert np.max(power[q > 2.0 * np.pi * 1.02e5]) < 1e-20 * np.max(power)
    assert np.mean(rough.heights) == pytest.approx(0.0, abs=1e-20)


def test_heights_are_gaussian():
    """Many waves of random phases: of 16 surfaces the mean skewness is 0 and the mean kurtosis 3."""
    level = SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=2e-5, roll_off=1e-4)
    maps = [random_topography(level, (128, 128), (1e-3, 1e-3), seed) for seed in range(16)]
    assert np.mean([rough.skewness for rough in maps]) == pytest.approx(0.0, abs=0.05)
    assert np.mean([rough.kurtosis for rough in maps]) == pytest.approx(3.0, abs=0.1)


def test_equal_seeds_make_equal_surfaces():
    maps = [random_topography(BLASTED, (32, 48), (1e-3, 1e-3), seed) for seed in (1, 1, 2)]
    assert maps[0] == maps[1]
    assert not np.allclose(maps[0].heights, maps[2].heights)
    lines = [random_line(BLASTED, 301, 1e-3, seed) for seed in (1, 1, 2)]
    assert np.array_equal(lines[0], lines[1])
    assert not np.allclose(lines[0], lines[2])


def test_waves_longer_than_the_map_are_left_out():
    """A map of a hundredth of the longest wave: what is left is the spectrum from half of its wave number on."""
    whole = SelfAffine(hurst=0.5, rms_height=1e-6, longest=1e-2, shortest=1e-6)
    rough = random_topography(whole, (256, 256), (1e-4, 1e-4), seed=0)
    low = 2.0 * np.pi / 1e-4
    q = np.geomspace(low, 2.0 * np.pi / 1e-6, 1000)
    at_most = PowerSpectrum(np.concatenate(([0.5 * low], q)), whole.at(np.concatenate(([0.5 * low], q))))
    at_least = PowerSpectrum(q, whole.at(q))
    assert at_least.rms_height < rough.rms_height < at_most.rms_height


@pytest.mark.parametrize("count", [2**13, 3**8])
@pytest.mark.parametrize("hurst", [0.3, 0.8])
def test_a_line_keeps_heights_and_gradients(count, hurst):
    """Theory 10: C_1D = pi q C keeps the root mean square of both."""
    spectrum = SelfAffine(hurst, rms_height=1e-6, longest=1e-3, shortest=1e-5)
    line = random_line(spectrum, count, 1.1523e-3, seed=3)
    assert line.shape == (count,)
    assert np.mean(line) == pytest.approx(0.0, abs=1e-19)
    assert np.std(line) == pytest.approx(1e-6, rel=2e-3)
    waves = np.abs(np.fft.fft(line) / count) ** 2
    slope = np.sqrt(np.sum((2.0 * np.pi * np.fft.fftfreq(count, 1.1523e-3 / count)) ** 2 * waves))
    assert slope == pytest.approx(spectrum.rms_slope, rel=5e-3)


def test_waves_that_do_not_fit_are_refused():
    with pytest.raises(InvalidInput, match=r"^random_topography: no wave between 1e-05 m and 0.001 m fits a map of"):
        random_topography(BLASTED, (16, 16), (1e-7, 1e-7), seed=0)
    with pytest.raises(InvalidInput, match=r"^random_line: no wave between 1e-05 m and 0.001 m fits a line of 1e-07 m"):
        random_line(BLASTED, 16, 1e-7, seed=0)


@pytest.mark.parametrize(
    ("shape", "lengths", "seed", "sentence"),
    [
        ((16,), (1.0, 1.0), 0, r"shape is \(16,\); give two whole numbers of pixels, at least 4"),
        ((16, 2), (1.0, 1.0), 0, r"shape is \(16, 2\); give two whole numbers"),
        ((16.0, 16), (1.0, 1.0), 0, r"shape is \(16.0, 16\); give two whole numbers"),
        ((16, 16), (1.0, -1.0), 0, r"lengths are \(1.0, -1.0\); give two positive lengths in m"),
        ((16, 16), "1 mm", 0, "lengths are '1 mm'; give two positive lengths in m"),
        ((16, 16), (1.0, 1.0), -1, "seed is -1; give a whole number"),
        ((16, 16), (1.0, 1.0), 0.5, "seed is 0.5; give a whole number"),
    ],
)
def test_wrong_numbers_are_refused(shape, lengths, seed, sentence):
    with pytest.raises(InvalidInput, match=f"^random_topography: {sentence}"):
        random_topography(BLASTED, shape, lengths, seed)


def test_a_map_that_does_not_fit_the_memory_is_refused(monkeypatch):
    def none_left(*_):
        raise MemoryError

    monkeypatch.setattr("winkler.profiles.rough.random_rough._cells", none_left)
    with pytest.raises(InvalidInput, match=r"4000 x 4000 pixels need 1.12 GB of memory, which this machine does not"):
        random_topography(BLASTED, (4000, 4000), (1.0, 1.0), seed=0)
