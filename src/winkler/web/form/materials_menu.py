"""Materials of the table for a body: which have the numbers that it needs, what they are, and where they stand."""

from __future__ import annotations

import dataclasses
import functools
import math
from typing import Any, NamedTuple

from winkler.materials.named import TabulatedProperty, material, material_names
from winkler.plot.series import name_in_words
from winkler.study.language.catalogue import kinds
from winkler.study.language.explain import keys_of
from winkler.values.errors import InvalidInput
from winkler.values.readable import with_unit
from winkler.values.units import format_quantity
from winkler.values.vocabulary import GLOSSARY

NAMED = "named_"
"""Beginning of the kinds of bodies that the table of materials gives the numbers of."""
TABULATED = {
    "elastic": ("young", "poisson", "strength"),
    "electrical_conductor": ("resistivity", "temperature_coefficient"),
    "thermal_conductor": ("conductivity", "density", "heat_capacity"),
}
"""Kind with numbers -> quantities of the table that it is made of."""


class MaterialLine(NamedTuple):
    """One number of a material: its name in words, itself with its unit, and its source."""

    name: str
    number: str
    source: str


@functools.cache
def tabulated(kind: str) -> dict[str, str]:
    """Return the materials that can be a body of a kind -> their most telling numbers.

    Examples
    --------
    >>> tabulated("named_elastic")["tungsten"]
    '411 GPa, 0.28'
    """
    result = {}
    for name in material_names():
        try:
            kinds()[kind].cls(name)
        except InvalidInput:  # a number that this kind needs is not in the table
            continue
        result[name] = ", ".join(line.number for line in material_lines(kind, name)[:2])
    return result


def material_lines(kind: str, name: str) -> tuple[MaterialLine, ...]:
    """Return the numbers of a material that a body of a kind is made of; none for an unknown name."""
    try:
        found = material(name)
    except InvalidInput:
        return ()
    known = {figure.quantity: figure for figure in found.figures}
    wanted = TABULATED[kind.removeprefix(NAMED)]
    return tuple(_line(known[quantity]) for quantity in wanted if quantity in known)


def _line(figure: TabulatedProperty) -> MaterialLine:
    number = with_unit(figure.number, GLOSSARY[figure.quantity].unit)
    return MaterialLine(name_in_words(figure.quantity), number, figure.source)


def material_numbers(kind: str, name: str) -> dict[str, Any]:
    """Return the keys of a body of a kind with the numbers of a material, to be changed; none for an unknown name.

    Examples
    --------
    >>> material_numbers("elastic", "fused silica")
    {'young': '73 GPa', 'poisson': 0.17}
    """
    try:
        body = kinds()[f"{NAMED}{kind}"].cls(name)
    except InvalidInput:
        return {}
    defaults = {field.name: field.default for field in dataclasses.fields(kinds()[kind].cls)}
    result: dict[str, Any] = {}
    for key in keys_of(kind):
        number = getattr(body, key.name)
        if number != defaults[key.name] and math.isfinite(number):
            result[key.name] = format_quantity(number, key.word.unit or "") if "quantity" in key.takes else number
    return result
