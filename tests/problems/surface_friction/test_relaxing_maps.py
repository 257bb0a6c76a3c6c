"""Height maps under friction on bodies that relax: proportion, springs that relax, free recovery, energy, refusals."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.study.batch.run import run
from winkler.study.language.reading import parse_study
from winkler.study.report.report import report_files
from winkler.values.validity import Assumption, Standing, worst

MU, DEPTH, SHIFT = 0.3, 0.01, 8e-4
BALL = wk.Paraboloid(1.0)
RELAXED, MORE, TIME = 0.1, 0.15, 1.0
"""Shear moduli of the solid, what is left and what relaxes, and its relaxation time."""


def solid(poisson: float = 0.3, times: float = 1.0) -> wk.StandardSolid:
    return wk.StandardSolid(times * RELAXED, times * MORE, TIME, poisson=poisson)


def elastic(shear: float, poisson: float = 0.3) -> wk.Elastic:
    return wk.Elastic(2.0 * shear * (1.0 + poisson), poisson)


PAIR = wk.ViscoelasticHalfSpace(solid(0.0), solid(0.0))
"""Bodies that are alike and without Poisson's ratio: round contacts know their slip exactly."""


def map_of(count: int = 33) -> wk.SampledProfile:
    return wk.SampledProfile([0.25, 0.25], BALL, (count, count))


def layers(shear: float) -> wk.CoatedHalfSpace:
    return wk.CoatedHalfSpace([wk.Layer(elastic(shear), 0.05)], elastic(3.0 * shear), wk.Rigid())


GLASS = RELAXED + MORE
MEDIA = {
    "alike": (PAIR, lambda shear: wk.HalfSpace.between(elastic(shear, 0.0), elastic(shear, 0.0))),
    "on a rigid body": (wk.ViscoelasticHalfSpace(solid()), lambda shear: wk.HalfSpace(elastic(shear))),
    "under a rigid body": (
        wk.ViscoelasticHalfSpace(wk.Rigid(), solid()),
        lambda shear: wk.HalfSpace(wk.Rigid(), elastic(shear)),
    ),
    "dissimilar": (
        wk.ViscoelasticHalfSpace(solid(), solid(0.1, 2.0)),
        lambda shear: wk.HalfSpace(elastic(shear), elastic(2.0 * shear, 0.1)),
    ),
    "layers": (wk.RelaxingInProportion(layers(RELAXED), solid(), RELAXED), layers),
}


@pytest.mark.parametrize(
    "name", [*list(MEDIA)[:2], *(pytest.param(n, marks=pytest.mark.slow) for n in list(MEDIA)[2:])]
)
def test_all_relaxes_in_proportion_after_sudden_steps(name):
    """Held where they are, bodies bear what elastic ones do times the course of the modulus, to the solver's error."""
    relaxing, elastic_like = MEDIA[name]
    time = np.array([0.0, 0.1, 1.0, 30.0])
    path = wk.Path(time, wk.Depth(DEPTH), wk.Shift(SHIFT))
    held = wk.SurfaceTangential(map_of(), relaxing, wk.Coulomb(MU), path).solve()
    once = wk.SurfaceTangential(
        map_of(), elastic_like(GLASS), wk.Coulomb(MU), wk.Path([0.0], wk.Depth(DEPTH), wk.Shift(SHIFT))
    ).solve()
    fall = (RELAXED + MORE * np.exp(-time / TIME)) / GLASS
    np.testing.assert_allclose(held.force, fall * once.force[0], rtol=2e-6)
    np.testing.assert_allclose(held.shear_force[:, 0], fall * once.shear_force[0, 0], rtol=1e-5)
    np.testing.assert_allclose(held.friction_loss, once.dissipation[0], rtol=1e-5)
    assert 0.05 < once.stick_share[0] < 0.95
    assert held.stored_energy[0] == pytest.approx(once.stored_energy[0], rel=1e-5)
    # a term stores M e^(-2 t/T): at rest the dashpots lose what is no longer stored
    lost = held.stored_energy[0] * MORE * (1.0 - np.exp(-2.0 * time / TIME)) / GLASS
    np.testing.assert_allclose(held.bulk_loss, lost, rtol=1e-4, atol=1e-5 * held.stored_energy[0])
    np.testing.assert_allclose(held.stored_energy + held.bulk_loss, held.stored_energy[0], rtol=1e-5)


@pytest.mark.parametrize(("duration", "shear"), [(1e-7, GLASS), (1e7, RELAXED)])
@pytest.mark.parametrize("by_load", [False, True])
def test_fast_and_slow_paths_are_those_of_the_glassy_and_the_relaxed_bodies(duration, shear, by_load):
    """At every point, with a twist and a rigid body, which is dissimilar."""
    relaxing, elastic_like = MEDIA["on a rigid body"]
    most = MU * wk.SurfaceContact(map_of(), elastic_like(shear), wk.Depth(DEPTH)).solve().force
    depth = DEPTH * np.array([0.0, 1.0, 1.0, 1.0, 1.0])
    part = np.array([0.0, 0.0, 0.3, 0.6, -0.2])
    lateral = wk.ShearForce(part * most) if by_load else wk.Shift(part * 3e-3)
    twist = wk.Angle(0.01 * part)
    path = wk.Path(duration * np.arange(5.0), wk.Depth(depth), lateral)
    one, other = (
        wk.SurfaceTangential(map_of(), medium, wk.Coulomb(MU), path, twist).solve()
        for medium in (relaxing, elastic_like(shear))
    )
    for name in ("force", "shear_force", "shift", "torque", "friction_loss", "stick_share"):
        mine, its = np.asarray(getattr(one, name)), np.asarray(getattr(other, name))
        np.testing.assert_allclose(mine, its, rtol=0.0, atol=2e-5 * np.max(np.abs(its)), err_msg=name)


def test_an_elastic_and_a_relaxing_body_that_keep_their_volume_relax_as_one():
    """A spring in series with a standard solid is a standard solid: G g/(G+g), and T (G+g)/(G_r+g)."""
    other = 0.3
    pair = wk.ViscoelasticHalfSpace(solid(0.5), elastic(other, 0.5))
    time = np.array([0.0, 0.2, 1.0, 30.0])
    path = wk.Path(time, wk.Depth(DEPTH), wk.Shift(SHIFT))
    held = wk.SurfaceTangential(map_of(), pair, wk.Coulomb(MU), path).solve()
    glassy, relaxed = (4.0 * shear * other / (shear + other) for shear in (GLASS, RELAXED))
    fall = relaxed + (glassy - relaxed) * np.exp(-time / TIME * (RELAXED + other) / (GLASS + other))
    once = wk.SurfaceTangential(
        map_of(), wk.HalfSpace(elastic(GLASS, 0.5), elastic(other, 0.5)), wk.Coulomb(MU),
        wk.Path([0.0], wk.Depth(DEPTH), wk.Shift(SHIFT)),
    ).solve()  # fmt: skip
    assert once.force[0] == pytest.approx(4.0 / 3.0 * glassy * DEPTH**1.5, rel=3e-3)
    np.testing.assert_allclose(held.force, fall / glassy * once.force[0], rtol=2e-6)
    np.testing.assert_allclose(held.shear_force[:, 0], fall / glassy * once.shear_force[0, 0], rtol=1e-5)


@pytest.mark.slow
def test_two_bodies_that_keep_their_volume_are_springs_that_relax_by_functions_of_their_own():
    """Up to what Poisson's ratio does: the slip of a ball is not straight along its shear force."""
    pair = wk.ViscoelasticHalfSpace(solid(0.5), wk.StandardSolid(0.4, 0.3, 0.2 * TIME, poisson=0.5))
    path = cycle(40)
    row = wk.Tangential(wk.Foundation(BALL, pair), wk.Coulomb(MU), path, count=1000).solve()
    found = wk.SurfaceTangential(map_of(65), pair, wk.Coulomb(MU), path).solve()
    most = row.force.max()
    np.testing.assert_allclose(found.force, row.force, rtol=0.0, atol=5e-4 * most)
    np.testing.assert_allclose(found.shear_force[:, 0], row.shear_force, rtol=0.0, atol=0.03 * MU * most)


def cycle(steps: int) -> wk.Path:
    """Return a path on which a ball is pressed, pushed there and back, and nearly lifted."""
    time = np.linspace(0.0, 2.0, 2 * steps + 1)
    depth = DEPTH * np.interp(time, [0.0, 1.0, 2.0], [0.0, 1.0, 0.05])
    return wk.Path(time, wk.Depth(depth), wk.Shift(1.5e-3 * np.sin(np.pi * time)))


@pytest.fixture(scope="module")
def springs() -> wk.TangentialSolution:
    """The same by springs that relax, one by one: no pixels, no Fourier transform, steps that are halved."""
    return wk.Tangential(wk.Foundation(BALL, PAIR), wk.Coulomb(MU), cycle(40), count=1500).solve()


def apart(springs: wk.TangentialSolution, steps: int, pixels: int) -> np.ndarray:
    """Return by how much forces, shear forces and the loss to friction differ, over the greatest."""
    found = wk.SurfaceTangential(map_of(pixels), PAIR, wk.Coulomb(MU), cycle(steps)).solve()
    every, most = 40 // steps, springs.force.max()
    return np.array(
        [
            np.max(np.abs(found.force - springs.force[::every])) / most,
            np.max(np.abs(found.shear_force[:, 0] - springs.shear_force[::every])) / (MU * most),
            abs(found.friction_loss[-1] / springs.friction_loss[-1] - 1.0),
        ]
    )


def test_a_ball_as_springs_that_relax(springs):
    """Pressing errs with the pixels, slip in proportion to the steps at least."""
    coarse, fine = (apart(springs, steps, 65) for steps in (20, 40))
    assert np.all(fine < [2e-4, 1.2e-3, 0.06])
    assert np.all(coarse[1:] > 1.7 * fine[1:])


def creeping(steps: int) -> wk.Path:
    """Return a path under forces, which the bodies creep under while they are pushed to and fro."""
    time, most = np.linspace(0.0, 3.0, 3 * steps + 1), 1e-4
    normal = most * np.interp(time, [0.0, 1.0, 2.0, 3.0], [0.3, 1.0, 1.0, 0.4])
    return wk.Path(time, wk.Force(normal), wk.ShearForce(0.36 * MU * most * np.sin(3.0 * time)))


@pytest.mark.slow
def test_a_ball_that_creeps_under_forces_as_springs():
    springs = wk.Tangential(wk.Foundation(BALL, PAIR), wk.Coulomb(MU), creeping(40), count=1000).solve()
    errors = []
    for steps in (10, 40):
        found = wk.SurfaceTangential(map_of(65), PAIR, wk.Coulomb(MU), creeping(steps)).solve()
        every = slice(None, None, 40 // steps)
        assert np.max(np.abs(found.depth - springs.depth[every])) < 3e-4 * springs.depth.max()
        errors.append(np.max(np.abs(found.shift[:, 0] - springs.shift[every])) / np.max(np.abs(springs.shift)))
    assert found.friction_loss[-1] == pytest.approx(springs.friction_loss[-1], rel=0.02)
    assert errors[0] > 3.0 * errors[1]
    assert errors[1] < 2e-3


@pytest.mark.slow
def test_finer_pixels_press_nearer_to_the_springs(springs):
    errors = [apart(springs, 40, pixels)[0] for pixels in (17, 33, 97)]
    assert errors[0] > 2.0 * errors[1] > 4.0 * errors[2]


@pytest.mark.slow
def test_small_oscillations_without_slip():
    """F_x = K G(omega) / G u, once what was before is forgotten; steady steps err by their square, and a part of it."""
    omega, per, turns = 2.0, 60, 3
    time = np.append(0.0, 40.0 + np.pi / omega * 2.0 * np.arange(turns * per + 1) / per)
    shift = np.append(0.0, 1e-5 * np.sin(omega * (time[1:] - 40.0)))
    disc = wk.SampledProfile([0.25, 0.25], BALL, (17, 17))
    path = wk.Path(time, wk.Depth(DEPTH), wk.Shift(shift))
    found = wk.SurfaceTangential(disc, PAIR, wk.Coulomb(100.0), path).solve()
    once = wk.Path.through(wk.Depth(DEPTH), wk.Shift([0.0, 1e-5]))
    stiff = (
        wk.SurfaceTangential(disc, MEDIA["alike"][1](1.0), wk.Coulomb(100.0), once).solve().shear_force[-1, 0] / 1e-5
    )
    last = slice(-per, None)
    turn = np.exp(-1j * omega * time[last])
    complex_stiffness = np.sum(found.shear_force[last, 0] * turn) / np.sum(shift[last] * turn)
    expected = RELAXED + MORE * 1j * omega * TIME / (1.0 + 1j * omega * TIME)
    assert abs(complex_stiffness / stiff / expected - 1.0) < 1e-3
    lost = np.pi * 1e-10 * stiff * expected.imag  # in a cycle
    assert found.loss_per_cycle == pytest.approx(lost, rel=2e-3)
    assert found.friction_loss[-1] - found.friction_loss[-per - 1] < 1e-3 * lost


def stamp() -> wk.Topography:
    heights = np.full((33, 33), -0.1)
    heights[8:25, 8:25] = 0.0
    return wk.Topography(heights, [0.25, 0.25])


def lifted(steps: int) -> tuple[float, float]:
    """Return what a stamp bears that comes back at last, and how deep the surface still is, both in closed form."""
    held, away, back = 2.0, 3.0, 0.8 * DEPTH
    time = np.concatenate([[0.0, held, held], held + away * np.arange(1, steps + 1) / steps, [held + away]])
    depth = np.concatenate([[DEPTH, DEPTH], np.full(steps + 1, -DEPTH), [back]])
    path = wk.Path(time, wk.Depth(depth), wk.Shift(0.0))
    found = wk.SurfaceTangential(stamp(), PAIR, wk.Coulomb(MU), path).solve()
    once = wk.Path([0.0], wk.Depth(DEPTH), wk.Shift(0.0))
    stiff = wk.SurfaceTangential(stamp(), MEDIA["alike"][1](GLASS), wk.Coulomb(MU), once).solve().force[0] / DEPTH
    assert np.all(found.force[2:-1] == 0.0)
    left = 1.0 - (RELAXED + MORE * np.exp(-held / TIME)) / GLASS  # let go, it springs back by what it bore
    left *= np.exp(-RELAXED / GLASS * away / TIME)  # and recovers with its retardation time
    return float(found.force[-1] / stiff), back - left * DEPTH


def test_a_surface_that_is_let_go_recovers_freely():
    errors = [abs(mine / its - 1.0) for mine, its in map(lifted, (5, 10, 20))]
    assert errors[-1] < 2e-4
    assert errors[0] > 3.5 * errors[1] > 12.0 * errors[2]


def test_a_ball_rests_on_what_has_not_recovered():
    """Without a force the depth is that of the highest place; it falls with time to where it was at first."""
    time = np.array([0.0, 1.0, 1.0, *np.linspace(1.1, 60.0, 60)])
    force = np.zeros(time.size)
    force[:2] = 1e-4
    found = wk.SurfaceTangential(stamp(), PAIR, wk.Coulomb(MU), wk.Path(time, wk.Force(force), wk.Shift(0.0))).solve()
    rest = found.depth[2:]
    assert np.all(np.diff(rest) < 0.0)
    assert 0.3 * found.depth[1] < rest[0] < found.depth[1]
    assert rest[-1] < 1e-9 * rest[0]


def test_work_along_the_surface_is_stored_or_lost():
    """The force taken as straight between two points; the account closes in proportion to the steps."""
    left = []
    for steps in (20, 40):
        path = cycle(steps)
        found = wk.SurfaceTangential(map_of(17), PAIR, wk.Coulomb(MU), path).solve()
        work = np.trapezoid(found.shear_force[:, 0], found.shift[:, 0])
        left.append(abs(work - found.stored_energy[-1] - found.dissipation[-1]) / work)
        assert np.all(np.diff(found.friction_loss) >= -1e-12 * found.friction_loss[-1])
        assert np.all(np.diff(found.bulk_loss) >= 0.0)
        assert found.bulk_loss[-1] > 0.1 * found.friction_loss[-1] > 0.0
    assert left[0] > 1.7 * left[1]
    assert left[1] < 0.05


@pytest.mark.slow
def test_a_map_that_is_repeated_and_friction_that_falls():
    """Of any law and of periodic maps the same proportion after sudden steps."""
    x = np.arange(24) / 24
    wave = wk.Topography(1e-3 * np.cos(2.0 * np.pi * x[:, None]) * np.cos(2.0 * np.pi * x), [1.0, 1.0], periodic=True)
    law = wk.LinearSlipWeakening(0.4, 0.2, 1e-2)
    time = np.array([0.0, 0.5, 5.0])
    relaxing, elastic_like = MEDIA["alike"]
    path = wk.Path(time, wk.Depth(5e-4), wk.Shift(3e-5))
    held = wk.SurfaceTangential(wave, relaxing, law, path).solve()
    once = wk.SurfaceTangential(wave, elastic_like(GLASS), law, wk.Path([0.0], wk.Depth(5e-4), wk.Shift(3e-5))).solve()
    fall = (RELAXED + MORE * np.exp(-time / TIME)) / GLASS
    np.testing.assert_allclose(held.force, fall * once.force[0], rtol=1e-5)
    np.testing.assert_allclose(held.shear_force[:, 0], fall * once.shear_force[0, 0], rtol=1e-4)
    assert 0.0 < once.stick_share[0] < 1.0


def test_a_step_that_friction_does_not_bear_is_refused_and_what_came_before_stands():
    """Half of the friction at first is more than all of it after some time."""
    force = wk.SurfaceContact(map_of(17), MEDIA["alike"][1](GLASS), wk.Depth(DEPTH)).solve().force
    path = wk.Path([0.0, 10.0], wk.Depth(DEPTH), wk.ShearForce(0.5 * MU * force))
    states = wk.SurfaceTangential(map_of(17), PAIR, wk.Coulomb(MU), path).steps()
    assert next(states).shear_force[0] == pytest.approx(0.5 * MU * force, rel=1e-6)
    with pytest.raises(wk.OutsideValidity, match="at index 1 of the path"):
        next(states)


@pytest.mark.parametrize(
    ("medium", "reason"),
    [
        (wk.ViscoelasticHalfSpace(solid(), elastic(1.0)), "each by a function of its own"),
        (wk.ViscoelasticHalfSpace(solid(), wk.StandardSolid(1.0, 1.0, 2.0)), "each by a function of its own"),
        (wk.ViscoelasticHalfSpace(wk.KelvinVoigt(1.0, 1.0)), "a dashpot alongside"),
        (wk.PoroelasticFilm(0.1, 0.3, 1.0, 0.1), "leaves the film more slowly"),
    ],
)
def test_bodies_of_more_than_one_course_are_refused(medium, reason):
    with pytest.raises(wk.InvalidInput, match=reason):
        wk.SurfaceTangential(map_of(17), medium, wk.Coulomb(MU), cycle(2))


def test_what_is_said_of_it():
    problem = wk.SurfaceTangential(map_of(17), PAIR, wk.Coulomb(MU), cycle(4))
    found = problem.gathered(list(problem.steps())[:6])
    steady = [note for note in found.validity if "one common relaxation function" in note.statement]
    assert [note.standing for note in steady] == [Standing.ASYMPTOTIC]
    assert worst(found.validity) in (Standing.ASYMPTOTIC, Standing.APPROXIMATE)
    assert {note.assumption for note in found.validity} <= wk.SurfaceTangential.assumptions
    assert Assumption.KNOWN_TIMES in wk.SurfaceTangential.assumptions
    with pytest.raises(wk.OutsideValidity, match="on viscoelastic bodies"):
        found.stresses([0.0], [0.0], [0.01])


STUDY = """
[problem]
kind = "surface_tangential"
law = { kind = "coulomb", coefficient = 0.3 }

[problem.topography]
kind = "sampled_profile"
lengths = ["2 mm", "2 mm"]
shape = [16, 16]
profile = { kind = "paraboloid", curvature_radius = "20 mm" }

[problem.medium]
kind = "viscoelastic_half_space"
first = { kind = "standard_solid", relaxed_shear = "0.5 MPa", shear = "1.5 MPa", relaxation_time = "50 ms" }

[problem.path]
kind = "program"
steps = [
    { kind = "start", normal = { kind = "depth", depth = "20 um" } },
    { kind = "oscillate", lateral = { kind = "shift", shift = "2 um" }, cycles = 1, count = 4 },
]
"""


def test_a_study_of_it_has_a_report():
    """The report asked every medium for its one modulus."""
    outcome = run(parse_study(STUDY))
    assert outcome.answer("bulk_loss")[-1] > 0.0
    assert report_files(outcome)
