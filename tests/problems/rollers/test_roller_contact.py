"""Rollers of finite length against Hertz's ellipse, Lundberg, endless lines, height maps and direct superposition."""

from __future__ import annotations

import dataclasses
import re

import numpy as np
import pytest

import winkler as wk
from winkler.values.validity import Assumption, Standing

STEEL = wk.Elastic(208e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
SOFT = wk.HalfSpace(wk.Elastic(1.0, 0.0))
LOG = wk.LogarithmicEnds(4e3 / 9.6e-3, load_factor=1.5, crowned_share=0.7)


def bearing(ends, load=None, alignment=None, elements=96, medium=PAIR):
    """Return a roller of a bearing under 4 kN."""
    return wk.RollerContact(4.2e-3, 9.6e-3, ends, medium, load or wk.Force(4e3), alignment or wk.Tilt(0.0), elements)


@pytest.mark.few(1)
@pytest.mark.parametrize(("crown", "load"), [(5.0, 1e-3), (100.0, 2e-4), (2000.0, 2e-5)])
def test_a_crown_whose_ends_do_not_touch_is_an_ellipse_of_hertz(crown, load):
    ellipse = wk.EllipticIndentation(wk.CurvedBodies(crown, 1.0), SOFT, wk.Force(load)).solve()
    found = wk.RollerContact(1.0, 4.0, wk.CrownedEnds(crown), SOFT, wk.Force(load)).solve()
    assert found.depth == pytest.approx(ellipse.depth, rel=3e-4)
    assert found.peak_pressure == pytest.approx(ellipse.peak_pressure, rel=1e-3)
    assert found.area == pytest.approx(ellipse.area, rel=4e-3)
    assert found.stiffness == pytest.approx(ellipse.stiffness, rel=4e-3)
    assert found.edge_factor == pytest.approx(1.0, rel=1e-3)
    inside = np.abs(found.last.x) < 0.8 * ellipse.longitudinal_semi_axis
    expected = ellipse.pressure(found.last.x[inside], 0.0)
    assert found.last.pressure_along[inside] == pytest.approx(expected, rel=3e-3)


def test_an_approach_gives_the_force_of_hertz():
    ellipse = wk.EllipticIndentation(wk.CurvedBodies(100.0, 1.0), SOFT, wk.Depth(1e-3)).solve()
    found = wk.RollerContact(1.0, 4.0, wk.CrownedEnds(100.0), SOFT, wk.Depth(1e-3), elements=96).solve()
    assert found.depth == 1e-3
    assert found.force == pytest.approx(ellipse.force, rel=4e-4)


def test_a_tilted_crown_is_the_same_ellipse_elsewhere():
    """x^2/(2 R_c) - theta x has its lowest point at theta R_c, theta^2 R_c/2 deeper."""
    tilt, crown = 2e-3, 100.0
    straight = wk.RollerContact(1.0, 4.0, wk.CrownedEnds(crown), SOFT, wk.Force(2e-4), elements=96).solve()
    tilted = wk.RollerContact(1.0, 4.0, wk.CrownedEnds(crown), SOFT, wk.Force(2e-4), wk.Tilt(tilt), 96).solve()
    assert tilted.moment / tilted.force == pytest.approx(tilt * crown, rel=1e-3)
    assert tilted.depth == pytest.approx(straight.depth - 0.5 * tilt**2 * crown, rel=2e-4)
    assert tilted.peak_pressure == pytest.approx(straight.peak_pressure, rel=1e-3)


@pytest.mark.parametrize(("young", "force"), [(489e9, 100.0), (2e15, 5e3), (210e9, 1e-2)])
def test_a_small_contact_far_from_the_middle_is_found(young, force):
    """Under a moment the lowest point of the crown moves until the force acts at M/F: exact for an ellipse."""
    crown, radius, length = 0.5, 10e-3, 22e-3
    medium = wk.HalfSpace(wk.Elastic(young, 0.3))
    ellipse = wk.EllipticIndentation(wk.CurvedBodies(crown, radius), medium, wk.Force(force)).solve()
    place = 8.8e-3
    roller = wk.RollerContact(
        radius, length, wk.CrownedEnds(crown), medium, wk.Force(force), wk.Moment(force * place), 64
    ).solve()
    assert roller.tilt == pytest.approx(place / crown, rel=1e-6)
    assert roller.peak_pressure == pytest.approx(ellipse.peak_pressure, rel=3e-3)
    assert roller.depth + 0.5 * place**2 / crown == pytest.approx(ellipse.depth, rel=2e-3)
    assert roller.middle_pressure == 0.0
    assert roller.edge_factor == np.inf


@pytest.mark.few(1)
@pytest.mark.parametrize("ends", [wk.SharpEnds(), wk.RoundedEnds(0.3e-3), wk.LogarithmicEnds(4e3 / 9.6e-3)])
def test_the_middle_is_that_of_an_endless_line(ends):
    found = bearing(ends, elements=160).solve().last
    middle = found.x.size // 2
    load = wk.LineForce(float(found.force_per_length[middle]))
    line = wk.LineIndentation(wk.LineFoundation(wk.Paraboloid(4.2e-3), PAIR), load).solve()
    assert found.middle_pressure == pytest.approx(line.peak_pressure, rel=5e-3)
    assert found.half_width[middle] == pytest.approx(line.half_width, rel=5e-3)


def test_lundbergs_crown_presses_evenly_and_has_his_approach():
    for half_width in (0.03, 0.003):
        even = np.pi * half_width**2 / 4.0
        found = wk.RollerContact(1.0, 2.0, wk.LogarithmicEnds(even), SOFT, wk.Force(2.0 * even), elements=128).solve()
        assert found.depth == pytest.approx(
            even / np.pi * (2.0 * np.log(4.0 / half_width) + 1.0), rel=0.1 * half_width + 5e-4
        )
        inside = np.abs(found.last.x) < 0.9
        assert found.last.force_per_length[inside] == pytest.approx(even, rel=0.02)
        assert 1.05 < found.edge_factor < 1.2
        turned = found.last.force_per_length[::-1]
        np.testing.assert_allclose(found.last.force_per_length, turned, rtol=1e-6, atol=1e-6 * even)


def love(x, y, dx, dy):
    """Return pi E* times the displacement at (x, y) from the middle of a rectangle under unit pressure."""

    def corner(x, y):
        return x * np.arcsinh(y / np.abs(x)) + y * np.arcsinh(x / np.abs(y))

    signs = [(1, 1), (-1, -1), (1, -1), (-1, 1)]
    return sum(s * t * corner(x + 0.5 * s * dx, y + 0.5 * t * dy) for s, t in signs)


@pytest.mark.parametrize(
    ("ends", "alignment"),
    [(wk.RoundedEnds(0.5e-3), wk.Tilt(1e-3)), (LOG, wk.Moment(3.0)), (wk.SharpEnds(), wk.Tilt(0.5e-3))],
)
def test_superposed_pressures_close_the_gap_and_bear_the_load(ends, alignment):
    problem = bearing(ends, alignment=alignment)
    found = problem.solve()
    state, half = found.last, 0.5 * problem.length
    loaded = state.force_per_length > 0.0
    step = state.y[1] - state.y[0]
    middles = state.x
    lengths = np.diff(state.edges)
    force = np.sum(state.pressure * lengths[:, None]) * step
    moment = np.sum(state.pressure * (lengths * middles)[:, None]) * step
    assert force == pytest.approx(4e3, rel=1e-6)
    assert moment == pytest.approx(found.moment, rel=1e-5)
    where = np.flatnonzero(loaded)[4:-4:7]
    for x in middles[where]:
        y = 0.21 * step
        moved = np.sum(state.pressure * love(x - middles[:, None], y - state.y, lengths[:, None], step))
        drop = float(ends.drop(np.array([x]), half, PAIR.modulus)[0])
        closed = found.depth + found.tilt * x - drop - y**2 / (2.0 * problem.radius)
        assert moved / (np.pi * PAIR.modulus) == pytest.approx(closed, abs=3e-3 * found.depth)


def test_a_height_map_of_a_short_roller_bears_the_same():
    """The other solver of the package: square pixels, another method, another grid."""
    n, length, tilt, radius, edge = 192, 2.0, 2e-2, 1.0, 0.4
    x = (np.arange(n) + 0.5) / n * length - 0.5 * length
    y = (np.arange(n // 2) + 0.5) / n * length - 0.25 * length
    ends = wk.RoundedEnds(edge)
    drop = ends.drop(x, 0.5 * length, 1.0) - tilt * x
    heights = -(drop[:, None] + y**2 / (2.0 * radius))
    depth = 0.06
    top = float(np.max(heights))
    surface = wk.SurfaceContact(wk.Topography(heights, [length, 0.5 * length]), SOFT, wk.Depth(depth + top)).solve()
    roller = wk.RollerContact(radius, length, ends, SOFT, wk.Depth(depth), wk.Tilt(tilt), 96).solve()
    assert roller.force == pytest.approx(surface.force, rel=2e-3)
    assert roller.stiffness == pytest.approx(surface.stiffness, rel=1e-2)
    assert roller.area == pytest.approx(surface.area, rel=2e-2)
    sums = np.sum(surface.last.pressure * x[:, None]) * (length / n) ** 2
    assert roller.moment == pytest.approx(sums, rel=5e-3)
    assert roller.peak_pressure == pytest.approx(np.max(surface.last.pressure), rel=2e-2)


SHAPES = [
    (wk.RoundedEnds(0.5e-3), wk.Tilt(0.0)),
    (wk.RoundedEnds(0.5e-3), wk.Tilt(1e-3)),
    (LOG, wk.Tilt(1e-3)),
    (wk.LogarithmicEnds(4e3 / 9.6e-3), wk.Moment(1.0)),
    (wk.CrownedEnds(0.5, 4e-3), wk.Tilt(2e-3)),
]


@pytest.mark.long
@pytest.mark.parametrize(("ends", "alignment"), SHAPES)
def test_the_usual_grid_is_within_one_per_cent_of_a_refined_one(ends, alignment):
    usual = bearing(ends, alignment=alignment, elements=160).solve()
    refined = bearing(ends, alignment=alignment, elements=320).solve()
    for name in ("depth", "peak_pressure", "middle_pressure", "edge_factor", "stiffness", "area"):
        assert getattr(usual, name) == pytest.approx(getattr(refined, name), rel=0.01), name
    assert usual.tilt == pytest.approx(refined.tilt, rel=0.01)
    assert usual.moment == pytest.approx(refined.moment, rel=0.01, abs=1e-6)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("ends", "alignment"), SHAPES[1:3])
def test_the_stated_error_of_the_grid_holds(ends, alignment):
    rough, fine = (bearing(ends, alignment=alignment, elements=count).solve() for count in (64, 192))
    for name in ("depth", "peak_pressure", "middle_pressure"):
        assert getattr(rough, name) == pytest.approx(getattr(fine, name), rel=max(rough.grid_error, 2e-3)), name


@pytest.mark.slow
def test_tilt_and_moment_and_force_and_depth_are_the_same_from_either_side():
    tilted = bearing(LOG, alignment=wk.Tilt(0.8e-3)).solve()
    turned = bearing(LOG, alignment=wk.Moment(tilted.moment)).solve()
    assert turned.tilt == pytest.approx(0.8e-3, rel=1e-3)
    assert turned.depth == pytest.approx(tilted.depth, rel=1e-4)
    pressed = bearing(LOG, wk.Depth(tilted.depth), wk.Tilt(0.8e-3)).solve()
    assert pressed.force == pytest.approx(4e3, rel=1e-3)
    both = bearing(LOG, wk.Depth(tilted.depth), wk.Moment(tilted.moment)).solve()
    assert (both.tilt, both.force) == (pytest.approx(0.8e-3, rel=2e-3), pytest.approx(4e3, rel=1e-3))
    mirrored = bearing(LOG, alignment=wk.Tilt(-0.8e-3)).solve()
    assert mirrored.moment == pytest.approx(-tilted.moment, rel=1e-4)
    free = bearing(LOG, alignment=wk.Moment(0.0)).solve()
    assert abs(free.tilt) < 1e-8


@pytest.mark.slow
def test_the_stiffness_is_the_slope_of_force_over_depth():
    for alignment in (wk.Tilt(1e-3), wk.Moment(3.0)):
        low, high = (bearing(LOG, wk.Force(force), alignment).solve() for force in (3.9e3, 4.1e3))
        middle = bearing(LOG, wk.Force(4e3), alignment).solve()
        assert middle.stiffness == pytest.approx(200.0 / (high.depth - low.depth), rel=0.01)


def test_tiny_and_huge_rollers_are_similar():
    one = wk.RollerContact(1.0, 2.0, wk.RoundedEnds(0.2), SOFT, wk.Depth(1e-3), elements=48).solve()
    for scale in (1e-9, 1e6):
        ends, depth = wk.RoundedEnds(0.2 * scale), wk.Depth(1e-3 * scale)
        other = wk.RollerContact(scale, 2.0 * scale, ends, SOFT, depth, elements=48).solve()
        assert other.force == pytest.approx(one.force * scale**2, rel=1e-9)
        assert other.edge_factor == pytest.approx(one.edge_factor, rel=1e-9)


def test_sharp_ends_have_no_greatest_pressure():
    found = bearing(wk.SharpEnds()).solve()
    assert found.peak_pressure == found.edge_factor == np.inf
    assert found.grid_error < 2e-3
    notes = [note for note in found.validity if note.assumption is Assumption.SHAPE]
    assert len(notes) == 1
    assert "infinite there, as at the edge of a punch" in notes[0].statement
    assert not [note for note in bearing(LOG).solve().validity if note.assumption is Assumption.SHAPE]
    weak, strong = (bearing(wk.CrownedEnds(radius)).solve().edge_factor for radius in (2.0, 0.5))
    assert weak == np.inf
    assert strong == pytest.approx(1.0, rel=1e-3)


def slopes_of(roller):
    (note,) = (one for one in roller.validity if one.assumption is Assumption.SMALL_SLOPES)
    return note


@pytest.mark.slow
def test_slopes_along_the_roller_and_its_tilt_are_stated():
    """A narrow crown is a ball of a smaller radius: the slope at the end of its ellipse is c / R_c."""
    ball = wk.RollerContact(1.0, 1.0, wk.CrownedEnds(1e-2), SOFT, wk.Force(2e-6)).solve()
    ellipse = wk.EllipticIndentation(wk.CurvedBodies(1.0, 1e-2), SOFT, wk.Force(2e-6)).solve()
    steepest = min(ellipse.longitudinal_semi_axis, ellipse.lateral_semi_axis) / 1e-2
    assert float(slopes_of(ball).statement.split(" is ")[1].split(":")[0]) == pytest.approx(steepest, rel=0.03)
    tilted = bearing(wk.LogarithmicEnds(4e5), alignment=wk.Tilt(-1.5))
    assert slopes_of(tilted.solve()).standing is Standing.OUTSIDE


def test_the_width_of_the_greatest_load_is_that_of_the_contact():
    falling = bearing(wk.CrownedEnds(0.05), wk.Force(np.array([4e3, 1e3]))).solve().validity
    (stated,) = (one for one in falling if "the body's radius" in one.statement)
    width = float(np.max(bearing(wk.CrownedEnds(0.05)).solve().last.half_width)) / 4.2e-3
    share = float(stated.statement.split(" is ")[1].split(" of")[0])
    assert width <= share <= 1.4 * width


def test_a_grid_that_only_just_reaches_the_end_says_so():
    ends = wk.LogarithmicEnds(1e6, crowned_share=0.4, edge_drop=20e-6)
    pair = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
    roller = wk.RollerContact(10e-3, 10e-3, ends, pair, wk.Force(10e3), wk.Tilt(1e-3), 64).solve()
    (note,) = (one for one in roller.validity if one.assumption is Assumption.RESOLUTION)
    assert note.standing is Standing.OUTSIDE
    assert "use more elements" in note.statement


def test_many_loads_are_taken_one_by_one():
    forces = np.array([1e3, 4e3])
    problem = bearing(LOG, wk.Force(forces), wk.Tilt(1e-3), 48)
    found = problem.solve()
    single = bearing(LOG, wk.Force(1e3), wk.Tilt(1e-3), 48).solve()
    assert found.depth[0] == single.depth
    np.testing.assert_allclose(found.force, forces, rtol=1e-9)
    assert problem.total == 2
    assert found.last.pressure.shape == (48, found.last.y.size)


def test_the_stress_below_a_roller_is_nearly_that_below_a_line_of_its_peak_pressure():
    """Johnson, sec. 4.2: 0.5575 p0 for nu = 0.3; the pressure of the ends is shorter than that of a line."""
    strong = wk.HalfSpace.between(wk.Elastic(208e9, 0.3, strength=1.8e9), STEEL)
    found = bearing(LOG, medium=strong, elements=48).solve()
    (note,) = [note for note in found.validity if note.assumption is Assumption.ELASTIC]
    assert note.standing is Standing.ASYMPTOTIC
    share = re.search(r"the greatest stress on this grid is ([\d.]+) of the strength of the first body", note.statement)
    assert float(share[1]) == pytest.approx(0.5575 * found.peak_pressure / 1.8e9, rel=0.02)
    pressed = dataclasses.replace(found.problem, load=wk.Force(40e3)).solve()
    assert [note.standing for note in pressed.validity if note.assumption is Assumption.ELASTIC] == [Standing.OUTSIDE]


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"load": wk.Force(-1.0)}, "give positive forces"),
        ({"load": wk.Depth(-1e-3)}, "do not touch; give more than 0"),
        ({"alignment": wk.Moment(20.0)}, "give less than 19.2 N m"),
        ({"ends": wk.CrownedEnds(1.0, 10e-3)}, "covers the whole roller"),
        ({"ends": wk.RoundedEnds(5e-3)}, "leave nothing of a roller"),
        ({"elements": 10}, "from 16 to 320"),
    ],
)
def test_what_is_no_roller_is_refused(change, sentence):
    with pytest.raises(wk.InvalidInput, match=sentence):
        dataclasses.replace(bearing(LOG), **change)


@pytest.mark.parametrize(
    ("radius", "elements"),
    [(1e6, 128), pytest.param(2e3, 320, marks=pytest.mark.long), pytest.param(1e6, 320, marks=pytest.mark.long)],
)
def test_a_roller_much_shorter_than_its_contact_is_as_wide_as_the_elements_that_bear(radius, elements):
    """The edge lies between the middles of the last element that bears and of the next; a coarse one is within 3 %."""
    wide, fine = (
        wk.RollerContact(radius, 2.0, wk.SharpEnds(), SOFT, wk.Depth(5e-2), elements=count).solve().last
        for count in (64, elements)
    )
    bears = fine.pressure[fine.x.size // 2] > 0.0
    half_element = 0.5 * (fine.y[1] - fine.y[0])
    edge = fine.y[bears].max() + half_element
    assert fine.half_width[fine.x.size // 2] == pytest.approx(edge, rel=0.0, abs=half_element)
    assert wide.half_width[wide.x.size // 2] == pytest.approx(edge, rel=0.0, abs=0.03 * edge + half_element)
    assert wide.half_width == pytest.approx(np.full(wide.x.size, wide.half_width.mean()), rel=0.01)


BASE = wk.Elastic(1.0, 0.3)
LAYERED = {
    "hard": wk.CoatedHalfSpace([wk.Layer(wk.Elastic(10.0, 0.3), 0.01)], on=BASE),
    "soft": wk.CoatedHalfSpace([wk.Layer(wk.Elastic(0.1, 0.3), 0.01)], on=BASE),
    "film": wk.SlidingFilm([wk.Layer(wk.Elastic(10.0, 0.3), 0.01)], on=BASE),
    "stack": wk.StackedHalfSpace(
        [wk.StackLayer(wk.Elastic(3.0, 0.3), 0.01), wk.StackLayer(wk.Elastic(0.3, 0.3), 0.02, bonded=False)], BASE
    ),
    "grading": wk.DepthGradedHalfSpace(wk.ExponentialGrading(0.3, 1.0, depth_scale=0.02, poisson=0.3)),
    "power": wk.GradedHalfSpace(wk.PowerLawGraded(1.0, 0.05, 0.4, 0.3)),
    "falling power": wk.GradedHalfSpace(wk.PowerLawGraded(1.0, 0.05, -0.4, 0.3)),
    "rubber": wk.CoatedHalfSpace([wk.Layer(wk.Elastic(0.01, 0.5), 0.02)], on=BASE),
}


def crowned(medium, elements=96, force=2e-4, crown=20.0):
    return wk.RollerContact(1.0, 2.0, wk.CrownedEnds(crown), medium, wk.Force(force), elements=elements).solve()


@pytest.mark.slow
@pytest.mark.parametrize("name", LAYERED)
def test_a_crown_on_layers_is_what_square_pixels_press(name):
    """Other grids, another solver: squares by fast transforms and conjugate gradients."""
    medium = LAYERED[name]
    pixels = wk.EllipticIndentation(wk.CurvedBodies(20.0, 1.0), medium, wk.Force(2e-4)).solve()
    found = crowned(medium)
    assert found.depth == pytest.approx(pixels.depth, rel=1e-3)
    assert found.stiffness == pytest.approx(pixels.stiffness, rel=0.01)
    assert found.peak_pressure == pytest.approx(pixels.peak_pressure, rel=max(2e-3, found.grid_error))
    assert found.area == pytest.approx(pixels.area, rel=2.0 / 12.0 + pixels.edge_error)


@pytest.mark.slow
def test_equal_layers_are_the_half_space_and_a_base_is_felt():
    def coated(young, thickness):
        return crowned(wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, 0.3), thickness)], on=BASE), elements=48)

    bare, equal = crowned(wk.HalfSpace(BASE), 48), coated(1.0, 0.02)
    for name in ("depth", "peak_pressure", "stiffness", "area"):
        assert getattr(equal, name) == pytest.approx(getattr(bare, name), rel=1e-9)
    for young in (0.1, 10.0):
        layer = crowned(wk.HalfSpace(wk.Elastic(young, 0.3)), 48)
        depths = [coated(young, thickness).depth for thickness in (1e-5, 1e-4, 0.03, 30.0, 300.0)]
        order = np.sort(depths) if young < 1.0 else np.sort(depths)[::-1]
        np.testing.assert_array_equal(depths, order)
        assert depths[0] == pytest.approx(bare.depth, rel=2e-2)
        assert abs(depths[0] - bare.depth) < 0.2 * abs(depths[1] - bare.depth)  # in proportion to h
        assert abs(depths[4] - layer.depth) < 0.2 * abs(depths[3] - layer.depth)  # and to 1/h
        assert depths[4] == pytest.approx(layer.depth, rel=2e-3)


def worked(depth, medium, elements=48):
    """Return the work that presses a crown so far, and the elastic energy of pressures and displacements."""
    nodes, weights = np.polynomial.legendre.leggauss(6)
    roots = 0.5 * (nodes + 1.0)  # of the depths over the greatest: the force rises as a power near 1.5 of the depth
    depths = depth * np.append(roots**2, 1.0)
    found = wk.RollerContact(1.0, 2.0, wk.CrownedEnds(20.0), medium, wk.Depth(depths), elements=elements).solve()
    work = depth * float(np.sum(weights * roots * found.force[:-1]))
    last = found.last
    sunk = depth - last.x[:, None] ** 2 / 40.0 - last.y**2 / 2.0
    areas = np.diff(last.edges)[:, None] * (last.y[1] - last.y[0])
    return work, 0.5 * float(np.sum(last.pressure * sunk * areas))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["soft", "hard", "stack", "power"])
def test_the_work_of_pressing_a_crown_is_the_energy_of_its_pressures(name):
    """All places that bear sink by what the crown leaves of the depth; nothing is lost."""
    work, stored = worked(2e-4, LAYERED[name])
    assert work == pytest.approx(stored, rel=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["soft", "hard"])
def test_the_error_of_a_crown_on_layers_falls_with_its_elements(name):
    """Against squares of pixels, by another solver: in proportion to the elements, and less than stated."""
    pixels = wk.EllipticIndentation(wk.CurvedBodies(20.0, 1.0), LAYERED[name], wk.Force(2e-4)).solve()
    for elements in (24, 48, 96):
        found = crowned(LAYERED[name], elements)
        depth, middle = (
            abs(found.depth / pixels.depth - 1.0),
            abs(found.middle_pressure / pixels.pressure(0.0, 0.0) - 1.0),
        )
        assert depth < min(0.1 / elements, found.grid_error)
        assert middle < min(0.5 / elements, found.grid_error)


@pytest.mark.slow
@pytest.mark.parametrize(("young", "thickness"), [(20.8e9, 1e-4), (2080e9, 1e-4), (20.8e9, 1e-2), (2080e9, 1e-2)])
def test_the_middle_of_a_long_roller_on_layers_is_an_endless_line(young, thickness):
    medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, 0.3), thickness)], on=STEEL)
    found = bearing(wk.RoundedEnds(0.5e-3), elements=160, medium=medium).solve().last
    middle = found.x.size // 2
    load = wk.LineForce(float(found.force_per_length[middle]))
    line = wk.LineIndentation(wk.LayeredLineFoundation(wk.Paraboloid(4.2e-3), medium), load).solve()
    assert found.middle_pressure == pytest.approx(line.peak_pressure, rel=0.01)
    assert found.half_width[middle] == pytest.approx(line.half_width, abs=found.y[-1] - found.y[-2])


def test_elements_add_what_a_layer_yields_by_direct_quadrature():
    """The integral over long elements of k, by Gauss' rule on each of them, where k is as smooth as the layer thick."""
    from winkler.media.mapped import layers_of
    from winkler.numerics.transforms.radial_kernel import radial_kernel

    below = layers_of(LAYERED["soft"])
    edges, across = np.array([-0.3, -0.28, -0.2, 0.0, 0.03, 0.3]), 0.004
    found = below.slices(edges, across, 5)
    kernel, middles = radial_kernel(below.response, 8), 0.5 * (edges[1:] + edges[:-1])
    node, weight = np.polynomial.legendre.leggauss(200)
    for row, place, element in np.ndindex(5, 5, 5):
        half = 0.5 * (edges[element + 1] - edges[element])
        x = middles[element] + half * node - middles[place]
        y = row * across + 0.5 * across * node
        k = kernel.at(np.hypot(x[:, None], y) / below.unit) / below.unit
        assert found[row, place, element] == pytest.approx(half * 0.5 * across * (weight @ k @ weight), rel=1e-5)


def test_a_film_too_thin_for_the_elements_and_gibsons_solid_are_refused():
    film = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(0.01, 0.5), 1e-5)], on=wk.Rigid())
    with pytest.raises(wk.OutsideValidity, match="too coarse"):
        crowned(film, 16)
    with pytest.raises(wk.OutsideValidity, match="Gibson"):
        crowned(wk.GradedHalfSpace(wk.PowerLawGraded(1.0, 0.05, 1.0, 0.5)), 16)
