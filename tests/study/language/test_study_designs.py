"""Designs: which points are solved, how a study file says so, and how the answers are laid out."""

from __future__ import annotations

import csv

import numpy as np
import pytest

import winkler as wk
from winkler.study.batch.run import run
from winkler.study.language.canonical import digest
from winkler.study.language.designs import Crossed, LatinHypercube, Sensitivity, Sobol, Zipped
from winkler.study.language.reading import parse_study
from winkler.study.language.study import Study
from winkler.study.language.varied import Axis, Range
from winkler.study.language.writing import study_text
from winkler.study.report.archive import archive_files, dataset
from winkler.study.report.describe import in_words, inputs
from winkler.study.report.writing import write_files
from winkler.values.errors import InvalidInput

BED = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace(wk.Elastic(1e9, 0.25)))
PROBLEM = wk.Indentation(BED, wk.Force(1.0))
FORCE = Range("problem.load.force", 1.0, 3.0)
YOUNG = Range("problem.bed.medium.first.young", 1e9, 1e11, "log")
SHAPE = Axis("problem.bed.profile", (wk.Paraboloid(1e-3), wk.Cone(1.5)))
DRAWN = {
    "latin hypercube": Study("x", PROBLEM, sweep=(FORCE, YOUNG, SHAPE), design=LatinHypercube(8, seed=3)),
    "sobol": Study("x", PROBLEM, sweep=(FORCE, YOUNG, SHAPE), design=Sobol(8, seed=3)),
    "sensitivity": Study("x", PROBLEM, sweep=(FORCE, YOUNG), design=Sensitivity(4, seed=3)),
}


@pytest.mark.parametrize("design", [LatinHypercube(32, 1), Sobol(32, 1)])
def test_every_part_of_every_range_has_one_point(design):
    """So it is for both: a Latin hypercube by its making, a Sobol sequence in base two."""
    shares = design.shares(4)
    assert shares.shape == (32, 4)
    for key in range(4):
        assert sorted(np.floor(32 * shares[:, key]).astype(int)) == list(range(32))


def test_a_sobol_sequence_is_even_in_two_keys_together():
    """Its first two dimensions: every box of 1/4 by 1/4 of 16 points has one."""
    shares = Sobol(16, 7).shares(2)
    assert len({tuple(place) for place in np.floor(4 * shares).astype(int)}) == 16


@pytest.mark.parametrize("kind", [LatinHypercube, Sobol, Sensitivity])
def test_equal_seeds_draw_equal_points(kind):
    assert np.array_equal(kind(16, 5).shares(3), kind(16, 5).shares(3))
    assert not np.array_equal(kind(16, 5).shares(3), kind(16, 6).shares(3))


def test_sensitivity_exchanges_one_key_at_a_time():
    rows = Sensitivity(4, 2).shares(3).reshape(4, 5, 3)
    for first, second, *mixed in rows:
        assert np.all(first != second)
        for key, row in enumerate(mixed):
            assert row[key] == second[key]
            assert np.array_equal(np.delete(row, key), np.delete(first, key))


def test_ranges_are_covered_evenly_in_their_scale():
    axes = DRAWN["latin hypercube"].axes
    forces, youngs = (np.array(axis.values) for axis in axes[:2])
    assert sorted(np.floor(8.0 * (forces - 1.0) / 2.0)) == list(range(8))
    assert sorted(np.floor(8.0 * np.log(youngs / 1e9) / np.log(100.0))) == list(range(8))
    assert [axes[2].values.count(shape) for shape in SHAPE.values] == [4, 4]


@pytest.mark.few(1)
@pytest.mark.parametrize("study", DRAWN.values(), ids=DRAWN)
def test_drawn_points_are_solved_and_laid_out(study, tmp_path):
    outcome = run(study)
    count = len(outcome.points)
    assert study.dims == ("point",)
    assert outcome.shape == (count,)
    assert count == {"sensitivity": 16}.get(study.design.kind, 8)
    forces, youngs = (np.array(axis.values) for axis in study.axes[:2])
    round_ = np.array([point.problem.bed.profile == wk.Paraboloid(1e-3) for point in outcome.points])
    expected = np.cbrt(9.0 * forces**2 / (16.0 * (youngs / (1.0 - 0.25**2)) ** 2 * 1e-3))
    np.testing.assert_allclose(outcome.answer("depth")[round_, 0], expected[round_], rtol=1e-10)
    found = dataset(outcome)
    assert found["depth"].dims == ("point",)
    assert found["problem.load.force"].attrs["units"] == "N"
    np.testing.assert_array_equal(found["problem.load.force"].values, forces)
    write_files(archive_files(outcome), tmp_path)
    rows = list(csv.DictReader((tmp_path / "results.csv").open()))
    assert [float(row["problem.load.force [N]"]) for row in rows] == forces.tolist()
    assert (tmp_path / "sensitivity.csv").exists() is (study.design.kind == "sensitivity")


@pytest.mark.parametrize("study", DRAWN.values(), ids=DRAWN)
def test_designs_come_back_from_text(study):
    assert parse_study(study_text(study)) == study
    assert parse_study(study_text(study)).axes == study.axes


def test_the_hash_distinguishes_designs():
    studies = [
        Study("x", PROBLEM, sweep=(FORCE,), design=design)
        for design in (LatinHypercube(8), LatinHypercube(8, 1), LatinHypercube(4), Sobol(8), Sensitivity(8))
    ]
    lists = [
        Study("x", PROBLEM, sweep=(Axis(FORCE.key, (1.0, 2.0)),), design=design) for design in (Crossed(), Zipped())
    ]
    assert len({digest(study) for study in studies + lists}) == 7
    assert digest(Study("y", PROBLEM, sweep=(FORCE,), design=Sobol(8))) == digest(studies[3])


def test_what_is_drawn_is_stated():
    message = in_words(DRAWN["sobol"])
    assert "load.force = 1 N to 3 N" in message
    assert "young = 1 GPa to 100 GPa, evenly in its logarithm" in message
    assert "scrambled Sobol sequence" in message
    assert "varied: 1 N to 3 N" in {given.text for given in inputs(DRAWN["sobol"])}


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: Sobol(100), "a Sobol sequence is even with a power of two only: give 64 or 128"),
        (lambda: Sensitivity(12), "sweep.design.count is 12"),
        (lambda: LatinHypercube(0), "sweep.design.count is 0; give a whole number from 1"),
        (lambda: LatinHypercube(2.5), "sweep.design.count is 2.5"),
        (lambda: LatinHypercube(True), "sweep.design.count is True"),
        (lambda: LatinHypercube(3, -1), "sweep.design.seed is -1; give a whole number from 0"),
        (lambda: Range("problem.load.force", 1.0, 1.0), "give two finite numbers that differ"),
        (lambda: Range("problem.load.force", 1.0, float("nan")), "give two finite numbers that differ"),
        (lambda: Range("problem.load.force", -1.0, 1.0, "log"), "both ends must have one sign, not zero"),
        (lambda: Range("problem.load.force", 1.0, 2.0, "lag"), "did you mean 'log'"),
        (lambda: Range("load.force", 1.0, 2.0), "does not start with 'problem.'"),
        (
            lambda: Study("x", PROBLEM, sweep=(FORCE,)),
            "is drawn from a range, but a crossed design needs a list of values",
        ),
        (lambda: Study("x", PROBLEM, sweep=(FORCE,), design=Zipped()), "but a zipped design needs a list of values"),
        (lambda: Study("x", PROBLEM, design=Sobol(4)), "the design sobol has no keys"),
    ],
)
def test_wrong_designs(make, sentence):
    with pytest.raises(InvalidInput) as caught:
        make()
    assert sentence in str(caught.value)


def test_a_text_may_begin_with_the_mark_of_utf_8():
    text = "[problem]\nkind = 'indentation'\n"
    with pytest.raises(InvalidInput) as plain:
        parse_study(text)
    with pytest.raises(InvalidInput) as marked:
        parse_study(f"\ufeff{text}")
    assert str(marked.value) == str(plain.value)
    assert "problem has no 'bed'" in str(plain.value)
