"""Parameters of a fit: a number inside a value, named by its path.

``"bed.medium.first.young"`` is the field `young` of `first` of `medium` of `bed`, and
``"bed.medium.layers[0].solid.young"`` goes through a tuple.  A value is never changed: `changed` returns a new one.
"""

from __future__ import annotations

import dataclasses
import functools
import math
import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from winkler.laws.adhesion import ShortRange
from winkler.values.errors import InvalidInput, suggest
from winkler.values.limits import KEY_LETTERS
from winkler.values.vocabulary import word

STEP = re.compile(r"([A-Za-z_]\w*)|\[(\d+)\]")


@functools.lru_cache(maxsize=256)
def _steps(path: str) -> tuple[str | int, ...]:
    steps: list[str | int] = []
    if len(path) > KEY_LETTERS:
        raise InvalidInput(f"free: '{path[:40]}...' has {len(path)} letters; give at most {KEY_LETTERS}.")
    place = 0
    while place < len(path):
        match = STEP.match(path, place)
        if not match:
            raise InvalidInput(
                f"free: '{path}' is no path; write names with dots between them and numbers in brackets, as "
                "bed.medium.layers[0].solid.young."
            )
        steps.append(match[1] if match[1] else int(match[2]))
        place = match.end()
        if place < len(path) and path[place] == ".":
            place += 1
    return tuple(steps)


def _next(owner: Any, step: str | int, path: str) -> Any:
    if isinstance(step, int):
        row = isinstance(owner, tuple | np.ndarray)
        if not row or step >= len(owner):
            length = len(owner) if row else 0
            raise InvalidInput(f"free: '{path}' names item {step} of {length}; counting begins at 0.")
        return owner[step]
    fields = [field.name for field in dataclasses.fields(owner)] if dataclasses.is_dataclass(owner) else []
    if step not in fields:
        raise InvalidInput(
            f"free: '{path}' leads nowhere: {type(owner).__name__} has no {step}{suggest(step, fields)}; it has "
            f"{', '.join(fields) or 'nothing'}."
        )
    return getattr(owner, step)


def _at(model: Any, path: str) -> Any:
    return functools.reduce(lambda owner, step: _next(owner, step, path), _steps(path), model)


def number_at(model: Any, path: str) -> float:
    """Return the number at a path.

    Raises
    ------
    InvalidInput
        If the path does not exist, or holds no finite number.
    """
    owner = _at(model, path)
    if isinstance(owner, bool) or not isinstance(owner, int | float) or not math.isfinite(owner):
        raise InvalidInput(f"free: '{path}' leads to {type(owner).__name__} {owner!r}, which is no finite number.")
    return float(owner)


def each(model: Any, path: str) -> tuple[str, ...]:
    """Return the paths of all numbers of an array, or the path itself for a single number.

    Raises
    ------
    InvalidInput
        If the path leads nowhere.
    """
    owner = _at(model, path)
    if isinstance(owner, np.ndarray):
        return tuple(f"{path}[{index}]" for index in range(owner.size))
    return (path,)


def unit_of(model: Any, path: str) -> str:
    """Return the SI unit of the number at a path, empty for a pure number."""
    owner, unit = model, ""
    for step in _steps(path):
        if isinstance(step, str) and dataclasses.is_dataclass(owner):
            unit = word(type(owner), step).unit or ""
        owner = _next(owner, step, path)
    return unit


def changed(model: Any, numbers: Mapping[str, float]) -> Any:
    """Return `model` with other numbers at some paths.

    Parameters
    ----------
    model : value
    numbers : mapping of str to float
        Path and number; several paths into one owner are changed at once.
    """
    return _changed(model, [(_steps(path), number) for path, number in numbers.items()])


def _changed(owner: Any, changes: list[tuple[tuple[str | int, ...], float]]) -> Any:
    own: dict[str | int, Any] = {}
    deeper: dict[str | int, list[tuple[tuple[str | int, ...], float]]] = {}
    for steps, number in changes:
        if len(steps) == 1:
            own[steps[0]] = number
        else:
            deeper.setdefault(steps[0], []).append((steps[1:], number))
    for step, rest in deeper.items():
        inner = owner[step] if isinstance(step, int) else getattr(owner, step)
        own[step] = _changed(inner, rest)
    if isinstance(owner, np.ndarray):
        row = owner.copy()
        row[[int(index) for index in own]] = list(own.values())
        return row
    if isinstance(owner, tuple):
        return tuple(own.get(index, item) for index, item in enumerate(owner))
    if isinstance(owner, ShortRange):
        return _attraction(owner, own)
    return dataclasses.replace(owner, **{str(step): content for step, content in own.items()})


def _attraction(law: ShortRange, own: Mapping[str | int, float]) -> ShortRange:
    """Return another attraction: `work` alone has no hysteresis, the pair has."""
    if "work" in own:
        return ShortRange(own["work"])
    return ShortRange(
        work_closing=own.get("work_closing", law.work_closing), work_opening=own.get("work_opening", law.work_opening)
    )
