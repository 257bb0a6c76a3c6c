r"""The noise of a curve: its autocorrelation and equivalent number of independent points.

Neighbouring points of a force curve are rarely independent.  The residuals :math:`e_i` are described by an
autoregressive process :math:`e_i = \sum_k\varphi_k e_{i-k} + \epsilon_i`, whose order follows from Schwarz' criterion.
Its correlations :math:`\rho_k` give the number of independent points of the curve, and the covariance of a
least-squares fit with the Jacobian J,

.. math:: n_\mathrm{eff} = \frac n{1+2\sum_k\rho_k}, \qquad
          \mathrm{cov} = \sigma^2\,(J^TJ)^{-1}\,J^TRJ\,(J^TJ)^{-1}, \qquad R_{ij} = \rho_{|i-j|} .

A fit absorbs part of the noise, mostly its slow part: with the projection :math:`H = J(J^TJ)^{-1}J^T` residuals
have the covariance :math:`(1-H)R(1-H)`, not R.  The missing lags are added to those of
the residuals once.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

__all__ = ["Memory", "memory", "memory_of_fit", "spread"]

HIGHEST_ORDER = 10
POINTS_PER_COEFFICIENT = 20
"""Points required for each coefficient."""
LEAST_EIGENVALUE = 1e-4
"""Least eigenvalue of corrected correlations; a first-order process of 0.999 has 5e-4."""
MOST_PARTIAL_CORRELATION = 0.9999
"""Largest partial correlation, so that the process decays."""


class Memory(NamedTuple):
    """Correlations rho_0 = 1, rho_1 ... ``(n,)`` of noise, and the equivalent number of independent points."""

    correlations: Array
    effective_count: float


def memory(residuals: Array) -> Memory:
    """Return the autocorrelation of residuals.

    Parameters
    ----------
    residuals : ndarray, (n,)
        In the order in which they were measured.
    """
    n = residuals.size
    sums = _lag_sums(residuals)
    return _process(sums / sums[0], n) if sums[0] > 0.0 else _process(np.ones(1), n)


def memory_of_fit(residuals: Array, jacobian: Array) -> Memory:
    """Return the autocorrelation of the noise of a fit from its residuals.

    Parameters
    ----------
    residuals : ndarray, (n,)
        In the order in which they were measured.
    jacobian : ndarray, (n, p)
        Derivatives of the fitted forces, in any units.
    """
    from scipy.linalg import matmul_toeplitz, toeplitz

    uncorrected = memory(residuals)
    n, sums = residuals.size, _lag_sums(residuals)
    if sums.size == 1 or not sums[0] > 0.0:
        return uncorrected
    basis = np.linalg.qr(jacobian)[0]
    transformed = matmul_toeplitz(uncorrected.correlations, basis)
    both = transformed - basis @ (basis.T @ transformed)
    absorbed = [np.sum(basis[: n - k] * both[k:] + transformed[: n - k] * basis[k:]) for k in range(sums.size)]
    variance = sums[0] / max(n - float(absorbed[0]), 1.0)
    lags = (sums / variance + np.array(absorbed)) / (n - np.arange(sums.size))
    is_positive = float(np.linalg.eigvalsh(toeplitz(lags / lags[0]))[0]) > LEAST_EIGENVALUE
    return _process(lags / lags[0], n) if is_positive else uncorrected  # a misfit is more correlated than noise


def _lag_sums(residuals: Array) -> Array:
    """Return the sums of products of residuals at lags 0, 1, 2 ... up to the highest order."""
    n = residuals.size
    highest = min(HIGHEST_ORDER, n // POINTS_PER_COEFFICIENT)
    return np.array([residuals[: n - k] @ residuals[k:] for k in range(highest + 1)])


def _process(lags: Array, n: int) -> Memory:
    """Return the autoregressive process of n points with the correlations `lags`, its order chosen."""
    white = np.zeros(n)
    white[0] = 1.0
    coefficients, remaining = np.zeros(0), 1.0
    best, chosen, chosen_remaining = 0.0, coefficients, remaining
    for order in range(1, lags.size):  # Levinson's recursion
        partial = (lags[order] - coefficients @ lags[order - 1 : 0 : -1]) / remaining
        partial = float(np.clip(partial, -MOST_PARTIAL_CORRELATION, MOST_PARTIAL_CORRELATION))
        coefficients = np.append(coefficients - partial * coefficients[::-1], partial)
        remaining *= 1.0 - partial**2
        score = n * np.log(remaining) + order * np.log(n)
        if score < best:
            best, chosen, chosen_remaining = score, coefficients, remaining
    if not chosen.size:
        return Memory(white, float(n))
    correlations = np.empty(n)
    order = chosen.size
    correlations[: order + 1] = lags[: order + 1]
    for k in range(order + 1, n):
        correlations[k] = chosen @ correlations[k - 1 : k - order - 1 : -1]
    whole = chosen_remaining / (1.0 - chosen.sum()) ** 2  # 1 + 2 sum of all correlations
    return Memory(correlations, float(np.clip(n / whole, 1.0, n)))


def spread(jacobian: Array, correlations: Array) -> tuple[Array, float]:
    """Return the covariance of least squares under noise of unit variance, and the degrees of freedom used.

    Parameters
    ----------
    jacobian : ndarray, (n, p)
    correlations : ndarray, (n,)

    Returns
    -------
    covariance : ndarray, (p, p)
    used : float
        The expected sum of squared residuals is (n - used) variances.
    """
    inverse = np.linalg.inv(jacobian.T @ jacobian)
    if not correlations[1:].any():
        return inverse, float(jacobian.shape[1])
    from scipy.linalg import matmul_toeplitz

    inner = jacobian.T @ matmul_toeplitz(correlations, jacobian)
    return inverse @ inner @ inverse, float(np.trace(inverse @ inner))
