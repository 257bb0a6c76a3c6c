"""Histories under a steady depth and their turning points: against springs one by one, and what is kept of them."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import winkler as wk
from winkler.problems.normal.solve_contact import at_depth

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


SHARES, WEIGHTS = np.polynomial.legendre.leggauss(24)
PLACES, WEIGHTS = np.sin(0.5 * np.pi * SHARES), 0.5 * np.pi * WEIGHTS * np.cos(0.5 * np.pi * SHARES)
"""From -1 to 1, roots at both ends mapped away."""


def one_by_one(solution):
    """Clip springs at their bounds, which are steady, and compare; their places are summed up piece by piece."""
    bed, depth, radius = solution.problem.bed, float(solution.depth[0]), float(solution.radius[0])
    cuts = np.unique([gap for state in solution.states for gap in state.memory.edges])
    edges = np.unique([0.0, *at_depth(bed, cuts)[1], *(b for b, _ in bed.kinks if b < radius), radius])
    half, middle = 0.5 * np.diff(edges)[:, None], 0.5 * (edges[1:] + edges[:-1])[:, None]
    x = (middle + half * PLACES).ravel()
    springs = 2.0 * bed.tangential_stiffness(x) * (half * WEIGHTS).ravel()
    bound = MU * STEEL.modulus / STEEL.shear_modulus * (depth - bed.gap(x))
    u, before, lost, work = np.zeros(x.size), 0.0, 0.0, 0.0
    whole = max(float(solution.work[-1]), float(np.max(solution.stored_energy)))
    for at, shift in enumerate(solution.shift.tolist()):
        trial = u + shift - before
        after = np.clip(trial, -bound, bound)
        loss = float(springs @ (bound * np.abs(trial - after)))
        work += 0.5 * float(springs @ (after**2 - u**2)) + loss
        lost, u, before = lost + loss, after, shift
        assert solution.shear_force[at] == pytest.approx(float(springs @ u), abs=1e-10 * MU * FORCE)
        energies = solution.dissipation[at], solution.work[at], solution.stored_energy[at]
        assert energies == pytest.approx((lost, work, 0.5 * float(springs @ u**2)), abs=1e-10 * whole)


@pytest.mark.parametrize("load", [wk.Shift, wk.ShearForce])
@pytest.mark.parametrize("swing", swings(1))
def test_a_history_is_that_of_springs_one_by_one(swing, load):
    one_by_one(problem(BALL, load, swings(120)[swing]).solve())


@pytest.mark.slow
@pytest.mark.parametrize("load", [wk.Shift, wk.ShearForce])
@pytest.mark.parametrize("bed", [name for name in BEDS if name != "ball"])
def test_a_history_is_that_of_springs_one_by_one_on_all_profiles(bed, load):
    for swing in swings(60).values():
        one_by_one(problem(BEDS[bed], load, swing).solve())


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
    assert len(memories[-1].pieces) > 250
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
