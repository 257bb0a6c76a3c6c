"""Solids at other temperatures: times move by one factor, moduli stay; laws against their published numbers."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.values.errors import InvalidInput, OutsideValidity

RUBBER = wk.Prony(1e6, [2e6, 5e5], [0.01, 1.0], poisson=0.49)
FERRY = wk.WilliamsLandelFerry(reference_temperature=298.15, first_constant=8.86, second_constant=101.6)
WARM = wk.AtTemperature(RUBBER, FERRY, temperature=328.15)


def test_times_are_multiplied_and_moduli_stay():
    factor = 10.0 ** (-8.86 * 30.0 / 131.6)
    assert WARM.factor == pytest.approx(factor, rel=1e-12)
    times = np.geomspace(1e-4, 10.0, 7)
    expected = 1e6 + 2e6 * np.exp(-times / (0.01 * factor)) + 5e5 * np.exp(-times / factor)
    assert WARM.relaxation(times) == pytest.approx(expected, rel=1e-12)
    assert WARM.poisson == 0.49
    assert WARM.series.relaxed == 1e6


def test_the_reference_temperature_changes_nothing():
    same = wk.AtTemperature(RUBBER, FERRY, 298.15)
    assert np.array_equal(same.series.times, RUBBER.series.times)


def test_storage_and_loss_lie_on_one_master_curve():
    omega = np.geomspace(0.1, 1e3, 5)
    assert WARM.storage(omega) == pytest.approx(RUBBER.storage(omega * WARM.factor), rel=1e-12)
    assert WARM.loss(omega) == pytest.approx(RUBBER.loss(omega * WARM.factor), rel=1e-12)


def test_the_span_moves_along():
    cell = wk.PowerLawSolid(shear=500.0, time_scale=1.0, exponent=0.2, shortest=1e-3, longest=10.0)
    law = wk.Arrhenius(reference_temperature=300.0, activation_energy=80e3)
    factor = math.exp(80e3 / 8.31446261815324 * (1.0 / 310.0 - 1.0 / 300.0))
    assert wk.AtTemperature(cell, law, 310.0).span == pytest.approx((1e-3 * factor, 10.0 * factor), rel=1e-12)
    assert wk.AtTemperature(RUBBER, law, 310.0).span == (0.0, math.inf)


def test_a_warm_body_creeps_as_a_cold_one_later():
    bed, warm = (wk.Foundation(wk.Paraboloid(1e-2), wk.ViscoelasticHalfSpace(solid)) for solid in (RUBBER, WARM))
    times = np.geomspace(1e-4, 1.0, 5)
    late = wk.CreepTest(bed, 1.0, times / WARM.factor).solve()
    assert wk.CreepTest(warm, 1.0, times).solve().depth == pytest.approx(late.depth, rel=1e-9)


@pytest.mark.parametrize(
    ("make", "error", "sentence"),
    [
        (lambda: wk.AtTemperature(wk.Elastic(1e9, 0.3), FERRY, 300.0), InvalidInput, "solid is a Elastic"),
        (lambda: wk.AtTemperature(RUBBER, "wlf", 300.0), InvalidInput, "law is a str"),
        (lambda: wk.AtTemperature(RUBBER, FERRY, -3.0), InvalidInput, "temperature is -3.0"),
        (lambda: wk.AtTemperature(RUBBER, FERRY, 150.0), OutsideValidity, "at 150 K the law gives no value"),
    ],
)
def test_what_is_refused(make, error, sentence):
    with pytest.raises(error, match=sentence):
        make()
