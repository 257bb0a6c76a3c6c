r"""Logs of tests: bounces by their times, and friction and height loss of a pin on a disc over the distance.

Bounces with a constant coefficient of restitution :math:`e` follow each other at

.. math:: t_n = t_0 + T\,\frac{1-e^n}{1-e} ,

fitted by least squares to all times, for errors of the clock that are independent.  Of a pin, the second half of the
distance is evaluated, after running-in; errors allow for slow noise by the correlation :math:`r` of neighbours, whose
mean has the variance of :math:`n(1-r)/(1+r)` independent ones.
"""

from __future__ import annotations

import math
import os
from typing import NamedTuple

import numpy as np

from winkler.errors import InvalidInput
from winkler.io.tables.column import Column
from winkler.io.tables.header import names_columns
from winkler.io.tables.table import read_table
from winkler.numerics.types import Array
from winkler.readable import with_unit
from winkler.values import value, words

__all__ = [
    "BOUNCE",
    "DISTANCE",
    "FRICTION",
    "LOSS",
    "BounceTimes",
    "Estimate",
    "PinOnDisc",
    "log_lines",
    "read_bounces",
    "read_pin",
]

BOUNCE = Column("time of a bounce", ("bounce", "bounces", "bounce time", "impact time", "bounce_time"), "s")
DISTANCE = Column("distance", ("distance", "sliding distance", "path", "gleitweg"), "m")
FRICTION = Column("coefficient of friction", ("cof", "mu", "friction coefficient", "coefficient of friction"), "")
LOSS = Column("height loss", ("height loss", "wear depth", "wear", "linear wear", "verschleiss"), "m", "um")
FEWEST_BOUNCES, FEWEST_ROWS = 5, 20


class Estimate(NamedTuple):
    """A number with its standard error, and how many independent rows it has beyond the fitted numbers."""

    value: float
    error: float
    freedom: float


@value
class BounceTimes:
    """Times at which a body that was dropped touches the ground."""

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
    """Friction and height loss of a pin over the distance that it slid; what was not measured is empty."""

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
        late = self.friction[self._late]
        return _last(np.ones((late.size, 1)), late)

    @property
    def wear_per_distance(self) -> Estimate:
        """Slope of the height loss over the second half of the distance [m/m]."""
        place, loss = self.distance[self._late], self.height_loss[self._late]
        return _last(np.stack([np.ones(place.size), place - place.mean()], axis=1), loss)


def _last(rows: Array, samples: Array) -> Estimate:
    """Return the last number of a linear fit with its error, which allows for noise that is correlated in order."""
    numbers, *_ = np.linalg.lstsq(rows, samples, rcond=None)
    rest = samples - rows @ numbers
    freedom = samples.size - rows.shape[1]
    square = float(rest @ rest)
    correlation = float(rest[:-1] @ rest[1:]) / square if square > 0.0 else 0.0
    held = min(max(correlation + 1.0 / samples.size, 0.0), 0.99)  # that of few samples is too small by about 1/n
    factor = (1.0 + held) / (1.0 - held)
    variance = float(np.linalg.inv(rows.T @ rows)[-1, -1]) * square / freedom * factor
    return Estimate(float(numbers[-1]), math.sqrt(variance), max(freedom / factor, 1.0))


def read_bounces(path: str | os.PathLike[str]) -> BounceTimes:
    """Read times of bounces from a table with a column bounce, bounce time or impact time.

    Raises
    ------
    InvalidInput
        If the file cannot be read, or there are fewer than five times.
    """
    return BounceTimes(read_table(path, (BOUNCE,)).values[:, 0])


def read_pin(path: str | os.PathLike[str]) -> PinOnDisc:
    """Read a log with a distance and a coefficient of friction (cof, mu), a height loss (wear depth), or both.

    Raises
    ------
    InvalidInput
        If the file cannot be read, or holds no such log.
    """
    measured = [column for column in (FRICTION, LOSS) if names_columns(path, (DISTANCE, column))]
    table = read_table(path, (DISTANCE, *measured))
    found = {column.word: table.values[:, 1 + place] for place, column in enumerate(measured)}
    nothing = np.zeros(0)
    return PinOnDisc(table.values[:, 0], found.get(FRICTION.word, nothing), found.get(LOSS.word, nothing))


def log_lines(content: object) -> tuple[str, ...]:
    """Return what a log says, one line each: numbers with standard errors."""
    if isinstance(content, BounceTimes):
        return (f"coefficient of restitution {_text(content.restitution)}, if it is the same in all bounces",)
    if not isinstance(content, PinOnDisc):
        return ()
    lines = []
    if content.friction.size:
        lines.append(f"coefficient of friction {_text(content.steady_friction)} over the second half")
    if content.height_loss.size:
        rate = content.wear_per_distance
        per_km = with_unit(1e3 * rate.value, "m", 4), with_unit(1e3 * rate.error, "m", 2)
        lines.append(f"height loss {per_km[0]} ± {per_km[1]} per kilometre over the second half")
    return tuple(lines)


def _text(number: Estimate) -> str:
    return f"{number.value:.4g} ± {number.error:.2g}"
