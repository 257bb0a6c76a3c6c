"""Loads that a problem takes one of, not an array: types of its fields."""

from __future__ import annotations

import math
from typing import Annotated, TypeAlias

import numpy as np

from winkler.field_checks import Such
from winkler.loading import Depth, Force, Lateral, Load, Normal, Radius, ShearForce, Shift
from winkler.numerics.types import Quantity
from winkler.path import numbers_of

__all__ = ["OneLoad", "OneNormal", "OnePositiveNormal", "OnePositiveSwing", "Swing", "load_number"]


def load_number(load: Load) -> Quantity:
    """Return what a load prescribes."""
    match load:
        case Depth(number) | Force(number) | Radius(number):
            return number


def _one(load: Normal | Lateral | Radius) -> bool:
    return np.ndim(load.radius if isinstance(load, Radius) else numbers_of(load)) == 0


def _positive(load: Normal | Lateral) -> bool:
    return _one(load) and 0.0 < float(numbers_of(load)) < math.inf


OneLoad: TypeAlias = Annotated[Load, Such(_one, "give Force, Depth or Radius with one number, and sweep over several")]
OneNormal: TypeAlias = Annotated[
    Normal, Such(_one, "give Depth(d) or Force(F) with one number, and sweep over several")
]
OnePositiveNormal: TypeAlias = Annotated[
    Normal, Such(_positive, "give Depth(d) or Force(F) with one positive number, and sweep over several")
]
Swing: TypeAlias = Annotated[
    Shift | ShearForce,
    Such(
        lambda load: bool(np.all(numbers_of(load) >= 0.0)),
        "give Shift(U) in m or ShearForce(F_x) in N, how far to each side, zero or more",
    ),
]
OnePositiveSwing: TypeAlias = Annotated[
    Shift | ShearForce,
    Such(_positive, "give Shift(U) in m or ShearForce(F_x) in N with one positive number, how far to each side"),
]
