"""What a page shows of an outcome: pictures as plain data, tables and notes as escaped HTML."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
import orjson

from winkler.errors import WinklerError
from winkler.plot import method
from winkler.plot.wear.wear import moment_panels
from winkler.problems.adhesion.indentation import AdhesiveSolution
from winkler.problems.answer import is_recovering
from winkler.problems.wear.states import WearState
from winkler.study.batch.outcome import Outcome
from winkler.study.chapters.contents import answer_of
from winkler.study.chapters.method_captions import captions_of
from winkler.study.report.figures import answers_over, settings_of, shown_point, svg_element
from winkler.study.report.markup import safe
from winkler.study.report.page_parts import papers, trust
from winkler.study.report.tables import answer_section, expected, failures
from winkler.validity import worst
from winkler.web.pictures import histories
from winkler.web.pictures.chart import Chart, chart
from winkler.web.pictures.moments import Moments, contact_at
from winkler.web.pictures.solid import draw_solid
from winkler.web.pictures.springs import moment_springs
from winkler.web.pictures.view import NOTHING, View, fitting

__all__ = [
    "AnswerText",
    "Frame",
    "Picture",
    "Scene",
    "Shown",
    "method_pictures",
    "packed",
    "pictures",
    "scene",
    "sheets",
    "told",
]


class AnswerText(NamedTuple):
    """The answer in words and numbers.

    Parameters
    ----------
    standing
        The worst of all notes.
    answers, notes, papers
        Sections of a page.
    text
        The study as a file.
    moments, moment
        How many moments the answer has, zero where it is no history; and which of them is shown first.
    points
        Of a sweep.
    """

    standing: str
    answers: str
    notes: str
    papers: str
    text: str
    moments: int
    moment: int
    points: int = 1


class Picture(NamedTuple):
    """One interactive picture, or why there is none.

    Parameters
    ----------
    name, title, sentence
        What is seen.
    chart
        The figure for plotly.js as JSON; empty where there is none.
    missing
        Why there is none.
    """

    name: str
    title: str
    sentence: str
    chart: str
    missing: str = ""


class Frame(NamedTuple):
    """Says that all interactive pictures of one moment have been sent.

    Parameters
    ----------
    total
        How many they were.
    remark
        What must be said about them all.
    """

    total: int
    remark: str


class Scene(NamedTuple):
    """What the pictures of one moment show.

    Parameters
    ----------
    outcome, point
        What a study came to, and the point of it that is shown.
    contact
        At that moment; None where none is shown.
    view
        The frame that the pictures share.
    states
        Of all moments, where the answer has them.
    moment
        Which of the moments is shown, -1 without a history.
    remark
        What must be said about them all.
    """

    outcome: Outcome
    point: Any
    contact: Any
    view: View
    states: tuple[Any, ...]
    moment: int
    remark: str


class Shown(NamedTuple):
    """One sheet that was drawn as SVG, or why there is none."""

    title: str
    sentence: str
    svg: str
    missing: str = ""


def told(outcome: Outcome, text: str, moments: int, moment: int) -> AnswerText:
    """Return the answer in words and numbers."""
    answers = "\n".join(part for part in (answer_section(outcome), failures(outcome), expected(outcome)) if part)
    return AnswerText(
        worst(outcome.validity).value,
        answers,
        trust(outcome.validity),
        papers(outcome.study),
        text,
        moments,
        moment,
        len(outcome.points),
    )


def scene(outcome: Outcome, moments: Moments, moment: int, held: View, *, still: bool) -> Scene:
    """Return what the pictures of a moment show.

    Parameters
    ----------
    outcome
        What a study came to.
    moments, moment
        Those of its answer, and which of them is shown.
    held
        The frame of the pictures before.
    still
        Whether that frame is kept, because another moment of the same history is looked at.
    """
    point = shown_point(outcome)
    contact, here = contact_at(point, moments, moment)
    view, remark = NOTHING, ""
    if is_recovering(contact):
        view = held if still and held != NOTHING else _recovering(contact)
    elif contact is not None:
        view = held if still and held != NOTHING else fitting(contact.pressed, held)
        which = answer_of(point.problem).contact_shown
        if not here and which:
            remark = f"The pictures of the method show {which}."
        elif here and not moments.states:
            remark = (
                "The pictures of the method show the contact at this depth, its springs along the surface left out."
            )
    if outcome.study.sweep and contact is not None:
        shown = f"The pictures below are of {settings_of(outcome, point)}, the last point of the sweep."
        remark = f"{shown} {remark}".rstrip()
    return Scene(outcome, point, contact, view, moments.states, moment if moments.total else -1, remark)


def pictures(seen: Scene) -> Iterator[Picture]:
    """Yield the interactive pictures one by one, so that the first are drawn while the next are made."""
    contact, view = seen.contact, seen.view
    if is_recovering(contact):
        yield _made("springs", lambda: chart(moment_springs(contact, seen.point.problem.bed, view)))
    elif contact is not None:
        yield from method_pictures(contact, view)
    if seen.states and isinstance(seen.states[seen.moment], WearState):
        yield from _worn(seen.states, seen.moment)
    for pair in histories.curves_of(seen.outcome, seen.point):
        drawn = histories.draw_curves(seen.outcome, seen.point, pair, seen.moment)
        yield Picture("_over_".join(reversed(pair)), histories.title_of(pair), "", packed(drawn))


def _worn(states: tuple[Any, ...], moment: int) -> Iterator[Picture]:
    words = (
        ("worn_profile", "Worn profile", "The profile at this moment, before wear and in the end; filled is what has "
         "been worn off."),
        ("worn_depth", "Worn depth", "What both bodies have lost by this moment, and in the end."),
        ("worn_pressure", "Pressure", "p(r) at this moment, at first and in the end."),
    )  # fmt: skip
    for name, panel in zip(words, moment_panels(states, moment), strict=True):
        yield Picture(*name, packed(chart(panel)))


def _recovering(state: Any) -> View:
    wide = 1.6 * (float(state.radius) if state.radius > 0.0 else float(state.position[-1]))
    return View(wide, 1.2 * max(float(np.max(state.recess)), float(state.depth), 1e-3 * wide))


def method_pictures(contact: Any, view: View) -> Iterator[Picture]:
    """Yield the pictures of the method for one contact."""
    sticks = isinstance(contact, AdhesiveSolution)
    makers: dict[str, Callable[[], Chart]] = {
        "shape": lambda: draw_solid(contact, view),
        "springs": lambda: chart(moment_springs(contact, contact.pressed.bed, view)),
        "line_load": lambda: chart(method.line_load(contact, view.extent)),
        "pressure": lambda: chart(method.pressure(contact, view.extent)),
        "force": lambda: chart(method.force(contact)),
        "stress": lambda: chart(method.stress(contact, view.extent, coarse=True)),
    }
    for name, make in makers.items():
        yield _made(name, make, sticks=sticks)


def _made(name: str, make: Callable[[], Chart], *, sticks: bool = False) -> Picture:
    title, sentence = captions_of(sticks=sticks)[name]
    try:
        return Picture(name, title, sentence, packed(make()))
    except WinklerError as error:
        return Picture(name, title, sentence, "", re.sub(r"^\w+: ", "", str(error)))


def packed(chart: Chart) -> str:
    """Return a figure as JSON, its numbers in single precision."""
    return orjson.dumps(_single(chart), option=orjson.OPT_SERIALIZE_NUMPY).decode()


def _single(content: Any) -> Any:
    if isinstance(content, dict):
        return {name: _single(item) for name, item in content.items()}
    if isinstance(content, list | tuple):
        return [_single(item) for item in content]
    if isinstance(content, np.ndarray) and content.dtype.kind == "i":
        return np.ascontiguousarray(content)
    if isinstance(content, np.ndarray):
        return np.ascontiguousarray(content, dtype=np.float32)
    return content.item() if isinstance(content, np.generic) else content


def sheets(outcome: Outcome) -> Iterator[Shown]:
    """Yield the sheets of an answer, drawn one after the other."""
    for one in answers_over(outcome):
        if one.picture is None:
            yield Shown(one.title, one.sentence, "", one.missing)
        else:
            yield Shown(one.title, one.sentence, svg_element(one, safe(f"{one.title}. {one.sentence}")))
