"""What is shown beside the answer of a contact of a height map: the surface itself, its spectrum, where it touches."""

from __future__ import annotations

from typing import Any, NamedTuple

from winkler.study.chapters.answer import Caption
from winkler.study.chapters.contents import answer_of
from winkler.study.chapters.kind import is_a

__all__ = ["Beside", "beside"]

CONDUCTION = "winkler.problems.rough.surface_conduction:SurfaceConductionSolution"
REDUCED = "winkler.problems.rough.reduced_bed:ReducedBed"
MAP = "winkler.profiles.rough.topography:Topography"
SURFACE = Caption(
    "surface",
    "The surface",
    "Heights above their mean, two cuts through the middle, and the power spectrum of all directions.",
)


class Beside(NamedTuple):
    """One more figure: what it is called, and what is drawn."""

    caption: Caption
    item: Any


def beside(solution: Any) -> tuple[Beside, ...]:
    """Return what is drawn before the answer itself; nothing for most answers."""
    problem: Any = getattr(solution, "problem", None)
    contact = solution.contact if is_a(solution, CONDUCTION) else None
    bed: Any = getattr(problem, "bed", None)
    rough = getattr(problem if contact is None else contact.problem, "topography", None)
    if is_a(bed, REDUCED):
        rough = bed.topography
    found = [Beside(SURFACE, rough)] if is_a(rough, MAP) else []
    caption = None if contact is None else answer_of(contact.problem).picture
    return (*found, *([Beside(caption, contact)] if caption is not None else []))
