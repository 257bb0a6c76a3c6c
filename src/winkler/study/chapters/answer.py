"""One record for one answer: all that a study, a report and the app know of a problem beside its classes.

A chapter is a file with its kinds and its answers.  An `Answer` holds the line of the catalogue, what the picture of
the answer is called, which curves are drawn along a path or over many loads, which contact the pictures of the method
show, and the formulas.  What draws it is registered with `winkler.plot.draw`: nothing here waits for pictures.
"""

from __future__ import annotations

import enum
from collections.abc import Callable
from typing import Any, NamedTuple

from winkler.study.chapters.kind import Kind

__all__ = ["ALONG", "Answer", "Caption", "Chapter", "Contact", "Formula", "Formulas", "Kinds", "always", "then"]


class Formula(NamedTuple):
    """A formula and what it says.

    Parameters
    ----------
    says
        One sentence.
    latex
        For `winkler.study.report.mathml.formula`.
    """

    says: str
    latex: str


Formulas = Callable[[Any], tuple[Formula, ...]]
"""Problem -> its formulas, in the order in which they are used."""
ALONG = ("shift", "depth")
"""What the answers to many loads are drawn over where no curves are named: the first of these that was computed."""
Kinds = dict[str, dict[str, Kind]]
"""Slot -> kind -> its line of the catalogue."""


class Caption(NamedTuple):
    """What a picture is called.

    Parameters
    ----------
    name
        The stem of its files.
    title, sentence
        What it shows.
    """

    name: str
    title: str
    sentence: str


class Contact(enum.Enum):
    """Which elastic contact the pictures of the method show."""

    LOAD = "that of the last load"
    PATH = "that at the greatest depth of the whole path"
    EDGE = "that of bodies that stick, with the edge where springs are stretched"
    NONE = "none: the pictures of the answer itself hold all"


class Answer(NamedTuple):
    """What is known of the answer to one problem.

    Parameters
    ----------
    kind
        The problem as a line of the catalogue: its class, an example, the papers it stands on.
    formulas
        What was computed.
    picture
        Title of the picture of the whole answer; None where the pictures of the method show all.
    curves
        ``(along, of)``: what is drawn over what, of an answer along a path, over time or over many loads.
    compared
        Answers that are drawn over the position or depth, one curve for each point of a sweep.
    contact
        Which contact the pictures of the method show.
    contact_shown
        The same in words, of an answer that holds many contacts.
    """

    kind: Kind
    formulas: Formulas
    picture: Caption | None = None
    curves: tuple[tuple[str, str], ...] = ()
    compared: tuple[str, ...] = ()
    contact: Contact = Contact.LOAD
    contact_shown: str = ""


class Chapter(NamedTuple):
    """One chapter of contact mechanics.

    Parameters
    ----------
    physics
        What the validation table calls it.
    kinds
        Its loads, laws, bodies and all else that is no problem.
    answers
        Kind of problem -> what is known of its answer.
    """

    physics: str
    kinds: Kinds
    answers: dict[str, Answer]

    @property
    def problems(self) -> dict[str, Kind]:
        """Its problems as lines of the catalogue."""
        return {name: answer.kind for name, answer in self.answers.items()}


def always(*formulas: Formula) -> Formulas:
    """Return what gives the same formulas for each problem of a kind."""
    return lambda problem: formulas


def then(first: Formulas, *more: Formula) -> Formulas:
    """Return what gives the formulas of a pressed contact and some more; none where the former are not known."""
    return lambda problem: (*before, *more) if (before := first(problem)) else ()
