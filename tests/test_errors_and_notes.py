"""The tree of errors, suggestions, and the order of standings."""

from __future__ import annotations

import ast
import pickle
import re

import numpy as np
import pytest

import winkler as wk
from winkler.study.language.compared.alternatives import alternatives
from winkler.values.errors import suggest
from winkler.values.validity import worst


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


def _errors(root=wk.WinklerError):
    return [root, *(error for kind in root.__subclasses__() for error in _errors(kind))]


BREAKS = [chr(code) for code in range(0x3000) if len(f"a{chr(code)}b".splitlines()) > 1]
"""Found by Python, whose `str.splitlines` is what reports and tables cut texts by."""


def test_each_sentence_of_an_error_is_one_line():
    """The `repr` of an array, and texts of users and libraries, have line breaks."""
    assert len(_errors()) >= 6
    assert len(BREAKS) >= 10
    rows = np.arange(4.0).reshape(2, 2)
    for kind in _errors():
        for given in (f"{rows!r}", f"{rows}", *(f"steel{mark} no. 2" for mark in BREAKS)):
            error = kind(f"force is {given}; give one number.", "depth is missing; add it.")
            first, second = str(error).splitlines()
            assert first.split() == f"force is {given}; give one number.".split()
            assert second == "depth is missing; add it."
            assert error.args == (first, second)
            again = pickle.loads(pickle.dumps(error))
            assert (type(again), str(again)) == (kind, str(error))


def test_a_reworded_error_keeps_its_sentences_and_notes():
    error = wk.OutsideValidity("one.", "two.")
    error.add_note("where it came from")
    reworded = error.reworded("here: {}".format)
    assert (type(reworded), str(reworded)) == (wk.OutsideValidity, "here: one.\nhere: two.")
    assert reworded.__notes__ == ["where it came from"]


def test_matrices_given_for_numbers_are_refused_in_one_line():
    for refused in (wk.Sphere, wk.Cone, wk.Coulomb, lambda given: wk.Elastic(given, 0.3)):
        with pytest.raises(wk.InvalidInput) as error:
            refused(np.arange(4.0).reshape(2, 2))
        assert len(str(error.value).splitlines()) == 1


def test_each_mistake_of_a_model_has_its_name_in_front():
    error = wk.InvalidInput("fit.toml: a is 1; give 2.", "fit.toml: b is 1; give 2.")

    def study_of(raw):
        raise error

    with pytest.raises(wk.InvalidInput) as raised:
        alternatives({"problem": {"a": 0}, "fit": {"models": {"cone": {"problem.a": 1}}}}, study_of, at="fit.toml: ")
    assert str(raised.value).splitlines() == [
        "fit.toml: fit.models.cone: a is 1; give 2.",
        "fit.toml: fit.models.cone: b is 1; give 2.",
    ]


RESIDUE = re.compile(r"mismatch|misfit|residual|uncertainty|\bleft\b")


def test_no_note_has_one_standing_whatever_a_solver_left(root):
    """A part that is stated decides on the standing, and it is one of the answer: no kelvin, newtons or metres."""
    fixed, absolute = [], []
    for path in sorted((root / "src" / "winkler").rglob("*.py")):
        text = path.read_text(encoding="utf-8")
        for call in ast.walk(ast.parse(text)) if "Note(" in text and RESIDUE.search(text) else ():
            if not (isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id == "Note"):
                continue
            standing, statement = call.args[1:3] if len(call.args) > 2 else (None, None)
            texts = (
                [part.values for part in ast.walk(statement) if isinstance(part, ast.JoinedStr)] if statement else []
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
