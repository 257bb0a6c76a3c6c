"""Points of a sweep as lines of text, from which their numbers come back to the last digit; solutions are not kept."""

from __future__ import annotations

import dataclasses
import functools
import json
import typing
from collections.abc import Iterable
from typing import Any

from winkler.errors import InvalidInput
from winkler.study.batch.events import EVENTS, Event
from winkler.study.batch.lossless import packed, unpacked
from winkler.study.batch.points import Failed, Recalled, Solved, Verdict
from winkler.study.batch.tasks import Task
from winkler.study.batch.verdicts import compared
from winkler.study.language.study import Expectation
from winkler.validity import Assumption, Note, Standing
from winkler.vocabulary import Word

__all__ = ["light", "notes_of", "plain_notes", "recalled", "written"]


def light(point: Solved, expect: tuple[Expectation, ...], shape: tuple[int, ...]) -> Recalled:
    """Return a solved point without its solution, but with everything that tables and archives take from it.

    Parameters
    ----------
    point
        What was solved.
    expect, shape
        What the study expects, and how many points it has along each dimension.

    Raises
    ------
    InvalidInput
        If what is expected is no answer of this problem.
    """
    return Recalled(
        point.index,
        point.settings,
        point.problem,
        point.found,
        point.answer_type,
        point.validity,
        tuple((name, rows) for name in EVENTS if (rows := point.events(name))),
        tuple(compared(point, expectation, shape) for expectation in expect),
        point.surface,
        point.subsurface,
        point.stopped,
        point.code,
    )


def written(point: Recalled | Failed) -> str:
    """Return a point as one line of JSON; index, settings and problem follow from the study."""
    if isinstance(point, Failed):
        content: dict[str, Any] = {"at": point.index, "reason": point.reason, "code": point.code}
        if point.traceback:
            content["traceback"] = point.traceback
    else:
        content = {
            "at": point.index,
            "answer": point.answer_type.__name__,
            "found": {name: packed(numbers) for name, numbers in point.found},
            "validity": plain_notes(point.validity),
        }
        more = {
            "events": {name: packed(rows) for name, rows in point.told},
            "verdicts": [packed((one.expectation.expected, one.got, one.deviation)) for one in point.verdicts],
            "surface": [packed(fields) for fields in point.surface],
            "subsurface": [packed(fields) for fields in point.subsurface],
            "stopped": point.stopped,
            "code": point.code,
        }
        content |= {name: item for name, item in more.items() if item}
    return json.dumps(content, separators=(",", ":"), ensure_ascii=False)


def plain_notes(notes: Iterable[Note]) -> list[list[str]]:
    """Return notes as rows of texts."""
    return [[note.assumption.value, note.standing.value, note.statement, note.source] for note in notes]


def notes_of(rows: Iterable[list[str]]) -> tuple[Note, ...]:
    """Return the notes that `plain_notes` was given."""
    return tuple(
        Note(Assumption(assumption), Standing(standing), statement, source)
        for assumption, standing, statement, source in rows
    )


@functools.cache
def _fields() -> dict[str, type]:
    """Return the classes of restored fields by their names."""
    from winkler.fields import SubsurfaceFields, SurfaceFields
    from winkler.foundation.sheared_fields import ShearedFields
    from winkler.problems.friction.torsion_fields import TwistedFields

    return {cls.__name__: cls for cls in (SurfaceFields, SubsurfaceFields, ShearedFields, TwistedFields)}


def _unpacked(content: Any) -> Any:
    return unpacked(content, _fields())


def recalled(content: dict[str, Any], task: Task, expect: tuple[Expectation, ...]) -> Recalled | Failed:
    """Return the point that a line tells of.

    Parameters
    ----------
    content
        The line, taken apart by ``json.loads``.
    task
        The point at its index.
    expect
        What the study expects.
    """
    index, settings = task.index, task.settings
    try:
        problem = task.problem
    except Exception:  # which is why it failed
        problem = task.base
    if "reason" in content:
        return Failed(index, settings, problem, content["reason"], content["code"], content.get("traceback", ""))
    verdicts = [
        Verdict(index, dataclasses.replace(asked, expected=_unpacked(expected)), _unpacked(got), _unpacked(deviation))
        for asked, (expected, got, deviation) in zip(expect, content.get("verdicts", []), strict=True)
    ]
    return Recalled(
        index,
        settings,
        problem,
        tuple((name, _unpacked(numbers)) for name, numbers in content["found"].items()),
        _answer_type(problem.__class__, content["answer"]),
        notes_of(content["validity"]),
        tuple((name, _rows(rows)) for name, rows in content.get("events", {}).items()),
        tuple(verdicts),
        tuple(_unpacked(fields) for fields in content.get("surface", [])),
        tuple(_unpacked(fields) for fields in content.get("subsurface", [])),
        content.get("stopped", ""),
        content.get("code", 0),
    )


def _rows(rows: list[Any]) -> tuple[tuple[Event, ...], ...]:
    return tuple(tuple(Event(name, Word(*word), _unpacked(content)) for name, word, content in row) for row in rows)


@functools.cache
def _answer_type(asked: type, name: str) -> type:
    """Return the class that a problem answers with, by its name."""
    hint = typing.get_type_hints(asked.solve).get("return")  # type: ignore[attr-defined]
    for cls in typing.get_args(hint) or (hint,):
        if isinstance(cls, type) and cls.__name__ == name:
            return cls
    raise InvalidInput(f"journal: {asked.__name__}.solve does not say that it returns {name}; annotate it `-> {name}`.")
