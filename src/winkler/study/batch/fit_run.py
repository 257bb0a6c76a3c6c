"""Fitting the curves of a study: one after the other or in a pool of processes, as a stream; none stops the others.

With a journal, what came of a curve is written as soon as it is fitted, and what an earlier run has written of a curve
that is still the same is not fitted again.
"""

from __future__ import annotations

import functools
import hashlib
import json
import math
import operator
import re
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType

from winkler.errors import InvalidInput, WinklerError
from winkler.fitting.compare import AnyFit
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit, fit_steps
from winkler.fitting.search import FitState
from winkler.io.curves import PlacedCurve, UnreadCurve, try_curves
from winkler.study.batch.fit_outcome import FitOutcome, Fitted, Refused
from winkler.study.batch.fit_recording import (
    MISTAKE,
    Piece,
    Results,
    fingerprint,
    recalled_fits,
    seen_from,
    written_fits,
)
from winkler.study.batch.journal import Journal
from winkler.study.batch.pool import checked_workers, completed
from winkler.study.batch.run import ERRORS, provenance
from winkler.study.batch.stopping import look
from winkler.study.language.canonical import how_fitted
from winkler.study.language.correcting import corrected
from winkler.study.language.fit_study import FitStudy
from winkler.validity import Assumption, Note, Standing

__all__ = ["Watch", "fit_curves", "fit_study", "gather_fits", "pieces"]

NOTHING: Mapping[int, Results] = MappingProxyType({})

Watch = Callable[[Iterable[FitState | AnyFit]], Iterable[FitState | AnyFit]]
"""Passes on how far a fit has come, state after state, and last what it has found."""


def fit_study(study: FitStudy, *, workers: int = 1, journal: str | Path = "") -> FitOutcome:
    """Fit every curve of a study.

    Parameters
    ----------
    study
        From `winkler.study.language.fit_reading.read_fit_study`.
    workers
        Number of processes; the numbers do not depend on it.
    journal
        File in which fits are kept while it runs: the same call goes on from there if it was stopped. It is removed at
        the end.

    Raises
    ------
    InvalidInput, NotConverged, OutsideValidity
        If no curve can be fitted: the reason of the first.
    """
    started = time.perf_counter()
    todo = pieces(study)
    if journal:
        with Journal(Path(journal), study) as kept:
            known = recalled_fits(study, todo, kept)
            outcome = gather_fits(
                study, fit_curves(study, todo, workers=workers, known=known, journal=kept), started=started
            )
            kept.remove()
        return outcome
    return gather_fits(study, fit_curves(study, todo, workers=workers), started=started)


def pieces(study: FitStudy) -> list[Piece]:
    """Return what workers share: the files of a study, or the curves of its only file."""
    return list(study.sources) if len(study.sources) > 1 else list(_read(study, study.sources[0]))


def fit_curves(
    study: FitStudy,
    todo: Sequence[Piece],
    *,
    workers: int = 1,
    watch: Watch | None = None,
    known: Mapping[int, Results] = NOTHING,
    journal: Journal | None = None,
) -> Iterator[tuple[int, Results]]:
    """Yield the place of every piece and what came of it, first what is known, then others as they are fitted.

    Parameters
    ----------
    study
        The model, and what is free.
    todo
        Files or curves, from `pieces`.
    workers
        Number of processes; 1 fits in this one.
    watch
        Sees every fit while it runs; not those of other processes.
    known
        What an earlier run found, by place, from `recalled_fits`.
    journal
        Where the others are written; it is removed if no curve has an answer, for then the study has to be changed.
    """
    checked_workers(workers)
    yield from known.items()
    left = [place for place in range(len(todo)) if place not in known]
    useful = any(_useful(results) for results in known.values())
    for nth, (mark, results) in _answered(study, [todo[place] for place in left], workers, watch):
        look()  # a library may have made the curve a failed one of it
        if journal is not None:
            journal.write(written_fits(mark, results))
        useful = useful or _useful(results)
        yield left[nth], results
    if journal is not None and not useful:
        journal.remove()


def _useful(results: Results) -> bool:
    return any(isinstance(result, Fitted) for result in results)


def _answered(
    study: FitStudy, todo: list[Piece], workers: int, watch: Watch | None
) -> Iterator[tuple[int, tuple[str, Results]]]:
    if workers == 1 or len(todo) < 2:
        yield from ((place, _marked(study, piece, watch)) for place, piece in enumerate(todo))
    else:
        yield from completed(functools.partial(_marked, study), todo, min(workers, len(todo)))


def _marked(study: FitStudy, piece: Piece, watch: Watch | None = None) -> tuple[str, Results]:
    """Return what came of a piece behind its fingerprint, which is taken before it is read."""
    return fingerprint(study, piece), _fit_piece(study, piece, watch)


def gather_fits(
    study: FitStudy, results: Iterable[tuple[int, Results]], *, started: float, source: str = "", left: int = 0
) -> FitOutcome:
    """Return the outcome of fits.

    Parameters
    ----------
    study
        What was asked.
    results
        What `fit_curves` yields, in any order.
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
    found = tuple(result for _, many in sorted(results, key=operator.itemgetter(0)) for result in many)
    if not any(isinstance(result, Fitted) for result in found):
        first = next(result for result in found if isinstance(result, Refused))
        many = f"none of the {len(found)} curves can be fitted; the first: " if len(found) > 1 else ""
        raise ERRORS.get(first.code, RuntimeError)(f"{many}{first.name}: {first.reason}")
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


def _fit_curve(study: FitStudy, one: PlacedCurve | UnreadCurve, where: str, watch: Watch | None) -> Fitted | Refused:
    """Fit one curve; an error of reading or of the physics, or a mistake of ours, becomes a `Refused`."""
    own = one.name if isinstance(one, UnreadCurve) else one.curve.name
    own = own.encode("utf-8", "backslashreplace").decode()
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
    except Exception as error:  # it costs this curve, not the batch
        reason = " ".join(str(error).split())
        return Refused(name, one.x, one.y, f"an unexpected error, {type(error).__name__}: {reason}", MISTAKE)


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
        **how_fitted(study),
        "curves": [hashlib.sha256(Path(path).read_bytes()).hexdigest() for path in study.sources],
    }
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()
