"""A surface under fluxes while it moves: pixels against quadrature, ellipses against the sum over directions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import erf

from winkler.numerics.fields.elliptic_source import EllipticSource
from winkler.numerics.surfaces import shared_heat
from winkler.numerics.surfaces.heated_grid import HeatedGrid, pixel_temperatures
from winkler.values.errors import NotConverged


def by_time(x: float, y: float, dx: float, dy: float, wave: float) -> float:
    """Return lambda T under one even rectangle: the sum over all times of what diffuses while the surface moves on.

    T = q / lambda * integral of X Y / sqrt(pi t) dt over kappa t, with X and Y the parts of a Gaussian that lie in the
    rectangle; with t = exp(2 s).
    """

    def rate(s: float) -> float:
        t = math.exp(2.0 * s)
        spread = 2.0 * math.sqrt(t)
        parts = [
            0.5 * (erf((at + 0.5 * w) / spread) - erf((at - 0.5 * w) / spread))
            for at, w in ((x - wave * t, dx), (y, dy))
        ]
        return 2.0 * math.sqrt(t / math.pi) * parts[0] * parts[1]

    pieces = np.linspace(-24.0, 24.0, 49)
    return sum(quad(rate, low, low + 1.0, epsabs=1e-13, epsrel=1e-10)[0] for low in pieces[:-1])


@pytest.mark.parametrize("wave", [0.0, 1e-6, 0.2, 2.0, 20.0, -20.0, 2e4])
def test_pixels_are_those_of_the_sum_over_times(wave):
    pixels = pixel_temperatures((3, 2), (1.0, 0.7), wave)
    expected = [[by_time(i - 2.0, 0.7 * j, 1.0, 0.7, wave) for j in range(2)] for i in range(5)]
    assert np.allclose(pixels, expected, rtol=1e-8, atol=1e-9 * pixels.max())


def test_pixels_of_any_proportions_add_up_to_larger_ones():
    """Far away a rectangle is the sum of its parts at their places; near by the middle of a part is a middle."""
    for wave in (0.0, 3.0, 3e3):
        whole = pixel_temperatures((4, 4), (1.0, 1.0), wave)
        parts = pixel_temperatures((130, 4), (1.0 / 33.0, 1.0), wave)
        summed = [parts[129 + 33 * i - 16 : 129 + 33 * i + 17].sum(axis=0) for i in (-2, 0, 2, 3)]
        assert np.allclose(summed, whole[[1, 3, 5, 6]], rtol=1e-9, atol=1e-12)


def hertz(count: int, a: float, b: float) -> tuple[np.ndarray, tuple[float, float]]:
    """Return Hertz' flux on an ellipse, the means of pixels over a map 1.1 times as wide, 1 W in all."""
    parts, wide = 8, 1.1
    fine = ((np.arange(count * parts) + 0.5) / (count * parts) * 2.0 - 1.0) * wide
    whole = np.sqrt(np.maximum(1.0 - fine[:, None] ** 2 - fine[None, :] ** 2, 0.0))
    flux = whole.reshape(count, parts, count, parts).mean(axis=(1, 3))
    pixel = 2.0 * wide * a / count, 2.0 * wide * b / count
    return flux / (flux.sum() * pixel[0] * pixel[1]), pixel


@pytest.mark.parametrize("peclet", [0.0, 0.1, 1.0, 10.0, 100.0, 1e4])
def test_peak_of_an_ellipse_converges_with_the_square_of_the_pixel(peclet):
    """The sum over directions of `EllipticSource` is another path; 64 pixels give 0.1 %, 16 times that on 16."""
    a, b = 1.0, 2.0
    peak = EllipticSource(a, b).peak(2.0 * peclet / a, 0.0)
    errors = []
    for count in (16, 32, 64):
        flux, pixel = hertz(count, a, b)
        rise = HeatedGrid.of(flux.shape, pixel, 1.0, 2.0 * peclet / a).warmed(flux)
        errors.append(abs(rise.max() / peak.height - 1.0))
        i, j = np.unravel_index(rise.argmax(), rise.shape)
        assert abs((i + 0.5) * pixel[0] - 1.1 * a - peak.x) <= pixel[0]
        assert abs((j + 0.5) * pixel[1] - 1.1 * b - peak.y) <= pixel[1]
    assert errors[0] < 0.012
    assert errors[1] < 0.0035
    assert errors[2] < 0.001
    back = HeatedGrid.of(flux.shape, pixel, 1.0, -2.0 * peclet / a).warmed(flux)
    assert np.allclose(back[::-1], rise, rtol=1e-10)


@pytest.mark.parametrize("peclet", [0.1, 1.0, 10.0, 100.0])
def test_a_ball_warms_as_its_moving_points_summed_around_a_place(peclet):
    """lambda T = 1/(2 pi) times the integral of q exp(-k s (1 - cos)) over distance s and direction, by quadrature."""
    k = peclet  # of the radius 1
    flux, pixel = hertz(64, 1.0, 1.0)
    rise = HeatedGrid.of(flux.shape, pixel, 1.0, 2.0 * k).warmed(flux)
    i = 45
    x, y = (i + 0.5) * pixel[0] - 1.1, 0.5 * pixel[1]

    def ray(turn: float) -> float:
        along = x * math.cos(turn) + y * math.sin(turn)
        end = along + math.sqrt(along**2 + 1.0 - x**2 - y**2)
        fall = 2.0 * k * math.sin(0.5 * turn) ** 2

        def point(s: float) -> float:
            return math.sqrt(max(1.0 - x**2 - y**2 + 2.0 * s * along - s * s, 0.0)) * math.exp(-fall * s)

        return quad(point, 0.0, end, epsrel=1e-9)[0]

    total = quad(ray, 0.0, math.pi, points=[1.0 / math.sqrt(1.0 + k)], epsrel=1e-7, limit=200)[0]
    total += quad(ray, -math.pi, 0.0, points=[-1.0 / math.sqrt(1.0 + k)], epsrel=1e-7, limit=200)[0]
    expected = 1.5 / math.pi * total / (2.0 * math.pi)
    assert math.isclose(rise[i, 32], expected, rel_tol=1e-3)


def test_in_fast_motion_heat_flows_into_the_depth_only():
    flux, pixel = hertz(40, 1.0, 1.0)
    wave = 1e7
    rise = HeatedGrid.of(flux.shape, pixel, 3.0, wave).warmed(flux)
    edge = np.sqrt(np.maximum(np.arange(40) + 0.5, 0.0) * pixel[0])
    kernel = 2.0 * np.diff(np.concatenate([[0.0], edge]))  # of 1/sqrt(x) over the pixels upstream
    expected = np.array([kernel[: i + 1] @ flux[i::-1] for i in range(40)]) / (3.0 * math.sqrt(math.pi * wave))
    assert np.allclose(rise, expected, rtol=1e-5, atol=1e-6 * expected.max())


def test_surfaces_that_share_heat_have_one_temperature():
    flux, pixel = hertz(48, 1.0, 1.5)
    for first, second in (
        ((1.0, 0.0), (2.0, 0.0)),
        ((1.0, 0.0), (1.0, 300.0)),
        ((0.1, 30.0), (5.0, -2e4)),
        ((5e7, 3.0), (1.0, 0.0)),
    ):
        grids = [HeatedGrid.of(flux.shape, pixel, *body) for body in (first, second)]
        sharing = shared_heat.HeatSharing(grids[0], grids[1], flux > 0.0)
        inflow, outflow = sharing.fluxes(flux, 0.0)
        warm = [grid.warmed(part) for grid, part in zip(grids, (inflow, outflow), strict=True)]
        assert np.max(np.abs(warm[0] - warm[1])[flux > 0.0]) < 1e-7 * np.max(warm[0])
        np.testing.assert_allclose(inflow + outflow, flux, rtol=1e-12, atol=1e-12)
        inflow, outflow = sharing.fluxes(flux, 0.3)
        apart = (grids[0].warmed(inflow) - grids[1].warmed(outflow) - 0.3)[flux > 0.0]
        assert np.max(np.abs(apart)) < 1e-7
        assert not np.any(inflow[flux == 0.0])
    assert not np.any(sharing.fluxes(0.0 * flux, 0.0))


def test_one_that_does_not_settle_says_so(monkeypatch):
    flux, pixel = hertz(16, 1.0, 1.0)
    grids = [HeatedGrid.of(flux.shape, pixel, 1.0, wave) for wave in (0.0, 100.0)]
    monkeypatch.setattr(shared_heat, "MOST_ROUNDS", 1)
    monkeypatch.setattr(shared_heat, "ROUND", 2)
    with pytest.raises(NotConverged, match="do not agree"):
        shared_heat.HeatSharing(grids[0], grids[1], flux > 0.0).fluxes(flux, 0.0)
