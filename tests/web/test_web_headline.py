"""The head of the app for each kind: what was asked, in a sentence and in large letters, as the report has it."""

from __future__ import annotations

import html
import re

import numpy as np
import pytest
import tomli_w
from example_answers import COSTLY

from winkler.plot.series import name_in_words
from winkler.study.batch.run import run
from winkler.study.chapters.contents import answer_of
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.explain import keys_of
from winkler.study.language.reading import parse_study
from winkler.study.report.describe import inputs
from winkler.study.report.report import page
from winkler.values.readable import with_unit
from winkler.values.validity import Standing, worst
from winkler.values.vocabulary import GLOSSARY, word
from winkler.web.form.form import initial_table
from winkler.web.pictures.answer import answer_text
from winkler.web.pictures.moments import Moments
from winkler.web.pictures.words import symbol_html

MARK = r'(?: <span class="standing outside">do not use</span>)?'
CARD = re.compile(rf'<div class="card(?: sought)?"><div class="value">(.*?){MARK}</div>')
LEAD = re.compile(rf'<p class="(?:lead )?sought-line">(.*?){MARK}</p>')


def first_of(text):
    """Return the first large number of a page, and its sentence."""
    return html.unescape(CARD.search(text)[1]), html.unescape(LEAD.search(text)[1]).replace("\xa0", " ")


def check(kind):
    outcome = run(parse_study(tomli_w.dumps(initial_table(kind))))
    text = answer_text(outcome, "", Moments(), 0).answers
    large, sentence = first_of(text)
    # a newcomer meets the example of a kind first; "held_contacts" asks whether a model is to be used
    assert worst(outcome.validity) is not Standing.OUTSIDE or kind == "held_contacts", outcome.validity
    assert 'class="card sought"' in text
    point = outcome.points[0]
    given = {one.name for one in inputs(outcome.study)}
    headline = [name for name in answer_of(point.problem).headline if name in point.answers]
    for end in (large, *large.split(" … ")):
        assert end.removeprefix("−") in sentence or f"{large.split(' … ')[0]} and {large.split(' … ')[1]}" in sentence
    if kind == "held_contacts":
        assert large == point.solution.verdict in ("poroelastic", "viscoelastic", "cannot tell", "neither")
    elif headline:
        name = sorted(headline, key=lambda one: name_in_words(one) in given)[0]
        numbers = np.ravel(point.answers[name])
        last = numbers[~np.isnan(numbers)][-1]
        farthest = numbers[np.nanargmax(np.abs(numbers))]
        sought = float(last if last != 0.0 else farthest)
        percent = f"{100.0 * sought:.3g} %" if name.endswith("_share") else ""
        assert large == (percent or with_unit(sought, word(point.answer_type, name).unit))
    return outcome, large, sentence


@pytest.mark.few(20, slow=10)
@pytest.mark.parametrize("kind", [kind for kind in CATALOGUE["problem"] if kind not in COSTLY])
def test_each_kind_is_headed_by_what_was_asked(kind):
    check(kind)


@pytest.mark.few(0, slow=4)
@pytest.mark.parametrize("kind", sorted(COSTLY))
def test_the_kinds_that_take_long_are_headed_too(kind):
    check(kind)


@pytest.mark.parametrize("kind", ["indentation", "equilibrium", "tangential", "line_friction_heating", "rough_contact"])
def test_the_report_begins_with_the_same_number(kind):
    outcome, large, sentence = check(kind)
    assert first_of(page(outcome, ())) == (large, sentence)


@pytest.mark.parametrize(
    ("kind", "beginning"),
    [
        ("yield_onset", "A body begins to yield at 13.96 N, 37 µm below the surface."),
        ("pull_off", "The contact pulls off at "),
    ],
)
def test_a_number_of_an_event_says_which(kind, beginning):
    """On the axis of Hertz's field p0 = 1.6128 strength where nu = 0.3; F = p0^3 pi^3 R^2 / (6 E*^2)."""
    assert check(kind)[2].startswith(beginning)


def test_no_symbol_shows_a_word_of_its_code():
    """Symbols of the glossary and of all keys, as the app shows them: Greek letters and accents, not LaTeX names."""
    words = [
        *GLOSSARY.items(),
        *((key.name, key.word) for slot in CATALOGUE.values() for kind in slot for key in keys_of(kind)),
    ]
    texts = {symbol_html(one.symbol) for _, one in words}
    shown = {re.sub(r"<su[bp]>.*?</su[bp]>|<[^>]*>|_\S+", "", text) for text in texts}
    assert {text for text in shown if re.search(r"\\|[A-Za-z]{2}", text)} == {"tan δ", "∫ F ds", "Pe"}
    assert "a\u0307" in shown
