"""Checks of the fields of a value, derived from their types once for each class.

A float is a number, an ``Array`` an array of numbers, the name of a class a value of that class, the name of a protocol
whatever has its members.  ``Annotated`` types restrict numbers (`number_checks`) and, by `Condition`, parts.  A type
without such a restriction, as ``Any``, admits all contents.
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

from winkler.checks.contract import described, lacking, of_kinds
from winkler.checks.number_checks import COUNT_BITS, Advice, Check, Ending, Number, ended
from winkler.checks.physical_size import as_text
from winkler.errors import InvalidInput
from winkler.vocabulary import word

__all__ = ["Condition", "checks_of", "numbers_taken"]

KIND_DEMANDS = {
    float: "give a number",
    int: "give a whole number below 10^12",
    str: "give a text",
    bool: "give True or False",
}
ANY_ARRAY = NDArray[Any]
NON_NUMERIC_KINDS = (str, bytes, complex, dict, set, object, type(None), bool)
UNCHECKED_KINDS = (Any, object, type, float, int, str, bool, bytes, tuple, list, dict, set, type(None), np.ndarray)
"""Kinds of which a part is made that nothing is compared with."""


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
    extras = _extras(hint)
    plain = hint.__origin__ if extras else hint
    section = getattr(cls, "section", "")
    where = f"{section}.{field}" if section else f"{cls.__name__}: {field}"
    ending = _ending(cls, field, "; ".join(item.text for item in extras if isinstance(item, Advice)))
    for item in extras:
        if hasattr(item, "check"):
            return item.check(where, ending)  # type: ignore[no-any-return]
    if plain in KIND_DEMANDS:
        return _exact(where, plain, ending)
    if plain == ANY_ARRAY or set(_union(plain)) == {float, ANY_ARRAY}:
        return _array(where, ending)
    many = typing.get_origin(plain) is tuple and typing.get_args(plain)[1:] == (Ellipsis,)
    kinds = _union(typing.get_args(plain)[0] if many else plain)
    if not all(isinstance(kind, type) and kind not in UNCHECKED_KINDS for kind in kinds):
        return None
    condition = next((item for item in extras if isinstance(item, Condition)), None)
    return _parts(where, kinds, many, ending) if condition is None else _conditional(where, kinds, condition)


def _union(hint: Any) -> tuple[Any, ...]:
    """Return the members of a union; a type that is none alone."""
    return typing.get_args(hint) if typing.get_origin(hint) in (Union, types.UnionType) else (hint,)


def _ending(cls: type, field: str, advice: str) -> Ending:
    """Return what completes the sentence of a refusal with the field's unit, looked up only then, and the advice."""

    def ending(demand: str) -> str:
        try:
            unit = word(cls, field).unit
        except KeyError:
            unit = None
        return ended(demand, unit, advice)

    return ending


def _exact(where: str, kind: type, ending: Ending) -> Check:
    allowed = (float, int) if kind is float else (kind,)

    def checked(content: Any) -> Any:
        made = type(content)
        if made not in allowed or (kind is int and content.bit_length() > COUNT_BITS):
            raise InvalidInput(f"{where} is {as_text(content)}; {ending(KIND_DEMANDS[kind])}.")
        return content

    return checked


def _array(where: str, ending: Ending) -> Check:
    def checked(content: Any) -> Any:
        made = type(content)
        if made in NON_NUMERIC_KINDS or (made is np.ndarray and content.dtype.kind not in "fbc"):
            demand_text = ending("give a number or an array of numbers")
            raise InvalidInput(f"{where} is {as_text(content)}; {demand_text}.")
        return content

    return checked


def _parts(where: str, kinds: tuple[type, ...], many: bool, ending: Ending) -> Check:
    fits = of_kinds(kinds)

    def refused(part: Any, place: str = "") -> InvalidInput:
        made = f"{type(part).__name__}{lacking(kinds, part)}"
        at = f"{where}{place}" if place else where.replace(": ", ": the ", 1)
        demand_text = ending(f"give {'a list of ' * many}{described(kinds)}")
        return InvalidInput(f"{at} is a {made}; {demand_text}.")

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


def _conditional(where: str, kinds: tuple[type, ...], condition: Condition) -> Check:
    fits = of_kinds(kinds)

    def checked(content: Any) -> Any:
        if not fits(content) or not condition.holds(content):
            raise InvalidInput(f"{where} is {as_text(content)}; {condition.demand}.")
        return content

    return checked
