"""The frames of a film: the body, the springs and the pressure at moments of a history, all in one frame."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from winkler.plot.animation import MOST_FRAMES, spread
from winkler.plot.marks import Facets
from winkler.plot.method import pressure
from winkler.plot.normal.body import contact_panel
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, points, titled
from winkler.plot.rough.film import film_sheets
from winkler.plot.series import name_in_words, series
from winkler.plot.wear.wear import moment_panels
from winkler.problems.answer import is_dragged, is_recovering, is_worn
from winkler.study.batch.points import SolvedPoint
from winkler.study.chapters.contents import answer_of
from winkler.values.errors import InvalidInput
from winkler.values.readable import with_unit
from winkler.web.pictures.moments import Moments, bed_of, contact_at, moments_of
from winkler.web.pictures.springs import moment_springs
from winkler.web.pictures.view import View, fitting

SPRINGS = "springs"
"""Title of their panel, which keeps its frame by itself."""
BEYOND = 0.05
"""Part of an axis that is left free beyond the curve with the moving point."""


def frames_of(point: SolvedPoint, *, most: int | None = None) -> Iterator[Sheet]:
    """Yield a sheet for each moment of an answer: a path, a time, cycles, or loads one after another.

    Parameters
    ----------
    point : SolvedPoint
    most : int, optional
        Of more moments so many are shown, at equal distances; 24 if left out.

    Raises
    ------
    InvalidInput
        If the answer has one state alone, or no contact that could be drawn.
    """
    most = MOST_FRAMES if most is None else most
    own = film_sheets(point.solution, most)
    if own is not None:
        yield from own
        return
    moments = moments_of(point)
    if moments.total < 2:
        raise InvalidInput(
            f"film: {type(point.problem).__name__} of one load does not move; give a path, times, cycles or a list "
            "of loads."
        )
    chosen = spread(moments.total, most)
    if moments.states and is_worn(moments.states[0]):
        for moment in chosen:
            panels = titled(moment_panels(moments.states, moment), "worn profile", "worn depth", "pressure")
            yield Sheet(panels, width=3.8, title=_title(point, moments, moment))
        return
    contacts = [contact_at(point, moments, moment)[0] for moment in chosen]
    bed = bed_of(point.problem)
    if bed is None or any(contact is None for contact in contacts):
        raise InvalidInput(f"film: a {type(point.problem).__name__} has no springs to be shown at each moment.")
    view = _view(contacts)
    rows = [_panels(contact, bed, view) for contact in contacts]
    for moment, row in zip(chosen, rows, strict=True):
        shown = tuple(
            panel if panel.title.startswith(SPRINGS) else _in_one_frame(panel, [each[place] for each in rows])
            for place, panel in enumerate(row)
        )
        panels = (*shown, *_course(point, moment))
        yield Sheet(panels, min(len(panels), 2), width=4.2, title=_title(point, moments, moment))


def _view(contacts: list[Any]) -> View:
    """Return the frame that holds all contacts."""
    recovering = [one for one in contacts if is_recovering(one)]
    if recovering:
        width = 1.6 * max(float(np.max(one.position)) for one in recovering)
        return View(width, 1.2 * max(max(float(np.max(one.recess)), float(one.depth)) for one in recovering))
    views = [fitting(one.pressed) for one in contacts if one.pressed.radius > 0.0]
    if not views:
        raise InvalidInput("film: the bodies touch at no moment, so there is nothing to show; give more load.")
    return View(max(one.extent for one in views), max(one.sunk for one in views))


def _panels(contact: Any, bed: Any, view: View) -> tuple[Panel, ...]:
    told = "; pressed red, recovering green" if is_recovering(contact) else ""
    told = "; sticking green, sliding red" if is_dragged(contact) else told
    springs = moment_springs(contact, bed, view).plus(title=f"{SPRINGS}{told}", legend="")
    if is_recovering(contact):
        return (springs,)
    body = contact_panel(contact, view.extent).plus(title="pressure below the body")
    return body, springs, pressure(contact, view.extent).plus(title="pressure")


def _in_one_frame(panel: Panel, every: Sequence[Panel]) -> Panel:
    """Return a panel with an upright axis that holds those of all moments."""
    lows = [low for one in every if (low := _end(one, np.min, one.upright.low)) is not None]
    highs = [high for one in every if (high := _end(one, np.max, one.upright.high)) is not None]
    greatest = max(every, key=lambda one: one.upright.scale.factor).upright.scale
    return panel.plus(upright=dataclasses.replace(panel.upright, low=min(lows), high=max(highs), scale=greatest))


def _end(panel: Panel, of: Any, given: float | None) -> float | None:
    """Return an end of the upright axis: the given one, or that of the marks."""
    if given is not None:
        return given
    ends = [
        float(of(content))
        for mark in panel.marks
        for content in [mark.corners[..., 1] if isinstance(mark, Facets) else getattr(mark, "y", np.empty(0))]
        if np.size(content) and np.isfinite(content).all()
    ]
    return float(of(ends)) if ends else None


def _course(point: SolvedPoint, moment: int) -> tuple[Panel, ...]:
    """Return one answer over another along the history, and where this moment is on it."""
    for over, what in (*answer_of(point.problem).curves, ("depth", "force")):
        x, y = (np.atleast_1d(point.answers.get(name, np.zeros(0))) for name in (over, what))
        if x.size == y.size > moment and np.isfinite(x).all() and np.isfinite(y).all():
            along, of = series(over, x, type(point.solution)), series(what, y, type(point.solution))
            axes = PanelAxis.of(along, margin=BEYOND), PanelAxis.of(of, margin=BEYOND)
            title = f"{name_in_words(what)} over {name_in_words(over)}"
            return (Panel((Line(x, y), points(x[moment], y[moment], order=5.0)), *axes, title=title),)
    return ()


def _title(point: SolvedPoint, moments: Moments, moment: int) -> str:
    time = np.atleast_1d(point.answers.get("time", np.zeros(0)))
    at = f",  $t$ = {with_unit(float(time[moment]), 's')}" if time.size == moments.total else ""
    return f"{moment + 1} of {moments.total}{at}"
