"""The one loop of all rows, under rows that are written here against the protocol alone."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

import winkler as wk
from winkler.problems.row import MOST_HALVINGS, MOST_STEPS, Reached, Row, follow, over

MEDIUM = wk.HalfSpace(wk.Elastic(2.0, 0.3))
BED = wk.Foundation(wk.Paraboloid(1.0), MEDIUM)
MU = 0.4
RATIO = MEDIUM.shear_modulus / MEDIUM.modulus
FULL = MU / RATIO
"""Shift at which a ball of unit radius pressed by unit depth slides."""


class Pushed(NamedTuple):
    force: float
    shift: float


class Single(NamedTuple):
    depth: float
    shift: float
    u: np.ndarray


class GhostRow(Row):
    """Springs under a ball at fixed places, under a normal force and a shift: F = 4/3 E* d^(3/2), g = x^2."""

    owner, order = "Ghost", 2

    def __init__(self, count: int) -> None:
        x = (np.arange(count) + 0.5) / count * 1.2
        self.gap, self.weight = x * x, 2.0 * MEDIUM.shear_modulus * 1.2 / count

    def depth(self, force):
        return (0.75 * force / MEDIUM.modulus) ** (2.0 / 3.0)

    def begin(self, goal):
        down = Single(self.depth(goal.force), 0.0, np.zeros(self.gap.size))
        return self.step(down, goal)

    def step(self, state, goal):
        depth, moved = self.depth(goal.force), goal.shift - state.shift
        first, last = (np.maximum(d - self.gap, 0.0) * FULL for d in (state.depth, depth))
        change = depth - state.depth
        share = np.where((first > 0.0) & (last > 0.0), 1.0, 0.0)
        once = (first > 0.0) ^ (last > 0.0)
        share[once] = (max(depth, state.depth) - self.gap[once]) / abs(change) if change else 0.0
        trial = state.u + share * moved
        after = np.clip(trial, -last, last)
        slid = np.abs(trial - after)
        side = np.sign(trial - after)
        margin = np.maximum(first - side * state.u, 0.0)
        onset = np.divide(margin, margin + slid, out=np.ones_like(slid), where=slid > 0.0)
        at_onset = first + (last - first) * onset
        lost = self.weight * float(np.sum(0.5 * (at_onset + last) * slid))
        stored = 0.5 * self.weight * float(after @ after - state.u @ state.u)
        return Reached(Single(depth, goal.shift, after), stored + lost, lost)

    def halfway(self, state, start, goal):
        depth = 0.5 * (self.depth(start.force) + self.depth(goal.force))
        force = 4.0 / 3.0 * MEDIUM.modulus * depth**1.5
        if start.force == goal.force or start.shift == goal.shift:
            return None
        part = (force - start.force) / (goal.force - start.force)
        return Pushed(force, start.shift + part * (goal.shift - start.shift))

    def apart(self, one, two):
        moved = float(np.max(np.abs(one.state.u - two.state.u)))
        return max(over(moved, 1e-4 * FULL), over(abs(one.lost - two.lost), 1e-4 * MEDIUM.shear_modulus * FULL**2))


FORCE = 4.0 / 3.0 * MEDIUM.modulus * np.array([0.5, 1.0, 0.6, 1.2, 0.0, 0.9])
SHIFT = FULL * np.array([0.0, 0.3, -0.4, 0.2, 0.5, 0.1])


def ghost(count):
    row = GhostRow(count)
    return row, list(follow(row, [Pushed(*goal) for goal in zip(FORCE.tolist(), SHIFT.tolist(), strict=True)]))


def test_a_ghost_row_agrees_with_springs_by_gap_at_its_order():
    exact = wk.Tangential(BED, wk.Coulomb(MU), wk.Path(np.arange(6.0), wk.Force(FORCE), wk.Shift(SHIFT))).solve()
    missed = []
    for count in (20, 60):
        row, steps = ghost(count)
        sheared = np.array([row.weight * float(np.sum(step.state.u)) for step in steps])
        lost = np.array([step.lost for step in steps])
        missed.append((np.max(np.abs(sheared - exact.shear_force)), np.max(np.abs(lost - exact.dissipation))))
        balance = [0.5 * row.weight * step.state.u @ step.state.u + step.lost - step.work for step in steps]
        # extrapolated work and loss miss what is stored at the end of the halves by what these miss
        np.testing.assert_allclose(balance, 0.0, atol=1e-4 * steps[-1].work)
    (force, lost), (finer, less) = missed
    assert finer < 2e-4 * MU * FORCE[3]
    assert less < 5e-4 * exact.dissipation[-1]
    assert force > 3.0 * finer
    assert lost > 3.0 * less


def test_a_path_is_carried_on_where_it_was_left():
    row = GhostRow(20)
    goals = [Pushed(*goal) for goal in zip(FORCE.tolist(), SHIFT.tolist(), strict=True)]
    whole = list(follow(row, goals))
    rest = list(follow(row, goals[3:], (2, goals[2], whole[2])))
    for one, two in zip(whole[3:], rest, strict=True):
        assert (one.work, one.lost) == (two.work, two.lost)
        np.testing.assert_array_equal(one.state.u, two.state.u)


class CurvedRow(Row):
    """One number that follows its goal, and loses the integral of a power of it, each step by the trapezoidal rule."""

    owner = "Curve"

    def __init__(self, order=2, allowed=1e-6, rough=0.0, whole=False):
        self.order, self.allowed, self.rough, self.whole = order, allowed, rough, whole
        self.taken = self.looked = 0

    def begin(self, goal):
        return Reached(goal, 0.0, 0.0)

    def step(self, state, goal):
        self.taken += 1
        if goal > 10.0:
            raise wk.OutsideValidity("ten is borne at most; give less.")
        lost = 0.5 * (state**3 + goal**3) * abs(goal - state) + self.rough * abs(goal - state) ** 0.5
        return Reached(goal, 2.0 * lost, lost)

    def halfway(self, state, start, goal):
        self.looked += 1
        return None if self.whole or start == goal else 0.5 * (start + goal)

    def apart(self, one, two):
        return over(abs(one.lost - two.lost), self.allowed)


def test_halves_are_extrapolated_by_their_order():
    *_, last = follow(CurvedRow(), [0.0, 1.0, 1.0, 0.5])
    assert last.lost == pytest.approx(0.25 + (1.0 - 0.5**4) / 4.0, abs=1e-12)  # Simpson's rule of a cubic is exact
    assert last.work == pytest.approx(2.0 * last.lost, rel=1e-15)


def test_points_of_the_path_are_the_steps_of_a_row_without_middles():
    row = CurvedRow(whole=True)
    *_, last = follow(row, [0.0, 1.0, 2.0])
    assert (row.taken, last.lost) == (2, 0.5 + 4.5)


def test_halves_of_a_row_without_order_are_taken_as_they_are():
    row = CurvedRow(order=None)
    *_, last = follow(row, [0.0, 1.0, 2.0])
    assert row.taken > 100
    assert last.lost == pytest.approx(
        4.0, abs=2e-6 * row.taken / 3
    )  # too much, as the trapezoidal rule of a convex loss
    assert last.lost > 4.0


def test_no_half_is_walked_twice():
    """Nor is a step tried that must be too long after those before it."""
    row = CurvedRow(allowed=1e-4)
    _ = list(follow(row, [0.0, 1.0]))
    halved = row.looked // 2  # each of them is looked at again in two parts
    assert halved > 5
    assert row.taken < 3 * row.looked - halved


def test_a_step_that_no_row_can_take_is_refused_with_what_came_before_it():
    reached = []
    with pytest.raises(wk.OutsideValidity, match="^Curve: at index 2 of the path ten is borne at most"):
        reached.extend(follow(CurvedRow(), [0.0, 1.0, 11.0, 0.0]))
    assert [step.state for step in reached] == [0.0, 1.0]


def test_a_step_that_never_settles_is_refused():
    row, reached = CurvedRow(allowed=1e-9, rough=1.0), []
    with pytest.raises(wk.NotConverged, match="^Curve: at index 1 of the path the step does not converge"):
        reached.extend(follow(row, [0.0, 1.0]))
    assert len(reached) == 1
    assert row.taken <= 3 * MOST_HALVINGS + 3


def test_a_path_that_settles_in_too_many_steps_alone_is_refused():
    """Halves whose error falls as slowly as their length would be walked for ever."""
    row, reached = CurvedRow(allowed=1e-9), []
    row.apart = lambda one, two: over(abs(one.lost - two.lost) ** 0.5, row.allowed)
    with pytest.raises(wk.NotConverged, match="^Curve: at index 1 of the path the step does not converge"):
        reached.extend(follow(row, [0.0, 1.0]))
    assert len(reached) == 1
    assert MOST_STEPS < row.taken < 4 * MOST_STEPS
