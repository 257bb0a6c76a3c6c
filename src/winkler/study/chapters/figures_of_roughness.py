"""What is shown beside the answer of a contact of a height map: the surface itself, its spectrum, where it touches."""

from __future__ import annotations

from typing import Any, NamedTuple

from winkler.problems.rough.reduced_bed import ReducedBed
from winkler.problems.rough.surface_conduction import SurfaceConductionSolution
from winkler.profiles.rough.topography import Topography
from winkler.study.chapters.captions import SHOWN_WHOLE

__all__ = ["Beside", "beside"]


class Beside(NamedTuple):
    """One more figure: the stem of its files, its title, a sentence, and what is drawn."""

    name: str
    title: str
    sentence: str
    item: Any


def beside(solution: Any) -> tuple[Beside, ...]:
    """Return what is drawn before the answer itself; nothing for most answers."""
    problem = getattr(solution, "problem", None)
    conducts = isinstance(solution, SurfaceConductionSolution)
    asked = solution.contact.problem if conducts else problem
    rough = getattr(asked, "topography", None)
    bed = getattr(problem, "bed", None)
    if isinstance(bed, ReducedBed):
        rough = bed.topography
    found = []
    if isinstance(rough, Topography):
        sentence = "Heights above their mean, two cuts through the middle, and the power spectrum of all directions."
        found.append(Beside("surface", "The surface", sentence, rough))
    if conducts:
        found.append(Beside(*SHOWN_WHOLE[type(solution.contact)], solution.contact))
    return tuple(found)
