"""How values of a study are written, as parts of a JSON schema for editors.

An editor knows no dimensions: the pattern of a quantity refuses a bare number and each symbol of the table of units
that has another dimension (``"10 kg"`` for a length).  Products of units are left to the reader of studies.  The
patterns are tested to take what that reader takes.
"""

from __future__ import annotations

import functools
import math
import re
from collections.abc import Callable
from typing import Annotated, Any

from pydantic import BeforeValidator

from winkler.study.language.quantities import INFINITE, RANGE_KEYS, sample
from winkler.values.checks.number_checks import Number
from winkler.values.unit_grammar import PREFIXED_UNITS, PREFIXES, SCALE_ZEROS, UNPREFIXED_UNITS, si_unit, unit_of
from winkler.values.units import is_fixed

Form = dict[str, Any]
"""A part of a JSON schema."""

KINDS = "kinds"
"""Key that stands for references to the forms of these kinds, which the whole schema defines."""

SHARED = "shared"
"""Key that holds the name of a form which stands once in the whole schema, to be referred to."""

SIGN, NUMBER = r"[+\-−]?", r"(?:\d+\.?\d*|\.\d+)(?:[eE][+\-]?\d+)?"


class _Written:
    """Marks how a value is written; made into JSON schema only if that is asked for."""

    def __init__(self, form: Callable[[], Form]) -> None:
        self.form = form

    def __get_pydantic_json_schema__(self, core: Any, handler: Any) -> Form:
        return self.form()


def checked(convert: Callable[[Any], Any], form: Callable[[], Form]) -> Any:
    """Return the annotation of a key that `convert` checks, and that is written as `form` says."""
    return Annotated[Any, BeforeValidator(convert), _Written(form)]


def of_kinds(names: tuple[str, ...]) -> Form:
    """Return the form of a table of one of these kinds."""
    return {KINDS: list(names)}


@functools.cache
def _others(unit: str) -> str:
    """Return a pattern of the symbols of the table of units that do not have the dimension of `unit`."""
    own = unit_of(unit).dimension
    plain = [name for name in (*UNPREFIXED_UNITS, *SCALE_ZEROS) if _dimension(name) != own]
    prefixed = [name for name in PREFIXED_UNITS if _dimension(name) != own]
    return "|".join([*plain, f"[{''.join(PREFIXES)}]?(?:{'|'.join(prefixed)})"])


def _dimension(name: str) -> Any:
    known = si_unit(name)
    return known and known.dimension


def _in_words(what: str, unit: str | None) -> str:
    """Return a name without signs for a form of numbers in a unit."""
    per = (unit or "").replace("/", " per ")
    return re.sub(
        r"\W+", "_", f"{what} in {per}" if per else f"{what} open" if unit is None else f"{what} plain"
    ).strip("_")


def quantity(unit: str | None, *, within: Number | None = None) -> Form:
    """Return the form of one number with its unit; a unit that depends on other keys is left open.

    Parameters
    ----------
    unit
        An SI unit, empty for a plain number; None if it is no quantity.
    within
        The numbers that are allowed, if the class says so; of quantities the sign alone is marked.
    """
    positive = within is not None and within.least >= 0.0 and not within.admits(0.0)
    number = (r"\+?" if positive else SIGN) + NUMBER
    if unit is None or not is_fixed(unit):
        form: Form = {"type": ["string", "number"]}
    elif not unit_of(unit).dimension:
        text = {"type": "string", "pattern": rf"^\s*{number}\s*(?!(?:{_others(unit)})\s*$)(?:[^\s\d.,].*)?$"}
        form = {"anyOf": [{"type": "number", **_bounds(within)}, text]}
    else:
        form = {
            SHARED: _in_words("positive" if positive else "quantity", unit),
            "type": "string",
            "pattern": rf"^\s*{number}\s*(?!(?:{_others(unit)})\s*$)(?:1\s*/|[^\s\d.,]).*$",
            "examples": [sample(unit)],
        }
    endless = within is not None and within.admits(math.inf)
    return {"anyOf": [form, {"const": INFINITE}]} if endless else form


def _bounds(within: Number | None) -> Form:
    """Return the bounds of a plain number."""
    if within is None:
        return {}
    ends = {"inimum": within.least, "aximum": within.most}
    return {
        f"exclusiveM{end}" if number in within.excluded else f"m{end}": number
        for end, number in ends.items()
        if math.isfinite(number)
    }


def several(unit: str | None) -> Form:
    """Return the form of numbers: a list of quantities and ranges, a range, or plain numbers with one unit."""
    one = quantity(unit)
    spread = {
        "type": "object",
        "properties": {
            "from": one,
            "to": one,
            "count": {"type": "integer", "minimum": 1, "maximum": 1_000_000},
            "spacing": {"enum": ["linear", "log"]},
        },
        "required": list(RANGE_KEYS[:3]),
        "additionalProperties": False,
    }
    values = {
        "type": "object",
        "properties": {"values": {"type": "array", "minItems": 1}, "unit": {"type": "string"}},
        "required": ["values"],
        "additionalProperties": False,
    }
    listed = {"type": "array", "minItems": 1, "items": {"anyOf": [one, spread]}}
    return {SHARED: _in_words("quantities", unit), "anyOf": [listed, spread, values]}


def one_or_many(unit: str | None) -> Form:
    """Return the form of one quantity, of several, or of rows of them."""
    rows = {"type": "array", "minItems": 1, "items": {"type": "array", "minItems": 1, "items": quantity(unit)}}
    return {SHARED: _in_words("one or more", unit), "anyOf": [quantity(unit), several(unit), rows]}


def height_map(unit: str | None) -> Form:
    """Return the form of a map: rows of quantities, rows of numbers with one unit, or packed."""
    rows = {"type": "array", "items": {"type": "array", "items": quantity(unit)}}
    packed = {"type": "object", "required": ["packed", "shape"]}
    return {"anyOf": [rows, packed, {"type": "object", "required": ["values"]}]}


def pair(unit: str | None) -> Form:
    """Return the form of two quantities, of which one stands for both."""
    return one_or_many(unit)


def counts() -> Form:
    """Return the form of two whole numbers."""
    return {"type": "array", "minItems": 2, "maxItems": 2, "items": {"type": "integer", "minimum": 1}}


def grid() -> Form:
    """Return the form of a table of plain numbers, row by row."""
    return {"type": "array", "minItems": 1, "items": {"type": "array", "minItems": 1, "items": quantity("")}}


def indexed() -> Form:
    """Return the form of a list in which each quantity has a unit of its own."""
    return {"anyOf": [{"type": "array", "minItems": 1}, {"type": "object", "required": ["values"]}]}


def named() -> Form:
    """Return the form of a table of named constants of any dimension."""
    return {"type": "object", "additionalProperties": {"type": ["string", "number"]}}


def places() -> Form:
    """Return the form of places: lengths, or multiples of the contact radius, written with the unit ``a``."""
    return one_or_many(None)


def texts() -> Form:
    """Return the form of a list of texts."""
    return {"type": "array", "items": {"type": "string"}}
