"""How far a height map that is pressed and sheared can be trusted: residuals, steps, border, slopes, pixels."""

from __future__ import annotations

import math
from typing import cast

import numpy as np

from winkler.laws.friction import Coulomb
from winkler.laws.varying_friction import SlipWeakening, greatest_coefficient
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium
from winkler.media.medium import Medium
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import solved_together_note
from winkler.problems.rough.mapped_medium import medium_notes
from winkler.profiles.rough.topography import Topography
from winkler.values.validity import Assumption, Note, Standing, standing_left

KALKER = "J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9"
GOODMAN = "L. E. Goodman, J. Appl. Mech. 29 (1962) 515-522, doi:10.1115/1.3640599"
IDA = "Y. Ida, J. Geophys. Res. 77 (1972) 3796-3805, doi:10.1029/JB077i020p03796"
UNCOUPLED_LAYERS = Note(
    Assumption.UNCOUPLED,
    Standing.APPROXIMATE,
    "Tangential tractions on layers also displace the surface normally, and pressures displace it tangentially, "
    "even if both bodies are equal. Both effects are neglected (Goodman). Shear forces and tractions change by "
    "terms of the order of mu, the stiffness without slip by less.",
    GOODMAN,
)
STEADY_RATIO = 1e-9
"""Change of the normal force, over the force, that is none."""


def surface_shear_notes(
    rough: Topography,
    medium: MappedMedium,
    law: Coulomb | SlipWeakening,
    blurred: float,
    force: Array,
    penetration: Array,
    misfit: Array,
) -> tuple[Note, ...]:
    """Return what was assumed of a path of a map, and what the solver left.

    Parameters
    ----------
    rough : Topography
        The map.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace or DepthGradedHalfSpace
        Both bodies.
    law : Coulomb, LinearSlipWeakening or ExponentialSlipWeakening
        Law of friction.
    blurred : float
        Error of the area of contact over the area, the greatest of all points.
    force, penetration, misfit : ndarray, (points,)
        As in `winkler.problems.surface_friction.state.SurfaceShearState`.
    """
    overlap = float(np.max(penetration))
    notes = [
        *medium_notes(medium, rough, math.inf, blurred, overlap, overlap),
        Note(
            Assumption.SLIP,
            standing_left(float(np.max(misfit))),
            f"{_named(law)} in each pixel, opposite to the direction of its own slip. The residual of this "
            f"condition is {float(np.max(misfit)):.1g} of the energy stored and dissipated.",
            KALKER,
        ),
    ]
    if not isinstance(law, Coulomb):
        notes.append(
            Note(
                Assumption.SLIP,
                Standing.ASYMPTOTIC,
                "The friction coefficient of each pixel depends on its accumulated slip and does not recover. "
                "Steps in which friction falls faster than the bodies unload cause a jump and are not supported.",
                IDA,
            )
        )
    if float(np.ptp(force)) > STEADY_RATIO * float(np.max(force)):
        notes.append(
            Note(
                Assumption.RESOLUTION,
                Standing.ASYMPTOTIC,
                "The normal force changes along the path. New contact pixels count as touching from the start of "
                "their step. Errors are proportional to the step size; compare with twice the points.",
                KALKER,
            )
        )
    stepped = "Normal loading alone causes slip. Errors are proportional to the steps of the normal load."
    if isinstance(medium, HomogeneousMedium):
        notes.append(solved_together_note(cast(Medium, medium), greatest_coefficient(law), stepped))
    else:
        notes.append(UNCOUPLED_LAYERS)
    return tuple(notes)


def _named(law: Coulomb | SlipWeakening) -> str:
    return "Coulomb's law" if isinstance(law, Coulomb) else "Friction weakened by slip"
