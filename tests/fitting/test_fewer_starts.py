"""Starts and restarts that are left out change no number."""

from __future__ import annotations

import numpy as np
import pytest
from noisy_worlds import worlds

from winkler.fitting import generalised
from winkler.fitting.curves.outline import outline
from winkler.fitting.elastic.task import ElasticTask
from winkler.fitting.fit import fit, fit_steps

WORLDS = worlds(600)


def steps_of(name, seed):
    world = WORLDS[name]
    *states, found = fit_steps(world.curve(seed), world.model(), free=list(world.truth))
    return len(states), found


@pytest.mark.parametrize(("name", "saved"), [("ball, white", True), ("cone in liquid", False)])
def test_a_start_that_explains_the_curve_needs_no_other(monkeypatch, name, saved):
    """A drag of many times the noise leaves residuals that might be those of a wrong start: then two are improved."""
    fewer, found = steps_of(name, 5)
    monkeypatch.setattr(ElasticTask, "explained_by", lambda *_: False)
    more, other = steps_of(name, 5)
    assert (fewer < more) is saved
    assert np.all(np.abs(found.values - other.values) < 1e-5 * other.standard_errors)
    assert found.standard_errors == pytest.approx(other.standard_errors, rel=1e-5)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [30_000, 30_036])
def test_a_restart_ends_near_a_known_optimum_and_still_finds_a_likelier_one(monkeypatch, seed):
    """Under the second seed another point at the snap is in contact; the contact point moves by half its error."""
    fewer, found = steps_of("JKR", seed)
    monkeypatch.setattr(generalised, "NEAR_ERRORS", -1.0)
    more, other = steps_of("JKR", seed)
    assert fewer < more
    assert np.array_equal(found.values, other.values)
    monkeypatch.setattr(ElasticTask, "restarts", lambda *_: [])
    world = WORLDS["JKR"]
    alone = fit(world.curve(seed), world.model(), free=list(world.truth))
    assert (found.log_likelihood > alone.log_likelihood + generalised.CLEAR_GAIN) is (seed == 30_036)


def test_the_outline_of_a_curve_is_kept():
    curve = WORLDS["ball, white"].curve(1)
    assert outline(curve) is outline(curve)
    assert outline(curve) is not outline(WORLDS["ball, white"].curve(2))
