"""The validity of a result: the assumptions behind it, the check of each one, and the source.

`Assumption` is the closed list.  Every problem declares in ``assumptions`` those that its result rests on; every
solution carries a tuple of `Note`, each of which states one of them, and its `Standing`.  The standing of a result is
the worst of its notes.  docs/validity.md states for every assumption how it is tested and what violating it costs.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from enum import Enum

from winkler.values.assumption import Assumption
from winkler.values.value import value

EXACT_PART, LEFT_PARTS = 1e-4, (0.01, 0.1)
"""What a solver may leave of an answer that is exact; of one that is asymptotic and approximate."""

__all__ = [
    "Assumption",
    "Note",
    "Standing",
    "in_words",
    "standing_left",
    "standing_of",
    "topic_of",
    "worst",
    "worst_note",
    "worst_of_each",
]


class Standing(Enum):
    """The levels of a validity note, from best to worst."""

    EXACT = "exact"
    ASYMPTOTIC = "asymptotic"
    APPROXIMATE = "approximate"
    OUTSIDE = "outside"


@value
class Note:
    """One statement about the validity of a result.

    Parameters
    ----------
    assumption
        The assumption to which the note refers.
    standing
        exact; asymptotic (exact in a limit, the deviation is stated); approximate (the error is stated); outside (the
        result is not reliable).
    statement
        One sentence in plain words.
    source
        The source of the statement: a citation with DOI, or the check that was made.
    error
        Approximate relative error of the result for this reason [-]; None if it is not known.
    """

    assumption: Assumption
    standing: Standing
    statement: str
    source: str
    error: float | None = None

    def __str__(self) -> str:
        return f"{self.standing.value}: {self.statement} [{self.source}]"

    def __repr__(self) -> str:
        return f"<{self}>"


def standing_of(number: float, small: float, large: float) -> Standing:
    """Return asymptotic up to the limit `small`, approximate up to `large`, and outside beyond, or of no number."""
    return Standing.ASYMPTOTIC if number <= small else Standing.APPROXIMATE if number <= large else Standing.OUTSIDE


def standing_left(part: float, best: Standing = Standing.EXACT) -> Standing:
    """Return the standing of an answer of which a solver leaves a part, at most `best`.

    Parameters
    ----------
    part : float
        What is left over the size of the answer [-]: up to 1e-4 it is exact, up to 0.01 asymptotic, up to 0.1
        approximate, and outside beyond, or of no number.
    best : Standing, optional
        Of the theory.
    """
    found = Standing.EXACT if part <= EXACT_PART else standing_of(part, *LEFT_PARTS)
    return max(best, found, key=list(Standing).index)


def worst(notes: Iterable[Note]) -> Standing:
    """Return the worst standing among `notes`; exact if there are none."""
    order = list(Standing)
    return max((note.standing for note in notes), key=order.index, default=Standing.EXACT)


IN_WORDS = {
    Standing.EXACT: "exact in its theory",
    Standing.ASYMPTOTIC: "good here",
    Standing.APPROXIMATE: "an estimate",
    Standing.OUTSIDE: "do not use",
}
"""Standing -> what a user may do with a result."""


def in_words(notes: Iterable[Note]) -> str:
    """Return what a user may do with a result of these notes, with its error where one is known.

    Of an estimate, some of whose notes know no error, it is the least that it is off; nothing is "good to about" a
    number that only some of its notes know.

    Examples
    --------
    >>> in_words([Note(Assumption.SMALL_SLOPES, Standing.ASYMPTOTIC, "The slope is 0.09.", "Hay", 0.03)])
    'good to about 3 %'
    """
    told = tuple(notes)
    standing = worst(told)
    errors = [note.error for note in told if note.standing is standing]
    known = [error for error in errors if error is not None]
    is_whole = len(known) == len(errors)
    if not known or standing not in (Standing.ASYMPTOTIC, Standing.APPROXIMATE):
        return IN_WORDS[standing]
    percent = f"{float(f'{100.0 * max(known):.1g}'):g} %"
    if standing is Standing.APPROXIMATE:
        return f"an estimate: ± {percent}" if is_whole else f"an estimate: ± {percent} or more"
    return f"good to about {percent}" if is_whole else IN_WORDS[standing]


def worst_note(notes: Iterable[Note]) -> Note | None:
    """Return the note that decides: of the worst standing that with the greatest error, or the first; None of none."""
    return max(notes, key=_badness, default=None)


def worst_of_each(notes: Iterable[Note]) -> tuple[Note, ...]:
    """Return notes; of statements that differ in their numbers only, the worst: of one standing, the greatest error."""
    collected: dict[str, Note] = {}
    for note in notes:
        topic = topic_of(note)
        if topic not in collected or _badness(note) >= _badness(collected[topic]):
            collected[topic] = note
    return tuple(collected.values())


def _badness(note: Note) -> tuple[int, float]:
    """Return what sorts notes from the best to the worst; of one standing by what they know of the error."""
    return list(Standing).index(note.standing), note.error or 0.0


def topic_of(note: Note) -> str:
    """Return the beginning of a statement, without its numbers: notes on one subject have one topic."""
    return re.sub(r"[-+]?\d[-+.\de]*", "#", note.statement).partition(":")[0]
