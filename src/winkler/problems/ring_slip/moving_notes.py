"""What is assumed where rings of a coating slide while the normal load changes, in small steps."""

from __future__ import annotations

import math

from winkler.foundation.bed import Bed
from winkler.media.offers import LayerStack, offers
from winkler.problems.normal.stiffness_ratio import alike, stiffness_ratios
from winkler.problems.ring_slip.push_notes import push_note
from winkler.values.validity import Assumption, Note, Standing

__all__ = ["IN_CYCLES", "IN_IMPACTS", "moving_ring_notes"]

OUTER_RINGS = (
    "Rings that slide are assumed to lie outside of those that stick. Under a changing normal load some slide inside "
    "of others. Reference: rings that slide independently of each other, "
)
IN_IMPACTS = (
    "a/h from 0.3 to 10. The greatest errors of a ball's velocity along the surface after an impact, over the "
    "coefficient times the velocity of approach, are: 3.5 % (base a hundred times softer than the layer), 2.8 % (ten "
    "times softer), 0.2 % (stiffer). Losses have errors of up to half as many per cent of that times the momentum "
    "along the surface."
)
IN_CYCLES = (
    "a/h from 1 to 10. The greatest errors of the loss of a cycle, over mu F_N A_x, are: 0.055 (base a hundred times "
    "softer than the layer, where motions in phase appear lossless), 0.012 (ten times softer), 0.002 (ten times "
    "stiffer)."
)
RINGS_NOTE = Note(
    Assumption.RESOLUTION,
    Standing.ASYMPTOTIC,
    "The contact is cut into rings and the motion into steps: velocities along the surface are known to 1e-4 of the "
    "first, losses to 1e-3; both errors fall with the square of rings and steps.",
    "compared with the closed solution on a half-space, rings and steps halved",
)
STUCK = Note(
    Assumption.SLIP,
    Standing.EXACT,
    "Nothing slides: springs bear what the stiffness k_x(a) of a disc without slip grows by with its radius, and what "
    "leaves the contact loses what it bore.",
    "superposition of discs of all radii, each moved along the surface as a whole",
)


def moving_ring_notes(
    bed: Bed, coefficient: float, radius: float, error: str, by_rings: bool = False
) -> tuple[Note, ...]:
    """Return what is assumed of rings; nothing where springs are alike, unless rings are asked for.

    Parameters
    ----------
    bed : Bed
    coefficient : float
        mu [-].
    radius : float
        Of the widest contact [m].
    error : str
        The end of the sentence on rings that slide inside of others.
    by_rings : bool, optional
        Whether rings are asked for.
    """
    if radius == 0.0 or (not by_rings and alike(stiffness_ratios(bed, radius))):
        return ()
    if math.isinf(coefficient):
        return (STUCK, RINGS_NOTE)
    source = "a march of 60 rings with constant tractions, normal and tangential"
    if not offers(bed.medium, LayerStack):
        error += " Those were layers; bodies graded in depth were not compared."
    outer = Note(Assumption.SLIP, Standing.APPROXIMATE, OUTER_RINGS + error, source)
    return (push_note(bed, radius), outer, RINGS_NOTE)
