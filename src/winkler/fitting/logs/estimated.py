r"""Numbers of a log with errors that allow for slow noise.

The correlation :math:`r` of neighbours makes the mean of :math:`n` samples as uncertain as that of
:math:`n(1-r)/(1+r)` independent ones.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array


class Estimate(NamedTuple):
    """A number with its standard error, and how many independent rows it has beyond the fitted numbers."""

    value: float
    error: float
    freedom: float

    @property
    def interval(self) -> tuple[float, float]:
        """The interval of 95 %, by Student's distribution."""
        from scipy.special import stdtrit

        half = float(stdtrit(self.freedom, 0.975)) * self.error
        return self.value - half, self.value + half


def inflation(rest: Array, fitted: int) -> float:
    """Return by which factor the correlation of neighbours widens the variance of a mean of residuals.

    Parameters
    ----------
    rest : ndarray, (n,)
        Residuals in their order.
    fitted : int
        Numbers that were fitted, each of which makes the correlation too small by about 1/n.
    """
    square = float(rest @ rest)
    correlation = float(rest[:-1] @ rest[1:]) / square if square > 0.0 else 0.0
    held = min(max(correlation + fitted / rest.size, 0.0), 0.99)
    return (1.0 + held) / (1.0 - held)


def last_of_line(rows: Array, samples: Array) -> Estimate:
    """Return the last number of a linear fit.

    Parameters
    ----------
    rows : ndarray, (n, p)
        What each number is multiplied with.
    samples : ndarray, (n,)
        In their order.
    """
    numbers, *_ = np.linalg.lstsq(rows, samples, rcond=None)
    rest = samples - rows @ numbers
    freedom = samples.size - rows.shape[1]
    factor = inflation(rest, rows.shape[1])
    variance = float(np.linalg.inv(rows.T @ rows)[-1, -1]) * float(rest @ rest) / freedom * factor
    return Estimate(float(numbers[-1]), math.sqrt(variance), max(freedom / factor, 1.0))


def mean_of(samples: Array) -> Estimate:
    """Return the mean of samples ``(n,)`` in their order."""
    return last_of_line(np.ones((samples.size, 1)), samples)
