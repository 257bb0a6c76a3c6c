"""Axisymmetric waves against Struve functions of mpmath and quadrature of T1."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from shape_solutions import assert_curvature, assert_starts_at_zero, assert_transforms

import winkler as wk

H, L = 1e-7, 2e-5


@pytest.mark.slow
def test_against_quadrature():
    k = 2 * mp.pi / mp.mpf(L)
    # where g' is near a root its relative error has no meaning: places between the roots
    x = L * np.array([1e-4, 0.01, 0.1, 0.2, 0.55, 0.9, 1.1, 2.15])
    assert_transforms(wk.Wavy(H, L), lambda r: H * k * mp.sin(k * r), x, rtol=1e-12)
    assert_curvature(wk.Wavy(H, L), lambda r: H * k * mp.sin(k * r), x)
    assert_starts_at_zero(wk.Wavy(H, L))


def test_against_mpmath_struve():
    """g = (pi/2) h k x H0(kx), its derivative, and Int g = (pi/2) h x H1(kx), also at 300 waves."""
    mp.mp.dps = 30
    x = L * np.concatenate([np.geomspace(1e-8, 1.0, 9), [3.3, 17.1, 99.9, 300.2]])
    k = 2 * mp.pi / mp.mpf(L)
    wave = wk.Wavy(H, L)
    arguments = [k * mp.mpf(v) for v in x]
    scale = np.array([float(mp.pi / 2 * H * max(t, t**2)) for t in arguments])
    gap = [float(mp.pi / 2 * H * t * mp.struveh(0, t)) for t in arguments]
    assert np.all(np.abs(wave.gap(x) - gap) <= 1e-12 * np.minimum(scale, np.abs(gap) + 1e-12 * scale))
    total = np.array([float(mp.pi / 2 * H * mp.mpf(v) * mp.struveh(1, t)) for v, t in zip(x, arguments, strict=True)])
    np.testing.assert_allclose(wave.gap_integral(x), total, rtol=1e-11)
    steep = [float(mp.pi / 2 * H * k * (mp.struveh(0, t) + t * (2 / mp.pi - mp.struveh(1, t)))) for t in arguments]
    allowed = 1e-12 * float(mp.pi / 2 * H * k) * np.maximum(1.0, np.array(arguments, dtype=float))
    assert np.all(np.abs(wave.gap_slope(x) - steep) <= np.minimum(allowed, 1.0))
    np.testing.assert_allclose(wave.gap_slope(x[:6]), steep[:6], rtol=1e-12)


def test_long_waves_are_paraboloids():
    """R = 1/(h k^2)."""
    radius = 1.0 / (H * (2.0 * math.pi / L) ** 2)
    x = L * np.array([1e-6, 1e-5])
    np.testing.assert_allclose(wk.Wavy(H, L).gap(x), wk.Paraboloid(radius).gap(x), rtol=1e-9)


def test_g_rises_and_falls():
    slope = wk.Wavy(H, L).gap_slope(np.linspace(0.01, 3.0, 500) * L)
    assert slope.min() < 0.0 < slope.max()
    assert not wk.Wavy(H, L).rising
    assert not (wk.Wavy(H, L) + wk.Paraboloid(1.0)).rising


@pytest.mark.parametrize("bad", [0.0, -1.0, math.nan, math.inf])
def test_bad_numbers(bad):
    with pytest.raises(wk.InvalidInput, match=r"^Wavy: amplitude is .*; it must be a positive, finite number in m\.$"):
        wk.Wavy(bad, 1.0)
    with pytest.raises(wk.InvalidInput, match=r"^Wavy: wavelength is .*; it must be a positive, finite number in m\.$"):
        wk.Wavy(1.0, bad)
