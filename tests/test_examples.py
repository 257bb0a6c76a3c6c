"""Every example runs: the scripts as a reader would start them, the studies through the command line.

Scripts and studies run one after the other in this process, as the manual's gallery runs them; each script in a process
of its own, which is enough for the longest, and the longer studies, among the slow tests.
"""

from __future__ import annotations

import os
import runpy
import subprocess
import sys
from pathlib import Path

import pytest

from winkler.cli import main

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
SCRIPTS = sorted(EXAMPLES.rglob("*.py"))
STUDIES = sorted((EXAMPLES / "studies").rglob("*.toml"))


def name(path: Path) -> str:
    return path.relative_to(EXAMPLES).as_posix()


def test_there_are_examples():
    assert {"measured_tip.toml"} <= {path.name for path in STUDIES}
    assert len(SCRIPTS) >= 4


LONGEST = {"bouncing_ball", "mindlin_varying_normal_force", "peeling_rubber"}
"""Scripts of more than two seconds of processor time."""
QUICK = [script for script in SCRIPTS if script.stem not in LONGEST]


def test_the_longest_are_there():
    assert len(QUICK) == len(SCRIPTS) - len(LONGEST)


@pytest.mark.parametrize("script", QUICK, ids=map(name, QUICK))
def test_script(script, tmp_path, monkeypatch):
    import matplotlib.pyplot as plt

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "argv", [str(script)])
    monkeypatch.setattr(sys, "path", [str(script.parent), *sys.path])
    with plt.rc_context():
        runpy.run_path(str(script), run_name="__main__")
        plt.close("all")


@pytest.mark.slow
@pytest.mark.parametrize("script", SCRIPTS, ids=map(name, SCRIPTS))
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


# what another study shows as well, and what takes long, runs among the slow tests
SLOW = {
    "cone",
    "formula",
    "flat_punch",
    "bolted_joint",
    "bouncing_ball",
    "fit_sticky",
    "measured_gel",
    "elliptic_flash",
} | {
    "braking_wheel",
    "cell_indentation",
    "contact_resistance",
    "fit_batch",
    "fit_cell_loop",
    "fit_gel_creep",
    "flash_temperature",
    "fretting_heat",
    "fretting_loop",
    "fretting_wear",
    "many_coatings",
    "rubber_ball",
    "rubber_dma",
    "rubber_rolling",
    "sticky_ball",
    "sticky_gel_film",
    "three_layers",
    "twisted_ball",
    "what_matters",
}


@pytest.mark.parametrize(
    "study",
    [pytest.param(study, marks=[pytest.mark.slow] if study.stem in SLOW else []) for study in STUDIES],
    ids=map(name, STUDIES),
)
def test_study(study, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    output = tmp_path / "answer"
    command = "fit" if "\n[fit]\n" in study.read_text(encoding="utf-8") else "run"
    assert main([command, str(study), "--output", str(output), "--workers", "1"]) == 0, capsys.readouterr()
    report = list(output.rglob("report.html"))
    assert report, f"no report.html in {sorted(path.name for path in output.rglob('*'))}"
    assert all(path.stat().st_size > 0 for path in output.rglob("*") if path.is_file())
