"""A form as a tree: made from the table of a study, its kinds and the glossary; independent of the browser."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

from winkler.plot.series import name_in_words
from winkler.study.language.catalogue import kind_of, kinds
from winkler.study.language.explain import completed, example_study, keys_of, summary
from winkler.study.language.schema import allowed_in_list, allowed_kinds, hints
from winkler.values.vocabulary import Word
from winkler.web.form.typed import field_text

FILE = "file"
"""The key of a file that replaces numbers."""
SECTION_SENTENCE = re.compile(
    r"((?:fit|sweep)(?:\.\w+)?)"  # fit.curve, sweep.design
    r'(?:\."([^"]*)")?'  # sweep."problem.load.force"
    r"(?:\.(\w+))?(?:\[(\d+)\])?(?: has no '(\w+)')?"
)
"""Beginning of a sentence about a section of a study."""


class FormEntry(NamedTuple):
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
        Its meaning, and the allowed values.
    takes
        In the words of `winkler.study.language.explain`.
    text
        Its content; empty if it was left out.
    required
        Whether it is required.
    """

    path: str
    label: str
    symbol: str
    unit: str
    hint: str
    takes: str
    text: str
    required: bool

    @property
    def word(self) -> Word:
        """Symbol, unit and meaning."""
        return Word(self.symbol, self.unit, self.hint)


class Slot(NamedTuple):
    """A key that takes one of several kinds; without `part` it is left out, and the kind is `otherwise`, if any."""

    path: str
    label: str
    hint: str
    allowed: tuple[str, ...]
    required: bool
    part: FormPart | None
    otherwise: str = ""


class Many(NamedTuple):
    """A list of kinds."""

    path: str
    label: str
    allowed: tuple[str, ...]
    parts: tuple[FormPart, ...]


class FormPart(NamedTuple):
    """One kind with its keys.

    Parameters
    ----------
    path
        Its path.
    kind
        Its name.
    meaning
        One sentence.
    takes_file
        Whether a file may replace its numbers.
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
    children: tuple[FormEntry | Slot | Many, ...]


def initial_table(problem: str) -> dict[str, Any]:
    """Return the initial table of a study of a problem."""
    return {**example_study(problem), "title": problem.replace("_", " ")}


def part_of(table: dict[str, Any], path: str = "problem") -> FormPart:
    """Return the form of the content at `path` of a study; its checks report unknown kinds and keys."""
    inside = at(table, path)
    name = str(inside.get("kind")) if isinstance(inside, dict) else ""
    if name not in kinds():
        return FormPart(path, name, "", False, "", ())
    line = kinds()[name]
    file = str(inside.get(FILE, ""))
    keys = {key.name: key for key in keys_of(name)}
    declared = hints(line.cls)
    defaults = {field.name: field.default for field in dataclasses.fields(line.cls)}
    children: list[FormEntry | Slot | Many] = []
    for key in keys.values():
        if key.name == FILE or (file and key.name in declared and key.required):
            continue
        if not file and line.reader is not None and key.name not in declared:
            continue  # options of reading, without a file
        where, content = f"{path}.{key.name}", inside.get(key.name)
        hint = declared.get(key.name)
        name_ = name_in_words(key.name) if hint is None or len(key.name) > 1 else key.name
        if key.name == "radius" and key.word.symbol != "a":
            name_ = "radius"  # of a body, not of the contact
        if hint is not None and allowed_kinds(hint):
            part = part_of(table, where) if isinstance(content, dict) else None
            default = defaults.get(key.name)
            otherwise = (
                kind_of(type(default)) if dataclasses.is_dataclass(default) and not dataclasses.fields(default) else ""
            )
            children.append(Slot(where, name_, key.word.meaning, allowed_kinds(hint), key.required, part, otherwise))
        elif hint is not None and allowed_in_list(hint):
            count = len(content) if isinstance(content, list) else 0
            parts = tuple(part_of(table, f"{where}.{place}") for place in range(count))
            children.append(Many(where, name_, allowed_in_list(hint), parts))
        else:
            hint_ = ". ".join(part for part in (key.word.meaning, key.range) if part)
            mark, unit = key.word.symbol, key.word.unit or ""
            children.append(FormEntry(where, name_, mark, unit, hint_, key.takes, field_text(content), key.required))
    return FormPart(path, name, summary(line.cls), line.reader is not None, file, tuple(children))


def at(table: Any, path: str) -> Any:
    """Return the content at a path of a study such as ``problem.path.steps.0``; None if there is none."""
    for part in path.split("."):
        try:
            table = table[int(part) if isinstance(table, list) else part]
        except (KeyError, IndexError, ValueError, TypeError):
            return None
    return table


def _holder(table: Any, path: str) -> tuple[Any, Any]:
    parent_path, _, last = path.rpartition(".")
    holder = at(table, parent_path) if parent_path else table
    return holder, int(last) if isinstance(holder, list) else last


def entry_at(
    table: dict[str, Any], path: str, label: str, hint: str, takes: str, *, unit: str = "", required: bool = False
) -> FormEntry:
    """Return an entry without a symbol, with the content at its path."""
    return FormEntry(path, label, "", unit, hint, takes, field_text(at(table, path)), required)


def put(table: dict[str, Any], path: str, content: Any) -> None:
    """Set the content at a path."""
    holder, key = _holder(table, path)
    holder[key] = content


def drop(table: dict[str, Any], path: str) -> None:
    """Remove the content at a path, if there is any."""
    holder, key = _holder(table, path)
    if isinstance(holder, list) or (isinstance(holder, dict) and key in holder):
        del holder[key]


def choose_kind(table: dict[str, Any], path: str, kind: str, known: Mapping[str, Any] = MappingProxyType({})) -> None:
    """Set a kind at a path, with the numbers of an example; keys shared with the previous kind keep their content.

    Parameters
    ----------
    table, path
        The study, and where in it.
    kind
        The kind; its example's numbers are taken.
    known
        Numbers that come before those of the example.
    """
    before = at(table, path)
    new = dict(known) if known.get("kind") == kind else completed({"kind": kind}) | dict(known)
    if isinstance(before, dict) and before.get("kind") in kinds():
        old = {key.name: key for key in keys_of(str(before["kind"]))}
        for key in keys_of(kind):
            if key.name in new and key.name in before and old[key.name].takes == key.takes:
                new[key.name] = before[key.name]
    put(table, path, new)


def owner_of(sentence: str) -> str:
    """Return the path of the key that a sentence about a study names; empty if it names none.

    Examples
    --------
    >>> owner_of("problem.load.force is '10 kg'; give a force."), owner_of("problem.load has no 'force' (why); add it.")
    ('problem.load.force', 'problem.load.force')
    >>> owner_of("problem.path.steps[1].normal: the depth is not there.")
    'problem.path.steps.1.normal'
    >>> owner_of('fit.free."problem.bed.medium.first.young"[0]: ...'), owner_of("fit.curve: gel.csv: ...")
    ('fit.free.problem.bed.medium.first.young.0', 'fit.curve')
    """
    match = SECTION_SENTENCE.match(sentence)
    if match is not None:
        return ".".join(part for part in match.groups() if part)
    match = re.match(r"(problem(?:\.\w+|\[\d+\])*)(?: has no '(\w+)')?", sentence)
    if match is None:
        return ""
    path = re.sub(r"\[(\d+)\]", r".\1", match[1])
    return f"{path}.{match[2]}" if match[2] else path
