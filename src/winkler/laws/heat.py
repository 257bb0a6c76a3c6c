"""Partition of the heat of friction between two bodies.

Temperatures agree wherever two bodies touch, but the steady field of a body at rest and that of one that moves past
are no multiples of each other: one share of the heat for the whole contact can only make one number of both agree.
"""

from __future__ import annotations

from winkler.values.checks.number_checks import Fraction
from winkler.values.value import value


@value
class EqualMaximum:
    """Heat partition with equal maximum temperatures of both bodies (Blok's rule)."""


@value
class EqualMean:
    """Heat partition with equal mean temperatures of both bodies over the contact (Jaeger's rule)."""


@value
class FixedShare:
    """A heat partition with a given share of the first body.

    Parameters
    ----------
    first_share : float
        From 0 to 1 [-]; 1 if the second body is an insulator.

    Raises
    ------
    InvalidInput
        If it is outside that range.
    """

    first_share: Fraction


HeatPartition = EqualMaximum | EqualMean | FixedShare
"""How the heat may be shared."""
