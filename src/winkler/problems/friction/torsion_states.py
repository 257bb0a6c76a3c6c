"""What a twisted contact is at one moment."""

from __future__ import annotations

import numpy as np

from winkler.media.halfspace import HomogeneousMedium
from winkler.media.interior.twist_field import TwistBelow, twist_below
from winkler.media.layered.wave_constants import twist_constants
from winkler.media.twisting.surface import turning_on
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.ring_slip.ring_states import RingState
from winkler.problems.round_march import RoundTwist
from winkler.values.errors import OutsideValidity
from winkler.values.value import value


@value
class TorsionState(RingState, RoundTwist[float]):
    """A twisted contact at one moment; its numbers are those of `RoundTwist` and of `RingState`."""

    def line_load(self, x: ArrayLike) -> Array:
        """Return the load of the springs q(x) [N/m], odd in x.

        Parameters
        ----------
        x : array_like
            [m].
        """
        return self.springs.load(x)

    def turning(self, r: ArrayLike) -> Array:
        """Return the displacement u_theta(r) of the surface [m], the sum over both bodies.

        Parameters
        ----------
        r : array_like
            Distance from the axis [m], not negative.
        """
        return turning_on(self.springs.bed.medium, self.springs, np.asarray(r, dtype=float))

    def below(self, r: ArrayLike, z: ArrayLike) -> TwistBelow:
        """Return displacement and shear stresses inside the bodies.

        Parameters
        ----------
        r, z : array_like
            Distance from the axis, and depth below the surface [m]: positive in the first body, negative in the second.

        Returns
        -------
        TwistBelow
            In the common shape of r and z, with z from the surface into the first body throughout; a positive torque
            turns the first body forwards and the second one back.

        Raises
        ------
        InvalidInput
            If a place lies on the surface.
        OutsideValidity
            If the body there is rigid, or layered or graded.
        """
        places, depths = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(z, dtype=float))
        parts = np.zeros((3, *places.shape))
        medium = self.springs.bed.medium
        if not isinstance(medium, HomogeneousMedium):
            raise OutsideValidity(
                f"The stresses of a twist inside a {type(medium).__name__} are not known; request the traction of the "
                "state, state.traction(r), or give a homogeneous half-space."
            )
        for sign, body in ((1.0, "first"), (-1.0, "second")):
            here = sign * depths >= 0.0 if sign > 0.0 else depths < 0.0
            if here.any():
                modulus, stretch = twist_constants(getattr(medium, body))
                parts[:, here] = twist_below(self.springs, places[here], np.abs(depths[here]), modulus, stretch)
        # the second body is rotated in the opposite sense; there z, and with it tau_theta-z, counts from its own
        # surface
        parts[0] *= np.where(depths < 0.0, -1.0, 1.0)
        parts[2] *= np.where(depths < 0.0, -1.0, 1.0)
        return TwistBelow(*parts)
