"""Validity of the contact of two profiles: pixels, half-spaces, ends of the profiles, yield."""

from __future__ import annotations

import math

import numpy as np

from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium, layers_of
from winkler.problems.normal.map_yield import greatest_share, map_yield_notes
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.pressed_shape.notes import PIXELS_ON_LAYERS, graded_notes
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.problems.profile_pair.patch import ProfilePatch
from winkler.values.validity import Assumption, Note, Standing, standing_of

POLONSKY = "I. A. Polonsky, L. M. Keer, Wear 231 (1999) 206-219, doi:10.1016/S0043-1648(99)00113-1"
KALKER = "J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9"
PIXELS_ON_HALF_SPACES = Note(
    Assumption.RESPONSE,
    Standing.EXACT,
    "Frictionless contact of homogeneous, linear elastic half-spaces. The pressure of every pixel displaces "
    "all other pixels.",
    POLONSKY,
)
FINE, COARSE = 0.01, 0.1
"""Change from half as many pixels up to which results count as fine, and as coarse."""
TURNED_SHARE = 0.3
"""Error of what one patch sinks another one: bodies whose surface turns between them are no half-spaces."""
FLAT, BENT = 0.1, 1.2
"""Angle over which the direction of the surface turns within a patch [rad], small, and too large for half-spaces."""


def pair_notes(
    medium: MappedMedium, patches: tuple[ProfilePatch, ...], grid_error: float, cut: bool, windows: int
) -> tuple[Note, ...]:
    """Return what was assumed of two profiles, and what the grid leaves.

    Parameters
    ----------
    medium
        Both bodies.
    patches
        Where they touch, the one that bears most first.
    grid_error
        Relative change from half as many pixels.
    cut
        Whether a contact reaches the end of a profile.
    windows
        Number of grids.
    """
    homogeneous = isinstance(medium, HomogeneousMedium)
    notes = [
        *((PIXELS_ON_HALF_SPACES,) if homogeneous else (PIXELS_ON_LAYERS, *graded_notes(medium))),
        Note(
            Assumption.RESOLUTION,
            standing_of(grid_error, FINE, COARSE),
            "With half as many pixels along a side force and maximum pressure change by up to "
            f"{100.0 * grid_error:.2g} per cent. The profiles are splines through their points.",
            "comparison of two grids",
            grid_error,
        ),
        *placed_notes(medium, patches, cut, windows),
    ]
    spot = max(patches, key=lambda patch: patch.peak_pressure)
    return (*notes, *yield_of_patches(medium, [spot.surface_load], len(patches) > 1 and windows == 1))


def yield_of_patches(medium: MappedMedium, loads: list[SurfaceLoad], together: bool) -> tuple[Note, ...]:
    """Return whether the bodies stay elastic below the worst of some patches.

    Parameters
    ----------
    medium
        Both bodies.
    loads
        What acts on the lower body on each patch.
    together
        Whether patches lie near each other.
    """
    worst = max(loads, key=lambda load: greatest_share(medium, load)) if len(loads) > 1 else loads[0]
    alone = map_yield_notes(medium, worst)
    if alone and alone[0].standing is not Standing.OUTSIDE and together:
        why = "the stresses of patches near each other add up and only those of the worst one are computed"
        return unknown_yield(medium, why)
    return alone


def placed_notes(medium: MappedMedium, patches: tuple[ProfilePatch, ...], cut: bool, windows: int) -> tuple[Note, ...]:
    """Return what was assumed of the shape of two profiles and of their patches; parameters as of `pair_notes`."""
    bent = max(patch.turned for patch in patches)
    notes = [
        Note(
            Assumption.HALF_SPACE,
            standing_of(bent, FLAT, BENT),
            f"Within a patch the direction of the normal changes by {bent:.2g} rad. The gap is measured along the "
            "normals. The elastic response is that of "
            f"{'a half-space' if isinstance(medium, HomogeneousMedium) else 'flat layers'} along the arc.",
            KALKER,
        ),
    ]
    if windows > 1:
        notes.append(_apart(medium, patches))
    if cut:
        notes.append(
            Note(
                Assumption.SHAPE,
                Standing.OUTSIDE,
                "The contact reaches the end of a profile, or a steep part of unknown height. A continuation of "
                "the profile would carry load too: give a longer profile.",
                "comparison of the contact and the profiles",
            )
        )
    return tuple(notes)


def _apart(medium: MappedMedium, patches: tuple[ProfilePatch, ...]) -> Note:
    """Return how much patches on grids of their own sink each other, and how far that is from the truth."""
    most, wide, layers = 0.0, 0.0, layers_of(medium)
    for one in patches:
        for other in patches:
            far = math.hypot(one.y - other.y, one.z - other.z, one.x - other.x)
            if other is not one and far > 0.0:
                sunk = other.force * max(float(np.cos(one.angle - other.angle)), 0.0)
                sunk *= float(layers.whole(np.array([1.0 / far]))[0]) if layers else 1.0
                most = max(most, sunk / (math.pi * medium.modulus * far) / one.depth)
                wide = max(wide, max(one.longitudinal_length, one.lateral_length) / far)
    return Note(
        Assumption.SINGLE_CONTACT,
        standing_of(most * max(wide, TURNED_SHARE), FINE, COARSE),
        "Distant places of contact have separate grids. Each acts on the others like a point force on a "
        f"half-space, with a displacement of up to {100.0 * most:.2g} per cent of their overlap.",
        KALKER,
    )
