r"""Struve's functions of order zero and one, fast enough for quadrature.

Up to t = 40 the smooth ratios :math:`\mathbf H_\nu(t)/t^{\nu+1}` are read from Chebyshev panels, which are made once
from

.. math:: \mathbf H_\nu(t) = \frac{2\,t^\nu}{\pi} \int_0^{\pi/2} \sin(t\cos\theta)\,\sin^{2\nu}\theta\,\mathrm d\theta
          \qquad (\nu = 0, 1) ;

beyond, the asymptotic series [1]_

.. math:: \mathbf H_\nu(t) - Y_\nu(t) \sim \frac1\pi \sum_k
          \frac{\Gamma(k+\frac12)}{\Gamma(\nu+\frac12-k)} \Big(\frac t2\Big)^{\nu-2k-1}

is good to rounding.  scipy.special is loaded where its Bessel functions are needed.

References
----------
.. [1] NIST Digital Library of Mathematical Functions, section 11.6.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.types import Array

ASYMPTOTIC_LIMIT = 40.0
"""From here on the asymptotic series is used: its smallest term is exp(-40)."""
ASYMPTOTIC_TERMS = 16


def struve(order: int, t: Array) -> Array:
    """Return Struve's function.

    Parameters
    ----------
    order
        0 or 1.
    t : ndarray, any shape
        Arguments, not negative.

    Returns
    -------
    ndarray of the shape of t
        To 1e-15 of t^(order + 1) or of the function's amplitude, whichever is smaller.
    """
    t = np.asarray(t, dtype=float)
    result = np.empty(t.shape)
    near = t < ASYMPTOTIC_LIMIT
    inner = t[near]
    result[near] = _table(order)(inner) * inner ** (order + 1)
    outer = t[~near]
    if outer.size:
        from scipy.special import y0, y1

        result[~near] = (y0 if order == 0 else y1)(outer) + _difference(order, outer)
    return result


@functools.lru_cache(maxsize=2)
def _table(order: int) -> Panels:
    nodes, weights = gauss_legendre(96)
    angle, weights = 0.5 * math.pi * nodes, weights * np.sin(0.5 * math.pi * nodes) ** (2 * order)
    cosine = np.cos(angle)

    def ratio(t: Array) -> Array:
        return np.asarray((np.sin(t[..., None] * cosine) / t[..., None]) @ weights)

    return fit_panels(ratio, np.linspace(0.0, ASYMPTOTIC_LIMIT, 21), 1e-16)


def _difference(order: int, t: Array) -> Array:
    """Return H - Y, nested from the last term inwards."""
    square = (2.0 / t) ** 2
    total = np.zeros_like(t)
    for k in range(ASYMPTOTIC_TERMS - 1, -1, -1):
        total = _coefficient(order, k) + square * total
    return np.asarray(total * (0.5 * t) ** (order - 1) / math.pi)


@functools.lru_cache(maxsize=2 * ASYMPTOTIC_TERMS)
def _coefficient(order: int, k: int) -> float:
    return math.gamma(k + 0.5) / math.gamma(order + 0.5 - k)
