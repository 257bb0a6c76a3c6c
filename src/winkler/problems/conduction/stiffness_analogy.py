r"""Conductance from stiffness: both are fixed by the same spots, whatever their shape (Barber),

.. math:: \Lambda = \frac{2}{E^*(\rho_1+\rho_2)}\,\frac{\mathrm dF}{\mathrm dd} .
"""

from __future__ import annotations

from winkler.errors import OutsideValidity
from winkler.materials.conducting_body import Plated, Rod, resistivity_of
from winkler.media.conduction.conductors import ElectricalConductors, HeatConductors
from winkler.media.halfspace import HomogeneousMedium

__all__ = ["conductance_of_stiffness"]


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
    between = conductors.film if isinstance(conductors, ElectricalConductors) else conductors.interface
    bodies = conductors.first, conductors.second
    if between.area_resistance or isinstance(bodies[0], Plated | Rod) or isinstance(bodies[1], Plated | Rod):
        raise OutsideValidity(
            f"{owner}: stiffness determines the conductance of thick conductors without film or plating; leave them "
            "out."
        )
    return 2.0 / (medium.modulus * (resistivity_of(bodies[0]) + resistivity_of(bodies[1])))
