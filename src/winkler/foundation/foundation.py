r"""The foundation: a body of revolution over a medium, seen as a line of independent springs.

The springs at :math:`\pm x` have the stiffness :math:`c_N(x) = k'(x)/2` per length and stand under the equivalent
plane profile g(x); with :math:`g(a) = d`

.. math:: F = \int_0^a k'(x)\,(d - g(x))\,\mathrm dx = k(a)\,d - \int_0^a k'(x)\,g(x)\,\mathrm dx .
"""

from __future__ import annotations

from winkler.foundation.on_medium import OnMedium
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.medium import Medium
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile
from winkler.validity import Note
from winkler.values import value

__all__ = ["Foundation"]


@value
class Foundation(OnMedium):
    """The springs that stand for a profile pressed into a medium.

    Parameters
    ----------
    profile : Profile
        The gap f(r) between the undeformed bodies.
    medium : Medium
        The pair of half-spaces.

    References
    ----------
    V. L. Popov, M. Hess, Method of Dimensionality Reduction in Contact Mechanics and Friction, Springer 2015,
    doi:10.1007/978-3-642-53876-6
    """

    profile: Profile
    medium: Medium

    @property
    def reach(self) -> float:
        """Up to which x the bed is known [m]."""
        return self.profile.reach

    @property
    def rim(self) -> float:
        """Where the contact is pinned [m]."""
        return self.profile.rim

    @property
    def size(self) -> float:
        """Radius of the body [m]."""
        return self.profile.size

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)`` where g is not smooth, as the medium says."""
        return self.medium.kinks(self.profile)

    @property
    def rising(self) -> bool:
        """Whether the body, on a homogeneous half-space, is known to have a g that never falls."""
        return self.profile.rising

    @property
    def certain(self) -> bool:
        """Whether every contact is known to be one disc: on a homogeneous half-space a g that never falls suffices."""
        return isinstance(self.medium, HomogeneousMedium) and self.profile.rising

    @property
    def notes(self) -> tuple[Note, ...]:
        """What must be said about shape and medium."""
        return (*self.medium.notes, *self.profile.notes)

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        return self.profile.height(r)

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""
        return self.profile.slope(r)

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        return self.medium.gap(self.profile, x)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        return self.medium.gap_slope(self.profile, x)

    def gap_load(self, radius: Array) -> Array:
        """The integral of k'(x) g(x) from 0 to `radius` [N]."""
        return self.medium.gap_load(self.profile, radius)
