"""The points of a study as a stream.

One bad point does not stop a sweep: whatever it raises, it has no answer, and the others are solved.
"""

from __future__ import annotations

import functools
import traceback
from collections.abc import Iterator
from typing import Any

import numpy as np

from winkler.errors import InvalidInput, Mistake, NotConverged, WinklerError, mistake_in
from winkler.study.batch.checkpoint import Keep
from winkler.study.batch.journal import Journal, settled
from winkler.study.batch.marching import ANEW, March, Watch, is_march, marched, unwatched
from winkler.study.batch.outcome import Failed, Point, Recalled, Solved, answers_of
from winkler.study.batch.pool import Workers
from winkler.study.batch.recording import light, recalled, written
from winkler.study.batch.stopping import INTERRUPTED
from winkler.study.batch.stream import results
from winkler.study.batch.tasks import Task, Tasks, tasks
from winkler.study.language.study import Expectation, Fields, Study

__all__ = ["solve_points", "solved"]

WHOLE = 256
"""Of sweeps with more points the solutions are not kept, only what tables and archives tell of them."""


def solved(task: Task, watch: Watch = unwatched, keep: Keep = ANEW) -> Solved | Failed:
    """Solve one point; an error of the physics becomes a `Failed`, any other one is a mistake of ours and is raised."""
    index, settings, problem, fields = task.index, task.settings, task.base, task.fields
    try:
        problem = task.problem
        march = marched(problem, watch, keep) if is_march(problem) else March(problem.solve())
        solution = march.solution
        found = tuple(answers_of(solution).items())
        point = Solved(index, settings, problem, solution, found)
        surface, below = _restored(point, fields) if fields.r.values.size else ((), ())
        return Solved(index, settings, problem, solution, found, surface, below, march.stopped, march.code)
    except WinklerError as error:
        return Failed(index, settings, problem, str(error), error.exit_code)


def _restored(point: Solved, fields: Fields) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
    """Return the fields on the surface and below it, load by load."""
    from winkler.fields import restore

    surface, below = [], []
    for contact in point.each:
        if not hasattr(contact, "pressed"):
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
    keep: Keep = ANEW,
) -> Iterator[Point]:
    """Yield the points of a study as they are solved.

    Parameters
    ----------
    study
        What to solve.
    journal
        Where points are kept: those that it has come first, then the others in any order.  Without one they come in the
        order of the sweep.
    workers
        Number of processes, a cluster, or the `Machine`; 1 solves in this one.
    watch
        Sees the states of a march along a path, if this process solves it; what was reached when it is interrupted is
        the last point.
    keep
        Where long marches keep what they have reached, to go on from there if they are killed.

    Raises
    ------
    InvalidInput
        Before the first point, if one of them cannot be asked, or the journal is of another study.
    NotConverged
        If workers died: how many points are kept.
    """
    points, expect, shape = tasks(study), study.expect, study.shape
    alone = study.size == 1  # its error ends the run, and shows where it came from
    whole = study.size <= WHOLE
    stream = results(
        points,
        functools.partial(_slimmed, expect=expect, shape=shape, keep=keep, whole=whole, alone=alone),
        known=() if journal is None else _known(study, points, journal),
        left=points.without,
        result=functools.partial(_kept, journal, expect, shape),
        useful=lambda point: not isinstance(point, Failed),
        journal=journal,
        names=("points", "solved"),
        workers=workers,
        watch=watch,
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


def _known(study: Study, points: Tasks, journal: Journal) -> Iterator[tuple[int, Point]]:
    for content in journal.recalled():
        if settled(content):
            place = int(np.ravel_multi_index(content["at"], study.shape)) if study.shape else 0
            yield place, recalled(content, points[place], study.expect)


def _kept(journal: Journal | None, expect: tuple[Expectation, ...], shape: tuple[int, ...], point: Point) -> Point:
    """Return a point that was computed, and write it into the journal if it was not interrupted."""
    if journal is None or (not isinstance(point, Failed) and point.code == INTERRUPTED):
        return point
    slim = _slim(point, expect, shape)
    journal.write(written(slim), final=not (isinstance(slim, Failed) and slim.traceback))
    return slim if isinstance(slim, Failed) else point


def _slimmed(
    task: Task,
    expect: tuple[Expectation, ...],
    shape: tuple[int, ...],
    keep: Keep,
    watch: Watch = unwatched,
    *,
    whole: bool,
    alone: bool,
) -> Point:
    try:
        point = solved(task, watch, keep)
    except Exception as error:
        if alone:
            raise
        return _unexpected(task.index, task.settings, task.base, error)
    return point if whole or alone else _slim(point, expect, shape)


def _slim(point: Point, expect: tuple[Expectation, ...], shape: tuple[int, ...]) -> Recalled | Failed:
    """Return what tables and archives take from a point; it has no answer if what the answer tells raises an error."""
    if not isinstance(point, Solved):
        return point
    try:
        return light(point, expect, shape)
    except InvalidInput:  # what is expected is no answer: the study has to be changed
        raise
    except WinklerError as error:
        return Failed(point.index, point.settings, point.problem, str(error), error.exit_code)
    except Exception as error:
        return _unexpected(point.index, point.settings, point.problem, error)


def _unexpected(index: tuple[int, ...], settings: tuple[Any, ...], problem: Any, error: Exception) -> Failed:
    """Return a point that met an error which winkler does not raise on purpose."""
    where = "".join(traceback.format_exception(error))
    if isinstance(error, MemoryError):
        text = " ".join(str(error).split()) or "no more is said"
        reason = f"there is not enough memory ({text}); ask for fewer loads or points of a path, or use fewer workers."
        return Failed(index, settings, problem, reason, NotConverged.exit_code, where)
    return Failed(
        index, settings, problem, f"{mistake_in(error)}; report it with this study.", Mistake.exit_code, where
    )
