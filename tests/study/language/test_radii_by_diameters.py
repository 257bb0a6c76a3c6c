"""Diameters in place of radii, and the osculation of a groove: the same bodies, and one sentence for each mistake."""

from __future__ import annotations

import math

import pytest

import winkler as wk
from winkler.study.json_schema import json_schema
from winkler.study.language.build import build, unbuild
from winkler.study.language.catalogue import kinds
from winkler.study.language.schema import diameters

GROOVED = {"kind": "curved_pair", "first_longitudinal_diameter": "10 mm", "first_lateral_radius": "5 mm",
           "second_longitudinal_diameter": "-52 mm"}  # fmt: skip


def test_a_diameter_is_twice_the_radius():
    assert build({"kind": "sphere", "diameter": "20 mm"}, "profile") == wk.Sphere(0.01)
    assert build({"kind": "radius", "diameter": ["1 mm", "3 mm"]}, "load").radius.tolist() == [5e-4, 1.5e-3]
    assert unbuild(build({"kind": "sphere", "diameter": "20 mm"}, "profile"))["curvature_radius"] == "10 mm"


def test_a_groove_by_its_osculation_is_hollow():
    pair = build({**GROOVED, "osculation": 0.52}, "footprint")
    radii = (pair.first_longitudinal_radius, pair.first_lateral_radius, pair.second_longitudinal_radius)
    assert radii == (5e-3, 5e-3, -26e-3)
    assert pair.second_lateral_radius == pytest.approx(-5.2e-3, rel=1e-15)
    straight = build({**GROOVED, "second_longitudinal_diameter": "infinite", "osculation": 0.52}, "footprint")
    assert straight.second_longitudinal_radius == math.inf


@pytest.mark.parametrize(
    ("slot", "table", "said"),
    [
        ("profile", {"kind": "sphere", "diameter": "1 mm", "curvature_radius": "1 mm"}, "has both diameter"),
        ("profile", {"kind": "sphere", "diameter": "1 kg"}, "diameter: '1 kg' is a mass"),
        ("profile", {"kind": "sphere", "diameter": "-1 mm"}, "curvature_radius is"),
        ("profile", {"kind": "cone", "diameter": "1 mm", "half_angle": "1 rad"}, "diameter is not known"),
        ("footprint", {**GROOVED, "osculation": 52}, "osculation is 52; give the radius of the groove over"),
        ("footprint", {**GROOVED, "osculation": "5 mm"}, "osculation"),
        ("footprint", {**GROOVED, "osculation": 0.52, "second_lateral_radius": "1 m"}, "has both osculation"),
        ("footprint", {"kind": "curved_pair", "osculation": 0.52}, "add it"),
    ],
)  # fmt: skip
def test_a_mistake_is_one_sentence(slot, table, said):
    with pytest.raises(wk.InvalidInput, match=said):
        build(table, slot)


def test_no_diameter_has_the_name_of_a_field_and_the_schema_knows_each():
    for kind, line in kinds().items():
        if "radius" in "".join(getattr(line.cls, "__dataclass_fields__", {})):
            properties = json_schema(kind)["definitions"].get(kind, json_schema(kind))["properties"]
            for diameter, radius in diameters(line.cls).items():
                assert "radius" in radius
                assert {diameter, radius} <= set(properties)


@pytest.mark.parametrize(("lateral", "asked"), [(5.2e-3, True), (-5.2e-3, False), (5e-3, False), (20e-3, False)])
def test_a_groove_without_its_sign_is_asked_about(lateral, asked):
    from winkler.study.batch.run import run
    from winkler.study.language.study import Study
    from winkler.study.report.headline.questions import questions_of

    pair = wk.CurvedPair(5e-3, 5e-3, 52e-3, lateral)
    solid = wk.HalfSpace(wk.Elastic(210e9, 0.3))
    questions = questions_of(run(Study("ball", wk.EllipticIndentation(pair, solid, wk.Force(1.0)))))
    assert any("times that of the first body" in one and "−5.2 mm" in one for one in questions) == asked
