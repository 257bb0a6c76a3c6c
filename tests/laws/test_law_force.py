"""Force, depth, radius, stiffness and energy of every shape: what must hold between them, whatever their numbers."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from contacts import FREE, PINNED, Contact, along, contacts, examples, graded, over_shapes
from hypothesis import given
from hypothesis import strategies as st
from media_cases import MEDIA
from shapes import KINDS

import winkler as wk


def press(contact: Contact, depth) -> wk.IndentationSolution:
    return wk.Indentation(contact.bed(), wk.Depth(depth)).solve()


@over_shapes(16, 2)
def test_force_rises_convexly_with_the_stiffness_as_its_slope(contact):
    depth = contact.depth * np.linspace(0.02, 1.0, 9)
    solution = press(contact, depth)
    assert np.all(np.diff(solution.force) > 0.0)
    assert np.all(np.diff(solution.radius) >= 0.0)
    # by the mean value theorem every chord of F(d) lies between the stiffnesses at its ends: no step is too long
    chord = np.diff(solution.force) / np.diff(depth)
    slack = 1e-11 * solution.stiffness[-1]
    assert np.all(solution.stiffness[:-1] <= chord + slack)
    assert np.all(chord <= solution.stiffness[1:] + slack)


@over_shapes(16, 2)
def test_a_small_step_of_depth_measures_the_stiffness(contact):
    bed, depth, step = contact.bed(), contact.depth, 1e-5
    solution = press(contact, depth * (1.0 + step * np.arange(-2.0, 3.0)))
    if any(solution.radius[0] < b < solution.radius[-1] for b, _ in bed.kinks):
        assert solution.stiffness[0] <= solution.stiffness[4]  # a kink within the step bends F(d)
        return
    measured = np.dot(solution.force, [1.0, -8.0, 0.0, 8.0, -1.0]) / (12.0 * step * depth)
    assert measured == pytest.approx(solution.stiffness[2], rel=1e-8)
    assert solution.stiffness[2] == pytest.approx(2.0 * bed.medium.modulus * solution.radius[2], rel=1e-15)


@over_shapes(4, 1)
def test_one_place_is_as_good_as_an_array_of_one(contact):
    """The crack along rubber goes from place to place, which numpy computes faster without an axis."""
    bed = contact.bed()
    for function in (bed.gap, bed.gap_load, bed.stiffness, bed.normal_stiffness):
        alone = float(function(np.array(contact.radius)))
        assert alone == pytest.approx(float(function(np.array([contact.radius]))[0]), rel=1e-14)


@over_shapes(12, 1)
def test_the_work_done_is_the_energy_stored(contact):
    solution, bed = contact.solve(), contact.bed()
    # beyond the depth at which a kink is reached F is a smooth function of the square root of what is added
    kinks = np.array([b for b, _ in bed.kinks if contact.specimen.flat * contact.unit < b < solution.radius])
    closing = [float(bed.gap(np.array([solution.radius]))[0])] if contact.specimen.pinned else []
    cuts = [0.0, *bed.gap(kinks), *closing, solution.depth]
    cuts = [cut for cut in cuts if cut == 0.0 or cut > 1e-6 * solution.depth]
    t, weight = graded([0.0, 1.0], [0.0], panels=6 if bed.rising and len(kinks) <= 4 else 1, order=10)
    work = 0.0
    for low, high in itertools.pairwise(sorted(set(cuts))):
        work += float(press(contact, low + (high - low) * t**2).force @ (2.0 * (high - low) * t * weight))
    assert work == pytest.approx(solution.energy, rel=1e-8)


@over_shapes(20, 2, kinds=FREE)
def test_depth_to_force_to_radius_to_depth(contact):
    bed, depth = contact.bed(), contact.depth
    force = wk.Indentation(bed, wk.Depth(depth)).solve().force
    middle = wk.Indentation(bed, wk.Force(force)).solve()
    last = wk.Indentation(bed, wk.Radius(middle.radius)).solve()
    assert middle.depth == pytest.approx(depth, rel=1e-11)
    assert last.depth == pytest.approx(depth, rel=1e-11)
    assert last.force == pytest.approx(force, rel=1e-11)
    assert middle.radius == pytest.approx(contact.radius, rel=1e-11)


@over_shapes(20, 2, kinds=PINNED)
def test_depth_to_force_to_depth_of_a_pinned_contact(contact):
    solution = contact.solve()
    back = wk.Indentation(contact.bed(), wk.Force(solution.force)).solve()
    assert back.depth == pytest.approx(contact.depth, rel=1e-12)
    assert back.radius == solution.radius == contact.radius


@pytest.mark.few(2, slow=6)
@over_shapes(12, 2)
def test_many_loads_at_once_are_the_loads_one_by_one(contact):
    depth = contact.depth * np.array([[1.0, 0.3], [0.0, 0.7]])
    solution = press(contact, depth)
    for index in np.ndindex(depth.shape):
        alone = press(contact, depth[index])
        for word in ("depth", "force", "radius", "stiffness", "energy"):
            assert getattr(solution, word)[index] == pytest.approx(getattr(alone, word), rel=1e-12, abs=0.0)
        assert solution.at(index).force == solution.force[index]


@over_shapes(12, 2)
def test_the_springs_carry_the_force(contact):
    solution, bed = contact.solve(), contact.bed()
    x, weight = along(bed, solution.radius)
    assert 2.0 * float(solution.line_load(x) @ weight) == pytest.approx(solution.force, rel=1e-9)
    assert np.array_equal(solution.line_load(-x), solution.line_load(x))
    assert not np.any(solution.line_load(solution.radius * np.array([1.0 + 1e-12, 2.0])))


@pytest.mark.parametrize("medium", MEDIA)
@examples(25)
@given(data=st.data())
def test_no_load_no_contact(medium, data):
    contact = data.draw(contacts(data.draw(st.sampled_from([*KINDS])), medium))
    for load in (wk.Force(0.0), wk.Depth(0.0), wk.Depth(-contact.unit)):
        solution = wk.Indentation(contact.bed(), load).solve()
        assert solution.force == solution.radius == solution.stiffness == solution.energy == 0.0


@over_shapes(20, 2, kinds=["truncated_cone", "truncated_paraboloid", "rounded_punch"])
def test_the_gentlest_touch_of_a_flat_end_is_that_of_a_flat_punch(contact):
    """g leaves the flat with a square root, so that the radius can no longer be distinguished from the flat's."""
    bed, flat = contact.bed(), contact.specimen.flat * contact.unit
    punch = wk.Foundation(wk.FlatPunch(flat), bed.medium)
    depth = contact.unit * 10.0 ** np.arange(-14.0, -8.0)
    solution, same = press(contact, depth), wk.Indentation(punch, wk.Depth(depth)).solve()
    np.testing.assert_allclose(solution.radius, flat, rtol=1e-4)
    assert np.all(solution.radius >= flat)
    np.testing.assert_allclose(solution.force, same.force, rtol=1e-4)
    back = wk.Indentation(bed, wk.Force(solution.force)).solve()
    np.testing.assert_allclose(back.depth, depth, rtol=1e-9)
