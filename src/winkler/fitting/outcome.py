"""What fits have found: of a contact with or without adhesion, of a contact that relaxes by forces or by positions."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.fitting.curves.checks import Flag
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.outline import FEWEST, outline
from winkler.fitting.estimate import Estimate
from winkler.fitting.validity import Model, fit_notes, free_notes
from winkler.fitting.varied import FREELY, OF_THE_CURVE, parameters_of
from winkler.numerics.types import Array
from winkler.problems.normal.validity import contact_notes
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.march import elastic_like
from winkler.validity import Assumption, Note, Standing
from winkler.values import value, words

__all__ = ["AnyFit", "CreepFit", "Fit", "ViscoelasticFit"]

QUASISTATIC = Note(
    Assumption.CURVE,
    Standing.APPROXIMATE,
    "Machine and liquid: the cantilever follows without inertia, and what a liquid drags at it is proportional to the "
    "velocity of its base, if drag is free; an adhesive pull is no part of the model.",
    "assumptions of the fit",
)


@value
class _Found(Estimate):
    """What all fits have found."""

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
        predicted=("F", "N", "fitted forces with the baseline"),
        flags=("", None, "what speaks against the numbers"),
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
    predicted: Array
    radius: Array
    flags: tuple[Flag, ...]

    @property
    def residuals(self) -> Array:
        """Measured less fitted forces [N] ``(n,)``."""
        return np.asarray(self.curve.force - self.predicted)

    @property
    def touched(self) -> Array:
        """Where the tip is in contact ``(n,)``."""
        return np.asarray(self.radius > 0.0)


@value
class Fit(_Found):
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

    __words__ = words(contact=("", None, "where the tip is in contact"))

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


@value
class _RelaxingFit(_Found):
    """What the fit of a contact that relaxes has found, whether forces or positions were fitted."""

    __words__ = words(logarithmic=("", None, "of which numbers the logarithm was varied"))

    model: ViscoelasticIndentation
    logarithmic: tuple[bool, ...]
    depth: Array

    @property
    def _on_logarithm(self) -> tuple[bool, ...]:
        return self.logarithmic

    @property
    def _contact_notes(self) -> tuple[Note, ...]:
        bed = self.model.bed
        return (*bed.notes, *contact_notes(elastic_like(bed), self.depth, self.radius))


@value
class ViscoelasticFit(_RelaxingFit):
    """What the forces along a measured motion say about a solid that relaxes.

    Parameters
    ----------
    curve : ForceCurve
        The points that were fitted.
    model : ViscoelasticIndentation
        With the fitted numbers, along the fitted depths.
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
        Standard deviation of the forces [N]: as given, else of the free points, else the scatter.
    weights : ndarray, (n,)
        What the residuals were multiplied with; 1 for even noise.
    scatter : float
        Standard deviation of the weighted residuals [N].
    effective_count : float
        Number of independent points that the curve is worth.
    predicted : ndarray, (n,)
        Fitted forces with the baseline [N].
    radius : ndarray, (n,)
        Fitted a [m].
    flags : tuple of Flag
        What speaks against the numbers.
    logarithmic : tuple of bool, (p,)
        Of which numbers the logarithm was varied.
    depth : ndarray, (n,)
        Fitted d, below zero out of contact [m].
    """

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the fitted contact can be trusted."""
        error = self.scatter / max(float(np.ptp(self.curve.force)), 1e-300)
        moved = np.any(self.curve.direction != 0.0)
        free = free_notes(self.curve, self.radius > 0.0, error) if moved else []
        return (*self._contact_notes, *free, QUASISTATIC)


@value
class CreepFit(_RelaxingFit):
    """What the positions under measured forces say about a solid that creeps.

    Parameters
    ----------
    curve : ForceCurve
        Its forces drive and the positions were fitted; on the way to a tenth of the greatest force, the forces.
    model : ViscoelasticIndentation
        With the fitted numbers, under the forces of the contact.
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
        Standard deviation of the positions [m]: as given, else the scatter of those that were fitted.
    weights : ndarray, (n,)
        What the residuals were multiplied with; less than 1 where the noise of the force adds to that of the position.
    scatter : float
        Standard deviation of the weighted residuals [m].
    effective_count : float
        Number of independent points that the curve is worth.
    predicted : ndarray, (n,)
        Fitted positions [m]; where the force was fitted, the measured ones less its misfit, a standard deviation of
        the force for one of the position.
    radius : ndarray, (n,)
        Fitted a [m].
    flags : tuple of Flag
        What speaks against the numbers.
    logarithmic : tuple of bool, (p,)
        Of which numbers the logarithm was varied.
    depth : ndarray, (n,)
        Fitted d [m].
    """

    __words__ = words(
        noise=(r"\sigma", "m", "standard deviation of the positions"),
        scatter=("s", "m", "standard deviation of the weighted residuals"),
        predicted=("D", "m", "fitted positions"),
    )

    @property
    def residuals(self) -> Array:
        """Measured less fitted positions [m]."""
        return np.asarray(self.curve.position - self.predicted)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the fitted contact can be trusted."""
        if np.count_nonzero(self.curve.direction > 0.0) < FEWEST:
            return (*self._contact_notes, QUASISTATIC)
        error = outline(self.curve.approach).noise / max(float(np.ptp(self.curve.force)), 1e-300)
        return (*self._contact_notes, *free_notes(self.curve, self.radius > 0.0, error), QUASISTATIC)


AnyFit = Fit | ViscoelasticFit | CreepFit
"""What a fit may have found."""
