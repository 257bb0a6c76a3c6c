"""Studies in addresses, and the steps of undo, without a browser."""

from __future__ import annotations

import base64
import re
import zlib

import pytest
import tomli_w

from winkler.study.language.catalogue import CATALOGUE
from winkler.values.errors import InvalidInput
from winkler.web.form.form import initial_table
from winkler.web.form.link import LONGEST_LINK, MOST_TEXT, code_of, study_of
from winkler.web.form.taken import taken
from winkler.web.form.undo import MOST_STATES, UndoStates


def packed(content):
    return base64.urlsafe_b64encode(content).decode().rstrip("=")


def test_each_example_fits_into_an_address():
    long = {}
    for kind in CATALOGUE["problem"]:
        text = tomli_w.dumps(initial_table(kind))
        code = code_of(text)
        assert re.fullmatch(r"[\w-]+", code, re.ASCII)
        assert study_of(code) == text
        if len(code) > 2000:
            long[kind] = len(code)
    assert long == {}
    assert LONGEST_LINK > 2000


@pytest.mark.parametrize(
    "code",
    [
        *("", "x", "what?", "../../etc", "ä", code_of("title = 'a ball'")[:-3]),
        *(packed(b"plain"), packed(zlib.compress(b"\xff\xfe")), packed(zlib.compress(b"a") + b"more")),
    ],
)
def test_an_address_that_was_cut_is_refused(code):
    with pytest.raises(InvalidInput, match="holds no whole study"):
        study_of(code)


def test_an_address_that_unpacks_to_gigabytes_is_refused():
    with pytest.raises(InvalidInput, match="too long"):
        study_of(packed(zlib.compress(b" " * (MOST_TEXT + 1))))


@pytest.mark.parametrize(
    "text", ["problem = 3", "[problem]\nkind = 'nothing'", "title = 1", "[problem]\nkind = 3", "fit = 1"]
)
def test_an_address_without_a_problem_is_refused(text, tmp_path):
    with pytest.raises(InvalidInput):
        taken(text, tmp_path)


class Clock:
    now = 0.0

    def __call__(self):
        return self.now


def test_undo_and_redo():
    clock = Clock()
    steps = UndoStates(clock)
    assert not steps.can_undo
    for text in "abc":
        clock.now += 10.0
        assert steps.keep(text, value=True)
    assert not steps.keep("c", value=True)
    assert (steps.undo(), steps.undo(), steps.undo()) == ("b", "a", "a")
    assert not steps.can_undo
    assert steps.redo() == "b"
    assert steps.can_redo
    clock.now += 10.0
    steps.keep("d", value=False)
    assert not steps.can_redo
    assert (steps.undo(), steps.undo()) == ("b", "a")


def test_a_slider_that_moves_is_one_step():
    clock = Clock()
    steps = UndoStates(clock)
    steps.keep("begin", value=False)
    for place in range(20):
        clock.now += 0.2
        steps.keep(f"slid {place}", value=True)
    clock.now += 0.2
    steps.keep("another kind", value=False)
    assert (steps.undo(), steps.undo()) == ("slid 19", "begin")
    steps.keep("slid after undo", value=True)
    assert steps.undo() == "begin"


def test_the_oldest_states_go_first():
    steps = UndoStates(Clock())
    for place in range(MOST_STATES + 5):
        steps.keep(str(place), value=False)
    assert len(steps.states) == MOST_STATES
    while steps.can_undo:
        steps.undo()
    assert steps.undo() == "5"
