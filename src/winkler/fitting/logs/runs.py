r"""Bounces by their times, and friction and height loss of a pin on a disc over the distance.

Bounces with a constant coefficient of restitution :math:`e` follow each other at

.. math:: t_n = t_0 + T\,\frac{1-e^n}{1-e} ,

fitted by least squares to all times, for errors of the clock that are independent.  Of a pin, the second half of the
distance is evaluated, after running-in.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.fitting.logs.estimated import Estimate, last_of_line, mean_of
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

FEWEST_BOUNCES, FEWEST_ROWS = 5, 20


@value
class BounceTimes:
    """Impact times of a dropped body that bounces."""

    __words__ = words(bounce=("t_n", "s", "time of the bounce"))

    bounce: Array

    def __post_init__(self) -> None:
        flights = np.diff(self.bounce)
        if self.bounce.size < FEWEST_BOUNCES or np.any(flights <= 0.0):
            raise InvalidInput(
                f"BounceTimes: give at least {FEWEST_BOUNCES} times of bounces, each later than the last."
            )

    @property
    def restitution(self) -> Estimate:
        """Coefficient of restitution e [-], speed after a bounce over that before it."""
        from scipy.optimize import least_squares

        count, span = np.arange(self.bounce.size), float(np.ptp(self.bounce))
        times = (self.bounce - self.bounce[0]) / span
        flights = np.diff(times)
        start = math.exp(float(np.polyfit(count[:-1], np.log(flights), 1)[0]))

        def left(numbers: Array) -> Array:
            powers = np.concatenate([[0.0], np.cumsum(numbers[2] ** count[:-1])])
            return np.asarray(numbers[0] + numbers[1] * powers - times)

        found = least_squares(left, [0.0, flights[0], min(start, 1.0)], x_scale=[1.0, flights[0], 1.0], xtol=1e-14)
        freedom = self.bounce.size - 3
        variance = np.linalg.inv(found.jac.T @ found.jac) * 2.0 * found.cost / freedom
        return Estimate(float(found.x[2]), math.sqrt(float(variance[2, 2])), freedom)


@value
class PinOnDisc:
    """Friction and height loss of a pin over the sliding distance; missing quantities are empty."""

    __words__ = words(
        distance=("s", "m", "distance of sliding"),
        friction=(r"\mu", "", "coefficient of friction"),
        height_loss=("h", "m", "height that was worn away"),
    )

    distance: Array
    friction: Array
    height_loss: Array

    def __post_init__(self) -> None:
        if self.distance.size < FEWEST_ROWS or np.any(np.diff(self.distance) < 0.0) or not np.ptp(self.distance) > 0.0:
            raise InvalidInput(f"PinOnDisc: give at least {FEWEST_ROWS} rows with a distance that grows.")

    @property
    def _late(self) -> Array:
        return np.asarray(self.distance >= 0.5 * (self.distance[0] + self.distance[-1]))

    @property
    def steady_friction(self) -> Estimate:
        """Mean coefficient of friction over the second half of the distance [-]."""
        return mean_of(self.friction[self._late])

    @property
    def wear_per_distance(self) -> Estimate:
        """Slope of the height loss over the second half of the distance [m/m]."""
        place, loss = self.distance[self._late], self.height_loss[self._late]
        return last_of_line(np.stack([np.ones(place.size), place - place.mean()], axis=1), loss)

    def wear_coefficient(self, area: float, force: float) -> Estimate:
        """Return the wear coefficient over the hardness [1/Pa] for `Archard`, from the second half.

        Parameters
        ----------
        area : float
            Area of the face of the pin [m^2], which does not change during wear.
        force : float
            Normal force on the pin [N].

        Raises
        ------
        InvalidInput
            If one of them is not positive, or the log holds no height loss.
        """
        for name, number in (("area", area), ("force", force)):
            if not (number > 0.0 and math.isfinite(number)):
                raise InvalidInput(f"PinOnDisc: {name} is {number!r}; give a positive number.")
        if not self.height_loss.size:
            raise InvalidInput("PinOnDisc: the log holds no height loss; add a column such as 'wear depth [um]'.")
        rate, share = self.wear_per_distance, area / force
        return Estimate(share * rate.value, share * rate.error, rate.freedom)
