"""Springs with memory: closed forms of one direction, the plane, and what must hold on every path."""

from __future__ import annotations

import dataclasses
import pickle

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import winkler as wk
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.loading.path import Path
from winkler.problems.friction.spring_run import SingleSprings
from winkler.problems.friction.spring_states import spring_notes
from winkler.values.validity import Assumption, Standing
from winkler.values.value import value

MEDIUM = wk.HalfSpace(wk.Elastic(2.0, 0.3))
E, G = MEDIUM.modulus, MEDIUM.shear_modulus
BALL = wk.Foundation(wk.Paraboloid(1.0), MEDIUM)
MU = 0.4
FULL = MU * E / G
"""Shift at which a ball of unit radius pressed by unit depth slides."""
FORCE = 4.0 / 3.0 * E


def still(shift, **other):
    """Return a path along the surface at unit depth."""
    shift = np.asarray(shift, dtype=float)
    return Path(np.arange(float(len(shift))), wk.Depth(1.0), wk.Shift(shift), **other)


def test_theory_numbers_of_unloading():
    """E* = 2, G* = 1.5, mu = 0.4, R = 3, a = 1.2, c = 0.7: depths of 0.9, 0.7, 0.5, 0.3 of the first one."""
    poisson = 0.4  # G*/E* = 2 (1 - nu) / (2 - nu) = 3/4
    bed = wk.Foundation(wk.Paraboloid(3.0), wk.HalfSpace(wk.Elastic(2.0 * (1.0 - poisson**2), poisson)))
    assert bed.medium.modulus == pytest.approx(2.0, rel=1e-15)
    assert bed.medium.shear_modulus == pytest.approx(1.5, rel=1e-15)
    shift = 0.4 * (2.0 / 1.5) * (1.2**2 - 0.7**2) / 3.0
    depth = 1.2**2 / 3.0 * np.array([1.0, 1.0, 0.9, 0.7, 0.5, 0.3])
    path = Path(np.arange(6.0), wk.Depth(depth), wk.Shift(shift * np.array([0.0, 1.0, 1.0, 1.0, 1.0, 1.0])))
    trace = wk.Tangential(bed, Coulomb(0.4), path, wk.Method.SPRINGS, 2000).solve()
    expected = [0.492444444444, 0.4522200744, 0.3548642550, 0.2172232032, 0.1009562218]
    np.testing.assert_allclose(trace.shear_force[1:], expected, rtol=1e-6)


def traction(state, r):
    """Return the traction (m, 2) over the coefficient times the pressure.

    The displacement is straight in g between the springs: a sum of pressures of contacts that reach to each of them.
    """
    gap = state.springs.gap
    chords = np.diff(state.displacement, axis=0) / np.diff(gap)[:, np.newaxis]
    factors = np.diff(np.concatenate([chords, np.zeros((1, 2))]), axis=0)
    pressures = 2.0 * E / np.pi * np.sqrt(np.maximum(gap[1:] - r[:, np.newaxis] ** 2, 0.0))
    whole = 2.0 * E / np.pi * np.sqrt(1.0 - r**2)
    return G / E * (pressures @ factors) / (MU * whole)[:, np.newaxis]


@pytest.mark.parametrize("parts", [1, 7])
def test_two_strokes_at_a_right_angle(parts):
    """What the vector rule costs: the traction exceeds what friction bears by 5 %, at r = 0.71 a."""
    leg = np.linspace(0.0, 0.5 * FULL, parts + 1)
    track = np.concatenate([np.column_stack([leg, 0.0 * leg]), np.column_stack([0.0 * leg + leg[-1], leg])[1:]])
    state = list(wk.Tangential(BALL, Coulomb(MU), still(track), wk.Method.SPRINGS, 400).steps())[-1]
    r = np.linspace(0.0, 0.98, 99)
    excess = np.hypot(*traction(state, r).T)
    assert excess.max() == pytest.approx(1.050, abs=1e-3)
    assert r[excess.argmax()] == pytest.approx(0.71, abs=0.011)
    # every spring keeps to its own bound all the same
    assert np.all(np.hypot(*state.displacement.T) <= FULL * (1.0 - state.springs.gap) * (1.0 + 1e-12))


@pytest.mark.slow
def test_a_circular_motion_is_inadmissible_at_the_edge_of_its_stick_zone():
    """Steady circle of half the shift of sliding: 1.35 at r = 0.70 a, and ever more towards c = a / sqrt(2)."""
    angle = 2.0 * np.pi * np.arange(8 * 240 + 1) / 240
    track = 0.5 * FULL * np.column_stack([np.cos(angle), np.sin(angle)])
    state = list(wk.Tangential(BALL, Coulomb(MU), still(track), wk.Method.SPRINGS, 800).steps())[-1]
    assert state.stick_radius == pytest.approx(np.sqrt(0.5), abs=1e-3)
    excess = np.hypot(*traction(state, np.array([0.6, 0.70, 0.705, 0.707])).T)
    assert excess[1] == pytest.approx(1.35, abs=5e-3)
    assert excess[0] < 1.0
    assert excess[1] < excess[2] < excess[3]
    # steady, a spring of bound b is displaced ahead of U by an angle with the cosine b / U_0; that is almost reached
    part = np.clip((1.0 - state.springs.gap) / 0.5, 0.0, 1.0)
    steady = 0.5 * FULL * np.column_stack([part * part, part * np.sqrt(1.0 - part * part)])
    force = G / E * state.springs.stiffness @ steady
    np.testing.assert_allclose(state.shear_force, force, rtol=3e-3)
    excess = np.hypot(*traction(dataclasses.replace(state, displacement=steady), np.array([0.70])).T)
    assert excess[0] == pytest.approx(1.350, abs=1e-3)


def test_fields_are_restored_from_the_same_sum():
    leg = [[0.0, 0.0], [0.3, 0.0], [0.3, 0.2]]
    state = list(wk.Tangential(BALL, Coulomb(MU), still(FULL * np.array(leg)), wk.Method.SPRINGS, 60).steps())[-1]
    sheared = state.sheared
    r = np.array([0.0, 0.31, 0.77])
    tau = np.column_stack([sum(G / E * MEDIUM.pressure(u, r) for u in parts) for parts in sheared.components])
    np.testing.assert_allclose(tau / (MU * 2.0 * E / np.pi * np.sqrt(1.0 - r**2))[:, np.newaxis], traction(state, r))


def test_a_prescribed_force_in_the_plane():
    turn = 0.7 * MU * FORCE * np.column_stack([np.cos(np.arange(40) * 0.3), np.sin(np.arange(40) * 0.3)])
    path = Path(np.arange(40.0), wk.Depth(np.linspace(1.0, 1.3, 40)), wk.ShearForce(turn))
    pulled = SingleSprings("Tangential", BALL, Coulomb(MU), path, 100)
    moved = SingleSprings("Tangential", BALL, Coulomb(MU), dataclasses.replace(path, lateral=wk.Shift(turn)), 100)
    here = pulled.begin(pulled.goals[0])
    for goal in pulled.goals[1:]:
        there = pulled.step(here.state, goal)
        np.testing.assert_allclose(there.state.force, goal.along, atol=1e-11 * FORCE)
        again = moved.step(here.state, goal._replace(along=there.state.shift))
        np.testing.assert_allclose(again.state.force, goal.along, atol=1e-11 * FORCE)
        np.testing.assert_allclose([again.lost, again.work], [there.lost, there.work], rtol=1e-10)
        here = there


@pytest.mark.parametrize("plane", [False, True])
def test_too_large_a_force_is_refused_where_it_is_prescribed(plane):
    prescribed = MU * FORCE * np.array([0.5, 0.9, 1.1, 0.2])
    load = wk.ShearForce(np.column_stack([prescribed, 0.0 * prescribed]) if plane else prescribed)
    problem = wk.Tangential(BALL, Coulomb(MU), Path(np.arange(4.0), wk.Depth(1.0), load), wk.Method.SPRINGS, 100)
    reached = []
    with pytest.raises(
        wk.OutsideValidity, match=r"at index 2 of the path .* the friction limit is .* give a smaller one"
    ):
        reached.extend(problem.steps())
    assert len(reached) == 2
    with pytest.raises(wk.OutsideValidity, match="at index 2"):
        problem.solve()


LATERAL_PATHS = {
    "line": wk.Shift(FULL * np.sin(np.arange(600) * 0.1)),
    "plane": wk.Shift(FULL * np.column_stack([np.sin(np.arange(600) * 0.1), 0.4 * np.cos(np.arange(600) * 0.23)])),
    "force": wk.ShearForce(0.3 * MU * FORCE * np.sin(np.arange(600) * 0.1)),
}


@pytest.mark.few(1)
@pytest.mark.parametrize("name", LATERAL_PATHS)
def test_solve_is_steps_to_the_last_bit(name):
    path = Path(np.arange(600.0), wk.Depth(1.0 + 0.3 * np.sin(np.arange(600) * 0.03)), LATERAL_PATHS[name])
    problem = wk.Tangential(BALL, Coulomb(MU), path, wk.Method.SPRINGS, 60)
    trace, states = problem.solve(), list(problem.steps())
    for word in (
        "time", "depth", "force", "radius", "shift", "shear_force", "stick_radius",
        "work", "stored_energy", "dissipation",
    ):  # fmt: skip
        np.testing.assert_array_equal(getattr(trace, word), [getattr(state, word) for state in states])
    # the last state is the end of the last block, the others are restored
    np.testing.assert_array_equal(trace.states[-1].displacement, states[-1].displacement)
    assert trace.at(-1) == states[-1]
    assert trace.at(300) == states[300]
    assert trace == problem.gathered(states)
    assert pickle.loads(pickle.dumps(trace)) == trace


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 10**6), st.floats(0.1, 2.0))
def test_no_energy_is_created(seed, size):
    """Over random paths in the plane with changing depth the springs lose, and pay for what they store."""
    rng = np.random.default_rng(seed)
    coarse = np.arange(9.0)
    points = rng.normal(scale=size * FULL, size=(9, 2)).cumsum(0)
    depth = rng.uniform(-0.2, 1.0, 9)
    depth[0] = 1.0
    fine = np.linspace(0.0, 8.0, 801)
    points_between = np.column_stack([np.interp(fine, coarse, part) for part in points.T])
    path = Path(fine, wk.Depth(np.interp(fine, coarse, depth)), wk.Shift(points_between - points_between[0]))
    trace = wk.Tangential(BALL, Coulomb(MU), path, wk.Method.SPRINGS, 40).solve()
    assert np.all(np.diff(trace.dissipation) >= 0.0)
    assert np.all(np.hypot(*trace.shear_force.T) <= MU * trace.force * (1.0 + 1e-12))
    mean = 0.5 * (trace.shear_force[1:] + trace.shear_force[:-1])
    work = np.concatenate([[0.0], np.cumsum(np.sum(mean * np.diff(trace.shift, axis=0), axis=1))])
    missing = trace.stored_energy + trace.dissipation - work
    assert np.max(np.abs(missing)) < 2e-3 * max(trace.dissipation[-1], MU * FORCE * FULL * size)


def test_without_slip():
    """mu infinite: F_x = G*/E* times the integral of k over the path; what leaves contact is lost."""
    path = Path(np.arange(3.0), wk.Depth([0.0, 1.0, 0.0]), wk.Shift([0.0, 0.2, 0.2]))
    trace = wk.Tangential(BALL, Coulomb(np.inf), path, wk.Method.SPRINGS, 800).solve()
    # U in proportion to d: springs that came later share less, F_x = (G*/E*) (U/d) F
    assert trace.shear_force[1] == pytest.approx(G / E * 0.2 * FORCE, rel=1e-6)
    assert trace.shear_force[2] == 0.0
    assert trace.dissipation[2] == pytest.approx(trace.stored_energy[1], rel=1e-12)


def test_without_friction_nothing_is_dragged():
    trace = wk.Tangential(
        BALL, Coulomb(0.0), still([[0.0, 0.0], [0.3, 0.1], [0.0, 0.2]]), wk.Method.SPRINGS, 20
    ).solve()
    np.testing.assert_array_equal(trace.shear_force, 0.0)
    np.testing.assert_array_equal(trace.dissipation, 0.0)


def test_bodies_that_never_meet():
    path = Path(np.arange(2.0), wk.Depth([-1.0, -0.5]), wk.Shift([0.0, 1.0]))
    state = list(wk.Tangential(BALL, Coulomb(MU), path, wk.Method.SPRINGS).steps())[-1]
    assert (state.force, state.shear_force, state.radius, state.stick_radius) == (0.0, 0.0, 0.0, 0.0)
    assert state.sheared.components == ((),)
    with pytest.raises(wk.OutsideValidity, match="at index 1 of the path .* the friction limit is 0 N"):
        wk.Tangential(
            BALL, Coulomb(MU), Path(path.time, path.normal, wk.ShearForce([0.0, 1.0])), wk.Method.SPRINGS
        ).solve()


def test_its_validity_notes():
    line, plane = still([0.0, 0.1]), still([[0.0, 0.0], [0.1, 0.1]])

    def notes(path):
        return wk.Tangential(BALL, Coulomb(MU), path, wk.Method.SPRINGS).solve().validity

    message = next(note for note in notes(line) if note.assumption is Assumption.RESOLUTION)
    assert message.standing is Standing.ASYMPTOTIC
    assert message.statement.startswith("400 springs: errors of shear force and energies are of second order")
    assert any("5 % after two strokes" in note.statement for note in notes(plane))
    medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(10.0, 0.2), 0.5)], wk.Elastic(1.0, 0.4))
    coated = wk.Foundation(wk.Paraboloid(1.0), medium)
    assert (
        spring_notes(wk.Springs.of(coated, 1.0, 20), Coulomb(MU), in_plane=False)[-1].standing is Standing.APPROXIMATE
    )
    state = list(wk.Tangential(coated, Coulomb(MU), still([0.0, 0.1]), wk.Method.SPRINGS, 20).steps())[-1]
    with pytest.raises(wk.OutsideValidity, match="the method rings"):
        _ = state.sheared


def test_sliding_on_a_coating():
    """Whatever the ratio of stiffnesses does, all springs slide at the coefficient times the force."""
    medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(10.0, 0.2), 0.5)], wk.Elastic(1.0, 0.4))
    path = Path(np.arange(3.0), wk.Depth([0.3, 0.5, 0.4]), wk.Shift([0.0, 3.0, 6.0]))
    trace = wk.Tangential(wk.Foundation(wk.Paraboloid(1.0), medium), Coulomb(MU), path, wk.Method.SPRINGS, 30).solve()
    np.testing.assert_allclose(trace.shear_force[1:], MU * trace.force[1:], rtol=1e-12)


@value
class Sticky:
    """A cold weld on top of Coulomb friction, where there is any load, up to a limit."""

    coefficient: float
    offset: float = 0.0
    most: float = np.inf

    def shear_bound(self, line_load):
        return np.minimum(np.where(line_load > 0.0, self.offset + self.coefficient * line_load, 0.0), self.most)


def test_a_law_of_ones_own():
    """In proportion to the load it is Coulomb's; with an offset every spring bears that much more."""
    track = FULL * np.array([0.0, 0.5, -0.3, 3.0])
    path = Path(np.arange(4.0), wk.Depth([1.0, 0.8, 0.9, 0.7]), wk.Shift(track))
    own, plain = (wk.Tangential(BALL, law, path, wk.Method.SPRINGS, 50).solve() for law in (Sticky(MU), Coulomb(MU)))
    np.testing.assert_allclose(own.shear_force, plain.shear_force, rtol=1e-12)
    np.testing.assert_allclose(own.dissipation, plain.dissipation, rtol=1e-9)
    more = wk.Tangential(BALL, Sticky(MU, 0.1), path, wk.Method.SPRINGS, 400).solve()
    touching = 2.0 * np.sqrt(0.7)  # length on both sides of the axis
    # a bound that does not vanish at the edge of the contact is of first order there
    assert more.shear_force[3] == pytest.approx(MU * more.force[3] + 0.1 * touching, rel=5e-4)
    limited = wk.Tangential(BALL, Sticky(MU, 0.0, 0.2), path, wk.Method.SPRINGS, 400).solve()
    edge = np.sqrt(0.7 - 0.2 / MU / E)
    expected = 2.0 * (0.2 * edge + MU * E * (0.7 * (np.sqrt(0.7) - edge) - (0.7**1.5 - edge**3) / 3.0))
    assert limited.shear_force[3] == pytest.approx(expected, rel=1e-4)
    assert any("every spring, not the traction" in note.statement for note in more.validity)
    with pytest.raises(wk.InvalidInput, match="Sticky.shear_bound must return finite loads"):
        wk.Tangential(BALL, Sticky(MU, 0.0, -1.0), path, wk.Method.SPRINGS, 50).solve()


def test_static_and_kinetic_friction():
    """With one coefficient they are Coulomb's; with two the contact bears more before it slides than after."""
    track = FULL * np.linspace(0.0, 3.0, 61)
    same = wk.Tangential(BALL, StaticKinetic(MU, MU), still(track), wk.Method.SPRINGS, 50).solve()
    plain = wk.Tangential(BALL, Coulomb(MU), still(track), wk.Method.SPRINGS, 50).solve()
    np.testing.assert_array_equal(same.shear_force, plain.shear_force)
    trace = wk.Tangential(BALL, StaticKinetic(2.0 * MU, MU), still(track), wk.Method.SPRINGS, 400).solve()
    # a spring at g drops when U = 2 b: stuck ones follow U, others bear b; with s = g at the edge of the stick zone
    s = np.maximum(1.0 - 0.5 * track / FULL, 0.0)
    stuck = 2.0 * np.sqrt(s) * G * track
    expected = stuck + 2.0 * MU * E * ((1.0 - np.sqrt(s)) - (1.0 - s**1.5) / 3.0)
    np.testing.assert_allclose(trace.shear_force, expected, atol=6e-3 * MU * FORCE)
    assert trace.shear_force.max() > 1.15 * trace.shear_force[-1]
    assert trace.shear_force[-1] == pytest.approx(MU * FORCE, rel=1e-12)
    mean = 0.5 * (trace.shear_force[1:] + trace.shear_force[:-1]) @ np.diff(trace.shift)
    assert trace.dissipation[-1] + trace.stored_energy[-1] == pytest.approx(mean, rel=2e-2)
    assert any("first order in the spring spacing" in note.statement for note in trace.validity)
    states = list(trace.problem.steps())
    np.testing.assert_allclose([state.stick_radius for state in states], np.sqrt(s), atol=4e-3)


def test_bad_input():
    with pytest.raises(wk.InvalidInput, match="the path prescribes a Angle; give Shift or"):
        wk.Tangential(BALL, Coulomb(MU), Path([0.0], wk.Depth(1.0), wk.Angle(0.1)), wk.Method.SPRINGS)
    with pytest.raises(wk.InvalidInput, match="law is a float; give Coulomb"):
        wk.Tangential(BALL, 0.3, still([0.0, 0.1]), wk.Method.SPRINGS)
    with pytest.raises(wk.InvalidInput, match="count is 1; give a whole number from 2"):
        wk.Tangential(BALL, Coulomb(MU), still([0.0, 0.1]), wk.Method.SPRINGS, 1)
