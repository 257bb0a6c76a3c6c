"""Pictures of bodies that stick: what they draw is what the solutions state, and what is cut off is stated."""

from __future__ import annotations

import math

import numpy as np
import pytest
from matplotlib.collections import LineCollection

import winkler as wk
from winkler.fields.restoration import restore
from winkler.plot import draw, style
from winkler.plot.adhesion.cycles import contact_of
from winkler.plot.extent import has_tensile_singularity, is_singular
from winkler.values.errors import InvalidInput

RUBBER = wk.HalfSpace.between(wk.Elastic(1e6, 0.5))
BALL = wk.Foundation(wk.Paraboloid(1e-3), RUBBER)
WAVY = wk.Foundation(wk.Paraboloid(10e-3) + wk.Wavy(1e-6, 1e-4), RUBBER)
LAW = wk.ShortRange(0.05)
THERE_AND_BACK = wk.Depth(np.array([-2e-5, 2e-5, -6e-5]))
STUCK = wk.AdhesiveIndentation(BALL, LAW, wk.Force(0.0)).solve()
PULLED = wk.AdhesiveIndentation(BALL, LAW, wk.Depth(-1.7e-6)).solve()
RING = wk.AdhesiveIndentation(BALL, wk.Dugdale(0.05, 3e4), wk.Force(0.0)).solve()
FAR = wk.AdhesiveIndentation(BALL, wk.DerjaguinMullerToporov(0.05), wk.Force(0.0)).solve()
CYCLE = wk.AdhesiveCycle(BALL, LAW, THERE_AND_BACK).solve()


def texts(figure):
    return " ".join(text.get_text() for axes in figure.axes for text in axes.texts)


def numbers(line):
    x, y = (np.asarray(part, dtype=float) for part in line.get_data())
    return x, y


ITEMS = {
    "pushed by nothing": (lambda: STUCK, 4),
    "pulled": (lambda: PULLED, 4),
    "ring": (lambda: RING, 4),
    "from afar": (lambda: FAR, 4),
    "held at a rim": (
        lambda: wk.AdhesiveIndentation(wk.Foundation(wk.FlatPunch(1e-3), RUBBER), LAW, wk.Force(-1e-3)).solve(),
        4,
    ),
    "pointed": (lambda: wk.AdhesiveIndentation(wk.Foundation(wk.Cone(1.3), RUBBER), LAW, wk.Force(0.0)).solve(), 4),
    "many loads": (lambda: wk.AdhesiveIndentation(BALL, LAW, wk.Force(np.array([-1e-4, 0.0, 1e-3]))).solve(), 2),
    "equilibria": (lambda: wk.Equilibrium(BALL, LAW, 2e-4, count=50).solve(), 2),
    "equilibria under a dead load": (lambda: wk.Equilibrium(BALL, LAW, 2e-4, 0.0, 50).solve(), 2),
    "many branches": (lambda: wk.Equilibrium(WAVY, LAW, 6e-4).solve(), 2),
    "cycle": (lambda: CYCLE, 2),
    "cycle under a dead load": (lambda: wk.AdhesiveCycle(BALL, LAW, wk.Force([0.0, 1e-3, -1e-4])).solve(), 2),
    "cycle without contact": (lambda: wk.AdhesiveCycle(BALL, LAW, wk.Depth([-2e-5, -1e-5])).solve(), 2),
    "sheared": (lambda: wk.AdhesiveShear(BALL, LAW, wk.Force(0.0), wk.Shift(1e-6)).solve(), 2),
    "pull-off": (lambda: wk.PullOff(BALL, LAW, 50.0).solve(), 1),
    "pull-off without a jump": (lambda: wk.PullOff(BALL, wk.DerjaguinMullerToporov(0.05)).solve(), 1),
}


@pytest.mark.few(2, slow=2)
@pytest.mark.parametrize("name", ITEMS)
def test_every_answer_has_a_picture(name):
    make, count = ITEMS[name]
    figure = draw(make())
    assert len(figure.axes) == count
    for axes in figure.axes:
        assert axes.get_title(loc="left")
        labels = [axes.get_xlabel(), axes.get_ylabel()]
        assert all("[" in label for label in labels) or not axes.axison


def test_the_tension_at_the_edge_is_cut_off_and_stated():
    axes = draw(STUCK).axes[2]
    text = texts(axes.figure)
    assert "infinite tension at the edge, cut off" in text
    assert "$K_I$ = 365 Pa" in text  # sqrt(2 E* w) = sqrt(2 (4/3 MPa) 0.05) = 365.1
    x, y = numbers(axes.lines[0])
    assert np.min(y) < axes.get_ylim()[0] < 0.0 < axes.get_ylim()[1]
    inside = np.abs(x) < 0.5 * STUCK.radius * 1e6
    expected = restore(STUCK, np.abs(x[inside]) * 1e-6).pressure / 1e3
    assert y[inside] == pytest.approx(expected, rel=1e-9)


@pytest.mark.slow
def test_what_is_finite_is_drawn_whole():
    axes = draw(RING).axes[2]
    assert "infinite" not in texts(axes.figure)
    assert np.min(numbers(axes.lines[0])[1]) == pytest.approx(-30.0, rel=1e-6)  # the strength of the law, in kPa
    assert axes.get_ylim()[0] < -30.0


@pytest.mark.parametrize(
    ("solution", "torn"), [(STUCK, True), (PULLED, True), (RING, False), (FAR, False)], ids=["a", "b", "c", "d"]
)
def test_only_attraction_without_range_tears(solution, torn):
    assert has_tensile_singularity(solution.pressed) == is_singular(solution.pressed) == torn


def test_springs_that_pull_reach_above_the_surface_in_another_colour():
    axes = draw(STUCK).axes[1]
    coils = [item for item in axes.collections if isinstance(item, LineCollection)]
    ends = {}
    for collection in coils:
        segments = collection.get_segments()
        colours = np.broadcast_to(collection.get_color(), (len(segments), 4))
        for line, colour in zip(segments, colours, strict=True):
            ends.setdefault(style.RED if colour[0] > 0.5 else style.BLUE, []).append(line[-1, 1])
    assert max(ends[style.BLUE]) > 3.0  # um: close to the stretch of the edge, sqrt(2 pi a w / E*) = 4.37
    x = np.linspace(0.0, STUCK.radius, 50)
    assert -np.min(STUCK.pressed.value(x)) == pytest.approx(math.sqrt(2 * math.pi * STUCK.radius * 0.05 * 0.75e-6))
    assert "blue springs pull" in texts(axes.figure)


@pytest.mark.slow
def test_a_ring_has_two_radii_in_the_picture_of_the_springs():
    text = [text.get_text() for text in draw(RING).axes[1].texts]
    assert {"$a$", "$c$"} <= set(text)
    assert "$c$" not in [text.get_text() for text in draw(STUCK).axes[1].texts]


def test_stable_and_unstable_states_are_distinguished():
    curve = wk.Equilibrium(WAVY, LAW, 6e-4).solve()
    lines = draw(curve).axes[0].lines
    solid = [
        line
        for line in lines
        if line.get_linestyle() == "-" and line.get_color() == style.BLUE and line.get_xdata()[:1].size
    ]
    assert len(solid) == len(curve.branches) > 3
    for line, branch in zip(solid, curve.branches, strict=True):
        x, y = numbers(line)
        assert x[[0, -1]] * 1e-6 == pytest.approx([branch.start_depth, branch.stop_depth], rel=1e-9)
        assert y[[0, -1]] * 1e-3 == pytest.approx([branch.start_force, branch.stop_force], rel=1e-9)


def test_the_shaded_area_of_a_cycle_is_what_was_lost():
    axes = draw(CYCLE).axes[0]
    corners = axes.patches[0].get_xy()
    x, y = corners[:, 0] * 1e-6, corners[:, 1] * 1e-3
    area = abs(float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)))) / 2.0
    assert area == pytest.approx(CYCLE.dissipation[-1], rel=1e-3)  # a polygon
    assert "shaded: lost, 397.3 pJ" in texts(axes.figure)


def test_a_cycle_that_ends_in_contact_shades_nothing():
    figure = draw(wk.AdhesiveCycle(BALL, LAW, wk.Depth([-1e-5, 1e-5])).solve())
    assert "lost so far" in texts(figure)
    assert not figure.axes[0].patches


def test_jumps_are_no_part_of_the_line():
    axes = draw(CYCLE).axes[1]
    x, y = numbers(axes.lines[0])
    assert np.isnan(x).sum() == len(CYCLE.jumps)
    snap = CYCLE.jumps[0].after
    assert np.any(np.isclose(x, snap.position * 1e6, atol=1e-9) & np.isclose(y, snap.radius * 1e6))


def test_a_sheared_contact_is_drawn_to_its_limit():
    solution = wk.AdhesiveShear(BALL, LAW, wk.Force(0.0), wk.ShearForce(1e-4)).solve()
    x, y = numbers(draw(solution).axes[0].lines[0])
    assert y[-1] == pytest.approx(solution.limit.shear_force * 1e6, rel=1e-12)
    # what is borne has its maximum there, so that rounding moves the radius, and with it the shift, by its root
    assert x[-1] == pytest.approx(solution.limit.shift * 1e6, rel=1e-7)


def test_an_extent_is_refused_where_there_is_none():
    with pytest.raises(InvalidInput, match="AdhesiveCycleSolution have no extent"):
        draw(CYCLE, extent=1e-3)


def test_contacts_of_answers_that_hold_many():
    assert contact_of(CYCLE).radius == np.max(CYCLE.radius)
    last = wk.PullOff(BALL, LAW).solve()
    assert contact_of(last).depth == last.depth
    assert contact_of(wk.PullOff(BALL, wk.DerjaguinMullerToporov(0.05)).solve()) is None
