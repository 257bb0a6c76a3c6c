"""Wrong studies: each gives its sentence on stderr, exit code 2, no traceback, and nothing is written."""

from __future__ import annotations

import contextlib
import os
import re
import tomllib
from pathlib import Path

import jsonschema
import pytest

from winkler.cli import main
from winkler.study.json_schema import json_schema
from winkler.study.language.catalogue import CATALOGUE
from winkler.values.errors import listed

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
HALF_SPACE = """kind = "half_space"
first = { kind = "elastic", young = "210 GPa", poisson = 0.3 }
"""
COATED = """kind = "coated_half_space"
on = { kind = "elastic", young = "210 GPa", poisson = 0.3 }

[[problem.bed.medium.layers]]
kind = "layer"
thickness = "20 um"
solid = { kind = "elastic", young = "450 GPa", poisson = 0.25 }
"""
DEPTH_GRADED = """kind = "depth_graded_half_space"

[problem.bed.medium.grading]
kind = "tabulated_grading"
depths = ["0 um", "10 um", "50 um"]
youngs = ["300 GPa", "250 GPa", "210 GPa"]
poissons = [0.25, 0.28, 0.3]
"""
GRADED = """kind = "graded_half_space"
first = { kind = "power_law_graded", young = "220 GPa", depth_scale = "1 mm", exponent = 0.2, poisson = 0.25 }
"""
BED = BASE.partition("[problem.bed]\n")[2].partition("[problem.load]")[0]
MEASURED = """kind = "measured_bed"
file = "table.csv"
modulus = "115 GPa"
"""
LAW = """
[problem.law]
kind = "short_range"
work = "50 mJ/m^2"
"""
CYCLE = """"adhesive_cycle"
machine_stiffness = "5 N/m\""""
PATH = """[problem.path]
kind = "depth"
depth = [{ from = "-5 nm", to = "5 nm", count = 11 }, { from = "5 nm", to = "-5 nm", count = 11 }]
"""
RUBBED = """[problem.law]
kind = "coulomb"
coefficient = 0.3

[problem.path]
kind = "program"
steps = [
    { kind = "start", normal = { kind = "force", force = "100 N" } },
    { kind = "ramp", lateral = { kind = "shift", shift = "0.2 um" } },
    { kind = "oscillate", lateral = { kind = "shift", shift = "0.1 um" }, cycles = 2.0 },
]
"""
ROLLING = """
friction = { kind = "coulomb", coefficient = 0.3 }
creepage = { kind = "creepages", longitudinal = 0.001 }
"""
RELAXING = """kind = "viscoelastic_half_space"

[problem.bed.medium.first]
kind = "at_temperature"
temperature = "60 degC"
solid = { kind = "prony", relaxed_shear = "1 MPa", shears = ["1 MPa", "2 MPa"], relaxation_times = ["1 s", "10 s"] }
law = { kind = "arrhenius", reference_temperature = "20 degC", activation_energy = "80 kJ/mol" }
"""
HELD = """[problem.path]
kind = "path"
time = ["0 s", "1 s"]
normal = { kind = "depth", depth = ["0 um", "50 um"] }
"""
CONDUCTING = """
[problem.drive]
kind = "voltage"
voltage = "20 mV"

[problem.conductors]
kind = "electrical_conductors"
first = { kind = "electrical_conductor", resistivity = "15.9 nohm m" }

[problem.conductors.second]
kind = "rod"
conductor = { kind = "electrical_conductor", resistivity = "15.9 nohm m" }
radius = "1 mm"
length = "10 mm"
"""
FRETTING = """
normal = { kind = "force", force = "100 N" }
amplitude = { kind = "shift", shift = "0.5 um" }
cycles = [0, 100]
count = 20
wear = { kind = "archard", rate = "1e-5 mm^3/(N m)" }
law = { kind = "coulomb", coefficient = 0.5 }
"""
ROUGH = """[problem.topography]
kind = "height_map"
heights = [["0 um", "1 um", "0 um"], ["1 um", "2 um", "1 um"], ["0 um", "1 um", "0 um"]]
lengths = ["1 mm", "1 mm"]

[problem.medium]
kind = "half_space"
first = { kind = "elastic", young = "210 GPa", poisson = 0.3 }

"""
MADE = """[problem.topography]
kind = "random_topography"
lengths = "1 mm"
shape = [16, 16]
spectrum = { kind = "self_affine", hurst = 0.8, rms_height = "1 um", longest = "1 mm", shortest = "0.2 mm" }
"""
FLAT = BASE.replace('"indentation"', '"surface_contact"').replace(BASE[BASE.index("[problem.bed]") :], ROUGH)
FLAT += BASE[BASE.index("[problem.load]") :]
BASES = {
    "rough": FLAT,
    "random": FLAT.replace(ROUGH.partition("[problem.medium]")[0], MADE),
    "half_space": BASE,
    "coated": BASE.replace(HALF_SPACE, COATED),
    "depth_graded": BASE.replace(HALF_SPACE, DEPTH_GRADED),
    "graded": BASE.replace(HALF_SPACE, GRADED),
    "measured": BASE.replace(BED, MEASURED),
    "adhesive": BASE.replace('"indentation"', '"adhesive_indentation"') + LAW,
    "cycle": BASE.partition("[problem.load]")[0].replace('"indentation"', CYCLE) + PATH + LAW,
    "rolling": BASE.replace('"indentation"', '"rolling"' + ROLLING),
    "fretting": BASE.partition("[problem.load]")[0].replace('"indentation"', '"fretting_wear"' + FRETTING),
    "conducting": BASE.replace('"indentation"', '"joule_heating"') + CONDUCTING,
    "relaxing": BASE.partition("[problem.load]")[0]
    .replace('"indentation"', '"viscoelastic_indentation"')
    .replace(HALF_SPACE, RELAXING)
    + HELD,
    "rubbed": BASE.partition("[problem.load]")[0].replace('"indentation"', '"tangential"') + RUBBED,
}
"""Name -> the study that is spoilt; a case that names none spoils the first one."""
WRONG = tomllib.loads((Path(__file__).parent / "wrong_studies.toml").read_text(encoding="utf-8"))["wrong"]


def spoilt(case: dict[str, str]) -> str:
    if "whole" in case:
        return case["whole"]
    text = BASES[case.get("base", "half_space")]
    assert case.get("old", "") in text
    text = text.replace(case["old"], case["new"], 1) if "old" in case else text
    return case.get("before", "") + text + case.get("after", "")


def test_the_table_is_long_enough():
    assert len(WRONG) >= 60
    assert len({spoilt(case) for case in WRONG} - set(BASES.values())) == len(WRONG)


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
    message = capsys.readouterr()
    given = re.search(r"kind is '?(\w+)|$", case["sentence"])[1] or ""
    sentence = case["sentence"]
    for slot in ("profile", "problem", "medium"):
        sentence = sentence.replace(f"{{{slot}s}}", listed(given, CATALOGUE[slot]))
    assert message.err == "winkler: " + "\n".join(f"wrong.toml: {line}" for line in sentence.split("\n")) + "\n"
    assert message.out == ""
    assert code == 2
    assert sorted(path.name for path in tmp_path.iterdir()) == ["table.csv", "wrong.toml"]


@pytest.mark.slow
def test_an_editor_marks_more_than_half_of_them():
    taken = jsonschema.Draft7Validator(json_schema()).is_valid
    tables = []
    for case in WRONG[::4]:  # a validator in Python takes half a second for each
        with contextlib.suppress(tomllib.TOMLDecodeError):
            tables.append(tomllib.loads(spoilt(case)))
    assert len(tables) > 40
    assert sum(not taken(table) for table in tables) > len(tables) / 2  # the others contradict themselves, or a file


READERS = ["run", "fit", "draw", "report", "merge", "cite", "table --output law.csv", "export --to c"]


@pytest.mark.parametrize("command", READERS)
def test_no_command_asks_in_words_of_its_own_whether_a_study_can_be_read(command, tmp_path, monkeypatch, capsys):
    """A study that nobody may read was an "invalid value for 'study'", with the help as its way out."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(os, "access", lambda path, *_: str(path) != "ball.toml")
    Path("ball.toml").write_text("", encoding="utf-8")
    name, *options = command.split()
    assert main([name, "ball.toml", *options]) == 2
    assert "the study is empty" in capsys.readouterr().err
