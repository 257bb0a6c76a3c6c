"""Histories under a steady depth by their turning points: against the march, against springs one by one."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import winkler as wk
from winkler.problems.friction.tangential_march import SlipRow
from winkler.problems.row import follow

MU, FORCE = 0.3, 1000.0
STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
BALL = wk.Foundation(wk.Paraboloid(10e-3), STEEL)
BEDS = {
    "ball": BALL,
    "truncated cone": wk.Foundation(wk.TruncatedCone(1.5, 1e-4), STEEL),
    "truncated ball": wk.Foundation(wk.TruncatedParaboloid(10e-3, 1e-4), STEEL),
    "capped ball": wk.Foundation(wk.CappedParaboloid(10e-3, 20e-3, 1e-4), STEEL),
    "pinned at a rim": wk.Foundation(wk.CappedCylinder(1.5e-4, wk.Paraboloid(10e-3)), STEEL),
}


def swings(count):
    """Return shares of the amplitude: loops that shrink, grow, end where they began, and random turns."""
    turn = np.arange(count)
    sign, random = (-1.0) ** turn, np.random.default_rng(11).uniform(-1.0, 1.0, count)
    small = np.tile([0.5, 0.2, 0.5, 0.499, 0.5, 0.5, -0.1, 0.5 + 1e-9], -(-count // 8))[:count]
    stairs = np.cumsum(np.where(turn % 3 == 2, -0.5, 1.0))
    return {
        "shrinking": sign * (1.0 - turn / count),
        "growing": sign * (turn + 1.0) / count,
        "random": random,
        "closing": small,
        "stairs": stairs / stairs.max(),
        "sliding": np.sign(random),
    }


def problem(bed, load, swing):
    most = MU * FORCE
    if load is wk.Shift:
        contact = wk.Indentation(bed, wk.Force(FORCE)).solve()
        most = 1.1 * MU * float(contact.depth) * STEEL.modulus / STEEL.shear_modulus
    return wk.Tangential(bed, wk.Coulomb(MU), wk.Path(np.arange(swing.size) * 1.0, wk.Force(FORCE), load(most * swing)))


def marched(solution):
    """Return shift, shear force, work, stored energy and loss of the march, step by step, and what is remembered."""
    here = solution.problem
    row = SlipRow(here.bed, MU, solution.states[0].mindlin_ratio, here.path, here.normal)
    reached = list(follow(row, row.goals))
    memories = [row.memory(each.state) for each in reached]
    numbers = [
        (each.state.shift, row.shear_force(memory), each.work, row.stored(memory), each.lost)
        for each, memory in zip(reached, memories, strict=True)
    ]
    return np.array(numbers).T, memories


def compared(solution):
    """Compare a solution with the march: to 1e-12 of the greatest."""
    (shift, force, work, stored, lost), memories = marched(solution)
    got = solution.shift, solution.shear_force, solution.work, solution.stored_energy, solution.dissipation
    scales = np.max(np.abs(shift)), MU * FORCE, np.max(work), np.max(work), np.max(work)
    for ours, theirs, scale in zip(got, (shift, force, work, stored, lost), scales, strict=True):
        np.testing.assert_allclose(ours, theirs, rtol=0.0, atol=1e-12 * scale)
    for state, memory in zip(solution.states, memories, strict=True):
        gap = memory.depth * np.linspace(0.01, 0.99, 12)
        np.testing.assert_allclose(state.memory.value(gap), memory.value(gap), rtol=0.0, atol=1e-11 * scales[0])


@pytest.mark.parametrize("load", [wk.Shift, wk.ShearForce])
@pytest.mark.parametrize("swing", swings(1))
def test_turning_points_are_the_march(swing, load):
    compared(problem(BALL, load, swings(120)[swing]).solve())


@pytest.mark.slow
@pytest.mark.parametrize("load", [wk.Shift, wk.ShearForce])
@pytest.mark.parametrize("bed", [name for name in BEDS if name != "ball"])
def test_turning_points_are_the_march_on_all_profiles(bed, load):
    for swing in swings(60).values():
        compared(problem(BEDS[bed], load, swing).solve())


@pytest.mark.parametrize("swing", ["shrinking", "growing", "random"])
def test_energies_are_those_of_springs_one_by_one(swing):
    """At a steady depth a spring is clipped at its bound; the places of a ball are summed up piece by piece."""
    solution = problem(BALL, wk.Shift, 0.8 * swings(40)[swing]).solve()
    depth, radius = float(solution.depth[0]), float(solution.radius[0])
    shares, weights = np.polynomial.legendre.leggauss(12)
    cuts = np.unique([gap for state in solution.states for gap in state.memory.edges])
    edges = np.sqrt(cuts / depth) * radius  # g = x^2/R
    half, middle = 0.5 * np.diff(edges)[:, None], 0.5 * (edges[1:] + edges[:-1])[:, None]
    x = (middle + half * shares).ravel()
    stiffness = 2.0 * STEEL.shear_modulus * (half * weights).ravel()
    bound = MU * STEEL.modulus / STEEL.shear_modulus * depth * (1.0 - (x / radius) ** 2)
    u, before, lost, work = np.zeros(x.size), 0.0, 0.0, 0.0
    for at, shift in enumerate(solution.shift.tolist()):
        trial = u + shift - before
        after = np.clip(trial, -bound, bound)
        loss = float(stiffness @ (bound * np.abs(trial - after)))
        work += 0.5 * float(stiffness @ (after**2 - u**2)) + loss
        lost, u, before = lost + loss, after, shift
        found = solution.shear_force[at] / (MU * FORCE), solution.dissipation[at] / lost, solution.work[at] / work
        assert found == pytest.approx((float(stiffness @ u) / (MU * FORCE), 1.0, 1.0), abs=1e-10)
        stored = 0.5 * float(stiffness @ u**2)
        assert solution.stored_energy[at] == pytest.approx(stored, abs=1e-12 * work)


@pytest.mark.parametrize("swing", ["shrinking", "growing", "random"])
def test_what_is_kept_grows_with_the_turning_points(swing):
    kept = []
    for count in (200, 400):
        memories = [state.memory for state in problem(BALL, wk.Shift, swings(count)[swing]).solve().states]
        shared = {id(memory.pieces): memory.pieces for memory in memories}
        assert len(shared) <= 1 + count // 200  # it goes on by itself where most pieces have been replaced
        kept.append(sum(pieces.columns.used[0] for pieces in shared.values()))
    assert kept[1] <= min(2.2 * kept[0], 2 * 400 + 1 + 20)


@pytest.mark.slow
def test_points_of_a_loop_on_a_coating_share_their_turns():
    layer = wk.Layer(wk.Elastic(400e9, 0.3), thickness=2e-6)
    bed = wk.Foundation(wk.Paraboloid(1e-3), wk.CoatedHalfSpace([layer], on=wk.Elastic(40e9, 0.3)))
    swing = 4e-9 * swings(300)["shrinking"]
    path = wk.Path(np.arange(swing.size) * 1.0, wk.Force(0.05), wk.Shift(swing))
    states = wk.Tangential(bed, wk.Coulomb(MU), path).solve().states
    memories = [state.springs.memory for state in states]
    assert len({id(memory.history) for memory in memories}) == 1
    assert memories[-1].record.sides.size > 250
    assert len(pickle.dumps(memories)) < 2 * len(pickle.dumps(memories[:1]))
    again = pickle.loads(pickle.dumps(memories[-1]))
    assert again == memories[-1]
    assert hash(again) == hash(memories[-1])
    assert again != memories[-2]


def test_what_friction_does_not_bear_is_refused_at_its_point():
    swing = np.array([0.2, -0.5, 1.0, 1.0 + 1e-13, 1.001, *[0.1] * 20])
    steps, states = problem(BALL, wk.ShearForce, swing).steps(), []
    with pytest.raises(wk.OutsideValidity, match=r"at index 4 of the path a shear force of 300\.3 N"):  # noqa: PT012
        for state in steps:
            states.append(state)
    assert [state.sliding for state in states] == [False, False, True, True]
    with pytest.raises(wk.OutsideValidity, match="at index 0 of the path"):
        problem(BALL, wk.ShearForce, np.array([1.1] * 20)).solve()
