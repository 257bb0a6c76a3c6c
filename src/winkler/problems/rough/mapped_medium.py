"""The media that a height map may be pressed into: what its boundary elements take of them, and what is not known."""

from __future__ import annotations

from typing import TypeAlias, cast

from winkler.errors import OutsideValidity
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.layered.coated import CoatedHalfSpace, SlidingFilm, StackedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.media.offers import GradedInDepth, PowerOfDepth, PressedWaves, offers
from winkler.numerics.pixels.layered import GridResponse, LayeredSurface, SurfaceBelow
from winkler.numerics.pixels.power_law import PowerLawSurface
from winkler.numerics.transforms.cosine_transform import in_own_lengths
from winkler.numerics.types import Quantity
from winkler.problems.rough.surface_notes import surface_notes
from winkler.profiles.rough.topography import Topography
from winkler.validity import Assumption, Note, Standing

__all__ = ["MappedMedium", "homogeneous", "layers_of", "medium_notes"]

MappedMedium: TypeAlias = (
    HomogeneousMedium | CoatedHalfSpace | StackedHalfSpace | SlidingFilm | DepthGradedHalfSpace | GradedHalfSpace
)
"""A medium under a height map."""
SULLIVAN = "T. C. O'Sullivan, R. B. King, J. Tribol. 110 (1988) 235-240, doi:10.1115/1.3261591"
FOLLOWED_SHARE = 0.01
"""Part of the displacement under a wave of sixteen pixels that may be wrong without a word."""


def layers_of(medium: MappedMedium) -> SurfaceBelow | None:
    """Return what differs from a homogeneous half-space; nothing of a homogeneous medium.

    Parameters
    ----------
    medium : HomogeneousMedium, CoatedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
    """
    if offers(medium, PowerOfDepth):
        if medium.exponent == 1.0:
            raise OutsideValidity(
                "A height map on Gibson's solid (exponent 1) meets springs of the surface alone, which winkler's "
                "boundary elements do not hold; give an exponent below 1."
            )
        return PowerLawSurface(medium.exponent, medium.depth_scale)
    if not offers(medium, PressedWaves):
        return None
    own, unit = in_own_lengths(medium.response)
    return LayeredSurface(cast(GridResponse, own), unit)


def homogeneous(owner: str, what: str, medium: MappedMedium) -> HomogeneousMedium:
    """Return the medium, or refuse layers.

    Parameters
    ----------
    owner, what : str
        Who refuses, and what is not known in layers.
    medium : HomogeneousMedium, CoatedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace

    Raises
    ------
    OutsideValidity
        If it is not homogeneous.
    """
    if not isinstance(medium, HomogeneousMedium):
        raise OutsideValidity(
            f"{owner}: {what} of a height map on a {type(medium).__name__} is not known to winkler, pressures, gaps "
            "and stiffness are; give a HalfSpace."
        )
    return medium


def medium_notes(
    medium: MappedMedium, rough: Topography, hardness: float, blurred: float, penetration: Quantity, misfit: Quantity
) -> tuple[Note, ...]:
    """Return what was assumed of a map and of the medium below it.

    Parameters
    ----------
    medium : HomogeneousMedium, CoatedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
    rough, hardness, blurred, penetration, misfit
        As of `winkler.problems.rough.surface_notes.surface_notes`.
    """
    notes = surface_notes(rough, hardness, blurred, penetration, misfit)
    layers = layers_of(medium)
    if layers is None:
        return notes
    response = Note(
        Assumption.RESPONSE,
        Standing.EXACT,
        "Frictionless contact of linear elastic layers or of a body graded in depth, every pixel pressing on "
        "all others through their surface compliance.",
        SULLIVAN,
    )
    border = notes[1]
    if rough.periodic and layers.mean > 0.0:
        border = Note(
            Assumption.RESPONSE,
            Standing.EXACT,
            "The map is repeated for ever in both directions; depths are approaches of the mean planes, and how far "
            "the mean pressure compresses the layers on their rigid base.",
            SULLIVAN,
        )
    graded = medium.notes if offers(medium, GradedInDepth) else ()
    if offers(medium, PowerOfDepth):
        graded = medium.notes[1:]  # the first one is of one round contact
    lost = 0.0 if rough.periodic else layers.lost(rough.pixel)
    coarse = Note(
        Assumption.RESOLUTION,
        Standing.APPROXIMATE,
        "The pixels are wide for a nearly incompressible film: under a wave of sixteen of them displacements are wrong "
        f"by {lost:.1%}; take a finer map.",
        "pixels of constant pressure against the compliance of the layers",
    )
    return (response, border, *graded, *((coarse,) if lost > FOLLOWED_SHARE else ()), *notes[2:])
