"""Values: frozen, equal and hashed by content, arrays read-only, also after a journey through pickle."""

from __future__ import annotations

import copy
import dataclasses
import math
import pickle
import subprocess
import sys

import numpy as np
import pytest

import winkler as wk
from winkler.values import value as values
from winkler.values.value import frozen_array, value


@value
class Sample:
    numbers: object
    name: str = "x"
    checked: bool = False

    def __post_init__(self):
        object.__setattr__(self, "checked", isinstance(self.numbers, np.ndarray) and not self.numbers.flags.writeable)


def test_frozen():
    ball = wk.Sphere(1.0)
    with pytest.raises(dataclasses.FrozenInstanceError):
        ball.curvature_radius = 2.0
    with pytest.raises(dataclasses.FrozenInstanceError):
        del ball.curvature_radius
    assert dataclasses.replace(ball, curvature_radius=2.0) == wk.Sphere(2.0)


def test_arrays_are_copies_and_read_only():
    given = np.array([1.0, 2.0])
    sample = Sample(given)
    given[0] = 9.0
    assert sample.numbers[0] == 1.0
    with pytest.raises(ValueError, match="read-only"):
        sample.numbers[0] = 5.0
    assert sample.checked  # the class's own check saw frozen content


def test_content_is_frozen_deeply():
    sample = Sample([1, [2.0, np.array([3, 4])], np.float64(5.0), np.int64(6)])
    assert isinstance(sample.numbers, tuple)
    assert isinstance(sample.numbers[1], tuple)
    assert not sample.numbers[1][1].flags.writeable
    assert sample.numbers[1][1].dtype == float
    assert type(sample.numbers[2]) is float
    assert type(sample.numbers[3]) is int
    assert type(Sample(np.array(2.0)).numbers) is float


def test_equal_and_hashed_by_content():
    a, b = Sample(np.array([1.0, math.nan])), Sample(np.array([1.0, math.nan]))
    assert a == b
    assert hash(a) == hash(b)
    assert len({a, b}) == 1
    assert a != Sample(np.array([1.0, 2.0]))
    assert a != Sample(np.array([[1.0, math.nan]]))
    assert a != dataclasses.replace(a, name="y")
    assert Sample(np.array([1, 2])) == Sample(np.array([1.0, 2.0]))
    assert wk.Sphere(1.0) != wk.Paraboloid(1.0)
    assert wk.Sphere(1) == wk.Sphere(1.0)
    assert hash(wk.Sphere(1)) == hash(wk.Sphere(1.0))
    assert wk.Sphere(1.0) != "Sphere"
    assert (wk.Sphere(1.0) == 3) is False


def test_different_classes_of_equal_content_differ():
    assert wk.TruncatedParaboloid(1.0, 2.0) != wk.RoundedPunch(1.0, 2.0)
    assert len({wk.TruncatedParaboloid(1.0, 2.0), wk.RoundedPunch(1.0, 2.0)}) == 2


VALUES = [
    wk.Measured(np.linspace(0.0, 1.0, 9), np.linspace(0.0, 1.0, 9) ** 2),
    wk.Paraboloid(1.0) + wk.Wavy(1.0, 2.0),
    wk.Formula("r**2/(2*R)", R=2.0),
    wk.AreaFunction([24.5, 1e-7]),
    wk.Foundation(wk.CappedCylinder(1.0, wk.Cone(1.0)), wk.HalfSpace.between(wk.Elastic(1.0, 0.3))),
    wk.Indentation(
        wk.PlaneFoundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.3))), wk.Force(np.array([1.0, 2.0]))
    ),
    wk.Depth([1.0, 2.0]),
]


@pytest.mark.parametrize("sample", VALUES)
def test_pickle_and_copies(sample):
    hash(sample)  # a stored hash must not travel
    for other in (pickle.loads(pickle.dumps(sample)), copy.copy(sample), copy.deepcopy(sample)):
        assert other == sample
        assert hash(other) == hash(sample)
        for field in dataclasses.fields(other):
            content = getattr(other, field.name)
            if isinstance(content, np.ndarray):
                assert not content.flags.writeable


def test_a_pickle_is_the_same_value_in_another_process(tmp_path):
    """Hashes of text differ from process to process; the unpickled value must find itself in a set."""
    path = tmp_path / "value.pickle"
    path.write_bytes(pickle.dumps(VALUES))
    code = (
        "import pickle, sys, pathlib, winkler as wk\n"
        "values = pickle.loads(pathlib.Path(sys.argv[1]).read_bytes())\n"
        "assert values[2] in {wk.Formula('r**2/(2*R)', R=2.0)}\n"
        "assert len(set(values)) == len(values)\n"
    )
    subprocess.run([sys.executable, "-c", code, str(path)], check=True, timeout=120)


def test_solutions_are_values():
    bed = wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace.between(wk.Elastic(1.0, 0.3)))
    one, two = (wk.Indentation(bed, wk.Force(np.array([1.0, 2.0]))).solve() for _ in range(2))
    assert one == two
    with pytest.raises(ValueError, match="read-only"):
        one.force[0] = 3.0
    fields = wk.restore(one.at(0), [0.0, 1.0])
    assert fields == wk.restore(two.at(0), [0.0, 1.0])
    assert pickle.loads(pickle.dumps(fields)) == fields


@pytest.mark.parametrize(
    ("given", "kind"), [([1, 2], "f"), ([True, False], "b"), ([1.0 + 2.0j], "c"), (["a"], "U"), ([1.5], "f")]
)
def test_frozen_array(given, kind):
    array = frozen_array(given)
    assert array.dtype.kind == kind
    assert not array.flags.writeable


def test_what_is_masked_is_missing():
    """The number that lies below a mask is none; as nan it is refused where finite ones are required."""
    given = np.ma.masked_array([1, 2, 3], mask=[False, True, False])
    np.testing.assert_array_equal(frozen_array(given), [1.0, np.nan, 3.0])


def test_contents_are_gathered_once(monkeypatch):
    """Caches compare equal keys at each hit: their arrays are not written out again."""
    numbers = np.linspace(0.0, 1.0, 5000)
    one, other, third = (Sample((Sample(numbers), end)) for end in (1.0, 1.0, 2.0))
    assert one == other != third
    gathered = []
    monkeypatch.setattr(values, "_key", lambda content: gathered.append(content))
    assert one == other != third
    assert {one: 1}[other] == 1
    assert not gathered
    later = np.where(numbers < 1.0, numbers, 2.0)
    monkeypatch.undo()
    assert Sample(numbers) != Sample(later)  # of which the last number differs
