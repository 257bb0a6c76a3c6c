r"""Dry friction: how much traction two surfaces bear before they slide.

Coulomb: :math:`|\tau|\le\mu p` wherever the surfaces touch, and equality against the motion where they slide.  A point
that has not slid yet may bear more than one that slides (static and kinetic friction).
"""

from __future__ import annotations

import math

from winkler.errors import InvalidInput
from winkler.values import value

__all__ = ["Coulomb", "Friction", "StaticKinetic"]

SMALLEST = 1e-60
"""Of the coefficients of which one is divided by the other."""


@value
class Coulomb:
    """Friction in proportion to pressure.

    Parameters
    ----------
    coefficient : float
        Friction coefficient mu [-], not negative; infinite if nothing ever slides.

    Raises
    ------
    InvalidInput
        If it is negative or no number.
    """

    coefficient: float

    def __post_init__(self) -> None:
        mu = self.coefficient
        if isinstance(mu, bool) or not isinstance(mu, int | float) or not mu >= 0.0:
            raise InvalidInput(
                f"Coulomb: the friction coefficient is {mu!r}; give zero or a positive number, or infinity if nothing "
                "may slide."
            )


@value
class StaticKinetic:
    """Friction that drops once a point has begun to slide, and recovers when it sticks again.

    Parameters
    ----------
    static_coefficient : float
        Friction coefficient of points that stick [-], not below the kinetic one, finite.
    kinetic_coefficient : float
        Friction coefficient of points that slide [-], from 1e-60 on.

    Raises
    ------
    InvalidInput
        If a coefficient is below 1e-60 or not finite, or the kinetic one is the greater.
    """

    static_coefficient: float
    kinetic_coefficient: float

    def __post_init__(self) -> None:
        both = self.static_coefficient, self.kinetic_coefficient
        for mu in both:
            if isinstance(mu, bool) or not isinstance(mu, int | float) or not SMALLEST <= mu < math.inf:
                raise InvalidInput(
                    f"StaticKinetic: a friction coefficient is {mu!r}; give two positive, finite numbers, from "
                    f"{SMALLEST:g} on."
                )
        if both[0] < both[1]:
            raise InvalidInput(
                f"StaticKinetic: the kinetic coefficient {both[1]:g} is above the static one, {both[0]:g}; sliding "
                "cannot bear more than sticking: give a smaller one."
            )


Friction = Coulomb | StaticKinetic
"""How surfaces may rub."""
