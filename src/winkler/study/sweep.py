"""The points of a study, solved one after the other, in a pool of processes or on a cluster, as a stream.

The numbers are the same whoever solves them.  With a journal, points are written as soon as they are solved, and those
that an earlier run has written are not solved again.
"""

from __future__ import annotations

import functools
import time
from collections.abc import Iterator

import numpy as np

from winkler.errors import InvalidInput, WinklerError
from winkler.fields import restore
from winkler.study.cluster import Cluster
from winkler.study.journal import Journal
from winkler.study.keeping import Keep
from winkler.study.marching import ANEW, March, Watch, is_march, marched, unwatched
from winkler.study.outcome import Failed, Point, Solved, answers_of
from winkler.study.pool import Machine, Workers, checked_workers, completed
from winkler.study.recording import light, recalled, written
from winkler.study.stopping import INTERRUPTED, look
from winkler.study.study import Expectation, Study
from winkler.study.tasks import Task, Tasks, tasks

__all__ = ["journaled", "solve_points", "solved"]

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
        surface, below = [], []
        for contact in point.each if fields.r.values.size else ():
            if not hasattr(contact, "pressed"):
                raise InvalidInput(
                    f"fields: the answer to {type(problem).__name__} has no fields to restore; remove [fields]."
                )
            radius = float(contact.radius)
            r, z = fields.r.within(radius), fields.z.within(radius)
            surface.append(restore(contact, r))
            if z.size:
                below.append(restore(contact, r[:, np.newaxis], z[np.newaxis, :]))
        return Solved(
            index, settings, problem, solution, found, tuple(surface), tuple(below), march.stopped, march.code
        )
    except WinklerError as error:
        return Failed(index, settings, problem, str(error), error.exit_code)


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
    """
    checked_workers(workers)
    todo = tasks(study)
    done, useful = np.zeros(len(todo), dtype=bool), False
    for content in journal.recalled():
        place = int(np.ravel_multi_index(content["at"], study.shape)) if study.shape else 0
        done[place] = True
        known = recalled(content, todo[place], study.expect)
        useful = useful or not isinstance(known, Failed)
        yield known
    for _, point in _answered(study, todo.without(done), workers, watch, keep):
        look()  # a library may have made the point a failed one of it
        if point.code == INTERRUPTED and journal.count:  # the points before it are kept, and the run goes on from there
            raise KeyboardInterrupt
        if isinstance(point, Failed) or point.code != INTERRUPTED:
            slim = light(point, study.expect, study.shape) if isinstance(point, Solved) else point
            journal.write(written(slim))
        useful = useful or not isinstance(point, Failed)
        yield point
    if not useful:  # the study has to be changed
        journal.remove()


def _answered(study: Study, todo: Tasks, workers: Workers, watch: Watch, keep: Keep) -> Iterator[tuple[int, Point]]:
    """Yield the places and the points of tasks, as they are ready."""
    whole = study.size <= WHOLE
    answer = functools.partial(_slimmed, expect=study.expect, shape=study.shape, keep=keep, whole=whole)
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
) -> Point:
    point = solved(task, watch, keep)
    return light(point, expect, shape) if isinstance(point, Solved) and not whole else point
