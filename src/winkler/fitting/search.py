"""The search for the best numbers of a fit: evaluations are counted, the best is kept, and a time limit ends it."""

from __future__ import annotations

import math
import time
from collections.abc import Callable

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, NotConverged
from winkler.values.value import value, words


@value
class FitState:
    """State of a running fit.

    Parameters
    ----------
    evaluations : int
        Number of predictions of the curve.
    names : tuple of str, (p,)
        Names of the parameters.
    values : ndarray, (p,)
        The best numbers so far, in SI units.
    scatter : float
        Standard deviation of the weighted residuals there, in units of the fitted quantity.
    """

    __words__ = words(
        evaluations=("", "", "how often the curve was predicted"),
        names=("", None, "what is varied"),
        values=("", None, "the best numbers so far, in SI units"),
        scatter=("s", None, "standard deviation of the weighted residuals there"),
    )

    evaluations: int
    names: tuple[str, ...]
    values: Array
    scatter: float


class Search:
    """Counts the evaluations of one fit, and ends it at its time limit.

    Parameters
    ----------
    time_limit : float, optional
        From now on [s].
    on_state : callable, optional
        Called with a `FitState` after each evaluation.

    Raises
    ------
    InvalidInput
        If the limit is not a positive time.
    """

    def __init__(self, time_limit: float = math.inf, on_state: Callable[[FitState], None] | None = None) -> None:
        if not isinstance(time_limit, int | float) or not time_limit > 0.0:
            raise InvalidInput(f"fit: time_limit is {time_limit!r}; give a positive time in s.")
        self.time_limit = time_limit
        self.end = time.monotonic() + time_limit
        self.on_state = on_state
        self.evaluations = 0
        self.scatter = math.inf
        self.best: dict[str, float] = {}

    def begin(self) -> None:
        """Reset the best scatter, for other points or weights."""
        self.scatter = math.inf

    def record(self, numbers: dict[str, float], squares: float, count: int) -> None:
        """Count an evaluation, and pass on the state.

        Parameters
        ----------
        numbers : dict of str to float
            Parameters of the evaluation.
        squares : float
            Sum of the squared weighted residuals of `count` points.

        Raises
        ------
        NotConverged
            If the time limit is reached.
        """
        self.evaluations += 1
        scatter = math.sqrt(squares / max(count, 1))
        if scatter < self.scatter or not self.best:
            self.scatter, self.best = scatter, numbers
        self.check()
        if self.on_state is not None:
            values = np.array(list(self.best.values()))
            self.on_state(FitState(self.evaluations, tuple(self.best), values, self.scatter))

    def check(self) -> None:
        """Raise NotConverged if the time limit is reached."""
        if time.monotonic() > self.end:
            many = f"{self.evaluations} evaluation{'s' * (self.evaluations != 1)}"
            raise NotConverged(
                f"fit: least squares have not converged within the time limit of {self.time_limit:g} s, after "
                f"{many}; give more time, starts or bounds nearer to the answer, fewer free numbers, or fewer "
                "points."
            )
