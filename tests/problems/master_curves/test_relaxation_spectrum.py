"""Relaxation spectra of closed formulas: moduli, bands, and the times at which they are determined."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

FEW = 40
EXPONENT, SHEAR = 0.45, 1e5
OMEGA = np.geomspace(1e-2, 1e2, 25)
TIME = np.geomspace(1e-2, 1e3, 60)


def dynamic(rng, scatter=0.02):
    turns = (1j * OMEGA) ** EXPONENT
    modulus = 1e3 + SHEAR * turns / (1.0 + turns)
    noise = np.exp(scatter * rng.standard_normal((2, OMEGA.size)))
    return wk.DynamicData(OMEGA, modulus.real * noise[0], modulus.imag * noise[1])


def density(time):
    """H(ln tau) of Cole and Cole: K. S. Cole, R. H. Cole, J. Chem. Phys. 9 (1941) 341, doi:10.1063/1.1750906."""
    x = EXPONENT * np.log(time)
    return SHEAR / (2.0 * np.pi) * np.sin(EXPONENT * np.pi) / (np.cosh(x) + np.cos(EXPONENT * np.pi))


def relaxation(time):
    return 1e3 + 5e3 / (1.0 + time / 0.5) ** 0.6


def test_the_spectrum_is_that_of_cole_and_cole():
    found = wk.RelaxationSpectrum(dynamic(np.random.default_rng(0), 0.0)).solve()
    times = found.relaxation_times
    inner = (times > 0.03) & (times < 30.0)
    assert found.shears[inner] == pytest.approx(density(times[inner]) * np.log(times[1] / times[0]), rel=0.02)


@pytest.mark.long
def test_bands_hold_the_truth_as_often_as_they_say():
    held, spectrum = [], []
    at = np.geomspace(3e-2, 3e2, 9)
    for seed in range(FEW):
        rng = np.random.default_rng(seed)
        noisy = relaxation(TIME) * np.exp(0.02 * rng.standard_normal(TIME.size))
        band = wk.RelaxationSpectrum(wk.RelaxationData(TIME, noisy)).solve().relaxation_interval(at)
        held.append((band.low <= relaxation(at)) & (relaxation(at) <= band.high))
        found = wk.RelaxationSpectrum(dynamic(rng)).solve()
        times, step = found.relaxation_times, np.log(found.relaxation_times[1] / found.relaxation_times[0])
        inner = (times > 0.03) & (times < 30.0)
        score = np.log(found.shears / (density(times) * step)) / found.shears_error
        spectrum.append(np.abs(score[inner]) < 1.96)
    assert 0.89 <= np.mean(held) <= 0.99
    assert np.mean(spectrum) >= 0.92


def test_the_determined_range_is_that_of_the_data():
    found = wk.RelaxationSpectrum(dynamic(np.random.default_rng(1))).solve()
    low, high = found.determined
    assert 0.3e-3 < low < 0.05
    assert 20.0 < high < 3e3
    beyond = found.relaxation_times > 500.0
    assert np.min(found.shears_error[beyond]) > np.median(found.shears_error)


def test_moduli_are_positive_and_the_band_contains_the_modulus():
    found = wk.RelaxationSpectrum(wk.RelaxationData(TIME, relaxation(TIME)), per_decade=3).solve()
    assert np.all(found.shears > 0.0)
    band = found.relaxation_interval([0.1, 1.0])
    assert np.all((band.low < band.modulus) & (band.modulus < band.high))
    assert band.modulus == pytest.approx(found.solid.relaxation([0.1, 1.0]), rel=1e-6)
    assert band.modulus == pytest.approx(relaxation(np.array([0.1, 1.0])), rel=2e-3)
    with pytest.raises(wk.InvalidInput, match="time is"):
        found.relaxation_interval(-1.0)
