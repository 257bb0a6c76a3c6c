r"""Steps of a stiff system of which the fast part has settled: two implicit stages, as long as the slow part allows.

With :math:`\gamma = 1-\sqrt{1/2}` both stages :math:`k = f(y+\gamma h k)` are solved by Newton's method; the step is of
second order, L-stable, and its weights are positive, so that what only grows never falls.  The rates may have kinks
(contact begins and ends): a Newton step that does not bring rates and stages together is shortened.  The error
estimated from both ends is filtered by the same matrix: what is fast has settled, however wrong its rate was.

R. Alexander, SIAM J. Numer. Anal. 14 (1977) 1006-1021, doi:10.1137/0714068;
M. E. Hosea, L. F. Shampine, Appl. Numer. Math. 20 (1996) 21-37, doi:10.1016/0168-9274(95)00115-8
"""

from __future__ import annotations

import math
from typing import NamedTuple, Protocol

import numpy as np

from winkler.numerics.equations.stabilised import step_error
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

GAMMA = 1.0 - math.sqrt(0.5)
MOST_TRIALS = 20
STAGE_TOLERANCE, SETTLED_TOLERANCE = 1e-8, 1e-6
"""Parts of the greatest rate to which a stage is met, the second where one more Newton step leaves it there: rounding.

The rates themselves are returned, so that nothing is lost."""
STEP_SHARES = (1.0, 0.5, 0.25, 0.1, 0.03)
"""Of a Newton step, tried in turn."""
SUFFICIENT_REDUCTION = 0.3
"""A share that brings the squared misfit down to this part is taken at once."""


class StiffSystem(Protocol):
    """Rates f(y) that are never negative, and how they change."""

    @property
    def weights(self) -> Array:
        """With which misfits of the rates count ``(n,)``."""
        ...

    def rates(self, state: Array) -> Array:
        """Return f(y) ``(n,)``."""
        ...

    def slopes(self, state: Array) -> tuple[Array, Array]:
        """Return which rates change with the state ``(n,)``, and how: their rows of the derivative ``(m, n)``."""
        ...

    def guess(self, state: Array, first: Array, length: float) -> Array:
        """Return mean rates over a length [as that of the step], if the fast part settles at once ``(n,)``."""
        ...


class ImplicitStep(NamedTuple):
    """The state after a step, the rates there, and the estimated error of the state ``(n,)``."""

    end: Array
    last: Array
    error: Array


def implicit_step(system: StiffSystem, start: Array, first: Array, length: float) -> ImplicitStep:
    """Return the state after a step.

    Parameters
    ----------
    system : StiffSystem
    start, first : ndarray, (n,)
        The state, and its rates.
    length : float

    Raises
    ------
    NotConverged
        If a stage is not met: take a shorter step.
    """
    inner = GAMMA * length
    one, _ = _stage(system, start, first, inner)
    base = start + (length - inner) * one
    two, slopes = _stage(system, base, one, inner)
    end = base + inner * two
    raw = step_error(start, end, first, two, length)
    changing, rows = slopes or system.slopes(end)
    error = raw.copy()
    error[changing] = _solved(changing, rows, inner, raw[changing], raw)
    return ImplicitStep(end, two, error)


def _solved(changing: Array, rows: Array, inner: float, right: Array, rates_known: Array) -> Array:
    """Return what (1 - gamma h f') takes to `right`, where rates change; elsewhere it is known."""
    matrix = np.eye(len(rows)) - inner * rows[:, changing]
    others = ~changing
    return np.asarray(np.linalg.solve(matrix, right + inner * (rows[:, others] @ rates_known[others])))


def _stage(system: StiffSystem, base: Array, near: Array, inner: float) -> tuple[Array, tuple[Array, Array] | None]:
    """Return the rates of an implicit stage, k = f(base + gamma h k), and the slopes last used, if any were."""

    def met(rates: Array) -> tuple[float, Array, Array]:
        there = system.rates(base + inner * rates)
        return float(system.weights @ (there - rates) ** 2), rates, there

    misfit, rates, there = min((met(guess) for guess in (near, system.guess(base, near, inner))), key=lambda m: m[0])
    slopes, close = None, False
    for _ in range(MOST_TRIALS):
        missed, most = float(np.max(np.abs(there - rates))), float(np.max(there))
        if missed <= (SETTLED_TOLERANCE if close else STAGE_TOLERANCE) * most:
            return there, slopes
        close = missed <= SETTLED_TOLERANCE * most
        changing, rows = slopes = system.slopes(base + inner * rates)
        change = -rates
        change[changing] = _solved(changing, rows, inner, (there - rates)[changing], change)
        tried = [(misfit, rates, there)] if close else []
        for share in STEP_SHARES:
            tried.append(met(np.maximum(rates + share * change, 0.0)))
            if tried[-1][0] <= SUFFICIENT_REDUCTION * misfit:
                break
        misfit, rates, there = min(tried, key=lambda m: m[0])
    raise NotConverged(f"An implicit step of length {inner / GAMMA:.3g} is not met; use a shorter one.")
