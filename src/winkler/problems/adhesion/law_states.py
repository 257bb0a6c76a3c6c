"""The states of equilibrium that a law of adhesion makes of a bed."""

from __future__ import annotations

import math

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.adhesion import AdhesionLaw, DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.media.offers import PressedWaves, offers
from winkler.problems.adhesion.edge_states import EdgeStates, FarStates, ShortStates
from winkler.problems.adhesion.layered_states import LayeredStates
from winkler.problems.adhesion.maugis import CohesiveStates
from winkler.problems.normal.length_scale import shape_length
from winkler.values.errors import InvalidInput, OutsideValidity


def states_of(bed: Bed, law: AdhesionLaw) -> EdgeStates:
    """Return the states of a bed under a law.

    Raises
    ------
    InvalidInput
        If the law is no law of adhesion.
    OutsideValidity
        If the law does not hold for this profile or medium.
    """
    match law:
        case ShortRange():
            return ShortStates(bed, law.work)
        case Dugdale():
            return LayeredStates(bed, law) if offers(bed.medium, PressedWaves) else CohesiveStates(bed, law)
        case DerjaguinMullerToporov():
            return FarStates(bed, 2.0 * math.pi * _apex_radius(bed) * law.work)
        case _:
            raise InvalidInput(
                f"adhesion: the law is a {type(law).__name__}; give ShortRange(work), Dugdale(work, strength) or "
                "DerjaguinMullerToporov(work)."
            )


def _apex_radius(bed: Bed) -> float:
    """Return the radius of curvature at the apex [m]."""
    r = shape_length(bed) * np.array([1e-8, 1e-6])
    near, far = bed.slope(r) / r
    if not (near > 0.0 and far > 0.0 and abs(math.log(near / far)) <= 1e-3 * math.log(100.0)):
        what = "flat" if far == 0.0 else "pointed, or flatter than a paraboloid"
        raise OutsideValidity(
            f"DerjaguinMullerToporov: the force 2 pi R work needs a radius of curvature R, but the apex is {what}; use "
            "ShortRange(work), or Dugdale(work, strength), which hold for any apex."
        )
    return float(1.0 / near)
