"""Validity of a shape pressed by pixels on layers, gradings and power laws."""

from __future__ import annotations

from winkler.media.mapped import MappedMedium
from winkler.media.offers import GradedInDepth, PowerOfDepth, offers
from winkler.values.validity import Assumption, Note, Standing, standing_of

SULLIVAN = "T. C. O'Sullivan, R. B. King, J. Tribol. 110 (1988) 235-240, doi:10.1115/1.3261591"
PIXELS_ON_LAYERS = Note(
    Assumption.RESPONSE,
    Standing.EXACT,
    "Frictionless contact of linear elastic layers or of a body graded in depth. The pressure of every pixel "
    "displaces all other pixels.",
    SULLIVAN,
)
FINE, COARSE = 0.05, 0.2
"""Error of the edge up to which results count as fine, and as coarse."""


def graded_notes(medium: MappedMedium) -> tuple[Note, ...]:
    """Return what is assumed of a medium whose moduli vary with the depth; nothing of layers."""
    if offers(medium, PowerOfDepth):
        return medium.notes[1:]  # the first one is of one round contact
    return medium.notes if offers(medium, GradedInDepth) else ()


def pixel_notes(medium: MappedMedium, grid_error: float, edge_error: float) -> tuple[Note, ...]:
    """Return what was assumed of a shape pressed by pixels, and what these leave.

    Parameters
    ----------
    medium
        Both bodies.
    grid_error, edge_error
        Relative errors of depth, force and greatest pressure, and of what depends on the edge.
    """
    pixels = Note(
        Assumption.RESOLUTION,
        standing_of(edge_error, FINE, COARSE),
        f"The error estimated from two grids is up to {grid_error:.1g} of depth, force and maximum pressure. It "
        f"is up to {edge_error:.1g} of area, stiffness and position of the contact edge.",
        "comparison of two grids",
    )
    return (PIXELS_ON_LAYERS, *graded_notes(medium), pixels)
