"""The numbers of a load that presses a line contact together, and the mean pressure that it makes."""

from __future__ import annotations

import numpy as np

from winkler.loading.loads import HalfWidth, LineForce, MeanPressure, NominalPressure
from winkler.numerics.types import Array, PerLoad, Q, Quantity, shaped
from winkler.values.errors import OutsideValidity

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


class OfWidth(PerLoad[Q]):
    """The part of a solution that force and half-width of a strip determine."""

    force_per_length: Q
    half_width: Q

    @property
    def mean_pressure(self) -> Q:
        """P / (2 a) [Pa], negative where the contact is pulled; zero without contact."""
        width = 2.0 * np.asarray(self.half_width)
        return shaped(np.asarray(self.force_per_length) / np.where(width > 0.0, width, 1.0))
