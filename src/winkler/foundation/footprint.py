r"""The outline of the contact behind a line of springs: a disc, an ellipse, or an unknown one.

Stiffness and depth are those of a disc of radius :math:`a = k/(2E^*)` whatever the outline; pressure, area, yield and
wear are not.  An ellipse of semi-axes :math:`\alpha > \beta`, :math:`m = 1-\beta^2/\alpha^2`, is as stiff as that disc
if :math:`\alpha = 2aK(m)/\pi`; moved along the surface without slip it yields, in a direction whose share is s,

.. math:: \frac1{G_s} = \frac1{E^*} + 2s\Bigl(\frac1{G^*}-\frac1{E^*}\Bigr) , \qquad
          s_\alpha = \frac{K-E}{mK} , \quad s_\beta = 1-s_\alpha ,

since a force on the surface moves it by :math:`(1-\nu+\nu\cos^2\theta)/(2\pi Gr)` and s is the mean of
:math:`\cos^2\theta` over the ellipse.  A disc has s = 1/2 in both directions.
"""

from __future__ import annotations

import math
from typing import Any

from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity
from winkler.values.value import value, words


@value
class RoundOutline:
    """The contact is a disc whose radius is that of the springs."""

    unlike_disc = ""
    """Nothing: it is one."""
    shear_share = 0.5
    """Mean of cos^2 of the angle to the shear [-]."""

    def area(self, radius: Array) -> Array:
        """Area of the contact [m^2]."""
        return math.pi * radius**2


@value
class UnknownOutline:
    """The contact may have any outline; the radius is that of the disc of equal stiffness.

    Parameters
    ----------
    origin : str
        What the springs stand for.
    instead : str
        The class that computes the outline instead.
    """

    __words__ = words(
        origin=("", None, "contact that the springs represent"),
        instead=("", None, "class that computes the outline"),
    )

    origin: str
    instead: str

    shear_share = 0.5
    """Mean of cos^2 over both directions [-]; each for itself is not known."""

    @property
    def unlike_disc(self) -> str:
        """What the springs stand for, which results they give, and what to use instead."""
        return (
            f"the foundation represents {self.origin}: it gives force, depth and stiffness, not the outline of "
            f"the contact; {self.instead}"
        )

    def area(self, radius: Array) -> Array:
        """Refused."""
        raise OutsideValidity(f"The area of the contact is not known: {self.unlike_disc}.")


@value
class EllipticOutline:
    """The contact is an ellipse, similar to itself under each load.

    Parameters
    ----------
    slenderness : float
        Semi-axis across over the one along x, b/a [-].
    """

    slenderness: float

    @property
    def unlike_disc(self) -> str:
        """What the springs stand for, which results they give, and what to use instead."""
        return (
            f"the foundation represents an ellipse of b/a = {self.slenderness:.4g}: it gives force, depth, "
            "stiffness and area; use EllipticIndentation for its pressure, or give Foundation(profile, medium) "
            "of a round body"
        )

    @property
    def shear_share(self) -> float:
        """Mean of cos^2 of the angle to x [-], over the ellipse: what a shear along x depends on."""
        from scipy.special import elliprd, elliprf

        smaller = min(self.slenderness, 1.0 / self.slenderness) ** 2
        longer = float(elliprd(0.0, smaller, 1.0) / (3.0 * elliprf(0.0, smaller, 1.0)))
        return longer if self.slenderness < 1.0 else 1.0 - longer

    def semi_axes(self, radius: Array) -> tuple[Array, Array]:
        """Return a along x and b across it [m] of the ellipse as stiff as a disc of this radius [m]."""
        from scipy.special import elliprf

        smaller = min(self.slenderness, 1.0 / self.slenderness)
        larger = 2.0 / math.pi * float(elliprf(0.0, smaller**2, 1.0)) * radius
        return (larger, smaller * larger) if self.slenderness <= 1.0 else (smaller * larger, larger)

    def area(self, radius: Array) -> Array:
        """Area of the contact [m^2]."""
        along, across = self.semi_axes(radius)
        return math.pi * along * across


Footprint = RoundOutline | UnknownOutline | EllipticOutline
DISC = RoundOutline()


def footprint_of(profile: Any) -> Footprint:
    """Return the outline that a profile leaves: a disc, unless it says otherwise."""
    outline = getattr(profile, "footprint", DISC)
    return outline if isinstance(outline, Footprint) else DISC
