"""How two bodies share the heat of their friction.

Temperatures agree wherever two bodies touch, but the steady field of a body at rest and that of one that moves past
are no multiples of each other: one share of the heat for the whole contact can only make one number of both agree.
"""

from __future__ import annotations

from winkler.errors import InvalidInput
from winkler.values import value

__all__ = ["EqualMaximum", "EqualMean", "FixedShare", "HeatPartition"]


@value
class EqualMaximum:
    """Both bodies reach the same greatest temperature: Blok's rule."""


@value
class EqualMean:
    """Both bodies have the same mean temperature over the contact: Jaeger's rule."""


@value
class FixedShare:
    """The first body takes a given part of the heat.

    Parameters
    ----------
    first_share : float
        From 0 to 1 [-]; 1 if the second body is an insulator.

    Raises
    ------
    InvalidInput
        If it is outside that range.
    """

    first_share: float

    def __post_init__(self) -> None:
        given = self.first_share
        if isinstance(given, bool) or not isinstance(given, int | float) or not 0.0 <= given <= 1.0:
            raise InvalidInput(f"FixedShare: first_share is {given!r}; give a number from 0 to 1.")


HeatPartition = EqualMaximum | EqualMean | FixedShare
"""How the heat may be shared."""
