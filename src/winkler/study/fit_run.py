"""Fitting the curves of a study: one after the other or in a pool of processes, as a stream; none stops the others."""

from __future__ import annotations

import functools
import hashlib
import json
import math
import re
import time
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

from winkler.errors import InvalidInput, NotConverged, WinklerError
from winkler.fitting.compare import AnyFit
from winkler.fitting.curve import ForceCurve
from winkler.fitting.fit import fit, fit_steps
from winkler.fitting.search import FitState
from winkler.io.curves import PlacedCurve, UnreadCurve, try_curves
from winkler.study.canonical import digest
from winkler.study.correcting import corrected
from winkler.study.fit_outcome import FitOutcome, Fitted, Refused
from winkler.study.fitting import FitStudy
from winkler.study.pool import pooled
from winkler.study.run import ERRORS, provenance
from winkler.study.study import Study
from winkler.validity import Assumption, Note, Standing

__all__ = ["Watch", "fit_curves", "fit_study", "gather_fits", "pieces", "seen_from"]

Piece = str | PlacedCurve | UnreadCurve
"""A file of many, or a curve of one file."""


Watch = Callable[[Iterable[FitState | AnyFit]], Iterable[FitState | AnyFit]]
"""Passes on how far a fit has come, state after state, and last what it has found."""


def fit_study(study: FitStudy, *, workers: int = 1) -> FitOutcome:
    """Fit every curve of a study.

    Parameters
    ----------
    study
        From `winkler.study.fit_reading.read_fit_study`.
    workers
        Number of processes; the numbers do not depend on it.

    Raises
    ------
    InvalidInput, NotConverged, OutsideValidity
        If no curve can be fitted: the reason of the first.
    """
    started = time.perf_counter()
    results = [result for many in fit_curves(study, pieces(study), workers=workers) for result in many]
    return gather_fits(study, results, started=started)


def pieces(study: FitStudy) -> list[Piece]:
    """Return what workers share: the files of a study, or the curves of its only file."""
    return list(study.sources) if len(study.sources) > 1 else list(_read(study, study.sources[0]))


def fit_curves(
    study: FitStudy, todo: list[Piece], *, workers: int = 1, watch: Watch | None = None
) -> Iterator[tuple[Fitted | Refused, ...]]:
    """Yield what came of every piece as soon as it is known, in their order.

    Parameters
    ----------
    study
        The model, and what is free.
    todo
        Files or curves, from `pieces`.
    workers
        Number of processes; 1 fits in this one.
    watch
        Sees every fit on its way; not those of other processes.
    """
    if isinstance(workers, bool) or not isinstance(workers, int) or workers < 1:
        raise InvalidInput(f"workers is {workers!r}; give a whole number from 1 on.")
    if workers == 1 or len(todo) == 1:
        yield from (_fit_piece(study, piece, watch) for piece in todo)
    else:
        yield from pooled(functools.partial(_fit_piece, study), todo, min(workers, len(todo)))


def gather_fits(
    study: FitStudy, results: Iterable[Fitted | Refused], *, started: float, source: str = "", left: int = 0
) -> FitOutcome:
    """Return the outcome of fits.

    Parameters
    ----------
    study
        What was asked.
    results
        What came of the curves.
    started
        ``time.perf_counter()`` when the run began.
    source
        Name of the study file.
    left
        Number of pieces that were not reached.

    Raises
    ------
    InvalidInput, NotConverged, OutsideValidity
        If no curve has an answer: the reason of the first.
    """
    found = tuple(results)
    if not any(isinstance(result, Fitted) for result in found):
        first = next(result for result in found if isinstance(result, Refused))
        many = f"none of the {len(found)} curves can be fitted; the first: " if len(found) > 1 else ""
        raise ERRORS.get(first.code, NotConverged)(f"{many}{first.name}: {first.reason}")
    made = provenance(_hash(study), time.perf_counter() - started, source)
    return FitOutcome(study, found, made, left)


def _read(study: FitStudy, path: str) -> Iterator[PlacedCurve | UnreadCurve]:
    return try_curves(path, spring_constant=study.spring_constant or None, sensitivity=study.sensitivity or None)


def _fit_piece(study: FitStudy, piece: Piece, watch: Watch | None = None) -> tuple[Fitted | Refused, ...]:
    if isinstance(piece, str):
        where = seen_from(study, piece)
        return tuple(_fit_curve(study, one, where, watch) for one in _read(study, piece))
    where = seen_from(study, study.sources[0]) if study.sources else ""
    return (_fit_curve(study, piece, where, watch),)


def seen_from(study: FitStudy, path: str) -> str:
    """Return a file as seen from the study."""
    try:
        return Path(path).relative_to(study.folder).as_posix()
    except ValueError:
        return Path(path).as_posix()


def _fit_curve(study: FitStudy, one: PlacedCurve | UnreadCurve, where: str, watch: Watch | None) -> Fitted | Refused:
    """Fit one curve; an error of reading or of the physics becomes a `Refused`."""
    own = one.name if isinstance(one, UnreadCurve) else one.curve.name
    file = where.rpartition("/")[2]
    name = where + own.removeprefix(file) if own.startswith(file) else own
    if isinstance(one, UnreadCurve):
        reason = re.sub(rf"^\S*{re.escape(file)}: ", "", one.reason)
        return Refused(name, math.nan, math.nan, reason, InvalidInput.exit_code)
    try:
        curve, steps = corrected(one.curve, study.correct, study.frame_stiffness, study.part, study.segments)
        found = _found(study, curve, watch)
        return Fitted(name, one.x, one.y, steps, found, _notes(found))
    except WinklerError as error:
        return Refused(name, one.x, one.y, str(error), error.exit_code)


def _found(study: FitStudy, curve: ForceCurve, watch: Watch | None) -> AnyFit:
    free = {free.path: free.asked for free in study.free}
    if watch is None:
        found: AnyFit = fit(curve, study.problem, free=free, noise=study.noise, time_limit=study.time_limit)
        return found
    steps = fit_steps(curve, study.problem, free=free, noise=study.noise, time_limit=study.time_limit)
    last = list(watch(steps))[-1]
    assert isinstance(last, AnyFit)
    return last


def _notes(found: AnyFit) -> tuple[Note, ...]:
    try:
        return found.validity
    except WinklerError as error:  # the fit stands; what cannot be told about its largest depth is said
        return (
            Note(
                Assumption.CURVE, Standing.OUTSIDE, f"At the largest depth of the fit: {error}", "the model's own check"
            ),
        )


def _hash(study: FitStudy) -> str:
    """Return the SHA-256 of the question: the model, what is free, what was done, and the bytes of the curves."""
    content = {
        "model": digest(Study("", study.problem)),
        "free": [[free.key, list(free.given)] for free in study.free],
        "how": [study.part, study.fitted, list(study.correct), *([list(study.segments)] if study.segments else [])],
        "numbers": [
            str(number) for number in (study.spring_constant, study.sensitivity, study.frame_stiffness, study.noise)
        ],
        "curves": [hashlib.sha256(Path(path).read_bytes()).hexdigest() for path in study.sources],
    }
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()
