"""From least squares to generalised least squares: steps under the noise that the residuals show.

Where the model does not explain the curve, or hardly any independent points remain, slow noise would only stand for
what the model misses: the numbers of least squares stay, and the step not taken is added to their errors.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.fitting.least_squares import bounds
from winkler.fitting.misfit import FEWEST_FREE_POINTS, Misfit, misfit_of
from winkler.fitting.noise.estimate import NoiseEstimate
from winkler.fitting.search import Search
from winkler.fitting.task import FitTask, Prediction
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity

MOST_STEPS = 6
SETTLED_ERRORS = 0.02
"""Greatest last step in standard errors."""
STRAIGHT = 0.1
"""Part of the settled step by which a prediction may leave its tangent, in parts of what the step changes."""
NEAR_ERRORS = 0.3
"""Greatest distance from a known optimum, in standard errors, at which a search that began elsewhere has found it."""
MOST_HALVINGS = 4
LONGEST_STEP = 1.0
LEAST_GAIN = -0.5
"""Least change of the logarithm of the likelihood by a step."""
POINTS_PER_PARAMETER = 3
"""Fewest independent points for each parameter with which the numbers of least squares are changed."""
CLEAR_GAIN = 0.5
"""Least gain of the logarithm of the likelihood for which another optimum is taken."""


class _GeneralisedFields(NamedTuple):
    """Data of a fit at its coordinates.

    Parameters
    ----------
    coordinates : ndarray, (p,)
    prediction : Prediction
    residuals : ndarray, (n,)
        Weighted.
    noise : NoiseEstimate
    """

    coordinates: Array
    prediction: Prediction
    residuals: Array
    noise: NoiseEstimate


class Generalised(_GeneralisedFields):
    """A fit at its coordinates."""

    @property
    def covariance(self) -> Array:
        """Of the coordinates ``(p, p)``, with a step that was not taken."""
        return np.asarray(self.noise.covariance + np.outer(self.noise.step, self.noise.step))

    def deviation(self, task: FitTask) -> float:
        """Return the standard deviation of the residuals out of contact, or of all if there are few."""
        free = self.residuals[task.quiet(self.prediction)]
        if free.size >= FEWEST_FREE_POINTS:
            return float(np.std(free))
        return self.scatter

    @property
    def scatter(self) -> float:
        """Standard deviation of the residuals."""
        return self._deviation_of(self.residuals)

    def scatter_of(self, task: FitTask) -> float:
        """Return the standard deviation of the residuals as the noise alone weighs them."""
        return self._deviation_of(self.residuals if task.misfits is None else self.residuals * task.misfits)

    def _deviation_of(self, residuals: Array) -> float:
        return float(np.linalg.norm(residuals) / np.sqrt(max(residuals.size - self.coordinates.size, 1)))

    def misfit(self, task: FitTask, noise: float) -> Misfit:
        """Return the misfit, for a standard deviation of the noise; computed once."""
        known: dict[float, Misfit] = self.__dict__.setdefault("misfits", {})
        if noise not in known:
            counted, freedoms = task.weights > 0.0, task.freedoms(self.prediction)
            left, level = self.residuals - self.noise.disturbance - self.noise.followed, noise or np.finfo(float).tiny
            left = left if task.misfits is None else left * task.misfits
            known[noise] = misfit_of(left, self.prediction.touched, counted, freedoms, level)
        return known[noise]


def generalised(
    task: FitTask, coordinates: Array, noise: float, search: Search, known: Generalised | None = None
) -> Generalised:
    """Return generalised least squares from the coordinates of least squares; at a bound, or for a misfit, these.

    Parameters
    ----------
    task : FitTask
    coordinates : ndarray, (p,)
    noise : float
        Standard deviation; zero: estimated.
    search : Search
        Counts the predictions.
    known : Generalised, optional
        An optimum that is returned as soon as a step has come near it, with the same points in contact.
    """
    begun = here = _at(task, coordinates)
    low, high = bounds(task.parameters, coordinates)
    margin = 1e-6 * (1.0 + np.abs(coordinates))
    if np.any(coordinates <= low + margin) or np.any(coordinates >= high - margin) or not _is_noise(task, here, noise):
        return here
    for _ in range(MOST_STEPS):
        step = here.noise.step
        if not np.max(np.abs(step) / np.sqrt(np.diag(here.noise.covariance))) > SETTLED_ERRORS:
            break
        step = step * min(1.0, LONGEST_STEP / float(np.max(np.abs(step))))
        further = _stepped(task, here, step, low + margin, high - margin, search)
        if further is None:
            break
        here = further
        if known is not None and _is_near(here, known):
            return known
    if here is begun or _is_noise(task, here, noise):
        return here
    _record(task, begun, search)
    return begun


def likeliest(task: FitTask, best: Generalised, noise: float, search: Search) -> Generalised:
    """Return the likeliest optimum of a fit that may have several (`FitTask.restarts`).

    Parameters
    ----------
    task : FitTask
    best : Generalised
        From `generalised`.
    noise, search
        As there.
    """
    low, high = bounds(task.parameters, best.coordinates)
    margin = 2e-6 * (1.0 + np.abs(best.coordinates))
    for start in task.restarts(best.coordinates, best.covariance):
        try:
            with np.errstate(
                divide="ignore", invalid="ignore"
            ):  # a start at which a number has no effect is no optimum
                other = generalised(task, np.clip(start, low + margin, high - margin), noise, search, best)
        except (OutsideValidity, np.linalg.LinAlgError):
            search.check()
            continue
        if other is best:
            continue
        explains = _is_noise(task, other, noise) or not _is_noise(task, best, noise)
        if explains and other.noise.likelihood > best.noise.likelihood + CLEAR_GAIN:
            best = other
    return best


def _is_noise(task: FitTask, here: Generalised, noise: float) -> bool:
    """Return whether the residuals may be noise."""
    enough = here.noise.effective_count >= POINTS_PER_PARAMETER * here.coordinates.size
    return enough and here.misfit(task, noise or here.deviation(task)).explained


def _stepped(
    task: FitTask, here: Generalised, step: Array, low: Array, high: Array, search: Search
) -> Generalised | None:
    """Return the fit after a step that does not make the residuals less likely, halved where needed."""
    for _ in range(MOST_HALVINGS):
        try:
            further = _at(task, np.clip(here.coordinates + step, low, high), here)
        except OutsideValidity:
            search.check()
        else:
            _record(task, further, search)
            if further.noise.likelihood - here.noise.likelihood > LEAST_GAIN:
                return further
        step = 0.5 * step
    return None


def _record(task: FitTask, here: Generalised, search: Search) -> None:
    """Make a fit the state of the search, whatever its scatter."""
    search.begin()
    squares = float(here.residuals @ here.residuals)
    search.record(task.numbers(here.coordinates), squares, int(np.count_nonzero(task.weights)))


def _is_near(here: Generalised, known: Generalised) -> bool:
    """Return whether a fit is within a part of the errors of a known optimum, with the same points in contact."""
    apart = np.abs(here.coordinates - known.coordinates) / np.sqrt(np.diag(known.noise.covariance))
    return bool(apart.max() <= NEAR_ERRORS) and np.array_equal(known.prediction.touched, here.prediction.touched)


def _at(task: FitTask, coordinates: Array, before: Generalised | None = None) -> Generalised:
    """Return the fit at coordinates; behind a whole step, along which the prediction is straight, the noise stays.

    The likelihood of each candidate is that at its optimum, and a straight step does not move this.
    """
    prediction = task.predicted(coordinates)
    residuals = (task.measured - prediction.fitted) * task.weights
    if before is not None:
        known, bent = before.noise, residuals - before.residuals + before.noise.followed
        limit = min(float(np.sqrt(known.spectrum.min())), STRAIGHT * float(np.linalg.norm(known.followed)))
        if np.linalg.norm(bent) <= SETTLED_ERRORS * limit:
            return Generalised(coordinates, prediction, residuals, known.behind_its_step)
    jacobian = task.instrument(coordinates, prediction)
    return Generalised(coordinates, prediction, residuals, task.noise_of(residuals, jacobian))
