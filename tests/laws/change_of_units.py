"""A change of the base units: every quantity of a value follows from its dimension, so that nothing else may change."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, NamedTuple

import numpy as np

from winkler.study.language.quantities import INDEXED, dependent, settled
from winkler.values.unit_grammar import unit_of
from winkler.values.vocabulary import word


class Units(NamedTuple):
    """By what numbers are multiplied.

    Parameters
    ----------
    length, stress, time, temperature, current
        Independent of each other; mass follows, and the amount of substance keeps the gas constant.
    """

    length: float = 1.0
    stress: float = 1.0
    time: float = 1.0
    temperature: float = 1.0
    current: float = 1.0

    def factor(self, unit: str) -> float:
        """Return by what a quantity of a unit is multiplied."""
        mass = self.stress * self.length * self.time**2
        base = {
            "meter": self.length,
            "second": self.time,
            "kilogram": mass,
            "kelvin": self.temperature,
            "ampere": self.current,
            "mole": mass * self.length**2 / self.time**2 / self.temperature,
            "radian": 1.0,
        }
        return math.prod(base[name] ** float(power) for name, power in unit_of(unit).dimension)

    def changed(self, content: Any) -> Any:
        """Return a value of winkler in these units."""
        if isinstance(content, tuple):
            return tuple(self.changed(item) for item in content)
        if not dataclasses.is_dataclass(content):
            return content
        new = {}
        for field in dataclasses.fields(content):
            if field.init:
                new[field.name] = self._field(content, field.name, getattr(content, field.name))
        return dataclasses.replace(content, **new)

    def _field(self, owner: Any, name: str, inside: Any) -> Any:
        cls = type(owner)
        if isinstance(inside, bool | str) or not isinstance(inside, int | float | np.ndarray | tuple):
            return self.changed(inside)
        if (cls.__name__, name) in INDEXED:
            units = INDEXED[cls.__name__, name]
            return tuple(number * self.factor(units(place)) for place, number in enumerate(inside))
        unit = word(cls, name).unit
        if name in dependent(cls):
            unit = settled(unit, cls, {item.name: getattr(owner, item.name) for item in dataclasses.fields(owner)})
        if unit is None:
            return self.changed(inside)
        factor = self.factor(unit)
        if factor == 1.0:
            return inside
        return tuple(number * factor for number in inside) if isinstance(inside, tuple) else inside * factor
