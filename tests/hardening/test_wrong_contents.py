"""Wrong contents for each argument of the public classes: refused, or kept as the numbers that they stand for."""

from __future__ import annotations

import dataclasses
import typing
import warnings
from decimal import Decimal

import numpy as np
import pytest
from wrong_contents import MEANT, WRONG, faults, public_values

import winkler as wk
from winkler.study.language.build import build
from winkler.study.language.catalogue import kinds
from winkler.study.language.explain import example_study
from winkler.study.language.fit_reading import read_fit_study
from winkler.study.language.reading import read_study
from winkler.values.checks.field_checks import _hints, checks_of
from winkler.values.value import _frozen

UNCHECKED = {
    *("IndenterCalibration.references", "JointStiffnessSolution.problem", "NanoindentationSolution.problem"),
    "TangentialSolution.states",
}
"""Fields of answers that keep the problem, of whatever class it is, and states that are restored when asked for."""


def test_each_field_of_a_public_class_has_a_check_of_its_type():
    fields = {f"{cls.__name__}.{name}": check for cls in public_values() for name, check in checks_of(cls)}
    assert len(fields) > 2000
    assert {name for name, check in fields.items() if check is None} <= UNCHECKED


@pytest.mark.slow
def test_each_type_of_a_field_refuses_what_is_wrong_or_keeps_what_is_meant():
    """The check is that of the type, so that one field of each type is tried."""
    tried: dict[str, list[typing.Any]] = {}
    warnings.simplefilter("error")
    for cls in public_values():
        hints = _hints(cls)
        for name, check in checks_of(cls):
            kind = str(hints[name])
            if kind not in tried and f"{cls.__name__}.{name}" not in UNCHECKED:
                tried[kind] = list(faults(cls.__name__, name, lambda content, check=check: check(_frozen(content))))
    assert len(tried) > 300
    assert [fault for found in tried.values() for fault in found] == []


def values_inside(content: typing.Any, found: dict[type, typing.Any]) -> None:
    """Collect a value of each class inside a content."""
    if isinstance(content, tuple):
        for part in content:
            values_inside(part, found)
    elif dataclasses.is_dataclass(content):
        found.setdefault(type(content), content)
        for field in dataclasses.fields(content):
            values_inside(getattr(content, field.name), found)


@pytest.mark.slow
def test_each_argument_of_what_studies_hold_refuses_what_is_wrong_or_keeps_what_is_meant():
    """With all other arguments sound, so that the checks of several fields together run, too."""
    found: dict[type, typing.Any] = {}
    for kind in kinds():
        values_inside(build(example_study(kind)["problem"]), found)
    public, wrong = set(public_values()), []
    warnings.simplefilter("error")
    for cls, sample in found.items():
        for field in dataclasses.fields(cls) if cls in public else ():

            def take(content: typing.Any, sample: typing.Any = sample, name: str = field.name) -> typing.Any:
                return getattr(dataclasses.replace(sample, **{name: content}), name)

            if field.init:
                wrong += faults(cls.__name__, field.name, take, named=False)
    assert len(public & set(found)) > 200
    assert wrong == []


def test_a_list_that_holds_itself_is_refused():
    endless: list[typing.Any] = []
    endless.append(endless)
    for cls in (wk.Force, wk.AreaFunction, wk.Sum):
        with pytest.raises(wk.InvalidInput, match="holds itself, or lists in lists without end"):
            cls(endless)


@pytest.mark.parametrize("bed", [wk.Foundation, wk.PlaneFoundation, wk.LineFoundation, wk.LayeredLineFoundation])
def test_a_class_in_place_of_a_shape_is_no_shape(bed):
    steel = wk.HalfSpace.between(wk.Elastic(210e9, 0.3))
    for shape in (wk.Sphere, wk.Paraboloid, wk.Shape):
        with pytest.raises(wk.InvalidInput, match=rf"is the class {shape.__name__} itself, not a value of it; give "):
            bed(shape, steel)


@pytest.mark.parametrize(
    "make",
    [
        lambda: wk.CappedCylinder(1e-3, wk.Cone),
        lambda: wk.SampledProfile([1e-3, 1e-3], wk.Sphere),
        lambda: wk.RoughProfile(wk.Topography(np.eye(4), [1e-3, 1e-3]), wk.Cone),
        lambda: wk.MirroredSection(wk.Paraboloid, 1e-3),
        lambda: wk.Foundation(wk.Sphere(1e-2), wk.HalfSpace),
        lambda: wk.Indentation(wk.Foundation, wk.Force(1.0)),
        lambda: wk.Indentation(wk.Foundation(wk.Sphere(1e-2), wk.HalfSpace.between(wk.Elastic(1e9, 0.3))), wk.Force),
        lambda: wk.HalfSpace(wk.Elastic),
    ],
)
def test_a_class_in_place_of_a_part_is_no_part(make):
    with pytest.raises(wk.InvalidInput, match=r"is the class \w+ itself, not a value of it; give .*\.$"):
        make()


def test_the_walk_finds_what_is_changed_in_silence():
    assert len(WRONG) >= 25
    changed = {fault.wrong for fault in faults("Sample", "length", lambda content: 1.0)}
    assert {"text", "complex", "set", "unit of no argument", "uncertain", "decimal"} <= changed
    raw = {fault.what[:10] for fault in faults("Sample", "length", lambda content: content.no_such_name)}
    assert raw == {"AttributeE"}


@pytest.fixture(scope="module")
def contact() -> wk.IndentationSolution:
    bed = wk.Foundation(wk.Paraboloid(1e-2), wk.HalfSpace.between(wk.Elastic(210e9, 0.3)))
    return wk.Indentation(bed, wk.Force(100.0)).solve()


def test_fields_at_wrong_places_are_refused(contact):
    for restored in (
        lambda place: wk.restore(contact, place),
        lambda place: wk.restore(contact, 1e-5, place),
        lambda place: wk.restore_body(contact, place, 0.0, 1e-5),
    ):
        refused = {fault.wrong for fault in faults("restore", "", restored) if fault.what.startswith("kept as ")}
        assert refused <= {*MEANT, "empty", "array of one row", "none"}  # without a depth
        assert not [fault for fault in faults("restore", "", restored) if not fault.what.startswith("kept as ")]
    with pytest.raises(wk.InvalidInput, match=r"shapes that do not broadcast \(r \(2,\), z \(3,\)\)"):
        wk.restore(contact, [0.0, 1e-4], [1e-4, 2e-4, 3e-4])


def test_fields_of_what_is_no_answer_are_refused(contact):
    for restored in (wk.restore, wk.restore_shift, wk.restore_body):
        places = (1e-5,) * {"restore": 1, "restore_shift": 2, "restore_body": 3}[restored.__name__]
        for wrong in (None, 3, wk.Indentation, wk.IndentationSolution, contact.problem):
            with pytest.raises(wk.InvalidInput, match=r"^restore.*: a \w+ .*; give "):
                restored(wrong, *places)
    with pytest.raises(wk.InvalidInput, match="has no tangential displacement of the surfaces"):
        wk.restore_shift(contact, 0.0, 0.0)


@pytest.mark.parametrize("wrong", [None, 3, b"study.toml", wk.Force])
def test_a_study_is_read_from_a_path(wrong):
    for read in (read_study, read_fit_study):
        with pytest.raises(wk.InvalidInput, match="is no path of a file; give one such as"):
            read(wrong)


def test_a_load_that_was_a_decimal_keeps_its_study(contact):
    solution = wk.Indentation(contact.problem.bed, wk.Force(Decimal("100"))).solve()
    assert solution == contact
    assert wk.to_xarray(solution).attrs == wk.to_xarray(contact).attrs
    assert "study" in wk.to_xarray(contact).attrs
