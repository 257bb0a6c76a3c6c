"""A force per length over time: what drives a line contact of bodies that relax.

Between two points the force changes in proportion to time.  There is no depth to prescribe: the surface of a half-plane
sinks without bound under a force per length.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

import numpy as np

from winkler.numerics.types import Array
from winkler.values.checks.number_checks import NON_NEGATIVE, NonNegativeQuantity, Numbers, Whole, affordable
from winkler.values.errors import InvalidInput
from winkler.values.limits import PATH_POINTS
from winkler.values.value import value, words


@value
class LineForcePath:
    """Normal force per length of a line contact over time.

    Parameters
    ----------
    time : ndarray, (points,)
        When [s], not negative and never falling; equal times are a sudden step.
    force_per_length : float or ndarray, (points,)
        P [N/m], not negative; one number is constant over the path.
    cycles : int, optional
        Number of repetitions of the path.
    count : int, optional
        Number of equal parts into which each step between two points is divided; a sudden step stays one.

    Raises
    ------
    InvalidInput
        If the lengths differ, or a number is out of range.

    Examples
    --------
    >>> path = LineForcePath([0.0, 1.0, 3.0], [0.0, 100e3, 0.0], count=2)
    >>> path.moments, path.across
    (array([0. , 0.5, 1. , 2. , 3. ]), array([     0.,  50000., 100000.,  50000.,      0.]))
    """

    __words__ = words(
        count=("n", None, "parts into which each step is divided"),
        cycles=("n", None, "how many times the path is repeated"),
        moments=("t", "s", "time of every point"),
        across=("P", "N/m", "normal force per length at every point"),
    )

    time: Annotated[Array, Numbers(NON_NEGATIVE, order="never falling")]
    force_per_length: NonNegativeQuantity
    cycles: Annotated[int, Whole(1, PATH_POINTS, "cycles")] = 1
    count: Annotated[int, Whole(1, PATH_POINTS, "parts")] = 1

    def __post_init__(self) -> None:
        shape, points = np.shape(self.force_per_length), self.time.size
        if shape not in ((), (points,)):
            raise InvalidInput(
                f"LineForcePath: force_per_length has the shape {shape} for {points} points in time; give one number "
                "for each, or one for all."
            )
        affordable("LineForcePath", "points", self.cycles * (1 + (points - 1) * self.count), PATH_POINTS)

    @property
    def moments(self) -> Array:
        """Time of every point [s], including the intermediate points of all cycles."""
        return self._divided[0]

    @property
    def across(self) -> Array:
        """P at every point [N/m], including the intermediate points of all cycles."""
        return self._divided[1]

    @property
    def _divided(self) -> tuple[Array, Array]:
        time = self.time
        force = np.broadcast_to(np.asarray(self.force_per_length, dtype=float), time.shape)
        rows = divided((time, force), np.where(np.diff(time) > 0.0, self.count, 1))
        begins = np.repeat(np.arange(self.cycles) * (time[-1] - time[0]), rows[0].size)
        moments, across = begins + np.tile(rows[0], self.cycles), np.tile(rows[1], self.cycles)
        again = (np.diff(moments) == 0.0) & (np.diff(across) == 0.0)  # where a cycle begins as the last one ended
        kept = np.append(True, ~again)
        return moments[kept], across[kept]


def divided(rows: Sequence[Array], parts: Array) -> list[Array]:
    """Return rows ``(n,)`` with points in between: the steps in so many equal parts ``(n - 1,)``."""
    low = np.repeat(np.arange(parts.size), parts)
    share = (np.arange(low.size) + 1 - np.repeat(np.cumsum(parts) - parts, parts)) / np.repeat(parts, parts)
    found = []
    for row in rows:  # what stays must stay the same number
        between = np.where(share == 1.0, row[low + 1], row[low] + share * (row[low + 1] - row[low]))
        found.append(np.append(row[:1], between))
    return found
