"""What is assumed where rings of a coating slide while the normal load changes, in small steps."""

from __future__ import annotations

import math

from winkler.foundation.bed import Bed
from winkler.media.offers import LayerStack, offers
from winkler.problems.normal.stiffness_ratio import alike, stiffness_ratios
from winkler.problems.ring_slip.push_notes import push_note
from winkler.values.validity import Assumption, Note, Standing

OUTER_RINGS = (
    "Slip annuli are assumed to lie outside the stick zone. Under a changing normal load some annuli slip inside "
    "it. The reference solution uses annular elements that slip independently of each other, for ratios of contact "
    "radius to layer thickness "
)
IN_IMPACTS = (
    "from 0.3 to 10. Errors of the tangential velocity after impact are divided by mu times the approach "
    "velocity. The errors are at most 3.5 % (base 100 times softer than the layer), 2.8 % (10 times softer) and 0.2 % "
    "(stiffer). The dissipated energy has errors of up to half these percentages of mu times the approach "
    "velocity times the tangential momentum."
)
IN_CYCLES = (
    "from 1 to 10. Errors of the dissipated energy per cycle are divided by mu F_N A_x. The errors are at most "
    "0.055 (base 100 times softer than the layer), 0.012 (10 times softer) and 0.002 (10 times stiffer). If "
    "depth and displacement oscillate in phase on the softest base, the computed dissipated energy is zero."
)
RINGS_NOTE = Note(
    Assumption.RESOLUTION,
    Standing.ASYMPTOTIC,
    "The contact is divided into annular elements and the motion into steps. The error of tangential velocities "
    "is 1e-4 of the initial velocity, that of the dissipated energy 1e-3. Both errors are of second order in "
    "element and step size.",
    "compared with the closed solution on a half-space, rings and steps halved",
)
STUCK = Note(
    Assumption.SLIP,
    Standing.EXACT,
    "Nothing slips. The stiffness of the springs is the derivative of the no-slip stiffness k_x(a) of a disc "
    "with respect to its radius. A spring that leaves the contact loses its tangential load.",
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
        error += " These values hold for layers; graded bodies were not compared."
    outer = Note(Assumption.SLIP, Standing.APPROXIMATE, OUTER_RINGS + error, source)
    return (push_note(bed, radius), outer, RINGS_NOTE)
