"""Validity of two profiles that roll with friction: law of friction, creepages, pixels, shape, yield."""

from __future__ import annotations

from typing import cast

from winkler.laws.friction import Coulomb
from winkler.laws.varying_friction import FallingFriction, greatest_coefficient
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium
from winkler.media.medium import Medium
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.pressed_shape.notes import PIXELS_ON_LAYERS, graded_notes
from winkler.problems.profile_pair.notes import placed_notes, yield_of_patches
from winkler.problems.profile_pair.rolled_patch import RolledPatch
from winkler.problems.surface_friction.notes import UNCOUPLED_LAYERS
from winkler.problems.surface_rolling.notes import named
from winkler.problems.surface_rolling.small_creep import small_creep_note
from winkler.values.validity import Assumption, Note, Standing, standing_left, standing_of

__all__ = ["pair_rolling_notes"]

KALKER = "J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9"
PIXELS_ON_HALF_SPACES = Note(
    Assumption.RESPONSE,
    Standing.EXACT,
    "Contact of homogeneous, linear elastic half-spaces, every pixel pressing and dragging all others of its grid.",
    KALKER,
)
FINE, COARSE = 0.01, 0.1
"""Change of forces from half as many pixels up to which results count as fine, and as coarse."""


def pair_rolling_notes(
    medium: MappedMedium,
    friction: Coulomb | FallingFriction,
    patches: tuple[RolledPatch, ...],
    windows: int,
    grid_error: float,
    misfit: float,
) -> tuple[Note, ...]:
    """Return what was assumed of two profiles that roll, and what grid and solver leave.

    Parameters
    ----------
    medium
        Both bodies.
    friction
        Law of friction.
    patches
        The one that bears most first.
    windows
        Number of grids.
    grid_error, misfit
        As of `ProfilePairRollingSolution`.
    """
    homogeneous = isinstance(medium, HomogeneousMedium)
    greatest = max(patch.greatest_rigid_slip for patch in patches)
    return (
        *((PIXELS_ON_HALF_SPACES,) if homogeneous else (PIXELS_ON_LAYERS, *graded_notes(medium))),
        Note(
            Assumption.SLIP,
            standing_left(misfit, Standing.ASYMPTOTIC),
            f"Exact theory of rolling, {named(friction)} in each pixel, to {misfit:.1g} of what friction would lose "
            "if all slipped. The rigid slip follows the radii of both bodies across the patch.",
            KALKER,
        ),
        Note(
            Assumption.STEADY,
            Standing.ASYMPTOTIC,
            "Steady rolling, after some lengths of the contact in which creepages and loads do not change.",
            KALKER,
        ),
        small_creep_note(greatest),
        sticking_note(cast(Medium, medium), greatest_coefficient(friction)) if homogeneous else UNCOUPLED_LAYERS,
        Note(
            Assumption.RESOLUTION,
            standing_of(grid_error, FINE, COARSE),
            f"Twice the change from other grids: forces are within {100.0 * grid_error:.2g} per cent of the friction; "
            "the profiles are splines through their points.",
            "comparison of three grids",
            grid_error,
        ),
        *placed_notes(medium, tuple(each.patch for each in patches), False, windows),
        *yield_of_patches(medium, [each.surface_load for each in patches], len(patches) > windows),
    )
