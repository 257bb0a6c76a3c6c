"""Springs in a row: the force converges with the second power of the cell width, wherever the edge cuts a cell."""

from __future__ import annotations

import numpy as np
import pytest
from slopes import order

import winkler as wk

MEDIUM = wk.HalfSpace(wk.Elastic(1.0, 0.0))
SHAPES = {
    "paraboloid": (wk.Paraboloid(1.0), 0.4),
    "sphere": (wk.Sphere(1.0), 0.6),
    "sharp": (wk.PowerLaw(0.5, 1.5), 0.4),
    "blunt": (wk.PowerLaw(0.5, 4.0), 0.4),
    "hyperboloid": (wk.Hyperboloid(1.0, 1.0), 0.8),
    "sphero-conical": (wk.SpheroConical(0.2, 0.8), 0.5),
    "rounded punch": (wk.RoundedPunch(0.2, 1.0), 0.5),
    "two bodies": (wk.Paraboloid(1.0) + wk.Cone(1.4), 0.4),
}
COUNTS = np.array([40, 80, 160, 320, 640])


@pytest.mark.parametrize("name", SHAPES)
def test_force_is_of_second_order(name):
    shape, radius = SHAPES[name]
    bed = wk.Foundation(shape, MEDIUM)
    exact = wk.Indentation(bed, wk.Radius(radius)).solve()

    def error(count: int) -> float:
        # the edge falls anywhere within a cell: the mean over many places of it is what has an order
        reach = radius * np.linspace(1.1, 1.3, 41)
        forces = [wk.Springs.of(bed, end, count).force(exact.depth) for end in reach]
        return float(np.sqrt(np.mean((np.array(forces) / exact.force - 1.0) ** 2)))

    errors = [error(int(count)) for count in COUNTS]
    assert 1.9 < order(COUNTS, errors) < 2.1
    assert errors[-1] < 1e-5


def test_under_a_cone_the_springs_are_exact():
    """The load falls along a straight line, and a straight line is what the edge is found with."""
    bed = wk.Foundation(wk.Cone(1.2), MEDIUM)
    exact = wk.Indentation(bed, wk.Radius(0.4)).solve()
    for reach in (0.47, 0.5, 1.0):
        assert wk.Springs.of(bed, reach, 15).force(exact.depth) == pytest.approx(exact.force, rel=1e-14)


@pytest.mark.parametrize("name", SHAPES)
def test_the_cut_cell_takes_the_jitter_out(name):
    """Whole cells alone are of second order too, but the force jumps about as the edge moves through a cell."""
    shape, radius = SHAPES[name]
    bed = wk.Foundation(shape, MEDIUM)
    exact = wk.Indentation(bed, wk.Radius(radius)).solve()
    for count in COUNTS:
        rows = [wk.Springs.of(bed, radius * end, int(count)) for end in np.linspace(1.1, 1.3, 41)]
        whole = [2.0 * float(row.line_load(exact.depth) @ row.width) / exact.force - 1.0 for row in rows]
        cut = [row.force(exact.depth) / exact.force - 1.0 for row in rows]
        assert np.max(np.abs(cut)) < np.max(np.abs(whole))
        assert np.std(cut) < 0.7 * np.std(whole)


def test_a_flat_punch_needs_no_order():
    bed = wk.Foundation(wk.FlatPunch(1.0), MEDIUM)
    assert wk.Springs.of(bed, 1.0, 10).force(0.1) == pytest.approx(0.2, rel=1e-14)


def test_a_kink_inside_the_contact_leaves_order_three_halves():
    """Above a kink g begins with a square root, which no row of equal cells meets."""
    bed = wk.Foundation(wk.TruncatedCone(1.2, 0.1), MEDIUM)
    exact = wk.Indentation(bed, wk.Radius(0.4)).solve()
    errors = []
    for count in COUNTS:
        forces = [wk.Springs.of(bed, 0.4 * end, int(count)).force(exact.depth) for end in np.linspace(1.1, 1.3, 41)]
        errors.append(float(np.sqrt(np.mean((np.array(forces) / exact.force - 1.0) ** 2))))
    assert 1.3 < order(COUNTS, errors) < 1.7
