"""Pairs of conducting bodies, with a film or an interface between their surfaces."""

from __future__ import annotations

from typing import Annotated

from winkler.laws.film import SurfaceFilm, ThermalInterface
from winkler.materials.conducting_body import ConductingBody, surface_of
from winkler.materials.conductor import ElectricalConductor, ThermalConductor
from winkler.media.conduction.disc_resistance import Resistances, conduction_notes, disc_resistances
from winkler.numerics.types import Array
from winkler.values.checks.field_checks import Condition
from winkler.values.validity import Note
from winkler.values.value import value

NO_FILM = SurfaceFilm()
PERFECT_INTERFACE = ThermalInterface()


CONDUCTS_CURRENT = Condition(
    lambda body: isinstance(surface_of(body), ElectricalConductor),
    "give ElectricalConductor, or Plated or Rod made of it",
)
CONDUCTS_HEAT = Condition(
    lambda body: isinstance(surface_of(body), ThermalConductor), "give ThermalConductor, or Plated or Rod made of it"
)


@value
class ElectricalConductors:
    """Two bodies that conduct electric current.

    Parameters
    ----------
    first : ElectricalConductor, Plated or Rod
        The body below, z > 0.
    second : ElectricalConductor, Plated or Rod
        The body above, z < 0.
    film : SurfaceFilm, optional
        Between them; none by default.

    Raises
    ------
    InvalidInput
        If a body is not an electrical conductor.
    """

    first: Annotated[ConductingBody, CONDUCTS_CURRENT]
    second: Annotated[ConductingBody, CONDUCTS_CURRENT]
    film: SurfaceFilm = NO_FILM

    def resistances(self, radius: Array) -> Resistances:
        """Return the resistances to a current [ohm] through discs of the given radii `(m,)` [m]."""
        return disc_resistances(self.first, self.second, self.film.area_resistance, radius)

    @property
    def notes(self) -> tuple[Note, ...]:
        """The assumptions for the bodies and the film."""
        return conduction_notes(self.first, self.second, self.film.area_resistance)


@value
class HeatConductors:
    """Two bodies that conduct heat.

    Parameters
    ----------
    first : ThermalConductor, Plated or Rod
        The body below, z > 0.
    second : ThermalConductor, Plated or Rod
        The body above, z < 0.
    interface : ThermalInterface, optional
        Thermal resistance between the surfaces; none by default.

    Raises
    ------
    InvalidInput
        If a body is an electrical conductor.
    """

    first: Annotated[ConductingBody, CONDUCTS_HEAT]
    second: Annotated[ConductingBody, CONDUCTS_HEAT]
    interface: ThermalInterface = PERFECT_INTERFACE

    def resistances(self, radius: Array) -> Resistances:
        """Return the resistances to heat [K/W] through discs of the given radii `(m,)` [m]."""
        return disc_resistances(self.first, self.second, self.interface.area_resistance, radius)

    @property
    def notes(self) -> tuple[Note, ...]:
        """The assumptions for the bodies and the interface."""
        return conduction_notes(self.first, self.second, self.interface.area_resistance)
