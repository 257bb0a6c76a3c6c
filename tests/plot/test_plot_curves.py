"""The numbers behind the pictures: they are those of the solutions, in the units of the labels."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose

from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth, Force
from winkler.materials.elastic import Elastic, Rigid
from winkler.media.halfspace import HalfSpace
from winkler.plot.dispatch import sheet_of
from winkler.plot.extent import around, is_singular, sunk, typical
from winkler.plot.families import spans_decades
from winkler.plot.normal.body import _revolved, _round
from winkler.plot.normal.curves import force_depth, line_load, surface
from winkler.plot.normal.springs import plane_profile, springs_panel, stretched
from winkler.plot.normal.stresses import first_body_deforms
from winkler.plot.panel import Sheet
from winkler.plot.render import render
from winkler.problems.normal.indentation import Indentation
from winkler.profiles.conical import Cone, SpheroConical, TruncatedCone
from winkler.profiles.flat import CappedCylinder, FlatPunch
from winkler.profiles.power import Paraboloid
from winkler.profiles.sphere import Sphere

STEEL = HalfSpace(Elastic(210e9, 0.3))
R = 10e-3


def pressed(profile, load, medium=STEEL):
    return Indentation(Foundation(profile, medium), load).solve()


BALL = pressed(Paraboloid(R), Force(100.0))
PUNCH = pressed(FlatPunch(1e-3), Force(100.0))
PINNED = pressed(CappedCylinder(1e-4, Paraboloid(R)), Depth(5e-6))
TRUNCATED = pressed(TruncatedCone(1.4, 1e-4), Depth(30e-6))


@pytest.mark.parametrize("solution", [BALL, PUNCH, PINNED, TRUNCATED], ids=["ball", "punch", "pinned", "truncated"])
def test_the_area_below_the_line_load_is_the_force(solution):
    curve = line_load(solution, 2.0 * solution.radius)
    assert_allclose(np.trapezoid(curve.of.content, curve.along.content), solution.force, rtol=2e-4)
    assert_allclose(curve.along.content[[0, -1]], [-2.0 * solution.radius, 2.0 * solution.radius])
    assert_allclose(curve.of.content[[0, -1]], 0.0)


@pytest.mark.slow
def test_springs_that_only_round_do_not_pull():
    """The edge of a contact without adhesion: g(a) = d but for the last digit, of either sign."""
    edges, drawn = [], 0
    for force in np.geomspace(1.0, 100.0, 40):
        for profile in (Paraboloid(R), Cone(0.1), Sphere(R)):
            solution = pressed(profile, Force(float(force)))
            edges.append(float(np.min(solution.pressed.value(np.linspace(0.0, solution.radius, 33)))))
            assert not stretched(solution.pressed.value(np.linspace(0.0, solution.radius, 33))).any()
            if edges[-1] < 0.0 and drawn < 4:
                drawn += 1
                assert "blue springs pull" not in [text.get_text() for text in sheet_of_springs(solution).texts]
    assert min(edges) < 0.0  # or nothing is tested


def sheet_of_springs(solution):
    return render(Sheet((springs_panel(solution.pressed, 2.0 * solution.radius),))).axes[0]


def test_the_line_load_jumps_at_a_pinned_edge():
    curve = line_load(PUNCH, 2e-3)
    at_edge = curve.of.content[curve.along.content == 1e-3]
    assert_allclose(sorted(at_edge), [0.0, STEEL.modulus * PUNCH.depth], rtol=1e-12)


@pytest.mark.parametrize("solution", [BALL, PUNCH, PINNED, TRUNCATED], ids=["ball", "punch", "pinned", "truncated"])
def test_force_over_depth_ends_at_the_contact_and_is_the_one_that_is_solved(solution):
    curve = force_depth(solution.pressed)
    assert_allclose(curve.along.content[-1], solution.depth)
    assert_allclose(curve.of.content[-1], solution.force, rtol=1e-12)
    middle = curve.along.content.size // 2
    again = pressed(solution.problem.bed.profile, Depth(curve.along.content[middle]))
    assert_allclose(curve.of.content[middle], again.force, rtol=1e-10, atol=1e-12 * solution.force)


def test_force_over_depth_of_hertz():
    curve = force_depth(BALL.pressed)
    exact = 4.0 / 3.0 * STEEL.modulus * np.sqrt(R) * curve.along.content**1.5
    assert_allclose(curve.of.content, exact, rtol=1e-12, atol=1e-12)


def test_force_over_depth_has_a_gap_where_the_contact_is_no_disc():
    class Bumpy:
        """g rises, falls, and rises again."""

        def gap(self, x):
            return np.where(x < 1.0, x, np.where(x < 2.0, 2.0 - x, x - 2.0))

        def stiffness(self, a):
            return 2.0 * a

        def gap_load(self, a):
            return 0.0 * a

    class Pressed:
        bed, radius, depth = Bumpy(), 4.0, 2.0

    force = force_depth(Pressed()).of.content
    a = 4.0 * np.linspace(0.0, 1.0, force.size - 1)
    assert np.all(np.isnan(force[:-1][(a > 1.01) & (a < 2.99)]))
    assert np.all(np.isfinite(force[:-1][(a < 0.99) | (a > 3.01)]))


def test_curves_over_many_loads_are_sorted_by_depth():
    force, radius, _ = sheet_of(pressed(Sphere(R), Force(np.array([100.0, 1.0, 10.0])))).panels
    assert_allclose(force.marks[0].y, [1.0, 10.0, 100.0])
    assert np.all(np.diff(radius.marks[0].x) > 0.0)


def test_surface_fields_for_a_picture_stay_finite():
    for solution in (BALL, PUNCH, PINNED, TRUNCATED):
        fields = surface(solution, 2.0 * solution.radius)
        assert np.all(np.isfinite(fields.pressure))
        assert np.max(fields.pressure) > 2.0 * solution.mean_pressure or solution is BALL


@pytest.mark.parametrize(
    ("profile", "expected"),
    [
        (Paraboloid(R), False),
        (Sphere(R), False),
        (SpheroConical(1e-3, 1.2), False),
        (Cone(1.4), True),
        (TruncatedCone(1.4, 1e-5), True),
        (FlatPunch(1e-3), True),
    ],
    ids=lambda item: type(item).__name__ if not isinstance(item, bool) else str(item),
)
def test_where_the_pressure_is_infinite(profile, expected):
    assert is_singular(pressed(profile, Force(1.0)).pressed) is expected


def test_the_rim_counts_only_when_it_is_reached():
    body = CappedCylinder(1e-4, Paraboloid(R))
    assert not is_singular(pressed(body, Depth(0.5e-6)).pressed)
    assert is_singular(pressed(body, Depth(5e-6)).pressed)


def test_the_dent_of_hertz():
    a = BALL.radius
    assert_allclose(sunk(BALL.pressed, np.array([0.0, a])), [BALL.depth, 0.5 * BALL.depth], rtol=1e-10)
    apart = pressed(Sphere(R), Depth(-1e-6))
    assert_allclose(sunk(apart.pressed, np.linspace(0.0, R, 5)), 0.0)


def test_how_far_a_picture_goes():
    assert around(BALL.pressed, None) == 1.8 * BALL.radius
    assert around(BALL.pressed, 0.3) == 0.3
    assert typical(Sphere(R)) == 0.6 * R
    assert typical(FlatPunch(1e-3)) == 1e-3
    assert typical(TruncatedCone(1.4, 1e-4)) == pytest.approx(3e-4)
    assert typical(Cone(1.4)) == 1e-3
    apart = pressed(Sphere(R), Depth(-1e-6)).pressed
    extent = around(apart, None)
    assert 3e-6 < apart.bed.height(np.array(extent)) < 6e-6  # the gap of 1 um is in the picture


def test_the_plane_profile_ends_where_the_body_ends():
    x, g = plane_profile(PUNCH.problem.bed, 2e-3)
    assert x.content[-1] == 1e-3
    assert_allclose(g.content, 0.0)
    x, g = plane_profile(BALL.problem.bed, 1e-3)
    assert_allclose(g.content, x.content**2 / R, rtol=1e-14)


def test_the_map_shows_the_body_that_deforms():
    soft = Elastic(1e7, 0.49)
    assert first_body_deforms(pressed(Sphere(R), Force(1.0), HalfSpace(soft)))
    assert not first_body_deforms(pressed(Sphere(R), Force(1.0), HalfSpace(Rigid(), soft)))


def test_logarithmic_axes_are_for_decades():
    assert spans_decades(np.geomspace(1.0, 1e3, 5))
    assert not spans_decades(np.linspace(1.0, 10.0, 5))
    assert not spans_decades(np.array([0.0, 1.0, 1e3]))
    assert not spans_decades(np.array([1.0, 1e3]))


def test_facets_of_a_cone_face_outward_and_have_its_slope():
    r = np.linspace(0.0, 1.0, 4)
    facets = _revolved(r, 0.5 * r, np.linspace(0.0, 2 * np.pi, 13), -1.0, lambda _: np.zeros(3))
    assert facets.corners.shape == (36, 4, 3)
    middle = facets.corners.mean(axis=1)
    assert np.all(np.sum(facets.normals[:, :2] * middle[:, :2], axis=1) > 0.0)
    assert_allclose(facets.normals[:, 2], -1.0 / np.sqrt(1.25), rtol=1e-12)
    assert_allclose(np.linalg.norm(facets.normals, axis=1), 1.0, rtol=1e-12)


@pytest.mark.parametrize(("length", "bar"), [(3.4e-4, 2e-4), (1.0, 1.0), (9.9e-9, 5e-9), (5.0, 5.0)])
def test_bars_are_round(length, bar):
    assert_allclose(_round(length), bar, rtol=1e-12)
