"""What every problem of frictional heating refuses."""

from __future__ import annotations

from winkler.errors import InvalidInput
from winkler.materials.conductor import ThermalConductor
from winkler.media.conduction.conductors import HeatConductors

__all__ = ["thick_bodies"]


def thick_bodies(owner: str, conductors: HeatConductors) -> tuple[ThermalConductor, ThermalConductor]:
    """Return both bodies; refuse those that are no half-spaces, and surfaces that hold heat back."""
    first, second = conductors.first, conductors.second
    if not isinstance(first, ThermalConductor) or not isinstance(second, ThermalConductor):
        raise InvalidInput(
            f"{owner}: the bodies are {type(first).__name__} and {type(second).__name__}; how the heat of friction "
            "flows is known for two thick bodies: give ThermalConductor(conductivity, diffusivity) for both."
        )
    if conductors.interface.area_resistance > 0.0:
        raise InvalidInput(
            f"{owner}: the surfaces have an interface_conductance of "
            f"{conductors.interface.interface_conductance:g} W/(m^2 K), but sliding surfaces are taken to have one "
            "temperature; leave the interface out."
        )
    return first, second
