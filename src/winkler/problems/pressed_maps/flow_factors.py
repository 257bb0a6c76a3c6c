r"""Flow through the gap between a rigid rough surface and a flat: Patir and Cheng's pressure flow factors.

At the distance h of the mean planes the film is as wide as :math:`h-z`, and zero where summits would overlap.  The flow
factor is the flow along a direction over that between smooth planes at the same distance, :math:`h^3/12\eta` for a unit
gradient of the pressure.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.films.joined import widest_path
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.pressed_maps.seal_states import passage
from winkler.profiles.rough.topography import Topography
from winkler.values.checks.number_checks import affordable
from winkler.values.errors import InvalidInput
from winkler.values.limits import MOST_FILM_PIXELS
from winkler.values.value import value, words


@value
class FlowFactors:
    """Flow through a rough gap divided by the flow between smooth planes.

    Parameters
    ----------
    separation : ndarray, (n,)
        Distances of the mean planes h [m].
    flow_factor, lateral_flow_factor : ndarray, (n,)
        Patir and Cheng's pressure flow factors along x and y [-]; zero if no open path exists.
    mean_gap : ndarray, (n,)
        Mean film thickness [m]; it counts as zero where asperities overlap.
    overlap_share : ndarray, (n,)
        Fraction of the map in which asperities overlap [-].
    closing_separation, lateral_closing_separation : float
        Distance h [m] at which the last open path along x and along y closes: the percolation threshold of the map.
    """

    __words__ = words(
        separation=("h", "m", "distance of the mean planes"),
        flow_factor=(r"\phi_x", "", "flow along x over that between smooth planes at the same distance"),
        lateral_flow_factor=(r"\phi_y", "", "flow along y over that between smooth planes at the same distance"),
        overlap_share=("", "", "part of the map where summits overlap"),
        closing_separation=("h_c", "m", "distance of the mean planes where the last path along x closes"),
        lateral_closing_separation=("h_{c,y}", "m", "distance of the mean planes where the last path along y closes"),
    )

    separation: Array
    flow_factor: Array
    lateral_flow_factor: Array
    mean_gap: Array
    overlap_share: Array
    closing_separation: float
    lateral_closing_separation: float


def flow_factors(surface: Topography, separations: ArrayLike) -> FlowFactors:
    """Return the pressure flow factors of a surface that does not deform.

    In `Seal` the surface is deformed, and the factor refers to a film as thick as the mean gap. At large distances
    both factors agree.

    Parameters
    ----------
    surface : Topography
        Sum of the heights of both surfaces. Boundary conditions at its sides are those of `Seal`.
    separations : array_like
        Distances of the mean planes [m], positive.

    Raises
    ------
    InvalidInput
        If a separation is not positive, heights are missing, or the map has more than 2048 x 2048 pixels.

    References
    ----------
    N. Patir, H. S. Cheng, J. Lubr. Technol. 100 (1978) 12-17, doi:10.1115/1.3453103

    Examples
    --------
    Sinusoidal grooves of amplitude A at the distance 2 A: along them the mean of the cube, 1 + 3/8.

    >>> z = 1e-6 * np.cos(2.0 * np.pi * (np.arange(64) + 0.5) / 64)
    >>> grooves = Topography(z + np.zeros((64, 1)), [1e-3, 1e-3], periodic=True)
    >>> round(float(flow_factors(grooves, [2e-6]).flow_factor[0]), 4)
    1.375
    """
    if surface.missing:
        raise InvalidInput(f"flow_factors: {surface.missing} heights are missing; use surface.filled() first.")
    affordable("flow_factors", "pixels", surface.heights.size, MOST_FILM_PIXELS)
    try:
        distances = np.atleast_1d(np.asarray(separations, dtype=float))
    except (TypeError, ValueError):
        distances = np.array([np.nan])
    if distances.ndim != 1 or not np.all(np.isfinite(distances) & (distances > 0.0)):
        raise InvalidInput("flow_factors: separations must be positive numbers in m; give those of the mean planes.")
    z = surface.heights - float(np.mean(surface.heights))
    lx, ly = (float(length) for length in surface.lengths)
    rows = []
    for distance in distances.tolist():
        gap = np.maximum(distance - z, 0.0)
        ahead, aside = passage(gap, surface), passage(gap, surface, lateral=True)
        rows.append(
            (
                ahead.flow.rate / (ly / lx * distance**3),
                aside.flow.rate / (lx / ly * distance**3),
                float(np.mean(gap)),
                float(np.mean(gap == 0.0)),
            )
        )
    top = float(np.max(z))
    deep = top - z
    along, across, mean, share = (np.asarray(column) for column in np.array(rows).reshape(-1, 4).T)
    closed, closed_across = (top - widest_path(width, wraps=surface.periodic).gap for width in (deep, deep.T))
    return FlowFactors(distances, along, across, mean, share, closed, closed_across)
