"""A second reading of a study's text, in the public names of Python; it shares no code with the package's reader.

Numbers are multiplied by their units as fractions, and rounded once, as those of a script are: `0.05 mm` is `0.05e-3`.
"""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np

import winkler as wk

UNITS = {
    **dict.fromkeys(("m", "s", "K", "N", "J", "W", "V", "A", "Pa", "Hz", "rad", "ohm", "mol"), Fraction(1)),
    "g": Fraction(1, 1000),
}
PREFIXES = {"n": -9, "u": -6, "m": -3, "k": 3, "M": 6, "G": 9}
PLURAL = {"creepages": "Creepage", "creep_forces": "CreepForce", "height_map": "Topography"}
"""Kinds that are not called as their class; the name of each other one is that of its class, in small letters."""


def factor(unit: str) -> Fraction:
    """Return how many SI units a unit such as ``mm^3/(N m)`` is."""
    above, _, below = unit.partition("/")
    result = Fraction(1)
    for side, sign in ((above, 1), (below, -1)):
        for name, power in re.findall(r"([A-Za-z]+)(?:\^(-?[\d.]+))?", side):
            known = name in UNITS
            one = UNITS[name] if known else Fraction(10) ** PREFIXES[name[0]] * UNITS[name[1:]]
            result *= one if one == 1 else one ** (sign * int(power or 1))
    return result


def number(given: str | float, unit: str = "") -> float:
    """Return the SI number of a quantity, or of a number in a unit that stands beside it."""
    digits, _, own = str(given).partition(" ")
    unit = own or unit
    if unit == "deg":
        return math.radians(float(digits))
    if unit == "degC":
        return float(Fraction(digits) + Fraction("273.15"))
    return float(Fraction(digits) * factor(unit))


def read(given: Any, key: str = "") -> Any:
    """Return what stands at a key of a study."""
    if isinstance(given, list):
        items = [read(item) for item in given]
        return np.concatenate(items) if any(isinstance(item, np.ndarray) for item in items) else items
    if isinstance(given, str):
        return number(given) if re.match(r"-?\d", given) and key != "expression" else given
    if not isinstance(given, dict):
        return given
    if "kind" in given:
        name = given["kind"]
        others = {at: read(item, at) for at, item in given.items() if at != "kind"}
        make = getattr(wk, PLURAL.get(name) or "".join(part.capitalize() for part in name.split("_")))
        return make(**others.pop("constants", {}), **others)
    if "values" in given:
        return [number(item, given.get("unit", "")) for item in given["values"]]
    if "from" in given:
        spaced: Callable[..., Any] = np.geomspace if given.get("spacing") == "log" else np.linspace
        return spaced(number(given["from"]), number(given["to"]), given["count"])
    return {name: number(item) for name, item in given.items()}


def problem_of(text: str) -> Any:
    """Return the problem of a study file."""
    return read(tomllib.loads(text)["problem"])
