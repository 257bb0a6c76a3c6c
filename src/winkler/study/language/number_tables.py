"""Tables of numbers in a study file: columns with a unit of their own each, rows of one length, named constants."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.numerics.types import Array
from winkler.study.language.quantities import WHERE, check_keys, inside, wrong
from winkler.units import to_si

__all__ = ["grid", "indexed", "named"]


def indexed(raw: Any, units: Callable[[int], str]) -> Array:
    """Return a list of quantities where each has its own unit, ``units(place)``."""
    if isinstance(raw, dict):
        check_keys(raw, ("values", "unit"), ("values",), "a table of values")
        raw = raw["values"]
        if isinstance(raw, list) and all(isinstance(item, int | float) and not isinstance(item, bool) for item in raw):
            return np.array(raw, dtype=float)
    if not isinstance(raw, list) or not raw:
        wrong(f"{WHERE} is {raw!r}; give a list with at least one quantity.")
    return np.array([inside(item, units(place), f"[{place}]") for place, item in enumerate(raw)], dtype=float)


def grid(raw: Any) -> Array:
    """Return a table of plain numbers, given row by row in rows of one length."""
    rows = raw if isinstance(raw, list) else []
    if not rows or not all(isinstance(row, list) and row and len(row) == len(rows[0]) for row in rows):
        wrong(f"{WHERE} is no table of numbers; give rows of one length, such as [[0.1, 0.2], [0.3, 0.4]].")
    return np.array([[inside(item, "", f"[{i}][{j}]") for j, item in enumerate(row)] for i, row in enumerate(rows)])


def named(raw: Any) -> tuple[tuple[str, float], ...]:
    """Return a table of named constants, each a number or a quantity of any dimension, in SI units."""
    if not isinstance(raw, dict):
        wrong(f'{WHERE} is {raw!r}; give a table of named constants, such as {{ R = "10 mm" }}.')
    constants = []
    for name, item in raw.items():
        if isinstance(item, str):
            try:
                constants.append((name, to_si(item, what=f"{WHERE}.{name}")))
            except InvalidInput as error:
                wrong(str(error))
        else:
            constants.append((name, inside(item, "", f".{name}")))
    return tuple(constants)
