"""Many curves fitted one after the other: progress after each, and an end that keeps what was fitted."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from winkler.study.batch.fit_outcome import FitOutcome
    from winkler.study.language.fit_study import FitStudy


class Progress(NamedTuple):
    """Number of solved points of a sweep or of a path, or of fitted curves."""

    done: int
    total: int | None
    """None if it is not known in advance."""
    what: str = "points"


def fitted_batch(
    study: FitStudy, todo: Sequence[Any], started: float, is_halted: Callable[[], bool]
) -> Generator[Progress, None, FitOutcome]:
    """Fit the curves or files of a study as the command line does; yield the progress after each.

    Parameters
    ----------
    study, todo
        A study, and its pieces.
    started
        When it began, as `time.perf_counter` gives it.
    is_halted
        Asked after each; once it is true, the outcome holds what was fitted.
    """
    from winkler.study.batch.fit_run import fit_curves, gather_fits

    found: dict[int, Any] = {}
    what = "files" if len(study.sources) > 1 else "curves"
    for place, results in fit_curves(study, todo):
        found[place] = results
        if len(todo) > 1:
            yield Progress(len(found), len(todo), what)
            if is_halted():
                break
    return gather_fits(study, found.items(), started=started, left=len(todo) - len(found))
