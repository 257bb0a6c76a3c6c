"""The folder of results that a command writes: for one run at a time, whole or not at all, resumed after a stop."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from winkler.cli.saying import safe, say_json

if TYPE_CHECKING:
    from winkler.study.batch.checkpoint import Keep
    from winkler.study.batch.fit_outcome import FitOutcome
    from winkler.study.batch.journal import Journal
    from winkler.study.batch.outcome import Outcome

__all__ = ["resumed", "say_outcome"]


@contextlib.contextmanager
def resumed(
    folder: Path, journal: Journal, keep: Keep | None = None, *, many: str, overwrite: bool, anew: bool
) -> Iterator[Path]:
    """Give an empty folder to write results into; what earlier runs have left is forgotten if they are complete.

    Parameters
    ----------
    folder
        Where the results go.
    journal, keep
        What an earlier run has left: points or fits, and states of marches.
    many
        How many points, files or curves there are, in words.
    overwrite
        Whether results may be replaced; those of a batch that is to go on may always.
    anew
        Whether to forget at once what was left.

    Raises
    ------
    InvalidInput
        If the folder, or the journal, is of no use.
    Interrupted
        After Ctrl-C, if something is kept.
    """
    from winkler.errors import Interrupted
    from winkler.study.batch.stopping import held
    from winkler.study.report.reserving import reserved
    from winkler.study.report.writing import holds_results, missing, placed

    with reserved(folder):
        goes_on = not anew and bool(missing(folder))
        if holds_results(folder) and not overwrite and not goes_on:
            overwrite = _may_overwrite(folder)
        if anew:
            _forget(journal, keep)
        with journal:
            if goes_on and not overwrite:
                overwrite = journal.count > 0 or _may_overwrite(folder)
            try:
                with placed(folder, overwrite=overwrite) as partial:
                    yield partial
            except KeyboardInterrupt:
                if not journal.count:
                    raise
                kept = f"{journal.count} of {many} are kept beside {folder}"
                raise Interrupted(f"interrupted; {kept}, and the same command goes on from there.") from None
            if journal.complete:
                with held():
                    _forget(journal, keep)


def _forget(journal: Journal, keep: Keep | None) -> None:
    journal.remove()
    if keep is not None:
        keep.forget()


def _may_overwrite(folder: Path) -> bool:
    """Ask whether the results in `folder` may be replaced; refuse where nobody can answer."""
    from winkler.errors import InvalidInput

    if not sys.stdin.isatty():
        raise InvalidInput(
            f"output: '{folder}' already holds results; add --overwrite to replace them, or give another folder with "
            "--output."
        )
    if typer.confirm(safe(f"'{folder}' already holds results. Replace them?"), err=True):
        return True
    raise InvalidInput(f"output: '{folder}' was kept; give another folder with --output.")


def say_outcome(outcome: Outcome | FitOutcome, folder: Path | None, columns: str, more: dict[str, Any]) -> None:
    """Say an outcome as JSON.

    Parameters
    ----------
    outcome
        What a study came to.
    folder
        Where it was written; None if nowhere.
    columns
        What its table is called.
    more
        What else there is to say.
    """
    made = outcome.provenance
    say_json(
        {
            "title": outcome.study.title,
            "folder": str(folder) if folder else None,
            "version": made.version,
            "hash": made.hash,
            "seconds": made.seconds,
            columns: [
                {"name": column.name, "unit": column.word.unit, "values": column.content} for column in outcome.table()
            ],
            **more,
            "validity": [
                {
                    "assumption": note.assumption.value,
                    "standing": note.standing.value,
                    "statement": note.statement,
                    "source": note.source,
                }
                for note in outcome.validity
            ],
        }
    )
