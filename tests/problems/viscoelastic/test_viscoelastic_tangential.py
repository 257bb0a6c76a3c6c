"""Viscoelastic contacts with friction: proportion, elastic limits, complex stiffness, brute force, and energy."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import winkler as wk
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.loading.loads import Angle, Depth, Force, ShearForce, Shift
from winkler.loading.path import Path
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.materials.viscoelastic import Prony
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.friction.tangential import Tangential
from winkler.problems.viscoelastic.tangential_march import DraggedRow, shear_relaxation
from winkler.values.errors import InvalidInput, OutsideValidity

STANDARD = StandardSolid(0.05, 0.2, 0.2)
MU = 0.3
TIME = np.linspace(0.0, 1.0, 41)
PRESS, PUSH = 0.01 * np.sin(np.pi * TIME) ** 2, 0.003 * np.sin(4.0 * np.pi * TIME)


def bed(solid, profile=None) -> wk.Foundation:
    return wk.Foundation(wk.Paraboloid(1.0) if profile is None else profile, ViscoelasticHalfSpace(solid))


def dragged(solid, time, normal, lateral, law=None, profile=None, **more):
    law = Coulomb(MU) if law is None else law
    return Tangential(bed(solid, profile), law, Path(time, normal, lateral), **{"count": 500, **more}).solve()


@pytest.mark.parametrize("profile", [wk.Paraboloid(1.0), wk.Cone(half_angle=1.4)])
@pytest.mark.parametrize("part", [0.3, pytest.param(0.8, marks=pytest.mark.slow)])
def test_all_relaxes_in_proportion_after_sudden_steps(profile, part):
    time = np.array([0.0, 0.1, 1.0, 30.0])
    half = part * MU * 0.01 * 1.5
    held = dragged(STANDARD, time, Depth(0.01), Shift(half), profile=profile, count=4000)
    glass = wk.Foundation(profile, wk.HalfSpace(wk.Elastic(0.75, 0.5)))
    elastic = wk.Tangential(glass, Coulomb(MU), Path([0.0], Depth(0.01), Shift(half))).solve()
    fall = (0.05 + 0.2 * np.exp(-time / 0.2)) / 0.25
    assert held.force == pytest.approx(fall * elastic.force[0], rel=1e-6)
    assert held.shear_force == pytest.approx(fall * elastic.shear_force[0], rel=2e-6)
    assert held.stick_radius[0] == pytest.approx(elastic.stick_radius[0], rel=1e-3)
    assert held.friction_loss == pytest.approx(np.full(4, elastic.dissipation[0]), rel=2e-3)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("solid", [STANDARD, Prony(0.05, [0.2, 0.3], [0.01, 0.5]), KelvinVoigt(0.25, 0.05)])
def test_small_oscillations_without_slip(solid):
    """F_x = 2 G*(omega) a U, once what was before is forgotten."""
    omega, per = 2.0 * np.pi * 1.5, 200
    time = np.arange(4 * per + 1) / per / 1.5
    start = np.array([0.0, 5.0])
    t = np.concatenate([start, 5.0 + time[1:]])
    depth = np.concatenate([[0.0], np.full(t.size - 1, 0.01)])
    shift = np.concatenate([[0.0, 0.0], 1e-4 * np.sin(omega * time[1:])])
    result = dragged(solid, t, Depth(depth), Shift(shift), Coulomb(math.inf))
    last = slice(-per, None)
    turn = np.exp(-1j * omega * time[last])
    got = np.sum(result.shear_force[last] * turn) / np.sum(shift[last] * turn)
    expected = 2.0 * 0.1 * shear_relaxation(ViscoelasticHalfSpace(solid)).dynamic(np.array(omega))
    # a dashpot's force is that of the rate before every point: half of a step late
    late = 0.5 * omega / per / 1.5 * (0.05 * omega / 0.25 if isinstance(solid, KelvinVoigt) else 0.0)
    assert abs(got / expected - 1.0) < 2e-3 + 1.2 * late
    assert np.all(result.friction_loss == 0.0)


def brute_force(solid, path, count, steps, mu):
    """March springs with Euler's implicit method in many little steps; return F_x at the points of the path."""
    x = (np.arange(count) + 0.5) / count * 0.105
    gap, width = x**2, 2.0 * 0.105 / count
    normal = np.array([4.0 * solid.relaxed_shear, 4.0 * solid.shear])
    shear = normal * 2.0 / 3.0
    u, v, s, r = (np.zeros(count) for _ in range(4))
    touching = np.zeros(count, dtype=bool)
    forces, lost = [0.0], [0.0]
    loss = 0.0
    for i in range(path.time.size - 1):
        dt = (path.time[i + 1] - path.time[i]) / steps
        fade = 1.0 / (1.0 + dt / solid.relaxation_time)
        for k in range(steps):
            part = (k + 1.0) / steps
            depth = path.across[i] + part * (path.across[i + 1] - path.across[i])
            push = (path.along[i + 1] - path.along[i]) / steps
            glass = normal[0] + normal[1] * fade
            free = u - (normal[0] * u + s * fade) / glass
            touching = depth - gap > free
            new = np.where(touching, depth - gap, free)
            s = (s + normal[1] * (new - u)) * fade
            u = new
            bound = np.where(touching, mu * np.maximum(normal[0] * u + s, 0.0), 0.0)
            stiff = shear[0] + shear[1] * fade
            rest = shear[0] * v + r * fade
            load = np.clip(rest + stiff * push, -bound, bound)
            moved = (load - rest) / stiff
            loss += np.sum(np.where(touching, load * (push - moved), 0.0)) * width
            r = (r + shear[1] * moved) * fade
            v = v + moved
        forces.append(np.sum(load) * width)
        lost.append(loss)
    return np.array(forces), np.array(lost)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, pytest.param(2, marks=pytest.mark.slow)])
def test_brute_force(seed):
    rng = np.random.default_rng(seed)
    time = np.linspace(0.0, 1.0, 9)
    depth = np.concatenate([[0.0], 0.01 * rng.uniform(0.0, 1.0, 8)])
    shift = np.concatenate([[0.0], np.cumsum(rng.uniform(-0.002, 0.002, 8))])
    path = Path(time, Depth(depth), Shift(shift))
    # of first order in the step, so that two give the limit
    once, twice = (np.array(brute_force(STANDARD, path, 200, n, MU)) for n in (400, 800))
    forces, lost = 2.0 * twice - once
    result = Tangential(bed(STANDARD), Coulomb(MU), path, tolerance=1e-6).solve()
    assert result.shear_force == pytest.approx(forces, abs=3e-3 * np.max(np.abs(forces)))
    assert result.friction_loss == pytest.approx(lost, abs=3e-3 * lost[-1])


def test_steps_are_chosen_by_their_error():
    whole = dragged(STANDARD, TIME, Depth(PRESS), Shift(PUSH))
    fine = np.linspace(0.0, 1.0, 401)
    many = dragged(STANDARD, fine, Depth(np.interp(fine, TIME, PRESS)), Shift(np.interp(fine, TIME, PUSH)))
    assert whole.shear_force == pytest.approx(many.shear_force[::10], abs=2e-5 * np.max(many.shear_force))
    assert whole.friction_loss[-1] == pytest.approx(many.friction_loss[-1], rel=1e-4)
    # the machine's work, from outside
    work = np.trapezoid(many.shear_force, many.shift) + np.trapezoid(many.force, many.depth)
    assert many.work[-1] == pytest.approx(work, rel=1e-4)
    states = list(whole.problem.steps())
    assert [state.shear_force for state in states] == whole.shear_force.tolist()
    assert states[20].sticking.shape == states[20].shear_load.shape == (500,)
    assert np.all(np.abs(states[20].shear_load) <= MU * states[20].line_load * (1.0 + 1e-9) + 1e-18)


def test_a_step_far_longer_than_the_relaxation_stays_accurate():
    """One step of 1e4 relaxation times: relaxed but for what the rate still holds."""
    solid = StandardSolid(0.05, 0.2, 1e-4)
    ours = dragged(solid, [0.0, 1.0, 2.0], Depth([0.0, 0.01, 0.01]), Shift([0.0, 0.0, 0.002]))
    elastic = wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(0.15, 0.5)))
    true = wk.Tangential(
        elastic, Coulomb(MU), Path([0.0, 1.0, 2.0], Depth([0.0, 0.01, 0.01]), Shift([0.0, 0.0, 0.002]))
    )
    assert ours.shear_force[2] == pytest.approx(true.solve().shear_force[2], rel=1e-3)


@pytest.mark.slow
def test_prescribed_forces():
    normal = Force(1e-3 * (1.2 - np.cos(2.0 * np.pi * TIME)))
    free = wk.ViscoelasticIndentation(bed(STANDARD), Path(TIME, normal)).solve()
    pushed = dragged(STANDARD, TIME, normal, Shift(PUSH))
    assert pushed.depth == pytest.approx(free.depth, rel=1e-4)
    assert pushed.force == pytest.approx(normal.force, rel=1e-9)
    held = dragged(STANDARD, TIME, normal, ShearForce(0.5 * MU * 2e-4 * np.sin(4.0 * np.pi * TIME)))
    assert held.shear_force == pytest.approx(held.problem.path.along, abs=1e-14)
    fine = np.linspace(0.0, 1.0, 201)
    load = Force(np.interp(fine, TIME, normal.force))
    pull = ShearForce(np.interp(fine, TIME, held.problem.path.along))
    there = dragged(STANDARD, fine, load, pull)
    back = dragged(STANDARD, fine, load, Shift(there.shift))
    assert there.shift[::5] == pytest.approx(held.shift, abs=1e-4 * np.max(held.shift))
    assert back.shear_force == pytest.approx(pull.shear_force, abs=1e-4 * np.max(pull.shear_force))


@pytest.mark.slow
def test_creep_under_a_shear_force_in_full_stick():
    """U = F_x (1/G*)(t) / (2 a), at a depth that is held."""
    time = np.array([0.0, 100.0, 100.0, 100.1, 100.5, 120.0])
    load = np.array([0.0, 0.0, 1e-6, 1e-6, 1e-6, 1e-6])
    after = time[2:] - 100.0
    compliance = 1.0 / 0.05 - (0.2 / (0.05 * 0.25)) * np.exp(-after * 0.05 / (0.2 * 0.25))
    true = 1e-6 * compliance * 0.375 / 0.2
    # the load jumps at the edge, where half of a spring is missing
    for count in (200, 800):
        law = Coulomb(math.inf)
        result = dragged(STANDARD, time, Depth(0.01), ShearForce(load), law, tolerance=1e-6, count=count)
        assert result.shift[2:] == pytest.approx(true * (1.0 + 0.5 / count), rel=1e-4)


turns = st.lists(
    st.tuples(st.floats(0.01, 2.0), st.floats(-0.3, 1.0), st.floats(-1.0, 1.0)), min_size=3, max_size=6
)  # fmt: skip


@settings(max_examples=12, deadline=None)
@given(
    turns, st.sampled_from([STANDARD, Maxwell(0.25, 0.3), KelvinVoigt(0.1, 0.05), Prony(0.0, [0.1, 0.3], [1.0, 0.01])])
)
def test_energy_is_never_made(points, solid):
    time = np.cumsum([0.0, *(dt for dt, _, _ in points)])
    depth = np.array([0.0, *(0.01 * d for _, d, _ in points)])
    shift = np.array([0.0, *(0.004 * u for _, _, u in points)])
    if np.max(depth) < 1e-4:
        return
    try:
        found = dragged(solid, time, Depth(depth), Shift(shift), count=60, tolerance=1e-3)
    except OutsideValidity:  # a ring, which is no disc
        return
    little = 1e-9 * np.max(found.work)
    assert np.all(np.diff(found.friction_loss) >= -little)
    assert np.all(np.diff(found.bulk_loss) >= -little)
    assert np.all(found.stored_energy >= 0.0)


def test_the_compliances_of_two_bodies_add_up():
    pair = ViscoelasticHalfSpace(StandardSolid(0.05, 0.2, 0.2, poisson=0.3), wk.Elastic(2.0, 0.2))
    omega = np.array([0.3, 3.0, 30.0])
    first = StandardSolid(0.05, 0.2, 0.2).series.dynamic(omega)
    expected = 1.0 / (1.7 / (4.0 * first) + 1.8 / (4.0 * 2.0 / 2.4))
    assert shear_relaxation(pair).dynamic(omega) == pytest.approx(expected, rel=1e-12)


def test_a_wider_row_changes_little():
    forces = [dragged(STANDARD, TIME, Depth(PRESS), Shift(PUSH), count=n).shear_force for n in (125, 250, 2000)]
    errors = [np.max(np.abs(force - forces[-1])) for force in forces[:-1]]
    assert errors[0] < 1e-3 * np.max(forces[-1])
    assert errors[1] < 0.4 * errors[0]


def test_solids_that_recover_are_touched_again():
    t = [0.0, 1.0, 1.2, 3.0, 4.0, 5.0]
    result = dragged(
        STANDARD, t, Depth([0.0, 0.01, -0.01, -0.01, 0.01, 0.01]), Shift([0.0, 0.001, 0.1, 0.1, 0.1, 0.101])
    )
    first = dragged(STANDARD, t[:2], Depth([0.0, 0.01]), Shift([0.0, 0.001]))
    assert result.shear_force[1] == first.shear_force[1]
    assert result.shear_force[2] == result.shear_force[3] == 0.0
    assert result.force[3] == 0.0
    # what has not recovered yet resists when it is caught
    assert 0.0 < abs(result.shear_force[4]) < 0.05 * result.shear_force[5]


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"law": StaticKinetic(0.5, 0.3)}, "StaticKinetic"),
        ({"path": Depth(1.0)}, "path is a Depth"),
        ({"path": Path([0.0, 1.0], Depth(0.01), Angle(0.1))}, "prescribes a Angle"),
        ({"path": Path([0.0, 1.0], Depth(0.01), Shift(np.zeros((2, 2))))}, "leaves its line"),
        ({"method": wk.Method.RINGS}, "the method rings"),
        ({"path": Path([0.0, 1.0], Force(-1.0))}, "tensile"),
        ({"count": 1}, "count"),
        ({"tolerance": 2.0}, "tolerance"),
    ],
)
def test_wrong_input_is_refused(given, message):
    right = {"bed": bed(STANDARD), "law": Coulomb(MU), "path": Path([0.0, 1.0], Depth(0.01), Shift([0.0, 0.001]))}
    with pytest.raises(InvalidInput, match=message):
        Tangential(**{**right, **given})


def test_what_cannot_be_is_refused_where_it_happens():
    slides = Tangential(
        bed(STANDARD), Coulomb(MU), Path([0.0, 1.0, 2.0], Depth(0.01), ShearForce([0.0, 1e-5, 1.0]))
    ).steps()
    assert len(list(itertools.islice(slides, 2))) == 2
    with pytest.raises(OutsideValidity, match="slide away"):
        next(slides)
    voigt = KelvinVoigt(0.25, 0.05)
    with pytest.raises(OutsideValidity, match="depth rises suddenly"):
        dragged(voigt, [0.0, 1.0], Depth(0.01), Shift(0.0))
    with pytest.raises(OutsideValidity, match="moved suddenly"):
        dragged(voigt, [0.0, 1.0, 1.0], Depth([0.0, 0.01, 0.01]), Shift([0.0, 0.0, 0.001]))
    with pytest.raises(OutsideValidity, match="never touch"):
        dragged(STANDARD, [0.0, 1.0], Depth(-0.01), Shift(0.0))


def crept_ball(time, force=1e-2, tau=0.3):
    """Return the depth of a ball of unit radius on a Kelvin-Voigt half-space of G = 1/4, nu = 0, under a force."""
    return (0.75 * force / 0.5 * -np.expm1(-time / tau)) ** (2.0 / 3.0)


@pytest.mark.parametrize("count", [100, pytest.param(400, marks=pytest.mark.slow)])
def test_a_dashpot_under_a_force_bears_the_rate_of_the_shift(count):
    """Each spring bears G (U - U when it was touched) + eta dU/dt; the error falls with the number of springs."""
    force, tau, stiff = 1e-2, 0.3, 0.5  # G* = 2 G for nu = 0
    time = np.linspace(0.0, 2.0, 21)
    shift = 0.05 * np.sin(3.0 * time)
    pushed = dragged(
        KelvinVoigt(0.25, 0.25 * tau, 0.0), time, Force(force), Shift(shift), Coulomb(math.inf), count=count
    )
    np.testing.assert_allclose(pushed.depth, crept_ball(time), rtol=1e-4)
    fine = np.linspace(0.0, 2.0, 40_001)
    width, moved = np.sqrt(crept_ball(fine)), np.interp(fine, time, shift)
    borne = []
    for now, rate in zip(time[1:], np.diff(shift) / np.diff(time), strict=True):
        some = fine <= now + 1e-9
        since = np.trapezoid(moved[some], width[some])
        borne.append(2.0 * stiff * (width[some][-1] * (moved[some][-1] + tau * rate) - since))
    np.testing.assert_allclose(pushed.shear_force[1:], borne, rtol=0.0, atol=0.5 / count * np.max(np.abs(borne)))


@pytest.mark.parametrize("tau", [0.03, pytest.param(1.0, marks=pytest.mark.slow)])
def test_a_dashpot_pushed_to_and_fro_under_a_force_is_followed_in_a_bounded_number_of_steps(tau, monkeypatch):
    """Springs bear suddenly what a dashpot resists: their force was compared, and steps were halved for ever."""
    steps, step = [], DraggedRow.step
    monkeypatch.setattr(DraggedRow, "step", lambda row, *where: steps.append(0) or step(row, *where))
    time = np.linspace(0.0, 2.0, 26)
    shift = 5e-2 * np.sin(2.0 * np.pi * time)
    solid, count = KelvinVoigt(0.25, 0.25 * tau, 0.0), 100
    pushed = dragged(solid, time, Force(1e-2), Shift(shift), count=count)
    assert len(steps) < 300 * time.size
    assert np.all(
        np.abs(pushed.shear_force) <= MU * pushed.force * (1.0 + 1.0 / count)
    )  # one spring is touched suddenly
    # the same by its depth, which is known, and more points
    finer = np.unique(np.concatenate([time, np.linspace(0.0, 2.0, 1001)]))
    again = dragged(solid, finer, Depth(crept_ball(finer, tau=tau)), Shift(np.interp(finer, time, shift)), count=count)
    assert pushed.friction_loss[-1] == pytest.approx(again.friction_loss[-1], rel=5e-3)
    assert pushed.bulk_loss[-1] == pytest.approx(again.bulk_loss[-1], rel=5e-3)
