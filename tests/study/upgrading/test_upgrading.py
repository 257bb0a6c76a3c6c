"""The upgrade page, tried on all that version 0.2 had: its studies and cases, its kinds, its public names.

A study whose text changed since is kept here as 0.2 had it; one that did not is solved by the tests of the examples.
"""

from __future__ import annotations

import hashlib
import re
import tomllib
from pathlib import Path

import pytest

import winkler
from winkler.study.batch.run import run
from winkler.study.language.catalogue import FORMER, kinds
from winkler.study.language.reading import parse_study, read_study

ROOT = Path(__file__).resolve().parents[3]
KEPT = Path(__file__).with_name("version_0_2")
BEFORE = tomllib.loads((KEPT / "contents.toml").read_text(encoding="utf-8"))
TEXTS = {path.name: path for path in KEPT.rglob("*.toml") if path.name != "contents.toml"}
CHANGED = sorted(TEXTS)


def digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()[:16] if path.is_file() else ""


def table(title: str) -> list[tuple[str, str]]:
    """Return the first two cells of the rows below a heading of the section "From 0.2"."""
    page = (ROOT / "docs" / "changelog" / "upgrading.md").read_text(encoding="utf-8")
    section = page.partition("## From 0.2")[2].partition("\n## ")[0]
    rows = section.partition(f"### {title}")[2].partition("\n### ")[0]
    found = [line.strip("|").split("|") for line in rows.splitlines() if line.startswith("| ")]
    return [(old.strip(), new.strip()) for old, new, *_ in found[1:]]


def test_each_study_of_0_2_is_tried_as_it_was():
    assert len(BEFORE["studies"]) == 376
    texts = {path: {digest(ROOT / path), digest(TEXTS.get(Path(path).name, KEPT))} for path in BEFORE["studies"]}
    lost = [path for path, stated in BEFORE["studies"].items() if stated not in texts[path]]
    assert lost == [], "keep the text that version 0.2 had in tests/study/upgrading/version_0_2, and mend the page"


@pytest.mark.slow
@pytest.mark.parametrize("name", CHANGED)
def test_a_study_that_changed_since_answers_the_same_in_its_old_words(name):
    [now] = [ROOT / path for path in BEFORE["studies"] if Path(path).name == name]
    text = TEXTS[name].read_text(encoding="utf-8")
    assert text != now.read_text(encoding="utf-8")
    old, new = run(parse_study(text, file=name, folder=now.parent)), run(read_study(now))
    assert old.failed == ()
    assert all(verdict.passed for verdict in old.verdicts)
    columns = [{column.name: list(column.content) for column in outcome.table()} for outcome in (old, new)]
    assert columns[0] == columns[1]


def test_kinds_of_0_2_are_there_or_on_the_page():
    stated = {old.strip("`"): new.strip("`") for old, new in table("Studies")}
    assert stated == FORMER
    assert set(BEFORE["kinds"]) - set(kinds()) == set(stated)


def test_public_names_of_0_2_are_there_or_on_the_page():
    gone = {name for name in BEFORE["names"] if not hasattr(winkler, name)}
    rows = {re.match(r"`(\w+)", old)[1]: re.findall(r"`(\w+)", new) for old, new in table("Python")}
    assert {name for name in rows if name in BEFORE["names"]} == gone
    assert [name for name in gone if not hasattr(winkler, rows[name][0])] == []
