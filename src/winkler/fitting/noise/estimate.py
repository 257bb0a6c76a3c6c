r"""Numbers of a fit under noise that is not known: the restricted likelihood of all candidates, and their mean.

Residuals r of n points, with the derivatives J by the p fitted coordinates, are described by

.. math:: r = J\beta + B\gamma + e, \qquad \gamma \sim N(0, s^2\sigma^2), \qquad e \sim N(0, \sigma^2 V) ,

with noise e of one of the candidates V (`winkler.fitting.noise.spectra`), and slow disturbances B that the model does
not contain (`winkler.fitting.noise.disturbances`), their amplitude s zero or one of a few.  With flat priors of
:math:`\beta` and :math:`\ln\sigma`, a candidate has the restricted likelihood

.. math:: \ln L = -\tfrac12\ln|V| - \tfrac12\ln|A| - q\ln s - \tfrac{n-p}2\ln Q, \qquad A = X^TV^{-1}X + R,

with X = (J, B), the precisions R of :math:`\gamma`, and the generalised sum of squares Q.  Step and covariance are the
means over all candidates by their weights, the differences of their steps included: what the curve does not say about
its noise makes the intervals wider.

References
----------
D. A. Harville, J. Am. Stat. Assoc. 72, 320 (1977), https://doi.org/10.1080/01621459.1977.10480998
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.fitting.noise.spectra import Candidates, candidates, transformed
from winkler.numerics.types import Array

__all__ = ["NoiseEstimate", "noise_of"]

AMPLITUDES, AMPLITUDE_WEIGHTS = (0.0, 0.05, 0.5, 5.0), (0.5, 0.2, 0.15, 0.15)
"""Standard deviations s of disturbances, in parts of that of the noise, and their prior weights."""
LEAST_OWN_SHARE = 0.1
"""Least part of a disturbance that no fitted number stands for: a tilt is none where it is free."""
LEAST_SQUARES_SHARE = 1e-24
"""Least sum of squares relative to that of the residuals."""


class NoiseEstimate(NamedTuple):
    """The noise of a curve, and what it does to the numbers of a fit.

    Parameters
    ----------
    step : ndarray, (p,)
        Change of the coordinates towards generalised least squares.
    covariance : ndarray, (p, p)
        Of the coordinates.
    scatter : float
        Standard deviation of the noise, white and slow parts together.
    slow_share : float
        Part of its variance that is slow.
    effective_count : float
        Number of independent points of this scatter that would determine the coordinates as well.
    likelihood : float
        Logarithm of the likelihood of the residuals, integrated over noise and disturbances.
    spectrum : ndarray, (n,)
        Mean variances of the cosine transform, in squares of the residuals' unit.
    courses : ndarray, (n, q)
        The disturbances that no fitted number stands for already.
    amplitudes : ndarray, (q,)
        Their standard deviations, in the residuals' unit.
    disturbance : ndarray, (n,)
        The disturbances in the residuals.
    """

    step: Array
    covariance: Array
    scatter: float
    slow_share: float
    effective_count: float
    likelihood: float
    spectrum: Array
    courses: Array
    amplitudes: Array
    disturbance: Array


class _Solutions(NamedTuple):
    """Logarithms of restricted and plain likelihood, estimates, covariances and variances of m candidates."""

    restricted: Array
    plain: Array
    estimates: Array
    covariances: Array
    variances: Array


def noise_of(residuals: Array, jacobian: Array, disturbances: Array) -> NoiseEstimate:
    """Return the noise in the residuals of a fit.

    Parameters
    ----------
    residuals : ndarray, (n,)
        Weighted, in the order in which they were measured.
    jacobian : ndarray, (n, p)
        Weighted derivatives of the prediction.
    disturbances : ndarray, (n, q)
        Courses of disturbances, of unit root mean square.
    """
    count, p = jacobian.shape
    disturbances = _own(disturbances, jacobian)
    unit, size = float(np.sqrt(np.mean(residuals**2))) or 1.0, np.linalg.norm(jacobian, axis=0)
    table = candidates(count)
    products = _products(table, np.concatenate([(residuals / unit)[:, None], jacobian / size, disturbances], axis=1))
    levels = AMPLITUDES if disturbances.shape[1] else AMPLITUDES[:1]
    priors = np.log(np.outer(AMPLITUDE_WEIGHTS[: len(levels)], table.priors)) - 0.5 * table.logarithms
    found = _Solutions(*map(np.stack, zip(*[_solved(products, p, level, count) for level in levels], strict=True)))
    weights, _ = _normalised(found.restricted + priors)
    share, variances = weights.ravel(), found.variances.ravel()
    estimates = found.estimates.reshape(share.size, -1)
    mean = share @ estimates
    apart = estimates[:, :p] - mean[:p]
    covariance = np.tensordot(share, found.covariances.reshape(-1, p, p), 1) + (share[:, None] * apart).T @ apart
    variance = float(share @ variances)
    by_candidate = (weights * found.variances).sum(axis=0)
    by_level = (weights * found.variances).sum(axis=1)
    losses = np.linalg.slogdet(found.covariances)[1] - p * np.log(found.variances)
    loss = (float(np.sum(weights * losses)) + np.linalg.slogdet(products[0, 1 : 1 + p, 1 : 1 + p])[1]) / p
    amplitude = unit * float(np.sqrt(by_level @ np.square(levels)))
    return NoiseEstimate(
        step=mean[:p] * unit / size,
        covariance=covariance * unit**2 / np.outer(size, size),
        scatter=unit * float(np.sqrt(variance)),
        slow_share=float(by_candidate @ table.slow) / variance,
        effective_count=float(np.clip(count * np.exp(-loss), 1.0, count)),
        likelihood=_normalised(found.plain + priors)[1] - count * float(np.log(unit)),
        spectrum=unit**2 * np.repeat(by_candidate @ table.spectra, table.sizes),
        courses=disturbances,
        amplitudes=np.full(disturbances.shape[1], amplitude),
        disturbance=unit * (disturbances @ mean[p:]),
    )


def _own(disturbances: Array, jacobian: Array) -> Array:
    """Return the disturbances that no combination of fitted numbers, or of those before, stands for."""
    basis, chosen = np.linalg.qr(jacobian)[0], []
    for index, course in enumerate(disturbances.T):
        left = course - basis @ (basis.T @ course)
        length = float(np.linalg.norm(left))
        if length > LEAST_OWN_SHARE * float(np.linalg.norm(course)):
            chosen.append(index)
            basis = np.concatenate([basis, left[:, None] / length], axis=1)
    return np.asarray(disturbances[:, chosen])


def _products(table: Candidates, columns: Array) -> Array:
    """Return the products of columns ``(n, c)`` weighted by each candidate ``(m, c, c)``."""
    spectra = transformed(columns)
    rows, cols = np.triu_indices(columns.shape[1])
    binned = np.stack(
        [np.add.reduceat(spectra[:, i] * spectra[:, j], table.starts) for i, j in zip(rows, cols, strict=True)], axis=1
    )
    products = np.empty((table.priors.size, columns.shape[1], columns.shape[1]))
    products[:, rows, cols] = (1.0 / table.spectra) @ binned
    products[:, cols, rows] = products[:, rows, cols]
    return products


def _normalised(logarithms: Array) -> tuple[Array, float]:
    """Return weights in proportion to exponentials, and the logarithm of the sum of these."""
    highest = float(logarithms.max())
    weights = np.exp(logarithms - highest)
    whole = float(weights.sum())
    return weights / whole, highest + float(np.log(whole))


def _solved(products: Array, p: int, amplitude: float, count: int) -> _Solutions:
    """Return the solutions of all candidates for one amplitude of the disturbances."""
    m, size, _ = products.shape
    used = size - 1 if amplitude > 0.0 else p
    inner = products[:, 1 : 1 + used, 1 : 1 + used].copy()
    inner[:, range(p, used), range(p, used)] += amplitude**-2 if amplitude > 0.0 else 0.0
    prior = -(used - p) * float(np.log(amplitude)) if amplitude > 0.0 else 0.0
    inverse = np.linalg.inv(inner)
    estimates = np.zeros((m, size - 1))
    estimates[:, :used] = np.einsum("mij,mj->mi", inverse, products[:, 1 : 1 + used, 0])
    whole = products[:, 0, 0]
    squares = whole - np.einsum("mi,mi->m", estimates, products[:, 1:, 0])
    squares = np.maximum(squares, LEAST_SQUARES_SHARE * whole + np.finfo(float).tiny)
    determinant = np.linalg.slogdet(inner)[1]
    of_model = np.linalg.slogdet(products[:, 1 : 1 + p, 1 : 1 + p])[1]
    restricted = prior - 0.5 * determinant - 0.5 * (count - p) * np.log(squares)
    plain = prior - 0.5 * (determinant - of_model) - 0.5 * count * np.log(squares)
    variances = squares / max(count - p - 2, 1)
    return _Solutions(restricted, plain, estimates, inverse[:, :p, :p] * variances[:, None, None], variances)
