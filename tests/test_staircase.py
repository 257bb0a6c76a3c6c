"""Jaeger's staircase against closed forms, with the order in which it converges, and against `restore`."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.testing import assert_allclose

from winkler.fields.punch_staircase import Staircase, staircase
from winkler.fields.restoration import restore
from winkler.foundation.foundation import Foundation
from winkler.foundation.plane import PlaneFoundation
from winkler.loading.loads import Depth, Force, Radius
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.problems.normal.indentation import Indentation
from winkler.profiles.conical import Cone, SpheroConical, TruncatedCone
from winkler.profiles.flat import CappedCylinder, FlatPunch
from winkler.profiles.power import Paraboloid, PowerLaw
from winkler.profiles.rounded import RoundedPunch
from winkler.profiles.sphere import Sphere
from winkler.values.errors import InvalidInput, OutsideValidity

UNIT = HalfSpace(Elastic(1.0, 0.0))  # E* = 1
COUNTS = (40, 80, 160, 320, 640)

SHAPES = {
    "paraboloid": Paraboloid(1.0),
    "sphere": Sphere(1.0),
    "power": PowerLaw(1.0, 6.0),
    "truncated cone": TruncatedCone(1.4, 0.2),
    "rounded punch": RoundedPunch(0.2, 1.0),
    "sphero-conical": SpheroConical(0.3, 1.2),
}


def contact(profile, radius=0.5):
    return Indentation(Foundation(profile, UNIT), Radius(radius)).solve()


def order(errors):
    """Return the order in which errors fall, fitted over all counts."""
    return -np.polyfit(np.log(COUNTS), np.log(errors), 1)[0]


def test_a_flat_punch_is_one_step():
    solution = Indentation(Foundation(FlatPunch(2.0), UNIT), Depth(0.1)).solve()
    punches = staircase(solution, 5)
    assert_allclose(punches.radii, [2.0])
    assert_allclose(punches.increments, [0.1])
    assert_allclose(punches.force, 2 * 2.0 * 0.1, rtol=1e-15)
    r = np.array([0.0, 1.0, 1.9])
    assert_allclose(punches.pressure(r), 0.1 / (np.pi * np.sqrt(4.0 - r**2)), rtol=1e-14)
    assert np.isinf(punches.pressure(2.0))
    assert_allclose(punches.displacement([0.0, 2.0]), 0.1, rtol=1e-15)
    assert_allclose(punches.displacement(5.0), 0.2 / np.pi * math.asin(0.4), rtol=1e-14)
    assert_allclose(punches.force_within([0.0, 1.0, 2.0, 9.0]), [0.0, 0.2 * (2 - math.sqrt(3)), 0.4, 0.4], rtol=1e-13)


@pytest.mark.parametrize("name", SHAPES)
def test_the_depth_is_met_exactly(name):
    solution = contact(SHAPES[name])
    assert_allclose(staircase(solution, 17).depth, solution.depth, rtol=1e-14)


@pytest.mark.parametrize("name", SHAPES)
def test_the_force_converges_in_second_order_also_over_kinks(name):
    solution = contact(SHAPES[name])
    errors = [abs(staircase(solution, count).force / solution.force - 1.0) for count in COUNTS]
    assert 1.95 < order(errors) < 2.05
    assert errors[-1] < 2e-6


def test_the_force_of_a_cone_is_exact_because_g_is_straight():
    solution = contact(Cone(1.4))
    assert_allclose(solution.force, 0.5 * np.pi * 0.25 / math.tan(1.4), rtol=1e-13)
    assert_allclose(staircase(solution, 7).force, solution.force, rtol=1e-14)


def test_outside_displacement_converges_in_second_order_to_the_closed_form():
    r = np.array([0.55, 0.8, 1.0, 3.0])
    ratio = r / 0.5
    exact = 0.25 / np.pi * ((2.0 - ratio**2) * np.arcsin(1.0 / ratio) + np.sqrt(ratio**2 - 1.0))
    assert_allclose(exact[2], 0.0544988905, atol=1e-10)  # theory sheet, section 1.1
    errors = [np.max(np.abs(staircase(contact(Paraboloid(1.0)), count).displacement(r) - exact)) for count in COUNTS]
    assert 1.97 < order(errors) < 2.03


def test_inside_displacement_converges_in_order_three_halves():
    r = np.linspace(0.03, 0.47, 23)
    exact = 0.25 - r**2 / 2.0  # d - f(r)
    errors = [np.max(np.abs(staircase(contact(Paraboloid(1.0)), count).displacement(r) - exact)) for count in COUNTS]
    assert 1.3 < order(errors) < 1.7
    assert errors[-1] < 1e-5


def test_the_force_within_a_circle_converges_to_hertz():
    solution = contact(Paraboloid(1.0))
    r = np.linspace(0.03, 0.47, 23)
    exact = solution.force * (1.0 - (1.0 - (r / 0.5) ** 2) ** 1.5)
    errors = [np.max(np.abs(staircase(solution, count).force_within(r) - exact)) for count in COUNTS]
    assert 1.3 < order(errors) < 1.8


@pytest.mark.parametrize(("below", "expected"), [(0.5, 0.5), (0.302721828, 1.5)])
def test_the_pressure_converges_as_the_zeta_function_says(below, expected):
    """A step's edge leaves an error zeta(1/2, below) / sqrt(count); it vanishes 0.3027 of a step below the edge."""
    errors = []
    for count in COUNTS:
        punches = staircase(contact(Paraboloid(1.0)), count)
        r = punches.radii[count // 4 : 3 * count // 4] - below * 0.5 / count
        exact = 2 * 0.5 / np.pi * np.sqrt(1.0 - (r / 0.5) ** 2)
        errors.append(np.max(np.abs(punches.pressure(r) - exact)))
    assert expected - 0.05 < order(errors) < expected + 0.05


@pytest.mark.parametrize("name", SHAPES)
def test_it_agrees_with_restored_fields(name):
    solution = contact(SHAPES[name])
    punches = staircase(solution, 2000)
    r = np.array([0.07, 0.31, 0.44, 0.52, 0.9, 4.0])
    assert_allclose(punches.displacement(r), restore(solution, r).displacement, atol=3e-6 * solution.depth)


def test_a_contact_pinned_at_the_rim_has_a_last_wide_step():
    body = CappedCylinder(0.5, Paraboloid(1.0))
    solution = Indentation(Foundation(body, UNIT), Depth(0.4)).solve()
    punches = staircase(solution, 3000)
    assert_allclose(punches.radii[-1], 0.5)
    assert_allclose(punches.increments[-1], 0.4 - 0.25, rtol=1e-12)
    assert_allclose(punches.force, 1.0 / 6.0 + 2 * 0.5 * 0.15, rtol=1e-6)
    r = np.array([0.2, 0.6, 2.0])
    assert_allclose(punches.displacement(r), restore(solution, r).displacement, rtol=3e-6)


def test_a_plane_profile_that_was_given():
    solution = Indentation(PlaneFoundation(PowerLaw(1.0, 2.0), UNIT), Radius(0.5)).solve()  # g = x^2: a ball with R = 1
    punches = staircase(solution, 400)
    assert_allclose(punches.force, 1.0 / 6.0, rtol=1e-5)
    assert_allclose(punches.displacement(1.0), 0.0544988905, rtol=1e-5)


def test_moduli_scale_pressure_and_force_only():
    stiff = HalfSpace(Elastic(210e9, 0.3), Elastic(72e9, 0.17))
    soft, hard = (
        staircase(Indentation(Foundation(Sphere(1.0), medium), Radius(0.1)).solve(), 9) for medium in (UNIT, stiff)
    )
    assert_allclose(hard.force, soft.force * stiff.modulus, rtol=1e-14)
    assert_allclose(hard.pressure(0.033), soft.pressure(0.033) * stiff.modulus, rtol=1e-14)
    assert_allclose(hard.displacement(0.3), soft.displacement(0.3), rtol=1e-14)


def test_no_contact_no_steps():
    punches = staircase(Indentation(Foundation(Sphere(1.0), UNIT), Force(0.0)).solve(), 4)
    assert punches.radii.size == 0
    assert punches.force == punches.depth == 0.0
    assert_allclose(punches.pressure([0.0, 1.0]), 0.0)
    assert_allclose(punches.displacement(np.zeros((2, 3))), np.zeros((2, 3)))


def test_many_places_and_punches_keep_their_shape():
    punches = staircase(contact(Sphere(1.0)), 5000)
    r = np.linspace(0.0, 1.0, 900).reshape(30, 30)
    assert_allclose(punches.displacement(r).ravel()[7], punches.displacement(r.ravel()[7]), rtol=1e-14)
    assert punches.pressure(r).shape == (30, 30)
    assert punches.pressure([]).shape == (0,)


def test_it_is_a_value():
    assert staircase(contact(Sphere(1.0)), 5) == staircase(contact(Sphere(1.0)), 5)
    assert len({staircase(contact(Sphere(1.0)), count) for count in (5, 5, 6)}) == 2
    assert not staircase(contact(Sphere(1.0)), 5).radii.flags.writeable


@pytest.mark.parametrize("count", [0, -3, 2.5, True, "8"])
def test_a_count_that_is_none(count):
    with pytest.raises(InvalidInput, match="count is .*; give a whole number of punches"):
        staircase(contact(Sphere(1.0)), count)


def test_fewer_punches_than_pieces():
    profile = TruncatedCone(1.4, 0.1) + TruncatedCone(1.4, 0.2) + TruncatedCone(1.4, 0.3)
    with pytest.raises(InvalidInput, match="the shape has 3 pieces"):
        staircase(contact(profile), 2)


def test_places_that_are_none():
    punches = staircase(contact(Sphere(1.0)), 5)
    for r in (-0.1, math.nan, math.inf):
        with pytest.raises(InvalidInput, match="staircase: r holds values"):
            punches.pressure(r)


def test_a_medium_without_closed_form_punches():
    class Other:
        pass

    class Bed:
        medium = Other()

    class Pressed:
        bed = Bed()

    class Solution:
        pressed = Pressed()

    with pytest.raises(OutsideValidity, match="no closed form on a Other"):
        staircase(Solution(), 5)


def test_many_loads_are_refused_with_a_remedy():
    solution = Indentation(Foundation(Sphere(1.0), UNIT), Force(np.array([1e-3, 2e-3]))).solve()
    with pytest.raises(InvalidInput, match=r"solution\.at"):
        staircase(solution, 5)
    assert isinstance(staircase(solution.at(0), 5), Staircase)
