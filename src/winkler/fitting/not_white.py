"""Noise that was stated to be white, and is not."""

from __future__ import annotations

import math
from collections.abc import Iterator

from winkler.fitting.curves.checks import Flag
from winkler.fitting.generalised import Generalised
from winkler.fitting.noise.estimate import noise_of
from winkler.fitting.task import FitTask

__all__ = ["not_white"]

LEAST_ODDS = 20.0
"""Of slow noise or disturbances to white noise, for which white noise is doubted."""


def not_white(task: FitTask, best: Generalised) -> Iterator[Flag]:
    """Yield a doubt if residuals are slow where the noise was stated to be white.

    Parameters
    ----------
    task : FitTask
    best : Generalised
        The fit at its coordinates.
    """
    if not task.curve.has_white_noise:
        return
    jacobian = task.instrument(best.coordinates, best.prediction)
    allowed = noise_of(best.residuals, jacobian, task.courses(jacobian))
    if allowed.likelihood - best.noise.likelihood > math.log(LEAST_ODDS):
        yield Flag(
            "not_white",
            f"The noise was stated to be white, but {allowed.slow_share:.0%} of its variance in the residuals is slow "
            "or follows a drift, tilt or drag: intervals are too narrow. Leave noise_spectrum out.",
        )
