"""How far temperatures of contacts on maps can be trusted: conduction, motion, sharing, pixels."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array, Quantity
from winkler.problems.assumptions.temperature import temperature_note
from winkler.problems.surface_heating.state import SurfaceHeatState
from winkler.problems.surface_rolling.state import SurfaceRollingState
from winkler.values.validity import Assumption, Note, Standing, standing_left, standing_of

JAEGER = "J. C. Jaeger, Proc. R. Soc. New South Wales 76 (1942) 203-224"
BLOK = "H. Blok, Wear 6 (1963) 483-494, doi:10.1016/0043-1648(63)90283-7"
FINE, COARSE = 0.01, 0.2
"""Change of the greatest rise from pixels of twice the size up to which they count as fine, and as coarse."""

SMALL_CREEPAGE, LARGE_CREEPAGE = 0.01, 0.25
"""Change of a share up to which the speeds of both bodies count as one, and beyond which they do not."""
NARROW_ZONE = 2.0
"""Pixels across a slip zone below which its loss is off by more than a per cent; by a tenth where it is one wide."""


def slip_zone_note(state: SurfaceHeatState) -> Note:
    """Return by how many pixels the zone is resolved that slips in a cycle."""
    touching = state.pressure > 0.0
    padded = np.pad(touching, 1)
    inside = padded[2:, 1:-1] & padded[:-2, 1:-1] & padded[1:-1, 2:] & padded[1:-1, :-2]
    width = np.count_nonzero(state.flux > 0.0) / np.count_nonzero(touching & ~inside)
    return Note(
        Assumption.RESOLUTION,
        Standing.ASYMPTOTIC if width >= NARROW_ZONE or np.all(state.flux[touching] > 0.0) else Standing.APPROXIMATE,
        f"In a cycle {np.count_nonzero(state.flux > 0.0)} of {np.count_nonzero(touching)} pixels slip, "
        f"about {width:.2g} for each pixel at the edge of the contact. With one for each the loss is wrong by about "
        "ten per cent, with two by one per cent.",
        "comparison with round contacts",
    )


def passing_note(rolled: SurfaceRollingState) -> Note:
    """Return that both bodies are taken to pass at the speed of rolling."""
    creepage = float(np.max(np.abs(rolled.creep)))
    return Note(
        Assumption.CONDUCTION,
        standing_of(0.25 * creepage, SMALL_CREEPAGE, LARGE_CREEPAGE),
        f"Both bodies are assumed to pass the contact at the rolling speed. The slip velocity is {creepage:.2g} "
        f"of this speed. The slip may change each body's share of the heat by {25.0 * creepage:.2g} per cent.",
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
    slow = "" if max(peclets) > 1.0 else " A slow body reaches this state late, after heat has spread over the contact."
    touching = last.pressure > 0.0
    rise = float(np.max(hottest)) - min(bulk)
    risen = last.max_temperature - min(bulk)
    left = last.mismatch / risen if risen > 0.0 else 0.0
    return (
        Note(
            Assumption.CONDUCTION,
            Standing.EXACT,
            "Steady heat conduction in half-spaces of constant conductivity and diffusivity that pass the "
            f"contact along x (Pe = {peclets[0]:.3g} and {peclets[1]:.3g}). No heat leaves the surface outside "
            f"the contact.{slow}",
            JAEGER,
        ),
        Note(
            Assumption.CONDUCTION,
            standing_left(left),
            "The heat partition gives both surfaces one temperature in every pixel of the contact, within "
            f"{left:.1g} of the maximum temperature rise.",
            BLOK,
        ),
        Note(
            Assumption.RESOLUTION,
            standing_of(change, FINE, COARSE),
            f"The contact has {_most(touching, 0)} pixels along the motion and {_most(touching, 1)} across. With "
            f"pixels of twice the size the maximum temperature rise changes by {100.0 * change:.2g} per cent.",
            "comparison of two grids",
            change,
        ),
        temperature_note(max(rise, 0.0)),
    )


def _most(touching: Array, axis: int) -> int:
    return int(np.max(np.count_nonzero(touching, axis=axis), initial=0))
