r"""Springs of a layered or graded body that is pushed along the surface: normal and shear kernels need not be alike.

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
from winkler.foundation.footprint import DISC
from winkler.foundation.torsion_bound import TwistBound
from winkler.media.offers import PushedWaves, offers
from winkler.media.twisting.kernels import TwistKernel
from winkler.numerics.panels.kink_panels import Sample
from winkler.numerics.transforms import fredholm
from winkler.numerics.transforms.cosine_transform import SurfaceResponse
from winkler.numerics.transforms.slip_tables import slip_table
from winkler.numerics.types import Array
from winkler.problems.method import Method
from winkler.problems.normal.stiffness_ratio import common_ratio
from winkler.values.errors import OutsideValidity


def layers_of_rings(bed: Bed) -> PushedWaves | None:
    """Return the medium of a bed on which it is known what rings bear that slide along the surface; else None.

    Raises
    ------
    OutsideValidity
        If one of its layers slides on what lies below it, and bears no push.
    """
    medium = bed.medium
    if not offers(medium, PushedWaves) or bed.footprint != DISC:
        return None
    _ = medium.tangential_response  # refuses layers that slide
    return medium


def pushed_body(bed: Bed, owner: str = "Tangential", remedy: str = ", or give springs,") -> PushedWaves:
    """Return the medium of a bed on which it is known what rings bear that slide along the surface.

    Raises
    ------
    OutsideValidity
        If it is not of layers that are bonded, nor graded in depth, or the contact no disc.
    """
    medium = layers_of_rings(bed)
    if medium is None:
        raise OutsideValidity(
            f"{owner}: the medium of the bed is a {type(bed.medium).__name__}; rings need kernels of their own, "
            "those of a CoatedHalfSpace, of a StackedHalfSpace whose layers are bonded or of a DepthGradedHalfSpace "
            f"under a body of revolution: leave the method out{remedy} for other media and shapes."
        )
    return medium


def exact_ratio(owner: str, bed: Bed, radius: float) -> float:
    """Return c_T / c_N of the springs up to a radius [m], which the method `Method.EXACT` needs to be one.

    Raises
    ------
    OutsideValidity
        If it is not, with the nearest method that follows them.
    """
    nearest = Method.RINGS if layers_of_rings(bed) is not None else Method.SPRINGS
    return common_ratio(owner, bed, radius, f"the method {Method.EXACT} needs one ratio: give the method {nearest}")


class PushBound(TwistBound):
    """What springs bear before they slide; parameters as of `TwistBound`, on a medium of `layers_of_rings`."""

    owner, load, unit, motion, free_motion = "Tangential", "shear force", "N", "shift", "slide"
    slides, halvings = True, 12

    def _responses(self) -> tuple[SurfaceResponse, ...]:
        medium = pushed_body(self.bed)
        return medium.response, medium.tangential_response

    def _springs(self) -> TwistKernel:
        medium = pushed_body(self.bed)
        shear, radii = medium.tangential_response, self.x.ravel()
        table = slip_table(self.panels, medium.response, shear)
        weight = fredholm.edge(shear, radii) ** 2
        stuck = float(np.sum(self.panels.weights.ravel() * table.lever**2))
        # what polynomials leave of a logarithm shows in the stiffness without slip, which is known otherwise
        self.miss = (
            abs(stuck / float(fredholm.area(shear, self.panels.edges[-1:])[0]) - 1.0) if self.logarithmic else 0.0
        )
        # all rings that slide under a flat punch bear its force: what tables miss of that is made up for
        made_up = fredholm.area(medium.response, radii) / self._sum_to_nodes(table.bound * weight[:, None])
        return TwistKernel(medium.modulus * table.bound * made_up, weight)

    def _sum_to_nodes(self, columns: Array) -> Array:
        """Return the integral over x of each column of a table up to the node whose number it has, ``(n,)``."""
        panels, (count, per_panel) = self.panels, self.x.shape
        nodes = np.arange(count * per_panel)
        own = nodes // per_panel
        rows = (columns * panels.stretch.reshape(-1, 1)).T.reshape(-1, count, per_panel)
        whole = np.einsum("jpk,pk->jp", rows, panels.part(panels.edges[1:], np.arange(count)))
        below = np.sum(np.where(np.arange(count) < own[:, None], whole, 0.0), axis=1)
        return np.asarray(below + np.sum(panels.part(panels.nodes.ravel(), own) * rows[nodes, own], axis=1))

    @functools.lru_cache(maxsize=64)  # noqa: B019 - as `TwistBound.at`
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
