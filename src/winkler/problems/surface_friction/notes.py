"""How far a height map that is pressed and sheared can be trusted: residuals, steps, border, slopes, pixels."""

from __future__ import annotations

import math

import numpy as np

from winkler.media.halfspace import HalfSpace
from winkler.media.medium import Medium
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import mismatch, sticking_note
from winkler.problems.rough.compliance import NEGLIGIBLE_COUPLING
from winkler.problems.rough.surface_notes import surface_notes
from winkler.profiles.rough.topography import Topography
from winkler.validity import Assumption, Note, Standing

__all__ = ["surface_shear_notes"]

KALKER = "J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9"
SPENCE = "D. A. Spence, J. Elast. 5 (1975) 297-319, doi:10.1007/BF00126993"
STEADY_RATIO = 1e-9
"""Change of the normal force, over the force, that is none."""


def surface_shear_notes(
    rough: Topography,
    medium: Medium,
    coefficient: float,
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
    medium : HalfSpace or TransverselyIsotropicHalfSpace
        Both bodies.
    coefficient : float
        Of friction.
    blurred : float
        Error of the area of contact over the area, the greatest of all points.
    force, penetration, misfit : ndarray, (points,)
        As in `winkler.problems.surface_friction.state.SurfaceShearState`.
    """
    overlap = float(np.max(penetration))
    notes = [
        *surface_notes(rough, math.inf, blurred, overlap, overlap),
        Note(
            Assumption.SLIP,
            Standing.EXACT,
            "Coulomb's law in each pixel, in the direction of its own slip: what slips is at its bound, with tractions "
            f"along the slip of each step, to {float(np.max(misfit)):.1g} of the energy stored and lost.",
            KALKER,
        ),
    ]
    if float(np.ptp(force)) > STEADY_RATIO * float(np.max(force)):
        notes.append(
            Note(
                Assumption.RESOLUTION,
                Standing.ASYMPTOTIC,
                "The normal force changes along the path: what comes into contact counts as touching from the start of "
                "its step on, so that results err in proportion to the steps; compare with twice the points.",
                KALKER,
            )
        )
    beta = mismatch(medium)
    if isinstance(medium, HalfSpace) and abs(beta) > NEGLIGIBLE_COUPLING:
        notes.append(
            Note(
                Assumption.UNCOUPLED,
                Standing.ASYMPTOTIC,
                f"The bodies are elastically dissimilar, Dundurs' beta = {beta:.3g}: pressures draw the surface along, "
                "and tractions sink it; both are solved together. Pressing alone makes parts slip, so that results err "
                "in proportion to the steps in which the normal load is applied.",
                SPENCE,
            )
        )
    else:
        notes.append(sticking_note(medium, coefficient))
    return tuple(notes)
