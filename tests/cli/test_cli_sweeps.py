"""``winkler run`` of a sweep that was stopped: the same command goes on, and loses nothing."""

from __future__ import annotations

import csv
import functools
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import winkler as wk
from winkler.cli import main
from winkler.study.batch.journal import Journal
from winkler.study.batch.sweep import solve_points
from winkler.study.language.reading import read_study

STUDY = """title = "Balls"

[problem]
kind = "indentation"
load = {{ kind = "force", force = "100 N" }}

[problem.bed]
kind = "foundation"
profile = {{ kind = "paraboloid", curvature_radius = "10 mm" }}
medium = {{ kind = "half_space", first = {{ kind = "elastic", young = "210 GPa", poisson = 0.3 }} }}

[sweep]
"problem.load.force" = {{ from = "-1 N", to = "10 N", count = {forces} }}
"problem.bed.medium.first.young" = {{ from = "100 GPa", to = "300 GPa", count = {youngs} }}

[output]
figures = []
report = false
"""


@pytest.fixture
def here(tmp_path, monkeypatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "balls.toml").write_text(STUDY.format(forces=12, youngs=2), encoding="utf-8")
    return tmp_path


def begun(here: Path, count: int) -> Path:
    """Leave what a run leaves that was killed after some points."""
    study, folder = read_study(here / "balls.toml"), here / "results" / "balls"
    (here / "results" / ".balls.0123456789ab.partial").mkdir(parents=True)
    with Journal.beside(folder, study) as journal:
        points = solve_points(study, journal)
        for _ in range(count):
            next(points)
    return journal.path


def test_the_same_command_goes_on(here, monkeypatch, capsys):
    assert main(["run", "balls.toml", "--quiet", "--output", "whole"]) == 4
    journal = begun(here, 9)
    solve, solved = wk.Indentation.solve, []

    @functools.wraps(solve)
    def watched(self):
        solved.append(self)
        return solve(self)

    monkeypatch.setattr(wk.Indentation, "solve", watched)
    assert main(["run", "balls.toml"]) == 4
    assert sum(isinstance(one.load, wk.Force) for one in solved) == 24 - 9  # stresses are sought at a depth
    assert "9 of 24 points were known from the run before." in capsys.readouterr().out
    assert not journal.exists()
    assert [path.name for path in (here / "results").iterdir()] == ["balls"]
    assert (here / "results/balls/results.csv").read_bytes() == (here / "whole/results.csv").read_bytes()


def test_anew(here, capsys):
    begun(here, 9)
    assert main(["run", "balls.toml", "--anew"]) == 4
    assert "known from the run before" not in capsys.readouterr().out


def test_another_study_is_refused_without_anew(here, capsys):
    journal = begun(here, 9)
    text = (here / "balls.toml").read_text(encoding="utf-8").replace("10 mm", "20 mm")
    (here / "balls.toml").write_text(text, encoding="utf-8")
    before = journal.read_bytes()
    assert main(["run", "balls.toml"]) == 2
    path = Path("results") / ".balls.journal"
    assert capsys.readouterr().err == (
        f"winkler: journal: '{path}' holds points of another study, or of another version of this one; add --anew to "
        "begin again without it, or give another folder with --output.\n"
    )
    assert journal.read_bytes() == before
    assert main(["run", "balls.toml", "--anew", "--quiet"]) == 4
    assert not journal.exists()


def test_ctrl_c_prints_how_to_go_on(here, monkeypatch, capsys):
    solve, solved = wk.Indentation.solve, []

    def interrupted(self):
        if len(solved) == 5:
            raise KeyboardInterrupt
        solved.append(self)
        return solve(self)

    with monkeypatch.context() as patch:
        patch.setattr(wk.Indentation, "solve", interrupted)
        assert main(["run", "balls.toml"]) == 130
    folder = Path("results") / "balls"
    assert capsys.readouterr().err == (
        f"winkler: interrupted; 5 of 24 points are kept beside {folder}, and the same command goes on from there.\n"
    )
    assert not folder.exists()
    assert main(["run", "balls.toml"]) == 4
    assert "5 of 24 points were known from the run before." in capsys.readouterr().out


def test_results_that_cannot_be_written_cost_no_point(here, monkeypatch, capsys):
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr("winkler.study.report.writing.study_text", full)
        assert main(["run", "balls.toml"]) == 2
    assert "no space left on device" in capsys.readouterr().err
    assert main(["run", "balls.toml"]) == 4
    assert "24 of 24 points were known from the run before." in capsys.readouterr().out


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="there is no SIGKILL there")
def test_two_thousand_points_survive_a_kill_at_half(here):
    """Killed without warning; nothing is solved twice, nothing is lost, and no process stays behind."""
    (here / "balls.toml").write_text(STUDY.format(forces=100, youngs=20), encoding="utf-8")
    words = [sys.executable, "-m", "winkler", "run", "balls.toml", "--workers", "2", "--quiet"]
    run = subprocess.Popen(words, cwd=here, start_new_session=True)
    journal = here / "results" / ".balls.journal"
    deadline = time.monotonic() + 300
    while not journal.exists() or journal.read_bytes().count(b"\n") < 1000:
        assert run.poll() is None
        assert time.monotonic() < deadline
        time.sleep(0.02)
    run.send_signal(signal.SIGKILL)
    run.wait()
    while True:  # the workers notice that they are alone
        try:
            os.killpg(run.pid, 0)
        except ProcessLookupError:
            break
        assert time.monotonic() < deadline
        time.sleep(0.05)
    lines = journal.read_bytes().count(b"\n")
    assert lines < 2001
    answer = subprocess.run([*words[:-1]], cwd=here, capture_output=True, text=True, check=False)
    assert answer.returncode == 4, answer.stderr
    assert f"{lines - 1} of 2000 points were known from the run before." in answer.stdout
    assert [path.name for path in (here / "results").iterdir()] == ["balls"]
    with (here / "results/balls/results.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 2000
    force, young, depth = (
        np.array([float(row[name]) for row in rows])
        for name in ("problem.load.force [N]", "problem.bed.medium.first.young [Pa]", "depth [m]")
    )
    np.testing.assert_array_equal(np.isnan(depth), force < 0.0)
    np.testing.assert_array_equal([row["failure"] != "" for row in rows], force < 0.0)
    pressed = force > 0.0
    expected = np.cbrt(9.0 * force**2 / (16.0 * (young / (1.0 - 0.3**2)) ** 2 * 10e-3))
    np.testing.assert_allclose(depth[pressed], expected[pressed], rtol=1e-10)
