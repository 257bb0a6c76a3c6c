"""How soon winkler answers: the help of the command line and the first import, each in a new process.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only

What is loaded is looked at by tests/package/test_cold_start.py; this looks at the clock.
"""

from __future__ import annotations

import subprocess
import sys

import pytest

pytestmark = pytest.mark.bench

STARTS = {
    "winkler --help": (["-m", "winkler", "--help"], 0.5),
    "import winkler, first name": (["-c", "import winkler; winkler.Sphere(1.0)"], 1.5),
}


@pytest.mark.parametrize("name", STARTS)
def bench_a_cold_start(benchmark, below, name):
    """The page cache is warm, the process is new."""
    words, target = STARTS[name]
    answer = benchmark.pedantic(
        lambda: subprocess.run([sys.executable, *words], capture_output=True, text=True, check=True),
        rounds=5,
        warmup_rounds=1,
    )
    assert answer.stderr == ""
    below(target, name)
