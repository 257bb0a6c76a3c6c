"""What a fit has found: numbers, how sure they are, and what speaks against them."""

from __future__ import annotations

import math

import numpy as np
from scipy.special import stdtrit

from winkler.errors import InvalidInput, suggest
from winkler.fitting.checks import Flag
from winkler.fitting.curve import ForceCurve
from winkler.fitting.prediction import Model
from winkler.fitting.task import Task, task
from winkler.fitting.trust import fit_notes
from winkler.numerics.types import Array
from winkler.validity import Note
from winkler.values import value

__all__ = ["Fit", "task_of"]


@value
class Fit:
    """What a curve says about a model.

    Parameters
    ----------
    curve : ForceCurve
        The points that were fitted, held ones left out.
    model : Indentation or AdhesiveIndentation
        The model with the fitted numbers; its load is the largest depth.
    names : tuple of str, (p,)
        What was varied.
    values : ndarray, (p,)
        The fitted numbers, in SI units.
    standard_errors : ndarray, (p,)
        In the same units; the noise's memory is counted in.
    correlation : ndarray, (p, p)
        Of the numbers' errors.
    lows, highs : ndarray, (p,)
        Bounds that were set.
    noise : float
        Standard deviation of the forces [N]: as given, else of the free points.
    weights : ndarray, (n,)
        What the residuals were multiplied with; 1 for even noise.
    scatter : float
        Standard deviation of the weighted residuals [N].
    effective_count : float
        Number of independent points that the curve is worth.
    predicted : ndarray, (n,)
        Fitted forces with the baseline [N].
    contact : ndarray of bool, (n,)
        Where the tip is in contact.
    radius : ndarray, (n,)
        Fitted contact radii [m].
    flags : tuple of Flag
        What speaks against the numbers.
    """

    curve: ForceCurve
    model: Model
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
    predicted: Array
    contact: Array
    radius: Array
    flags: tuple[Flag, ...]

    def index(self, name: str) -> int:
        """Return which of the numbers has a name.

        Raises
        ------
        InvalidInput
            If none has.
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
        """Return the interval of Wald: estimate and error, on the logarithm of positive quantities.

        Parameters
        ----------
        name : str
        confidence : float
            Between 0 and 1.
        """
        index = self.index(name)
        number, error = float(self.values[index]), float(self.standard_errors[index])
        width = self.quantile(confidence)
        if task_of(self).parameters[index].logarithmic:
            return number * math.exp(-width * error / number), number * math.exp(width * error / number)
        return number - width * error, number + width * error

    def quantile(self, confidence: float) -> float:
        """Return how many standard errors wide an interval is on either side, by Student's t."""
        if not 0.0 < confidence < 1.0:
            raise InvalidInput(f"fit: a confidence of {confidence!r} was asked for; give a number between 0 and 1.")
        return float(stdtrit(max(self.effective_count - len(self.names), 1.0), 0.5 + 0.5 * confidence))

    @property
    def covariance(self) -> Array:
        """Of the numbers, in products of their units ``(p, p)``."""
        return np.asarray(self.correlation * np.outer(self.standard_errors, self.standard_errors))

    @property
    def residuals(self) -> Array:
        """Measured less fitted forces [N]."""
        return np.asarray(self.curve.force - self.predicted)

    @property
    def depth(self) -> Array:
        """Depths d [m] of the fitted contact; below zero before first touch."""
        origin = self.value("contact_point") if "contact_point" in self.names else 0.0
        pull = np.where(self.contact, self.predicted - self._line(), 0.0)
        return np.asarray(self.curve.position - origin - self.curve.compliance * pull)

    def _line(self) -> Array:
        numbers = dict(zip(self.names, self.values.tolist(), strict=True))
        return task_of(self).line(numbers)

    @property
    def misfit(self) -> float:
        """Sum of the squared weighted residuals [N^2]."""
        return float(np.sum((self.weights * self.residuals) ** 2))

    @property
    def chi_square(self) -> float:
        """Squared misfit over the noise, per degree of freedom: near one if the model explains the curve."""
        return self.misfit / max(self.curve.count - len(self.names), 1) / self.noise**2

    @property
    def aic(self) -> float:
        """Akaike's criterion, of as many points as the curve is worth; models of one curve compare by `compare`."""
        return _likelihood(self) + 2.0 * len(self.names)

    @property
    def bic(self) -> float:
        """Schwarz' criterion, of as many points as the curve is worth."""
        return _likelihood(self) + math.log(self.effective_count) * len(self.names)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the fitted contact can be trusted at its largest depth, and whether the curve could tell it."""
        error = self.scatter / float(np.ptp(self.curve.force))
        own = fit_notes(self.model, self.curve, self.names, self.contact, float(self.radius.max()), error)
        return (*self.model.solve().validity, *own)


def _likelihood(fit: Fit) -> float:
    """Return minus twice the logarithm of the likelihood, but for a constant."""
    return fit.effective_count * math.log(fit.misfit / fit.curve.count)


def task_of(found: Fit) -> Task:
    """Return the task that a fit has answered, beginning at the answer."""
    free = {name: (low, high) for name, low, high in zip(found.names, found.lows, found.highs, strict=True)}
    return task(found.curve, found.model, free, np.mean(found.weights) / found.weights)
