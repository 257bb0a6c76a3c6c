"""Roots between known signs."""

from __future__ import annotations

import mpmath as mp
import numpy as np

from winkler.numerics.equations.bracketing import between


def test_many_at_once_to_rounding():
    target = np.geomspace(1e-12, 1e12, 200)
    found = between(lambda x, i: x**3 + x - target[i], np.zeros(200), np.full(200, 1e5))
    exact = [float(mp.findroot(lambda x, t=t: x**3 + x - mp.mpf(t), min(t, t ** (1 / 3)))) for t in target]
    np.testing.assert_allclose(found, exact, rtol=1e-14)


def test_hard_shapes():
    """Flat, steep and nearly discontinuous functions keep their bracket."""
    low, high = np.full(4, -1.0), np.full(4, 2.0)
    shapes = [
        lambda x: (x - 0.3) ** 9,
        lambda x: np.cbrt(x - 0.3),
        lambda x: np.arctan(1e12 * (x - 0.3)),
        lambda x: np.where(x < 0.3, -1.0, 1e9),
    ]
    found = between(lambda x, i: np.array([float(shapes[k](v)) for v, k in zip(x, i, strict=True)]), low, high)
    np.testing.assert_allclose(found, 0.3, rtol=1e-4)
    np.testing.assert_allclose(found[1:], 0.3, rtol=1e-14)


def test_a_root_at_an_end_and_an_empty_bracket():
    found = between(lambda x, _: x, np.array([0.0, -1.0, 0.0]), np.array([1.0, 0.0, 0.0]))
    np.testing.assert_array_equal(found, 0.0)
