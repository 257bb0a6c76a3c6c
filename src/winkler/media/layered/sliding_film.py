"""A film that slides on its base without friction, and is not bonded to it."""

from __future__ import annotations

from winkler.errors import InvalidInput, OutsideValidity
from winkler.materials.elastic import RIGID, Solid
from winkler.materials.layered import Layer
from winkler.media.families import SlidingBody
from winkler.media.layered.coated import BARBER, LayeredMedium
from winkler.media.layered.coated_load import CarriedLoad
from winkler.media.layered.sliding_response import SlidingResponse
from winkler.media.punch_field import BodyField
from winkler.numerics.transforms.cosine_transform import SurfaceResponse
from winkler.numerics.types import Array
from winkler.validity import Assumption, Note, Standing
from winkler.values import value

__all__ = ["SlidingFilm"]


@value
class SlidingFilm(LayeredMedium, SlidingBody):
    r"""An isotropic layer on a half-space or a rigid base, without shear between them and without a gap.

    The layer is bonded to nothing: it expands sideways under a pressure, also where it is incompressible, so that a
    thin film is far softer than the bonded one of `CoatedHalfSpace`.  It may slide, but it does not lift off.

    Parameters
    ----------
    layers : sequence of Layer
        One layer.
    on : Elastic or Rigid
        What carries it: an infinitely deep substrate, or a base that does not deform.
    second : Elastic or Rigid, optional
        The other body, z < 0; rigid unless given.

    Raises
    ------
    InvalidInput
        If there is not one layer, or something is not of these kinds.
    OutsideValidity
        Where shear on the surface, or stresses inside the body, are requested.

    References
    ----------
    J. R. Barber, Determining the contact area in elastic-indentation problems, J. Strain Anal. 9 (1974) 230-232;
    E. K. Dimitriadis et al., Biophys. J. 82 (2002) 2798-2810, doi:10.1016/S0006-3495(02)75620-8 (samples not bonded).

    Examples
    --------
    >>> from winkler.materials.elastic import Elastic, Rigid
    >>> import numpy as np
    >>> film = SlidingFilm([Layer(Elastic(young=1e6, poisson=0.5), thickness=1e-3)], on=Rigid())
    >>> round(float(film.punch_stiffness(np.array(0.1)) / (np.pi * 0.1**2 * film.modulus / 1e-3)), 3)
    1.004
    """

    layers: tuple[Layer, ...]
    on: Solid
    second: Solid = RIGID

    def __post_init__(self) -> None:
        if len(self.layers) != 1:
            raise InvalidInput(
                f"SlidingFilm: layers has {len(self.layers)} layers; give one Layer(solid, thickness), since a "
                "stack that slides is not solved. CoatedHalfSpace takes several bonded layers."
            )

    @property
    def response(self) -> SlidingResponse:
        """The response of the pair to a pressure."""
        return SlidingResponse(self.layers, self.on, self.second)

    @property
    def tangential_response(self) -> SurfaceResponse:
        """Refused, as that to any shear: the film would slide away."""
        raise OutsideValidity(
            "SlidingFilm: a film without friction on its base bears no shear, it slides away; give a CoatedHalfSpace "
            "for a bonded one."
        )

    along_response = tangential_response
    across_response = tangential_response

    @property
    def thickness(self) -> float:
        """Of the layer [m]."""
        return self.layers[0].thickness

    def inside(self, load: CarriedLoad, r: Array, z: Array) -> BodyField:
        """Refuse: fields inside the layer and its base are not computed."""
        raise OutsideValidity(
            "SlidingFilm: stresses inside a sliding film and its base are not computed; request fields of the surface, "
            "or give a CoatedHalfSpace for a bonded film."
        )

    notes = (
        Note(
            Assumption.RESPONSE,
            Standing.EXACT,
            "Frictionless contact of an isotropic, linear elastic layer that slides on its base without friction and "
            "does not lift off: k and g follow from its flat punches without approximation, for one round contact.",
            BARBER,
        ),
    )
    """What is assumed."""
