"""What every problem of frictional heating refuses."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from winkler.materials.conducting_body import Plated
from winkler.materials.conductor import ThermalConductor
from winkler.media.conduction.conductors import HeatConductors
from winkler.numerics.types import Array, Quantity
from winkler.problems.heating.moved_body import HeatBody, diffusivities
from winkler.problems.normal.indentation import Indentation
from winkler.values.checks.outline import refuse_unless_round
from winkler.values.errors import InvalidInput, OutsideValidity

HIGHEST_PECLET = 1e8
"""Peclet number above which rounding matters in means over the contact."""


class RubbingBodies:
    """A problem of frictional heating: its `conductors` are two thick bodies, in perfect touch."""

    conductors: HeatConductors

    def __post_init__(self) -> None:
        _ = self._bodies

    @property
    def _bodies(self) -> tuple[ThermalConductor, ThermalConductor]:
        """Both bodies; those that are no half-spaces are refused, and surfaces that hold heat back."""
        first, second = self.conductors.first, self.conductors.second
        if not isinstance(first, ThermalConductor) or not isinstance(second, ThermalConductor):
            raise InvalidInput(
                f"{type(self).__name__}: the bodies are {type(first).__name__} and {type(second).__name__}; how the "
                "heat of friction flows is known for two thick bodies: give ThermalConductor(conductivity, "
                "diffusivity) for both."
            )
        _refuse_pair(self, (first, second))
        return first, second


class RubbingPlatedBodies:
    """A problem of frictional heating: its `conductors` are thick bodies, plated or not, in perfect touch."""

    conductors: HeatConductors

    def __post_init__(self) -> None:
        _ = self._bodies

    @property
    def _bodies(self) -> tuple[HeatBody, HeatBody]:
        """Both bodies; rods are refused, and surfaces that hold heat back."""
        first, second = self.conductors.first, self.conductors.second
        if not isinstance(first, ThermalConductor | Plated) or not isinstance(second, ThermalConductor | Plated):
            raise InvalidInput(
                f"{type(self).__name__}: the bodies are {type(first).__name__} and {type(second).__name__}; how the "
                "heat of friction flows is known for two thick bodies: give ThermalConductor(conductivity, "
                "diffusivity), or Plated made of it, for both."
            )
        _refuse_pair(self, (first, second))
        return first, second

    @property
    def _plated(self) -> bool:
        """Whether a body is plated."""
        return any(isinstance(body, Plated) for body in self._bodies)


def _refuse_pair(problem: RubbingBodies | RubbingPlatedBodies, bodies: tuple[HeatBody, HeatBody]) -> None:
    """Refuse an interface, and bodies of unknown diffusivity, save those of a steady problem that rest."""
    owner, interface = type(problem).__name__, problem.conductors.interface
    if interface.area_resistance > 0.0:
        raise InvalidInput(
            f"{owner}: the surfaces have an interface_conductance of {interface.interface_conductance:g} "
            "W/(m^2 K), but sliding surfaces are assumed to have one temperature; leave the interface out."
        )
    for word, body in zip(("first", "second"), bodies, strict=True):
        rests = not np.any(np.asarray(getattr(problem, f"{word}_speed", math.nan)))
        if not rests and max(diffusivities(body)) == math.inf:
            raise InvalidInput(
                f"{owner}: the diffusivity of the {word} body is infinite, or not given, but the heat that flows "
                "into it depends on it; give a diffusivity in m^2/s."
            )


def refuse_contact(problem: RubbingBodies | RubbingPlatedBodies, contact: Any) -> None:
    """Refuse springs that stand for a contact that is not known to be round."""
    if isinstance(contact, Indentation):
        needed = "the heat of friction, which follows the pressure from place to place,"
        refuse_unless_round(contact, type(problem).__name__, needed)


def peclet_numbers(
    owner: str, lengths: Sequence[Quantity], speeds: Sequence[Quantity], bodies: tuple[HeatBody, HeatBody]
) -> list[Array]:
    """Return V a / (2 kappa) of both bodies [-]; refuse those above the range in which temperatures are computed.

    The `lengths` a are half those of the contact along either motion; a plated body has the least of its diffusivities.
    """
    rates = [min(diffusivities(body)) for body in bodies]
    pairs = zip(lengths, speeds, rates, strict=True)
    peclets = [np.asarray(0.5 * np.abs(speed) * length / rate) for length, speed, rate in pairs]
    fastest = max(float(np.max(each, initial=0.0)) for each in peclets)
    if fastest > HIGHEST_PECLET:
        raise OutsideValidity(
            f"{owner}: a Peclet number V a / (2 kappa) is {fastest:.3g}; temperatures of moving bodies are computed up "
            f"to {HIGHEST_PECLET:g}: check speeds and diffusivities."
        )
    return peclets
