"""Paths into a value: found, changed without touching the old one, refused where they lead nowhere."""

from __future__ import annotations

import pytest

import winkler as wk
from winkler.fitting.parameters import changed, number_at, unit_of
from winkler.laws.adhesion import Dugdale, ShortRange
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.values.errors import InvalidInput

COATED = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1e9, 0.3), 1e-6)], on=wk.Elastic(1e10, 0.2))
MODEL = AdhesiveIndentation(wk.Foundation(wk.Paraboloid(1e-5), COATED), ShortRange(0.1), wk.Depth(0.0))


def test_numbers_are_found():
    assert number_at(MODEL, "bed.medium.layers[0].solid.young") == 1e9
    assert number_at(MODEL, "bed.medium.layers[0].thickness") == 1e-6
    assert number_at(MODEL, "law.work") == 0.1


def test_units_come_from_the_glossary():
    assert unit_of(MODEL, "bed.medium.layers[0].solid.young") == "Pa"
    assert unit_of(MODEL, "law.work") == "J/m^2"
    assert unit_of(MODEL, "bed.medium.on.poisson") == ""


def test_a_change_leaves_the_old_value_alone():
    new = changed(
        MODEL,
        {
            "bed.medium.layers[0].solid.young": 2e9,
            "bed.medium.layers[0].thickness": 3e-6,
            "bed.profile.curvature_radius": 2e-5,
            "law.work": 0.2,
        },
    )
    assert new.bed.medium.layers[0] == wk.Layer(wk.Elastic(2e9, 0.3), 3e-6)
    assert new.bed.medium.on == MODEL.bed.medium.on
    assert new.bed.profile == wk.Paraboloid(2e-5)
    assert new.law == ShortRange(0.2)
    assert number_at(MODEL, "bed.medium.layers[0].solid.young") == 1e9


def test_both_works_of_a_hysteresis():
    new = changed(MODEL, {"law.work_closing": 0.05})
    assert new.law == ShortRange(work_closing=0.05, work_opening=0.1)
    assert changed(new, {"law.work_closing": 0.1, "law.work_opening": 0.3}).law == ShortRange(
        work_closing=0.1, work_opening=0.3
    )


def test_other_laws():
    model = AdhesiveIndentation(MODEL.bed, Dugdale(0.1, 1e6), wk.Depth(0.0))
    assert changed(model, {"law.strength": 2e6}).law == Dugdale(0.1, 2e6)


@pytest.mark.parametrize(
    ("path", "message"),
    [
        ("bed.medium.frist.young", "CoatedHalfSpace has no frist"),
        ("bed.medium.layers[0].solid.yung", r"Elastic has no yung \(did you mean 'young'\?\)"),
        ("bed.medium.layers[3].solid.young", "item 3 of 1; counting begins at 0"),
        ("bed.medium.on[0]", "item 0 of 0"),
        ("bed.medium.on", "leads to Elastic .* no finite number"),
        ("bed..medium", "is no path"),
        ("bed.medium.layers[x]", "is no path"),
    ],
)
def test_paths_that_lead_nowhere(path, message):
    with pytest.raises(InvalidInput, match=message):
        number_at(MODEL, path)
