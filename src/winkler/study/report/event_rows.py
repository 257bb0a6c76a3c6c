"""The events of all points of a study: jumps, branches, limits and stages as rows of tables."""

from __future__ import annotations

from winkler.study.batch.events import Event
from winkler.study.batch.outcome import Outcome
from winkler.study.batch.points import SolvedPoint

__all__ = ["columns_of", "rows_of"]


def columns_of(outcome: Outcome, name: str) -> tuple[Event, ...]:
    """Return the first row of events of a kind in a study, whose names and words all rows share; empty if none."""
    return next((rows[0] for _, rows in rows_of(outcome, name)), ())


def rows_of(outcome: Outcome, name: str) -> list[tuple[SolvedPoint, tuple[tuple[Event, ...], ...]]]:
    """Return the points that have events of a kind, with their rows."""
    pairs = [(point, point.events(name)) for point in outcome.solved]
    return [(point, rows) for point, rows in pairs if rows]
