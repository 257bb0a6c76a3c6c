"""Fourteen tasks of practitioners as the manual records them: at most three commands from a question to a number."""

from __future__ import annotations

import re
import shlex
import shutil
from pathlib import Path

import pytest

from winkler.cli import main

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "tutorials" / "tasks.md").read_text(encoding="utf-8")
TASKS = dict(re.findall(r"^## (.+?)\n\n```console\n(.+?)```", PAGE, flags=re.MULTILINE | re.DOTALL))
FIRST = 3
"""Rows of a search among which the answer stands."""

SHOWN_LETTERS = 60
"""Of a row of a search."""


def plain(text):
    return " ".join(text.split())


def test_there_are_fourteen_tasks_of_at_most_three_commands():
    assert len(TASKS) == PAGE.count("\n## ") == 14
    assert all(block.count("$ winkler ") <= 3 for block in TASKS.values())


@pytest.mark.parametrize("question", TASKS)
def test_a_task_is_solved_as_the_page_says(question, tmp_path, monkeypatch, capsys):
    shutil.copytree(ROOT / "examples" / "data", tmp_path / "examples" / "data")
    monkeypatch.chdir(tmp_path)
    for entry in TASKS[question].split("$ winkler ")[1:]:
        command, *lines = entry.strip().splitlines()
        words = shlex.split(command)
        assert main(words) == 0
        captured = capsys.readouterr()
        shown = plain(captured.out + captured.err)
        is_search = words[0] == "show" and "--write" not in words
        for line in lines:
            assert (line[:SHOWN_LETTERS] if is_search else line) in shown  # the table breaks long descriptions
        if is_search:
            rows = re.findall(r"^ *(problem|task|medium|bed|profile|load|law) +(\w+)", captured.out, flags=re.MULTILINE)
            assert tuple(lines[0].split()[:2]) in rows[:FIRST]
