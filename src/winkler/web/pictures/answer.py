"""Display of an outcome: pictures as plain data, tables and notes as escaped HTML."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np

from winkler.plot import method
from winkler.plot.rough.film import film_panels, has_frames
from winkler.plot.wear.wear import moment_panels
from winkler.problems.adhesion.indentation import AdhesiveSolution
from winkler.problems.answer import is_recovering, is_worn
from winkler.study.batch.outcome import Outcome
from winkler.study.chapters.answer import Caption
from winkler.study.chapters.contents import answer_of
from winkler.study.chapters.method_captions import captions_of
from winkler.study.report.describe import settings_text
from winkler.study.report.extra_pictures import extra_pictures
from winkler.study.report.figure import ReportFigure, capital, svg_element
from winkler.study.report.figures import answers_over
from winkler.study.report.headline.questions import questions_of
from winkler.study.report.headline.section import doubt_line, doubt_of
from winkler.study.report.headline.shown_contact import shown_point
from winkler.study.report.markup import badge, safe
from winkler.study.report.page_parts import code_section, papers, trust
from winkler.study.report.tables import answer_section, expected, failures
from winkler.values.errors import WinklerError
from winkler.values.validity import worst
from winkler.web.pictures import histories
from winkler.web.pictures.chart import Chart, chart
from winkler.web.pictures.comparison import numbers_of
from winkler.web.pictures.moments import Moments, bed_of, contact_at, labels_of
from winkler.web.pictures.packing import packed
from winkler.web.pictures.replies import AnswerText, DrawnSheet, InteractivePicture
from winkler.web.pictures.solid import draw_solid
from winkler.web.pictures.springs import moment_springs
from winkler.web.pictures.view import NO_VIEW, View, fitting, of_history
from winkler.web.pictures.words import text_plain


class Scene(NamedTuple):
    """The data of the pictures of one moment.

    Parameters
    ----------
    outcome, point
        Outcome of a study, and its displayed point.
    contact
        At that moment; None if none is shown.
    view
        The common frame of the pictures.
    states
        Of all moments, if the results have them.
    moment
        Index of the moment, -1 without a history.
    remark
        Remark on all of them.
    """

    outcome: Outcome
    point: Any
    contact: Any
    view: View
    states: tuple[Any, ...]
    moment: int
    remark: str


def answer_text(outcome: Outcome, text: str, moments: Moments, moment: int) -> AnswerText:
    """Return the results as text."""
    answers = "\n".join(part for part in (answer_section(outcome), failures(outcome), expected(outcome)) if part)
    return AnswerText(
        worst(outcome.validity).value,
        badge(outcome.validity),
        answers,
        trust(outcome.validity, questions_of(outcome)),
        papers(outcome.study) + code_section(outcome.study, "study.toml"),
        text,
        moments.total,
        moment,
        len(outcome.points),
        doubt_line(doubt_of(outcome)),
        numbers_of(outcome),
        labels=labels_of(outcome, shown_point(outcome), moments),
    )


def scene(outcome: Outcome, moments: Moments, moment: int, previous: View, *, still: bool) -> Scene:
    """Return the data of the pictures of a moment.

    Parameters
    ----------
    outcome
        Outcome of a study.
    moments, moment
        Moments of its results, and the index of the drawn one.
    previous
        Frame of the previous pictures.
    still
        Whether that frame is kept, for another moment of the same history.
    """
    point = shown_point(outcome)
    contact, here = contact_at(point, moments, moment)
    view, remark = NO_VIEW, ""
    if is_recovering(contact):
        view = previous if still and previous != NO_VIEW else _recovering(contact)
    elif contact is not None:
        is_moment = still and previous != NO_VIEW
        view = (of_history if is_moment else fitting)(contact.pressed, previous)
        which = answer_of(point.problem).contact_shown
        if not here and which:
            remark = f"The pictures of the method show {which}."
        elif here and not moments.states:
            remark = "The pictures of the method show the contact at this depth, without friction."
    if outcome.study.sweep and contact is not None:
        settings = settings_text(outcome.study, point.settings)
        remark = f"The pictures below are of {settings}, the last point of the sweep. {remark}".rstrip()
    return Scene(outcome, point, contact, view, moments.states, moment if moments.total else -1, remark)


def pictures(shown_scene: Scene) -> Iterator[InteractivePicture]:
    """Yield the interactive pictures one by one, so that the browser draws while the next are computed."""
    contact, view = shown_scene.contact, shown_scene.view
    if is_recovering(contact):
        yield _made("springs", lambda: chart(moment_springs(contact, bed_of(shown_scene.point.problem), view)))
    elif contact is not None:
        yield from method_pictures(contact, view)
    if shown_scene.states and is_worn(shown_scene.states[shown_scene.moment]):
        yield from _worn(shown_scene.states, shown_scene.moment)
    if shown_scene.moment >= 0 and has_frames(shown_scene.point.solution):
        yield from _zones(shown_scene.point.solution, shown_scene.moment)
    caption = answer_of(shown_scene.point.problem).picture
    if caption is not None and is_live(shown_scene.outcome):
        yield from _panels(shown_scene.point.solution, caption)
    for pair in histories.curves_of(shown_scene.outcome, shown_scene.point):
        drawn = histories.draw_curves(shown_scene.outcome, shown_scene.point, pair, shown_scene.moment)
        yield InteractivePicture("_over_".join(reversed(pair)), histories.title_of(pair), "", packed(drawn))


def is_live(outcome: Outcome) -> bool:
    """Return whether the panels of the whole answer are drawn in the browser, and no sheet of them is needed."""
    return len(outcome.points) == 1 and answer_of(shown_point(outcome).problem).live


def _panels(solution: Any, caption: Caption) -> Iterator[InteractivePicture]:
    """Yield the panels of the picture of an answer."""
    from winkler.plot import sheet_of as drawn_sheet  # loads all pictures, which those of the method do not need

    for number, panel in enumerate(drawn_sheet(solution).panels):
        sentence = "" if number or "; of many" in caption.sentence else caption.sentence
        title = capital(text_plain(panel.title))
        yield InteractivePicture(f"{caption.name}_{number + 1}", title, sentence, packed(chart(panel)))


def _worn(states: tuple[Any, ...], moment: int) -> Iterator[InteractivePicture]:
    captions = (
        ("worn_profile", "Worn profile", "The profile at this moment, before wear and in the end; filled is what has "
         "been worn off."),
        ("worn_depth", "Worn depth", "What both bodies have lost by this moment, and in the end."),
        ("worn_pressure", "Pressure", "p(r) at this moment, at first and in the end."),
    )  # fmt: skip
    for name, panel in zip(captions, moment_panels(states, moment), strict=True):
        yield InteractivePicture(*name, packed(chart(panel)))


def _zones(solution: Any, moment: int) -> Iterator[InteractivePicture]:
    captions = (
        (
            "stick_and_slip",
            "Stick and slip",
            "What sticks (green) and slips at this moment, with arrows of the traction.",
        ),
        ("traction", "Traction", "Its size at this moment, in one scale for all moments."),
    )
    for name, panel in zip(captions, film_panels(solution, moment), strict=True):
        yield InteractivePicture(*name, packed(chart(panel)))


def _recovering(state: Any) -> View:
    width = 1.6 * (float(state.radius) if state.radius > 0.0 else float(state.position[-1]))
    return View(width, 1.2 * max(float(np.max(state.recess)), float(state.depth), 1e-3 * width))


def method_pictures(contact: Any, view: View) -> Iterator[InteractivePicture]:
    """Yield the pictures of the method for one contact."""
    sticks = isinstance(contact, AdhesiveSolution)
    makers: dict[str, Callable[[], Chart]] = {
        "shape": lambda: draw_solid(contact, view),
        "springs": lambda: chart(moment_springs(contact, contact.pressed.bed, view)),
        "line_load": lambda: chart(method.line_load(contact, view.extent)),
        "pressure": lambda: chart(method.pressure(contact, view.extent)),
        "force": lambda: chart(method.force(contact)),
        "stress": lambda: chart(method.stress(contact, view.extent, scale=view.radius)),
    }
    for name, make in makers.items():
        yield _made(name, make, sticks=sticks)


def _made(name: str, make: Callable[[], Chart], *, sticks: bool = False) -> InteractivePicture:
    title, sentence = captions_of(sticks=sticks)[name]
    try:
        return InteractivePicture(name, title, sentence, packed(make()))
    except WinklerError as error:
        return InteractivePicture(name, title, sentence, "", re.sub(r"^\w+: ", "", str(error)))


def has_sheets(outcome: Outcome) -> bool:
    """Return whether sheets may follow the interactive pictures, which take a second."""
    point = shown_point(outcome)
    picture = answer_of(point.problem).picture or extra_pictures(point.solution)
    return not is_live(outcome) and (bool(picture) or len(outcome.table()[0].content) > 1)


def sheets(outcome: Outcome) -> Iterator[DrawnSheet]:
    """Yield the sheets of the results."""
    yield from map(sheet_of, answers_over(outcome, pictured=not is_live(outcome)))


def sheet_of(one: ReportFigure) -> DrawnSheet:
    """Return a figure of a report as a sheet."""
    svg = svg_element(one, safe(f"{one.title}. {one.sentence}")) if one.drawing is not None else ""
    return DrawnSheet(one.title, one.sentence, svg, one.missing)
