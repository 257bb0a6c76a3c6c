"""A form as a tree: made from the table of a study, its kinds and the glossary; nothing here knows a browser."""

from __future__ import annotations

import re
from typing import Any, NamedTuple

from winkler.plot.series import spoken
from winkler.study.language.catalogue import kinds
from winkler.study.language.explain import completed, example_study, keys_of, summary
from winkler.study.language.schema import allowed_in_list, allowed_kinds, hints
from winkler.web.form.typed import shown

__all__ = ["Entry", "Many", "Part", "Slot", "at", "begun", "chosen", "drop", "owner_of", "part_of", "put"]

FILE = "file"
"""The key that stands for a file in place of numbers."""
SECTIONED = re.compile(
    r"((?:fit|sweep)(?:\.\w+)?)"  # fit.curve, sweep.design
    r'(?:\."([^"]*)")?'  # sweep."problem.load.force"
    r"(?:\.(\w+))?(?:\[(\d+)\])?(?: has no '(\w+)')?"
)
"""How a sentence about a section of a study begins."""


class Entry(NamedTuple):
    """One key that takes a number, a list, a text or a yes or no.

    Parameters
    ----------
    path
        Of the key, from ``problem`` on.
    label
        Its name.
    symbol, unit
        Of the glossary; empty for none.
    hint
        What it means, and what is allowed.
    takes
        In the words of `winkler.study.language.explain`.
    text
        What stands there; empty if it was left out.
    required
        Whether it must be given.
    """

    path: str
    label: str
    symbol: str
    unit: str
    hint: str
    takes: str
    text: str
    required: bool


class Slot(NamedTuple):
    """A place that one of several kinds takes; without `part` it is left out."""

    path: str
    label: str
    hint: str
    allowed: tuple[str, ...]
    required: bool
    part: Part | None


class Many(NamedTuple):
    """A list of kinds."""

    path: str
    label: str
    allowed: tuple[str, ...]
    parts: tuple[Part, ...]


class Part(NamedTuple):
    """One kind with its keys.

    Parameters
    ----------
    path
        Where it stands.
    kind
        Its name.
    meaning
        One sentence.
    takes_file
        Whether a file may stand in place of its numbers.
    file
        The name of that file; empty for none.
    children
        Its keys.
    """

    path: str
    kind: str
    meaning: str
    takes_file: bool
    file: str
    children: tuple[Entry | Slot | Many, ...]


def begun(problem: str) -> dict[str, Any]:
    """Return the table of a study that asks a problem, to begin with."""
    return {**example_study(problem), "title": problem.replace("_", " ")}


def part_of(table: dict[str, Any], path: str = "problem") -> Part:
    """Return the form of what stands at `path` of a study; unknown kinds and keys are left to the study's checks."""
    inside = at(table, path)
    name = str(inside.get("kind")) if isinstance(inside, dict) else ""
    if name not in kinds():
        return Part(path, name, "", False, "", ())
    line = kinds()[name]
    file = str(inside.get(FILE, ""))
    keys = {key.name: key for key in keys_of(name)}
    known = hints(line.cls)
    children: list[Entry | Slot | Many] = []
    for key in keys.values():
        if key.name == FILE or (file and key.name in known and key.required):
            continue
        if not file and line.reader is not None and key.name not in known:
            continue  # how a file is read, where there is none
        where, content = f"{path}.{key.name}", inside.get(key.name)
        hint = known.get(key.name)
        name_ = spoken(key.name) if hint is None or len(key.name) > 1 else key.name
        if hint is not None and allowed_kinds(hint):
            part = part_of(table, where) if isinstance(content, dict) else None
            children.append(Slot(where, name_, key.word.meaning, allowed_kinds(hint), key.required, part))
        elif hint is not None and allowed_in_list(hint):
            count = len(content) if isinstance(content, list) else 0
            parts = tuple(part_of(table, f"{where}.{place}") for place in range(count))
            children.append(Many(where, name_, allowed_in_list(hint), parts))
        else:
            hint_ = ". ".join(part for part in (key.word.meaning, key.range) if part)
            mark, unit = key.word.symbol, key.word.unit or ""
            children.append(Entry(where, name_, mark, unit, hint_, key.takes, shown(content), key.required))
    return Part(path, name, summary(line.cls), line.reader is not None, file, tuple(children))


def at(table: Any, path: str) -> Any:
    """Return what stands at a path of a study such as ``problem.path.steps.0``; None if nothing does."""
    for part in path.split("."):
        try:
            table = table[int(part) if isinstance(table, list) else part]
        except (KeyError, IndexError, ValueError, TypeError):
            return None
    return table


def _holder(table: Any, path: str) -> tuple[Any, Any]:
    held, _, last = path.rpartition(".")
    holder = at(table, held) if held else table
    return holder, int(last) if isinstance(holder, list) else last


def put(table: dict[str, Any], path: str, content: Any) -> None:
    """Put something at a path."""
    holder, key = _holder(table, path)
    holder[key] = content


def drop(table: dict[str, Any], path: str) -> None:
    """Leave out what stands at a path, if anything does."""
    holder, key = _holder(table, path)
    if isinstance(holder, list) or (isinstance(holder, dict) and key in holder):
        del holder[key]


def chosen(table: dict[str, Any], path: str, kind: str) -> None:
    """Put a kind at a path, with the numbers of an example; what the old one called by the same name is kept."""
    if path == "problem":
        table |= begun(kind)
        return
    before = at(table, path)
    new = completed({"kind": kind})
    if isinstance(before, dict) and before.get("kind") in kinds():
        old = {key.name: key for key in keys_of(str(before["kind"]))}
        for key in keys_of(kind):
            if key.name in new and key.name in before and old[key.name].takes == key.takes:
                new[key.name] = before[key.name]
    put(table, path, new)


def owner_of(sentence: str) -> str:
    """Return the path of the key that a sentence about a study is about; empty if it names none.

    Examples
    --------
    >>> owner_of("problem.load.force is '10 kg'; give a force."), owner_of("problem.load has no 'force' (why); add it.")
    ('problem.load.force', 'problem.load.force')
    >>> owner_of("problem.path.steps[1].normal: the depth is not there.")
    'problem.path.steps.1.normal'
    >>> owner_of('fit.free."problem.bed.medium.first.young"[0]: ...'), owner_of("fit.curve: gel.csv: ...")
    ('fit.free.problem.bed.medium.first.young.0', 'fit.curve')
    """
    found = SECTIONED.match(sentence)
    if found is not None:
        return ".".join(part for part in found.groups() if part)
    found = re.match(r"(problem(?:\.\w+|\[\d+\])*)(?: has no '(\w+)')?", sentence)
    if found is None:
        return ""
    path = re.sub(r"\[(\d+)\]", r".\1", found[1])
    return f"{path}.{found[2]}" if found[2] else path
