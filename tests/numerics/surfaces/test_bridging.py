"""Holes in a grid: Laplace's equation against harmonic polynomials and a plain loop; spikes against a plain loop."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.numerics.surfaces.bridging import bridged, spikes

X, Y = np.arange(30.0)[:, None], np.arange(24.0)[None, :]
HARMONIC = {
    "plane": 3.0 - 0.5 * X + 2.0 * Y,
    "saddle": X**2 - Y**2,
    "product": X * Y,
    "third": X**3 - 3.0 * X * Y**2,
}
"""Also solutions of the equation with differences: fourth derivatives vanish."""


@pytest.mark.parametrize("name", HARMONIC)
def test_harmonic_heights_come_back(name):
    whole = np.broadcast_to(HARMONIC[name], (30, 24))
    holed = whole.copy()
    holed[3:9, 5:20] = holed[15:25, 2:4] = holed[26, 20] = np.nan
    assert np.max(np.abs(bridged(holed, False) - whole)) < 1e-9 * np.max(np.abs(whole))


def relaxed(numbers, periodic):
    """Return means of neighbours, taken until they stay."""
    holes = np.argwhere(np.isnan(numbers))
    grid = np.where(np.isnan(numbers), np.nanmean(numbers), numbers)
    nx, ny = grid.shape
    for _ in range(3000):
        for i, j in holes:
            near = [(i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)]
            near = [(a % nx, b % ny) for a, b in near] if periodic else [
                (a, b) for a, b in near if 0 <= a < nx and 0 <= b < ny
            ]  # fmt: skip
            grid[i, j] = np.mean([grid[place] for place in near])
    return grid


@pytest.mark.few(1)
@pytest.mark.parametrize("periodic", [False, True])
def test_holes_at_the_border(periodic):
    numbers = np.random.default_rng(3).standard_normal((7, 6))
    numbers[0, :3] = numbers[5:, 4:] = numbers[3, 3] = np.nan
    filled = bridged(numbers, periodic)
    np.testing.assert_allclose(filled, relaxed(numbers, periodic), atol=1e-12)
    known = ~np.isnan(numbers)
    np.testing.assert_array_equal(filled[known], numbers[known])


def test_nothing_lies_above_the_border_of_its_hole():
    numbers = np.random.default_rng(4).random((20, 20))
    numbers[np.random.default_rng(5).random((20, 20)) < 0.5] = np.nan
    filled = bridged(numbers, False)
    assert np.nanmin(numbers) <= np.min(filled) <= np.max(filled) <= np.nanmax(numbers)


def quartiles_around(numbers, periodic):
    """Return the 7th and the 19th of 25 numbers, two apart, which are repeated or mirrored beyond the border."""
    nx, ny = numbers.shape
    wide = np.pad(numbers, 4, mode="wrap" if periodic else "symmetric")
    stated = np.array(
        [[np.sort(wide[i : i + 9 : 2, j : j + 9 : 2].ravel())[[6, 18]] for j in range(ny)] for i in range(nx)]
    )
    return stated[..., 0], stated[..., 1]


@pytest.mark.parametrize("periodic", [False, True])
def test_spikes_lie_outside_of_the_fences(periodic):
    numbers = np.random.default_rng(6).standard_normal((24, 19))
    numbers[:6, :6] *= 20.0  # rougher there
    numbers[14:17, 9:11] = 30.0
    low, high = quartiles_around(numbers, periodic)
    distance = np.maximum(high - low, np.median(high - low))
    for times in (1.0, 4.0):
        expected = (numbers > high + times * distance) | (numbers < low - times * distance)
        np.testing.assert_array_equal(spikes(numbers, times, periodic), expected)
    assert np.all(spikes(numbers, 4.0, periodic)[14:17, 9:11])
    assert not np.any(spikes(numbers, 4.0, periodic)[8:13, 8:15])


def test_holes_are_no_spikes():
    numbers = np.random.default_rng(7).standard_normal((30, 30))
    numbers[4:9, 4:9] = np.nan
    numbers[3, 5] = 30.0
    numbers[20, 20] = -30.0
    assert np.argwhere(spikes(numbers, 4.0, False)).tolist() == [[3, 5], [20, 20]]
