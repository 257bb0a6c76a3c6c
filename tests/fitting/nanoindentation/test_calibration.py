"""Area and frame from fused silica and sapphire of played worlds; files of indenters; first yield."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest
from nano_worlds import SAPPHIRE, SILICA, Machine, indentation
from scipy.stats import binom

from winkler.fitting.nanoindentation.calibration import calibrate_indenter
from winkler.fitting.nanoindentation.indenter import CalibratedIndenter
from winkler.fitting.nanoindentation.pop_ins import first_yield_stress, pop_in_statistics
from winkler.fitting.nanoindentation.reference_samples import ReferenceSample
from winkler.fitting.unloading.contact_reading import CalibratedArea
from winkler.io.indenter_file import read_indenter, write_indenter
from winkler.values.errors import InvalidInput

GLASS, CRYSTAL = ReferenceSample(72e9, 0.17, 0.0, "silica"), ReferenceSample(410e9, 0.24, 0.0, "sapphire")
HEIGHTS = np.array([80e-9, 150e-9, 300e-9, 400e-9])


def curves(machine, seed, silica=3, sapphire=1, **how):
    how = {"peak": 50e-3, "levels": 5, **how}
    found = [(indentation(machine, SILICA, 100 * seed + i, **how)[0], GLASS) for i in range(silica)]
    return found + [(indentation(machine, SAPPHIRE, 100 * seed + 50 + i, **how)[0], CRYSTAL) for i in range(sapphire)]


def area(found, height):
    return sum(c * height ** (2.0 ** (1 - n)) for n, c in enumerate(found.indenter.area.coefficients))


@pytest.mark.slow
def test_area_and_frame_are_found_together():
    machine = Machine()
    found = calibrate_indenter(curves(machine, 1, 2, 1))
    assert found.frame_compliance == pytest.approx(machine.compliance, abs=4.0 * found.frame_compliance_error)
    assert found.frame_compliance_error < 0.06 * machine.compliance
    errors = (area(found, HEIGHTS) - machine.area(HEIGHTS)) / found.area_error(HEIGHTS)
    assert np.all(np.abs(errors) < 4.0)
    assert np.all(found.area_error(HEIGHTS) < 0.02 * machine.area(HEIGHTS))
    assert found.indenter.area.shallowest == pytest.approx(found.contact_depth.min())
    assert found.factor < 3.0
    assert found.force.size == 15


@pytest.mark.slow
def test_a_reference_with_an_error_makes_the_area_uncertain():
    """At a known frame A goes as 1/E_r^2 of the reference."""
    given = curves(Machine(), 1, 2, 0)
    doubtful = dataclasses.replace(GLASS, young_error=1.44e9)
    sure = calibrate_indenter(given, terms=2, frame_compliance=Machine().compliance)
    unsure = calibrate_indenter(
        [(curve, doubtful) for curve, _ in given], terms=2, frame_compliance=Machine().compliance
    )
    share = np.sqrt(unsure.area_error(HEIGHTS) ** 2 - sure.area_error(HEIGHTS) ** 2) / area(sure, HEIGHTS)
    modulus = GLASS.modulus(sure.indenter.solid)
    relative = (1.0 - 0.17**2) / 72e9 * modulus * 0.02
    assert share == pytest.approx(2.0 * relative, rel=0.25)


@pytest.mark.long
def test_intervals_of_the_calibration_hold():
    """Of area and frame of four played calibrations, down to 60 nm, the shallowest reading."""
    machine, errors = Machine(), []
    heights = np.array([60e-9, *HEIGHTS])
    for seed in range(720, 724):
        found = calibrate_indenter(curves(machine, seed, 2, 1))
        frame = (found.frame_compliance - machine.compliance) / found.frame_compliance_error
        errors.append([frame, *((area(found, heights) - machine.area(heights)) / found.area_error(heights))])
    each = np.array(errors)
    assert np.count_nonzero(np.abs(each) < 1.96) >= binom.ppf(1e-3, each.size, 0.92)
    assert np.all(np.abs(np.median(each, axis=0)) < 1.0)  # of four: the median scatters by half a standard uncertainty


@pytest.mark.slow
def test_a_curve_that_stands_out_is_left_out_of_the_calibration():
    """One of six curves is of another glass, 60 GPa; the calibration is that of the other five."""
    machine = Machine(rate=8.0)
    short = {"levels": 2, "hold": 2.0, "leg": 8.0, "low_hold": 0.0}
    given = curves(machine, 3, 4, 1, **short)
    known = {"terms": 2, "frame_compliance": machine.compliance}
    clean = calibrate_indenter(given, **known)
    assert clean.left_out == ()
    soft = dataclasses.replace(SILICA, young=60e9, hardness=7e9)
    wrong = indentation(machine, soft, 999, peak=50e-3, **short)[0]
    found = calibrate_indenter([*given[:2], (wrong, GLASS), *given[2:]], **known)
    assert len(found.left_out) == 1
    assert found.left_out[0].startswith("seed 999: the compliance of its contacts stands out")
    assert found.indenter.area.coefficients == pytest.approx(clean.indenter.area.coefficients, rel=1e-9)
    assert any(note.statement == f"Left out: {found.left_out[0]}" for note in found.validity)


@pytest.mark.slow
def test_copies_count_once_in_a_calibration():
    """The same curve three times made the errors of frame and area too small."""
    given = curves(Machine(rate=8.0), 4, 1, 1, levels=2, hold=2.0, leg=8.0, low_hold=0.0)
    known = {"terms": 2, "frame_compliance": Machine().compliance}
    alone = calibrate_indenter(given, **known)
    found = calibrate_indenter([*given, given[0], given[0]], **known)
    assert np.array_equal(found.indenter.covariance, alone.indenter.covariance)
    assert found.left_out == ("seed 400: the data of seed 400, counted once.",) * 2


def test_calibrations_that_are_refused():
    with pytest.raises(InvalidInput, match="terms is 9"):
        calibrate_indenter([], terms=9)
    with pytest.raises(InvalidInput, match="no curve can be evaluated"):
        calibrate_indenter([])
    one = curves(Machine(), 1, 1, 0, levels=1)
    with pytest.raises(InvalidInput, match="at least 4"):
        calibrate_indenter(one)


def test_files_of_indenters(tmp_path):
    path = tmp_path / "indenter.toml"
    matrix = np.array([[1e-16, 1e-10, 0.0], [1e-10, 0.04, 1e-9], [0.0, 1e-9, 1e-14]])
    indenter = CalibratedIndenter(CalibratedArea((24.5, 1e-6), 5e-8, 1e-6), 4e-7, matrix, shape_factor=1.05)
    write_indenter(indenter, path, made_from="a test")
    assert read_indenter(path) == indenter
    plain = CalibratedIndenter(CalibratedArea((24.5,)))
    write_indenter(plain, path)
    assert read_indenter(path) == plain
    for text, words in (
        ("kind = 1", "kind is 1"),
        ("kind = 'calibrated_indenter'\nare = 1", "key 'are' is unknown"),
        ("kind = 'calibrated_indenter'", "key 'area' is missing"),
        ("no toml", "no calibrated indenter can be read"),
    ):
        path.write_text(text, encoding="utf-8")
        with pytest.raises(InvalidInput, match=words):
            read_indenter(path)


def test_the_stress_of_first_yield():
    """Hertz: 0.31 p_0 with p_0 = 3 F/(2 pi a^2) and a^3 = 3 F R/(4 E*)."""
    force, modulus, radius = 1e-4, 2e11, 2e-7
    contact = (0.75 * force * radius / modulus) ** (1.0 / 3.0)
    assert first_yield_stress(force, modulus, radius) == pytest.approx(
        0.31 * 1.5 * force / (math.pi * contact**2), rel=1e-12
    )
    with pytest.raises(InvalidInput, match="tip_radius"):
        first_yield_stress(force, modulus, 0.0)


def test_statistics_of_first_yield():
    """Weibull stresses of known scale and shape: both within four standard errors of 400 draws; the mean."""
    shape, scale, modulus, radius = 8.0, 9e9, 2e11, 2e-7
    unit = first_yield_stress(1.0, modulus, radius)
    random = np.random.default_rng(4)
    stress = scale * random.weibull(shape, 400)
    found = pop_in_statistics((stress / unit) ** 3, modulus, radius)
    assert found.stress == pytest.approx(np.sort(stress), rel=1e-9)
    assert found.shape == pytest.approx(shape, abs=4.0 * found.shape_error)
    assert found.scale == pytest.approx(scale, rel=4.0 / shape / 20.0)
    mean, inside = scale * math.gamma(1.0 + 1.0 / shape), 0
    for _ in range(200):
        some = (scale * random.weibull(shape, 12) / unit) ** 3
        low, high = pop_in_statistics(some, modulus, radius).interval()
        inside += low < mean < high
    assert 0.90 * 200 <= inside <= 0.985 * 200
    blunt = pop_in_statistics((stress / unit) ** 3, modulus, radius, tip_radius_error=0.3 * radius)
    assert blunt.mean_error == pytest.approx(0.2 * blunt.mean_stress, rel=0.01)
    assert found.activation_volume > 0.0
    with pytest.raises(InvalidInput, match="at least 3"):
        pop_in_statistics([1e-4, 2e-4], modulus, radius)


def test_the_activation_volume():
    """Stresses at the quantiles of 1 - exp(-exp((tau - tau_1)/s)): v = k T/s."""
    share = (np.arange(50) + 0.5) / 50
    stress = 8e9 + 3e8 * np.log(-np.log1p(-share))
    forces = (stress / first_yield_stress(1.0, 2e11, 2e-7)) ** 3
    found = pop_in_statistics(forces, 2e11, 2e-7, temperature=300.0)
    assert found.activation_volume == pytest.approx(1.380649e-23 * 300.0 / 3e8, rel=1e-6)
