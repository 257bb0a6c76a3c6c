"""The moments of a history: their number, and the contact at each of them."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from winkler.loading.loads import Depth
from winkler.plot.series import name_in_words
from winkler.problems.adhesion.indentation import AdhesiveIndentation, AdhesiveSolution
from winkler.problems.answer import is_march, is_recovering, is_restorable, is_worn
from winkler.problems.normal.indentation import Indentation
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.study.batch.outcome import Outcome
from winkler.study.batch.points import SolvedPoint
from winkler.study.chapters.answer import ALONG, PicturedContact
from winkler.study.chapters.contents import answer_of
from winkler.study.language.explain import plain_symbol
from winkler.study.report.headline.shown_contact import shown_contact
from winkler.values.readable import with_unit

ALONG_HISTORIES = ("time", "cycle", "distance")
"""What a history goes along, the first of these that was computed."""


class Moments(NamedTuple):
    """The moments of a solution.

    Parameters
    ----------
    total
        Their number; zero without a history.
    states
        The state at each, if the solution has them.
    """

    total: int = 0
    states: tuple[Any, ...] = ()


def moments_of(point: SolvedPoint) -> Moments:
    """Return the moments of a solution along a path or over time, or its loads."""
    if len(point.each) > 1:
        return Moments(len(point.each), point.each)
    if isinstance(point.problem, ViscoelasticIndentation):
        states = tuple(point.problem.steps())
        return Moments(len(states), states)
    rows = max((len(content) for content in point.answers.values()), default=1)
    history = "time" in point.answers or is_march(point.problem)
    return Moments(rows if history and rows > 1 else 0)


def initial_moment(point: SolvedPoint, moments: Moments) -> int:
    """Return the moment shown first: that of the greatest tangential load, depth or force; else the last.

    Of wear it is the last. Where depths are negative too, as of bodies that adhere, it is the deepest one pressed, and
    moments without contact do not count.
    """
    if moments.states and is_worn(moments.states[-1]):
        return moments.total - 1
    touching = np.atleast_1d(point.answers.get("radius", np.ones(1))) > 0.0
    for name in ("shear_force", "torque", "depth", "force"):
        content = np.nan_to_num(point.answers.get(name, np.zeros(0)))
        if not moments.total or content.size != moments.total:
            continue
        if name != "depth" or np.max(content) <= 0.0:
            content = np.abs(content)
        content = np.where(touching, content, 0.0) if touching.size in (1, content.size) else content
        if np.max(content) > 0.0:
            return int(np.argmax(content))
    return moments.total - 1


def labels_of(outcome: Outcome, point: SolvedPoint, moments: Moments) -> tuple[str, ...]:
    """Return what each moment is, as ``t = 0.5 s`` or ``force = 2 N``; empty if unknown."""
    over = (*ALONG_HISTORIES, *(pair[0] for pair in answer_of(point.problem).curves), *ALONG, "force")
    for name in over:
        content = np.atleast_1d(point.answers.get(name, np.zeros(0)))
        if moments.total and content.size == moments.total:
            word = outcome.word(name)
            letter = plain_symbol(word.symbol)
            lead = name_in_words(name) if not letter or "_" in letter else letter
            return tuple(f"{lead} = {with_unit(float(one), word.unit)}" for one in content)
    return ()


def bed_of(problem: Any) -> Any:
    """Return the bed of a problem, or that of the contact that it takes; None if neither has one."""
    return getattr(problem, "bed", None) or getattr(getattr(problem, "contact", None), "bed", None)


def contact_at(point: SolvedPoint, moments: Moments, moment: int) -> tuple[Any, bool]:
    """Return the contact drawn at a moment (None if there is none), and whether it belongs to that moment.

    A state with a depth alone is drawn without its tangential springs.
    """
    if moments.states and (is_restorable(moments.states[moment]) or is_recovering(moments.states[moment])):
        return moments.states[moment], True
    contact_kind, answers, bed = answer_of(point.problem).pictured, point.answers, bed_of(point.problem)
    if moments.total and bed is not None and contact_kind is not PicturedContact.NONE:
        numbers = {name: float(answers[name][moment]) for name in ("depth", "force", "radius") if name in answers}
        if contact_kind is PicturedContact.EDGE and len(numbers) == 3 and numbers["radius"] > 0.0:
            problem = AdhesiveIndentation(bed, point.problem.law, Depth(numbers["depth"]))
            return AdhesiveSolution(problem, numbers["depth"], numbers["force"], numbers["radius"], True), True
        if "depth" in numbers and np.isfinite(numbers["depth"]):
            depth = 0.0 if contact_kind is PicturedContact.EDGE else max(numbers["depth"], 0.0)
            return Indentation(bed, Depth(depth)).solve(), True
    return shown_contact(point), False
