"""Display of fits: parameters with their errors, doubts, and pictures of one curve."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any

import numpy as np

from winkler.fitting.outcome import Fit
from winkler.numerics.types import Array
from winkler.plot.fitting.fits import fit_panels
from winkler.plot.series import with_unit as number_text
from winkler.plot.viscoelastic.fits import relaxing_loop
from winkler.study.batch.fit_outcome import FitOutcome, Fitted, interval_of
from winkler.study.report import fit_tables
from winkler.study.report.examined.sections import further_figures, further_section
from winkler.study.report.figure import capital
from winkler.study.report.fit_report import figures_of_curves, figures_of_many, steps
from winkler.study.report.headline.advice import worst_doubt
from winkler.study.report.headline.section import doubt_line
from winkler.study.report.markup import badge, safe, with_fixed_units
from winkler.study.report.mathml import symbol
from winkler.study.report.page_parts import code_section, papers, trust
from winkler.values.errors import WinklerError
from winkler.values.validity import worst
from winkler.web.form.fit_form import key_in_words
from winkler.web.pictures.answer import method_pictures, sheet_of
from winkler.web.pictures.chart import chart
from winkler.web.pictures.curve_list import cards_of_many, curve_list, curve_names, overviews
from winkler.web.pictures.packing import packed
from winkler.web.pictures.replies import AnswerText, DrawnSheet, InteractivePicture, NamedNumber
from winkler.web.pictures.view import fitting

__all__ = ["drawn_points", "fit_pictures", "fit_sheets", "fit_text"]

MOST_POINTS = 3000
"""Most drawn points of a curve, evenly spaced."""
CURVE_CAPTION = (
    "Dots are measured, the line is the fitted law; below, the residuals, which should scatter without a trend."
)
METHOD_REMARK = "The pictures of the method show the fitted contact at the largest depth of the curve."


def fit_text(outcome: FitOutcome, text: str) -> AnswerText:
    """Return the fitted parameters as text."""
    count = len(outcome.fitted)
    several = len(outcome.results) > 1
    answers = [cards_of_many(outcome) if several else _cards(outcome), fit_tables.doubts(outcome)]
    body = [
        fit_tables.answers(outcome),
        further_section(outcome),
        steps(outcome),
        fit_tables.failures(outcome),
    ]
    return AnswerText(
        worst(outcome.validity).value,
        badge(outcome.validity),
        f"{''.join(answers)}<div class='whole'>{''.join(body)}</div>",
        trust(outcome.validity),
        papers(outcome.study.problem) + code_section(outcome.study, outcome.provenance.source or "fit.toml"),
        text,
        count if count > 1 else 0,
        0,
        doubt=doubt_line(worst_doubt(outcome.validity)),
        numbers=_numbers(outcome) if count == 1 else (),
        curves=curve_list(outcome) if several else "",
        labels=curve_names(outcome) if count > 1 else (),
    )


def _numbers(outcome: FitOutcome) -> tuple[NamedNumber, ...]:
    """Return the fitted parameters of one curve."""
    fit, free = outcome.fitted[0].fit, outcome.study.free
    words = {one.key: outcome.study.word(one.key) for one in free}
    return tuple(
        NamedNumber(key_in_words(one.key), words[one.key].symbol, words[one.key].unit or "", float(fit.value(one.path)))
        for one in free
    )


def _cards(outcome: FitOutcome) -> str:
    """Return the fitted parameters with their intervals as cards, and the first one in a sentence."""
    (result,), cards, lead = outcome.fitted, [], ""
    fit = result.fit
    for free in outcome.study.free:
        word = outcome.study.word(free.key)
        low, high = (number_text(end, word.unit) for end in interval_of(result, free))
        name = key_in_words(free.key).rpartition("› ")[2]
        found = number_text(fit.value(free.path), word.unit)
        lead = lead or f"{capital(name)} is {found}, with 95 % between {low} and {high}."
        cards.append(
            f'<div class="card"><div class="value">{safe(found)}</div>'
            f'<div class="name">{safe(name)} {symbol(word.symbol)}<br>'
            f"95 %: {with_fixed_units(f'{low} … {high}')}</div></div>"
        )
    return f'<p class="lead sought-line">{with_fixed_units(lead)}</p><div class="cards">{"".join(cards)}</div>'


def fit_pictures(outcome: FitOutcome, moment: int) -> tuple[Iterator[InteractivePicture], str]:
    """Return the interactive pictures of one of the curves, and a remark on all of them.

    Parameters
    ----------
    outcome
        Outcome of the fits.
    moment
        Index of the fitted curve.
    """
    result = outcome.fitted[moment]
    before = _overviews(outcome, moment) if len(outcome.results) > 1 else iter(())
    if not isinstance(result.fit, Fit):
        return itertools.chain(before, _relaxing(result)), ""
    try:
        contact = result.fit.model.solve()
    except WinklerError as error:
        return itertools.chain(before, (_curve(result),)), f"There are no pictures of the method: {error}"
    return itertools.chain(before, _elastic(result, contact)), METHOD_REMARK


def _overviews(outcome: FitOutcome, moment: int) -> Iterator[InteractivePicture]:
    for name, title, sentence, drawn in overviews(outcome, moment):
        yield InteractivePicture(name, title, sentence, packed(drawn))


def drawn_points(count: int) -> Array:
    """Return the indices of the drawn points of a curve."""
    return np.unique(np.linspace(0, count - 1, min(count, MOST_POINTS)).astype(int))


def _curve(result: Fitted) -> InteractivePicture:
    count = result.fit.curve.count
    some = f" Of {count} points {MOST_POINTS} are drawn." if count > MOST_POINTS else ""
    drawn = chart(*fit_panels(result.fit, drawn_points(count)))
    return InteractivePicture("fit", f"Curve and fit: {result.name}", f"{CURVE_CAPTION}{some}", packed(drawn))


def _elastic(result: Fitted, contact: Any) -> Iterator[InteractivePicture]:
    yield _curve(result)
    yield from method_pictures(contact, fitting(contact.pressed))


def _relaxing(result: Fitted) -> Iterator[InteractivePicture]:
    yield _curve(result)
    sentence = "Measured response; loading and unloading differ because the body relaxes."
    loop = chart(relaxing_loop(result.fit, drawn_points(result.fit.curve.count)))
    yield InteractivePicture("loop", "Force over depth", sentence, packed(loop))


def fit_sheets(outcome: FitOutcome) -> Iterator[DrawnSheet]:
    """Yield the figures of the report that are not interactive: many curves, depths, models, events and noise."""
    relaxing = not isinstance(outcome.fitted[0].fit, Fit)
    yield from map(sheet_of, figures_of_many(outcome))
    yield from map(sheet_of, further_figures(outcome))
    if relaxing or len(outcome.fitted) == 1:
        yield from (
            sheet_of(one) for one in figures_of_curves(outcome) if relaxing or not one.name.startswith("curve_")
        )
