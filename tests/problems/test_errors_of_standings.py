"""What notes say of their errors, against an independent derivation of each."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.problems.normal.validity import large_body_note, steepness_note
from winkler.values.validity import Note, in_words


def hay(slope, poisson):
    """Return the correction of the load of Hay, Bolshakov, Pharr (1999), equation 8, less one."""
    part = (1.0 - 2.0 * poisson) / (4.0 * (1.0 - poisson)) * slope
    return math.pi * (math.pi / 4.0 + 0.15483073 * part) / (math.pi / 2.0 - 0.83119312 * part) ** 2 - 1.0


@pytest.mark.parametrize("poisson", [0.0, 0.2, 0.3, 0.45])
def test_the_error_of_a_slope_bounds_the_correction_of_a_cone(poisson):
    slopes = np.geomspace(1e-3, 1.0, 13)
    found = np.array([steepness_note(slope).error for slope in slopes])
    exact = np.array([hay(slope, poisson) for slope in slopes])
    assert np.all(exact <= found)
    if poisson == 0.0:
        assert np.all(exact >= 0.75 * found)


@pytest.mark.parametrize("poisson", [0.0, 0.2, 0.3, 0.5])
def test_the_error_of_a_body_bounds_what_the_opposite_force_does(poisson):
    """A ball is held at its far pole: Boussinesq's displacement at 2 R below a force, over the approach of Hertz."""
    radius, contact, young = 1.0, np.geomspace(1e-3, 0.5, 7), 1.0
    force = 4.0 / 3.0 * young / (1.0 - poisson**2) * contact**3 / radius
    away = 2.0 * radius
    moved = force * (1.0 + poisson) / (2.0 * math.pi * young) * (1.0 + 2.0 * (1.0 - poisson)) / away
    found = np.array([large_body_note(ratio).error for ratio in contact / radius])
    share = moved / (contact**2 / radius)
    assert np.all(share <= found * (1.0 + 1e-2))
    assert np.all(share >= 0.7 * found)


def test_words_name_an_error_where_a_worst_note_knows_one():
    def note(standing, error=None):
        return Note(wk.Assumption.SHAPE, standing, "It is so.", "a check", error)

    exact, good, estimate, outside = wk.Standing
    assert in_words([]) == in_words([note(exact)]) == "exact in its theory"
    assert in_words([note(exact), note(good, 0.006)]) == "good to about 0.6 %"
    assert in_words([note(good, 0.006), note(good, 0.021)]) == "good to about 2 %"
    assert in_words([note(good, 0.006), note(good)]) == "good here"
    assert in_words([note(good), note(estimate, 0.22)]) == "an estimate: ± 20 %"
    assert in_words([note(estimate), note(estimate, 0.22)]) == "an estimate: ± 20 % or more"
    assert in_words([note(estimate), note(good, 0.22)]) == "an estimate"
    assert in_words([note(estimate, 0.22), note(outside, 3.0)]) == "do not use"


def test_a_recorded_note_keeps_its_error_and_old_rows_are_read():
    from winkler.study.batch.recording import notes_of, plain_notes

    notes = (steepness_note(0.1), Note(wk.Assumption.SHAPE, wk.Standing.EXACT, "It is so.", "a check"))
    assert notes_of(plain_notes(notes)) == notes
    assert notes_of([row[:4] for row in plain_notes(notes[1:])]) == notes[1:]
