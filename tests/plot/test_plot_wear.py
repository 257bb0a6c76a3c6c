"""Sheets of wear show what they say."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.plot import draw, sheet_of
from winkler.plot.wear.wear import moment_panels

STEEL = wk.Elastic(young=210e9, poisson=0.3)
MEDIUM = wk.HalfSpace.between(STEEL, STEEL)
BED = wk.Foundation(wk.Paraboloid(10e-3), MEDIUM)
SWING, DEPTH, FRICTION = wk.Shift(0.45e-6), wk.Depth(1e-6), wk.Coulomb(0.5)
CYCLES = np.array([0.0, 1e4, 3e4, 1e5, 2e5, 3e5, 1e6])


def titles(figure):
    return [axes.get_title("left") or axes.get_title() for axes in figure.axes]


def test_fretting_is_shown_over_the_cycles():
    worn = wk.FrettingWear(BED, wk.Archard(1e-14), FRICTION, DEPTH, SWING, CYCLES, count=30).solve()
    figure = draw(worn)
    assert titles(figure) == [
        "worn profiles",
        "worn depth",
        "pressure",
        "contact and stick zone",
        "worn volume",
        "normal force",
    ]
    profiles, depths, pressures, radii, volume, _ = figure.axes
    assert 3 <= len(profiles.lines) <= 6
    # all curves in one unit: what was worn off never falls
    tops = [np.max(line.get_ydata()) for line in depths.lines]
    assert np.all(np.diff(tops) > 0.0)
    assert tops[-1] == pytest.approx(1e9 * worn.worn_depth[-1], rel=1e-9)
    assert len(pressures.lines) == len(profiles.lines)
    assert [line.get_label() for line in radii.lines] == ["radius", "stick radius"]
    assert volume.get_xlabel().startswith("cycles")
    assert "cycles" in profiles.get_legend().get_title().get_text()


def test_both_bodies_have_a_line_and_a_steady_force_shows_the_depth():
    law = wk.PairWear(wk.Archard(1e-14), wk.Archard(2e-14))
    worn = wk.FrettingWear(BED, law, FRICTION, wk.Force(15.0), SWING, CYCLES[:3], count=30).solve()
    figure = draw(worn)
    assert titles(figure)[-1] == "depth"
    assert len(figure.axes[4].lines) == 2


def test_sliding_is_shown_over_the_distance():
    run = wk.SlidingWear(BED, wk.Archard(1e-14), wk.Force(15.0), np.array([0.0, 0.1, 0.3]), count=30).solve()
    figure = draw(run)
    assert titles(figure)[-1] == "mean pressure"
    assert figure.axes[3].get_xlabel() == "distance $s$ [mm]"
    assert titles(draw(run.states[-1])) == ["worn profiles", "worn depth", "pressure"]


def test_the_limit_is_shown_beside_what_was_before():
    figure = draw(wk.LimitingProfile(BED, FRICTION, DEPTH, SWING).solve())
    assert titles(figure) == ["profile", "worn depth", "pressure"]
    low, high = figure.axes[0].lines[:2]
    assert np.all(high.get_ydata() >= low.get_ydata())


def test_sheets_have_no_extent():
    limit = wk.LimitingProfile(BED, FRICTION, DEPTH, SWING).solve()
    with pytest.raises(wk.InvalidInput, match="have no extent"):
        draw(limit, extent=1e-3)


STRIP = wk.LineFoundation(wk.Paraboloid(10e-3), MEDIUM)
PRESS, SHEAR = wk.LineForce(100e3), wk.LineShearForce(30e3)
BOTH = wk.PairWear(wk.Archard(1e-14), wk.Archard(3e-14))


@pytest.fixture(scope="module")
def fretted():
    return wk.LineFrettingWear(STRIP, BOTH, FRICTION, PRESS, SHEAR, np.array([0.0, 1e3, 1e5]), count=40).solve()


def test_a_fretted_strip_shows_profiles_pressures_and_both_volumes(fretted):
    panels = sheet_of(fretted).panels
    assert len(panels) == 6
    profile, depth, _, widths, volumes, _ = panels
    assert np.max(profile.marks[0].x) <= 1.35 * fretted.half_width[-1]
    np.testing.assert_array_equal(np.max(depth.marks[-1].y), fretted.worn_depth[-1])
    np.testing.assert_array_equal(widths.marks[0].y, fretted.half_width)
    np.testing.assert_array_equal(widths.marks[1].y, fretted.stick_half_width)
    np.testing.assert_array_equal(volumes.marks[1].y, fretted.second_volume_per_length)
    assert profile.across.label == "$x$"


def test_a_state_and_a_moment_of_a_strip_have_their_pictures(fretted):
    assert len(sheet_of(fretted.states[-1]).panels) == 3
    profile, _, pressure = moment_panels(fretted.states, 1)
    np.testing.assert_allclose(profile.marks[1].y, STRIP.profile.height(profile.marks[1].x))
    assert pressure.marks


def test_a_strip_that_slides_and_its_limit_have_theirs():
    slid = wk.LineSlidingWear(STRIP, wk.Archard(1e-14), PRESS, np.array([0.0, 0.1]), count=40).solve()
    np.testing.assert_array_equal(sheet_of(slid).panels[-1].marks[0].y, slid.mean_pressure)
    limit = wk.LineLimitingProfile(STRIP, FRICTION, PRESS, SHEAR).solve()
    _, depth, pressure = sheet_of(limit).panels
    assert np.max(depth.marks[0].y) == pytest.approx(limit.worn_depth, rel=1e-3)
    assert np.max(pressure.marks[1].x) < limit.stick_half_width
