"""The JSON schema of studies: it takes what the reader takes, and marks what an editor can know to be wrong."""

from __future__ import annotations

import json
import re
import tomllib
from pathlib import Path

import jsonschema
import pytest

from winkler.cli import main
from winkler.study.json_schema import DIALECT, json_schema
from winkler.study.language.json_forms import quantity as form_of
from winkler.study.language.template import SCHEMA_FILE, template
from winkler.values.errors import WinklerError
from winkler.values.units import quantity

TREE = Path(__file__).parents[3]
STUDIES = [
    path
    for folder in ("examples/studies", "src/winkler/cases")
    for path in sorted((TREE / folder).rglob("*.toml"))
    if "[function]" not in path.read_text(encoding="utf-8")
]


@pytest.fixture(scope="module")
def taken():
    """What the schema takes."""
    whole = json_schema()
    jsonschema.Draft7Validator.check_schema(whole)
    return jsonschema.Draft7Validator(whole).is_valid


UNITS = ("m", "N", "Pa", "N/m", "J/m^2", "1/m", "1/Pa", "rad", "K", "W/(m K)", "m^2/s", "ohm m", "1/s")
WRITTEN = (
    "10 mm", "10mm", " 1e-3 m ", "-.5 µm", "3 um", "1 inch", "2 Å", "70.3 deg", "20°", "5 N", "3 kN m", "1 lbf",
    "2e3 GPa", "1 psi", "1 N/mm^2", "40 mJ/m^2", "40 mN/m",
    "0.1 1/mm", "2 mm^-1", "1 1/kPa", "300 K", "20 degC", "45 W/(m K)",
    "12 mm²/s", "16 nohm m", "50 Hz", "10", "3 kg", "1 ms", "2 hour", "5 V", "1 percent", "10,5 mm", "mm", "ten mm", "",
)  # fmt: skip


@pytest.mark.parametrize("unit", UNITS)
def test_no_pattern_refuses_what_the_reader_takes_and_bare_symbols_of_another_dimension_are_refused(unit):
    pattern = form_of(unit)["pattern"]
    taken, refused = [], []
    for text in WRITTEN:
        try:
            quantity(text, unit, what="it")
            taken.append(text)
        except WinklerError:
            refused.append(text)
    assert [text for text in taken if not re.search(pattern, text)] == []
    assert taken
    marked = [text for text in refused if not re.search(pattern, text)]
    others = {"10", "3 kg", "5 V", "1 percent", "10,5 mm", "mm", "ten mm", ""}
    assert others <= set(marked)


def test_a_number_without_dimension_is_bare_or_a_percentage():
    for content in (0.3, 3, "0.3", "30 %", "3 percent"):
        jsonschema.validate(content, form_of(""))
    for content in ([0.3], "0.3 GPa", "3 mm"):
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate(content, form_of(""))


def test_signs_and_bounds_are_marked_where_the_class_states_them():
    taken = jsonschema.Draft7Validator(json_schema("elastic")).is_valid
    assert taken({"kind": "elastic", "young": "210 GPa", "poisson": 0.3})
    assert taken({"kind": "elastic", "young": "+210 GPa", "poisson": -0.3})
    for wrong in ({"young": "-210 GPa"}, {"poisson": 0.6}, {"poisson": -1.0}):
        assert not taken({"kind": "elastic", "young": "210 GPa", "poisson": 0.3, **wrong})


def test_the_schema_of_a_kind_describes_its_keys():
    sphere = json_schema("sphere")
    assert sphere["$schema"] == DIALECT
    assert sphere["required"] == ["kind"]
    assert sphere["properties"]["curvature_radius"]["description"].startswith("R [m]: radius of curvature")
    taken = jsonschema.Draft7Validator(sphere).is_valid
    assert taken({"kind": "sphere", "curvature_radius": "10 mm"})
    assert taken({"kind": "sphere", "diameter": "20 mm"})
    for wrong in (
        {"curvature_radius": "10 kg"},
        {"curvature_radius": 0.01},
        {"radius": "10 mm"},
        {"diameter": 0.02},
        {},
    ):
        assert not taken({"kind": "sphere", **wrong})


@pytest.mark.parametrize(
    "third", [pytest.param(0, marks=pytest.mark.slow), *(pytest.param(k, marks=pytest.mark.long) for k in (1, 2))]
)
def test_every_study_that_winkler_ships_is_taken(taken, third):
    refused = [path.name for path in STUDIES[third::3] if not taken(tomllib.loads(path.read_text(encoding="utf-8")))]
    assert len(STUDIES) > 300
    assert refused == []


@pytest.mark.slow
def test_every_study_that_new_writes_is_taken(taken):
    from winkler.study.language.catalogue import CATALOGUE

    assert [name for name in CATALOGUE["problem"] if not taken(tomllib.loads(template(name)))] == []


def test_the_command_writes_the_file_that_new_names(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["schema", "cone", "--output", "cone.json"]) == 0
    assert json.loads((tmp_path / "cone.json").read_text(encoding="utf-8"))["properties"]["kind"]["const"] == "cone"
    assert template("indentation").startswith(f"#:schema {SCHEMA_FILE}\n")
    assert main(["schema", "cone", "--output", "cone.json"]) == 2
    assert main(["schema", "conne"]) == 2
    assert "(did you mean 'cone'?)" in capsys.readouterr().err
