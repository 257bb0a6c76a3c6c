"""A path of a line contact: normal and shear force per length, point after point, and a bulk stress.

All of them change in proportion to each other between two points; how fast does not matter to friction.  Before the
first point the bodies are pressed straight down by its normal force, and then sheared by its shear force and strained
by its bulk stress, in proportion to each other.  There is no
displacement to prescribe: the surface of a half-plane moves without bound under a force per length.
"""

from __future__ import annotations

from typing import Annotated

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.line_viscoelastic.path import divided
from winkler.values.checks.number_checks import FiniteQuantity, NonNegativeQuantity, Whole, affordable
from winkler.values.errors import InvalidInput
from winkler.values.limits import PATH_POINTS
from winkler.values.value import value, words

ROUNDING = 1e-12
"""Part of the greatest bulk stress by which one in phase may differ."""


@value
class LinePath:
    """Normal and shear force per length of a line contact, point after point.

    Parameters
    ----------
    force_per_length : float or ndarray, (points,)
        P [N/m], not negative; one number is constant over the path.
    shear_force_per_length : float or ndarray, (points,)
        Q [N/m] along x on the first body, against x on the second; one number is constant over the path.
    bulk_stress : float or ndarray, (points,), optional
        Stress along x in the first body, far from the contact [Pa], tension positive.  One number is the bulk stress at
        the maximum positive shear force, to which the stress is proportional. An array gives the stress at every point.
    count : int, optional
        Number of equal parts into which each step between two points is divided.
    time : float or ndarray, (points,), optional
        Times of the points [s], never decreasing, for viscoelastic bodies; equal times define a sudden step.

    Raises
    ------
    InvalidInput
        If the lengths differ, the time falls, or one number is given for the bulk stress and there is no shear force.

    Examples
    --------
    >>> LinePath(100e3, [0.0, 10e3, -10e3], count=2).along
    array([     0.,   5000.,  10000.,      0., -10000.])
    >>> LinePath(100e3, 0.0, bulk_stress=[0.0, 50e6, -50e6]).bulk
    array([       0.,  50000000., -50000000.])
    """

    __words__ = words(
        count=("n", None, "parts into which each step is divided"),
        time=("t", "s", "when the points are reached"),
        moments=("t", "s", "time of every point"),
        across=("P", "N/m", "normal force per length at every point"),
        along=("Q", "N/m", "shear force per length at every point"),
        bulk=("", "Pa", "bulk stress in the first body at every point"),
        in_phase=("", None, "whether the bulk stress is proportional to the shear force"),
        bulk_per_shear=("", "1/m", "bulk stress over the shear force per length, where they are in phase"),
    )

    force_per_length: NonNegativeQuantity
    shear_force_per_length: FiniteQuantity
    bulk_stress: FiniteQuantity = 0.0
    count: Annotated[int, Whole(1, PATH_POINTS, "parts")] = 1
    time: NonNegativeQuantity = 0.0

    def __post_init__(self) -> None:
        rows = (self.force_per_length, self.shear_force_per_length, self.bulk_stress, self.time)
        shapes = [np.shape(row) for row in rows]
        lengths = {shape for shape in shapes if shape != ()}
        if len(lengths) > 1 or any(len(shape) != 1 or shape == (0,) for shape in lengths):
            named = zip(("bulk stress", "time"), shapes[2:], strict=True)
            beside = "".join(f", and the {name} {shape}" for name, shape in named if shape != ())
            raise InvalidInput(
                f"LinePath: the forces have the shapes {shapes[0]} and {shapes[1]}{beside}; give one number for each "
                "point, or one for all."
            )
        if np.any(np.diff(self.time) < 0.0 if np.ndim(self.time) else False):
            raise InvalidInput("LinePath: the time falls from one point to the next; give times that never fall.")
        points = max((shape[0] for shape in lengths), default=1)
        affordable("LinePath", "points", 1 + (points - 1) * self.count, PATH_POINTS)
        if shapes[2] == () and self.bulk_stress != 0.0 and not np.any(self.shear_force_per_length):
            raise InvalidInput(
                "LinePath: one number for the bulk stress changes in proportion to the shear force, and there is none; "
                "give a shear force, no bulk stress, or one bulk stress for each point."
            )

    @property
    def across(self) -> Array:
        """P at every point [N/m], including the intermediate points."""
        return self._divided(0)

    @property
    def along(self) -> Array:
        """Q at every point [N/m], including the intermediate points."""
        return self._divided(1)

    @property
    def bulk(self) -> Array:
        """Bulk stress in the first body at every point [Pa], including the intermediate points."""
        return self._divided(2) if np.ndim(self.bulk_stress) else self.bulk_per_shear * self.along

    @property
    def moments(self) -> Array:
        """Time of every point [s], including the intermediate points."""
        return self._divided(3)

    @property
    def bulk_per_shear(self) -> float:
        """Bulk stress over the shear force per length [1/m], where they are in phase."""
        if not np.any(self.bulk_stress) or not np.any(self.shear_force_per_length):
            return 0.0
        if np.ndim(self.bulk_stress) == 0:
            return float(self.bulk_stress) / float(np.max(np.abs(self.shear_force_per_length)))
        shear, bulk = np.broadcast_arrays(np.atleast_1d(self.shear_force_per_length), self.bulk_stress)
        greatest = int(np.argmax(np.abs(shear)))
        return float(bulk[greatest] / shear[greatest])

    @property
    def in_phase(self) -> bool:
        """Whether the bulk stress is proportional to the shear force."""
        bulk = self.bulk
        return bool(np.all(np.abs(bulk - self.bulk_per_shear * self.along) <= ROUNDING * np.max(np.abs(bulk))))

    def _divided(self, which: int) -> Array:
        bulk = self.bulk_stress if np.ndim(self.bulk_stress) else 0.0
        given = self.force_per_length, self.shear_force_per_length, bulk, self.time
        rows = (np.atleast_1d(row) for row in given)
        row = np.broadcast_arrays(*rows)[which]
        return divided((row,), np.full(row.size - 1, self.count))[0]
