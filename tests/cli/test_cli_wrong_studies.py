"""Wrong studies: each gives its sentence on stderr, exit code 2, no traceback, and nothing is written."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from winkler.cli import main
from winkler.study.catalogue import CATALOGUE

BASE = """title = "Ball"

[problem]
kind = "indentation"

[problem.bed]
kind = "foundation"
profile = { kind = "sphere", curvature_radius = "10 mm" }

[problem.bed.medium]
kind = "half_space"
first = { kind = "elastic", young = "210 GPa", poisson = 0.3 }

[problem.load]
kind = "force"
force = "100 N"
"""
WRONG = tomllib.loads((Path(__file__).parent / "wrong_studies.toml").read_text(encoding="utf-8"))["wrong"]


def spoilt(case: dict[str, str]) -> str:
    if "whole" in case:
        return case["whole"]
    assert case.get("old", "") in BASE
    text = BASE.replace(case["old"], case["new"], 1) if "old" in case else BASE
    return case.get("before", "") + text + case.get("after", "")


def test_the_table_is_long_enough():
    assert len(WRONG) >= 60
    assert len({spoilt(case) for case in WRONG} - {BASE}) == len(WRONG)


def test_the_study_they_spoil_is_right(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "right.toml").write_text(BASE + "[output]\nfigures = []\nreport = false\n")
    assert main(["run", "right.toml", "--quiet"]) == 0


@pytest.mark.parametrize("case", WRONG, ids=[str(number) for number in range(len(WRONG))])
def test_wrong_study(case, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "wrong.toml").write_text(spoilt(case), encoding="utf-8")
    (tmp_path / "table.csv").write_text("a,b\n1,2\n", encoding="utf-8")
    code = main(["run", "wrong.toml", "--output", "made/answer"])
    told = capsys.readouterr()
    sentence = case["sentence"].replace("{profiles}", ", ".join(CATALOGUE["profile"]))
    assert told.err == "winkler: " + "\n".join(f"wrong.toml: {line}" for line in sentence.split("\n")) + "\n"
    assert told.out == ""
    assert code == 2
    assert sorted(path.name for path in tmp_path.iterdir()) == ["table.csv", "wrong.toml"]
