"""Ctrl-C while height maps are pressed: one sentence, the documented code, and whole files or none."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

MAP = """title = "A rough map"

[problem]
kind = "surface_contact"
medium = {{ kind = "half_space", first = {{ kind = "elastic", young = "83 GPa", poisson = 0.37 }} }}
load = {{ kind = "force", force = {{ from = "0.1 N", to = "200 N", count = {loads}, spacing = "log" }} }}

[problem.topography]
kind = "random_topography"
lengths = "1 mm"
shape = [{pixels}, {pixels}]
spectrum = {{ kind = "self_affine", hurst = 0.8, rms_height = "1 um", longest = "1 mm", shortest = "10 um" }}
"""
SWEEP = """
[sweep]
"problem.topography.seed" = {seeds}
"""
OUTPUT = """
[output]
figures = []
report = false
"""

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(os.name == "nt", reason="there is no SIGINT of a process alone there"),
]


def stopped(here: Path, ready, after: float) -> tuple[int, str]:
    """Run ``winkler run map.toml``, interrupt it once it is ready, and return the code and what it told."""
    words = [sys.executable, "-m", "winkler.cli", "run", "map.toml", "--quiet"]
    run = subprocess.Popen(words, cwd=here, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    deadline = time.monotonic() + 240
    while not ready():
        assert run.poll() is None, run.communicate()
        assert time.monotonic() < deadline
        time.sleep(0.05)
    time.sleep(after)
    run.send_signal(signal.SIGINT)
    said, told = run.communicate(timeout=240)
    assert said == ""
    return run.returncode, told


def partial(here: Path):
    return lambda: any((here / "results").glob(".map.*.partial")) if (here / "results").is_dir() else False


def test_before_the_first_load_is_reached(tmp_path):
    """One contact that takes long: nothing is written."""
    (tmp_path / "map.toml").write_text(MAP.format(loads=2, pixels=1024) + OUTPUT, encoding="utf-8")
    code, told = stopped(tmp_path, partial(tmp_path), 0.3)
    assert (code, told) == (130, "winkler: interrupted; nothing was written.\n")
    assert [path.name for path in tmp_path.iterdir()] == ["map.toml"]


def test_on_the_way_along_a_curve(tmp_path):
    """What was reached is written whole, or nothing if that was nothing yet."""
    import xarray

    (tmp_path / "map.toml").write_text(MAP.format(loads=2000, pixels=96) + OUTPUT, encoding="utf-8")
    code, told = stopped(tmp_path, partial(tmp_path), 3.0)
    assert code == 130
    assert told.startswith("winkler: interrupted; ")
    assert told.count("\n") == 1
    left = [path.name for path in (tmp_path / "results").iterdir()]
    if left:  # the first load was reached within that time
        assert told == f"winkler: interrupted; the points that were reached are kept in {Path('results') / 'map'}.\n"
        assert left == ["map"]
        with xarray.open_dataset(tmp_path / "results" / "map" / "results.nc") as data:
            assert 1 <= data.sizes["load"] < 2000
            force = data.force.to_numpy()
        np.testing.assert_allclose(force, np.geomspace(0.1, 200.0, 2000)[: force.size], rtol=1e-6)
        rows = (tmp_path / "results" / "map" / "results.csv").read_text(encoding="utf-8").splitlines()
        assert len(rows) == force.size + 1
    else:
        assert told == "winkler: interrupted; nothing was written.\n"


def test_within_a_sweep(tmp_path):
    """The points that were solved are kept, and the same command goes on from there."""
    journal = tmp_path / "results" / ".map.journal"
    study = MAP.format(loads=2, pixels=64) + SWEEP.format(seeds=list(range(200))) + OUTPUT
    (tmp_path / "map.toml").write_text(study, encoding="utf-8")

    def some() -> bool:
        return journal.exists() and journal.read_bytes().count(b"\n") > 3

    code, told = stopped(tmp_path, some, 0.0)
    known = journal.read_bytes().count(b"\n") - 1
    assert code == 130
    assert told == (
        f"winkler: interrupted; {known} of 200 points are kept beside {Path('results') / 'map'}, and the same command "
        "goes on from there.\n"
    )
    assert [path.name for path in (tmp_path / "results").iterdir()] == [".map.journal"]
    code, told = stopped(tmp_path, lambda: some() and journal.read_bytes().count(b"\n") > known + 3, 0.0)
    assert code == 130
    assert journal.read_bytes().count(b"\n") - 1 > known
