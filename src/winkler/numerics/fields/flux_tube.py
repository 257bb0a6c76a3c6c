r"""The constriction of a disc of one voltage on the end of a round rod, relative to that on a half-space.

The field of a half-space leaves through the side of the rod; a second field, regular inside, sends it back.  Both are
superpositions of :math:`K_0(yr)\cos yz` and :math:`I_0(yr)\cos yz`, and on the line the disc of one voltage becomes

.. math:: \varphi(x) + \frac{4}{\pi^2}\int_0^\infty \frac{K_1(yb)}{I_1(yb)}\,(\cosh yx - 1)
          \int_0^a \varphi(t)\cosh yt\,\mathrm dt\,\mathrm dy = 1 .

The resistance follows from the voltage far down the rod, where what remains of it falls linearly.
"""

from __future__ import annotations

import functools

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre, panel_nodes
from winkler.numerics.types import Array

LARGEST_RADIUS_RATIO = 0.9
"""Largest radius of the disc over that of the rod."""
RULE_NODES = 32
DEGREE = 40
SERIES_LIMIT = 2.0**-12
"""Below this y the ratio of Bessel functions is known by its series."""


def relief(ratio: Array) -> Array:
    """Return the constriction resistance over that of the same disc on a half-space, rho / (4 a).

    Parameters
    ----------
    ratio : ndarray
        Radius of the disc over that of the rod, from 0 to 0.9.

    Returns
    -------
    ndarray
        From 1 down to 0.0151; ten digits.
    """
    series = np.polynomial.chebyshev.chebval(
        2.0 * np.asarray(ratio, dtype=float) / LARGEST_RADIUS_RATIO - 1.0, _series()
    )
    return np.asarray(series)


@functools.cache
def _series() -> Array:
    """Return the Chebyshev coefficients of the factor over the ratio."""
    angles = np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1)
    places = 0.5 * LARGEST_RADIUS_RATIO * (1.0 + np.cos(angles))
    reliefs = np.array([_solved(float(place)) for place in places])
    rows = np.cos(np.outer(np.arange(DEGREE + 1), angles))
    series = 2.0 / (DEGREE + 1) * rows @ reliefs
    series[0] *= 0.5
    return np.asarray(series)


def _solved(a: float) -> float:
    """Return the factor for a disc of radius a on a rod of radius 1."""
    from scipy.special import i1e, k1e

    nodes, weights = gauss_legendre(RULE_NODES)
    t, dt = a * nodes, a * weights
    # panels double from where the kernel is singular like ln y, up to where the images have died out
    edges = np.concatenate([[0.0], 2.0 ** np.arange(-40.0, 0.0), np.arange(1.0, 2.0 + 18.0 / (1.0 - a), 1.5)])
    y, dy = panel_nodes(edges, 16)
    # exp(-y) cosh(yt) and exp(-y) (cosh(yx) - 1), without cancellation and without overflow
    right = 0.5 * (np.exp(-y[:, None] * (1.0 - t)) + np.exp(-y[:, None] * (1.0 + t)))
    left = 0.5 * (np.exp(-0.5 * y[:, None] * (1.0 - t)) - np.exp(-0.5 * y[:, None] * (1.0 + t))) ** 2
    sides = k1e(y) / i1e(y)  # exp(2 y) K1 / I1
    kernel = 4.0 / np.pi**2 * (left * (sides * dy)[:, None]).T @ right
    phi = np.linalg.solve(np.eye(RULE_NODES) + kernel * dt, np.ones(RULE_NODES))
    total = float(phi @ dt)
    # K1/I1 has the pole 2 / y^2, the even flow down the rod, which is no part of the constriction
    with np.errstate(over="ignore"):
        direct = sides * np.exp(-2.0 * y) - 2.0 / y**2
    poleless = np.where(y < SERIES_LIMIT, np.log(0.5 * y) + np.euler_gamma - 0.75, direct)
    rest = poleless * total + sides * np.exp(-y) * (left @ (phi * dt))
    far = -2.0 * total / edges[-1]
    return float(a * (1.0 + 4.0 / np.pi**2 * (float(rest @ dy) + far)) / total)
