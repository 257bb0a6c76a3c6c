"""Area and frame from one reference: how uncertain they are, whether that is said, and how often intervals hold."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from nano_worlds import Machine, Sample, indentation
from scipy.stats import binom, norm

from winkler.fitting.nanoindentation.area_fit import ReferenceReadings, fitted_area
from winkler.fitting.nanoindentation.calibration import calibrate_indenter
from winkler.fitting.nanoindentation.calibration_solution import IndenterCalibration
from winkler.fitting.nanoindentation.indenter import CalibratedIndenter
from winkler.fitting.nanoindentation.measurement import Nanoindentation
from winkler.fitting.nanoindentation.readings import Peaks, factors_of, moved_by, readings_of
from winkler.fitting.nanoindentation.reference_samples import ReferenceSample
from winkler.fitting.nanoindentation.repetition import RepeatedMean
from winkler.fitting.unloading.contact_reading import CalibratedArea
from winkler.values.validity import Standing

TIP = (1.0 - 0.07**2) / 1141e9
SILICA = ReferenceSample(72e9, 0.17, 0.0, "silica")
STEEL, STEEL_POISSON, STEEL_HARDNESS = 210e9, 0.3, 6.4e9
DEPTH_NOISE, COMPLIANCE_NOISE, ZERO_NOISE = 0.15e-9, 0.004, 0.7e-9
FORCES = np.linspace(2e-3, 8e-3, 6)
FRAME, AREA = 0.5e-6, (24.5, 800e-9)
"""Of the issue: 0.5 um/N, 24.5 h^2 + 800 nm h, six unloadings of 2 to 8 mN."""


def area_of(coefficients, height):
    return sum(c * height ** (2.0 ** (1 - n)) for n, c in enumerate(coefficients))


def peaks(force, young, poisson, hardness, frame, coefficients):
    """Of F = H A(h_c), S = 2 E_r sqrt(A/pi), h = h_c + 3/4 F/S, on a frame."""
    modulus = 1.0 / ((1.0 - poisson**2) / young + TIP)
    area = force / hardness
    low, high = np.zeros_like(area), np.full_like(area, 1e-4)
    for _ in range(100):
        middle = 0.5 * (low + high)
        below = area_of(coefficients, middle) < area
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    compliance = np.sqrt(np.pi) / (2.0 * modulus * np.sqrt(area))
    return force, low + (0.75 * compliance + frame) * force, compliance + frame


def silica(random, count, frame, coefficients, noise=1.0):
    """Readings of `count` curves with noise of depth and compliance, and zero points that share a quarter of it."""
    columns, blocks = [], []
    shared = 0.5 * random.standard_normal()
    for number in range(count):
        force, depth, compliance = peaks(FORCES, 72e9, 0.17, 9.3e9, frame, coefficients)
        depth = depth + noise * ZERO_NOISE * (shared + np.sqrt(0.75) * random.standard_normal())
        depth = depth + noise * DEPTH_NOISE * random.standard_normal(force.size)
        compliance = compliance * (1.0 + noise * COMPLIANCE_NOISE * random.standard_normal(force.size))

        def covariance(by_depth, by_compliance, compliance=compliance):
            own = (by_depth * DEPTH_NOISE) ** 2 + (by_compliance * COMPLIANCE_NOISE * compliance) ** 2
            return np.diag(own) + 0.75 * np.outer(by_depth, by_depth) * ZERO_NOISE**2

        columns.append((force, depth, compliance))
        blocks.append((np.arange(number * force.size, (number + 1) * force.size), covariance))
    force, depth, compliance = np.concatenate(columns, axis=1)
    whole = np.ones(force.size)
    modulus = 1.0 / ((1.0 - 0.17**2) / 72e9 + TIP)
    return ReferenceReadings(force, depth, compliance, 0.75 * whole, modulus * whole, ZERO_NOISE * whole, blocks)


def calibrated(readings, known=None):
    found = fitted_area(readings, range(1, 5), 1.0, known)
    area = CalibratedArea(tuple(found.numbers[1:].tolist()), 1e-8, 1e-6)
    indenter = CalibratedIndenter(area, float(found.numbers[0]), found.covariance)
    own = readings.compliance - found.numbers[0]
    contact = readings.depth - found.numbers[0] * readings.force - 0.75 * readings.force * own
    measured = np.pi * (1.0 / (2.0 * readings.reference * own)) ** 2
    names = ("silica",) * own.size
    return IndenterCalibration(
        indenter, readings.force, contact, measured, found.residuals, names, found.factor, (SILICA,)
    )


def of_steel(indenter, frame, coefficients):
    """E and H of a noiseless indentation, and their standard uncertainties by the calibration."""
    force, depth, compliance = peaks(np.array([8e-3]), STEEL, STEEL_POISSON, STEEL_HARDNESS, frame, coefficients)
    given = Peaks(force, depth, compliance, np.array([0.75]))
    base = readings_of(given, indenter.numbers, indenter, STEEL_POISSON)
    moved = [moved_by(given, indenter, STEEL_POISSON, numbers=part) for part in factors_of(indenter.covariance).T]
    errors = [np.sqrt(sum(float(getattr(one, name)[0]) ** 2 for one in moved)) for name in ("young", "hardness")]
    return float(base.young[0]), float(base.hardness[0]), *errors


def test_one_reference_of_clean_data_says_that_frame_and_area_are_hardly_told_apart():
    """It gave a frame of 1.5e-24 m/N in a part of the seeds, and E from -2.274 to 2.656 TPa."""
    found = calibrated(silica(np.random.default_rng(0), 1, FRAME, AREA, noise=0.0))
    error = found.frame_compliance_error
    assert abs(found.frame_compliance - FRAME) < error
    assert 0.1e-6 < error < 2e-6
    young, hardness, young_error, hardness_error = of_steel(found.indenter, FRAME, AREA)
    assert abs(young - STEEL) < young_error < 0.5 * STEEL
    assert abs(hardness - STEEL_HARDNESS) < hardness_error < 0.5 * STEEL_HARDNESS
    determined, described = found.validity
    assert determined.standing is Standing.APPROXIMATE
    assert f"a correlation of {found.correlation:.2f}" in determined.statement
    assert abs(found.correlation) > 0.5
    assert "give frame_compliance, more depths, or a second reference" in determined.statement
    assert described.standing is Standing.ASYMPTOTIC


def test_a_given_frame_is_no_part_of_the_calibration():
    found = calibrated(silica(np.random.default_rng(1), 2, FRAME, AREA), known=FRAME)
    assert found.frame_compliance_error == 0.0
    assert np.isnan(found.correlation)
    assert "was given" in found.validity[0].statement
    assert of_steel(found.indenter, FRAME, AREA)[0] == pytest.approx(STEEL, rel=0.03)


def test_readings_that_no_area_explains_are_approximate():
    readings = silica(np.random.default_rng(2), 1, FRAME, AREA)
    jumping = readings.compliance * (1.0 + 0.03 * np.array([1, -1, 1, -1, 1, -1]))
    found = calibrated(readings._replace(compliance=jumping))
    assert found.validity[1].standing is Standing.APPROXIMATE


def test_no_interval_of_a_mean_is_below_zero():
    """210 +- 400 GPa: the logarithm ends at 5 and 8,800 GPa."""
    mean = RepeatedMean(210e9, ("calibration",), np.array([400e9]), 1e6, 6, 1e9)
    low, high = mean.interval()
    assert low == pytest.approx(210e9 * np.exp(-1.959964 * 400.0 / 210.0), rel=1e-4)
    assert low > 0.0
    assert np.isfinite(dataclasses.replace(mean, shares=np.array([1e17])).interval()[1])
    assert high == pytest.approx(210e9 * np.exp(1.959964 * 400.0 / 210.0), rel=1e-4)


BLUNTER = (24.5, 800e-9, 2e-10)
"""A tip with a term in h^(1/2), a tenth of the others at 150 nm."""
COVERED = (0.92, 0.98)


def drawn_tip(random):
    """Tips of two to four coefficients."""
    blunt = random.uniform(2e-7, 1.5e-6)
    higher = [random.uniform(0.0, 0.5) * blunt * 2e-7**0.5, random.uniform(0.0, 0.3) * blunt * 2e-7**0.75]
    return (random.uniform(22.0, 26.0), blunt, *higher[: random.integers(3)])


def errors_in_worlds(count, worlds, tip_of):
    """Errors of frame, ln E and ln H in standard uncertainties, (worlds, 3); frames are drawn up to 2 um/N."""
    apart = np.zeros((worlds, 3))
    for seed in range(worlds):
        random = np.random.default_rng([37, count, seed])
        frame, tip = random.uniform(0.0, 2e-6), tip_of(random)
        found = calibrated(silica(random, count, frame, tip))
        young, hardness, young_error, hardness_error = of_steel(found.indenter, frame, tip)
        apart[seed] = (
            (found.frame_compliance - frame) / found.frame_compliance_error,
            np.log(young / STEEL) * young / young_error,
            np.log(hardness / STEEL_HARDNESS) * hardness / hardness_error,
        )
    return apart


def hold(apart):
    """Whether coverage is that of the goal, within the scatter of so many worlds.

    Of errors of a normal distribution 0.98 and 0.92 lie within 1.96 where their rms is 0.84 and 1.12.  Hits alone would
    hardly exclude wide intervals: a hundred of a hundred are found in 13 % of all tables of a coverage of 0.98.
    """
    worlds = len(apart)
    scatter = 2.58 / np.sqrt(2.0 * worlds)
    least, most = (norm.ppf(0.975) / norm.ppf(0.5 + 0.5 * covered) for covered in COVERED[::-1])
    assert np.all(np.count_nonzero(np.abs(apart) < 1.96, axis=0) >= binom.ppf(0.005, worlds, COVERED[0]))
    size = np.sqrt(np.mean(apart**2, axis=0))
    assert np.all((least * (1.0 - scatter) < size) & (size < most * (1.0 + scatter)))


@pytest.mark.parametrize(
    ("count", "worlds"),
    [pytest.param(3, 30, marks=pytest.mark.slow), *(pytest.param(n, 100, marks=pytest.mark.long) for n in (1, 3, 10))],
)
def test_intervals_hold_in_drawn_worlds(count, worlds):
    """The truth includes the choice of the number of coefficients: tips have two, three or four."""
    hold(errors_in_worlds(count, worlds, drawn_tip))


def expected_tip(random):
    """A tip of one to four coefficients as the average expects it before the readings; its whole area is measured."""
    area, height = FORCES[-1] / 9.3e9, 172e-9
    while True:
        shares = np.abs(random.standard_normal(random.integers(1, 5)))
        shares = shares * 0.5 ** np.arange(shares.size)
        if random.uniform() < np.exp(-0.5 * ((shares.sum() - 1.0) / 0.02) ** 2):
            return shares * area / height ** (2.0 ** (1 - np.arange(shares.size)))


@pytest.mark.parametrize(
    ("count", "worlds"),
    [pytest.param(1, 20, marks=pytest.mark.slow), *(pytest.param(n, 80, marks=pytest.mark.long) for n in (1, 3))],
)
def test_the_frame_is_held_by_the_average_that_states_it(count, worlds):
    """Tips, their numbers of coefficients and frames are drawn from what is averaged: no other interval is its own."""
    apart = np.zeros((worlds, 1))
    for seed in range(len(apart)):
        random = np.random.default_rng([92, count, seed])
        frame, tip = random.uniform(0.0, 8e-6), expected_tip(random)
        found = calibrated(silica(random, count, frame, tip))
        apart[seed] = (found.frame_compliance - frame) / found.frame_compliance_error
    hold(apart)


@pytest.mark.parametrize("tip", [AREA, BLUNTER], ids=["berkovich", "blunter"])
@pytest.mark.parametrize(
    ("count", "worlds"),
    [pytest.param(1, 20, marks=pytest.mark.slow), *(pytest.param(n, 60, marks=pytest.mark.long) for n in (1, 10))],
)
def test_intervals_hold_for_two_tips(count, worlds, tip):
    """A tip on the bounds of the coefficients, and one within them: the number of coefficients is not known."""
    hold(errors_in_worlds(count, worlds, lambda _: tip))


@pytest.mark.slow
def test_the_noise_of_many_curves_does_not_make_the_frame_stiff():
    """With one covariance for all frames 1.5 um/N was missed by 2.15 standard uncertainties in the mean."""
    frame = 1.5e-6
    found = [calibrated(silica(np.random.default_rng([38, seed]), 10, frame, BLUNTER)) for seed in range(10)]
    assert abs(np.mean([(one.frame_compliance - frame) / one.frame_compliance_error for one in found])) < 1.0


@pytest.mark.slow
@pytest.mark.parametrize("seeds", [(0, 1, 2), (3, 4, 10)])
def test_whole_curves_of_the_six_seeds_hold(seeds):
    """Six unloadings of 2 to 8 mN with holds of 30 s that creep 2.8 nm.

    Of the seeds 0 to 29 version 0.2 missed most at 10: C_f 1.28 um/N, E 254 GPa [172, 336].
    """
    machine, forces = Machine(AREA, FRAME), {"peaks": FORCES, "hold": 30.0, "creep": 0.0163}
    held = []
    for seed in seeds:
        curve, truth = indentation(machine, Sample(), seed, **forces)
        assert truth.contact_depth[-1] - truth.contact_depth[-1] / 1.0163 == pytest.approx(2.8e-9, rel=0.02)
        found = calibrate_indenter([(curve, SILICA)])
        assert found.validity[0].standing is Standing.APPROXIMATE
        assert "hardly be separated" in found.validity[0].statement
        assert abs(found.frame_compliance - FRAME) < 1.96 * found.frame_compliance_error
        steel, _ = indentation(machine, Sample(STEEL, STEEL_POISSON, STEEL_HARDNESS), 1000 + seed, **forces)
        solution = Nanoindentation(steel, found.indenter, STEEL_POISSON).solve()
        for name, true in (("young", STEEL), ("hardness", STEEL_HARDNESS)):
            low, high = (float(end[solution.deepest]) for end in solution.interval(name))
            held.append(low < true < high)
            assert 0.5 * true < low
            assert high < 1.6 * true
    assert np.count_nonzero(held) >= len(held) - 1
