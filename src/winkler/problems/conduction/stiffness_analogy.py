r"""Conductance from stiffness: both are fixed by the same spots, whatever their shape (Barber),

.. math:: \Lambda = \frac{2}{E^*(\rho_1+\rho_2)}\,\frac{\mathrm dF}{\mathrm dd} .
"""

from __future__ import annotations

from winkler.materials.conducting_body import Plated, Rod, resistivity_of, surface_of
from winkler.media.conduction.conductors import ElectricalConductors, HeatConductors
from winkler.media.halfspace import HomogeneousMedium
from winkler.values.errors import OutsideValidity


def conductance_of_stiffness(
    owner: str, medium: HomogeneousMedium, conductors: ElectricalConductors | HeatConductors
) -> float:
    """Return conductance over stiffness [S m/N or W m/(K N)].

    Parameters
    ----------
    owner : str
        Name of the problem, for the error sentence.
    medium : HalfSpace
        Both bodies, homogeneous.
    conductors : ElectricalConductors or HeatConductors
        What they conduct; thick ones without platings or film.

    Raises
    ------
    OutsideValidity
        If there is a film, a plating or a rod.
    """
    if not plain(conductors):
        raise OutsideValidity(
            f"{owner}: stiffness determines the conductance of thick conductors without film or plating; leave them "
            "out."
        )
    first, second = (resistivity_of(surface_of(body)) for body in (conductors.first, conductors.second))
    return 2.0 / (medium.modulus * (first + second))


def plain(conductors: ElectricalConductors | HeatConductors) -> bool:
    """Return whether both bodies are thick ones of one conductor, and nothing lies between them."""
    between = conductors.film if isinstance(conductors, ElectricalConductors) else conductors.interface
    layered = any(isinstance(body, Plated | Rod) for body in (conductors.first, conductors.second))
    return not layered and not between.area_resistance
