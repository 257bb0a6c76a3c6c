r"""Laws of dry friction: the traction at which two surfaces slide.

Coulomb: :math:`|\tau|\le\mu p` wherever the surfaces touch, and equality against the motion where they slide.  A point
that has not slid yet may bear more than one that slides (static and kinetic friction).
"""

from __future__ import annotations

import math
from typing import Annotated, TypeAlias

from winkler.values.checks.field_checks import Condition
from winkler.values.checks.number_checks import Number, PositiveNotTiny
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words


@value
class Coulomb:
    """Friction proportional to pressure.

    Parameters
    ----------
    coefficient : float
        Friction coefficient mu [-], not negative; infinite if slip is excluded.

    Raises
    ------
    InvalidInput
        If it is negative or no number.
    """

    __words__ = words(coefficient=(r"\mu", "", "friction coefficient"))

    coefficient: Annotated[float, Number("give zero or a positive number, or infinity if nothing may slide", 0.0)]


Sliding: TypeAlias = Annotated[
    Coulomb,
    Condition(
        lambda law: 0.0 < law.coefficient < math.inf,
        "give Coulomb(coefficient) with a positive, finite coefficient: there is friction, and it is overcome",
    ),
]
"""Coulomb's law of surfaces that rub."""


Overcome: TypeAlias = Annotated[
    Coulomb, Condition(lambda law: law.coefficient < math.inf, "give Coulomb(coefficient) with a finite coefficient")
]
"""Coulomb's law of surfaces that may be free of friction."""


@value
class StaticKinetic:
    """Friction that drops at the onset of slip, and recovers when a point sticks again.

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

    __words__ = words(
        static_coefficient=(r"\mu_s", "", "friction coefficient of points that stick"),
        kinetic_coefficient=(r"\mu_k", "", "friction coefficient of points that slide"),
    )

    static_coefficient: PositiveNotTiny
    kinetic_coefficient: PositiveNotTiny

    def __post_init__(self) -> None:
        if self.static_coefficient < self.kinetic_coefficient:
            raise InvalidInput(
                f"StaticKinetic: the kinetic coefficient {self.kinetic_coefficient:g} is above the static one, "
                f"{self.static_coefficient:g}; sliding cannot bear more than sticking: give a smaller one."
            )


Friction = Coulomb | StaticKinetic
"""How surfaces may rub."""
