"""Impacts of sticky bodies: the closed losses of JKR, duration by quadrature, hysteresis, waves, and the balance."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

import winkler as wk
from winkler.laws.adhesion import Dugdale, ShortRange
from winkler.laws.friction import Coulomb
from winkler.problems.impact.adhesive_impact import AdhesiveImpact
from winkler.problems.impact.impact import Impact

MODULUS, RADIUS, WORK, MASS = 7.0e6, 3.0e-3, 0.05, 2.0e-6
MEDIUM = wk.HalfSpace(wk.Elastic(MODULUS, 0.0))
BALL = wk.Foundation(wk.Paraboloid(RADIUS), MEDIUM)
UNIT = (WORK**5 * RADIUS**4 / MODULUS**2) ** (1 / 3)
STICKING = math.sqrt(2.0 * 7.092195972 * UNIT / MASS)
"""Below this velocity a ball stays: the closed work of pull-off after a snap-in at no depth."""


def hit(speed: float, bed=BALL, law=ShortRange(WORK), **more) -> object:  # noqa: B008
    return AdhesiveImpact(bed, law, MASS, speed, **({"count": 41} | more)).solve()


@pytest.mark.few(1, slow=2)
@pytest.mark.parametrize("part", [1.0001, 1.2, 2.0, 10.0, 300.0])
def test_a_ball_leaves_with_what_snap_in_and_pull_off_have_left(part):
    impact = hit(part * STICKING)
    assert not impact.captured
    assert impact.restitution == pytest.approx(math.sqrt(1.0 - 1.0 / part**2), rel=1e-8 if part > 1.001 else 1e-5)
    assert impact.dissipation[-1] / UNIT == pytest.approx(7.092195972, rel=1e-9)
    assert [jump.loss / UNIT for jump in impact.jumps] == pytest.approx([6.418315112, 0.673880860], rel=1e-8)
    assert [jump.snap_in for jump in impact.jumps] == [True, False]
    np.testing.assert_allclose(impact.balance, 1.0, atol=1e-10)
    assert impact.force[-1] == impact.radius[-1] == impact.energy[-1] == 0.0


@pytest.mark.few(1)
@pytest.mark.parametrize("part", [0.01, 0.5, 0.9999])
def test_a_slow_ball_stays(part):
    impact = hit(part * STICKING)
    assert impact.captured
    assert impact.restitution == 0.0
    assert abs(impact.velocity[-1]) < 1e-6 * STICKING
    assert impact.dissipation[-1] / UNIT == pytest.approx(6.418315112, rel=1e-9)
    energy = 0.5 * MASS * STICKING**2
    np.testing.assert_allclose(impact.balance, 1.0, atol=1e-10 * energy / (0.5 * MASS * (part * STICKING) ** 2))
    assert impact.force[-1] < 0.0
    assert any("stays" in note.statement for note in impact.validity)


def duration_of_a_ball(speed: float) -> float:
    """From snap-in at no depth to the fold at which fixed grips lose a JKR ball: the integral of dd / v over a."""
    stretch = math.sqrt(2.0 * math.pi * WORK / MODULUS)

    def depth(a):
        return a**2 / RADIUS - stretch * math.sqrt(a)

    def potential(a):
        d = depth(a)
        elastic = MODULUS * (d * d * a - 2.0 * d * a**3 / (3.0 * RADIUS) + a**5 / (5.0 * RADIUS**2))
        return elastic - math.pi * WORK * a**2

    snapped = (stretch * RADIUS) ** (2.0 / 3.0)
    fold = (stretch * RADIUS / 4.0) ** (2.0 / 3.0)
    energy = 0.5 * MASS * speed**2 + potential(snapped)
    far = snapped
    while potential(far) < energy:
        far *= 2.0
    last = brentq(lambda a: potential(a) - energy, snapped, far, xtol=1e-300, rtol=1e-15)

    def time(start):
        """With a = last - (last - start) s^2, which takes the root of the velocity at the turn away."""

        def rate(s):
            a = last - (last - start) * s * s
            slope = 2.0 * a / RADIUS - 0.5 * stretch / math.sqrt(a)
            return 2.0 * s * (last - start) * slope / math.sqrt(2.0 / MASS * max(energy - potential(a), 1e-300))

        return quad(rate, 1e-7, 1.0, epsabs=0.0, epsrel=1e-12, limit=400)[0] * 1.0 + 1e-7 * rate(1e-5)

    return time(snapped) + time(fold)


@pytest.mark.parametrize("part", [1.3, 5.0])
def test_duration_by_quadrature(part):
    assert hit(part * STICKING).duration == pytest.approx(duration_of_a_ball(part * STICKING), rel=1e-7)


def test_little_adhesion_is_hardly_any():
    """With a vanishing work of adhesion the ball of Hertz is left."""
    hertz = Impact(BALL, Coulomb(0.0), MASS, 0.5).solve()
    impact = hit(0.5, law=ShortRange(1e-9))
    assert impact.duration == pytest.approx(hertz.duration, rel=1e-5)
    assert np.max(impact.depth) == pytest.approx(np.max(hertz.depth), rel=1e-6)
    assert impact.restitution == pytest.approx(1.0, abs=1e-9)


def test_a_flat_punch_loses_the_work_of_its_area_twice():
    """It snaps in at no depth, without a force, and parts at Kendall's load, each time at the price of its area."""
    b, speed = 2.0e-4, 0.2
    impact = hit(speed, bed=wk.Foundation(wk.FlatPunch(b), MEDIUM))
    area = math.pi * b**2
    assert [jump.loss for jump in impact.jumps] == pytest.approx([WORK * area] * 2, rel=1e-9)
    assert impact.restitution == pytest.approx(math.sqrt(1.0 - 4.0 * WORK * area / (MASS * speed**2)), rel=1e-9)
    frequency = math.sqrt(2.0 * MODULUS * b / MASS)
    pulled = math.sqrt(2.0 * math.pi * b * WORK / MODULUS)
    out = math.asin(pulled * frequency / speed) / frequency
    assert impact.duration == pytest.approx(math.pi / frequency + out, rel=1e-9)


@pytest.mark.slow
def test_hysteresis_costs_every_area_that_was_closed():
    closing, opening = 0.2 * WORK, WORK
    slow, fast = (
        hit(part * STICKING, law=ShortRange(work_closing=closing, work_opening=opening)) for part in (4.0, 12.0)
    )
    for impact in (slow, fast):
        np.testing.assert_allclose(impact.balance, 1.0, atol=1e-10)
        assert np.min(np.diff(impact.dissipation)) >= -1e-12 * impact.dissipation[-1]
        widest = np.max(impact.radius)
        crept = (opening - closing) * math.pi * widest**2
        assert impact.dissipation[-1] < crept + 7.1 * UNIT
        assert impact.dissipation[-1] > 0.9 * crept
        lost = 0.5 * MASS * impact.velocity[0] ** 2 * (1.0 - impact.restitution**2)
        assert lost == pytest.approx(impact.dissipation[-1], rel=1e-9)
    assert fast.dissipation[-1] > 2.0 * slow.dissipation[-1]


def test_nothing_gained_by_closing():
    impact = hit(4.0 * STICKING, law=ShortRange(work_closing=0.0, work_opening=WORK))
    assert not any(jump.snap_in for jump in impact.jumps)
    np.testing.assert_allclose(impact.balance, 1.0, atol=1e-10)


@pytest.mark.few(1)
@pytest.mark.parametrize(
    "profile",
    [wk.Cone(1.3), wk.CappedCylinder(2e-4, wk.Paraboloid(RADIUS)), wk.Sphere(RADIUS), wk.PowerLaw(1e4, 3.0)],
    ids=lambda profile: type(profile).__name__,
)
def test_any_shape_keeps_the_balance(profile):
    impact = hit(0.2, bed=wk.Foundation(profile, MEDIUM), count=21)
    np.testing.assert_allclose(impact.balance, 1.0, atol=1e-10)


@pytest.mark.slow
def test_waves_cost_a_jump_each():
    """A wavy ball loses in a dozen jumps."""
    medium = wk.HalfSpace(wk.Elastic(1.0, 0.0))
    bed = wk.Foundation(wk.Paraboloid(1.0) + wk.Wavy(1e-3, 0.05), medium)
    impact = AdhesiveImpact(bed, ShortRange(1e-4), 1.0, 0.036, count=21).solve()
    assert len(impact.jumps) > 8
    assert impact.dissipation[-1] == pytest.approx(sum(jump.loss for jump in impact.jumps), rel=1e-12)
    np.testing.assert_allclose(impact.balance, 1.0, atol=1e-10)


def test_units_do_not_matter():
    one = hit(2.0 * STICKING, count=9)
    medium = wk.HalfSpace(wk.Elastic(1.0, 0.0))
    work, mass = WORK / (MODULUS * RADIUS), MASS
    speed = 2.0 * STICKING / math.sqrt(MODULUS * RADIUS**3)
    two = AdhesiveImpact(wk.Foundation(wk.Paraboloid(1.0), medium), ShortRange(work), mass, speed, count=9).solve()
    np.testing.assert_allclose(two.depth, one.depth / RADIUS, atol=1e-9 * np.max(two.depth))
    np.testing.assert_allclose(two.force, one.force / (MODULUS * RADIUS**2), atol=1e-8 * np.max(two.force))
    assert two.restitution == pytest.approx(one.restitution, rel=1e-11)


@pytest.mark.slow
def test_a_grain_of_dust_is_followed_as_well():
    """What lasts nanoseconds is followed as closely as what lasts seconds."""
    radius, work = 0.5e-6, 0.05
    silica = wk.Elastic(young=70e9, poisson=0.17)
    bed = wk.Foundation(wk.Paraboloid(radius), wk.HalfSpace.between(silica, silica))
    mass = 4.0 / 3.0 * math.pi * radius**3 * 2200.0
    cost = 7.092195972 * (work**5 * radius**4 / bed.medium.modulus**2) ** (1 / 3)
    for part in (0.95, 1.05, 5.0):
        impact = AdhesiveImpact(bed, ShortRange(work), mass, part * math.sqrt(2.0 * cost / mass), count=5).solve()
        assert impact.duration < 1e-7
        assert impact.captured == (part < 1.0)
        np.testing.assert_allclose(impact.balance, 1.0, atol=1e-11)
        if part > 1.0:
            assert impact.restitution == pytest.approx(math.sqrt(1.0 - 1.0 / part**2), rel=1e-9)


def test_steps_are_the_solution():
    problem = AdhesiveImpact(BALL, ShortRange(WORK), MASS, 2.0 * STICKING, count=8)
    whole = problem.solve()
    for index, state in enumerate(problem.steps()):
        for word in ("time", "depth", "velocity", "force", "radius", "energy", "dissipation"):
            assert getattr(state, word) == getattr(whole, word)[index], word
    assert index == 8  # eight moments, and the greatest depth


def test_a_body_that_ends_too_soon_is_refused():
    r = np.linspace(0.0, 1e-4, 21)
    bed = wk.Foundation(wk.Measured(r, r**2 / (2 * RADIUS)), MEDIUM)
    with pytest.raises(wk.OutsideValidity, match="reach"):
        hit(2.0, bed=bed)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"law": Dugdale(0.05, 1e5)}, "afar"),
        ({"mass": -1.0}, "mass"),
        ({"velocity": math.inf}, "velocity"),
        ({"count": 2.5}, "count"),
    ],
    ids=lambda given: str(given),
)
def test_what_makes_no_sense_is_refused(change, words):
    given = {"bed": BALL, "law": ShortRange(WORK), "mass": 1.0, "velocity": 1.0} | change
    with pytest.raises(wk.InvalidInput, match=words):
        AdhesiveImpact(**given)
