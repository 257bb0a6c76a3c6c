r"""Creep from elastic answers at a few real rates: sums of exponentials whose coefficients may be anything.

By the correspondence what relaxes answers at a real rate s like something elastic.  Whatever is linear in compliances
is then a sum of exponentials in time,

.. math:: A(t) = A_0 + \sum_j A_j\,\big(1-e^{-t/\lambda_j}\big) , \qquad
          \tilde A(s) = A_0 + \sum_j \frac{A_j}{1+s\lambda_j} ,

and the :math:`A_j` are linear in the elastic answers: numbers, matrices and kernels alike.  Times lie evenly in the
logarithm, and rates are their inverses.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

SPACING, MARGIN = 0.5, 2
"""Of the logarithms of the times, and times beyond the shortest and the longest one: errors below 1e-4."""
CUTOFF = 1e-10
"""Singular values below this part of the largest one are left out of the fit."""
LIMIT_WEIGHT = 100.0
"""Of what is left after all time, against that of one rate."""


class RateFit(NamedTuple):
    """The rates at which answers are asked, and how these are put together.

    Parameters
    ----------
    times : ndarray, (k,)
        lambda_j [s], ascending.
    rates : ndarray, (m,)
        s [1/s]: infinite, zero, and some between them.
    shares : ndarray, (1 + k, m)
        A_0 and the A_j, over the answers at all rates.
    """

    times: Array
    rates: Array
    shares: Array

    def terms(self, answers: Array) -> Array:
        """Return A_0 and the A_j ``(1 + k, ...)`` from what is answered at all rates ``(m, ...)``."""
        return np.asarray(np.tensordot(self.shares, answers, 1))


def fit_rates(times: tuple[float, float], share: Callable[[Array], Array]) -> RateFit:
    """Return the rates at which answers are asked.

    Parameters
    ----------
    times : (float, float)
        Between which the retardation times lie [s].
    share : callable
        The smallest compliance at rates [1/s] ``(m,)`` over that after all time: in proportion to it errors are
        weighed.
    """
    low, high = math.log(times[0]) - MARGIN * SPACING, math.log(times[1]) + MARGIN * SPACING
    count = math.ceil((high - low) / SPACING) + 1
    kept = np.exp(np.linspace(low, high, count))
    rates = np.append(0.0, np.exp(np.linspace(-high - SPACING, SPACING - low, count + 2)))
    weights = 1.0 / share(rates)
    weights[0] *= LIMIT_WEIGHT
    weighted = weights[:, None] / (1.0 + rates[:, None] * kept)
    size = np.linalg.norm(weighted, axis=0)
    inverse = np.linalg.pinv(weighted / size, rcond=CUTOFF) / size[:, None] * weights
    sudden = np.append(1.0, -inverse.sum(axis=1))  # what creeps is the answer less the sudden one
    return RateFit(kept, np.append(np.inf, rates), np.column_stack([sudden, np.pad(inverse, ((1, 0), (0, 0)))]))
