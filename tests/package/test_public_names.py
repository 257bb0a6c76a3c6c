"""The public names are pinned: a new one is a decision, a lost one breaks somebody's script."""

from __future__ import annotations

from pathlib import Path

import winkler

PINNED = Path(__file__).with_name("public_names.txt")


def test_the_public_names_are_the_pinned_ones():
    pinned = PINNED.read_text(encoding="utf-8").split()
    assert sorted(winkler.__all__) == pinned, (
        "a change of the public names goes into tests/package/public_names.txt too"
    )


def test_the_pinned_list_is_sorted_and_has_no_doubles():
    pinned = PINNED.read_text(encoding="utf-8").split()
    assert pinned == sorted(set(pinned))


def test_every_public_name_has_a_value():
    for name in winkler.__all__:
        assert getattr(winkler, name) is not None, name


def test_an_unknown_name_is_refused():
    assert not hasattr(winkler, "Hertz")
