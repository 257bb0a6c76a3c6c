"""How far temperatures of contacts on maps can be trusted: conduction, motion, sharing, pixels."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array, Quantity
from winkler.problems.assumptions.temperature import temperature_note
from winkler.problems.surface_heating.state import SurfaceHeatState
from winkler.problems.surface_rolling.state import SurfaceRollingState
from winkler.values.validity import Assumption, Note, Standing, standing_left, standing_of

__all__ = ["passing_note", "surface_heating_notes"]

JAEGER = "J. C. Jaeger, Proc. R. Soc. New South Wales 76 (1942) 203-224"
BLOK = "H. Blok, Wear 6 (1963) 483-494, doi:10.1016/0043-1648(63)90283-7"
FINE, COARSE = 0.01, 0.2
"""Change of the greatest rise from pixels of twice the size up to which they count as fine, and as coarse."""

SMALL_CREEPAGE, LARGE_CREEPAGE = 0.01, 0.25
"""Change of a share up to which the speeds of both bodies count as one, and beyond which they do not."""


def passing_note(rolled: SurfaceRollingState) -> Note:
    """Return that both bodies are taken to pass at the speed of rolling."""
    creepage = float(np.max(np.abs(rolled.creep)))
    return Note(
        Assumption.CONDUCTION,
        standing_of(0.25 * creepage, SMALL_CREEPAGE, LARGE_CREEPAGE),
        f"Both bodies pass at the speed of rolling; with a slip of {creepage:.2g} of it the share of either may "
        f"differ by {25.0 * creepage:.2g} per cent.",
        JAEGER,
        0.25 * creepage,
    )


def surface_heating_notes(
    last: SurfaceHeatState,
    hottest: Quantity,
    grid_error: Quantity,
    peclets: tuple[float, float],
    bulk: tuple[float, float],
) -> tuple[Note, ...]:
    """Return what was assumed of the heat.

    Parameters
    ----------
    last : SurfaceHeatState
        The last contact.
    hottest, grid_error : float or ndarray
        Greatest temperatures [K], and their changes from pixels of twice the size.
    peclets : tuple of float
        Of both bodies [-].
    bulk : tuple of float
        Temperatures far away [K].
    """
    change = float(np.max(grid_error))
    slow = "" if max(peclets) > 1.0 else " A slow body comes to it late: heat must spread over the contact."
    touching = last.pressure > 0.0
    rise = float(np.max(hottest)) - min(bulk)
    risen = last.max_temperature - min(bulk)
    left = last.mismatch / risen if risen > 0.0 else 0.0
    return (
        Note(
            Assumption.CONDUCTION,
            Standing.EXACT,
            "Steady heat conduction in half-spaces of constant conductivity and diffusivity that pass the contact "
            f"along x, Pe = {peclets[0]:.3g} and {peclets[1]:.3g}; nothing is lost through the surface outside the "
            f"contact.{slow}",
            JAEGER,
        ),
        Note(
            Assumption.CONDUCTION,
            standing_left(left),
            "The bodies share the heat so that their surfaces have one temperature in every pixel where they touch, to "
            f"{left:.1g} of the greatest rise.",
            BLOK,
        ),
        Note(
            Assumption.RESOLUTION,
            standing_of(change, FINE, COARSE),
            f"The contact has {_most(touching, 0)} pixels along the motion and {_most(touching, 1)} across; from "
            f"pixels of twice the size the greatest rise of temperature changes by {100.0 * change:.2g} per cent.",
            "comparison of two grids",
            change,
        ),
        temperature_note(max(rise, 0.0)),
    )


def _most(touching: Array, axis: int) -> int:
    return int(np.max(np.count_nonzero(touching, axis=axis), initial=0))
