"""The lines of a user are checked by mypy and pyright without a cast, and run."""

from __future__ import annotations

import json
import runpy
import subprocess
import sys
from pathlib import Path

import pytest

import winkler

LINES = Path(__file__).with_name("typed") / "user.py"
SOURCE = Path(winkler.__file__).parents[1]
WRONG = """
import winkler as wk
import numpy as np

bed = wk.Foundation(wk.Sphere(1e-2), wk.HalfSpace(wk.Elastic(1e9, 0.3)))
number: float = wk.Indentation(bed, wk.Force(np.array([1.0, 2.0]))).solve().depth
"""


def test_the_lines_run(capsys):
    runpy.run_path(str(LINES))
    assert capsys.readouterr().out.startswith("3.483 um 186.62 ")
    assert len(LINES.read_text(encoding="utf-8").splitlines()) >= 60


def mypy(path, cache):
    command = [
        sys.executable,
        "-m",
        "mypy",
        "--strict",
        "--follow-imports=silent",
        "--cache-dir",
        str(cache),
        str(path),
    ]
    return subprocess.run(command, cwd=SOURCE, capture_output=True, text=True)


@pytest.mark.slow
def test_mypy_takes_them_and_no_array_for_a_number(tmp_path):
    pytest.importorskip("mypy", reason="no mypy here: pip install winkler[checks]")
    done = mypy(LINES, tmp_path / "cache")
    assert done.returncode == 0, done.stdout
    (tmp_path / "wrong.py").write_text(WRONG, encoding="utf-8")
    done = mypy(tmp_path / "wrong.py", tmp_path / "cache")
    assert "wrong.py:6: error: Incompatible types in assignment" in done.stdout
    assert "Found 1 error" in done.stdout


@pytest.mark.slow
def test_pyright_takes_them_and_no_array_for_a_number(tmp_path):
    pytest.importorskip("pyright", reason="no pyright here: pip install winkler[checks]")
    (tmp_path / "wrong.py").write_text(WRONG, encoding="utf-8")
    (tmp_path / "right.py").write_text(LINES.read_text(encoding="utf-8"), encoding="utf-8")
    settings = {"include": ["*.py"], "extraPaths": [str(SOURCE)], "pythonVersion": "3.11"}
    (tmp_path / "pyrightconfig.json").write_text(json.dumps(settings), encoding="utf-8")
    command = [sys.executable, "-m", "pyright", "--outputjson", "--pythonpath", sys.executable, "-p", str(tmp_path)]
    told = json.loads(subprocess.run(command, cwd=tmp_path, capture_output=True, text=True).stdout)
    assert told["summary"]["filesAnalyzed"] == 2
    found = [(Path(one["file"]).name, one["range"]["start"]["line"] + 1) for one in told["generalDiagnostics"]]
    assert found == [("wrong.py", 6)], told["generalDiagnostics"]
