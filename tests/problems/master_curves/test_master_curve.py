"""Master curves of sweeps made with closed formulas: shifts, laws, spectra, and how often their intervals hold."""

from __future__ import annotations

import tomllib
from importlib.resources import files

import numpy as np
import pytest
from master_worlds import (
    ENERGY,
    FIRST,
    REFERENCE,
    SECOND,
    WARMTH,
    arrhenius,
    contradicting,
    ferry,
    moduli,
    slower_loss,
    sweeps,
)

import winkler as wk

FEW, MANY = 12, 40


def judged(found, truth):
    """Return errors of the logarithms of the shifts over their standard errors."""
    others = found.shift_error > 0.0
    return ((np.log(found.shift_factor) - truth) / np.where(others, found.shift_error, 1.0))[others]


def held(interval, truth):
    return interval[0] <= truth <= interval[1]


@pytest.mark.few(1)
@pytest.mark.parametrize(("law", "name"), [(ferry, "Williams, Landel and Ferry"), (arrhenius, "Arrhenius")])
def test_without_scatter_shifts_and_constants_come_back(law, name):
    found = wk.MasterCurve(sweeps(0, law, scatter=0.0), REFERENCE).solve()
    assert np.log(found.shift_factor) == pytest.approx(law(WARMTH), abs=1e-3)
    assert found.verdict == name
    if law is ferry:
        assert (found.first_constant, found.second_constant) == pytest.approx((FIRST, SECOND), rel=1e-3)
    else:
        assert found.activation_energy == pytest.approx(ENERGY, rel=1e-4)
        assert found.second_constant == pytest.approx(REFERENCE, rel=1e-2)  # Arrhenius is a Ferry with c2 = T0


@pytest.mark.slow
def test_intervals_hold_the_truth_as_often_as_they_say():
    scores, constants = [], []
    for seed in range(FEW):
        found = wk.MasterCurve(sweeps(seed), REFERENCE).solve()
        scores.append(judged(found, ferry(WARMTH)))
        constants.append([held(found.laws.first_interval, FIRST), held(found.laws.second_interval, SECOND)])
        assert found.verdict == "Williams, Landel and Ferry"
        assert found.scatter == pytest.approx(0.02, rel=0.35)
    scores = np.array(scores)
    assert 0.90 <= np.mean(np.abs(scores) < 1.96) <= 0.99
    assert np.max(np.abs(np.mean(scores, axis=0))) < 0.8  # 3.5 standard errors of the mean
    assert np.mean(constants) >= 0.8


@pytest.mark.long
@pytest.mark.parametrize("law", [ferry, arrhenius])
def test_intervals_of_many_curves(law):
    scores, constants, verdicts = [], [], []
    for seed in range(5000, 5000 + MANY):
        found = wk.MasterCurve(sweeps(seed, law), REFERENCE).solve()
        scores.append(judged(found, law(WARMTH)))
        laws = found.laws
        if law is ferry:
            constants.append([held(laws.first_interval, FIRST), held(laws.second_interval, SECOND)])
        else:
            constants.append([held(laws.energy_interval, ENERGY), held(laws.second_interval, REFERENCE)])
        verdicts.append(found.verdict)
    scores = np.array(scores)
    assert 0.92 <= np.mean(np.abs(scores) < 1.96) <= 0.98
    assert np.max(np.abs(np.mean(scores, axis=0))) < 0.2 * 2.0 * 1.96  # a fifth of the interval
    assert np.all(np.mean(constants, axis=0) >= 0.85)
    right = "Williams, Landel and Ferry" if law is ferry else "Arrhenius"
    assert verdicts.count(right) + verdicts.count("cannot tell") >= 0.98 * MANY


def test_few_temperatures_cannot_tell_the_laws_apart():
    found = wk.MasterCurve(sweeps(1, arrhenius, warmth=WARMTH[3:6], scatter=0.05), REFERENCE - 10.0).solve()
    assert found.verdict == "cannot tell"
    assert any("cannot tell" in note.statement for note in found.validity)


@pytest.mark.slow
def test_factors_of_the_moduli_are_found_and_otherwise_spoil_the_superposition():
    factors = np.exp(0.1 * np.sin(np.arange(WARMTH.size)))
    truth = factors / factors[4]
    given = sweeps(3, factors=factors)
    free = wk.MasterCurve(given, REFERENCE, vertical=True).solve()
    assert np.all(np.abs(np.log(free.vertical_factor / truth)) <= 4.0 * free.vertical_error)
    assert np.all(np.abs(judged(free, ferry(WARMTH))) < 4.0)
    without = wk.MasterCurve(given, REFERENCE).solve()
    assert without.scatter[0] > 1.5 * free.scatter[0]
    assert any("do not superpose" in note.statement for note in without.validity)
    assert not any("do not superpose" in note.statement for note in free.validity)


@pytest.mark.slow
def test_entropic_moduli_grow_with_the_temperature():
    found = wk.MasterCurve(sweeps(4, factors=WARMTH / REFERENCE, scatter=0.0), REFERENCE, entropic=True).solve()
    assert np.log(found.shift_factor) == pytest.approx(ferry(WARMTH), abs=1e-3)
    assert found.vertical_factor == pytest.approx(WARMTH / REFERENCE, rel=1e-12)


@pytest.mark.slow
def test_isochronal_sweeps_of_three_frequencies_are_shifted_as_well():
    warmth = np.arange(223.15, 304.0, 4.0)
    at = WARMTH[4] - 2.0 + 2.0  # one of the temperatures: 263.15 K
    found = wk.MasterCurve(sweeps(5, warmth=warmth, count=3), at).solve()
    assert np.mean(np.abs(judged(found, ferry(warmth))) < 1.96) >= 0.8
    assert np.all(np.abs(judged(found, ferry(warmth))) < 4.5)


def test_a_fluid_keeps_no_modulus():
    found = wk.MasterCurve(sweeps(6, relaxed=False), REFERENCE, fluid=True).solve()
    assert found.relaxed_shear == 0.0
    assert np.all(np.abs(judged(found, ferry(WARMTH))) < 4.0)


def test_relaxation_at_several_temperatures():
    """G(t) = 1 MPa + 10 MPa / (1 + t / 1 s)^0.6, a smooth spectrum."""
    rng = np.random.default_rng(7)
    warmth, time = np.repeat(WARMTH[2:7], 20), np.tile(np.geomspace(0.05, 50.0, 20), 5)
    modulus = 1e6 + 10e6 / (1.0 + time / np.exp(ferry(warmth))) ** 0.6
    noisy = modulus * np.exp(0.01 * rng.standard_normal(time.size))
    found = wk.MasterCurve(wk.RelaxationSweeps(warmth, time, noisy), REFERENCE).solve()
    assert np.all(np.abs(judged(found, ferry(WARMTH[2:7]))) < 4.0)
    assert found.scatter == pytest.approx(0.01, rel=0.3)
    assert found.solid.relaxation(1.0) == pytest.approx(1e6 + 10e6 / 2.0**0.6, rel=0.02)


def test_the_solid_is_a_material_at_any_temperature():
    found = wk.MasterCurve(sweeps(8), REFERENCE).solve()
    warm = found.solid_at(288.15)
    turns = 1j * 20.0 * np.exp(ferry(288.15)) * 1e-3
    assert warm.storage(20.0) == pytest.approx(moduli(turns).real, rel=0.02)
    assert warm.loss(20.0) == pytest.approx(moduli(turns).imag, rel=0.03)
    bed = wk.Foundation(wk.Paraboloid(1e-2), wk.ViscoelasticHalfSpace(warm))
    shaken = wk.HarmonicIndentation(bed, wk.Depth(1e-5), 20.0).solve()
    assert shaken.loss_tangent == pytest.approx(moduli(turns).imag / moduli(turns).real, rel=0.03)


def test_a_gap_between_temperatures_is_stated():
    found = wk.MasterCurve(sweeps(9, warmth=np.array([233.15, REFERENCE, 273.15])), REFERENCE).solve()
    note = next(note for note in found.validity if "decades" in note.statement)
    assert "gap" in note.statement
    assert "233" in note.statement


@pytest.mark.parametrize("seed", range(2))
def test_storage_and_loss_that_contradict_each_other_are_said_to(seed):
    found = wk.MasterCurve(contradicting(seed), REFERENCE).solve()
    others = found.loss_over_storage_error > 0.0
    wrong = np.log(found.loss_over_storage) - slower_loss(WARMTH)
    assert np.all(np.abs(wrong[others]) < 4.0 * found.loss_over_storage_error[others])
    said = [note.statement for note in found.validity if "contradict" in note.statement]
    assert len(said) == 1
    assert "by = 'storage' or by = 'loss'" in said[0]


@pytest.mark.parametrize("by", [wk.ShiftedBy.STORAGE, wk.ShiftedBy.LOSS])
def test_shifts_by_one_of_them_are_its_own(by):
    """Together they give neither: the joint shifts are off by tens of errors of the storage alone."""
    truth = ferry(WARMTH) + (slower_loss(WARMTH) if by is wk.ShiftedBy.LOSS else 0.0)
    found = wk.MasterCurve(contradicting(3), REFERENCE, by=by).solve()
    assert np.all(np.abs(judged(found, truth)) < 4.0)
    assert any(f"those of the {by} modulus alone" in note.statement for note in found.validity)
    assert found.loss_over_storage.size == 0
    assert found.residuals.size == 2 * 13 * WARMTH.size  # of both, with these shifts
    own, other = found.scatter if by is wk.ShiftedBy.STORAGE else found.scatter[::-1]
    assert other > 2.0 * own


@pytest.mark.long
def test_one_body_contradicts_itself_as_rarely_as_it_says():
    """Scores of 96 differences are those of a normal number: variance 1 +- 0.15, none beyond one in a thousand."""
    scores = []
    for seed in range(100, 100 + FEW):
        found = wk.MasterCurve(sweeps(seed), REFERENCE).solve()
        others = found.loss_over_storage_error > 0.0
        scores.append(np.log(found.loss_over_storage[others]) / found.loss_over_storage_error[others])
        assert not any("contradict" in note.statement for note in found.validity)
    assert 0.6 <= np.mean(np.square(scores)) <= 1.5


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (
            {"sweeps": wk.RelaxationSweeps(WARMTH, np.ones(9), np.ones(9)), "by": wk.ShiftedBy.LOSS},
            "by is 'loss', and the sweeps are relaxations",
        ),
        ({"reference_temperature": 268.0}, "the nearest temperature is 263.15 K"),
        ({"vertical": True, "entropic": True}, "let one of them be false"),
        ({"temperature_step": 100.0}, "all rows have temperatures within"),
        ({"per_decade": 1}, "per_decade is 1"),
    ],
)
def test_what_cannot_be_shifted_is_refused(change, sentence):
    with pytest.raises(wk.InvalidInput, match=sentence):
        wk.MasterCurve(**({"sweeps": sweeps(0), "reference_temperature": REFERENCE} | change))


def test_shifts_of_neither_law_are_said_to_be_so():
    found = wk.MasterCurve(
        sweeps(10, lambda t: 0.6 * np.sin(t / 6.0) - 0.6 * np.sin(REFERENCE / 6.0)), REFERENCE
    ).solve()
    assert found.verdict == "neither"
    with pytest.raises(wk.OutsideValidity, match="neither law"):
        found.solid_at(280.0)


def test_the_case_of_polyisobutylene_is_that_of_its_formula():
    """Its shifts refer to 298 K; at the glass transition, 202 K, the same law has 16.6 and 104 K (Ferry, table "
    "11-II)."""
    case = tomllib.loads((files("winkler.cases") / "master_curve_polyisobutylene.toml").read_text(encoding="utf-8"))
    table = case["problem"]["sweeps"]
    warmth, omega, storage, loss = (
        np.array([float(cell.split()[0]) for cell in table[name]])
        for name in ("temperature", "angular_frequency", "storage_shear", "loss_shear")
    )
    first, second = (line["value"] for line in case["expect"])
    shift = 10.0 ** (-first * (warmth - 298.0) / (second + warmth - 298.0))
    turns = np.sqrt(1j * omega * shift * 1e-6)
    modulus = 1e6 + 1e9 * turns / (1.0 + turns)
    assert storage == pytest.approx(modulus.real, rel=1e-5)
    assert loss == pytest.approx(modulus.imag, rel=1e-5)
    at_glass = second + 202.0 - 298.0
    assert at_glass == pytest.approx(104.4, abs=0.05)
    assert first * second / at_glass == pytest.approx(16.6, abs=0.1)
