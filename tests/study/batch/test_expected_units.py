"""An expected number has the unit of the answer in its own problem."""

from __future__ import annotations

import pytest
from example_answers import example_problem

from winkler.cli import main
from winkler.study.batch.outcome import number_names
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.compared.expected_units import solution_types, unit_of_quantity
from winkler.values.errors import InvalidInput
from winkler.values.vocabulary import word


@pytest.mark.slow
@pytest.mark.parametrize(("unit", "code"), [("K/W", 0), ("ohm", 2)])
def test_a_thermal_resistance_is_in_kelvin_per_watt_and_not_in_ohm(shared_data, tmp_path, capsys, unit, code):
    text = (shared_data / "reported/expect_thermal_resistance/h1_glass_beads.toml").read_text(encoding="utf-8")
    study = tmp_path / "beads.toml"
    study.write_text(text.replace("K/W", unit), encoding="utf-8")
    assert main(["run", str(study), "--output", str(tmp_path / "beads"), "--quiet"]) == code
    assert ("K/W" in capsys.readouterr().err) == (code == 2)


@pytest.mark.slow
def test_each_answer_of_each_problem_is_expected_in_its_own_unit():
    wrong, seen = {}, 0
    for kind in CATALOGUE["problem"]:
        problem = example_problem(kind)
        for solution in solution_types(type(problem)):
            for name in number_names(solution):
                seen += 1
                if unit_of_quantity(name, problem) != word(solution, name).unit:
                    wrong[kind, name] = unit_of_quantity(name, problem)
    assert wrong == {}
    assert seen > 700


def test_a_path_ends_in_the_unit_of_its_owner():
    problem = example_problem("thermal_constriction")
    assert unit_of_quantity("problem.temperature_drop", problem) == "K"
    assert unit_of_quantity("problem.bed.medium.first.young", problem) == "Pa"
    assert unit_of_quantity("resistance.-1", problem) == "K/W"
    assert unit_of_quantity("resistance") == "ohm"


def test_a_name_that_nothing_answers_is_refused_with_the_nearest():
    with pytest.raises(InvalidInput, match="'resistence'.*resistance"):
        unit_of_quantity("resistence", example_problem("thermal_constriction"))
