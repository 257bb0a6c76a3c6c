r"""First yield of many indentations: shear stress below a ball at the pop-in, its distribution and its mean.

Before the first pop-in the contact is elastic, and the greatest shear stress below a ball of radius R is

.. math:: \tau = 0.31\left(\frac{6FE^{*2}}{\pi^3R^2}\right)^{1/3} .

The forces of n pop-ins have the distribution :math:`P = 1 - \exp(-(\tau/\tau_0)^k)` (Weibull).  Under thermal
activation
(Schuh) the volume v in :math:`\ln(-\ln(1-P)) \approx \tau v/(k_BT) + const` follows from the slope over the stress.

References
----------
K. L. Johnson, Contact Mechanics (1985), doi:10.1017/CBO9781139171731
C. A. Schuh, A. C. Lund, J. Mater. Res. 19 (2004) 2152-2158, doi:10.1557/JMR.2004.0276
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from winkler.numerics.types import Array
from winkler.values.checks.number_checks import POSITIVE, checked
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

BOLTZMANN = 1.380649e-23
FEWEST = 3


def first_yield_stress(force: float, modulus: float, tip_radius: float) -> float:
    """Return the maximum shear stress [Pa] below a ball, 0.31 times the maximum pressure of Hertz (nu = 0.3).

    Parameters
    ----------
    force : float
        At the pop-in [N].
    modulus : float
        Reduced modulus [Pa].
    tip_radius : float
        R [m].

    Examples
    --------
    >>> round(first_yield_stress(1e-4, 200e9, 200e-9) / 1e9, 2)
    8.32
    """
    for name, number, unit in (("force", force, "N"), ("modulus", modulus, "Pa"), ("tip_radius", tip_radius, "m")):
        checked(POSITIVE, "first_yield_stress", name, number, unit)
    return float(0.31 * (6.0 * force * modulus**2 / (math.pi**3 * tip_radius**2)) ** (1.0 / 3.0))


@value
class PopInStatistics:
    """First yield (pop-in) of n indentations, sorted by force.

    Parameters
    ----------
    force, stress, probability : ndarray, (n,)
        Forces [N], shear stresses [Pa], and cumulative probabilities (i - 1/2)/n.
    mean_stress, mean_error : float
        Mean stress and its standard uncertainty, that of the tip radius included [Pa].
    scale, shape : float
        Weibull's stress tau_0 [Pa] and exponent k [-], of maximum likelihood.
    shape_error : float
        Standard error of k [-].
    activation_volume : float
        v [m^3] under thermal activation.
    """

    __words__ = words(
        force=("F", "N", "forces at the first pop-ins"),
        stress=(r"\tau", "Pa", "greatest shear stress at the pop-ins"),
        probability=("P", "", "cumulative probability"),
        mean_stress=(r"\bar\tau", "Pa", "mean shear stress of first yield"),
        mean_error=(r"u(\bar\tau)", "Pa", "standard uncertainty of the mean stress"),
        scale=(r"\tau_0", "Pa", "Weibull's stress"),
        shape=("k", "", "Weibull's exponent"),
        shape_error=("u(k)", "", "standard error of Weibull's exponent"),
        activation_volume=("v", "m^3", "activation volume of first yield"),
    )

    force: Array
    stress: Array
    probability: Array
    mean_stress: float
    mean_error: float
    scale: float
    shape: float
    shape_error: float
    activation_volume: float

    def interval(self, confidence: float = 0.95) -> tuple[float, float]:
        """Return the interval of the mean stress [Pa] by Student's t."""
        from scipy.special import stdtrit

        width = float(stdtrit(self.force.size - 1, 0.5 + 0.5 * confidence)) * self.mean_error
        return self.mean_stress - width, self.mean_stress + width


def pop_in_statistics(
    forces: Sequence[float] | Array,
    modulus: float,
    tip_radius: float,
    *,
    tip_radius_error: float = 0.0,
    temperature: float = 295.0,
) -> PopInStatistics:
    """Return the statistics of first yield.

    Parameters
    ----------
    forces : sequence of float
        Force of the first pop-in of each indentation [N].
    modulus : float
        Reduced modulus [Pa].
    tip_radius, tip_radius_error : float
        Radius of the tip and its standard uncertainty [m].
    temperature : float, optional
        T [K]; 295 by default.

    Raises
    ------
    InvalidInput
        If there are fewer than three forces, or one is not positive.
    """
    force = np.sort(np.asarray(forces, dtype=float))
    if force.ndim != 1 or force.size < FEWEST or not np.all(np.isfinite(force)) or not force[0] > 0.0:
        raise InvalidInput(f"pop_in_statistics: give at least {FEWEST} positive forces [N], one for each indentation.")
    checked(POSITIVE, "pop_in_statistics", "temperature", temperature, "K")
    stress = np.array([first_yield_stress(one, modulus, tip_radius) for one in force.tolist()])
    probability = (np.arange(force.size) + 0.5) / force.size
    mean = float(stress.mean())
    error = math.hypot(
        float(stress.std(ddof=1)) / math.sqrt(force.size), 2.0 / 3.0 * mean * tip_radius_error / tip_radius
    )
    scale, shape = _weibull(stress)
    slope = float(np.polyfit(stress, np.log(-np.log1p(-probability)), 1)[0]) if np.ptp(stress) > 0.0 else math.inf
    return PopInStatistics(
        force, stress, probability, mean, error, scale, shape, shape * math.sqrt(6.0) / math.pi / math.sqrt(force.size),
        slope * BOLTZMANN * temperature,
    )  # fmt: skip


def _weibull(stress: Array) -> tuple[float, float]:
    """Return scale and exponent of greatest likelihood."""
    from scipy.optimize import brentq

    logarithms = np.log(stress / stress.max())

    def slope(shape: float) -> float:
        weights = np.exp(shape * logarithms)
        return float(weights @ logarithms / weights.sum() - 1.0 / shape - logarithms.mean())

    if not np.ptp(stress) > 1e-12 * stress.max():
        return float(stress.max()), math.inf
    high = 10.0
    while slope(high) < 0.0 and high < 1e9:
        high *= 2.0
    shape = float(brentq(slope, 1e-3, high))
    return float(stress.max() * np.mean(np.exp(shape * logarithms)) ** (1.0 / shape)), shape
