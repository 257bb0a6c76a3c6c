"""What every problem of frictional heating refuses."""

from __future__ import annotations

import math

import numpy as np

from winkler.errors import InvalidInput
from winkler.laws.friction import Coulomb
from winkler.laws.heat import EqualMaximum, EqualMean, FixedShare
from winkler.loading import Depth, Force, Load, Radius
from winkler.materials.conductor import ThermalConductor
from winkler.media.conduction.conductors import HeatConductors
from winkler.numerics.types import Quantity

__all__ = ["all_finite", "checked_heating", "load_number", "thick_bodies"]


def checked_heating(owner: str, law: object, partition: object, conductors: object) -> None:
    """Refuse friction without a finite coefficient, and what neither conducts heat nor shares it."""
    if not isinstance(law, Coulomb) or law.coefficient == math.inf:
        raise InvalidInput(f"{owner}: the law is {law!r}; give Coulomb(coefficient) with a finite coefficient.")
    thick_bodies(owner, conductors)
    if not isinstance(partition, EqualMaximum | EqualMean | FixedShare):
        raise InvalidInput(
            f"{owner}: partition is a {type(partition).__name__}; give EqualMaximum(), EqualMean() or "
            "FixedShare(first_share)."
        )


def thick_bodies(owner: str, conductors: object) -> tuple[ThermalConductor, ThermalConductor]:
    """Return both bodies; refuse those that are no half-spaces, and surfaces that hold heat back."""
    if not isinstance(conductors, HeatConductors):
        raise InvalidInput(
            f"{owner}: conductors is a {type(conductors).__name__}; give HeatConductors(first, second) of two "
            "ThermalConductor(conductivity, diffusivity)."
        )
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


def all_finite(given: object) -> bool:
    """Return whether something is a finite number or an array of them."""
    try:
        numbers = np.asarray(given, dtype=float)
    except (TypeError, ValueError):
        return False
    return not isinstance(given, bool) and bool(np.all(np.isfinite(numbers)))


def load_number(owner: str, load: Load) -> Quantity:
    """Return what a load prescribes."""
    match load:
        case Depth(number) | Force(number) | Radius(number):
            return number
    raise InvalidInput(f"{owner}: the load is a {type(load).__name__}; give Force, Depth or Radius.")
