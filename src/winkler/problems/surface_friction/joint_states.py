"""How stiff a joint is under one normal force, by boundary elements and by the disc that is as stiff across."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.media.mapped import MappedMedium
from winkler.media.offers import PushedWaves, offers
from winkler.numerics.surfaces.punched_grid import stuck_stiffness
from winkler.numerics.surfaces.traction_grid import Compliance
from winkler.numerics.transforms import fredholm
from winkler.problems.rough.contact_springs import radii_of
from winkler.problems.rough.surface_states import SurfaceState
from winkler.profiles.rough.topography import Topography


class JointState(NamedTuple):
    """Stiffnesses of a contact [N/m]: across the surface, and along x and y where nothing slips."""

    normal: float
    along_x: float
    along_y: float


def joint_state(state: SurfaceState, rough: Topography, medium: MappedMedium, compliance: Compliance) -> JointState:
    """Return the stiffnesses of a contact that has been solved; infinite of a periodic one that touches everywhere.

    Raises
    ------
    NotConverged
        If the tractions are not found.
    """
    touching = state.pressure > 0.0
    if math.isinf(state.stiffness):
        return JointState(math.inf, math.inf, math.inf)
    x, y = stuck_stiffness(touching, rough.pixel, compliance, periodic=rough.periodic)
    return JointState(state.stiffness, medium.modulus * x, medium.modulus * y)


def disc_ratio(stiffness: float, medium: MappedMedium) -> float:
    """Return tangential over normal stiffness of the disc on these bodies that is as stiff across: Mindlin's ratio.

    Of homogeneous bodies it does not depend on the disc.  Of layers the part of the displacement that turns with the
    angle is left out.
    """
    bodies = medium
    if math.isinf(stiffness) or not offers(medium, PushedWaves):
        return bodies.shear_modulus / bodies.modulus
    radius = radii_of(np.array([stiffness]), bodies)
    tangential = 2.0 * medium.shear_modulus * fredholm.area(medium.tangential_response, radius)
    return float(tangential[0] / stiffness)
