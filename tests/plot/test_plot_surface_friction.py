"""The picture of a sheared height map: zones and arrows where it touches, and the loop that goes with the path."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import winkler as wk
from winkler.plot import sheet_of
from winkler.plot.panel import Map, Vectors
from winkler.plot.render import render

PAIR = wk.HalfSpace.between(wk.Elastic(1.0, 0.3), wk.Elastic(1.0, 0.3))
BALL = wk.SampledProfile([0.25, 0.25], wk.Paraboloid(1.0), (33, 33))


def sheet(normal, lateral):
    path = wk.Path.through(normal, lateral)
    solution = wk.SurfaceTangential(BALL, PAIR, wk.Coulomb(0.3), path).solve()
    return solution, sheet_of(solution)


def test_zones_cover_the_contact_and_arrows_point_along_the_traction():
    solution, drawn = sheet(wk.Depth(0.01), wk.Shift([0.0, 0.0015]))
    zones, size, loop = drawn.panels
    assert [panel.title for panel in drawn.panels] == [
        "stick (green) and slip", "traction", "shear force over the shift",
    ]  # fmt: skip
    stuck, slid = (mark for mark in zones.marks if isinstance(mark, Map))
    touching = np.count_nonzero(solution.last.pressure > 0.0)
    assert np.nansum(stuck.z) + np.nansum(slid.z) == touching
    assert np.nansum(slid.z) == np.count_nonzero(solution.last.slipping)
    (arrows,) = (mark for mark in zones.marks if isinstance(mark, Vectors))
    assert np.all(arrows.u > 0.0)
    assert np.all(np.hypot(arrows.x, arrows.y) < 0.11)
    (image,) = (mark for mark in size.marks if isinstance(mark, Map))
    assert np.nanmax(image.z) == pytest.approx(np.max(np.hypot(*solution.last.traction)))
    assert loop.across.label.startswith("shift")


@pytest.mark.parametrize(("normal", "lateral", "titles"), [
    (wk.Depth([0.01, -0.01]), wk.Shift(0.0), ["no contact", "shear force over the shift"]),
    (wk.Depth(0.01), wk.Angle([0.0, 0.02]), ["stick (green) and slip", "traction", "torque over the twist"]),
    (wk.Depth([0.01]), wk.Shift([0.0]), ["stick (green) and slip", "traction"]),
])  # fmt: skip
def test_what_is_drawn_of_other_paths(normal, lateral, titles):
    assert [panel.title for panel in sheet(normal, lateral)[1].panels] == titles


def test_a_rolling_map_shows_its_creep_curve_and_the_last_creepage():
    def drawn(creepage):
        return sheet_of(wk.SurfaceRolling(BALL, PAIR, wk.Depth(0.008), wk.Coulomb(0.3), creepage).solve())

    zones, _, curve = drawn(wk.Creepage(longitudinal=[1e-3, 1e-2, 2e-2])).panels
    assert zones.title == "stick (green) and slip, rolls to the right"
    assert curve.across.label.startswith("longitudinal creepage")
    assert drawn(wk.Creepage(spin=[0.01, 0.1])).panels[2].across.label.startswith("spin creepage")
    assert len(drawn(wk.Creepage(longitudinal=1e-3)).panels) == 2


@pytest.mark.slow
def test_springs_are_drawn_beside_the_elements_in_both_directions():
    oblong = wk.SampledProfile([0.25, 0.17], wk.CurvedBodies(1.0, 0.5), (41, 41))
    found = wk.ReducedFriction(oblong, PAIR, wk.Coulomb(0.3), 0.006).solve()
    along, across, ratios = sheet_of(found).panels
    for axis, panel in enumerate((along, across)):
        springs, elements = (mark for mark in panel.marks if hasattr(mark, "marker"))
        assert np.array_equal(elements.x, found.shift[:, axis])
        assert springs.x[-1] == pytest.approx(found.spring_shift[-1, axis])
        assert panel.across.label.startswith(f"shift {'xy'[axis]}")
    assert {mark.name for mark in ratios.marks} == {"along $x$", "along $y$"}


def test_a_narrow_map_has_few_ticks_and_its_colours_end_with_the_bar():
    map_ = wk.SampledProfile([0.14, 0.28], wk.CurvedBodies(0.3, 1.0), (30, 60))
    rolls = wk.SurfaceRolling(map_, PAIR, wk.Depth(0.005), wk.Coulomb(0.3), wk.Creepage(longitudinal=0.05)).solve()
    figure = render(sheet_of(rolls))
    figure.canvas.draw()
    zones, size = figure.axes[:2]
    bar = size.child_axes[0]
    for axes in (zones, size):
        width = axes.get_window_extent().width
        labels = [label.get_window_extent() for label in axes.get_xticklabels() if label.get_text()]
        inside = [box for box in labels if box.x1 > axes.bbox.x0 and box.x0 < axes.bbox.x0 + width]
        assert all(one.x1 < other.x0 for one, other in itertools.pairwise(inside))
    assert bar.get_window_extent().height == pytest.approx(size.get_window_extent().height, rel=1e-6)
    greatest = np.max(np.hypot(*rolls.last.traction))
    factor = size.images[0].norm.vmax / greatest
    assert bar.get_ylim()[1] == pytest.approx(greatest * factor, rel=1e-6)
