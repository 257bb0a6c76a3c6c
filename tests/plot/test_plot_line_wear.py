"""Pictures of worn line contacts."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.plot import sheet_of
from winkler.plot.wear.wear import moment_panels

STEEL = wk.Elastic(210e9, 0.3)
BED = wk.LineFoundation(wk.Paraboloid(10e-3), wk.HalfSpace.between(STEEL, STEEL))
PRESS, SWING, FRICTION = wk.LineForce(100e3), wk.LineShearForce(30e3), wk.Coulomb(0.5)
BOTH = wk.PairWear(wk.Archard(1e-14), wk.Archard(3e-14))


@pytest.fixture(scope="module")
def fretted():
    return wk.LineFrettingWear(BED, BOTH, FRICTION, PRESS, SWING, np.array([0.0, 1e3, 1e5]), count=40).solve()


def test_fretting_shows_profiles_pressures_and_both_volumes(fretted):
    panels = sheet_of(fretted).panels
    assert len(panels) == 6
    profile, depth, _, widths, volumes, _ = panels
    assert np.max(profile.marks[0].x) <= 1.35 * fretted.half_width[-1]
    np.testing.assert_array_equal(np.max(depth.marks[-1].y), fretted.worn_depth[-1])
    np.testing.assert_array_equal(widths.marks[0].y, fretted.half_width)
    np.testing.assert_array_equal(widths.marks[1].y, fretted.stick_half_width)
    np.testing.assert_array_equal(volumes.marks[1].y, fretted.second_volume_per_length)
    assert profile.across.label == "$x$"


def test_a_state_and_a_moment_have_their_pictures(fretted):
    assert len(sheet_of(fretted.states[-1]).panels) == 3
    profile, _, pressure = moment_panels(fretted.states, 1)
    np.testing.assert_allclose(profile.marks[1].y, BED.profile.height(profile.marks[1].x))
    assert pressure.marks


def test_sliding_and_the_limit_have_theirs():
    slid = wk.LineSlidingWear(BED, wk.Archard(1e-14), PRESS, np.array([0.0, 0.1]), count=40).solve()
    np.testing.assert_array_equal(sheet_of(slid).panels[-1].marks[0].y, slid.mean_pressure)
    limit = wk.LineLimitingProfile(BED, FRICTION, PRESS, SWING).solve()
    _, depth, pressure = sheet_of(limit).panels
    assert np.max(depth.marks[0].y) == pytest.approx(limit.worn_depth, rel=1e-3)
    assert np.max(pressure.marks[1].x) < limit.stick_half_width
