"""The page on the architecture is that of the imports, and folders and files keep a size that can be read."""

from __future__ import annotations

import ast
import importlib.util
import re
from collections import Counter

import pytest
from project_files import project_files

MOST_FILES = 25
"""In one folder of the package; the literature cases are data."""
MOST_ENTRIES = 24
"""At the top of the package, folders and files."""


def drawing(root):
    spec = importlib.util.spec_from_file_location("draw_architecture", root / "docs" / "draw_architecture.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.slow
def test_the_page_is_that_of_the_imports(root):
    written = drawing(root)
    hint = "run python docs/draw_architecture.py"
    assert (root / "docs" / "architecture.md").read_text(encoding="utf-8") == written.page(), hint
    assert (root / "docs" / "figures" / "architecture.svg").read_text(encoding="utf-8") == written.picture(), hint


def test_the_way_of_a_study_names_what_is_there(root):
    source = root / "src" / "winkler"
    named = re.findall(r"`([a-z_]+(?:\.[a-z_]+)+)`", drawing(root).HEAD)
    assert len(named) > 8
    places = {name: source.joinpath(*name.split(".")) for name in named if not name.endswith(".toml")}
    assert [name for name, place in places.items() if not (place.is_dir() or place.with_suffix(".py").is_file())] == []


def test_no_folder_holds_too_many_files(root):
    full: dict[str, int] = {}
    for top in ("src/winkler", "tests", "examples", "docs"):
        counts = Counter(path.parent.relative_to(root) for path in project_files(root / top))
        full |= {
            folder.as_posix(): count
            for folder, count in counts.items()
            if count > MOST_FILES and not {"cases", "numbers"} & set(folder.parts)
        }
    assert full == {}


def test_the_top_of_the_package_can_be_read_at_once(root):
    source = root / "src" / "winkler"
    entries = {path.relative_to(source).parts[0] for path in project_files(source)}
    assert len(entries) <= MOST_ENTRIES


def test_one_name_means_one_class(pages):
    places = {}
    for page in pages:
        for node in page.tree.body:
            if isinstance(node, ast.ClassDef):
                places.setdefault(node.name.lstrip("_"), []).append(page.name)
    assert {name: files for name, files in places.items() if len(files) > 1} == {}
