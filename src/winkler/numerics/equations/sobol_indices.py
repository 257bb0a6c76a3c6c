r"""Indices of Sobol: the part of the variance of a function that each of its independent arguments causes.

The function is known at points A, at as many other points B, and at :math:`A_B^i`, which is A with its argument *i*
taken from B:

.. math:: S_i = \frac{\overline{f_B\,(f_{AB}^i-f_A)}}{V}, \qquad
          S_{Ti} = \frac{\overline{(f_A-f_{AB}^i)^2}}{2V}

The first is the part of the variance that is gone once argument *i* is known; the second, what is left of it when all
others are.  Their intervals are percentiles over pairs that are drawn again (bootstrap).

`scipy.stats.sobol_indices` has the same estimates.  It takes a power of two of pairs only, so that no point may have
failed, and its intervals have no seed: a study would not write the same table twice.

References
----------
Saltelli, Annoni, Azzini, Campolongo, Ratto, Tarantola: Computer Physics Communications 181 (2010) 259,
doi:10.1016/j.cpc.2009.09.018 (first order)
Jansen: Analysis of variance designs for model output. Computer Physics Communications 117 (1999) 35,
doi:10.1016/S0010-4655(98)00154-4 (total order)
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

RESAMPLINGS = 1000
"""How often pairs are drawn again."""
CONFIDENCE_LEVEL = 0.95
"""Probability of the intervals."""


class SobolEstimate(NamedTuple):
    """Indices with their intervals; each array ``(arguments,)``."""

    first_order: Array
    first_order_low: Array
    first_order_high: Array
    total_order: Array
    total_order_low: Array
    total_order_high: Array


def sobol_indices(first: Array, second: Array, mixed: Array, seed: int = 0) -> SobolEstimate:
    """Return the indices of first and total order of a function, with intervals of 95 %.

    Parameters
    ----------
    first, second : ndarray, shape (pairs,)
        f at A and at B; they must not all be equal.
    mixed : ndarray, shape (arguments, pairs)
        f at A with one argument from B.
    seed : int, optional
        Of the pairs that are drawn again.
    """
    middle = float(np.mean((first + second) / 2.0))  # the estimates scatter least about the mean
    f_a, f_b, f_ab = first - middle, second - middle, mixed - middle
    best = _indices(f_a, f_b, f_ab)
    generator, pairs = np.random.default_rng(seed), len(first)
    drawn = np.empty((RESAMPLINGS, 2, len(mixed)))
    for again in drawn:
        chosen = generator.integers(pairs, size=pairs)
        again[:] = _indices(f_a[chosen], f_b[chosen], f_ab[:, chosen])
    low, high = np.quantile(drawn, [(1.0 - CONFIDENCE_LEVEL) / 2.0, (1.0 + CONFIDENCE_LEVEL) / 2.0], axis=0)
    return SobolEstimate(best[0], low[0], high[0], best[1], low[1], high[1])


def _indices(f_a: Array, f_b: Array, f_ab: Array) -> Array:
    variance = np.var(np.concatenate([f_a, f_b]))
    if variance == 0.0:  # of few pairs that were drawn again, all may be one
        return np.zeros((2, len(f_ab)))
    alone = np.mean(f_b * (f_ab - f_a), axis=1)
    total = np.mean((f_a - f_ab) ** 2, axis=1) / 2.0
    return np.asarray(np.stack([alone, total]) / variance)
