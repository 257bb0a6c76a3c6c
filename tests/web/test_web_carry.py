"""Another question for the same bodies: what fits stays, and the sentence says what does not."""

from __future__ import annotations

import copy

import pytest
import tomli_w

from winkler.study.chapters.contents import CHAPTERS
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.reading import parse_study
from winkler.web.form import form
from winkler.web.form.carry import leaves
from winkler.web.form.front_examples import FRONT_EXAMPLES
from winkler.web.form.study_form import StudyForm

PROFILE, FIRST, LOAD = "problem.bed.profile", "problem.bed.medium.first", "problem.load"
QUESTIONS = [kind for chapter in CHAPTERS for kind in chapter.answers]
RUBBER = {"kind": "elastic", "young": "3 MPa", "poisson": 0.49}
TIP = {"kind": "sphere", "curvature_radius": "7 mm"}


@pytest.fixture
def entered():
    """A ball of 7 mm on rubber under 2 N."""
    study = StudyForm(lambda: None, lambda: None)
    form.put(study.table, PROFILE, dict(TIP))
    form.put(study.table, FIRST, dict(RUBBER))
    form.put(study.table, LOAD, {"kind": "force", "force": "2 N"})
    return study


def bodies(study):
    bed = form.at(study.table, "problem.bed") or form.at(study.table, "problem.contact.bed")
    medium = bed["medium"]
    return bed["profile"], *({**medium[body], "strength": ""} for body in ("first", "second"))


@pytest.mark.parametrize("question", ["yield_onset", "tangential", "friction_heating", "constriction", "impact"])
def test_no_question_changes_the_bodies_of_the_first_page(question):
    study = StudyForm(lambda: None, lambda: None)
    before = bodies(study)
    study.choose("problem", question)
    assert bodies(study) == before
    study.choose("problem", "indentation")
    assert bodies(study) == before


@pytest.fixture
def typed():
    """The first page with two bodies, a radius and a force that somebody has typed."""
    study = StudyForm(lambda: None, lambda: None)
    for path, text in (
        (f"{FIRST}.young", "70 GPa"),
        ("problem.bed.medium.second.young", "71 GPa"),
        (f"{PROFILE}.curvature_radius", "7 mm"),
        (f"{LOAD}.force", "33 N"),
    ):
        study.change(path, text, "one number")
    return study


def through(study, *questions):
    """Ask other questions and the first one again; return what differs, and whose number has changed its owner."""
    before, assumed = copy.deepcopy(study.table["problem"]), study.still_assumed
    for question in (*questions, before["kind"]):
        study.choose("problem", question)
    now, was = leaves(study.table["problem"]), leaves(before)
    changed = {path for path in now.keys() | was.keys() if now.get(path) != was.get(path)}
    return changed | (study.still_assumed.keys() ^ assumed.keys())


@pytest.mark.few(24)
@pytest.mark.parametrize("question", QUESTIONS)
def test_every_question_gives_back_what_was_typed(typed, question):
    assert through(typed, question) == set()


@pytest.mark.few(8)
@pytest.mark.parametrize("question", QUESTIONS)
def test_two_questions_give_back_what_was_typed(typed, question):
    other = QUESTIONS[(7 * QUESTIONS.index(question) + 31) % len(QUESTIONS)]
    assert through(typed, question, other) == set()


@pytest.mark.parametrize("question", ["map_stress", "elastic_plastic_particle"])
def test_a_solid_is_the_body_below(typed, question):
    typed.choose("problem", question)
    assert form.at(typed.table, "problem.solid.young") == "70 GPa"
    assert "problem.solid.young" not in typed.assumed


def test_a_strength_that_came_with_a_question_goes_with_it(typed):
    """Typed it is the user's, and stays."""
    for question in ("yield_onset", "line_yield_onset", "indentation"):
        typed.choose("problem", question)
    assert "strength" not in form.at(typed.table, FIRST)
    typed.choose("problem", "yield_onset")
    typed.change(f"{FIRST}.strength", "650 MPa", "one number")
    typed.choose("problem", "indentation")
    assert form.at(typed.table, FIRST)["strength"] == "650 MPa"
    assert not typed.is_assumed(f"{FIRST}.strength")


def test_a_part_of_another_kind_gives_way_to_the_former_one(typed):
    """Of a sphere a line keeps the radius, in a parabola; what is typed there goes back into the sphere."""
    typed.choose("problem", "line_rolling")
    assert form.at(typed.table, PROFILE) == {"kind": "paraboloid", "curvature_radius": "7 mm"}
    typed.change(f"{PROFILE}.curvature_radius", "9 mm", "one number")
    typed.choose("problem", "indentation")
    assert form.at(typed.table, PROFILE) == {"kind": "sphere", "curvature_radius": "9 mm"}


def test_a_new_load_goes_to_the_former_path(typed):
    """The path comes back, but with the force of today; what nobody has given of it is still nobody's."""
    typed.choose("problem", "tangential")
    typed.change("problem.path.steps.2.lateral.shift", "0.7 um", "one number")
    typed.choose("problem", "indentation")
    assert form.at(typed.table, f"{LOAD}.force") == "33 N"
    typed.change(f"{LOAD}.force", "40 N", "one number")
    typed.choose("problem", "tangential")
    assert form.at(typed.table, "problem.path.steps.0.normal.force") == "40 N"
    assert form.at(typed.table, "problem.path.steps.2.lateral.shift") == "0.7 um"
    assert not typed.is_assumed("problem.path.steps.2.lateral.shift")
    assert typed.is_assumed("problem.path.steps.2.cycles")


def test_an_example_begins_anew(typed):
    """What was put aside of one study does not come into an example that is taken later."""
    typed.choose("problem", "elliptic_indentation")
    typed.begin_with(FRONT_EXAMPLES[-1].table)
    typed.choose("problem", "indentation")
    assert form.at(typed.table, PROFILE) != {"kind": "sphere", "curvature_radius": "7 mm"}


def test_another_kind_of_a_part_gives_back_the_former_one(typed):
    for path, kind, former in ((PROFILE, "cone", "sphere"), ("problem.bed.medium", "coated_half_space", "half_space")):
        before = copy.deepcopy(typed.content(path))
        assumed = typed.still_assumed.keys() - {f"{path}.kind"}
        typed.choose(path, kind)
        assert typed.content(path) != before
        typed.choose(path, former)
        assert typed.content(path) == before
        assert typed.still_assumed.keys() == assumed
    second = copy.deepcopy(typed.content("problem.bed.medium.second"))
    typed.choose("problem.bed.medium.second", "")
    typed.choose("problem.bed.medium.second", "elastic")
    assert typed.content("problem.bed.medium.second") == second


def test_each_task_has_its_own_numbers(typed):
    """Nothing that was put aside of a problem comes into the model of a curve."""
    before, assumed = copy.deepcopy(typed.table), typed.still_assumed
    typed.choose("problem", "elliptic_indentation")
    typed.switch_task("fit")
    assert typed.still_assumed == leaves(typed.table["problem"])
    assert "curvature radius 5 um" in typed.assumed_sentence
    assert "Young" not in typed.assumed_sentence  # free: the curve decides
    typed.choose("problem", "adhesive_indentation")
    assert typed.is_assumed(f"{PROFILE}.curvature_radius")
    typed.switch_task("solve")
    typed.choose("problem", "indentation")
    assert typed.table["problem"] == before["problem"]
    assert typed.still_assumed == assumed


def test_numbers_of_the_example_are_said():
    study = StudyForm(lambda: None, lambda: None)
    study.choose("problem", "yield_onset")
    assert study.carried_remark.endswith("Of the example: strength 700 MPa.")
    assert study.assumed[f"{FIRST}.strength"] == "700 MPa"
    study.change(f"{FIRST}.strength", "900 MPa", "one number")
    study.choose("problem", "tangential")
    assert form.at(study.table, f"{FIRST}.strength") == "900 MPa"
    assert f"{FIRST}.strength" not in study.assumed
    assert f"{FIRST}.young" in study.assumed


def test_what_was_put_aside_comes_back_before_numbers_of_examples():
    study = StudyForm(lambda: None, lambda: None)
    study.change(f"{FIRST}.young", "70 GPa", "one number")
    for question in ("viscoelastic_indentation", "seal", "constriction"):
        study.choose("problem", question)
    first = FIRST.replace("problem.", "problem.contact.")
    assert form.at(study.table, f"{first}.young") == "70 GPa"
    assert f"{first}.young" not in study.assumed


def test_bodies_and_load_stay(entered):
    entered.choose("problem", "friction_heating")
    contact = form.at(entered.table, "problem.contact")
    assert contact["bed"]["profile"] == TIP
    assert contact["bed"]["medium"]["first"] == RUBBER
    assert contact["load"] == {"kind": "force", "force": "2 N"}
    assert entered.carried_remark == (
        "Kept: shape and bodies, load (force 2 N). Of the example: coefficient 0.3, conductivity 45 W/(m K), "
        "diffusivity 12 mm^2/s, first speed 1 m/s."
    )
    entered.take_example()
    assert entered.table == form.initial_table("friction_heating")
    assert entered.carried_remark == ""


def test_a_load_goes_to_the_beginning_of_a_path(entered):
    entered.choose("problem", "tangential")
    assert form.at(entered.table, "problem.path.steps.0.normal") == {"kind": "force", "force": "2 N"}
    assert form.at(entered.table, FIRST) == RUBBER
    assert "Dropped" not in entered.carried_remark


def test_what_has_no_place_is_said_and_comes_back(entered):
    entered.choose("problem", "elliptic_indentation")
    assert form.at(entered.table, "problem.medium.first") == RUBBER
    assert entered.carried_remark == (
        "Kept: medium (half space), load (force 2 N). "
        "Dropped, as elliptic indentation has no place for it: profile (sphere 7 mm). "
        "Of the example: longitudinal curvature radius 20 mm, lateral curvature radius 10 mm."
    )
    entered.choose("problem", "constriction")
    contact = form.at(entered.table, "problem.contact")
    assert contact["bed"]["medium"]["first"] == RUBBER
    assert contact["bed"]["profile"] == TIP
    assert contact["load"] == {"kind": "force", "force": "2 N"}


def test_numbers_stay_where_a_part_does_not_fit(entered):
    """A body that yields needs a strength: modulus and Poisson's ratio stay, the strength is that of the example."""
    entered.choose("problem", "yield_onset")
    first, example = form.at(entered.table, FIRST), form.at(form.initial_table("yield_onset"), FIRST)
    assert first == {**example, "young": "3 MPa", "poisson": 0.49}


def test_a_sweep_stays_where_its_keys_do(entered):
    entered.vary(f"{LOAD}.force")
    ranges = dict(entered.table["sweep"])
    entered.choose("problem", "adhesive_indentation")
    assert entered.table["sweep"] == ranges
    assert "Left out" not in entered.carried_remark
    entered.choose("problem", "constriction")  # whose load is that of its contact
    assert entered.table["sweep"] == {"problem.contact.load.force": ranges["problem.load.force"]}
    assert "Left out" not in entered.carried_remark
    entered.choose("problem", "indentation")
    assert entered.table["sweep"] == ranges
    entered.choose("problem", "line_indentation")
    assert "sweep" not in entered.table
    assert entered.carried_remark.endswith("Left out: [sweep].")


def test_another_shape_ends_the_remark(entered):
    entered.choose("problem", "adhesive_indentation")
    entered.choose(PROFILE, "cone")
    assert entered.carried_remark == ""


@pytest.mark.slow
def test_every_kind_takes_what_fits_and_stays_sound(entered):
    """Its checks pass, and a part of the same path whose kind is allowed is there unless the checks forbid it."""
    before = dict(entered.table)
    wrong = {}
    for kind in CATALOGUE["problem"]:
        entered.load(dict(before))
        entered._aside = {}
        entered.choose("problem", kind)
        parse_study(tomli_w.dumps(entered.table))
        assert entered.table["problem"]["kind"] == kind
        if kind != before["problem"]["kind"]:
            assert entered.carried_remark.startswith(("Kept: ", "Nothing of the former study fits here."))
        profile = form.at(entered.table, PROFILE)
        if profile is not None and profile["kind"] == "sphere" and profile != TIP:
            wrong[kind] = profile
    assert wrong == {}


def test_the_model_of_a_fit_keeps_tip_and_sample():
    study = StudyForm(lambda: None, lambda: None)
    study.switch_task("fit")
    form.put(study.table, "problem.bed.profile", {"kind": "cone", "half_angle": "70.3 deg"})
    form.put(study.table, "fit.spring", "0.1 N/m")
    study.choose("problem", "adhesive_indentation")
    assert form.at(study.table, "problem.bed.profile") == {"kind": "cone", "half_angle": "70.3 deg"}
    assert form.at(study.table, "fit.spring") == "0.1 N/m"
    assert "shape and bodies" in study.carried_remark
