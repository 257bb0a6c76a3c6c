"""Additional pictures of a contact of a height map: the surface, its spectrum, the contact area."""

from __future__ import annotations

from typing import Any, NamedTuple

from winkler.study.chapters.answer import Caption
from winkler.study.chapters.contents import answer_of
from winkler.values.checks.contract import is_a

HOLD_A_CONTACT = (
    "winkler.problems.rough.surface_conduction:SurfaceConductionSolution",
    "winkler.problems.pressed_maps.seal:SealSolution",
    "winkler.problems.pressed_maps.thermal_joint:ThermalJointSolution",
    "winkler.problems.pressed_maps.true_area:TrueAreaSolution",
    "winkler.problems.surface_current.constriction:SurfaceConstrictionSolution",
)
REDUCED_BED = "winkler.problems.rough.reduced_bed:ReducedBed"
HEIGHT_MAP = "winkler.profiles.rough.topography:Topography"
SURFACE_CAPTION = Caption(
    "surface",
    "The surface",
    "Heights above their mean, two cuts through the middle, and the power spectrum of all directions.",
)


class ExtraPicture(NamedTuple):
    """An additional figure: its caption, and the value that is drawn."""

    caption: Caption
    item: Any


def extra_pictures(solution: Any) -> tuple[ExtraPicture, ...]:
    """Return the additional pictures of a solution; empty for most solutions."""
    problem: Any = getattr(solution, "problem", None)
    contact = solution.contact if is_a(solution, *HOLD_A_CONTACT) else None
    bed: Any = vars(problem).get("bed") if problem is not None else None  # as given: the springs of others are made
    rough = getattr(problem if contact is None else contact.problem, "topography", None)
    if is_a(bed, REDUCED_BED):
        rough = bed.topography
    pictures = [ExtraPicture(SURFACE_CAPTION, rough)] if is_a(rough, HEIGHT_MAP) else []
    caption = None if contact is None else answer_of(contact.problem).picture
    return (*pictures, *([ExtraPicture(caption, contact)] if caption is not None else []))
