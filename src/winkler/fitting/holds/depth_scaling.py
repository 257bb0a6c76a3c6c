r"""Poroelastic or viscoelastic: the power of the contact radius with which the times of a relaxation grow.

A liquid diffuses across the contact in a time that grows as :math:`a^2`; a viscoelastic body relaxes in its own time,
:math:`a^0`.  Holds with several contact radii are shifted into one curve, as sweeps at several temperatures are, and
the power is that of the shifts, by generalised least squares with their covariance.
"""

from __future__ import annotations

import enum
import math
from collections.abc import Sequence

import numpy as np

from winkler.fitting.holds.held_force import HeldForce, checked_holds
from winkler.numerics.springs.pairwise_shifts import pairwise_shifts
from winkler.numerics.springs.relaxation_spectrum import estimate_spectrum
from winkler.numerics.springs.spectrum_response import Measurements, Response
from winkler.numerics.types import Array
from winkler.problems.master_curves.temperature_groups import in_own_units, spread_times
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

LEAST_RATIO = 1.05
"""Least ratio of the greatest contact radius to the smallest."""
PER_DECADE = 4
ROUNDS = 5
NEW_GRID = 0.5
UNLIKELY = 1e-3
"""Probability of the misfit of the shifts below which they follow no power."""
SURE = 0.99
"""Confidence of the interval by which a kind of body is excluded."""


class HoldVerdict(enum.Enum):
    """What the holds determine."""

    POROELASTIC = "poroelastic"
    VISCOELASTIC = "viscoelastic"
    UNDECIDED = "cannot tell"
    NEITHER = "neither"


@value
class DepthScaling:
    """Growth of the relaxation times with the contact radius.

    Parameters
    ----------
    radius : ndarray, (m,)
        a [m] of each hold, rising.
    shift_factor, shift_error : ndarray, (m,)
        Times relative to those of the smallest contact [-], and the standard error of their natural logarithm.
    exponent : float
        Power of the contact radius with which they grow [-]: 2 of a poroelastic body, 0 of a viscoelastic one.
    error : float
        Its standard error [-].
    misfit : float
        Weighted squares of the deviations of the shifts from the power law [-].
    freedom : float
        Degrees of freedom of the errors.
    verdict : str
        "poroelastic", "viscoelastic", "cannot tell" or "neither".
    """

    __words__ = words(
        radius=("a", "m", "contact radius of each hold"),
        shift_factor=("", "", "times relative to those of the smallest contact"),
        shift_error=("", "", "standard error of the natural logarithm of the shift factor"),
        exponent=("n", "", "power of the contact radius with which the times grow"),
        error=("", "", "standard error of the exponent"),
        misfit=("", "", "weighted squares of what the power leaves of the shifts"),
        freedom=("", "", "degrees of freedom with which the errors are known"),
        verdict=("", None, "poroelastic, viscoelastic, cannot tell or neither"),
    )

    radius: Array
    shift_factor: Array
    shift_error: Array
    exponent: float
    error: float
    misfit: float
    freedom: float
    verdict: str

    def interval(self, confidence: float = 0.95) -> tuple[float, float]:
        """Return the interval of the exponent."""
        from scipy.stats import t

        width = float(t.ppf(0.5 + 0.5 * confidence, self.freedom)) * self.error
        return self.exponent - width, self.exponent + width


def depth_scaling(holds: Sequence[HeldForce], *, vertical: bool = True) -> DepthScaling:
    """Return how relaxation times grow with the contact radius: poroelastic or viscoelastic body.

    Parameters
    ----------
    holds : sequence of HeldForce
        Two or more, of one shape of indenter, with different contact radii: other depths, or other punches.
    vertical : bool, optional
        Whether the forces of each hold period have a free factor, so that an error of the depth does not bias the
        verdict.

    Raises
    ------
    InvalidInput
        If there are fewer than two, shapes differ, or the contact radii are nearly the same.
    NotConverged
        If the iteration does not converge.
    """
    from scipy.stats import chi2

    rows = distinct_radii("depth_scaling", checked_holds("depth_scaling", holds, 2))
    radius = np.array([hold.radius for hold in rows])
    group = np.repeat(np.arange(len(rows)), [hold.time.size for hold in rows])
    modulus = np.concatenate([hold.force / hold.unit_force for hold in rows])
    time = np.concatenate([hold.time for hold in rows])
    measured, _, _ = in_own_units((Measurements(Response.RELAXATION, time, group, modulus),))
    shifts = pairwise_shifts(measured, len(rows), 0)
    for _ in range(ROUNDS):
        times = spread_times(measured, shifts, PER_DECADE)
        found = estimate_spectrum(measured, times, shifts, reference=0, free_factors=vertical)
        moved = float(np.max(np.abs(found.shifts - shifts)))
        shifts = found.shifts
        if moved < NEW_GRID:
            break
    first = times.size + 2
    covariance = found.covariance[first : first + len(rows) - 1, first : first + len(rows) - 1]
    root = np.linalg.cholesky(covariance)
    column, target = np.linalg.solve(root, np.log(radius[1:] / radius[0])), np.linalg.solve(root, shifts[1:])
    curvature = float(column @ column)
    exponent = float(column @ target) / curvature
    misfit = float(np.sum((target - exponent * column) ** 2))
    result = DepthScaling(
        radius,
        np.exp(shifts),
        np.append(0.0, np.sqrt(np.diag(covariance))),
        exponent,
        1.0 / math.sqrt(curvature),
        misfit,
        found.freedom,
        HoldVerdict.NEITHER.value,
    )
    if len(rows) > 2 and float(chi2.sf(misfit, len(rows) - 2)) < UNLIKELY:
        return result
    low, high = result.interval(SURE)
    liquid, solid = low <= 2.0 <= high, low <= 0.0 <= high
    names = {
        (True, True): HoldVerdict.UNDECIDED,
        (True, False): HoldVerdict.POROELASTIC,
        (False, True): HoldVerdict.VISCOELASTIC,
        (False, False): HoldVerdict.NEITHER,
    }
    return DepthScaling(**(vars(result) | {"verdict": names[liquid, solid].value}))


def distinct_radii(owner: str, holds: Sequence[HeldForce]) -> list[HeldForce]:
    """Return holds by rising contact radius; refuse those with nearly the same."""
    rows = sorted(holds, key=lambda hold: hold.radius)
    if rows[-1].radius < LEAST_RATIO * rows[0].radius:
        raise InvalidInput(
            f"{owner}: the contact radii, {rows[0].radius:.4g} m to {rows[-1].radius:.4g} m, are nearly the same; give "
            "holds at other depths, or with another punch."
        )
    return rows
