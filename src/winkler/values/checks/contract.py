"""Checks of the parts of a value against the kinds of their fields: classes, or protocols member by member."""

from __future__ import annotations

import dataclasses
import functools
import inspect
import typing
from collections.abc import Callable
from collections.abc import Set as AbstractSet
from typing import Any, TypeVar

import numpy as np

K = TypeVar("K")
NO_PART = (float, int, bool, complex, str, bytes, tuple, list, dict, set, object, type(None), np.ndarray)
"""What is never a part made of other values, even if it has the members of a protocol."""
KINDS_NAMED_ALONE = 5
"""From so many kinds on a sentence gives their names alone."""
STATED_OFFERS: dict[Any, str] = {}
"""What refusals tell the user to give for a protocol or a base class."""


def offered(text: str) -> Callable[[K], K]:
    """Decorate a protocol or a base class with the phrase that refusals use for it."""

    def decorate(kind: K) -> K:
        STATED_OFFERS[kind] = text
        return kind

    return decorate


def keeps(part: Any, protocol: type) -> bool:
    """Return whether a value has each member of a protocol, without evaluating any of them."""
    return not isinstance(part, type) and not _missing(part, protocol)


def of_kinds(kinds: tuple[type, ...]) -> Callable[[Any], bool]:
    """Return a test of whether a part is of one of the kinds; for most parts the class alone decides, once."""
    classes = tuple(kind for kind in kinds if not is_protocol(kind))
    protocols = [kind for kind in kinds if is_protocol(kind)]
    accepted: set[type] = set()

    def fits(part: Any) -> bool:
        made = part.__class__
        if made in accepted:
            return True
        if made in NO_PART or isinstance(part, type):
            return False
        if issubclass(made, classes) or any(stands_for(made, kind) for kind in protocols):
            accepted.add(made)
            return True
        return any(not _missing(part, kind) for kind in protocols)

    return fits


def path_of(cls: type) -> str:
    """Return module and name of a class, as ``"winkler.loading.loads:Force"``."""
    return f"{cls.__module__}:{cls.__qualname__}"


def is_a(content: Any, *paths: str) -> bool:
    """Return whether a value is of one of the classes, named by their paths; none of them is loaded for it."""
    return any(path_of(base) in paths for base in type(content).__mro__)


def stands_for(made: type, kind: type) -> bool:
    """Return whether a class is derived from another one, or declares each member of a protocol."""
    return not _unknown(made, kind) if is_protocol(kind) else issubclass(made, kind)


def is_protocol(kind: Any) -> bool:
    """Return whether a class is a protocol, whose members are compared one by one."""
    return bool(getattr(kind, "_is_protocol", False))


def lacking(kinds: tuple[type, ...], part: Any) -> str:
    """Return which members of a protocol are missing from what has most of them, for who wrote it."""
    protocols = [kind for kind in kinds if is_protocol(kind)]
    missing = [item for kind in protocols for item in sorted(_missing(part, kind))]
    few = missing and 2 * len(missing) < sum(len(_members(kind)) for kind in protocols)
    return f" without {', '.join(missing)}" if few else ""


def _missing(part: Any, protocol: type) -> AbstractSet[str]:
    """Return the public members of a protocol that a value has not, without evaluating any of them."""
    unknown = _unknown(part.__class__, protocol)
    if isinstance(part, type):
        return {name for name in unknown if inspect.getattr_static(part, name, unknown) is unknown}
    return unknown.difference(getattr(part, "__dict__", ()))  # the class has none of them


@functools.cache
def _unknown(made: type, protocol: type) -> frozenset[str]:
    """Return the public members of a protocol that a class does not declare."""
    return _members(protocol) - {*dir(made), *getattr(made, "__dataclass_fields__", ())}


@functools.cache
def _members(protocol: type) -> frozenset[str]:
    """Return the public members of a protocol."""
    parts = [base for base in protocol.__mro__ if is_protocol(base) and base is not typing.Protocol]
    return frozenset(
        name for base in parts for name in (*vars(base), *vars(base).get("__annotations__", {})) if name[0] != "_"
    )


def described(kinds: tuple[type, ...]) -> str:
    """Return the phrase for what to give: ``Elastic(young, poisson) or Rigid()``."""
    names = [
        _described(kind) if len(kinds) < KINDS_NAMED_ALONE else STATED_OFFERS.get(kind, kind.__name__) for kind in kinds
    ]
    return f"{', '.join(names[:-1])} or {names[-1]}" if names[1:] else names[0]


def _described(kind: type) -> str:
    if kind in STATED_OFFERS:
        return STATED_OFFERS[kind]
    if not dataclasses.is_dataclass(kind):
        return kind.__name__
    fields = [field for field in dataclasses.fields(kind) if field.init]
    missing = dataclasses.MISSING
    needed = [field.name for field in fields if field.default is missing and field.default_factory is missing]
    if len(fields) == 1 and fields[0].name.replace("_", "") == kind.__name__.lower():
        return kind.__name__  # Force, Depth: the name is enough
    return f"{kind.__name__}({', '.join(needed or [field.name for field in fields])})"
