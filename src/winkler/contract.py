"""Whether a part is of the kinds that a field names: of its classes, or with each member of a protocol."""

from __future__ import annotations

import functools
import inspect
import typing
from typing import Any

__all__ = ["fits", "keeps", "lacking", "listed"]

OFFERED = {
    "Bed": "a bed, such as Foundation(profile, medium)",
    "DepthGrading": "a grading, such as ExponentialGrading",
    "Medium": "a medium, such as HalfSpace(first, second)",
    "Profile": "a profile, such as Sphere or Cone",
    "Spectrum": "a spectrum, such as SelfAffine",
}
"""What to give for a protocol."""


def fits(cls: type, name: str, parts: tuple[Any, ...]) -> bool:
    """Return whether parts are of the kinds that a field of a class names."""
    return all(
        _surely(cls, name, part.__class__) or any(_is(part, kind) for kind in _kinds(cls, name)) for part in parts
    )


def keeps(part: Any, protocol: type) -> bool:
    """Return whether a value has each member of a protocol, without asking for any of them."""
    return not _missing(part, protocol)


@functools.cache
def _surely(cls: type, name: str, given: type) -> bool:
    """Return whether values of a class are of the kinds that a field names, which their class alone tells of most."""
    kinds = _kinds(cls, name)
    protocols = [kind for kind in kinds if getattr(kind, "_is_protocol", False)]
    classes = tuple(kind for kind in kinds if kind not in protocols)
    return not kinds or any(not _unknown(given, kind) for kind in protocols) or issubclass(given, classes)


def _is(part: Any, kind: type) -> bool:
    return not _missing(part, kind) if getattr(kind, "_is_protocol", False) else isinstance(part, kind)


def lacking(cls: type, name: str, inside: Any) -> str:
    """Return which members of a protocol are missing from what has most of them, for who wrote it."""
    protocols = [kind for kind in _kinds(cls, name) if getattr(kind, "_is_protocol", False)]
    missing = [item for kind in protocols for item in sorted(_missing(inside, kind))]
    few = missing and 2 * len(missing) < sum(len(_members(kind)) for kind in protocols)
    return f" without {', '.join(missing)}" if few else ""


@functools.cache
def _kinds(cls: type, name: str) -> tuple[type, ...]:
    """Return the classes and protocols that a field names; none if they are known to type checkers only."""
    try:
        hint = typing.get_type_hints(cls)[name]
    except (NameError, TypeError):
        return ()
    if typing.get_origin(hint) is tuple:
        hint = typing.get_args(hint)[0]
    kinds = typing.get_args(hint) or (hint,)
    return kinds if all(isinstance(kind, type) for kind in kinds) else ()


def _missing(part: Any, protocol: type) -> set[str]:
    """Return the public members of a protocol that a value has not, without asking for any of them."""
    unknown = _unknown(part.__class__, protocol)
    return {name for name in unknown if inspect.getattr_static(part, name, unknown) is unknown}


@functools.cache
def _unknown(given: type, protocol: type) -> frozenset[str]:
    """Return the public members of a protocol of which a class does not tell that its values have them."""
    return _members(protocol) - {*dir(given), *getattr(given, "__dataclass_fields__", ())}


@functools.cache
def _members(protocol: type) -> frozenset[str]:
    """Return the public members of a protocol."""
    parts = [base for base in protocol.__mro__ if getattr(base, "_is_protocol", False) and base is not typing.Protocol]
    return frozenset(
        name for base in parts for name in (*vars(base), *vars(base).get("__annotations__", {})) if name[0] != "_"
    )


def listed(hint: Any) -> str:
    """Return the names of a union as a sentence lists them."""
    names = [_offered(part) for part in typing.get_args(hint)]
    return f"{', '.join(names[:-1])} or {names[-1]}" if names else _offered(hint)


def _offered(hint: Any) -> str:
    """Return the name of a class; of a protocol, what has all of it."""
    name = str(getattr(hint, "__name__", hint))
    return OFFERED.get(name, name)
