"""The page on study files is right: whole studies run, fragments are TOML, every kind and key is named."""

from __future__ import annotations

import re
import tomllib

import pytest

from winkler.cli import main
from winkler.study.batch.run import run
from winkler.study.language.grammar import SECTIONS
from winkler.study.language.reading import parse_study

BLOCK = re.compile(r"(<!-- study -->\n)?^```toml\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@pytest.fixture(scope="module")
def page(root) -> str:
    return (root / "docs" / "study-files.md").read_text(encoding="utf-8")


def test_whole_studies_run_and_hold_what_they_expect(page):
    whole = [text for mark, text in BLOCK.findall(page) if mark]
    assert len(whole) >= 2
    for text in whole:
        outcome = run(parse_study(text))
        assert outcome.failed == ()
        assert all(verdict.passed for verdict in outcome.verdicts)


def test_fragments_are_toml(page):
    fragments = [text for mark, text in BLOCK.findall(page) if not mark]
    assert len(fragments) >= 6
    for text in fragments:
        keys = re.findall(r"^(\w+) = ", text, re.MULTILINE)
        for part in [line for line in text.splitlines() if line] if len(keys) != len(set(keys)) else [text]:
            assert tomllib.loads(part)


def test_every_key_is_on_the_page(page):
    for section, keys in SECTIONS.items():
        for key in keys:
            assert key.strip('"') in page, f"{section}: {key}"


def test_commands_and_codes_are_on_the_page_of_the_command_line(root, capsys):
    page = (root / "docs" / "command-line.md").read_text(encoding="utf-8")
    for command in ("run", "new", "show", "draw", "cite", "validate"):
        assert f"winkler {command}" in page
        assert main([command, "--help"]) == 0
        options = set(re.findall(r"--[a-z]{3,}", capsys.readouterr().out)) - {"--help"}
        if command in ("run", "validate"):
            assert options <= set(re.findall(r"--[a-z]{3,}", page))
    for code in (0, 1, 2, 3, 4, 70, 130):
        assert re.search(rf"^\| {code}[ ,]", page, re.MULTILINE)
