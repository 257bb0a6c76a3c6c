"""What a pushed contact on a coating is at one moment."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array, ArrayLike
from winkler.problems.coated_friction.push import PushedSprings
from winkler.values import value, words

__all__ = ["CoatedTangentialState"]


@value
class CoatedTangentialState:
    """A pushed contact on a coating at one moment.

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
        still = self.radius == 0.0 or (self.shear_force == 0.0 and self.shift == 0.0)
        return np.full(r.shape, self.shift) if still else self.shift - self.springs.displacement(r)
