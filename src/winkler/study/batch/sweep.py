"""The points of a study, solved one after the other, in a pool of processes or on a cluster, as a stream.

The numbers are the same whoever solves them.  With a journal, points are written as soon as they are solved, and those
that an earlier run has written are not solved again.  One bad point does not stop a sweep: whatever it raises, it has
no answer, and the others are solved.
"""

from __future__ import annotations

import functools
import time
import traceback
from collections.abc import Iterator
from typing import Any

import numpy as np

from winkler.errors import InvalidInput, Mistake, NotConverged, WinklerError, mistake_in
from winkler.problems.answer import is_march, is_restorable
from winkler.study.batch.checkpoint import Keep
from winkler.study.batch.cluster import Cluster
from winkler.study.batch.journal import Journal, settled
from winkler.study.batch.marching import ANEW, Marched, Watch, marched, unwatched
from winkler.study.batch.outcome import Failed, Point, Recalled, Solved, answers_of
from winkler.study.batch.pool import Machine, Workers, checked_workers, completed
from winkler.study.batch.recording import light, recalled, written
from winkler.study.batch.stopping import INTERRUPTED, look
from winkler.study.batch.tasks import Task, Tasks, tasks
from winkler.study.language.study import Expectation, Fields, Study

__all__ = ["journaled", "solve_points", "solved"]

WHOLE = 256
"""Of sweeps with more points the solutions are not kept, only what tables and archives tell of them."""


def solved(task: Task, watch: Watch = unwatched, keep: Keep = ANEW) -> Solved | Failed:
    """Solve one point; an error of the physics becomes a `Failed`, any other one is a mistake of ours and is raised."""
    index, settings, problem, fields = task.index, task.settings, task.base, task.fields
    try:
        problem = task.problem
        march = marched(problem, watch, keep) if is_march(problem) else Marched(problem.solve())
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
        known = is_restorable(contact)
        if not known:
            raise InvalidInput(
                f"fields: the answer to {type(point.problem).__name__} has no fields to restore; remove [fields]."
            )
        radius = float(contact.radius)
        r, z = fields.r.within(radius), fields.z.within(radius)
        surface.append(restore(contact, r))
        if z.size:
            below.append(restore(contact, r[:, np.newaxis], z[np.newaxis, :]))
    return tuple(surface), tuple(below)


def solve_points(study: Study, *, workers: Workers = 1, watch: Watch = unwatched, keep: Keep = ANEW) -> Iterator[Point]:
    """Yield the points of a study as they are solved, in the order of its sweep.

    Parameters
    ----------
    study
        What to solve.
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
        Before the first point, if one of them cannot be asked.
    """
    checked_workers(workers)
    early: dict[int, Point] = {}
    due = 0
    for place, point in _answered(study, tasks(study), workers, watch, keep):
        look()
        early[place] = point
        while due in early:
            yield early.pop(due)
            due += 1


def journaled(
    study: Study, journal: Journal, *, workers: Workers = 1, watch: Watch = unwatched, keep: Keep = ANEW
) -> Iterator[Point]:
    """Yield the points of a study, first those in its journal, then others as soon as they are solved and written.

    Parameters
    ----------
    study, workers, watch, keep
        As for `solve_points`.
    journal
        Where points are kept.

    Raises
    ------
    InvalidInput
        Before the first point, if one of them cannot be asked, or the journal is of another study.
    NotConverged
        If workers died: how many points are kept.
    """
    checked_workers(workers)
    todo = tasks(study)
    done, useful = np.zeros(len(todo), dtype=bool), False
    for content in journal.recalled():
        if not settled(content):
            continue
        place = int(np.ravel_multi_index(content["at"], study.shape)) if study.shape else 0
        done[place] = True
        known = recalled(content, todo[place], study.expect)
        useful = useful or not isinstance(known, Failed)
        yield known
    for point in _counted(_answered(study, todo.without(done), workers, watch, keep), journal, len(todo)):
        look()  # a library may have made the point a failed one of it
        if point.code == INTERRUPTED and journal.count:  # the points before it are kept, and the run goes on from there
            raise KeyboardInterrupt
        if isinstance(point, Failed) or point.code != INTERRUPTED:
            slim = _slim(point, study.expect, study.shape)
            final = not (isinstance(slim, Failed) and slim.traceback)
            journal.write(written(slim), final=final)
            point = slim if isinstance(slim, Failed) else point
        useful = useful or not isinstance(point, Failed)
        yield point
    if not useful:  # the study has to be changed
        journal.remove()


def _counted(points: Iterator[tuple[int, Point]], journal: Journal, many: int) -> Iterator[Point]:
    """Yield points; if nobody is left to solve them, tell how many are kept."""
    try:
        for _, point in points:
            yield point
    except NotConverged as error:
        kept = f"{journal.count} of {many} points are kept in '{journal.path}', and the same run goes on from there."
        raise NotConverged(f"{error} {kept}" if journal.count else f"{error} No point was solved.") from None


def _answered(study: Study, todo: Tasks, workers: Workers, watch: Watch, keep: Keep) -> Iterator[tuple[int, Point]]:
    """Yield the places and the points of tasks, as they are ready."""
    whole = study.size <= WHOLE
    alone = study.size == 1  # its error ends the run, and shows where it came from
    answer = functools.partial(_slimmed, expect=study.expect, shape=study.shape, keep=keep, whole=whole, alone=alone)
    if isinstance(workers, Cluster) or (isinstance(workers, int) and workers > 1 < len(todo)):
        yield from completed(answer, todo, workers)
        return
    others, patience = (workers.processors, workers.patience) if isinstance(workers, Machine) else (1, 0.0)
    started = time.monotonic()
    for place, task in enumerate(todo):
        point = answer(task, watch=watch)
        yield place, point
        if point.code == INTERRUPTED:
            return
        rest = place + 1
        if others > 1 < len(todo) - rest and time.monotonic() - started > patience:
            yield from ((rest + later, other) for later, other in completed(answer, todo[rest:], others))
            return


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
