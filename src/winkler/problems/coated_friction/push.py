r"""Springs of a coated body that is pushed along the surface: normal and shear kernels need not be alike.

With tractions along the motion that depend on the distance from the axis alone (Cattaneo, Mindlin), the mean of the
displacement over each ring is that of the compliance averaged over the angle between wave and motion,
:math:`\frac12(C_L+C_T)`.  The problem is then scalar, as that of a twist: springs with the weight
:math:`e^2 = \varphi_S(x;x)^2` bear :math:`h=G^*U` while they stick, and otherwise what rings that slide bear,
:math:`\mu p(r)` at each radius (`winkler.numerics.transforms.slip_tables`).
"""

from __future__ import annotations

import functools

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.torsion_bound import TwistBound
from winkler.media.interior.twist_field import clean_slope
from winkler.media.twisting.kernels import TwistKernel
from winkler.media.twisting.surface import TABLE_ROUNDING
from winkler.numerics.panels.kink_panels import Sample
from winkler.numerics.transforms import abel, fredholm
from winkler.numerics.transforms.slip_tables import slip_table
from winkler.numerics.types import Array
from winkler.problems.friction.torsion_states import TwistedSprings
from winkler.values import value

__all__ = ["PushBound", "PushedSprings", "push_bound"]


class PushBound(TwistBound):
    """What springs bear before they slide; parameters as of `TwistBound`, on a CoatedHalfSpace."""

    owner, load, unit, motion, free_motion = "CoatedTangential", "shear force", "N", "shift", "slide"

    def _springs(self) -> TwistKernel:
        medium = self.bed.medium
        table = slip_table(self.panels, medium.response, medium.tangential_response)  # type: ignore[attr-defined]
        return TwistKernel(medium.modulus * table.bound, table.lever**2)  # type: ignore[attr-defined]

    def inertia(self, radius: float) -> float:
        """Return 2 int e^2 dx up to a radius [m]: the stiffness over G*."""
        return 2.0 * float(self.panels.integral(self.weight, np.array([radius]))[0])

    def weigh(self, sample: Sample) -> Array:
        """Return e(x)^2 [-] at the places of a sample."""
        return np.asarray(sample.read(self.weight))


@functools.lru_cache(maxsize=8)
def push_bound(bed: Bed, coefficient: float, widest: float, forced: bool) -> PushBound:
    """Return the bound, cached by value."""
    return PushBound(bed, coefficient, widest, forced)


@value
class PushedSprings(TwistedSprings):
    """The springs of a pushed contact: what `TwistedSprings` holds, h = G* u in place of 8 G_t phi."""

    @property
    def _bound(self) -> TwistBound:
        return push_bound(self.bed, self.coefficient, self.widest, self.forced)

    def traction(self, r: Array) -> Array:
        """Return tau(r) [Pa] along the motion: rigidly pushed discs of all radii, superposed."""
        response = self.bed.medium.tangential_response  # type: ignore[attr-defined]
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
