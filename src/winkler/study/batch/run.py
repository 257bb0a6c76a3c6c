"""Run a study: solve its points, compare them with the expected numbers, and record the provenance."""

from __future__ import annotations

import datetime
import platform
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from winkler.io.software import software
from winkler.study.batch.journal import Journal
from winkler.study.batch.outcome import Outcome, Provenance
from winkler.study.batch.points import ComparedNumber, Failed, Point, Solved
from winkler.study.batch.pool import Workers
from winkler.study.batch.sweep import solve_points
from winkler.study.batch.verdicts import compared
from winkler.study.language.canonical import digest
from winkler.study.language.study import Study
from winkler.values.errors import InvalidInput, Mistake, NotConverged, OutsideValidity, WinklerError

if TYPE_CHECKING:
    from winkler.study.language.fit_study import FitStudy


Result = TypeVar("Result")

ERRORS = {error.exit_code: error for error in (InvalidInput, NotConverged, OutsideValidity, Mistake)}


def run(study: Study, *, workers: Workers = 1, journal: str | Path = "") -> Outcome:
    """Run a study.

    Parameters
    ----------
    study
        The study, from `winkler.study.language.reading.read_study` or made in Python.
    workers
        Number of processes for a sweep, a `winkler.study.batch.cluster.Cluster`, an executor of processes
        (`concurrent.futures.Executor`, of the standard library or another), or `winkler.study.batch.pool.Machine()` for
        all processors of this machine; the numbers do not depend on it.
    journal
        File in which points are recorded while it runs: a stopped run is continued from it by the same call. It is
        removed at the end.

    Returns
    -------
    Outcome
        Points that failed are in it, with their reasons.  Of sweeps with more than 256 points the solutions are not
        kept; ``point.solution`` solves one again.

    Raises
    ------
    InvalidInput, NotConverged, OutsideValidity, Mistake
        If no point of the study has an answer: the reason of the first, or of the first mistake of winkler's own.
    """
    started = time.perf_counter()
    return resumed(
        study, journal, lambda kept: gather(study, solve_points(study, kept, workers=workers), started=started)
    )


def resumed(study: Study | FitStudy, path: str | Path, outcome: Callable[[Journal | None], Result]) -> Result:
    """Return the outcome of a study, with a journal at `path` if there is one, which is removed at the end."""
    if not path:
        return outcome(None)
    with Journal(Path(path), study) as journal:
        result = outcome(journal)
        journal.remove()
    return result


def gather(study: Study, points: Iterable[Point], *, started: float, source: str = "") -> Outcome:
    """Return the outcome of a study from the stream of its points.

    Parameters
    ----------
    study
        The study.
    points
        Its points from `solve_points`, in any order.
    started
        ``time.perf_counter()`` when the run began.
    source
        Name of the study file.
    """
    compared_points: list[tuple[Point, tuple[ComparedNumber, ...]]] = []
    for point in points:
        if isinstance(point, Solved):
            compared_points.append(
                (point, tuple(compared(point, expectation, study.shape) for expectation in study.expect))
            )
        else:
            compared_points.append((point, () if isinstance(point, Failed) else point.verdicts))
    compared_points.sort(key=lambda pair: pair[0].index)
    ordered = tuple(point for point, _ in compared_points)
    if all(isinstance(point, Failed) for point in ordered):
        first = first_failure(point for point in ordered if isinstance(point, Failed))
        many = f"none of the {len(ordered)} points of the sweep has an answer; the first: " if len(ordered) > 1 else ""
        raise raised(first, many + first.reason)
    verdicts = tuple(verdict for _, verdicts in compared_points for verdict in verdicts)
    made = provenance(digest(study), time.perf_counter() - started, source)
    return Outcome(study, ordered, verdicts, made)


def first_failure(failed: Iterable[Failed]) -> Failed:
    """Return the point that represents all that failed: the first mistake of winkler's own, else the first."""
    each = list(failed)
    return next((point for point in each if point.code == Mistake.exit_code), each[0])


def named(error: WinklerError, name: str) -> WinklerError:
    """Return an error with the name of its file in front of each sentence."""
    return error.reworded(lambda sentence: f"{name}: {sentence}")


def raised(point: Failed, sentence: str) -> WinklerError:
    """Return the error of a point that failed; that of a mistake has its traceback."""
    error = ERRORS.get(point.code, NotConverged)(sentence)
    if point.traceback:
        error.add_note(point.traceback)
    return error


def provenance(question: str, seconds: float, source: str) -> Provenance:
    """Return the provenance of numbers computed now; `question` is the hash of the study."""
    created = datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds")
    made = {"python": platform.python_version(), **software()}
    version, sources = made.pop("winkler"), made.pop("sources")
    return Provenance(version, question, created, seconds, tuple(made.items()), source, sources)
