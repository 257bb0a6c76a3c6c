"""What every problem of frictional heating refuses."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from winkler.errors import InvalidInput, OutsideValidity
from winkler.materials.conductor import ThermalConductor
from winkler.media.conduction.conductors import HeatConductors
from winkler.numerics.types import Array, Quantity

__all__ = ["peclet_numbers", "thick_bodies"]

HIGHEST_PECLET = 1e8
"""Peclet number above which rounding matters in means over the contact."""


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


def peclet_numbers(
    owner: str, radius: Quantity, speeds: Sequence[Array], bodies: tuple[ThermalConductor, ThermalConductor]
) -> list[Array]:
    """Return V a / (2 kappa) of both bodies [-]; refuse those above the range in which temperatures are computed."""
    peclets = [
        np.asarray(0.5 * np.abs(speed) * radius / body.diffusivity) for speed, body in zip(speeds, bodies, strict=True)
    ]
    fastest = max(float(np.max(each, initial=0.0)) for each in peclets)
    if fastest > HIGHEST_PECLET:
        raise OutsideValidity(
            f"{owner}: a Peclet number V a / (2 kappa) is {fastest:.3g}; temperatures of moving bodies are computed up "
            f"to {HIGHEST_PECLET:g}: check speeds and diffusivities."
        )
    return peclets
