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
from python_of_kinds import NEWER

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
QUARTZ = wk.TransverselyIsotropic(162e9, 92e9, 69e9, 181e9, 47e9)
HALF_SPACE = wk.HalfSpace(STEEL)
CERAMIC = wk.PowerLawGraded(young=220e9, depth_scale=1e-3, exponent=0.15, poisson=0.25)
HARD = wk.Layer(wk.Elastic(450e9, 0.25), thickness=50e-6)
SLIDES = wk.StackLayer(HARD.solid, HARD.thickness, bonded=False)
CASE = wk.ExponentialGrading(surface_young=380e9, deep_young=210e9, depth_scale=0.2e-3, poisson=0.3)


def pressed(profile, medium=HALF_SPACE, load=wk.Force(100.0)):  # noqa: B008 (values are immutable)
    return wk.Indentation(wk.Foundation(profile, medium), load)


RADII = np.linspace(0.0, 1e-3, 6)
BALL = wk.Sphere(10e-3)
STICKY = wk.ShortRange(work=0.05)
BED = wk.Foundation(BALL, HALF_SPACE)


RUBBER = wk.Coulomb(0.3)
AT_100 = wk.Start(wk.Force(100.0))
RUBBED = wk.Program([AT_100, wk.Ramp(wk.Force(200.0)), wk.Oscillate(lateral=wk.Shift(5e-7), cycles=2.0), wk.Hold(1.0)])


def stuck(law):
    return wk.AdhesiveIndentation(BED, law, wk.Force(100.0))


PYTHON = {
    "sphere": pressed(BALL),
    "paraboloid": pressed(wk.Paraboloid(10e-3)),
    "power_law": pressed(wk.PowerLaw(1e6, 4.0)),
    "cone": pressed(wk.Cone(math.radians(70.3))),
    "ellipsoid": pressed(wk.Ellipsoid(10e-3, 5e-3)),
    "ball_in_socket": pressed(wk.BallInSocket(10e-3, 10.1e-3)),
    "hyperboloid": pressed(wk.Hyperboloid(1e-3, math.radians(70.0))),
    "flat_punch": pressed(wk.FlatPunch(1e-3)),
    "rounded_punch": pressed(wk.RoundedPunch(0.5e-3, 1e-3)),
    "truncated_cone": pressed(wk.TruncatedCone(math.radians(80.0), 0.1e-3)),
    "truncated_paraboloid": pressed(wk.TruncatedParaboloid(10e-3, 0.2e-3)),
    "capped_paraboloid": pressed(wk.CappedParaboloid(10e-3, 20e-3, 0.1e-3)),
    "rounded_cone": pressed(wk.RoundedCone(1e-3, math.radians(70.3))),
    "sphero_conical": pressed(wk.SpheroConical(1e-3, math.radians(60.0))),
    "berkovich": pressed(wk.Berkovich()),
    "vickers": pressed(wk.Vickers()),
    "cube_corner": pressed(wk.CubeCorner()),
    "pyramid": pressed(wk.Pyramid(4, math.radians(68.0))),
    "pyramid_by_edges": pressed(wk.PyramidByEdges(3, math.radians(54.7356))),
    "rounded_pyramid": pressed(wk.RoundedPyramid(4, math.radians(70.0), 1e-3)),
    "calibrated_tip": pressed(wk.CalibratedTip((24.5, 40e-6), 1e-6, 200e-6)),
    "tabulated_tip": pressed(
        wk.TabulatedTip(
            np.array([1e-6, 3e-6, 10e-6, 30e-6, 100e-6, 200e-6]),
            np.array([64.5e-12, 340.5e-12, 2850e-12, 23250e-12, 249e-9, 988e-9]),
        )
    ),
    "area_function": pressed(wk.AreaFunction((24.5, 2e-6, 3e-6))),
    "capped_cylinder": pressed(wk.CappedCylinder(0.2e-3, BALL)),
    "wavy": pressed(wk.Paraboloid(10e-3) + wk.Wavy(0.1e-6, 1e-3)),
    "sum": pressed(wk.Paraboloid(10e-3) + wk.Wavy(0.1e-6, 1e-3)),
    "formula": pressed(wk.Formula("r**2/(2*R) + r**4/(8*R**3)", R=10e-3)),
    "measured": pressed(wk.Measured(RADII, np.array([0.0, 2e-6, 8e-6, 18e-6, 32e-6, 50e-6]))),
    "designed": pressed(
        wk.Designed(np.array([0.0, 0.5e-3, 1e-3]), np.array([[0.025, 0.025], [0.075, 0.025]]), tolerance=1e-10)
    ),
    "elastic": pressed(BALL),
    "rigid": pressed(BALL, wk.HalfSpace.between(STEEL, wk.Rigid())),
    "named_elastic": pressed(BALL, wk.HalfSpace(wk.NamedElastic("fused silica"))),
    "transversely_isotropic": pressed(BALL, wk.TransverselyIsotropicHalfSpace(QUARTZ)),
    "power_law_graded": pressed(BALL, wk.GradedHalfSpace.between(CERAMIC)),
    "layer": pressed(BALL, wk.CoatedHalfSpace([HARD], on=STEEL)),
    "stack_layer": pressed(BALL, wk.StackedHalfSpace([SLIDES], on=STEEL)),
    "exponential_grading": pressed(BALL, wk.DepthGradedHalfSpace(CASE, tolerance=1e-2)),
    "sigmoidal_grading": pressed(
        BALL, wk.DepthGradedHalfSpace(wk.SigmoidalGrading(380e9, 210e9, 0.2e-3, 0.1e-3, 0.3), tolerance=1e-2)
    ),
    "tabulated_grading": pressed(
        BALL,
        wk.DepthGradedHalfSpace(
            wk.TabulatedGrading((0.0, 0.1e-3, 0.3e-3, 0.6e-3), (380e9, 340e9, 240e9, 210e9), (0.24, 0.26, 0.29, 0.3)),
            tolerance=1e-2,
        ),
    ),
    "half_space": pressed(BALL),
    "transversely_isotropic_half_space": pressed(BALL, wk.TransverselyIsotropicHalfSpace.between(QUARTZ)),
    "graded_half_space": pressed(BALL, wk.GradedHalfSpace(CERAMIC)),
    "coated_half_space": pressed(BALL, wk.CoatedHalfSpace((HARD,), STEEL)),
    "sliding_film": pressed(BALL, wk.SlidingFilm((HARD,), STEEL)),
    "stacked_half_space": pressed(BALL, wk.StackedHalfSpace((SLIDES,), STEEL)),
    "depth_graded_half_space": pressed(BALL, wk.DepthGradedHalfSpace(CASE, wk.Rigid(), 1e-2)),
    "foundation": pressed(BALL),
    "plane_foundation": wk.Indentation(wk.PlaneFoundation(BALL, HALF_SPACE), wk.Force(100.0)),
    "measured_bed": wk.Indentation(
        wk.MeasuredBed(
            np.linspace(0.05e-3, 0.3e-3, 6),
            np.linspace(11.5e6, 69e6, 6),
            np.array([0.25e-6, 1e-6, 2.25e-6, 4e-6, 6.25e-6, 9e-6]),
        ),
        wk.Force(100.0),
    ),
    "force": pressed(BALL),
    "short_range": stuck(STICKY),
    "dugdale": stuck(wk.Dugdale(0.05, 1e6)),
    "derjaguin_muller_toporov": stuck(wk.DerjaguinMullerToporov(0.05)),
    "depth": pressed(BALL, load=wk.Depth(5e-6)),
    "radius": pressed(BALL, load=wk.Radius(0.1e-3)),
    "shift": wk.AdhesiveShear(BED, STICKY, wk.Force(100.0), wk.Shift(1e-9)),
    "shear_force": wk.AdhesiveShear(BED, STICKY, wk.Force(100.0), wk.ShearForce(1e-3)),
    "indentation": pressed(BALL),
    "adhesive_indentation": stuck(STICKY),
    "pull_off": wk.PullOff(BED, STICKY),
    "equilibrium": wk.Equilibrium(BED, STICKY, reach=10e-6, count=200),
    "adhesive_cycle": wk.AdhesiveCycle(
        BED, STICKY, wk.Depth(np.concatenate([np.linspace(-5e-9, 5e-9, 41), np.linspace(5e-9, -5e-9, 41)]))
    ),
    "adhesive_shear": wk.AdhesiveShear(BED, STICKY, wk.Force(100.0), wk.ShearForce(1e-3)),
    "yield_onset": wk.YieldOnset(wk.Foundation(BALL, wk.HalfSpace(wk.Elastic(210e9, 0.3, strength=700e6)))),
    "angle": wk.Torsion(BED, RUBBER, wk.Path([0.0, 1.0, 2.0], wk.Force(100.0), wk.Angle(1e-3))),
    "torque": wk.Torsion(BED, RUBBER, wk.Path([0.0, 1.0, 2.0], wk.Force(100.0), wk.Torque(1e-3))),
    "coulomb": wk.Tangential(BED, RUBBER, RUBBED),
    "static_kinetic": wk.Tangential(BED, wk.StaticKinetic(0.4, 0.3), RUBBED),
    "path": wk.Tangential(
        BED, RUBBER, wk.Path([0.0, 1.0, 2.0], wk.Force(100.0), wk.Shift(np.array([0.0, 5e-7, -5e-7])))
    ),
    **{kind: wk.Tangential(BED, RUBBER, RUBBED) for kind in ("program", "start", "ramp", "hold", "oscillate")},
    "circle": wk.Tangential(BED, RUBBER, wk.Program([AT_100, wk.Circle(wk.Shift(5e-7))])),
    "follow": wk.Tangential(
        BED,
        RUBBER,
        wk.Program(
            [
                AT_100,
                wk.Follow(
                    wk.Path([0.0, 1.0, 2.0], wk.Force(100.0), wk.Shift(np.array([0.0, 5e-7, -5e-7]))),
                    cycles=2,
                ),
            ]
        ),
    ),
    "tangential": wk.Tangential(BED, RUBBER, RUBBED),
    "torsion": wk.Torsion(
        BED,
        RUBBER,
        wk.Program([wk.Start(wk.Force(100.0), wk.Angle(0.0)), wk.Oscillate(lateral=wk.Angle(2e-3), cycles=1.25)]),
    ),
    "coated_tangential": wk.CoatedTangential(
        wk.Foundation(BALL, wk.CoatedHalfSpace([wk.Layer(wk.Elastic(450e9, 0.25), 50e-6)], on=STEEL, second=STEEL)),
        RUBBER,
        wk.Program([wk.Start(wk.Force(100.0), wk.Shift(0.0)), wk.Oscillate(lateral=wk.Shift(5e-7), cycles=1.25)]),
    ),
    "friction_damping": wk.FrictionDamping(BED, RUBBER, wk.Force(100.0), wk.Shift(5e-7)),
    "bimodal_damping": wk.BimodalDamping(
        BED, RUBBER, depth=3e-6, depth_amplitude=1e-6, shift_amplitude=5e-7, phase=math.radians(90.0)
    ),
    "relaxation_damper": wk.RelaxationDamper(BED, depth=3e-6, depth_amplitude=1e-6, frequency=100.0),
    "impact": wk.Impact(BED, RUBBER, mass=33e-3, velocity=1.0, lateral_velocity=0.5, inertia=1.3e-6, lever=10e-3),
    "adhesive_impact": wk.AdhesiveImpact(BED, STICKY, mass=33e-3, velocity=1e-3),
    "elastic_plastic_particle": wk.ElasticPlasticParticle(
        1e-3, wk.Elastic(1e9, 0.3, strength=20e6), wk.Depth(np.array([20e-6, 40e-6, 0.0]))
    ),
    **NEWER,
}
RUN = {"indentation", "adhesive_cycle", "tangential", "line_tangential", "surface_contact"}
"""Problems that are run in Python, too: the command line calls it, so that a few of each form of answer are enough."""
LIGHT = "\n[output]\nfigures = []\nreport = false\n"


def test_every_kind_is_in_the_table():
    assert set(PYTHON) == set(kinds())


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


@pytest.mark.parametrize("kind", list(PYTHON))
def test_same_problem(kind):
    problem, text = PYTHON[kind], whole_text(kind)
    study = parse_study(text)
    assert study.problem == problem
    assert parse_study(study_text(study)) == study


FIRST = {next(iter(table)) for table in CATALOGUE.values()}
"""One part of each slot: that the problems which hold the others are equal is tested for all."""
SOLVED = [kind for kind in PYTHON if kind in CATALOGUE["problem"] or kind in FIRST]


PARTS = [kind for kind in PYTHON if kind not in SOLVED]


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
    problem, text = PYTHON[kind], whole_text(kind)
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
