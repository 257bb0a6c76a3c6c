"""Keys of a study: ``problem.load.force`` is the path of a value inside the study, to be read, described or replaced.

Parts of lists are named by their number from zero (``parts.1``), entries of a table of names by the name
(``constants.R``).
"""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from winkler.values.checks.contract import is_a
from winkler.values.errors import InvalidInput, suggest
from winkler.values.limits import KEY_LETTERS
from winkler.values.readable import scale_of
from winkler.values.vocabulary import Word, word


def _names(content: Any) -> list[str] | None:
    """Return the names of a table that is kept as a tuple of (name, content) pairs, else None."""
    if isinstance(content, tuple) and content:
        pairs = [isinstance(item, tuple) and len(item) == 2 and isinstance(item[0], str) for item in content]
        if all(pairs):
            return [item[0] for item in content]
    return None


def _step(content: Any, part: str, key: str) -> tuple[Any, Any]:
    """Return ``(place, content)`` one part further down: a field's name, or a position in a list."""
    names = _names(content)
    if names is not None:
        if part in names:
            return names.index(part), content[names.index(part)][1]
        raise InvalidInput(
            f"the key '{key}': there is no '{part}'{suggest(part, names)}; known are {', '.join(names)}."
        )
    if isinstance(content, tuple | np.ndarray):
        if part.isdecimal() and int(part) < len(content):
            return int(part), content[int(part)]
        places = f"give a number from 0 to {len(content) - 1}" if len(content) > 1 else "its only one is 0"
        raise InvalidInput(f"the key '{key}': '{part}' is no place in this list; {places}.")
    if dataclasses.is_dataclass(content):
        fields = [field.name for field in dataclasses.fields(content) if field.init]
        if part in fields:
            return part, getattr(content, part)
        advice = f"; known are {', '.join(fields)}" if fields else "; nothing is adjustable there"
        raise InvalidInput(f"the key '{key}': there is no '{part}'{suggest(part, fields)}{advice}.")
    raise InvalidInput(f"the key '{key}': nothing lies below the part before '{part}', which is {label(content)}.")


def _parts(key: str) -> list[str]:
    if len(key) > KEY_LETTERS:
        raise InvalidInput(f"the key '{key[:40]}...' has {len(key)} letters; give at most {KEY_LETTERS}.")
    return key.split(".")


def _walk(root: Any, key: str) -> list[tuple[Any, Any]]:
    """Return ``(owner, place)`` of every step from `root` down to `key`."""
    steps, content = [], root
    for part in _parts(key):
        place, below = _step(content, part, key)
        steps.append((content, place))
        content = below
    return steps


def content_at(root: Any, key: str) -> Any:
    """Return the value at `key` inside `root`."""
    content = root
    for part in _parts(key):
        _, content = _step(content, part, key)
    return content


def owner_at(root: Any, key: str) -> tuple[Any, str, tuple[Any, ...]]:
    """Return the value that holds `key`, the name of its field, and the places below that field."""
    steps = _walk(root, key)
    last = max(number for number, (owner, _) in enumerate(steps) if dataclasses.is_dataclass(owner))
    return steps[last][0], str(steps[last][1]), tuple(place for _, place in steps[last + 1 :])


def replaced(root: Any, key: str, content: Any) -> Any:
    """Return `root` with `content` at `key`; every value on the path is created anew, and so checked again."""
    for owner, place in reversed(_walk(root, key)):
        if dataclasses.is_dataclass(owner) and not isinstance(owner, type):
            content = _remade(owner, place, content)
        elif isinstance(owner, np.ndarray):
            changed = owner.copy()
            changed[place] = content
            content = changed
        else:
            names = _names(owner)
            item = content if names is None else (names[place], content)
            content = (*owner[:place], item, *owner[place + 1 :])
    return content


def _remade(owner: Any, field: str, content: Any) -> Any:
    """Return a value with one field changed; the works of adhesion change together; `work` is that of opening."""
    if not is_a(owner, "winkler.laws.adhesion:ShortRange"):
        return dataclasses.replace(owner, **{field: content})
    if field == "work" and owner.work_closing == owner.work_opening:
        return type(owner)(content)
    pair = {"work_closing": owner.work_closing, "work_opening": owner.work_opening}
    return type(owner)(**pair | {"work_opening" if field == "work" else field: content})


def word_at(root: Any, key: str) -> Word:
    """Return symbol, unit and meaning of the value at `key`."""
    owner, field, below = owner_at(root, key)
    entry = word(type(owner), field)
    if below and isinstance(below[0], int):
        names = _names(getattr(owner, field))
        return entry._replace(symbol=names[below[0]] if names else f"{entry.symbol}[{below[0]}]", unit=entry.unit or "")
    return entry


def label(content: Any, unit: str | None = None) -> str:
    """Return a short text for the value at a key of a unit: a number, a list, a name, or a value with its numbers."""
    if isinstance(content, float):
        return f"{content:.6g}"
    if isinstance(content, tuple) and all(isinstance(item, float) for item in content):
        scale = scale_of(unit, np.array(content))
        return f"{', '.join(f'{item / scale.factor:.6g}' for item in content)} {scale.unit}".rstrip()
    if dataclasses.is_dataclass(content):
        contents = ((field.name, getattr(content, field.name)) for field in dataclasses.fields(content))
        numbers = [f"{name}={number:.6g}" for name, number in contents if isinstance(number, float)]
        return f"{type(content).__name__}({', '.join(numbers)})"
    return str(content)
