r"""Relaxation spectrum of measurements at several temperatures, with the shifts that make them one curve.

The logarithms of measured moduli are those of a sum of exponentials at times :math:`\tau_i` evenly spaced in their
logarithm, of positive strengths :math:`e^{s_i}`, beside a constant :math:`e^{s_0}`,

.. math:: G'_j = b\Bigl(e^{s_0}+\sum_i e^{s_i}\frac{x_i^2}{1+x_i^2}\Bigr),\quad
   G''_j = b\sum_i e^{s_i}\frac{x_i}{1+x_i^2},\quad G_j = b\Bigl(e^{s_0}+\sum_i e^{s_i}e^{-1/x_i}\Bigr),

with :math:`x_i=\omega a\tau_i` or :math:`a\tau_i/t`, a shift a and a factor b for each temperature.  The second
differences of :math:`s_i` are small: their weight and the scatter of each kind of measurement are those of the greatest
evidence (MacKay's iteration), numbers and covariance those of the greatest posterior and its curvature.

D. J. C. MacKay, Neural Comput. 4 (1992) 415-447, doi:10.1162/neco.1992.4.3.415; J. Honerkamp, J. Weese, Rheol. Acta 32
(1993) 65-73, doi:10.1007/BF00396678
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.springs.spectrum_response import Measurements, Response, SpectrumLayout, bending, linearised
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

SETTLED = 1e-10
"""Longest step of a logarithm with which the search ends."""
ROUNDING = 1e-12
"""Part of the cost that is rounding."""
MOST_STEPS = 400
MOST_ROUNDS = 200
LEAST_WEIGHT, GREATEST_WEIGHT = 1e-4, 1e7
LEAST_SCATTER = 1e-4
"""Least relative scatter: that with which a series of few terms per decade describes a smooth spectrum."""
STRENGTH_FREEDOM = 8.0
"""Standard deviation of the logarithm of a strength that no measurement determines."""
LEVEL_FREEDOM = 3.0
"""The same of the constant."""
LONGEST_STEP = 3.0
"""Longest step of a logarithm."""
GREATEST_DAMPING = 1e12


class SpectrumEstimate(NamedTuple):
    """The spectrum and the shifts.

    Parameters
    ----------
    times : ndarray, (k,)
        tau_i.
    strengths : ndarray, (k,)
        Logarithms of the strengths s_i.
    level : float
        Logarithm of the constant s_0; -inf without one.
    shifts, factors : ndarray, (m,)
        Logarithms of a and b.
    covariance : ndarray, (k + 2 m + 1, k + 2 m + 1)
        Of strengths, level, shifts and factors; zero for those that are fixed.
    scatter : ndarray, (kinds,)
        Standard deviation of the logarithm of each kind.
    residuals : tuple of ndarray
        Of the logarithms, for each kind.
    freedom : float
        Number of measurements minus number of fitted parameters.
    """

    times: Array
    strengths: Array
    level: float
    shifts: Array
    factors: Array
    covariance: Array
    scatter: Array
    residuals: tuple[Array, ...]
    freedom: float


def estimate_spectrum(
    measured: tuple[Measurements, ...],
    times: Array,
    shifts: Array,
    *,
    reference: int,
    free_shifts: bool = True,
    free_factors: bool = False,
    fixed_factors: Array | None = None,
    relaxes: bool = True,
) -> SpectrumEstimate:
    """Return spectrum and shifts of the greatest posterior.

    Parameters
    ----------
    measured : tuple of Measurements
    times : ndarray, (k,)
        tau_i, evenly spaced in their logarithm, at the reference temperature.
    shifts : ndarray, (m,)
        Where the search of the logarithms of a begins.
    reference : int
        The temperature whose shift is zero and whose factor is one.
    free_shifts, free_factors : bool, optional
        Whether shifts and factors are sought.
    fixed_factors : ndarray, (m,), optional
        Logarithms of b that are given.
    relaxes : bool, optional
        Whether a constant remains at last.

    Raises
    ------
    NotConverged
        If the iteration does not converge.
    """
    k, m = times.size, shifts.size
    others = np.arange(m) != reference
    free = np.concatenate([np.ones(k, bool), [relaxes], others & free_shifts, others & free_factors])
    layout = SpectrumLayout(k, m, free)
    least = min(float(one.modulus.min()) for one in measured)
    factors = np.zeros(m) if fixed_factors is None else fixed_factors
    level = math.log(least) if relaxes else -math.inf
    numbers = np.concatenate([_start(measured, times, shifts), [level], shifts, factors])
    loose = np.zeros(free.size)
    loose[:k], loose[k] = STRENGTH_FREEDOM**-2, LEVEL_FREEDOM**-2
    pull = (loose * np.nan_to_num(numbers, neginf=0.0))[free]
    rough = np.zeros((free.size, free.size))
    second = np.diff(np.eye(k), 2, axis=0)
    rough[:k, :k] = second.T @ second
    weight, scatter = 10.0, np.full(len(measured), 0.05)
    previous = np.full(len(measured) + 1, math.inf)
    for _ in range(MOST_ROUNDS):
        numbers, slopes, residuals, inner = _settle(
            measured, times, layout, numbers, (rough * weight + np.diag(loose))[np.ix_(free, free)], pull, scatter
        )
        covariance = np.linalg.inv(inner)
        taken = np.array(
            [np.einsum("ij,ji->", covariance, slope.T @ slope) / s**2 for slope, s in zip(slopes, scatter, strict=True)]
        )
        counts = np.array([one.modulus.size for one in measured])
        squares = np.array([float(one @ one) for one in residuals])
        scatter = np.maximum(np.sqrt(squares / np.maximum(counts - taken, 1.0)), LEAST_SCATTER)
        smooth = numbers[:k] @ rough[:k, :k] @ numbers[:k]
        held = (k - 2) - weight * float(np.trace(covariance @ rough[np.ix_(free, free)]))
        weight = float(np.clip(max(held, 1e-3) / max(smooth, 1e-300), LEAST_WEIGHT, GREATEST_WEIGHT))
        now = np.log(np.append(scatter, weight))
        if np.all(np.abs(now - previous) < 1e-3):
            break
        previous = now
    else:
        raise NotConverged(
            "The smoothness of the relaxation spectrum does not settle; give fewer terms per decade, or more "
            "measurements."
        )
    whole = np.zeros((free.size, free.size))
    whole[np.ix_(free, free)] = covariance
    strengths, level, shifts, factors = layout.parts(numbers)
    freedom = float(max(np.sum(counts) - np.sum(taken), 1.0))
    return SpectrumEstimate(
        times, strengths, level if relaxes else -math.inf, shifts, factors, whole, scatter, residuals, freedom
    )


def _start(measured: tuple[Measurements, ...], times: Array, shifts: Array) -> Array:
    """Return strengths from the loss, H = 2 G'' / pi at tau = 1 / omega, or evenly shared where there is none."""
    spacing = math.log(times[1] / times[0])
    for one in measured:
        if one.response is Response.LOSS:
            x = -(np.log(one.abscissa) + shifts[one.group])
            order = np.argsort(x)
            level = np.interp(np.log(times), x[order], np.log(one.modulus)[order])
            return np.asarray(level + math.log(2.0 / math.pi * spacing))
    size = max(float(one.modulus.max()) for one in measured)
    return np.full(times.size, math.log(size / times.size))


def _settle(
    measured: tuple[Measurements, ...],
    times: Array,
    layout: SpectrumLayout,
    numbers: Array,
    prior: Array,
    pull: Array,
    scatter: Array,
) -> tuple[Array, list[Array], tuple[Array, ...], Array]:
    """Return the numbers of the greatest posterior, slopes and residuals there, and its curvature."""
    free, damping = layout.free, 1e-3
    slopes, residuals = linearised(measured, times, layout, numbers)

    def cost(at: Array, misfit: tuple[Array, ...]) -> float:
        misfits = sum(float(r @ r) / s**2 for r, s in zip(misfit, scatter, strict=True))
        return float(misfits + (prior @ at[free] - 2.0 * pull) @ at[free])

    def weighted(misfit: tuple[Array, ...]) -> tuple[Array, ...]:
        return tuple(r / s**2 for r, s in zip(misfit, scatter, strict=True))

    here = cost(numbers, residuals)
    bends = bending(measured, times, layout, numbers, weighted(residuals))
    for _ in range(MOST_STEPS):
        inner = sum((j.T @ j / s**2 for j, s in zip(slopes, scatter, strict=True)), start=prior)
        right = sum(
            (j.T @ r / s**2 for j, r, s in zip(slopes, residuals, scatter, strict=True)),
            start=pull - prior @ numbers[free],
        )
        step = _step(inner - bends, inner, right, damping)
        step *= min(1.0, LONGEST_STEP / max(float(np.max(np.abs(step))), LONGEST_STEP))
        ahead = numbers.copy()
        ahead[free] += step
        next_slopes, next_residuals = linearised(measured, times, layout, ahead)
        there = cost(ahead, next_residuals)
        if math.isfinite(there) and there <= here + ROUNDING * (1.0 + abs(here)):
            settled = float(np.max(np.abs(step))) <= SETTLED
            numbers, slopes, residuals, here = ahead, next_slopes, next_residuals, there
            bends = bending(measured, times, layout, numbers, weighted(residuals))
            damping = max(0.2 * damping, 1e-12)
            if settled:
                break
        else:
            damping *= 8.0
            if damping > GREATEST_DAMPING:
                break
    else:
        raise NotConverged(
            "The search of the relaxation spectrum does not settle; check that the measurements are moduli of one body."
        )
    inner = sum((j.T @ j / s**2 for j, s in zip(slopes, scatter, strict=True)), start=prior)
    return numbers, slopes, residuals, inner


def _step(curvature: Array, convex: Array, right: Array, damping: float) -> Array:
    """Return Newton's step where the cost is curved upwards, or that of Gauss and Newton."""
    import scipy.linalg

    for matrix in (curvature, convex):
        damped = matrix + damping * np.diag(np.diag(convex))
        try:
            return np.asarray(scipy.linalg.cho_solve(scipy.linalg.cho_factor(damped), right))
        except scipy.linalg.LinAlgError:
            continue
    return np.linalg.solve(convex + damping * np.diag(np.diag(convex)), right)
