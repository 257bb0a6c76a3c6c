"""Viscoelastic contacts in study files: solids from files, temperatures, marches, sweeps, figures, reports."""

from __future__ import annotations

import csv
import dataclasses
import math

import numpy as np
import pytest

import winkler as wk
from winkler.cli import main
from winkler.io.processes.stopping import INTERRUPTED
from winkler.study.batch.marching import solve_march
from winkler.study.batch.outcome import answers_of
from winkler.study.batch.run import run
from winkler.study.batch.sweep import solve_points
from winkler.study.chapters.contents import formulas_of
from winkler.study.chapters.relaxing_bodies import RELAXING_BODIES
from winkler.study.chapters.viscoelastic import VISCOELASTIC
from winkler.study.chapters.viscoelastic_surfaces import VISCOELASTIC_SURFACES
from winkler.study.language.build import build, unbuild
from winkler.study.language.explain import example_study
from winkler.study.language.reading import parse_study
from winkler.study.language.study import Study
from winkler.study.language.varied import Axis
from winkler.study.language.writing import study_text
from winkler.study.report.citing import cite
from winkler.study.report.describe import in_words, inputs
from winkler.study.report.figure import ReportFigure
from winkler.study.report.figures import figures_of
from winkler.study.report.mathml import formula
from winkler.study.report.report import page
from winkler.values.errors import InvalidInput, OutsideValidity

RUBBER = wk.StandardSolid(relaxed_shear=1e6, shear=3e6, relaxation_time=0.1)
BED = wk.Foundation(wk.Paraboloid(10e-3), wk.ViscoelasticHalfSpace(RUBBER))
TIME = np.linspace(0.0, 0.4, 9)
PRESSED = wk.ViscoelasticIndentation(
    BED, wk.Path(TIME, wk.Depth(1e-4 * np.interp(TIME, [0.0, 0.1, 0.3, 0.4], [0.0, 1.0, 1.0, 0.0]))), count=40
)
SOLIDS = list(RELAXING_BODIES["solid"])
PROBLEMS = [*VISCOELASTIC.answers, *VISCOELASTIC_SURFACES.answers]

TEXT = """title = "Creep of a gel"

[problem]
kind = "creep_test"
force = "2 mN"
time = { from = "10 ms", to = "100 s", count = 5, spacing = "log" }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "1 mm" }

[problem.bed.medium]
kind = "viscoelastic_half_space"
"""
GEL = '[problem.bed.medium.first]\nkind = "at_temperature"\ntemperature = "50 degC"\n'
GEL += 'solid = { kind = "maxwell", shear = "2 kPa", relaxation_time = "3 s" }\n'
GEL += 'law = { kind = "arrhenius", reference_temperature = "20 degC", activation_energy = "60 kJ/mol" }\n'


def test_a_file_says_the_same_as_python():
    study = parse_study(TEXT + GEL)
    law = wk.Arrhenius(reference_temperature=293.15, activation_energy=60e3)
    solid = wk.AtTemperature(wk.Maxwell(2e3, 3.0), law, 323.15)
    bed = wk.Foundation(wk.Paraboloid(1e-3), wk.ViscoelasticHalfSpace(solid))
    problem = wk.CreepTest(bed, 2e-3, np.geomspace(0.01, 100.0, 5))
    assert study.problem == problem
    assert parse_study(study_text(study)) == study
    # F = 4/3 E*(a^3/R) with 1/E* replaced by (1 + t/tau)/(4 G); tau at 50 degC
    tau = 3.0 * math.exp(60e3 / 8.31446261815324 * (1.0 / 323.15 - 1.0 / 293.15))
    radius = np.cbrt(0.75 * 2e-3 * 1e-3 * (1.0 + problem.time / tau) / 8e3)
    assert run(study).solved[0].answers["radius"] == pytest.approx(radius, rel=1e-9)


def test_temperatures_are_swept():
    swept = parse_study(TEXT + GEL + '[sweep]\n"problem.bed.medium.first.temperature" = ["20 degC", "50 degC"]\n')
    cold, warm = (point.answers["depth"] for point in run(swept).solved)
    assert np.all(warm > cold)
    assert parse_study(study_text(swept)) == swept


@pytest.mark.parametrize("name", SOLIDS)
def test_every_solid_creeps(name):
    table = example_study("creep_test")["problem"]
    table["time"] = ["10 ms", "1 s"]
    table["bed"]["medium"]["first"] = example_solid(name)
    sunk = build(table).solve().depth
    assert 0.0 < sunk[0] < sunk[1] < math.inf


def example_solid(name):
    return example_study(name)["problem"]["bed"]["medium"]["first"]


@pytest.mark.parametrize(
    ("kind", "header", "rows", "read"),
    [
        (
            "relaxation_data",
            "time [s], shear [kPa]",
            [(0.1, 3.0), (1.0, 2.0), (10.0, 1.5), (99.0, 1.2)],
            wk.RelaxationData,
        ),
        (
            "creep_data",
            "time [s], compliance [1/kPa]",
            [(0.1, 1.0), (1.0, 2.0), (10.0, 2.5), (99.0, 3.0)],
            wk.CreepData,
        ),
        (
            "dynamic_data",
            "frequency [Hz], storage [kPa], loss [kPa]",
            [(0.1, 1.0, 0.1), (1.0, 1.2, 0.3), (10.0, 2.0, 0.5), (99.0, 3.0, 0.3)],
            wk.DynamicData,
        ),
    ],
)
def test_measured_solids_lie_beside_the_study(tmp_path, monkeypatch, kind, header, rows, read):
    monkeypatch.chdir(tmp_path)
    lines = [header, *(", ".join(map(str, row)) for row in rows)]
    (tmp_path / "gel.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    first = f'first = {{ kind = "{kind}", file = "gel.csv", poisson = 0.45 }}\n'
    (tmp_path / "gel.toml").write_text(TEXT + first + "[output]\nfigures = []\nreport = false\n", encoding="utf-8")
    assert main(["run", "gel.toml", "--output", "out", "--quiet"]) == 0
    again = parse_study((tmp_path / "out" / "study.toml").read_text(encoding="utf-8"))  # the points are in it
    solid = again.problem.bed.medium.first
    assert isinstance(solid, read)
    assert solid.poisson == 0.45
    with (tmp_path / "out" / "results.csv").open(encoding="utf-8") as file:
        found = [float(row["depth [m]"]) for row in csv.DictReader(file)]
    assert found == pytest.approx(again.problem.solve().depth.tolist(), rel=1e-12)


# -------------------------------------------------------------------------------------------------------- marches


def test_a_march_that_is_interrupted_keeps_what_it_reached():
    def watch(states, total):
        assert total == TIME.size
        for number, state in enumerate(states):
            if number == 4:
                raise KeyboardInterrupt
            yield state

    (point,) = solve_points(Study("", PRESSED), watch=watch)
    assert point.code == INTERRUPTED
    whole = PRESSED.solve()
    for name, content in point.answers.items():
        assert np.array_equal(content, answers_of(whole)[name][:4]), name


def test_a_march_that_breaks_off_keeps_what_it_reached():
    """A dashpot alongside takes no sudden step of depth."""
    bed = dataclasses.replace(BED, medium=wk.ViscoelasticHalfSpace(wk.KelvinVoigt(1e6, 1e5)))
    path = wk.Path([0.0, 0.1, 0.2, 0.2], wk.Depth([0.0, 1e-5, 2e-5, 3e-5]))
    march = solve_march(wk.ViscoelasticIndentation(bed, path, count=40))
    assert march.code == OutsideValidity("").exit_code
    assert march.stopped.startswith("After 3 of 4 points of the path, which are kept, the calculation ended: Visco")
    assert march.solution.time.tolist() == [0.0, 0.1, 0.2]


def test_a_program_defines_the_path():
    table = example_study("viscoelastic_indentation")["problem"]
    assert table["path"]["kind"] == "program"
    answer = build(table).solve()
    assert np.max(answer.depth) == pytest.approx(1e-4)
    assert answer.force[-1] == 0.0
    shifted = table | {"path": example_study("tangential")["problem"]["path"]}
    with pytest.raises(InvalidInput, match="problem: ViscoelasticIndentation: the path moves along the surface"):
        build(shifted)


def test_elastic_questions_about_viscoelastic_bodies_are_refused():
    with pytest.raises(OutsideValidity, match="its stiffness changes in time"):
        run(Study("", wk.Indentation(BED, wk.Force(1.0))))


# ------------------------------------------------------------------------------------------------ words and pictures


@pytest.mark.parametrize("name", PROBLEMS)
def test_every_problem_is_cited_described_and_has_formulas(name):
    problem = build(example_study(name)["problem"])
    keys = {paper.key for paper in cite(problem)}
    assert {"popov_hess_2015", "lee_radok_1960"} <= keys
    found = formulas_of(problem)
    assert len(found) >= 4
    for one in found:
        assert formula(one.latex).startswith("<math")
    assert "standard solid" in in_words(Study("", problem))
    assert all(given.text for given in inputs(Study("", problem)))


def test_the_law_of_temperature_is_among_the_formulas():
    message = [one.says for one in formulas_of(parse_study(TEXT + GEL).problem)]
    assert "which follows the law of Arrhenius" in message
    assert unbuild(parse_study(TEXT + GEL).problem.bed.medium.first)["temperature"] == "323.15 K"


@pytest.fixture
def unprinted(monkeypatch):
    """Leave figures as they are, without their SVG, where only their names matter."""

    def plain(name, title, sentence, picture):
        return ReportFigure(name, title, sentence, picture)

    monkeypatch.setattr("winkler.study.report.figures.drawn", plain)


@pytest.mark.slow
def test_figures_of_a_march():
    single = run(Study("", PRESSED))
    assert [shown.name for shown in figures_of(single)] == ["answer_relaxing"]
    text = page(single)
    assert "The method in pictures" not in text
    assert "The load of every spring is a hereditary integral of its compression" in text


def test_figures_of_a_sweep(unprinted):
    swept = run(Study("", PRESSED, sweep=(Axis("problem.bed.medium.first.relaxation_time", (0.01, 0.1)),)))
    names = [shown.name for shown in figures_of(swept)]
    of_cycles = ["loss_per_cycle", "secant_stiffness", "loss_factor"]
    assert names == [f"answer_{name}" for name in ("relaxing", "force", "force_over_time", "dissipation", *of_cycles)]


def test_restitution_is_drawn_over_what_was_varied(unprinted):
    problem = wk.ViscoelasticImpact(BED, 0.03, 1.0, count=20, tolerance=0.05)
    swept = run(Study("", problem, sweep=(Axis("problem.velocity", (0.1, 1.0, 10.0)),)))
    shown = {one.name: one for one in figures_of(swept)}
    assert "Restitution over velocity" in [one.title for one in shown.values()]
    assert swept.answer("restitution").shape[0] == 3
    assert all(one.picture is not None for one in shown.values())


@pytest.mark.slow
def test_an_oscillation_has_its_frequencies_as_rows(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    problem = wk.HarmonicIndentation(BED, wk.Depth(1e-4), [1.0, 10.0, 100.0])
    text = study_text(Study("Shaken", problem)) + "\n[output]\nfigures = []\n"
    (tmp_path / "shaken.toml").write_text(text, encoding="utf-8")
    assert main(["run", "shaken.toml", "--output", "out", "--quiet"]) == 0
    with (tmp_path / "out" / "results.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["angular_frequency [rad/s]"]) for row in rows] == [1.0, 10.0, 100.0]
    # at 10 rad/s and tau = 0.1 s: k' = 2a 4 (1 + 3/2) MPa, k'' = 2a 4 3/2 MPa, a = 1 mm
    assert float(rows[1]["storage_stiffness [N/m]"]) == pytest.approx(2e-3 * 10e6, rel=1e-12)
    assert float(rows[1]["loss_stiffness [N/m]"]) == pytest.approx(2e-3 * 6e6, rel=1e-12)
    assert "A small oscillation" in (tmp_path / "out" / "report.html").read_text(encoding="utf-8")


def test_one_frequency_is_swept_over_temperature(unprinted):
    solid = wk.AtTemperature(RUBBER, wk.Arrhenius(300.0, 8e4), 300.0)
    bed = dataclasses.replace(BED, medium=wk.ViscoelasticHalfSpace(solid))
    problem = wk.HarmonicIndentation(bed, wk.Depth(1e-4), 10.0)
    outcome = run(Study("", problem, sweep=(Axis("problem.bed.medium.first.temperature", (280.0, 300.0, 320.0)),)))
    titles = [shown.title for shown in figures_of(outcome)]
    assert "Loss tangent over temperature" in titles
    assert outcome.answer("loss_tangent")[1, 0] == pytest.approx(0.6, rel=1e-12)
