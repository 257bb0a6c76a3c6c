"""A path and the steps it may be stated in: points, turning points, kinds of loads, tables, errors."""

from __future__ import annotations

import dataclasses
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from winkler.io.tables.path_table import read_path
from winkler.loading.loads import Angle, Depth, Force, ShearForce, Shift, Torque
from winkler.loading.path import Path
from winkler.loading.path_steps import Circle, Follow, Hold, Oscillate, Ramp, Start, Unchanged
from winkler.loading.program import Program
from winkler.numerics.equations.oscillation_times import oscillation_moments, sine
from winkler.values.errors import InvalidInput


def test_one_number_holds_all_the_time():
    path = Path([0.0, 1.0, 4.0], Force(7.0), Torque(2.0))
    assert np.array_equal(path.across, [7.0, 7.0, 7.0])
    assert np.array_equal(path.along, [2.0, 2.0, 2.0])
    assert path == Path(np.array([0.0, 1.0, 4.0]), Force([7.0] * 3), Torque([2.0] * 3))
    assert not path.in_plane


def test_a_path_in_the_plane_has_two_columns():
    rows = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 2.0]])
    path = Path.through(Depth(1e-6), Shift(rows))
    assert path.in_plane
    assert np.array_equal(path.along, rows)
    assert np.array_equal(path.time, [0.0, 1.0, 2.0])


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: Path([0.0, 1.0, 0.5], Force(1.0)), "give a row of finite numbers in s that never fall"),
        (lambda: Path([], Force(1.0)), "give a row of finite numbers in s that never fall"),
        (lambda: Path("now", Force(1.0)), "give a row of finite numbers in s that never fall"),
        (lambda: Path([0.0, np.nan], Force(1.0)), "give a row of finite numbers in s that never fall"),
        (lambda: Path([0.0], Shift(1.0)), r"normal is a Shift; give Depth or Force"),
        (lambda: Path([0.0], Force(1.0), Force(1.0)), "lateral is a Force; give Shift, ShearForce, Angle or Torque"),
        (lambda: Path([0.0, 1.0], Force([1.0, 2.0, 3.0])), r"normal has the shape \(3,\) for 2 points in time"),
        (lambda: Path([0.0, 1.0, 2.0], Force(1.0), Angle(np.zeros((3, 2)))), r"lateral has the shape \(3, 2\)"),
        (lambda: Path.through(Depth([1.0, 2.0]), Shift([1.0, 2.0, 3.0])), r"normal has the shape \(2,\)"),
        (lambda: Path.oscillation(amplitude=1.0), "give either depth or force"),
        (lambda: Path.oscillation(depth=1.0, force=1.0, amplitude=1.0), "give either depth or force"),
        (lambda: Path.oscillation(depth=1.0, amplitude=1.0, cycles=0.0), "cycles is 0.0; it must be a positive"),
        (lambda: Path.oscillation(depth=1.0, amplitude=1.0, count=0), "count is 0; give a whole number"),
        (lambda: Path.oscillation(depth=1.0, amplitude=1.0, frequency=-1.0), "frequency is -1.0; it must be positive"),
        (lambda: Path.oscillation(depth=1.0, amplitude=Shift([1.0, 2.0])), r"the shape \(2,\); give one number"),
        (lambda: Path.oscillation(depth=1.0, amplitude=1.0, cycles=1e9), "are more than 10000000 points"),
    ],
)
def test_wrong_paths(make, sentence):
    with pytest.raises(InvalidInput, match=sentence):
        make()


def test_an_oscillation_hits_its_turning_points_exactly():
    for count in (3, 7, 40):
        path = Path.oscillation(force=10.0, amplitude=3e-7, cycles=2.5, frequency=50.0, count=count)
        for number, side in enumerate((1.0, -1.0, 1.0, -1.0, 1.0)):
            assert path.along[np.argmin(np.abs(path.time - (0.25 + 0.5 * number) / 50.0))] == side * 3e-7
        assert path.time[-1] == pytest.approx(0.05, rel=1e-15)
        assert path.along[-1] == 0.0
        assert np.all(path.across == 10.0)
        assert np.allclose(path.along, 3e-7 * np.sin(100.0 * np.pi * path.time), atol=1e-20)


@pytest.mark.parametrize("kind", [Shift, ShearForce, Angle, Torque])
def test_anything_along_the_surface_may_oscillate(kind):
    path = Path.oscillation(depth=1e-6, amplitude=kind(2.0), count=4)
    assert path.lateral == kind(np.array([0.0, 2.0, 0.0, -2.0, 0.0]))


@given(turns=st.floats(-50.0, 50.0))
def test_sine_of_turns(turns):
    assert sine(np.array(turns)) == pytest.approx(np.sin(2.0 * np.pi * turns), abs=2e-13)


@given(
    cycles=st.floats(0.1, 9.0),
    count=st.integers(1, 30),
    rate=st.floats(0.2, 4.0),
    lead=st.floats(-2.0, 2.0),
)
def test_moments_hold_every_turning_point(cycles, count, rate, lead):
    moments = oscillation_moments(cycles, count, ((1.0, 0.0), (rate, lead)))
    assert moments[0] == 0.0
    assert moments[-1] == cycles
    assert np.all(np.diff(moments) > 0.0)
    for speed, ahead in ((1.0, 0.0), (rate, lead)):
        numbers = np.arange(-40, 60)
        turning = (0.25 + 0.5 * numbers - ahead) / speed
        for moment in turning[(turning > 1e-8) & (turning < cycles - 1e-8)]:
            assert np.min(np.abs(moments - moment)) < 2e-9


# --------------------------------------------------------------------------------------------------------- programs


def test_steps_go_on_from_where_the_one_before_ended():
    path = Program(
        [
            Start(Depth(1.0), ShearForce(5.0)),
            Ramp(Depth(3.0), duration=2.0, count=2),
            Hold(4.0),
            Ramp(lateral=ShearForce(-5.0), duration=1.0),
            Ramp(Depth(0.0), ShearForce(0.0), duration=0.0),
        ]
    )
    assert np.array_equal(path.time, [0.0, 1.0, 2.0, 6.0, 7.0, 7.0])
    assert np.array_equal(path.across, [1.0, 2.0, 3.0, 3.0, 3.0, 0.0])
    assert np.array_equal(path.along, [5.0, 5.0, 5.0, 5.0, -5.0, 0.0])
    assert isinstance(path.normal, Depth)
    assert isinstance(path.lateral, ShearForce)
    assert isinstance(path, Path)


def test_a_start_alone_is_one_point():
    path = Program([Start(Force(2.0))])
    assert (path.time, path.across, path.along) == ([0.0], [2.0], [0.0])


@pytest.mark.parametrize("kind", [Shift, ShearForce, Angle, Torque])
def test_a_start_without_a_lateral_load_is_at_zero_of_the_one_that_follows(kind):
    steps = (Hold(2.0), Ramp(lateral=kind(3.0)))
    path = Program([Start(Force(1.0)), *steps])
    assert path.lateral == kind([0.0, 0.0, 3.0])
    assert path.lateral == Program([Start(Force(1.0), kind(0.0)), *steps]).lateral


def test_both_loads_oscillate_about_where_one_is():
    path = Program(
        [
            Start(Force(10.0), Shift(1.0)),
            Oscillate(Force(2.0), Shift(0.5), cycles=2.0, frequency=4.0, ratio=1.5, phase=np.pi / 3, count=11),
        ]
    )
    t = path.time[1:]  # the first point is the start
    assert np.array_equal((path.across[0], path.along[0]), (10.0, 1.0))
    assert t[0] == 0.0
    assert t[-1] == pytest.approx(0.5, rel=1e-15)
    assert np.allclose(path.along[1:], 1.0 + 0.5 * np.sin(8.0 * np.pi * t + np.pi / 3), rtol=1e-13)
    assert np.allclose(path.across[1:], 10.0 + 2.0 * np.sin(12.0 * np.pi * t), rtol=1e-13)
    assert (np.max(path.across), np.min(path.across)) == (12.0, 8.0)
    assert np.max(path.along) == pytest.approx(1.5, rel=1e-15)
    assert np.min(path.along) == pytest.approx(0.5, rel=1e-15)


def test_an_oscillation_does_not_repeat_its_first_point():
    path = Program([Start(Force(1.0)), Oscillate(lateral=Shift(1.0), count=4), Oscillate(lateral=Shift(2.0), count=4)])
    assert np.array_equal(path.along, [0, 1, 0, -1, 0, 2, 0, -2, 0])
    assert np.array_equal(path.time, np.arange(9) / 4.0)


def test_the_oscillation_is_the_same_as_the_builder_of_paths():
    stated = Program([Start(Depth(1e-6)), Oscillate(lateral=Shift(2e-7), cycles=3.0, frequency=2.0)])
    built = Path.oscillation(depth=1e-6, amplitude=2e-7, cycles=3.0, frequency=2.0)
    assert np.array_equal(stated.time, built.time)
    assert np.array_equal(stated.along, built.along)


def test_a_circle():
    path = Program([Start(Force(1.0), Shift([1.0, 2.0])), Circle(Shift(0.5), cycles=2.0, frequency=0.1, count=8)])
    out = path.along[1:] - [1.0, 2.0]
    assert path.in_plane
    assert np.array_equal(path.along[0], [1.0, 2.0])
    assert np.array_equal(out[0], [0.5, 0.0])
    assert np.allclose(np.hypot(*out.T), 0.5, rtol=1e-15)
    assert np.allclose(np.unwrap(np.arctan2(out[:, 1], out[:, 0])), 0.2 * np.pi * path.time[1:], atol=1e-14)
    assert path.time[-1] == 20.0


def test_an_angular_path_in_the_plane():
    path = Program([Start(Force(1.0)), Ramp(lateral=Shift([1.0, 0.0])), Ramp(lateral=Shift([1.0, 3.0]))])
    assert np.array_equal(path.along, [[0, 0], [1, 0], [1, 3]])


def test_a_path_is_followed_again_and_again():
    measured = Path([5.0, 6.0, 8.0], Force([1.0, 2.0, 1.0]), Shift([0.0, 3.0, 0.0]))
    path = Program([Start(Force(1.0)), Ramp(duration=2.0), Follow(measured, cycles=2)])
    assert np.array_equal(path.time, [0.0, 2.0, 3.0, 5.0, 5.0, 6.0, 8.0])
    assert np.array_equal(path.across, [1.0, 1.0, 2.0, 1.0, 1.0, 2.0, 1.0])
    assert np.array_equal(path.along, [0.0, 0.0, 3.0, 0.0, 0.0, 3.0, 0.0])


def test_programs_may_hold_programs():
    inner = Program([Start(Force(1.0)), Oscillate(lateral=Shift(1.0), count=4)])
    path = Program([Start(Force(1.0)), Follow(inner, cycles=3)])
    assert np.array_equal(path.along, np.tile([0.0, 1.0, 0.0, -1.0, 0.0], 3))


def test_a_program_is_a_value():
    steps = [Start(Force(1.0)), Ramp(Force(2.0)), Oscillate(lateral=Shift(1e-6))]
    path = Program(steps)
    assert path == Program(steps)
    assert hash(path) == hash(Program(steps))
    assert pickle.loads(pickle.dumps(path)) == path
    other = dataclasses.replace(path, steps=(*path.steps, Hold(3.0)))
    assert other.time[-1] == path.time[-1] + 3.0
    assert other != path


@pytest.mark.parametrize(
    ("steps", "sentence"),
    [
        ([], "the first step must be a Start"),
        ([Ramp(Force(1.0))], "the first step must be a Start"),
        ([Start(Force(1.0)), Start(Force(1.0))], r"step 2 \(Start\) begins anew"),
        ([Start(Force(1.0)), 7], r"steps\[1\] is a int; give a list of Start"),
        (
            [Start(Force(1.0)), Ramp(Depth(1.0))],
            r"step 2 \(Ramp\) is driven by Depth, step 1 by Force",
        ),
        (
            [Start(Force(1.0)), Ramp(lateral=Shift(1.0)), Hold(), Oscillate(lateral=Angle(1.0))],
            r"step 4 \(Oscillate\) is driven by Angle, step 2 by Shift",
        ),
        ([Start(Force(1.0), Angle(0.0)), Follow(Path([0.0], Force(1.0), Torque(1.0)))], "driven by Torque"),
        ([Start(Force(1.0), Angle(0.0)), Circle(Shift(1.0))], "driven by Shift, step 1 by Angle"),
    ],
)
def test_wrong_programs(steps, sentence):
    with pytest.raises(InvalidInput, match=sentence):
        Program(steps)


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: Start(Shift(1.0)), r"Start: normal is Shift\(.*\); give Depth\(d\) or Force\(F\) with one number"),
        (lambda: Start(Unchanged()), "Start: normal is Unchanged"),
        (
            lambda: Start(Force([1.0, 2.0])),
            r"Start: normal is Force\(force=array.*; give Depth\(d\) or Force\(F\) with one number",
        ),
        (
            lambda: Ramp(Force(1.0), Shift([1.0, 2.0, 3.0])),
            r"Ramp: lateral is Shift.*with one number, or for a shift or a shear force in the plane two",
        ),
        (
            lambda: Ramp(Force(1.0), Angle([1.0, 2.0])),
            r"Ramp: lateral is Angle.*with one number, or for a shift or a shear force in the plane two",
        ),
        (lambda: Ramp(Shift(1.0)), "or leave it out"),
        (lambda: Ramp(Force(1.0), duration=-1.0), "Ramp: duration is -1.0"),
        (lambda: Ramp(Force(1.0), count=0), "Ramp: count is 0"),
        (lambda: Hold(np.inf), "Hold: duration is inf"),
        (lambda: Oscillate(lateral=Shift(1.0), frequency=0.0), "Oscillate: frequency is 0.0"),
        (lambda: Oscillate(lateral=Shift(1.0), cycles=-1.0), "cycles is -1.0"),
        (lambda: Oscillate(lateral=Shift(1.0), ratio=0.0), "ratio of frequencies is 0.0"),
        (lambda: Oscillate(lateral=Shift(1.0), phase=np.nan), "phase is nan"),
        (lambda: Circle(Angle(1.0)), "Circle: lateral is Angle"),
        (lambda: Circle(Shift(0.0)), r"Circle: lateral is Shift\(shift=0.0\); .* one positive number"),
        (lambda: Follow(Force(1.0)), "Follow: the path is a Force; give Path"),
        (lambda: Follow(Path([0.0], Force(1.0)), cycles=0), "Follow: cycles is 0"),
    ],
)
def test_wrong_steps(make, sentence):
    with pytest.raises(InvalidInput, match=sentence):
        make()


# ----------------------------------------------------------------------------------------------------------- tables


def test_a_path_is_read_from_a_table(tmp_path):
    file = tmp_path / "loop.csv"
    file.write_text("# measured\ntime [ms], force [kN], shift [um], note\n0, 0.1, 0, 1\n10, 0.2, 0.5, 2\n", "utf-8")
    assert read_path(file) == Path([0.0, 0.01], Force([100.0, 200.0]), Shift([0.0, 0.5 * 1e-6]))


@pytest.mark.parametrize(
    ("header", "row", "path"),
    [
        ("t [s];d [um]", "1;2", Path([1.0], Depth([2e-6]))),
        ("t [s];d [um];phi [deg]", "1;2;180", Path([1.0], Depth([2e-6]), Angle([np.pi]))),
        ("t [s];force [N];torque [N m]", "1;2;3", Path([1.0], Force([2.0]), Torque([3.0]))),
        ("t [s];force [N];f_x [mN]", "1;2;3", Path([1.0], Force([2.0]), ShearForce([3e-3]))),
        ("t [s];force [N];u_x [m];u_y [m]", "1;2;3;4", Path([1.0], Force([2.0]), Shift([[3.0, 4.0]]))),
    ],
)
def test_every_kind_of_load_is_read(tmp_path, header, row, path):
    file = tmp_path / "path.csv"
    file.write_text(f"{header}\n{row}\n", "utf-8")
    found = read_path(file)
    assert type(found.normal) is type(path.normal)
    assert type(found.lateral) is type(path.lateral)
    assert np.allclose(found.across, path.across, rtol=1e-15)
    assert found.along.shape == path.along.shape
    assert np.allclose(found.along, path.along, rtol=1e-15)


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("time [s], shift [um]\n0, 1\n", "neither a depth nor a normal force; a path needs one of both"),
        ("time [s], force [N], depth [um]\n0, 1, 1\n", "both a depth and a normal force"),
        ("time [s], force [N], shift [um], angle [deg]\n0, 1, 1, 1\n", "columns of shift and angle; only one of them"),
        ("force [N], shift [um]\n0, 1\n", "time"),
        ("time [s], force [N], shift [um]\n1, 1, 1\n0, 1, 1\n", "give a row of finite numbers in s that never"),
        ("time [s], force [N], shift [kg]\n1, 1, 1\n", "shift"),
    ],
)
def test_wrong_tables_of_paths(tmp_path, text, sentence):
    file = tmp_path / "path.csv"
    file.write_text(text, "utf-8")
    with pytest.raises(InvalidInput, match=sentence) as caught:
        read_path(file)
    assert "path.csv" in str(caught.value)


def test_a_hold_has_many_points():
    path = Program([Start(Force(2.0), Shift(np.array([1e-6, 2e-6]))), Hold(4.0, count=4)])
    assert path.time.tolist() == [0.0, 1.0, 2.0, 3.0, 4.0]
    assert path.across.tolist() == [2.0] * 5
    assert path.along.tolist() == [[1e-6, 2e-6]] * 5
    with pytest.raises(InvalidInput, match="Hold: count is 0"):
        Hold(1.0, count=0)
