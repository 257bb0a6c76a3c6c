"""Oscillating depth and shift together, and relaxation damping: closed forms, mpmath, a march of springs."""

from __future__ import annotations

import itertools
import math
from types import SimpleNamespace

import mpmath as mp
import numpy as np
import pytest

import winkler as wk
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Depth, Shift
from winkler.problems.friction.tangential import Tangential
from winkler.problems.ring_slip.sliding_springs import sliding_springs
from winkler.reference.damping import relaxation_loss, relaxation_viscosity

MEDIUM = wk.HalfSpace.between(wk.Elastic(young=200e9, poisson=0.3), wk.Elastic(young=200e9, poisson=0.3))
E, G = MEDIUM.modulus, MEDIUM.shear_modulus
R = 10e-3
BALL = wk.Foundation(wk.Paraboloid(R), MEDIUM)
CONE = wk.Foundation(wk.Cone(half_angle=1.5), MEDIUM)
FREE = Coulomb(math.inf)
DEPTH, DOWN, ASIDE = 2e-6, 0.6e-6, 0.3e-6


def marched(mu, depth, down, aside, phase, n, m, count, steps):
    """Return the losses of the first two closed cycles of a ball: `count` springs, straight small steps."""
    beta = mu * E / G
    edge = math.sqrt(R * (depth + down))
    x = (np.arange(count) + 0.5) / count * edge
    gap = x * x / R
    turn = np.linspace(0.0, 2.0 * np.pi, steps + 1)
    sunk, moved = depth + down * np.cos(n * turn), aside * np.cos(m * turn + phase)
    held, lost = np.zeros(count), []
    for _ in range(2):
        total = 0.0
        for (d0, d1), (u0, u1) in zip(itertools.pairwise(sunk), itertools.pairwise(moved), strict=True):
            before, after = np.maximum(beta * (d0 - gap), 0.0), np.maximum(beta * (d1 - gap), 0.0)
            share = np.clip((d1 - gap) / (d1 - d0), 0.0, 1.0) if d1 > d0 else 1.0
            trial = held + (u1 - u0) * np.where((before == 0.0) & (after > 0.0), share, 1.0)
            new = np.clip(trial, -after, after)
            total += float(np.sum(np.abs(trial - new) * (before + after)) * G * edge / count)
            held = new
        lost.append(total)
    return lost


CYCLES = [
    # mu, depth, down, aside, phase, n, m
    (0.3, DEPTH, DOWN, ASIDE, 0.7, 1, 1),
    (0.3, DEPTH, DOWN, 2.0 * ASIDE, 0.0, 1, 1),
    (0.3, DEPTH, DOWN, ASIDE, 0.4, 2, 1),
    (0.3, DEPTH, DOWN, ASIDE, -1.0, 3, 2),
    (0.3, DEPTH, 1.5 * DEPTH, ASIDE, 0.7, 1, 1),
    (0.3, DEPTH, 1.5 * DEPTH, ASIDE, 0.7, 2, 3),
    (2.0, DEPTH, 0.9 * DEPTH, ASIDE, 1.7, 1, 1),
]


@pytest.mark.few(4)
@pytest.mark.parametrize("cycle", CYCLES, ids=str)
def test_against_a_march_of_springs(cycle):
    """The march converges to it with the second power of its steps, and its second cycle is steady."""
    mu, depth, down, aside, phase, n, m = cycle
    problem = wk.BimodalDamping(BALL, Coulomb(mu), depth, down, aside, phase, n, m)
    loss = problem.solve().loss_per_cycle
    coarse = marched(*cycle, count=150, steps=300)[1]
    fine = marched(*cycle, count=450, steps=900)[1]
    assert fine == pytest.approx(loss, rel=1e-3)
    assert abs(fine - loss) < 0.2 * abs(coarse - loss) + 1e-5 * loss


@pytest.mark.few(2)
@pytest.mark.parametrize(("n", "m", "count"), [(1, 1, 60), (1, 1, 240), (1, 2, 120), (3, 2, 200)])
def test_against_a_march_along_the_path(n, m, count):
    """`Tangential` along straight pieces, which cut corners by the square of their length."""
    problem = wk.BimodalDamping(BALL, Coulomb(0.3), DEPTH, DOWN, ASIDE, 0.7, n, m)
    loss = problem.solve().loss_per_cycle
    path = problem.path(0.7, ASIDE, 2, count)
    trace = Tangential(BALL, Coulomb(0.3), path).solve()
    first = int(np.searchsorted(path.time, 1.0))
    assert path.time[first] == 1.0
    assert trace.dissipation[-1] - trace.dissipation[first] == pytest.approx(loss, rel=10.0 * (max(n, m) / count) ** 2)


def test_a_steady_depth_is_mindlin_and_deresiewicz():
    shift = np.array([0.1, 0.5, 1.0, 3.0]) * 0.3 * E / G * DEPTH
    still = wk.BimodalDamping(BALL, Coulomb(0.3), DEPTH, 0.0, shift, 0.3).solve()
    steady = wk.FrictionDamping(BALL, Coulomb(0.3), Depth(DEPTH), Shift(shift)).solve()
    np.testing.assert_allclose(still.loss_per_cycle, steady.loss_per_cycle, rtol=1e-10)
    np.testing.assert_allclose(still.loss_stiffness, steady.loss_stiffness, rtol=1e-10)
    np.testing.assert_allclose(still.damping(10.0), steady.damping(10.0), rtol=1e-10)


def test_pressing_alone_loses_nothing():
    assert wk.BimodalDamping(BALL, Coulomb(0.3), DEPTH, DOWN, 0.0).solve().loss_per_cycle == 0.0
    # nor does a push so small that nothing slides for it: in phase, within the cone of friction
    aside = 0.5 * 0.3 * E / G * DOWN
    assert wk.BimodalDamping(BALL, Coulomb(0.3), DEPTH, DOWN, aside).solve().loss_per_cycle == 0.0
    assert wk.BimodalDamping(BALL, Coulomb(0.3), DEPTH, DOWN, aside, 0.2).solve().loss_per_cycle > 0.0
    assert wk.BimodalDamping(BALL, Coulomb(0.3), DEPTH, DOWN, 2.5 * aside).solve().loss_per_cycle > 0.0


def test_mirrored_motion_loses_as_much():
    here = wk.BimodalDamping(BALL, Coulomb(0.3), DEPTH, DOWN, ASIDE, 0.7).solve().loss_per_cycle
    there = wk.BimodalDamping(BALL, Coulomb(0.3), DEPTH, DOWN, ASIDE, 0.7 + math.pi).solve().loss_per_cycle
    assert there == pytest.approx(here, rel=1e-10)


def test_relaxation_of_cones_at_any_amplitude():
    """(16/3) G* A_x^2 |A_z| sin^2(phase) / g'(a), exact where k grows in proportion to the depth."""
    phase = np.array([0.0, 0.3, 1.0, math.pi / 2, 2.5, -1.0])
    slope = float(CONE.gap_slope(np.ones(1))[0])
    for down in (1e-9, DOWN, DEPTH):
        swing = wk.BimodalDamping(CONE, FREE, DEPTH, down, ASIDE, phase).solve()
        closed = relaxation_loss(phase, depth_amplitude=down, shift_amplitude=ASIDE, gap_slope=slope, shear_modulus=G)
        np.testing.assert_allclose(swing.loss_per_cycle, closed, rtol=1e-10 if down > 1e-9 else 1e-7, atol=0.0)


def test_relaxation_of_a_ball():
    """Small amplitudes of the depth by Popov, Popov and Pohrt; large ones at 30 digits."""
    slope = 2.0 * math.sqrt(DEPTH / R)
    off = []
    for down in (0.1 * DEPTH, 0.01 * DEPTH):
        loss = wk.BimodalDamping(BALL, FREE, DEPTH, down, ASIDE, 0.8).solve().loss_per_cycle
        closed = relaxation_loss(0.8, depth_amplitude=down, shift_amplitude=ASIDE, gap_slope=slope, shear_modulus=G)
        off.append(abs(loss / float(closed) - 1.0))
    assert off[0] < 1e-3
    assert off[1] < 0.0101 * off[0]
    for down in (0.5 * DEPTH, DEPTH, 2.5 * DEPTH):
        loss = wk.BimodalDamping(BALL, FREE, DEPTH, down, ASIDE, 0.8).solve().loss_per_cycle
        with mp.workdps(30):
            low = mp.sqrt(R * max(DEPTH - down, 0.0))
            high = mp.sqrt(R * (mp.mpf(DEPTH) + down))
            parted = mp.quad(lambda x, down=down: 1 - ((x**2 / R - DEPTH) / down) ** 2, [low, high])
            exact = float(4 * G * ASIDE**2 * mp.sin(mp.mpf("0.8")) ** 2 * parted)
        assert loss == pytest.approx(exact, rel=1e-11)


@pytest.mark.parametrize(("n", "m"), [(2, 1), (3, 1), (1, 2), (3, 2), (1, 3), (2, 3)])
def test_relaxation_of_other_frequency_ratios(n, m):
    """Springs hold, when they part, what the shift has moved since they touched: summed at 30 digits."""
    phase, down = 0.8, 0.7 * DEPTH
    loss = wk.BimodalDamping(BALL, FREE, DEPTH, down, ASIDE, phase, n, m).solve().loss_per_cycle

    def parted(x):
        touching = mp.re(mp.acos((x**2 / R - DEPTH) / down)) / n
        held = [
            mp.cos(m * (2 * mp.pi * j / n + touching) + phase) - mp.cos(m * (2 * mp.pi * j / n - touching) + phase)
            for j in range(n)
        ]
        return mp.fsum(each**2 for each in held)

    with mp.workdps(20):
        edges = [mp.sqrt(R * mp.mpf(DEPTH - down)), mp.sqrt(R * mp.mpf(DEPTH + down))]
        exact = float(G * ASIDE**2 * mp.quad(parted, edges))
    assert loss == pytest.approx(exact, rel=1e-11)


def test_much_friction_tends_to_relaxation():
    """The losses come closer in proportion to 1 / mu."""
    free = wk.BimodalDamping(BALL, FREE, DEPTH, DOWN, ASIDE, 1.0).solve().loss_per_cycle
    off = [
        mu * (wk.BimodalDamping(BALL, Coulomb(mu), DEPTH, DOWN, ASIDE, 1.0).solve().loss_per_cycle / free - 1.0)
        for mu in (10.0, 100.0, 1000.0)
    ]
    assert off[0] == pytest.approx(off[2], rel=1e-2)
    assert off[1] == pytest.approx(off[2], rel=1e-3)
    assert off[2] < 0.0


def test_a_contact_that_is_lost_and_a_flat_punch():
    """A flat punch that lifts off in every cycle loses what all of it holds."""
    punch = wk.Foundation(wk.FlatPunch(radius=1e-3), MEDIUM)
    phase = 0.6
    lifted = wk.BimodalDamping(punch, FREE, DEPTH, 2.0 * DEPTH, ASIDE, phase).solve().loss_per_cycle
    touching = math.acos(-0.5)
    held = 2.0 * ASIDE * math.sin(touching) * math.sin(phase)
    assert lifted == pytest.approx(0.5 * 2.0 * G * 1e-3 * held**2, rel=1e-12)
    assert wk.BimodalDamping(punch, FREE, DEPTH, 0.5 * DEPTH, ASIDE, phase).solve().loss_per_cycle == 0.0
    assert wk.BimodalDamping(punch, Coulomb(0.3), DEPTH, 2.0 * DEPTH, ASIDE, phase).solve().loss_per_cycle > 0.0


def test_a_graded_medium_whose_springs_stiffen_towards_the_axis():
    """c_T ~ x^k with k < 0: the relaxation of a parabola, at 30 digits."""
    soil = wk.GradedHalfSpace(wk.PowerLawGraded(young=5e9, depth_scale=1e-3, exponent=-0.3, poisson=0.25))
    bed = wk.Foundation(wk.Paraboloid(R), soil)
    curve, stiff = (float(f(np.ones(1) * 1e-3)[0]) for f in (bed.gap, bed.tangential_stiffness))
    phase, down = 1.1, 1.2 * DEPTH
    loss = wk.BimodalDamping(bed, FREE, DEPTH, down, ASIDE, phase).solve().loss_per_cycle
    with mp.workdps(25):
        edge = 1e-3 * mp.sqrt((DEPTH + down) / mp.mpf(curve))

        def parted(t):
            x = edge * t**4
            share = ((x / 1e-3) ** 2 * curve - DEPTH) / down
            return stiff * (x / 1e-3) ** mp.mpf("-0.3") * (1 - share**2) * 4 * edge * t**3

        exact = float(4 * ASIDE**2 * mp.sin(mp.mpf(phase)) ** 2 * mp.quad(parted, [0, 1]))
    assert loss == pytest.approx(exact, rel=1e-10)


def test_fast_pressing_is_a_viscous_damper():
    """3.7367 G* A_z / (omega g'), for cones of any amplitude; for balls as it becomes small."""
    slope = float(CONE.gap_slope(np.ones(1))[0])
    damper = wk.RelaxationDamper(CONE, DEPTH, DOWN, 1e3).solve()
    closed = float(relaxation_viscosity(DOWN, frequency=1e3, gap_slope=slope, shear_modulus=G))
    assert damper.damping == pytest.approx(closed, rel=1e-11)
    assert closed * 2e3 * math.pi * slope / (G * DOWN) == pytest.approx(3.7367, abs=5e-5)
    assert damper.shear_stiffness == pytest.approx(2.0 * G * (DEPTH - DOWN) / slope, rel=1e-12)

    off = []
    for down in (0.1 * DEPTH, 0.01 * DEPTH):
        ball = wk.RelaxationDamper(BALL, DEPTH, down, 1e3).solve().damping
        small = relaxation_viscosity(down, frequency=1e3, gap_slope=2.0 * math.sqrt(DEPTH / R), shear_modulus=G)
        off.append(abs(ball / float(small) - 1.0))
    assert off[0] < 0.04
    assert off[1] == pytest.approx(0.1 * off[0], rel=0.1)


def test_the_damper_is_the_limit_of_slow_shifts():
    """What a slow harmonic shift loses, as the depth goes to and fro more often within it; by the second power."""
    off = []
    for n in (20, 80):
        loss = wk.BimodalDamping(BALL, FREE, DEPTH, DOWN, ASIDE, 0.4, n).solve()
        damper = wk.RelaxationDamper(BALL, DEPTH, DOWN, float(n)).solve()
        off.append(abs(loss.damping(1.0) / damper.damping - 1.0))
    assert off[0] < 5e-3
    assert off[1] == pytest.approx(off[0] / 16.0, rel=0.02)


@pytest.mark.slow
def test_arrays_and_notes():
    phase = np.linspace(0.0, math.pi, 3)
    swing = wk.BimodalDamping(BALL, Coulomb(0.3), DEPTH, DOWN, np.array([[ASIDE], [2.0 * ASIDE]]), phase).solve()
    assert np.shape(swing.loss_per_cycle) == (2, 3)
    assert np.shape(swing.loss_stiffness) == (2, 3)
    one = wk.BimodalDamping(BALL, Coulomb(0.3), DEPTH, DOWN, 2.0 * ASIDE, float(phase[1])).solve()
    assert isinstance(one.loss_per_cycle, float)
    assert one.loss_per_cycle == swing.loss_per_cycle[1, 1]
    assert any("From the second cycle on" in note.statement for note in swing.validity)
    assert any("Cattaneo-Mindlin" in note.statement for note in swing.validity)
    assert any(
        "No slip is assumed" in note.statement for note in wk.RelaxationDamper(BALL, DEPTH, DOWN, 1.0).solve().validity
    )


@pytest.mark.slow
def test_scaling():
    """Lengths times s, moduli times m: energies times m s^3."""
    s, m = 300.0, 1e-3
    bed = wk.Foundation(wk.Paraboloid(R * s), wk.HalfSpace.between(*[wk.Elastic(young=200e9 * m, poisson=0.3)] * 2))
    small = wk.BimodalDamping(BALL, Coulomb(0.3), DEPTH, DOWN, ASIDE, 0.7, 2, 3).solve().loss_per_cycle
    large = wk.BimodalDamping(bed, Coulomb(0.3), s * DEPTH, s * DOWN, s * ASIDE, 0.7, 2, 3).solve().loss_per_cycle
    assert large == pytest.approx(m * s**3 * small, rel=1e-10)


def test_refusals():
    law = Coulomb(0.3)
    with pytest.raises(wk.InvalidInput, match="positive coefficient"):
        wk.BimodalDamping(BALL, Coulomb(0.0), DEPTH, DOWN, ASIDE)
    with pytest.raises(wk.InvalidInput, match="give a finite number"):
        wk.BimodalDamping(BALL, law, math.nan, DOWN, ASIDE)
    with pytest.raises(wk.InvalidInput, match="phase is"):
        wk.BimodalDamping(BALL, law, DEPTH, DOWN, ASIDE, math.inf)
    with pytest.raises(wk.InvalidInput, match="negative"):
        wk.BimodalDamping(BALL, law, DEPTH, DOWN, [ASIDE, -ASIDE])
    with pytest.raises(wk.InvalidInput, match="whole number"):
        wk.BimodalDamping(BALL, law, DEPTH, DOWN, ASIDE, normal_cycles=0)
    with pytest.raises(wk.InvalidInput, match="give 2 and 1"):
        wk.BimodalDamping(BALL, law, DEPTH, DOWN, ASIDE, normal_cycles=4, lateral_cycles=2)
    with pytest.raises(wk.InvalidInput, match="go together"):
        wk.BimodalDamping(BALL, law, DEPTH, DOWN, [ASIDE] * 2, [0.0] * 3)
    with pytest.raises(wk.OutsideValidity, match="never brings"):
        wk.BimodalDamping(BALL, law, -2.0 * DOWN, DOWN, ASIDE).solve()
    uneven = SimpleNamespace(medium=None, normal_stiffness=np.ones_like, tangential_stiffness=lambda x: 1.0 + x)
    with pytest.raises(wk.OutsideValidity, match="the same everywhere"):
        sliding_springs("BimodalDamping", uneven, 0.3, 1.0)
    for wrong in ({"depth": math.inf}, {"depth_amplitude": 0.0}, {"frequency": -1.0}, {"frequency": True}):
        with pytest.raises(wk.InvalidInput, match="RelaxationDamper"):
            wk.RelaxationDamper(BALL, **({"depth": DEPTH, "depth_amplitude": DOWN, "frequency": 1.0} | wrong))
    with pytest.raises(wk.OutsideValidity, match="never brings"):
        wk.RelaxationDamper(BALL, -DEPTH, DOWN, 1.0).solve()
