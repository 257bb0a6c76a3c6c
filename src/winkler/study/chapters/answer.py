"""One record for each problem: all that studies, reports and the app need beside its classes.

A chapter is a file with its kinds and its answers.  An `Answer` holds the line of the catalogue, the caption
of its picture, the curves that are drawn along a path or over many loads, the contact in the pictures of the method,
and the formulas.  Its picture is registered with `winkler.plot.draw`, so that no drawing code is loaded here.
"""

from __future__ import annotations

import enum
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

from winkler.study.chapters.kind import Kind, kind


class Equation(NamedTuple):
    """A formula and its sentence.

    Parameters
    ----------
    says
        One sentence that describes it.
    latex
        For `winkler.study.report.mathml.formula`.
    """

    says: str
    latex: str


Formulas = Callable[[Any], tuple[Equation, ...]]
"""Problem -> its formulas, in the order in which they are used."""
ALONG = ("shift", "depth")
"""Abscissae of the answers to many loads where no curves are named: the first of these that was computed."""
Kinds = dict[str, dict[str, Kind]]
"""Slot -> kind -> its line of the catalogue."""


class Caption(NamedTuple):
    """Caption of a picture.

    Parameters
    ----------
    name
        The stem of its files.
    title, sentence
        The caption.
    """

    name: str
    title: str
    sentence: str


class PicturedContact(enum.Enum):
    """The elastic contact in the pictures of the method."""

    LOAD = "that of the last load"
    PATH = "that at the greatest depth of the whole path"
    EDGE = "that of adhesive bodies, with stretched springs at the edge"
    NONE = "none: the pictures of the result show everything"


class Answer(NamedTuple):
    """Record of the answer to one problem.

    Parameters
    ----------
    kind
        The problem as a line of the catalogue: its class, an example, its papers.
    formulas
        Formulas of the solution.
    question
        What a user asks that it answers, in one sentence; none of a record that replaces another on bodies that relax.
    page
        The page of the manual on it, and the heading there if it has one of its own: ``chapters/wear.md#sliding``.
    headline
        Names of the answers that stand at the top in large letters, what is most often sought first; none where only
        the whole curve is an answer.  Of a path or a history they are those at its end.
    picture
        Title of the picture of the whole answer; None where the pictures of the method show all.
    curves
        ``(abscissa, ordinate)`` of the curves of an answer along a path, over time or over many loads.
    compared
        Answers that are drawn over the position or depth, one curve for each point of a sweep.
    pictured
        The contact in the pictures of the method.
    contact_shown
        The same in words, of an answer that holds many contacts.
    verdict
        Name of the answer in words that stands before the headline; empty where the question is for numbers.
    event
        What the first number of the headline belongs to, where that is not prescribed: "at which a body yields".
    says
        Sought number -> clause of the headline that answers the question: ``{name}`` stands for an answer with its
        unit, ``{name:%}`` for it in per cent, ``{name:size}`` without its sign, ``{name:below}`` for a depth.
        ``{contact_share}`` is the contact area over that of the height map.  Of the others the number is named.
    beyond
        The kind that takes the same bodies and goes on where a metal yields; empty without one.
    live
        Whether the panels of the picture take milliseconds, so that the app draws them at each move of a slider.
    """

    kind: Kind
    formulas: Formulas
    question: str = ""
    page: str = ""
    headline: tuple[str, ...] = ()
    picture: Caption | None = None
    curves: tuple[tuple[str, str], ...] = ()
    compared: tuple[str, ...] = ()
    pictured: PicturedContact = PicturedContact.LOAD
    contact_shown: str = ""
    verdict: str = ""
    event: str = ""
    says: Mapping[str, str] = MappingProxyType({})
    beyond: str = ""
    live: bool = False


def answer(
    path: str,
    /,
    *cites: str,
    question: str = "",
    page: str = "",
    headline: tuple[str, ...] = (),
    formulas: Formulas | tuple[Equation, ...],
    picture: Caption | None = None,
    curves: tuple[tuple[str, str], ...] = (),
    compared: tuple[str, ...] = (),
    pictured: PicturedContact = PicturedContact.LOAD,
    contact_shown: str = "",
    verdict: str = "",
    event: str = "",
    says: Mapping[str, str] = MappingProxyType({}),
    beyond: str = "",
    live: bool = False,
    **example: Any,
) -> Answer:
    """Return a record: the path of the problem, its papers and an example as for `kind`, and the fields of `Answer`.

    Formulas in place of a function of the problem are the same for each problem of the kind.
    """
    made = (lambda problem: formulas) if isinstance(formulas, tuple) else formulas
    line = kind(path, *cites, **example)
    return Answer(
        line,
        made,
        question,
        page,
        headline,
        picture,
        curves,
        compared,
        pictured,
        contact_shown,
        verdict,
        event,
        says,
        beyond,
        live,
    )


class Chapter(NamedTuple):
    """One chapter of contact mechanics.

    Parameters
    ----------
    physics
        Its name in the validation table.
    kinds
        Its loads, laws, bodies and other kinds that are no problems.
    answers
        Kind of problem -> record of its answer.
    relaxing
        The same of bodies that relax, where the answer shows more of them.
    """

    physics: str
    kinds: Kinds
    answers: dict[str, Answer]
    relaxing: Mapping[str, Answer] = MappingProxyType({})

    @property
    def problems(self) -> dict[str, Kind]:
        """Its problems as lines of the catalogue."""
        return {name: answer.kind for name, answer in self.answers.items()}


def followed_by(first: Formulas, *more: Equation) -> Formulas:
    """Return a function that gives the formulas of `first` and some more; none where the former are unknown."""
    return lambda problem: (*before, *more) if (before := first(problem)) else ()
