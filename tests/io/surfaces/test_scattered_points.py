"""Heights at points x, y, z that lie on no full grid: a map between them, what is said of it, and what is no map."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.io.topography_file import read_topography
from winkler.profiles.rough.map_notes import map_notes
from winkler.study.inspection.inspect import inspect_file
from winkler.study.inspection.surfaces import SurfaceOptions
from winkler.values.errors import InvalidInput

RANDOM = np.random.default_rng(7)
X, Y = RANDOM.uniform(0.0, 3.0, 3000), RANDOM.uniform(0.0, 1.0, 3000)


def _file(tmp_path, points, name="cloud.xyz"):
    np.savetxt(tmp_path / name, points, fmt="%.9g")
    return tmp_path / name


def _places(found, low):
    """Centres of the pixels of a map whose lowest place is `low` [m]."""
    count = found.heights.shape
    axes = [low[axis] + found.lengths[axis] * (np.arange(count[axis]) + 0.5) / count[axis] for axis in (0, 1)]
    return np.meshgrid(*axes, indexing="ij")


def test_points_of_a_plane_are_that_plane_on_pixels_of_the_mean_area(tmp_path):
    """Linear interpolation keeps a plane; 3,000 points on 3 by 1 mm have squares of sqrt(1e-3) mm."""
    found = read_topography(_file(tmp_path, np.column_stack([X, Y, 0.1 * X - 0.2 * Y])), unit="mm")
    x, y = _places(found, 1e-3 * np.array([X.min(), Y.min()]))
    known = np.isfinite(found.heights)
    assert np.mean(known) > 0.97
    np.testing.assert_allclose(found.heights[known], (0.1 * x - 0.2 * y)[known], atol=1e-11)
    assert found.pixel == pytest.approx((1e-3 * 1e-3**0.5,) * 2, rel=0.03)
    assert found.reading.startswith("heights between 3000 points off a grid, on pixels of 31")
    assert any(found.reading in note.statement for note in map_notes(found))
    assert found.detrended(1).reading == found.reading


def test_a_hole_is_missing_and_the_share_is_said(tmp_path):
    """A ring of points: a circle of .25 of the radius around it is empty, and so are the corners."""
    radius = np.hypot(X / 3.0 - 0.5, Y - 0.5)
    ring = (radius < 0.5) & (radius > 0.25)
    points = np.column_stack([X / 3.0, Y, X])[ring]
    file = _file(tmp_path, points)
    found = read_topography(file, unit="um")
    x, y = _places(found, 1e-6 * points[:, :2].min(axis=0))
    from_middle = np.hypot(x - 0.5e-6, y - 0.5e-6)
    reach = 2.0 * max(found.pixel)
    assert np.all(np.isnan(found.heights[from_middle < 0.25e-6 - reach]))
    assert np.all(np.isfinite(found.heights[(from_middle > 0.25e-6) & (from_middle < 0.48e-6 - 0.5 * reach)]))
    filled = 1.0 - found.missing / found.heights.size
    assert found.reading.endswith(f"; {filled:.0%} of them have a height")
    shown = inspect_file(file, SurfaceOptions(unit="um"))
    assert shown.taken_for == "height map"
    assert any(found.reading in doubt for doubt in shown.doubts)


def test_pixels_are_long_where_scan_lines_are_far_apart(tmp_path):
    """Forty lines, 50 um apart, of 400 places each, about 1 um apart: a pixel is some fifty times as long as wide."""
    along = np.arange(400.0) + RANDOM.uniform(-0.3, 0.3, (40, 400))
    across = 50.0 * np.arange(40.0)[:, None] + RANDOM.uniform(-3.0, 3.0, (40, 400))
    points = np.column_stack([along.ravel(), across.ravel(), 0.01 * along.ravel() + 0.001 * across.ravel()])
    found = read_topography(_file(tmp_path, points), unit="um")
    assert 20.0 < found.pixel[1] / found.pixel[0] < 100.0
    assert found.missing < 0.05 * found.heights.size
    x, y = _places(found, 1e-6 * points[:, :2].min(axis=0))
    known = np.isfinite(found.heights)
    np.testing.assert_allclose(found.heights[known], (0.01 * x + 0.001 * y)[known], atol=1e-13)


def test_a_grid_keeps_its_heights_where_points_lack(tmp_path):
    x, y = (one.ravel() for one in np.meshgrid(np.arange(8.0), np.arange(6.0), indexing="ij"))
    points = np.column_stack([x, y, x * y])
    kept = np.ones(48, dtype=bool)
    kept[[7, 20, 33]] = False
    found = read_topography(_file(tmp_path, points[kept]), unit="um")
    expected = np.where(kept, 1e-6 * x * y, np.nan).reshape(8, 6)
    np.testing.assert_allclose(found.heights, expected, atol=1e-18)
    assert found.lengths == pytest.approx([8e-6, 6e-6])
    assert found.reading == ""


def test_points_at_one_place_are_averaged_and_counted(tmp_path):
    points, up = np.column_stack([X, Y, 0.1 * X]), np.array([0.0, 0.0, 0.05])
    again = np.concatenate([points + up, points - up])
    once, twice = (read_topography(_file(tmp_path, one), unit="um") for one in (points, again))
    np.testing.assert_allclose(twice.heights, once.heights, atol=1e-14)
    assert "6000 points off a grid, 3000 of them at the place of another, averaged, on pixels" in twice.reading


def _sphere():
    points = RANDOM.normal(size=(4000, 3))
    return points / np.linalg.norm(points, axis=1)[:, None]


TIME = np.linspace(0.0, 1.0, 2000)


@pytest.mark.parametrize(
    ("points", "sentence"),
    [
        (_sphere(), "heights of neighbours differ nearly as much as any two, as on a body with two sides"),
        (np.column_stack([X, Y, RANDOM.normal(size=3000)]), "heights of neighbours differ nearly as much"),
        (np.column_stack([TIME, np.minimum(TIME, 1.0 - TIME), TIME**1.5]), "as many pixels as points would be 8"),
        (np.column_stack([np.sin(6.28 * TIME), TIME * (1.0 - TIME), TIME]), "as many pixels as points would be 8"),
        (np.column_stack([TIME, 2.0 * TIME, TIME]), "as many pixels as points would be 9"),
        (np.column_stack([TIME, 0.0 * TIME, TIME]), "they are on one line, or fewer than 16"),
        (np.column_stack([1e200 * X, 1e-200 * Y, X]), "they are close to one line"),
    ],
    ids=["sphere", "noise", "time_position_force", "loop", "diagonal", "line", "extreme"],
)
def test_what_is_no_surface_is_refused_in_a_sentence(tmp_path, points, sentence):
    """A closed body, noise, and tables of three columns without names, whose first two are on a curve."""
    with pytest.raises(InvalidInput, match=f"points x, y, z are no map, for {sentence}"):
        read_topography(_file(tmp_path, points), unit="um")


def test_a_lower_half_of_a_sphere_is_a_map(tmp_path):
    """A linear interpolation errs by at most half the curvature times the square of the circle around a triangle."""
    points = _sphere()
    found = read_topography(_file(tmp_path, points[points[:, 2] < 0.0]), unit="mm")
    x, y = _places(found, 1e-3 * points[points[:, 2] < 0.0][:, :2].min(axis=0))
    inside = np.hypot(x, y) < 0.5e-3
    curvature = 1e-6 / (1e-6 - 0.25e-6) ** 1.5
    bound = 0.5 * curvature * (2.0 * max(found.pixel)) ** 2
    expected = -np.sqrt(1e-6 - x[inside] ** 2 - y[inside] ** 2)
    np.testing.assert_allclose(found.heights[inside], expected, atol=bound)


def test_too_many_points_are_refused(tmp_path, monkeypatch):
    monkeypatch.setattr("winkler.io.height_matrix.MOST_SCATTERED", 100)
    with pytest.raises(InvalidInput, match="3000 points are off a grid; at most 100 are read: thin them out"):
        read_topography(_file(tmp_path, np.column_stack([X, Y, X])), unit="mm")


def test_bare_points_without_a_unit_say_so(tmp_path):
    shown = inspect_file(_file(tmp_path, np.column_stack([X, Y, X]), "points.txt"))
    assert not shown.is_read
    assert "does not state the unit of its heights; give unit" in shown.reason
