"""What the fit of a contact with or without adhesion has found."""

from __future__ import annotations

import numpy as np

from winkler.fitting.elastic.contact import Model
from winkler.fitting.elastic.trust import fit_notes
from winkler.fitting.estimate import Estimate
from winkler.fitting.task import FREELY, OF_THE_CURVE, parameters_of
from winkler.numerics.types import Array
from winkler.validity import Note
from winkler.values import value

__all__ = ["Fit"]


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
    radius : ndarray, (n,)
        Fitted contact radii [m].
    flags : tuple of Flag
        What speaks against the numbers.
    contact : ndarray of bool, (n,)
        Where the tip is in contact.
    """

    model: Model
    contact: Array

    @property
    def _on_logarithm(self) -> tuple[bool, ...]:
        """Of which numbers the logarithm was varied ``(p,)``."""
        free = {name: (low, high) for name, low, high in zip(self.names, self.lows, self.highs, strict=True)}
        scales = dict.fromkeys(OF_THE_CURVE, 1.0)
        return tuple(parameter.logarithmic for parameter in parameters_of(self.model, free, scales, FREELY))

    @property
    def touched(self) -> Array:
        """Where the tip is in contact ``(n,)``."""
        return self.contact

    @property
    def depth(self) -> Array:
        """Depths d [m] of the fitted contact; below zero before first touch."""
        numbers = dict(zip(self.names, self.values.tolist(), strict=True))
        along = self.curve.position - numbers.get("contact_point", 0.0)
        line = numbers.get("baseline", 0.0) + numbers.get("tilt", 0.0) * along
        return np.asarray(along - self.curve.compliance * np.where(self.contact, self.predicted - line, 0.0))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the fitted contact can be trusted at its largest depth, and whether the curve could tell it."""
        error = self.scatter / float(np.ptp(self.curve.force))
        own = fit_notes(self.model, self.curve, self.names, self.contact, float(self.radius.max()), error)
        return (*self.model.solve().validity, *own)
