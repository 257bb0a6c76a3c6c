"""Adding profiles: the order does not matter, the plane profile is linear, twice a shape is a shape twice as steep."""

from __future__ import annotations

import numpy as np
import pytest
from contacts import examples
from hypothesis import given
from hypothesis import strategies as st
from media_cases import MEDIA
from shapes import EDGED, SMOOTH, measured, wavy

import winkler as wk

parts = st.one_of(*SMOOTH.values(), *EDGED.values(), measured, wavy)
PLACES = np.linspace(0.05, 0.95, 7)


def words(shape, x):
    return [getattr(shape, word)(x) for word in ("height", "slope", "gap", "gap_slope", "gap_integral")]


@pytest.mark.slow
@examples(40)
@given(one=parts, other=parts, third=parts)
def test_the_order_of_the_parts_does_not_matter(one, other, third):
    a, b, c = one.make(1.0), other.make(1.0), third.make(1.0)
    x = PLACES * min(one.widest, other.widest, third.widest)
    for left, right in ((a + b, b + a), ((a + b) + c, a + (b + c)), (a + b + c, c + b + a)):
        assert (left.reach, left.rim, left.size, left.rising) == (right.reach, right.rim, right.size, right.rising)
        assert [b for b, _ in left.kinks] == [b for b, _ in right.kinks]
        for one_sum, other_sum in zip(words(left, x), words(right, x), strict=True):
            np.testing.assert_allclose(one_sum, other_sum, rtol=1e-14, atol=0.0)


@examples(40)
@given(one=parts, other=parts)
def test_the_transform_is_linear(one, other):
    a, b = one.make(1.0), other.make(1.0)
    x = PLACES * min(one.widest, other.widest)
    for both, first, second in zip(words(a + b, x), words(a, x), words(b, x), strict=True):
        np.testing.assert_allclose(both, first + second, rtol=1e-14, atol=0.0)


@examples(25)
@given(specimen=st.one_of(*SMOOTH.values(), *EDGED.values()), sample=MEDIA["half_space"], part=st.floats(0.1, 0.9))
def test_twice_a_shape_needs_twice_the_depth_and_force_for_the_same_radius(specimen, sample, part):
    shape, medium = specimen.make(1.0), sample.make(1.0, 1.0)
    load = wk.Radius(specimen.flat + part * (specimen.widest - specimen.flat))
    once = wk.Indentation(wk.Foundation(shape, medium), load).solve()
    twice = wk.Indentation(wk.Foundation(shape + shape, medium), load).solve()
    np.testing.assert_allclose([twice.depth, twice.force], [2.0 * once.depth, 2.0 * once.force], rtol=1e-13)
    np.testing.assert_allclose(twice.energy, 4.0 * once.energy, rtol=1e-12)
