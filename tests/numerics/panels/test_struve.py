"""Struve's functions against mpmath at 30 digits, on both sides of the change of method."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest

from winkler.numerics.panels.struve import ASYMPTOTIC_LIMIT, struve

T = np.concatenate(
    [
        [0.0],
        np.geomspace(1e-12, 1.0, 7),
        np.linspace(1.3, 60.0, 41),
        [np.nextafter(ASYMPTOTIC_LIMIT, 0.0), ASYMPTOTIC_LIMIT, 137.7, 2345.6],
    ]
)


@pytest.mark.parametrize("order", [0, 1])
def test_values(order):
    with mp.workdps(30):
        exact = np.array([float(mp.struveh(order, mp.mpf(t))) for t in T])
    # relative to the leading power near zero, to the size of the function elsewhere; rounding of t itself far away
    size = np.minimum(T ** (order + 1), 1.0) + 1e-300
    np.testing.assert_array_less(np.abs(struve(order, T) - exact), 2e-15 * size * np.maximum(1.0, T))


def test_shapes():
    assert struve(0, np.array(2.0)).shape == ()
    assert struve(1, np.array([[2.0, 50.0]])).shape == (1, 2)
    assert struve(1, np.zeros(0)).shape == (0,)
