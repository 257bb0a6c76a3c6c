"""The numbers of a load that presses a line contact together."""

from __future__ import annotations

import numpy as np

from winkler.loading.loads import HalfWidth, LineForce, MeanPressure, NominalPressure
from winkler.numerics.types import Array, Quantity
from winkler.values.errors import OutsideValidity

__all__ = ["PressingLoad", "given_by", "pressing"]

PressingLoad = LineForce | HalfWidth | MeanPressure | NominalPressure


def given_by(load: PressingLoad) -> Quantity:
    """Return the numbers of a load, in the shape in which they were given."""
    match load:
        case LineForce(given) | HalfWidth(given) | MeanPressure(given) | NominalPressure(given):
            return given


def pressing(owner: str, load: PressingLoad) -> Array:
    """Return the numbers of a load in a row ``(m,)``; refuse tensile ones.

    Raises
    ------
    OutsideValidity
        If a number is negative; `owner` begins the sentence.
    """
    row = np.ravel(np.asarray(given_by(load), dtype=float))
    if np.any(row < 0.0):
        raise OutsideValidity(
            f"{owner}: the load {float(np.min(row)):.6g} is tensile; without adhesion bodies can only be pressed "
            "together: give zero or more."
        )
    return row
