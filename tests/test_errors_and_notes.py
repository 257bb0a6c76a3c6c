"""The tree of errors, suggestions, and the order of standings."""

from __future__ import annotations

import ast
import pickle
import re

import pytest

import winkler as wk
from winkler.errors import suggest
from winkler.validity import worst


def test_the_tree():
    for error, python, code in (
        (wk.InvalidInput, ValueError, 2),
        (wk.NotConverged, ArithmeticError, 3),
        (wk.OutsideValidity, ValueError, 4),
    ):
        assert issubclass(error, wk.WinklerError)
        assert issubclass(error, python)
        assert error.exit_code == code
    assert wk.WinklerError.exit_code == 1
    assert not issubclass(wk.OutsideValidity, wk.InvalidInput)


@pytest.mark.parametrize(
    ("word", "expected"),
    [("sphre", " (did you mean 'sphere'?)"), ("radious", " (did you mean 'radius'?)"), ("xyz", ""), ("", "")],
)
def test_suggestions(word, expected):
    assert suggest(word, ["sphere", "radius", "cone"]) == expected
    assert suggest(word, []) == ""


def test_the_worst_of_notes():
    notes = {standing: wk.Note(wk.Assumption.SHAPE, standing, "a", "b") for standing in wk.Standing}
    assert worst([]) is wk.Standing.EXACT
    assert worst(notes.values()) is wk.Standing.OUTSIDE
    assert worst([notes[wk.Standing.EXACT], notes[wk.Standing.ASYMPTOTIC]]) is wk.Standing.ASYMPTOTIC
    assert worst([notes[wk.Standing.APPROXIMATE], notes[wk.Standing.ASYMPTOTIC]]) is wk.Standing.APPROXIMATE
    assert str(notes[wk.Standing.EXACT]) == "exact: a [b]"


@pytest.mark.parametrize("thing", [object(), lambda: 0, [object()]])
def test_a_message_states_no_place_in_memory(thing):
    """It differs from run to run: `<object object at 0x7fa58826e680>`."""
    for refused in (wk.Sphere, wk.Force, wk.Coulomb, wk.Formula, lambda given: wk.Elastic(given, 0.3), wk.read_profile):
        with pytest.raises(wk.InvalidInput) as error:
            refused(thing)
        assert " at 0x" not in str(error.value)
        assert "\n" not in str(error.value)
        again = pickle.loads(pickle.dumps(error.value))
        assert (type(again), str(again)) == (wk.InvalidInput, str(error.value))


RESIDUE = re.compile(r"mismatch|misfit|residual|uncertainty|\bleft\b")


def test_no_note_has_one_standing_whatever_a_solver_left(root):
    """A part that is stated decides on the standing, and it is one of the answer: no kelvin, newtons or metres."""
    fixed, absolute = [], []
    for path in sorted((root / "src" / "winkler").rglob("*.py")):
        for call in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not (isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id == "Note"):
                continue
            standing, statement = call.args[1:3] if len(call.args) > 2 else (None, None)
            texts = (
                [text.values for text in ast.walk(statement) if isinstance(text, ast.JoinedStr)] if statement else []
            )
            for pieces in texts:
                for number, after in zip(pieces, [*pieces[1:], ast.Constant("")], strict=True):
                    if isinstance(number, ast.FormattedValue) and RESIDUE.search(ast.unparse(number.value)):
                        place = f"{path.name}:{call.lineno}"
                        if isinstance(standing, ast.Attribute):
                            fixed.append(place)
                        words = after.value if isinstance(after, ast.Constant) else ""
                        if re.match(r" (K|N|m|Pa|W|J)\b", str(words)):
                            absolute.append(place)
    assert fixed == []
    assert absolute == []
