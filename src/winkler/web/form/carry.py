"""Another question for the same bodies: what fits into the study of another kind of problem stays.

A part (a profile, a medium, a load) goes to the place of the same name that may hold its kind; of a part that does not
fit, the parts and numbers inside it that do.  Each stays only if the study is still sound with it.  What does not
fit is put aside and comes back; an optional number that came with a question goes with it.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Collection, Iterator, Mapping
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

MOST_NAMED, MOST_SHOWN = 6, 12
"""Numbers of an example in the sentence on a change, and in that on the whole study."""
LOADS, BODIES = ("load", "normal"), ("first", "solid")
"""Names of the part that presses, and of the body below."""
NAMES = {
    "first": "the body below",
    "second": "the body above",
    "bed": "shape and bodies",
    "on": "what carries the layers",
}


class PutAside(NamedTuple):
    """What found no place in a study.

    Parameters
    ----------
    content
        A part or a number.
    assumed
        End of a path inside it -> content that nobody has given.
    """

    content: Any
    assumed: dict[str, Any]


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
    came
        Paths of what came with this problem, or with one before it, and nobody has given.
    places
        Path of what was taken -> where it stands now.
    """

    table: dict[str, Any]
    kept: tuple[str, ...]
    dropped: tuple[str, ...]
    aside: dict[str, PutAside]
    assumed: dict[str, Any]
    new: tuple[str, ...]
    came: frozenset[str]
    places: dict[str, str]

    def moved(self, key: str) -> str:
        """Return where what stood at a key stands now; the same key if it was not taken."""
        place = key
        while place and place not in self.places:
            place = place.rpartition(".")[0]
        return self.places[place] + key[len(place) :] if place else key

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


def content_at(table: dict[str, Any], path: str) -> Any:
    """Return the content at a path of a study, also of the range of a varied number; None if there is none.

    Examples
    --------
    >>> content_at({"sweep": {"problem.load.force": ["1 N", "2 N"]}}, "sweep.problem.load.force")
    ['1 N', '2 N']
    """
    section, _, key = path.partition(".")
    inside = table.get(section)
    return inside[key] if isinstance(inside, dict) and key in inside else form.at(table, path)


def content_leaves(table: Mapping[str, Any]) -> dict[str, Any]:
    """Return path -> content of the problem of a study, and of the ranges of varied numbers."""
    ranges = table.get("sweep", {})
    return leaves(table["problem"]) | {f"sweep.{key}": content for key, content in ranges.items()}


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
    if key in ("kind", "spacing", "scale") or isinstance(content, bool):
        return ""
    if isinstance(content, dict) and {"from", "to"} <= set(content):
        return f"{name_in_words(key)} from {content['from']} to {content['to']}"
    return f"{name_in_words(key)} {content}" if isinstance(content, str | float | int) else key


def carried(
    old: dict[str, Any],
    new: dict[str, Any],
    aside: Mapping[str, PutAside],
    is_sound: Callable[[dict[str, Any]], bool],
    assumed: Mapping[str, Any] = MappingProxyType({}),
    came: Collection[str] = (),
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
    came
        Paths of those of them that came with a question.
    """
    table = copy.deepcopy(new)
    transfer = _Transfer(old, table, aside, is_sound, assumed, came)
    transfer.part(form.part_of(table))
    transfer.restore()
    dropped = list(transfer.dropped(form.part_of(old)))
    left = {key: one for key, one in aside.items() if key not in transfer.taken_aside}
    for key in [key for key in left if any(taken.startswith(f"{key}.") for taken in transfer.taken_aside)]:
        for path, piece in _inside({key: left.pop(key)}):  # a part of which something was taken is none any more
            if not any(f"{path}.".startswith(f"{one}.") or one.startswith(path) for one in transfer.taken_aside):
                left.setdefault(_aside_key(path, piece.content), piece)
    given = [(path, name) for path, name in dropped if not transfer.is_assumed(path, form.at(old, path))]
    for path in (*(path for path, _ in given), *transfer.replaced):
        for at in (path, *transfer.loads_inside(path)):
            key = _aside_key(at, form.at(old, at))
            is_stand_in = key in left and f"{at}.kind" in transfer.came
            left[key] = transfer.with_given(left[key], at) if is_stand_in else transfer.put_aside(at)
    names = tuple(dict.fromkeys(name for _, name in given))
    still, fresh, with_it = transfer.not_given()
    return CarriedStudy(table, tuple(dict.fromkeys(transfer.kept)), names, left, still, fresh, with_it, transfer.went)


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
        aside: Mapping[str, PutAside],
        is_sound: Callable[[dict[str, Any]], bool],
        assumed: Mapping[str, Any],
        came: Collection[str],
    ) -> None:
        self.old, self.new, self.is_sound, self.assumed = old, new, is_sound, assumed
        self.put_aside_before = frozenset(aside)
        self.aside, self.aside_at = dict(aside), {key: key for key in aside}
        for path, one in _inside(aside):
            name = _aside_key(path, one.content)
            self.aside.setdefault(name, one)
            self.aside_at.setdefault(name, path)
        self.came = {path for path in came if self.is_assumed(path, form.at(old, path))}
        self.replaced: list[str] = []
        self.sources: dict[str, str | PutAside] = {}
        self.places = [
            (path, content)
            for path, content in _places(old["problem"], "problem")
            if not path.rpartition(".")[0].rpartition(".")[2].isdecimal() or not self.is_assumed(path, content)
        ]  # of the steps of a path the loads that somebody gave
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
                if self._is_replaced(child.part):
                    self.replaced.append(child.path)
                yield from self.dropped(child.part)
            else:
                yield child.path, _said(child.path, content)

    @property
    def went(self) -> dict[str, str]:
        """Path of what was taken from the study before -> where it stands now."""
        return {source: place for place, source in self.sources.items() if isinstance(source, str)}

    def _is_replaced(self, part: FormPart) -> bool:
        """Return whether a number of a part went into a part of another kind."""
        went = self.went
        places = [went[one.path] for one in part.children if isinstance(one, FormEntry) and one.path in went]
        return any(form.at(self.new, place.rpartition(".")[0]).get("kind") != part.kind for place in places)

    def _slot(self, slot: Slot) -> bool:
        """Put a part into a place of the same name; return whether one fits."""
        key = slot.path.rpartition(".")[2]
        for path, content in self._candidates(slot.path, key):
            if not isinstance(content, dict) or str(content.get("kind")) not in slot.allowed:
                continue
            if self._put(slot.path, self._without_came(content, path)) or self._put(slot.path, content):
                self._taken(slot.path, path, key, content)
                return True
        return False

    def _without_came(self, content: Any, path: str) -> Any:
        """Return a part without the optional numbers that came with a question."""
        if not isinstance(content, dict):
            return content
        return {
            key: self._without_came(inside, f"{path}.{key}")
            for key, inside in content.items()
            if f"{path}.{key}" not in self.came or _is_required(content, key)
        }

    def _many(self, many: Many) -> None:
        key = many.path.rpartition(".")[2]
        for path, content in self._candidates(many.path, key):
            fits = isinstance(content, list) and all(
                isinstance(one, dict) and str(one.get("kind")) in many.allowed for one in content
            )
            if fits and content and self._put(many.path, content):
                self._taken(many.path, path, key, content)
                if path:
                    return
                many = many._replace(
                    parts=tuple(form.part_of(self.new, f"{many.path}.{i}") for i in range(len(content)))
                )
                break
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
            if path in self.came and not entry.required:
                continue
            if _takes(form.at(self.old, parent), key) == entry.takes and self._put(entry.path, content):
                self._taken(entry.path, path, key, content)
                return

    def _candidates(self, path: str, key: str) -> list[tuple[str, Any]]:
        """Return path and content of what may go to a place: of the same path, of the same name, of earlier studies."""
        names = (key, *_names(key))
        named = [(one, content) for one, content in self.places if one.rpartition(".")[2] in names]
        named.sort(key=lambda pair: (pair[0] != path, pair[0].rpartition(".")[2] != key))
        free = [(one, content) for one, content in named if not self._is_used(one)]
        given = [one for one in free if not self.is_assumed(*one)]
        aside = next((self.aside[name] for name in names if name in self.aside), None)
        if aside is not None and all(f"{one}.kind" in self.came for one, _ in given):
            for one, _ in given:
                aside = self.with_given(aside, one)
            return [("", copy.deepcopy(aside.content)), *given, *(one for one in free if one not in given)]
        return [*given, *(one for one in free if one not in given)]

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

    def loads_inside(self, path: str) -> list[str]:
        """Return the place of the load that somebody gave in a path, if any: it may fit where no path does."""
        loads = [
            at
            for at, content in self.places
            if at.startswith(f"{path}.") and at.rpartition(".")[2] in LOADS
            if not self._is_used(at) and not self.is_assumed(at, content)
        ]
        return loads[:1]

    def with_given(self, aside: PutAside, path: str) -> PutAside:
        """Return a part with the numbers that somebody gave while a part of another kind stood in for it."""
        numbers = {
            name: inside
            for name, inside in form.at(self.old, path).items()
            if name in aside.content and not self.is_assumed(f"{path}.{name}", inside)
        }
        return PutAside(aside.content | numbers, aside.assumed)

    def put_aside(self, path: str) -> PutAside:
        """Return what stood at a path of the study before, without what came with a question alone."""
        content = self._without_came(form.at(self.old, path), path)
        not_given = {at[len(path) :]: item for at, item in leaves(content, path).items() if self.is_assumed(at, item)}
        return PutAside(content, not_given)

    def restore(self) -> None:
        """Put numbers that were put aside to the places where they stood, if nobody has given others."""
        for path, content in self.not_given()[0].items():
            key = _aside_key(path, content)
            if (
                key in self.aside
                and self.aside_at[key] not in self.taken_aside
                and self._put(path, self.aside[key].content)
            ):
                self._taken(path, "", key, self.aside[key].content)

    def not_given(self) -> tuple[dict[str, Any], tuple[str, ...], frozenset[str]]:
        """Return what nobody has given in the new study: path -> content, its new numbers, paths that came with it."""
        found, fresh, came = {}, [], set()
        for path, content in leaves(self.new["problem"]).items():
            place = path
            while place and place not in self.sources:
                place = place.rpartition(".")[0]
            source = self.sources.get(place)
            if source is None:
                found[path] = content
                fresh += [one] if (one := _number(path, content)) else []
                came.add(path)
            elif isinstance(source, PutAside):
                found |= {path: content} if source.assumed.get(path[len(place) :]) == content else {}
            elif self.is_assumed(before := source + path[len(place) :], content):
                found[path] = content
                came |= {path} & {path if before in self.came else ""}
        return found, tuple(dict.fromkeys(fresh)), frozenset(came)

    def _taken(self, place: str, path: str, key: str, content: Any) -> None:
        if path:
            self.sources[place] = path
            self.used.add(path)
        else:
            found = next(name for name in (key, *_names(key)) if name in self.aside)
            self.sources[place] = self.aside[found]
            if found in self.put_aside_before or isinstance(content, dict | list):  # a part stays, for all its numbers
                self.taken_aside.add(self.aside_at[found])
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
        for place, step in enumerate(inside if isinstance(inside, list) else ()):
            if isinstance(step, dict):  # the load of a step of a path
                yield from ((f"{path}.{key}.{place}.{name}", step[name]) for name in LOADS if name in step)


def _inside(aside: Mapping[str, PutAside]) -> Iterator[tuple[str, PutAside]]:
    """Yield path and content of what is inside the parts that were put aside, unless nobody has given it."""
    for key, one in aside.items():
        for path, content in _places(one.content, key):
            start = path[len(key) :]
            inside = {at[len(start) :]: item for at, item in one.assumed.items() if at.startswith(start)}
            assumed = {at: item for at, item in inside.items() if at[:1] in ("", ".")}
            if leaves(content, "") != assumed:
                yield path, PutAside(content, assumed)


def _names(key: str) -> tuple[str, ...]:
    """Return the names under which the same part stands in other problems."""
    return next((names for names in (LOADS, BODIES) if key in names), (key,))


def _is_required(part: dict[str, Any], key: str) -> bool:
    """Return whether a part cannot do without a key; a range, which is no kind, can do without none."""
    kind = str(part.get("kind"))
    return key == "kind" or kind not in kinds() or any(one.name == key and one.required for one in keys_of(kind))


def _aside_key(path: str, content: Any) -> str:
    """Return the name under which a content is put aside: of a number with that of its part, as ``first.young``."""
    return ".".join(path.split(".")[-1 if isinstance(content, dict | list) else -2 :])


def _belong(before: str, now: str) -> bool:
    """Return whether numbers of one name are one thing in two parts; a load may be a part or a number of its own."""
    return before in _names(now) or {before, now} == {"problem", "load"}


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
