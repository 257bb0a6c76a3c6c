r"""The potential of flat punches of many widths on a half-plane.

At :math:`\zeta = x + \mathrm iz` below the surface a pressure p(s) has the potential

.. math:: F(\zeta) = \frac1\pi\int\frac{p(s)}{\zeta-s}\,\mathrm ds , \qquad
          F(\zeta) = \frac1\pi\int_0^a\frac{w'(c)}{\sqrt{\zeta^2-c^2}}\,\mathrm dc ,

the second where flat punches of half-widths c bear :math:`\mathrm dP = w'(c)\,\mathrm dc`.  Between two kinks of w the
variable is :math:`y = \sqrt{c^2-b^2}`, in which the densities :math:`w'\,y/c` are smooth; above a place
:math:`\eta = \sqrt{\zeta^2-b^2} = \xi + \mathrm ih` it is :math:`y = \xi + h\sinh t`: what is left is analytic in t
wherever the place lies, so that Gauss-Legendre rules on short pieces reach rounding also close to the surface.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.chunks import chunks
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.panels.chebyshev import Panels
from winkler.numerics.types import Array

NODES = 16
LONGEST_PIECE = 2.0
"""In t, on which so many nodes reach rounding."""
PLACES_PER_CHUNK = 4000


class Pile(NamedTuple):
    """Flat punches of half-widths between two kinks of w.

    Parameters
    ----------
    base
        b, the half-width of the narrowest [m].
    density
        w' y/c over y = sqrt(c^2 - b^2) [-].
    """

    base: float
    density: Panels


def potential(piles: tuple[Pile, ...], x: Array, z: Array) -> tuple[Array, Array]:
    """Return F and its derivative by zeta, for unit modulus.

    Parameters
    ----------
    piles : tuple of Pile
    x, z : ndarray, (m,)
        Positions [m], x not negative, z positive.

    Returns
    -------
    F, F' : ndarray of complex, (m,)
        [-], [1/m].
    """
    whole, slope = np.zeros((2, x.size), dtype=complex)
    for part in chunks(x.size, 1, PLACES_PER_CHUNK):
        zeta = x[part] + 1j * z[part]
        for pile in piles:
            added = _of_pile(pile, zeta)
            whole[part] += added[0]
            slope[part] += added[1]
    return whole, slope


def _of_pile(pile: Pile, zeta: Array) -> tuple[Array, Array]:
    eta = np.sqrt(zeta - pile.base) * np.sqrt(zeta + pile.base)
    xi, h = np.maximum(eta.real, 0.0), np.maximum(eta.imag, 1e-300)
    ends = np.arcsinh((pile.density.edges[None, :] - xi[:, None]) / h[:, None])
    length = np.diff(ends, axis=1)
    count = np.maximum(np.ceil(length / LONGEST_PIECE), 1.0).astype(int)
    place = np.repeat(np.repeat(np.arange(zeta.size), length.shape[1]), count.ravel())
    step = np.repeat((length / count).ravel(), count.ravel())
    number = np.arange(place.size) - np.repeat(np.cumsum(count.ravel()) - count.ravel(), count.ravel())
    start = np.repeat(ends[:, :-1].ravel(), count.ravel()) + number * step
    nodes, weights = gauss_legendre(NODES)
    t = start[:, None] + step[:, None] * nodes
    rise, width = np.sinh(t), h[place, None]
    y = np.clip(xi[place, None] + width * rise, 0.0, pile.density.edges[-1])
    root = np.sqrt(width * (1j - rise)) * np.sqrt(eta[place, None] + y)
    share = pile.density(y) * width * np.cosh(t) / root * (step[:, None] * weights)
    square = width * (1j - rise) * (eta[place, None] + y)
    first, second = share.sum(axis=1), (share / square).sum(axis=1)

    def gathered(parts: Array) -> Array:
        real, imaginary = (np.bincount(place, part, minlength=zeta.size) for part in (parts.real, parts.imag))
        return np.asarray(real + 1j * imaginary)

    return gathered(first) / np.pi, -zeta * gathered(second) / np.pi
