"""Loads: numbers and arrays, and one clear sentence for everything else."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.loading.loads import ShearForce, Shift

LOADS = [
    (wk.Force, "force", "N"),
    (wk.Depth, "depth", "m"),
    (wk.Radius, "radius", "m"),
    (Shift, "shift", "m"),
    (ShearForce, "shear_force", "N"),
]


@pytest.mark.parametrize(("cls", "word", "unit"), LOADS)
def test_numbers_and_arrays(cls, word, unit):
    assert getattr(cls(2), word) == 2.0
    assert getattr(cls(np.float64(2.0)), word) == 2.0
    array = getattr(cls(np.ones((2, 3))), word)
    assert array.shape == (2, 3)
    assert not array.flags.writeable
    assert cls(0.0) == cls(0.0)
    assert cls(1.0) != cls(2.0)


@pytest.mark.parametrize(("cls", "word", "unit"), LOADS)
@pytest.mark.parametrize("bad", ["10", "ten", None, {}, [1.0, "x"], [[1.0], [2.0, 3.0]]])
def test_what_is_no_number(cls, word, unit, bad):
    with pytest.raises(
        wk.InvalidInput, match=rf"^\w+: {word} is .*; give a number or an array of finite numbers in {unit}"
    ):
        cls(bad)


@pytest.mark.parametrize(("cls", "word", "unit"), LOADS)
def test_what_is_not_finite(cls, word, unit):
    for bad in (math.nan, math.inf, -math.inf):
        with pytest.raises(wk.InvalidInput, match=rf"^\w+: {word} is -?(nan|inf); give .* of finite numbers in {unit}"):
            cls(bad)
    with pytest.raises(wk.InvalidInput, match=rf"^\w+: {word} is nan at index 1, 3; give"):
        cls(np.array([1.0, math.nan, 2.0, math.inf]))


@pytest.mark.parametrize(("cls", "word", "unit"), LOADS)
@pytest.mark.parametrize("empty", [[], np.zeros((0, 3)), ()])
def test_nothing(cls, word, unit, empty):
    with pytest.raises(
        wk.InvalidInput, match=rf"^\w+: {word} is empty; give a number or an array of finite numbers in {unit}"
    ):
        cls(empty)


def test_a_contact_radius_is_not_negative():
    with pytest.raises(
        wk.InvalidInput, match=r"^Radius: radius is -0.1 at index 1; give .* in m, none of them negative\.$"
    ):
        wk.Radius(np.array([0.2, -0.1]))
    assert wk.Depth(-1.0).depth == -1.0
    assert wk.Force(-1.0).force == -1.0


def test_lists_are_loads_too():
    bed = wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace.between(wk.Elastic(1.0, 0.0)))
    contact = wk.Indentation(bed, wk.Force([1.0, 2.0])).solve()
    assert contact.depth.shape == (2,)
    assert contact.at(1).force == 2.0
    assert wk.Indentation(bed, wk.Depth([[0.1], [0.2]])).solve().force.shape == (2, 1)


@pytest.mark.parametrize("bad", [1e6, -1.6, math.nan, math.inf])
def test_a_tilt_is_less_than_a_right_angle(bad):
    with pytest.raises(wk.InvalidInput, match=r"^Tilt: tilt is .*; give a number between -1.5 and 1.5 in rad\.$"):
        wk.Tilt(bad)
