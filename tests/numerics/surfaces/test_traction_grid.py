"""Displacements under tractions on a grid: against quadrature, Betti's theorem, and waves in closed form."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.numerics.surfaces.traction_grid import Compliance, TractionGrid

SHAPE, PIXEL, BODIES = (7, 9), (1.0, 0.7), Compliance(1.2, 0.4, 0.3)
MIDDLE = (3, 4)


@pytest.fixture
def free() -> TractionGrid:
    return TractionGrid.of(SHAPE, PIXEL, BODIES, periodic=False)


def unit(direction: int) -> np.ndarray:
    traction = np.zeros((2, *SHAPE))
    traction[(direction, *MIDDLE)] = 1.0
    return traction


def over_a_pixel(kernel, place: tuple[int, int]) -> float:
    """Return the mean of a kernel over the pixel in the middle, seen from another one, times its area."""
    nodes, weights = np.polynomial.legendre.leggauss(60)
    x = (place[0] - MIDDLE[0]) * PIXEL[0] + 0.5 * PIXEL[0] * nodes[:, None]
    y = (place[1] - MIDDLE[1]) * PIXEL[1] + 0.5 * PIXEL[1] * nodes[None, :]
    return float(np.sum(weights[:, None] * weights * kernel(x, y, np.hypot(x, y)))) * 0.25 * PIXEL[0] * PIXEL[1] / np.pi


@pytest.mark.parametrize("place", [(5, 2), (3, 6), (0, 8), (2, 4)])
def test_a_pixel_displaces_others_as_cerruti_says(free, place):
    a, b, beta, *_ = BODIES
    along, across = free.sheared(unit(0)), free.sheared(unit(1))
    expected = {
        (0, 0): over_a_pixel(lambda x, y, r: a / r + b * x * x / r**3, place),
        (0, 1): over_a_pixel(lambda x, y, r: b * x * y / r**3, place),
        (1, 1): over_a_pixel(lambda x, y, r: a / r + b * y * y / r**3, place),
    }
    found = {(0, 0): along[0][place], (0, 1): along[1][place], (1, 1): across[1][place]}
    assert found == pytest.approx(expected, rel=1e-9, abs=1e-14)
    assert across[0][place] == pytest.approx(along[1][place], rel=1e-12, abs=1e-14)
    for direction in (0, 1):
        drawn = -beta * over_a_pixel(lambda x, y, r, d=direction: (x, y)[d] / r**2, place)
        assert free.drawn(unit(0)[0])[(direction, *place)] == pytest.approx(drawn, rel=1e-9, abs=1e-14)
        assert free.sunk(unit(direction))[place] == pytest.approx(-drawn, rel=1e-9, abs=1e-14)


@pytest.mark.parametrize("periodic", [False, True])
def test_betti(periodic):
    grid = TractionGrid.of((8, 9), PIXEL, BODIES, periodic=periodic)
    rng = np.random.default_rng(1)
    p, q, other = rng.random((8, 9)), rng.random((2, 8, 9)), rng.random((2, 8, 9))
    assert np.sum(grid.drawn(p) * q) == pytest.approx(np.sum(grid.sunk(q) * p), rel=1e-12)
    assert np.sum(grid.sheared(q) * other) == pytest.approx(np.sum(grid.sheared(other) * q), rel=1e-12)
    assert np.sum(grid.sheared(q) * q) > 0.0


def test_waves():
    """Along a wave 2 a / q, across it 2 (a + b) / q, and coupled 2 beta / q, a quarter of a wave aside."""
    a, b, beta, *_ = BODIES
    n, turns = 24, 3
    grid = TractionGrid.of((n, n), (1.0, 1.0), BODIES, periodic=True)
    q = 2.0 * np.pi * turns / n
    x = np.arange(n)[:, None] + np.zeros(n)
    wave, none = np.cos(q * x), np.zeros((n, n))
    for traction, expected in (((wave, none), 2.0 * a / q), ((none, wave), 2.0 * (a + b) / q)):
        found = grid.sheared(np.stack(traction))
        np.testing.assert_allclose(found, expected * np.stack(traction), atol=1e-13)
    np.testing.assert_allclose(grid.sunk(np.stack((wave, none))), 2.0 * beta / q * np.sin(q * x), atol=1e-13)
    np.testing.assert_allclose(grid.drawn(wave)[0], -2.0 * beta / q * np.sin(q * x), atol=1e-13)


def test_similar_bodies_are_not_coupled():
    grid = TractionGrid.of(SHAPE, PIXEL, Compliance(1.0, 0.4), periodic=False)
    assert not np.any(grid.drawn(unit(0)[0]))
    assert not np.any(grid.sunk(unit(0)))


def test_the_preconditioner_undoes_waves():
    grid = TractionGrid.of((25, 27), (1.0, 1.0), BODIES, periodic=True)
    rng = np.random.default_rng(2)
    q = rng.random((2, 25, 27))
    q -= np.mean(q, axis=(1, 2), keepdims=True)
    np.testing.assert_allclose(grid.roughly_shearing(grid.sheared(q)), q, atol=1e-12)
