"""The numbers in the docstrings are true."""

from __future__ import annotations

import doctest
import importlib


def test_doctests(module_name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    module = importlib.import_module(module_name)
    result = doctest.testmod(module, optionflags=doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS)
    assert result.failed == 0, f"{result.failed} of {result.attempted} examples of {module_name} failed, see above"


def test_there_are_doctests(modules):
    finder = doctest.DocTestFinder(exclude_empty=True)
    assert sum(len(test.examples) for module in modules for test in finder.find(module)) >= 10
