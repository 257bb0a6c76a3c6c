"""Checks of the fields of a value, derived from their types once for each class.

A float is a number, an ``Array`` an array of numbers (`winkler.values.checks.plain_numbers`), the name of a class a
value of that class, the name of a protocol whatever has its members, a tuple of them a list.  ``Annotated`` types
restrict numbers (`number_checks`) and, by `Condition`, parts.  A type without a restriction, as ``Any``, admits all
contents.
"""

from __future__ import annotations

import dataclasses
import functools
import types
import typing
from collections.abc import Callable
from typing import Annotated, Any, NamedTuple, Union

import numpy as np
from numpy.typing import NDArray

from winkler.values.checks.contract import described, lacking, of_kinds
from winkler.values.checks.number_checks import COUNT_BITS, Advice, Check, Number
from winkler.values.checks.physical_size import as_text, refuse_size
from winkler.values.checks.plain_numbers import REAL, Argument, plain
from winkler.values.errors import InvalidInput
from winkler.values.vocabulary import word

KIND_DEMANDS = {
    float: "give a number",
    int: "give a whole number below 10^12",
    str: "give a text",
    bool: "give True or False",
}
ANY_ARRAY = NDArray[Any]
UNCHECKED_KINDS = (Any, object, type, float, int, str, bool, bytes, tuple, list, dict, set, type(None), np.ndarray)
"""Kinds of which a part is made that nothing is compared with."""
ABSENT: dict[Any, Any] = {type(None): None, tuple[()]: ()}
"""Kind of a part that may be left out -> what stands in its place."""


class Condition(NamedTuple):
    """A condition `holds` on a part, besides its being of a kind that the type names; `demand` is what to give."""

    holds: Callable[[Any], bool]
    demand: str


def checks_of(cls: Any) -> tuple[tuple[str, Check | None], ...]:
    """Return the fields of a dataclass that are given, each with what its contents are compared with.

    A sentence of refusal begins with the name of the class, or with its `section` of a study if it is one.
    """
    hints = _hints(cls)
    return tuple((item.name, _check(cls, item.name, hints[item.name])) for item in dataclasses.fields(cls) if item.init)


def _hints(cls: Any) -> dict[str, Any]:
    """Return the types of the fields of a class; ``Any`` for one that only type checkers resolve."""
    unknown: dict[str, Any] = {}
    while True:
        try:
            return typing.get_type_hints(cls, localns=unknown or None, include_extras=True)
        except NameError as error:
            unknown[str(error.name)] = Any
        except AttributeError:  # a name in a module that only type checkers load: field by field
            if len(dataclasses.fields(cls)) == 1:
                return {dataclasses.fields(cls)[0].name: Any}
            return {
                name: hint for field in dataclasses.fields(cls) for name, hint in _hints(_alone(cls, field)).items()
            }


def _alone(cls: Any, field: dataclasses.Field[Any]) -> type:
    """Return a class with one field of another one."""
    content = {"__module__": cls.__module__, "__annotations__": {field.name: field.type}}
    return dataclasses.dataclass(type(cls.__name__, (), content))


@functools.cache
def numbers_taken(cls: type, field: str) -> Number | None:
    """Return which single numbers a field of a class takes; None if its type does not state it."""
    return next((item for item in _extras(_hints(cls).get(field)) if isinstance(item, Number)), None)


def _extras(hint: Any) -> tuple[Any, ...]:
    """Return what stands beside a type in ``Annotated``."""
    return hint.__metadata__ if typing.get_origin(hint) is Annotated else ()


def _check(cls: type, field: str, hint: Any) -> Check | None:
    """Return the check that refuses contents which do not fit the type of a field; None if all of them do."""
    section = getattr(cls, "section", "")
    where = f"{section}.{field}" if section else f"{cls.__name__}: {field}"
    advice = "; ".join(item.text for item in _extras(hint) if isinstance(item, Advice))
    return _check_of(hint, Argument(where, functools.partial(_unit, cls, field), advice))


def _unit(cls: type, field: str) -> str | None:
    """Return the unit of a field; None if it is no quantity, or no word."""
    try:
        return word(cls, field).unit
    except KeyError:
        return None


def _check_of(hint: Any, argument: Argument) -> Check | None:
    """Return the check that refuses contents which do not fit a type; None if all of them do."""
    extras = _extras(hint)
    plain_hint = hint.__origin__ if extras else hint
    for item in extras:
        if hasattr(item, "check"):
            return item.check(argument)  # type: ignore[no-any-return]
    if plain_hint in KIND_DEMANDS:
        return _exact(plain_hint, argument)
    members = _union(plain_hint)
    if ANY_ARRAY in members and set(members) <= {float, bool, ANY_ARRAY}:
        return _array(argument, bool in members, alone=len(members) == 1)
    for kind, left_out in ABSENT.items():
        if kind in members:
            return _unless(left_out, _check_of(Union[tuple(one for one in members if one != kind)], argument))  # noqa: UP007
    if many := typing.get_origin(plain_hint) is tuple:
        entries = typing.get_args(plain_hint)
        members = _union(entries[0])
        if entries == (float, Ellipsis):
            return _row(argument)
        if entries[1:] != (Ellipsis,) or not _are_classes(members):
            return _entries(entries, argument)
    if not _are_classes(members):
        return None
    condition = next((item for item in extras if isinstance(item, Condition)), None)
    return _parts(members, many, argument) if condition is None else _conditional(members, condition, argument)


def _unless(left_out: Any, check: Check | None) -> Check | None:
    """Return a check that lets through what stands for a part that is left out."""
    if check is None:
        return None

    def checked(content: Any) -> Any:
        return content if type(content) is type(left_out) and content == left_out else check(content)

    return checked


def _are_classes(kinds: tuple[Any, ...]) -> bool:
    """Return whether parts are compared with all of some kinds."""
    return all(isinstance(kind, type) and kind not in UNCHECKED_KINDS for kind in kinds)


def _union(hint: Any) -> tuple[Any, ...]:
    """Return the members of a union; a type that is none alone."""
    return typing.get_args(hint) if typing.get_origin(hint) in (Union, types.UnionType) else (hint,)


def _exact(kind: type, argument: Argument) -> Check:
    allowed = REAL if kind is float else (kind,)

    def checked(content: Any) -> Any:
        if type(content) is float and kind is float:
            return content
        found = content if kind in (str, bool) else plain(content, argument)
        if type(found) not in allowed or (kind is int and found.bit_length() > COUNT_BITS):
            raise argument.refused(f"is {as_text(content)}", KIND_DEMANDS[kind])
        if type(found) is int:
            refuse_size(argument.where, found)
        return found

    return checked


def _array(argument: Argument, masks: bool, *, alone: bool) -> Check:
    """Return the check of numbers in any shape; of truth values where an array stands alone and has no unit."""

    def checked(content: Any) -> Any:
        if type(content) is float:
            return content
        if type(content) is np.ndarray and content.dtype.kind == "f":
            return content  # long histories are kept in single precision
        found = plain(content, argument)
        if type(found) is int:
            refuse_size(argument.where, found)
        if type(found) in REAL or (type(found) is np.ndarray and found.dtype.kind == "f"):
            return found
        if type(found) is bool and masks:
            return found
        if type(found) is np.ndarray and found.dtype.kind == "b" and (masks or (alone and not argument.unit())):
            return found
        raise argument.refused(f"is {as_text(content)}", "give a number or an array of numbers")

    return checked


def _row(argument: Argument) -> Check:
    """Return the check of a tuple of numbers."""

    def checked(content: Any) -> Any:
        if type(content) is tuple and REAL.issuperset(map(type, content)):
            return content
        found = plain(content, argument)
        if type(found) is not np.ndarray or found.dtype != float or found.ndim != 1:
            raise argument.refused(f"is {as_text(content)}", "give a row of numbers{unit}")
        return tuple(found.tolist())

    return checked


def _entries(kinds: tuple[Any, ...], argument: Argument) -> Check | None:
    """Return the check of a tuple of entries of one kind, or of one entry of each kind; None if all are admitted."""
    checks = [_check_of(kind, argument) for kind in kinds if kind is not Ellipsis]
    many = kinds[1:] == (Ellipsis,)
    if not any(checks):
        return None

    def checked(content: Any) -> Any:
        if isinstance(content, np.ndarray) and content.ndim == 1:
            content = tuple(content.tolist())
        if type(content) is not tuple or not (many or len(content) == len(checks)):
            count = "entries" if many else f"{len(checks)} entries"
            raise argument.refused(f"is {as_text(content)}", f"give a list of {count}")
        if not many:
            return tuple(part if check is None else check(part) for check, part in zip(checks, content, strict=True))
        check = checks[0]
        return content if check is None else tuple(entry(check, part, place) for place, part in enumerate(content))

    def entry(check: Check, part: Any, place: int) -> Any:
        try:
            return check(part)
        except InvalidInput:
            again = _check_of(kinds[0], _at(argument, part, place))
        return part if again is None else again(part)  # refused once more, with its place

    return checked


def _at(argument: Argument, part: Any, place: int) -> Argument:
    """Return an argument that names a part of a list: a pair of a name and what it stands for by the name."""
    named = type(part) is tuple and part and type(part[0]) is str
    return argument._replace(where=f"{argument.where}[{repr(part[0]) if named else place}]")


def _parts(kinds: tuple[type, ...], many: bool, argument: Argument) -> Check:
    fits = of_kinds(kinds)

    def refused(part: Any, place: str = "") -> InvalidInput:
        made = f"a {type(part).__name__}{lacking(kinds, part)}"
        if isinstance(part, type):
            made = f"the class {part.__name__} itself, not a value of it"
        at = argument.where + place if place else argument.where.replace(": ", ": the ", 1)
        return argument._replace(where=at).refused(f"is {made}", f"give {'a list of ' * many}{described(kinds)}")

    def checked(content: Any) -> Any:
        if not many:
            if not fits(content):
                raise refused(content)
            return content
        if type(content) is not tuple:
            raise refused(content)
        for place, part in enumerate(content):
            if not fits(part):
                raise refused(part, f"[{place}]")
        return content

    return checked


def _conditional(kinds: tuple[type, ...], condition: Condition, argument: Argument) -> Check:
    fits = of_kinds(kinds)

    def checked(content: Any) -> Any:
        if not fits(content) or not condition.holds(content):
            raise InvalidInput(f"{argument.where} is {as_text(content)}; {condition.demand}.")
        return content

    return checked
