"""The lines of a user are checked by mypy and pyright without a cast, and run."""

from __future__ import annotations

import json
import os
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


@pytest.mark.slow
def test_mypy_takes_them_and_no_array_for_a_number(tmp_path, root):
    pytest.importorskip("mypy", reason="no mypy here: pip install winkler[checks]")
    (tmp_path / "wrong.py").write_text(WRONG, encoding="utf-8")
    command = [sys.executable, "-m", "mypy", "--strict", str(LINES), str(tmp_path / "wrong.py")]
    # from the folder of the sources, whose cache a check of the sources has filled
    given = {**os.environ, "MYPYPATH": "src"}
    told = subprocess.run(command, cwd=root, env=given, capture_output=True, text=True).stdout
    assert "wrong.py:6: error: Incompatible types in assignment" in told
    assert "Found 1 error in 1 file (checked 2 source files)" in told


@pytest.mark.long  # pyright fetches its program when it first runs
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
