"""Events of a solution: the jumps of a cycle, the branches of a curve, the limit of a sheared contact, the stages of an
impact, the onsets of yield of several bodies.

Each event becomes a row of numbers and texts with names and glossary entries, for tables and archives.
"""

from __future__ import annotations

import dataclasses
from typing import Any, NamedTuple

from winkler.values.vocabulary import Word, word

EVENTS = {
    "limit": "Where the contact loses its hold",
    "branches": "Stable branches",
    "jumps": "Jumps",
    "stages": "Sticking and sliding",
    "onsets": "Where each body begins to yield",
}
"""Attribute of a solution -> title of its table."""


class Event(NamedTuple):
    """One number or text of an event.

    Parameters
    ----------
    name
        As in the glossary; of a member of a state, preceded by the name of the state: ``before_force``.
    word
        Symbol, unit and meaning.
    content
        SI; a text where the unit of the word is None.
    """

    name: str
    word: Word
    content: float | str


def events_of(solution: Any, name: str) -> tuple[tuple[Event, ...], ...]:
    """Return one row for every event of a solution; none if it has no such events."""
    content = getattr(solution, name, ())
    items = content if isinstance(content, tuple) else (content,)
    return tuple(tuple(_numbers(item)) for item in items if dataclasses.is_dataclass(item))


def _numbers(item: Any) -> list[Event]:
    events = []
    for field in dataclasses.fields(item):
        member, entry = getattr(item, field.name), word(type(item), field.name)
        if dataclasses.is_dataclass(member):
            events += [
                Event(
                    f"{field.name}_{one.name}",
                    one.word._replace(meaning=f"{one.word.meaning}; {entry.meaning}"),
                    one[2],
                )
                for one in _numbers(member)
            ]
        elif isinstance(member, int | float | str):
            events.append(Event(field.name, entry, member if isinstance(member, str) else float(member)))
    return events
