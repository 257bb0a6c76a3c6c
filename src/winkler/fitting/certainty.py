"""Uncertainty of the parameters of a fit, and doubts that follow from its algebra.

The covariance is that of generalised least squares under white and slow noise (`winkler.fitting.noise`).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.checks import Flag
from winkler.fitting.estimate import FitEstimate
from winkler.fitting.misfit import Misfit
from winkler.fitting.noise.estimate import orthonormal
from winkler.fitting.varied import Parameter
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity
from winkler.values.readable import with_unit

__all__ = ["Certainty", "certainty", "doubts", "refuse_singular"]

SINGULAR_RATIO = 1e-7
CORRELATION_LIMIT = 0.99
POINTS_PER_PARAMETER = 5
"""Fewest independent points for each parameter."""


class Certainty(NamedTuple):
    """Uncertainty of parameters under the noise of their fit.

    Parameters
    ----------
    errors : ndarray, (p,)
        Standard errors of the coordinates.
    correlation : ndarray, (p, p)
        Of these errors.
    effective_count : float
        Number of independent points.
    misfit : Misfit
    """

    errors: Array
    correlation: Array
    effective_count: float
    misfit: Misfit


def certainty(covariance: Array, effective_count: float, misfit: Misfit) -> Certainty:
    """Return the uncertainty of the parameters of a fit from the covariance of its coordinates."""
    variances = np.diag(covariance)
    correlation = np.clip(covariance / np.sqrt(np.outer(variances, variances)), -1.0, 1.0)
    return Certainty(np.sqrt(variances), correlation, effective_count, misfit)


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
    _, values, rows = np.linalg.svd(orthonormal(jacobian / size)[1])
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
    if uncertainty.effective_count < POINTS_PER_PARAMETER * len(parameters):
        yield Flag(
            "memory",
            f"The curve has the information of {uncertainty.effective_count:.3g} independent points: the noise "
            "is slow, or the model misses the course of the curve.",
        )
    if not uncertainty.misfit.on_the_whole:
        yield Flag(
            "misfit",
            f"The residuals are {math.sqrt(estimate.chi_square):.3g} times the noise, in contact "
            f"{math.sqrt(estimate.chi_square_in_contact):.3g} times: the model does not explain the curve.",
        )
    elif not uncertainty.misfit.explained:
        place = float(estimate.curve.position[uncertainty.misfit.place])
        yield Flag(
            "misfit",
            f"Near the position {with_unit(place, 'm', 4)} the residuals are {uncertainty.misfit.local:.3g} times the "
            "noise: the model does not explain this part of the curve.",
        )
