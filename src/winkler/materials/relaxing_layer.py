"""A layer of a coating that relaxes: its viscoelastic solid and its thickness."""

from __future__ import annotations

from typing import Annotated

from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.values.checks.number_checks import Advice, PositiveNotTiny
from winkler.values.value import value


@value
class ViscoelasticLayer:
    """One bonded, isotropic layer with a separate relaxation function.

    Parameters
    ----------
    solid : ViscoelasticSolid
        Material of the layer, with finite moduli at short and long times. It may be incompressible.
    thickness : float
        [m], positive.

    Raises
    ------
    InvalidInput
        If the solid is not viscoelastic, or the thickness not positive.

    Examples
    --------
    >>> from winkler.materials.spring_and_dashpot import StandardSolid
    >>> ViscoelasticLayer(StandardSolid(relaxed_shear=1e3, shear=4e3, relaxation_time=2.0), thickness=1e-4).thickness
    0.0001
    """

    solid: Annotated[ViscoelasticSolid, Advice("an elastic layer is a Layer(solid, thickness)")]
    thickness: Annotated[PositiveNotTiny, Advice("leave a layer without thickness out")]
