r"""Springs: a bed sampled at places, for problems in which every spring remembers.

Between 0 and the reach stand n cells; each spring stands for its cell on both sides of the axis.  The load of a cell
that the contact edge cuts counts only up to the edge: the force then converges with the second power of the cell width
without jumping about as the edge moves through a cell; under a cone it is exact.
"""

from __future__ import annotations

import numpy as np

from winkler.errors import InvalidInput, OutsideValidity
from winkler.foundation.bed import Bed
from winkler.numerics.types import Array
from winkler.values import value

__all__ = ["Springs"]


@value
class Springs:
    """Independent springs in a row, symmetric about the axis.

    Parameters
    ----------
    position : ndarray, (n,)
        Places x of the springs [m], ascending, the middles of their cells.
    width : ndarray, (n,)
        Lengths of the cells [m].
    gap : ndarray, (n,)
        g(x) [m] under which they stand.
    normal_stiffness, tangential_stiffness : ndarray, (n,)
        Per length [Pa].
    """

    position: Array
    width: Array
    gap: Array
    normal_stiffness: Array
    tangential_stiffness: Array

    @classmethod
    def of(cls, bed: Bed, reach: float, count: int) -> Springs:
        """Return the springs of a bed in cells of equal width.

        Parameters
        ----------
        bed : Bed
        reach : float
            Up to which x [m]; not beyond what is known of the bed, nor beyond its rim.
        count : int
            How many.

        Raises
        ------
        InvalidInput
            If reach or count are not positive.
        OutsideValidity
            If the bed is not known that far.
        """
        if not (reach > 0.0 and count >= 1):
            raise InvalidInput(f"Springs: reach is {reach!r} m and count {count!r}; both must be positive.")
        if reach > min(bed.reach, bed.rim):
            raise OutsideValidity(
                f"Springs: the reach of {reach:.6g} m is beyond the bed's, {min(bed.reach, bed.rim):.6g} m; give less."
            )
        width = reach / count
        x = (np.arange(count) + 0.5) * width
        return cls(x, np.full(count, width), bed.gap(x), bed.normal_stiffness(x), bed.tangential_stiffness(x))

    def line_load(self, depth: float) -> Array:
        """Load per length of every spring at a depth [N/m], zero where it does not touch."""
        return self.normal_stiffness * np.maximum(depth - self.gap, 0.0)

    def force(self, depth: float) -> float:
        """Normal force at a depth [N], both sides of the axis.

        The edge is where the straight line through the last two springs in contact reaches zero; error of second
        order in the cell width for profiles that are smooth there.
        """
        load = self.line_load(depth)
        touching = np.flatnonzero(load > 0.0)
        if not touching.size:
            return 0.0
        last = int(touching[-1])
        fall = (load[last - 1] - load[last]) / (self.position[last] - self.position[last - 1]) if last else 0.0
        if fall <= 0.0 or last == len(load) - 1 or touching.size != last + 1:
            return 2.0 * float(load @ self.width)
        # whole cells before the last spring in contact, then the triangle from its cell's start to the edge
        top = load[last] + 0.5 * fall * self.width[last]
        return 2.0 * float(load[:last] @ self.width[:last] + 0.5 * top * top / fall)
