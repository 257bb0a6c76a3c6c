"""What a fit has found: numbers, how sure they are, and what speaks against them."""

from __future__ import annotations

import numpy as np

from winkler.fitting.curves.checks import Flag
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.estimate import Estimate
from winkler.fitting.prediction import Model
from winkler.fitting.task import Task, task
from winkler.fitting.trust import fit_notes
from winkler.numerics.types import Array
from winkler.validity import Note
from winkler.values import value

__all__ = ["Fit", "task_of"]


@value
class Fit(Estimate):
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

    @property
    def _on_logarithm(self) -> tuple[bool, ...]:
        """Of which numbers the logarithm was varied ``(p,)``."""
        return tuple(parameter.logarithmic for parameter in task_of(self).parameters)

    @property
    def touched(self) -> Array:
        """Where the tip is in contact ``(n,)``."""
        return self.contact

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
    def validity(self) -> tuple[Note, ...]:
        """How far the fitted contact can be trusted at its largest depth, and whether the curve could tell it."""
        error = self.scatter / float(np.ptp(self.curve.force))
        own = fit_notes(self.model, self.curve, self.names, self.contact, float(self.radius.max()), error)
        return (*self.model.solve().validity, *own)


def task_of(found: Fit) -> Task:
    """Return the task that a fit has answered, beginning at the answer."""
    free = {name: (low, high) for name, low, high in zip(found.names, found.lows, found.highs, strict=True)}
    return task(found.curve, found.model, free, np.mean(found.weights) / found.weights)
