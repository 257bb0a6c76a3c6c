r"""Candidates of the noise of a curve: white noise, and white noise with a slow part.

The noise of n points in the order of measurement is described by the variances :math:`S_k` of its cosine transform,
k = 0 ... n-1, at the angular frequencies :math:`\omega_k = \pi k/n` per point: :math:`S \propto 1 + g^2\,c\,f_k`, with

.. math:: f_k = (2\sin\tfrac{\omega_k}2)^{-\alpha}, \qquad
          f_k = \frac{1-\rho^2}{1+\rho^2-2\rho\cos\omega_k} \quad\text{or}\quad f_k = \frac1{1+(k/K)^4},

a power law (1/f noise for :math:`\alpha = 1`, a random walk for 2), a first-order process with the correlation
:math:`\rho` of neighbours, or smooth wandering with about K half periods; c makes the mean of f one, and g is the root
mean square of the slow part relative to the white one.

The cosine transform diagonalises the covariance of a random walk, and that of stationary noise but for its two ends.
The likelihood of all candidates is therefore one product of matrices after one transform, n log n; a state-space model
would treat uneven times, but costs as much for each candidate.  Frequencies are gathered in bins, narrow compared with
the course of S.

References
----------
P. Whittle, Ark. Mat. 2, 423 (1953), https://doi.org/10.1007/BF02590998
"""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

SINGLE_BINS, BIN_RATIO = 64, 1.03
"""Frequencies with a bin of their own, and ratio of the ends of the others."""
EXPONENTS, EXPONENT_WEIGHTS = (1.0, 1.5, 2.0, 2.5), (0.08, 0.18, 0.62, 0.12)
"""Exponents alpha of the power law, and their prior weights."""
LEAST_RATIO, GREATEST_RATIO, RATIO_STEP = 0.04, 30.0, 1.82
"""Root mean squares g of the slow part."""
LEAST_TIME, TIME_STEP, MOST_TIME_SHARE = 0.7, 1.96, 0.1
"""Correlation times of first-order processes: least in points, ratio, and greatest in parts of the curve."""
HALF_PERIODS = (1.5, 3.0, 6.0, 12.0)
"""Numbers K of half periods of smooth wandering."""
WHITE_WEIGHT, POWER_WEIGHT, PROCESS_WEIGHT, SMOOTH_WEIGHT = 0.14, 0.55, 0.12, 0.19
"""Prior weights of white noise alone, of a power law, of a first-order process, and of smooth wandering."""
FAINT_FALL, STRONG_FALL = 1.9, 1.15
"""Prior weights of g are 1/(g^-a + g^b): few machines have a slow part far from the white one."""
LOWEST_FREQUENCY = 0.7
"""Index k at which the variance of the mean is read; a random walk from its first point on has 0.55, 1/f noise 0.7."""


class Candidates(NamedTuple):
    """Spectra of a curve's noise, in parts of its variance.

    Parameters
    ----------
    starts, sizes : ndarray, (b,)
        First index and number of the frequencies in each bin.
    spectra : ndarray, (m, b)
        Variances S, with the mean 1 over all frequencies but the first.
    precisions : ndarray, (m, b)
        Their inverses.
    logarithms : ndarray, (m,)
        Sum of ln S over all frequencies.
    priors : ndarray, (m,)
        Prior weights; their sum is 1.
    slow : ndarray, (m,)
        Part of the variance that is slow.
    """

    starts: Array
    sizes: Array
    spectra: Array
    precisions: Array
    logarithms: Array
    priors: Array
    slow: Array

    @property
    def only_white(self) -> Candidates:
        """White noise alone."""
        return self._replace(
            spectra=self.spectra[:1],
            precisions=self.precisions[:1],
            logarithms=self.logarithms[:1],
            priors=np.ones(1),
            slow=self.slow[:1],
        )


def transformed(columns: Array) -> Array:
    """Return the cosine transform ``(n, q)`` of columns ``(n, q)`` along the points; it keeps their norms."""
    from scipy.fft import dct

    return np.asarray(dct(np.ascontiguousarray(columns.T), type=2, norm="ortho")).T


@functools.lru_cache(maxsize=32)
def candidates(count: int) -> Candidates:
    """Return the candidates of the noise of `count` points."""
    starts, sizes = _bins(count)
    index = np.maximum(starts + 0.5 * (sizes - 1), LOWEST_FREQUENCY)
    omega = np.pi / count * index
    longest = max(MOST_TIME_SHARE * count, 2.0 * LEAST_TIME)
    memories = np.exp(-1.0 / np.exp(np.arange(np.log(LEAST_TIME), np.log(longest), np.log(TIME_STEP))))
    powers = [(2.0 * np.sin(0.5 * omega)) ** -exponent for exponent in EXPONENTS]
    processes = [(1.0 - r**2) / (1.0 + r**2 - 2.0 * r * np.cos(omega)) for r in memories.tolist()]
    smooth = [1.0 / (1.0 + (index / periods) ** 4) for periods in HALF_PERIODS]
    shapes = np.array([*powers, *processes, *smooth])
    shapes /= (shapes[:, 1:] @ sizes[1:] / max(count - 1, 1))[:, None] if count > 1 else 1.0
    weights = np.concatenate(
        [
            POWER_WEIGHT * np.array(EXPONENT_WEIGHTS),
            np.full(len(processes), PROCESS_WEIGHT / len(processes)),
            np.full(len(smooth), SMOOTH_WEIGHT / len(smooth)),
        ]
    )
    ratios = np.exp(np.arange(np.log(LEAST_RATIO), np.log(GREATEST_RATIO), np.log(RATIO_STEP)))
    shares = 1.0 / (ratios**-FAINT_FALL + ratios**STRONG_FALL)
    slow = ratios**2 / (1.0 + ratios**2)
    rows = (1.0 - slow)[:, None] + slow[:, None] * shapes[:, None, :]
    spectra = np.concatenate([np.ones((1, starts.size)), rows.reshape(-1, starts.size)])
    priors = np.concatenate([[WHITE_WEIGHT], np.outer(weights, shares / shares.sum()).ravel()])
    of_slow = np.concatenate([[0.0], np.tile(slow, len(shapes))])
    return Candidates(starts, sizes, spectra, 1.0 / spectra, np.log(spectra) @ sizes, priors, of_slow)


def _bins(count: int) -> tuple[Array, Array]:
    """Return first indices and sizes of the bins."""
    single = min(SINGLE_BINS, count)
    many = 2 + int(np.log(count / single) / np.log(BIN_RATIO))
    wide = np.geomspace(single, count, many).astype(int)
    starts = np.unique(np.concatenate([np.arange(single), wide[wide < count]]))
    return starts, np.diff(np.append(starts, count))
