r"""The mean temperature of a disc under a round source of heat that moves, as one integral without cancellation.

The chord :math:`c(s)=\sqrt{1-s^2}` of the disc weighs the line load :math:`q_b` of each direction.  The factor of a
direction is the derivative of :math:`E(z)=e^{-z}I_0(z)`; integrated by parts, and over the directions first,

.. math:: \bar T = \frac2{\pi^2\lambda}\int_0^2 S(u)\,K\bigl(\tfrac{wu}2\bigr)\,\mathrm du , \qquad
          S(u) = -\frac{\mathrm d}{\mathrm du}\int_{-1}^{1-u}q(t)\,c(t+u)\,\mathrm dt , \qquad
          K(z) = \int_0^{\pi/2}E(z\cos\theta)\,\mathrm d\theta .

S is of the source alone, K of the motion alone, :math:`w = aV/\kappa`; K decays as :math:`z^{-1/2}`, and nothing is
subtracted however fast the body moves.  Lengths are counted in contact radii.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre, tanh_sinh
from winkler.numerics.types import Array, Curve

__all__ = ["disc_mean"]

OUTER_NODES = 41
INNER_NODES = 49
"""Of the double-exponential rules over u and over t: 1e-10 of the mean together."""
TURN_NODES = 48
ASYMPTOTIC_LIMIT = 40.0
"""Beyond it K is its asymptotic series."""
ASYMPTOTIC_TERMS = 20
LENGTH_RATIO = 8.0
"""Ratio of the lengths of consecutive pieces that leave the length of diffusion."""
LEAST_SQUARE = 1e-300


def disc_mean(wave: float, joints: Array, load: Curve) -> float:
    """Return the mean of lambda T over the disc.

    Parameters
    ----------
    wave : float
        a V / kappa, not negative.
    joints : ndarray
        Where the line load is not smooth, from 0 to 1.
    load : Curve
        The line load q [any], at places from -1 to 1.
    """
    marks = {0.0, 2.0, *(1.0 - joints[:-1]), *(1.0 + joints[:-1])}
    length = 1.0 / max(wave, 1.0)
    while length < 2.0:
        marks.add(length)
        length *= LENGTH_RATIO
    cuts = np.array(sorted(marks))
    node, far, weight = tanh_sinh(OUTER_NODES)
    width = np.diff(cuts)[:, None]
    u, left = (cuts[:-1, None] + width * node).ravel(), (2.0 - cuts[1:, None] + width * far).ravel()
    parts = _slopes(u, left, joints, load) * _turned(0.5 * wave * u) * (width * weight).ravel()
    return 2.0 / math.pi**2 * float(np.sum(parts))


def _slopes(u: Array, left: Array, joints: Array, load: Curve) -> Array:
    """Return S at u (n,), `left` short of 2, which is counted for itself as the last piece shrinks to nothing there."""
    ends = np.array(sorted({-1.0, 1.0, *joints[:-1], *(-joints[:-1])}))
    cuts = np.minimum(ends, 1.0 - u[:, None])
    cuts[:, -1] = 1.0 - u
    node, far, weight = tanh_sinh(INNER_NODES)
    width = np.diff(cuts)
    width[:, 0] = np.minimum(width[:, 0], left)
    width = width[..., None]
    t = cuts[:, :-1, None] + width * node
    lag = u[:, None, None]
    ahead = (1.0 - lag - cuts[:, 1:, None]) + width * far  # to where the chord ends
    slope = (t + lag) / np.sqrt(np.maximum(ahead * (1.0 + t + lag), LEAST_SQUARE))
    return np.asarray(np.sum(load(t.ravel()).reshape(t.shape) * slope * width * weight, axis=(1, 2)))


def _turned(z: Array) -> Array:
    """Return K(z)."""
    from scipy.special import i0e

    node, weight = gauss_legendre(TURN_NODES)
    near = i0e(np.minimum(z, ASYMPTOTIC_LIMIT)[:, None] * np.cos(0.5 * np.pi * node)) @ (0.5 * np.pi * weight)
    large = np.maximum(z, ASYMPTOTIC_LIMIT)
    return np.where(
        z < ASYMPTOTIC_LIMIT, near, np.polynomial.polynomial.polyval(1.0 / large, _series()) / np.sqrt(large)
    )


@functools.lru_cache(maxsize=1)
def _series() -> Array:
    """Return the coefficients of z^(1/2) K(z) in powers of 1/z, the residues of its Mellin transform."""
    from scipy.special import gammaln, rgamma

    k = np.arange(ASYMPTOTIC_TERMS)
    size = np.exp(gammaln(k + 0.5) - gammaln(k + 1.0)) * rgamma(0.75 - 0.5 * k) ** 2
    return np.asarray(0.5 * math.sqrt(math.pi) * (-1.0) ** k * size)
