"""Continuously measured stiffness: depth, force and stiffness of a small oscillation during one loading."""

from __future__ import annotations

import dataclasses
import math
from typing import Annotated

import numpy as np

from winkler.numerics.types import Array
from winkler.values.checks.number_checks import POSITIVE_OR_INFINITE, Advice, Numbers
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

POINTS_ADVICE = Advice("give the points as they were taken, and leave out those without numbers")
FEWEST = 2


def _empty() -> Array:
    return np.zeros(0)


@value
class ContinuousStiffness:
    """Depth, force and stiffness of one indentation under a small oscillation, in the order of measurement.

    Parameters
    ----------
    depth : ndarray, (n,)
        Depth from first touch [m].
    force : ndarray, (n,)
        Mean force [N], compression positive.
    stiffness : ndarray, (n,)
        In-phase stiffness of the oscillation [N/m].
    time : ndarray, (n,) or (0,), optional
        [s], never falling; empty (by default) where it is unknown.
    machine_stiffness : float, optional
        Stiffness of the frame still contained in depth and stiffness [N/m]. Infinite by default, because most
        instruments have subtracted it.
    name : str, optional
        Origin of the data.

    Raises
    ------
    InvalidInput
        If lengths differ, a number is not finite, time runs backwards, or there are fewer than two points.

    References
    ----------
    X. Li, B. Bhushan, Mater. Charact. 48 (2002) 11-36, doi:10.1016/S1044-5803(02)00192-4

    Examples
    --------
    >>> ContinuousStiffness([50e-9, 100e-9], [1e-4, 4e-4], [2e4, 4e4]).count
    2
    """

    __words__ = words(
        depth=("h", "m", "depth from first touch"),
        stiffness=("S", "N/m", "in-phase stiffness of the oscillation"),
        name=("", None, "where the data come from"),
    )

    depth: Annotated[Array, Numbers(fewest=FEWEST), POINTS_ADVICE]
    force: Annotated[Array, Numbers(fewest=FEWEST), POINTS_ADVICE]
    stiffness: Annotated[Array, Numbers(fewest=FEWEST), POINTS_ADVICE]
    time: Annotated[Array, Numbers(fewest=0, order="never falling"), POINTS_ADVICE] = dataclasses.field(
        default_factory=_empty
    )
    machine_stiffness: Annotated[float, POSITIVE_OR_INFINITE] = math.inf
    name: str = ""

    def __post_init__(self) -> None:
        for word in ("force", "stiffness", "time"):
            count = getattr(self, word).size
            if count != self.depth.size and not (word == "time" and count == 0):
                raise InvalidInput(
                    f"ContinuousStiffness: depth has {self.depth.size} points, {word} has {count}; give one for each."
                )
        object.__setattr__(self, "machine_stiffness", float(self.machine_stiffness))

    @property
    def count(self) -> int:
        """Number of points."""
        return int(self.depth.size)

    @property
    def timed(self) -> bool:
        """Whether the times are known."""
        return bool(self.time.size)
