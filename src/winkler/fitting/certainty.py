"""Uncertainty of the parameters of a fit, and doubts that follow from its algebra.

The covariance is that of generalised least squares under white and slow noise (`winkler.fitting.noise`).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.errors import OutsideValidity
from winkler.fitting.curves.checks import Flag
from winkler.fitting.estimate import FitEstimate
from winkler.fitting.noise.estimate import NoiseEstimate, noise_of
from winkler.fitting.varied import Parameter
from winkler.numerics.types import Array

__all__ = ["Certainty", "certainty", "doubts", "refuse_singular"]

SINGULAR_RATIO = 1e-7
CORRELATION_LIMIT = 0.99
MISFIT_LIMIT = 2.0
"""Squared misfit over the noise, per degree of freedom, from which on a model does not explain a curve."""
MISFIT_CONFIDENCE = 0.999
"""Part of correct models whose misfit in contact stays below its limit."""
FEWEST_FREE_POINTS = 20
"""Fewest free points for the autocorrelation of the noise."""
POINTS_PER_PARAMETER = 3
"""Fewest independent points for each parameter."""


class Certainty(NamedTuple):
    """Uncertainty of parameters under the noise of their fit.

    Parameters
    ----------
    errors : ndarray, (p,)
        Standard errors of the coordinates.
    correlation : ndarray, (p, p)
        Of these errors.
    noise : NoiseEstimate
    """

    errors: Array
    correlation: Array
    noise: NoiseEstimate


def certainty(noise: NoiseEstimate) -> Certainty:
    """Return the uncertainty of the parameters of a fit from its noise."""
    variances = np.diag(noise.covariance)
    correlation = np.clip(noise.covariance / np.sqrt(np.outer(variances, variances)), -1.0, 1.0)
    return Certainty(np.sqrt(variances), correlation, noise)


def refuse_singular(parameters: tuple[Parameter, ...], jacobian: Array, largest: float) -> None:
    """Raise OutsideValidity for parameters that the curve does not determine.

    Parameters
    ----------
    parameters : tuple of Parameter, (p,)
    jacobian : ndarray, (n, p)
    largest : float
        Norm of the measured quantity.

    Raises
    ------
    OutsideValidity
        If a parameter has no effect, or only a combination of several has.
    """
    size = np.linalg.norm(jacobian, axis=0)
    names = [p.name for p in parameters]
    insensitive = [name for name, norm in zip(names, size, strict=True) if norm <= SINGULAR_RATIO * largest * 1e-3]
    if insensitive:
        raise OutsideValidity(
            f"fit: the curve does not depend on {', '.join(insensitive)}; leave it fixed.{_fewer_terms(insensitive)}"
        )
    _, values, rows = np.linalg.svd(jacobian / size, full_matrices=False)
    if values[-1] <= SINGULAR_RATIO * values[0]:
        combined = [name for name, part in zip(names, rows[-1], strict=True) if abs(part) > 0.1]
        raise OutsideValidity(
            f"fit: not identifiable: the curve does not distinguish {' from '.join(combined)}, "
            f"only a combination of them; fix all but one.{_fewer_terms(combined)}"
        )


def _fewer_terms(names: list[str]) -> str:
    is_series = any("shears[" in name or "relaxation_times[" in name for name in names)
    return " One term fewer may suffice." if is_series else ""


def doubts(
    parameters: tuple[Parameter, ...], coordinates: Array, estimate: FitEstimate, uncertainty: Certainty
) -> Iterator[Flag]:
    """Yield the doubts about the parameters of a fit.

    Parameters
    ----------
    parameters : tuple of Parameter, (p,)
    coordinates : ndarray, (p,)
    estimate : FitEstimate
        The fit, flags of its own not yet among them.
    uncertainty : Certainty
    """
    numbers = zip(parameters, coordinates.tolist(), estimate.values, estimate.standard_errors, strict=True)
    for parameter, coordinate, number, error in numbers:
        bounds = parameter.inward(parameter.low), parameter.inward(parameter.high)
        if any(abs(coordinate - bound) <= 1e-6 * (1.0 + abs(coordinate)) for bound in bounds):
            yield Flag("at_bound", f"{parameter.name} has reached its bound; its error has no meaning.")
        elif parameter.logarithmic and error > number:
            yield Flag("undetermined", f"{parameter.name} is smaller than its error and remains undetermined.")
    for i, first in enumerate(parameters):
        for j, second in enumerate(parameters[:i]):
            correlation = uncertainty.correlation[i, j]
            if abs(correlation) > CORRELATION_LIMIT:
                text = f"{second.name} and {first.name} go together (correlation {correlation:.4f})."
                yield Flag("correlated", text)
    if uncertainty.noise.effective_count < POINTS_PER_PARAMETER * len(parameters):
        yield Flag(
            "memory",
            f"The curve has the information of {uncertainty.noise.effective_count:.3g} independent points: the noise "
            "drifts, or the model misses the course of the curve; the errors are rough.",
        )
    clean = estimate.weights * estimate.residuals - uncertainty.noise.disturbance
    whole, contact, limit = _misfits(estimate, clean)
    if whole > MISFIT_LIMIT or contact > limit:
        yield Flag(
            "misfit",
            f"The residuals are {math.sqrt(estimate.chi_square):.3g} times the noise, in contact "
            f"{math.sqrt(estimate.chi_square_in_contact):.3g} times: the model does not explain the curve.",
        )


def _misfits(estimate: FitEstimate, clean: Array) -> tuple[float, float, float]:
    """Return the squared misfits over the noise, on the whole and in contact, and the limit in contact.

    The noise out of contact states how far residuals in contact vary: slow noise has fewer independent points, and
    grows with their number.  Drifts, tilts and drags are no misfit.

    Parameters
    ----------
    estimate : FitEstimate
    clean : ndarray, (n,)
        Weighted residuals without disturbances.
    """
    from scipy.special import gammaincinv

    free = ~estimate.touched & (estimate.weights > 0.0)
    count, noise, share, growth = int(np.count_nonzero(free)), estimate.noise, 1.0, 1.0
    if count >= FEWEST_FREE_POINTS:
        own = clean[free] - clean[free].mean()
        noise = min(noise, float(np.sqrt(np.mean(own**2)))) or noise
        spectrum = noise_of(own, np.ones((count, 1)), np.zeros((count, 0))).spectrum[1:]
        inside = max(int(estimate.contact_count), 2)
        along = np.interp(np.arange(1, inside) / inside, np.arange(1, count) / count, spectrum)
        share = float(along.sum() ** 2 / (along @ along)) / along.size
        growth = max(float(along.mean() / spectrum.mean()), 1.0)
    whole = float(clean @ clean) / max(estimate.count - len(estimate.names), 1) / noise**2
    contact = float(np.sum(clean[estimate.touched] ** 2)) / estimate.contact_freedom / noise**2
    half = 0.5 * max(estimate.contact_freedom * share, 1.0)
    return whole, contact, growth * max(MISFIT_LIMIT, float(gammaincinv(half, MISFIT_CONFIDENCE)) / half)
