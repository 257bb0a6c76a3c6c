"""The public names: each is a value, and stands once in the page of imports.

What a former version offered is looked for in `tests/study/upgrading`; `tests/cli/second_reading.py` reads each kind of
study in public names.
"""

from __future__ import annotations

import ast
from importlib.resources import files

import winkler


def test_no_name_is_imported_twice():
    page = files(winkler).joinpath("public.py").read_text(encoding="utf-8")
    imports = [line for line in ast.parse(page).body if isinstance(line, ast.ImportFrom)]
    names = [imported.name for line in imports for imported in line.names]
    assert sorted([*names, "__version__"]) == winkler.__all__
    assert len(names) == len(set(names))


def test_every_public_name_has_a_value():
    for name in winkler.__all__:
        assert getattr(winkler, name) is not None, name


def test_an_unknown_name_is_refused():
    assert not hasattr(winkler, "Hertz")
