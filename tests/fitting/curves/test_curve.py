"""A force curve: a value that refuses what is no curve, and knows its parts."""

from __future__ import annotations

import math
import pickle

import numpy as np
import pytest

from winkler.fitting.curves.curve import ForceCurve
from winkler.values.errors import InvalidInput


def there_and_back() -> ForceCurve:
    position = np.array([0.0, 1.0, 2.0, 3.0, 3.0, 2.0, 1.0]) * 1e-9
    return ForceCurve(
        position, 2.0 * position, 4.0, time=np.arange(7.0), direction=[1, 1, 1, 1, 0, -1, -1], name="there and back"
    )


def test_the_depth_is_what_the_machine_does_not_take():
    curve = there_and_back()
    np.testing.assert_allclose(curve.depth(1e-9), curve.position - 1e-9 - curve.force / 4.0, rtol=1e-15)
    stiff = ForceCurve(curve.position, curve.force)
    assert stiff.compliance == 0.0
    np.testing.assert_array_equal(stiff.depth(0.0), curve.position)


def test_parts():
    curve = there_and_back()
    assert (curve.approach.count, curve.retract.count, curve.count) == (4, 2, 7)
    assert [part.count for part in curve.parts] == [4, 2]  # one held point is no stretch
    assert curve.retract.name == "there and back"
    np.testing.assert_array_equal(curve.approach.time, [0.0, 1.0, 2.0, 3.0])
    with pytest.raises(InvalidInput, match="has no hold; it holds 4 points going in, 1 held and 2 coming out"):
        _ = curve.hold


def test_directions_are_read_from_the_positions():
    position = np.array([0.0, 1.0, 2.0, 1.0, 0.0])
    np.testing.assert_array_equal(ForceCurve(position, position).direction, [1, 1, 1, -1, -1])
    np.testing.assert_array_equal(ForceCurve(position[2:], position[2:]).direction, [-1, -1, -1])
    np.testing.assert_array_equal(ForceCurve(position[:3], position[:3]).direction, [1, 1, 1])


def test_a_curve_is_a_value():
    curve = there_and_back()
    assert curve == there_and_back()
    assert hash(pickle.loads(pickle.dumps(curve))) == hash(curve)
    assert not curve.position.flags.writeable
    assert curve != curve.approach


def test_it_stays_apart_from_the_arrays_it_was_made_of():
    position = np.array([0.0, 1.0, 2.0])
    curve = ForceCurve(position, position)
    position[0] = 7.0
    assert curve.position[0] == 0.0


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"force": [1.0, 2.0]}, "position has 3 points, force has 2"),
        ({"force": [1.0, math.nan, 2.0]}, "force is nan at index 1"),
        ({"position": [0.0, math.inf, math.inf]}, "position is inf at index 1, 2"),
        ({"force": ["a", "b", "c"]}, "force is .*; give a row of .* numbers in N"),
        ({"force": [[1.0, 2.0, 3.0]]}, r"force has the shape \(1, 3\)"),
        ({"time": [0.0, 2.0, 1.0]}, "time falls from index 1 \\(2\\) to the next \\(1\\)"),
        ({"time": [0.0, 1.0]}, "position has 3 points, time has 2"),
        ({"direction": [1.0, 1.0, 2.0]}, "direction holds other numbers"),
        ({"direction": [1.0, 1.0]}, "direction has 2"),
        ({"machine_stiffness": 0.0}, "machine_stiffness is 0.0; it must be positive"),
        ({"machine_stiffness": -1.0}, "machine_stiffness is -1.0"),
        ({"machine_stiffness": math.nan}, "machine_stiffness is nan"),
        ({"machine_stiffness": "soft"}, "machine_stiffness is 'soft'"),
        ({"position": [0.0], "force": [0.0]}, "position has 1 number; give a row of at least 2"),
    ],
)
def test_what_is_no_curve_is_refused(changed, message):
    given = {"position": [0.0, 1.0, 2.0], "force": [0.0, 0.0, 1.0]}
    with pytest.raises(InvalidInput, match=message):
        ForceCurve(**(given | changed))


def test_choosing_too_few_points_is_refused():
    with pytest.raises(InvalidInput, match="1 points are chosen"):
        there_and_back().chosen(np.array([3]))
