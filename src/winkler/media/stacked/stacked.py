r"""Stacks of layers that may be transversely isotropic about their normal, and of which any may slide on the next.

The compliance under a pressure is all that the method of `winkler.media.layered.coated` needs.  It is climbed from the
base to the surface (`winkler.media.layered.climb`) with the five constants of each layer; an interface that slides
passes on the normal stress and the normal displacement.
"""

from __future__ import annotations

from typing import ClassVar

from winkler.errors import InvalidInput, OutsideValidity
from winkler.materials.elastic import RIGID, Elastic, Rigid, TransverselyIsotropic
from winkler.materials.layered import Layer, StackLayer
from winkler.media.interior.shear_field_punch import ShearField
from winkler.media.layered.coated import BARBER, StackMedium
from winkler.media.layered.coated_load import CarriedLoad
from winkler.media.layered.pair_response import Mode, PairResponse
from winkler.media.layered.stack import StackBody
from winkler.media.medium import Displacement
from winkler.media.punch_field import BodyField
from winkler.media.stacked.floating import FloatingAcross
from winkler.numerics.types import Array
from winkler.validity import Assumption, Note, Standing
from winkler.values import value

__all__ = ["SlidingStack", "StackedHalfSpace"]


class SlidingStack(StackMedium):
    """What media of layers that may slide have in common."""

    notes: ClassVar[tuple[Note, ...]]
    """What is assumed."""

    def responding(self, mode: Mode) -> PairResponse:
        """The response of the pair to a load: to a twist and a pressure, if a layer slides."""
        slides = next((number for number, layer in enumerate(self.stack, 1) if not layer.bonded), 0)
        if not slides or mode is Mode.NORMAL:
            return super().responding(mode)
        if mode is Mode.ACROSS:
            return FloatingAcross(mode, StackBody(self.stack[:slides], RIGID), self.second)
        raise OutsideValidity(
            f"{type(self).__name__}: layer {slides} slides on what lies below it and bears no shear there, so "
            "that under a push it slides away; give layers that are bonded."
        )

    def inside_dragged(self, load: CarriedLoad, modulus: float, x: Array, y: Array, z: Array) -> ShearField:
        """Stresses and displacements under a traction along +x: that of a load times a modulus; no layer slides."""
        _ = self.tangential_response
        return super().inside_dragged(load, modulus, x, y, z)

    def interior(self, displacement: Displacement, r: Array, z: Array, *, below: bool) -> BodyField:
        """Stresses and displacements in the layers and their base (`below`), or in the other body."""
        if not below and isinstance(self.second, TransverselyIsotropic):
            raise OutsideValidity(
                f"{type(self).__name__}: the stresses inside a transversely isotropic second body are not known to "
                "winkler; request the surface (without z), or points in the layers."
            )
        return super().interior(displacement, r, z, below=below)


@value
class StackedHalfSpace(SlidingStack):
    r"""Layers, isotropic or transversely isotropic, each bonded to what lies below it or sliding there, on a base.

    Isotropic layers that are all bonded give what `CoatedHalfSpace` gives; more problems take that.  An interface that
    slides has no friction and does not open.

    Parameters
    ----------
    layers : sequence of StackLayer or Layer
        From the surface down, at least one.  A `Layer` is bonded.
    on : Elastic, TransverselyIsotropic or Rigid
        What carries them: an infinitely deep substrate, or a base that does not deform.
    second : Elastic, TransverselyIsotropic or Rigid, optional
        The other body, z < 0; rigid unless given.

    Raises
    ------
    InvalidInput
        If there is no layer, or something is not of these kinds.
    OutsideValidity
        Where shear on the surface is requested although a layer slides, or stresses inside a transversely isotropic
        uppermost layer or second body.

    References
    ----------
    J. R. Barber, Determining the contact area in elastic-indentation problems, J. Strain Anal. 9 (1974) 230-232;
    H. A. Elliott, Proc. Camb. Phil. Soc. 45 (1949) 621-630, doi:10.1017/S0305004100025305 (transversely isotropic
    solids).

    Examples
    --------
    A glass cover slip on a polymer: bonded to it, and sliding on it.

    >>> import numpy as np
    >>> glass, polymer = Elastic(young=70e9, poisson=0.2), Elastic(young=3e9, poisson=0.35)
    >>> for bonded in (True, False):
    ...     cover = StackedHalfSpace([StackLayer(glass, 10e-6, bonded)], on=polymer)
    ...     print(f"{float(cover.punch_stiffness(np.array(10e-6))) / 1e6:.4f} MN/m")
    0.1687 MN/m
    0.1525 MN/m
    """

    layers: tuple[StackLayer | Layer, ...]
    on: Elastic | TransverselyIsotropic | Rigid
    second: Elastic | TransverselyIsotropic | Rigid = RIGID

    def __post_init__(self) -> None:
        if not self.layers:
            raise InvalidInput(
                "StackedHalfSpace: layers must be a list of at least one StackLayer(solid, thickness); for a body "
                "without layers give HalfSpace or TransverselyIsotropicHalfSpace."
            )

    notes = (
        Note(
            Assumption.RESPONSE,
            Standing.EXACT,
            "Frictionless contact of linear elastic layers, isotropic or transversely isotropic about the surface "
            "normal, each bonded to what lies below it or sliding there without friction or gap: k and g follow from "
            "the flat punches of the stack without approximation, for one round contact.",
            BARBER,
        ),
    )
    """What is assumed."""
