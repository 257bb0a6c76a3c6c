"""Runs of the wear of a height map that are stopped: what was reached is kept, and the next run goes on from there."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.io.processes.stopping import INTERRUPTED
from winkler.io.wear_states import read_wear, write_wear
from winkler.study.batch.checkpoint import CheckpointStore
from winkler.study.batch.marching import solve_march
from winkler.study.batch.outcome import answers_of

X = np.arange(12) / 12
SURFACE = wk.Topography(0.02 * np.cos(2.0 * np.pi * X[:, None]) * np.cos(2.0 * np.pi * X), [1.0, 1.0], periodic=True)
PROBLEM = wk.SurfaceWear(
    wk.SurfaceContact(SURFACE, wk.HalfSpace(wk.Elastic(1.0, 0.0)), wk.Force(0.01)),
    wk.Archard(1.0),
    [0.0, 0.01, 0.05, 0.2, 0.3],
    tolerance=1e-2,
)


def interrupted_after(count):
    def watch(states, total):
        assert total == 5
        for place, state in enumerate(states):
            if place == count:
                raise KeyboardInterrupt
            yield state

    return watch


def test_a_run_that_was_stopped_goes_on_with_the_same_numbers(tmp_path):
    whole, keep = PROBLEM.solve(), CheckpointStore(str(tmp_path), "worn")
    early = solve_march(PROBLEM, interrupted_after(3), keep)
    assert early.code == INTERRUPTED
    assert early.stopped.startswith("After 3 of 5 points of the path, which are kept")
    assert np.array_equal(early.solution.worn_volume, whole.worn_volume[:3])
    assert early.solution.last.worn.shape == (12, 12)
    assert keep.path(PROBLEM).exists()

    counted = []

    def counting(states, total):
        for state in states:
            counted.append(state.distance)
            yield state

    resumed = solve_march(PROBLEM, counting, keep).solution
    assert counted == PROBLEM.goals.tolist()
    for name, content in answers_of(whole).items():
        assert np.array_equal(getattr(resumed, name), content), name
    assert (resumed.first, resumed.last) == (whole.first, whole.last)
    keep.remove()
    assert not keep.path(PROBLEM).exists()


def test_a_file_that_is_spoilt_is_refused(tmp_path):
    states = list(PROBLEM.steps())
    path = write_wear(states, tmp_path / "worn.npz")
    content = dict(np.load(path))
    for name, spoilt in (
        ("force", content["force"][:-1]),
        ("area", content["area"].astype(str)),
        ("worn", content["worn"][:1]),
        ("pressure", np.full_like(content["pressure"], np.nan)),
        ("separation", content["separation"][:, :3]),
    ):
        np.savez(tmp_path / "spoilt.npz", **{**content, name: spoilt})
        with pytest.raises(wk.InvalidInput, match=f"{name} is not finite numbers of the shape"):
            read_wear(tmp_path / "spoilt.npz")
    np.savez(tmp_path / "other.npz", **{**content, "format": np.array("winkler wear 1")})
    with pytest.raises(wk.InvalidInput, match="it does not hold 'winkler wear 2'"):
        read_wear(tmp_path / "other.npz")
    with pytest.raises(wk.InvalidInput, match="at least one"):
        write_wear([], tmp_path / "none.npz")
