"""What stands first in a report and in the app: the number that was sought, for each kind of problem."""

from __future__ import annotations

import re
import typing

import pytest

from winkler.study.batch.outcome import number_names
from winkler.study.batch.run import run
from winkler.study.chapters.contents import answers
from winkler.study.language.catalogue import kinds
from winkler.study.language.reading import parse_study
from winkler.study.language.template import template
from winkler.study.report.tables import answer_section

WHOLE_CURVE = {"equilibrium"}
"""Where no single number is sought."""


def test_every_kind_has_a_headline_of_its_answers():
    wrong = {}
    for name, record in answers().items():
        numbers = number_names(typing.get_type_hints(kinds()[name].cls.solve)["return"])
        if bool(record.headline) == (name in WHOLE_CURVE) or not set(record.headline) <= set(numbers):
            wrong[name] = record.headline
    assert wrong == {}


def test_what_a_headline_says_is_made_of_answers():
    """Each clause belongs to a number of the headline, and names answers of the kind."""
    wrong = {}
    for name, record in answers().items():
        numbers = {*number_names(typing.get_type_hints(kinds()[name].cls.solve)["return"]), "contact_share"}
        named = {word for clause in record.says.values() for word in re.findall(r"{(\w+)", clause)}
        if not set(record.says) <= set(record.headline) or not named <= numbers:
            wrong[name] = record.says
    assert wrong == {}
    assert sum(bool(record.says) for record in answers().values()) > 30


@pytest.mark.few(1)
@pytest.mark.parametrize(
    ("kind", "sought", "value"),
    [
        ("friction_heating", "flash temperature", "195 K"),
        ("yield_onset", "force", "13.96 N"),
        ("tangential", "dissipation", "4.723 µJ"),
    ],
)
def test_the_sought_number_stands_first(kind, sought, value):
    """What was prescribed stands last; of a path the numbers are those at its end, and the sentence says so."""
    page = answer_section(run(parse_study(template(kind))))
    lead, _, page = page.partition("</p>")
    assert value in lead.replace("\xa0", " ")
    first, second = page.index('class="card sought"'), page.index('class="card"')
    assert first < page.index(value) < second
    assert first < page.index(sought, first) < second
    assert ("After 4 s the" in lead.replace("\xa0", " ")) == (kind == "tangential")
