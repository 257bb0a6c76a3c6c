"""The load of the springs of a contact that is pushed on a coating, and its traction."""

from __future__ import annotations

import numpy as np

from winkler.foundation.torsion_bound import TwistBound
from winkler.media.interior.twist_field import clean_slope
from winkler.media.twisting.surface import TABLE_ROUNDING
from winkler.numerics.transforms import abel, fredholm
from winkler.numerics.types import Array
from winkler.problems.friction.torsion_states import TwistedSprings
from winkler.problems.ring_slip.push_bound import push_bound, pushed_body
from winkler.values import value

__all__ = ["PushedSprings"]


@value
class PushedSprings(TwistedSprings):
    """The springs of a pushed contact: what `TwistedSprings` holds, h = G* u in place of 8 G_t phi."""

    @property
    def _bound(self) -> TwistBound:
        return push_bound(self.bed, self.coefficient, self.widest, self.forced)

    def traction(self, r: Array) -> Array:
        """Return tau(r) [Pa] along the motion: rigidly pushed discs of all radii, superposed."""
        response = pushed_body(self.bed).tangential_response
        return np.asarray(
            abel.pressure(
                clean_slope(self, TABLE_ROUNDING),
                self.kinks,
                self.edge,
                self.radius,
                r,
                lambda r, x: fredholm.push(response, r, x),
                response.precision,
            )
        )
