"""Points of a sweep as lines of text, from which their numbers come back to the last digit; solutions are not kept."""

from __future__ import annotations

import base64
import dataclasses
import functools
import json
import typing
from typing import Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.fields import SubsurfaceFields, SurfaceFields
from winkler.foundation.sheared_fields import ShearedFields
from winkler.problems.torsion_fields import TwistedFields
from winkler.study.events import EVENTS, Event
from winkler.study.judging import judge
from winkler.study.points import Failed, Recalled, Solved, Verdict
from winkler.study.study import Expectation
from winkler.study.tasks import Task
from winkler.validity import Assumption, Note, Standing
from winkler.vocabulary import Word

__all__ = ["light", "recalled", "written"]

RESTORED = {cls.__name__: cls for cls in (SurfaceFields, SubsurfaceFields, ShearedFields, TwistedFields)}


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
        tuple(judge(point, expectation, shape) for expectation in expect),
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
            "found": {name: _plain(numbers) for name, numbers in point.found},
            "validity": [
                [note.assumption.value, note.standing.value, note.statement, note.source] for note in point.validity
            ],
        }
        more = {
            "events": dict(point.told),
            "verdicts": [[_plain(one.expectation.expected), _plain(one.got), one.deviation] for one in point.verdicts],
            "surface": [_plain(fields) for fields in point.surface],
            "subsurface": [_plain(fields) for fields in point.subsurface],
            "stopped": point.stopped,
            "code": point.code,
        }
        content |= {name: item for name, item in more.items() if item}
    return json.dumps(content, separators=(",", ":"), ensure_ascii=False)


def _plain(content: Any) -> Any:
    """Return numbers, arrays and fields as JSON can hold them, with all their digits."""
    if isinstance(content, np.ndarray):
        data = base64.b64encode(np.ascontiguousarray(content).tobytes()).decode("ascii")
        return {"shape": content.shape, "type": content.dtype.str, "data": data}
    if dataclasses.is_dataclass(content):
        fields = {field.name: _plain(getattr(content, field.name)) for field in dataclasses.fields(content)}
        return {"fields": type(content).__name__, **fields}
    return content


def _number(content: Any) -> Any:
    if isinstance(content, dict) and "data" in content:
        data = base64.b64decode(content["data"])
        return np.frombuffer(data, dtype=content["type"]).reshape(content["shape"])
    if isinstance(content, dict):
        parts = {name: _number(item) for name, item in content.items() if name != "fields"}
        return RESTORED[content["fields"]](**parts)
    return content


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
        Verdict(index, dataclasses.replace(asked, expected=_number(expected)), _number(got), deviation)
        for asked, (expected, got, deviation) in zip(expect, content.get("verdicts", []), strict=True)
    ]
    return Recalled(
        index,
        settings,
        problem,
        tuple((name, _number(numbers)) for name, numbers in content["found"].items()),
        _answer_type(problem.__class__, content["answer"]),
        tuple(
            Note(Assumption(assumption), Standing(standing), statement, source)
            for assumption, standing, statement, source in content["validity"]
        ),
        tuple((name, _rows(rows)) for name, rows in content.get("events", {}).items()),
        tuple(verdicts),
        tuple(_number(fields) for fields in content.get("surface", [])),
        tuple(_number(fields) for fields in content.get("subsurface", [])),
        content.get("stopped", ""),
        content.get("code", 0),
    )


def _rows(rows: list[Any]) -> tuple[tuple[Event, ...], ...]:
    return tuple(tuple(Event(name, Word(*word), content) for name, word, content in row) for row in rows)


@functools.cache
def _answer_type(asked: type, name: str) -> type:
    """Return the class that a problem answers with, by its name."""
    hint = typing.get_type_hints(asked.solve).get("return")  # type: ignore[attr-defined]
    for cls in typing.get_args(hint) or (hint,):
        if isinstance(cls, type) and cls.__name__ == name:
            return cls
    raise InvalidInput(f"journal: {asked.__name__}.solve does not say that it returns {name}; annotate it `-> {name}`.")
