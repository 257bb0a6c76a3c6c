"""The contact that the pictures of an answer show, and the stresses inside it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.loading.loads import Depth
from winkler.numerics.types import Array
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.study.batch.outcome import Outcome
from winkler.study.batch.points import SolvedPoint
from winkler.study.chapters.answer import PicturedContact as Shows
from winkler.study.chapters.contents import answer_of

if TYPE_CHECKING:
    from winkler.plot.method import Contact


def shown_point(outcome: Outcome) -> SolvedPoint:
    """Return the point whose contact the pictures show: the last one that was solved."""
    return outcome.solved[-1]


def most_pressed(points: Sequence[SolvedPoint], each: Sequence[Mapping[str, Array]]) -> SolvedPoint:
    """Return the point with the greatest pressure, else with the greatest load; else the last.

    Parameters
    ----------
    points
        Solved ones.
    each
        Numbers of each.
    """
    for name in ("peak_pressure", "mean_pressure", "force", "force_per_length"):
        if all(name in one for one in each):
            greatest = [np.max(one[name], initial=-math.inf, where=~np.isnan(one[name])) for one in each]
            return points[int(np.argmax(greatest))]
    return points[-1]


def shown_contact(point: SolvedPoint) -> Contact | None:
    """Return the contact of a point in the pictures, of its last load; None if there is none."""
    shows = answer_of(point.problem).pictured
    if shows is Shows.NONE:
        return None
    solution = point.solution if shows is Shows.PATH else point.each[-1]
    if isinstance(solution, IndentationSolution):
        return solution
    if shows is Shows.EDGE:
        from winkler.plot.adhesion.cycles import contact_of  # loads the problems of adhesion

        return contact_of(solution)
    inside = getattr(solution, "contact", None)
    if isinstance(inside, IndentationSolution):
        return inside
    bed, depth = getattr(point.problem, "bed", None), getattr(solution, "depth", None)
    if bed is None or not isinstance(depth, float | np.ndarray):
        return None
    return Indentation(bed, Depth(float(np.max(depth)))).solve()


def stressed_contact(point: SolvedPoint) -> Any:
    """Return the contact whose stresses are sought: that of the pictures, that inside an answer, or the answer.

    Parameters
    ----------
    point
        A solved point.
    """
    contact = shown_contact(point)
    if contact is not None:
        return contact
    found = point.each[-1]
    inside = getattr(found, "contact", None)
    return inside if hasattr(inside, "greatest_stress") else found


def medium_of(found: Any) -> Any:
    """Return the medium of a contact or a problem; None where it names none.

    Parameters
    ----------
    found
        A solution or one of its states.
    """
    problem = getattr(found, "problem", found)
    own = getattr(problem, "medium", None)
    return getattr(getattr(problem, "bed", None), "medium", None) if own is None else own
