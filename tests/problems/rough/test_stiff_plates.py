"""Stiff plates on soft bases under rough maps: against a dense quadratic programme, and each other's drives."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import nnls

import winkler as wk
from winkler.media.mapped import layers_of
from winkler.numerics.surfaces.pressed_box import ByDepth, ByLoad
from winkler.numerics.surfaces.pressed_grid import press
from winkler.numerics.surfaces.punched_grid import punch


def plate(contrast, thickness):
    return wk.CoatedHalfSpace([wk.Layer(wk.Elastic(contrast, 0.3), thickness)], on=wk.Elastic(1.0, 0.4))


def rough(count, *, periodic, seed=3):
    """A self-affine map of Hurst exponent 0.8, 1 m wide, rms height 1 cm."""
    q = np.hypot(*np.meshgrid(*2 * [np.fft.fftfreq(count) * count], indexing="ij"))
    amplitude = np.where((q > 0) & (q <= count / 4), np.maximum(q, 3.0) ** -1.8, 0.0)
    z = np.fft.ifft2(np.fft.fft2(np.random.default_rng(seed).standard_normal((count, count))) * amplitude).real
    return wk.Topography(z * 0.01 / z.std(), [1.0, 1.0], periodic=periodic)


def compliance(q, contrast, thickness):
    """Displacement per pressure of a wave on one bonded layer: T. Nogi, T. Kato, J. Tribol. 119 (1997) 493-500,
    doi:10.1115/1.2833525."""
    mu, first, second = contrast * 1.4 / 1.3, 0.3, 0.4  # ratio of the shear moduli
    kappa, lam = (mu - 1) / (mu + 3 - 4 * first), 1 - 4 * (1 - first) / (1 + mu * (3 - 4 * second))
    h = q * thickness
    fade = np.exp(-2 * h)
    bent = (1 + 4 * h * kappa * fade - lam * kappa * fade**2) / (
        1 - (lam + kappa + 4 * kappa * h * h) * fade + lam * kappa * fade**2
    )
    return 2 * (1 - first**2) / (contrast * q) * bent


@pytest.mark.slow
@pytest.mark.parametrize(("contrast", "thickness", "mean"), [(4e3, 0.01, 1.0), (1e6, 0.003, 3.0)])
def test_a_periodic_map_meets_a_dense_quadratic_programme(contrast, thickness, mean):
    """Lawson and Hanson's active set on all pixels, with compliances of another derivation."""
    n, map_ = 24, rough(24, periodic=True)
    q = 2 * np.pi * np.hypot(*np.meshgrid(*2 * [np.fft.fftfreq(n) * n], indexing="ij"))
    q[0, 0] = 1.0
    waves = compliance(q, contrast, thickness)
    waves[0, 0] = 0.0
    column = np.fft.ifft2(waves).real
    i, j = (each.ravel() for each in np.indices((n, n)))
    matrix = column[(i[:, None] - i) % n, (j[:, None] - j) % n]
    gap = (map_.heights.max() - map_.heights).ravel()
    stiff = 1e3 * np.abs(column).max()  # of a spring under the mean, which stands for the load
    factor = np.linalg.cholesky(matrix + stiff)
    wanted = np.linalg.solve(factor, stiff * mean * n * n - gap)
    p, _ = nnls(factor.T, wanted, maxiter=20 * n * n)
    load = p.sum() / n**2
    found = wk.SurfaceContact(map_, plate(contrast, thickness), wk.Force(load), tolerance=1e-10).solve()
    assert 0.01 < np.count_nonzero(p) / p.size < 0.5
    np.testing.assert_allclose(found.last.pressure.ravel(), p, atol=2e-5 * p.max())
    assert found.depth == pytest.approx(stiff * (mean * n * n - p.sum()), rel=1e-6)


@pytest.mark.few(1)
@pytest.mark.parametrize("share", [np.inf, 0.5])
def test_a_free_map_under_its_depth_bears_the_same_as_under_its_load(share):
    """Two other minima, of which the second one has no balance of loads; where it is hard, at its hardness."""
    map_, medium = rough(32, periodic=False), plate(1e5, 0.01)
    layers, pixel = layers_of(medium), map_.pixel
    soft = press(map_.gaps, pixel, ByLoad(0.05), periodic=False, layers=layers, tolerance=1e-9)
    limit = soft.pressure.max() * share
    loaded = press(map_.gaps, pixel, ByLoad(0.05), periodic=False, layers=layers, tolerance=1e-9, ceiling=limit)
    deep = press(map_.gaps, pixel, ByDepth(loaded.depth), periodic=False, layers=layers, tolerance=1e-9, ceiling=limit)
    assert deep.pressure.sum() == pytest.approx(0.05, rel=1e-5)
    assert loaded.pressure.max() <= limit
    np.testing.assert_allclose(deep.pressure, loaded.pressure, atol=1e-3 * loaded.pressure.max())


@pytest.mark.slow
def test_a_punch_of_scattered_pixels_is_pressed_alike():
    there = rough(48, periodic=False).heights > 0.008
    layers = layers_of(plate(1e6, 0.004))
    p = punch(there, (1 / 48, 1 / 48), periodic=False, tolerance=1e-8, layers=layers)
    i, j = np.nonzero(there)
    own = layers.pixels(there.shape, (1 / 48, 1 / 48)) + love(48)
    sunk = own[abs(i[:, None] - i), abs(j[:, None] - j)] @ p[there]
    np.testing.assert_allclose(sunk, 1.0, atol=1e-7)


def love(count):
    """Love's displacement at the middles of the pixels, under one of them."""
    x = (np.arange(count + 1) - 0.5)[:, None] / count
    corner = x * np.arcsinh(x.T / abs(x)) + x.T * np.arcsinh(x / abs(x.T))
    return (corner[1:, 1:] - corner[:-1, 1:] - corner[1:, :-1] + corner[:-1, :-1]) / np.pi


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("periodic", [True, False])
@pytest.mark.parametrize(("contrast", "thickness", "mean"), [(3e3, 0.02, 20.0), (1e6, 0.003, 20.0), (1e6, 0.02, 1e3)])
def test_contrasts_up_to_a_million_are_solved(periodic, contrast, thickness, mean):
    found = wk.SurfaceContact(rough(96, periodic=periodic), plate(contrast, thickness), wk.Force(mean)).solve()
    assert found.penetration <= 1e-6
    assert found.misfit <= 1e-6
    assert found.force == pytest.approx(mean, rel=1e-9)
