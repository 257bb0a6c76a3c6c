"""Two groups of curves, such as treated and control: the ratio of their means with an interval.

The calibration of one cantilever is the same in both groups, and drops out of the ratio.
"""

from __future__ import annotations

import math

from winkler.fitting.several.population import Population, quantile
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words


@value
class GroupRatio:
    """Ratio of the means of two groups of curves.

    Parameters
    ----------
    ratio : float
        Mean of the first over that of the second.
    low, high : float
        Interval.
    freedom : float
        Degrees of freedom.
    """

    __words__ = words(
        ratio=("", "", "mean of the first group over that of the second"),
        low=("", "", "lower end of the interval"),
        high=("", "", "upper end of the interval"),
        freedom=("", "", "degrees of freedom"),
    )

    ratio: float
    low: float
    high: float
    freedom: float

    @property
    def differ(self) -> bool:
        """Whether the interval excludes one."""
        return not self.low <= 1.0 <= self.high


def ratio_of(first: Population, second: Population, confidence: float = 0.95) -> GroupRatio:
    """Return the ratio of the means of two groups, by Welch's degrees of freedom.

    Parameters
    ----------
    first, second : Population
        Results for a positive quantity, measured with one calibration.
    confidence : float, optional
        Between 0 and 1.

    Raises
    ------
    InvalidInput
        If the quantity is not positive.

    References
    ----------
    B. L. Welch, Biometrika 34, 28 (1947), https://doi.org/10.1093/biomet/34.1-2.28

    Examples
    --------
    >>> from winkler.fitting.several.population import population
    >>> control = population([1000.0, 1100.0, 950.0, 1050.0], [20.0, 20.0, 20.0, 20.0])
    >>> treated = population([700.0, 650.0, 720.0, 690.0], [20.0, 20.0, 20.0, 20.0])
    >>> found = ratio_of(treated, control)
    >>> f"{found.ratio:.2f}, {found.low:.2f} to {found.high:.2f}"
    '0.67, 0.61 to 0.74'
    """
    if not (first.logarithmic and second.logarithmic):
        raise InvalidInput("ratio_of: a ratio needs positive quantities; give populations with logarithmic=True.")
    parts = [(group.standard_error**2, group.count - 1) for group in (first, second)]
    whole = sum(variance for variance, _ in parts)
    fourth = sum(variance**2 / freedom for variance, freedom in parts)
    freedom = whole**2 / fourth if fourth > 0.0 else float(first.count + second.count - 2)
    width = quantile(freedom, confidence) * math.sqrt(whole)
    ratio = first.mean / second.mean
    return GroupRatio(ratio, ratio * math.exp(-width), ratio * math.exp(width), freedom)
