"""A commented study, to begin with: every key with its symbol, unit and meaning beside it."""

from __future__ import annotations

import json
import re
from typing import Any, get_args, get_type_hints

from winkler.study.language.catalogue import kinds, slot_of
from winkler.study.language.explain import Key, example_study, keys_of, place_of, plain_symbol, summary, table_at
from winkler.study.language.quantities import sample
from winkler.study.language.schema import hints
from winkler.values.checks.number_checks import Whole

COMMENT_COLUMN = 44
SCHEMA_FILE = "winkler.schema.json"
"""File beside a study in which an editor looks for its schema."""

SWEEP_LINES = {
    "force": '"problem.load.force" = { from = "1 N", to = "100 N", count = 9, spacing = "log" }',
    "depth": '"problem.load.depth" = { from = "1 um", to = "5 um", count = 9 }',
    "law": '"problem.law.work" = ["20 mJ/m^2", "50 mJ/m^2", "100 mJ/m^2"]',
    "coulomb": '"problem.law.coefficient" = [0.1, 0.3, 0.6]',
    "radius": '"problem.load.radius" = { from = "0.02 mm", to = "0.1 mm", count = 9 }',
}

FIELDS_SECTION = """
# [fields]                                  # fields to restore, in lengths or in contact radii a
# r = {{ from = "0 a", to = "3 a", count = 61 }}
# z = {{ from = "0.05 a", to = "3 a", count = 41 }}  # below the surface; leave it out for surface fields only
"""

OUTPUT_SECTION = """
# [output]
# folder = "results/{name}"
# figures = ["svg"]
# report = true
# workbook = false
"""


def inline(content: Any) -> str:
    """Return a value as TOML on one line."""
    if isinstance(content, bool):
        return str(content).lower()
    if isinstance(content, str):
        return json.dumps(content, ensure_ascii=False)
    if isinstance(content, dict):
        return "{ " + ", ".join(f"{_bare(key)} = {inline(item)}" for key, item in content.items()) + " }"
    if isinstance(content, list | tuple):
        return "[" + ", ".join(inline(item) for item in content) + "]"
    return repr(content)


def _bare(key: str) -> str:
    """Return a key as TOML, in quotes where it has other characters than letters, digits, "_" and "-"."""
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else json.dumps(key, ensure_ascii=False)


def _comment(key: Key) -> str:
    unit = key.word.unit
    label = " ".join(
        part for part in (plain_symbol(key.word.symbol), f"[{unit or '-'}]" if unit is not None else "") if part
    )
    return f"{label}: {key.word.meaning}" if label else key.word.meaning


def _line(text: str, comment: str) -> str:
    return f"{text:<{COMMENT_COLUMN - 2}}  # {comment}" if comment else text


def _such(cls: type, key: Key) -> str:
    """Return what an optional key may be, as TOML; nothing if it takes text or a kind."""
    if key.takes == "true or false":
        return inline(True)
    if key.word.unit is None:
        return ""
    if key.takes == "whole number":
        return _whole(cls, key.name)
    such = sample(key.word.unit, key.name)
    return inline(such) if key.word.unit else str(such)


def _heading(place: str) -> str:
    """Return the heading of the table at a key; parts of lists have two brackets, and no number."""
    path = ".".join(part for part in place.split(".") if not part.isdecimal())
    return f"[[{path}]]" if place.rpartition(".")[2].isdecimal() else f"[{path}]"


def _section(place: str, table: dict[str, Any]) -> list[str]:
    """Return the lines of one kind and of those inside it."""
    name = str(table["kind"])
    lines = ["", _line(_heading(place), summary(kinds()[name].cls)), f"kind = {inline(name)}"]
    below: list[str] = []
    for key in keys_of(name):
        content = table.get(key.name)
        if isinstance(content, dict) and "kind" in content:
            below += _section(f"{place}.{key.name}", content)
        elif isinstance(content, list) and all(isinstance(item, dict) and "kind" in item for item in content):
            for number, item in enumerate(content):
                below += _section(f"{place}.{key.name}.{number}", item)
        elif content is not None:
            lines.append(_line(f"{key.name} = {inline(content)}", _comment(key)))
        elif not key.required and key.name in hints(kinds()[name].cls):
            such = _such(kinds()[name].cls, key)
            lines += [_line(f"# {key.name} = {such}", f"{_comment(key)} (optional)")] if such else []
    return lines + below


def _whole(cls: type, name: str) -> str:
    """Return a whole number that a field allows."""
    _, *checks = get_args(get_type_hints(cls, include_extras=True)[name]) or (int,)
    return str(max([10, *(check.least for check in checks if isinstance(check, Whole))]))


def template(name: str, *, file: str = "study", **chosen: str) -> str:
    """Return a commented study for a problem.

    Parameters
    ----------
    name
        Kind of the problem.
    file
        Name of the study file without its ending.
    chosen
        Kinds to use in it, by slot: ``profile="cone"``; an empty text leaves the choice.
    """
    table = example_study(name, **chosen)
    used = table["problem"]
    law = used["law"]["kind"] if "law" in used else ""
    varied = used["load"]["kind"] if "load" in used else "coulomb" if law == "coulomb" else "law" if law else ""
    head = [
        f"#:schema {SCHEMA_FILE}",
        "# Complete and check it in an editor: winkler schema",
        f"# Run it:            winkler run {file}.toml",
        f"# What a kind takes: winkler show {name}",
        "# What there is:     winkler show",
        "",
        f"title = {inline(table['title'])}",
    ]
    tail = []
    if varied in SWEEP_LINES:
        tail = ["", "# [sweep]", f"# {SWEEP_LINES[varied]}"]
        tail += [FIELDS_SECTION.rstrip("\n").format()] if "load" in used else []  # only one load has fields to restore
        tail += [OUTPUT_SECTION.format(name=file).rstrip("\n")]
    return "\n".join([*head, *_section("problem", used), *tail]) + "\n"


def whole_text(name: str) -> str:
    """Return a whole study, as text, that uses a kind."""
    table = example_study(name)
    return "\n".join([f"title = {inline(table['title'])}", *_section("problem", table["problem"])]) + "\n"


def example_text(name: str) -> str:
    """Return the part of a study file that describes an example of a kind."""
    place, study = place_of(name), example_study(name)
    parent, _, last = place.rpartition(".")
    places = [f"{parent}.{number}" for number in range(int(last) + 1)] if last.isdecimal() else [place]
    lines = [line for one in places for line in _section(one, table_at(study, one))]  # a step follows others
    title = [f'title = "{name.replace("_", " ")}"'] if slot_of(name) == "problem" else []
    return "\n".join([*title, *lines]).strip() + "\n"
