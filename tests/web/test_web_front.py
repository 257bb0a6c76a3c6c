"""The examples with which the app begins are sound studies of the kinds that their cards name."""

from __future__ import annotations

import math

import pytest
import tomli_w

from winkler.study.batch.run import run
from winkler.study.finding.finding import find
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.fit_reading import parse_fit_study
from winkler.study.language.reading import parse_study
from winkler.values.validity import Standing, worst
from winkler.web.form import form
from winkler.web.form.front_examples import FRONT_EXAMPLES, QUESTIONS, first_table
from winkler.web.form.sample_curve import SAMPLE, sample_curve
from winkler.web.page.question import _chapters


def test_the_first_study_is_a_ball_of_steel_on_steel():
    """d = (9 F^2 / 16 R E*^2)^(1/3), E* = E / 2(1 - nu^2), up to what a ball differs from a paraboloid."""
    depth = float(run(parse_study(tomli_w.dumps(first_table()))).points[0].answers["depth"][0])
    modulus = 210e9 / (2.0 * (1.0 - 0.3**2))
    assert depth == pytest.approx(math.cbrt(9.0 * 100.0**2 / (16.0 * 10e-3 * modulus**2)), rel=1e-4)


@pytest.mark.few(3, slow=2)
@pytest.mark.parametrize("one", [one for one in FRONT_EXAMPLES if one.kind != "fit"], ids=lambda one: one.title)
def test_each_example_is_answered(one):
    outcome = run(parse_study(tomli_w.dumps(one.table)))
    assert not outcome.failed
    assert worst(outcome.validity) is not Standing.OUTSIDE
    assert one.question.endswith("?")


def test_each_question_has_its_problem():
    """The search in the list finds it by the same question."""
    asked = {one.title: one.kind for one in QUESTIONS}
    assert len(asked) == 8
    for title, kind in asked.items():
        assert kind in [hit.name for hit in find(title).hits], title


def test_the_curve_to_fit_is_there(tmp_path):
    (tmp_path / SAMPLE).write_bytes(sample_curve())
    (one,) = (one for one in FRONT_EXAMPLES if one.kind == "fit")
    assert len(parse_fit_study(tomli_w.dumps(one.table), folder=tmp_path).free) == 3


def test_each_kind_has_a_chapter():
    """Kinds of one chapter stand together."""
    chapters = _chapters()
    assert set(chapters) == set(CATALOGUE["problem"])
    order = list(chapters.values())
    assert sum(before != after for before, after in zip(order, order[1:], strict=False)) == len(set(order)) - 1


def test_a_body_that_is_left_out_is_called_rigid():
    whole = form.part_of(form.initial_table("indentation"), "problem.bed.medium")
    (second,) = (child for child in whole.children if isinstance(child, form.Slot) and child.label == "second")
    assert (second.part, second.otherwise) == (None, "rigid")
