"""One step of stick and slip: against projected gradients on the whole matrix, and what certifies it."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.numerics.surfaces import sheared_surface
from winkler.numerics.surfaces.sheared_surface import RigidStep, shear
from winkler.numerics.surfaces.traction_grid import Compliance, TractionGrid
from winkler.values.errors import NotConverged

N = 9
X = (np.arange(N) - 0.5 * (N - 1))[:, None] + np.zeros(N)
MODES = np.stack((np.stack((X * 0 + 1, X * 0)), np.stack((X * 0, X * 0 + 1)), np.stack((-X.T, X))))
BOUND = np.sqrt(np.maximum(1.0 - (X**2 + X.T**2) / 16.0, 0.0))
GRID = TractionGrid.of((N, N), (1.0, 1.0), Compliance(1.0, 0.6), periodic=False)
NOTHING = np.zeros((2, N, N))


def by_amount(*motion: float) -> RigidStep:
    return RigidStep(MODES, np.array(motion), np.zeros(3, dtype=bool))


def least_energy(goal: np.ndarray) -> np.ndarray:
    """Return the tractions by projected gradients with momentum, on the matrix itself."""
    columns = []
    for place in np.ndindex(2, N, N):
        one = np.zeros((2, N, N))
        one[place] = 1.0
        columns.append(GRID.sheared(one).ravel())
    matrix = np.array(columns).T
    rate = 1.0 / np.linalg.norm(matrix, 2)
    q = ahead = np.zeros((2, N, N))
    momentum = 1.0
    for _ in range(20000):
        moved = ahead - rate * ((matrix @ ahead.ravel()).reshape(q.shape) - goal)
        size = np.hypot(*moved)
        new = moved * np.where(size > BOUND, BOUND / np.where(size > 0.0, size, 1.0), 1.0)
        if np.sum((ahead - new) * (new - q)) > 0.0:  # restart
            momentum = 1.0
        later = 0.5 * (1.0 + np.sqrt(1.0 + 4.0 * momentum**2))
        ahead = new + (momentum - 1.0) / later * (new - q)
        q, momentum = new, later
    return q


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("motion", [(2.5, 0.0, 0.0), (0.7, -0.4, 0.0), (0.5, 0.5, 0.5), (30.0, 10.0, -20.0)])
def test_it_is_the_least_energy(motion):
    step = by_amount(*motion)
    found = shear(GRID, BOUND, NOTHING, step, NOTHING, tolerance=1e-12)
    expected = least_energy(np.tensordot(step.given, MODES, 1))
    np.testing.assert_allclose(found.traction, expected, atol=2e-6)


def test_what_slips_is_at_its_bound_and_along_its_slip():
    found = shear(GRID, BOUND, NOTHING, by_amount(2.5, 0.0, 0.1), NOTHING, tolerance=1e-12)
    size, slid = np.hypot(*found.traction), np.hypot(*found.slip)
    assert 0 < np.count_nonzero(found.slipping) < np.count_nonzero(BOUND)
    assert np.all(size <= BOUND * (1.0 + 1e-12))
    np.testing.assert_allclose(size[found.slipping], BOUND[found.slipping], rtol=1e-9)
    cosine = np.sum(found.traction * found.slip, 0)[found.slipping] / (size * slid)[found.slipping]
    # hardly any slip next to what sticks has hardly a direction
    far = slid[found.slipping] > 1e-2 * np.max(slid)
    assert np.all(cosine[far] > 1.0 - 1e-6)
    sticking = (BOUND > 0.0) & ~found.slipping
    assert np.max(slid[sticking]) < 1e-5 * np.max(slid)


def test_given_forces_are_met():
    forces = 0.6 * np.sum(BOUND) * np.array([0.8, 0.3]), np.array([0.2])
    step = RigidStep(MODES, np.concatenate((forces[0], forces[1])), np.array([True, True, False]))
    found = shear(GRID, BOUND, NOTHING, step, NOTHING)
    np.testing.assert_allclose(np.sum(found.traction, axis=(1, 2)), forces[0], rtol=1e-8)
    assert found.motion[2] == 0.2
    again = shear(GRID, BOUND, NOTHING, by_amount(*found.motion), NOTHING, tolerance=1e-12)
    np.testing.assert_allclose(again.traction, found.traction, atol=1e-4)


def test_forces_that_friction_does_not_bear_do_not_converge():
    step = RigidStep(MODES, np.array([1.01 * np.sum(BOUND), 0.0, 0.0]), np.ones(3, dtype=bool))
    with pytest.raises(NotConverged, match="given forces lack"):
        shear(GRID, BOUND, NOTHING, step, NOTHING)


def test_too_few_rounds_are_not_converged(monkeypatch):
    monkeypatch.setattr(sheared_surface, "MOST_ROUNDS", 2)
    with pytest.raises(NotConverged, match="after 2 rounds"):
        shear(GRID, BOUND, NOTHING, by_amount(2.5, 0.0, 0.0), NOTHING)


def test_one_is_added_to_by_the_next():
    """Half of the shift and then the other half is the whole shift, where nothing turns back."""
    half, whole = (by_amount(part * 2.5, 0.0, 0.0) for part in (0.5, 1.0))
    first = shear(GRID, BOUND, NOTHING, half, NOTHING, tolerance=1e-12)
    second = shear(GRID, BOUND, first.displacement, half, first.traction, tolerance=1e-12)
    straight = shear(GRID, BOUND, NOTHING, whole, NOTHING, tolerance=1e-12)
    np.testing.assert_allclose(np.sum(second.traction, (1, 2)), np.sum(straight.traction, (1, 2)), rtol=2e-3, atol=1e-9)
