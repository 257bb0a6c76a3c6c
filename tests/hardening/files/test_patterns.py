"""Regular expressions take a time in proportion to the text, whatever it holds."""

from __future__ import annotations

import ast
import functools
import importlib
import re
from pathlib import Path

import bounded
import pytest
from bounded import sentence_within

import winkler

ROOT = Path(winkler.__file__).parent
LONG = 20_000
PIECES = (
    " ", "\t", "\n", "a", "1", "(", "[", "a(", "1 ", "-", ".", "1.", "<", "a ", "_", "1e", "{", "a.", "^", "a/", "'",
    '"', "\\", "# x ",
)  # fmt: skip
TEXTS = (
    *(piece * LONG for piece in PIECES),
    f"# {' ' * LONG}x",
    f"x{' ' * LONG}y",
    f"Block{' ' * LONG}y",
    f"a{'1' * LONG}b",
    f"m^{' ' * LONG}x",
)


def used():
    """Return each compiled pattern of a module, and the methods by which the modules that know it use it."""
    origins, methods = {}, {}
    for path in ROOT.rglob("*.py"):
        module = ".".join(path.relative_to(ROOT.parent).with_suffix("").parts)
        tree = ast.parse(path.read_text(encoding="utf-8"))
        known = {
            name.id: module
            for node in tree.body
            if isinstance(node, ast.Assign) and ast.unparse(node.value).startswith("re.compile(")
            for name in node.targets
        }
        origins |= {(module, name): set() for name in known}
        known |= {one.name: node.module for node in tree.body if isinstance(node, ast.ImportFrom) for one in node.names}
        for node in ast.walk(tree):
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in known:
                methods.setdefault((known[node.value.id], node.value.id), set()).add(node.attr)
    return {
        (module, name): (getattr(importlib.import_module(module), name), methods.get((module, name), set()))
        for module, name in origins
    }


def applied(pattern, methods, texts):
    for text in texts:
        given = text.encode() if isinstance(pattern.pattern, bytes) else text
        for method in methods & {"match", "fullmatch", "search", "split"}:
            getattr(pattern, method)(given)
        if methods & {"sub", "subn", "findall", "finditer"}:
            pattern.findall(given)


@pytest.mark.slow
def test_no_pattern_of_a_module_takes_long():
    found = used()
    assert sum(bool(methods) for _, methods in found.values()) > 50
    slow = {}
    items = list(found.items())
    for few in (items[first::8] for first in range(8)):
        if not sentence_within(lambda few=few: [applied(*one, TEXTS) for _, one in few]):  # all within the time of one
            continue
        for (module, name), (pattern, methods) in few:
            end = sentence_within(functools.partial(applied, pattern, methods, TEXTS))
            if end:
                slow[f"{module}.{name}"] = (pattern.pattern, end)
    assert slow == {}


@pytest.mark.slow
def test_a_pattern_that_takes_long_is_seen(monkeypatch):
    monkeypatch.setattr(bounded, "PROCESSOR", 1)
    assert sentence_within(lambda: applied(re.compile(r"\s*x"), {"search"}, [" " * 100_000])).startswith("ended by")
