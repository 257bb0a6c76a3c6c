"""The tabulated force of a machine against closed forms, and against every problem solved on its own."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq
from synthetic import hertz_on_spring, jkr_states

import winkler as wk
from winkler.fitting.elastic.response import response
from winkler.laws.adhesion import DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.problems.adhesion.edge_states import FarStates
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.problems.adhesion.law_states import states_of
from winkler.values.errors import OutsideValidity

GEL = wk.HalfSpace.between(wk.Elastic(1e4, 0.5))
E = GEL.modulus
R = 5e-6

PROFILES = [
    wk.Paraboloid(R),
    wk.Sphere(curvature_radius=R),
    wk.Cone(half_angle=1.2),
    wk.SpheroConical(curvature_radius=1e-6, half_angle=0.6),
    wk.TruncatedCone(half_angle=1.2, flat_radius=1e-6),
    wk.RoundedPunch(flat_radius=1e-6, edge_radius=1e-6),
    wk.FlatPunch(1e-6),
    wk.CappedCylinder(radius=2e-6, cap=wk.Paraboloid(R)),
    wk.PowerLaw(1e10, 3.0),
    wk.AreaFunction((24.5, 1e-7)),
]


@pytest.mark.parametrize("profile", PROFILES, ids=lambda profile: type(profile).__name__)
def test_it_is_the_problem_solved_depth_by_depth(profile):
    bed = wk.Foundation(profile, GEL)
    depth = np.geomspace(1e-11, 1e-6, 100)
    expected = wk.Indentation(bed, wk.Depth(depth)).solve()
    answer = response(FarStates(bed, 0.0), 0.0, 1e-6)
    for got in (answer.closing(depth), answer.opening(depth, 1e-6)):
        np.testing.assert_allclose(got.force, expected.force, rtol=2e-9)
        np.testing.assert_allclose(got.slope, expected.stiffness, rtol=2e-7)
        np.testing.assert_allclose(got.radius, expected.radius, rtol=2e-7)


def test_a_soft_machine():
    position = np.linspace(1e-9, 1e-6, 50)
    answer = response(FarStates(wk.Foundation(wk.Paraboloid(R), GEL), 0.0), 1.0 / 0.02, 1e-6)
    np.testing.assert_allclose(answer.closing(position).force, hertz_on_spring(position, E, R, 0.02), rtol=1e-12)


@pytest.mark.parametrize("stiffness", [0.01, 0.1, 1e6])
def test_jkr_on_a_machine(stiffness):
    work = 1e-4
    bed = wk.Foundation(wk.Paraboloid(R), GEL)
    place, force = jkr_states(E, R, work, stiffness, 3e-6)
    answer = response(states_of(bed, ShortRange(work)), 1.0 / stiffness, 1e-6)
    level, lost = answer.loss()
    # the limit itself from its own equation: dD/da = 0, as 1/k_m + d'/F'
    springs = np.sqrt(2.0 * np.pi * work / E)

    def rate(a):
        along = 2.0 * a / R - 0.5 * springs / np.sqrt(a)
        return along + (4.0 * E * a**2 / R - 1.5 * np.sqrt(8.0 * np.pi * work * E * a)) / stiffness

    edge = brentq(rate, 1e-9, 3e-6, xtol=1e-20)
    pull = 4.0 * E * edge**3 / (3.0 * R) - np.sqrt(8.0 * np.pi * work * E * edge**3)
    assert lost == pytest.approx(pull, rel=1e-9)
    assert level == pytest.approx(edge**2 / R - springs * np.sqrt(edge) + pull / stiffness, rel=1e-9)
    chosen = slice(50, None, 1000)
    inside = (place[chosen] < 1e-6) & (place[chosen] > answer.held[0].level)
    assert answer.held[0].level < level + 1e-4 * abs(level)
    got = answer.opening(place[chosen][inside], 1e-6).force
    np.testing.assert_allclose(got, force[chosen][inside], rtol=1e-8, atol=1e-9 * abs(pull))


@pytest.mark.parametrize("law", [Dugdale(1e-4, 5e3), DerjaguinMullerToporov(1e-4)], ids=["Dugdale", "DMT"])
def test_other_laws_are_the_problem_solved_depth_by_depth(law):
    bed = wk.Foundation(wk.Paraboloid(R), GEL)
    depth = np.linspace(1e-8, 1e-6, 20)
    expected = AdhesiveIndentation(bed, law, wk.Depth(depth)).solve()
    got = response(states_of(bed, law), 0.0, 1e-6).opening(depth, 1e-6)
    np.testing.assert_allclose(got.force, expected.force, rtol=1e-7, atol=1e-17)


def test_a_wavy_body_goes_in_and_out_on_different_branches():
    wave = wk.Sum((wk.Paraboloid(1e-4), wk.Wavy(amplitude=2e-8, wavelength=2e-6)))
    bed = wk.Foundation(wave, wk.HalfSpace.between(wk.Elastic(1e6, 0.5)))
    states = states_of(bed, ShortRange(1e-4))
    answer = response(states, 0.0, 4e-7)
    position = np.linspace(0.0, 4e-7, 60)
    inward, outward = answer.closing(position), answer.opening(position, 4e-7)
    assert np.all(inward.radius <= outward.radius * (1.0 + 1e-9))
    assert np.any(inward.radius < 0.99 * outward.radius)
    # brute force: along a fine line of radii the first and the last crossing of every depth, upwards
    radius = np.linspace(1e-9, 1.2 * outward.radius.max(), 400_001)
    depth = states.depth(radius)
    above = np.maximum.accumulate(depth)
    first = radius[np.searchsorted(above, position, side="right")]
    below = np.minimum.accumulate(depth[::-1])[::-1]
    last = radius[np.searchsorted(below, position, side="left") - 1]
    step = radius[1] - radius[0]
    # at a leap the place is as uncertain as the depth there; nearly all points are not at one
    assert np.mean(np.abs(inward.radius - first) < 3.0 * step) > 0.9
    assert np.mean(np.abs(outward.radius - last) < 3.0 * step) > 0.9


@pytest.mark.parametrize("stiffness", [0.01, 0.05, np.inf])
def test_at_its_limit_a_force_goes_straight_on(stiffness):
    """Under any machine the force falls steeply with D where the contact is lost; there is no corner for a fit."""
    bed = wk.Foundation(wk.Paraboloid(R), GEL)
    answer = response(states_of(bed, ShortRange(1e-4)), 1.0 / stiffness, 1e-6)
    level, force = answer.loss()
    straight = answer.held[0].level
    assert level < straight < level + 1e-4 * abs(level)
    around = straight + 1e-12 * np.linspace(-1.0, 1.0, 201)
    got = answer.opening(around, 1e-6)
    assert np.all(got.slope < 0.0)
    assert np.ptp(got.slope[around < straight]) == 0.0
    np.testing.assert_allclose(np.diff(got.force), 1e-14 * 0.5 * (got.slope[1:] + got.slope[:-1]), rtol=1e-2)
    assert answer.opening(np.array([level]), 1e-6).force[0] == pytest.approx(force, rel=0.01)


def test_what_is_not_in_contact_is_no_plateau():
    """Without contact DMT's pull would fit any tension; below first touch the branch leaves it at once."""
    bed = wk.Foundation(wk.Paraboloid(R), GEL)
    answer = response(states_of(bed, DerjaguinMullerToporov(1e-4)), 0.0, 1e-6)
    pull = -2.0 * np.pi * R * 1e-4
    below = answer.opening(np.array([-1e-9, -1e-7]), 1e-6)
    assert np.all(below.force < pull)
    assert below.force[1] < 2.0 * pull
    dry = response(FarStates(bed, 0.0), 0.0, 1e-6).opening(np.array([-1e-9, -1e-7]), 1e-6)
    np.testing.assert_allclose(dry.force, 0.0, atol=1e-30)


def test_a_contact_that_closes_without_end_is_refused():
    nearly_flat = wk.Foundation(wk.PowerLaw(1e-200, 1e-3), GEL)
    with pytest.raises(OutsideValidity, match="closes without end before the position 1e-06 m"):
        response(FarStates(nearly_flat, 0.0), 0.0, 1e-6)
