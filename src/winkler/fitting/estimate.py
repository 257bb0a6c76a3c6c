"""Common part of all fits: parameters, errors and intervals, and criteria of model selection."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.fitting.curves.checks import Flag
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.noise.mixture import SIGMAS
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, suggest
from winkler.values.value import value, words

LARGEST_EXPONENT = math.log(np.finfo(float).max)
REFERENCE_WIDTH = 2.0
"""Half-width in standard errors to which the stretches of intervals refer."""
MOST_STRETCHES = 1.5
"""Greatest power of a stretch: beyond three standard errors it is not extrapolated."""
LINE_PARAMETERS = ("baseline", "tilt", "drag", "inertia")
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
        reaches=("", "", "half-widths of the intervals of 68, 90, 95, 99 and 99.7 % in standard errors"),
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
    reaches: Array
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
        """Which points are in contact, ``(n,)``."""
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

        Its half-widths are those of the mixture of all noises that the curve allows (`winkler.fitting.noise.mixture`);
        where the model is curved over the interval, they are stretched to those of the profile likelihood.
        It ends at zero and infinity where it exceeds the range of floats; `unbounded` names such numbers.

        Parameters
        ----------
        name : str
        confidence : float
            Between 0 and 1.

        Raises
        ------
        InvalidInput
            If the number was not free, or the confidence is not between 0 and 1.
        """
        index = self.index(name)
        number, error = float(self.values[index]), float(self.standard_errors[index])
        width = self.quantile(confidence, name)
        ends = []
        for sign, stretch in zip((-1.0, 1.0), self.stretches[index].tolist(), strict=True):
            half = width * float(stretch) ** min(width / REFERENCE_WIDTH, MOST_STRETCHES)
            if self.logarithmic[index]:
                part = half * (error / number) if number > 0.0 and half > 0.0 else math.inf
                ends.append(_scaled(number, sign * part))
            else:
                ends.append(_finite_or_infinite(number, sign * half * error, sign))
        return ends[0], ends[1]

    @property
    def unbounded(self) -> tuple[str, ...]:
        """Numbers of which the curve leaves at least one end of the 95 % interval open: zero or infinite."""
        return tuple(name for name in self.names if self._is_open(name))

    def _is_open(self, name: str) -> bool:
        low, high = self.interval(name)
        index = self.index(name)
        return not math.isfinite(low) or not math.isfinite(high) or (self.logarithmic[index] and low == 0.0)

    def quantile(self, confidence: float, name: str = "") -> float:
        """Return the half-width of the interval of a number in standard errors; without a name, the widest of all.

        Raises
        ------
        InvalidInput
            If the number was not free, or the confidence is not between 0 and 1.
        """
        from scipy.special import ndtri

        if not 0.0 < confidence < 1.0:
            raise InvalidInput(f"fit: confidence is {confidence!r}; give a number between 0 and 1.")
        sigmas = float(-ndtri(0.5 - 0.5 * confidence))
        reaches = self.reaches[self.index(name)] if name else self.reaches.max(axis=0)
        if sigmas > SIGMAS[-1]:
            return sigmas * float(reaches[-1]) / SIGMAS[-1]
        return float(np.interp(sigmas, (0.0, *SIGMAS), (0.0, *reaches.tolist())))

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


def _scaled(number: float, exponent: float) -> float:
    """Return a number times an exponential, zero or infinite beyond the range of floats."""
    if exponent >= LARGEST_EXPONENT:
        return math.inf
    return number * math.exp(max(exponent, -2.0 * LARGEST_EXPONENT))


def _finite_or_infinite(number: float, change: float, sign: float) -> float:
    """Return the sum, infinite where the change is no number."""
    return number + change if math.isfinite(change) else sign * math.inf
