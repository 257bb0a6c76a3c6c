"""The compliances of two bodies along their surfaces, over those across them, from their moduli."""

from __future__ import annotations

from typing import cast

from winkler.media.halfspace import HalfSpace
from winkler.media.mapped import MappedMedium, layers_of
from winkler.media.offers import LayerStack, PowerOfDepth, PushedWaves, offers
from winkler.numerics.pixels.layered_shear import LayeredShear, ShearResponse
from winkler.numerics.pixels.power_law import PowerLawSurface
from winkler.numerics.surfaces.traction_grid import Compliance
from winkler.numerics.transforms.cosine_transform import in_own_lengths
from winkler.problems.assumptions.coupling import NEGLIGIBLE_COUPLING
from winkler.values.errors import OutsideValidity


def compliance_of(medium: MappedMedium) -> Compliance:
    """Return the compliances of the bodies along their surfaces, lengths of layers in m.

    Those in all directions, and more along the traction, follow from G* and G_t: a disc is pushed, and twisted.  Of
    layers and power laws the coupling of tractions with pressures is left out.

    Raises
    ------
    OutsideValidity
        If the modulus is proportional to the depth, or a layer slides.
    """
    if offers(medium, LayerStack) and not all(layer.bonded for layer in medium.stack):
        raise OutsideValidity(
            f"The layer of a {type(medium).__name__} that slides carries no tangential tractions of a height map. "
            "Under a tangential load it would slide away. Give bonded layers."
        )
    pushed, twisted = 2.0 * medium.modulus / medium.shear_modulus, 0.5 * medium.modulus / medium.torsional_modulus
    power = layers_of(medium) if offers(medium, PowerOfDepth) else None
    if isinstance(power, PowerLawSurface):  # its springs of a twist are stiffer than those of a push by (1 + k)^2
        twisted /= (1.0 + power.exponent) ** 2
        return Compliance(pushed - twisted, 2.0 * twisted - pushed, power=power)
    beta = medium.mismatch if isinstance(medium, HalfSpace) else 0.0
    surface = Compliance(pushed - twisted, 2.0 * twisted - pushed, beta if abs(beta) > NEGLIGIBLE_COUPLING else 0.0)
    if not offers(medium, PushedWaves):
        return surface
    even, unit = in_own_lengths(medium.tangential_response)
    turning = in_own_lengths(medium.turning_response)[0]
    layers = LayeredShear(cast(ShearResponse, even), turning, unit, medium.modulus / medium.shear_modulus)
    return surface._replace(layers=layers)
