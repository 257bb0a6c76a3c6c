"""Turns of a motion between two measured points."""

from __future__ import annotations

import numpy as np
import pytest
from relaxing_curves import FREE, TRUE, loop, start

from winkler.fitting.fit import fit
from winkler.fitting.viscoelastic.corners import corners_of, with_corners

TIME = np.linspace(0.0, 2.0, 80)
DIRECTION = np.where(TIME <= 1.03, 1.0, 0.0)
TURNED = np.minimum(TIME, 1.03)


@pytest.mark.parametrize("late", [-1, 0, 1])
def test_the_turn_is_where_the_lines_meet(late):
    """Also if the direction changes a point too early or too late."""
    found = corners_of(TIME, TURNED, np.roll(DIRECTION, late) if late else DIRECTION)
    assert found.before.tolist() == [int(np.flatnonzero(TIME <= 1.03)[-1])]
    assert found.time[0] == pytest.approx(1.03, rel=1e-12)
    assert found.signal[0] == pytest.approx(1.03, rel=1e-12)


def test_what_is_subtracted_is_subtracted_from_the_turn():
    found = corners_of(TIME, TURNED, DIRECTION)
    time, driven, measured = with_corners(found, TIME, TURNED, TURNED - 0.2 - 0.1 * TIME)
    assert driven[~measured] == pytest.approx([1.03 - 0.2 - 0.103], rel=1e-12)
    assert np.array_equal(time[measured], TIME)
    assert np.all(np.diff(time) > 0.0)


def test_rounded_and_noisy_turns_are_left():
    round_ = np.sin(0.5 * np.pi * TIME)
    assert not corners_of(TIME, round_, np.where(TIME <= 1.0, 1.0, -1.0)).before.size
    noisy = TURNED + 0.03 * np.random.default_rng(1).standard_normal(TIME.size)
    assert not corners_of(TIME, noisy, DIRECTION).before.size


@pytest.mark.parametrize("held", [True, False])
def test_a_turn_between_points_biases_no_fit(held):
    """Without noise; along straight lines from point to point the modulus was off by 2.5e-4 and 6e-4."""
    found = fit(loop(0, noise=1e-16, count=300, held=held), start("relaxation"), free=FREE["relaxation"])
    assert found.values[0] == pytest.approx(TRUE["relaxation"][0], rel=2e-4)
