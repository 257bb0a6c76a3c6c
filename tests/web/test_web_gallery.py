"""The pictures of the app in the manual are those that one script takes; each chapter has one."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

from winkler.study.chapters.contents import CHAPTERS
from winkler.study.language.reading import parsed

DOCS = Path(__file__).parents[2] / "docs"
SCRIPT = runpy.run_path(str(DOCS / "app" / "picture_app.py"), run_name="picture_app")
SIGNATURE = b"\x89PNG\r\n\x1a\n"
LARGEST, IN_ALL = 150_000, 1_500_000
"""Bytes."""


def test_the_gallery_shows_what_the_script_takes():
    states = SCRIPT["STATES"]
    names = sorted(state.name for state in states)
    page = (DOCS / "app.md").read_text(encoding="utf-8")
    assert sorted(re.findall(r"\]\(app/(\w+)\.png\)", page)) == names
    contents = {path.stem: path.read_bytes() for path in (DOCS / "app").glob("*.png")}
    assert sorted(contents) == names
    for state in states:
        content = contents[state.name]
        assert content.startswith(SIGNATURE), state.name
        assert int.from_bytes(content[16:20], "big") == state.width, state.name
        assert int.from_bytes(content[20:24], "big") == state.height, state.name
        assert len(content) < LARGEST, state.name
    assert sum(map(len, contents.values())) < IN_ALL


def test_each_chapter_has_a_picture_of_one_of_its_kinds():
    kinds = {}
    for chapter in CHAPTERS:
        kinds.setdefault(chapter.physics, set()).update(chapter.answers)
    shown = {state.chapter: SCRIPT["text_of"](state.study) for state in SCRIPT["STATES"] if state.chapter}
    assert set(shown) == set(kinds)
    for chapter, text in shown.items():
        assert parsed(text, chapter)["problem"]["kind"] in kinds[chapter], chapter
