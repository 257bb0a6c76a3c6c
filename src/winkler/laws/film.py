"""What resists between the surfaces: a film that current tunnels through, a thermal interface."""

from __future__ import annotations

import math

from winkler.errors import InvalidInput
from winkler.given import not_negative
from winkler.values import value

__all__ = ["SurfaceFilm", "ThermalInterface"]


@value
class SurfaceFilm:
    """A thin film of equal resistance everywhere in the contact: an oxide, a tarnish, water.

    Parameters
    ----------
    area_resistance : float, optional
        Its resistance times area, sigma_f [ohm m^2], not negative; 0 (the default) for clean metals.

    Raises
    ------
    InvalidInput
        If it is negative or no number.
    """

    area_resistance: float = 0.0

    def __post_init__(self) -> None:
        not_negative("SurfaceFilm", "area_resistance", self.area_resistance, "ohm m^2")


@value
class ThermalInterface:
    """Surfaces that hold heat back where they touch.

    Parameters
    ----------
    interface_conductance : float, optional
        Heat flux per drop of temperature, h [W/(m^2 K)], positive; infinite (the default) for a perfect touch.

    Raises
    ------
    InvalidInput
        If it is not positive.
    """

    interface_conductance: float = math.inf

    def __post_init__(self) -> None:
        given = self.interface_conductance
        if isinstance(given, bool) or not isinstance(given, int | float) or not given > 0.0:
            raise InvalidInput(
                f"ThermalInterface: interface_conductance is {given!r}; give a positive number in W/(m^2 K), or "
                "infinity for a perfect touch."
            )

    @property
    def area_resistance(self) -> float:
        """1 / h [m^2 K/W]."""
        return 1.0 / self.interface_conductance
