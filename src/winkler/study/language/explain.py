"""The keys of a kind with symbol, unit, meaning and range, from the class and the glossary."""

from __future__ import annotations

import dataclasses
import functools
import inspect
import re
import typing
from typing import Any, NamedTuple

from winkler.study.language import maps, quantities
from winkler.study.language.catalogue import kinds, slot_of
from winkler.study.language.schema import allowed_in_list, allowed_kinds, hints, is_choice, options, required_fields
from winkler.values.errors import InvalidInput
from winkler.values.readable import GREEK
from winkler.values.vocabulary import Word, word


class Key(NamedTuple):
    """One key of a kind.

    Parameters
    ----------
    name
        As written in a study file.
    word
        Symbol, unit and meaning after the glossary.
    takes
        Allowed values: a unit, kinds, text.
    range
        Range as the docstring of the class states it.
    required
        Whether it must be given.
    """

    name: str
    word: Word
    takes: str
    range: str
    required: bool


def plain_symbol(symbol: str) -> str:
    """Return a LaTeX symbol as plain text."""
    symbol = symbol.replace(r"\mathrm", "").replace(r"\,", " ")
    for name, mark in {"bar": "\u0304", "dot": "\u0307"}.items():
        symbol = re.sub(rf"\\{name} ?\{{?([A-Za-z])\}}?", rf"\g<1>{mark}", symbol)
    for name, letter in GREEK.items():
        symbol = symbol.replace(f"\\{name}", letter)
    return re.sub(r"[{}\\]", "", symbol.replace("^*", "*"))


def summary(cls: type) -> str:
    """Return the first sentence of a class."""
    return (inspect.getdoc(cls) or "").split("\n\n")[0].replace("\n", " ")


def _parameters(cls: Any) -> dict[str, str]:
    """Return name -> text of the numpydoc section Parameters of a class or function, without the type."""
    text = inspect.getdoc(cls) or ""
    match = re.search(r"^Parameters\n-+\n(.*?)(?=^\w[\w ]*\n-{3,}$|\Z)", text, flags=re.DOTALL | re.MULTILINE)
    rows: dict[str, str] = {}
    for names, body in re.findall(
        r"^([\w, ]+?)(?: : [^\n]*)?\n((?:[ \t]+[^\n]*\n?|\n)+)", match[1] if match else "", re.M
    ):
        for name in names.split(","):
            rows[name.strip()] = " ".join(body.split())
    return rows


def keys_of(name: str) -> tuple[Key, ...]:
    """Return the keys of a kind, in the order of its class."""
    line = kinds()[name]
    parameters = _parameters(line.cls)
    needed = required_fields(line.cls)
    rows = [
        Key(field, word(line.cls, field), _takes(line.cls, field, hint), parameters.get(field, ""), field in needed)
        for field, hint in hints(line.cls).items()
    ]
    if line.reader is not None:
        meaning = "a file with the same content, beside the study, in place of the other keys"
        rows.append(Key("file", Word("", None, meaning), "path", "", False))
        parameters = _parameters(line.reader)
        for option, hint in options(line).items():
            if option not in hints(line.cls):
                plain = hint in (bool, int, str)
                how = Word("", None, "how the file is read") if plain else word(line.cls, option)
                how = how._replace(meaning=f"{how.meaning}; with a file only")
                rows.append(Key(option, how, _takes(line.cls, option, hint), parameters.get(option, ""), False))
    return tuple(rows)


def _takes(cls: type, field: str, hint: Any) -> str:
    inner = typing.get_args(hint)
    if allowed_kinds(hint) or is_choice(hint):
        return f"one of {', '.join(allowed_kinds(hint) or hint)}"
    if allowed_in_list(hint):
        return f"list of {slot_of(allowed_in_list(hint)[0])}s"
    if (cls.__name__, field) in quantities.INDEXED:
        units = [quantities.INDEXED[cls.__name__, field](place) or "-" for place in range(3)]
        return f"list of quantities [{', '.join(units)} ...]"
    if (cls.__name__, field) in quantities.GRIDS:
        return "list of lists of numbers"
    if (cls.__name__, field) in maps.MAPS:
        return f"list of lists of quantity [{quantities.unit_of(cls, field)}]"
    if (cls.__name__, field) in maps.PAIRS:
        return f"two of quantity [{quantities.unit_of(cls, field)}]"
    if hint == tuple[int, int]:
        return "two whole numbers"
    if hint is str:
        return "text"
    if hint in (int, bool):
        return {int: "whole number", bool: "true or false"}[hint]
    if hint == tuple[tuple[str, float], ...]:
        return "table of named quantities"
    unit = quantities.unit_of(cls, field)
    one = f"quantity [{unit}]" if unit else "number"
    if hint is float:
        return f'{one} or "{quantities.INFINITE}"' if quantities.endless(cls, field) else one
    return f"{one}, list or range" if float in inner and Ellipsis not in inner else f"list of {one}"


def completed(table: dict[str, Any]) -> dict[str, Any]:
    """Return an example of a kind with every required key: those of `table` first, then those of the catalogue."""
    name = str(table["kind"])
    line = kinds()[name]
    given = {**line.example, **table}
    result: dict[str, Any] = {"kind": name}
    for field, hint in hints(line.cls).items():
        required = field in required_fields(line.cls)
        content = given.get(field)
        if content is not None:
            result[field] = _completed(content)
        elif required and allowed_kinds(hint):
            result[field] = completed({"kind": allowed_kinds(hint)[0]})
        elif required and allowed_in_list(hint):
            result[field] = [completed({"kind": allowed_in_list(hint)[0]})]
        elif required:
            result[field] = quantities.sample(quantities.unit_of(line.cls, field) or "")
    return result


def _completed(content: Any) -> Any:
    if isinstance(content, list):
        return [_completed(item) for item in content]
    return completed(content) if isinstance(content, dict) and "kind" in content else content


def place_of(name: str) -> str:
    """Return a key of a study at which a kind is allowed, such as ``problem.bed.profile`` for a sphere.

    An example study adds the surrounding values if the kind alone would have no solution.
    """
    if slot_of(name) == "problem":
        return "problem"
    holder, field = _holder(name)
    number = "" if allowed_kinds(hints(kinds()[holder].cls)[field]) else f".{_number(holder, field, name)}"
    return f"{place_of(holder)}.{field}{number}"


def _number(holder: str, field: str, name: str) -> int:
    """Return the place of a kind in the list of an example."""
    listed = kinds()[name].within or kinds()[holder].example.get(field, ())
    there = [item["kind"] for item in listed] if isinstance(listed, list) else []
    return there.index(name) if name in there else 0


def table_at(table: Any, place: str) -> Any:
    """Return the value in a table at a key such as ``problem.bed.medium.layers.0``."""
    for part in place.split("."):
        table = table[int(part) if part.isdecimal() else part]
    return table


def _holders(name: str) -> tuple[tuple[str, str], ...]:
    """Return the kinds of other slots that hold `name`, and the key."""
    return _all_holders().get(name, ())


@functools.cache
def _all_holders() -> dict[str, tuple[tuple[str, str], ...]]:
    """Return the same for each kind that is held; one pass through the catalogue finds all."""
    found: dict[str, tuple[tuple[str, str], ...]] = {}
    for holder, line in kinds().items():
        for field, hint in hints(line.cls).items():
            for name in allowed_kinds(hint) or allowed_in_list(hint):
                if slot_of(holder) != slot_of(name):
                    found[name] = (*found.get(name, ()), (holder, field))
    return found


@functools.cache
def _holder(name: str) -> tuple[str, str]:
    """Return one of the kinds of another slot that hold `name`, and the key.

    The problem that its line in the catalogue names comes first, then a key that has it by default; another problem
    than the named one comes last.
    """
    problem = kinds()[name].problem
    elsewhere = ("path", "step", "problem") if problem else ("path", "step")
    rows = [
        (holder, field, _by_default(holder, field, name) and slot_of(holder) not in elsewhere)
        for holder, field in _holders(name)
    ]
    named = [(holder, field) for holder, field, _ in rows if holder == problem]
    inner = [row[:2] for row in rows if not problem or slot_of(row[0]) != "problem"]
    return (named or [(holder, field) for holder, field, default in rows if default] or inner or [rows[0][:2]])[0]


def _by_default(holder: str, field: str, name: str) -> bool:
    fields = {item.name: item for item in dataclasses.fields(kinds()[holder].cls)}
    return type(fields[field].default) is kinds()[name].cls


def example_study(name: str, **chosen: str) -> dict[str, Any]:
    """Return the table of a whole study that uses a kind.

    Parameters
    ----------
    name
        Any kind of the catalogue.
    chosen
        Other kinds to use, by slot: ``profile="cone"``; an empty text leaves the choice.
    """
    picks = {slot: kind for slot, kind in chosen.items() if kind} | {slot_of(name): name}
    problem = picks.pop("problem", "") or _problem_with(name)
    table = completed({"kind": problem})
    for kind in sorted(picks.values(), key=lambda kind: place_of(kind).count(".")):
        holders = [_holder(kind)[0], *(holder for holder, _ in _holders(kind))]
        if not _placed(table, kind) and not any(_placed(table, one) and _placed(table, kind) for one in holders):
            raise InvalidInput(f"{problem} has no place for {kind}, a {slot_of(kind)}; see `winkler show {problem}`.")
    title = problem if name == problem else f"{problem} ({name})"
    return {"title": title.replace("_", " "), "problem": table}


def _problem_with(name: str) -> str:
    """Return the first problem that has a place for a kind."""
    while slot_of(name) != "problem":
        name = kinds()[name].problem or _holder(name)[0]
    return name


def _placed(table: dict[str, Any], kind: str) -> bool:
    """Put an example of `kind` where it is allowed inside `table`; return whether there is such a place."""
    holder = str(table["kind"])
    entry = hints(kinds()[holder].cls)
    places = [field for field, hint in entry.items() if kind in (allowed_kinds(hint) or allowed_in_list(hint))]
    places.sort(key=lambda field: not _by_default(holder, field, kind))
    if places:
        present, listed = table.get(places[0]), not allowed_kinds(entry[places[0]])
        there = [item["kind"] for item in (present if isinstance(present, list) else [present]) if item]
        if kind not in there:
            example = _completed(kinds()[kind].within or {"kind": kind})
            table[places[0]] = [example] if listed and not isinstance(example, list) else example
            table.update({key: _completed(content) for key, content in kinds()[kind].beside.items()})
        return True
    return any(_placed(inside, kind) for inside in table.values() if isinstance(inside, dict) and "kind" in inside)
