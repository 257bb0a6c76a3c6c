"""What is shown beside the answer of a contact of a height map: the surface itself, its spectrum, where it touches."""

from __future__ import annotations

from typing import Any, NamedTuple

from winkler.problems.rough.reduced_bed import ReducedBed
from winkler.problems.rough.surface_conduction import SurfaceConductionSolution
from winkler.profiles.rough.topography import Topography
from winkler.study.chapters.answer import Caption
from winkler.study.chapters.contents import answer_of

__all__ = ["Beside", "beside"]

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
    problem = getattr(solution, "problem", None)
    contact = solution.contact if isinstance(solution, SurfaceConductionSolution) else None
    bed = getattr(problem, "bed", None)
    rough = getattr(problem if contact is None else contact.problem, "topography", None)
    if isinstance(bed, ReducedBed):
        rough = bed.topography
    found = [Beside(SURFACE, rough)] if isinstance(rough, Topography) else []
    caption = None if contact is None else answer_of(contact.problem).picture
    return (*found, *([Beside(caption, contact)] if caption is not None else []))
