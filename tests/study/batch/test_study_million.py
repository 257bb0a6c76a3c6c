"""A sweep of a million points begins at once, and needs memory for what was solved, not for what is to come."""

from __future__ import annotations

import functools
import tracemalloc

import numpy as np
import pytest

import winkler as wk
from winkler.study.batch.journal import Journal
from winkler.study.batch.points import Failed
from winkler.study.batch.sweep import solve_points
from winkler.study.batch.tasks import MOST_CHECKED, tasks
from winkler.study.language.designs import LatinHypercube
from winkler.study.language.study import Study
from winkler.study.language.varied import Axis, Range
from winkler.values.errors import InvalidInput

BED = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace(wk.Elastic(1e9, 0.25)))
PROBLEM = wk.Indentation(BED, wk.Force(1.0))
CROSSED = Study(
    "million",
    PROBLEM,
    sweep=(
        Axis("problem.load.force", np.linspace(1.0, 10.0, 1000)),
        Axis("problem.bed.profile.curvature_radius", np.linspace(1e-3, 2e-3, 1000)),
    ),
)
FEW = 30_000_000
"""Bytes that are few for a million points: thirty for each, where one problem takes a thousand."""


@pytest.fixture
def made(monkeypatch):
    """Count the shapes that are made."""
    built = []
    check = wk.Paraboloid.__post_init__

    @functools.wraps(check)
    def watched(self):
        built.append(self.curvature_radius)
        check(self)

    monkeypatch.setattr(wk.Paraboloid, "__post_init__", watched)
    return built


def test_no_more_points_are_made_than_are_looked_at(made):
    points = solve_points(CROSSED)
    for place in range(5):
        assert next(points).index == (0, place)
    assert len(made) <= MOST_CHECKED + 2 * 5


@pytest.mark.slow
def test_a_journal_of_a_million_points_goes_on_in_little_memory(tmp_path):
    path, study = tmp_path / "x.journal", CROSSED
    tracemalloc.start()
    try:
        before = tracemalloc.get_traced_memory()[0]
        with Journal(path, study) as journal:
            points = solve_points(study, journal)
            first = [next(points) for _ in range(10)]
            points.close()
        with Journal(path, study) as journal:
            known = journal.count
            points = solve_points(study, journal)
            again = [next(points) for _ in range(known + 5)]
            points.close()
        peak = tracemalloc.get_traced_memory()[1] - before
    finally:
        tracemalloc.stop()
    assert peak < FEW
    assert known >= 10
    assert again[:10] == first
    assert len({point.index for point in again}) == known + 5


@pytest.mark.slow
def test_drawn_points_go_on_from_a_journal_too(tmp_path):
    lines = (Range("problem.load.force", 1.0, 10.0), Range("problem.bed.profile.curvature_radius", 1e-3, 2e-3))
    study = Study("drawn", PROBLEM, sweep=lines, design=LatinHypercube(50_000, seed=3))
    path = tmp_path / "x.journal"
    with Journal(path, study) as journal:
        points = solve_points(study, journal)
        first = [next(points) for _ in range(10)]
    with Journal(path, study) as journal:
        points = solve_points(study, journal)
        again = [next(points) for _ in range(12)]
    assert again[:10] == first
    assert [point.index for point in again] == [(place,) for place in range(12)]
    other = Study("drawn", PROBLEM, sweep=lines, design=LatinHypercube(50_000, seed=4))
    with pytest.raises(InvalidInput, match="points of another study"), Journal(path, other):
        pass


def test_places_and_indices():
    todo = tasks(CROSSED)
    assert len(todo) == 1_000_000
    assert todo[-1].index == (999, 999)
    assert todo[123_456].index == (123, 456)
    assert todo[123_456].problem.load.force == CROSSED.sweep[0].values[123]
    assert todo[123_456].problem.bed.profile.curvature_radius == CROSSED.sweep[1].values[456]
    done = np.ones(1_000_000, dtype=bool)
    done[[7, 123_456]] = False
    assert [task.index for task in todo.without(done)] == [(0, 7), (123, 456)]


@pytest.mark.slow
def test_a_point_between_those_that_were_looked_at_fails_when_its_turn_comes(tmp_path):
    """Of 5000 points every second or third is looked at; number 3 is not."""
    ratios = np.full(5000, 0.3)
    ratios[3] = 0.7
    study = Study("x", PROBLEM, sweep=(Axis("problem.bed.medium.first.poisson", ratios),))
    path = tmp_path / "x.journal"
    with Journal(path, study) as journal:
        points = solve_points(study, journal)
        first = [next(points) for _ in range(5)]
    assert isinstance(first[3], Failed)
    assert first[3].reason.startswith("sweep: at problem.bed.medium.first.poisson = 0.7: Elastic: poisson is 0.7;")
    assert first[3].code == InvalidInput.exit_code
    with Journal(path, study) as journal:
        points = solve_points(study, journal)
        assert [next(points) for _ in range(5)] == first
