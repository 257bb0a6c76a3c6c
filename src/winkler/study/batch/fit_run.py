"""The fits of the curves of a study as a stream; a curve that fails does not stop the others.

A result in the journal is used as long as its curve is unchanged.
"""

from __future__ import annotations

import dataclasses
import functools
import hashlib
import json
import math
import operator
import re
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from pathlib import Path
from types import MappingProxyType

import numpy as np

from winkler.fitting.compare import AnyFit
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit, fit_steps
from winkler.fitting.search import FitState
from winkler.io.curves import PlacedCurve, UnreadCurve, try_curves
from winkler.study.batch.cluster import Cluster
from winkler.study.batch.fit_further import further_of, joint_of_study
from winkler.study.batch.fit_outcome import FitOutcome, Fitted, Refused
from winkler.study.batch.fit_recording import (
    Piece,
    Results,
    fingerprint,
    path_from_study,
    recalled_fits,
    written_fits,
)
from winkler.study.batch.journal import Journal
from winkler.study.batch.pool import Workers
from winkler.study.batch.run import ERRORS, provenance, resumed
from winkler.study.batch.stream import results
from winkler.study.language.canonical import how_fitted
from winkler.study.language.correcting import corrected
from winkler.study.language.fit_study import FitStudy
from winkler.study.language.segmenting import segmented, with_stated_events
from winkler.values.errors import InvalidInput, Mistake, WinklerError
from winkler.values.validity import Assumption, Note, Standing

NO_RESULTS: Mapping[int, Results] = MappingProxyType({})
FitWatch = Callable[[Iterable[FitState | AnyFit]], Iterable[FitState | AnyFit]]
"""Passes on the states of a fit, one after the other, and last the result."""


def fit_study(study: FitStudy, *, workers: Workers = 1, journal: str | Path = "") -> FitOutcome:
    """Fit every curve of a study.

    Parameters
    ----------
    study
        From `winkler.study.language.fit_reading.read_fit_study`.
    workers, journal
        As for `winkler.study.batch.run.run`.

    Raises
    ------
    InvalidInput, NotConverged, OutsideValidity
        If no curve can be fitted: the reason of the first.
    """
    started = time.perf_counter()
    todo = pieces(study)

    def outcome(recorded: Journal | None) -> FitOutcome:
        earlier = NO_RESULTS if recorded is None else recalled_fits(study, todo, recorded)
        return gather_fits(study, fit_curves(study, todo, earlier, workers=workers, journal=recorded), started=started)

    return resumed(study, journal, outcome)


def pieces(study: FitStudy) -> list[Piece]:
    """Return the pieces of work: the files of a study, or the curves of its only file."""
    return list(study.sources) if len(study.sources) > 1 else list(_read(study, study.sources[0]))


def fit_curves(
    study: FitStudy,
    todo: Sequence[Piece],
    earlier: Mapping[int, Results] = NO_RESULTS,
    *,
    workers: Workers = 1,
    watch: FitWatch | None = None,
    journal: Journal | None = None,
) -> Iterator[tuple[int, Results]]:
    """Yield the place of every piece and its results, first those of an earlier run, then others as they are fitted.

    Parameters
    ----------
    study
        The model, and what is free.
    todo
        Files or curves, from `pieces`.
    known
        Results of an earlier run, by place, from `recalled_fits`.
    workers, watch, journal
        As for `winkler.study.batch.stream.results`.
    """

    def recorded(computed: tuple[str, Results]) -> Results:
        if journal is not None:
            journal.write(written_fits(*computed))
        return computed[1]

    if isinstance(workers, Cluster | Executor):  # whose processes may have been started in another folder
        sources = tuple(str(Path(path).absolute()) for path in study.sources)
        study = dataclasses.replace(study, sources=sources, folder=str(Path(study.folder).absolute()))
        todo = [str(Path(piece).absolute()) if isinstance(piece, str) else piece for piece in todo]
    return results(
        todo,
        functools.partial(_marked, study),
        earlier=earlier.items(),
        left=lambda done: [todo[place] for place in np.flatnonzero(~done).tolist()],
        result=recorded,
        useful=lambda curves: any(isinstance(one, Fitted) for one in curves),
        journal=journal,
        names=("files" if len(study.sources) > 1 else "curves", "fitted"),
        workers=workers,
        watch=watch,
    )


def _marked(study: FitStudy, piece: Piece, watch: FitWatch | None = None) -> tuple[str, Results]:
    """Return the fingerprint of a piece, which is computed before it is read, and its results."""
    return fingerprint(study, piece), _fit_piece(study, piece, watch)


def gather_fits(
    study: FitStudy, found: Iterable[tuple[int, Results]], *, started: float, source: str = "", left: int = 0
) -> FitOutcome:
    """Return the outcome of fits.

    Parameters
    ----------
    study
        The study.
    found
        The pairs that `fit_curves` yields, in any order.
    started, source
        As for `winkler.study.batch.run.gather`.
    left
        Number of pieces that were not reached.

    Raises
    ------
    InvalidInput, NotConverged, OutsideValidity
        If no curve has an answer: the reason of the first.
    """
    each = tuple(result for _, many in sorted(found, key=operator.itemgetter(0)) for result in many)
    if not any(isinstance(result, Fitted) for result in each):
        first = next(result for result in each if isinstance(result, Refused))
        many = f"none of the {len(each)} curves can be fitted; the first: " if len(each) > 1 else ""
        raise ERRORS[first.code](f"{many}{first.name}: {first.reason}")
    made = provenance(_hash(study), time.perf_counter() - started, source)
    outcome = FitOutcome(study, each, made, left)
    joint = joint_of_study(study, [result.fit for result in outcome.independent])
    return dataclasses.replace(outcome, joint=joint[0], joint_failure=joint[1])


def _read(study: FitStudy, path: str) -> Iterator[PlacedCurve | UnreadCurve]:
    return try_curves(
        path,
        spring_constant=study.spring_constant or None,
        sensitivity=study.sensitivity or None,
        units=dict(study.units),
        columns=dict(study.columns),
    )


def _fit_piece(study: FitStudy, piece: Piece, watch: FitWatch | None = None) -> tuple[Fitted | Refused, ...]:
    if isinstance(piece, str):
        where = path_from_study(study, piece)
        return tuple(_fit_curve(study, one, where, watch) for one in _read(study, piece))
    where = path_from_study(study, study.sources[0]) if study.sources else ""
    return (_fit_curve(study, piece, where, watch),)


def _fit_curve(study: FitStudy, one: PlacedCurve | UnreadCurve, where: str, watch: FitWatch | None) -> Fitted | Refused:
    """Fit one curve; an error of reading or of the physics, or a programming error of winkler, becomes a `Refused`."""
    own = one.name if isinstance(one, UnreadCurve) else one.curve.name
    own = own.encode("utf-8", "backslashreplace").decode()
    file = where.rpartition("/")[2]
    name = where + own.removeprefix(file) if own.startswith(file) else own
    if isinstance(one, UnreadCurve):
        reason = re.sub(rf"^\S*{re.escape(file)}: ", "", one.reason)
        return Refused(name, math.nan, math.nan, reason, InvalidInput.exit_code)
    try:
        how = study.correct, study.frame_stiffness, study.part, study.segments, study.events
        curve, steps = corrected(dataclasses.replace(one.curve, noise_spectrum=study.noise_spectrum), *how)
        fitted = _fit_of(study, curve, watch)
        return Fitted(name, one.x, one.y, steps, fitted, _notes(fitted), further_of(study, curve, fitted))
    except WinklerError as error:
        return Refused(name, one.x, one.y, str(error), error.exit_code)
    except Exception as error:  # this curve fails, not the batch
        reason = " ".join(str(error).split())
        return Refused(name, one.x, one.y, f"an unexpected error, {type(error).__name__}: {reason}", Mistake.exit_code)


def _fit_of(study: FitStudy, curve: ForceCurve, watch: FitWatch | None) -> AnyFit:
    free = {free.path: free.start_or_bounds for free in study.free}
    if watch is None:
        fitted: AnyFit = fit(curve, study.problem, free=free, noise=study.noise, time_limit=study.time_limit)
        return fitted
    steps = fit_steps(curve, study.problem, free=free, noise=study.noise, time_limit=study.time_limit)
    last = list(watch(steps))[-1]
    assert isinstance(last, AnyFit)
    return last


def measured_curve(study: FitStudy, result: Fitted) -> ForceCurve:
    """Return the curve of a file with its stated segments and events; the fitted part of it if it cannot be read again.

    Curves of a map are not read again.
    """
    for path in study.sources:
        if path_from_study(study, path) == result.name:
            try:
                (one,) = _read(study, path)
                if isinstance(one, PlacedCurve):
                    curve = segmented(one.curve, study.segments) if study.segments else one.curve
                    return with_stated_events(curve, study.events)
            except (WinklerError, ValueError):  # changed since, or several curves
                break
    return result.fit.curve


def _notes(fitted: AnyFit) -> tuple[Note, ...]:
    try:
        return fitted.validity
    except WinklerError as error:  # the fit holds; the note states what is unknown at its largest depth
        return (
            Note(
                Assumption.CURVE, Standing.OUTSIDE, f"At the largest depth of the fit: {error}", "the model's own check"
            ),
        )


def _hash(study: FitStudy) -> str:
    """Return the SHA-256 of the study: the model, the free numbers, the corrections, and the bytes of the curves."""
    content = {
        **how_fitted(study),
        "curves": [hashlib.sha256(Path(path).read_bytes()).hexdigest() for path in study.sources],
    }
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()
