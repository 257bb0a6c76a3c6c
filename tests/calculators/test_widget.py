"""The sliders in a notebook: values, numbers and the study, without a browser."""

from __future__ import annotations

from importlib.util import find_spec

import pytest

import winkler
from winkler.calculators.catalogue import CALCULATORS, calculator
from winkler.calculators.evaluate import answer_of, study_text_of, values_of
from winkler.study.language.reading import parse_study
from winkler.values.errors import InvalidInput


@pytest.mark.few(3)
@pytest.mark.parametrize("one", CALCULATORS, ids=lambda one: one.name)
def test_the_kept_tables_give_the_digits_of_the_package(one):
    """One place off the beginning; the browser tests go through all ranges."""
    values = {s.name: float(f"{s.start + 0.07 * (s.high - s.start):.4g}") for s in one.sliders}
    solution = parse_study(study_text_of(one, values)).problem.solve()
    for number, found in zip(one.numbers, answer_of(one, values).values(), strict=True):
        true = float(eval(f"solution.{number.path}", {"solution": solution}))
        assert found == pytest.approx(true, rel=1e-9, abs=0.0), number.name


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        (
            {"wrk": 1.0},
            "widget: adhesion has no slider 'wrk'; give some of curvature_radius, young, poisson, work, pull.",
        ),
        ({"work": 0.5}, r"widget: work is 0.5 mJ/m\^2; give a number from 1 to 10000 mJ/m\^2."),
    ],
)
def test_wrong_values_are_refused(given, sentence):
    with pytest.raises(InvalidInput, match=sentence):
        values_of(calculator("adhesion"), given)


def test_a_calculator_that_is_not_there():
    with pytest.raises(InvalidInput, match="'torsoin' is not known .did you mean 'torsion'"):
        winkler.widget("torsoin")


def test_the_value_follows_the_sliders():
    if find_spec("anywidget") is None:
        pytest.skip("no anywidget here: pip install winkler[widget]")
    shown = winkler.widget("tangential", share=0.5)
    assert "coefficient = 0.3" in shown.value
    before = shown.answer["shift"]
    shown.values = {**shown.values, "coefficient": 0.6}
    assert shown.answer["shift"] == pytest.approx(2.0 * before, rel=1e-12)
    assert parse_study(shown.value).problem.law.coefficient == 0.6
    heard = []
    shown.observe(lambda change: heard.append(change["new"]), "value")
    shown.set_state({"values": {**shown.values, "share": 0.75}})  # as the browser does
    assert len(heard) == 1
    assert parse_study(heard[0]).problem.path.lateral.shear_force[-1] == pytest.approx(0.75 * 0.6 * 100.0)
    with pytest.raises(InvalidInput, match="give a number from"):
        shown.values = {**shown.values, "share": 2.0}
