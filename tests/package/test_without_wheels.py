"""Where numba, h5py or h5netcdf is not there or cannot be loaded, studies run: slower, or without NetCDF files."""

from __future__ import annotations

import csv
import math
import os
import subprocess
import sys

import pytest

from winkler.numerics import jit
from winkler.study.report import netcdf

STUDIES = {
    "springs": """
[problem]
kind = "tangential"
law = { kind = "coulomb", coefficient = 0.3 }
path.kind = "program"
path.steps = [
  { kind = "start", lateral = { kind = "shift", shift = ["0 m", "0 m"] }, normal = { kind = "force", force = "0 N" } },
  { kind = "ramp", normal = { kind = "force", force = "100 N" } },
  { kind = "oscillate", lateral = { kind = "shift", shift = ["0.3 um", "0.2 um"] }, count = 8 },
]
""",
    "relaxing": """
[problem]
kind = "viscoelastic_impact"
mass = "30 g"
velocity = "1 m/s"
count = 20
tolerance = 0.02
""",
}
MEDIA = {
    "springs": ("half_space", 'kind = "elastic", young = "210 GPa", poisson = 0.3'),
    "relaxing": (
        "viscoelastic_half_space",
        'kind = "standard_solid", relaxed_shear = "1 MPa", shear = "1 MPa", relaxation_time = "2 ms"',
    ),
}
BED = """
[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }
medium.kind = "{medium}"
medium.first = { {first} }
[output]
figures = []
report = false
"""


def rows(path):
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.reader(file))


def test_a_package_that_is_not_there_is_said_once(monkeypatch, caplog):
    monkeypatch.setitem(sys.modules, "numba", None)
    monkeypatch.setitem(sys.modules, "h5netcdf", None)  # without h5py alone it loads, and keeps that for later tests
    for question in (jit._numba, netcdf.has_netcdf):
        monkeypatch.setattr(sys.modules[question.__module__], question.__name__, question)  # a cache of its own
        question.cache_clear()
        try:
            assert not question()
            assert not question()
        finally:
            question.cache_clear()
    said = [record.getMessage() for record in caplog.records]
    assert len(said) == 2
    assert said[0].startswith("winkler: numba ")
    assert "loops run as plain Python, more slowly" in said[0]
    assert said[1].startswith("winkler: no NetCDF file is written, as h5netcdf or h5py cannot be loaded (")


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("name", STUDIES)
def test_studies_run_without_them(name, tmp_path):
    """Issue 38, item 9: two of seven studies ended in "winkler made a mistake"."""
    lags = tmp_path / "lags"
    lags.mkdir()
    medium, first = MEDIA[name]
    bed = BED.replace("{medium}", medium).replace("{first}", first)
    (tmp_path / "x.toml").write_text(STUDIES[name] + bed, encoding="utf-8")
    for package in ("numba", "h5py", "h5netcdf"):
        (lags / f"{package}.py").write_text('raise ImportError("no wheel for this Python.")\n')
    path = os.environ.get("PYTHONPATH", "")
    found = {}
    for how, places in (("with", path), ("without", f"{lags}{os.pathsep}{path}")):
        words = [sys.executable, "-m", "winkler", "run", "x.toml", "--quiet", "--output", how]
        ended = subprocess.run(
            words, cwd=tmp_path, env={**os.environ, "PYTHONPATH": places}, capture_output=True, text=True, check=False
        )
        assert (ended.returncode, ended.stdout) == (0, ""), ended.stderr
        found[how] = ended.stderr.splitlines(), rows(tmp_path / how / "results.csv")
    assert (tmp_path / "with/results.nc").is_file()
    assert not (tmp_path / "without/results.nc").exists()
    assert found["with"][0] == []
    assert [line.partition(" (no wheel for this Python); ")[0] for line in found["without"][0]] == [
        "winkler: numba cannot be loaded",
        "winkler: no NetCDF file is written, as h5netcdf or h5py cannot be loaded",
    ]
    compiled, plain = found["with"][1], found["without"][1]
    assert compiled[0] == plain[0]
    assert len(compiled) > 2
    for one, other in zip(compiled[1:], plain[1:], strict=True):
        for column, a, b in zip(compiled[0], one, other, strict=True):
            assert math.isclose(float(a), float(b), rel_tol=1e-9, abs_tol=1e-12), column
