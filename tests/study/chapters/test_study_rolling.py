"""Rolling in study files: what they say is what Python says, and their reports tell it."""

from __future__ import annotations

import csv

import numpy as np
import pytest

import winkler as wk
from winkler.cli import main
from winkler.study.batch.run import run
from winkler.study.chapters.contents import formulas_of
from winkler.study.language.build import build
from winkler.study.language.catalogue import kinds
from winkler.study.language.explain import example_study
from winkler.study.language.reading import parse_study
from winkler.study.language.study import Study
from winkler.study.language.writing import study_text
from winkler.study.report.citing import cite

ROLLING = ("rolling", "simplified_rolling", "rolling_start", "oscillating_rolling")
STEEL = wk.Elastic(210e9, 0.3)
BALL = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace.between(STEEL, STEEL))
MU, LOAD = wk.Coulomb(0.3), wk.Force(100.0)

PROBLEMS = [
    wk.Rolling(BALL, MU, wk.Creepage(np.array([0.0, 1e-3, 2e-3]), 1e-3), LOAD),
    wk.Rolling(BALL, MU, wk.Creepage(lateral=1e-3), wk.Depth(1e-6), wk.Uncalibrated()),
    wk.SimplifiedRolling(
        wk.CurvedBodies(0.4, 0.3), BALL.medium, MU, wk.Creepage(1e-3, spin=np.array([0.1, 0.2])), LOAD, 16
    ),
    wk.SimplifiedRolling(wk.ContactEllipse(2e-3, 3e-3), BALL.medium, MU, wk.Creepage(1e-3), LOAD),
    wk.RollingStart(BALL, MU, wk.Creepage(1e-3), LOAD, 1e-3, wk.ShearForce(-5.0), wk.Uncalibrated(), 20, 100),
    wk.OscillatingRolling(BALL, MU, 20e-6, 12.0, wk.Radius(150e-6), cycles=5, count=50),
]


@pytest.mark.parametrize("problem", PROBLEMS, ids=lambda problem: type(problem).__name__)
def test_a_study_is_written_down_and_read_again(problem):
    assert parse_study(study_text(Study("", problem))).problem == problem


@pytest.mark.parametrize("name", ROLLING)
def test_every_kind_is_cited_described_and_has_formulas(name):
    problem = build(example_study(name)["problem"])
    assert type(problem) is kinds()[name].cls
    assert len(cite(problem)) >= 2
    assert len(formulas_of(problem)) >= 3
    assert problem.solve().validity


def test_rows_are_the_creepages():
    outcome = run(Study("", PROBLEMS[0]))
    np.testing.assert_allclose(outcome.answer("longitudinal_creepage"), [0.0, 1e-3, 2e-3])
    np.testing.assert_allclose(outcome.answer("lateral_creepage"), 1e-3)
    np.testing.assert_allclose(outcome.answer("longitudinal_force"), PROBLEMS[0].solve().longitudinal_force)
    spun = run(Study("", PROBLEMS[2]))
    np.testing.assert_allclose(spun.answer("spin_creepage"), [0.1, 0.2])
    assert spun.word("moment").unit == "N m"


@pytest.mark.slow
@pytest.mark.parametrize("name", ["simplified_rolling", "oscillating_rolling"])
def test_the_command_line_writes_the_report(name, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["new", name, "--output", "study.toml"]) == 0
    assert main(["run", "study.toml", "--output", "out", "--quiet"]) == 0
    capsys.readouterr()
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "The formulas" in page or "formula" in page
    stem = {"simplified_rolling": "creep", "oscillating_rolling": "rocking"}[name]
    assert (tmp_path / "out" / "figures" / f"answer_{stem}.svg").stat().st_size < 3_000_000
    with (tmp_path / "out" / "results.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == (31 if name == "oscillating_rolling" else 1)


def test_spin_on_a_line_has_its_own_exit_code(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    text = study_text(Study("", PROBLEMS[1])).replace("lateral = 0.001", 'spin = "0.1 1/m"')
    (tmp_path / "spin.toml").write_text(text, encoding="utf-8")
    assert main(["run", "spin.toml"]) == 4
    assert "a line of springs has no counterpart of that; use SimplifiedRolling" in capsys.readouterr().err
