"""Points of a sweep as lines of JSON, from which their numbers are restored to the last digit."""

from __future__ import annotations

import dataclasses
import functools
import json
from collections.abc import Iterable
from typing import Any

from winkler.study.batch.events import EVENTS, Event
from winkler.study.batch.lossless import packed, unpacked
from winkler.study.batch.points import ComparedNumber, Failed, Recalled, Solved
from winkler.study.batch.tasks import PointTask
from winkler.study.batch.verdicts import compared
from winkler.study.language.study import Expectation
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.vocabulary import Word


def without_solution(point: Solved, expect: tuple[Expectation, ...], shape: tuple[int, ...]) -> Recalled:
    """Return a solved point without its solution, but with all that tables and archives need of it.

    Parameters
    ----------
    point
        The solved point.
    expect, shape
        Expectations of the study, and its number of points along each dimension.

    Raises
    ------
    InvalidInput
        If an expected quantity is no answer of this problem.
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


def json_line(point: Recalled | Failed) -> str:
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
            "events": {name: packed(rows) for name, rows in point.event_rows},
            "verdicts": [packed((one.expectation.expected, one.got, one.deviation)) for one in point.verdicts],
            "surface": [packed(fields) for fields in point.surface],
            "subsurface": [packed(fields) for fields in point.subsurface],
            "stopped": point.stopped,
            "code": point.code,
        }
        content |= {name: item for name, item in more.items() if item}
    return json.dumps(content, separators=(",", ":"), ensure_ascii=False)


def plain_notes(notes: Iterable[Note]) -> list[list[Any]]:
    """Return notes as rows of texts, the error last."""
    return [[note.assumption.value, note.standing.value, note.statement, note.source, note.error] for note in notes]


def notes_of(rows: Iterable[list[Any]]) -> tuple[Note, ...]:
    """Return notes from the rows of `plain_notes`."""
    return tuple(
        Note(Assumption(assumption), Standing(standing), statement, source, *error)
        for assumption, standing, statement, source, *error in rows  # versions up to 0.2 recorded no error
    )


@functools.cache
def _fields() -> dict[str, type]:
    """Return the classes of restored fields by their names."""
    from winkler.fields.restoration import SubsurfaceFields, SurfaceFields
    from winkler.foundation.sheared_fields import ShearedFields
    from winkler.problems.friction.torsion_fields import TwistedFields

    return {cls.__name__: cls for cls in (SurfaceFields, SubsurfaceFields, ShearedFields, TwistedFields)}


def _unpacked(content: Any) -> Any:
    return unpacked(content, _fields())


def recalled(content: dict[str, Any], task: PointTask, expect: tuple[Expectation, ...]) -> Recalled | Failed:
    """Return the point that a line describes.

    Parameters
    ----------
    content
        The line, parsed by ``json.loads``.
    task
        The point at its index.
    expect
        Expectations of the study.
    """
    index, settings = task.index, task.settings
    try:
        problem = task.problem
    except Exception:  # the reason why it failed
        problem = task.base
    if "reason" in content:
        return Failed(index, settings, problem, content["reason"], content["code"], content.get("traceback", ""))
    verdicts = [
        ComparedNumber(
            index, dataclasses.replace(item, expected=_unpacked(expected)), _unpacked(got), _unpacked(deviation)
        )
        for item, (expected, got, deviation) in zip(expect, content.get("verdicts", []), strict=True)
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
def _answer_type(problem_type: type, name: str) -> type:
    """Return the class of the solutions of a problem, by its name."""
    from winkler.study.language.compared.expected_units import solution_types

    for cls in solution_types(problem_type):
        if cls.__name__ == name:
            return cls
    raise InvalidInput(
        f"journal: {problem_type.__name__}.solve does not state that it returns {name}; annotate it `-> {name}`."
    )
