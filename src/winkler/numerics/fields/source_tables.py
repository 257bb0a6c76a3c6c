r"""Tables of the kernels of moving and switched-on sources of heat: over the lag, and over the spread in time."""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.panels.chebyshev import fit_panels
from winkler.numerics.types import Array

NODES = 12
"""Of the rule on every piece."""
ASYMPTOTIC_LIMIT = 16.0
"""Beyond it the kernel D is its asymptotic series."""
ASYMPTOTIC_TERMS = 21
SPREAD_ASYMPTOTIC_LIMIT = 8.0
SPREAD_TERMS = 18
LINEAR_LIMIT = 1e-8
"""Below it Dawson's function is its argument."""


@functools.lru_cache(maxsize=4)
def cosine_rule(count: int = NODES) -> tuple[Array, Array]:
    """Return nodes and weights on [0, 1] of a Gauss rule in u, where the place is (1 - cos(pi u))/2."""
    u, weight = gauss_legendre(count)
    return 0.5 * (1.0 - np.cos(np.pi * u)), weight * 0.5 * np.pi * np.sin(np.pi * u)


def powers(coefficients: Array) -> Array:
    """Return Chebyshev series (panels, n) in powers of their variable, an even number of coefficients each."""
    count = coefficients.shape[1]
    matrix = np.zeros((count, count + count % 2))
    for k in range(count):
        row = np.polynomial.chebyshev.cheb2poly([0.0] * k + [1.0])
        matrix[k, : row.size] = row
    return np.asarray(coefficients @ matrix)


@functools.lru_cache(maxsize=1)
def lag_table() -> tuple[Array, Array, Array]:
    """Return D(z) as the edges and coefficients of panels below 16, and z^(3/2) D(z) as a polynomial in 1/z above."""
    from scipy.special import i0e, i1e

    near = fit_panels(lambda z: i0e(z) - i1e(z), np.array([0.0, 2.0, 6.0, ASYMPTOTIC_LIMIT]), 1e-15)
    first, second = 1.0, 1.0
    series = np.zeros(ASYMPTOTIC_TERMS)
    for k in range(1, ASYMPTOTIC_TERMS + 1):  # the coefficients of I0 and I1; their first ones cancel
        first *= (2 * k - 1) ** 2 / (8.0 * k)
        second *= ((2 * k - 1) ** 2 - 4.0) / (8.0 * k)
        series[k - 1] = (first - second) / math.sqrt(2.0 * math.pi)
    return near.edges, powers(near.coefficients), series


@functools.lru_cache(maxsize=1)
def spread_table() -> tuple[Array, Array, Array]:
    """Return Dawson's function over its argument z, as panels below 8, and z^2 times it as a series in 1/z^2 above."""
    from scipy.special import dawsn

    def over(z: Array) -> Array:
        return np.asarray(dawsn(np.maximum(z, LINEAR_LIMIT)) / np.maximum(z, LINEAR_LIMIT))

    near = fit_panels(over, np.array([0.0, 1.0, 2.0, 4.0, SPREAD_ASYMPTOTIC_LIMIT]), 1e-15)
    series = np.full(SPREAD_TERMS, 0.5)
    for k in range(1, SPREAD_TERMS):
        series[k] = series[k - 1] * (2 * k - 1) / 2.0
    return near.edges, powers(near.coefficients), series
