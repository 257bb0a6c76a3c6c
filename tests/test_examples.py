"""Every example runs: the scripts as a reader would start them, the studies through the command line.

They run in this process, one script of each folder and some studies by default; the other studies are slow tests, as
are some scripts in a process of their own.  The other scripts run where the manual's gallery is built, which
stops at a mistake or a warning as these tests do: `pytest -m manual` runs them without it, and `.ci/run` does not.
"""

from __future__ import annotations

import os
import runpy
import subprocess
import sys
from pathlib import Path

import pytest
from project_files import ROOT, project_files

from winkler.cli import main

EXAMPLES = ROOT / "examples"
SCRIPTS = project_files(EXAMPLES, "*.py")
STUDIES = project_files(EXAMPLES / "studies", "*.toml")


def name(path: Path) -> str:
    return path.relative_to(EXAMPLES).as_posix()


def test_there_are_examples():
    assert {"measured_tip.toml"} <= {path.name for path in STUDIES}
    assert len(SCRIPTS) >= 4


QUICK = {
    "adhesion/snap_in_and_pull_off.py",
    "conduction/thermal_joint.py",
    "course/lesson_1_springs.py",
    "data/make_force_curves.py",
    "data/make_rough_surface.py",
    "data/gel_holds/make_holds.py",
    "data/logs/make_logs.py",
    "exchange/for_other_programs.py",
    "fitting/oliver_pharr.py",
    "friction/fretting_loop.py",
    "heating/warming_up.py",
    "line/sticky_roller.py",
    "media/graded_ceramic.py",
    "normal/hertz.py",
    "rolling/creep_curves.py",
    "rough/ellipse_and_pyramid.py",
    "viscoelastic/gel_bead.py",
    "wear/fretting_ends.py",
} | {
    "studies/adhesion/sticky_ball.toml",
    "studies/conduction/roller_resistance.toml",
    "studies/fitting/fit_gel.toml",
    "studies/friction/twisted_ball.toml",
    "studies/heating/fretting_heat.toml",
    "studies/impact/bouncing_ball.toml",
    "studies/line/line_creep.toml",
    "studies/normal/wheel_rail.toml",
    "studies/rolling/leaning_wheel.toml",
    "studies/rough/pressure_map.toml",
    "studies/viscoelastic/gel_creep.toml",
    "studies/wear/fretting_wear.toml",
}
"""One of each folder, and those that write data for others; all run among the slow tests."""
QUICK_SCRIPTS = [script for script in SCRIPTS if name(script) in QUICK]


def test_one_of_each_folder_is_quick():
    examples = [*SCRIPTS, *STUDIES]
    assert {name(path) for path in examples} >= QUICK
    assert {path.parent for path in examples} == {(EXAMPLES / path).parent for path in QUICK}


def when(script: Path) -> list[pytest.MarkDecorator]:
    """Return the mark of a script; sphinx-gallery takes the folders that have a heading."""
    if name(script) in QUICK:
        return []
    return [pytest.mark.manual if (script.parent / "GALLERY_HEADER.rst").exists() else pytest.mark.slow]


@pytest.mark.few(2)
@pytest.mark.parametrize(
    "script", [pytest.param(script, marks=when(script)) for script in SCRIPTS], ids=map(name, SCRIPTS)
)
def test_script(script, tmp_path, monkeypatch):
    import matplotlib.pyplot as plt

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "argv", [str(script)])
    monkeypatch.setattr(sys, "path", [str(script.parent), *sys.path])
    with plt.rc_context():
        runpy.run_path(str(script), run_name="__main__")
        plt.close("all")


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("script", QUICK_SCRIPTS, ids=map(name, QUICK_SCRIPTS))
def test_script_on_its_own(script, tmp_path):
    solution = subprocess.run(
        [sys.executable, str(script)],
        cwd=tmp_path,
        env={**os.environ, "MPLBACKEND": "Agg", "PYTHONWARNINGS": "error::RuntimeWarning", "PYTHONIOENCODING": "utf-8"},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=600,
        check=False,
    )
    assert solution.returncode == 0, solution.stdout + solution.stderr


@pytest.mark.few(2)
@pytest.mark.parametrize(
    "study",
    [
        study
        if name(study) in QUICK
        else pytest.param(study, marks=pytest.mark.long if place % 3 else pytest.mark.slow)
        for place, study in enumerate(STUDIES)
    ],
    ids=map(name, STUDIES),
)
def test_study(study, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    output = tmp_path / "answer"
    text = study.read_text(encoding="utf-8")
    fits = any(f"\n[{section}]" in text for section in ("fit", "indentation", "calibration"))
    command = "fit" if fits else "run"
    assert main([command, str(study), "--output", str(output), "--workers", "1"]) == 0, capsys.readouterr()
    report = list(output.rglob("report.html"))
    assert report, f"no report.html in {sorted(path.name for path in output.rglob('*'))}"
    assert all(path.stat().st_size > 0 for path in output.rglob("*") if path.is_file())
