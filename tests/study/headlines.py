"""The head of the app and of a report: what was asked, in a sentence and in large letters."""

from __future__ import annotations

import html
import re
from collections.abc import Iterator
from typing import Any

import numpy as np

from winkler.plot.series import name_in_words
from winkler.study.chapters.contents import answer_of
from winkler.study.report.describe import inputs
from winkler.values.readable import with_unit
from winkler.values.validity import Standing, worst
from winkler.values.vocabulary import word
from winkler.web.pictures.answer import answer_text
from winkler.web.pictures.moments import Moments

MARK = r'(?: <span class="standing outside">do not use</span>)?'
CARD = re.compile(rf'<div class="card(?: sought)?"><div class="value">(.*?){MARK}</div>')
LEAD = re.compile(rf'<p class="(?:lead )?sought-line">(.*?){MARK}</p>')


def first_of(text: str) -> tuple[str, str]:
    """Return the first large number of a page, and its sentence."""
    return html.unescape(CARD.search(text)[1]), html.unescape(LEAD.search(text)[1]).replace("\xa0", " ")


def head_of(outcome: Any) -> tuple[str, str]:
    """Return the large number and the sentence with which the app answers."""
    return first_of(answer_text(outcome, "", Moments(), 0).answers)


def headline_mistakes(kind: str, outcome: Any) -> Iterator[str]:
    """Yield what is wrong with the head of the example of a kind, which its large number and its sentence are."""
    large, sentence = head_of(outcome)
    # a newcomer meets the example of a kind first; "held_contacts" asks whether a model is to be used
    if worst(outcome.validity) is Standing.OUTSIDE and kind != "held_contacts":
        yield f"not to be used: {outcome.validity}"
    if 'class="card sought"' not in answer_text(outcome, "", Moments(), 0).answers:
        yield "nothing is marked as what was asked"
    point = outcome.points[0]
    given = {one.name for one in inputs(outcome.study)}
    headline = [name for name in answer_of(point.problem).headline if name in point.answers]
    ends = large.split(" … ")
    if not all(end.removeprefix("−") in sentence or " and ".join(ends) in sentence for end in (large, *ends)):
        yield f"{large!r} is not in {sentence!r}"
    if kind == "held_contacts":
        if large != point.solution.verdict or large not in ("poroelastic", "viscoelastic", "cannot tell", "neither"):
            yield f"{large!r} is no verdict"
    elif headline:
        name = sorted(headline, key=lambda one: name_in_words(one) in given)[0]
        numbers = np.ravel(point.answers[name])
        last = numbers[~np.isnan(numbers)][-1]
        farthest = numbers[np.nanargmax(np.abs(numbers))]
        sought = float(last if last != 0.0 else farthest)
        percent = f"{100.0 * sought:.3g} %" if name.endswith("_share") else ""
        if large != (percent or with_unit(sought, word(point.answer_type, name).unit)):
            yield f"{large!r} is not {name}, {sought}"
