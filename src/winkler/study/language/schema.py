"""Input models, derived from the dataclasses: the keys that a study file may have.

Every class of the catalogue becomes a pydantic model with the same keys and a ``kind``; extra keys are forbidden.  A
float becomes a quantity in the glossary's unit, a protocol any of the kinds that fulfil it.  The model of a kind is
created when a table first names the kind.  The models only check and convert; the plain dataclasses are made from them
in `winkler.study.language.build`.
"""

from __future__ import annotations

import dataclasses
import functools
import inspect
import types
import typing
from collections.abc import Callable, Mapping
from enum import StrEnum
from typing import Any, Literal, Union

import numpy as np
from pydantic import (
    BaseModel,
    ConfigDict,
    StrictBool,
    StrictInt,
    StrictStr,
    TypeAdapter,
    create_model,
    model_validator,
)
from pydantic_core import PydanticCustomError

from winkler.numerics.types import Array
from winkler.study.chapters.kind import Kind
from winkler.study.language import json_forms, maps, quantities
from winkler.study.language.catalogue import CATALOGUE, SLOTS, UNWRITTEN, kinds
from winkler.study.language.json_forms import checked
from winkler.study.language.kind_of_table import either_file_or, refuse_kind, value_text
from winkler.study.language.quantities import WHERE, wrong
from winkler.values.checks.contract import path_of, stands_for
from winkler.values.checks.field_checks import numbers_taken
from winkler.values.errors import suggest
from winkler.values.units import format_quantity

OSCULATION, BALL, GROOVE = "osculation", "first_lateral_radius", "second_lateral_radius"
"""Radius of a groove over the diameter of the ball in it, and the radii that it stands between."""

MISSING: Any = object()
"""Stands in a form for a key that was left out and has a default in its class."""

FORBID = ConfigDict(extra="forbid", arbitrary_types_allowed=True, protected_namespaces=(), defer_build=True)


def choice(hint: Any) -> Any:
    """Return the validator of a table of one of the kinds that are allowed for the type `hint`."""
    return checked(functools.partial(_chosen, hint=hint), lambda: json_forms.of_kinds(allowed_kinds(hint)))


def _chosen(raw: Any, hint: Any) -> BaseModel:
    tag = raw.get("kind") if isinstance(raw, Mapping) else None
    if not (isinstance(tag, str) and tag in kinds() and _may_stand(tag, hint)):
        refuse_kind(raw, allowed_kinds(hint))
    return form(tag).model_validate(raw)


def is_choice(hint: Any) -> bool:
    """Return whether a type is one of a few words, such as a method."""
    return isinstance(hint, type) and issubclass(hint, StrEnum)


def _word_of(raw: Any, hint: type[StrEnum]) -> StrEnum:
    allowed = [str(each) for each in hint]
    if raw not in allowed:
        near = suggest(raw, allowed) if isinstance(raw, str) else ""
        wrong(f"{WHERE} is {value_text(raw)}{near}; give one of {', '.join(allowed)}.")
    return hint(raw)


def _in_unit(convert: Callable[..., Any], form: Callable[[str | None], json_forms.Form], unit: str | None) -> Any:
    """Return the annotation of numbers in a unit."""
    return checked(functools.partial(convert, unit=unit), functools.partial(form, unit))


def annotation(owner: type, field: str, hint: Any) -> Any:
    """Return the annotation by which pydantic checks the key `field` of `owner`; `hint` is its type in the class.

    Raises
    ------
    TypeError
        If a study file cannot hold such a field.
    """
    if is_choice(hint):
        return checked(functools.partial(_word_of, hint=hint), lambda: {"enum": [str(each) for each in hint]})
    if hint in (int, bool, str):
        return {int: StrictInt, bool: StrictBool, str: StrictStr}[hint]
    origin, inner = typing.get_origin(hint), typing.get_args(hint)
    unit = quantities.unit_of(owner, field)
    if (owner.__name__, field) in quantities.INDEXED:
        units = quantities.INDEXED[owner.__name__, field]
        return checked(functools.partial(quantities.indexed, units=units), json_forms.indexed)
    if (owner.__name__, field) in quantities.GRIDS:
        return checked(quantities.grid, json_forms.grid)
    if hint == tuple[int, int]:
        return checked(maps.counts, json_forms.counts)
    if hint == tuple[tuple[str, float], ...]:
        return checked(quantities.named, json_forms.named)
    if (owner.__name__, field) in maps.MAPS:
        return _in_unit(maps.height_map, json_forms.height_map, unit)
    if (owner.__name__, field) in maps.PAIRS:
        return _in_unit(maps.pair, json_forms.pair, unit)
    if hint is float:
        taken = quantities.number_or_infinite if quantities.endless(owner, field) else quantities.number
        return _in_unit(taken, lambda unit: json_forms.quantity(unit, within=numbers_taken(owner, field)), unit)
    if hint == Array or (origin is tuple and inner == (float, Ellipsis)):
        return _in_unit(quantities.numbers, json_forms.several, unit)
    if origin in (Union, types.UnionType) and set(inner) == {float, Array}:
        return _in_unit(quantities.number_or_numbers, json_forms.one_or_many, unit)
    if origin is tuple and len(inner) == 2 and inner[1] is Ellipsis:
        return list[annotation(owner, field, inner[0])]  # type: ignore[misc]
    if origin in (Union, types.UnionType) or isinstance(hint, type):
        return choice(hint)
    raise TypeError(f"{owner.__name__}.{field}: a study file cannot hold {hint}.")


def allowed_kinds(hint: Any) -> tuple[str, ...]:
    """Return the kinds that are allowed for the type `hint`; none if it is no type of kinds.

    A `hint` that is a text is the name of a slot.
    """
    if slot := _slot(hint):
        return tuple(CATALOGUE[slot])
    if typing.get_origin(hint) in (Union, types.UnionType):
        parts = [allowed_kinds(part) for part in typing.get_args(hint) if path_of(part) not in UNWRITTEN]
        return tuple(dict.fromkeys(name for part in parts for name in part)) if all(parts) else ()
    return _kinds_of(hint) if isinstance(hint, type) else ()


def _slot(hint: Any) -> str:
    """Return the slot whose kinds are allowed for the type `hint`, or that it names; empty if it allows other kinds."""
    return hint if isinstance(hint, str) else SLOTS.get(path_of(hint), "") if isinstance(hint, type) else ""


def _may_stand(name: str, hint: Any) -> bool:
    """Return whether a kind is allowed for the type `hint`; no other kind is loaded for it."""
    if slot := _slot(hint):
        return name in CATALOGUE[slot]
    if typing.get_origin(hint) in (Union, types.UnionType):
        return any(_may_stand(name, part) for part in typing.get_args(hint))
    return isinstance(hint, type) and path_of(hint) not in UNWRITTEN and stands_for(kinds()[name].cls, hint)


@functools.cache  # of one class only: unions of the same classes in another order are equal
def _kinds_of(cls: type) -> tuple[str, ...]:
    """Return the kinds of a class and of those derived from it, or those that keep a protocol."""
    return tuple(name for name, line in kinds().items() if stands_for(line.cls, cls))


def allowed_in_list(hint: Any) -> tuple[str, ...]:
    """Return the kinds that are allowed in a list for the type ``tuple[X, ...]``; none for other types."""
    inner = typing.get_args(hint)
    listed = typing.get_origin(hint) is tuple and len(inner) == 2 and inner[1] is Ellipsis
    return allowed_kinds(inner[0]) if listed else ()


@functools.cache
def hints(owner: type) -> dict[str, Any]:
    """Return field -> type of a dataclass, in the order of its fields."""
    hint_of = typing.get_type_hints(owner)
    return {field.name: hint_of[field.name] for field in dataclasses.fields(owner) if field.init}


def required_fields(owner: type) -> list[str]:
    """Return the fields of a dataclass without a default, in their order."""
    return [
        field.name
        for field in dataclasses.fields(owner)
        if field.default is field.default_factory is dataclasses.MISSING
    ]


def options(line: Kind) -> dict[str, Any]:
    """Return name -> type of the options of a kind's reader: its keyword-only arguments."""
    if line.reader is None:
        return {}
    arguments, types_ = inspect.signature(line.reader).parameters.values(), typing.get_type_hints(line.reader)
    return {item.name: types_[item.name] for item in arguments if item.kind is inspect.Parameter.KEYWORD_ONLY}


def diameters(owner: type) -> dict[str, str]:
    """Return the diameters that a study may give in place of radii: key -> field of the radius.

    Examples
    --------
    >>> from winkler.profiles.power import Paraboloid
    >>> diameters(Paraboloid)
    {'diameter': 'curvature_radius'}
    """
    radii = [field for field in hints(owner) if "radius" in field and quantities.unit_of(owner, field) == "m"]
    named = {radius.replace("curvature_radius", "diameter").replace("radius", "diameter"): radius for radius in radii}
    return {key: radius for key, radius in named.items() if key not in hints(owner)}


def _in_radii(raw: Any, pairs: dict[str, str]) -> Any:
    """Return a table with the radii that its diameters and the osculation of a groove stand for."""
    if not isinstance(raw, dict):
        return raw
    found = dict(raw)
    for key in pairs.keys() & raw.keys():
        if pairs[key] in raw:
            wrong(f"{WHERE} has both {key} and {pairs[key]}; give one of them.")
        found[pairs[key]] = _scaled(found.pop(key), 0.5, key)
    if OSCULATION in found and GROOVE in pairs.values():
        if GROOVE in found:
            wrong(f"{WHERE} has both {OSCULATION} and {GROOVE}; give one of them.")
        if BALL not in found:
            wrong(f"{WHERE} has an {OSCULATION}, but no '{BALL}', of the ball in the groove; add it.")
        ratio = _read(found.pop(OSCULATION), None, OSCULATION)
        if not (isinstance(ratio, int | float) and 0.5 < ratio < 1.0):
            given = value_text(raw[OSCULATION])
            wrong(
                f"{WHERE} is {given}; give the radius of the groove over the diameter of the ball, such as 0.52.",
                OSCULATION,
            )
        found[GROOVE] = _scaled(found[BALL], -2.0 * ratio, BALL)
    return found


def _scaled(raw: Any, factor: float, key: str) -> Any:
    """Return a length of a study, or several, times a factor."""
    if raw == quantities.INFINITE:
        return raw
    lengths = np.asarray(_read(raw, "m", key), dtype=float) * factor
    return (
        [format_quantity(float(length), "m") for length in lengths]
        if lengths.ndim
        else format_quantity(float(lengths), "m")
    )


def _read(raw: Any, unit: str | None, key: str) -> Any:
    try:
        return quantities.number_or_numbers(raw, unit)
    except PydanticCustomError as refusal:
        wrong(quantities.sentence_of(refusal), key)


def _model(name: str, line: Kind) -> type[BaseModel]:
    required = required_fields(line.cls)
    others = [field for field in hints(line.cls) if field not in required]
    keys: dict[str, Any] = {"kind": (Literal[name], ...)}
    for field, hint in hints(line.cls).items():
        optional = field not in required or line.reader is not None
        keys[field] = (annotation(line.cls, field, hint), MISSING if optional else ...)
    rules: dict[str, Any] = {}
    if pairs := diameters(line.cls):
        rules["radii"] = model_validator(mode="before")(functools.partial(_in_radii, pairs=pairs))
    if line.reader is not None:
        keys["file"] = (StrictStr, MISSING)
        taken = options(line)
        keys |= {option: (annotation(line.cls, option, hint), MISSING) for option, hint in taken.items()}
        alone = tuple(option for option in taken if option not in hints(line.cls))
        either = functools.partial(either_file_or, required=required, others=others, options=tuple(taken), alone=alone)
        rules["either"] = model_validator(mode="before")(either)
    depends = quantities.dependent(line.cls)
    if depends:
        rules["units"] = model_validator(mode="after")(functools.partial(quantities.settle, cls=line.cls, keys=depends))
    return create_model(name, __config__=FORBID, __validators__=rules, **keys)


@functools.cache
def form(name: str) -> type[BaseModel]:
    """Return the input model of one kind."""
    return _model(name, kinds()[name])


def _adapter(shape: Any) -> TypeAdapter[Any]:
    return TypeAdapter(create_model("wrapper", __config__=FORBID, content=(shape, ...)))


@functools.cache
def slot_adapter(slot: str) -> TypeAdapter[Any]:
    """Return the validator of ``{"content": table}`` where the table is any kind of `slot`."""
    return _adapter(choice(slot))


@functools.cache
def adapter(owner: type, field: str, hint: Any) -> TypeAdapter[Any]:
    """Return the validator of ``{"content": x}`` where x of the type `hint` is the key `field` of `owner`."""
    return _adapter(annotation(owner, field, hint))
