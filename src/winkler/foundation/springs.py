r"""Springs: a bed as a row of separate springs, for problems in which every spring has a history.

Springs stand at places :math:`x_i`, under the gaps :math:`g_i`; together, pressed to a depth d, they bear

.. math:: F(d) = \sum_i k_i\,(d-g_i)_+ ,

a polygon with a corner wherever a spring comes into contact.  The stiffnesses :math:`k_i` are chosen so that the
corners lie on the true force curve of the bed: they are the second differences of F over g.  So the force is exact when
the last spring just touches, and of second order in the distance of the springs in between, under any profile, with a
flat end (one spring stands for all of it), in any medium.

Any sum over the springs, :math:`\sum k_i\,w(g_i)`, is then the integral of w over the bed with w taken as straight
between the springs.  Where a displacement has a corner, at the edge of the contact or of a zone that sticks, the error
is of second order too, and friction laws hold to the last digit.
"""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import Bed
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.value import value


@value
class Springs:
    """Independent springs along a line; each represents both sides of the axis.

    Parameters
    ----------
    position : ndarray, (n,)
        Places x of the springs [m], ascending.
    gap : ndarray, (n,)
        Gap g(x) above each spring [m], ascending.
    stiffness : ndarray, (n,)
        Normal stiffness of every spring [N/m].
    mindlin_ratio : ndarray, (n,)
        Tangential over normal stiffness of every spring [-].

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1.0), HalfSpace.between(Elastic(1.0, 0.0)))
    >>> springs = Springs.of(bed, 0.5, 100)
    >>> round(springs.force(0.25), 12)  # 4/3 E* a^3
    0.166666666667
    """

    position: Array
    gap: Array
    stiffness: Array
    mindlin_ratio: Array

    @classmethod
    def of(cls, bed: Bed, reach: float, count: int) -> Springs:
        """Return the springs of a bed at equal distances, the last one at `reach`.

        Parameters
        ----------
        bed : Bed
        reach : float
            Maximum x [m], within the known range of the foundation and its rim.  The best value is the radius of the
            widest contact.
        count : int
            Number of springs, at least two. Of the springs under a flat end only the outermost is kept.

        Raises
        ------
        InvalidInput
            If reach is not positive or there are less than two.
        OutsideValidity
            If the foundation is not defined up to `reach`, or g decreases.
        """
        if not (reach > 0.0 and count >= 2):
            raise InvalidInput(
                f"Springs: reach is {reach!r} m and count {count!r}; give a positive reach and 2 springs or more."
            )
        if reach > min(bed.reach, bed.rim):
            raise OutsideValidity(
                f"Springs: the reach of {reach:.6g} m is beyond the bed's, {min(bed.reach, bed.rim):.6g} m; give less."
            )
        start = _flat_end(bed, reach)
        x = np.linspace(start, reach, count)
        gap = bed.gap(x)
        gap[0] = max(gap[0], 0.0)
        if np.any(np.diff(gap) < 0.0):
            raise OutsideValidity(
                "Springs: g decreases somewhere below the reach, so the contact is not a growing disc; give "
                "a smaller reach."
            )
        distinct = np.append(gap[1:] > gap[:-1], True)
        x, gap = x[distinct], gap[distinct]
        stiffness = bed.stiffness(x)
        force = stiffness * gap - bed.gap_load(x)
        chords = np.concatenate([[0.0], np.diff(force) / np.diff(gap), stiffness[-1:]])
        place = _off_axis(x)
        ratio = bed.tangential_stiffness(place) / bed.normal_stiffness(place)
        return cls(x, gap, np.diff(chords), ratio)

    @property
    def tangential_stiffness(self) -> Array:
        """Tangential stiffness of every spring [N/m]."""
        return self.stiffness * self.mindlin_ratio

    def density(self, bed: Bed) -> Array:
        """c_N [Pa] of the bed at every spring."""
        return bed.normal_stiffness(_off_axis(self.position))

    def force(self, depth: float) -> float:
        """Normal force at a depth [N].

        The error is of second order in the spring distance, and zero when a spring just touches. Contacts beyond the
        last spring require a rim there.
        """
        return float(self.stiffness @ np.maximum(depth - self.gap, 0.0))

    def depth(self, force: Array) -> Array:
        """Depth [m] of the springs under given normal forces (m,) [N], not negative."""
        slopes = np.cumsum(self.stiffness)
        corners = np.concatenate([[0.0], np.cumsum(slopes[:-1] * np.diff(self.gap))])
        beyond = np.maximum(force - corners[-1], 0.0) / slopes[-1]
        return np.asarray(np.interp(force, corners, self.gap) + beyond)


def _flat_end(bed: Bed, reach: float) -> float:
    """Return the radius up to which g vanishes."""
    ends = [0.0, *(b for b, _ in bed.kinks if b < reach), reach]
    return max(end for end in ends if end == 0.0 or float(bed.gap(np.array([end]))[0]) == 0.0)


def _off_axis(x: Array) -> Array:
    """Return the places at which stiffnesses are evaluated; at the axis itself they may vanish or diverge."""
    return np.where(x > 0.0, x, 0.5 * x[min(1, x.size - 1)])
