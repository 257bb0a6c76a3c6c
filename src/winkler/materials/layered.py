"""Layers: of a coating, bonded and isotropic; of a stack, bonded or sliding, isotropic or transversely isotropic."""

from __future__ import annotations

from typing import Annotated, ClassVar

from winkler.materials.elastic import Elastic, TransverselyIsotropic
from winkler.values.checks.number_checks import Advice, PositiveNotTiny
from winkler.values.value import value, words

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
        Material of the layer; incompressible (poisson = 0.5) is allowed.
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
    bonded: ClassVar[bool] = True
    """A `StackLayer` may slide."""


@value
class StackLayer:
    """One layer of a `StackedHalfSpace`.

    Parameters
    ----------
    solid : Elastic or TransverselyIsotropic
        Material of the layer; the axis of a transversely isotropic solid is the surface normal.
    thickness : float
        [m], positive.
    bonded : bool, optional
        Whether it is bonded to the material below (the default).  If not, it slides there without friction, and does
        not lift off: the interface transmits normal stress and normal displacement only.

    Raises
    ------
    InvalidInput
        If the solid is neither, or the thickness not positive.

    Examples
    --------
    >>> StackLayer(Elastic(young=70e9, poisson=0.2), thickness=1e-4, bonded=False).bonded
    False
    """

    __words__ = words(bonded=("", "", "whether it is bonded to what lies below it; if not, it slides there"))

    solid: Elastic | TransverselyIsotropic
    thickness: Annotated[PositiveNotTiny, Advice("leave a layer without thickness out")]
    bonded: bool = True
