r"""Boundary elements of uneven width on half-planes, and the potential of a traction that is linear between nodes.

An even traction q on an element from l to r moves the surfaces along each other at x by

.. math:: u(x) = -\frac{2q}{\pi E^*}\,[\,(x-l)\ln|x-l| - (x-r)\ln|x-r| - (r-l)\,] ,

(on bodies graded by a power k with :math:`(1-|x|^{-k})/k` in place of the logarithm), and a traction whose slope jumps
by :math:`\kappa_j` at :math:`s_j` has the potential of `winkler.problems.line.stress`

.. math:: F(\zeta) = \frac1\pi\int\frac{q(s)}{\zeta-s}\,\mathrm ds
          = \frac1\pi\sum_j\kappa_j\,(\zeta-s_j)\,[\,\ln(\zeta-s_j)-1\,] .
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.pixels.power_law import PowerLawSurface
from winkler.numerics.types import Array

FAR = 30.0
"""Distance in half-lengths from which moments of the traction are summed: the logarithms lose digits there."""
MOMENTS = 12
CHUNK = 500_000
"""Logarithms held at once."""


def summed_power(x: Array, exponent: float) -> Array:
    """Return the integral of (1 - |x|^-k) / k from 0 to places, of the logarithm for k = 0.

    Parameters
    ----------
    x : ndarray
        Of any shape.
    exponent : float
        k, below one.
    """
    logarithm = np.log(np.where(x == 0.0, 1.0, np.abs(x)))
    if exponent == 0.0:
        return np.asarray(x * logarithm - x)
    rest = 1.0 - exponent
    return np.asarray(x * (-np.expm1(-exponent * logarithm) - exponent) / (exponent * rest))


def element_compliance(edges: Array, exponent: float = 0.0) -> Array:
    """Return the displacement over 1/E* at the middles of elements by unit tractions on each of them ``(n, n)``.

    Parameters
    ----------
    edges : ndarray, (n + 1,)
        Ascending [length]; the displacement is counted from a distance of one unit of it.
    exponent : float, optional
        k of `summed_power`, whose kernel is that of half-planes unless given.
    """
    far = 0.5 * (edges[1:] + edges[:-1])[:, None] - edges
    return np.asarray(2.0 / np.pi * np.diff(summed_power(far, exponent), axis=1))


def power_elements(surface: PowerLawSurface, count: int, spacing: float, reference: float) -> Array:
    """Return the displacement 0, 1, ... elements away from an even pressure of E*/2 on one, zero a reference on.

    Parameters
    ----------
    surface : PowerLawSurface
        In the unit of the lengths.
    count : int
        How many.
    spacing, reference : float
        Width of the elements, and from where on displacements are counted.
    """
    ends = spacing / reference * (np.arange(count + 1) - 0.5)
    softer = _softer(surface, reference)
    return np.asarray(-softer * reference / math.pi * np.diff(summed_power(ends, surface.exponent)))


def power_compliance(surface: PowerLawSurface, x: Array) -> Array:
    """Return the displacement by unit line loads at distances, over E*/2 and zero at a distance of one.

    Parameters
    ----------
    surface : PowerLawSurface
        In the unit of the lengths.
    x : ndarray
        Not zero, of any shape.
    """
    k, logarithm = surface.exponent, np.log(np.abs(x))
    power = -np.expm1(-k * logarithm) / k if k else logarithm
    return np.asarray(-_softer(surface, 1.0) / math.pi * power)


def _softer(surface: PowerLawSurface, unit: float) -> float:
    """Return how far a line load moves the surface, with lengths over a unit, over half-planes [-]."""
    wave = float(surface.whole(np.array([1.0 / unit]))[0])  # 1 + M, of which the line load is the cosine transform
    return wave / (math.gamma(1.0 - surface.exponent) * float(np.sinc(0.5 * surface.exponent)))


def linear_slope(nodes: Array, x: Array, exponent: float = 0.0) -> Array:
    """Return Re F at the surface of tractions that are one at a node and fall to zero at the next ``(k, m - 2)``.

    Parameters
    ----------
    nodes : ndarray, (m,)
        Ascending; the first and the last carry nothing.
    x : ndarray, (k,)
        Places, none of them a node.
    exponent : float, optional
        k of `summed_power`: with the slope of its kernel in place of the inverse of the distance.
    """
    away = x[:, None] - nodes
    lifted = summed_power(away, exponent) if exponent else away * np.log(np.abs(away))
    return by_hats(lifted, nodes) / np.pi


def by_hats(lifted: Array, nodes: Array) -> Array:
    """Return integrals of a kernel times tractions that are one at a node and fall to zero at the next ``(k, m - 2)``.

    Parameters
    ----------
    lifted : ndarray, (k, m)
        The kernel, integrated twice, at the distances of places from nodes.
    nodes : ndarray, (m,)
        Ascending; the first and the last carry nothing.
    """
    return np.asarray(np.diff(np.diff(lifted, axis=1) / np.diff(nodes), axis=1))


def hats(nodes: Array, x: Array) -> Array:
    """Return the values at places of tractions that are one at a node and fall to zero at the next ``(k, m - 2)``."""
    share = (x[:, None] - nodes[:-1]) / np.diff(nodes)
    return np.maximum(np.minimum(share[:, :-1], 1.0 - share[:, 1:]), 0.0)


def linear_potential(nodes: Array, values: Array, x: Array, z: Array) -> tuple[Array, Array]:
    """Return F [Pa] and z F' [Pa] of a traction that is linear between nodes.

    Parameters
    ----------
    nodes, values : ndarray, (m,)
        Ascending places [m], and the traction there [Pa]; zero at both ends.
    x, z : ndarray, (n,)
        Places [m], z not negative.
    """
    middle, half = 0.5 * (nodes[0] + nodes[-1]), 0.5 * (nodes[-1] - nodes[0])
    s, zeta, deep = (nodes - middle) / half, ((x - middle) + 1j * z) / half, z / half
    slopes = np.diff(values) / np.diff(s)
    bends = np.diff(np.concatenate([[0.0], slopes, [0.0]]))
    whole, slope = np.zeros((2, zeta.size), dtype=complex)
    far = np.abs(zeta) > FAR
    near = np.flatnonzero(~far)
    for part in np.array_split(near, max(1, near.size * s.size // CHUNK)):
        away = zeta[part, None] - s
        logarithm = np.log(np.where(away == 0.0, 1.0, away))
        whole[part] = (away * (logarithm - 1.0)) @ bends / np.pi
        slope[part] = deep[part] * (logarithm @ bends) / np.pi
    if far.any():
        below, above, low, high = s[:-1], s[1:], values[:-1], values[1:]
        node, weight = np.polynomial.legendre.leggauss(MOMENTS // 2 + 1)
        t = 0.5 * (below + above)[:, None] + 0.5 * (above - below)[:, None] * node
        q = 0.5 * (low + high)[:, None] + 0.5 * (high - low)[:, None] * node
        share = 0.5 * (above - below)[:, None] * weight * q
        beyond = 1.0 / zeta[far]
        for order in range(MOMENTS):
            moment = float(np.sum(share * t**order)) / np.pi
            whole[far] += moment * beyond ** (order + 1)
            slope[far] -= deep[far] * (order + 1) * moment * beyond ** (order + 2)
    return whole, slope
