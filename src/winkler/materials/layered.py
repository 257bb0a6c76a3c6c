"""A layer of a coating: its solid and its thickness."""

from __future__ import annotations

from typing import Annotated

from winkler.checks.number_checks import Advice, PositiveNotTiny
from winkler.materials.elastic import Elastic
from winkler.values import value

__all__ = ["Layer"]


BUILT_ELASTIC = Advice(
    "a layer that relaxes is a ViscoelasticLayer(solid, thickness) of a ViscoelasticCoatedHalfSpace; if all parts "
    "relax in proportion, build the body of elastic layers, and give RelaxingInProportion(medium, solid, shear)"
)


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

    solid: Annotated[Elastic, BUILT_ELASTIC]
    thickness: Annotated[PositiveNotTiny, Advice("leave a layer without thickness out")]
