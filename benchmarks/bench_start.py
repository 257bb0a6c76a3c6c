"""The time to start winkler: its help, one name, all names, numbers and a report of one contact, each in a new process.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only

What is loaded is checked by tests/package/test_cold_start.py; this measures time.
"""

from __future__ import annotations

import subprocess
import sys

import pytest

pytestmark = pytest.mark.bench

STUDY = """[problem]
kind = "indentation"
load = { kind = "force", force = "100 N" }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }
medium = { kind = "half_space", first = { kind = "elastic", young = "210 GPa", poisson = 0.3 } }
"""
STARTS = {
    "winkler --help": (["-m", "winkler.cli", "--help"], 0.5),
    "import winkler, one name": (["-c", "import winkler; winkler.Sphere"], 0.4),
    "import winkler, all names": (["-c", "import winkler; [getattr(winkler, name) for name in dir(winkler)]"], 1.5),
    "winkler run --json, one contact": (["-m", "winkler.cli", "run", "ball.toml", "--json"], 1.0),
    "winkler run, one contact, with report": (["-m", "winkler.cli", "run", "ball.toml", "--quiet", "--yes"], 3.0),
}


@pytest.mark.parametrize("name", STARTS)
def bench_a_cold_start(benchmark, below, name, tmp_path):
    """The page cache is warm, the process is new."""
    words, target = STARTS[name]
    (tmp_path / "ball.toml").write_text(STUDY, encoding="utf-8")
    solution = benchmark.pedantic(
        lambda: subprocess.run([sys.executable, *words], capture_output=True, text=True, check=True, cwd=tmp_path),
        rounds=5,
        warmup_rounds=1,
    )
    assert solution.stderr == ""
    below(target, name)
