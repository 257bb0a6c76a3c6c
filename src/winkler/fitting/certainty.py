"""How sure the numbers of a fit are, and what its own algebra says against them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.errors import OutsideValidity
from winkler.fitting.curves.checks import Flag
from winkler.fitting.curves.noise import memory, memory_of_fit, spread
from winkler.fitting.estimate import Estimate
from winkler.fitting.varied import Parameter
from winkler.numerics.types import Array

__all__ = ["Certainty", "certainty", "doubts", "refuse_singular"]

SINGULAR = 1e-7
ALIKE = 0.99
MISFIT = 2.0
"""Squared misfit over the noise, per degree of freedom, that no model that explains a curve leaves."""
SURE = 0.999
"""Of so many right models, the contact part stays below its own limit, however few points it has."""
QUIET = 20
"""Fewest free points that tell how far the noise remembers."""
FEW_EACH = 10
"""Fewest independent points for each number."""


class Certainty(NamedTuple):
    """What residuals say about the numbers that left them.

    Parameters
    ----------
    errors : ndarray, (p,)
        Standard errors of the coordinates.
    correlation : ndarray, (p, p)
        Of these errors.
    scatter : float
        Standard deviation of the residuals.
    effective_count : float
        How many independent points they are worth.
    """

    errors: Array
    correlation: Array
    scatter: float
    effective_count: float


def certainty(residuals: Array, jacobian: Array) -> Certainty:
    """Return how sure the numbers of a fit are.

    Parameters
    ----------
    residuals : ndarray, (n,)
        Weighted, in the order in which they were measured.
    jacobian : ndarray, (n, p)
        Weighted derivatives of the prediction.
    """
    kept = memory_of_fit(residuals, jacobian)
    covariance, used = spread(jacobian, kept.correlations)
    scatter = math.sqrt(float(residuals @ residuals) / max(residuals.size - used, 1.0))
    variances = np.diag(covariance)
    correlation = np.clip(covariance / np.sqrt(np.outer(variances, variances)), -1.0, 1.0)
    return Certainty(scatter * np.sqrt(variances), correlation, scatter, kept.effective_count)


def refuse_singular(parameters: tuple[Parameter, ...], jacobian: Array, largest: float) -> None:
    """Refuse numbers that the curve cannot tell.

    Parameters
    ----------
    parameters : tuple of Parameter, (p,)
    jacobian : ndarray, (n, p)
    largest : float
        Norm of what was measured.

    Raises
    ------
    OutsideValidity
        If a number changes nothing, or only a combination of some matters.
    """
    size = np.linalg.norm(jacobian, axis=0)
    names = [p.name for p in parameters]
    blind = [name for name, own in zip(names, size, strict=True) if own <= SINGULAR * largest * 1e-3]
    if blind:
        raise OutsideValidity(
            f"fit: the curve says nothing about {', '.join(blind)}; leave it fixed.{_fewer_terms(blind)}"
        )
    _, values, rows = np.linalg.svd(jacobian / size, full_matrices=False)
    if values[-1] <= SINGULAR * values[0]:
        mixed = [name for name, part in zip(names, rows[-1], strict=True) if abs(part) > 0.1]
        raise OutsideValidity(
            f"fit: not identifiable: the curve cannot tell {' from '.join(mixed)}, only a combination of them; fix all "
            f"but one.{_fewer_terms(mixed)}"
        )


def _fewer_terms(names: list[str]) -> str:
    return " One term less may do." if any("shears[" in name or "relaxation_times[" in name for name in names) else ""


def doubts(parameters: tuple[Parameter, ...], coordinates: Array, found: Estimate, sure: Certainty) -> list[Flag]:
    """Return what speaks against the numbers of a fit.

    Parameters
    ----------
    parameters : tuple of Parameter, (p,)
    coordinates : ndarray, (p,)
    found : Estimate
        The fit, flags of its own not yet among them.
    sure : Certainty
    """
    values, errors = found.values, found.standard_errors
    flags = []
    for index, parameter in enumerate(parameters):
        here = float(coordinates[index])
        walls = parameter.inward(parameter.low), parameter.inward(parameter.high)
        if any(abs(here - wall) <= 1e-6 * (1.0 + abs(here)) for wall in walls):
            flags.append(Flag("at_bound", f"{parameter.name} has come to its bound; its error means nothing."))
        elif parameter.logarithmic and errors[index] > values[index]:
            flags.append(Flag("undetermined", f"{parameter.name} is less than its own error; it may be anything."))
    names = [p.name for p in parameters]
    for i, first in enumerate(names):
        for j, second in enumerate(names[:i]):
            if abs(sure.correlation[i, j]) > ALIKE:
                flags.append(
                    Flag("correlated", f"{second} and {first} go together (correlation {sure.correlation[i, j]:.4f}).")
                )
    if sure.effective_count < FEW_EACH * len(names):
        flags.append(
            Flag(
                "memory",
                f"The curve is worth no more than {sure.effective_count:.3g} independent points: the noise drifts, or "
                "the model misses the course of the curve; the errors are rough.",
            )
        )
    whole, contact = found.chi_square, found.chi_square_in_contact
    if whole > MISFIT or contact > _limit(found):
        flags.append(
            Flag(
                "misfit",
                f"The residuals are {math.sqrt(whole):.3g} times the noise, in contact {math.sqrt(contact):.3g} times: "
                "the model does not explain the curve.",
            )
        )
    return flags


def _limit(found: Estimate) -> float:
    """Return the squared misfit of the contact part over the noise that chance alone hardly reaches."""
    from scipy.special import gammaincinv

    quiet = (found.weights * found.residuals)[~found.touched & (found.weights > 0.0)]
    share = memory(quiet).effective_count / quiet.size if quiet.size >= QUIET else 1.0
    half = 0.5 * max(found.contact_freedom * share, 1.0)
    return max(MISFIT, float(gammaincinv(half, SURE)) / half)
