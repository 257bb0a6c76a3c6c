"""The tree of errors, suggestions, and the order of standings."""

from __future__ import annotations

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
