"""The journal of a sweep: nothing is solved twice, nothing is lost, and numbers come back to the last digit."""

from __future__ import annotations

import dataclasses
import functools
import json
import re
import zlib

import numpy as np
import pytest

import winkler as wk
from winkler.io.software import software
from winkler.study.batch import sweep
from winkler.study.batch.journal import Journal
from winkler.study.batch.points import Failed, Recalled, Solved
from winkler.study.batch.run import gather, run
from winkler.study.batch.sweep import solve_points
from winkler.study.language.fit_study import FitStudy, Free
from winkler.study.language.study import Expectation, Fields, Places, Study
from winkler.study.language.varied import Axis
from winkler.values.errors import InvalidInput, OutsideValidity

BED = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace(wk.Elastic(1e9, 0.25)))
FORCES = Axis("problem.load.force", (1.0, -1.0, 2.0, 3.0, 4.0))
PLACES = Places(np.array([0.0, 0.5, 2.0]), relative=True)
STUDY = Study(
    "x",
    wk.Indentation(BED, wk.Force(1.0)),
    sweep=(FORCES, Axis("problem.bed.medium.first.young", (1e9, 1e9 / 3.0))),
    fields=Fields(PLACES, Places(np.array([0.1, 1.0]), relative=True)),
    expect=(Expectation("depth", 1e-4, 0.5), Expectation("force", 1.0, 1e-12)),
)
SHEARED = Study(
    "sheared",
    wk.AdhesiveShear(BED, wk.ShortRange(0.05), wk.Force(0.5), wk.Shift(np.linspace(0.0, 1e-7, 3))),
    sweep=(Axis("problem.normal.force", (0.5, 0.7)),),
)


@pytest.fixture
def counted(monkeypatch):
    """Count what is solved."""
    solved = []
    solve = wk.Indentation.solve

    @functools.wraps(solve)
    def watched(self):
        solved.append(self)
        return solve(self)

    monkeypatch.setattr(wk.Indentation, "solve", watched)
    return solved


def first(study: Study, path, count: int):
    """Begin a run, and stop it after some points."""
    with Journal(path, study) as journal:
        points = solve_points(study, journal)
        return [next(points) for _ in range(count)]


def test_a_stopped_run_goes_on_where_it_was(tmp_path, counted):
    path = tmp_path / "x.journal"
    whole = run(STUDY)
    del counted[:]
    begun = first(STUDY, path, 4)
    assert begun == list(whole.points[:4])
    with Journal(path, STUDY) as journal:
        assert journal.count == 4
        outcome = gather(STUDY, solve_points(STUDY, journal), started=0.0)
    assert len(counted) == 10
    assert [type(point) for point in outcome.points[:4]] == [Recalled, Recalled, Failed, Failed]
    assert [type(point) for point in outcome.points[4:]] == [Solved] * 6
    for one, other in zip(outcome.points, whole.points, strict=True):
        assert (one.index, one.settings, one.problem) == (other.index, other.settings, other.problem)
        if isinstance(one, Failed):
            assert one == other
        else:
            assert one.found == other.found
            assert one.surface == other.surface
            assert one.subsurface == other.subsurface
            assert one.validity == other.validity
            assert one.answer_type is other.answer_type
    assert outcome.verdicts == whole.verdicts
    assert outcome.validity == whole.validity
    for mine, theirs in zip(outcome.table(), whole.table(), strict=True):
        np.testing.assert_array_equal(mine.content, theirs.content)


def test_a_recalled_point_solves_again_when_its_solution_is_requested(tmp_path, counted):
    path = tmp_path / "x.journal"
    first(STUDY, path, 2)
    with Journal(path, STUDY) as journal:
        point = next(solve_points(STUDY, journal))
    del counted[:]
    assert isinstance(point, Recalled)
    assert point.solution == point.problem.solve()
    assert [contact.force for contact in point.each] == [1.0]


@pytest.mark.parametrize("study", [STUDY, SHEARED], ids=["fields", "events"])
def test_a_run_with_a_journal_comes_to_the_same(study, tmp_path):
    path = tmp_path / "x.journal"
    outcome, whole = run(study, journal=path), run(study)
    assert outcome.points == whole.points
    assert not path.exists()
    if study is SHEARED:
        first(study, path, 2)
        recalled = run(study, journal=path)
        assert all(isinstance(point, Recalled) for point in recalled.points)
        assert recalled.points[0].events("limit") == whole.points[0].events("limit") != ()


def test_a_torn_last_line_is_dropped(tmp_path):
    path = tmp_path / "x.journal"
    first(STUDY, path, 4)
    whole = path.read_bytes()
    last = whole.rindex(b"\n", 0, -1) + 1
    for cut in (1, (len(whole) - last) // 2, len(whole) - last - 1, len(whole) - last):
        path.write_bytes(whole[:-cut])
        with Journal(path, STUDY) as journal:
            assert journal.count == 3
        assert path.read_bytes() == whole[:last]
    path.write_bytes(whole[:-2] + b"0\n")
    with Journal(path, STUDY) as journal:
        assert journal.count == 3


def test_a_torn_head_begins_again(tmp_path):
    path = tmp_path / "x.journal"
    first(STUDY, path, 1)
    path.write_bytes(path.read_bytes()[:20])
    with Journal(path, STUDY) as journal:
        assert journal.count == 0
        assert len(list(solve_points(STUDY, journal))) == 10
        assert journal.count == 10


def test_a_journal_spoilt_in_its_middle_is_refused(tmp_path):
    path = tmp_path / "x.journal"
    first(STUDY, path, 4)
    lines = path.read_bytes().split(b"\n")
    lines[2] = lines[2].replace(b"1", b"2")
    path.write_bytes(b"\n".join(lines))
    with pytest.raises(InvalidInput, match=r"is spoilt in line 3; add --anew"), Journal(path, STUDY):
        pass


@pytest.mark.parametrize(
    "change",
    [
        {"problem": wk.Indentation(BED, wk.Force(2.0))},
        {"sweep": STUDY.sweep[:1]},
        {"fields": Fields()},
        {"expect": STUDY.expect[:1]},
    ],
)
def test_a_journal_of_another_study_is_refused(change, tmp_path):
    path = tmp_path / "x.journal"
    first(STUDY, path, 4)
    before = path.read_bytes()
    with (
        pytest.raises(InvalidInput, match="holds points of another study, or of another version of this one"),
        Journal(path, dataclasses.replace(STUDY, **change)),
    ):
        pass
    assert path.read_bytes() == before


def test_a_fit_names_what_a_journal_of_a_sweep_holds(tmp_path):
    path = tmp_path / "x.journal"
    first(STUDY, path, 1)
    fit = FitStudy("x", wk.Indentation(BED, wk.Depth(0.0)), ("x.csv",), (Free("contact_point"),))
    with pytest.raises(InvalidInput, match="holds points of another study"), Journal(path, fit):
        pass


@pytest.mark.parametrize("name", ["winkler", "sources", "numba", "numpy", "scipy"])
def test_other_software_does_not_go_on(name, tmp_path, monkeypatch):
    path = tmp_path / "x.journal"
    first(STUDY, path, 4)
    before, mine = path.read_bytes(), software()
    monkeypatch.setattr("winkler.io.software.software", lambda: mine | {name: "99.0"})
    text = rf"was begun with (sources of )?\w+ {re.escape(mine[name])} \(here 99\.0\), .*; add --anew to begin again"
    with pytest.raises(InvalidInput, match=text), Journal(path, STUDY):
        pass
    assert path.read_bytes() == before


def test_a_journal_that_names_no_software_does_not_go_on(tmp_path):
    path = tmp_path / "x.journal"
    head = json.dumps({"journal of": "winkler", "version": software()["winkler"]}).encode()
    path.write_bytes(b"%08x %s\n" % (zlib.crc32(head), head))
    with pytest.raises(InvalidInput, match=r"sources of winkler unknown \(here "), Journal(path, STUDY):
        pass


def test_the_title_does_not_matter(tmp_path):
    path = tmp_path / "x.journal"
    first(STUDY, path, 4)
    with Journal(path, dataclasses.replace(STUDY, title="another")) as journal:
        assert journal.count == 4


def test_two_runs_do_not_write_one_journal(tmp_path):
    path = tmp_path / "x.journal"
    with Journal(path, STUDY) as journal:
        next(solve_points(STUDY, journal))
        with pytest.raises(InvalidInput, match="another run is writing"), Journal(path, STUDY):
            pass
        with pytest.raises(InvalidInput, match="another run is writing"):
            Journal(path, STUDY).remove()
    late = Journal(tmp_path / "late", STUDY)
    with late, Journal(tmp_path / "late", STUDY) as early:
        next(solve_points(STUDY, early))
        with pytest.raises(InvalidInput, match="another run is writing"):
            next(solve_points(STUDY, late))


def test_a_run_without_any_answer_leaves_no_journal(tmp_path):
    study = dataclasses.replace(STUDY, sweep=(Axis("problem.load.force", (-1.0, -2.0)),))
    with pytest.raises(OutsideValidity):
        run(study, journal=tmp_path / "x.journal")
    assert list(tmp_path.iterdir()) == []


def test_a_line_for_every_point_as_soon_as_it_is_solved(tmp_path):
    path = tmp_path / "x.journal"
    with Journal(path, STUDY) as journal:
        for count, _ in enumerate(solve_points(STUDY, journal), start=1):
            lines = path.read_text(encoding="utf-8").splitlines()
            assert len(lines) == count + 1
    content = [json.loads(line.partition(" ")[2]) for line in lines]
    assert content[1]["found"]["force"] == 1.0
    assert "tensile" in content[3]["reason"]


def test_of_long_sweeps_solutions_are_not_stored(monkeypatch, tmp_path):
    monkeypatch.setattr(sweep, "MOST_KEPT_SOLUTIONS", 4)
    points = list(solve_points(STUDY))
    assert {type(point) for point in points} == {Recalled, Failed}
    light = gather(STUDY, points, started=0.0)
    monkeypatch.undo()
    whole = run(STUDY)
    assert light.verdicts == whole.verdicts
    for mine, theirs in zip(light.table(), whole.table(), strict=True):
        np.testing.assert_array_equal(mine.content, theirs.content)


@pytest.mark.slow
def test_a_pool_writes_the_same_journal(tmp_path):
    path = tmp_path / "x.journal"
    with Journal(path, STUDY) as journal:
        pooled = gather(STUDY, solve_points(STUDY, journal, workers=2), started=0.0)
    assert pooled.points == run(STUDY).points
    with Journal(path, STUDY) as journal:
        assert journal.count == 10
