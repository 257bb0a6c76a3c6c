"""Units, decimal commas, ranges and materials in the fields of the app: no quantity changes when its unit does."""

from __future__ import annotations

import pytest
import tomli_w

from winkler.study.language.catalogue import kinds
from winkler.study.language.explain import keys_of
from winkler.study.language.reading import parse_study
from winkler.values.errors import InvalidInput
from winkler.values.units import quantity
from winkler.web.form import form
from winkler.web.form.field_units import completed_text, in_unit, offered_units, shown_unit
from winkler.web.form.front_examples import first_table
from winkler.web.form.materials_menu import material_lines, tabulated
from winkler.web.form.study_form import StudyForm

FORCE, YOUNG = "problem.load.force", "problem.bed.medium.first.young"
UNITS = sorted({key.word.unit for kind in kinds() for key in keys_of(kind) if key.word.unit})


@pytest.mark.parametrize("si", UNITS)
def test_another_unit_is_the_same_quantity(si):
    """To the last bit of its SI number, for numbers whose conversion has no end, too."""
    for unit in offered_units(si):
        for number in ("1", "0.1", "3.7", "123.456", "70.3", "1e-3"):
            for other in offered_units(si):
                text = in_unit(f"{number} {unit}", other, si)
                assert quantity(text, si, what="") == quantity(f"{number} {unit}", si, what="")
                assert shown_unit(text, "") == other


@pytest.mark.parametrize(
    ("text", "takes", "unit", "content"),
    [
        ("5", "quantity [m]", "mm", "5 mm"),
        ("0,5", "quantity [m]", "mm", "0.5 mm"),
        (",5 um", "quantity [m]", "mm", ".5 um"),
        ("1.234,5", "quantity [m]", "mm", "1234.5 mm"),
        ("0,3", "number", "", "0.3"),
        ("1,000", "quantity [N], list or range", "N", "1,000"),
        ("1,000 N", "quantity [N]", "mN", "1,000 N"),
        ("1,5", "quantity [N], list or range", "N", "1.5 N"),
        ("1,5", "list of quantity [N]", "N", "1,5"),
        ("1, 5", "list of quantity [N]", "N", "1 N, 5 N"),
        ("1,5; 2,5", "list of quantity [N]", "N", "1.5 N, 2.5 N"),
        ("10,20,30", "list of quantity [N]", "N", "10 N, 20 N, 30 N"),
        ("1 N,2 kN", "quantity [N], list or range", "mN", "1 N, 2 kN"),
        ("infinite", 'quantity [Pa] or "infinite"', "Pa", "infinite"),
        ('{ from = "1 N" }', "quantity [N], list or range", "N", '{ from = "1 N" }'),
        ("1,5", "text", "", "1,5"),
    ],
)
def test_bare_numbers_and_decimal_commas(text, takes, unit, content):
    assert completed_text(text, takes, unit) == content


def test_degrees_celsius_are_no_differences():
    assert offered_units("K", "problem.temperature_drop") == ("K",)
    assert "degC" in offered_units("K", "problem.bulk_temperature")
    assert in_unit("20 degC", "K", "K") == "293.15 K"


def test_what_is_ambiguous_is_refused_in_one_sentence():
    table = first_table()
    form.put(table, FORCE, completed_text("1,000", "quantity [N], list or range", "N"))
    with pytest.raises(InvalidInput, match=r"a comma, which is ambiguous; write '1000' if .*, '1\.000' if"):
        parse_study(tomli_w.dumps(table))


def test_a_range_is_two_numbers_and_a_count():
    entered = StudyForm(lambda: None, lambda: None)
    entry = next(one for one in form.part_of(entered.table, "problem.load").children if one.path == FORCE)
    entered.give_range(entry, "ratio", {"from": "1", "to": "0,1 kN", "count": "3"}, anew=True)
    assert entered.content(FORCE) == {"from": "1 kN", "to": "0.1 kN", "count": 3, "spacing": "log"}
    entered.give_range(entry, "even", {"from": "10", "to": "100", "count": "4"}, anew=False)
    study = parse_study(tomli_w.dumps(entered.table))
    assert study.problem.load.force.tolist() == [10.0, 40.0, 70.0, 100.0]
    entered.give_one(FORCE)
    assert entered.content(FORCE) == "100 N"


def test_materials_have_values_and_sources():
    assert {"tungsten", "PDMS"} <= set(tabulated("named_elastic"))
    assert "PDMS" not in tabulated("named_electrical_conductor")
    lines = material_lines("named_elastic", "fused silica")  # of the maker's data sheet
    assert [(line.name, line.number) for line in lines] == [("Young's modulus", "73 GPa"), ("Poisson's ratio", "0.17")]
    assert all(line.source for line in lines)
    entered = StudyForm(lambda: None, lambda: None)
    entered.choose("problem.bed.medium.first", "named_elastic")
    entered.change("problem.bed.medium.first.name", "tungsten", "text")
    assert parse_study(tomli_w.dumps(entered.table)).problem.bed.medium.first.young == 411e9
    entered.choose("problem.bed.medium.first", "elastic")  # with the numbers of that material, to be changed
    assert entered.content(YOUNG) == "411 GPa"
    assert entered.content("problem.bed.medium.first.poisson") == 0.28
