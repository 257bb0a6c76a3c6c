r"""One spectrum of noise for all parts of a curve, and what it does to least-squares fits of each part.

The residuals of a part have the variances :math:`\sigma_i^2\,(1 + (\omega_c/\omega)^\alpha)` in their cosine transform,
with a level :math:`\sigma_i` of their own, but the same exponent and the same frequency :math:`\omega_c` per point at
which
slow and white noise are equal.  The restricted likelihoods of all parts are multiplied; covariances are means over the
candidates by that weight.  A part of a hundred points alone hardly knows its slow noise; all parts together do.

References
----------
D. A. Harville, J. Am. Stat. Assoc. 72, 320 (1977), https://doi.org/10.1080/01621459.1977.10480998
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.fitting.noise.spectra import transformed
from winkler.numerics.types import Array

__all__ = ["NoiseRecord", "PooledNoise", "pooled_noise"]

EXPONENTS = (1.0, 1.5, 2.0)
CROSSINGS = np.geomspace(1e-4, 2.0, 20)
"""Frequencies omega_c [rad per point] at which slow and white noise are equal."""


class NoiseRecord(NamedTuple):
    """Residuals ``(n,)`` of a fit in the order of measurement, and the derivatives of its prediction ``(n, p)``."""

    residuals: Array
    jacobian: Array


class PooledNoise(NamedTuple):
    """Covariances ``(p, p)`` of the fitted numbers of each part, and variances of white and slow noise of each."""

    covariances: list[Array]
    white_variances: list[float]
    slow_variances: list[float]


def pooled_noise(records: list[NoiseRecord], count: int) -> PooledNoise:
    """Return covariances of least-squares numbers under a common spectrum.

    Parameters
    ----------
    records : list of NoiseRecord
    count : int
        Number of points of the whole curve: the slow variance is that over its length.
    """
    candidates = [(crossing, exponent) for exponent in EXPONENTS for crossing in CROSSINGS]
    likelihoods = np.zeros(len(candidates))
    variances, covariances = np.zeros((len(records), len(candidates))), []
    for place, record in enumerate(records):
        likelihood, variances[place], each = _under(record, candidates)
        likelihoods += likelihood
        covariances.append(each)
    weights = np.exp(likelihoods - likelihoods.max())
    weights /= weights.sum()
    frequency = np.pi * np.arange(1, count) / count
    slow = np.array([np.mean((crossing / frequency) ** exponent) for crossing, exponent in candidates])
    return PooledNoise(
        [np.asarray(np.tensordot(weights, each, 1)) for each in covariances],
        [float(weights @ variance) for variance in variances],
        [float(weights @ (variance * slow)) for variance in variances],
    )


def _under(record: NoiseRecord, candidates: list[tuple[float, float]]) -> tuple[Array, Array, Array]:
    """Return restricted likelihoods, white variances, and covariances ``(m, p, p)`` of all candidates."""
    size = np.linalg.norm(record.jacobian, axis=0)
    unit = float(np.sqrt(np.mean(record.residuals**2))) or np.finfo(float).tiny
    columns = transformed(np.concatenate([(record.residuals / unit)[:, None], record.jacobian / size], axis=1))
    count, p = record.jacobian.shape
    frequency = np.pi * np.maximum(np.arange(count), 0.5) / count
    spectra = np.stack([1.0 + (crossing / frequency) ** exponent for crossing, exponent in candidates])
    pairs = columns[:, :, None] * columns[:, None, :]
    products = np.tensordot(1.0 / spectra, pairs, 1)
    inner = products[:, 1:, 1:]
    solved = np.linalg.solve(inner, products[:, 1:, :1])[:, :, 0]
    squares = np.maximum(products[:, 0, 0] - np.einsum("mi,mi->m", solved, products[:, 1:, 0]), 1e-12)
    logarithms = np.sum(np.log(spectra), axis=1) + np.linalg.slogdet(inner)[1] + (count - p) * np.log(squares)
    variances = squares / max(count - p - 2, 1)
    plain = np.linalg.inv(pairs[:, 1:, 1:].sum(axis=0))
    spread = np.tensordot(spectra, pairs[:, 1:, 1:], 1)
    covariances = plain @ spread @ plain * variances[:, None, None] * unit**2 / np.outer(size, size)
    return -0.5 * logarithms, variances * unit**2, covariances
