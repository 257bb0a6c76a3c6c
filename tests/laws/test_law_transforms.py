"""Back and forth between the body and its springs: what one transform does the other undoes."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from contacts import examples, graded
from hypothesis import given
from hypothesis import strategies as st
from media_cases import MEDIA
from shapes import KINDS, WAVES, Specimen, number

import winkler as wk
from winkler.numerics.transforms import abel

SHAPES = {**KINDS, **WAVES}
SLOW = {"wavy", "wavy_ball", "formula", "measured"}
PLACES = np.array([1e-4, 0.03, 0.11, 0.26, 0.41, 0.59, 0.73, 0.88, 0.99])


def places(specimen: Specimen) -> np.ndarray:
    """Return places up to the widest contact, not exactly at a kink."""
    return PLACES * specimen.widest


def over_specimens(law):
    few = [pytest.param(kind, 2 if kind in SLOW else 4, id=kind) for kind in SHAPES]
    more = [pytest.param(kind, 4 if kind in SLOW else 12, id=f"{kind}-more", marks=pytest.mark.long) for kind in SHAPES]

    @pytest.mark.parametrize(("kind", "many"), [*few, *more])
    def test(kind, many):
        examples(many)(given(SHAPES[kind])(law))()

    return test


@over_specimens
def test_the_inverse_transform_gives_the_body_back(specimen):
    shape, r = specimen.make(1.0), places(specimen)
    back = abel.surface(shape.gap, [b for b, _ in shape.kinks], r)
    np.testing.assert_allclose(back, shape.height(r), rtol=1e-10, atol=1e-12 * np.max(np.abs(shape.height(r))))


@over_specimens
def test_three_roads_to_the_plane_profile(specimen):
    """By the slope, by the height alone, and by the shape's own closed form."""
    shape, x = specimen.make(1.0), places(specimen)
    edges = [b for b, _ in shape.kinks]
    scale = np.max(np.abs(shape.gap(x)))
    np.testing.assert_allclose(abel.gap(shape.slope, edges, x), shape.gap(x), rtol=1e-10, atol=1e-11 * scale)
    stored = shape.gap_integral(x)
    np.testing.assert_allclose(
        abel.gap_integral(shape.height, edges, x), stored, rtol=1e-10, atol=1e-11 * np.max(np.abs(stored))
    )


@over_specimens
def test_integral_plane_profile_and_slope_belong_together(specimen):
    shape = specimen.make(1.0)
    end = specimen.widest if np.isfinite(shape.gap(np.array([specimen.widest]))[0]) else 0.9 * specimen.widest
    cuts = [0.0, *(b for b, _ in shape.kinks if b < end), end]
    # beyond a kink g' may hold an inverse square root: x = b + t^2 takes it away
    for low, high in itertools.pairwise(cuts):
        t, weight = graded(np.linspace(0.0, 1.0, 9), [0.0, 1.0] if low == 0.0 else [1.0], panels=8)
        x, step = low + (high - low) * t**2, 2.0 * (high - low) * t * weight
        ends = np.array([low, high])
        rise, area = np.diff(shape.gap(ends))[0], np.diff(shape.gap_integral(ends))[0]
        most = np.max(np.abs(shape.gap(x)))
        assert shape.gap_slope(x) @ step == pytest.approx(rise, rel=1e-9, abs=1e-10 * most)
        assert shape.gap(x) @ step == pytest.approx(area, rel=1e-9, abs=1e-10 * most * end)


@over_specimens
def test_a_plane_profile_given_directly_finds_its_body(specimen):
    """Springs under g = f(x) belong to a body whose transform is f(x) again."""
    shape = specimen.make(1.0)
    if any(strength for _, strength in shape.kinks):
        return  # the body of a plane profile with a corner has a logarithm in its slope
    bed = wk.PlaneFoundation(shape, wk.HalfSpace(wk.Elastic(1.0, 0.3)))
    edges = [b for b, _ in shape.kinks]
    x = places(specimen)[2:8:2] if len(edges) < 8 else places(specimen)[2:3]
    again = abel.gap_integral(bed.height, edges, x)
    expected = abel.integral(shape.height, edges, x)
    np.testing.assert_allclose(again, expected, rtol=1e-9, atol=1e-10 * np.max(np.abs(expected)))


@pytest.mark.parametrize("medium", MEDIA)
@examples(30)
@given(data=st.data())
def test_springs_and_punch_belong_together(medium, data):
    """The stiffness of a flat punch is the sum of its springs."""
    bed = data.draw(MEDIA[medium]).make(1.0, 1.0)
    radius = data.draw(number(0.01, 10.0))
    t, weight = graded([0.0, 1.0], [0.0])
    x, weight = radius * t**6, radius * 6.0 * t**5 * weight  # takes x^k from the axis, k > -1
    assert 2.0 * bed.normal_stiffness(x) @ weight == pytest.approx(bed.punch_stiffness(np.array(radius)), rel=1e-9)
    assert np.all(bed.tangential_stiffness(x) > 0.0)
