"""Expectations and their verdicts, and the ledger of literature cases."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.study.batch.points import ComparedNumber
from winkler.study.batch.run import run
from winkler.study.batch.verdicts import compared
from winkler.study.language.study import Expectation, Study
from winkler.study.ledger.ledger import CASES, case_files, ledger, run_case
from winkler.study.ledger.ledger_page import markdown
from winkler.values.errors import InvalidInput

# Hertz: E* = 1, R = 1, a = 1/2
BED = wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.0)))
(POINT,) = run(Study("x", wk.Indentation(BED, wk.Radius(0.5)))).solved
(MANY,) = run(Study("x", wk.Indentation(BED, wk.Radius(np.array([0.5, 1.0]))))).solved


@pytest.mark.parametrize(
    ("quantity", "expected", "place"),
    [
        ("depth", 0.25, ()),
        ("force", 1.0 / 6.0, ()),
        ("stiffness", 1.0, ()),
        ("pressure", 1.0 / math.pi, (("r", 0.0),)),
        ("displacement", 0.0544988905, (("r", 1.0),)),
        ("line_load", 0.25, (("x", 0.0),)),
        ("line_load", 0.21, (("x", 0.2),)),
        ("axial_stress", -(1.0 / math.pi) / 2.0, (("r", 0.0), ("z", 0.5))),
        ("problem.bed.medium.modulus", 1.0, ()),
    ],
)
def test_right_numbers_pass(quantity, expected, place):
    verdict = compared(POINT, Expectation(quantity, expected, 1e-8, place=place))
    assert verdict.passed
    assert verdict.digits >= 8.0


@pytest.mark.parametrize(("factor", "passed"), [(1.0 + 0.9e-3, True), (1.0 - 0.9e-3, True), (1.002, False)])
def test_tolerance_is_relative(factor, passed):
    verdict = compared(POINT, Expectation("depth", 0.25 * factor, 1e-3))
    assert verdict.passed is passed
    assert verdict.deviation == pytest.approx(abs(1.0 - 1.0 / factor), rel=1e-9)


def test_scale_replaces_the_number():
    field = Expectation("pressure", 0.0, 1e-3, place=(("r", 0.6),), scale=1.0)
    assert compared(POINT, field).deviation == 0.0
    assert compared(POINT, Expectation("depth", 0.35, 0.1001, scale=1.0)).passed
    assert not compared(POINT, Expectation("depth", 0.35, 0.0999, scale=1.0)).passed


def test_many_loads():
    assert compared(MANY, Expectation("depth", np.array([0.25, 1.0]), 1e-12)).passed
    assert not compared(MANY, Expectation("depth", np.array([0.25, 1.1]), 1e-12)).passed
    assert not compared(MANY, Expectation("depth", 0.25, 1e-12)).passed
    with pytest.raises(InvalidInput, match="depth has 2 values, but 3 are expected"):
        compared(MANY, Expectation("depth", np.array([0.25, 1.0, 2.0]), 1e-12))


def test_what_is_not_finite_is_missed():
    punch = wk.Foundation(wk.FlatPunch(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.0)))
    (point,) = run(Study("x", wk.Indentation(punch, wk.Force(1.0)))).solved
    verdict = compared(point, Expectation("pressure", 1.0, 0.5, place=(("r", 1.0),)))
    assert verdict.deviation == math.inf
    assert not verdict.passed
    assert verdict.digits == 0.0


@pytest.mark.parametrize(
    ("expectation", "sentence"),
    [
        (Expectation("amplitude", 1.0, 0.1), "'amplitude' is not an answer of IndentationSolution; there are depth"),
        (Expectation("gap", 1.0, 0.1, place=(("r", 0.0), ("z", 1.0))), "'gap' is not one of SubsurfaceFields"),
        (
            Expectation("principal", 1.0, 0.1, place=(("r", 0.0), ("z", 1.0))),
            "principal has 3 components; name",
        ),
        (Expectation("depth", 1.0, 0.1, place=(("x", 0.0),)), "depth is no function of x"),
        (Expectation("problem.bed.rim.force", 1.0, 0.1), "'force' is not a part of float"),
        (Expectation("problem.load", 1.0, 0.1), "'problem.load' is no number but a Radius"),
    ],
)
def test_expectations_that_cannot_be_compared(expectation, sentence):
    with pytest.raises(InvalidInput) as caught:
        compared(POINT, expectation)
    assert sentence in str(caught.value)


def test_a_wrong_expectation_stops_a_sweep_at_its_first_point(monkeypatch):
    from winkler.study.language.varied import Axis

    solved = []
    real = wk.Indentation.solve
    monkeypatch.setattr(wk.Indentation, "solve", lambda self: solved.append(self) or real(self))
    study = Study(
        "x",
        wk.Indentation(BED, wk.Force(1.0)),
        sweep=(Axis("problem.load.force", (1.0, 2.0, 3.0)),),
        expect=(Expectation("amplitude", 1.0, 0.1),),
    )
    with pytest.raises(InvalidInput, match="amplitude"):
        run(study)
    assert len(solved) == 1


def test_digits():
    expectation = Expectation("depth", 1.0, 1e-3)
    assert ComparedNumber((), expectation, 1.0, 0.0).digits == 16.0
    assert ComparedNumber((), expectation, 1.0, 1e-5).digits == pytest.approx(5.0)
    assert ComparedNumber((), expectation, 1.0, 7.0).digits == 0.0


CASE = """title = "A case"
source = "nobody"
grade = "analytical"

[problem]
kind = "indentation"
load = { kind = "radius", radius = "0.5 m" }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "1 m" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 Pa", poisson = 0.0 } }

[[expect]]
quantity = "depth"
value = 0.25
unit = "m"
tolerance = 1e-12
"""


def test_a_case_is_examined(tmp_path):
    (tmp_path / "case.toml").write_text(CASE)
    entry = run_case(tmp_path / "case.toml")
    assert entry.passed
    assert entry.digits > 12.0
    (tmp_path / "case.toml").write_text(CASE.replace("0.25", "0.26"))
    assert not run_case(tmp_path / "case.toml").passed


@pytest.mark.parametrize("key", ["source", "grade", "[[expect]]"])
def test_a_case_needs_source_grade_and_expectations(key, tmp_path):
    lines = CASE.split("[[expect]]")[0] if key == "[[expect]]" else CASE
    text = "\n".join(line for line in lines.splitlines() if not line.startswith(f"{key} ="))
    (tmp_path / "case.toml").write_text(text)
    with pytest.raises(InvalidInput) as caught:
        run_case(tmp_path / "case.toml")
    assert str(caught.value).startswith(f"case.toml: a case needs {key}")


def test_a_case_that_cannot_be_solved_is_missed(tmp_path):
    (tmp_path / "case.toml").write_text(CASE.replace('"radius", radius = "0.5 m"', '"force", force = "-1 N"'))
    entry = run_case(tmp_path / "case.toml")
    assert not entry.passed
    assert "tensile" in entry.failure
    assert "Not solved: force -1 N is tensile" in markdown([entry])


def test_cases_are_found_by_name_file_and_folder(tmp_path):
    (tmp_path / "mine.toml").write_text(CASE)
    assert case_files([str(tmp_path)]) == case_files([str(tmp_path / "mine.toml")]) == [tmp_path / "mine.toml"]
    assert case_files(["hertz_paraboloid"]) == [CASES / "hertz_paraboloid.toml"]
    assert len(case_files()) == len(list(CASES.glob("*.toml"))) >= 20
    with pytest.raises(InvalidInput, match=r"'hertz_parabolid' is no case \(did you mean 'hertz_paraboloid'\?\)"):
        case_files(["hertz_parabolid"])
    (tmp_path / "empty").mkdir()
    with pytest.raises(InvalidInput, match="holds no case"):
        case_files([str(tmp_path / "empty")])


LONG = {
    *("coated_substrate_limit", "coated_winkler_paraboloid", "coated_winkler_punch", "depth_graded_soft_skin"),
    *("steady_circle_overshoot", "maw_barber_fawcett_table", "rough_line_stiffness", "jkr_slow_peeling"),
    *("reduced_friction_ellipse", "line_fretting_reaches_the_limit", "coated_hard_stiffness"),
}
"""Contacts much wider than a layer, a grading cut into hundreds of layers, and marches of a second and longer."""


def case_parameters():
    """Every second case by default; the page on validation solves all, and the manual is not built if one fails."""
    for number, path in enumerate(case_files()):
        here = number % 2 == 0 and path.stem not in LONG
        yield pytest.param(path, marks=[] if here else [pytest.mark.manual], id=path.stem)


@pytest.mark.few(3, slow=3)
@pytest.mark.parametrize("path", [*case_parameters()])
def test_every_case_of_the_package_passes(path):
    entry = run_case(path)
    assert entry.failure == ""
    assert [verdict for verdict in entry.verdicts if not verdict.passed] == []


def test_the_page_of_the_manual(tmp_path):
    (tmp_path / "mine.toml").write_text(CASE)
    page = markdown(ledger(case_files([str(tmp_path)])))
    assert "1 cases, 1 numbers" in page
    assert "## Normal contact" in page
    assert "| normal contact | 1 | 1 | 1, 1" in page
    assert "| depth | 0.25 m | 0.25 m |" in page


BALL = wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(2.0, 0.0), wk.Elastic(2.0, 0.0)))


def rubbed(shift):
    path = wk.Path(np.arange(3.0), wk.Depth(1.0), wk.Shift(shift))
    (point,) = run(Study("x", wk.Tangential(BALL, wk.Coulomb(0.3), path))).solved
    return point


def test_fields_at_a_point_of_a_path_and_inside_the_bodies():
    """All slides: the traction is the coefficient times the pressure (2/pi) sqrt(1 - r^2), E* = R = d = a = 1."""
    point = rubbed(np.array([0.0, 1.0, -1.0]))
    for row, sign in ((1, 1.0), (-1, -1.0)):
        there = Expectation(f"traction.{row}", sign * 0.6 / np.pi * 0.8, 1e-12, place=(("r", 0.6),))
        assert compared(point, there).passed
    # on the axis sigma_z is Hertz' and the traction adds none
    inside = (("x", 0.0), ("y", 0.0), ("z", 0.5))
    assert compared(point, Expectation("zz_stress.1", -2.0 / np.pi / 1.25, 1e-9, place=inside)).passed


def test_components_of_a_direction_in_the_plane():
    point = rubbed(np.array([[0.0, 0.0], [0.0, 1.0], [0.0, 2.0]]))
    across = Expectation("traction.-1.1", 0.6 / np.pi * 0.8, 1e-3, place=(("r", 0.6),))
    assert compared(point, across).passed


@pytest.mark.parametrize(
    ("quantity", "place", "sentence"),
    [
        ("traction", (("r", 0.6),), "traction is of 3 contacts; name one, as traction.-1 the last"),
        ("traction.3", (("r", 0.6),), "traction.3 asks for one of 3 contacts; count from 0"),
        ("traction.1.0", (("r", 0.6),), "traction has 1 component; leave out the number behind it"),
        ("slope.1", (("r", 0.6),), "'slope' is not one of ShearedFields"),
        ("depth.1", (("x", 0.6),), "depth.1 is no function of x of TangentialSolution; leave x out"),
    ],
)
def test_places_that_cannot_be_compared(quantity, place, sentence):
    with pytest.raises(InvalidInput) as caught:
        compared(rubbed(np.array([0.0, 1.0, -1.0])), Expectation(quantity, 1.0, 0.1, place=place))
    assert sentence in str(caught.value)


def test_one_load_of_many():
    (point,) = run(Study("x", wk.Indentation(BALL, wk.Radius(np.array([0.5, 1.0]))))).solved
    assert compared(point, Expectation("pressure.1", 2.0 / np.pi, 1e-9, place=(("r", 0.0),))).passed
    with pytest.raises(InvalidInput, match="of 2 contacts"):
        compared(point, Expectation("pressure", 1.0, 1e-9, place=(("r", 0.0),)))
