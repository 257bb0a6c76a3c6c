r"""A bed whose equivalent plane profile g(x) is given directly, not by way of a body of revolution.

The body that belongs to it is :math:`f(r) = \frac2\pi\int_0^r g(x)\,(r^2-x^2)^{-1/2}\,\mathrm dx` on a homogeneous
half-space: what one would have to turn on a lathe to get these springs.
"""

from __future__ import annotations

import numpy as np

from winkler.errors import InvalidInput
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics import abel
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile
from winkler.validity import Note
from winkler.values import value

__all__ = ["PlaneFoundation"]


@value
class PlaneFoundation:
    """Springs under a given plane profile.

    Parameters
    ----------
    plane_profile : Profile
        Its height, read as a function of x, is g(x).
    medium : HalfSpace or TransverselyIsotropicHalfSpace
        A homogeneous medium, so that the springs have the constant stiffness E* per length.

    Raises
    ------
    InvalidInput
        If the medium is not homogeneous.
    """

    plane_profile: Profile
    medium: HomogeneousMedium

    def __post_init__(self) -> None:
        if not isinstance(self.medium, HomogeneousMedium):
            raise InvalidInput(
                f"PlaneFoundation: the medium is a {type(self.medium).__name__}; a plane profile can be given directly "
                "only on a homogeneous half-space: give HalfSpace or TransverselyIsotropicHalfSpace."
            )

    @property
    def reach(self) -> float:
        """Up to which x the bed is known [m]."""
        return self.plane_profile.reach

    @property
    def rim(self) -> float:
        """Where the contact is pinned [m]."""
        return self.plane_profile.rim

    @property
    def size(self) -> float:
        """Radius of the body [m]."""
        return self.plane_profile.size

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Where g is not smooth; its slope jumps there but stays finite."""
        return tuple((b, 0.0) for b, _ in self.plane_profile.kinks)

    @property
    def rising(self) -> bool:
        """Unknown; the solver looks for itself."""
        return False

    @property
    def notes(self) -> tuple[Note, ...]:
        """What must be said about shape and medium."""
        return (*self.medium.notes, *self.plane_profile.notes)

    def height(self, r: Array) -> Array:
        """f(r) [m], by the inverse transform T2."""
        return abel.surface(self.gap, [b for b, _ in self.kinks], r)

    def slope(self, r: Array) -> Array:
        """f'(r) [-], by T2 applied to x g'(x) / r."""
        r = np.asarray(r, dtype=float)
        moment = abel.surface(lambda x: x * self.gap_slope(x), [b for b, _ in self.kinks], r)
        at_axis = 2.0 / np.pi * float(self.gap_slope(np.zeros(1))[0])
        return np.where(r > 0.0, moment / np.where(r > 0.0, r, 1.0), at_axis)

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        return self.plane_profile.height(x)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        return self.plane_profile.slope(x)

    def gap_load(self, radius: Array) -> Array:
        """2 E* times the integral of g from 0 to `radius` [N]."""
        return 2.0 * self.medium.modulus * abel.integral(self.gap, [b for b, _ in self.kinks], radius)

    def stiffness(self, radius: Array) -> Array:
        """k(a) = 2 E* a [N/m]."""
        return self.medium.punch_stiffness(radius)

    def normal_stiffness(self, x: Array) -> Array:
        """c_N = E* [Pa]."""
        return self.medium.normal_stiffness(x)

    def tangential_stiffness(self, x: Array) -> Array:
        """c_T = G* [Pa]."""
        return self.medium.tangential_stiffness(x)
