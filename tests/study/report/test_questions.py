"""Questions about unlikely numbers, and numbers that are not to be trusted."""

from __future__ import annotations

import pytest

import winkler as wk
from winkler.study.batch.run import run
from winkler.study.language.study import Study
from winkler.study.report.headline.questions import questions_of
from winkler.study.report.headline.section import headline_section
from winkler.study.report.report import page

STEEL = wk.Elastic(210e9, 0.3)
MEDIUM = wk.HalfSpace.between(STEEL, STEEL)


def outcome(problem):
    return run(Study("a study", problem))


def asked(problem):
    return questions_of(outcome(problem))


def ball(radius=10e-3, medium=MEDIUM):
    return wk.Foundation(wk.Paraboloid(radius), medium)


def test_a_coefficient_of_friction_in_per_cent():
    heated = wk.Torsion(ball(), wk.Coulomb(60.0), wk.Path.through(wk.Force([100.0, 100.0]), wk.Angle([0.0, 1e-4])))
    assert asked(heated) == (
        "The coefficient is 60, and dry solids have coefficients of friction of 0.05 to 1.5: did you mean 0.6?",
    )


def test_a_wheel_in_millimetres():
    (question,) = asked(wk.Indentation(ball(460.0), wk.Force(100.0)))
    assert question.endswith("did you mean 460 mm?")


def test_a_work_of_adhesion_in_millijoules():
    (question,) = asked(wk.AdhesiveIndentation(ball(), wk.ShortRange(50.0), wk.Force(0.0)))
    assert question.endswith("did you mean 50 mJ/m²?")


@pytest.mark.parametrize(("groove", "count"), [(5.2e-3, 1), (-5.2e-3, 0)])
def test_a_raceway_with_its_sign_forgotten(groove, count):
    questions = asked(wk.EllipticIndentation(wk.CurvedPair(5e-3, 5e-3, 26e-3, groove), MEDIUM, wk.Force(2000.0)))
    assert len(questions) == count
    assert all("whose radius is negative?" in question for question in questions)


def test_usual_numbers_and_soft_bodies_are_not_asked_about():
    rubber = wk.HalfSpace(wk.Elastic(1e6, 0.5))
    assert asked(wk.Indentation(ball(5e-3), wk.Force(100.0))) == ()
    assert asked(wk.AdhesiveIndentation(ball(5e-3, rubber), wk.ShortRange(0.05), wk.Force(0.0))) == ()
    assert asked(wk.EllipticIndentation(wk.CurvedPair(5e-3, 5e-3, 26e-3, 5e-3), rubber, wk.Force(1.0))) == ()


def test_a_question_stands_in_the_report():
    text = page(outcome(wk.Indentation(ball(460.0), wk.Force(100.0))), ())
    assert 'class="question">The curvature radius is 460 m' in text


@pytest.mark.parametrize(("speed", "marked"), [(2.0, True), (1e-3, False)])
def test_the_restitution_of_bodies_that_yield_is_marked_where_it_stands(speed, marked):
    """At 2 m/s a ball of 2.5 mm begins to yield at 10 N of 247 N; elastic springs still give back everything."""
    strong = wk.Elastic(210e9, 0.3, strength=1e9)
    bed = wk.Foundation(wk.Sphere(2.5e-3), wk.HalfSpace.between(strong, strong))
    text = headline_section(outcome(wk.Impact(bed, wk.Coulomb(0.3), mass=0.5e-3, velocity=speed, count=21)))
    assert ('<div class="value">1 <span class="standing outside">do not use</span></div>' in text) == marked
    assert ('class="card sought"' in text) != marked
