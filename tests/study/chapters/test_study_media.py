"""Studies on coated, graded and measured contacts: read from files, swept, reported, and written down again."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import winkler as wk
from winkler.study.batch.run import run
from winkler.study.chapters.contents import formulas_of
from winkler.study.language.build import build, unbuild
from winkler.study.language.reading import parse_study, read_study
from winkler.study.language.study import Fields, Output, Study
from winkler.study.language.writing import study_text
from winkler.study.report.describe import in_words, inputs
from winkler.study.report.mathml import formula
from winkler.study.report.report import page

STEEL = wk.Elastic(210e9, 0.3)
STACK = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(180e9, 0.22), 2e-6), wk.Layer(wk.Elastic(279e9, 0.21), 5e-7)], on=STEEL)
SOIL = wk.GradedHalfSpace(wk.PowerLawGraded(30e6, 1.0, 0.5, 0.3))
RADII = np.linspace(1e-5, 1e-4, 12)
MEASURED = wk.MeasuredBed(RADII, 2e11 * RADII, RADII**2 / 1e-2, mindlin_ratio=0.8)
CASE = wk.DepthGradedHalfSpace(wk.TabulatedGrading([0.0, 1e-3], [2e9, 1e9], [0.3, 0.3]), tolerance=1e-2)


def ball_on(medium, load=wk.Depth(1e-7)):  # noqa: B008 (values are immutable)
    return wk.Indentation(wk.Foundation(wk.Paraboloid(5e-5), medium), load)


@pytest.fixture
def here(tmp_path, monkeypatch):
    """An empty folder that is the current one."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_force_curve_in_a_file_answers_like_the_same_in_python(here):
    depth = np.linspace(0.0, 1e-6, 40)
    (here / "curve.csv").write_text(
        "depth [nm], force [mN]\n" + "".join(f"{d * 1e9!r}, {5e9 * d**1.5!r}\n" for d in depth.tolist()),
        encoding="utf-8",
    )
    text = """
[problem]
kind = "indentation"
load = { kind = "force", force = ["1 mN", "2 mN"] }
[problem.bed]
kind = "measured_bed"
file = "curve.csv"
modulus = "70 GPa"
mindlin_ratio = 0.85
"""
    study = parse_study(text)
    python = wk.Indentation(
        wk.read_bed("curve.csv", modulus=70e9, mindlin_ratio=0.85), wk.Force(np.array([1e-3, 2e-3]))
    )
    assert study.problem == python
    assert parse_study(study_text(study)) == study  # the points, not the file
    answers = run(study).points[0].answers
    np.testing.assert_allclose(answers["depth"], (np.array([1e-3, 2e-3]) / 5e6) ** (2 / 3), rtol=1e-6)


def test_a_grading_in_a_file_with_one_poissons_ratio(here):
    (here / "case.csv").write_text("depth [um], young [GPa]\n0, 380\n200, 250\n600, 210\n", encoding="utf-8")
    table = {"kind": "tabulated_grading", "file": "case.csv", "poisson": 0.3}
    found = build(table, "grading")
    assert found == wk.read_grading("case.csv", poisson=0.3)
    assert build(unbuild(found), "grading") == found


@pytest.mark.slow
def test_a_thickness_of_one_layer_and_the_solid_of_another_can_be_swept():
    text = (
        study_text(Study("x", ball_on(STACK)))
        + """
[sweep]
"problem.bed.medium.layers.0.thickness" = ["1 um", "4 um"]
"problem.bed.medium.layers.1.solid.young" = ["279 GPa"]
"""
    )
    study = parse_study(text)
    assert parse_study(study_text(study)) == study
    outcome = run(study)
    assert outcome.failed == ()
    force = outcome.answer("force")[:, 0]
    own = wk.HalfSpace(wk.Elastic(180e9, 0.22))
    alone = wk.Indentation(wk.Foundation(wk.Paraboloid(5e-5), own), wk.Depth(1e-7)).solve().force
    assert abs(force[1] / alone - 1.0) < abs(force[0] / alone - 1.0)  # the thicker, the less the rest matters


def test_a_designed_body_can_be_written_and_read():
    glass = wk.HalfSpace.between(wk.Elastic(70e9, 0.2))
    t = np.linspace(0.0, 1.0, 61)[1:]
    body = wk.design_profile(1e-6 * t, 0.1 * (t**1.5 + t**3), glass)
    study = Study("x", wk.Indentation(wk.Foundation(body, glass), wk.Depth(5e-7)))
    assert parse_study(study_text(study)) == study


PROBLEMS = {
    "stack": ball_on(STACK),
    "soil": ball_on(SOIL),
    "case": ball_on(CASE),
    "measured": wk.Indentation(MEASURED, wk.Depth(1e-7)),
    "punch on a stack": wk.Indentation(wk.Foundation(wk.FlatPunch(1e-6), STACK), wk.Depth(1e-8)),
}


@pytest.mark.parametrize("name", PROBLEMS)
def test_formulas_can_be_shown_and_do_not_claim_equal_springs(name):
    found = formulas_of(PROBLEMS[name])
    assert len(found) >= 3
    for one in found:
        assert formula(one.latex).startswith("<math")
    text = " ".join(one.latex for one in found)
    assert "c_N" in text
    assert "q_z(x) = E^*" not in text
    assert ("\\le d" in text) == (name == "punch on a stack")


def test_the_formula_of_the_layered_profile_is_the_one_that_is_computed():
    """g(a) phi(a;a) = h(a) - Int rho h, with phi and rho from an independent solution of the stated equations."""
    film = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1e9, 0.3), 1.0)], on=wk.Elastic(2e9, 0.3))
    a, curvature = 0.7, 10.0
    response = film.response
    xi, weight = np.polynomial.legendre.leggauss(400)
    xi, weight = 15.0 * (xi + 1.0), 15.0 * weight  # M falls like exp(-2 xi)
    excess = np.real(response.excess(xi.astype(complex)))
    node, step = np.polynomial.legendre.leggauss(30)
    t, dt = 0.5 * a * (node + 1.0), 0.5 * a * step

    def kernel(x, y):
        waves = np.cos(np.multiply.outer(x, xi)) * (weight * excess) @ np.cos(np.multiply.outer(y, xi)).T
        return 2.0 / np.pi * waves

    matrix = np.eye(t.size) + kernel(t, t) * dt
    edge = np.array([a])
    phi = np.linalg.solve(matrix, np.ones(t.size))
    rho = np.linalg.solve(matrix, kernel(t, edge)[:, 0])
    phi_edge = 1.0 - float(kernel(edge, t)[0] @ (dt * phi))
    gap = (a**2 / curvature - float(np.sum(dt * rho * t**2 / curvature))) / phi_edge
    bed = wk.Foundation(wk.Paraboloid(curvature), film)
    assert float(bed.gap(edge)[0]) == pytest.approx(gap, rel=1e-9)
    assert float(bed.normal_stiffness(edge)[0]) == pytest.approx(film.modulus * phi_edge**2, rel=1e-9)
    assert float(bed.stiffness(edge)[0]) == pytest.approx(2.0 * film.modulus * float(dt @ phi), rel=1e-9)


def test_layers_are_listed_in_words_and_rows():
    study = Study("x", ball_on(STACK))
    message = in_words(study)
    assert "The coating, from the surface down: layer (" in message
    assert "thickness = 2 µm) + layer (" in message
    assert "What carries them is elastic (Young's modulus = 210 GPa" in message
    groups = list(dict.fromkeys(row.group for row in inputs(study)))
    assert [group for group in groups if "layer" in group] == [
        "layer 1",
        "layer 1, solid: elastic",
        "layer 2",
        "layer 2, solid: elastic",
        "what carries the layers: elastic",
    ]
    assert "The body below is graded: exponential grading (" in in_words(
        Study("x", ball_on(wk.DepthGradedHalfSpace(wk.ExponentialGrading(2e9, 1e9, 1e-6, 0.3))))
    )


@pytest.mark.slow
@pytest.mark.parametrize("name", ["soil", "measured"])
def test_a_report_says_what_cannot_be_shown(name):
    outcome = run(Study(name, PROBLEMS[name], output=Output(figures=())))
    text = page(outcome)
    missing = text.count("Not shown: ")
    assert missing == {"soil": 0, "measured": 4}[name]
    assert "The medium" in text
    assert "The formulas" in text


@pytest.mark.slow
def test_the_study_of_three_layers_lies_between_its_layer_and_its_stiffest_part(root):
    study = dataclasses.replace(read_study(root / "examples/studies/normal/three_layers.toml"), fields=Fields())
    outcome = run(study)
    assert outcome.failed == ()
    medium = study.problem.bed.medium
    apparent = (outcome.answer("stiffness") / (2.0 * outcome.answer("radius")))[:, 0]
    tip = wk.Elastic(1140e9, 0.07)
    soft = wk.HalfSpace(wk.Elastic(180e9, 0.22), tip).modulus
    hard = wk.HalfSpace(wk.Elastic(300e9, 0.24), tip).modulus
    assert medium.modulus == pytest.approx(soft, rel=1e-14)
    assert np.all((apparent > soft) & (apparent < hard))
    assert np.all(np.diff(apparent) > 0.0)
    assert outcome.answer("depth")[:, 0].tolist() == pytest.approx([1e-8, 2e-8, 5e-8, 1e-7, 2e-7, 3e-7], rel=1e-12)
