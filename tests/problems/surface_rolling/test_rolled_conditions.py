"""Coulomb's conditions of random rolling contacts, with the displacement summed up by a kernel of its own."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import fftconvolve

from winkler.numerics.surfaces.rolled_surface import roll
from winkler.numerics.surfaces.traction_grid import Compliance, TractionGrid


def kernels(shape: tuple[int, int], side: float, more: float) -> tuple[np.ndarray, ...]:
    """Return Cerruti's displacements xx, yy and xy of a pixel of 1 x side under even traction, E* = 1."""
    x, y = np.meshgrid(*(np.arange(1.0 - n, n) for n in shape), indexing="ij")

    def corners(of):
        return sum(i * j * of(x + 0.5 * i, (y + 0.5 * j) * side) for i in (1, -1) for j in (1, -1))

    along = corners(lambda x, y: x * np.arcsinh(y / np.abs(x)))  # of y^2 / r^3
    across = corners(lambda x, y: y * np.arcsinh(x / np.abs(y)))  # of x^2 / r^3
    both = more * corners(lambda x, y: -np.hypot(x, y))
    return (along + (1.0 + more) * across) / np.pi, ((1.0 + more) * along + across) / np.pi, both / np.pi


def displacement(traction: np.ndarray, parts: tuple[np.ndarray, ...]) -> np.ndarray:
    nx, ny = traction.shape[1:]

    def of(kernel, field):
        return fftconvolve(field, kernel)[nx - 1 : 2 * nx - 1, ny - 1 : 2 * ny - 1]

    xx, yy, xy = parts
    return np.stack((of(xx, traction[0]) + of(xy, traction[1]), of(xy, traction[0]) + of(yy, traction[1])))


def bound_of(name: str, x: np.ndarray, y: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    hills = {
        "two spots": lambda: (
            np.sqrt(np.maximum(0.15 - (x - 0.4) ** 2 - (y - 0.3) ** 2, 0.0))
            + np.sqrt(np.maximum(0.08 - (x + 0.5) ** 2 - (y + 0.4) ** 2, 0.0))
        ),
        "rough": lambda: np.maximum(rng.standard_normal(x.shape) - 0.5, 0.0),
        "few pixels": lambda: np.maximum(rng.standard_normal(x.shape) - 1.8, 0.0),
        "row along": lambda: np.sqrt(np.maximum(0.8 - x**2, 0.0)) * (np.arange(x.shape[1]) == x.shape[1] // 2),
        "row across": lambda: (
            np.sqrt(np.maximum(0.8 - y**2, 0.0)) * (np.arange(x.shape[0]) == x.shape[0] // 2)[:, None]
        ),
    }
    found = hills.get(name, lambda: np.sqrt(np.maximum(0.8 - x**2 - y**2, 0.0)))()
    found[-1] = 0.0  # nothing touches where material comes in
    return 1e-3 * found


NAMES = ("two spots", "rough", "few pixels", "row along", "row across", "full slip", "near full stick", "spin")


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize(
    "seed",
    [3, *(pytest.param(k, marks=pytest.mark.long) for k in range(4, 9))],
)
def test_what_slips_is_at_its_bound_and_along_its_slip(name, seed):
    rng = np.random.default_rng([seed, NAMES.index(name)])
    shape, side, nu = tuple(rng.integers(14, 80, 2).tolist()), rng.uniform(0.5, 2.0), rng.uniform(0.0, 0.5)
    x, y = np.meshgrid(*((2.0 * np.arange(n) + 1.0 - n) / n for n in shape), indexing="ij")
    bound = bound_of(name, x, y, rng)
    size = {"full slip": 1.0, "near full stick": 1e-7}.get(name, 10.0 ** rng.uniform(-4.5, -2.5))
    xi, eta, phi = size * rng.standard_normal(3) if name != "spin" else (0.0, 0.0, size)
    rigid = np.stack((xi - phi * y, eta + phi * x))
    more = nu / (1.0 - nu)
    grid = TractionGrid.of(shape, (1.0, side), Compliance(1.0, more), periodic=False)
    traction = roll(grid, bound, rigid, np.zeros_like(rigid)).traction
    moved = displacement(traction, kernels(shape, side, more))
    slip = rigid - moved
    slip[:, :-1] += moved[:, 1:]
    fast, pulled, scale = np.hypot(*slip), np.hypot(*traction), np.max(np.hypot(*rigid))
    assert np.all(pulled <= bound * (1.0 + 1e-9))
    sticking = (bound > 0.0) & (pulled < (1.0 - 1e-6) * bound)
    assert np.all(fast[sticking] <= 1e-4 * scale)
    lost = np.sum(bound * fast) - np.sum(traction * slip)
    assert abs(lost) <= 2e-7 * np.sum(bound * np.hypot(*rigid))
    slipping = (bound > 0.0) & ~sticking & (fast > 1e-2 * scale)
    along = np.sum(traction * slip, axis=0)[slipping]
    assert np.all(along >= (1.0 - 1e-4) * (pulled * fast)[slipping])
