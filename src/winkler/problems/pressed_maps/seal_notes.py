"""How far the leak of a seal can be trusted: Reynolds' film, its grid, and the pressure of the fluid."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array
from winkler.values.validity import Assumption, Note, Standing, standing_of

__all__ = ["seal_notes"]

PATIR = "N. Patir, H. S. Cheng, J. Lubr. Technol. 100 (1978) 12-17, doi:10.1115/1.3453103"
DAPP = (
    "W. B. Dapp, A. Luecke, B. N. J. Persson, M. H. Mueser, Phys. Rev. Lett. 108 (2012) 244301, "
    "doi:10.1103/PhysRevLett.108.244301"
)
SMALL_CHANGE, LARGE_CHANGE = 0.05, 0.5
SMALL_SQUEEZE, LARGE_SQUEEZE = 0.1, 1.0
"""Pressure of the fluid over the mean pressure of the contact."""


def seal_notes(
    *, area: float, squeeze: float, leak: Array, change: Array, narrow: Array, overlap: Array, periodic: bool
) -> tuple[Note, ...]:
    """Return what was assumed of a film.

    Parameters
    ----------
    area
        Relative change of the area of contact from every second point, the greatest of all loads.
    squeeze
        Pressure drop over force per area of the map, the greatest of all loads.
    leak, change
        Leak rate of every load and its change from every second point.
    narrow
        Critical gap of every load.
    overlap
        Overlap that the solver of the contact left [m].
    periodic
        Whether the map is repeated.
    """
    sides = "the map is repeated across the flow" if periodic else "the sides along the flow are closed"
    notes = [
        Note(
            Assumption.RESPONSE,
            Standing.EXACT,
            "Reynolds' equation of a laminar film of a Newtonian, incompressible fluid that sticks to both bodies and "
            f"fills the gap; {sides}.",
            PATIR,
        ),
        Note(
            Assumption.EQUILIBRIUM,
            standing_of(squeeze, SMALL_SQUEEZE, LARGE_SQUEEZE),
            "The bodies are in equilibrium without the fluid, which does not press them apart: its pressure is up to "
            f"{squeeze:.2g} of the mean pressure of the contact.",
            "comparison of both pressures",
        ),
        Note(
            Assumption.RESOLUTION,
            standing_of(area, SMALL_CHANGE, LARGE_CHANGE),
            f"On all and every second point of the map areas in contact differ by up to {100.0 * area:.2g} per cent.",
            DAPP,
            area,
        ),
    ]
    open_loads = leak > 0.0
    if not np.all(open_loads):
        notes.append(
            Note(
                Assumption.RESOLUTION,
                Standing.APPROXIMATE,
                f"Under {int(np.count_nonzero(~open_loads))} of {leak.size} loads no way of pixels leads through; ways "
                "narrower than a pixel are not seen.",
                DAPP,
            )
        )
    if np.any(open_loads):
        worst = float(np.max(change[open_loads] / leak[open_loads]))
        lost = bool(np.any(narrow[open_loads] <= overlap[open_loads]))
        notes.append(
            Note(
                Assumption.RESOLUTION,
                Standing.OUTSIDE if lost else standing_of(worst, SMALL_CHANGE, LARGE_CHANGE),
                f"On all and every second point of the map leak rates differ by up to {100.0 * worst:.2g} per cent"
                + ("; the narrowest place is within what the solver left, give a smaller tolerance." if lost else "."),
                DAPP,
                worst,
            )
        )
    return tuple(notes)
