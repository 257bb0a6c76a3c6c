"""Validity notes of an indentation: each limit is noted when it is passed, and not before."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.problems.normal import overlap, single_contact
from winkler.values.validity import worst

STEEL = wk.Elastic(210e9, 0.3)


def validity(profile, load, medium=None):
    return wk.Indentation(wk.Foundation(profile, medium or wk.HalfSpace.between(STEEL, STEEL)), load).solve().validity


def find(notes, words):
    (note,) = [note for note in notes if words in note.statement]
    return note


@pytest.mark.parametrize(
    ("degrees", "standing", "words"),
    [
        (88.0, wk.Standing.ASYMPTOTIC, "small, as the theory assumes"),
        (70.3, wk.Standing.APPROXIMATE, "(1 - 2 nu) times the slope"),
        (30.0, wk.Standing.OUTSIDE, "far from small"),
    ],
)
def test_slopes(degrees, standing, words):
    notes = validity(wk.Cone(math.radians(degrees)), wk.Depth(1e-6))
    note = find(notes, "steepest slope")
    assert note.standing is standing
    assert words in note.statement
    assert f"{1.0 / math.tan(math.radians(degrees)):.3g}" in note.statement


@pytest.mark.parametrize(
    ("ratio", "standing"),
    [(0.01, wk.Standing.ASYMPTOTIC), (0.3, wk.Standing.APPROXIMATE), (0.7, wk.Standing.OUTSIDE)],
)
def test_the_bodys_size(ratio, standing):
    note = find(validity(wk.Sphere(1e-3), wk.Radius(ratio * 1e-3)), "of the body's radius")
    assert note.standing is standing
    assert f"{ratio:.3g} of the body's radius" in note.statement


def test_the_widest_of_many_loads_counts():
    one = validity(wk.Sphere(1e-3), wk.Radius(7e-4))
    many = validity(wk.Sphere(1e-3), wk.Radius(np.array([[1e-5, 7e-4], [3e-4, 1e-4]])))
    assert [n.statement for n in one] == [n.statement for n in many]


def test_a_cone_has_no_size():
    assert not any("body's radius" in note.statement for note in validity(wk.Cone(1.5), wk.Depth(1e-6)))


def test_dissimilar_bodies():
    """Without friction Dundurs' constant changes nothing, and no note mentions it."""
    notes = validity(wk.Paraboloid(1.0), wk.Depth(1e-6), wk.HalfSpace.between(STEEL))
    assert not any("Dundurs" in note.statement for note in notes)
    assert not any(note.assumption is wk.Assumption.UNCOUPLED for note in notes)


def test_a_rim():
    note = find(validity(wk.FlatPunch(1e-3), wk.Depth(1e-6)), "pinned at the rim")
    assert note.standing is wk.Standing.EXACT
    inside = validity(wk.CappedCylinder(1e-3, wk.Paraboloid(1.0)), wk.Depth(1e-8))
    assert not any("pinned" in note.statement for note in inside)


def test_a_note_of_a_wavy_body_states_that_it_was_checked():
    note = find(
        validity(wk.Paraboloid(1e-2) + wk.Wavy(1e-10, 1e-3), wk.Depth(1e-7)),
        "checked that the contact is one disc",
    )
    assert "no tension inside, no overlap outside" in note.statement


def test_yield():
    """Before and beyond the onset; and no note if no strength was given."""
    strong = wk.HalfSpace.between(wk.Elastic(210e9, 0.3, strength=1e9))
    onset = wk.YieldOnset(wk.Foundation(wk.Paraboloid(1e-2), strong)).solve()
    elastic = find(validity(wk.Paraboloid(1e-2), wk.Force(0.5 * onset.force), strong), "von Mises")
    plastic = find(validity(wk.Paraboloid(1e-2), wk.Force(np.array([0.1, 1.5]) * onset.force), strong), "von Mises")
    assert elastic.standing is wk.Standing.EXACT
    assert f"yielding begins at {onset.force:.4g} N; the contact stays elastic" in elastic.statement
    assert plastic.standing is wk.Standing.OUTSIDE
    assert not any("von Mises" in note.statement for note in validity(wk.Paraboloid(1e-2), wk.Force(1.0)))


def test_every_note_has_a_source_and_ends_as_a_sentence():
    notes = validity(wk.Berkovich() + wk.Sphere(1e-2), wk.Depth(1e-6), wk.HalfSpace.between(STEEL))
    assert len(notes) >= 4
    for note in notes:
        assert note.source
        assert note.statement.endswith(".")
        assert str(note).startswith(f"{note.standing.value}: ")
    assert worst(notes) is wk.Standing.APPROXIMATE


def test_a_check_that_does_not_come_to_an_end_refuses_nothing(monkeypatch):
    """The result is that of the check that ended; a note says that whether it is one disc was not found out."""
    film = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1e4, 0.5), 2.13e-6)], on=wk.Rigid())
    bed, loads = wk.Foundation(wk.Cone(1.2), film), wk.Depth(np.array([0.3e-6, 1e-6]))
    looked_at = wk.Indentation(bed, loads).solve()
    assert find(looked_at.validity, "checked that the contact is one disc").standing is wk.Standing.EXACT

    def endless(*_):
        raise wk.NotConverged("The separation outside the contact could not be computed.")

    monkeypatch.setattr(overlap, "_clear_outside", endless)
    single_contact._unfinished.cache_clear()
    try:
        unseen = wk.Indentation(bed, loads).solve()
        note = find(unseen.validity, "did not finish")
    finally:
        single_contact._unfinished.cache_clear()
    assert note.standing is wk.Standing.APPROXIMATE
    assert "could not be computed" in note.statement
    np.testing.assert_array_equal(unseen.force, looked_at.force)
    np.testing.assert_array_equal(unseen.radius, looked_at.radius)
