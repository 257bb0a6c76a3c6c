"""What an electric contact of a height map cannot be made of."""

from __future__ import annotations

from winkler.errors import OutsideValidity
from winkler.materials.conducting_body import Rod, layers_of
from winkler.media.conduction.conductors import ElectricalConductors

__all__ = ["refuse_bodies"]

THINNEST_SHARE = 1e-7
"""Of the length of the map that a plating must be thick: the pixels resolve nothing thinner."""


def refuse_bodies(conductors: ElectricalConductors, longest: float) -> None:
    """Refuse rods, and platings far thinner than a map of this length [m] resolves.

    Raises
    ------
    OutsideValidity
    """
    for body in (conductors.first, conductors.second):
        if isinstance(body, Rod):
            raise OutsideValidity(
                "SurfaceConstriction: a rod constricts the current of one round contact, not that of a height map; "
                "give its conductor alone, and add the resistance of its length, resistivity * length / section."
            )
        thinnest = min((thickness for _, thickness in layers_of(body)[0]), default=longest)
        if thinnest < THINNEST_SHARE * longest:
            raise OutsideValidity(
                f"SurfaceConstriction: a plating of {thinnest:.3g} m is less than {THINNEST_SHARE:g} of the "
                f"map, {longest:.3g} m, which does not resolve it; leave the plating out."
            )
