"""The folder of results that a command writes: for one run at a time, whole or not at all, resumed after a stop."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from winkler.cli.streams import safe, write_json

if TYPE_CHECKING:
    from winkler.study.batch.checkpoint import CheckpointStore
    from winkler.study.batch.fit_outcome import FitOutcome
    from winkler.study.batch.journal import Journal
    from winkler.study.batch.outcome import Outcome
    from winkler.study.batch.points import ComparedNumber
    from winkler.study.nanoindentation.running import NanoindentationOutcome

MOST_DOUBTFUL = 5
"""Curves with doubts that are printed; the table of curves holds all."""


@contextlib.contextmanager
def resumed(
    folder: Path, journal: Journal, keep: CheckpointStore | None = None, *, many: str, overwrite: bool, anew: bool
) -> Iterator[Path]:
    """Provide an empty folder for the results; the records of earlier runs are removed once the results are complete.

    Parameters
    ----------
    folder
        Where the results go.
    journal, keep
        Records of an earlier run: points or fits, and states of marches.
    many
        Number of points, files or curves, as text.
    overwrite
        Whether results may be replaced; those of a batch that is continued may always.
    anew
        Whether to remove the records of earlier runs first.

    Raises
    ------
    InvalidInput
        If the folder, or the journal, cannot be used.
    Interrupted
        After Ctrl-C, if points or fits are kept.
    """
    from winkler.io.processes.stopping import deferred_signals
    from winkler.study.report.reserving import reserved
    from winkler.study.report.writing import holds_results, missing, placed
    from winkler.values.errors import Interrupted

    with reserved(folder):
        goes_on = not anew and bool(missing(folder))
        if holds_results(folder) and not overwrite and not goes_on:
            overwrite = _may_overwrite(folder)
        if anew:
            _remove_records(journal, keep)
        with journal:
            if goes_on and not overwrite:
                overwrite = journal.count > 0 or _may_overwrite(folder)
            try:
                with placed(folder, overwrite=overwrite) as partial:
                    yield partial
            except KeyboardInterrupt:
                if not journal.count:
                    raise
                kept_text = f"{journal.count} of {many} are kept beside {folder}"
                raise Interrupted(f"interrupted; {kept_text}, and the same command goes on from there.") from None
            if journal.complete:
                with deferred_signals():
                    _remove_records(journal, keep)


def _remove_records(journal: Journal, keep: CheckpointStore | None) -> None:
    journal.remove()
    if keep is not None:
        keep.remove()


def _may_overwrite(folder: Path) -> bool:
    """Ask whether the results in `folder` may be replaced; refuse if stdin is no terminal."""
    from winkler.values.errors import InvalidInput

    if not sys.stdin.isatty():
        raise InvalidInput(
            f"output: '{folder}' already holds results; add --overwrite to replace them, or give another folder with "
            "--output."
        )
    if typer.confirm(safe(f"'{folder}' already holds results. Replace them?"), err=True):
        return True
    raise InvalidInput(f"output: '{folder}' was kept; give another folder with --output.")


def write_outcome_json(outcome: Outcome | FitOutcome, folder: Path | None, columns: str, more: dict[str, Any]) -> None:
    """Write an outcome as JSON.

    Parameters
    ----------
    outcome
        The outcome of a study.
    folder
        Folder of the results; None if none was written.
    columns
        Name of its table.
    more
        Further entries.
    """
    made = outcome.provenance
    write_json(
        {
            "title": outcome.study.title,
            "folder": str(folder) if folder else None,
            "version": made.version,
            "sources": made.sources,
            "hash": made.hash,
            "seconds": made.seconds,
            columns: [
                {"name": column.name, "unit": column.word.unit, "values": column.content} for column in outcome.table()
            ],
            **more,
            "validity": validity_json(outcome),
        }
    )


def validity_json(outcome: Outcome | FitOutcome | NanoindentationOutcome) -> list[dict[str, Any]]:
    """Return the notes on the validity of an outcome for JSON."""
    return [
        {
            "assumption": note.assumption.value,
            "standing": note.standing.value,
            "statement": note.statement,
            "source": note.source,
            "error": note.error,
        }
        for note in outcome.validity
    ]


def verdict_json(verdict: ComparedNumber) -> dict[str, Any]:
    """Return a verdict for JSON."""
    item = verdict.expectation
    return {
        "index": list(verdict.index),
        "quantity": item.quantity,
        "place": dict(item.place),
        "unit": item.unit,
        "expected": item.expected,
        "got": verdict.got,
        "deviation": verdict.deviation,
        "tolerance": item.tolerance,
        "digits": verdict.digits,
        "passed": verdict.passed,
    }


def print_batch(outcome: FitOutcome | NanoindentationOutcome, out: Any, file: str) -> None:
    """Print median and scatter of the curves of a batch, and which of them are doubtful.

    Parameters
    ----------
    outcome
        With several curves.
    out
        Console.
    file
        Name of the table that holds all curves.
    """
    from winkler.cli import terminal
    from winkler.fitting.several.standing_out import LEAST_STATED

    if len(outcome.independent) >= LEAST_STATED:
        table = terminal.table(f"of {len(outcome.independent)} curves", "median", "MAD")
        for one in outcome.batch:
            table.add_row(one.name, one.text(one.median, 4), one.text(one.deviation, 2))
        out.print(table)
    for name, doubts in outcome.doubts[:MOST_DOUBTFUL]:
        out.print(f"doubtful: {name}: {' '.join(doubts)}", soft_wrap=True)
    if len(outcome.doubts) > MOST_DOUBTFUL:
        out.print(f"and {len(outcome.doubts) - MOST_DOUBTFUL} more with doubts, see {file}.")


def batch_json(outcome: FitOutcome | NanoindentationOutcome) -> dict[str, Any]:
    """Return median and scatter of the curves of a batch, and which of them are doubtful, for JSON."""
    return {
        "batch": [
            {"name": one.name, "unit": one.unit, "median": one.median, "mad": one.deviation} for one in outcome.batch
        ],
        "doubts": [{"curve": name, "doubts": list(doubts)} for name, doubts in outcome.doubts],
    }
