"""How far the contact of a height map can be trusted: border, residual, slopes, pixels."""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array, Quantity
from winkler.profiles.rough.map_notes import map_notes
from winkler.profiles.rough.topography import Topography
from winkler.values.validity import Assumption, Note, Standing, standing_left

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
        "The map repeats without end in both directions. Depths are the approach of the mean planes."
        if rough.periodic
        else (
            "The map is not periodic: nothing touches beyond its border, and pressures rise there as at the edge "
            "of a punch."
        )
    )
    overlap, left = float(np.max(penetration)), float(np.max(misfit))
    notes = [
        Note(
            Assumption.RESPONSE,
            Standing.EXACT,
            "Frictionless contact of homogeneous, linear elastic half-spaces. The pressure of every pixel "
            "displaces all other pixels.",
            POLONSKY,
        ),
        Note(Assumption.RESPONSE, Standing.EXACT, border, STANLEY if rough.periodic else POLONSKY),
        Note(
            Assumption.RESOLUTION,
            standing_left(max(overlap, left), Standing.ASYMPTOTIC),
            f"Residuals of the solver: the surfaces overlap by at most {overlap:.1g} of the depth. The work of "
            f"the pressures on the gaps is {left:.1g} of that of the force. For smooth contacts ten times the "
            "pixels along a side reduce the error of the force by a factor of 100.",
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
                f"Contact spots are about {0.5 / blurred:.2g} pixels wide. On this grid the area has an error of "
                f"about {100.0 * blurred:.2g} per cent, and the maximum pressure may be up to "
                f"{600.0 * blurred**2:.2g} per cent too "
                f"low{'; use a finer map.' if blurred > LOST_AREA_ERROR else '.'}",
                YASTREBOV,
                blurred,
            )
        )
    slope = rough.rms_slope
    notes.append(
        Note(
            Assumption.SMALL_SLOPES,
            Standing.OUTSIDE if slope > 1.0 else Standing.APPROXIMATE if slope > STEEP_SLOPE else Standing.ASYMPTOTIC,
            f"The root mean square slope of the heights is {slope:.2g}; half-space elasticity requires small "
            f"slopes{', this is none: are heights and lengths both in m?' if slope > 1.0 else '.'}",
            "K. L. Johnson, Contact Mechanics, Cambridge 1985, doi:10.1017/CBO9781139171731",
        )
    )
    if math.isfinite(hardness):
        notes.append(
            Note(
                Assumption.ELASTIC,
                Standing.APPROXIMATE,
                "Pressures are limited to the hardness; overlapping material is assumed to deform plastically. "
                "Strains are not computed, and unloading is not described.",
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
            f"The outermost pixels carry {share:.0%} of the force. This is correct for a rough punch that ends "
            "there. If the map is part of a larger surface, it is too small for this load: use a larger map.",
            "sum of the pressures",
        ),
    )
