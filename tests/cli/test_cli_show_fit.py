"""``winkler show fit``: all keys, corrections and flags; and the suggestion for a wrong key."""

from __future__ import annotations

import json
import re
from pathlib import Path

import winkler.fitting
from winkler.cli import main
from winkler.cli.show_fit import EXAMPLE
from winkler.study.language.correcting import CORRECTIONS
from winkler.study.language.fit_grammar import fit_form
from winkler.study.language.fit_reading import parse_fit_study
from winkler.study.language.fit_study import FITTED


def test_it_shows_all_keys_models_corrections_and_flags(capsys):
    """The flags are those that the package raises, found in its source."""
    assert main(["show", "fit"]) == 0
    shown = capsys.readouterr().out
    assert main(["show", "fit", "--json"]) == 0
    content = json.loads(capsys.readouterr().out)
    assert {row["key"] for row in content["[fit]"]} == set(fit_form().model_fields)
    assert [row["kind"] for row in content["models"]] == list(FITTED)
    assert {row["name"] for row in content["corrections"]} == set(CORRECTIONS)
    assert "see docs" not in str(content["corrections"])
    sources = "".join(path.read_text(encoding="utf-8") for path in Path(winkler.fitting.__path__[0]).rglob("*.py"))
    raised = set(re.findall(r'Flag\(\s*"(\w+)"', sources))
    assert raised >= {"misfit", "memory", "units"}
    assert {row["flag"] for row in (*content["flags"], *content["refused"])} == raised
    assert all(name in shown for name in (*raised, *FITTED, "frame_stiffness"))


def test_its_example_is_a_study(tmp_path):
    (tmp_path / "gel").mkdir()
    (tmp_path / "gel/a.csv").write_text("depth [nm], force [nN]\n0, 0\n", encoding="utf-8")
    assert [free.key for free in parse_fit_study(EXAMPLE, folder=tmp_path).free][1:] == ["contact_point", "baseline"]


def test_a_wrong_key_and_a_wrong_word_get_a_suggestion(tmp_path, capsys):
    (tmp_path / "study.toml").write_text(EXAMPLE.replace("part =", "prat ="), encoding="utf-8")
    assert main(["fit", str(tmp_path / "study.toml")]) == 2
    assert "did you mean 'part'?" in capsys.readouterr().err
    assert main(["show", "fti"]) == 2
    assert "did you mean 'fit'?" in capsys.readouterr().err
