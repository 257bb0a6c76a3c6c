r"""Modulus, Poisson's ratio and diffusivity of a poroelastic body from the forces of holds, by least squares.

.. math:: F_j(t) = F_{\infty j} + (F_{0j}-F_{\infty j})\,g(Dt/a_j^2,\nu),\quad F_{0j} = G f_j,\quad F_{\infty j} =
   \frac{F_{0j}}{2(1-\nu)},

with the force :math:`f_j` of the indenter at its depth on an incompressible body of unit modulus.  Residuals are
relative.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from winkler.fitting.holds.held_force import HeldForce, checked_holds
from winkler.numerics.types import Array
from winkler.problems.poroelastic.held import shape_of
from winkler.problems.poroelastic.relaxation_table import GREATEST_POISSON, relaxed_share
from winkler.values.errors import NotConverged
from winkler.values.value import value, words

STARTS = (0.1, 1.0, 10.0)
"""Times of diffusion at which the search begins, relative to the middle of the measured ones."""
NEAR_BOUND = 1e-4


@value
class PoroelasticFit:
    """A poroelastic body fitted to holds.

    Parameters
    ----------
    shear, poisson, diffusivity : float
        G [Pa], nu [-] of the drained network, D [m^2/s].
    covariance : ndarray, (3, 3)
        Of ln G, nu and ln D.
    scatter : float
        Relative scatter of the forces [-].
    freedom : float
        Number of forces less three.
    residuals : ndarray
        Logarithms of measured over fitted forces, one hold after the other [-].
    at_bound : bool
        Whether Poisson's ratio has reached 0 or 0.49; its interval then has no meaning.
    """

    __words__ = words(
        diffusivity=("D", "m^2/s", "effective diffusivity of the liquid in the network"),
        covariance=("", "", "covariance of ln G, nu and ln D"),
        scatter=("", "", "relative scatter of the forces"),
        freedom=("", "", "number of forces less that of the fitted numbers"),
        residuals=("", "", "logarithms of measured over fitted forces"),
        at_bound=("", None, "whether Poisson's ratio has reached an end of its range"),
    )

    shear: float
    poisson: float
    diffusivity: float
    covariance: Array
    scatter: float
    freedom: float
    residuals: Array
    at_bound: bool

    def interval(self, name: str, confidence: float = 0.95) -> tuple[float, float]:
        """Return the interval of "shear", "poisson" or "diffusivity".

        Parameters
        ----------
        name : str
        confidence : float, optional
            Between 0 and 1.
        """
        from scipy.stats import t

        place = ("shear", "poisson", "diffusivity").index(name)
        width = float(t.ppf(0.5 + 0.5 * confidence, self.freedom)) * math.sqrt(float(self.covariance[place, place]))
        middle = float(getattr(self, name))
        if name == "poisson":
            return middle - width, middle + width
        return middle * math.exp(-width), middle * math.exp(width)


def fit_poroelastic(holds: Sequence[HeldForce]) -> PoroelasticFit:
    """Return the poroelastic body that describes one hold or several best.

    Parameters
    ----------
    holds : sequence of HeldForce
        Of one shape of indenter.

    Raises
    ------
    InvalidInput
        If there is none, or their shapes differ.
    NotConverged
        If the iteration does not converge.
    """
    from scipy.optimize import least_squares

    rows = checked_holds("fit_poroelastic", holds, 1)
    shape = shape_of(rows[0].profile)
    # in units of the holds themselves: no digit depends on those of the user
    modulus = max(float(np.max(hold.force)) / hold.unit_force for hold in rows)
    length, duration = rows[0].radius, float(rows[0].time[0])
    measured = np.log(np.concatenate([hold.force / (modulus * hold.unit_force) for hold in rows]))
    times = [(hold.time / duration) / (hold.radius / length) ** 2 for hold in rows]

    def model(numbers: Array) -> Array:
        stiffness, poisson, spread = numbers
        last = 0.5 / (1.0 - poisson)
        parts = [np.log(last + (1.0 - last) * relaxed_share(shape, math.exp(spread) * time, poisson)) for time in times]
        return np.asarray(stiffness + np.concatenate(parts))

    middle = np.median([-np.mean(np.log(time[[0, -1]])) for time in times])
    tried = [
        least_squares(
            lambda numbers: model(numbers) - measured,
            [0.0, 0.25, float(middle) + math.log(share)],
            bounds=([-np.inf, 0.0, -np.inf], [np.inf, GREATEST_POISSON, np.inf]),
            x_scale=[0.1, 0.1, 1.0],
            xtol=1e-12,
            ftol=1e-12,
        )
        for share in STARTS
    ]
    best = min(tried, key=lambda one: float(one.cost))
    if not best.success:
        raise NotConverged(
            "fit_poroelastic: the search does not converge; check that the forces relax, and their times."
        )
    freedom = float(max(measured.size - 3, 1))
    squares = 2.0 * float(best.cost)
    covariance = squares / freedom * np.linalg.pinv(best.jac.T @ best.jac)
    stiffness, poisson, spread = (float(number) for number in best.x)
    bound = min(poisson, GREATEST_POISSON - poisson) < NEAR_BOUND
    return PoroelasticFit(
        modulus * math.exp(stiffness),
        poisson,
        math.exp(spread) * length**2 / duration,
        covariance,
        math.sqrt(squares / freedom),
        freedom,
        -np.asarray(best.fun),
        bound,
    )
