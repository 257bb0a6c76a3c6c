"""The compliances of two bodies along their surfaces, over those across them, from their moduli."""

from __future__ import annotations

from typing import cast

from winkler.errors import OutsideValidity
from winkler.media.halfspace import HalfSpace, HomogeneousMedium
from winkler.media.layered.climb import is_bonded
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.media.layered.depth_response import solid_at
from winkler.media.layered.pair_response import Mode
from winkler.media.mapped import MappedMedium
from winkler.media.stacked.stacked import SlidingStack
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.numerics.pixels.layered_shear import LayeredShear, ShearResponse
from winkler.numerics.surfaces.traction_grid import Compliance
from winkler.numerics.transforms.cosine_transform import in_own_lengths
from winkler.problems.assumptions.coupling import NEGLIGIBLE_COUPLING

__all__ = ["compliance_of"]


def compliance_of(medium: MappedMedium) -> Compliance:
    """Return the compliances of the bodies along their surfaces, lengths of layers in m.

    Those in all directions, and more along the traction, follow from G* and G_t: a disc is pushed, and twisted.  Of
    layers the coupling of tractions with pressures is left out.

    Raises
    ------
    OutsideValidity
        If the modulus follows a power of the depth, or a layer slides.
    """
    if isinstance(medium, HomogeneousMedium):
        pushed, twisted = 2.0 * medium.modulus / medium.shear_modulus, 0.5 * medium.modulus / medium.torsional_modulus
        beta = medium.mismatch if isinstance(medium, HalfSpace) else 0.0
        beta = beta if abs(beta) > NEGLIGIBLE_COUPLING else 0.0
        return Compliance(pushed - twisted, 2.0 * twisted - pushed, beta)
    if isinstance(medium, CoatedHalfSpace):
        top = medium.layers[0].solid
    elif isinstance(medium, DepthGradedHalfSpace):
        top = solid_at(medium.grading)
    elif isinstance(medium, SlidingStack):
        if not all(is_bonded(layer) for layer in medium.stack):
            raise OutsideValidity(
                f"The layer of a {type(medium).__name__} that slides bears no tractions of a height map: under a push "
                "it slides away; give layers that are bonded."
            )
        return _on_layers(TransverselyIsotropicHalfSpace(medium.stack[0].solid, medium.second), medium)
    else:
        raise OutsideValidity(
            "The tractions of a height map on a GradedHalfSpace, whose modulus follows a power of the depth, are not "
            "known to winkler (the response to a push in one point is not built in); give a DepthGradedHalfSpace, "
            "or a Foundation(profile, medium)."
        )
    return _on_layers(HalfSpace(top, medium.second), medium)


def _on_layers(surface: HomogeneousMedium, medium: CoatedHalfSpace | DepthGradedHalfSpace | SlidingStack) -> Compliance:
    """Return those of layers, from those of their surface as a half-space."""
    even, unit = in_own_lengths(medium.tangential_response)
    layers = LayeredShear(
        cast(ShearResponse, even),
        in_own_lengths(medium.responding(Mode.TURNING))[0],
        unit,
        surface.modulus / surface.shear_modulus,
    )
    return compliance_of(surface)._replace(coupling=0.0, layers=layers)
