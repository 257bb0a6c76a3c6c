"""A point of a sweep that meets a mistake of winkler's own: it says so, the others are solved, the exit code is 70."""

from __future__ import annotations

import functools
import pickle
from pathlib import Path

import pytest

import winkler as wk
from winkler.cli import main
from winkler.study.batch.journal import Journal
from winkler.study.batch.points import Failed, Recalled, Solved
from winkler.study.batch.run import gather, run
from winkler.study.batch.sweep import solve_points
from winkler.study.language.study import Expectation, Study
from winkler.study.language.varied import Axis
from winkler.study.language.writing import study_text
from winkler.values.errors import InvalidInput, Mistake, OutsideValidity, mistake_in

BED = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace(wk.Elastic(1e9, 0.25)))
STUDY = Study("x", wk.Indentation(BED, wk.Force(1.0)), sweep=(Axis("problem.load.force", (-1.0, 1.0, 2.0, 3.0)),))
SOLVE = wk.Indentation.solve
SENTENCE = "winkler made a mistake (LookupError: no such word at winkler.study.batch.sweep:"


@pytest.fixture
def broken(monkeypatch):
    """Let winkler stumble over the force of 2 N, and count what is solved."""
    solved = []

    @functools.wraps(SOLVE)
    def solve(self):
        solved.append(self.load.force)
        if self.load.force == 2.0:
            raise LookupError("no such\n word")
        return SOLVE(self)

    monkeypatch.setattr(wk.Indentation, "solve", solve)
    return solved


def test_the_others_are_solved(broken):
    outcome = run(STUDY)
    assert [type(point) for point in outcome.points] == [Failed, Solved, Failed, Solved]
    tensile, ours = outcome.failed
    assert (tensile.code, tensile.traceback) == (4, "")
    assert ours.code == 70
    assert ours.reason.startswith(SENTENCE)
    assert ours.reason.endswith("report it with this study.")
    assert "\n" not in ours.reason
    assert "in solve\n    raise LookupError(" in ours.traceback
    assert pickle.loads(pickle.dumps(ours)) == ours


def test_a_point_whose_validity_cannot_be_stated_fails(monkeypatch, tmp_path):
    """What stands beside the numbers is computed when the point is stored, not when all results are written."""

    def validity(self):
        if self.force == 2.0:
            raise OutsideValidity("Indentation: nothing is known here.")
        if self.force == 3.0:
            raise IndexError("deep inside")
        return ()

    monkeypatch.setattr(wk.IndentationSolution, "validity", property(validity))
    outcome = run(STUDY, journal=tmp_path / "x.journal")
    assert [point.code for point in outcome.points] == [4, 0, 4, 70]
    assert outcome.validity == ()


def test_a_run_that_goes_on_tries_it_again(broken, monkeypatch, tmp_path):
    path = tmp_path / "x.journal"
    with Journal(path, STUDY) as journal:
        points = solve_points(STUDY, journal)
        begun = [next(points) for _ in range(3)]
    assert journal.count == 2
    lines = path.read_text(encoding="utf-8").splitlines()
    assert "LookupError" in lines[-1]
    del broken[:]
    with Journal(path, STUDY) as journal:
        assert journal.count == 2
        again = gather(STUDY, solve_points(STUDY, journal), started=0.0)
        assert journal.count == 3
    assert broken == [2.0, 3.0]
    assert [type(point) for point in again.points] == [Failed, Recalled, Failed, Solved]
    assert again.failed == tuple(point for point in begun if isinstance(point, Failed))
    monkeypatch.setattr(wk.Indentation, "solve", SOLVE)
    with Journal(path, STUDY) as journal:
        mended = gather(STUDY, solve_points(STUDY, journal), started=0.0)
        assert journal.count == 4
    assert [point.code for point in mended.points] == [4, 0, 0, 0]


def test_too_little_memory_is_tried_again_and_no_mistake(monkeypatch, tmp_path):
    def solve(self):
        if self.load.force == 3.0:
            raise MemoryError("Unable to allocate 4.85 TiB")
        return SOLVE(self)

    monkeypatch.setattr(wk.Indentation, "solve", solve)
    with Journal(tmp_path / "x", STUDY) as journal:
        last = gather(STUDY, solve_points(STUDY, journal), started=0.0).points[-1]
        assert journal.count == 3
    assert isinstance(last, Failed)
    assert last.code == 3
    assert last.reason.startswith("there is not enough memory (Unable to allocate 4.85 TiB); ask for fewer loads")


def test_none_has_an_answer(broken):
    with pytest.raises(
        Mistake, match="none of the 2 points of the sweep has an answer; the first: winkler made"
    ) as message:
        run(Study("x", STUDY.problem, sweep=(Axis("problem.load.force", (-1.0, 2.0)),)))
    assert "in solve\n    raise LookupError(" in message.value.__notes__[0]


def test_a_point_that_cannot_be_built_by_our_mistake(monkeypatch):
    made = wk.Force.__post_init__

    def broken(self):
        if self.force == 2.0:
            raise IndexError("deep inside")
        made(self)

    monkeypatch.setattr(wk.Force, "__post_init__", broken)
    assert [point.code for point in run(STUDY).points] == [4, 0, 70, 0]
    monkeypatch.undo()


def test_without_a_sweep_the_error_itself_is_raised(broken):
    with pytest.raises(LookupError):
        run(Study("x", wk.Indentation(BED, wk.Force(2.0))))


def test_what_is_expected_wrongly_ends_the_sweep(tmp_path):
    study = Study("x", STUDY.problem, sweep=STUDY.sweep, expect=(Expectation("coefficient", 1.0, 0.1),))
    with pytest.raises(InvalidInput, match="coefficient"):
        run(study, journal=tmp_path / "x.journal")


def test_the_command_line_reports_it(broken, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    text = study_text(STUDY) + "\n[output]\nfigures = []\nreport = false\n"
    (tmp_path / "x.toml").write_text(text, encoding="utf-8")
    assert main(["run", "x.toml", "--quiet"]) == 70
    message = capsys.readouterr()
    assert message.out == ""
    folder = Path("results") / "x"
    assert message.err.startswith(
        "winkler: x.toml: at 1 of 4 points winkler is at fault, not the study; what the others answer is in "
        f"{folder}. The first: {SENTENCE}"
    )
    assert message.err.endswith("report it with this study.\n")
    assert message.err.count("\n") == 1
    table = (folder / "results.csv").read_text(encoding="utf-8")
    assert "winkler made a mistake (LookupError" in table
    assert not list(Path("results").glob(".x*"))


def test_the_sentence_names_the_place_and_is_cut():
    try:
        wk.restore(None, None)
    except Exception as error:
        kind, sentence = type(error).__name__, mistake_in(error)
    assert sentence.startswith(f"winkler made a mistake ({kind}: ")
    assert mistake_in(ValueError("a" * 10000)) == f"winkler made a mistake (ValueError: {'a' * 300}...)"
