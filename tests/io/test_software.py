"""The software that computes: a digest that tells changed sources, and nothing else, apart."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
import scipy

import winkler
from winkler.io import software as module
from winkler.io.software import differences, software

SOURCES = {"values.py": "a = 1\n", "problems/__init__.py": "", "problems/ball.py": "b = 2\n", "cases/x.toml": "c = 3\n"}
HERE = Path(winkler.__file__).parent


def package(folder: Path, sources=SOURCES, age: float = 0.0) -> Path:
    for name, text in sources.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    if age:
        (folder / "__pycache__").mkdir()
    return folder


def test_it_states_what_is_installed():
    import numba

    stated = software()
    assert list(stated) == ["winkler", "sources", "numba", "numpy", "scipy"]
    assert (stated["numba"], stated["numpy"], stated["scipy"]) == (
        numba.__version__,
        np.__version__,
        scipy.__version__,
    )
    assert stated["winkler"] == winkler.__version__
    assert module.installed_version("no_such_package") == "none"


def test_the_same_sources_have_one_digest_wherever_and_whenever_they_were_written(tmp_path):
    first = package(tmp_path / "first")
    second = package(tmp_path / "second", dict(reversed(SOURCES.items())))
    os.utime(second / "values.py", (1.0, 1.0))
    (second / "__pycache__").mkdir()
    (second / "__pycache__/values.cpython-311.pyc").write_bytes(b"x")
    (second / "cases/x.toml").write_text("c = 4\n")
    assert module._digest(first) == module._digest(second)


@pytest.mark.parametrize(
    "change",
    [{"values.py": "a = 2\n"}, {"problems/ball.py": ""}, {"problems/new.py": ""}, {"materials.toml": "x = 1\n"}],
)
def test_each_change_of_what_solves_shows(change, tmp_path):
    before = module._digest(package(tmp_path))
    assert module._digest(package(tmp_path, change)) != before


def test_a_file_that_was_renamed_shows(tmp_path):
    before = module._digest(package(tmp_path))
    (tmp_path / "problems/ball.py").rename(tmp_path / "problems/cone.py")
    assert module._digest(tmp_path) != before


@pytest.fixture
def settled(tmp_path, monkeypatch):
    """Return a package whose files are old enough that their times are believed, with its digest kept."""
    folder = package(tmp_path, age=1.0)
    later = time.time() + 10.0
    monkeypatch.setattr(module.time, "time", lambda: later)
    return folder, module._digest(folder)


def test_what_is_kept_is_not_read_again_and_a_change_of_equal_length_shows(settled, monkeypatch):
    folder, before = settled
    (folder / "values.py").chmod(0o644)  # nothing changed but the time of the last change of anything
    assert module._digest(folder) == before
    with monkeypatch.context() as patch:
        patch.setattr("builtins.open", None)
        assert module._digest(folder) == before
    status = (folder / "values.py").stat()
    (folder / "values.py").write_text("a = 9\n")
    os.utime(folder / "values.py", ns=(status.st_atime_ns, status.st_mtime_ns))
    assert module._digest(folder) != before


@pytest.mark.parametrize("spoilt", ["", "x", "{key} ", "{key} abc \n", "{key} 0123456789abcdef", "\0" * 90])
def test_a_spoilt_record_is_made_anew(spoilt, settled):
    folder, before = settled
    record = folder / "__pycache__/sources.digest"
    record.write_text(spoilt.replace("{key}", record.read_text().split(" ")[0]))
    assert module._digest(folder) == before


def test_sources_that_changed_a_moment_ago_are_read_each_time(tmp_path):
    folder = package(tmp_path, age=1.0)
    module._digest(folder)
    assert list((folder / "__pycache__").iterdir()) == []


def test_what_differs_is_named():
    mine = software()
    assert differences(mine) == ""
    assert differences(mine | {"numpy": "1.0", "sources": "0"}) == (
        f"sources of winkler 0 (here {mine['sources']}), numpy 1.0 (here {np.__version__})"
    )
    assert differences(None).startswith(f"winkler unknown (here {mine['winkler']})")


def test_no_solver_reads_what_is_left_out():
    """The layers see to it; and no folder is named that is not there."""
    assert {name for name in module.NOT_SOLVING if not (HERE / name).is_dir()} == set()
    code = (
        "import winkler as wk; wk.Indentation(wk.Foundation(wk.Sphere(1e-3), wk.HalfSpace(wk.Elastic(1e9, 0.25))), "
        "wk.Force(1.0)).solve(); import sys; print(*sys.modules)"
    )
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert {name for name in loaded if name.startswith(tuple(f"winkler.{one}" for one in module.NOT_SOLVING))} == set()


STUDY = """
title = "x"
[problem]
kind = "indentation"
bed.kind = "foundation"
bed.profile = { kind = "paraboloid", curvature_radius = "1 mm" }
bed.medium = { kind = "half_space", first = { kind = "elastic", young = "1 GPa", poisson = 0.25 } }
load = { kind = "force", force = "1 N" }
[sweep]
"problem.load.force" = ["1 N", "2 N", "3 N"]
[output]
figures = []
report = false
"""
STOPPED = """
import sys
from winkler.study.batch import sweep
from winkler.study.batch.journal import Journal
from winkler.study.language.reading import read_study
from pathlib import Path
study = read_study("x.toml")
with Journal.beside(Path("results/x"), study) as journal:
    next(sweep.solve_points(study, journal))
"""


@pytest.mark.slow
def test_a_sweep_is_not_continued_by_changed_sources(tmp_path):
    """Issue 38, item 8: 197 of 320 points of one program, the others of another, ended with code 0."""
    shutil.copytree(HERE, tmp_path / "src/winkler", ignore=shutil.ignore_patterns("__pycache__"))
    (tmp_path / "x.toml").write_text(STUDY, encoding="utf-8")
    (tmp_path / "results").mkdir()
    environment = {**os.environ, "PYTHONPATH": str(tmp_path / "src")}

    def python(*words):
        return subprocess.run(
            [sys.executable, *words], cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
        )

    assert python("-c", STOPPED).returncode == 0
    source = tmp_path / "src/winkler/profiles/power.py"
    text = source.read_text(encoding="utf-8")
    source.write_text(f"{text}\n# another program\n", encoding="utf-8")
    refused = python("-m", "winkler", "run", "x.toml", "--quiet")
    assert (refused.returncode, refused.stdout) == (2, "")
    assert "was begun with sources of winkler" in refused.stderr
    assert "add --anew" in refused.stderr
    source.write_text(text, encoding="utf-8")
    continued = python("-m", "winkler", "run", "x.toml", "--quiet")
    assert (continued.returncode, continued.stderr) == (0, "")
