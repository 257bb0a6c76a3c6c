"""Sensitivity of a contact: indices of Sobol against closed forms, through points that fail, and in every output."""

from __future__ import annotations

import csv

import mpmath
import numpy as np
import pytest

import winkler as wk
from winkler.study.batch.run import run
from winkler.study.batch.sensitivity import sensitivity
from winkler.study.language.designs import Sensitivity, Sobol
from winkler.study.language.study import Study
from winkler.study.language.varied import Range
from winkler.study.report.archive import archive_files, dataset
from winkler.study.report.report import page
from winkler.study.report.sweep_figures import clouds, parts
from winkler.study.report.writing import write_files
from winkler.values.errors import InvalidInput

BED = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace(wk.Elastic(1e9, 0.25)))
PROBLEM = wk.Indentation(BED, wk.Force(1.0))
KEYS = (
    Range("problem.load.force", 1.0, 3.0),
    Range("problem.bed.medium.first.young", 1e9, 3e9, "log"),
    Range("problem.bed.profile.curvature_radius", 1e-3, 3e-3),
)
HERTZ = Study("Hertz", PROBLEM, sweep=KEYS, design=Sensitivity(128, seed=1))
POWERS = {
    "depth": (2.0 / 3.0, -2.0 / 3.0, -1.0 / 3.0),
    "radius": (1.0 / 3.0, -1.0 / 3.0, 1.0 / 3.0),
    "mean_pressure": (1.0 / 3.0, 2.0 / 3.0, -2.0 / 3.0),
}
"""Hertz: every answer is a product of powers of force, modulus and radius."""


@pytest.fixture(scope="module")
def outcome():
    return run(HERTZ)


def moments(line: Range, power: float) -> tuple[float, float]:
    """Return the mean of a power of what a range holds, and of its square."""
    ends = [line.start, line.stop]
    span = mpmath.log(line.stop / line.start) if line.scale == "log" else line.stop - line.start
    density = (lambda x: 1 / (x * span)) if line.scale == "log" else (lambda x: 1 / span)
    return tuple(float(mpmath.quad(lambda x, n=n: x ** (n * power) * density(x), ends)) for n in (1, 2))


@pytest.mark.few(1)
@pytest.mark.parametrize("answer", POWERS)
def test_hertz(answer, outcome):
    """Of a product of independent factors with means m and mean squares s: V = prod s - prod m^2."""
    mean, square = np.array([moments(line, power) for line, power in zip(KEYS, POWERS[answer], strict=True)]).T
    variance = np.prod(square) - np.prod(mean**2)
    alone = (square - mean**2) * np.prod(mean**2) / mean**2 / variance
    total = (square - mean**2) * np.prod(square) / square / variance
    found = next(one for one in outcome.indices if one.answer == answer)
    assert found.pairs == 128
    np.testing.assert_allclose(found.first_order, alone, atol=0.02)
    np.testing.assert_allclose(found.total_order, total, atol=0.02)
    assert np.all((found.total_order_low < total) & (total < found.total_order_high))


def test_what_was_given_has_no_indices(outcome):
    assert "force" not in [one.answer for one in outcome.indices]


@pytest.mark.slow
def test_pairs_with_a_failed_point_are_left_out():
    half = Range("problem.load.force", -1.0, 3.0)  # a quarter of the forces is tensile
    found = run(Study("x", PROBLEM, sweep=(half, KEYS[1]), design=Sensitivity(32)))
    assert found.failed
    (one, *_) = found.indices
    assert 0 < one.pairs < 32
    assert np.all(np.isfinite(one.total_order))


def test_other_designs_have_no_indices():
    with pytest.raises(InvalidInput, match="the design of the study is sobol; its indices need the design sensitivity"):
        sensitivity(Study("x", PROBLEM, sweep=KEYS, design=Sobol(2)), {})


@pytest.mark.slow
def test_every_output_has_them(outcome, tmp_path):
    (depth, *_) = outcome.indices
    data = dataset(outcome)
    assert data["first_order"].dims == ("answer", "key")
    np.testing.assert_array_equal(data["total_order"].sel(answer="depth").values, depth.total_order)
    assert data["key"].values.tolist() == [line.key for line in KEYS]
    write_files(archive_files(outcome), tmp_path)
    rows = list(csv.DictReader((tmp_path / "sensitivity.csv").open()))
    assert [float(row["total_order [-]"]) for row in rows[:3]] == depth.total_order.tolist()
    assert rows[1]["key"] == KEYS[1].key
    bars, cloud = next(parts(outcome)), next(clouds(outcome, {"depth": outcome.answer("depth")[:, 0]}))
    assert (bars.name, cloud.name) == ("sensitivity_depth", "answer_depth")
    text = page(outcome, (bars, cloud))
    assert text.count("<svg") == 2
    assert "How much of the scatter each key makes" in text
