r"""How stiff the contacts of a height map are along x and along y: springs in both directions from solved contacts.

In each contact whose depth differs enough the tractions are found that shift all its pixels alike, without slip:
:math:`K_x` and :math:`K_y` over the normal stiffness k are ratios that change slowly with k.  Between the contacts,
whose pixels make them jump, they are the parabola in ln k that meets them best, or a line or a number if these do as
well.
"""

from __future__ import annotations

import numpy as np

from winkler.foundation.directional import DirectionalBed
from winkler.foundation.measured import MeasuredBed
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium
from winkler.numerics.surfaces.punched_grid import stuck_stiffness
from winkler.numerics.types import Array
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.rough.surface_states import SurfaceState

__all__ = ["StuckContacts"]

FEWEST_PIXELS = 16
"""A contact of fewer determines its stiffnesses too poorly."""
LEAST_DEPTH_RATIO = 1.4
"""Contacts whose depths differ by less are as stiff in both directions."""
ALLOWED_MISFIT = 2e-3
"""Difference of a stiffness from the computed ones, over the greatest, at which a simpler curve is enough."""
GREATEST_DEGREE = 2
LEAST_POWER = -0.5
"""Of the ratio over k: K_x must rise with k."""
ISOTROPIC = 1e-12
"""Part of the compliance that depends on the direction, of bodies where it is rounding."""


class StuckContacts:
    """Contacts that are sheared without slip.

    Parameters
    ----------
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
        Both bodies.
    pixel : tuple of float
        Sides of a pixel [m].
    """

    def __init__(self, medium: MappedMedium, pixel: tuple[float, float]) -> None:
        self.medium, self.pixel = medium, pixel
        self.compliance = compliance_of(medium)
        self.depths: list[float] = []
        self.rows: list[tuple[float, float, float]] = []
        """Normal stiffness [N/m], K_x/k and K_y/k."""

    def add(self, state: SurfaceState) -> None:
        """Take a contact, unless one of nearly its depth has been taken, or its direction does not matter."""
        touching = state.pressure > 0.0
        near = any(1.0 / LEAST_DEPTH_RATIO < state.depth / depth < LEAST_DEPTH_RATIO for depth in self.depths)
        isotropic = abs(self.compliance.along) <= ISOTROPIC and not self.compliance.layers
        if near or isotropic or np.count_nonzero(touching) < FEWEST_PIXELS:
            return
        along, across = stuck_stiffness(touching, self.pixel, self.compliance)
        self.depths.append(state.depth)
        stiffness = state.stiffness / self.medium.modulus
        self.rows.append((state.stiffness, along / stiffness, across / stiffness))

    def turned_to(self, bed: MeasuredBed) -> DirectionalBed:
        """Return these springs with the stiffness of both directions."""
        count = bed.radii.size
        ratios = np.full((2, count), self.medium.shear_modulus / self.medium.modulus)
        if self.rows:
            stiffness, *computed = np.array(sorted(self.rows)).T
            for i in range(2):
                ratios[i] = _fitted(stiffness, computed[i], bed.stiffnesses)
        return DirectionalBed(
            bed.radii, bed.stiffnesses, bed.depths, bed.scatter, bed.mindlin_ratio, bed.disc,
            ratios_along=ratios[0], ratios_across=ratios[1],
            homogeneous=isinstance(self.medium, HomogeneousMedium),
        )  # fmt: skip


def _fitted(stiffness: Array, ratio: Array, places: Array) -> Array:
    """Return the ratio at other stiffnesses: the simplest polynomial in ln k that meets the computed ones."""
    weight, powers = stiffness / stiffness[-1], np.log(stiffness / stiffness[-1])
    curve = np.polynomial.Polynomial([np.average(ratio, weights=weight)])
    for degree in range(1, min(GREATEST_DEGREE, ratio.size - 2) + 1):
        if float(np.max(np.abs(curve(powers) - ratio) * weight)) <= ALLOWED_MISFIT:
            break
        bent = np.polynomial.Polynomial.fit(powers, ratio, degree, w=weight)
        if np.min(bent.deriv()(powers) / bent(powers)) < LEAST_POWER:
            break
        curve = bent
    with np.errstate(divide="ignore"):
        within = np.clip(np.log(places / stiffness[-1]), powers[0], powers[-1])
    return np.asarray(curve(within))
