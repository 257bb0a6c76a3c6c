"""Common part of all fits: parameters, errors and intervals, and criteria of model selection."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.errors import InvalidInput, suggest
from winkler.fitting.curves.checks import Flag
from winkler.fitting.curves.curve import ForceCurve
from winkler.numerics.types import Array
from winkler.values import value, words

__all__ = ["FitEstimate"]

LARGEST_EXPONENT = math.log(np.finfo(float).max)
REFERENCE_WIDTH = 2.0
"""Half-width in standard errors to which the stretches of intervals refer."""
LINE_PARAMETERS = ("baseline", "tilt", "drag")
"""Parameters that follow from the free points."""


@value
class FitEstimate:
    """Fitted parameters with their errors; the fields are those of `winkler.fitting.outcome.Fit`."""

    __words__ = words(
        model=("", None, "the model with the fitted numbers"),
        names=("", None, "what was varied"),
        values=("", None, "the fitted numbers, in SI units"),
        correlation=("", "", "correlation of the numbers' errors"),
        lows=("", None, "lower bounds"),
        highs=("", None, "upper bounds"),
        noise=(r"\sigma", "N", "standard deviation of the forces"),
        weights=("", "", "what residuals were multiplied with"),
        scatter=("s", "N", "standard deviation of the weighted residuals"),
        slow_share=("", "", "part of the noise's variance that is slow"),
        log_likelihood=(r"\ln L", None, "logarithm of the likelihood, integrated over the noise"),
        stretches=("", "", "factors of the half-widths of intervals"),
        predicted=("F", "N", "fitted forces with the baseline"),
        flags=("", None, "what speaks against the numbers"),
        logarithmic=("", None, "of which numbers the logarithm was varied"),
    )

    curve: ForceCurve
    model: Any
    names: tuple[str, ...]
    values: Array
    standard_errors: Array
    correlation: Array
    lows: Array
    highs: Array
    noise: float
    weights: Array
    scatter: float
    effective_count: float
    slow_share: float
    log_likelihood: float
    stretches: Array
    predicted: Array
    radius: Array
    flags: tuple[Flag, ...]
    logarithmic: tuple[bool, ...]

    @property
    def residuals(self) -> Array:
        """Measured less fitted forces [N] ``(n,)``."""
        return np.asarray(self.curve.force - self.predicted)

    @property
    def touched(self) -> Array:
        """Points in contact ``(n,)``."""
        return np.asarray(self.radius > 0.0)

    def index(self, name: str) -> int:
        """Return the index of a parameter.

        Raises
        ------
        InvalidInput
            If it was not free.
        """
        if name not in self.names:
            raise InvalidInput(f"fit: '{name}' was not free{suggest(name, self.names)}; {', '.join(self.names)} were.")
        return self.names.index(name)

    def value(self, name: str) -> float:
        """Return a fitted number."""
        return float(self.values[self.index(name)])

    def error(self, name: str) -> float:
        """Return the standard error of a fitted number."""
        return float(self.standard_errors[self.index(name)])

    def interval(self, name: str, confidence: float = 0.95) -> tuple[float, float]:
        """Return the interval: estimate and error, on the logarithm of positive quantities.

        Where the model is curved over the interval, its half-widths are stretched to those of the profile likelihood.
        It ends at zero and infinity where it exceeds the range of floats.

        Parameters
        ----------
        name : str
        confidence : float
            Between 0 and 1.
        """
        index = self.index(name)
        number, error = float(self.values[index]), float(self.standard_errors[index])
        width = self.quantile(confidence)
        below, above = (width * stretch ** (width / REFERENCE_WIDTH) for stretch in self.stretches[index].tolist())
        if self.logarithmic[index]:
            part = error / number if number > 0.0 else math.inf
            high = number * math.exp(above * part) if above * part < LARGEST_EXPONENT else math.inf
            return number * math.exp(-below * part), high
        return number - below * error, number + above * error

    def quantile(self, confidence: float) -> float:
        """Return the half-width of an interval in standard errors, by Student's t."""
        from scipy.special import stdtrit

        if not 0.0 < confidence < 1.0:
            raise InvalidInput(f"fit: confidence is {confidence!r}; give a number between 0 and 1.")
        return float(stdtrit(max(self.effective_count - len(self.names), 1.0), 0.5 + 0.5 * confidence))

    @property
    def covariance(self) -> Array:
        """Of the numbers, in products of their units ``(p, p)``."""
        return np.asarray(self.correlation * np.outer(self.standard_errors, self.standard_errors))

    @property
    def misfit(self) -> float:
        """Sum of the squared weighted residuals."""
        return float(np.sum((self.weights * self.residuals) ** 2))

    @property
    def chi_square(self) -> float:
        """Squared misfit over the noise, per degree of freedom: near one if the model explains the curve."""
        return self.misfit / max(self.count - len(self.names), 1) / self.noise**2

    @property
    def contact_count(self) -> int:
        """Number of fitted points in contact."""
        return int(np.count_nonzero(self.weights * self.touched))

    @property
    def contact_freedom(self) -> int:
        """Degrees of freedom of the fitted points in contact."""
        return max(self.contact_count - sum(name not in LINE_PARAMETERS for name in self.names), 1)

    @property
    def chi_square_in_contact(self) -> float:
        """Squared misfit over the noise of the points in contact alone, which a long baseline does not dilute."""
        return float(np.sum((self.weights * self.residuals)[self.touched] ** 2)) / self.contact_freedom / self.noise**2

    @property
    def aic(self) -> float:
        """Akaike's criterion by the likelihood under white and slow noise; `compare` ranks models of one curve."""
        return 2.0 * len(self.names) - 2.0 * self.log_likelihood

    @property
    def bic(self) -> float:
        """Schwarz' criterion, with the effective number of points."""
        return math.log(self.effective_count) * len(self.names) - 2.0 * self.log_likelihood

    @property
    def count(self) -> int:
        """Number of fitted points."""
        return int(np.count_nonzero(self.weights))
