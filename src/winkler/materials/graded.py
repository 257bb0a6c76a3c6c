r"""A solid whose Young's modulus grows or falls with the depth by a power law.

.. math:: E(z) = E_0\,(z/c_0)^k , \qquad -1 < k < 1 .

k = 0 is the homogeneous solid.  For k > 0 the surface is soft and the depth stiff (soil, bone, a ceramic infiltrated
with glass); k < 0 is a hard skin.  k = 1, Gibson's solid, makes sense for nu = 1/2 alone: its surface then responds to
a pressure exactly as Winkler's springs do.
"""

from __future__ import annotations

import math
from typing import Annotated

from winkler.values.checks.number_checks import Number, PoissonRatio, PositiveNotTiny
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

FINITE_DEPTH = Number(
    "a surface under load has a finite depth only for exponents above -1 and below 1", -1.0, 1.0, excluded=(-1.0,)
)


@value
class PowerLawGraded:
    """An isotropic, linear elastic solid with E = young (z / depth_scale)^exponent.

    Parameters
    ----------
    young : float
        Young's modulus E_0 [Pa] at the depth `depth_scale`, positive.
    depth_scale : float
        c_0 [m], positive.
    exponent : float
        k [-], above -1 and below 1; exactly 1 (Gibson's solid) only with poisson = 0.5.
    poisson : float
        Poisson's ratio nu [-], above -1 and at most 0.5, the same at every depth.

    Raises
    ------
    InvalidInput
        If a number is outside its range.

    References
    ----------
    J. R. Booker, N. P. Balaam, E. H. Davis, Int. J. Numer. Anal. Methods Geomech. 9 (1985) 353-367

    Examples
    --------
    >>> ceramic = PowerLawGraded(young=220e9, depth_scale=2e-3, exponent=0.15, poisson=0.25)
    >>> round(ceramic.young_at(0.02e-3) / 1e9, 3)
    110.261
    """

    __words__ = words(
        young=("E_0", "Pa", "Young's modulus at the depth c_0"),
        depth_scale=("c_0", "m", "depth at which the modulus is E_0"),
        exponent=("k", "", "exponent of the grading E = E_0 (z/c_0)^k"),
    )

    young: PositiveNotTiny
    depth_scale: PositiveNotTiny
    exponent: Annotated[float, FINITE_DEPTH]
    poisson: PoissonRatio

    def __post_init__(self) -> None:
        if self.exponent == 1.0 and self.poisson != 0.5:
            raise InvalidInput(
                f"PowerLawGraded: exponent 1 with poisson {self.poisson!r} has no solution, since the surface would "
                "move without limit; Gibson's solid needs poisson = 0.5, or give an exponent below 1."
            )

    def young_at(self, depth: float) -> float:
        """Return Young's modulus [Pa] at a depth [m]."""
        return self.young * math.pow(depth / self.depth_scale, self.exponent)
