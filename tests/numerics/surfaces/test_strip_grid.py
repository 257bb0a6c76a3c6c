"""What sticks on a strip: systems bordered by nodes that have changed give what the whole system gives."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.numerics.surfaces.strip_grid import FEW_CHANGED, MOST_CHANGED, StuckStrip, strip_compliance

COUNT = 90


@pytest.mark.parametrize("summed", [True, False])
@pytest.mark.parametrize("most", [FEW_CHANGED, MOST_CHANGED // 2, MOST_CHANGED])
def test_nodes_that_begin_to_stick_or_to_slip_border_the_system(most, summed, monkeypatch):
    random = np.random.default_rng(most)
    away = np.abs(np.subtract.outer(np.arange(COUNT), np.arange(COUNT)))
    compliance = strip_compliance(COUNT, 1.0 / COUNT, 2.0)[away]
    weights = random.uniform(0.5, 2.0, COUNT)
    grid, factorised = StuckStrip(compliance, weights), []
    hold = grid._hold
    monkeypatch.setattr(grid, "_hold", lambda sticks: factorised.append(1) or hold(sticks))
    first = random.random(COUNT) < 0.6
    for _ in range(6):
        sticks, wanted = first.copy(), random.normal(size=COUNT)
        sticks[random.choice(COUNT, most // 2, replace=False)] ^= True
        total = 0.7 if summed else None
        found, shift = grid.stuck(sticks, wanted, total)
        number = int(np.sum(sticks))
        # the whole system, of tractions and of the shift
        system = np.zeros((number + summed, number + summed))
        system[:number, :number] = compliance[np.ix_(sticks, sticks)]
        if summed:
            system[:number, -1], system[-1, :number] = -1.0, weights[sticks]
        right = np.append(wanted[sticks], [0.7] * summed)
        known = np.linalg.solve(system, right)
        assert np.all(found[~sticks] == 0.0)
        np.testing.assert_allclose(found[sticks], known[:number], rtol=0.0, atol=3e-12 * np.max(np.abs(known)))
        assert not summed or abs(shift - known[-1]) <= 3e-12 * max(abs(known[-1]), np.max(np.abs(wanted)))
    assert len(factorised) == 1
