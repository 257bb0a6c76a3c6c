"""Pixels that press: the step of their pressures to where all of them touch, by conjugate gradients."""

from __future__ import annotations

import numpy as np

from winkler.numerics.plates.responding_grid import RespondingGrid
from winkler.numerics.plates.screened_inverse import ScreenedInverse
from winkler.numerics.types import Array

MOST_ITERATIONS = 300
"""Conjugate gradients after which a step is taken as it is; twenty to sixty are usual."""


def step_on(
    grid: RespondingGrid, kernel: Array, there: Array, wanted: Array, tolerance: float, *, balanced: bool
) -> tuple[Array, int]:
    """Return changes of pressures that displace some pixels as wanted, and the number of iterations.

    Parameters
    ----------
    grid : RespondingGrid
        The response.
    kernel : ndarray, (nx, ny)
        As of `winkler.numerics.plates.screened_inverse.kernel_of`.
    there : ndarray, (nx, ny)
        The pixels whose pressures change.
    wanted : ndarray, (nx, ny)
        Displacements.
    tolerance : float
        Greatest error of a displacement.
    balanced : bool
        Whether the changes sum to zero, displacements then being as wanted up to a constant.
    """
    inverse = ScreenedInverse(kernel, there, grid.padded == grid.shape)
    left = wanted[there]
    even = inverse(np.ones_like(left))
    whole = float(np.sum(even))

    def pressing(wrong: Array) -> Array:
        pressed = inverse(wrong)
        return pressed - (float(np.sum(pressed)) / whole) * even if balanced else pressed

    found, along, product = np.zeros_like(left), np.zeros_like(left), 0.0
    full = np.zeros(grid.shape)
    count = 0
    for count in range(MOST_ITERATIONS):  # noqa: B007
        uneven = left - float(left @ even) / whole if balanced else left
        if float(np.max(np.abs(uneven))) <= tolerance:
            break
        pressed = pressing(left)
        new = float(left @ pressed)
        if not new > 0.0:
            break
        along = pressed + (new / product) * along if product > 0.0 else pressed
        product = new
        full[there] = along
        sunk = grid.displaced(full)[there]
        bent = float(along @ sunk)
        if not bent > 0.0:
            break
        found += (new / bent) * along
        left = left - (new / bent) * sunk
    full[there] = found
    return full, count
