r"""Laws of dry friction whose coefficient falls with the slip, or with its velocity.

Slip weakening (Ida; Palmer and Rice): the coefficient falls from the static to the kinetic one over a distance of slip
D, along which a point has slipped since the beginning, to and fro alike,

.. math:: \mu = \mu_s-(\mu_s-\mu_k)\min(s/D, 1) \quad\text{or}\quad \mu = \mu_k+(\mu_s-\mu_k)\,e^{-s/D} .

Falling friction (Polach): it depends on the velocity of slip at present,
:math:`\mu = \mu_k+(\mu_s-\mu_k)\,e^{-v/v_0}`.
"""

from __future__ import annotations

import math
from typing import Annotated, TypeAlias

import numpy as np

from winkler.laws.friction import Coulomb
from winkler.numerics.types import Array
from winkler.values.checks.field_checks import Condition
from winkler.values.checks.number_checks import Positive, PositiveNotTiny
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

STATIC_WORD = (r"\mu_s", "", "friction coefficient of points that have not slipped")
KINETIC_WORD = (r"\mu_k", "", "friction coefficient after much slip")
DISTANCE_WORD = ("D", "m", "slip over which the friction coefficient falls")


def _refuse_rising(who: str, static: float, kinetic: float) -> None:
    if static < kinetic:
        raise InvalidInput(
            f"{who}: the kinetic coefficient {kinetic:g} is above the static one, {static:g}; friction falls with "
            "slip: give a smaller one."
        )


@value
class LinearSlipWeakening:
    """Friction that decreases linearly with the slip distance to a constant value.

    The slip distance accumulates in both directions. It is kept when a point sticks again or the surfaces separate.

    Parameters
    ----------
    static_coefficient : float
        Friction coefficient mu_s of points that have not slipped [-], not below the kinetic one.
    kinetic_coefficient : float
        Friction coefficient mu_k at and beyond the slip distance [-], at least 1e-60.
    distance : float
        Slip distance D over which the coefficient falls [m], positive.

    Raises
    ------
    InvalidInput
        If a number is out of its range, or the kinetic coefficient is the greater.

    References
    ----------
    Y. Ida, J. Geophys. Res. 77 (1972) 3796-3805, doi:10.1029/JB077i020p03796

    Examples
    --------
    >>> law = LinearSlipWeakening(0.6, 0.4, distance=10e-6)
    >>> law.after_slip(np.array([0.0, 5e-6, 20e-6])).round(3).tolist()
    [0.6, 0.5, 0.4]
    """

    __words__ = words(static_coefficient=STATIC_WORD, kinetic_coefficient=KINETIC_WORD, distance=DISTANCE_WORD)

    static_coefficient: PositiveNotTiny
    kinetic_coefficient: PositiveNotTiny
    distance: Positive

    def __post_init__(self) -> None:
        _refuse_rising("LinearSlipWeakening", self.static_coefficient, self.kinetic_coefficient)

    def after_slip(self, slip: Array) -> Array:
        """Return mu [-] after some slip [m]."""
        return np.asarray(self.static_coefficient - self._drop * np.minimum(slip / self.distance, 1.0))

    def fall(self, slip: Array) -> Array:
        """Return the decrease of mu per slip distance [1/m]."""
        return np.asarray(np.where(slip < self.distance, self._drop / self.distance, 0.0))

    def lost(self, slip: Array) -> Array:
        """Return the integral of mu over the slip [m]: the dissipated energy per area, over the pressure."""
        part = np.minimum(slip, self.distance)
        fallen = 0.5 * part * part / self.distance + (slip - part)
        return np.asarray(self.static_coefficient * slip - self._drop * fallen)

    @property
    def _drop(self) -> float:
        return self.static_coefficient - self.kinetic_coefficient


@value
class ExponentialSlipWeakening:
    """Friction that decreases exponentially with the slip distance.

    The slip distance accumulates in both directions. It is kept when a point sticks again or the surfaces separate.

    Parameters
    ----------
    static_coefficient : float
        Friction coefficient mu_s of points that have not slipped [-], not below the kinetic one.
    kinetic_coefficient : float
        Friction coefficient mu_k after much slip [-], at least 1e-60.
    distance : float
        Slip D [m] after which the difference from mu_k has fallen to 1/e, positive.

    Raises
    ------
    InvalidInput
        If a number is out of its range, or the kinetic coefficient is the greater.

    References
    ----------
    A. C. Palmer, J. R. Rice, Proc. R. Soc. Lond. A 332 (1973) 527-548, doi:10.1098/rspa.1973.0040

    Examples
    --------
    >>> law = ExponentialSlipWeakening(0.6, 0.4, distance=10e-6)
    >>> law.after_slip(np.array([0.0, 10e-6, 1e-3])).round(3).tolist()
    [0.6, 0.474, 0.4]
    """

    __words__ = words(static_coefficient=STATIC_WORD, kinetic_coefficient=KINETIC_WORD, distance=DISTANCE_WORD)

    static_coefficient: PositiveNotTiny
    kinetic_coefficient: PositiveNotTiny
    distance: Positive

    def __post_init__(self) -> None:
        _refuse_rising("ExponentialSlipWeakening", self.static_coefficient, self.kinetic_coefficient)

    def after_slip(self, slip: Array) -> Array:
        """Return mu [-] after some slip [m]."""
        return self.kinetic_coefficient + self._drop * np.exp(-slip / self.distance)

    def fall(self, slip: Array) -> Array:
        """Return the decrease of mu per slip distance [1/m]."""
        return self._drop / self.distance * np.exp(-slip / self.distance)

    def lost(self, slip: Array) -> Array:
        """Return the integral of mu over the slip [m]: the dissipated energy per area, over the pressure."""
        return self.kinetic_coefficient * slip - self._drop * self.distance * np.expm1(-slip / self.distance)

    @property
    def _drop(self) -> float:
        return self.static_coefficient - self.kinetic_coefficient


@value
class FallingFriction:
    """Friction that decreases with the slip velocity.

    Parameters
    ----------
    static_coefficient : float
        Friction coefficient mu_s of slow slip [-], not below the kinetic one.
    kinetic_coefficient : float
        Friction coefficient mu_k of fast slip [-], at least 1e-60.
    velocity : float
        Slip velocity v_0 [m/s] at which the difference from mu_k has fallen to 1/e, positive.

    Raises
    ------
    InvalidInput
        If a number is out of its range, or the kinetic coefficient is the greater.

    References
    ----------
    O. Polach, Wear 258 (2005) 992-1000, doi:10.1016/j.wear.2004.03.046

    Examples
    --------
    Polach's friction of a locomotive on a wet rail, mu_0 ((1 - A) exp(-B v) + A):

    >>> wet = FallingFriction(0.30, 0.40 * 0.30, velocity=1 / 0.20)
    >>> wet.at_velocity(np.array([0.0, 1.0, 100.0])).round(3).tolist()
    [0.3, 0.267, 0.12]
    """

    __words__ = words(
        static_coefficient=(r"\mu_s", "", "friction coefficient of slow slip"),
        kinetic_coefficient=(r"\mu_k", "", "friction coefficient of fast slip"),
        velocity=("v_0", "m/s", "slip velocity over which the friction coefficient falls"),
    )

    static_coefficient: PositiveNotTiny
    kinetic_coefficient: PositiveNotTiny
    velocity: Positive

    def __post_init__(self) -> None:
        _refuse_rising("FallingFriction", self.static_coefficient, self.kinetic_coefficient)

    def at_velocity(self, velocity: Array) -> Array:
        """Return mu [-] at a slip velocity [m/s]."""
        drop = self.static_coefficient - self.kinetic_coefficient
        return self.kinetic_coefficient + drop * np.exp(-velocity / self.velocity)

    def fall(self, velocity: Array) -> Array:
        """Return the decrease of mu per slip velocity [s/m]."""
        return (self.static_coefficient - self.kinetic_coefficient) / self.velocity * np.exp(-velocity / self.velocity)


SlipWeakening: TypeAlias = LinearSlipWeakening | ExponentialSlipWeakening
"""Friction that falls with slip."""


def _finite(law: Coulomb | SlipWeakening | FallingFriction) -> bool:
    return not isinstance(law, Coulomb) or 0.0 < law.coefficient < math.inf


Slipped: TypeAlias = Annotated[
    Coulomb | LinearSlipWeakening | ExponentialSlipWeakening,
    Condition(
        _finite,
        "give Coulomb(coefficient) with a positive, finite coefficient, or a LinearSlipWeakening or "
        "ExponentialSlipWeakening, whose coefficient falls over a distance",
    ),
]
"""Friction of surfaces that slip, of Coulomb or weakened by slip."""


Rolled: TypeAlias = Annotated[
    Coulomb | FallingFriction,
    Condition(
        _finite,
        "give Coulomb(coefficient) with a positive, finite coefficient, or FallingFriction, whose coefficient falls "
        "with the velocity of slip",
    ),
]
"""Friction of surfaces that roll steadily, of Coulomb or falling with the velocity of slip."""


def greatest_coefficient(law: Coulomb | SlipWeakening | FallingFriction) -> float:
    """Return the coefficient where nothing has slipped, or slips [-]."""
    return law.coefficient if isinstance(law, Coulomb) else law.static_coefficient
