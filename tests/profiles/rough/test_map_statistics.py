"""Statistics of height maps: waves and Gaussian heights, whose numbers are known."""

from __future__ import annotations

import math

import numpy as np
import pytest

from winkler.profiles.rough.map_statistics import bearing_heights, correlation_length, map_statistics
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput

X = np.arange(512) / 512


def wave(height=0.01, periodic=True, rows=16):
    return Topography(np.repeat(height * np.cos(2.0 * np.pi * X)[:, None], rows, 1), [1.0, 0.1], periodic=periodic)


def test_a_wave():
    """Sa = 2 D / pi, Sq = D / sqrt 2, Sku = 3/2, Sdq = sqrt 2 pi D; Sdr by an elliptic integral, here by its series."""
    found = map_statistics(wave())
    assert found.arithmetic_height == pytest.approx(0.02 / math.pi, rel=1e-4)
    assert found.rms_height == pytest.approx(0.01 / math.sqrt(2.0), rel=1e-12)
    assert found.skewness == pytest.approx(0.0, abs=1e-12)
    assert found.kurtosis == pytest.approx(1.5, rel=1e-12)
    assert found.peak_height == pytest.approx(0.01, rel=1e-12)
    assert found.valley_depth == pytest.approx(0.01, rel=1e-12)
    assert found.rms_slope == pytest.approx(math.sqrt(2.0) * math.pi * 0.01, rel=1e-4)
    s = (2.0 * math.pi * 0.01) ** 2
    assert found.developed_share == pytest.approx(s / 4.0 - 3.0 * s**2 / 64.0, rel=1e-4)


def test_a_tilted_plane_with_a_hole():
    """The area of a plane grows as sqrt(1 + slope^2), on pixels that are not square."""
    x, y = np.arange(20)[:, None] / 20 * 2.0, np.arange(30) / 30 * 1.0
    heights = 0.3 * x + 0.4 * y
    heights[4:7, 9] = np.nan
    found = map_statistics(Topography(heights, [2.0, 1.0]))
    assert found.rms_slope == pytest.approx(0.5, rel=1e-12)
    assert found.developed_share == pytest.approx(math.sqrt(1.25) - 1.0, rel=1e-12)


def test_the_bearing_curve_of_a_wave():
    """The share t of a wave lies above D cos(pi t)."""
    shares = np.linspace(0.05, 0.95, 7)
    np.testing.assert_allclose(bearing_heights(wave(), shares), 0.01 * np.cos(np.pi * shares), atol=1e-4)
    with pytest.raises(InvalidInput, match="from 0 to 1"):
        bearing_heights(wave(), [0.5, 1.5])


def test_the_correlation_length_of_gaussian_hills():
    """Waves weighted by exp(-q^2 l^2 / 4) have the autocorrelation exp(-r^2 / (2 l^2)): 0.2 at l sqrt(2 ln 5)."""
    pytest.importorskip("SurfaceTopography")
    length, count = 0.02, 256
    q = 2.0 * np.pi * np.hypot(np.fft.fftfreq(count, 1 / count)[:, None], np.fft.fftfreq(count, 1 / count))
    rng = np.random.default_rng(1)
    white = np.fft.fft2(rng.standard_normal((count, count)))
    heights = np.fft.ifft2(white / np.abs(white) * np.exp(-((q * length) ** 2) / 4.0)).real
    surface = Topography(heights, [1.0, 1.0], periodic=True)
    assert correlation_length(surface) == pytest.approx(length * math.sqrt(2.0 * math.log(5.0)), rel=0.02)
    small = Topography(1e-9 * heights, [1.0, 1.0], periodic=True)
    assert correlation_length(small) == pytest.approx(correlation_length(surface), rel=1e-9)


def test_bad_maps():
    flat = Topography(np.ones((4, 4)), [1.0, 1.0])
    with pytest.raises(InvalidInput, match="flat"):
        map_statistics(flat)
    with pytest.raises(InvalidInput, match="flat"):
        correlation_length(flat)
    holes = np.arange(16.0).reshape(4, 4)
    holes[1::2] = np.nan
    with pytest.raises(InvalidInput, match="four neighbouring"):
        map_statistics(Topography(holes, [1.0, 1.0]))
    with pytest.raises(InvalidInput, match="missing"):
        correlation_length(Topography(holes, [1.0, 1.0]))
