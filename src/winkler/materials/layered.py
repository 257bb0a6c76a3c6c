"""A layer of a coating: what it is made of, and how thick it is."""

from __future__ import annotations

import math

from winkler.errors import InvalidInput
from winkler.materials.elastic import Elastic
from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.values import value

__all__ = ["Layer"]


@value
class Layer:
    """One bonded, isotropic layer of a coating.

    Parameters
    ----------
    solid : Elastic
        What it is made of; incompressible (poisson = 0.5) is allowed.
    thickness : float
        [m], positive.

    Raises
    ------
    InvalidInput
        If the solid is not elastic, or the thickness not positive.

    Examples
    --------
    >>> Layer(Elastic(young=250e9, poisson=0.2), thickness=2e-6).thickness
    2e-06
    """

    solid: Elastic
    thickness: float

    def __post_init__(self) -> None:
        if isinstance(self.solid, ViscoelasticSolid):
            raise InvalidInput(
                "Layer: solid relaxes, and unless all parts of a layered body do so in proportion its equivalent "
                "profile changes in time, which is not answered; build the body of Elastic(young, poisson), and give "
                "RelaxingInProportion(medium, solid, shear) of the whole."
            )
        if not isinstance(self.solid, Elastic):
            raise InvalidInput(f"Layer: solid is a {type(self.solid).__name__}; give Elastic(young, poisson).")
        number = self.thickness
        if isinstance(number, bool) or not isinstance(number, int | float) or not 0.0 < number < math.inf:
            raise InvalidInput(
                f"Layer: thickness is {number!r}; it must be a positive, finite number in m: leave a layer without "
                "thickness out."
            )
