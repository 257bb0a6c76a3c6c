r"""Quadrature rules on [0, 1], computed once and shared.

`gauss_legendre` is exact for polynomials of degree ``2 count - 1`` and converges geometrically for analytic
integrands.  `tanh_sinh` is the trapezoidal rule in `s` after

.. math:: x(s) = \frac{1}{1 + \exp(-\pi \sinh s)} ,

whose nodes crowd double exponentially towards both ends: it integrates algebraic and logarithmic end-point
singularities, up to the inverse square root, without knowing them.  Both ends can only be resolved if the distance
of a node to the *far* end is not formed as ``1 - x``; the rule therefore returns the complements as well.

References
----------
.. [1] H. Takahasi, M. Mori, Double exponential formulas for numerical integration, Publ. RIMS 9 (1974) 721-741,
   doi:10.2977/prims/1195192451.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput

_EXPONENTIAL_SPAN = 4.0
"""Largest s of the tanh-sinh rule: nodes down to exp(-pi sinh 4) = 6e-38, whose square root is below rounding."""


def _shared(array: Array) -> Array:
    array.flags.writeable = False
    return array


@functools.lru_cache(maxsize=256)
def gauss_legendre(count: int) -> tuple[Array, Array]:
    """Return nodes and weights of the Gauss-Legendre rule on [0, 1].

    Parameters
    ----------
    count : int
        Number of nodes, at least 1.

    Returns
    -------
    nodes, weights : (count,) ndarray
        Ascending nodes and positive weights, read-only and cached.

    Examples
    --------
    >>> nodes, weights = gauss_legendre(3)
    >>> round(float(weights @ nodes**5), 15)
    0.166666666666667
    """
    if count < 1:
        raise InvalidInput(f"gauss_legendre: count is {count}; give at least 1.")
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return _shared(0.5 * (1.0 + nodes)), _shared(0.5 * weights)


def panel_nodes(edges: Array, count: int) -> tuple[Array, Array]:
    """Return nodes and weights of Gauss-Legendre rules of `count` nodes on all panels, one after the other."""
    nodes, weights = gauss_legendre(count)
    width = np.diff(edges)[:, None]
    return (edges[:-1, None] + width * nodes).ravel(), (width * weights).ravel()


def growing(first: float, last: float, ratio: float) -> list[float]:
    """Return lengths that grow by the same ratio, from the first one on, below the last: ends of panels."""
    count = math.ceil(math.log(last / first) / math.log(ratio)) if first < last else 0
    return [length for k in range(count) if (length := first * ratio**k) < last]


@functools.lru_cache(maxsize=64)
def tanh_sinh(count: int) -> tuple[Array, Array, Array]:
    """Return nodes, complements and weights of the tanh-sinh rule on [0, 1].

    Parameters
    ----------
    count : int
        Number of nodes, at least 2.  The step is ``8 / (count - 1)``; about 80 nodes give full double precision for
        integrands that are analytic inside, up to inverse square roots at the ends.

    Returns
    -------
    nodes, complements, weights : (count,) ndarray
        Ascending nodes x, the distances ``1 - x`` to the far end without cancellation, and the weights; read-only
        and cached.  Near the upper end nodes round to 1: there use the complements.

    Examples
    --------
    >>> nodes, complements, weights = tanh_sinh(81)
    >>> float(abs(weights @ complements**-0.5 - 2.0)) < 1e-14
    True
    """
    if count < 2:
        raise InvalidInput(f"tanh_sinh: count is {count}; give at least 2.")
    half = np.linspace(-_EXPONENTIAL_SPAN, _EXPONENTIAL_SPAN, count)
    half = 0.5 * (half - half[::-1])  # symmetric to the last digit
    exponential = np.exp(-np.pi * np.abs(np.sinh(half)))
    near, far = exponential / (1.0 + exponential), 1.0 / (1.0 + exponential)
    nodes = np.where(half < 0.0, near, far)
    complements = np.where(half < 0.0, far, near)
    step = 2.0 * _EXPONENTIAL_SPAN / (count - 1)
    weights = step * np.pi * np.cosh(half) * near * far
    return _shared(nodes), _shared(complements), _shared(weights)
