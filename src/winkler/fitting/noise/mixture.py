r"""Numbers under noise that is not known, as a mixture: estimates and covariances of each candidate, and weights.

A half-width h of the interval about the mean that holds a part c of the mixture solves

.. math:: \sum_k w_k \left[\Phi\left(\frac{h-x_k}{s_k}\right) - \Phi\left(\frac{-h-x_k}{s_k}\right)\right] = c ,

with the estimates :math:`x_k` less their mean, and the errors :math:`s_k`.  The standard deviation of a mixture alone
does not state it: a little weight of very slow noise widens the deviation more than the interval, or less.

References
----------
JCGM 101:2008, Evaluation of measurement data, Supplement 1 (intervals from a distribution, not from its deviation)
"""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

SIGMAS = (1.0, 1.644853627, 1.959963985, 2.575829304, 3.0)
"""Half-widths of a normal distribution, in standard deviations, that hold the stated parts: 68, 90, 95, 99, 99.7 %."""
FARTHEST = 20.0
"""Greatest half-width, in standard errors: by Chebyshev's inequality 99.75 % lie within."""
SETTLED = 3e-3
"""Last step of Newton's method for a half-width, in standard errors; the next one is about its square: 1e-5."""
FAR = 12.0
"""Distance in errors beyond which a normal distribution is 0 or 1; the densities of numbers below 1e-308 take long."""
MOST_STEPS = 60
LEAST_BEYOND = 1e-6
"""Least part beyond a half-width, over that wanted, of which the logarithm is taken: rounding may leave none."""
UNCOUNTED = 1e-7
"""Weight of the least likely candidates together that no half-width counts."""


class _MixtureFields(NamedTuple):
    shares: Array
    steps: Array
    covariances: Array


class Mixture(_MixtureFields):
    """Weights ``(m,)``, steps ``(m, p)`` and covariances ``(m, p, p)`` of the likely candidates."""

    @functools.cached_property
    def mean(self) -> Array:
        """Mean step ``(p,)``."""
        return np.asarray(self.shares @ self.steps)

    @functools.cached_property
    def covariance(self) -> Array:
        """Of the mixture, the differences of the steps included ``(p, p)``."""
        apart = self.steps - self.mean
        return np.asarray(np.tensordot(self.shares, self.covariances, 1) + (self.shares[:, None] * apart).T @ apart)

    @functools.cached_property
    def reaches(self) -> Array:
        """Half-widths ``(p, 5)`` of the intervals of 68, 90, 95, 99 and 99.7 %, in standard errors."""
        from scipy.special import ndtr

        order = np.argsort(self.shares)
        counted = order[np.cumsum(self.shares[order]) > UNCOUNTED]
        shares, deviations = self.shares[counted], np.sqrt(np.diag(self.covariance))
        errors = (np.sqrt(np.einsum("mii->im", self.covariances[counted])) / deviations[:, None])[:, None]
        apart = ((self.steps[counted] - self.mean) / deviations).T[:, None] / errors
        outside = 2.0 * ndtr(-np.array(SIGMAS))
        low, high = np.zeros((deviations.size, len(SIGMAS))), np.full((deviations.size, len(SIGMAS)), FARTHEST)
        width = np.broadcast_to(np.array(SIGMAS), low.shape)
        for _ in range(MOST_STEPS):
            wide = width[:, :, None] / errors
            ends = np.clip([apart - wide, -apart - wide], -FAR, FAR)
            beyond = ndtr(ends).sum(axis=0) @ shares
            density = (np.exp(-0.5 * ends**2).sum(axis=0) / errors) @ shares
            low, high = np.where(beyond > outside, width, low), np.where(beyond > outside, high, width)
            # the logarithm of what lies beyond is nearly straight far out, and curved a little near the middle
            rest = beyond * np.log(np.maximum(beyond / outside, LEAST_BEYOND))
            step = np.divide(rest * np.sqrt(2.0 * np.pi), density, out=np.full_like(low, np.inf), where=density > 0.0)
            inside = (width + step >= low) & (width + step <= high)
            step = np.where(inside, step, 0.5 * (low + high) - width)
            width = width + step
            if inside.all() and float(np.max(np.abs(step))) < SETTLED:
                break
        return width
