"""Adhesive cycles: closed forms of energies and limits, the balance of energy, and waves against brute force."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import struve

import winkler as wk
from winkler.laws.adhesion import DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.materials.graded import PowerLawGraded
from winkler.materials.layered import Layer
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.problems.adhesion.cycle import AdhesiveCycle

MODULUS, RADIUS, WORK = 7.0e6, 3.0e-3, 0.05
MEDIUM = wk.HalfSpace(wk.Elastic(MODULUS, 0.0))
BALL = wk.Foundation(wk.Paraboloid(RADIUS), MEDIUM)
UNIT = (WORK**5 * RADIUS**4 / MODULUS**2) ** (1 / 3)
LENGTH = (WORK**2 * RADIUS / MODULUS**2) ** (1 / 3)


def ball_energy(a, w, e=MODULUS, r=RADIUS):
    """Elastic less surface energy of a ball in equilibrium at the radius a, at 30 digits."""
    d = a**2 / r - mp.sqrt(2 * mp.pi * a * w / e)
    return e * (d**2 * a - 2 * d * a**3 / (3 * r) + a**5 / (5 * r**2)) - w * mp.pi * a**2


def test_energies_of_a_ball_under_fixed_grips():
    cycle = AdhesiveCycle(BALL, ShortRange(WORK), wk.Depth([50 * LENGTH, -50 * LENGTH])).solve()
    with mp.workdps(30):
        w, e, r = mp.mpf(WORK), mp.mpf(MODULUS), mp.mpf(RADIUS)
        snap = (2 * mp.pi * r**2 * w / e) ** (mp.mpf(1) / 3)
        tear = (mp.pi * r**2 * w / (8 * e)) ** (mp.mpf(1) / 3)
        released, left = -ball_energy(snap, w), ball_energy(tear, w)
    assert float(released) / UNIT == pytest.approx(6.418315112, rel=1e-9)
    assert float(left) / UNIT == pytest.approx(0.673880860, rel=2e-9)
    first, last = cycle.jumps
    assert [(jump.snap_in, jump.pull_off) for jump in cycle.jumps] == [(True, False), (False, True)]
    assert first.loss == pytest.approx(float(released), rel=1e-11)
    assert last.loss == pytest.approx(float(left), rel=1e-11)
    assert cycle.dissipation[-1] == pytest.approx(7.092195972 * UNIT, rel=1e-9)
    assert cycle.work[-1] == pytest.approx(float(released + left), rel=1e-11)
    assert first.after.radius == pytest.approx(float(snap), rel=1e-12)
    assert first.after.force == pytest.approx(-4 / 3 * math.pi * WORK * RADIUS, rel=1e-12)
    assert first.after.depth == pytest.approx(0.0, abs=1e-14 * LENGTH)
    assert last.before.radius == pytest.approx(float(tear), rel=1e-10)
    assert last.before.depth == pytest.approx(-0.75 * math.pi ** (2 / 3) * LENGTH, rel=1e-12)
    assert last.before.force == pytest.approx(-5 / 6 * math.pi * WORK * RADIUS, rel=1e-10)
    assert (last.after.radius, last.after.force) == (0.0, 0.0)
    assert np.all(cycle.hysteresis == 0.0)


@pytest.mark.parametrize("stiffness", [0.1, 30.0, 300.0, 1e4])
def test_pull_off_in_a_machine(stiffness):
    """The edge loses its hold where (g' - l/2a) + (2E*/k_m)(a g' - 3l/2) = 0 (theory, section 4)."""
    far = 50 * LENGTH + 20 * WORK * RADIUS / stiffness
    cycle = AdhesiveCycle(BALL, ShortRange(WORK), wk.Depth([far, -far]), stiffness).solve()
    with mp.workdps(30):

        def balance(a):
            stretch = mp.sqrt(2 * mp.pi * a * WORK / MODULUS)
            soft = 2 * a / RADIUS - stretch / (2 * a)
            return soft + 2 * MODULUS / mp.mpf(stiffness) * (2 * a**2 / RADIUS - 3 * stretch / 2)

        grips = (mp.pi * RADIUS**2 * WORK / (8 * MODULUS)) ** (mp.mpf(1) / 3)
        tear = mp.findroot(balance, (grips, grips * mp.mpf(9) ** (mp.mpf(1) / 3)), solver="anderson", tol=1e-25)
        depth = tear**2 / RADIUS - mp.sqrt(2 * mp.pi * tear * WORK / MODULUS)
        force = 2 * MODULUS * (tear * depth - tear**3 / (3 * RADIUS))
        lost = ball_energy(tear, WORK) + force**2 / (2 * mp.mpf(stiffness))
    jump = cycle.jumps[-1]
    assert jump.before.radius == pytest.approx(float(tear), rel=1e-9)
    assert jump.before.force == pytest.approx(float(force), rel=1e-9)
    assert jump.before.position == pytest.approx(float(depth + force / stiffness), rel=1e-11)
    assert jump.after.position == pytest.approx(jump.before.position, rel=1e-12)
    assert jump.loss == pytest.approx(float(lost), rel=1e-10)


def test_loop_of_a_ball_with_hysteresis():
    """Snap-in with the closing work, the area passed at a price of the difference, pull-off with the opening work."""
    closing, opening, most = 0.3 * WORK, WORK, 40 * LENGTH
    law = ShortRange(work_closing=closing, work_opening=opening)
    cycle = AdhesiveCycle(BALL, law, wk.Depth([most, -most])).solve()
    with mp.workdps(30):
        widest = mp.findroot(
            lambda a: a**2 / RADIUS - mp.sqrt(2 * mp.pi * a * closing / MODULUS) - most, mp.sqrt(RADIUS * most)
        )
        paid = (mp.mpf(opening) - closing) * mp.pi * widest**2
    units = [(w**5 * RADIUS**4 / MODULUS**2) ** (1 / 3) for w in (closing, opening)]
    assert cycle.radius[0] == pytest.approx(float(widest), rel=1e-12)
    assert cycle.hysteresis[-1] == pytest.approx(float(paid), rel=1e-11)
    expected = 6.418315112 * units[0] + float(paid) + 0.673880860 * units[1]
    assert cycle.dissipation[-1] == pytest.approx(expected, rel=1e-9)
    assert cycle.work[-1] == pytest.approx(expected, rel=1e-9)
    assert cycle.dissipation[0] == pytest.approx(6.418315112 * units[0], rel=1e-9)


def test_a_pinned_edge_moves_along_a_straight_line():
    """Between closing and opening the contact is a flat punch: dF/dd = k(a), and nothing is lost."""
    law = ShortRange(work_closing=0.3 * WORK, work_opening=WORK)
    top = 40 * LENGTH
    path = wk.Depth(top + LENGTH * np.array([0.0, -0.5, -1.0, -0.3, 0.0]))
    cycle = AdhesiveCycle(BALL, law, path).solve()
    np.testing.assert_allclose(cycle.radius, cycle.radius[0], rtol=1e-14)
    slope = np.diff(cycle.force) / np.diff(cycle.depth)
    np.testing.assert_allclose(slope, 2 * MODULUS * cycle.radius[0], rtol=1e-9)
    assert np.ptp(cycle.dissipation) == 0.0


def test_loop_of_a_flat_punch_with_hysteresis():
    """Closing gains w_c pi b^2; opening takes the elastic energy 2 pi b^2 w_o of Kendall's pull-off."""
    punch, closing, opening = 0.4e-3, 0.2 * WORK, WORK
    bed = wk.Foundation(wk.FlatPunch(punch), MEDIUM)
    law = ShortRange(work_closing=closing, work_opening=opening)
    cycle = AdhesiveCycle(bed, law, wk.Depth([1e-6, -1e-4])).solve()
    snap, tear = cycle.jumps
    assert snap.loss == pytest.approx(closing * math.pi * punch**2, rel=1e-12)
    assert tear.loss == pytest.approx((2 * opening - closing) * math.pi * punch**2, rel=1e-12)
    assert cycle.dissipation[-1] == pytest.approx(2 * math.pi * punch**2 * opening, rel=1e-12)
    assert tear.before.force == pytest.approx(-math.sqrt(8 * math.pi * MODULUS * opening * punch**3), rel=1e-12)
    assert tear.before.radius == snap.after.radius == punch
    assert cycle.hysteresis[-1] == pytest.approx((opening - closing) * math.pi * punch**2, rel=1e-12)


def test_dead_loads():
    """Under no load the ball is drawn in to a0^3 = 9 pi R^2 w / 2E*; the work is that of the load."""
    least = -1.5 * math.pi * WORK * RADIUS
    cycle = AdhesiveCycle(BALL, ShortRange(WORK), wk.Force([0.0, 3.0 * WORK * RADIUS, 0.999999 * least])).solve()
    (snap,) = cycle.jumps
    drawn = (4.5 * math.pi * RADIUS**2 * WORK / MODULUS) ** (1 / 3)
    assert cycle.radius[0] == pytest.approx(drawn, rel=1e-12)
    assert cycle.depth[0] == pytest.approx(drawn**2 / (3 * RADIUS), rel=1e-11)
    with mp.workdps(30):
        assert snap.loss == pytest.approx(-float(ball_energy(mp.mpf(drawn), WORK)), rel=1e-11)
    assert cycle.work[0] == pytest.approx(0.0, abs=1e-12 * snap.loss)
    np.testing.assert_array_equal(cycle.position, cycle.depth)
    problem = AdhesiveCycle(BALL, ShortRange(WORK), wk.Force([0.0, 1.000001 * least, 0.0]))
    steps = problem.steps()
    assert next(steps).radius == pytest.approx(drawn, rel=1e-12)
    with pytest.raises(wk.OutsideValidity, match=r"At index 1 of the path .* lowest force .* is -0.000706858 N"):
        next(steps)
    with pytest.raises(wk.OutsideValidity, match="At index 0"):
        AdhesiveCycle(BALL, ShortRange(WORK), wk.Force([0.5 * least])).solve()


def power_branch(n, c, w, machine):
    """F, dD/da of an edge under f whose g = c x^n, in equilibrium with the work w."""

    def force_and_slope(a):
        stretch = np.sqrt(2 * np.pi * a * w / MODULUS)
        depth, steep = c * a**n - stretch, n * c * a ** (n - 1) - 0.5 * stretch / a
        force = 2 * MODULUS * (a * depth - c * a ** (n + 1) / (n + 1))
        return force, steep + 2 * MODULUS / machine * (a * steep - stretch)

    return force_and_slope


def work_along(cycle, n, c, law, machine):
    """The integral of F dD by Gauss' rule in closed forms, piece by piece between the events of the solution."""
    nodes, weights = np.polynomial.legendre.leggauss(24)

    def moving(w, start, end):
        # a = s^2: everything is a polynomial in s where n is a multiple of one half
        low, high = math.sqrt(start), math.sqrt(end)
        s = 0.5 * (low + high) + 0.5 * (high - low) * nodes
        force, slope = power_branch(n, c, w, machine)(s * s)
        return 0.5 * (high - low) * float(np.sum(weights * force * slope * 2 * s))

    def straight(a, start, end):
        """A pinned edge: F is linear in D."""
        if a == 0.0:
            return 0.0
        stiffness = 2 * MODULUS * a
        load = 2 * MODULUS * c * a ** (n + 1) / (n + 1)

        def force(position):
            depth = (position + load / machine) / (1 + stiffness / machine)
            return stiffness * depth - load

        return 0.5 * (force(start) + force(end)) * (end - start)

    def level(a, w):
        stretch = math.sqrt(2 * math.pi * a * w / MODULUS)
        depth = c * a**n - stretch
        return depth + 2 * MODULUS * (a * depth - c * a ** (n + 1) / (n + 1)) / machine

    total, radius, position = [], 0.0, -1.0
    spent = 0.0
    for state in cycle.problem.steps():
        rising = state.position >= position
        w = law.work_closing if rising else law.work_opening
        a, here = radius, position
        for jump in state.jumps:
            if jump.before.radius == a:
                spent += straight(a, here, jump.before.position)
            else:
                turn = level(a, w)
                spent += straight(a, here, turn) + moving(w, a, jump.before.radius)
            a, here = jump.after.radius, jump.after.position
        if state.radius == a:
            spent += straight(a, here, state.position)
        else:
            turn = level(a, w)
            spent += straight(a, here, turn) + moving(w, a, state.radius)
        total.append(spent)
        radius, position = state.radius, state.position
    return np.array(total)


SHAPES = {
    "cone": (1.0, 0.4),
    "blunt": (1.5, 2.0),
    "ball": (2.0, 1.0 / RADIUS),
    "fourth": (4.0, 1e8),
}


@pytest.mark.slow
@settings(max_examples=40, deadline=None, derandomize=True)
@given(
    name=st.sampled_from(sorted(SHAPES)),
    turns=st.lists(st.floats(-3.0, 12.0), min_size=1, max_size=6),
    ratio=st.sampled_from([0.0, 0.2, 0.7, 1.0]),
    softness=st.floats(0.0, 10.0),
)
def test_energy_is_conserved(name, turns, ratio, softness):
    """Work of the machine, integrated independently, = energy stored + energy lost; nothing is ever gained."""
    n, c = SHAPES[name]
    factor = {1.0: math.pi / 2, 1.5: 1.5 * math.gamma(0.75) * math.sqrt(math.pi) / (2 * math.gamma(1.25)), 2.0: 2.0}
    factor[4.0] = 8.0 / 3.0
    bed = wk.Foundation(wk.PowerLaw(c / factor[n], n), MEDIUM)
    np.testing.assert_allclose(bed.gap(np.array([1e-3])), c * 1e-3**n, rtol=1e-13)
    edge = (math.pi * WORK / (2 * n * n * c * c * MODULUS)) ** (1 / (2 * n - 1))
    scale = math.sqrt(2 * math.pi * edge * WORK / MODULUS)
    machine = 2 * MODULUS * edge / softness if softness > 1e-3 else math.inf
    law = ShortRange(work_closing=ratio * WORK, work_opening=WORK)
    cycle = AdhesiveCycle(bed, law, wk.Depth(scale * np.array(turns)), machine).solve()
    assert np.all(np.diff(cycle.dissipation, prepend=0.0) >= 0.0)
    assert np.all(np.diff(cycle.hysteresis, prepend=0.0) >= 0.0)
    assert np.all(cycle.hysteresis <= cycle.dissipation * (1 + 1e-12))
    assert all(jump.loss >= 0.0 for jump in cycle.jumps)
    spent = work_along(cycle, n, c, law, machine)
    # stored energy in closed form: E* Int_0^a (d - c x^n)^2 dx
    d, a = cycle.depth, cycle.radius
    stored = MODULUS * (d * d * a - 2 * d * c * a ** (n + 1) / (n + 1) + c * c * a ** (2 * n + 1) / (2 * n + 1))
    stored += 0.5 * cycle.force**2 / machine - law.work_closing * np.pi * a * a
    size = np.max(np.abs(stored)) + cycle.dissipation[-1] + WORK * edge**2
    np.testing.assert_allclose(cycle.energy, stored, atol=1e-11 * size, rtol=0)
    np.testing.assert_allclose(spent, stored + cycle.dissipation, atol=1e-10 * size, rtol=0)
    np.testing.assert_allclose(spent, cycle.work, atol=1e-10 * size, rtol=0)


@pytest.mark.parametrize("law", [ShortRange(WORK), ShortRange(work_closing=0.5 * WORK, work_opening=WORK)])
@pytest.mark.parametrize("machine", [math.inf, 300.0])
def test_only_the_turning_points_matter(law, machine):
    turns = LENGTH * np.array([5.0, -2.0, 20.0, 1.0, 8.0, -60.0, 3.0])
    coarse = AdhesiveCycle(BALL, law, wk.Depth(turns), machine).solve()
    rng = np.random.default_rng(5)
    fine, marks = [turns[:1]], [0]
    for low, high in zip(turns[:-1], turns[1:], strict=True):
        between = np.sort(rng.uniform(min(low, high), max(low, high), 37))
        fine.append(np.append(between if high > low else between[::-1], high))
        marks.append(marks[-1] + 38)
    dense = AdhesiveCycle(BALL, law, wk.Depth(np.concatenate(fine)), machine).solve()
    for word in ("depth", "force", "radius", "dissipation", "hysteresis", "work"):
        dense_, coarse_ = getattr(dense, word)[marks], getattr(coarse, word)
        np.testing.assert_allclose(dense_, coarse_, rtol=1e-11, atol=1e-13 * np.max(np.abs(coarse_)), err_msg=word)
    assert len(dense.jumps) == len(coarse.jumps) >= 3


def test_many_cycles_cost_the_same_each():
    turns = LENGTH * np.array([5.0, -10.0] * 20)
    cycle = AdhesiveCycle(BALL, ShortRange(WORK), wk.Depth(turns)).solve()
    np.testing.assert_allclose(cycle.dissipation[1::2], 7.092195972 * UNIT * np.arange(1, 21), rtol=1e-9)
    assert len(cycle.jumps) == 40


# --- waves ----------------------------------------------------------------------------------------------------------

HEIGHT, WAVE, WAVY_WORK = 1.0e-3, 0.05, 1.0e-4  # against R = E* = 1


def wavy_gap(x):
    t = 2 * np.pi * x / WAVE
    return x**2 + 0.5 * np.pi * HEIGHT * t * struve(0, t)


def brute_force(depths, grid):
    """Go downhill in the total energy from cell to cell of a grid of radii, for one depth after another.

    Pi(a; d) = E* Int_0^a (d - g)^2 dx - w pi a^2, summed by Simpson's rule; no formula of equilibrium is used.
    """
    cell = np.diff(grid)
    g, middle = wavy_gap(grid), wavy_gap(0.5 * (grid[1:] + grid[:-1]))
    first = np.concatenate([[0.0], np.cumsum(cell * (g[1:] + g[:-1] + 4 * middle) / 6)])
    second = np.concatenate([[0.0], np.cumsum(cell * (g[1:] ** 2 + g[:-1] ** 2 + 4 * middle**2) / 6)])
    index, radii = 0, []
    for d in depths:
        climbs = np.diff(d * d * grid - 2 * d * first + second - WAVY_WORK * np.pi * grid**2) >= 0.0
        onward = index + int(np.argmax(np.append(climbs[index:], True)))
        if onward == index:
            falls = ~climbs[:index][::-1]
            onward = index - int(np.argmax(np.append(falls, True)))
        index = onward
        radii.append(grid[index])
    return np.array(radii)


@pytest.mark.slow
def test_guduru_waves_against_brute_force():
    """Number and place of all jumps of a wavy ball, approaching and retracting, against a search on a grid."""
    bed = wk.Foundation(wk.Paraboloid(1.0) + wk.Wavy(HEIGHT, WAVE), wk.HalfSpace(wk.Elastic(1.0, 0.0)))
    up, down = np.linspace(1e-12, 0.1, 1200), np.linspace(0.1, -0.03, 1600)
    cell = 2e-5
    depths = np.concatenate([up, down])
    searched = brute_force(depths, np.arange(0.0, 0.4, cell))
    cycle = AdhesiveCycle(bed, ShortRange(WAVY_WORK), wk.Depth(depths)).solve()
    places = np.flatnonzero(np.abs(np.diff(searched, prepend=0.0)) > 0.012)  # a quarter of a wave
    advancing = [jump for jump in cycle.jumps if jump.after.radius > jump.before.radius]
    receding = [jump for jump in cycle.jumps if jump.after.radius < jump.before.radius]
    result = [int(np.searchsorted(up, jump.before.depth)) for jump in advancing]
    result += [up.size + int(np.searchsorted(-down, -jump.before.depth)) for jump in receding]
    assert len(advancing) >= 6
    assert len(receding) >= 6
    assert len(places) == len(cycle.jumps)
    assert np.max(np.abs(np.array(result) - places)) <= 1
    # where the edge creeps, the radii agree to a cell, but for the steps beside a jump
    calm = np.ones(depths.size, dtype=bool)
    calm[(places[:, None] + np.arange(-2, 2)).clip(0, depths.size - 1)] = False
    assert np.max(np.abs(searched - cycle.radius)[calm]) < 1.5 * cell
    for jump, place in zip(cycle.jumps, places, strict=True):
        before = searched[place - 1] if place else 0.0
        assert jump.before.radius == pytest.approx(before, abs=2e-3)  # the radius turns like a root towards its limit
        assert jump.after.radius == pytest.approx(searched[place], abs=2e-4)
        assert jump.loss > 0.0


# --- other media and refusals ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("k", [-0.3, 0.4])
def test_a_graded_body_under_fixed_grips(k):
    """Snap-in and pull-off of a paraboloid on E = E0 (z/c0)^k, in the closed forms of theory 8.1 at 30 digits."""
    medium = GradedHalfSpace.between(PowerLawGraded(young=MODULUS, depth_scale=1e-4, exponent=k, poisson=0.3))
    bed = wk.Foundation(wk.Paraboloid(RADIUS), medium)
    cycle = AdhesiveCycle(bed, ShortRange(WORK), wk.Depth([2e-5, -2e-5])).solve()
    with mp.workdps(30):
        e, c0 = mp.mpf(medium.modulus), mp.mpf(1e-4)
        curve = 1 / ((1 + mp.mpf(k)) * RADIUS)

        def energy(a):
            stretch = mp.sqrt(2 * mp.pi * c0**k * a ** (1 - mp.mpf(k)) * WORK / e)
            d = curve * a**2 - stretch
            terms = (d * d / (1 + k), -2 * d * curve * a**2 / (3 + k), curve**2 * a**4 / (5 + k))
            return e * a ** (1 + mp.mpf(k)) / c0**k * sum(terms) - WORK * mp.pi * a * a

        drawn = mp.sqrt(2 * mp.pi * c0**k * WORK / e) / curve  # curve a^2 = stretch
        snap = drawn ** (2 / (3 + mp.mpf(k)))
        # a g' = (1 - k)/2 stretch
        tear = (drawn * (1 - mp.mpf(k)) / 4) ** (2 / (3 + mp.mpf(k)))
    first, last = cycle.jumps
    assert first.after.radius == pytest.approx(float(snap), rel=1e-11)
    assert last.before.radius == pytest.approx(float(tear), rel=1e-9)
    assert first.loss == pytest.approx(-float(energy(snap)), rel=1e-9)
    assert last.loss == pytest.approx(float(energy(tear)), rel=1e-9)
    assert cycle.work[-1] == pytest.approx(float(energy(tear) - energy(snap)), rel=1e-9)


@pytest.mark.slow
def test_a_coated_body_keeps_its_energy():
    """The area of the loop F(d), by Gauss' rule between the jumps, is what the jumps have lost."""
    film = CoatedHalfSpace([Layer(wk.Elastic(20 * MODULUS, 0.3), 1e-5)], on=wk.Elastic(MODULUS, 0.3))
    bed = wk.Foundation(wk.Paraboloid(RADIUS), film)
    most = 2e-6
    ends = AdhesiveCycle(bed, ShortRange(WORK), wk.Depth([most, -most])).solve()
    snap, tear = (jump.before.depth for jump in ends.jumps)
    nodes, weights = np.polynomial.legendre.leggauss(60)
    up = snap + (most - snap) * 0.5 * (1 + nodes)
    # near its limit the radius turns like a square root: d = tear + (most - tear) s^2
    s = 0.5 * (1 - nodes)
    down = tear + (most - tear) * s**2
    cycle = AdhesiveCycle(bed, ShortRange(WORK), wk.Depth(np.concatenate([up, down]))).solve()
    area = 0.5 * (most - snap) * weights @ cycle.force[:60] - (most - tear) * weights @ (cycle.force[60:] * s)
    assert len(ends.jumps) == 2
    assert area == pytest.approx(ends.dissipation[-1], rel=1e-8)
    assert ends.work[-1] == pytest.approx(ends.dissipation[-1], rel=1e-12)


def test_what_is_refused():
    law = ShortRange(WORK)
    with pytest.raises(wk.InvalidInput, match="one row"):
        AdhesiveCycle(BALL, law, wk.Depth([[1e-6], [0.0]]))
    with pytest.raises(wk.InvalidInput, match="one row"):
        AdhesiveCycle(BALL, law, wk.Depth(1e-6))
    with pytest.raises(wk.InvalidInput, match="the path is a Radius"):
        AdhesiveCycle(BALL, law, wk.Radius([1e-6]))
    with pytest.raises(wk.InvalidInput, match="machine_stiffness is 0.0; it must be positive"):
        AdhesiveCycle(BALL, law, wk.Depth([1e-6]), 0.0)
    with pytest.raises(wk.InvalidInput, match="plays no part"):
        AdhesiveCycle(BALL, law, wk.Force([1e-6]), 3.0)
    with pytest.raises(wk.InvalidInput, match="give ShortRange"):
        AdhesiveCycle(BALL, 0.05, wk.Depth([1e-6]))
    tip = wk.Measured(np.linspace(0.0, 1e-4, 30), np.linspace(0.0, 1e-4, 30) ** 2 / (2 * RADIUS))
    steps = AdhesiveCycle(wk.Foundation(tip, MEDIUM), law, wk.Depth([1e-7, 1e-3])).steps()
    assert next(steps).radius > 0.0
    with pytest.raises(wk.OutsideValidity, match="At index 1 .* beyond the reach of the profile"):
        next(steps)


def test_a_ring_that_touches_first_is_refused():
    """A wave so high that the edge would have to climb over the energy of a trough."""
    bed = wk.Foundation(wk.Paraboloid(1.0) + wk.Wavy(0.02, 0.05), wk.HalfSpace(wk.Elastic(1.0, 0.0)))
    with pytest.raises(wk.OutsideValidity, match="A ring of the body touches there first"):
        AdhesiveCycle(bed, ShortRange(1e-7), wk.Depth([0.2])).solve()


def test_notes_of_a_cycle_state_its_validity():
    cycle = AdhesiveCycle(BALL, ShortRange(WORK), wk.Depth([1e-6, -1e-6])).solve()
    assert any("except in 2 jumps" in note.statement for note in cycle.validity)
    assert any("without range" in note.statement for note in cycle.validity)
    assert cycle == AdhesiveCycle(BALL, ShortRange(WORK), wk.Depth([1e-6, -1e-6])).solve()


# --- attraction with a range ----------------------------------------------------------------------------------------

PULL = math.pi * WORK * RADIUS


def test_dmt_in_a_machine():
    """The pull 2 pi w R comes up at touch; torn off, the machine's spring has stored (2 pi w R)^2 / 2 k_m."""
    law, stiffness = DerjaguinMullerToporov(WORK), 40.0
    far = 10.0 * PULL / stiffness
    cycle = AdhesiveCycle(BALL, law, wk.Depth([far, -far]), stiffness).solve()
    snap, tear = cycle.jumps
    assert tear.pull_off
    assert tear.before.force == pytest.approx(-2.0 * PULL, rel=1e-12)
    assert tear.before.position == pytest.approx(-2.0 * PULL / stiffness, rel=1e-12)
    assert tear.loss == pytest.approx((2.0 * PULL) ** 2 / (2.0 * stiffness), rel=1e-12)
    with mp.workdps(30):  # drawn in at D = 0: d + (Hertz(d) - 2 pi w R)/k_m = 0
        hertz = mp.mpf(4) / 3 * MODULUS * mp.sqrt(RADIUS)
        d = mp.findroot(lambda d: d + (hertz * d**1.5 - 2 * PULL) / stiffness, 1e-6)
        force = hertz * d**1.5 - 2 * PULL
        left = 2 * PULL * d - hertz * d**2.5 * 2 / 5 - force**2 / (2 * stiffness)
    assert snap.snap_in
    assert snap.after.depth == pytest.approx(float(d), rel=1e-11)
    assert snap.loss == pytest.approx(float(left), rel=1e-9)
    assert cycle.work[-1] == pytest.approx(float(left) + (2.0 * PULL) ** 2 / (2.0 * stiffness), rel=1e-9)
    grips = AdhesiveCycle(BALL, law, wk.Depth([far, -far])).solve()
    assert grips.dissipation[-1] == 0.0


def disc_before_touch(law, c):
    """Depth at which a constant stress over a disc c holds a ball, and how far its middle is from touching."""
    with mp.workdps(20):
        c = mp.mpf(c)
        # a uniform tension raises the rim by 4 s c/(pi E*), the middle by 2 s c/E*
        rim, middle = 4 * law.strength * c / (mp.pi * MODULUS), 2 * law.strength * c / MODULUS
        depth = c**2 / (2 * RADIUS) - rim - law.range
        return float(depth), float(-depth - middle)


@pytest.mark.few(3)
@pytest.mark.parametrize("strength", [0.2, 1.0, 3.0])
@pytest.mark.parametrize("stiffness", [math.inf, 60.0])
def test_dugdale_keeps_its_energy(strength, stiffness):
    """The area under F(D), by Gauss' rule between the jumps, is what the jumps lose; before touch the disc holds."""
    unit = (math.pi * WORK * (4 / 3 * MODULUS) ** 2 / RADIUS) ** (1 / 3)
    law = Dugdale(WORK, 0.5 * strength * unit)  # Maugis' lambda = strength
    far = 60.0 * LENGTH + 10.0 * PULL / stiffness
    ends = AdhesiveCycle(BALL, law, wk.Depth([far, -far]), stiffness).solve()
    advancing = [jump for jump in ends.jumps if jump.after.force < jump.before.force or jump.before.force == 0.0]
    marks = [jump.before.position for jump in advancing if jump.before.position > -far]
    back = [jump.before.position for jump in ends.jumps if jump not in advancing]
    assert marks[0] == pytest.approx(-law.range, rel=1e-12)
    assert back
    # t^3 (4 - 3 t) leaves both ends of a piece like a cube and a square: roots of the turning curve vanish
    nodes, weights = np.polynomial.legendre.leggauss(120)
    t = 0.5 * (1 + nodes)
    share, rate = t**4 * (35 - 84 * t + 70 * t**2 - 20 * t**3), 140 * t**3 * (1 - t) ** 3
    stops = [*marks, far, *back]
    path = np.concatenate([low + (high - low) * share for low, high in zip(stops[:-1], stops[1:], strict=True)])
    cycle = AdhesiveCycle(BALL, law, wk.Depth(path), stiffness).solve()
    area = sum(
        0.5 * (high - low) * float(np.sum(weights * rate * cycle.force[i * 120 : (i + 1) * 120]))
        for i, (low, high) in enumerate(zip(stops[:-1], stops[1:], strict=True))
    )
    assert area == pytest.approx(ends.dissipation[-1], rel=1e-7)
    assert ends.work[-1] == pytest.approx(ends.dissipation[-1], rel=1e-12)
    assert all(jump.loss > 0.0 for jump in ends.jumps)
    before = [jump.after for jump in ends.jumps if jump.after.radius == 0.0 and jump.after.force < 0.0]
    for state in before:
        c = math.sqrt(-state.force / (math.pi * law.strength))
        depth, middle = disc_before_touch(law, c)
        assert state.depth == pytest.approx(depth, rel=1e-9)
        assert middle > 0.0


def test_dugdale_becomes_jkr_and_touches_without_a_step():
    unit = (math.pi * WORK * (4 / 3 * MODULUS) ** 2 / RADIUS) ** (1 / 3)
    lost = []
    for strength in (5.0, 40.0):
        law = Dugdale(WORK, 0.5 * strength * unit)
        cycle = AdhesiveCycle(BALL, law, wk.Depth([60 * LENGTH, -60 * LENGTH])).solve()
        lost.append(cycle.dissipation[-1] / UNIT - 7.092195972)
    # the ball is drawn in already at d = -w/sigma_0, where JKR's energy is greater by 4/3 pi w R for every metre
    assert lost[1] == pytest.approx(-4 / 3 * math.pi * law.range / LENGTH, rel=0.02)
    assert abs(lost[1]) < 0.2 * abs(lost[0])
    law = Dugdale(WORK, 0.1 * unit)
    edge = AdhesiveCycle(BALL, law, wk.Depth([1e-6]))._edge
    touch = edge.approach.extent()
    depth, middle = disc_before_touch(law, touch)
    assert middle == pytest.approx(0.0, abs=1e-10 * law.range)
    near = edge.closing.curve(np.array([-1e-9, 1e-9]) * touch)
    np.testing.assert_allclose(near, depth, rtol=1e-7)


def test_dugdale_on_other_media_is_refused():
    medium = GradedHalfSpace.between(PowerLawGraded(young=MODULUS, depth_scale=1e-4, exponent=0.3, poisson=0.3))
    with pytest.raises(wk.OutsideValidity, match="before they touch"):
        AdhesiveCycle(wk.Foundation(wk.Paraboloid(RADIUS), medium), Dugdale(WORK, 1e6), wk.Depth([1e-6])).solve()
