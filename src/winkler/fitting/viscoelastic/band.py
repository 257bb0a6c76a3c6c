"""The relaxation function of a fit, with its interval from the errors of the parameters."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.fitting.layered.response import relaxing_solid
from winkler.fitting.outcome import CreepFit, ViscoelasticFit
from winkler.fitting.parameters import changed
from winkler.fitting.varied import CURVE_PARAMETERS
from winkler.foundation.bed import Bed
from winkler.media.relaxing.layered import ViscoelasticCoatedHalfSpace
from winkler.numerics.springs.exponential_sums import RelaxationSeries
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.viscoelastic.march import relaxation_of

RELATIVE_STEP = 1e-3


class RelaxationBand(NamedTuple):
    """A modulus over time, and the ends of its interval [Pa], each ``(m,)``."""

    modulus: Array
    low: Array
    high: Array


def observed_times(found: ViscoelasticFit | CreepFit) -> tuple[float, float]:
    """Return the sampling interval and the time in contact [s], outside of which the curve has no information."""
    time = found.curve.time
    steps = np.diff(time)
    touched = np.flatnonzero(found.radius > 0.0)
    return float(np.median(steps[steps > 0.0])), float(time[touched[-1]] - time[touched[0]])


def relaxation_band(found: ViscoelasticFit | CreepFit, time: ArrayLike, confidence: float = 0.95) -> RelaxationBand:
    """Return the relaxation modulus E*(t), or phi(t) of proportional media, with its interval.

    For layers it is the modulus of a half-space of the fitted solid.

    The errors of the parameters are propagated to first order, in the logarithm of the modulus.

    Parameters
    ----------
    found : ViscoelasticFit or CreepFit
    time : array_like, (m,)
        Since a step [s], positive.
    confidence : float, optional
        Between 0 and 1.

    Returns
    -------
    RelaxationBand
    """
    t = np.asarray(time, dtype=float)
    relaxation = _relaxation(found.model.bed).at(t)
    own = [index for index, name in enumerate(found.names) if name not in CURVE_PARAMETERS]
    slopes = np.zeros((t.size, len(found.names)))
    for index in own:
        number = float(found.values[index])
        step = RELATIVE_STEP * min(
            abs(number) or 1.0, float(found.standard_errors[index]) / RELATIVE_STEP or RELATIVE_STEP
        )
        moved = changed(found.model, {found.names[index]: number - step})
        slopes[:, index] = (np.log(relaxation) - np.log(_relaxation(moved.bed).at(t))) / step
    variance = np.einsum("ti,ij,tj->t", slopes, found.covariance, slopes)
    width = found.quantile(confidence) * np.sqrt(np.maximum(variance, 0.0))
    return RelaxationBand(relaxation, relaxation * np.exp(-width), relaxation * np.exp(width))


def _relaxation(bed: Bed) -> RelaxationSeries:
    if isinstance(bed.medium, ViscoelasticCoatedHalfSpace):
        solid = relaxing_solid(bed)
        return solid.series.scaled(2.0 / (1.0 - solid.poisson))
    return relaxation_of("relaxation_band", bed)
