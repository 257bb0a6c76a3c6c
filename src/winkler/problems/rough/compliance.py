"""The compliances of two bodies along their surfaces, over those across them, from their moduli."""

from __future__ import annotations

from winkler.media.halfspace import HalfSpace, HomogeneousMedium
from winkler.numerics.surfaces.traction_grid import Compliance
from winkler.problems.assumptions.coupling import NEGLIGIBLE_COUPLING

__all__ = ["compliance_of"]


def compliance_of(medium: HomogeneousMedium) -> Compliance:
    """Return the compliances of the bodies along their surfaces.

    Those in all directions, and more along the traction, follow from G* and G_t: a disc is pushed, and twisted.
    """
    pushed, twisted = 2.0 * medium.modulus / medium.shear_modulus, 0.5 * medium.modulus / medium.torsional_modulus
    beta = medium.mismatch if isinstance(medium, HalfSpace) else 0.0
    beta = beta if abs(beta) > NEGLIGIBLE_COUPLING else 0.0
    return Compliance(pushed - twisted, 2.0 * twisted - pushed, beta)
