"""Sliding wear: volumes, the flat punch, worn balls, and profiles that end."""

import math

import numpy as np
import pytest

import winkler as wk
from winkler.problems.wear.grids import wear_grid
from winkler.problems.wear.march import march_wear
from winkler.problems.wear.worn_grid import WornGrid

MEDIUM = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
BALL = wk.Foundation(wk.Paraboloid(1e-3), MEDIUM)
RATE = 1e-14


class Squared:
    """Wears with the square of the pressure; as much as Archard at a gigapascal."""

    def depth_per_slip(self, pressure):
        return RATE * pressure**2 / 1e9


def worn(distance, *, bed=BALL, normal=None, wear=None, count=100, tolerance=1e-3):
    wear = wear or wk.Archard(RATE)
    return wk.SlidingWear(bed, wear, normal or wk.Force(1.0), distance, count=count, tolerance=tolerance).solve()


def test_the_volume_is_rate_times_force_times_distance():
    # what was worn, integrated straight in r: not the rule by which the march conserves
    misses = []
    for count in (100, 200, 400):
        last = worn(np.array([0.0, 2e-3]), count=count).states[-1]
        volume = np.trapezoid(2.0 * np.pi * last.radii * last.worn, last.radii)
        misses.append(abs(volume / (RATE * 1.0 * 2e-3) - 1.0))
    assert misses[-1] < 1e-4
    assert np.all(np.log2(np.array(misses[:-1]) / misses[1:]) > 1.5)


@pytest.mark.slow
def test_a_wider_grid_loses_nothing():
    run = worn(np.array([1e-3, 1e-2, 0.1]))
    assert run.states[-1].radii[-1] > 1.4 * run.states[0].radii[-1]
    np.testing.assert_allclose(run.worn_volume, RATE * run.distance, rtol=1e-9)
    np.testing.assert_allclose(run.force, 1.0, rtol=1e-9)


@pytest.mark.slow
def test_a_ball_wears_to_a_cap():
    run = worn(np.array([0.0, 1.0]), count=50)
    cap = (4.0 * 1e-3 * RATE * 1.0 / math.pi) ** 0.25
    assert run.radius[-1] == pytest.approx(cap, rel=0.02)
    last = run.states[-1]
    inside = last.radii < 0.8 * last.radius
    # flat but for what is elastic: pressure is that of all the cap
    np.testing.assert_allclose(last.pressure[inside], run.mean_pressure[-1], rtol=0.05)


def test_the_pressure_beside_the_edge_is_stated():
    before, after = worn(np.array([0.0, 1e-30]), count=20), worn(np.array([0.0, 1e-3]), count=20)
    last = after.states[-1]
    share = f"{np.max(last.pressure) * math.pi * last.radius**2 / last.force:.3g} of the mean. A node at the edge"
    assert any(share in note.statement for note in after.validity)
    assert not any("of the mean" in note.statement for note in before.validity)


@pytest.mark.slow
def test_a_ball_wears_over_any_distance(monkeypatch):
    # a hundred kilometres, over which the contact grows to forty times its radius: V = kappa F s is a cap of the ball
    looks = 0
    press = WornGrid.press

    def counted(grid, worn, load):
        nonlocal looks
        looks += 1
        return press(grid, worn, load)

    monkeypatch.setattr(WornGrid, "press", counted)
    curvature, force, distance = 1e-2, 10.0, np.array([1e2, 1e3, 1e4, 1e5])
    bed = wk.Foundation(wk.Paraboloid(curvature), MEDIUM)
    run = worn(distance, bed=bed, normal=wk.Force(force))
    volume = RATE * force * distance
    np.testing.assert_allclose(run.worn_volume, volume, rtol=1e-9)
    for state, lost in zip(run.states, volume, strict=True):
        assert state.radius == pytest.approx((4.0 * curvature * lost / math.pi) ** 0.25, abs=1.5 * state.radii[1])
    np.testing.assert_allclose(run.worn_depth[1:], np.sqrt(volume[1:] / (math.pi * curvature)), rtol=2e-3)
    # explicit jumps need more than a million
    assert looks < 10_000


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("wear", [wk.Archard(RATE), Squared()], ids=["Archard", "own"])
def test_implicit_jumps_go_where_explicit_ones_go(wear):
    problem = wk.SlidingWear(BALL, wear, wk.Force(1.0), np.array([0.3, 1.0, 3.0]), count=50)
    begun = next(wk.SlidingWear(BALL, wear, wk.Force(1.0), 1e-4, count=50).steps()).moment
    short = list(march_wear(problem, problem.goals, begun))
    for moment, state in zip(short, problem.steps(), strict=True):
        same = wear_grid(BALL, moment.nodes).press(moment.worn.sum(axis=0), wk.Force(1.0))
        assert state.depth == pytest.approx(same.depth, rel=1e-3)
        np.testing.assert_allclose(state.first_worn, moment.worn[0], atol=5e-3 * same.depth)


def test_a_flat_punch_wears_until_its_pressure_is_even():
    radius = 1e-3
    bed = wk.Foundation(wk.FlatPunch(radius), MEDIUM)
    run = worn(np.array([0.0, 1.0, 10.0]), bed=bed, normal=wk.Force(100.0), count=60)
    even = 100.0 / (math.pi * radius**2)
    first, _, last = run.states
    assert first.pressure[0] == pytest.approx(0.5 * even, rel=1e-3)
    np.testing.assert_allclose(last.pressure, even, rtol=1e-3)
    bulge = 4.0 * even * radius / (math.pi * MEDIUM.modulus) * (0.5 * math.pi - 1.0)
    assert last.worn[-1] - last.worn[0] == pytest.approx(bulge, rel=2e-3)
    np.testing.assert_allclose(run.worn_volume, RATE * 100.0 * run.distance, rtol=1e-9)


def test_at_a_steady_depth_a_ball_wears_until_nothing_presses():
    depth = 1e-6
    run = worn(np.array([0.0, 10.0]), normal=wk.Depth(depth), count=50)
    assert run.force[-1] < 1e-3 * run.force[0]
    step = run.states[-1].radii[1]
    assert run.radius[-1] == pytest.approx(math.sqrt(2.0 * 1e-3 * depth), abs=step)
    # the cap above the depth is gone
    assert run.worn_volume[-1] == pytest.approx(math.pi * 1e-3 * depth**2, rel=0.01)


@pytest.mark.slow
def test_a_stopped_march_goes_on_with_the_same_numbers_across_a_wider_grid():
    problem = wk.SlidingWear(BALL, wk.Archard(RATE), wk.Force(1.0), np.array([1e-3, 1e-2, 0.1, 0.2]), count=60)
    whole = list(problem.steps())
    assert list(problem.steps(start=whole[1])) == whole[2:]


def test_where_the_profile_ends_the_states_before_remain():
    radii = np.linspace(0.0, 3e-5, 60)
    bed = wk.Foundation(wk.Measured(radii, radii**2 / 2e-3), MEDIUM)
    problem = wk.SlidingWear(bed, wk.Archard(RATE), wk.Force(1.0), np.geomspace(1e-4, 1.0, 30), count=40)
    remaining = []

    def advance():
        for state in problem.steps():
            remaining.append(state)

    with pytest.raises(wk.OutsideValidity, match="as far as the profile is known"):
        advance()
    assert len(remaining) > 10
    assert remaining[-1].radius < 3e-5


def test_a_worn_profile_can_be_pressed_again():
    state = worn(np.array([0.0, 2e-3]), count=100).states[-1]
    again = wk.Indentation(wk.Foundation(wk.Measured(state.radii, state.height), MEDIUM), wk.Force(1.0)).solve()
    # the edge, where the worn part ends with a corner, lies within a cell
    assert again.radius == pytest.approx(state.radius, abs=0.5 * (state.radii[1] - state.radii[0]))
    # depth counts from the worn apex
    assert again.depth == pytest.approx(state.depth - state.worn[0], rel=1e-4)


@pytest.mark.parametrize("wear", [wk.PairWear(wk.Archard(1.0), wk.Archard(1.0)), 3.0])
def test_only_one_body_wears(wear):
    with pytest.raises(wk.InvalidInput, match="SlidingWear: the wear is a"):
        worn(1.0, wear=wear)


@pytest.mark.parametrize("rate", [0.0, -1.0, math.inf, math.nan, True, "much"])
def test_rates_that_wear_nothing_are_refused(rate):
    with pytest.raises(wk.InvalidInput, match="Archard: rate is"):
        wk.Archard(rate)
