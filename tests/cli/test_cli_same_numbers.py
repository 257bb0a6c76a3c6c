"""Python, study file and command line give the same numbers to the last digit, for every kind of the catalogue."""

from __future__ import annotations

import contextlib
import csv
import io
import json
import math

import numpy as np
import pytest
from example_answers import lasting_slow, solved
from second_reading import problem_of

import winkler as wk
from winkler.cli import main
from winkler.study.batch.outcome import answers_of
from winkler.study.batch.points import Solved
from winkler.study.batch.run import run
from winkler.study.language.catalogue import CATALOGUE, kinds
from winkler.study.language.reading import parse_study
from winkler.study.language.template import whole_text
from winkler.study.language.writing import study_text

STEEL = wk.Elastic(210e9, 0.3)
BALL = wk.Sphere(10e-3)
BED = wk.Foundation(BALL, wk.HalfSpace(STEEL))
RUBBER = wk.Coulomb(0.3)
RUBBED = wk.Program(
    [
        wk.Start(wk.Force(100.0)),
        wk.Ramp(wk.Force(200.0)),
        wk.Oscillate(lateral=wk.Shift(5e-7), cycles=2.0),
        wk.Hold(1.0),
    ]
)
BLASTED = wk.SelfAffine(hurst=0.8, rms_height=0.3e-6, longest=0.5e-3, shortest=160e-6)
STAMP = wk.RandomTopography(np.array([1e-3, 1e-3]), BLASTED, (64, 64), seed=1, periodic=False)
SOLID = wk.StandardSolid(relaxed_shear=1e6, shear=3e6, relaxation_time=0.1)
STEPS = [wk.Start(wk.Depth(0.0)), wk.Ramp(wk.Depth(100e-6), duration=0.1, count=20)]
STEPS += [wk.Hold(0.2, count=10), wk.Ramp(wk.Depth(0.0), duration=0.1, count=20)]
SECTION = [36, 31, 25, 20, 18, 13, 9, 9, 4, 2, 3, 0, 1, 1, 0, 4, 3, 7, 10, 11, 17, 20, 24, 31, 35]


def pressed(profile, medium=BED.medium):
    return wk.Indentation(wk.Foundation(profile, medium), wk.Force(100.0))


BY_HAND = {
    "sphere": pressed(BALL),
    "cone": pressed(wk.Cone(math.radians(70.3))),
    "pyramid_by_edges": pressed(wk.PyramidByEdges(3, math.radians(54.7356))),
    "area_function": pressed(wk.AreaFunction((24.5, 2e-6, 3e-6))),
    "formula": pressed(wk.Formula("r**2/(2*R) + r**4/(8*R**3)", R=10e-3)),
    "measured": pressed(wk.Measured(np.linspace(0.0, 1e-3, 6), np.array([0.0, 2e-6, 8e-6, 18e-6, 32e-6, 50e-6]))),
    "designed": pressed(
        wk.Designed(np.array([0.0, 0.5e-3, 1e-3]), np.array([[0.025, 0.025], [0.075, 0.025]]), tolerance=1e-10)
    ),
    "named_elastic": pressed(BALL, wk.HalfSpace(wk.NamedElastic("fused silica"))),
    "layer": pressed(BALL, wk.CoatedHalfSpace([wk.Layer(wk.Elastic(450e9, 0.25), thickness=50e-6)], on=STEEL)),
    "sum": pressed(wk.Paraboloid(10e-3) + wk.Wavy(0.1e-6, 1e-3)),
    "adhesive_cycle": wk.AdhesiveCycle(
        BED,
        wk.ShortRange(work=0.05),
        wk.Depth(np.concatenate([np.linspace(-5e-9, 5e-9, 41), np.linspace(5e-9, -5e-9, 41)])),
    ),
    "tangential": wk.Tangential(BED, RUBBER, RUBBED),
    "impact": wk.Impact(BED, RUBBER, mass=33e-3, velocity=1.0, lateral_velocity=0.5, inertia=1.3e-6, lever=10e-3),
    "at_temperature": wk.ViscoelasticIndentation(
        wk.Foundation(
            BALL,
            wk.ViscoelasticHalfSpace(
                wk.AtTemperature(
                    SOLID,
                    wk.WilliamsLandelFerry(reference_temperature=298.15, first_constant=8.86, second_constant=101.6),
                    313.15,
                )
            ),
        ),
        wk.Program(STEPS),
        count=200,
    ),
    "measured_section": wk.LineProfileContact(
        wk.MeasuredSection(np.linspace(-0.6e-3, 0.6e-3, 25), np.array(SECTION) / 1e6),
        wk.HalfSpace(STEEL),
        wk.LineForce(200e3),
        wk.Tilt(0.0),
    ),
    "power_spectrum": wk.RoughContact(
        wk.PowerSpectrum(np.array([1e4, 1e5, 1e6]), np.array([1e-21, 4e-25, 1e-28])),
        wk.HalfSpace(STEEL),
        1e-3,
        wk.Force(np.geomspace(10.0, 200.0, 5)),
        realisations=20,
        count=1024,
    ),
    "seal": wk.Seal(
        wk.SurfaceContact(STAMP, wk.HalfSpace(STEEL), wk.Force(np.geomspace(10.0, 200.0, 5))),
        viscosity=1e-3,
        pressure_drop=1e5,
    ),
    "friction_damping": wk.FrictionDamping(BED, RUBBER, wk.Force(100.0), wk.Shift(5e-7)),
    "wiedemann_franz": wk.JouleHeating(
        wk.Indentation(BED, wk.Force(1.0)),
        wk.ElectricalConductors(*2 * [wk.ElectricalConductor(15.9e-9, 3.8e-3)]),
        wk.Current(5.0),
        wk.WiedemannFranz(2.44e-8),
    ),
}
"""One kind of each form of writing, as a person writes it in Python; all others are read a second time."""
RUN = {"indentation", "adhesive_cycle", "tangential", "line_tangential", "surface_contact"}
"""Problems that are run in Python, too: the command line calls it, so that a few of each form of answer are enough."""
LIGHT = "\n[output]\nfigures = []\nreport = false\n"


@pytest.fixture(scope="module")
def computed(tmp_path_factory):
    """Return what solves a study by the command line, the same study under another title once."""
    known = {}

    def numbers(text):
        without_title = text.partition("\n")[2]
        if without_title not in known:
            folder = tmp_path_factory.mktemp("answer")
            (folder / "study.toml").write_text(text + LIGHT, encoding="utf-8")
            with contextlib.redirect_stdout(io.StringIO()) as out:
                assert main(["run", str(folder / "study.toml"), "--json", "--output", str(folder / "answer")]) == 0
            message = {
                column["name"]: [math.inf if number == "infinite" else number for number in column["values"]]
                for column in json.loads(out.getvalue())["answers"]
            }
            with (folder / "answer" / "results.csv").open(encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            table = {name.split(" ")[0]: [float(row[name]) for row in rows] for name in rows[0]}
            known[without_title] = message, table
        return known[without_title]

    return numbers


@pytest.mark.parametrize("kind", BY_HAND)
def test_the_second_reading_is_what_a_person_writes(kind):
    assert problem_of(whole_text(kind)) == BY_HAND[kind]


@pytest.mark.parametrize("kind", kinds())
def test_same_problem(kind):
    text = whole_text(kind)
    study = parse_study(text)
    assert study.problem == problem_of(text)
    assert parse_study(study_text(study)) == study


FIRST = {next(iter(table)) for table in CATALOGUE.values()}
"""One part of each slot: that the problems which hold the others are equal is tested for all."""
SOLVED = [kind for kind in kinds() if kind in CATALOGUE["problem"] or kind in FIRST]


PARTS = [kind for kind in kinds() if kind not in SOLVED]


@pytest.mark.few(8, slow=12)
@pytest.mark.parametrize(
    "kind",
    [
        *lasting_slow(SOLVED),
        *(pytest.param(kind, marks=pytest.mark.slow) for kind in PARTS[::8]),
        *(pytest.param(kind, marks=pytest.mark.long) for kind in PARTS if kind not in PARTS[::8]),
    ],
)
def test_same_numbers(kind, computed):
    text = whole_text(kind)
    problem = problem_of(text)
    solution, study = solved(problem), parse_study(text)

    message, table = computed(text)
    assert set(message) == set(table)
    assert len(message) >= 2
    for name, numbers in message.items():
        assert numbers == table[name]
        base = name.removesuffix("_x").removesuffix("_y")
        if base != name and np.ndim(getattr(solution, base, 0.0)) > 1:  # in the plane
            expected = getattr(solution, base)[:, "xy".index(name[-1])]
        else:
            expected = np.broadcast_to(np.ravel(getattr(solution, name)).astype(float), len(numbers))
        assert numbers == expected.tolist()
    if kind in CATALOGUE["problem"]:
        answers = Solved((), (), problem, solution, tuple(answers_of(solution).items())).answers
        assert {name: content.tolist() for name, content in answers.items()} == message
    if kind in RUN:
        answers = run(study).points[0].answers
        assert {name: content.tolist() for name, content in answers.items()} == message


def test_a_result_can_be_run_again_to_the_same_numbers(tmp_path, monkeypatch):
    """study.toml in the folder of results stands on its own, measured points included."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "tip.csv").write_text(
        "radius [um], height [nm]\n" + "".join(f"{r / 7}, {r * r / 3}\n" for r in range(30)), encoding="utf-8"
    )
    text = whole_text("indentation").replace('kind = "sphere"', 'kind = "measured"\nfile = "tip.csv"')
    text = "\n".join(line for line in text.splitlines() if not line.startswith("curvature_radius"))
    text = text.replace('"100 N"', '"1 mN"')
    (tmp_path / "study.toml").write_text(text + LIGHT, encoding="utf-8")
    assert main(["run", "study.toml", "--quiet", "--output", "first"]) == 0
    (tmp_path / "tip.csv").unlink()
    assert main(["run", "first/study.toml", "--quiet", "--output", "second"]) == 0
    first, second = (json.loads((tmp_path / name / "provenance.json").read_text()) for name in ("first", "second"))
    assert first["hash"] == second["hash"]
    assert (tmp_path / "first" / "results.csv").read_text() == (tmp_path / "second" / "results.csv").read_text()
