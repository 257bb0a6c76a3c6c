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

from winkler.errors import OutsideValidity
from winkler.footprint import DISC
from winkler.foundation.bed import Bed
from winkler.foundation.torsion_bound import TwistBound
from winkler.media.families import CoatedBody
from winkler.media.twisting.kernels import TwistKernel
from winkler.numerics.panels.kink_panels import Sample
from winkler.numerics.transforms.slip_tables import slip_table
from winkler.numerics.types import Array

__all__ = ["PushBound", "push_bound", "pushed_body"]


def pushed_body(bed: Bed) -> CoatedBody:
    """Return the medium of a bed on which it is known what rings bear that slide along the surface.

    Raises
    ------
    OutsideValidity
        If it is not a CoatedHalfSpace, or the contact no disc.
    """
    if not isinstance(bed.medium, CoatedBody) or bed.footprint != DISC:
        raise OutsideValidity(
            f"CoatedTangential: the medium of the bed is a {type(bed.medium).__name__}; it must be a CoatedHalfSpace "
            "under a body of revolution, as rings with the kernels of layers are built in for these: use Tangential, "
            "on springs, for other media and shapes."
        )
    return bed.medium


class PushBound(TwistBound):
    """What springs bear before they slide; parameters as of `TwistBound`, on a CoatedHalfSpace."""

    owner, load, unit, motion, free_motion = "CoatedTangential", "shear force", "N", "shift", "slide"
    slides = True

    def _springs(self) -> TwistKernel:
        medium = pushed_body(self.bed)
        table = slip_table(self.panels, medium.response, medium.tangential_response)
        return TwistKernel(medium.modulus * table.bound, table.lever**2)

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
