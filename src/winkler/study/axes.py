"""The lines of ``[sweep]``: their values are checked like the key that they replace."""

from __future__ import annotations

import dataclasses
import typing
from pathlib import Path
from typing import Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.numerics.types import Array
from winkler.study import keys
from winkler.study.build import assembled, unbuild, written_field, written_number
from winkler.study.study import Axis

__all__ = ["axis", "written"]


def axis(key: str, raw: Any, problem: Any, *, file: str, folder: Path) -> Axis:
    """Return one line of ``[sweep]``.

    Parameters
    ----------
    key
        Path of the key, ``problem.load.force``.
    raw
        What stands there: a list, or a range ``{ from, to, count, spacing }``.
    problem
        The problem whose key varies.
    file, folder
        As for `winkler.study.build.build`.

    Raises
    ------
    InvalidInput
        If there is no such key, or it cannot take one of the values.
    """
    first, _, rest = key.partition(".")
    if first != "problem" or not rest:
        raise InvalidInput(f"sweep: the key '{key}' does not start with 'problem.'; sweep a key of the problem.")
    try:
        target = _Target(problem, rest)
    except InvalidInput as error:
        raise InvalidInput(f"sweep: {str(error).replace(rest, key, 1)}") from None
    where = f'sweep."{key}"'
    if isinstance(raw, dict) and "kind" not in raw and target.is_number:
        return Axis(key, tuple(float(number) for number in target.numbers(raw, where)))
    if not isinstance(raw, list):
        such = "a range { from, to, count }" if target.is_number else "a list of one"
        raise InvalidInput(f"{where} is {_shown(raw)}, not a list; give the values in turn, or {such}.")
    if not raw:
        raise InvalidInput(f"{where} is an empty list; give at least one value.")
    return Axis(key, tuple(target.content(item, f"{where}[{place}]", file, folder) for place, item in enumerate(raw)))


def written(line: Axis, problem: Any) -> list[Any]:
    """Return what stands in a study file for the values of an axis."""
    target = _Target(problem, line.key.partition(".")[2])
    return [target.text(content) for content in line.values]


def _shown(raw: Any) -> str:
    return "a table" if isinstance(raw, dict) else repr(raw)


class _Target:
    """The place in a problem that a key names, and what may stand there."""

    def __init__(self, problem: Any, key: str) -> None:
        from winkler.study import quantities, schema

        self.owner, self.field, self.below = keys.owner_at(problem, key)
        self.cls = self.owner.__class__
        self.hint = schema.hints(self.cls)[self.field]
        self.is_constant = bool(self.below) and self.hint == tuple[tuple[str, float], ...]
        if self.below and not self.is_constant:
            inner = typing.get_args(self.hint)
            self.hint = inner[0] if typing.get_origin(self.hint) is tuple else float
        scalar = self.hint is float or float in typing.get_args(self.hint)
        self.is_number = self.is_constant or (scalar and typing.get_origin(self.hint) is not tuple)
        if (self.cls.__name__, self.field) in quantities.INDEXED and self.below:
            self.unit = quantities.INDEXED[self.cls.__name__, self.field](int(self.below[0]))
        else:
            self.unit = quantities.unit_of(self.cls, self.field) or ""
        if self.field in quantities.dependent(self.cls):
            fields = {item.name: getattr(self.owner, item.name) for item in dataclasses.fields(self.cls)}
            self.unit = quantities.settled(self.unit, self.cls, fields)

    def numbers(self, raw: Any, where: str) -> Array:
        """Return SI numbers from a list or range."""
        from pydantic_core import PydanticCustomError

        from winkler.study import quantities

        try:
            if self.is_constant and isinstance(raw, list):
                return np.array([quantities.named({"value": item})[0][1] for item in raw])
            return quantities.numbers(raw, self.unit)
        except PydanticCustomError as error:
            sentence = str((error.context or {})["sentence"])
            for mark in (f"{quantities.WHERE}[0]", f"{quantities.WHERE}.value", quantities.WHERE):
                sentence = sentence.replace(mark, where)
            raise InvalidInput(sentence) from None

    def content(self, raw: Any, where: str, file: str, folder: Path) -> Any:
        """Return one value for the key."""
        from pydantic import BaseModel, ValidationError

        from winkler.study import mistakes, quantities, schema

        if self.is_number:
            if quantities.endless(self.cls, self.field) and raw == quantities.INFINITE:
                return float("inf")
            if isinstance(raw, dict):  # a range stands for many values, here is place for one
                raise InvalidInput(f'{where} is a table; give one quantity, such as "{quantities.sample(self.unit)}".')
            return float(self.numbers([raw], where)[0])
        try:
            content = schema.adapter(self.cls, self.field, self.hint).validate_python({"content": raw}).content
        except ValidationError as error:
            raise InvalidInput("\n".join(mistakes.sentences(error, {"content": raw}, where))) from None
        if isinstance(content, BaseModel):
            return assembled(content, folder=folder, file=file, key=where)
        if isinstance(content, list):
            keyed = enumerate(content)
            return tuple(assembled(item, folder=folder, file=file, key=f"{where}[{place}]") for place, item in keyed)
        if isinstance(content, np.ndarray) and typing.get_origin(self.hint) is tuple:
            return tuple(float(number) for number in content)
        return content

    def text(self, content: Any) -> Any:
        """Return what a study file says for one value."""
        if not self.below:
            return written_field(self.owner, self.field, content)
        if dataclasses.is_dataclass(content):
            return unbuild(content)
        return float(content) if self.is_constant else written_number(float(content), self.unit)
