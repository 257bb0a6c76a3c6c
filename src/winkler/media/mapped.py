"""The media that a grid of pixels may be pressed into, and what its boundary elements take of them."""

from __future__ import annotations

from typing import TypeAlias, cast

from winkler.media.halfspace import HomogeneousMedium
from winkler.media.offers import PowerOfDepth, PressedWaves, PushedWaves, offers
from winkler.numerics.pixels.layered import GridResponse, LayeredSurface, SurfaceBelow
from winkler.numerics.pixels.power_law import PowerLawSurface
from winkler.numerics.transforms.cosine_transform import in_own_lengths
from winkler.values.errors import OutsideValidity

MappedMedium: TypeAlias = HomogeneousMedium | PushedWaves | PowerOfDepth
"""A medium under a height map."""


def layers_of(medium: MappedMedium) -> SurfaceBelow | None:
    """Return what differs from a homogeneous half-space; nothing of a homogeneous medium.

    Parameters
    ----------
    medium : HomogeneousMedium, CoatedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace

    Raises
    ------
    OutsideValidity
        If the modulus of a power law is proportional to the depth.
    """
    if offers(medium, PowerOfDepth):
        if medium.exponent == 1.0:
            raise OutsideValidity(
                "A height map on Gibson's solid (exponent 1) is not implemented, because its surface consists of "
                "independent springs; give an exponent below 1."
            )
        return PowerLawSurface(medium.exponent, medium.depth_scale)
    if not offers(medium, PressedWaves):
        return None
    own, unit = in_own_lengths(medium.response)
    return LayeredSurface(cast(GridResponse, own), unit)
