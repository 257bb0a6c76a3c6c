"""Conversion between the tables of a study file and plain dataclasses, in both directions.

``build(unbuild(x)) == x`` for every value of the catalogue, floats to the last digit.
"""

from __future__ import annotations

import dataclasses
import itertools
import math
import typing
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.io.foreign import path_text, reason_of
from winkler.study.language.catalogue import in_present_kinds, kind_of, kinds
from winkler.values.errors import InvalidInput, WinklerError

if TYPE_CHECKING:
    from pydantic import BaseModel


MOST_NEIGHBOURS = 1000
"""Files of a folder among which similar names are searched."""
MOST_LISTED = 12
"""Longer lists of quantities are written as plain numbers with one unit."""


def build(table: Any, slot: str = "problem", *, folder: Path = Path(), file: str = "", key: str = "") -> Any:
    """Return the value that a table of a study file describes.

    Parameters
    ----------
    table
        ``{"kind": ..., ...}``, quantities as text with units.
    slot
        What it must be: a slot of the catalogue, such as profile or problem.
    folder
        Where files that the table names lie.
    file, key
        Name of the study file and place of the table in it, for error messages.

    Raises
    ------
    InvalidInput
        With one sentence for every mistake.

    Examples
    --------
    >>> build({"kind": "sphere", "curvature_radius": "10 mm"}, "profile")
    Sphere(curvature_radius=0.01)
    """
    from pydantic import ValidationError

    from winkler.study.language import mistakes, schema

    table = in_present_kinds(table)
    try:
        form = schema.slot_adapter(slot).validate_python({"content": table}).content
    except ValidationError as error:
        reasons = mistakes.sentences(error, {"content": table}, key or slot)
        raise mistakes.worded(file, reasons) from None
    return assembled(form, folder=folder, file=file, key=key or slot)


def assembled(form: BaseModel, *, folder: Path, file: str, key: str) -> Any:
    """Return the plain dataclass of a checked input model, and of those inside it."""
    from pydantic import BaseModel

    from winkler.study.language.schema import MISSING

    line = kinds()[form.kind]  # type: ignore[attr-defined]
    arguments: dict[str, Any] = {}
    for name in type(form).model_fields:
        content = getattr(form, name)
        if name == "kind" or content is MISSING:
            continue
        if isinstance(content, BaseModel):
            content = assembled(content, folder=folder, file=file, key=f"{key}.{name}")
        elif isinstance(content, list):
            content = tuple(
                assembled(item, folder=folder, file=file, key=f"{key}.{name}[{place}]")
                if isinstance(item, BaseModel)
                else item
                for place, item in enumerate(content)
            )
        arguments[name] = content
    try:
        if "file" in arguments:
            assert line.reader is not None
            return line.reader(_existing_file(folder, arguments.pop("file")), **arguments)
        return line.cls(**arguments)
    except WinklerError as error:
        raise type(error)(_located(str(error), line.cls, f"{file}: {key}" if file else key)) from None


FIELD_VERBS = ("is ", "has ", "does ", "falls ")
"""Words that follow the name of a field in a sentence about it."""


def _located(sentence: str, cls: type, key: str) -> str:
    """Return a sentence of a class with its key in front."""
    begin, _, rest = sentence.partition(": ")
    field, _, statement = rest.partition(" ")
    named = begin == cls.__name__ and field in {item.name for item in dataclasses.fields(cls)}
    return f"{key}.{field} {statement}" if named and statement.startswith(FIELD_VERBS) else f"{key}: {sentence}"


def _existing_file(folder: Path, name: str) -> Path:
    path = folder / name
    try:
        if path.is_file():
            return path
        beside = path.parent.iterdir() if path.parent.is_dir() else ()
        folder_given = path.is_dir()
        near = sorted(item.name for item in itertools.islice(beside, MOST_NEIGHBOURS) if item.suffix == path.suffix)[:5]
    except (OSError, ValueError) as error:
        raise InvalidInput(
            f"file is '{path_text(name)}', which cannot be accessed ({reason_of(error)}); give its path from the study."
        ) from None
    if folder_given:
        raise InvalidInput(f"file is '{path_text(name)}', which is a folder; give the path of a file.")
    near_ones = f"; there are {', '.join(near)}" if near else ""
    raise InvalidInput(
        f"file is '{path_text(name)}', which does not exist beside the study{near_ones}; give its path from there."
    )


def unbuild(content: Any) -> dict[str, Any]:
    """Return the table from which `build` creates `content`; keys at their default are left out.

    Raises
    ------
    InvalidInput
        If the class is not in the catalogue.
    """
    name = kind_of(type(content))
    if not name:
        raise InvalidInput(f"{type(content).__name__} is not in the catalogue, so that no study file can name it.")
    table: dict[str, Any] = {"kind": name}
    for field in dataclasses.fields(content):
        if not field.init:  # follows from the others
            continue
        inside = getattr(content, field.name)
        default = field.default if field.default_factory is dataclasses.MISSING else field.default_factory()
        if default is not dataclasses.MISSING and _same(inside, default):
            continue
        table[field.name] = written_field(content, field.name, inside)
    return table


def _same(content: Any, default: Any) -> bool:
    return type(content) is type(default) and np.array_equal(content, default)


def written_field(owner: Any, field: str, content: Any) -> Any:
    """Return `content` as a study file writes it at the key `field`."""
    from winkler.study.language import maps, quantities

    cls = type(owner)
    if dataclasses.is_dataclass(content):
        return unbuild(content)
    if isinstance(content, Enum):
        return str(content)
    if isinstance(content, bool | str) or (isinstance(content, int) and typing.get_type_hints(cls)[field] is int):
        return content
    if (cls.__name__, field) in quantities.INDEXED:
        return {"values": [float(number) for number in content]}
    if (cls.__name__, field) in quantities.GRIDS:
        return np.asarray(content, dtype=float).tolist()
    if typing.get_type_hints(cls)[field] == tuple[int, int]:
        return list(content)
    unit = quantities.unit_in(owner, field) or ""
    if (cls.__name__, field) in maps.MAPS:
        return maps.written_map(content, unit)
    if quantities.endless(cls, field) and math.isinf(content):
        return quantities.INFINITE
    if isinstance(content, int | float):
        return written_number(float(content), unit)
    if isinstance(content, tuple) and all(dataclasses.is_dataclass(item) for item in content):
        return [unbuild(item) for item in content]
    if isinstance(content, tuple) and all(isinstance(item, tuple) for item in content):
        return dict(content)
    return written_numbers(np.asarray(content, dtype=float), unit)


def written_number(number: float, unit: str) -> Any:
    """Return one SI number as a study file writes it."""
    from winkler.values.units import format_quantity

    return format_quantity(number, unit) if unit else number


def written_numbers(numbers: np.ndarray, unit: str) -> Any:
    """Return a list of SI numbers as a study file writes it."""
    if numbers.ndim == 2:
        return [[written_number(float(number), unit) for number in row] for row in numbers]
    if numbers.ndim != 1:
        raise InvalidInput(
            f"an array of shape {numbers.shape} cannot be written in a study file; give a list, or a list of rows."
        )
    if unit and len(numbers) > MOST_LISTED:
        return {"values": [float(number) for number in numbers], "unit": unit}
    return [written_number(float(number), unit) for number in numbers]
