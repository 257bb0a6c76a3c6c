"""The points of a study as a stream.

A point that raises an error does not stop a sweep: it is recorded as failed, and the others are solved.
"""

from __future__ import annotations

import functools
import traceback
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.io.processes.stopping import INTERRUPTED
from winkler.problems.answer import is_march, is_restorable
from winkler.study.batch.checkpoint import CheckpointStore
from winkler.study.batch.journal import Journal, is_final
from winkler.study.batch.marching import NO_CHECKPOINTS, MarchResult, Watch, solve_march, unwatched
from winkler.study.batch.outcome import answers_of
from winkler.study.batch.points import Failed, Point, Recalled, Solved
from winkler.study.batch.pool import Workers
from winkler.study.batch.recording import json_line, recalled, without_solution
from winkler.study.batch.stream import results
from winkler.study.batch.tasks import PointTask, PointTasks, tasks
from winkler.study.language.study import Expectation, Fields, Study
from winkler.values.errors import InvalidInput, Mistake, NotConverged, WinklerError, mistake_in

if TYPE_CHECKING:
    from winkler.study.batch.shards import Shard


MOST_KEPT_SOLUTIONS = 256
"""Points of a sweep up to which solutions are kept; of longer ones only numbers."""


def solved(task: PointTask, watch: Watch = unwatched, keep: CheckpointStore = NO_CHECKPOINTS) -> Solved | Failed:
    """Solve one point; an error of the physics becomes a `Failed`, any other one is raised."""
    index, settings, problem, fields = task.index, task.settings, task.base, task.fields
    try:
        problem = task.problem
        march = solve_march(problem, watch, keep) if is_march(problem) else MarchResult(problem.solve())
        solution = march.solution
        found = tuple(answers_of(solution).items())
        point = Solved(index, settings, problem, solution, found)
        surface, below = _restored(point, fields) if fields.r.values.size else ((), ())
        return Solved(index, settings, problem, solution, found, surface, below, march.stopped, march.code)
    except WinklerError as error:
        return Failed(index, settings, problem, str(error), error.exit_code)


def _restored(point: Solved, fields: Fields) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
    """Return the fields on the surface and below it, load by load."""
    from winkler.fields.restoration import restore

    surface, below = [], []
    for contact in point.each:
        restorable = is_restorable(contact)
        if not restorable:
            raise InvalidInput(
                f"fields: the answer to {type(point.problem).__name__} has no fields to restore; remove [fields]."
            )
        radius = float(contact.radius)
        r, z = fields.r.within(radius), fields.z.within(radius)
        surface.append(restore(contact, r))
        if z.size:
            below.append(restore(contact, r[:, np.newaxis], z[np.newaxis, :]))
    return tuple(surface), tuple(below)


def solve_points(
    study: Study,
    journal: Journal | None = None,
    *,
    workers: Workers = 1,
    watch: Watch = unwatched,
    keep: CheckpointStore = NO_CHECKPOINTS,
    shard: Shard | None = None,
) -> Iterator[Point]:
    """Yield the points of a study as they are solved.

    Parameters
    ----------
    study
        The study.
    journal
        Record of points: those that it holds come first, then the others in any order.  Without one they come in the
        order of the sweep.
    workers
        Number of processes, a cluster, an executor, or the `Machine`; 1 solves in this one.
    watch
        Passes on the states of a march along a path, if this process solves it; if it is interrupted, the states
        reached give the last point.
    keep
        Checkpoints of long marches, from which they are continued if they are killed.
    shard
        The part of the points that is solved; all of them unless given.

    Raises
    ------
    InvalidInput
        Before the first point, if one of them is invalid, or the journal is of another study.
    NotConverged
        If workers died; the sentence states how many points are recorded.
    """
    points, expect, shape = tasks(study), study.expect, study.shape
    alone = study.size == 1  # its error ends the run with its traceback
    keeps_solutions = study.size <= MOST_KEPT_SOLUTIONS
    stream = results(
        points,
        functools.partial(
            _computed_point, expect=expect, shape=shape, keep=keep, keeps_solutions=keeps_solutions, alone=alone
        ),
        earlier=() if journal is None else _recalled_points(study, points, journal),
        left=points.without,
        result=functools.partial(_recorded, journal, expect, shape),
        useful=lambda point: shard is not None or not isinstance(point, Failed),
        journal=journal,
        names=("points", "solved"),
        workers=workers,
        watch=watch,
        others=None if shard is None else shard.others(study.size),
    )
    early: dict[int, Point] = {}
    due = 0
    for place, point in stream:
        if journal is not None:
            yield point
            continue
        early[place] = point
        while due in early:
            yield early.pop(due)
            due += 1


def _recalled_points(study: Study, points: PointTasks, journal: Journal) -> Iterator[tuple[int, Point]]:
    for content in journal.recalled():
        if is_final(content):
            place = int(np.ravel_multi_index(content["at"], study.shape)) if study.shape else 0
            yield place, recalled(content, points[place], study.expect)


def _recorded(journal: Journal | None, expect: tuple[Expectation, ...], shape: tuple[int, ...], point: Point) -> Point:
    """Return a point that was computed, and write it into the journal if it was not interrupted."""
    if journal is None or (not isinstance(point, Failed) and point.code == INTERRUPTED):
        return point
    reduced = _reduced(point, expect, shape)
    journal.write(json_line(reduced), final=not (isinstance(reduced, Failed) and reduced.traceback))
    return reduced if isinstance(reduced, Failed) else point


def _computed_point(
    task: PointTask,
    expect: tuple[Expectation, ...],
    shape: tuple[int, ...],
    keep: CheckpointStore,
    watch: Watch = unwatched,
    *,
    keeps_solutions: bool,
    alone: bool,
) -> Point:
    try:
        point = solved(task, watch, keep)
    except Exception as error:
        if alone:
            raise
        return _unexpected(task.index, task.settings, task.base, error)
    return point if keeps_solutions or alone else _reduced(point, expect, shape)


def _reduced(point: Point, expect: tuple[Expectation, ...], shape: tuple[int, ...]) -> Recalled | Failed:
    """Return the numbers of a point for tables and archives; it fails if computing them raises an error."""
    if not isinstance(point, Solved):
        return point
    try:
        return without_solution(point, expect, shape)
    except InvalidInput:  # an expected quantity is no answer: the study has to be changed
        raise
    except WinklerError as error:
        return Failed(point.index, point.settings, point.problem, str(error), error.exit_code)
    except Exception as error:
        return _unexpected(point.index, point.settings, point.problem, error)


def _unexpected(index: tuple[int, ...], settings: tuple[Any, ...], problem: Any, error: Exception) -> Failed:
    """Return the failed point of an error that winkler does not raise on purpose."""
    where = "".join(traceback.format_exception(error))
    if isinstance(error, MemoryError):
        text = " ".join(str(error).split()) or "no more is said"
        reason = f"there is not enough memory ({text}); ask for fewer loads or points of a path, or use fewer workers."
        return Failed(index, settings, problem, reason, NotConverged.exit_code, where)
    return Failed(
        index, settings, problem, f"{mistake_in(error)}; report it with this study.", Mistake.exit_code, where
    )
