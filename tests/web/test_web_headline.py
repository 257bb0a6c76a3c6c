"""The head of the app: as the report has it; `tests/study/test_every_kind.py` looks at that of each kind."""

from __future__ import annotations

import re

import pytest
import tomli_w
from headlines import first_of, head_of

from winkler.study.batch.run import run
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.explain import keys_of
from winkler.study.language.reading import parse_study
from winkler.study.report.report import page
from winkler.values.vocabulary import GLOSSARY
from winkler.web.form.form import initial_table
from winkler.web.pictures.words import symbol_html


def head(kind):
    return head_of(run(parse_study(tomli_w.dumps(initial_table(kind)))))


@pytest.mark.parametrize("kind", ["indentation", "equilibrium", "tangential", "line_friction_heating", "rough_contact"])
def test_the_report_begins_with_the_same_number(kind):
    outcome = run(parse_study(tomli_w.dumps(initial_table(kind))))
    assert first_of(page(outcome, ())) == head_of(outcome)


@pytest.mark.parametrize(
    ("kind", "beginning"),
    [
        ("yield_onset", "A body begins to yield at 13.96 N, 37 µm below the surface."),
        ("pull_off", "The contact pulls off at "),
    ],
)
def test_a_number_of_an_event_says_which(kind, beginning):
    """On the axis of Hertz's field p0 = 1.6128 strength where nu = 0.3; F = p0^3 pi^3 R^2 / (6 E*^2)."""
    assert head(kind)[1].startswith(beginning)


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
