"""Invariants of a stress state against eigenvalues of the full tensor, and the search for the greatest."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from winkler.media.interior.peak import greatest
from winkler.media.interior.stress import max_shear, principal, von_mises

stress = st.floats(-1e9, 1e9, allow_nan=False).map(lambda s: round(s, 3))


@settings(max_examples=60)
@given(stress, stress, stress, stress)
def test_against_the_tensor(radial, hoop, axial, shear):
    tensor = np.array([[radial, 0.0, shear], [0.0, hoop, 0.0], [shear, 0.0, axial]])
    values = np.linalg.eigvalsh(tensor)[::-1]
    size = np.max(np.abs(tensor)) + 1e-300
    parts = [np.array([part]) for part in (radial, hoop, axial, shear)]
    np.testing.assert_allclose(principal(*parts)[0], values, atol=1e-12 * size)
    assert max_shear(*parts)[0] == pytest.approx(0.5 * (values[0] - values[2]), abs=1e-12 * size)
    deviator = tensor - np.trace(tensor) / 3.0 * np.eye(3)
    assert von_mises(*parts)[0] == pytest.approx(math.sqrt(1.5 * np.sum(deviator**2)), abs=2e-12 * size)


def test_shapes():
    grid = np.ones((2, 3))
    assert principal(grid, grid, grid, grid).shape == (2, 3, 3)
    assert von_mises(grid, grid, grid, 0.0 * grid).shape == (2, 3)
    assert not np.any(max_shear(grid, grid, grid, 0.0 * grid))


@pytest.mark.parametrize("place", [(0.0, 0.48), (0.7, 0.3), (0.97, 0.05), (0.0, 1.9), (1.0, 0.0), (0.33, 0.0)])
@pytest.mark.parametrize("radius", [1e-9, 1.0, 1e3])
def test_the_greatest_is_found(place, radius):
    """A smooth hill anywhere below the contact: its height to rounding, its place to 1e-5 of the radius."""

    def hill(r, z):
        return 7.0 / (1.0 + ((r / radius - place[0]) / 0.3) ** 2 + ((z / radius - place[1]) / 0.4) ** 2)

    found = greatest(hill, radius)
    assert found.value == pytest.approx(7.0, rel=1e-9)
    assert found.r / radius == pytest.approx(place[0], abs=2e-5)
    assert found.z / radius == pytest.approx(place[1], abs=2e-5)


def test_a_ridge_that_slants():
    def ridge(r, z):
        along, across = r + z - 0.9, (r - z) - 0.1
        return np.exp(-0.05 * along**2 - 8.0 * across**2)

    found = greatest(ridge, 1.0)
    assert found.value == pytest.approx(1.0, rel=1e-8)
