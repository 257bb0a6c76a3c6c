"""Two runs into one folder do not mix."""

from __future__ import annotations

import csv
import json
import subprocess
import sys

import pytest

from winkler.study.language.reading import read_study
from winkler.study.language.template import whole_text

LIGHT = '\n[output]\nfigures = ["svg"]\nreport = true\n'


def study(folder, name, force):
    """Write a study of a force."""
    path = folder / f"{name}.toml"
    path.write_text(whole_text("indentation").replace('"100 N"', f'"{force} N"') + LIGHT, encoding="utf-8")
    return path


def started(path, output):
    return subprocess.Popen(
        [sys.executable, "-m", "winkler", "run", str(path), "--output", str(output), "--overwrite", "--quiet"],
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    )  # fmt: skip


def whole(output) -> float:
    """Check that a folder of results is that of one run, and return its force."""
    made = json.loads((output / "provenance.json").read_text(encoding="utf-8"))
    present = sorted(path.relative_to(output).as_posix() for path in output.rglob("*") if path.is_file())
    assert sorted(made["files"]) == present
    with (output / "results.csv").open(encoding="utf-8") as file:
        force = float(next(csv.DictReader(file))["force [N]"])
    stated = read_study(output / "study.toml").problem.load.force
    assert force == pytest.approx(stated, rel=1e-12)
    return force


def hidden(folder):
    return [path.name for path in folder.iterdir() if path.name.startswith(".")]


@pytest.mark.slow
def test_two_runs_at_once_leave_the_results_of_one(tmp_path):
    output = tmp_path / "results"
    runs = [started(study(tmp_path, f"run{force}", force), output) for force in (1, 2)]
    message = [(run.communicate(timeout=120)[1], run.returncode) for run in runs]
    assert 0 in [code for _, code in message], message
    for sentence, code in message:
        assert code in (0, 2), sentence
        assert "Traceback" not in sentence
    assert whole(output) in (1.0, 2.0)
    assert hidden(tmp_path) == []
