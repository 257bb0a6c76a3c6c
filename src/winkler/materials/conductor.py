r"""Conductors: solids with an electric resistivity, or with a thermal conductivity."""

from __future__ import annotations

import math

from winkler.values.checks.number_checks import POSITIVE, NonNegative, Positive, PositiveOrInfinite, checked
from winkler.values.value import value


@value
class ElectricalConductor:
    r"""An electrical conductor with the resistivity :math:`\rho(T)=\rho_0\,(1+\alpha\,(T-T_0))`.

    Parameters
    ----------
    resistivity : float
        rho_0 [ohm m], positive; at the temperature of the body away from the contact, T_0.
    temperature_coefficient : float, optional
        alpha [1/K], not negative, relative to that temperature; 0 (the default) for a resistivity that does not change.

    Raises
    ------
    InvalidInput
        If a number is outside its range.

    Examples
    --------
    >>> silver = ElectricalConductor(resistivity=15.9e-9, temperature_coefficient=3.8e-3)
    >>> round(silver.resistivity_above(100.0) * 1e9, 3)
    21.942
    """

    resistivity: Positive
    temperature_coefficient: NonNegative = 0.0

    def resistivity_above(self, rise: float) -> float:
        """Return rho [ohm m] at `rise` [K] above the temperature of the body."""
        return self.resistivity * (1.0 + self.temperature_coefficient * rise)


@value
class ThermalConductor:
    """A solid that conducts heat.

    Parameters
    ----------
    conductivity : float
        Thermal conductivity [W/(m K)], positive.
    diffusivity : float, optional
        Thermal diffusivity [m^2/s], conductivity over heat capacity per volume, positive. If it is not known it is
        infinite (default): no heat capacity.  Steady conduction at rest does not depend on it. Frictional heating needs
        it for moving bodies, and for all bodies in transient heating.

    Raises
    ------
    InvalidInput
        If a number is not positive.

    Examples
    --------
    >>> steel = ThermalConductor.of(conductivity=45.0, density=7850.0, heat_capacity=470.0)
    >>> round(steel.diffusivity * 1e6, 3)
    12.197
    """

    conductivity: Positive
    diffusivity: PositiveOrInfinite = math.inf

    @classmethod
    def of(cls, conductivity: float, density: float, heat_capacity: float) -> ThermalConductor:
        """Return the conductor of a conductivity [W/(m K)], a density [kg/m^3] and a heat capacity [J/(kg K)].

        Raises
        ------
        InvalidInput
            If a number is not positive.
        """
        for word, number, unit in (
            ("conductivity", conductivity, "W/(m K)"),
            ("density", density, "kg/m^3"),
            ("heat_capacity", heat_capacity, "J/(kg K)"),
        ):
            checked(POSITIVE, "ThermalConductor", word, number, unit)
        return cls(conductivity, conductivity / (density * heat_capacity))
