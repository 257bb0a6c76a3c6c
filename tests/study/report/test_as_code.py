"""A study as Python: the script builds the problem of the study, to the last digit, and prints its answers."""

from __future__ import annotations

import contextlib
import io
from pathlib import Path

import numpy as np
import pytest
import tomli_w

from winkler.study.batch.fit_run import fit_study
from winkler.study.batch.run import run
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.explain import example_study
from winkler.study.language.fit_reading import read_fit_study
from winkler.study.language.reading import parse_study, read_study
from winkler.study.report.fit_report import page as fit_page
from winkler.study.report.headline.as_code import command_text, python_text

STUDIES = Path(__file__).resolve().parents[3] / "examples" / "studies"


def built(script):
    """Return the problem that a script builds, without solving it."""
    names = {}
    exec("\n".join(line for line in script.splitlines() if "solution" not in line), names)
    return names["problem"]


def test_every_kind_of_problem_is_written_as_python():
    wrong = []
    for kind in CATALOGUE["problem"]:
        study = parse_study(tomli_w.dumps(example_study(kind)))
        script = python_text(study)
        if "read_study" in script or built(script) != study.problem:
            wrong.append(kind)
    assert wrong == []


@pytest.mark.parametrize("file", ["normal/hertz.toml", "normal/cone.toml", "normal/flat_punch.toml"])
def test_a_sweep_becomes_a_loop_that_prints_the_answers_of_its_points(file):
    """The first number behind the varied ones is the first of the headline, at each point of the sweep."""
    study = read_study(STUDIES / file)
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        exec(python_text(study), {})
    lines = said.getvalue().splitlines()
    depth = np.ravel(run(study).answer("depth"))
    assert len(lines) == depth.size
    assert [float(line.split()[-3]) for line in lines] == pytest.approx(depth, rel=1e-12)


def test_what_is_too_large_to_be_written_is_read_from_its_file(tmp_path):
    script = python_text(read_study(STUDIES / "rough" / "rough_surface.toml"), "a map.toml")
    assert "read_study(Path('a map.toml'))" in script
    compile(script, "script", "exec")
    assert command_text("a map.toml").startswith("winkler run 'a map.toml'\n")


def test_a_fit_is_read_from_its_file_and_gives_the_same_numbers(monkeypatch):
    """The script prints what the fit of the file gives."""
    file = STUDIES / "fitting" / "fit_gel.toml"
    study = read_fit_study(file)
    monkeypatch.chdir(file.parent)
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        exec(python_text(study, file.name), {})
    outcome = fit_study(study)
    assert said.getvalue().splitlines() == [
        f"{column.name} {column.word.unit} {column.content}" for column in outcome.table()
    ]
    page = fit_page(outcome, ())
    assert "As Python" in page
    assert command_text(file.name, fits=True).splitlines()[0] == "winkler fit fit_gel.toml"
