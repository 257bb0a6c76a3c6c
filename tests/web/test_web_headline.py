"""The head of the app for each kind: what was asked, in a sentence and in large letters, as the report has it."""

from __future__ import annotations

import html
import re

import numpy as np
import pytest
import tomli_w

from winkler.plot.series import name_in_words
from winkler.readable import with_unit
from winkler.study.batch.run import run
from winkler.study.chapters.contents import answer_of
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.reading import parse_study
from winkler.study.report.describe import inputs
from winkler.study.report.report import page
from winkler.vocabulary import word
from winkler.web.form.form import initial_table
from winkler.web.pictures.answer import answer_text
from winkler.web.pictures.moments import Moments

LONG = {
    "friction_heating", "viscoelastic_indentation", "viscoelastic_impact", "viscoelastic_tangential", "map_stress",
    "simplified_rolling", "sliding_resistance", "transient_heating", "rolling_start", "reduced_friction", "seal",
    "viscoelastic_adhesion", "surface_rolling_start", "sliding_wear", "elliptic_wear", "fretting_wear",
    "reduction", "surface_tangential", "profile_pair_rolling", "surface_adhesion",
}  # fmt: skip
"""Kinds that take more than a second, most of it for compiling."""
CARD = re.compile(r'<div class="card sought"><div class="value">(.*?)</div>')
LEAD = re.compile(r'<p class="lead sought-line">(.*?)</p>')


def first_of(text):
    """Return the first large number of a page, and its sentence."""
    return html.unescape(CARD.search(text)[1]), html.unescape(LEAD.search(text)[1]).replace("\xa0", " ")


def check(kind):
    outcome = run(parse_study(tomli_w.dumps(initial_table(kind))))
    large, sentence = first_of(answer_text(outcome, "", Moments(), 0).answers)
    point = outcome.points[0]
    given = {one.name for one in inputs(outcome.study)}
    headline = [name for name in answer_of(point.problem).headline if name in point.answers]
    for end in (large, *large.split(" … ")):
        assert end in sentence or f"{large.split(' … ')[0]} and {large.split(' … ')[1]}" in sentence
    if kind == "held_contacts":
        assert large == point.solution.verdict in ("poroelastic", "viscoelastic", "cannot tell", "neither")
    elif headline:
        name = sorted(headline, key=lambda one: name_in_words(one) in given)[0]
        numbers = np.ravel(point.answers[name])
        last = numbers[~np.isnan(numbers)][-1]
        farthest = numbers[np.nanargmax(np.abs(numbers))]
        assert large == with_unit(float(last if last != 0.0 else farthest), word(point.answer_type, name).unit)
    return outcome, large, sentence


@pytest.mark.parametrize("kind", [kind for kind in CATALOGUE["problem"] if kind not in LONG])
def test_each_kind_is_headed_by_what_was_asked(kind):
    check(kind)


@pytest.mark.slow
@pytest.mark.parametrize("kind", sorted(LONG))
def test_the_kinds_that_take_long_are_headed_too(kind):
    check(kind)


@pytest.mark.parametrize("kind", ["indentation", "equilibrium", "tangential", "line_friction_heating", "rough_contact"])
def test_the_report_begins_with_the_same_number(kind):
    outcome, large, sentence = check(kind)
    assert first_of(page(outcome, ())) == (large, sentence)
