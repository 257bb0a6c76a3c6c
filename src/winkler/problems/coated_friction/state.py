"""What a pushed contact on layers is at one moment."""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.foundation.sheared_fields import BodyFields, ShearedFields, body_of_pressed, body_under
from winkler.media.medium import Medium
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.coated_friction.push import PushedSprings
from winkler.values import value, words

__all__ = ["CoatedTangentialState"]


@value
class CoatedTangentialState:
    """A pushed contact on layers, or a grading, at one moment.

    Parameters
    ----------
    time, depth, force, radius, shift, shear_force, stick_radius : float
        As in `winkler.problems.coated_friction.tangential.CoatedTangentialSolution`.
    work, stored_energy, dissipation, nested : float or bool
        As there.
    springs : PushedSprings
        Their load.
    """

    __words__ = words(work=("W", "J", "what the lateral motion has spent since the beginning"))

    time: float
    depth: float
    force: float
    radius: float
    shift: float
    shear_force: float
    stick_radius: float
    work: float
    stored_energy: float
    dissipation: float
    nested: bool
    springs: PushedSprings

    def traction(self, r: ArrayLike) -> Array:
        """Return the traction tau(r) [Pa] along the motion, of the sign of the shear force; zero outside the contact.

        Parameters
        ----------
        r : array_like
            Distance from the axis [m], not negative.
        """
        r = np.asarray(r, dtype=float)
        return self.springs.traction(r) if self.radius > 0.0 else np.zeros(r.shape)

    def slip(self, r: ArrayLike) -> Array:
        """Return how far the surfaces stand displaced against each other [m], mean over the circle.

        Where they have touched all the time that is how far they have slipped.

        Parameters
        ----------
        r : array_like
            Distance from the axis [m], not negative.
        """
        r = np.asarray(r, dtype=float)
        return self.shift - (np.zeros(r.shape) if self._still else self.springs.displacement(r))

    @property
    def _still(self) -> bool:
        """Whether nothing acts along the surface."""
        return self.radius == 0.0 or (self.shear_force == 0.0 and self.shift == 0.0)

    @property
    def medium(self) -> Medium:
        """The bodies."""
        return self.springs.bed.medium

    @property
    def _pressed(self) -> PressedSprings:
        return PressedSprings(self.springs.bed, self.depth, self.radius)

    def sharp_places(self) -> tuple[float, ...]:
        """Return distances from the axis at which stresses on the surface are infinite [m]."""
        springs = self._pressed, self.springs
        kinks = [b for part in springs for b, strength in part.kinks if strength != 0.0]
        return (*kinks, *([self.radius] if any(part.edge != 0.0 for part in springs) else []))

    def surface_fields(self, r: Array) -> ShearedFields:
        """Return pressure, traction, displacement along the surface and slip (`winkler.restore`).

        Parameters
        ----------
        r : ndarray
            Distance from the axis [m], not negative.
        """
        pressed, slip = self._pressed, self.slip(r)
        pressure = pressed.bed.medium.pressure(pressed, r) if self.radius > 0.0 else np.zeros(r.shape)
        return ShearedFields(r, pressure, self.traction(r), self.shift - slip, slip)

    def body_fields(self, x: Array, y: Array, z: Array) -> BodyFields:
        """Return stresses and displacements under pressure and traction (`winkler.restore_body`).

        Parameters
        ----------
        x, y, z : ndarray
            Places [m]; z > 0 in the layers and their base, z < 0 in the other body.

        Raises
        ------
        OutsideValidity
            If the body there is rigid, or stresses in this medium are not known.
        """
        if self._still:
            return body_of_pressed(self._pressed, x, y, z)
        return body_under(self._pressed, self.springs.body, x, y, z)
