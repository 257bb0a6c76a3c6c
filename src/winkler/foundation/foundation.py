r"""The foundation: a body of revolution over a medium, represented by a line of independent springs.

The springs at :math:`\pm x` have the stiffness :math:`c_N(x) = k'(x)/2` per length and stand under the equivalent
plane profile g(x); with :math:`g(a) = d`

.. math:: F = \int_0^a k'(x)\,(d - g(x))\,\mathrm dx = k(a)\,d - \int_0^a k'(x)\,g(x)\,\mathrm dx .
"""

from __future__ import annotations

from winkler.foundation.on_medium import UnderProfile
from winkler.media.medium import Medium
from winkler.profiles.profile import Profile
from winkler.values.value import value


@value
class Foundation(UnderProfile):
    """The spring foundation that represents a profile pressed into a medium.

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
