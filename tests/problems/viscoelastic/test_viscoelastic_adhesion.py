"""Adhesion of rubber: JKR when slow, an independent equation of motion when fast, scaling, energy, and Kendall."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import winkler as wk
from winkler.laws.crack import RateDependentWork, SaturatingWork
from winkler.loading.loads import Depth, Force, Shift
from winkler.loading.path import Path
from winkler.materials.spring_and_dashpot import Maxwell, StandardSolid
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.viscoelastic.adhesion import ViscoelasticAdhesion
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Standing, worst

R, W, YOUNG = 1e-3, 0.05, 1e6
MODULUS = YOUNG / 0.75
RUBBER = wk.HalfSpace(wk.Elastic(YOUNG, 0.5))
BALL = wk.Foundation(wk.Paraboloid(R), RUBBER)
LAW = RateDependentWork(W, 1e-6, 0.6)
ONE = math.pi * W * R


def pulled(speed, far=50e-6, bed=BALL, law=LAW, press=5e-6, count=2, **more):
    depth = np.linspace(press, press - far, count)
    time = np.linspace(0.0, far / speed, count)
    return ViscoelasticAdhesion(bed, law, Path(time, Depth(depth)), **more).solve()


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("profile", [wk.Paraboloid(R), wk.PowerLaw(1e9, 4.0)])
def test_slow_rubber_is_elastic(profile):
    """The limit of no speed: JKR, with its snap-in, pull-off and loss."""
    bed = wk.Foundation(profile, RUBBER)
    slow = pulled(1e-15, bed=bed, press=2e-6, far=20e-6)
    elastic = wk.AdhesiveCycle(bed, wk.ShortRange(W), Depth([2e-6, *np.linspace(2e-6, -18e-6, 4000)])).solve()
    assert slow.radius[0] == pytest.approx(elastic.radius[0], rel=1e-9)
    assert slow.force[0] == pytest.approx(elastic.force[0], rel=1e-9)
    assert slow.lowest_force[-1] == pytest.approx(np.min(elastic.force), rel=1e-3)
    assert slow.dissipation[-1] == pytest.approx(elastic.dissipation[-1], rel=1e-2)
    assert slow.dissipation[0] == pytest.approx(elastic.dissipation[0], rel=1e-9)
    assert slow.radius[-1] == slow.force[-1] == 0.0


@pytest.mark.slow
@pytest.mark.parametrize(
    ("speed", "exponent"), [(1e-8, 0.6), (1e-6, 1.0), pytest.param(1e-7, 0.25, marks=pytest.mark.slow)]
)
def test_an_independent_equation_of_motion(speed, exponent):
    law = RateDependentWork(W, 1e-6, exponent)
    start, far = 5e-6, 60e-6
    time = np.linspace(0.0, far / speed, 25)
    result = ViscoelasticAdhesion(BALL, law, Path(time, Depth(start - speed * time))).solve()

    def release(t, a):
        return MODULUS * (a**2 / R - start + speed * t) ** 2 / (2.0 * math.pi * a)

    def motion(t, a):
        return -1e-6 * np.maximum(release(t, a) / W - 1.0, 0.0) ** (1.0 / exponent)

    def gone(t, a):
        return a[0] - 1e-6

    gone.terminal = True
    radius = result.radius[0]
    assert release(0.0, radius) == pytest.approx(W, rel=1e-12)
    true = solve_ivp(
        motion, (0.0, time[-1]), [radius], method="LSODA", rtol=1e-11, atol=1e-16, events=gone, dense_output=True
    )  # fmt: skip
    moments = np.linspace(0.0, true.t[-1], 20001)
    a = true.sol(moments)[0]
    force = 2.0 * MODULUS * (a * (start - speed * moments) - a**3 / (3.0 * R))
    assert result.lowest_force[-1] == pytest.approx(np.min(force), rel=1e-6)
    inside = time < true.t[-1]
    assert result.radius[inside] == pytest.approx(true.sol(time[inside])[0], rel=1e-5)
    assert np.all(result.radius[time > 1.02 * true.t[-1]] == 0.0)
    assert result.crack_speed[inside][1:] == pytest.approx(-motion(time[inside], result.radius[inside])[1:], rel=1e-6)
    # what is lost at the edge, area by area; the bodies part with almost nothing left
    loss = np.trapezoid(2.0 * math.pi * a * (W - release(moments, a)), a)
    assert result.dissipation[-1] - result.dissipation[0] == pytest.approx(loss, rel=3e-2)
    assert np.all(np.diff(result.dissipation) >= 0.0)


def test_the_work_converges_to_what_is_spent():
    """Four times as many points, a sixteenth of the trapezia's error."""
    misfits = []
    for count in (40, 160):
        track = np.linspace(5e-6, -1e-6, count + 1)
        result = ViscoelasticAdhesion(BALL, LAW, Path((5e-6 - track) / 2e-8, Depth(track))).solve()
        a, d = result.radius, result.depth
        stored = MODULUS * (d**2 * a - 2.0 * d * a**3 / (3.0 * R) + a**5 / (5.0 * R**2)) - W * math.pi * a**2
        spent = stored[-1] - stored[0] + result.dissipation[-1] - result.dissipation[0]
        misfits.append(abs(spent - np.trapezoid(result.force, track)) / np.max(np.abs(stored)))
    assert misfits[1] < misfits[0] / 15.0
    assert misfits[1] < 1e-4


@pytest.mark.slow
def test_only_one_number_counts():
    """V (R E* / w)^(1/3) / v_0, of balls pressed on alike (Muller's equation)."""
    ratios = []
    for radius, work, young in [(1e-3, 0.05, 1e6), (2e-2, 0.4, 1e7)]:
        bed = wk.Foundation(wk.Paraboloid(radius), wk.HalfSpace(wk.Elastic(young, 0.5)))
        unit = (work**2 * radius / (young / 0.75) ** 2) ** (1.0 / 3.0)
        speed = 0.02 * 3e-6 * (work / (radius * young / 0.75)) ** (1.0 / 3.0)
        law = RateDependentWork(work, 3e-6, 0.5)
        result = pulled(speed, bed=bed, law=law, press=2.0 * unit, far=20.0 * unit)
        ratios.append(result.lowest_force[-1] / (math.pi * work * radius))
    assert ratios == pytest.approx([ratios[0]] * 2, rel=1e-6)
    assert ratios[0] < -1.6


@pytest.mark.slow
def test_the_pull_off_rises_with_the_speed():
    forces = np.array([-pulled(speed, far=4e-4).lowest_force[-1] for speed in [1e-10, 1e-6]]) / ONE
    assert np.all(np.diff(forces) > 0.0)
    assert forces[0] == pytest.approx(1.5297, rel=1e-4)
    stiff = pulled(1e-7).lowest_force[-1]
    # a soft machine lets the edge run at almost a constant force, and is torn off at less
    soft = pulled(1e-7, far=5e-3, machine_stiffness=0.05).lowest_force[-1]
    assert stiff < soft < -1.5 * ONE


def test_work_is_stored_or_lost():
    turns = [(-1e-6, 5e-6, 9), (5e-6, -2e-6, 50), (-2e-6, 4e-6, 30)]
    track = np.concatenate([[-1e-6], *(np.linspace(*turn)[1:] for turn in turns)])
    time = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(track)))]) / 2e-8
    for stiffness in (math.inf, 200.0):
        result = ViscoelasticAdhesion(BALL, LAW, Path(time, Depth(track)), stiffness).solve()
        assert result.radius[0] == result.force[0] == 0.0
        assert np.all(np.diff(result.dissipation) >= 0.0)
        begin = 12
        work = np.trapezoid(result.force[begin:], track[begin:])
        a, d, f = result.radius, result.depth, result.force
        inner = MODULUS * (d**2 * a - 2.0 * d * a**3 / (3.0 * R) + a**5 / (5.0 * R**2)) - W * math.pi * a**2
        stored = inner + 0.5 * f**2 / stiffness
        spent = stored[-1] - stored[begin] + result.dissipation[-1] - result.dissipation[begin]
        # the work is computed by trapezia between the points
        assert spent == pytest.approx(work, abs=1.1e-3 * np.max(np.abs(stored)))
        assert track == pytest.approx(d + f / stiffness, abs=1e-15)


def test_a_hold_lets_the_edge_come_to_rest():
    result = ViscoelasticAdhesion(
        BALL, LAW, Path([0.0, 10.0, 1e3, 1e5, 1e9], Depth([5e-6, 2e-6, 2e-6, 2e-6, 2e-6]))
    ).solve()
    rest = wk.AdhesiveIndentation(BALL, wk.ShortRange(W), Depth(2e-6)).solve()
    assert np.all(np.diff(result.radius) < 0.0)
    assert np.all(np.diff(result.crack_speed[1:]) < 0.0)
    assert result.radius[-1] == pytest.approx(rest.radius, rel=1e-3)
    again = ViscoelasticAdhesion(BALL, LAW, Path([0.0, 10.0, 20.0], Depth([5e-6, 2e-6, 5e-6]))).solve()
    assert again.radius[-1] == pytest.approx(again.radius[0], rel=1e-9)
    assert again.crack_speed[-1] == 0.0


@pytest.mark.slow
def test_a_flat_punch():
    """Kendall's force with the work of its speed: the edge starts where G = w_0, and then runs in."""
    b = 1e-4
    bed = wk.Foundation(wk.FlatPunch(b), RUBBER)
    kendall = math.sqrt(8.0 * math.pi * MODULUS * W * b**3)
    slow = pulled(1e-14, bed=bed, press=1e-6, far=20e-6)
    assert slow.lowest_force[-1] == pytest.approx(-kendall, rel=1e-3)
    fast = pulled(1e-6, bed=bed, press=1e-6, far=200e-6)
    assert fast.lowest_force[-1] < -1.5 * kendall


@pytest.mark.slow
def test_a_relaxed_solid_and_its_steps():
    solid = StandardSolid(YOUNG / 3.0, 5e6, 1e-4)
    relaxed = pulled(1e-7, bed=wk.Foundation(wk.Paraboloid(R), ViscoelasticHalfSpace(solid)), count=3)
    elastic = pulled(1e-7, count=3)
    assert relaxed.lowest_force[-1] == pytest.approx(elastic.lowest_force[-1], rel=1e-9)
    assert [state.radius for state in elastic.problem.steps()] == elastic.radius.tolist()
    assert worst(elastic.validity[:1]) is Standing.APPROXIMATE


@pytest.mark.slow
def test_a_work_that_comes_to_an_end():
    """Slow as the unbounded law, fast as JKR with the greatest work; what is driven by more runs at once."""
    bounded = SaturatingWork(W, 5.0 * W, 1e-6, 0.6)
    assert bounded.opening(bounded.speed([W, 2.0 * W, 4.9 * W])) == pytest.approx([W, 2.0 * W, 4.9 * W])
    assert bounded.speed([0.1 * W, 5.0 * W, 9.0 * W]).tolist() == [0.0, math.inf, math.inf]
    power = RateDependentWork(W, 1e-6 * 4.0 ** (-1.0 / 0.6), 0.6)
    slow = [pulled(1e-11, law=law).lowest_force[-1] for law in (bounded, power)]
    assert slow[0] == pytest.approx(slow[1], rel=1e-3)
    # pressed so far on that the edge reaches its limit before it comes to the pull-off
    fast = pulled(1.0, law=bounded, press=40e-6, far=120e-6)
    assert fast.lowest_force[-1] == pytest.approx(-7.5 * ONE, rel=2e-3)
    assert fast.radius[-1] == 0.0


@pytest.mark.slow
def test_pulled_at_once():
    """An edge that has no time rests; held, it runs then."""
    result = ViscoelasticAdhesion(BALL, LAW, Path([0.0, 0.0, 1e-12, 1e5], Depth([5e-6, -5e-6, -5e-6, -5e-6]))).solve()
    a = result.radius[0]
    assert result.radius[1] == a
    assert result.force[1] == pytest.approx(2.0 * MODULUS * (-5e-6 * a - a**3 / (3.0 * R)), rel=1e-12)
    assert result.dissipation[1] == pytest.approx(result.dissipation[0], abs=1e-12 * abs(result.force[1]) * 1e-5)
    assert result.radius[-1] == 0.0


def test_the_law():
    assert LAW.opening(LAW.speed([W, 2.0 * W, 7.0 * W])) == pytest.approx([W, 2.0 * W, 7.0 * W])
    assert LAW.speed(0.5 * W) == 0.0
    for wrong in ({"work": 0.0}, {"reference_speed": -1.0}, {"exponent": 1.5}, {"exponent": True}):
        with pytest.raises(InvalidInput, match=next(iter(wrong))):
            RateDependentWork(**{"work": W, "reference_speed": 1e-6, "exponent": 0.6, **wrong})
    with pytest.raises(InvalidInput, match="not above work"):
        SaturatingWork(W, 0.5 * W, 1e-6, 0.6)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"bed": wk.Foundation(wk.Paraboloid(R), ViscoelasticHalfSpace(Maxwell(1e6, 1.0)))}, "creeps without limit"),
        ({"law": wk.ShortRange(W)}, "AdhesiveCycle"),
        ({"path": Path([0.0, 1.0], Force([1e-3, -1e-3]))}, "Force is prescribed"),
        ({"path": Depth([0.0, 1.0])}, "path is a Depth; give Path"),
        ({"path": Path([0.0, 1.0], Depth([0.0, 1e-6]), Shift([0.0, 1e-6]))}, "lateral"),
        ({"machine_stiffness": 0.0}, "machine_stiffness"),
    ],
)
def test_wrong_input_is_refused(given, message):
    right = {"bed": BALL, "law": LAW, "path": Path([0.0, 1.0], Depth([1e-6, -1e-6]))}
    with pytest.raises(InvalidInput, match=message):
        ViscoelasticAdhesion(**{**right, **given})


def test_beyond_the_profile_is_refused():
    r = np.linspace(0.0, 1e-4, 200)
    known = wk.Foundation(wk.Measured(r, r**2 / (2.0 * R)), RUBBER)
    with pytest.raises(OutsideValidity, match="reach"):
        ViscoelasticAdhesion(known, LAW, Path([0.0, 1.0], Depth([1e-6, 5e-5]))).solve()


SOFTENING = wk.StandardSolid(relaxed_shear=1e6, shear=3e6, relaxation_time=0.1)


@pytest.mark.slow
@pytest.mark.parametrize("alike", [False, True])
def test_layers_that_relax_count_as_relaxed(alike):
    film = wk.CoatedHalfSpace(
        [wk.Layer(wk.Elastic(2e6 * (1 + SOFTENING.poisson), SOFTENING.poisson), 1e-4)], on=wk.Rigid()
    )
    layers = [wk.ViscoelasticLayer(SOFTENING, 1e-4)]
    medium = (
        wk.RelaxingInProportion(film, SOFTENING, 1e6)
        if alike
        else wk.ViscoelasticCoatedHalfSpace(layers, on=wk.Rigid())
    )
    ball, path = wk.Paraboloid(1e-3), wk.Path([0.0, 1.0], wk.Depth([2e-6, 1.9e-6]))
    law = wk.RateDependentWork(work=0.05, reference_speed=1e-6, exponent=0.6)
    first = next(iter(wk.ViscoelasticAdhesion(wk.Foundation(ball, medium), law, path).steps()))
    stuck = wk.AdhesiveIndentation(wk.Foundation(ball, film), wk.ShortRange(0.05), wk.Depth(2e-6)).solve()
    assert first.force == pytest.approx(float(stuck.force), rel=1e-6)


def test_moduli_that_are_not_the_relaxed_ones_are_refused():
    medium = wk.RelaxingInProportion(wk.HalfSpace(wk.Elastic(9e6, 0.5)), SOFTENING, 3e6)
    law = wk.RateDependentWork(work=0.05, reference_speed=1e-6, exponent=0.6)
    path = wk.Path([0.0, 1.0], wk.Depth([2e-6, 1.9e-6]))
    with pytest.raises(wk.InvalidInput, match=r"with the relaxed moduli in the medium .* 1e\+06 Pa"):
        wk.ViscoelasticAdhesion(wk.Foundation(wk.Paraboloid(1e-3), medium), law, path)
