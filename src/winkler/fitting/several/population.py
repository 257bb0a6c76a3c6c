r"""Mean of a fitted number over many curves: scatter between the curves, and errors within them.

.. math:: y_i = \mu + b_i + e_i, \qquad b_i \sim N(0, \tau^2), \qquad e_i \sim N(0, s_i^2)

with the standard error :math:`s_i` of curve i; y is the logarithm of positive quantities, so that moduli are lognormal.
The variance :math:`\tau^2` between the curves is that of restricted maximum likelihood,

.. math:: \sum w_i^2 (y_i-\mu)^2 = \sum w_i - \frac{\sum w_i^2}{\sum w_i}, \qquad w_i = \frac1{\tau^2+s_i^2} ,

and the interval of the mean is that of Hartung and Knapp, with Student's t of k - 1 degrees of freedom,

.. math:: \mathrm{se}^2 = \frac{\max(q, \tfrac12)}{\sum w_i}, \qquad q = \frac{\sum w_i (y_i-\mu)^2}{k-1} .

Errors that the scatter refutes as too large (a chance of 1 %) leave the plain mean, with equal :math:`w_i` and
:math:`\mathrm{se}^2 = s^2/k` of the scatter s.  An error that is zero, unknown, or less than a tenth of the median one
is not believed, and replaced by the median: it would decide the mean alone.

A calibration that all curves share does not average out; its error is added in quadrature.

References
----------
G. Knapp, J. Hartung, Stat. Med. 22, 2693 (2003), https://doi.org/10.1002/sim.1482
W. Viechtbauer, J. Educ. Behav. Stat. 30, 261 (2005), https://doi.org/10.3102/10769986030003261
"""

from __future__ import annotations

import math

import numpy as np

from winkler.fitting.several.standing_out import outlying
from winkler.numerics.types import Array, ArrayLike
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

FEWEST = 2
FEWEST_FOR_DECISIVE = 5
DECISIVE_SHARE = 0.5
"""Share of the weights from which on one curve of five or more decides the mean alone."""
LEAST_ERROR = 0.1
"""Least error that is believed, relative to the median one of three curves or more."""
CHANCE_OF_SCATTER = 0.01
"""Chance of a scatter below which errors are too large for it."""
LEAST_SCATTER = 0.5
"""Least squared scatter over that of the model; the plain rule (zero) holds a little less often with five curves."""
LARGEST_EXPONENT = math.log(np.finfo(float).max)


@value
class Population:
    """Mean of a number over many curves.

    Parameters
    ----------
    count : int
        Number of curves.
    mean : float
        Of positive quantities the geometric mean, in SI units.
    standard_error : float
        Of the mean without the calibration; relative for positive quantities.
    between : float
        Standard deviation between the curves, beyond their errors; relative for positive quantities.
    within : float
        Root mean square of the errors of the single curves; relative for positive quantities.
    calibration : float
        Standard error of the calibration that all curves share; relative for positive quantities.
    logarithmic : bool
        Whether the quantity is positive and its logarithm was averaged.
    outliers : tuple of int
        Indices of curves that do not belong to the others; they are part of the mean.
    weights : ndarray, (k,)
        Weights of the curves in the mean; their sum is 1.
    doubted : tuple of int
        Indices of curves whose error is zero, unknown, or less than a tenth of the median error; the median was used
        for them.
    overstated : bool
        Whether the curves scatter less than their errors allow; the interval follows from the scatter alone.
    """

    __words__ = words(
        count=("", "", "number of curves"),
        mean=("", None, "mean over the curves; of positive quantities the geometric one"),
        standard_error=("", None, "standard error of the mean; relative for positive quantities"),
        between=(r"\tau", None, "standard deviation between the curves; relative for positive quantities"),
        within=("s", None, "typical error of a single curve; relative for positive quantities"),
        calibration=("", None, "error of the calibration that the curves share; relative for positive quantities"),
        logarithmic=("", None, "whether the logarithm was averaged"),
        outliers=("", None, "curves that do not belong to the others"),
        weights=("", "", "shares of the curves in the mean"),
        doubted=("", None, "curves whose error is not believed"),
        overstated=("", None, "whether the scatter is less than the errors allow"),
    )

    count: int
    mean: float
    standard_error: float
    between: float
    within: float
    calibration: float
    logarithmic: bool
    outliers: tuple[int, ...]
    weights: Array
    doubted: tuple[int, ...]
    overstated: bool

    @property
    def decisive(self) -> tuple[int, ...]:
        """Index of the curve that has more than half of the weight, if there are five or more."""
        if self.count < FEWEST_FOR_DECISIVE:
            return ()
        return tuple(np.flatnonzero(self.weights > DECISIVE_SHARE).tolist())

    @property
    def shared_variance(self) -> float:
        """Fraction of the variance that is due to differences between the curves, not to their errors."""
        whole = self.between**2 + self.within**2
        return self.between**2 / whole if whole > 0.0 else 0.0

    def interval(self, confidence: float = 0.95) -> tuple[float, float]:
        """Return the interval of the mean, with the calibration.

        Parameters
        ----------
        confidence : float
            Between 0 and 1.
        """
        scatter = quantile(self.count - 1, confidence) * self.standard_error
        return self._about(math.hypot(scatter, quantile(math.inf, confidence) * self.calibration))

    def range_of_curves(self, confidence: float = 0.95) -> tuple[float, float]:
        """Return the interval for the true value of another curve with the same calibration.

        Parameters
        ----------
        confidence : float
            Between 0 and 1.
        """
        spread = math.hypot(self.between, self.standard_error)
        return self._about(quantile(max(self.count - 2, 1), confidence) * spread)

    def _about(self, width: float) -> tuple[float, float]:
        if not self.logarithmic:
            return self.mean - width, self.mean + width
        center = math.log(self.mean)
        high = math.exp(center + width) if center + width < LARGEST_EXPONENT else math.inf
        return math.exp(center - width), high


def quantile(freedom: float, confidence: float) -> float:
    """Return the half-width of an interval in standard errors, by Student's t with `freedom` degrees of freedom.

    Raises
    ------
    InvalidInput
        If the confidence is not between 0 and 1.
    """
    from scipy.special import ndtri, stdtrit

    if not 0.0 < confidence < 1.0:
        raise InvalidInput(f"confidence is {confidence!r}; give a number between 0 and 1.")
    upper = 0.5 + 0.5 * confidence
    return float(ndtri(upper) if math.isinf(freedom) else stdtrit(freedom, upper))


def population(
    values: ArrayLike, errors: ArrayLike, *, logarithmic: bool = True, calibration: float = 0.0
) -> Population:
    """Return the mean of a fitted number over curves, by random effects.

    Parameters
    ----------
    values : array_like, (k,)
        The number of each curve, in SI units.
    errors : array_like, (k,)
        Their standard errors, in the same units; those of noise alone; zero or nan where one is unknown.
    logarithmic : bool, optional
        Whether the number is positive, and its logarithm is averaged (by default).
    calibration : float, optional
        Standard error of the calibration that all curves share; relative if `logarithmic`.

    Raises
    ------
    InvalidInput
        If there are fewer than two curves, lengths differ, errors are negative, or a positive quantity is not positive.

    Examples
    --------
    >>> cells = population([800.0, 1200.0, 1000.0, 900.0, 1500.0], [40.0, 60.0, 50.0, 45.0, 75.0])
    >>> low, high = cells.interval()
    >>> f"{cells.mean:.0f} Pa, {low:.0f} to {high:.0f}; {cells.between:.0%} between, {cells.within:.0%} within"
    '1053 Pa, 775 to 1432; 24% between, 5% within'
    """
    numbers, stated = np.asarray(values, dtype=float), np.asarray(errors, dtype=float)
    _refuse(numbers, stated, logarithmic, calibration)
    deviations = np.nan_to_num(stated)
    y, variances = numbers, deviations**2
    if logarithmic:
        y, variances = np.log(numbers), (deviations / numbers) ** 2
    unit = float(np.sqrt(np.mean((y - y.mean()) ** 2 + variances))) or 1.0
    doubted, variances = _believed(variances / unit**2)
    y, between = y / unit, _between(y / unit, variances)
    weights = 1.0 / (between + variances)
    mean, squares, least = *_mean(y, weights), LEAST_SCATTER
    if overstated := between == 0.0 and _is_rare(squares, y.size - 1):
        weights = np.full(y.size, 1.0 / float(variances.mean()))
        mean, squares, least = *_mean(y, weights), 0.0
    squared = max(squares / (y.size - 1), least) / float(weights.sum())
    return Population(
        count=y.size,
        mean=math.exp(unit * mean) if logarithmic else unit * mean,
        standard_error=unit * math.sqrt(squared),
        between=unit * math.sqrt(between),
        within=unit * float(np.sqrt(variances.mean())),
        calibration=float(calibration),
        logarithmic=logarithmic,
        outliers=tuple(np.flatnonzero(outlying(y, np.sqrt(variances)) > 1.0).tolist()),
        weights=weights / float(weights.sum()),
        doubted=doubted,
        overstated=overstated,
    )


def _refuse(numbers: Array, deviations: Array, logarithmic: bool, calibration: float) -> None:
    if numbers.ndim != 1 or numbers.shape != deviations.shape or numbers.size < FEWEST:
        raise InvalidInput(
            f"population: numbers have the shape {numbers.shape}, errors {deviations.shape}; give one of each for at "
            f"least {FEWEST} curves."
        )
    if not np.all(np.isfinite(numbers)) or np.any(np.isinf(deviations)) or np.any(deviations < 0.0):
        raise InvalidInput(
            "population: a number or an error is not finite, or an error is negative; leave it out, or give nan for "
            "an error that is unknown."
        )
    if logarithmic and not np.all(numbers > 0.0):
        raise InvalidInput(
            f"population: {numbers.min():.6g} is not positive; give logarithmic=False, or leave this curve out."
        )
    if not (math.isfinite(calibration) and calibration >= 0.0):
        raise InvalidInput(f"population: calibration is {calibration!r}; give a finite error, not negative.")


def _believed(variances: Array) -> tuple[tuple[int, ...], Array]:
    """Return the curves whose error is not believed, and the variances with the median one in their place."""
    known = variances > 0.0
    if not known.any():
        return (), np.full(variances.shape, np.finfo(float).eps)
    least = LEAST_ERROR**2 * float(np.median(variances[known])) if variances.size > FEWEST else 0.0
    doubted = ~known | (variances < least)
    return tuple(np.flatnonzero(doubted).tolist()), np.where(doubted, np.median(variances[~doubted]), variances)


def _mean(y: Array, weights: Array) -> tuple[float, float]:
    """Return the weighted mean, and the weighted sum of squares about it."""
    mean = float(weights @ y / weights.sum())
    return mean, float(weights @ (y - mean) ** 2)


def _is_rare(squares: float, freedom: int) -> bool:
    """Return whether the scatter is too small for the errors."""
    from scipy.special import gammainc

    return bool(gammainc(0.5 * freedom, 0.5 * squares) < CHANCE_OF_SCATTER)


def _between(y: Array, variances: Array) -> float:
    """Return the variance between the curves by restricted maximum likelihood."""
    from scipy.optimize import brentq

    def excess(between: float) -> float:
        weights = 1.0 / (between + variances)
        mean = weights @ y / weights.sum()
        return float(weights**2 @ (y - mean) ** 2 - weights.sum() + weights**2 @ np.ones(y.size) / weights.sum())

    most = 4.0 * float(np.ptp(y)) ** 2 + 1e-300
    if excess(0.0) <= 0.0 or excess(most) >= 0.0:
        return 0.0
    return float(brentq(excess, 0.0, most, xtol=1e-15, rtol=1e-10))
