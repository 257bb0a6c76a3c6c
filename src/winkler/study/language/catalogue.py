"""The catalogue: every kind that a study file may name, and the class behind it.

One line in a chapter makes a class available to study files, ``winkler show``, ``winkler new``, ``winkler cite`` and
the tests: its keys, units and meanings are read from the class and the glossary.  The line also carries an example
(values as a study file writes them; for a part that is left out, the first kind of its slot is taken) and the BibTeX
keys of the papers on which the class is based.
"""

from __future__ import annotations

import functools
import re
from typing import Any

from winkler.study.chapters.bodies import BODIES
from winkler.study.chapters.contents import CHAPTERS
from winkler.study.chapters.kind import Kind, kind
from winkler.study.chapters.relaxing_bodies import RELAXING_BODIES
from winkler.values.checks.contract import path_of


def _merged(*tables: dict[str, dict[str, Kind]]) -> dict[str, dict[str, Kind]]:
    """Put the kinds of every slot together, in the order of the tables."""
    slots: dict[str, dict[str, Kind]] = {}
    for table in tables:
        for slot, lines in table.items():
            slots.setdefault(slot, {}).update(lines)
    return slots


CATALOGUE: dict[str, dict[str, Kind]] = _merged(
    BODIES,
    *(chapter.kinds | {"problem": chapter.problems} for chapter in CHAPTERS),
    RELAXING_BODIES,
)
"""Slot -> kind -> class; kinds are unique over all slots."""

SLOTS: dict[str, str] = {
    "winkler.profiles.profile:Profile": "profile",
    "winkler.media.medium:Medium": "medium",
    "winkler.foundation.bed:Bed": "bed",
    "winkler.materials.depth_grading:DepthGrading": "grading",
    "winkler.profiles.rough.spectrum:Spectrum": "spectrum",
}
"""Protocol -> slot: the kinds that are allowed where a class requires this protocol."""

UNWRITTEN = frozenset(
    {
        "winkler.loading.path_steps:Unchanged",
        "winkler.media.offers:PlaneMedium",
        "winkler.problems.friction.spring_states:OwnLaw",
        "winkler.laws.wear:OwnWear",
    }
)
"""Classes that a study file cannot name: a load that stays as it is, layers of your own, laws that are functions."""

FORMER = {
    "coated_tangential": "tangential",
    "viscoelastic_tangential": "tangential",
    "elliptic_friction_heating": "friction_heating",
    "surface_rolling_heating": "surface_friction_heating",
}
"""Kinds of version 0.2 -> those that answer with the same numbers; studies that name the former still run."""
FORMER_DEFAULTS: dict[str, dict[str, Any]] = {"viscoelastic_tangential": {"count": 500}}
"""Keys that have another default today."""
FORMER_PARTS: dict[str, tuple[str, str, tuple[str, ...]]] = {
    "friction_heating": ("contact", "indentation", ("bed", "load", "bodies", "medium")),
    "elliptic_friction_heating": ("contact", "elliptic_indentation", ("bodies", "medium", "load")),
    "transient_heating": ("contact", "indentation", ("bed", "load")),
    "line_friction_heating": ("contact", "line_indentation", ("bed", "load")),
    "constriction": ("contact", "indentation", ("bed", "load")),
    "thermal_constriction": ("contact", "indentation", ("bed", "load")),
    "joule_heating": ("contact", "indentation", ("bed", "load")),
    "line_constriction": ("contact", "line_indentation", ("bed", "load")),
    "fretting_heat": ("contact", "", ("motion",)),
    "surface_rolling_heating": ("contact", "", ("rolling",)),
    "surface_friction_heating": ("contact", "", ("load", "rolling")),
}
"""Kinds of version 0.2 some of whose keys stand in a table of their own today: its key, its kind, and what it holds;
without a kind the key is called otherwise today."""

REFUSED: dict[str, Kind] = {"cylinder": kind("winkler.profiles.flat:Cylinder")}
"""Kinds that cannot be solved; creating one raises the reason."""


@functools.cache
def kinds() -> dict[str, Kind]:
    """Return every kind of every slot by its name."""
    return {name: line for slot in CATALOGUE.values() for name, line in slot.items()}


def kind_of(cls: type) -> str:
    """Return the name of `cls` in study files; an empty string if it is not in the catalogue."""
    return _names().get(path_of(cls), "")


@functools.cache
def _names() -> dict[str, str]:
    return {line.path: name for name, line in kinds().items()}


def in_present_kinds(content: Any) -> Any:
    """Return the tables and lists of a study with the kinds and keys of today in place of those of version 0.2."""
    problem = content.get("problem") if isinstance(content, dict) else None
    if isinstance(problem, dict) and isinstance(name := problem.get("kind"), str) and name in FORMER_PARTS:
        place, there, keys = FORMER_PARTS[name]
        moved, now = re.compile(rf"problem\.({'|'.join(keys)})(?=\.|$)"), f"problem.{place}" + r".\1" * bool(there)
        content = {key: item if key == "problem" else _renamed(item, moved, now) for key, item in content.items()}
    return _present(content)


def _renamed(content: Any, moved: re.Pattern[str], now: str) -> Any:
    """Return tables and lists in which keys that were moved have their name of today."""
    if isinstance(content, str):
        return moved.sub(now, content, count=1) if moved.match(content) else content
    if isinstance(content, list):
        return [_renamed(item, moved, now) for item in content]
    if isinstance(content, dict):
        return {_renamed(key, moved, now): _renamed(item, moved, now) for key, item in content.items()}
    return content


def _present(content: Any) -> Any:
    if isinstance(content, list):
        return [_present(item) for item in content]
    if not isinstance(content, dict):
        return content
    table = {key: _present(item) for key, item in content.items()}
    if not isinstance(name := table.get("kind"), str):
        return table
    if name in FORMER_PARTS:
        place, kind_there, keys = FORMER_PARTS[name]
        if before := {key: table.pop(key) for key in keys if key in table}:
            there, part = table.get(place), before if kind_there else next(iter(before.values()))
            new = there if isinstance(there, dict) else {"kind": kind_there} if kind_there else {}
            table[place] = _over(new, part) if isinstance(part, dict) else part
    return {**FORMER_DEFAULTS.get(name, {}), **table, "kind": FORMER[name]} if name in FORMER else table


def _over(table: dict[str, Any], more: dict[str, Any]) -> dict[str, Any]:
    """Return a table in which more contents stand, tables within tables."""
    both = {key: (table.get(key), item) for key, item in more.items()}
    return table | {
        key: _over(old, new) if isinstance(old, dict) and isinstance(new, dict) else new
        for key, (old, new) in both.items()
    }


def in_kinds(sentence: str) -> str:
    """Return a sentence with the names of study files in place of those of their classes."""
    names = {path.rpartition(":")[2]: name for path, name in _names().items()}
    return re.sub(r"\b[A-Z][A-Za-z]+\b", lambda found: names.get(found[0], found[0]), sentence)


def slot_of(name: str) -> str:
    """Return the slot that the kind `name` belongs to."""
    return next(slot for slot, lines in CATALOGUE.items() if name in lines)
