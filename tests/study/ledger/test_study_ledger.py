"""The ledger as a whole: every physics has its sources, sweeps are checked point by point, fits by their numbers."""

from __future__ import annotations

import inspect
import re
import tomllib

import pytest

from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.reading import read_study
from winkler.study.language.study import Study
from winkler.study.ledger.function_case import FUNCTIONS, read_function_case
from winkler.study.ledger.ledger import CASES, case_files, read_fit_case, run_case
from winkler.study.ledger.ledger_page import chapters, markdown
from winkler.study.ledger.physics import CHAPTERS, FITS, physics_of
from winkler.values.errors import InvalidInput
from winkler.values.vocabulary import GLOSSARY

SWEPT = """\
title = "Two balls"
source = "H. Hertz"
grade = "analytical"

[problem]
kind = "indentation"
load = { kind = "radius", radius = "0.5 m" }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "1 m" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 Pa", poisson = 0.0 } }

[sweep]
"problem.bed.profile.curvature_radius" = ["1 m", "2 m"]

[[expect]]
quantity = "depth"
value = [0.25, 0.125]
unit = "m"
tolerance = 1e-12

[[expect]]
quantity = "radius"
value = 0.5
unit = "m"
tolerance = 1e-12
"""

FITTED = """\
title = "Hertz again"
source = "H. Hertz"
grade = "analytical"

[problem]
kind = "indentation"

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "5 um" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 kPa", poisson = 0.5 } }

[fit]
curve = "curve.csv"
part = "approach"
noise = "1 fN"

[fit.free]
"problem.bed.medium.first.young" = ["10 Pa", "10 MPa"]
contact_point = true

[[expect]]
quantity = "problem.bed.medium.first.young"
value = 4000.0
unit = "Pa"
tolerance = 1e-6
"""


FUNCTION_CASE = """\
title = "Spin of a circle"
source = "J. J. Kalker"
grade = "published table"

[function]
name = "creep_coefficients.spin"
ratio = 1.0
poisson = [0.25]

[[expect]]
quantity = "creep_coefficient"
value = 1.47
unit = ""
tolerance = 1e-12
"""


def holds(path, section):
    return section in tomllib.loads(path.read_text(encoding="utf-8"))


def physics(path):
    if holds(path, "function"):
        return read_function_case(path).function.physics
    return FITS if holds(path, "fit") else physics_of(read_study(path))


def outside(source):
    """Return the sources that are not our own: first author and year of what was published, and other codes."""
    found = {code for code in ("CONTACT", "LAMMPS") if source.startswith(code)}
    for part in source.split(";"):
        message = re.search(r"(?:[A-Z]\.[ -]?)+ ?([A-Z][a-z][\w-]+).*?\b((?:18|19|20)\d\d)\b", part)
        if message:
            found.add(" ".join(message.groups()))
    return found


def test_what_an_outside_source_is():
    assert outside("H. Hertz, J. reine angew. Math. 92 (1882) 156-171; K. L. Johnson, Cambridge (1985)") == {
        "Hertz 1882",
        "Johnson 1985",
    }
    assert outside("CONTACT (J. J. Kalker, E. A. H. Vollebregt), nu = 0") == {"CONTACT"}
    assert outside("own lines of 32 waves with random phases") == set()


def test_second_solvers_of_our_own_are_graded_as_such():
    """They verify the code and not the physics, as do formulas of the springs themselves."""
    own = re.compile(r"^own |^independent |the springs' own|another root finder|rule of springs|ahead of the")
    for path in case_files():
        content = tomllib.loads(path.read_text(encoding="utf-8"))
        if own.search(content["source"]):
            assert content["grade"] in ("independent implementation", "measured"), path.stem


@pytest.mark.slow
def test_every_physics_has_two_outside_sources():
    sources = {chapter: set() for chapter in CHAPTERS}
    for path in case_files():
        sources[physics(path)] |= outside(tomllib.loads(path.read_text(encoding="utf-8"))["source"])
    few = {chapter: found for chapter, found in sources.items() if len(found) < 2 and chapter != "other contacts"}
    assert few == {}


def test_no_case_says_the_same_as_another():
    """Problem, sweep and expectations of any two cases differ."""
    stems: dict[str, str] = {}
    for path in case_files():
        content = tomllib.loads(path.read_text(encoding="utf-8"))
        message = repr([content.get(key) for key in ("problem", "function", "sweep", "fit", "expect")])
        assert message not in stems, (path.stem, stems[message])
        stems[message] = path.stem


@pytest.mark.parametrize(
    ("name", "chapter"),
    [
        ("coated_pressure", "coatings"),
        ("graded_moduli", "graded bodies"),
        ("hertz_axis_stress", "fields"),
        ("hertz_paraboloid", "normal contact"),
        ("jkr_pull_off", "adhesion"),
        ("lubkin_table", "friction and impacts"),
        ("ting_power_law_cell", "bodies that relax"),
        ("two_spots_bem", "current and heat"),
        ("heating_speeds", "frictional heat"),
        ("shakedown_limit", "rolling"),
        ("limiting_profile_half_core", "wear"),
        ("fit_jkr", "fits"),
        ("maugis_parameter_unit", "adhesion"),
    ],
)
def test_a_case_is_in_its_chapter(name, chapter):
    assert physics(CASES / f"{name}.toml") == chapter
    assert chapter in CHAPTERS


def test_cases_solve_problems_that_are_there():
    contents = [tomllib.loads(path.read_text(encoding="utf-8")) for path in case_files()]
    solved = {content["problem"]["kind"] for content in contents if "problem" in content}
    assert solved <= set(CATALOGUE["problem"])
    assert {content["function"]["name"] for content in contents if "function" in content} == set(FUNCTIONS)


def test_the_functions_are_in_chapters_and_answer_with_words():
    for name, function in FUNCTIONS.items():
        assert function.physics in CHAPTERS, name
        assert function.answer in GLOSSARY, name
        assert set(function.units) == set(inspect.signature(function.call).parameters), name


def test_what_no_table_knows_is_another_contact():
    class Strange:
        bed = None

    assert physics_of(Study("x", Strange())) == "other contacts"


def test_a_sweep_is_checked_point_by_point(tmp_path):
    (tmp_path / "swept.toml").write_text(SWEPT, encoding="utf-8")
    entry = run_case(tmp_path / "swept.toml")
    assert entry.passed
    assert [float(verdict.expectation.expected) for verdict in entry.verdicts] == [0.25, 0.5, 0.125, 0.5]
    assert entry.points == ("curvature_radius = 1 m",) * 2 + ("curvature_radius = 2 m",) * 2
    assert "| depth at curvature_radius = 2 m | 0.125 m | 0.125 m |" in markdown([entry])
    (tmp_path / "swept.toml").write_text(SWEPT.replace("0.125]", "0.126]"), encoding="utf-8")
    assert [verdict.passed for verdict in run_case(tmp_path / "swept.toml").verdicts] == [True, True, False, True]
    (tmp_path / "swept.toml").write_text(SWEPT.replace("0.125]", "0.125, 0.1]"), encoding="utf-8")
    assert "expect: depth has 1 values, but 3 are expected" in run_case(tmp_path / "swept.toml").failure


def written(tmp_path, text):
    (tmp_path / "curve.csv").write_bytes((CASES / "curves" / "fit_hertz.csv").read_bytes())
    (tmp_path / "fitted.toml").write_text(text, encoding="utf-8")
    return tmp_path / "fitted.toml"


def test_a_fit_is_checked(tmp_path):
    entry = run_case(written(tmp_path, FITTED))
    assert entry.passed
    assert entry.physics == FITS
    assert entry.digits > 6.0
    assert not run_case(written(tmp_path, FITTED.replace("4000.0", "4001.0"))).passed


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('source = "H. Hertz"\n', "", "a case needs source"),
        ('grade = "analytical"', 'grade = "sure"', "grade: 'sure' is not known; give one of analytical"),
        (
            'quantity = "problem.bed.medium.first.young"',
            'quantity = "problem.bed.young"',
            "asks for 'problem.bed.young', which is not free",
        ),
        ("tolerance = 1e-6\n", "", "expect needs tolerance; add it"),
        ("value = 4000.0", 'value = "4000 N"', "fitted.toml: expect: value: '4000 N' is a force"),
        ('curve = "curve.csv"', 'curve = "gone.csv"', "gone.csv"),
    ],
)
def test_wrong_fits_are_refused(tmp_path, old, new, sentence):
    assert old in FITTED
    with pytest.raises(InvalidInput) as caught:
        run_case(written(tmp_path, FITTED.replace(old, new)))
    assert sentence in str(caught.value)


def test_a_function_is_checked(tmp_path):
    path = tmp_path / "spin.toml"
    path.write_text(FUNCTION_CASE.replace("[0.25]", "0.25"), encoding="utf-8")
    entry = run_case(path)
    assert entry.passed
    assert (entry.physics, entry.verdicts[0].got) == ("rolling", 1.47)
    path.write_text(FUNCTION_CASE.replace("[0.25]", "0.25").replace("1.47", "1.48"), encoding="utf-8")
    assert not run_case(path).passed
    path.write_text(FUNCTION_CASE.replace("[0.25]", "0.7"), encoding="utf-8")
    assert "Poisson's ratio is 0.7; the table goes from 0 to 0.5" in run_case(path).failure
    with pytest.raises(InvalidInput, match=r"a section \[function\]: it is a case of the ledger; `winkler validate"):
        read_study(path)


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        (
            "creep_coefficients.spin",
            "creep_coefficients.spun",
            "(did you mean 'creep_coefficients.spin'?); give",
        ),
        ("poisson = [0.25]", "", "function.poisson is missing; creep_coefficients.spin takes ratio, poisson."),
        ("poisson = [0.25]", "poisson = 0.25\nnu = 1", "function.nu is not known; creep_coefficients.spin takes"),
        ("poisson = [0.25]", 'poisson = "1 mm"', "spin.toml: function.poisson: '1 mm'"),
        ('"creep_coefficient"', '"restitution"', "expect asks for 'restitution'; creep_coefficients.spin answers with"),
        ('unit = ""\n', 'unit = ""\nr = "0 m"\n', "answers with creep_coefficient, at no place"),
        ("tolerance = 1e-12\n", "", "spin.toml: expect needs tolerance; add it."),
        ("[[expect]]", "[expect]", "expect is no list of tables; write it with two brackets, as [[expect]]."),
        ('grade = "published table"', "", "a case needs grade"),
        ("title =", "titel =", "titel is not known (did you mean 'title'?); a case with [function] has"),
    ],
)
def test_wrong_functions_are_refused(tmp_path, old, new, sentence):
    (tmp_path / "spin.toml").write_text(FUNCTION_CASE.replace(old, new).replace("[0.25]", "0.25"), encoding="utf-8")
    with pytest.raises(InvalidInput) as caught:
        run_case(tmp_path / "spin.toml")
    assert sentence in str(caught.value)


def test_a_curve_that_cannot_be_fitted_is_missed(tmp_path):
    path = written(tmp_path, FITTED)
    lines = (tmp_path / "curve.csv").read_text(encoding="utf-8").splitlines()
    (tmp_path / "curve.csv").write_text("\n".join(lines[:5]) + "\n", encoding="utf-8")
    entry = run_case(path)
    assert not entry.passed
    assert entry.failure
    (part,) = chapters([entry])
    assert part.missed == 1


def test_fit_cases_of_the_package():
    for path in case_files():
        if holds(path, "fit"):
            case = read_fit_case(path)
            assert case.source
            assert case.expect
            assert all(source.endswith(".csv") for source in case.study.sources)
