r"""Flux through an interface whose resistance differs from place to place, between two conducting bodies.

With the unit drop of potential far away, the flux q of every pixel obeys

.. math:: r\,q + \frac{\rho_1+\rho_2}{2\pi}\int\frac{q}{|\mathbf r-\mathbf r'|}\,\mathrm dA' = 1 ,

where r is the resistance times area of the interface there: conjugate gradients on a grid.  Layers change the response
to the flux as they change that to a pressure (`winkler.numerics.pixels.layered`).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.pixels.layered import SurfaceBelow
from winkler.numerics.surfaces.surface_grid import SurfaceGrid
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

MOST_ITERATIONS = 3000
"""A hundred are usual."""


class JointFlux(NamedTuple):
    """Flux per unit drop of potential.

    Parameters
    ----------
    flux : ndarray, (nx, ny)
        Per area; zero where nothing passes.
    whole : float
        Through all of the interface; its error is of the order of the square of the tolerance.
    residual : float
        Greatest drop out of balance.
    """

    flux: Array
    whole: float
    residual: float


def joint_flux(
    resistance: Array,
    pixel: tuple[float, float],
    spreading: float,
    *,
    periodic: bool,
    tolerance: float = 1e-6,
    layers: SurfaceBelow | None = None,
) -> JointFlux:
    """Return the flux through an interface, for a unit drop of potential far away from it.

    Of a periodic interface the drop is what comes on top of that of the bodies without an interface.

    Parameters
    ----------
    resistance
        r, (nx, ny): resistance times area, not negative; infinite where nothing passes.  Of a periodic interface it is
        positive somewhere.
    pixel
        Sides of a pixel [m].
    spreading
        Sum of the resistivities of both bodies, at their surfaces.
    periodic
        Whether the interface is repeated, or nothing passes outside of the grid.
    tolerance
        Greatest drop out of balance, in parts of the whole.
    layers
        What lies below the surfaces, together; nothing else unless given.

    Raises
    ------
    NotConverged
        If the tolerance is not met.
    OutsideValidity
        If the pixels are too coarse for the layers.
    """
    there = np.isfinite(resistance)
    if not there.any():
        return JointFlux(np.zeros(resistance.shape), 0.0, 0.0)
    unit = 0.5 * spreading * pixel[0]
    local = np.where(there, resistance, 0.0) / unit
    shape = (resistance.shape[0], resistance.shape[1])
    below = layers.in_units_of(pixel[0]) if layers else None
    grid = SurfaceGrid.of(shape, (1.0, pixel[1] / pixel[0]), periodic=periodic, layers=below)
    alone = np.zeros(shape)
    alone[0, 0] = 1.0
    weight = np.where(there, 1.0 / (local + float(grid.displaced(alone)[0, 0])), 0.0)

    def dropped(flux: Array) -> Array:
        return np.where(there, local * flux + grid.displaced(flux), 0.0)

    wanted = there.astype(float)
    flux = weight * wanted
    wrong = wanted - dropped(flux)
    along, before = np.zeros(shape), 0.0
    for _ in range(MOST_ITERATIONS):
        left = float(np.max(np.abs(wrong)))
        if left <= tolerance:
            area = pixel[0] * pixel[1]
            # q (2 - A q) is stationary at the solution
            return JointFlux(flux / unit, float(np.sum(flux * (wanted + wrong))) * area / unit, left)
        downhill = weight * wrong
        now = float(np.sum(wrong * downhill))
        along = downhill + (now / before if before > 0.0 else 0.0) * along
        sunk = dropped(along)
        length = now / float(np.sum(along * sunk))
        flux, wrong, before = flux + length * along, wrong - length * sunk, now
    raise NotConverged(
        f"the flux through {int(np.count_nonzero(there))} pixels was not found; give the map other pixels, or a larger "
        "tolerance."
    )
