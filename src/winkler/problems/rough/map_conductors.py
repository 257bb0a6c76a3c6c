"""What conducting bodies of a height map may be made of."""

from __future__ import annotations

from winkler.materials.conducting_body import ConductingBody, Plated, Rod, layers_of
from winkler.media.conduction.conductors import ElectricalConductors, HeatConductors
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing

THINNEST_SHARE = 1e-7
"""Of the length of the map that a plating must be thick: the pixels resolve nothing thinner."""
IMAGES = "dense matrices of images of the platings, and the integral equation of a plated disc"


def refuse_bodies(owner: str, conductors: ElectricalConductors | HeatConductors, longest: float) -> None:
    """Refuse rods, and platings far thinner than a map of this length [m] resolves.

    Raises
    ------
    OutsideValidity
    """
    flowing = "current" if isinstance(conductors, ElectricalConductors) else "heat"
    for body in (conductors.first, conductors.second):
        if isinstance(body, Rod):
            raise OutsideValidity(
                f"{owner}: a rod constricts the {flowing} of one round contact, not that of a height map; give its "
                "conductor alone, and add the resistance of its length, resistivity * length / section."
            )
        thinnest = min((thickness for _, thickness in layers_of(body)[0]), default=longest)
        if thinnest < THINNEST_SHARE * longest:
            raise OutsideValidity(
                f"{owner}: a plating of {thinnest:.3g} m is less than {THINNEST_SHARE:g} of the map, {longest:.3g} m, "
                "which does not resolve it; leave the plating out."
            )


def plating_notes(
    conductors: ElectricalConductors | HeatConductors, medium: MappedMedium, rough: Topography
) -> tuple[Note, ...]:
    """Return what was assumed of platings that conduct, and of elastic layers that have none of their own."""
    bodies: tuple[ConductingBody, ...] = (conductors.first, conductors.second)
    plated = any(isinstance(body, Plated) for body in bodies)
    notes = []
    if plated:
        alone = "" if rough.periodic else ", and extend beyond the map"
        notes.append(
            Note(
                Assumption.CONDUCTION,
                Standing.EXACT,
                f"The platings conduct as flat layers, bonded without resistance{alone}. The roughness is assumed "
                "shallow compared with their thickness.",
                IMAGES,
            )
        )
    elif not isinstance(medium, HomogeneousMedium):
        notes.append(
            Note(
                Assumption.CONDUCTION,
                Standing.EXACT,
                "The conductors are given separately from the elastic layers: both bodies conduct as homogeneous "
                "ones. If the layers have other resistivities, give Plated conductors of the same thicknesses.",
                IMAGES,
            )
        )
    return tuple(notes)
