"""Results of fits: contacts with or without adhesion, and relaxing contacts by forces or by positions."""

from __future__ import annotations

import numpy as np

from winkler.fitting.curves.outline import FEWEST, outline
from winkler.fitting.estimate import FitEstimate
from winkler.fitting.layered.notes import layered_fit_notes
from winkler.fitting.validity import Model, fit_notes, free_notes
from winkler.media.relaxing.layered import ViscoelasticCoatedHalfSpace
from winkler.numerics.types import Array
from winkler.problems.normal.validity import contact_notes
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.march import elastic_like
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

QUASISTATIC = Note(
    Assumption.CURVE,
    Standing.APPROXIMATE,
    "Machine and liquid: the model has no inertia of the cantilever and no adhesive pull. The drag of a liquid "
    "is proportional to the velocity of the cantilever base, if drag is free.",
    "assumptions of the fit",
)


@value
class Fit(FitEstimate):
    """Parameters of a model fitted to a curve.

    Parameters
    ----------
    curve : ForceCurve
        The fitted points, without hold periods.
    model : Indentation or AdhesiveIndentation
        The model with the fitted parameters; its load is the maximum depth.
    names : tuple of str, (p,)
        Names of the parameters.
    values : ndarray, (p,)
        Values of the parameters, in SI units.
    standard_errors : ndarray, (p,)
        Standard errors in the same units, for white and correlated (slow) noise.
    correlation : ndarray, (p, p)
        Correlation of the errors of the parameters.
    lows, highs : ndarray, (p,)
        Bounds of the parameters, as given.
    noise : float
        Standard deviation of the forces [N]: as given, otherwise estimated from the points without contact.
    weights : ndarray, (n,)
        Factors of the residuals; 1 for uniform noise.
    scatter : float
        Standard deviation of the weighted residuals [N].
    effective_count : float
        Number of independent points with this scatter that would give the same errors.
    slow_share : float
        Part of the noise's variance that is slow (1/f, a random walk, or correlated neighbours).
    log_likelihood : float
        Logarithm of the likelihood, integrated over the noise. Only differences between fits of the same data have a
        meaning.
    reaches : ndarray, (p, 5)
        Half-widths of the intervals of 68, 90, 95, 99 and 99.7 %, divided by the standard errors.
    stretches : ndarray, (p, 2)
        Factors of the lower and upper half-widths of intervals by profile likelihood; 1 for nearly linear models.
    predicted : ndarray, (n,)
        Fitted forces with the baseline [N].
    radius : ndarray, (n,)
        Fitted contact radii [m].
    flags : tuple of Flag
        Doubts about the parameters.
    logarithmic : tuple of bool, (p,)
        Whether the logarithm of the parameter was varied.
    contact : ndarray of bool, (n,)
        Points in contact.
    """

    __words__ = words(contact=("", None, "where the tip is in contact"))

    model: Model
    contact: Array

    @property
    def touched(self) -> Array:
        """Which points are in contact, ``(n,)``."""
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
        """How far the fitted contact can be trusted at its largest depth, and whether the curve determines it."""
        error = self.scatter / float(np.ptp(self.curve.force))
        own = fit_notes(self.model, self.curve, self.names, self.contact, float(self.radius.max()), error)
        return (*self.model.solve().validity, *own)


@value
class _RelaxingFit(FitEstimate):
    """Fit of a relaxing contact, by forces or positions."""

    model: ViscoelasticIndentation
    depth: Array

    @property
    def _contact_notes(self) -> tuple[Note, ...]:
        bed = self.model.bed
        if isinstance(bed.medium, ViscoelasticCoatedHalfSpace):
            own = layered_fit_notes(bed, self.names, self.curve.time, self.depth, self.radius)
            return (*bed.notes, *own)
        return (*bed.notes, *contact_notes(elastic_like(bed), self.depth, self.radius))


@value
class ViscoelasticFit(_RelaxingFit):
    """Fit of a viscoelastic solid to forces under a measured motion; all other fields are those of `Fit`.

    Parameters
    ----------
    model : ViscoelasticIndentation
        The model with the fitted parameters, along the fitted depths.
    noise : float
        Standard deviation of the forces [N]: as given, otherwise estimated from the points without contact, otherwise
        the scatter.
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
    """Fit of a creeping solid to positions under measured forces; all other fields are those of `Fit`.

    Parameters
    ----------
    curve : ForceCurve
        Positions are fitted under its forces; during approach, up to a tenth of the maximum force, forces are fitted.
    model : ViscoelasticIndentation
        The model with the fitted parameters, under the forces of the contact.
    noise : float
        Standard deviation of the positions [m]: as given, else the scatter of those that were fitted.
    weights : ndarray, (n,)
        Factors of the residuals; less than 1 where the noise of the force adds to that of the position.
    scatter : float
        Standard deviation of the weighted residuals [m].
    predicted : ndarray, (n,)
        Fitted positions [m]. Where forces were fitted, the deviation of the force is converted: one standard deviation
        of the force counts as one of the position.
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
"""Any fit."""
