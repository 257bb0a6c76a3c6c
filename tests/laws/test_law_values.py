"""Shapes, media, beds, loads and solutions are values: frozen, compared by content, safe to copy and to send."""

from __future__ import annotations

import copy
import dataclasses
import pickle

import numpy as np
import pytest
from contacts import KINDS, contacts, examples
from hypothesis import given
from hypothesis import strategies as st
from media_cases import MEDIA
from shapes import WAVES

import winkler as wk

SHAPES = {**KINDS, **WAVES}


def arrays(value) -> list[np.ndarray]:
    """Return every array inside a value."""
    if isinstance(value, np.ndarray):
        return [value]
    if isinstance(value, tuple):
        return [array for item in value for array in arrays(item)]
    if dataclasses.is_dataclass(value):
        return [array for field in dataclasses.fields(value) for array in arrays(getattr(value, field.name))]
    return []


def assert_a_value(one, twin, other) -> None:
    """`twin` was made from the same numbers anew, `other` from different ones."""
    assert one is not twin
    assert one == twin
    assert hash(one) == hash(twin)
    assert one != other
    assert len({one, twin, other}) == 2
    assert one != "something else"
    for copied in (pickle.loads(pickle.dumps(one)), copy.copy(one), copy.deepcopy(one), dataclasses.replace(one)):
        assert type(copied) is type(one)
        assert copied == one
        assert hash(copied) == hash(one)
        assert repr(dataclasses.astuple(copied)) == repr(dataclasses.astuple(one))
        for array in arrays(copied):
            assert not array.flags.writeable
            with pytest.raises(ValueError, match="read-only"):
                array[...] = 0.0
    for field in dataclasses.fields(one):
        with pytest.raises(dataclasses.FrozenInstanceError):
            setattr(one, field.name, getattr(other, field.name, 1.0))
        with pytest.raises(dataclasses.FrozenInstanceError):
            delattr(one, field.name)
    with pytest.raises(dataclasses.FrozenInstanceError):
        one.something_new = 1.0
    assert one == twin


@pytest.mark.parametrize("kind", SHAPES)
def test_shapes_are_values(kind):
    @examples(6)
    @given(specimen=SHAPES[kind])
    def law(specimen):
        other = specimen.make(1.25)
        if other == specimen.make(1.0):  # a cone is the same at any size
            other = wk.Sphere(1.0)
        assert_a_value(specimen.make(1.0), specimen.make(1.0), other)

    law()


@pytest.mark.parametrize("medium", MEDIA)
@examples(20)
@given(data=st.data())
def test_media_are_values(medium, data):
    sample = data.draw(MEDIA[medium])
    assert_a_value(sample.make(1.0, 1.0), sample.make(1.0, 1.0), sample.make(1.0, 2.0))


@pytest.mark.slow
@examples(20)
@given(contact=contacts("measured"), depths=st.lists(st.floats(1e-6, 1.0), min_size=1, max_size=5))
def test_beds_loads_problems_and_answers_are_values(contact, depths):
    def problem(factor: float) -> wk.Indentation:
        return wk.Indentation(contact.bed(), wk.Depth(factor * contact.depth * np.array([*depths, 0.5])))

    one, twin, other = problem(1.0), problem(1.0), problem(0.5)
    assert_a_value(one, twin, other)
    assert_a_value(one.load, twin.load, other.load)
    assert_a_value(one.bed, twin.bed, contact.bed(2.0))
    assert_a_value(one.solve(), twin.solve(), other.solve())
    last = len(depths)
    assert_a_value(one.solve().at(last), twin.solve().at(last), other.solve().at(last))
    r = contact.radius * np.array([0.1, 0.4, 2.0])
    fields = [wk.restore(item.solve().at(last), r) for item in (one, twin, other)]
    assert_a_value(*fields)
    springs = [wk.Springs.of(contact.bed(), 0.9 * contact.radius, count) for count in (7, 7, 8)]
    assert_a_value(*springs)


@examples(20)
@given(contact=contacts("measured"))
def test_nothing_changes_behind_the_back_of_a_value(contact):
    places, heights = np.linspace(0.0, 1.0, 30), np.linspace(0.0, 1.0, 30) ** 2
    shape = wk.Measured(places, heights)
    known = hash(shape)
    heights[:] = 0.0
    assert hash(shape) == hash(wk.Measured(places, np.linspace(0.0, 1.0, 30) ** 2)) == known
    depth = contact.depth * np.array([0.2, 0.9])
    load = wk.Depth(depth)
    solution = wk.Indentation(contact.bed(), load).solve()
    depth[:] = -1.0
    assert np.all(load.depth > 0.0)
    assert np.all(solution.problem.load.depth > 0.0)


@examples(40)
@given(factor=st.floats(1.1, 2.0))
def test_a_replaced_value_is_checked_again(factor):
    ball = wk.Sphere(1.0)
    assert dataclasses.replace(ball, curvature_radius=factor).curvature_radius == factor
    with pytest.raises(wk.InvalidInput):
        dataclasses.replace(ball, curvature_radius=-factor)
    tip = wk.Formula("r**2/(2*R)", R=1.0)
    assert dataclasses.replace(tip, R=factor) == wk.Formula("r**2/(2*R)", R=factor)
