r"""Laws of adhesion that say how the attraction fades with the gap: exponentially, or as between two solids.

Both have the work of adhesion :math:`w` and a length, and pull the more the closer the surfaces are, up to the
strength.
"""

from __future__ import annotations

import math
from typing import Annotated

from winkler.laws.adhesion import NO_ATTRACTION_ADVICE
from winkler.values.checks.number_checks import Positive
from winkler.values.value import value, words


@value
class ExponentialAttraction:
    r"""Attraction that decays exponentially with the gap, with impenetrable surfaces: w/r exp(-g/r).

    Parameters
    ----------
    work : float
        Work of adhesion [J/m^2], positive.
    range : float
        r [m], over which the stress falls to 1/e, positive.

    Raises
    ------
    InvalidInput
        If a number is not positive and finite.

    References
    ----------
    V. Rey, G. Anciaux, J.-F. Molinari, Comput. Mech. 60 (2017) 69-81, doi:10.1007/s00466-017-1392-5

    Examples
    --------
    >>> ExponentialAttraction(work=0.05, range=0.5e-9).strength
    100000000.0
    """

    __words__ = words(
        strength=(r"\sigma_0", "Pa", "greatest stress with which the surfaces attract each other"),
        range=("r", "m", "gap over which the attraction falls to 1/e"),
    )

    work: Annotated[Positive, NO_ATTRACTION_ADVICE]
    range: Annotated[Positive, NO_ATTRACTION_ADVICE]

    @property
    def strength(self) -> float:
        """The maximum attraction, work / range [Pa]."""
        return self.work / self.range


@value
class LennardJones:
    r"""Attraction and repulsion of two solids with the Lennard-Jones potential between molecules (8-2, or 3-9, law).

    .. math:: \sigma(g) = \frac{8w}{3z_0}\left[\left(\frac{z_0}{g}\right)^3-\left(\frac{z_0}{g}\right)^9\right]

    Parameters
    ----------
    work : float
        Work of adhesion [J/m^2], positive.
    spacing : float
        z_0 [m], the gap at which surfaces neither attract nor repel each other, positive.

    Raises
    ------
    InvalidInput
        If a number is not positive and finite.

    References
    ----------
    J. A. Greenwood, Proc. R. Soc. Lond. A 453 (1997) 1277-1297, doi:10.1098/rspa.1997.0070

    Examples
    --------
    >>> round(LennardJones(work=0.05, spacing=0.3e-9).strength / 1e6, 3)
    171.067
    """

    __words__ = words(
        strength=(r"\sigma_0", "Pa", "greatest stress with which the surfaces attract each other"),
        spacing=("z_0", "m", "gap at which surfaces neither attract nor repel each other"),
    )

    work: Annotated[Positive, NO_ATTRACTION_ADVICE]
    spacing: Annotated[Positive, NO_ATTRACTION_ADVICE]

    @property
    def strength(self) -> float:
        """The maximum attraction, 16 w / (9 sqrt(3) z_0) [Pa], at the gap of 3^(1/6) z_0."""
        return 16.0 / (9.0 * math.sqrt(3.0)) * self.work / self.spacing
