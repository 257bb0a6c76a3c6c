"""The core of a worn contact: the springs that stick, keep their shape, and bear everything in the end."""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import Bed
from winkler.numerics.types import Array
from winkler.values import value

__all__ = ["Core"]


@value
class Core:
    """The springs that bear in the end: those of the bed as deep as it is pressed, up to the stick radius.

    Parameters
    ----------
    bed : Bed
    depth, radius : float
        d [m], c [m].
    """

    bed: Bed
    depth: float
    radius: float

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)`` within the core."""
        return tuple((b, strength) for b, strength in self.bed.kinks if b < self.radius)

    @property
    def edge(self) -> float:
        """u(c-) [m]: the core ends with a jump."""
        return float(self.depth - self.bed.gap(np.array([self.radius]))[0])

    def value(self, x: Array) -> Array:
        """u(x) [m]."""
        return self.depth - self.bed.gap(x)

    def slope(self, x: Array) -> Array:
        """u'(x) [-]."""
        return -self.bed.gap_slope(x)
