"""A film that slides on its base without friction, and is not bonded to it."""

from __future__ import annotations

from winkler.errors import InvalidInput
from winkler.materials.elastic import RIGID, Solid
from winkler.materials.layered import Layer, StackLayer
from winkler.media.layered.coated import BARBER
from winkler.media.stacked.stacked import SlidingStack
from winkler.validity import Assumption, Note, Standing
from winkler.values import value

__all__ = ["SlidingFilm"]


@value
class SlidingFilm(SlidingStack):
    r"""An isotropic layer on a half-space or a rigid base, without shear between them and without a gap.

    It is a `StackedHalfSpace` of one layer that is not bonded.  With x = xi h and gamma = E* / E*_b of layer and base

    .. math:: 1+M = \frac{\sinh^2x+\gamma\,(\sinh x\cosh x+x)}{\sinh x\cosh x+x+\gamma\,(\sinh^2x-x^2)} .

    The solid appears by E* alone: Poisson's ratio has no other effect.

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
        Where shear on the surface is requested.

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
                f"SlidingFilm: layers has {len(self.layers)} layers; give one Layer(solid, thickness). "
                "StackedHalfSpace takes several layers, bonded or sliding; CoatedHalfSpace several bonded ones."
            )

    @property
    def stack(self) -> tuple[StackLayer, ...]:
        """The layer, which slides on its base."""
        return tuple(StackLayer(layer.solid, layer.thickness, bonded=False) for layer in self.layers)

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
