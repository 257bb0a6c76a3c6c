"""Nanoindentations of played worlds: E and H over depth, and intervals that hold; each number by another route."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest
from nano_worlds import SAPPHIRE, SILICA, STEEL, Machine, indentation
from scipy.stats import binom

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.nanoindentation.continuous import ContinuousIndentation
from winkler.fitting.nanoindentation.indenter import CalibratedIndenter
from winkler.fitting.nanoindentation.measurement import Nanoindentation
from winkler.fitting.nanoindentation.quantities import indentation_quantities
from winkler.fitting.nanoindentation.repetition import repeated_mean
from winkler.fitting.nanoindentation.thermal_drift import ThermalDrift, found_drift
from winkler.fitting.nanoindentation.zero_point import ZeroPoint, found_zero_point
from winkler.fitting.unloading.contact_reading import CalibratedArea
from winkler.fitting.unloading.continuous_stiffness import ContinuousStiffness
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Standing

STILL = Machine(depth_noise=1e-14, force_noise=1e-11, drift=0.0)
EXACT_ZERO, NO_DRIFT = ZeroPoint(300e-9, 0.0, 0.0, extrapolated=False), ThermalDrift(0.0, 0.0)


def indenter(machine, covariance=None):
    more = {} if covariance is None else {"covariance": covariance}
    return CalibratedIndenter(CalibratedArea(machine.coefficients), machine.compliance, **more)


@pytest.mark.few(1)
@pytest.mark.parametrize("sample", [SILICA, SAPPHIRE, STEEL], ids=["silica", "sapphire", "steel"])
def test_every_unloading_is_read(sample):
    curve, truth = indentation(STILL, sample, 1, free=2.0, low_hold=2.0)
    found = Nanoindentation(curve, indenter(STILL), sample.poisson, zero_point=EXACT_ZERO, drift=NO_DRIFT).solve()
    assert found.force == pytest.approx(truth.force, rel=1e-6)
    assert found.stiffness == pytest.approx(truth.stiffness, rel=1e-3)
    assert found.contact_depth == pytest.approx(truth.contact_depth, rel=1e-3)
    assert found.young == pytest.approx(sample.young, rel=2e-3)
    assert found.hardness == pytest.approx(truth.hardness, rel=3e-3)


def test_the_touch_and_the_drift_are_found():
    machine = Machine()
    random = np.random.default_rng(3)
    rate = machine.drift * random.uniform(0.5, 1.5) * random.choice([-1.0, 1.0])
    curve, _ = indentation(machine, SILICA, 3)
    curve = dataclasses.replace(curve, machine_stiffness=1.0 / machine.compliance)
    drift = found_drift(curve)
    assert drift.rate == pytest.approx(rate, abs=4.0 * drift.error)
    assert drift.error < 0.2 * abs(rate)
    steady = dataclasses.replace(curve, position=curve.position - rate * curve.time)
    zero = found_zero_point(steady)
    assert zero.position == pytest.approx(300e-9, abs=1.5e-9)
    assert 0.05e-9 < zero.error < 1e-9
    assert not zero.extrapolated


def test_a_hold_at_a_small_peak_is_no_drift():
    """It creeps: only a hold after an unloading, or before the first loading, counts."""
    curve, _ = indentation(Machine(drift=0.0), SILICA, 1, low_hold=0.0)
    assert curve.segments[1].kind.value == "hold"
    assert not found_drift(curve).measured


def test_a_tip_that_is_lifted_off_first_neither_drifts_nor_touches_early():
    """As instruments do that begin in contact: 2 s at a small force, lifted off, and back."""
    machine = Machine(drift=0.0)
    curve, _ = indentation(machine, SILICA, 5, free=3.0, low_hold=0.0)
    random = np.random.default_rng(1)
    back = np.concatenate([np.full(4, 302e-9), np.linspace(300e-9, 240e-9, 60)])
    position = np.concatenate([back + machine.depth_noise * random.standard_normal(64), curve.position])
    force = np.concatenate([np.full(4, 8e-6), np.zeros(60)]) + machine.force_noise * random.standard_normal(64)
    time = np.concatenate([np.arange(64) / machine.rate, curve.time + 64 / machine.rate])
    lifted = ForceCurve(position, np.concatenate([force, curve.force]), time=time)
    assert not found_drift(lifted).measured
    assert found_zero_point(lifted).position == pytest.approx(300e-9, abs=2e-9)


def test_without_points_before_contact_the_first_point_bounds_the_touch():
    curve, _ = indentation(Machine(), SILICA, 2)
    first = int(np.argmax(curve.position > 301e-9))
    zero = found_zero_point(curve.chosen(np.arange(first, curve.count)))
    assert zero.extrapolated
    assert zero.position == pytest.approx(300e-9, abs=5e-9)


WORLDS = {
    "silica": (Machine(), SILICA, {}),
    "steel": (Machine(rate=50.0), STEEL, {"levels": 1, "leg": 20.0}),
    "sapphire": (Machine(), SAPPHIRE, {"peak": 30e-3}),
    "sharp": (Machine(coefficients=(24.5, 1e-7)), SILICA, {}),
    "noisy": (Machine(depth_noise=0.6e-9, force_noise=1e-6), SILICA, {"levels": 3}),
    "coarse": (Machine(rate=8.0), SILICA, {"levels": 1}),
    "elastic_start": (Machine(), dataclasses.replace(SILICA, size=10e-9, power=-0.5), {}),
}


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("name", WORLDS)
def test_intervals_hold(name):
    """All unloadings of each world: intervals of 95 % hold as often as 0.92 allows, the median is off by less than a
    fifth of the interval."""
    machine, sample, how = WORLDS[name]
    young, hardness = [], []
    for seed in range(7000, 7020):
        curve, truth = indentation(machine, sample, seed, **how)
        found = Nanoindentation(curve, indenter(machine), sample.poisson).solve()
        young.append((found.young - sample.young) / found.young_errors)
        hardness.append((found.hardness - truth.hardness) / found.hardness_errors)
    for errors in (np.array(young), np.array(hardness)):
        assert np.count_nonzero(np.abs(errors) < 1.96) >= binom.ppf(1e-3, errors.size, 0.92)
        assert abs(np.median(errors)) < 0.2 * 2.0 * 1.96


@pytest.mark.slow
def test_shares_follow_their_sources():
    """Each share against finite differences of the whole evaluation, made by hand."""
    covariance = np.diag([2e-8, 0.3, 4e-8]) ** 2
    curve, _ = indentation(STILL, SILICA, 1, free=2.0, low_hold=2.0, levels=3)
    zero = dataclasses.replace(EXACT_ZERO, error=1e-9)
    drift = ThermalDrift(0.0, 2e-12)
    given = {"zero_point": zero, "drift": drift, "poisson_error": 0.01}
    found = Nanoindentation(curve, indenter(STILL, covariance), 0.17, **given).solve()
    place = {name: number for number, name in enumerate(found.sources)}

    def changed(**other):
        again = Nanoindentation(curve, indenter(STILL), 0.17, **{"zero_point": zero, "drift": drift, **other}).solve()
        return np.abs(again.young - found.young), np.abs(again.hardness - found.hardness)

    moved = dataclasses.replace(zero, position=zero.position + 1e-10)
    young, hardness = changed(zero_point=moved)
    assert found.young_shares[place["zero point"]] == pytest.approx(10.0 * young, rel=0.02)
    assert found.hardness_shares[place["zero point"]] == pytest.approx(10.0 * hardness, rel=0.02)
    touched = float(curve.time[np.argmax(curve.position > 300e-9)])
    at_touch = dataclasses.replace(zero, position=zero.position - 1e-12 * touched)  # the drift counts from there
    young, hardness = changed(drift=ThermalDrift(1e-12, 2e-12), zero_point=at_touch)
    assert found.young_shares[place["drift"]] == pytest.approx(2.0 * young, rel=0.15)  # of two that cancel
    assert found.hardness_shares[place["drift"]] == pytest.approx(2.0 * hardness, rel=0.05)
    parts = []
    for number, spread in enumerate([2e-8, 0.3, 4e-8]):
        numbers = np.array([STILL.compliance, *STILL.coefficients])
        numbers[number] += 0.01 * spread
        other = CalibratedIndenter(CalibratedArea(numbers[1:]), numbers[0])
        again = Nanoindentation(curve, other, 0.17, zero_point=zero, drift=drift).solve()
        parts.append(100.0 * np.abs(again.hardness - found.hardness))
    assert found.hardness_shares[place["calibration"]] == pytest.approx(
        np.sqrt(np.sum(np.square(parts), axis=0)), rel=0.02
    )
    by_poisson = found.young * 2.0 * 0.17 * 0.01 / (1.0 - 0.17**2)
    assert found.young_shares[place["constants"]] == pytest.approx(by_poisson, rel=1e-4)
    assert found.young_errors == pytest.approx(np.sqrt(np.sum(found.young_shares**2, axis=0)), rel=1e-12)


@pytest.mark.slow
def test_the_mean_of_repeated_indentations():
    """The calibration is common: no repetition makes it smaller."""
    covariance = np.diag([0.0, 0.5, 0.0]) ** 2
    found = [
        Nanoindentation(indentation(Machine(), SILICA, seed)[0], indenter(Machine(), covariance), 0.17).solve()
        for seed in range(3)
    ]
    mean = repeated_mean(found, "hardness")
    last = [one.hardness[-1] for one in found]
    assert mean.mean == pytest.approx(np.mean(last), rel=1e-12)
    assert mean.scatter == pytest.approx(np.std(last, ddof=1), rel=1e-12)
    by = dict(zip(mean.sources, mean.shares.tolist(), strict=True))
    one = dict(zip(found[0].sources, found[0].hardness_shares[:, -1].tolist(), strict=True))
    assert by["calibration"] == pytest.approx(one["calibration"], rel=0.02)
    assert by["noise"] == pytest.approx(one["noise"] / math.sqrt(3.0), rel=0.3)
    low, high = mean.interval()
    assert low < 8.97e9 < high
    with pytest.raises(InvalidInput, match="give one, and young or hardness"):
        repeated_mean([])


def test_quantities_of_the_standard():
    """Each by its definition on the true curve of the world."""
    machine = dataclasses.replace(STILL, coefficients=(24.5,))
    curve, truth = indentation(machine, SILICA, 1, free=2.0, low_hold=0.0, levels=1, creep=0.05)
    given = {"zero_point": EXACT_ZERO, "drift": NO_DRIFT}
    found = Nanoindentation(curve, indenter(machine), 0.17, **given).solve()
    got = indentation_quantities(found)
    deepest, area = truth.depth[0], truth.area[0]
    assert got.value("HM") == pytest.approx(10e-3 / (26.43 * deepest**2), rel=2e-3)
    assert got.value("HIT") == pytest.approx(10e-3 / area, rel=3e-3)
    assert got.value("HV*") == pytest.approx(0.0945 * 10e-3 / area * 1e-6, rel=3e-3)
    assert got.value("EIT") == pytest.approx(SILICA.young, rel=2e-3)
    start = machine.contact_depth(np.array([10e-3]), SILICA)[0]
    start += 0.75 * 10e-3 / (2.0 * SILICA.modulus * math.sqrt(machine.area(start) / math.pi))
    assert got.value("CIT") == pytest.approx(deepest / start - 1.0, rel=0.06)
    assert math.isnan(got.value("RIT"))
    width = 1.5 * 10e-3 / truth.stiffness[0]
    elastic = 10e-3 * width * (1.0 - 0.1 ** (5.0 / 3.0)) / 2.5  # of the part that is measured, down to a tenth
    assert got.value("W_e") == pytest.approx(elastic, rel=3e-3)
    loading = 10e-3 * start / 3.0 + 10e-3 * (deepest - start)  # F goes as h^2 under a sharp tip, then the hold
    assert got.value("W") == pytest.approx(loading, rel=5e-3)
    assert got.value("W_p") == pytest.approx(got.value("W") - got.value("W_e"), rel=1e-12)
    assert got.value("HMs") == pytest.approx(10e-3 / start**2 / 26.43, rel=5e-3)


@pytest.mark.slow
def test_errors_of_the_work_are_those_of_repeated_noise():
    """Of 40 noisy tests the works scatter as their errors say; they were 0.0."""
    depth = np.concatenate([300e-9 * np.linspace(0.0, 1.0, 150) ** 0.5, 150e-9 + 150e-9 * np.linspace(1, 0, 90) ** 0.7])
    force = 1e-2 * np.concatenate([np.linspace(0.0, 1.0, 150), np.linspace(1.0, 0.0, 90)])
    tip = CalibratedIndenter(CalibratedArea((24.5,)))
    random, found = np.random.default_rng(1), []
    for _ in range(40):
        noisy = depth + 1e-9 * random.standard_normal(240), force + 3e-5 * random.standard_normal(240)
        stated = [("loading", 0), ("unloading", 150)]
        curve = ForceCurve(*noisy, time=0.1 * np.arange(240)).with_segments(stated)
        solution = Nanoindentation(curve, tip, 0.2, zero_point=ZeroPoint(0.0, 1e-10, 0.0, extrapolated=False))
        found.append(indentation_quantities(solution.solve()))
    for name in ("W", "W_e", "W_p", "eta_IT"):
        scatter = np.std([one.value(name) for one in found], ddof=1)
        stated = np.sqrt(np.mean([one.error(name) ** 2 for one in found]))
        assert 0.7 < stated / scatter < 1.6, name


def test_continuous_stiffness():
    machine = Machine()
    contact = np.linspace(20e-9, 500e-9, 300)
    area = machine.area(contact)
    force, stiffness = SILICA.hardness * area, 2.0 * SILICA.modulus * np.sqrt(area / np.pi)
    depth = contact + 0.75 * force / stiffness
    data = ContinuousStiffness(
        depth + machine.compliance * force, force, 1.0 / (1.0 / stiffness + machine.compliance), np.arange(300.0)
    )
    covariance = np.diag([0.0, 0.5, 0.0]) ** 2
    found = ContinuousIndentation(data, indenter(machine, covariance), 0.17).solve()
    assert found.young == pytest.approx(SILICA.young, rel=1e-9)
    assert found.hardness == pytest.approx(SILICA.hardness, rel=1e-9)
    assert found.depth == pytest.approx(depth, rel=1e-12)
    assert found.hardness_errors == pytest.approx(SILICA.hardness * 0.5 * contact**2 / area, rel=1e-4)
    framed = dataclasses.replace(data, machine_stiffness=1.0 / machine.compliance)
    again = ContinuousIndentation(framed, dataclasses.replace(indenter(machine), frame_compliance=0.0), 0.17).solve()
    assert again.young == pytest.approx(SILICA.young, rel=1e-9)
    mean = found.mean(100e-9, 300e-9)
    assert mean.young == pytest.approx(SILICA.young, rel=1e-9)
    assert mean.young_scatter < 1e-6 * SILICA.young
    with pytest.raises(InvalidInput, match="mean: 0 points lie at 1 m to 2 m"):
        found.mean(1.0, 2.0)
    with pytest.raises(InvalidInput, match="stiffness has 2"):
        ContinuousStiffness([1e-9, 2e-9, 3e-9], [1.0, 2.0, 3.0], [1.0, 2.0])


@pytest.mark.slow
def test_validity_names_what_is_missing():
    curve, _ = indentation(Machine(), SILICA, 1, low_hold=0.0)
    found = Nanoindentation(curve, indenter(Machine()), 0.17).solve()
    notes = {note.statement.partition(":")[0]: note for note in found.validity}
    assert "its contribution to the uncertainty is missing" in notes["Drift"].statement
    assert "covariance of area and frame is not known" in notes["Calibration"].statement
    narrow = CalibratedArea(Machine().coefficients, 1e-9, 5e-8)
    other = CalibratedIndenter(narrow, Machine().compliance, np.diag([1e-9, 0.1, 1e-9]) ** 2)
    outside = Nanoindentation(curve, other, 0.17).solve().validity
    assert any(note.standing is Standing.OUTSIDE and "extrapolated" in note.statement for note in outside)


def test_what_cannot_be_evaluated_is_refused():
    curve, _ = indentation(STILL, SILICA, 1, free=2.0, low_hold=0.0, levels=1)
    with pytest.raises(InvalidInput, match="has no unloading that can be evaluated"):
        Nanoindentation(curve.chosen(np.arange(200)), indenter(STILL), 0.17).solve()
    soft = CalibratedIndenter(CalibratedArea((24.5,)), 1e-3)
    with pytest.raises((InvalidInput, OutsideValidity)):
        Nanoindentation(curve, soft, 0.17, zero_point=EXACT_ZERO).solve()
    with pytest.raises(InvalidInput, match="parts of the force"):
        Nanoindentation(curve, indenter(STILL), 0.17, upper=0.2)
    with pytest.raises(InvalidInput, match="shape"):
        CalibratedIndenter(CalibratedArea((24.5, 1e-6)), 0.0, np.eye(2))
    with pytest.raises(InvalidInput, match="fewer than"):
        found_zero_point(ForceCurve([0.0, 1e-9, 2e-9], [0.0, 1e-6, 2e-6]))


def test_results_are_drawn():
    from winkler.plot import draw

    contact = np.linspace(20e-9, 500e-9, 50)
    size = Machine().area(contact)
    force, stiffness = 9e9 * size, 2.0 * SILICA.modulus * np.sqrt(size / np.pi)
    data = ContinuousStiffness(contact + 0.75 * force / stiffness, force, stiffness)
    tip = CalibratedIndenter(CalibratedArea(Machine().coefficients), 0.0)
    curve, _ = indentation(STILL, SILICA, 1, free=2.0, low_hold=0.0, levels=2)
    found = Nanoindentation(curve, indenter(STILL), 0.17, zero_point=EXACT_ZERO, drift=NO_DRIFT).solve()
    for item, count in ((ContinuousIndentation(data, tip, 0.17).solve(), 2), (found, 3)):
        assert len(draw(item).axes) == count
