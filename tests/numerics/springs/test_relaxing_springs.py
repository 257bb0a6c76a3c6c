"""Relaxing springs: many steps at once are single steps, a spring follows its differential equations."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import winkler as wk
from winkler.foundation.springs import Springs
from winkler.loading.loads import Depth
from winkler.loading.path import Path
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell
from winkler.materials.viscoelastic import Prony
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.springs.exponential_sums import RelaxationSeries
from winkler.numerics.springs.free_relaxation import Recovery
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.march import SpringRow, elastic_like

SERIES = {
    "solid": RelaxationSeries(0.3, 0.0, np.array([1.0, 0.5, 0.2]), np.array([0.01, 0.3, 4.0])),
    "fluid": RelaxationSeries(0.0, 0.0, np.array([1.0, 0.5]), np.array([0.05, 0.7])),
    "dashpot": RelaxationSeries(0.3, 0.2, np.array([1.0, 0.5]), np.array([0.05, 0.7])),
    "flowing": RelaxationSeries(0.0, 0.2, np.array([1.0, 0.5]), np.array([0.05, 0.7])),
}


@pytest.mark.parametrize("name", SERIES)
def test_modes_share_no_energy(name):
    """What a free spring stores is a sum over its modes, each alone."""
    series = SERIES[name]
    recovery = Recovery.of(series)
    form = series.relaxed + (recovery.to_memory.T / series.moduli) @ recovery.to_memory
    energy = recovery.law(series)[-1]
    assert np.diag(energy) == pytest.approx(0.5 * form, abs=1e-12 * np.max(np.abs(form)))


@pytest.mark.few(1)
@pytest.mark.parametrize(
    "solid", [Maxwell(0.25, 0.3), KelvinVoigt(0.25, 0.1), Prony(0.05, [0.1, 0.05], [0.02, 1.0])], ids=["M", "KV", "P"]
)
def test_many_steps_are_single_steps(solid):
    """To the last bit, whether states are requested or only the solution; with touch lost and found."""
    t = np.sort(np.concatenate([np.linspace(0.0, 3.0, 301), [0.71, 1.3, 2.4]]))
    d = 0.2 + 0.3 * np.sin(5.0 * t) * np.exp(-0.1 * t)
    d[0] = 0.0
    bed = wk.Foundation(wk.Paraboloid(1.0), ViscoelasticHalfSpace(solid))
    problem = ViscoelasticIndentation(bed, Path(t, Depth(d)), count=60)
    whole = problem.solve()
    for word in ("time", "depth", "force", "radius", "stored_energy", "dissipation"):
        single = np.array([getattr(state, word) for state in problem.steps()])
        assert np.array_equal(getattr(whole, word), single), word
    assert np.any(whole.radius[50:] == 0.0)


@pytest.mark.parametrize("name", SERIES)
def test_one_spring_is_its_differential_equation(name):
    """A flat punch is one spring: Maxwell elements that hang together, integrated as they are, until it lets go."""
    series = SERIES[name]
    bed = wk.Foundation(wk.FlatPunch(0.5), wk.HalfSpace(wk.Elastic(1.0, 0.0)))
    row = SpringRow(bed, Springs.of(bed, 0.5, 2), series)
    rates = np.array([0.3, 0.0, -0.04])
    spans = np.array([0.5, 0.3, 0.2])
    done = row.march(rates * spans, spans)
    m = series.moduli.size

    def flow(rate):
        return lambda t, y: np.concatenate([[rate], -y[1:] / series.times + series.moduli * rate])

    y = np.zeros(m + 1)
    for i in range(3):
        y = solve_ivp(flow(rates[i]), (0.0, spans[i]), y, rtol=1e-11, atol=1e-13, method="LSODA").y[:, -1]
        load = series.relaxed * y[0] + series.viscosity * rates[i] + y[1:].sum()
        stored = 0.5 * series.relaxed * y[0] ** 2 + 0.5 * np.sum(y[1:] ** 2 / series.moduli)
        assert load > 0.0
        assert done.force[i] == pytest.approx(load, rel=1e-8)
        assert done.stored[i] == pytest.approx(stored, rel=1e-8)


@pytest.mark.parametrize("name", SERIES)
def test_a_free_spring_bears_nothing(name):
    """Let go at once, it recovers so that elements and dashpot balance all the time: as its own creep recovers."""
    series = SERIES[name]
    bed = wk.Foundation(wk.FlatPunch(0.5), wk.HalfSpace(wk.Elastic(1.0, 0.0)))
    row = SpringRow(bed, Springs.of(bed, 0.5, 2), series)
    row.march(np.array([0.2]), np.array([0.4]))
    stored = row.march(np.array([-10.0]), np.array([1e-9])).stored
    u, memory = row.place[0], (Recovery.of(series).to_memory @ row.memory)[:, 0]
    if series.viscosity > 0.0:

        def flow(t, y):
            rate = -(series.relaxed * y[0] + y[1:].sum()) / series.viscosity
            return np.concatenate([[rate], -y[1:] / series.times + series.moduli * rate])

    else:

        def flow(t, y):
            rate = (y[1:] / series.times).sum() / (series.relaxed + series.moduli.sum())
            return np.concatenate([[rate], -y[1:] / series.times + series.moduli * rate])

    after = solve_ivp(flow, (0.0, 0.5), np.concatenate([[u], memory]), rtol=1e-11, atol=1e-13, method="LSODA").y[:, -1]
    done = row.march(np.array([0.0]), np.array([0.5]))
    assert done.force[0] == 0.0
    assert row.place[0] == pytest.approx(after[0], rel=1e-7)
    energy = 0.5 * series.relaxed * after[0] ** 2 + 0.5 * np.sum(after[1:] ** 2 / series.moduli)
    assert done.stored[0] == pytest.approx(energy, rel=1e-7)
    assert done.stored[0] <= stored[0]


def test_memories_that_are_nothing_are_forgotten():
    """A hold of a million times the shortest relaxation time leaves no numbers that are slow to reckon with."""
    solid = Prony(0.0, [0.1, 0.1], [1e-3, 1.0])
    bed = wk.Foundation(wk.Paraboloid(1.0), ViscoelasticHalfSpace(solid))
    elastic = elastic_like(bed)
    row = SpringRow(elastic, Springs.of(elastic, 0.5, 20), bed.medium.relaxation)
    row.march(np.array([0.2]), np.array([0.1]))
    for _ in range(20):
        done = row.march(np.zeros(1), np.array([60.0]))
    assert np.all(row.memory == 0.0)
    assert done.force[0] == 0.0
    assert math.isclose(row.depth, 0.2)
