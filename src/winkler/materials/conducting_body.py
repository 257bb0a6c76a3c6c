r"""Conducting bodies that are more than a half-space of one solid: plated ones, and rods."""

from __future__ import annotations

import math

from winkler.materials.conductor import ElectricalConductor, ThermalConductor
from winkler.values.checks.number_checks import Positive, PositiveNotTiny
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

Conductor = ElectricalConductor | ThermalConductor
"""What a body may be made of."""


@value
class Plated:
    """A thick body with a plating of another conductor, bonded without interface resistance.

    Parameters
    ----------
    plating : ElectricalConductor or ThermalConductor
        At the surface.
    thickness : float
        h [m], positive.
    on : ElectricalConductor, ThermalConductor or Plated
        The body below the plating, of the same type of conductor. A `Plated` body has several platings.

    Raises
    ------
    InvalidInput
        If the thickness is not positive, or one part conducts current and the other heat.
    """

    __words__ = words(on=("", None, "what carries the plating"), thickness=("h", "m", "thickness of the plating"))

    plating: Conductor
    thickness: PositiveNotTiny
    on: Conductor | Plated

    def __post_init__(self) -> None:
        below = surface_of(self.on)
        if type(self.plating) is not type(below):
            raise InvalidInput(
                f"Plated: a plating of {type(self.plating).__name__} on {type(below).__name__}; give two of one sort."
            )


@value
class Rod:
    """A round rod with the contact in the middle of its end face; its side is insulated.

    Parameters
    ----------
    conductor : ElectricalConductor or ThermalConductor
        Material of the layer.
    radius : float
        b [m], positive; the contact must be narrower.
    length : float
        Distance from the contact to the end at which voltage or temperature are given [m]; at least a few radii.

    Raises
    ------
    InvalidInput
        If a length is not positive.
    """

    __words__ = words(radius=("b", "m", "radius of the rod"), length=("l", "m", "length of the rod"))

    conductor: Conductor
    radius: Positive
    length: Positive


ConductingBody = Conductor | Plated | Rod
"""What may touch: a thick body of one conductor, a plated one, a rod."""


def surface_of(body: ConductingBody) -> Conductor:
    """Return the conductor at the surface."""
    match body:
        case Plated():
            return body.plating
        case Rod():
            return body.conductor
        case _:
            return body


def layers_of(body: ConductingBody) -> tuple[tuple[tuple[Conductor, float], ...], Conductor]:
    """Return the platings of a body with their thicknesses [m], from the surface down, and what carries them."""
    layers: list[tuple[Conductor, float]] = []
    while isinstance(body, Plated):
        layers.append((body.plating, body.thickness))
        body = body.on
    return tuple(layers), surface_of(body)


def parts_of(body: ConductingBody) -> tuple[Conductor, ...]:
    """Return the conductors of a body, from the surface down."""
    layers, base = layers_of(body)
    return (*(conductor for conductor, _ in layers), base)


def resistivity_of(conductor: Conductor) -> float:
    """Return the resistivity [ohm m], or the inverse of the thermal conductivity [m K/W]."""
    return conductor.resistivity if isinstance(conductor, ElectricalConductor) else 1.0 / conductor.conductivity


def bulk_of(body: ConductingBody) -> float:
    """Return the resistance of the length of a rod [ohm or K/W]; zero of a body without end."""
    if isinstance(body, Rod):
        return resistivity_of(body.conductor) * body.length / (math.pi * body.radius**2)
    return 0.0
