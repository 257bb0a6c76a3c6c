"""How far the wear of a height map can be trusted."""

from __future__ import annotations

import math

from winkler.media.offers import GradedInDepth, LayerStack, offers
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.rough.surface_contact import SurfaceContact
from winkler.problems.surface_wear.states import SurfaceWearState
from winkler.problems.wear.validity import DEBRIS, SLIDES_EVERYWHERE
from winkler.values.validity import Assumption, Note, Standing, standing_of

__all__ = ["wear_notes"]

ALEXANDER = "R. Alexander, SIAM J. Numer. Anal. 14 (1977) 1006-1021, doi:10.1137/0714068"
OWN_CHECK = "comparison of the worn depth with layer or grading"
THIN_WEAR, DEEP_WEAR = 0.01, 0.3
"""Part of the uppermost layer that may be worn off without and with a warning."""


def wear_notes(contact: SurfaceContact, tolerance: float, last: SurfaceWearState) -> tuple[Note, ...]:
    """Return what was assumed of the wear of a map, beside its contact.

    Parameters
    ----------
    contact
        Before wear.
    tolerance
        Of each step.
    last
        The state that has worn most.
    """
    notes = [
        DEBRIS,
        SLIDES_EVERYWHERE,
        Note(
            Assumption.RESOLUTION,
            Standing.APPROXIMATE,
            f"Each step errs by at most {tolerance:.0e} of the greatest worn depth. Greatest pressures err by more: a "
            "pixel that has just come into contact bears much for a short way; a smaller tolerance shows by how much.",
            ALEXANDER,
        ),
    ]
    if offers(contact.medium, LayerStack):
        share = last.worn_depth / contact.medium.layers[0].thickness
        notes.append(
            Note(
                Assumption.WEAR,
                standing_of(share, THIN_WEAR, DEEP_WEAR),
                f"The layers keep their thickness for the elastic response; {share:.2g} of the uppermost one was worn "
                "off where most was.",
                OWN_CHECK,
            )
        )
    if offers(contact.medium, GradedInDepth):
        notes.append(
            Note(
                Assumption.WEAR,
                Standing.APPROXIMATE,
                "The grading counts from the surface before wear for the elastic response: what was worn off must be "
                f"shallow against it; the greatest worn depth is {last.worn_depth:.3g} m.",
                OWN_CHECK,
            )
        )
    if math.isfinite(contact.hardness):
        notes.append(
            Note(
                Assumption.ELASTIC,
                Standing.APPROXIMATE,
                "Where pressures are cut at the hardness only wear changes the heights for good; what flows is not "
                "kept.",
                "assumption of the cut of pressures",
            )
        )
    why = "the tractions of friction are not stated, and the stresses under the worn map are not computed"
    return (*notes, *unknown_yield(contact.medium, why))
