r"""Confocal coordinates of places below an ellipse, and the integrals over the confocal ellipsoids outside of a place.

With the semi-axes :math:`a\ge b`, :math:`\alpha=a^2+s`, :math:`\beta=b^2+s` the ellipsoid s is
:math:`x^2/\alpha+y^2/\beta+z^2/s=1`.  The largest root :math:`\lambda` is the ellipsoid through the place; in the
plane of the surface there are

.. math:: \omega^2(s) = 1-\frac{x^2}\alpha-\frac{y^2}\beta = \frac{(s-s_1)(s-s_2)}{\alpha\beta} , \qquad
          \lambda(\lambda-s_1)(\lambda-s_2) = z^2\,\alpha(\lambda)\beta(\lambda) .

The integrals from :math:`\lambda` to infinity are regular in :math:`\sqrt{s-s_1}`, with all singularities on the
imaginary axis, between the distances :math:`\sqrt{s_1+b^2}` and :math:`\sqrt{s_1+a^2}` from zero: one rule of Gauss in
the logarithm of this variable covers them, another one its inverse beyond.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array

BEYOND = 14
"""Nodes of the rule beyond the largest singularity."""
WITHIN, PER_LOGARITHM = 12, 6.0
"""Nodes of the rule below it: at least, and per factor e of a / b."""
MOST_STEPS = 80


class Confocal(NamedTuple):
    """Confocal coordinates of places; lengths over a, squares of lengths over a^2.

    Parameters
    ----------
    lam, first, second : ndarray
        The ellipsoid through the place, and the larger and the smaller root in the plane.
    alpha, beta : ndarray
        1 + lam and (b/a)^2 + lam.
    above : ndarray
        lam - first, accurate also where it is small.
    omega : ndarray
        z over the square root of lam.
    """

    lam: Array
    first: Array
    second: Array
    alpha: Array
    beta: Array
    above: Array
    omega: Array


class ShellRule(NamedTuple):
    """Nodes y of an integral over the square root of s - s_1, one row for each place, and their weights."""

    squared: Array
    weights: Array


def confocal(x: Array, y: Array, z: Array, ratio: float) -> Confocal:
    """Return the confocal coordinates of places, z >= 0, over the larger semi-axis along x; `ratio` is b / a."""
    focus = math.sqrt((1.0 - ratio) * (1.0 + ratio))
    apart = np.hypot(x - focus, y) * np.hypot(x + focus, y)  # s_1 - s_2
    half = 0.5 * (1.0 + ratio**2 - x * x - y * y)
    product = ratio**2 * (1.0 - x * x) - y * y
    rising = half >= 0.0
    outer = np.where(rising, -half - 0.5 * apart, -half + 0.5 * apart)
    inner = product / outer
    first, second = np.where(rising, inner, outer), np.where(rising, outer, inner)
    second = np.minimum(second, -(ratio**2))
    lam = _through(first, second, z, ratio)
    alpha, beta = 1.0 + lam, ratio**2 + lam
    small = first > 0.0
    above = np.where(
        small, z * z * alpha * beta / np.where(small, lam * (lam - second), 1.0), np.maximum(lam - first, 0.0)
    )
    omega = np.sqrt(above * (lam - second) / (alpha * beta))
    return Confocal(lam, first, second, alpha, beta, above, omega)


def _through(first: Array, second: Array, z: Array, ratio: float) -> Array:
    """Return the largest root of s (s - s_1)(s - s_2) = z^2 (1 + s)(b^2 + s), by Newton's method from above."""
    linear = first * second - z * z * (1.0 + ratio**2)
    quadratic = -(first + second) - z * z
    third = quadratic / 3.0
    spread = np.sqrt(np.maximum(third * third - linear / 3.0, 0.0))
    cubed = third**3 - 0.5 * third * linear - 0.5 * (z * ratio) ** 2
    cosine = np.clip(-cubed / np.where(spread > 0.0, spread, 1.0) ** 3, -1.0, 1.0)
    root = 2.0 * spread * np.cos(np.arccos(cosine) / 3.0) - third
    lowest = np.maximum(first, 0.0)
    lam = np.maximum(root + 1e-14 * (spread + np.abs(third)), lowest)
    for _ in range(MOST_STEPS):
        one, two = lam - first, lam - second
        missing = lam * one * two - z * z * (1.0 + lam) * (ratio**2 + lam)
        slope = one * two + lam * (one + two) - z * z * (1.0 + ratio**2 + 2.0 * lam)
        step = np.where(slope > 0.0, missing / np.where(slope > 0.0, slope, 1.0), 0.0)
        new = np.maximum(lam - step, lowest)
        if np.all(np.abs(new - lam) <= 1e-15 * lam):
            return np.asarray(new)
        lam = new
    return np.asarray(lam)


def rule(lower: Array, ground: Array, place: Confocal, ratio: float) -> ShellRule:
    """Return the nodes of integrals over y from sqrt(lower) to infinity, s = s_1 + y^2.

    Parameters
    ----------
    lower : ndarray, (n,)
        lam - s_1.
    ground : ndarray, (n,)
        s_1 + (b/a)^2: square of the distance from zero of the nearest singularity.
    place : Confocal
        Of n places.
    ratio : float
        b / a.
    """
    scale = np.sqrt(lower + np.maximum(ground, 0.0))
    end = np.sqrt(place.alpha)
    start, stop = np.arcsinh(np.sqrt(lower) / scale), np.arcsinh(end / scale)
    u, weights = gauss_legendre(WITHIN + round(PER_LOGARITHM * math.log(1.0 / ratio)))
    width = stop - start
    w = start[:, None] + width[:, None] * u
    inside = scale[:, None] * np.sinh(w)
    steps = (scale * width)[:, None] * np.cosh(w) * weights
    inverse, beyond = gauss_legendre(BEYOND)
    outside = end[:, None] / inverse
    y = np.concatenate([inside, outside], axis=1)
    return ShellRule(y * y, np.concatenate([steps, beyond * outside / inverse], axis=1))
