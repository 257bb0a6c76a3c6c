"""The NetCDF files follow the conventions CF, by the checker of IOOS; the names of keys keep their dots."""

from __future__ import annotations

import json
import warnings

import pytest

from winkler.cli import main

STUDY = """title = "balls"
[problem]
kind = "indentation"
[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "5 mm" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 MPa", poisson = 0.5 } }
[problem.load]
kind = "force"
force = "1 N"
[sweep]
"problem.load.force" = ["1 N", "2 N"]
"problem.bed.profile.curvature_radius" = ["1 mm", "2 mm", "3 mm"]
[fields]
r = { from = "0 a", to = "3 a", count = 6 }
z = { from = "0.05 a", to = "3 a", count = 4 }
[output]
figures = []
report = false
"""


def test_what_the_file_states(tmp_path, monkeypatch):
    xarray = pytest.importorskip("xarray")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "s.toml").write_text(STUDY, encoding="utf-8")
    assert main(["run", "s.toml", "--quiet", "--output", "s"]) == 0
    with xarray.open_dataset("s/results.nc") as stored:
        assert stored.attrs["Conventions"] == "CF-1.11"
        assert "written by winkler" in stored.attrs["history"]
        assert all(one.attrs.get("units") for one in stored.variables.values())
        edges = [name for name in stored.coords if stored[name].dims == (name,)]
        assert len(edges) == 4
        assert [name for name in edges if "_FillValue" in stored[name].encoding] == []
        assert set(stored["von_mises"].coords) == {*edges, "r", "z"}


@pytest.mark.slow
def test_a_checker_finds_no_error(tmp_path, monkeypatch):
    runner = pytest.importorskip("compliance_checker.runner", reason="no checker here: pip install winkler[checks]")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "s.toml").write_text(STUDY, encoding="utf-8")
    assert main(["run", "s.toml", "--quiet", "--output", "s"]) == 0
    runner.CheckSuite.load_all_available_checkers()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        runner.ComplianceChecker.run_checker(
            "s/results.nc", ["cf:1.11"], 0, "normal", output_filename="told.json", output_format="json"
        )
    told = json.loads((tmp_path / "told.json").read_text(encoding="utf-8"))["cf:1.11"]
    assert sum(one["value"][1] for one in told["all_priorities"]) > 100
    errors = [one["msgs"] for one in told["high_priorities"] if one["value"][0] < one["value"][1]]
    assert errors == []
    others = [line for one in told["medium_priorities"] for line in one["msgs"] if one["value"][0] < one["value"][1]]
    assert [line for line in others if "letters, digits, and underscores" not in line] == []
