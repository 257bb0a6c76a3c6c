r"""A bed whose equivalent plane profile g(x) is given directly, not by a body of revolution.

The body that belongs to it is what one would have to turn on a lathe to get these springs: on a homogeneous half-space
:math:`f(r) = \frac2\pi\int_0^r g(x)\,(r^2-x^2)^{-1/2}\,\mathrm dx`, in every medium the surface that springs displaced
by g itself would give (`winkler.media.body_of`).
"""

from __future__ import annotations

import math

import numpy as np

from winkler.foundation.on_medium import OfShape
from winkler.media import body_of
from winkler.media.body_of import Imprint
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.medium import Medium
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile
from winkler.values.value import value

INFINITE_LENGTH = 1e30
"""Instead of a length without end [m]."""


@value
class PlaneFoundation(OfShape):
    """Springs under a given plane profile.

    Parameters
    ----------
    plane_profile : Profile
        A profile whose height as a function of x is g(x).
    medium : Medium
        Any medium; body and separation are computed for homogeneous, graded or layered half-spaces.

    Raises
    ------
    InvalidInput
        If the argument is not a medium.
    """

    plane_profile: Profile
    medium: Medium

    @property
    def _shape(self) -> Profile:
        return self.plane_profile

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Where g is not smooth; its slope jumps there but stays finite."""
        return tuple((b, 0.0) for b, _ in self.plane_profile.kinks)

    rising = False
    """Unknown; the solver computes it."""

    certain = False
    """Unknown; the solver computes it."""

    def height(self, r: Array) -> Array:
        """f(r) [m] of the body that has these springs."""
        r = np.asarray(r, dtype=float)
        if isinstance(self.medium, HomogeneousMedium):
            return abel.surface(self.gap, [b for b, _ in self.kinks], r)
        return body_of.height(self.medium, self._imprint(r), r)

    def slope(self, r: Array) -> Array:
        """f'(r) [-] of that body; on a homogeneous half-space by T2 applied to x g'(x) / r."""
        r = np.asarray(r, dtype=float)
        if not isinstance(self.medium, HomogeneousMedium):
            return body_of.slope(self.medium, self._imprint(r), r)
        moment = abel.surface(lambda x: x * self.gap_slope(x), [b for b, _ in self.kinks], r)
        at_axis = 2.0 / np.pi * float(self.gap_slope(np.zeros(1))[0])
        return np.where(r > 0.0, moment / np.where(r > 0.0, r, 1.0), at_axis)

    def _imprint(self, r: Array) -> Imprint:
        """Return the springs displaced by g up to the next power of two, so that its tables serve more than once."""
        farthest = float(np.max(r, initial=0.0)) or min(self.reach, body_of.thickness_of(self.medium), INFINITE_LENGTH)
        return Imprint(self, min(2.0 ** math.ceil(math.log2(farthest)), max(self.reach, farthest)))

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        return self.plane_profile.height(x)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        return self.plane_profile.slope(x)

    def gap_load(self, radius: Array) -> Array:
        """The integral of k'(x) g(x) from 0 to `radius` [N]; by parts where k' is not constant."""
        edges = [b for b, _ in self.kinks]
        if isinstance(self.medium, HomogeneousMedium):
            return 2.0 * self.medium.modulus * abel.integral(self.gap, edges, radius)
        radius = np.asarray(radius, dtype=float)
        moved = abel.integral(lambda x: self.stiffness(x) * self.gap_slope(x), edges, radius)
        return np.asarray(self.stiffness(radius) * self.gap(radius) - moved)
