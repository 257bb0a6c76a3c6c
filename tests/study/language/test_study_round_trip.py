"""Text to value and back: nothing is lost, for every kind, to the last digit."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import winkler as wk
from winkler.study.language.build import build, unbuild
from winkler.study.language.canonical import canonical, digest
from winkler.study.language.catalogue import CATALOGUE, REFUSED, kind_of, kinds, slot_of
from winkler.study.language.designs import Zipped
from winkler.study.language.explain import completed, example_study, keys_of, place_of, table_at
from winkler.study.language.reading import parse_study
from winkler.study.language.schema import form, hints, options
from winkler.study.language.study import Expectation, Fields, Output, Places, Study
from winkler.study.language.varied import Axis
from winkler.study.language.writing import study_text
from winkler.values.errors import InvalidInput

positive = st.floats(1e-12, 1e12)
angle = st.floats(0.01, 1.56)


@pytest.mark.slow
def test_every_kind_comes_back():
    for name in kinds():
        value = build(completed({"kind": name}), slot_of(name))
        again = build(unbuild(value), slot_of(name))
        assert again == value, name
        assert hash(again) == hash(value), name
        assert kind_of(type(value)) == name


def test_a_form_has_the_keys_of_its_class():
    for name, line in kinds().items():
        fields = [field.name for field in dataclasses.fields(line.cls) if field.init]
        read = {"kind", "file", *options(line)} - set(fields)
        known = [key for key in form(name).model_fields if key not in read]
        assert known == fields == list(hints(line.cls)), name
        assert {key.name for key in keys_of(name)} >= set(fields), name


def test_names_of_kinds_are_unique():
    names = [name for slot in CATALOGUE.values() for name in slot]
    assert len(names) == len(set(names)) == len({form(name) for name in kinds()})
    assert not set(REFUSED) & set(names)


ELSEWHERE = {
    wk.BallImpacts,
    wk.ContactLaw,
    wk.ContactTrace,
    wk.Contacts,
    wk.CorrelationLengths,
    wk.CurrentFields,
    wk.EllipticFields,
    wk.FlowFactors,
    wk.HeatFields,
    wk.NamedMaterial,
    wk.PlateBase,
    wk.RelaxationSpectrum,
    wk.RollerCentre,
    wk.LayerStress,
    wk.PartOnset,
    wk.LinePartOnset,
    wk.EllipticPartOnset,
    wk.LineFields,
    wk.LineScan,
    wk.MapStatistics,
    wk.ProfilePatch,
    wk.RolledPatch,
    wk.RoughLine,
    wk.Spikes,
    wk.TwistedFields,
}
"""Thousands of contacts or springs at once, arrays that no study file holds; restored fields and statistics of a map,
which are answers; references, which a method takes."""


def test_the_catalogue_knows_every_public_value_that_a_study_could_name():
    """A new shape, solid, medium, load or problem needs its line."""
    public_items = [getattr(wk, name) for name in wk.__all__]
    in_catalogue = {line.cls for line in kinds().values()} | {line.cls for line in REFUSED.values()}
    folders = ("winkler.profiles", "winkler.materials", "winkler.media", "winkler.loading.loads", "winkler.problems")
    expected = {
        item
        for item in public_items
        if isinstance(item, type)
        and dataclasses.is_dataclass(item)
        and item.__module__.startswith(folders)
        and not any(field.name == "problem" for field in dataclasses.fields(item))  # a solution knows its problem
    }
    assert expected - ELSEWHERE <= in_catalogue


@given(number=positive)
def test_every_float_comes_back(number):
    for value in (
        wk.Sphere(number),
        wk.Force(number),
        wk.Elastic(number, 0.1234567890123456),
        wk.Depth(np.array([number, -number, 3.0 * number])),
        wk.PowerLaw(number, 2.7),
        wk.PowerLaw(number, 1.0),
    ):
        assert build(unbuild(value), slot_of(kind_of(type(value)))) == value


@given(theta=angle)
def test_every_angle_comes_back(theta):
    assert build(unbuild(wk.Cone(theta)), "profile") == wk.Cone(theta)


@given(numbers=st.lists(st.floats(-1e3, 1e3), min_size=1, max_size=40))
def test_long_lists_come_back(numbers):
    load = wk.Depth(np.array(numbers))
    assert build(unbuild(load), "load") == load


@given(value=st.floats(-1e6, 1e6, allow_subnormal=False))
def test_constants_of_a_formula_come_back(value):
    shape = wk.Formula("r**2 * (1 + 0*c)", c=value)
    assert build(unbuild(shape), "profile") == shape


def test_nothing_is_written_that_is_the_default():
    assert unbuild(wk.HalfSpace(wk.Elastic(1e9, 0.3))) == {
        "kind": "half_space",
        "first": {"kind": "elastic", "young": "1 GPa", "poisson": 0.3},
    }


def test_a_class_outside_the_catalogue_is_refused():
    with pytest.raises(InvalidInput, match="Study is not in the catalogue"):
        unbuild(Study("", wk.Force(1.0)))


WHOLE = Study(
    title='A "title" with quotes, ä and \\',
    problem=wk.Indentation(
        wk.Foundation(wk.Paraboloid(1e-3) + wk.Wavy(1e-9, 1.23456789e-5), wk.HalfSpace(wk.Elastic(1e9, 0.25))),
        wk.Force(np.array([1.0, 2.0 / 3.0])),
    ),
    sweep=(
        Axis("problem.bed.profile.parts.1.amplitude", (1e-9, 2e-9 / 3.0)),
        Axis("problem.bed.medium", (wk.HalfSpace(wk.Elastic(1e9, 0.25)), wk.HalfSpace(wk.Elastic(2e9, 0.1)))),
    ),
    fields=Fields(r=Places(np.linspace(0.0, 3.0, 31), relative=True), z=Places(np.array([0.1, 0.2]), relative=True)),
    output=Output(folder="somewhere/else", figures=("pdf",), report=False),
    expect=(
        Expectation("depth", np.array([1e-6, 1.0 / 3.0]), 1e-3),
        Expectation("pressure", 1.0 / 3.0, 1e-3, place=(("r", 1e-5 / 3.0),), scale=1e9),
        Expectation("von_mises", 0.0, 1e-3, place=(("r", 1e-5), ("z", 2e-5)), scale=7.0),
        Expectation("line_load", 5.0, 1e-3, place=(("x", 1e-5),)),
        Expectation("problem.bed.medium.modulus", 1e9, 0.1),
    ),
    source="a paper",
    grade="cross-code",
)


def test_a_whole_study_comes_back():
    assert parse_study(study_text(WHOLE)) == WHOLE


def test_together_comes_back():
    study = Study(
        "",
        WHOLE.problem,
        sweep=(
            Axis("problem.bed.medium.first.young", (1e9, 2e9)),
            Axis("problem.bed.medium.first.poisson", (0.1, 0.2)),
        ),
        design=Zipped(),
    )
    assert parse_study(study_text(study)) == study


@pytest.mark.parametrize(
    ("key", "values"),
    [
        ("problem.load", (wk.Depth(1e-6), wk.Force(1.0))),
        ("problem.bed.profile.parts", ((wk.Sphere(1.0), wk.Cone(1.0)), (wk.Sphere(2.0),))),
        ("problem.bed.profile.parts.0", (wk.Sphere(1.0), wk.Cone(1.0))),
        ("problem.bed.medium.first.strength", (1e9, 2e9)),
        ("problem.load.force.1", (1.0, 2.0)),
    ],
)
def test_any_key_can_be_swept_and_written(key, values):
    study = Study("x", WHOLE.problem, sweep=(Axis(key, values),))
    assert parse_study(study_text(study)) == study


def test_constants_coefficients_and_dependent_units_can_be_swept_and_written():
    for profile, key, values in (
        (wk.Formula("r**2/(2*R)", R=1.0), "constants.R", (1.0, 1.0 / 3.0)),
        (wk.AreaFunction((24.5, 1e-6)), "coefficients.1", (1e-6, 1e-6 / 3.0)),
        (wk.AreaFunction((24.5, 1e-6)), "coefficients", ((24.5, 1e-6), (20.0, 0.0, 1e-9))),
        (wk.Formula("r**2/(2*R)", R=1.0), "constants", ((("R", 1.0),), (("R", 2.0 / 3.0),))),
        (wk.Formula("r**2 + r**2*sqrt((r-b)**2)", b=1.0, corners=(1.0,)), "corners.0", (1.0,)),
        (wk.PowerLaw(1.0, 3.0), "coefficient", (1.0, 1.0 / 3.0)),
        (wk.PowerLaw(1.0, 3.0), "exponent", (2.0, 2.5)),
    ):
        problem = wk.Indentation(wk.Foundation(profile, wk.HalfSpace(wk.Elastic(1e9, 0.25))), wk.Force(1.0))
        study = Study("x", problem, sweep=(Axis(f"problem.bed.profile.{key}", values),))
        assert parse_study(study_text(study)) == study, key


def test_the_forms_of_writing_numbers_agree():
    def force(text: str):
        return build({"kind": "force", "force": text}, "load")

    assert force(["1 mN", "2 mN"]) == force({"values": [1, 2], "unit": "mN"}) == wk.Force(np.array([1e-3, 2e-3]))
    assert force({"from": "1 mN", "to": "1 N", "count": 4, "spacing": "log"}) == wk.Force(np.geomspace(1e-3, 1.0, 4))
    assert force({"from": "0 N", "to": "1 kN", "count": 7}) == wk.Force(np.linspace(0.0, 1e3, 7))
    assert force("1e2 N") == force("0.1 kN") == wk.Force(100.0)


def test_units_of_a_power_law_follow_its_exponent():
    table = {"kind": "power_law", "coefficient": "2 1/mm", "exponent": 2.0}
    assert build(table, "profile") == wk.PowerLaw(2e3, 2.0)
    assert build({**table, "coefficient": "2 mm^-3", "exponent": 4.0}, "profile") == wk.PowerLaw(2e9, 4.0)
    assert build({**table, "coefficient": 0.5, "exponent": 1.0}, "profile") == wk.PowerLaw(0.5, 1.0)


def test_the_hash_is_of_the_question_alone():
    study = parse_study(study_text(WHOLE))
    assert digest(study) == digest(WHOLE)
    assert len(digest(study)) == 64
    for other in (
        dataclasses.replace(WHOLE, title="other", output=Output(), expect=()),
        dataclasses.replace(WHOLE, source="", grade=""),
    ):
        assert digest(other) == digest(WHOLE)
    changed = (
        dataclasses.replace(WHOLE, problem=dataclasses.replace(WHOLE.problem, load=wk.Force(np.array([1.0, 2.0])))),
        dataclasses.replace(WHOLE, sweep=WHOLE.sweep[:1]),
        dataclasses.replace(WHOLE, fields=Fields(r=WHOLE.fields.r)),
    )
    assert len({digest(other) for other in changed} | {digest(WHOLE)}) == 4


def test_equal_values_have_one_canonical_form():
    one = Study("", wk.Indentation(WHOLE.problem.bed, wk.Force(0.0)))
    two = Study("", wk.Indentation(WHOLE.problem.bed, wk.Force(-0.0)))
    three = Study("", wk.Indentation(WHOLE.problem.bed, wk.Force(0)))
    assert canonical(one) == canonical(two) == canonical(three)
    assert '"inf"' in canonical(one)  # the strength that was not given


def test_examples_stand_where_they_are_stated_to_stand():
    for name in kinds():
        table = table_at(example_study(name), place_of(name))
        assert table["kind"] == name or f"'kind': '{name}'" in str(table)
    assert math.isclose(build(example_study("cone")["problem"]).bed.profile.half_angle, math.radians(70.3))


@pytest.mark.parametrize(
    ("table", "slot", "sentence"),
    [
        (
            {"kind": "sphere"},
            "profile",
            "profile has no 'curvature_radius' (radius of curvature of the body at its apex)",
        ),
        ({"kind": "sphere", "curvature_radius": 1.0}, "profile", "profile.curvature_radius: '1.0' has no unit"),
        ({"kind": "spher"}, "profile", "profile.kind is 'spher' (did you mean 'sphere'?)"),
        (7, "load", 'load is 7, not a table; write it as { kind = "force", ... }.'),
        ({"kind": "elastic", "young": "1 GPa", "poisson": 0.7}, "solid", "solid.poisson is 0.7; a Poisson ratio"),
    ],
)
def test_wrong_tables(table, slot, sentence):
    with pytest.raises(InvalidInput) as caught:
        build(table, slot)
    assert str(caught.value).startswith(sentence)


def test_tables_may_hold_numpy_numbers():
    table = {"kind": "force", "force": {"values": list(np.linspace(0.0, 1.0, 3)), "unit": "kN"}}
    assert build(table, "load") == wk.Force(np.array([0.0, 500.0, 1000.0]))
