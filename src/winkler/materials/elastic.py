"""Linear elastic solids, and the rigid one."""

from __future__ import annotations

import math

from winkler.values.checks.number_checks import Finite, PoissonRatio, PositiveNotTiny, PositiveOrInfinite
from winkler.values.errors import InvalidInput
from winkler.values.value import value


@value
class Elastic:
    """An isotropic, linear elastic solid.

    Parameters
    ----------
    young : float
        Young's modulus E [Pa], positive.
    poisson : float
        Poisson's ratio nu [-], above -1 and at most 0.5.
    strength : float, optional
        Yield strength in uniaxial tension [Pa], positive; infinite (the default) if yielding is not considered.

    Raises
    ------
    InvalidInput
        If a number is outside its range.

    Examples
    --------
    >>> round(Elastic(young=210e9, poisson=0.3).shear / 1e9, 6)
    80.769231
    """

    young: PositiveNotTiny
    poisson: PoissonRatio
    strength: PositiveOrInfinite = math.inf

    @property
    def shear(self) -> float:
        """Shear modulus G = E / (2 (1 + nu)) [Pa]."""
        return self.young / (2.0 * (1.0 + self.poisson))


@value
class Rigid:
    """A body that does not deform."""


@value
class TransverselyIsotropic:
    """A linear elastic solid, isotropic in the plane of the surface, different along its normal.

    Parameters
    ----------
    c11, c12, c13, c33, c44 : float
        Elastic stiffnesses [Pa] in Voigt's notation, axis 3 along the surface normal.

    Raises
    ------
    InvalidInput
        If the stiffnesses do not give a positive strain energy: c44 > 0, c11 > abs(c12) and
        (c11 + c12) c33 > 2 c13^2.
    """

    c11: Finite
    c12: Finite
    c13: Finite
    c33: Finite
    c44: Finite

    def __post_init__(self) -> None:
        stable = (
            self.c44 > 0.0
            and self.c11 > abs(self.c12)
            and self.c33 > 0.0
            and (self.c11 + self.c12) * self.c33 > 2.0 * self.c13**2
        )
        if not stable:
            raise InvalidInput(
                f"TransverselyIsotropic: c11={self.c11:g}, c12={self.c12:g}, c13={self.c13:g}, c33={self.c33:g}, "
                f"c44={self.c44:g} Pa give a negative strain energy; a stable solid has c44 > 0, c11 > |c12| and "
                "(c11 + c12) c33 > 2 c13^2."
            )


RIGID = Rigid()
Solid = Elastic | Rigid
"""What the isotropic half-space may be made of."""
