"""Measured profiles: what is made of points, and what is refused."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
import shape_solutions

import winkler as wk

UNIT = wk.HalfSpace.between(wk.Elastic(1.0, 0.0))
R = np.linspace(0.0, 1e-4, 41)
F = R**2 / 2e-2


def curve_slope(profile):
    """The slope of the chosen spline at 30 digits."""
    knots = [mp.mpf(k) for k in profile.curve.knots]
    parts = [[mp.mpf(v) for v in row] for row in profile.curve.derivatives]

    def slope(r):
        i = max(0, min(len(knots) - 2, sum(1 for k in knots if k <= r) - 1))
        t = r - knots[i]
        return parts[1][i] + t * parts[2][i] + t**2 / 2 * parts[3][i]

    return slope


@pytest.mark.slow
@pytest.mark.parametrize("count", [6, 9, 25])
def test_the_transform_of_the_curve_is_exact(count):
    """T1 of the very spline, by quadrature between its knots."""
    r = np.sort(np.random.default_rng(count).uniform(0.0, 1.0, count))
    r[0] = 0.0
    profile = wk.Measured(r, np.cosh(2.0 * r) + 0.3 * r)
    edges = [float(k) for k in profile.curve.knots[1:-1]]
    slope = curve_slope(profile)
    x = np.array([0.05, 0.31, 0.62, 0.93]) * profile.reach
    steepest = float(np.max(profile.slope(np.linspace(0.0, profile.reach, 500))))
    for v in x:
        place = np.array([v])
        assert profile.gap(place)[0] == pytest.approx(
            float(shape_solutions.gap(slope, v, edges)), abs=1e-10 * steepest * v
        )
        integral = float(shape_solutions.gap_integral(slope, v, edges))
        assert profile.gap_integral(place)[0] == pytest.approx(integral, abs=1e-10 * steepest * v**2)
        steep = float(shape_solutions.gap_slope(slope, v, edges))
        assert profile.gap_slope(place)[0] == pytest.approx(steep, abs=1e-10 * steepest)
        assert profile.height(place)[0] == pytest.approx(float(shape_solutions.height(slope, v, edges)), rel=1e-11)


@pytest.mark.parametrize("count", [6, 40, 256, 257, 3000])
@pytest.mark.parametrize(
    "twin", [wk.Paraboloid(3.0), wk.Cone(1.3), wk.PowerLaw(0.5, 3.0), wk.Cone(1.4) + wk.PowerLaw(0.5, 3.0)]
)
def test_what_a_cubic_can_hold_is_found_to_rounding(twin, count):
    r = np.linspace(0.0, 0.7, count)
    profile = wk.Measured(r, twin.height(r))
    x = np.array([0.01, 0.2, 0.69])
    np.testing.assert_allclose(profile.gap(x), twin.gap(x), rtol=1e-9, atol=1e-11 * twin.gap(x)[-1])
    np.testing.assert_allclose(profile.gap_slope(x), twin.gap_slope(x), rtol=1e-8)
    np.testing.assert_allclose(profile.gap_integral(x), twin.gap_integral(x), rtol=1e-7, atol=1e-11)


# ------------------------------------------------------------------------------------------- what is put right


def test_rows_in_any_order():
    order = np.random.default_rng(3).permutation(R.size)
    assert wk.Measured(R[order], F[order]).gap(R).tolist() == wk.Measured(R, F).gap(R).tolist()


def test_the_height_of_the_apex_is_free():
    np.testing.assert_allclose(wk.Measured(R, F + 7.3).gap(R), wk.Measured(R, F).gap(R), rtol=1e-7, atol=1e-15)
    assert wk.Measured(R, F + 7.3).height(np.zeros(1))[0] == 0.0


def test_equal_radii_are_averaged():
    """A scan across the apex, folded: both flanks, a little apart."""
    tilt = 1e-9 * np.sin(9e4 * R)
    both = wk.Measured(np.concatenate([R, R]), np.concatenate([F + tilt, F - tilt]))
    np.testing.assert_allclose(both.height(R), wk.Measured(R, F).height(R), atol=1e-15)


def test_the_apex_between_the_points():
    """The innermost point may stand a little off the axis."""
    off = wk.Measured(R[1:], F[1:])
    assert off.curve.knots[0] == 0.0
    np.testing.assert_allclose(off.gap(R), wk.Measured(R, F).gap(R), rtol=1e-7, atol=1e-15)


def test_numbers_and_lists_will_do():
    assert wk.Measured([0, 1, 2, 3, 4, 5], (0, 1, 4, 9, 16, 25)).gap(np.array([3.0]))[0] == pytest.approx(18.0)
    assert float(wk.Measured(R, F).gap(np.array(5e-5))) == pytest.approx(2.5e-7, rel=1e-9)
    assert wk.Measured(R, F).gap(R.reshape(1, 41)).shape == (1, 41)


# ------------------------------------------------------------------------------------------------ what is refused


def refused(radii, heights, match):
    with pytest.raises(wk.InvalidInput, match=match) as caught:
        wk.Measured(np.asarray(radii, dtype=float), np.asarray(heights, dtype=float))
    text = str(caught.value)
    assert text.startswith("Measured: ")
    assert text.endswith(".")
    assert "\n" not in text


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_values_that_are_not_finite(bad):
    spoilt = F.copy()
    spoilt[[7, 9]] = bad
    refused(R, spoilt, r"heights is -?(nan|inf) at index 7, 9; .*: remove these points\.")
    places = R.copy()
    places[7] = bad
    refused(places, F, r"radii is .* at index 7")


def test_shapes_that_do_not_match():
    refused(R, F[:-1], r"there are 41 radii and 40 heights; give two one-dimensional arrays")
    refused(R[:, None], F[:, None], r"radii has the shape \(.*\); give a row of")
    refused(0.0, 0.0, r"radii has the shape \(.*\); give a row of")


@pytest.mark.parametrize("bad", ["abc", ["a"] * 8, None, [1.0, [2.0, 3.0]]])
def test_points_that_are_no_numbers(bad):
    with pytest.raises(wk.InvalidInput, match="^Measured: "):
        wk.Measured(bad, F)
    with pytest.raises(wk.InvalidInput, match="^Measured: "):
        wk.Measured(R, bad)


def test_too_few_points():
    refused([], [], "0 different radii were given; a profile needs at least 6")
    refused(R[:5], F[:5], "5 different radii were given; a profile needs at least 6")
    refused([0, 1, 1, 2, 2, 3, 3, 3], [0, 1, 1, 4, 4, 9, 9, 9], "4 different radii were given")


def test_negative_radii():
    refused(R - 5e-5, F, r"radii is -5e-05 at index .*: give distances from the axis, or let read_profile fold")


def test_a_profile_that_falls():
    refused(R, -F, "the height falls by .* towards the radius 0.0001 m.*turn the sign if depths were given")
    dip = F - 2e-7 * np.exp(-(((R - 7e-5) / 1e-5) ** 2))
    refused(R, dip, "the height falls by")


def test_a_vertical_wall():
    wall = np.concatenate([F, [3e-6, 6e-6]])
    refused(np.concatenate([R, [1e-4, 1e-4]]), wall, "like a vertical wall; cut the data there and give CappedCylinder")


def test_an_apex_that_is_missing():
    refused(R[10:], F[10:], "the innermost point is at 2.5e-05 m of 0.0001 m; the apex must be measured too")


def test_a_flat_line_makes_no_tip():
    """Heights that do not rise at all: flat is allowed, it is a punch without an edge; then no depth can be met."""
    with pytest.raises((wk.InvalidInput, wk.OutsideValidity)):
        wk.Indentation(wk.Foundation(wk.Measured(R, np.full_like(R, 3.0)), UNIT), wk.Depth(1e-9)).solve()


# ---------------------------------------------------------------------------------------------------- clean data


@pytest.mark.few(1, slow=2)
@pytest.mark.parametrize("count", [16, 64, 128, 256, 257, 2048])
@pytest.mark.parametrize(
    ("twin", "reach"), [(wk.Hyperboloid(0.1, 1.2), 1.0), (wk.Sphere(1.0), 0.9), (wk.SpheroConical(0.5, 1.2), 1.0)]
)
def test_clean_data_can_be_pressed_and_restored(twin, reach, count):
    """Whatever the spline, all three loads are met, the pressure is finite on the axis and its total is the force."""
    r = np.linspace(0.0, reach, count)
    profile = wk.Measured(r, twin.height(r))
    bed = wk.Foundation(profile, UNIT)
    contact = wk.Indentation(bed, wk.Radius(0.5 * reach)).solve()
    by_force = wk.Indentation(bed, wk.Force(contact.force)).solve()
    by_depth = wk.Indentation(bed, wk.Depth(contact.depth)).solve()
    assert by_force.depth == pytest.approx(contact.depth, rel=1e-12)
    assert by_depth.force == pytest.approx(contact.force, rel=1e-12)
    fields = wk.restore(contact, np.array([0.0, 0.3, 0.99]) * contact.radius)
    exact = wk.restore(wk.Indentation(wk.Foundation(twin, UNIT), wk.Radius(0.5 * reach)).solve(), fields.r)
    if count >= 64:
        np.testing.assert_allclose(fields.pressure, exact.pressure, rtol=0.02 * (64.0 / count))
        np.testing.assert_allclose(fields.displacement, exact.displacement, rtol=1e-3 * (64.0 / count))


def test_clean_data_say_so():
    (note,) = wk.Measured(R, F).notes
    assert note.standing is wk.Standing.ASYMPTOTIC
    assert "cubic spline through 41 points, with a round apex; its transform is exact" in note.statement


def test_a_round_apex_is_recognised_and_a_pointed_one_left_alone():
    r = np.linspace(0.0, 1.0, 60)
    assert wk.Measured(r, wk.Sphere(2.0).height(r)).slope(np.zeros(1))[0] == 0.0
    assert wk.Measured(r, wk.Cone(1.2).height(r)).slope(np.zeros(1))[0] == pytest.approx(1.0 / math.tan(1.2), rel=1e-9)


@pytest.mark.parametrize("count", [64, 128, 256, 512])
def test_no_tip_falls_from_its_apex(count):
    """A tip too sharp for its points must not come out with a dimple."""
    r = np.linspace(0.0, 1.0, count)
    profile = wk.Measured(r, wk.Hyperboloid(0.1, 1.2).height(r))
    assert profile.slope(np.zeros(1))[0] >= 0.0
    assert profile.gap(np.array([1e-6]))[0] >= 0.0


@pytest.mark.slow
def test_a_measured_flat_end_is_restored():
    """Flat, then rising: the spline rings a little at the corner, which must not keep the pressure from its value."""
    r = np.linspace(0.0, 0.6, 200)
    bed = wk.Foundation(wk.Measured(r, np.maximum(r - 0.3, 0.0) ** 2), UNIT)
    twin = wk.Foundation(wk.RoundedPunch(0.3, 0.5), UNIT)
    contact, expected = (wk.Indentation(b, wk.Force(0.01)).solve() for b in (bed, twin))
    assert contact.depth == pytest.approx(expected.depth, rel=1e-4)
    x = np.array([0.0, 0.1, 0.25, 0.33])
    fields, compared = wk.restore(contact, x), wk.restore(expected, x)
    np.testing.assert_allclose(fields.pressure, compared.pressure, rtol=5e-3)
    np.testing.assert_allclose(fields.displacement, compared.displacement, rtol=1e-4)
