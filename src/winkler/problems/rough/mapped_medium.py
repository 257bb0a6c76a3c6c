"""What a height map assumes of the medium that it is pressed into."""

from __future__ import annotations

from winkler.media.mapped import MappedMedium, layers_of
from winkler.numerics.types import Quantity
from winkler.problems.pressed_shape.notes import PIXELS_ON_LAYERS, SULLIVAN, graded_notes
from winkler.problems.rough.surface_notes import surface_notes
from winkler.profiles.rough.topography import Topography
from winkler.values.validity import Assumption, Note, Standing

FOLLOWED_SHARE = 0.01
"""Part of the displacement under a wave of sixteen pixels that may be wrong without a word."""


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
    border = notes[1]
    if rough.periodic and layers.mean > 0.0:
        border = Note(
            Assumption.RESPONSE,
            Standing.EXACT,
            "The map repeats without end in both directions. Depths are the approach of the mean planes, "
            "including the compression of the layers by the mean pressure on their rigid base.",
            SULLIVAN,
        )
    lost = 0.0 if rough.periodic else layers.lost(rough.pixel)
    coarse = Note(
        Assumption.RESOLUTION,
        Standing.APPROXIMATE,
        "The pixels are too wide for a nearly incompressible film: at a wavelength of sixteen pixels "
        f"displacements have an error of {lost:.1%}. Use a finer map.",
        "pixels of constant pressure against the compliance of the layers",
    )
    return (PIXELS_ON_LAYERS, border, *graded_notes(medium), *((coarse,) if lost > FOLLOWED_SHARE else ()), *notes[2:])
