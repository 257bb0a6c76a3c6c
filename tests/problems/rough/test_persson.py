"""Persson's theory: against mpmath, an independent quadrature of the formula as printed, limits, boundary elements."""

from __future__ import annotations

import csv
import math

import mpmath
import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import erf

from winkler.problems.rough.persson import area_fraction, mean_separation
from winkler.profiles.rough.map_spectrum import spectrum_of
from winkler.profiles.rough.spectrum import PowerSpectrum, SelfAffine
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput

WIDE = SelfAffine(hurst=0.8, rms_height=0.025, longest=0.5, shortest=1.0 / 64)


def test_area():
    with mpmath.workdps(30):
        expected = [float(mpmath.erf(mpmath.sqrt(2) * mpmath.mpf(p))) for p in ("1e-4", "0.1", "2")]
    assert area_fraction(np.array([1e-4, 0.1, 2.0]), 1.0, 1.0) == pytest.approx(expected, rel=1e-12)


def test_area_at_small_pressures():
    """sqrt(8 / pi) p / (E* h')."""
    assert float(area_fraction(np.array(3e-5), 2.0, 0.5)) == pytest.approx(math.sqrt(8.0 / math.pi) * 3e-5, rel=1e-8)


def test_wrong_pressures_are_refused():
    for pressure in (-1.0, np.nan, np.inf):
        with pytest.raises(InvalidInput, match="pressure must not be negative"):
            area_fraction(np.array(pressure), 1.0, 1.0)
    with pytest.raises(InvalidInput, match="rms_slope is 0"):
        area_fraction(np.array(1.0), 1.0, 0.0)
    with pytest.raises(InvalidInput, match="a pressure is zero"):
        mean_separation(np.array([0.0, 1.0]), 1.0, WIDE)
    assert area_fraction(np.array(0.0), 1.0, 1.0) == 0.0


def separation(pressure, spectrum, hurst):
    """Return Yang and Persson's double integral as it is printed, for a pure power law, by nested adaptive rules."""
    low, high = spectrum.smallest, spectrum.greatest
    density = float(spectrum.at(np.array(low * 1.5))) * (low * 1.5) ** (2.0 * hurst + 2.0)

    def w(q):
        power = density * (q ** (2.0 - 2.0 * hurst) - low ** (2.0 - 2.0 * hurst)) / (2.0 - 2.0 * hurst)
        return (math.pi * power) ** -0.5

    def inner(q):
        def integrand(logarithm):
            s = w(q) * math.exp(logarithm)
            return (0.45 + 3.0 * 0.55 * erf(s) ** 2) * math.exp(-(s**2))

        last = math.log(7.0 / w(q))
        return quad(integrand, math.log(pressure), last, epsrel=1e-11, limit=200)[0] if last > math.log(pressure) else 0

    def outer(v):  # q = low + v^2 takes the root at the smallest wave number away
        q = low + v * v
        return 2.0 * v * q**2 * density * q ** (-2.0 * hurst - 2.0) * w(q) * inner(q) if v > 1e-6 else 0.0

    ends = math.sqrt(high - low) * np.array([0.0, 0.01, 0.05, 0.2, 0.5, 1.0])
    return math.sqrt(math.pi) * sum(quad(outer, a, b, epsrel=1e-8)[0] for a, b in zip(ends, ends[1:], strict=False))


@pytest.mark.parametrize("pressure", [0.002, 0.4])
def test_gap_is_the_double_integral(pressure):
    result = mean_separation(np.array(pressure), 1.0, WIDE)
    assert float(result) == pytest.approx(separation(pressure, WIDE, 0.8), rel=3e-7)


def test_gap_falls_with_the_logarithm_of_small_pressures():
    """u = u_0 ln(p_c / p), u_0 = gamma sqrt(pi) times the integral of q^2 C w (Persson 2007)."""
    gaps = mean_separation(np.array([1e-8, 1e-7, 1e-6]), 1.0, WIDE)
    q = WIDE.smallest + np.linspace(0.0, math.sqrt(WIDE.greatest - WIDE.smallest), 20001)[1:] ** 2
    density = WIDE.at(q)[0] * q[0] ** 3.6
    w = (math.pi * density * (q**0.4 - WIDE.smallest**0.4) / 0.4) ** -0.5
    slope = 0.45 * math.sqrt(math.pi) * np.trapezoid(q**2 * WIDE.at(q) * w * 2.0 * np.sqrt(q - WIDE.smallest),
                                                     np.sqrt(q - WIDE.smallest))  # fmt: skip
    assert -np.diff(gaps) / math.log(10.0) == pytest.approx([slope, slope], rel=1e-3)


def test_gap_closes_under_great_pressures():
    gaps = mean_separation(np.array([1.0, 2.0, 5.0, 20.0]) * WIDE.rms_slope, 1.0, WIDE)
    assert np.all(np.diff(gaps) < 0.0)
    assert 0.0 < gaps[1] < 1e-3 * WIDE.rms_height
    assert 0.0 <= gaps[3] < 1e-15


def test_gap_scales_with_height_and_modulus():
    double = SelfAffine(hurst=0.8, rms_height=0.05, longest=0.5, shortest=1.0 / 64)
    pressure = np.array([[1e-3], [1e-1]])
    one, two = mean_separation(pressure, 1.0, WIDE), mean_separation(10.0 * pressure, 5.0, double)
    assert one.shape == (2, 1)
    assert two == pytest.approx(2.0 * one, rel=1e-12)


def test_a_measured_spectrum_is_taken_as_well():
    q = np.geomspace(WIDE.smallest, WIDE.greatest, 300)
    same = PowerSpectrum(q, WIDE.at(q))
    pressure = np.array([1e-3, 1e-1])
    assert mean_separation(pressure, 1.0, same) == pytest.approx(mean_separation(pressure, 1.0, WIDE), rel=1e-5)


def test_the_gap_of_a_line():
    """All power at one wave number q: the integral over t = 1/w has 1/q before it (module docstring)."""
    x = 2.0 * math.pi * np.arange(256) / 256
    wave = Topography(np.tile(1e-3 * np.sin(20.0 * x)[:, None], 256), [1.0, 1.0], periodic=True)
    q, p = 40.0 * math.pi, 1e-2

    def work(s):
        return quad(lambda t: (0.45 + 1.65 * math.erf(t) ** 2) * math.exp(-(t**2)) / t, s, 12.0)[0]

    whole = quad(lambda t: work(p / t), 1e-3, 1e-3 * q / 2.0)[0]  # h' / sqrt(2), and h' = q h / sqrt(2)
    result = mean_separation(np.array(p), 1.0, spectrum_of(wave))
    assert float(result) == pytest.approx(2.0 / math.sqrt(math.pi) * whole / q, rel=5e-3)


def test_gap_and_area_against_boundary_elements(shared_data):
    """One periodic surface of root mean square slope 1 (Tamaas, H = 0.8, waves from L/64 to L/2).

    The theory's gap lies 5 to 2 per cent too high up to p = 0.02 E* h', 6 per cent too low at 0.1 and 24 at 0.4; with
    the gradient and not the height of that surface taken over, since few long waves carry its height. Its area lies a
    third too low at small pressures.
    """
    slope = SelfAffine(hurst=0.8, rms_height=1.0, longest=0.5, shortest=1.0 / 64).rms_slope
    surface = SelfAffine(hurst=0.8, rms_height=1.0 / slope, longest=0.5, shortest=1.0 / 64)
    with (shared_data / "reference" / "rough_periodic.csv").open() as file:
        table = [row for row in csv.DictReader(file) if (row["n"], row["tol"]) == ("512", "1e-09")]
    pressure, gap, area = (
        np.array([float(row[word]) for row in table])
        for word in ("p/(E*rms_slope)", "mean_gap/L", "area_frac_corrected")
    )
    expected = [1.045, 1.027, 1.024, 1.012, 0.983, 0.946, 0.878, 0.763]
    assert pressure.tolist() == [0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.4]
    assert mean_separation(pressure, 1.0, surface) / gap == pytest.approx(expected, abs=2e-3)
    share = area_fraction(pressure, 1.0, 1.0) / area
    assert share == pytest.approx([0.673, 0.743, 0.746, 0.75, 0.77, 0.795, 0.842, 0.914], abs=2e-3)
