"""Impacts: Hertz, Maw-Barber-Fawcett, no slip, plain springs by brute force, and the balance of energy."""

from __future__ import annotations

import itertools
import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import winkler as wk
from winkler.laws.friction import Coulomb
from winkler.materials.graded import PowerLawGraded
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.problems.impact import motion
from winkler.problems.impact.impact import Impact

MODULUS, MASS, SPEED = 1.0, 1.0, 0.01


def half_space(poisson: float, modulus: float = MODULUS) -> wk.HalfSpace:
    """One elastic body with a given E*, against a rigid one: the ratio G*/E* is 2 (1 - nu)/(2 - nu)."""
    return wk.HalfSpace(wk.Elastic(modulus * (1.0 - poisson**2), poisson))


def ratio(poisson: float) -> float:
    return 2.0 * (1.0 - poisson) / (2.0 - poisson)


def ball(bed: wk.Foundation, coefficient: float, sliding: float, **more) -> Impact:
    """A solid ball of the radius one, without spin before the impact."""
    given = {"mass": MASS, "velocity": SPEED, "inertia": 0.4 * MASS, "lever": 1.0, "count": 41} | more
    return Impact(bed, Coulomb(coefficient), lateral_velocity=sliding, **given)


BALL = wk.Foundation(wk.Paraboloid(1.0), half_space(0.3))
SHAPES = {
    "ball": wk.Paraboloid(1.0),
    "sphere": wk.Sphere(1.0),
    "cone": wk.Cone(1.4),
    "flat punch": wk.FlatPunch(0.1),
    "rim": wk.CappedCylinder(0.1, wk.Paraboloid(1.0)),
    "flattened cone": wk.TruncatedCone(0.05, 1.4),
    "fourth power": wk.PowerLaw(1.0, 4.0),
}


def plain_springs(gaps, stiffness, force, duration, sliding, mobility, shear_ratio, coefficient, steps):
    """March independent springs through an impact, step by step, second order: the sliding velocity at the end."""
    dt, climb = duration / steps, coefficient / shear_ratio if math.isfinite(coefficient) else math.inf
    u, d, v, w, shear = np.zeros(gaps.shape), 0.0, SPEED, sliding, 0.0
    for _ in range(steps):
        v -= 0.5 * dt * force(d) / MASS
        w -= 0.5 * dt * mobility * shear
        d, before = d + dt * v, d
        entering = (d - gaps) / (d - before) if d > before else np.ones(gaps.shape)
        moved = u + np.where(gaps < before, 1.0, np.clip(entering, 0.0, 1.0)) * dt * w
        bound = np.where(d > gaps, climb * (d - gaps), 0.0) if math.isfinite(climb) else np.where(d > gaps, climb, 0.0)
        u = np.clip(moved, -bound, bound)
        shear = shear_ratio * (stiffness @ u)
        v -= 0.5 * dt * force(d) / MASS
        w -= 0.5 * dt * mobility * shear
    return w


@pytest.mark.parametrize(
    ("profile", "power", "coefficient"),
    [
        (wk.Paraboloid(3.0), 2.5, lambda e: mp.mpf(8) / 15 * e * mp.sqrt(3)),
        (wk.Cone(1.2), 3.0, lambda e: 2 * e * mp.tan(mp.mpf(1.2)) / (3 * mp.pi)),
        (wk.FlatPunch(0.05), 2.0, lambda e: e * mp.mpf(0.05)),
    ],
    ids=["ball", "cone", "flat punch"],
)
def test_straight_impacts_are_closed_forms(profile, power, coefficient):
    """Energy W = c d^p gives depth and duration: T = 2 sqrt(pi) Gamma(1 + 1/p) / Gamma(1/2 + 1/p) d_max / v."""
    modulus, mass, speed = 2.0e5, 0.3, 0.7
    with mp.workdps(30):
        depth = (mp.mpf(mass) * mp.mpf(speed) ** 2 / (2 * coefficient(mp.mpf(modulus)))) ** (1 / mp.mpf(power))
        form = 2 * mp.sqrt(mp.pi) * mp.gamma(1 + 1 / mp.mpf(power)) / mp.gamma(mp.mpf("0.5") + 1 / mp.mpf(power))
        duration = form * depth / speed
    bed = wk.Foundation(profile, half_space(0.3, modulus))
    hit = Impact(bed, Coulomb(0.0), mass, speed, count=201).solve()
    assert hit.depth[100] == pytest.approx(float(depth), rel=1e-12)
    assert hit.duration == pytest.approx(float(duration), rel=1e-11)
    assert hit.restitution == pytest.approx(1.0, abs=1e-11)
    assert np.all(hit.shear_force == 0.0)
    np.testing.assert_allclose(hit.depth, hit.depth[::-1], atol=1e-10 * float(depth))
    np.testing.assert_allclose(hit.balance, 1.0, atol=1e-11)


def test_hertz_numbers_of_the_literature():
    """The numbers .974514960 and 2.868265699 of the elastic ball."""
    modulus, radius, mass, speed = 7.0e9, 5.0e-3, 4.0e-3, 2.0
    bed = wk.Foundation(wk.Paraboloid(radius), half_space(0.25, modulus))
    hit = Impact(bed, Coulomb(0.0), mass, speed).solve()
    assert np.max(hit.depth) == pytest.approx(
        0.974514960 * (mass**2 * speed**4 / (modulus**2 * radius)) ** 0.2, rel=1e-9
    )
    assert hit.duration == pytest.approx(2.868265699 * (mass**2 / (modulus**2 * radius * speed)) ** 0.2, rel=1e-9)


MAW = [
    (0.1, 0.0206),
    (0.5, 0.0478),  # the springs of coarse steps give .0480
    (1.0, -0.0597),
    (1.5, -0.4280),
    (2.0, -0.8372),
    (3.0, -1.3797),
    (4.0, -1.4365),
    (4.5, -1.2176),
    (5.0, -0.7647),
    (6.0, 0.2353),
]


@pytest.mark.few(2, slow=2)
@pytest.mark.parametrize(("before", "after"), MAW, ids=[f"psi {row[0]}" for row in MAW])
def test_the_oblique_impact_of_a_ball(before, after):
    """The angles of incidence and reflection of Maw, Barber and Fawcett, psi = (G*/E*) w / (mu v), at nu = 0.3."""
    coefficient = 0.4
    unit = coefficient * SPEED / ratio(0.3)
    hit = ball(BALL, coefficient, before * unit).solve()
    assert hit.sliding_velocity[-1] / unit == pytest.approx(after, abs=6e-5)
    np.testing.assert_allclose(hit.balance, 1.0, atol=1e-11)


@pytest.mark.slow
def test_gross_slip_begins_where_it_should():
    """Beyond psi = 4 chi - 1, chi = (7/4)(G*/E*), the ball slides throughout and psi falls by 4 chi."""
    coefficient, chi = 0.25, 1.75 * ratio(0.3)
    unit = coefficient * SPEED / ratio(0.3)
    for before in (4.0 * chi - 1.0 + 1e-3, 5.2, 40.0):
        hit = ball(BALL, coefficient, before * unit).solve()
        assert hit.sliding_velocity[-1] / unit == pytest.approx(before - 4.0 * chi, rel=1e-11)
        assert [stage.side for stage in hit.stages] == [1]
        assert np.all(hit.stick_radius == 0.0)
        np.testing.assert_allclose(hit.shear_force, coefficient * hit.force, atol=1e-12 * np.max(hit.force))
    hit = ball(BALL, coefficient, (4.0 * chi - 1.0 - 1e-3) * unit).solve()
    assert [stage.side for stage in hit.stages] == [1, -1]
    assert hit.sliding_velocity[-1] / unit > -1.0 - 1e-3 + 1e-9


@pytest.mark.few(1)
@pytest.mark.parametrize(("poisson", "part"), [(0.0, 0.3870), (0.25, 0.2800), (0.3, 0.2317), (0.5, -0.1040)])
def test_no_slip_depends_on_the_mindlin_ratio_alone(poisson, part):
    """The part of the sliding velocity that is left, of Lyashenko and Popov."""
    slow, fast = (
        ball(wk.Foundation(wk.Paraboloid(1.0), half_space(poisson)), math.inf, w).solve() for w in (1e-3, 0.02)
    )
    assert slow.sliding_velocity[-1] / 1e-3 == pytest.approx(part, abs=6e-5)
    assert slow.lateral_restitution == pytest.approx(fast.lateral_restitution, rel=1e-11)
    np.testing.assert_allclose(fast.balance, 1.0, atol=1e-12)
    assert np.all(fast.stick_radius == fast.radius)


def test_a_flat_punch_that_sticks_swings_sideways():
    """All springs of a flat punch act as one: w = w0 cos(sqrt(kappa rho m) pi); what is stored at the end is lost."""
    hit = ball(wk.Foundation(wk.FlatPunch(0.1), half_space(0.3)), math.inf, 0.004).solve()
    phase = math.pi * math.sqrt(3.5 * ratio(0.3))
    assert -hit.lateral_restitution == pytest.approx(math.cos(phase), rel=1e-11)
    assert hit.dissipation[-1] == pytest.approx(0.5 / 3.5 * 0.004**2 * math.sin(phase) ** 2, rel=1e-10)


def test_much_friction_is_no_slip_as_long_as_nothing_parts():
    """Up to the greatest depth a large coefficient and an infinite one are the same."""
    stuck, rough = (ball(BALL, mu, 0.004, count=9).solve() for mu in (math.inf, 1e5))
    np.testing.assert_allclose(rough.shear_force[:5], stuck.shear_force[:5], atol=1e-4 * np.max(stuck.shear_force))


SPRINGS = {
    "ball": (wk.Paraboloid(1.0), lambda x: x * x, lambda d: 4 / 3 * max(d, 0.0) ** 1.5),
    "cone": (
        wk.Cone(1.4),
        lambda x: math.pi / 2 * x / math.tan(1.4),
        lambda d: 2 / math.pi * math.tan(1.4) * max(d, 0.0) ** 2,
    ),
    "flat punch": (wk.FlatPunch(0.5), lambda x: 0.0 * x, lambda d: max(d, 0.0)),
}


@pytest.mark.few(2, slow=2)
@pytest.mark.parametrize(("coefficient", "part"), [(0.05, 2.2), (0.4, 0.5), (0.4, 2.2), (3.0, 0.5), (math.inf, 0.5)])
@pytest.mark.parametrize("shape", SPRINGS)
def test_plain_springs_agree(shape, coefficient, part):
    """Thousands of springs, step by step, come as close as their steps allow, and closer with smaller ones."""
    profile, gap, force = SPRINGS[shape]
    sliding = part * min(coefficient, 0.5) * SPEED
    hit = ball(wk.Foundation(profile, half_space(0.2)), coefficient, sliding).solve()
    errors = []
    for count, steps in ((100, 600), (200, 1200)):
        x = (np.arange(count) + 0.5) / count * np.max(hit.radius)
        stiffness = np.full(count, 2.0 * np.max(hit.radius) / count)
        rest = (gap(x), stiffness, force, hit.duration, sliding, 3.5, ratio(0.2), coefficient)
        errors.append(plain_springs(*rest, steps) / sliding - hit.sliding_velocity[-1] / sliding)
    # springs that never slide let go of all they hold, one by one, at the last of a plain march's steps that they see
    assert abs(errors[1]) < (2e-3 if math.isinf(coefficient) else 4e-5)
    assert math.isinf(coefficient) or abs(errors[1]) < max(0.75 * abs(errors[0]), 3e-6)


@pytest.mark.slow
@settings(max_examples=12)
@given(
    shape=st.sampled_from(sorted(SHAPES)),
    poisson=st.floats(0.0, 0.5),
    coefficient=st.floats(-2.0, 1.0).map(lambda power: 10.0**power) | st.just(math.inf),
    part=st.floats(1e-6, 7.0) | st.floats(-7.0, -1e-6) | st.just(0.0),
    inertia=st.floats(0.2, 5.0),
)
def test_energy_is_neither_made_nor_lost(shape, poisson, coefficient, part, inertia):
    bed = wk.Foundation(SHAPES[shape], half_space(poisson))
    sliding = part * min(coefficient, 1.0) * SPEED
    hit = ball(bed, coefficient, sliding, inertia=inertia).solve()
    initial = hit.kinetic_energy[0]
    np.testing.assert_allclose(hit.balance, 1.0, atol=1e-10)
    assert np.min(np.diff(hit.dissipation)) >= -1e-11 * initial
    assert np.min(hit.stored_energy) >= -1e-11 * initial
    assert hit.restitution == pytest.approx(1.0, abs=1e-9)
    if math.isfinite(coefficient):
        assert np.all(np.abs(hit.shear_force) <= coefficient * hit.force + 1e-10 * np.max(hit.force))
    assert np.all(hit.stick_radius <= hit.radius)
    assert np.all(np.abs(hit.sliding_velocity) <= abs(sliding) * (1.0 + 1e-12))
    assert hit.shear_force[-1] == hit.stored_energy[-1] == hit.energy[-1] == hit.force[-1] == 0.0


@pytest.mark.slow
@pytest.mark.parametrize(
    ("poisson", "coefficient", "part", "inertia"),
    [(0.02437885536358403, 9.943249686656019, 2.1331675622318276, 1.3256489680151549),
     (0.11532445186941914, 4.102429585568286, 0.07147354340520984, 3.6816513520102285)],
)  # fmt: skip
def test_a_flat_punch_does_not_part_by_rounding(poisson, coefficient, part, inertia):
    """All its springs stick or slide at once, also where the depth at first touch is read as less than nothing."""
    bed = wk.Foundation(wk.FlatPunch(0.1), half_space(poisson))
    hit = ball(bed, coefficient, part * min(coefficient, 1.0) * SPEED, inertia=inertia).solve()
    np.testing.assert_allclose(hit.balance, 1.0, atol=1e-10)
    assert hit.restitution == pytest.approx(1.0, abs=1e-9)


def test_a_graded_body_keeps_the_balance():
    medium = GradedHalfSpace(PowerLawGraded(young=1.0, depth_scale=0.1, exponent=0.4, poisson=0.25))
    for coefficient in (0.3, math.inf):
        hit = ball(wk.Foundation(wk.Paraboloid(1.0), medium), coefficient, 0.006).solve()
        np.testing.assert_allclose(hit.balance, 1.0, atol=1e-11)
        assert hit.restitution == pytest.approx(1.0, abs=1e-11)


def test_the_solution_has_converged(monkeypatch):
    """A march of a millionth of the accuracy comes to the same end."""
    problem = ball(BALL, 0.4, 0.009)
    fine = problem.solve()
    monkeypatch.setattr(motion, "PRECISION", 1e-8)
    coarse = problem.solve()
    assert coarse.sliding_velocity[-1] != fine.sliding_velocity[-1]
    assert coarse.sliding_velocity[-1] == pytest.approx(fine.sliding_velocity[-1], abs=1e-7 * SPEED)
    assert [stage.side for stage in coarse.stages] == [stage.side for stage in fine.stages]


def test_units_do_not_matter():
    """Lengths, moduli and masses may be counted in anything."""
    length, modulus, mass = 1e-7, 3e10, 1e-17
    speed = math.sqrt(modulus * length**3 / mass)
    time = length / speed
    one = ball(BALL, 0.4, 0.009).solve()
    bed = wk.Foundation(wk.Paraboloid(length), half_space(0.3, modulus))
    two = Impact(
        bed,
        Coulomb(0.4),
        mass * MASS,
        speed * SPEED,
        lateral_velocity=speed * 0.009,
        inertia=0.4 * mass * length**2,
        lever=length,
        count=41,
    ).solve()
    assert two.duration == pytest.approx(time * one.duration, rel=1e-11)
    for word, unit in (
        ("depth", length),
        ("shift", length),
        ("sliding_velocity", speed),
        ("shear_force", mass * speed / time),
        ("stick_radius", length),
        ("dissipation", mass * speed**2),
    ):
        was = unit * getattr(one, word)
        np.testing.assert_allclose(getattr(two, word), was, atol=1e-10 * np.max(np.abs(was)), err_msg=word)


def test_left_is_the_mirror_of_right():
    right, left = (ball(BALL, 0.4, sign * 0.009).solve() for sign in (1.0, -1.0))
    np.testing.assert_array_equal(right.shear_force, -left.shear_force)
    np.testing.assert_array_equal(right.dissipation, left.dissipation)
    assert [stage.side for stage in right.stages] == [-stage.side for stage in left.stages]


@pytest.mark.slow
def test_only_the_touching_points_count():
    """Spin and flight that make the points slide alike meet the same forces; a rolling ball meets none."""
    flying = ball(BALL, 0.4, 0.009).solve()
    spinning = ball(BALL, 0.4, 0.0, angular_velocity=-0.009).solve()
    np.testing.assert_allclose(spinning.shear_force, flying.shear_force, rtol=1e-13, atol=0.0)
    rolling = ball(BALL, 0.4, 0.009, angular_velocity=0.009).solve()
    assert np.all(rolling.shear_force == 0.0)
    assert math.isnan(rolling.lateral_restitution)


def test_angular_momentum_about_the_touching_point_is_conserved():
    hit = ball(BALL, 0.4, 0.009, angular_velocity=-0.02, inertia=0.7, lever=1.3).solve()
    momentum = 1.3 * MASS * hit.lateral_velocity + 0.7 * hit.angular_velocity
    np.testing.assert_allclose(momentum, momentum[0], rtol=1e-14)
    np.testing.assert_allclose(hit.lateral_velocity - 1.3 * hit.angular_velocity, hit.sliding_velocity, atol=1e-15)
    assert hit.angular_velocity[0] == -0.02


def test_steps_are_the_solution_and_their_number_plays_no_part():
    few, many = ball(BALL, 0.4, 0.009, count=11), ball(BALL, 0.4, 0.009, count=41)
    whole = many.solve()
    for index, state in enumerate(few.steps()):
        for word in ("time", "depth", "shear_force", "sliding_velocity", "stick_radius", "dissipation", "energy"):
            assert getattr(state, word) == getattr(whole, word)[4 * index], word
    assert index == 10
    assert whole.stages[0].start == 0.0
    assert whole.stages[-1].end == whole.duration
    assert all(one.end == two.start and one.side != two.side for one, two in itertools.pairwise(whole.stages))


def test_exactly_at_the_limit_of_sticking():
    """Where the bound of the first touch grows as fast as the ball slides, it sticks, unless it is hard to slow."""
    unit = 0.4 * SPEED / ratio(0.3)
    assert ball(BALL, 0.4, unit).solve().stages[0].side == 0
    heavy = ball(BALL, 0.4, unit, lever=0.0, inertia=math.inf).solve()
    np.testing.assert_allclose(heavy.balance, 1.0, atol=1e-11)
    assert heavy.stages[0].side == (1 if ratio(0.3) < 1.0 else 0)


def test_sliding_that_ends_just_when_the_ball_turns_back():
    """At nu = 1/2, kappa = 2/m and w = 2 mu v the ball slides, and is at rest at the greatest depth in both."""
    bed, coefficient = wk.Foundation(wk.Paraboloid(1.0), half_space(0.5)), 0.2164439528417777
    ends = []
    for part in (2.0, 2.0 * (1.0 - 1e-9), 2.0 * (1.0 + 1e-9)):
        hit = ball(bed, coefficient, part * coefficient * SPEED, inertia=1.0).solve()
        assert np.all(np.abs(hit.shear_force) <= coefficient * hit.force + 1e-12 * np.max(hit.force))
        np.testing.assert_allclose(hit.balance, 1.0, atol=1e-11)
        ends.append(hit.sliding_velocity[-1])
    np.testing.assert_allclose(ends, ends[0], atol=1e-7 * SPEED)


@pytest.mark.long
def test_a_ball_that_slides_on_a_grading_loses_what_friction_takes():
    """It slides throughout: its velocity along the surface falls by 7 mu v, and energy is accounted for."""
    graded = wk.DepthGradedHalfSpace(wk.ExponentialGrading(4.0, 1.0, depth_scale=0.05, poisson=0.3), tolerance=1e-3)
    bed = wk.Foundation(wk.Paraboloid(1.0), graded)
    hit = Impact(bed, Coulomb(0.3), MASS, SPEED, count=5).solve()
    np.testing.assert_allclose(hit.balance, 1.0, atol=1e-9)
    assert hit.duration < Impact(BALL, Coulomb(0.3), MASS, SPEED, count=5).solve().duration
    slid = ball(bed, 0.02, 0.005, count=5).solve()
    assert slid.sliding_velocity[-1] == pytest.approx(0.005 - 7.0 * 0.02 * SPEED, rel=2e-4)
    np.testing.assert_allclose(slid.balance, 1.0, atol=1e-9)


def test_a_body_that_ends_too_soon_is_refused():
    r = np.linspace(0.0, 0.05, 21)
    bed = wk.Foundation(wk.Measured(r, r**2 / 2), half_space(0.3))
    with pytest.raises(wk.OutsideValidity, match="reach"):
        Impact(bed, Coulomb(0.0), MASS, SPEED).solve()
    assert Impact(bed, Coulomb(0.0), MASS, 1e-4).solve().restitution == pytest.approx(1.0, abs=1e-9)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"mass": 0.0}, "mass"),
        ({"velocity": -1.0}, "velocity"),
        ({"inertia": 0.0}, "inertia"),
        ({"lateral_velocity": math.nan}, "lateral_velocity"),
        ({"angular_velocity": 1.0}, "lever"),
        ({"lever": -1.0}, "lever"),
        ({"count": 1}, "count"),
        ({"law": wk.ShortRange(1.0)}, "Coulomb"),
        ({"law": Coulomb(1e6)}, "rounding"),
    ],
    ids=lambda given: str(given),
)
def test_what_makes_no_sense_is_refused(change, words):
    given = {"bed": BALL, "law": Coulomb(0.3), "mass": 1.0, "velocity": 1.0} | change
    with pytest.raises(wk.InvalidInput, match=words):
        Impact(**given)


def test_notes_state_what_is_left_out():
    statements = " ".join(note.statement for note in ball(BALL, 0.4, 0.009).solve().validity)
    assert "Gravity" in statements
    assert "Cattaneo-Mindlin" in statements
    assert "Elastic waves carry away about" in statements
    straight = " ".join(note.statement for note in ball(BALL, 0.4, 0.0).solve().validity)
    assert "Cattaneo-Mindlin" not in straight


STRUCK = wk.Foundation(wk.Sphere(20e-3), wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3)))
THROWN = {"mass": 0.035, "velocity": 2.0, "lateral_velocity": 1.0}


def test_a_steel_ball_that_is_thrown_leaves_with_spin():
    blow = wk.Impact(STRUCK, wk.Coulomb(0.5), **THROWN, inertia=5.6e-6, lever=20e-3).solve()
    assert blow.angular_velocity[-1] == pytest.approx(35.865, rel=1e-3)
    assert blow.lateral_velocity[-1] == pytest.approx(0.713, rel=1e-3)


@pytest.mark.parametrize(("given", "missing"), [({"inertia": 5.6e-6}, "lever"), ({"lever": 20e-3}, "inertia")])
def test_inertia_and_lever_act_only_together(given, missing):
    """Without a word the ball had kept its spin of zero, and its velocity had turned to -0.827 m/s."""
    with pytest.raises(wk.InvalidInput, match=f"give .*{missing}|{missing} is 0"):
        wk.Impact(STRUCK, wk.Coulomb(0.5), **THROWN, **given)


def test_a_lever_without_inertia_is_of_a_body_whose_spin_stays():
    spun = wk.Impact(STRUCK, wk.Coulomb(0.5), mass=0.035, velocity=2.0, angular_velocity=10.0, lever=20e-3).solve()
    assert spun.angular_velocity[-1] == 10.0
    assert spun.lateral_velocity[-1] > 0.0
