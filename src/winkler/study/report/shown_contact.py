"""Which contact the pictures of the method show: of the last point, the one that its record names."""

from __future__ import annotations

import numpy as np

from winkler.loading import Depth
from winkler.plot.adhesion.cycles import contact_of
from winkler.plot.method import Contact
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.study.batch.outcome import Answered, Outcome
from winkler.study.chapters.answer import Contact as Shows
from winkler.study.chapters.contents import answer_of

__all__ = ["shown_contact", "shown_point"]


def shown_point(outcome: Outcome) -> Answered:
    """Return the point whose contact the pictures show: the last one that was solved."""
    return outcome.solved[-1]


def shown_contact(point: Answered) -> Contact | None:
    """Return the contact of a point that the pictures show, its last load; None if there is no contact to show."""
    shows = answer_of(point.problem).contact
    if shows is Shows.NONE:
        return None
    solution = point.solution if shows is Shows.PATH else point.each[-1]
    if isinstance(solution, IndentationSolution):
        return solution
    if shows is Shows.EDGE:
        return contact_of(solution)
    inside = getattr(solution, "contact", None)
    if isinstance(inside, IndentationSolution):
        return inside
    bed, depth = getattr(point.problem, "bed", None), getattr(solution, "depth", None)
    if bed is None or not isinstance(depth, float | np.ndarray):
        return None
    return Indentation(bed, Depth(float(np.max(depth)))).solve()
