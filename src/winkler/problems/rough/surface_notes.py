"""How far the contact of a height map can be trusted: border, residual, slopes, pixels."""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array, Quantity
from winkler.profiles.rough.map_notes import map_notes
from winkler.profiles.rough.topography import Topography
from winkler.values.validity import Assumption, Note, Standing, standing_left

__all__ = ["border_notes", "surface_notes"]

YASTREBOV = "V. A. Yastrebov, G. Anciaux, J.-F. Molinari, Tribol. Int. 114 (2017) 161-171"
STANLEY = "H. M. Stanley, T. Kato, J. Tribol. 119 (1997) 481-485, doi:10.1115/1.2833523"
ALMQVIST = (
    "A. Almqvist, F. Sahlin, R. Larsson, S. Glavatskih, Tribol. Int. 40 (2007) 574-579, "
    "doi:10.1016/j.triboint.2005.11.008"
)
POLONSKY = "I. A. Polonsky, L. M. Keer, Wear 231 (1999) 206-219, doi:10.1016/S0043-1648(99)00113-1"
FINE_AREA_ERROR, LOST_AREA_ERROR = 0.05, 0.4
"""Error of the area, over the area: of a round spot of 500 pixels, and of nine, below which it is lost."""
STEEP_SLOPE = 0.1
MOST_ON_BORDER = 0.05
"""Part of the force; a flat stamp of 64 pixels bears a tenth there."""
SMALLEST_WITH_BORDER = 16
"""Pixels along a side; of fewer ones many are on the border."""


def surface_notes(
    rough: Topography, hardness: float, blurred: float, penetration: Quantity, misfit: Quantity
) -> tuple[Note, ...]:
    """Return what was assumed of a map, and what the solver left.

    Parameters
    ----------
    rough : Topography
        The map.
    hardness : float
        At which pressures are cut [Pa]; infinite if they are not.
    blurred : float
        Error of the area of contact over the area, the greatest of all loads.
    penetration, misfit : float or ndarray
        As in `winkler.problems.rough.surface_states.SurfaceState`.
    """
    border = (
        "The map is repeated for ever in both directions; depths are approaches of the mean planes."
        if rough.periodic
        else "The map stands alone: beyond its border nothing touches, and pressures rise there like under a stamp."
    )
    overlap, left = float(np.max(penetration)), float(np.max(misfit))
    notes = [
        Note(
            Assumption.RESPONSE,
            Standing.EXACT,
            "Frictionless contact of homogeneous, linear elastic half-spaces, every pixel pressing on all others.",
            POLONSKY,
        ),
        Note(Assumption.RESPONSE, Standing.EXACT, border, STANLEY if rough.periodic else POLONSKY),
        Note(
            Assumption.RESOLUTION,
            standing_left(max(overlap, left), Standing.ASYMPTOTIC),
            f"Solved until surfaces overlap by at most {overlap:.1g} of the depth, and pressures do {left:.1g} "
            "of the work of the force on gaps; smooth contacts gain two digits of the force for ten times the "
            "pixels along a side.",
            POLONSKY,
        ),
    ]
    if blurred > 0.0:
        notes.append(
            Note(
                Assumption.RESOLUTION,
                Standing.OUTSIDE
                if blurred > LOST_AREA_ERROR
                else Standing.APPROXIMATE
                if blurred > FINE_AREA_ERROR
                else Standing.ASYMPTOTIC,
                f"Spots of contact are about {0.5 / blurred:.2g} pixels wide. On this grid the area is known to "
                f"about {100.0 * blurred:.2g} per cent, and the greatest pressure may be up to "
                f"{600.0 * blurred**2:.2g} per cent too "
                f"low{'; take a finer map.' if blurred > LOST_AREA_ERROR else '.'}",
                YASTREBOV,
                blurred,
            )
        )
    slope = rough.rms_slope
    notes.append(
        Note(
            Assumption.SMALL_SLOPES,
            Standing.OUTSIDE if slope > 1.0 else Standing.APPROXIMATE if slope > STEEP_SLOPE else Standing.ASYMPTOTIC,
            f"The heights have a root mean square slope of {slope:.2g}; half-space elasticity takes them as small"
            f"{', this is none: are heights and lengths both in m?' if slope > 1.0 else '.'}",
            "K. L. Johnson, Contact Mechanics, Cambridge 1985, doi:10.1017/CBO9781139171731",
        )
    )
    if math.isfinite(hardness):
        notes.append(
            Note(
                Assumption.ELASTIC,
                Standing.APPROXIMATE,
                "Pressures are cut at the hardness, and what would overlap there is thought to flow; no strain is "
                "followed, and unloading is not described.",
                ALMQVIST,
            )
        )
    return (*notes, *map_notes(rough))


def border_notes(pressure: Array, periodic: bool) -> tuple[Note, ...]:
    """Return how much the border of a map that stands alone bears, if that is much.

    Parameters
    ----------
    pressure : ndarray, (nx, ny)
        [Pa]
    periodic : bool
        Whether the map is repeated.
    """
    whole = float(np.sum(pressure))
    if periodic or min(pressure.shape) < SMALLEST_WITH_BORDER or whole <= 0.0:
        return ()
    share = 1.0 - float(np.sum(pressure[1:-1, 1:-1])) / whole
    if share <= MOST_ON_BORDER:
        return ()
    return (
        Note(
            Assumption.RESOLUTION,
            Standing.APPROXIMATE,
            f"The outermost pixels bear {share:.0%} of the force: right for a stamp that ends there; of a part of a "
            "larger surface the map is too small for this load, take a larger one.",
            "sum of the pressures",
        ),
    )
