"""Sweeps: ten thousand points from the study file to the whole folder of results, and what a point costs in between.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import winkler as wk
from winkler.study.batch.journal import Journal
from winkler.study.batch.run import run
from winkler.study.batch.sweep import solve_points
from winkler.study.language.designs import Sensitivity, Sobol
from winkler.study.language.study import Study
from winkler.study.language.varied import Axis, Range

pytestmark = pytest.mark.bench

STUDY = """title = "Ten thousand balls"

[problem]
kind = "indentation"
load = { kind = "force", force = "10 N" }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }
medium = { kind = "half_space", first = { kind = "elastic", young = "210 GPa", poisson = 0.3 } }

[sweep]
"problem.load.force" = { from = "1 N", to = "1 kN", count = 100, spacing = "log" }
"problem.bed.medium.first.young" = { from = "50 GPa", to = "500 GPa", count = 100, spacing = "log" }
"""
BED = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace(wk.Elastic(210e9, 0.3)))
BALL = wk.Indentation(BED, wk.Force(10.0))
KEYS = (Range("problem.load.force", 1.0, 1e3, "log"), Range("problem.bed.medium.first.young", 50e9, 500e9))


def bench_ten_thousand_points_with_all_results(benchmark, below, tmp_path):
    """The command, in two processes, with its start, its journal, NetCDF, CSV, figures and report: 30 s."""
    (tmp_path / "balls.toml").write_text(STUDY, encoding="utf-8")
    words = [sys.executable, "-m", "winkler", "run", "balls.toml", "--workers", "2", "--quiet", "--overwrite"]

    def command() -> None:
        subprocess.run(words, cwd=tmp_path, check=True)

    benchmark.pedantic(command, rounds=2, iterations=1)
    lines = (tmp_path / "results/balls/results.csv").read_text(encoding="utf-8").count("\n")
    assert lines == 10001
    below(30.0, "sweep of 10,000 points, two processes, all results")


def bench_ten_thousand_points_recalled(benchmark, below, tmp_path):
    """From a whole journal to the table of results, nothing solved: 5 s."""
    forces, youngs = np.geomspace(1.0, 1e3, 100), np.geomspace(50e9, 500e9, 100)
    study = Study("x", BALL, sweep=(Axis(KEYS[0].key, forces), Axis(KEYS[1].key, youngs)))
    path = tmp_path / "x.journal"
    with Journal(path, study) as journal:
        for _ in solve_points(study, journal):
            pass

    def again() -> Path:
        return Path(shutil.copy(path, tmp_path / "again.journal"))

    outcome = benchmark.pedantic(
        lambda journal: run(study, journal=journal), setup=lambda: ((again(),), {}), rounds=3, iterations=1
    )
    assert len(outcome.table()[0].content) == 10000
    below(5.0, "10,000 points recalled from a journal")


def bench_a_thousand_drawn_points(benchmark, below):
    """Drawn, solved in this process, and tabled: 2 s."""
    study = Study("x", BALL, sweep=KEYS, design=Sobol(1024))
    outcome = benchmark.pedantic(lambda: run(study).table(), rounds=3, iterations=1)
    assert len(outcome[0].content) == 1024
    below(2.0, "1024 points of a Sobol sequence, one process")


def bench_indices_of_sobol(benchmark, below):
    """Five results over two keys, 256 pairs, with their intervals: 1 s."""
    outcome = run(Study("x", BALL, sweep=KEYS, design=Sensitivity(256)))

    def indices():
        vars(outcome).pop("indices", None)
        return outcome.indices

    assert len(benchmark(indices)) == 5
    below(1.0, "indices of Sobol of five answers, 256 pairs")
