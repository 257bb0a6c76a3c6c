"""What one field may hold is its type: no class tests again what `@value` compares."""

from __future__ import annotations

import ast
import math

import pytest

from winkler.values.checks.number_checks import Positive
from winkler.values.errors import InvalidInput
from winkler.values.value import value

NUMBERS = {"bool", "int", "float"}


def repeated(check: ast.FunctionDef) -> list[str]:
    """Return the tests of a ``__post_init__`` whether a field of its own is a number."""
    calls = [node for node in ast.walk(check) if isinstance(node, ast.Call) and len(node.args) == 2]
    return [
        ast.unparse(call)
        for call in calls
        if isinstance(call.func, ast.Name)
        and call.func.id == "isinstance"
        and ast.unparse(call.args[0]).startswith("self.")
        and {node.id for node in ast.walk(call.args[1]) if isinstance(node, ast.Name)} & NUMBERS
    ]


def test_no_class_tests_whether_its_fields_are_numbers(pages):
    found = {
        page.name: repeated(node)
        for page in pages
        if "__post_init__" in page.text
        for node in page.nodes
        if isinstance(node, ast.FunctionDef) and node.name == "__post_init__" and repeated(node)
    }
    assert found == {}
    sample = "def __post_init__(self):\n    isinstance(self.young, int | float)"
    assert repeated(ast.parse(sample).body[0]) == ["isinstance(self.young, int | float)"]


@value
class HalfKnown:
    """One of its types is a name that its module lacks when it runs."""

    first: math.no_such_name
    second: Positive
    third: float


def test_a_type_that_is_not_there_hides_no_other():
    assert HalfKnown("anything", 2.0, 3).second == 2.0
    with pytest.raises(InvalidInput, match="second is -2"):
        HalfKnown("anything", -2.0, 3.0)
