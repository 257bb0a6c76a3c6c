"""Conduction in study files: every kind is read, written and described, solved and reported."""

from __future__ import annotations

import pytest

import winkler as wk
from winkler.study.batch.run import run
from winkler.study.chapters.conduction import CONDUCTION
from winkler.study.chapters.contents import formulas_of
from winkler.study.language.build import build, unbuild
from winkler.study.language.explain import example_study
from winkler.study.language.study import Study
from winkler.study.language.varied import Axis
from winkler.study.report.citing import cite
from winkler.study.report.figures import figures_of
from winkler.study.report.mathml import formula
from winkler.study.report.report import page

SILVER = wk.Elastic(83e9, 0.37)
BALL = wk.Foundation(wk.Paraboloid(2e-3), wk.HalfSpace.between(SILVER, SILVER))
METAL = wk.ElectricalConductor(15.9e-9, 3.8e-3)
FILMED = wk.ElectricalConductors(wk.Rod(METAL, 1e-3, 1e-2), METAL, wk.SurfaceFilm(1e-12))


@pytest.mark.parametrize("name", [*CONDUCTION.answers, *(name for slot in CONDUCTION.kinds.values() for name in slot)])
def test_every_kind_makes_a_study_that_has_an_answer(name):
    problem = build(example_study(name)["problem"], slot="problem")
    assert build(unbuild(problem), slot="problem") == problem
    solution = problem.solve()
    assert solution.validity
    assert cite(problem)
    assert all(formula(one.latex) for one in formulas_of(problem))
    assert formulas_of(problem)


def test_formulas_state_what_was_done():
    bare, filmed = wk.ElectricalConductors(METAL, METAL), FILMED
    plain = [one.says for one in formulas_of(wk.Constriction(wk.Indentation(BALL, wk.Force(1.0)), bare))]
    more = [one.says for one in formulas_of(wk.Constriction(wk.Indentation(BALL, wk.Force(1.0)), filmed))]
    assert any("(Barber)" in says for says in plain)
    assert not any("film" in says for says in plain)
    assert {"film", "rod"} <= {word for word in ("film", "rod") for says in more if word in says}
    soil = wk.Foundation(wk.Paraboloid(1e-2), wk.GradedHalfSpace.between(wk.PowerLawGraded(1e9, 1e-3, 0.3, 0.3)))
    graded = [one.says for one in formulas_of(wk.Constriction(wk.Indentation(soil, wk.Force(1.0)), bare))]
    assert any("for any elastic medium" in says for says in graded)


SWEPT = Study(
    "Relay",
    wk.Constriction(wk.Indentation(BALL, wk.Force(1.0)), FILMED),
    sweep=(Axis("problem.contact.load.force", (0.1, 1.0, 10.0)),),
)


def test_a_sweep_over_forces_is_tabled():
    outcome = run(SWEPT)
    expected = [
        wk.Constriction(wk.Indentation(BALL, wk.Force(force)), FILMED).solve().resistance for force in (0.1, 1.0, 10.0)
    ]
    assert outcome.answer("resistance")[:, 0] == pytest.approx(expected, rel=1e-12)
    assert outcome.word("resistance").unit == "ohm"


@pytest.mark.slow
def test_a_sweep_over_forces_is_drawn_and_reported():
    outcome = run(SWEPT)
    shown = figures_of(outcome)
    names = [one.name for one in shown]
    assert len(names) == len(set(names))
    assert {"answer_resistance", "answer_contact_resistance"} <= set(names)
    assert all(not one.missing for one in shown)
    text = page(outcome, shown)
    assert "Ω" in text
    assert "Holm" in text


def test_an_infinite_interface_is_written_as_that_word():
    table = example_study("thermal_interface")["problem"]
    table["conductors"]["interface"]["interface_conductance"] = "infinite"
    problem = build(table, slot="problem")
    assert problem.conductors.interface == wk.ThermalInterface()
    assert build(unbuild(problem), slot="problem") == problem
