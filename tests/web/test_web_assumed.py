"""Whose a number of the form is: the user's, or an example's."""

from __future__ import annotations

import copy

import pytest
import tomli_w

from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.reading import parse_study
from winkler.web.form import form
from winkler.web.form.carry import leaves
from winkler.web.form.link import code_of, study_of
from winkler.web.form.study_form import StudyForm
from winkler.web.form.taken import assumed_in, taken, with_assumed

PROFILE, FIRST, FORCE = "problem.bed.profile", "problem.bed.medium.first", "problem.load.force"


@pytest.fixture
def entered():
    return StudyForm(lambda: None, lambda: None)


def test_a_number_is_the_users_once_it_is_typed(entered):
    assert entered.is_assumed(FORCE)
    assert entered.assumed_sentence.startswith("Not yours, but an example's: ")
    entered.change(FORCE, "12 N", "one number")
    assert not entered.is_assumed(FORCE)
    assert "12 N" not in entered.assumed_sentence
    assert entered.is_assumed(f"{FIRST}.young")


def test_what_comes_with_a_kind_that_is_chosen_is_the_examples(entered):
    entered.load(dict(entered.table))
    assert entered.assumed_sentence == ""
    entered.choose(PROFILE, "cone")
    assert entered.still_assumed == {f"{PROFILE}.half_angle": form.at(entered.table, f"{PROFILE}.half_angle")}
    assert entered.assumed_sentence.startswith("Not yours, but an example's: half angle ")
    entered.change(f"{PROFILE}.half_angle", "61 deg", "one number")
    assert entered.assumed_sentence == ""
    entered.choose(PROFILE, "cone")
    assert entered.assumed_sentence == ""


def test_a_link_carries_what_was_assumed(entered, tmp_path):
    entered.change(FORCE, "12 N", "one number")
    text = study_of(code_of(with_assumed(tomli_w.dumps(entered.table), entered.still_assumed)))
    parse_study(text)
    other = StudyForm(lambda: None, lambda: None)
    other.load(taken(text, tmp_path), assumed_in(text))
    assert other.table == entered.table
    assert other.still_assumed == entered.still_assumed
    assert not other.is_assumed(FORCE)


def test_a_study_of_a_file_is_the_users(entered, tmp_path):
    text = tomli_w.dumps(entered.table)
    assert assumed_in(text) == ()
    entered.load(taken(text, tmp_path), assumed_in(text))
    assert entered.still_assumed == {}
    assert with_assumed(text, entered.still_assumed) == text


def test_unknown_paths_of_an_address_are_nothing(entered, tmp_path):
    text = with_assumed(tomli_w.dumps(entered.table), ["problem.load", "problem.x.0.9", "..", FORCE])
    entered.load(taken(text, tmp_path), assumed_in(text))
    assert set(entered.still_assumed) == {FORCE}


def test_an_edited_text_makes_only_its_changes_the_users(entered):
    table = copy.deepcopy(entered.table)
    form.put(table, f"{FIRST}.young", "70 GPa")
    before = entered.still_assumed
    entered.load_edited(table)
    assert entered.still_assumed.keys() == before.keys() - {f"{FIRST}.young"}


def test_the_number_of_an_example_is_the_users_once_he_typed_it(entered):
    number = form.at(entered.table, FORCE)
    entered.change(FORCE, "12 N", "one number")
    entered.change(FORCE, number, "one number")
    assert not entered.is_assumed(FORCE)


def test_numbers_of_a_named_material_are_the_materials(entered):
    entered.choose(FIRST, "named_elastic")
    assert entered.is_assumed(f"{FIRST}.name")
    entered.change(f"{FIRST}.name", "tungsten", "text")
    assert not entered.is_assumed(f"{FIRST}.name")
    entered.choose(FIRST, "elastic")
    assert form.at(entered.table, FIRST) == {"kind": "elastic", "young": "411 GPa", "poisson": 0.28}
    assert not entered.is_assumed(f"{FIRST}.young")


def test_a_range_that_nobody_has_given_is_said_and_goes_with_the_link(entered, tmp_path):
    entered.vary(FORCE)
    assert entered.is_assumed(f"sweep.{FORCE}")
    assert "force from 50 N to 200 N" in entered.assumed_sentence
    other = StudyForm(lambda: None, lambda: None)
    text = with_assumed(tomli_w.dumps(entered.table), entered.still_assumed)
    other.load(taken(text, tmp_path), assumed_in(text))
    assert other.still_assumed == entered.still_assumed
    entered.vary_over(FORCE, "even", {"from": "10 N", "to": "200 N", "count": "5"}, anew=False)
    assert not entered.is_assumed(f"sweep.{FORCE}")


@pytest.mark.parametrize("kind", CATALOGUE["problem"])
def test_all_of_the_example_of_a_kind_is_an_examples(entered, kind):
    entered.table["problem"]["kind"] = kind
    entered.take_example()
    assert entered.still_assumed == leaves(entered.table["problem"])
