"""Keys name places inside a value: to be read, named, replaced."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.study.language import keys
from winkler.values.errors import InvalidInput

PROBLEM = wk.Indentation(
    wk.Foundation(wk.Paraboloid(1e-3) + wk.Formula("r**4/c", c=2.0), wk.HalfSpace(wk.Elastic(1e9, 0.25))),
    wk.Force(np.array([1.0, 2.0])),
)


@pytest.mark.parametrize(
    ("key", "content", "other"),
    [
        ("load.force.1", 2.0, 7.0),
        ("bed.profile.parts.0.curvature_radius", 1e-3, 5e-3),
        ("bed.profile.parts.1.constants.c", 2.0, 3.0),
        ("bed.profile.parts.1.expression", "r**4/c", "r**6/c"),
        ("bed.medium.second", wk.Rigid(), wk.Elastic(2e9, 0.1)),
        ("bed.medium.first.young", 1e9, 2e9),
    ],
)
def test_read_and_replaced(key, content, other):
    assert keys.content_at(PROBLEM, key) == content
    changed = keys.replaced(PROBLEM, key, other)
    assert keys.content_at(changed, key) == other
    assert changed != PROBLEM
    assert keys.replaced(changed, key, content) == PROBLEM
    assert keys.content_at(PROBLEM, key) == content


def test_what_is_replaced_is_checked_again():
    with pytest.raises(InvalidInput, match=r"young is -1\.0"):
        keys.replaced(PROBLEM, "bed.medium.first.young", -1.0)


@pytest.mark.parametrize(
    ("key", "sentence"),
    [
        ("lod", "the key 'lod': there is no 'lod' (did you mean 'load'?); known are bed, load."),
        ("load.force.2", "the key 'load.force.2': '2' is no place in this list; give a number from 0 to 1."),
        (
            "bed.profile.parts.one",
            "the key 'bed.profile.parts.one': 'one' is no place in this list; give a number from 0 to 1.",
        ),
        ("bed.profile.parts.1.constants.d", "there is no 'd'; known are c."),
        ("bed.medium.second.young", "there is no 'young'; nothing is adjustable there."),
        ("bed.medium.first.young.x", "nothing lies below the part before 'x', which is 1e+09."),
    ],
)
def test_unknown_keys(key, sentence):
    with pytest.raises(InvalidInput) as caught:
        keys.content_at(PROBLEM, key)
    assert str(caught.value).endswith(sentence)


@pytest.mark.parametrize(
    ("key", "symbol", "unit"),
    [
        ("load.force", "F_N", "N"),
        ("bed.medium.first.poisson", r"\nu", ""),
        ("bed.profile.parts.0.curvature_radius", "R", "m"),
        ("bed.profile.parts.1.constants.c", "c", ""),
        ("bed.profile", "f(r)", None),
    ],
)
def test_words_come_from_the_glossary(key, symbol, unit):
    message = keys.word_at(PROBLEM, key)
    assert (message.symbol, message.unit) == (symbol, unit)


def test_labels_are_short():
    assert keys.label(1.23456789e-5) == "1.23457e-05"
    assert keys.label(wk.Cone(1.0)) == "Cone(half_angle=1)"
    assert keys.label("text") == "text"
