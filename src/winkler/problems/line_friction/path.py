"""A path of a line contact: normal and shear force per length, point after point, and a bulk stress in phase.

The forces change in proportion to each other between two points; how fast does not matter to friction.  Before the
first point the bodies are pressed straight down by its normal force, and then sheared by its shear force.  There is no
displacement to prescribe: the surface of a half-plane moves without bound under a force per length.
"""

from __future__ import annotations

from typing import Annotated

import numpy as np

from winkler.checks.number_checks import Finite, FiniteQuantity, NonNegativeQuantity, Whole, affordable
from winkler.errors import InvalidInput
from winkler.limits import PATH_POINTS
from winkler.numerics.types import Array
from winkler.values import value, words

__all__ = ["LinePath"]


@value
class LinePath:
    """Normal and shear force per length of a line contact, point after point.

    Parameters
    ----------
    force_per_length : float or ndarray, (points,)
        P [N/m], not negative; one number holds all the time.
    shear_force_per_length : float or ndarray, (points,)
        Q [N/m] along x on the first body, against x on the second; one number holds all the time.
    bulk_stress : float, optional
        Stress along x in the first body, far from the contact, when the shear force is at its greatest magnitude and
        positive [Pa], tension positive.  It changes in proportion to the shear force.
    count : int, optional
        Into how many equal parts each step between two points is divided.

    Raises
    ------
    InvalidInput
        If the lengths differ, or there is a bulk stress and no shear force.

    Examples
    --------
    >>> LinePath(100e3, [0.0, 10e3, -10e3], count=2).along
    array([     0.,   5000.,  10000.,      0., -10000.])
    """

    __words__ = words(
        count=("n", None, "parts into which each step is divided"),
        across=("P", "N/m", "normal force per length at every point"),
        along=("Q", "N/m", "shear force per length at every point"),
        bulk_per_shear=("", "1/m", "bulk stress over the shear force per length"),
    )

    force_per_length: NonNegativeQuantity
    shear_force_per_length: FiniteQuantity
    bulk_stress: Finite = 0.0
    count: Annotated[int, Whole(1, PATH_POINTS, "parts")] = 1

    def __post_init__(self) -> None:
        shapes = [np.shape(part) for part in (self.force_per_length, self.shear_force_per_length)]
        lengths = {shape for shape in shapes if shape != ()}
        if len(lengths) > 1 or any(len(shape) != 1 or shape == (0,) for shape in lengths):
            raise InvalidInput(
                f"LinePath: the forces have the shapes {shapes[0]} and {shapes[1]}; give one number for each point, or "
                "one for all."
            )
        points = max((shape[0] for shape in lengths), default=1)
        affordable("LinePath", "points", 1 + (points - 1) * self.count, PATH_POINTS)
        if self.bulk_stress != 0.0 and not np.any(self.shear_force_per_length):
            raise InvalidInput(
                "LinePath: the bulk stress changes in proportion to the shear force, and there is none; give a shear "
                "force, or no bulk stress."
            )

    @property
    def across(self) -> Array:
        """P at every point [N/m], those in between included."""
        return self._divided(0)

    @property
    def along(self) -> Array:
        """Q at every point [N/m], those in between included."""
        return self._divided(1)

    @property
    def bulk_per_shear(self) -> float:
        """Bulk stress over the shear force per length [1/m]."""
        return self.bulk_stress / float(np.max(np.abs(self.shear_force_per_length))) if self.bulk_stress else 0.0

    def _divided(self, which: int) -> Array:
        both = np.atleast_1d(self.force_per_length), np.atleast_1d(self.shear_force_per_length)
        row = np.broadcast_arrays(*both)[which]
        between = np.arange(1 + (row.size - 1) * self.count) / self.count
        low = np.minimum(between.astype(int), max(row.size - 2, 0))
        share, last = between - low, np.minimum(low + 1, row.size - 1)
        # a force that stays must stay the same number
        return np.asarray(np.where(share == 1.0, row[last], row[low] + share * (row[last] - row[low])))
