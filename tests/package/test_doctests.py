"""The numbers in the docstrings are true."""

from __future__ import annotations

import doctest
import importlib
from pathlib import Path

import pytest

import winkler

SOURCE = Path(winkler.__file__).parent


def module_of(page: Path) -> str:
    """Return the name of the module in a source file."""
    parts = page.relative_to(SOURCE.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


EXEMPLARY = [module_of(page) for page in sorted(SOURCE.rglob("*.py")) if ">>>" in page.read_text(encoding="utf-8")]
"""Modules with examples; of the others there is nothing to run."""
LONG = {
    *("winkler.problems.wear.sliding", "winkler.problems.wear.line_sliding", "winkler.problems.viscoelastic.adhesion"),
    *("winkler.problems.wear.fretting", "winkler.problems.wear.line_fretting", "winkler.media.layered.depth_graded"),
    *("winkler.problems.surface_rolling.start", "winkler.problems.surface_friction.reduced"),
    *("winkler.problems.surface_friction.joint", "winkler.problems.surface_adhesion.adhesion"),
}
"""Examples that march for seconds; they are slow tests."""


@pytest.mark.parametrize(
    "module_name", [pytest.param(name, marks=pytest.mark.slow) if name in LONG else name for name in EXEMPLARY]
)
def test_doctests(module_name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    module = importlib.import_module(module_name)
    result = doctest.testmod(module, optionflags=doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS)
    assert result.failed == 0, f"{result.failed} of {result.attempted} examples of {module_name} failed, see above"


def test_all_modules_with_doctests_are_run(modules):
    finder = doctest.DocTestFinder(exclude_empty=True)
    found = {module.__name__ for module in modules if any(test.examples for test in finder.find(module))}
    assert LONG <= found <= set(EXEMPLARY)
    assert len(found) > 100
