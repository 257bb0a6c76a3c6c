"""Running a study: solve its points, judge what was expected, remember what made the numbers."""

from __future__ import annotations

import datetime
import platform
import time
from collections.abc import Iterable
from importlib.metadata import version

from winkler.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.study.canonical import digest
from winkler.study.judging import judge
from winkler.study.outcome import Failed, Outcome, Provenance, Solved, Verdict
from winkler.study.study import Study
from winkler.study.sweep import solve_points

__all__ = ["ERRORS", "gather", "provenance", "run"]

ERRORS = {error.exit_code: error for error in (InvalidInput, NotConverged, OutsideValidity)}


def run(study: Study, *, workers: int = 1) -> Outcome:
    """Run a study.

    Parameters
    ----------
    study
        What to solve, from `winkler.study.reading.read_study` or made in Python.
    workers
        Number of processes for a sweep; the numbers do not depend on it.

    Returns
    -------
    Outcome
        Points that failed are in it, with their reasons.

    Raises
    ------
    InvalidInput, NotConverged, OutsideValidity
        If no point of the study has an answer: the reason of the first.
    """
    started = time.perf_counter()
    return gather(study, solve_points(study, workers=workers), started=started)


def gather(study: Study, points: Iterable[Solved | Failed], *, started: float, source: str = "") -> Outcome:
    """Return the outcome of a study from the stream of its points.

    Parameters
    ----------
    study
        What was asked.
    points
        What `solve_points` yields.
    started
        ``time.perf_counter()`` when the run began.
    source
        Name of the study file.
    """
    found: list[Solved | Failed] = []
    verdicts: list[Verdict] = []
    for point in points:
        found.append(point)
        if isinstance(point, Solved):
            verdicts += [judge(point, expectation) for expectation in study.expect]
    if not any(isinstance(point, Solved) for point in found):
        first = next(point for point in found if isinstance(point, Failed))
        many = f"none of the {len(found)} points of the sweep has an answer; the first: " if len(found) > 1 else ""
        raise ERRORS.get(first.code, NotConverged)(many + first.reason)
    made = provenance(digest(study), time.perf_counter() - started, source)
    return Outcome(study, tuple(found), tuple(verdicts), made)


def provenance(question: str, seconds: float, source: str) -> Provenance:
    """Return what made numbers now; `question` is the hash of what was asked."""
    created = datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds")
    packages = (("python", platform.python_version()), *((name, version(name)) for name in ("numpy", "scipy")))
    return Provenance(version("winkler"), question, created, seconds, packages, source)
