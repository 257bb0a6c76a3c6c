"""The lines of ``[sweep]`` and its design; values are checked as those of the key."""

from __future__ import annotations

import dataclasses
import typing
from pathlib import Path
from typing import Any

import numpy as np

from winkler.numerics.types import Array
from winkler.study.language import keys
from winkler.study.language.build import assembled, unbuild, written_field, written_number
from winkler.study.language.designs import DESIGNS, Design
from winkler.study.language.varied import Axis, Range, check_path
from winkler.values.errors import InvalidInput, suggest


def design(raw: Any) -> Design:
    """Return the design of a sweep, from a table with a kind.

    Raises
    ------
    InvalidInput
        If there is no such design, or it does not take a given key.
    """
    allowed = ", ".join(DESIGNS)
    if not isinstance(raw, dict) or "kind" not in raw:
        raise InvalidInput(
            f'sweep.design is {_given_text(raw)} without a kind; give a table such as {{ kind = "zipped" }}, of a '
            f"kind from {allowed}."
        )
    kind, settings = raw["kind"], {name: content for name, content in raw.items() if name != "kind"}
    if kind not in DESIGNS:
        raise InvalidInput(f"sweep.design.kind is {kind!r}{suggest(str(kind), DESIGNS)}; give one of {allowed}.")
    fields = {field.name: field.default for field in dataclasses.fields(DESIGNS[kind])}
    taken = ", ".join(("kind", *fields))
    for name in settings:
        if name not in fields:
            raise InvalidInput(f"sweep.design.{name} is not known{suggest(name, fields)}; {kind} takes {taken}.")
    for name, default in fields.items():
        if name not in settings and default is dataclasses.MISSING:
            raise InvalidInput(f"sweep.design has no '{name}'; {kind} takes {taken}.")
    return DESIGNS[kind](**settings)


def written_design(content: Design) -> dict[str, Any]:
    """Return the table of a design in a study file."""
    return {"kind": content.kind, **{field.name: getattr(content, field.name) for field in dataclasses.fields(content)}}


def line(key: str, raw: Any, problem: Any, of: Design, *, file: str, folder: Path) -> Axis | Range:
    """Return one line of ``[sweep]``.

    Parameters
    ----------
    key
        Path of the key, ``problem.load.force``.
    raw
        Its value: a list, a range ``{ from, to, count, spacing }``, or a range ``{ from, to, scale }`` to draw
        from.
    problem
        The problem whose key varies.
    of
        The design of the sweep.
    file, folder
        As for `winkler.study.language.build.build`.

    Raises
    ------
    InvalidInput
        If there is no such key, or it cannot take one of the values.
    """
    rest = key.partition(".")[2]
    if key == "together":
        raise InvalidInput("sweep: 'together' is not known; write design = { kind = \"zipped\" }.")
    check_path(key)
    try:
        target = _Target(problem, rest)
    except InvalidInput as error:
        raise InvalidInput(f"sweep: {str(error).replace(rest, key, 1)}") from None
    where = f'sweep."{key}"'
    if isinstance(raw, dict) and "kind" not in raw and target.is_number and of.draws:
        return Range(key, **_ends(raw, target, where, of.kind))
    if isinstance(raw, dict) and "kind" not in raw and target.is_number:
        return Axis(key, tuple(float(number) for number in target.numbers(raw, where)))
    if not isinstance(raw, list):
        such = "a range { from, to, count }" if target.is_number else "a list of one"
        raise InvalidInput(f"{where} is {_given_text(raw)}, not a list; give the values in turn, or {such}.")
    if not raw:
        raise InvalidInput(f"{where} is an empty list; give at least one value.")
    return Axis(key, tuple(target.content(item, f"{where}[{place}]", file, folder) for place, item in enumerate(raw)))


def written(line: Axis | Range, problem: Any) -> Any:
    """Return the values of a key, or its range, as a study file writes them."""
    target = _Target(problem, line.key.partition(".")[2])
    if isinstance(line, Range):
        ends = {"from": target.text(line.start), "to": target.text(line.stop)}
        return ends if line.scale == "linear" else {**ends, "scale": line.scale}
    return [target.text(content) for content in line.values]


RANGE_FIELDS = {"from": "start", "to": "stop", "scale": "scale"}
"""Key of a range to draw from -> argument of `Range`."""


def _ends(raw: dict[str, Any], target: _Target, where: str, kind: str) -> dict[str, Any]:
    """Return the ends and the scale of a range that a design draws from."""
    for name in raw:
        if name not in RANGE_FIELDS:
            advice = {"count": "; give the count of the points in sweep.design", "spacing": "; write scale"}.get(
                name, ""
            )
            raise InvalidInput(
                f"{where}.{name} is not known{advice or suggest(name, RANGE_FIELDS)}; a range that {kind} draws from "
                f"has {', '.join(RANGE_FIELDS)}."
            )
    for name in ("from", "to"):
        if name not in raw:
            raise InvalidInput(f"{where} has no '{name}'; a range that {kind} draws from needs from, to.")
    limits = {RANGE_FIELDS[name]: float(target.numbers([raw[name]], f"{where}.{name}")[0]) for name in ("from", "to")}
    return limits | ({"scale": raw["scale"]} if "scale" in raw else {})


def _given_text(raw: Any) -> str:
    return "a table" if isinstance(raw, dict) else repr(raw)


class _Target:
    """The place in a problem that a key names, and the values that are allowed there."""

    def __init__(self, problem: Any, key: str) -> None:
        from winkler.study.language import quantities, schema

        self.owner, self.field, self.below = keys.owner_at(problem, key)
        self.cls = self.owner.__class__
        self.hint = schema.hints(self.cls)[self.field]
        self.is_constant = bool(self.below) and self.hint == tuple[tuple[str, float], ...]
        if self.below and not self.is_constant:
            inner = typing.get_args(self.hint)
            self.hint = inner[0] if typing.get_origin(self.hint) is tuple else float
        scalar = self.hint is float or float in typing.get_args(self.hint)
        self.is_number = self.is_constant or (scalar and typing.get_origin(self.hint) is not tuple)
        self.takes_rows = any(typing.get_origin(each) is np.ndarray for each in typing.get_args(self.hint))
        if (self.cls.__name__, self.field) in quantities.INDEXED and self.below:
            self.unit = quantities.INDEXED[self.cls.__name__, self.field](int(self.below[0]))
        else:
            self.unit = quantities.unit_in(self.owner, self.field) or ""

    def numbers(self, raw: Any, where: str) -> Array:
        """Return SI numbers from a list or range."""
        from pydantic_core import PydanticCustomError

        from winkler.study.language import quantities

        try:
            if self.is_constant and isinstance(raw, list):
                return np.array([quantities.named({"value": item})[0][1] for item in raw])
            return quantities.numbers(raw, self.unit)
        except PydanticCustomError as refusal:
            sentence = quantities.sentence_of(refusal)
            for mark in (f"{quantities.WHERE}[0]", f"{quantities.WHERE}.value", quantities.WHERE):
                sentence = sentence.replace(mark, where)
            raise InvalidInput(sentence) from None

    def content(self, raw: Any, where: str, file: str, folder: Path) -> Any:
        """Return one value for the key."""
        from pydantic import BaseModel, ValidationError

        from winkler.study.language import mistakes, quantities, schema

        if self.is_number and self.takes_rows and isinstance(raw, list):
            return tuple(float(number) for number in self.numbers(raw, where))
        if self.is_number:
            if quantities.endless(self.cls, self.field) and raw == quantities.INFINITE:
                return float("inf")
            if isinstance(raw, dict):  # a range gives many values, one is needed
                raise InvalidInput(f'{where} is a table; give one quantity, such as "{quantities.sample(self.unit)}".')
            return float(self.numbers([raw], where)[0])
        try:
            content = schema.adapter(self.cls, self.field, self.hint).validate_python({"content": raw}).content
        except ValidationError as error:
            raise InvalidInput(*mistakes.sentences(error, {"content": raw}, where)) from None
        if isinstance(content, BaseModel):
            return assembled(content, folder=folder, file=file, key=where)
        if isinstance(content, list):
            keyed = enumerate(content)
            return tuple(assembled(item, folder=folder, file=file, key=f"{where}[{place}]") for place, item in keyed)
        if isinstance(content, np.ndarray) and typing.get_origin(self.hint) is tuple:
            return tuple(float(number) for number in content)
        return content

    def text(self, content: Any) -> Any:
        """Return one value as a study file writes it."""
        if not self.below:
            return written_field(self.owner, self.field, content)
        if dataclasses.is_dataclass(content):
            return unbuild(content)
        return float(content) if self.is_constant else written_number(float(content), self.unit)
