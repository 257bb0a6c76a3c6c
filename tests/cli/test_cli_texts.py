"""What reaches a terminal: no control characters, characters that the stream can write, infinities in words."""

from __future__ import annotations

import ast
import io
import json
import re
import sys
import unicodedata
from pathlib import Path

import numpy as np
import pytest
from rich.console import Console

import winkler as wk
import winkler.cli
from winkler.cli import main, terminal
from winkler.cli.streams import plain_json, safe, write_line
from winkler.study.batch.outcome import ResultColumn
from winkler.study.batch.run import run
from winkler.study.language.study import Study
from winkler.values.vocabulary import GLOSSARY

SPHERE = """title = "{title}"

[problem]
kind = "constriction"
load = {{ kind = "force", force = ["0 N", "1 N"] }}

[problem.bed]
kind = "foundation"
profile = {{ kind = "paraboloid", curvature_radius = "10 mm" }}
medium = {{ kind = "half_space", first = {{ kind = "elastic", young = "210 GPa", poisson = 0.3 }} }}

[problem.conductors]
kind = "electrical_conductors"
first = {{ kind = "electrical_conductor", resistivity = "15.9 nohm m" }}
second = {{ kind = "electrical_conductor", resistivity = "15.9 nohm m" }}

[output]
figures = []
report = {report}
"""
FIT = """title = "Gel"

[problem]
kind = "indentation"

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "5 um" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 kPa", poisson = 0.5 } }

[fit]
curve = "gel"
part = "approach"

[fit.free]
"problem.bed.medium.first.young" = true

[output]
figures = []
report = false
"""
HARMFUL = ("\x1b[31m", "\x07", "\x9b31m", "\x7f", "\r", "\u202e", "\u2066", "\u2028", "\udc80")


@pytest.fixture
def here(tmp_path, monkeypatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "c.toml").write_text(SPHERE.format(title="5 µm", report="false"), encoding="utf-8")
    return tmp_path


def harmless(text: str) -> bool:
    return not any(letter in "\u202e\u2066\u2028" or unicodedata.category(letter) in ("Cc", "Cs")
                   for letter in text.replace("\n", ""))  # fmt: skip


@pytest.mark.parametrize("harmful", HARMFUL)
def test_control_characters_are_shown_as_escapes(harmful, capsys):
    message = safe(f"a{harmful}b µ\n\t")
    assert harmless(message.replace("\t", ""))
    assert message.encode("utf-8").decode("unicode_escape", "ignore").startswith(f"a{harmful}b")
    write_line(f"a{harmful}b", error=True)
    assert harmless(capsys.readouterr().err)


def test_texts_of_a_study_with_control_characters_are_refused(here, capsys):
    for place in ('title = "a\\u001b]0;x\\u0007"', 'title = "\\u0000"', '"\\u009b" = 1'):
        (here / "x.toml").write_text(f"{place}\n", encoding="utf-8")
        assert main(["run", "x.toml"]) == 2
        message = capsys.readouterr().err
        assert "holds a control character; leave it out, only line breaks and tabs are allowed." in message
        assert harmless(message)


def test_a_title_that_turns_the_line_around_is_written_in_files_alone(here, capsys):
    (here / "c.toml").write_text(SPHERE.format(title="a\\u202eb", report="false"), encoding="utf-8")
    assert main(["run", "c.toml"]) == 0
    assert capsys.readouterr().out.startswith("a\\u202eb\n")
    assert "a\u202eb" in (here / "results" / "c" / "study.toml").read_text(encoding="utf-8")
    assert main(["run", "c.toml", "--json", "--overwrite"]) == 0
    message = capsys.readouterr().out
    assert harmless(message)
    assert json.loads(message)["title"] == "a\u202eb"


@pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="file names are texts there")
def test_names_of_files_reach_tables_as_escapes(here, capsys):
    (here / "gel").mkdir()
    rows = "".join(f"{10 * i - 500}, {max(10 * i - 500, 0) ** 1.5:.3f}\n" for i in range(100))
    for name in (b"a\x1b[2J.csv", b"b\xff.csv"):
        Path("gel", name.decode("utf-8", "surrogateescape")).write_text("depth [nm], force [pN]\n" + rows)
    (here / "gel.toml").write_text(FIT, encoding="utf-8")
    assert main(["fit", "gel.toml"]) == 0
    message = capsys.readouterr().out
    assert "gel/a\\x1b[2J.csv" in message
    assert harmless(message)
    assert main(["fit", "gel.toml", "--json", "--overwrite"]) == 0
    assert json.loads(capsys.readouterr().out)["columns"][0]["values"] == ["gel/a\x1b[2J.csv", "gel/b\\udcff.csv"]


@pytest.mark.parametrize("encoding", ["ascii", "latin-1"])
def test_a_stream_that_knows_few_characters_does_not_raise(encoding, here, monkeypatch):
    streams = []
    for name in ("stdout", "stderr"):
        stream = io.TextIOWrapper(io.BytesIO(), encoding=encoding, errors="strict")
        monkeypatch.setattr(sys, name, stream)
        streams.append(stream)
    assert main(["run", "c.toml"]) == 0
    assert main(["show", "constriction"]) == 0
    assert main(["run", "µ☃.toml"]) == 2
    for stream in streams:
        stream.flush()
    out, err = (stream.buffer.getvalue().decode(encoding) for stream in streams)
    assert out.splitlines()[0] == ("5 um" if encoding == "ascii" else "5 µm")
    assert "?.toml" in err


@pytest.mark.slow
def test_what_is_infinite_is_written_in_words(here, capsys):
    """The resistance without contact: in the table, in JSON, and on the page."""
    (here / "c.toml").write_text(SPHERE.format(title="5 µm", report="true"), encoding="utf-8")
    assert main(["run", "c.toml"]) == 0
    message = capsys.readouterr().out
    assert " infinite " in message
    assert " inf " not in message
    page = (here / "results" / "c" / "report.html").read_text(encoding="utf-8")
    assert "infinite" in page
    assert ">∞" not in page
    (here / "c.toml").write_text(SPHERE.format(title="5 µm", report="false"), encoding="utf-8")
    assert main(["run", "c.toml", "--json", "--overwrite"]) == 0
    answers = json.loads(capsys.readouterr().out, parse_constant=pytest.fail)["answers"]
    resistance = next(one["values"] for one in answers if one["name"] == "resistance")
    assert resistance[0] == "infinite"
    assert resistance[1] > 0.0


def test_what_is_undefined_is_distinguished_from_what_has_no_answer(here, capsys):
    """As the restitution along the surface of bodies that do not move along it, and a point that is refused."""
    column = ResultColumn("lateral_restitution", GLOSSARY["lateral_restitution"], np.array([0.5, np.nan, np.nan]))
    assert terminal._column_texts(column, np.array([False, False, True])) == ("", ["0.5", "undefined", "-"])
    text = (here / "c.toml").read_text(encoding="utf-8").replace('["0 N", "1 N"]', '"1 N"')
    (here / "c.toml").write_text(f'{text}\n[sweep]\n"problem.load.force" = ["1 N", "-1 N"]\n', encoding="utf-8")
    assert main(["run", "c.toml"]) == 4
    message = capsys.readouterr().out
    assert "undefined" not in message
    assert re.search(r"\n +-1 +-", message)


def test_json_knows_no_bare_infinity():
    content = {"a": (float("inf"), -float("inf"), float("nan"), 1.5, "x", True, None), "b": [{"c": 2}]}
    message = json.dumps(plain_json(content), allow_nan=False)
    assert json.loads(message) == {"a": ["infinite", "-infinite", None, 1.5, "x", True, None], "b": [{"c": 2}]}


def test_everything_is_written_in_one_place():
    """No command prints by itself."""
    for path in Path(winkler.cli.__file__).parent.glob("*.py"):
        calls = [node for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(node, ast.Call)]
        names = {node.func.id for node in calls if isinstance(node.func, ast.Name)}
        assert "print" not in names or path.name == "streams.py", path.name
        assert "Console" not in names or path.name == "terminal.py", path.name


def printed(load, width):
    bed = wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.3)))
    outcome = run(Study("loads", wk.Indentation(bed, wk.Force(np.array(load)))))
    out = Console(file=io.StringIO(), width=width)
    terminal.answers(outcome, out)
    return outcome, out.file.getvalue()


def test_a_narrow_table_goes_on_below_and_cuts_no_number():
    outcome, text = printed([1e-5, 2e-5, 1.5e-5], 60)
    assert "…" not in text
    assert max(len(line) for line in text.splitlines()) <= 60
    headings = [line for line in text.splitlines() if any(name in line.split() for name in outcome.answers)]
    assert len(headings) > 1
    assert {line.split()[0] for line in headings} == {outcome.answers[0]}
    told = " ".join(headings).split()
    assert all(told.count(name) == 1 for name in outcome.answers[1:])


def test_a_history_ends_in_the_greatest_numbers():
    _, text = printed([1e-5, 2e-5, 1.5e-5], 200)
    (end,) = [line.split() for line in text.splitlines() if "greatest" in line]
    rows = [line.split() for line in text.splitlines() if line.strip() and line.split()[0][0].isdigit()]
    assert len(rows) == 3
    assert end[1:] == rows[1]
    assert "greatest" not in printed([1e-5, 2e-5], 200)[1]
