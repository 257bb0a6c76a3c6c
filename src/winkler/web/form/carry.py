"""Another question for the same bodies: what fits into the study of another kind of problem stays.

A part (a profile, a medium, a load) goes to the place of the same name that may hold its kind; of a part that does not
fit, the parts and numbers inside it that do.  Each stays only if the study is still sound with it.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

import tomli_w

from winkler.plot.series import name_in_words
from winkler.study.language.catalogue import kinds
from winkler.study.language.explain import keys_of
from winkler.values.errors import WinklerError
from winkler.web.form import form
from winkler.web.form.form import FormEntry, FormPart, Many, Slot

__all__ = ["CarriedStudy", "carried", "is_sound", "leaves", "named_numbers"]

MOST_NAMED, MOST_SHOWN = 6, 12
"""Numbers of an example in the sentence on a change, and in that on the whole study."""
LOADS = ("load", "normal")
"""Names of the part that presses."""
NAMES = {
    "first": "the body below",
    "second": "the body above",
    "bed": "shape and bodies",
    "on": "what carries the layers",
}


class CarriedStudy(NamedTuple):
    """What became of a study when its question changed.

    Parameters
    ----------
    table
        The problem of the new study.
    kept, dropped
        Names of what stayed, and of what the new problem has no place for.
    aside
        Key -> what was dropped, which may fit again later.
    assumed
        Path -> content of the numbers and words that nobody has given: those of an example.
    new
        Names and contents of those of them that come with the new problem.
    """

    table: dict[str, Any]
    kept: tuple[str, ...]
    dropped: tuple[str, ...]
    aside: dict[str, Any]
    assumed: dict[str, Any]
    new: tuple[str, ...]

    @property
    def sentence(self) -> str:
        """What was kept, dropped and assumed, in sentences."""
        kept = f"Kept: {', '.join(self.kept)}." if self.kept else "Nothing of the former study fits here."
        kind = str(self.table["problem"]["kind"]).replace("_", " ")
        dropped = f" Dropped, as {kind} has no place for it: {', '.join(self.dropped)}." if self.dropped else ""
        named = f" Of the example: {_listed(self.new, MOST_NAMED)}." if self.new else ""
        return kept + dropped + named


def leaves(content: Any, path: str = "problem") -> dict[str, Any]:
    """Return path -> content of all kinds, numbers and words of a part."""
    if isinstance(content, dict):
        inside = [leaves(item, f"{path}.{key}") for key, item in content.items()]
    elif isinstance(content, list) and any(isinstance(item, dict) for item in content):
        inside = [leaves(item, f"{path}.{place}") for place, item in enumerate(content)]
    else:
        return {path: content}
    return {key: item for part in inside for key, item in part.items()}


def named_numbers(assumed: Mapping[str, Any]) -> str:
    """Return the numbers and words among what nobody has given, for a sentence; empty if there are none.

    Examples
    --------
    >>> named_numbers({"problem.load.kind": "force", "problem.load.force": "2 N"})
    'force 2 N'
    """
    numbers = dict.fromkeys(one for path, content in assumed.items() if (one := _number(path, content)))
    return _listed(tuple(numbers), MOST_SHOWN)


def _listed(numbers: tuple[str, ...], most: int) -> str:
    more = f" and {len(numbers) - most} more" if len(numbers) > most else ""
    return ", ".join(numbers[:most]) + more


def _number(path: str, content: Any) -> str:
    """Return the name of a key and what it holds; nothing of a kind or of a switch."""
    key = path.rpartition(".")[2]
    if key == "kind" or isinstance(content, bool):
        return ""
    return f"{name_in_words(key)} {content}" if isinstance(content, str | float | int) else key


def carried(
    old: dict[str, Any],
    new: dict[str, Any],
    aside: dict[str, Any],
    is_sound: Callable[[dict[str, Any]], bool],
    assumed: Mapping[str, Any] = MappingProxyType({}),
) -> CarriedStudy:
    """Return a study with what fits of another one.

    Parameters
    ----------
    old
        The study before.
    new
        An example of the new problem.
    aside
        Key -> content that was dropped earlier.
    is_sound
        Whether a study passes its checks.
    assumed
        Path -> content of the study before that nobody has given: what was put aside comes before it.
    """
    table = copy.deepcopy(new)
    transfer = _Transfer(old, table, aside, is_sound, assumed)
    transfer.part(form.part_of(table))
    transfer.restore()
    dropped = list(transfer.dropped(form.part_of(old)))
    left = {key: content for key, content in aside.items() if key not in transfer.taken_aside}
    given = [(path, name) for path, name in dropped if not transfer.is_assumed(path, form.at(old, path))]
    left |= {_aside_key(path, form.at(old, path)): form.at(old, path) for path, _ in given}
    names = tuple(dict.fromkeys(name for _, name in given))
    still, fresh = transfer.not_given()
    return CarriedStudy(table, tuple(dict.fromkeys(transfer.kept)), names, left, still, fresh)


def is_sound(table: dict[str, Any], folder: Path) -> bool:
    """Return whether a study passes its checks.

    Parameters
    ----------
    table
        The study.
    folder
        Where its files are.
    """
    from winkler.study.language.fit_reading import parse_fit_study  # with all that it solves: not before it is asked
    from winkler.study.language.reading import parse_study

    text = tomli_w.dumps(table)
    try:
        (parse_fit_study if "fit" in table else parse_study)(text, folder=folder)
    except WinklerError:
        return False
    return True


class _Transfer:
    """The parts of one study on their way into another."""

    def __init__(
        self,
        old: dict[str, Any],
        new: dict[str, Any],
        aside: dict[str, Any],
        is_sound: Callable[[dict[str, Any]], bool],
        assumed: Mapping[str, Any],
    ) -> None:
        self.old, self.new, self.aside, self.is_sound, self.assumed = old, new, aside, is_sound, assumed
        self.sources: dict[str, str] = {}
        self.places = list(_places(old["problem"], "problem"))
        self.used: set[str] = set()
        self.kept: list[str] = []
        self.taken_aside: set[str] = set()

    def part(self, part: FormPart) -> None:
        """Fill a part of the new study, and those inside it."""
        for child in part.children:
            match child:
                case Slot():
                    if not self._slot(child) and child.part:
                        self.part(child.part)
                case Many():
                    self._many(child)
                case FormEntry():
                    self._number(child, part)

    def dropped(self, part: FormPart) -> Iterator[tuple[str, str]]:
        """Yield path and name of what found no place."""
        for child in part.children:
            content = form.at(self.old, child.path)
            if content is None or content == [] or child.path in self.used:
                continue
            inside = any(used.startswith(f"{child.path}.") for used in self.used)
            if inside and isinstance(child, Slot) and child.part:
                yield from self.dropped(child.part)
            else:
                yield child.path, _said(child.path, content)

    def _slot(self, slot: Slot) -> bool:
        """Put a part into a place of the same name; return whether one fits."""
        key = slot.path.rpartition(".")[2]
        for path, content in self._candidates(slot.path, key):
            if isinstance(content, dict) and str(content.get("kind")) in slot.allowed and self._put(slot.path, content):
                self._taken(slot.path, path, key, content)
                return True
        return False

    def _many(self, many: Many) -> None:
        key = many.path.rpartition(".")[2]
        for path, content in self._candidates(many.path, key):
            fits = isinstance(content, list) and all(
                isinstance(one, dict) and str(one.get("kind")) in many.allowed for one in content
            )
            if fits and content and self._put(many.path, content):
                self._taken(many.path, path, key, content)
                return
        for step in many.parts:  # the first step of a path that prescribes a load of the same kind
            for child in step.children:
                if isinstance(child, Slot) and child.path.endswith(LOADS) and child.part:
                    self._slot(child._replace(allowed=(child.part.kind,)))

    def _number(self, entry: FormEntry, owner: FormPart) -> None:
        """Keep a number of the same name in a part of the same name, if it is of the same dimension."""
        key, role = entry.path.rpartition(".")[2], owner.path.rpartition(".")[2]
        for path, content in self._candidates(entry.path, key):
            parent = path.rpartition(".")[0]
            if not parent or isinstance(content, dict) or not _belong(parent.rpartition(".")[2], role):
                continue
            if _takes(form.at(self.old, parent), key) == entry.takes and self._put(entry.path, content):
                self._taken(entry.path, path, key, content)
                return

    def _candidates(self, path: str, key: str) -> list[tuple[str, Any]]:
        """Return path and content of what may go to a place: of the same path, of the same name, of earlier studies."""
        names = LOADS if key in LOADS else (key,)
        named = [(one, content) for one, content in self.places if one.rpartition(".")[2] in names]
        named.sort(key=lambda pair: pair[0] != path)
        free = [(one, content) for one, content in named if not self._is_used(one)]
        given = [one for one in free if not self.is_assumed(*one)]
        aside = [("", self.aside[key])] if key in self.aside and not given else []
        return [*given, *aside, *(one for one in free if one not in given)]

    def _is_used(self, path: str) -> bool:
        return any(path == used or path.startswith(f"{used}.") for used in self.used)

    def _put(self, path: str, content: Any) -> bool:
        """Put a content to a place of the new study, if the study is still sound with it."""
        before = form.at(self.new, path)
        if content == before:
            return True
        form.put(self.new, path, copy.deepcopy(content))
        if self.is_sound(self.new):
            return True
        if before is None:
            form.drop(self.new, path)
        else:
            form.put(self.new, path, before)
        return False

    def is_assumed(self, path: str, content: Any) -> bool:
        """Return whether nobody has given a content of the study before."""
        return all(at in self.assumed and self.assumed[at] == item for at, item in leaves(content, path).items())

    def restore(self) -> None:
        """Put numbers that were put aside to the places where they stood, if nobody has given others."""
        for path, content in self.not_given()[0].items():
            key = _aside_key(path, content)
            if key in self.aside and key not in self.taken_aside and self._put(path, self.aside[key]):
                self._taken(path, "", key, self.aside[key])

    def not_given(self) -> tuple[dict[str, Any], tuple[str, ...]]:
        """Return path -> content of what nobody has given in the new study, and its numbers that came with it."""
        found, fresh = {}, []
        for path, content in leaves(self.new["problem"]).items():
            place = path
            while place and place not in self.sources:
                place = place.rpartition(".")[0]
            source = self.sources.get(place)
            if source is None:
                found[path] = content
                fresh += [one] if (one := _number(path, content)) else []
            elif source and self.is_assumed(source + path[len(place) :], content):
                found[path] = content
        return found, tuple(dict.fromkeys(fresh))

    def _taken(self, place: str, path: str, key: str, content: Any) -> None:
        self.sources[place] = path
        if path:
            self.used.add(path)
        else:
            self.taken_aside.add(key)
        self.kept.append(_said(path or key, content))


def _places(content: Any, path: str) -> Iterator[tuple[str, Any]]:
    """Yield path and content of all keys of a problem, the outer ones first."""
    if not isinstance(content, dict):
        return
    for key, inside in content.items():
        if key != "kind":
            yield f"{path}.{key}", inside
    for key, inside in content.items():
        yield from _places(inside, f"{path}.{key}")


def _aside_key(path: str, content: Any) -> str:
    """Return the name under which a content is put aside: of a number with that of its part, as ``first.young``."""
    return ".".join(path.split(".")[-1 if isinstance(content, dict | list) else -2 :])


def _belong(before: str, now: str) -> bool:
    """Return whether numbers of one name are one thing in two parts; a load may be a part or a number of its own."""
    return before == now or {before, now} == {"problem", "load"}


def _takes(part: Any, key: str) -> str:
    kind = str(part.get("kind")) if isinstance(part, dict) else ""
    found = [one.takes for one in keys_of(kind) if one.name == key] if kind in kinds() else []
    return found[0] if found else ""


def _said(path: str, content: Any) -> str:
    """Return a part or a number in words: ``profile (sphere)``, ``load (force)``, ``the body below (elastic)``."""
    key = path.rpartition(".")[2]
    name = NAMES.get(key, name_in_words(key))
    if not isinstance(content, dict) or "kind" not in content or key == "bed":
        return name
    kind = str(content["kind"]).replace("_", " ")
    numbers = [
        str(inside) for key, inside in content.items() if key != "kind" and isinstance(inside, str | float | int)
    ]
    return f"{name} ({' '.join([kind, *numbers]) if len(numbers) == 1 else kind})"
