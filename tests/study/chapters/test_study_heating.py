"""Frictional heating in study files: kinds, units, tables, formulas, papers, and what is refused."""

import numpy as np
import pytest

from winkler.study.batch.outcome import answers_of
from winkler.study.batch.run import run
from winkler.study.chapters.contents import formulas_of
from winkler.study.language.build import build, unbuild
from winkler.study.language.explain import example_study
from winkler.study.language.reading import parse_study
from winkler.study.report.citing import cite
from winkler.study.report.mathml import formula
from winkler.values.errors import InvalidInput

TEXT = """title = "Rubbing"

[problem]
kind = "friction_heating"
law = { kind = "coulomb", coefficient = 0.3 }
load = { kind = "force", force = "20 N" }
first_speed = ["1 cm/s", "1 m/s"]
partition = { kind = "equal_mean" }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }

[problem.bed.medium]
kind = "half_space"
first = { kind = "elastic", young = "210 GPa", poisson = 0.3 }

[problem.conductors]
kind = "heat_conductors"
first = { kind = "thermal_conductor", conductivity = "45 W/(m K)", diffusivity = "12 mm^2/s" }
second = { kind = "thermal_conductor", conductivity = "45 W/(m K)", diffusivity = "12 mm^2/s" }
"""


def test_many_speeds_in_one_study():
    outcome = run(parse_study(TEXT))
    columns = {column.name: column for column in outcome.table()}
    assert columns["flash_temperature"].word.unit == "K"
    assert columns["flash_temperature"].content.shape == (2,)
    np.testing.assert_allclose(
        columns["first_mean_temperature"].content, columns["second_mean_temperature"].content, rtol=1e-12
    )
    assert {"heat_rate", "radius", "first_share", "first_peclet", "overestimate"} <= set(columns)
    assert "not the temperatures at every point" in " ".join(note.statement for note in outcome.validity)


@pytest.mark.parametrize("kind", ["friction_heating", "transient_heating", "fretting_heat"])
def test_the_example_is_a_problem_with_formulas_and_papers(kind):
    problem = build(example_study(kind)["problem"], "problem")
    assert build(unbuild(problem), "problem") == problem
    text = formulas_of(problem)
    assert len(text) > 3
    for one in text:
        assert formula(one.latex).startswith("<math")
    assert "jaeger_1942" in {paper.key for paper in cite(problem)}


def test_fretting_answers_with_numbers_of_one_cycle():
    problem = build(example_study("fretting_heat")["problem"], "problem")
    answers = answers_of(problem.solve())
    assert {"heat_rate", "loss_per_cycle", "max_temperature", "mean_temperature", "swing"} <= set(answers)
    assert all(np.ndim(number) == 0 for number in answers.values())


@pytest.mark.parametrize(
    ("old", "new", "text"),
    [
        ('["1 cm/s", "1 m/s"]', '"1 m"', "is a length, not a speed"),
        ('diffusivity = "12 mm^2/s"', 'diffusivity = "12 m/s"', "diffusivity"),
        ('"equal_mean"', '"equal_means"', "equal_mean"),
        ('{ kind = "equal_mean" }', '{ kind = "fixed_share", first_share = 2.0 }', "from 0 to 1"),
        ("coefficient = 0.3", "coefficient = -0.3", "law.coefficient is -0.3"),
    ],
)
def test_what_a_study_is_stated(old, new, text):
    with pytest.raises(InvalidInput, match=text):
        parse_study(TEXT.replace(old, new, 1))
