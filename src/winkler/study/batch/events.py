"""What an answer tells beside its rows: the jumps of a cycle, the branches of a curve, the limit of a sheared contact,
the stages of an impact.

Each is a list of small values; here every one becomes a row of numbers with names and words, for tables and archives.
"""

from __future__ import annotations

import dataclasses
from typing import Any, NamedTuple

from winkler.vocabulary import Word, word

__all__ = ["EVENTS", "Event", "events_of"]

EVENTS = {
    "limit": "Where the contact loses its hold",
    "branches": "Stable branches",
    "jumps": "Jumps",
    "stages": "Sticking and sliding",
}
"""Attribute of a solution -> what a table of it is called."""


class Event(NamedTuple):
    """One number of an event.

    Parameters
    ----------
    name
        As in the glossary; of a state inside, with the name of the state before it: ``before_force``.
    word
        Symbol, unit and meaning.
    content
        SI.
    """

    name: str
    word: Word
    content: float


def events_of(solution: Any, name: str) -> tuple[tuple[Event, ...], ...]:
    """Return one row of numbers for every event of a solution; none if it has no such events."""
    content = getattr(solution, name, ())
    items = content if isinstance(content, tuple) else (content,)
    return tuple(tuple(_numbers(item)) for item in items if dataclasses.is_dataclass(item))


def _numbers(item: Any) -> list[Event]:
    found = []
    for field in dataclasses.fields(item):
        inside, told = getattr(item, field.name), word(type(item), field.name)
        if dataclasses.is_dataclass(inside):
            found += [
                Event(
                    f"{field.name}_{one.name}", one.word._replace(meaning=f"{one.word.meaning}; {told.meaning}"), one[2]
                )
                for one in _numbers(inside)
            ]
        elif isinstance(inside, int | float):
            found.append(Event(field.name, told, float(inside)))
    return found
