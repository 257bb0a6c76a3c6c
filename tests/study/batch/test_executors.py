"""Executors of the standard library, and of others that follow its interface, solve the points of a sweep."""

from __future__ import annotations

import multiprocessing
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest

import winkler as wk
from winkler.study.batch.run import run
from winkler.study.language.study import Study
from winkler.study.language.varied import Axis
from winkler.values.errors import InvalidInput, NotConverged

BED = wk.Foundation(wk.Sphere(10e-3), wk.HalfSpace(wk.Elastic(210e9, 0.3)))
STUDY = Study(
    "Balls", wk.Indentation(BED, wk.Force(1.0)), sweep=(Axis("problem.load.force", tuple(np.linspace(1.0, 9.0, 30))),)
)


class Here(Executor):
    """An executor of somebody else's, which computes at once."""

    def __init__(self, breaks_at=-1):
        self.count, self.breaks_at, self.cancelled = 0, breaks_at, 0

    def submit(self, function, /, *arguments):
        self.count += 1
        future = Future()
        if self.count == self.breaks_at:
            future.set_exception(BrokenExecutor("a machine went away"))
        else:
            future.set_result(function(*arguments))
        return future


def test_an_executor_solves_what_this_process_solves():
    executor = Here()
    found = run(STUDY, workers=executor).answer("depth")
    assert executor.count > 1
    assert found.tolist() == run(STUDY).answer("depth").tolist()


def test_an_executor_that_breaks_is_named_and_points_are_kept(tmp_path):
    journal = tmp_path / "points.journal"
    with pytest.raises(NotConverged, match=r"the executor is broken \(a machine went away\); make a new one"):
        run(STUDY, workers=Here(breaks_at=3), journal=journal)
    again = Here()
    assert run(STUDY, workers=again, journal=journal).answer("depth").tolist() == run(STUDY).answer("depth").tolist()
    assert not journal.exists()


def test_threads_are_refused():
    with ThreadPoolExecutor(2) as threads, pytest.raises(InvalidInput, match="give one of processes, such as"):
        run(STUDY, workers=threads)


@pytest.mark.slow
def test_a_pool_of_processes_stays_open():
    with ProcessPoolExecutor(2, multiprocessing.get_context("spawn")) as pool:
        found = [run(STUDY, workers=pool).answer("depth").tolist() for _ in range(2)]
        assert pool.submit(sum, [1, 2]).result() == 3
    assert found == 2 * [run(STUDY).answer("depth").tolist()]
