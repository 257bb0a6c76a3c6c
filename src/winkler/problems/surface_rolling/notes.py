"""How far a height map that rolls can be trusted: border, residual, slopes, pixels, steady state, yield."""

from __future__ import annotations

import math
from typing import cast

import numpy as np

from winkler.laws.friction import Coulomb
from winkler.laws.varying_friction import FallingFriction, greatest_coefficient
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium
from winkler.media.medium import Medium
from winkler.numerics.pixels.contact_area import contact_area
from winkler.numerics.types import Array, Quantity
from winkler.problems.assumptions.coupling import solved_together_note
from winkler.problems.rough.mapped_medium import medium_notes
from winkler.problems.surface_friction.by_turns import COUPLED_TOLERANCE
from winkler.problems.surface_friction.notes import UNCOUPLED_LAYERS
from winkler.profiles.rough.topography import Topography
from winkler.values.validity import Assumption, Note, Standing, standing_left

KALKER = "J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9"
PRESSED_TOLERANCE = 1e-6
"""To which the pressures are solved."""


def surface_rolling_notes(
    rough: Topography,
    medium: MappedMedium,
    friction: Coulomb | FallingFriction,
    pressure: Array,
    misfit: Quantity,
    forced: bool,
) -> tuple[Note, ...]:
    """Return what was assumed of a map that rolls, and what the solver left.

    Parameters
    ----------
    rough : Topography
        The map.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace or DepthGradedHalfSpace
        Both bodies.
    friction : Coulomb or FallingFriction
        Law of friction.
    pressure : ndarray, (nx, ny)
        [Pa].
    misfit : float or ndarray
        As in `winkler.problems.surface_rolling.state.SurfaceRollingState`.
    forced : bool
        Whether forces are given.
    """
    touching = pressure > 0.0
    area, error = contact_area(touching, rough.pixel, False)
    across = int(np.max(np.count_nonzero(touching, axis=0)))
    met = " The error of prescribed forces is at most this fraction of mu F_N. Along" if forced else " Along"
    bodies = "Half-spaces" if isinstance(medium, HomogeneousMedium) else "Layered or graded bodies"
    law = Note(
        Assumption.SLIP,
        standing_left(float(np.max(misfit)), Standing.ASYMPTOTIC),
        f"{bodies} roll on each other, with {named(friction)} in each pixel. The residual of the law of "
        f"friction is {float(np.max(misfit)):.1g} of the energy dissipated at full sliding.{met} the rolling "
        f"direction there are {across} pixels. The error of the forces is proportional to the pixel size. With "
        "40 pixels it is about 0.5 % of mu F_N.",
        KALKER,
    )
    steady = Note(
        Assumption.STEADY,
        Standing.ASYMPTOTIC,
        "Steady rolling is assumed, after a distance of several contact lengths. The height map moves with "
        "the contact and does not pass through it.",
        KALKER,
    )
    pressed = medium_notes(medium, rough, math.inf, error / area, PRESSED_TOLERANCE, PRESSED_TOLERANCE)
    if not isinstance(medium, HomogeneousMedium):
        return (*pressed, law, steady, UNCOUPLED_LAYERS)
    turns = (
        f"Coupling converges to {COUPLED_TOLERANCE:.0e} of the depth. The error of the forces is proportional to "
        "the pixel size."
    )
    return (*pressed, law, steady, solved_together_note(cast(Medium, medium), greatest_coefficient(friction), turns))


def named(friction: Coulomb | FallingFriction) -> str:
    """Return the law of friction in words."""
    return "Coulomb's law" if isinstance(friction, Coulomb) else "friction that falls with the velocity of slip"
