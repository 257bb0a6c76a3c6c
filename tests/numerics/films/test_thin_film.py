"""Flow of thin films: closed forms, bounds, a known network, conservation, and effective media."""

from __future__ import annotations

import math

import numpy as np
import pytest

from winkler.numerics.films.effective_medium import effective_conductance
from winkler.numerics.films.thin_film import film_flow


def gaussian(count, wavelength, seed, ratio=1.0):
    """A periodic Gaussian field of unit variance, smooth over about a wavelength [pixels]."""
    rng = np.random.default_rng(seed)
    q = np.hypot(np.fft.fftfreq(count)[:, None] * ratio, np.fft.fftfreq(count) / ratio)
    field = np.fft.ifft2(np.fft.fft2(rng.standard_normal((count, count))) * np.exp(-((q * wavelength) ** 2))).real
    field -= field.mean()
    return field / field.std()


def by_every_face(k, pixel, wraps):
    """The flow by a dense matrix, put together face by face."""
    nx, ny = k.shape
    a, b = np.zeros((nx * ny, nx * ny)), np.zeros(nx * ny)
    for i in range(nx):
        for j in range(ny):
            here = i * ny + j
            for di, dj in ((1, 0), (-1, 0), (0, 1), (0, -1)):
                ii, jj = i + di, j + dj
                face = pixel[1] / pixel[0] if di else pixel[0] / pixel[1]
                if not 0 <= ii < nx:
                    a[here, here] += 2.0 * face * k[i, j]
                    b[here] += 2.0 * face * k[i, j] * (ii < 0)
                    continue
                if not 0 <= jj < ny and not wraps:
                    continue
                g = face * 2.0 / (1.0 / k[i, j] + 1.0 / k[ii, jj % ny])
                a[here, here] += g
                a[here, ii * ny + jj % ny] -= g
    p = np.linalg.solve(a, b).reshape(k.shape)
    return float(np.sum(2.0 * pixel[1] / pixel[0] * k[0] * (1.0 - p[0]))), p


@pytest.mark.parametrize("wraps", [False, True])
def test_a_known_network(wraps):
    k = np.random.default_rng(5).uniform(0.1, 3.0, (5, 7))
    found = film_flow(k, (2.0, 3.0), wraps=wraps)
    rate, pressure = by_every_face(k, (2.0, 3.0), wraps)
    assert found.rate == pytest.approx(rate, rel=1e-13)
    np.testing.assert_allclose(found.pressure, pressure, rtol=1e-12)


def test_parallel_gap_series_and_parallel_strips():
    """Cubic law, the harmonic mean across strips and the arithmetic one along them, on pixels that are not square."""
    pixel = (2.0, 0.5)
    across = 12 * 0.5 / (10 * 2.0)
    assert film_flow(np.full((10, 12), 0.3**3), pixel, wraps=False).rate == pytest.approx(0.3**3 * across, rel=1e-13)
    k = np.random.default_rng(0).uniform(0.01, 5.0, 10) ** 3
    series = np.broadcast_to(k[:, None], (10, 12))
    assert film_flow(series, pixel, wraps=False).rate == pytest.approx(across / np.mean(1.0 / k), rel=1e-12)
    parallel = np.broadcast_to(np.append(k, (0.0, 2.0)), (10, 12))
    assert film_flow(parallel, pixel, wraps=True).rate == pytest.approx(across * np.mean(parallel), rel=1e-12)


def test_a_wedge():
    """Q = (b / 12 eta) dp / int dx / h^3, h rising from 1 to 3: int = (1 - 1/9) / 4 for the length 1."""
    errors = []
    for count in (32, 64):
        h = 1.0 + 2.0 * (np.arange(count) + 0.5) / count
        rate = film_flow(np.repeat(h[:, None] ** 3, 3, 1), (1.0 / count, 1.0 / 3.0), wraps=False).rate
        errors.append(rate * (1.0 - 1.0 / 9.0) / 4.0 - 1.0)
    assert abs(errors[1]) < 6e-4
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.02)  # second order


def test_nothing_is_lost_and_all_lies_between_the_means():
    """Gaps over six decades: conductances over eighteen."""
    k = np.exp(3.0 * math.log(10.0) * 2.0 * np.clip(gaussian(64, 6.0, 1), -1.5, 1.5))
    for wraps in (False, True):
        found = film_flow(k, (1.0, 1.0), wraps=wraps)
        assert found.imbalance < 1e-12
        assert 1.0 / np.mean(1.0 / k) < found.rate < np.mean(k)
        np.testing.assert_allclose(found.along.sum(axis=1), found.rate, rtol=1e-12)  # through every section
        assert 0.0 <= np.min(found.pressure) <= np.max(found.pressure) <= 1.0 + 1e-12


def test_closed_films_and_dead_ends():
    k = np.ones((8, 9))
    k[:, 4] = 0.0
    k[3, :4] = 0.0
    k[6, 6] = 0.0
    half = film_flow(k, (1.0, 1.0), wraps=False)
    assert np.isnan(half.pressure[:, :4]).all()  # closed on that side: nothing flows
    assert 3.0 / 8.0 < half.rate < 4.0 / 8.0
    k[5] = 0.0
    closed = film_flow(k, (1.0, 1.0), wraps=True)
    assert closed.rate == 0.0
    assert np.isnan(closed.pressure).all()
    assert not closed.along.any()


def test_a_chessboard():
    """sqrt(k1 k2): J. B. Keller, J. Math. Phys. 5 (1964) 548-549, doi:10.1063/1.1704146.

    The sides lie in the middle of fields, where mirroring changes nothing; corners make the convergence geometric.
    """
    rates = []
    for side in (4, 8, 16):
        i, j = np.indices((8 * side, 8 * side))
        colour = ((i + side // 2) // side + j // side) % 2
        rates.append(film_flow(np.where(colour, 4.0, 1.0), (1.0, 1.0), wraps=True).rate)
    first, second = np.diff(rates)
    assert rates[-1] == pytest.approx(2.0, rel=0.015)
    assert rates[-1] + second**2 / (first - second) == pytest.approx(2.0, rel=3e-3)


@pytest.mark.slow
def test_isotropic_and_striped_roughness_of_small_height():
    """1 - 3/2 s^2, 1 + 3 s^2 along and 1 - 6 s^2 across stripes, s = rms / mean gap.

    J. H. Tripp, J. Lubr. Technol. 105 (1983) 458-463, doi:10.1115/1.3254641.
    """
    s = 0.05
    flows = []
    for i in range(4):
        mirrored = gaussian(128, 16.0, i)  # the sides are lines of mirroring, so that they change nothing
        mirrored = mirrored + mirrored[::-1]
        mirrored = mirrored + mirrored[:, ::-1]
        h = 1.0 + s * mirrored / mirrored.std()
        flows += [film_flow(part**3, (1.0, 1.0), wraps=True).rate for part in (h, h.T)]
    assert (1.0 - np.mean(flows)) / s**2 == pytest.approx(1.5, abs=0.05)
    stripes = np.broadcast_to(s * math.sqrt(2.0) * np.cos(2.0 * np.pi * np.arange(64) / 16), (64, 64))
    along = film_flow((1.0 + stripes) ** 3, (1.0, 1.0), wraps=True).rate
    across = film_flow((1.0 + stripes.T) ** 3, (1.0, 1.0), wraps=True).rate
    assert (along - 1.0) / s**2 == pytest.approx(3.0, rel=1e-6)
    assert (1.0 - across) / s**2 == pytest.approx(6.0, rel=0.05)


@pytest.mark.slow
def test_bruggeman_of_two_kinds_and_of_lognormal_conductances():
    """Closed form of two kinds: 2 s = b + sqrt(b^2 + 4 k1 k2), b = (2 c1 - 1) k1 + (2 c2 - 1) k2."""
    two = np.repeat([5.0, 0.5], [3, 7])
    b = -0.4 * 5.0 + 0.4 * 0.5
    assert effective_conductance(two) == pytest.approx(0.5 * (b + math.sqrt(b**2 + 4.0 * 2.5)), rel=1e-10)
    assert effective_conductance(np.repeat([2.0, 0.0], [3, 2])) == pytest.approx(0.4, rel=1e-10)  # (2 c - 1) k
    assert effective_conductance(np.repeat([2.0, 0.0], [2, 2])) == 0.0
    assert effective_conductance(np.full(5, 3.0)) == pytest.approx(3.0, rel=1e-12)
    # in two dimensions the geometric mean, of media that are statistically the same when turned over (Dykhne)
    fields = [gaussian(96, 8.0, i) for i in range(6)]
    fields = [*fields, *(-one for one in fields)]
    flows = [film_flow(np.exp(0.8 * one), (1.0, 1.0), wraps=True).rate for one in fields]
    assert np.exp(np.mean(np.log(flows))) == pytest.approx(1.0, abs=0.03)
    assert effective_conductance(np.exp(0.8 * np.stack(fields))) == pytest.approx(1.0, abs=1e-10)


@pytest.mark.few(1)
@pytest.mark.parametrize("ratio", [3.0, 6.0])
def test_patir_and_cheng(ratio):
    """phi = 1 - 0.9 exp(-0.56 H) of isotropic Gaussian gaps, clipped at zero; N. Patir, H. S. Cheng 1978.

    Their grids had some 20 x 20 peaks and scattered by a few per cent.
    """
    flows = []
    for i in range(6):
        h = np.maximum(ratio + gaussian(128, 8.0, i), 0.0)
        flows.append(film_flow(h**3, (1.0, 1.0), wraps=True).rate / ratio**3)
    assert np.mean(flows) == pytest.approx(1.0 - 0.9 * math.exp(-0.56 * ratio), abs=0.03)
