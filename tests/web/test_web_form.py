"""Forms are trees made from the catalogue: every kind has one, and what it shows is the study."""

from __future__ import annotations

import pytest
import tomli_w

from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.reading import parse_study
from winkler.study.language.template import whole_text
from winkler.web.form import form
from winkler.web.form.form import FormEntry, Many, Slot
from winkler.web.form.typed import typed


def entries(part):
    for child in part.children:
        if isinstance(child, FormEntry):
            yield child
        elif isinstance(child, Slot) and child.part:
            yield from entries(child.part)
        elif isinstance(child, Many):
            for inside in child.parts:
                yield from entries(inside)


@pytest.mark.parametrize("kind", list(CATALOGUE["problem"]))
def test_what_a_form_shows_is_the_study(kind):
    """Typing every text of a form anew gives the study that the command line begins with."""
    table = form.initial_table(kind)
    shown = list(entries(form.part_of(table)))
    for entry in shown:
        if entry.text:
            form.put(table, entry.path, typed(entry.text, entry.takes))
    problem = parse_study(tomli_w.dumps(table)).problem
    assert problem == parse_study(whole_text(kind)).problem
    assert all(entry.hint for entry in shown)
    assert all(entry.text for entry in shown if entry.required)


@pytest.mark.parametrize("kind", list(CATALOGUE["profile"]))
def test_every_profile_can_be_chosen(kind):
    table = form.initial_table("indentation")
    form.choose_kind(table, "problem.bed.profile", kind)
    assert form.at(table, "problem.bed.profile.kind") == kind
    assert form.part_of(table, "problem.bed.profile").kind == kind


def test_numbers_with_the_same_name_stay():
    table = form.initial_table("indentation")
    form.put(table, "problem.bed.profile.curvature_radius", "3 mm")
    form.choose_kind(table, "problem.bed.profile", "paraboloid")
    assert form.at(table, "problem.bed.profile") == {"kind": "paraboloid", "curvature_radius": "3 mm"}
    form.choose_kind(table, "problem.bed.profile", "cone")
    assert set(form.at(table, "problem.bed.profile")) == {"kind", "half_angle"}


def test_a_file_stands_for_the_numbers():
    table = form.initial_table("indentation")
    form.put(table, "problem.bed.profile", {"kind": "measured", "file": "tip.csv"})
    part = form.part_of(table, "problem.bed.profile")
    assert part.takes_file
    assert part.file == "tip.csv"
    assert {"radii", "heights"}.isdisjoint(child.path.rpartition(".")[2] for child in part.children)


def test_parts_of_lists_are_added_and_taken_away():
    table = form.initial_table("tangential")
    assert [step["kind"] for step in form.at(table, "problem.path.steps")] == ["start", "ramp", "oscillate", "hold"]
    form.drop(table, "problem.path.steps.1")
    assert [step["kind"] for step in form.at(table, "problem.path.steps")] == ["start", "oscillate", "hold"]
    form.drop(table, "problem.bed.medium.second")  # was left out already
    assert form.at(table, "problem.bed.medium.second") is None
    assert form.at(table, "problem.path.steps.7.kind") is None


@pytest.mark.parametrize(
    ("sentence", "path"),
    [
        ("problem.bed.profile.curvature_radius is -1 m; give more.", "problem.bed.profile.curvature_radius"),
        ("problem.bed: the two do not fit.", "problem.bed"),
        ("problem.path.steps[2].lateral.shift is 'x'.", "problem.path.steps.2.lateral.shift"),
        ("problem.load has no 'force' (normal force); add it.", "problem.load.force"),
        ("the loads are too great.", ""),
    ],
)
def test_whose_mistake_it_is(sentence, path):
    assert form.owner_of(sentence) == path
