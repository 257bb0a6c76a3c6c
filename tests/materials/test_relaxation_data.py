"""Measured solids: what was put in comes back, the misfit is stated, and nonsense is refused."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.materials.relaxation_data import CreepData, DynamicData, RelaxationData
from winkler.materials.spring_and_dashpot import StandardSolid
from winkler.materials.viscoelastic import Prony
from winkler.values.errors import InvalidInput

T = np.geomspace(1e-3, 1e3, 61)
BETWEEN = np.sqrt(T[1:] * T[:-1])
TRUE = Prony(1e3, [3e3, 2e3, 5e2], [0.02, 1.3, 60.0])


def test_relaxation_comes_back():
    data = RelaxationData(T, TRUE.relaxation(T))
    assert data.series_error < 0.012
    assert data.relaxation(BETWEEN) == pytest.approx(TRUE.relaxation(BETWEEN), rel=0.015)
    assert np.abs(data.relaxation(T) / data.shear - 1.0).max() == pytest.approx(data.series_error, rel=1e-6)
    # what was not measured follows: creep, storage, loss
    assert data.creep(BETWEEN) == pytest.approx(TRUE.creep(BETWEEN), rel=0.02)
    omega = np.geomspace(1e-2, 1e2, 9)
    assert data.storage(omega) == pytest.approx(TRUE.storage(omega), rel=0.02)
    assert data.loss(omega) == pytest.approx(TRUE.loss(omega), rel=0.06)
    assert data.span == (T[0], T[-1])


def test_creep_comes_back():
    data = CreepData(T, TRUE.creep(T))
    assert data.series_error < 0.012
    assert data.creep(T) == pytest.approx(data.compliance, rel=1.001 * data.series_error)
    assert data.relaxation(BETWEEN) == pytest.approx(TRUE.relaxation(BETWEEN), rel=0.03)


def test_dynamic_comes_back():
    omega = np.geomspace(1e-3, 1e3, 61)
    data = DynamicData(omega, TRUE.storage(omega), TRUE.loss(omega))
    assert data.series_error < 0.08
    assert data.relaxation(BETWEEN[5:-5]) == pytest.approx(TRUE.relaxation(BETWEEN[5:-5]), rel=0.02)


def test_scatter_is_not_followed():
    """With two per cent of scatter the truth is met closer than the data are."""
    rng = np.random.default_rng(7)
    noisy = TRUE.relaxation(T) * (1.0 + 0.02 * rng.standard_normal(T.size))
    data = RelaxationData(T, noisy)
    misfit = np.sqrt(np.mean((noisy / TRUE.relaxation(T) - 1.0) ** 2))
    assert np.sqrt(np.mean((data.relaxation(T) / TRUE.relaxation(T) - 1.0) ** 2)) < 0.75 * misfit


def test_a_fluid_flows():
    data = CreepData(T, 1e-3 + 2e-4 * T)
    assert data.series.relaxed == 0.0
    assert float(data.creep(1e3)) == pytest.approx(0.201, rel=1e-6)


def test_no_energy_is_made():
    data = RelaxationData(T, StandardSolid(1.0, 1.0, 0.1).relaxation(T))
    assert np.all(data.series.moduli > 0.0)
    assert np.all(data.loss(np.geomspace(1e-6, 1e6, 50)) >= 0.0)


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (
            lambda: RelaxationData([1.0, 2.0, 3.0], [1.0, 1.0, 1.0]),
            "time has 3 numbers; give a row of at least 4 positive",
        ),
        (lambda: RelaxationData([1.0, 3.0, 2.0, 4.0], np.ones(4)), "does not rise"),
        (lambda: CreepData([1.0, 2.0, 3.0, 4.0], np.ones(5)), "give as many"),
        (lambda: CreepData([1.0, 2.0, 3.0, 4.0], [1.0, 1.0, -1.0, 1.0]), "positive"),
        (lambda: RelaxationData(T, np.ones(T.size), 0.7), "poisson is 0.7"),
    ],
)
def test_what_is_refused(make, sentence):
    with pytest.raises(InvalidInput, match=sentence):
        make()
