"""Resistance between the surfaces: a film for electric current, an interface for heat."""

from __future__ import annotations

import math
from typing import Annotated

from winkler.values.checks.number_checks import POSITIVE_OR_INFINITE, NonNegative
from winkler.values.value import value, words


@value
class SurfaceFilm:
    """A thin film of uniform resistance over the contact: an oxide, a tarnish film, water.

    Parameters
    ----------
    area_resistance : float, optional
        Its resistance times area, sigma_f [ohm m^2], not negative; 0 (the default) for clean metals.

    Raises
    ------
    InvalidInput
        If it is negative or no number.
    """

    area_resistance: NonNegative = 0.0


CONDUCTANCE_RANGE = POSITIVE_OR_INFINITE._replace(
    demand="give a positive number{unit}, or infinity for a perfect touch"
)


@value
class ThermalInterface:
    """A thermal resistance of the surfaces in contact.

    Parameters
    ----------
    interface_conductance : float, optional
        Heat flux per temperature drop, h [W/(m^2 K)], positive; infinite (the default) for perfect thermal contact.

    Raises
    ------
    InvalidInput
        If it is not positive.
    """

    __words__ = words(area_resistance=("1/h", "m^2 K/W", "temperature drop per heat flux"))

    interface_conductance: Annotated[float, CONDUCTANCE_RANGE] = math.inf

    @property
    def area_resistance(self) -> float:
        """1 / h [m^2 K/W]."""
        return 1.0 / self.interface_conductance
