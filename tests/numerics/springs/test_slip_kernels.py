"""Springs that stick and slip: against small steps, an integrator of differential equations, and themselves."""

from __future__ import annotations

import importlib.util

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from winkler.numerics import jit
from winkler.numerics.springs import slip_kernels, slip_plane, slip_turn
from winkler.numerics.springs.slip_kernels import march_line
from winkler.numerics.springs.slip_plane import march_plane
from winkler.numerics.springs.slip_pull import pull_line

COUNT, STEPS = 60, 30
PLACE = np.linspace(0.0, 1.0, COUNT)
GAP = PLACE**2
STIFFNESS = 1.0 + PLACE
ALIKE = np.full(COUNT, 0.4)
UNLIKE = 0.3 + 0.2 * PLACE


def history(seed: int, steps: int = STEPS) -> tuple[np.ndarray, np.ndarray]:
    """Return depths that come and go, some of them held, and shifts in the plane."""
    rng = np.random.default_rng(seed)
    depth = np.cumsum(rng.normal(scale=0.25, size=steps + 1))
    depth += 0.4 - depth.mean()
    depth[5:8] = depth[5]
    return depth, np.cumsum(rng.normal(scale=0.08, size=(steps + 1, 2)), axis=0)


def line(depth, shift, slope, blocks=None, march=march_line):
    """Run the kernel over one direction, in blocks; return displacements, forces, energies and losses."""
    u, steps, shift = np.zeros(COUNT), depth.size - 1, np.ascontiguousarray(shift)
    force, stored, lost = np.zeros((3, steps))
    for a, b in blocks or [(0, steps)]:
        march(u, GAP, STIFFNESS, slope, depth[a : b + 1], shift[a : b + 1], force[a:b], stored[a:b], lost[a:b])
    return u, force, stored, lost


def plane(depth, shift, slope, hold=1.0, blocks=None, march=march_plane):
    """Do the same in the plane."""
    u, slips, steps = np.zeros((2, COUNT)), np.zeros(COUNT, dtype=bool), depth.size - 1
    force, stored, lost = np.zeros((steps, 2)), np.zeros(steps), np.zeros(steps)
    bound = slope * np.maximum(depth[:, np.newaxis] - GAP, 0.0)
    for a, b in blocks or [(0, steps)]:
        cut = slice(a, b + 1)
        march(u, slips, GAP, STIFFNESS, bound[cut], hold, depth[cut], shift[cut], force[a:b], stored[a:b], lost[a:b])
    return u, force, stored, lost


def refined(depth, shift, parts):
    """Return the same motion with every step in so many parts."""
    coarse, fine = np.arange(depth.size), np.arange((depth.size - 1) * parts + 1) / parts
    shift = np.column_stack([np.interp(fine, coarse, part) for part in np.atleast_2d(shift.T)])
    return np.interp(fine, coarse, depth), shift[:, 0] if shift.shape[1] == 1 else shift


def small_steps(depth, shift, slope, parts):
    """March in very small steps by the rule of the textbooks: follow, be held back, and lose force times slip."""
    depth, shift = refined(depth, shift, parts)
    u, lost, force = np.zeros(COUNT), np.zeros(depth.size - 1), np.zeros(depth.size - 1)
    for t in range(depth.size - 1):
        bound = slope * np.maximum(depth[t + 1] - GAP, 0.0)
        trial = np.where(depth[t + 1] > GAP, u + shift[t + 1] - shift[t], u)
        u = np.clip(trial, -bound, bound)
        lost[t] = STIFFNESS @ (np.abs(trial - u) * 0.5 * (np.abs(trial) + np.abs(u)))
        force[t] = STIFFNESS @ u
    return force[parts - 1 :: parts], lost.reshape(-1, parts).sum(1)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("slope", [ALIKE, UNLIKE], ids=["alike", "unlike"])
@pytest.mark.parametrize("seed", [1, 2])
def test_a_long_step_is_as_good_as_many_short_ones(slope, seed):
    depth, shift = history(seed)
    _, force, _, lost = line(depth, shift[:, 0], slope)
    errors = []
    for parts in (50, 800):
        expected, waste = small_steps(depth, shift[:, 0], slope, parts)
        errors.append([np.abs(force - expected).max() / force.max(), np.abs(lost - waste).max() / lost.max()])
    # it is the small steps that come nearer to the long one, as they get shorter
    np.testing.assert_array_less(errors[1], 2e-3)
    np.testing.assert_array_less(errors[1], 0.25 * np.array(errors[0]))


@pytest.mark.parametrize("slope", [ALIKE, UNLIKE], ids=["alike", "unlike"])
def test_steps_may_be_divided(slope):
    depth, shift = history(3)
    _, force, stored, lost = line(depth, shift[:, 0], slope)
    _, force_7, stored_7, lost_7 = line(*refined(depth, shift[:, 0], 7), slope)
    np.testing.assert_allclose(force_7[6::7], force, rtol=1e-12, atol=1e-13)
    np.testing.assert_allclose(stored_7[6::7], stored, rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(lost_7.reshape(-1, 7).sum(1), lost, rtol=1e-11, atol=1e-14)


@pytest.mark.parametrize("slope", [ALIKE, UNLIKE, np.full(COUNT, 1e100)], ids=["alike", "unlike", "rough"])
def test_work_is_stored_or_lost(slope):
    """The force over the shift, by the trapezoidal rule on ever shorter parts of the steps."""
    depth, shift = history(4)
    missing = []
    for parts in (20, 40):
        d, u = refined(depth, shift[:, 0], parts)
        _, force, stored, lost = line(d, u, slope)
        before = np.concatenate([[0.0], force[:-1]])
        work = np.sum(0.5 * (force + before) * np.diff(u))
        missing.append(abs(work - stored[-1] - lost.sum()) / lost.sum())
    assert missing[1] < 2e-4
    assert missing[1] < 0.35 * missing[0]


def test_without_slip_a_spring_that_leaves_takes_what_it_stored():
    u = np.zeros(1)
    force, stored, lost = np.zeros((3, 3))
    march_line(
        u,
        np.array([0.5]),
        np.array([2.0]),
        np.array([1e100]),
        np.array([0.0, 1.0, 1.0, 0.0]),
        np.array([0.0, 0.2, 0.5, 0.7]),
        force,
        stored,
        lost,
    )
    # in touch from half of the first step to half of the last
    np.testing.assert_allclose(force, [0.2, 0.8, 0.0], rtol=1e-14)
    np.testing.assert_allclose(lost, [0.0, 0.0, 0.5**2], rtol=1e-14)


def test_loss_of_one_spring_by_hand():
    """The bound rises from 1 to 2 while the bodies move by 4: reached after 1/3 of the path, then follow it."""
    u = np.zeros(1)
    force, stored, lost = np.zeros((3, 1))
    march_line(u, np.zeros(1), np.ones(1), np.ones(1), np.array([1.0, 2.0]), np.array([0.0, 4.0]), force, stored, lost)
    assert force[0] == pytest.approx(2.0, rel=1e-15)
    # slip 3 per unit of time over the last 2/3 under a mean force of (4/3 + 2)/2
    assert lost[0] == pytest.approx(3.0 * (2.0 / 3.0) * (5.0 / 3.0), rel=1e-14)


@pytest.mark.parametrize("angle", [0.0, 1.1, 3.9])
@pytest.mark.parametrize("slope", [ALIKE, UNLIKE, np.full(COUNT, 1e100)], ids=["alike", "unlike", "rough"])
def test_one_direction_in_the_plane_is_a_line(angle, slope):
    depth, shift = history(5)
    u, force, stored, lost = line(depth, shift[:, 0], slope)
    path = np.array([np.cos(angle), np.sin(angle)])
    u_2, force_2, stored_2, lost_2 = plane(depth, np.outer(shift[:, 0], path), slope)
    np.testing.assert_allclose(u_2, np.outer(path, u), atol=1e-13)
    np.testing.assert_allclose(force_2, np.outer(force, path), atol=1e-12)
    np.testing.assert_allclose(stored_2, stored, atol=1e-13)
    np.testing.assert_allclose(lost_2, lost, rtol=1e-11, atol=1e-13)


@pytest.mark.parametrize(("bound", "last"), [(1.0, 1.0), (1.0, 1.3), (1.0, 0.4), (1.0, 0.0)])
@pytest.mark.parametrize("angle", [0.3, 1.5, 2.9])
@pytest.mark.parametrize("path", [0.05, 0.7, 3.0])
def test_a_spring_turns_as_the_differential_equation_says(bound, last, angle, path):
    """It follows the bodies; on the circle only the part of the motion along the circle is left."""
    start = 0.95 * bound * np.array([np.cos(angle), np.sin(angle)])
    move = np.array([path, 0.0])

    def radius(s):
        return bound + s * (last - bound)

    def outward(s, u):
        return u[0] ** 2 + u[1] ** 2 - radius(s) ** 2

    outward.terminal, outward.direction = True, 1.0
    stuck = solve_ivp(lambda s, u: move, (0.0, 1.0), start, events=outward, rtol=1e-12, atol=1e-14)
    u, lost = stuck.y[:, -1], 0.0
    if stuck.t[-1] < 1.0:
        at = np.arctan2(u[1], u[0])

        def slip(s, y):  # the angle to the motion, and the loss: bound times rate of slip
            b = radius(s)
            return [-path * np.sin(y[0]) / b, b * (path * np.cos(y[0]) - (last - bound))]

        end = 1.0 if last > 0.0 else 1.0 - 1e-9
        turned = solve_ivp(slip, (stuck.t[-1], end), [at, 0.0], rtol=1e-11, atol=1e-13, method="LSODA").y[:, -1]
        u, lost = last * np.array([np.cos(turned[0]), np.sin(turned[0])]), turned[1]
    x, y, waste, _ = slip_turn.travel(*start, bound, last, *move, 1.0, False)
    np.testing.assert_allclose([x, y], u, atol=1e-8)
    assert waste == pytest.approx(lost, rel=1e-8 if last == bound else 2e-4, abs=1e-9)


@pytest.mark.parametrize("last", [1.0, 1.02, 0.97])
def test_the_row_turns_as_every_spring_by_itself(last):
    rng = np.random.default_rng(6)
    first = rng.uniform(0.2, 1.0, 300)
    angle, part = rng.uniform(-1.2, 1.2, 300), rng.uniform(0.9, 1.0, 300)
    ux, uy = first * part * np.cos(angle), first * part * np.sin(angle)
    nx, ny, waste = np.zeros((3, 300))
    move = np.array([0.06, 0.02])
    slip_plane._circle((ux, uy), first, last * first, False, *move, (nx, ny, waste))
    row = np.array([nx, ny, waste])
    if last == 1.0:
        slip_plane._circle((ux, uy), first, first, True, *move, (nx, ny, waste))
        np.testing.assert_allclose([nx, ny, waste], row, atol=1e-14)
    observed = 0
    for i in range(300):
        x, y, lost, _ = slip_turn.travel(ux[i], uy[i], first[i], last * first[i], *move, 1.0, False)
        if waste[i] >= 0.0:
            observed += 1
            np.testing.assert_allclose(row[:2, i], [x, y], atol=1e-13)
            assert row[2, i] == pytest.approx(lost, rel=1e-4, abs=1e-13 if last == 1.0 else 1e-3 * first[i] * 0.063)
    assert observed > 250


def test_steps_in_the_plane_may_be_divided():
    depth, shift = history(7)
    _, force, stored, lost = plane(depth, shift, ALIKE)
    for parts in (4, 16):
        _, force_n, stored_n, lost_n = plane(*refined(depth, shift, parts), ALIKE)
        np.testing.assert_allclose(force_n[parts - 1 :: parts], force, atol=2e-12)
        np.testing.assert_allclose(stored_n[parts - 1 :: parts], stored, atol=1e-12)
        lost_n = lost_n.reshape(-1, parts).sum(1)
        # where the depth is held the loss is exact as well
        np.testing.assert_allclose(lost_n[5:7], lost[5:7], rtol=1e-11)
        np.testing.assert_allclose(lost_n, lost, rtol=3e-4, atol=1e-4 * lost.max())


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 10**6), st.floats(0.01, 3.0))
def test_nothing_is_ever_gained(seed, size):
    depth, shift = history(seed)
    bound = ALIKE[0] * max(depth.max(), 0.0)
    for hold in (1.0, 1.5):
        u, force, _, lost = plane(depth, size * shift, ALIKE, hold)
        assert lost.min() >= 0.0
        assert np.all(np.hypot(*u) <= hold * bound * (1.0 + 1e-12))
        most = hold * ALIKE[0] * np.maximum(depth[1:, np.newaxis] - GAP, 0.0) @ STIFFNESS
        assert np.all(np.hypot(*force.T) <= most * (1.0 + 1e-12))
    assert line(depth, size * shift[:, 0], UNLIKE)[3].min() >= 0.0


def test_blocks_do_not_matter_to_the_last_bit():
    depth, shift = history(8)
    ones = [(t, t + 1) for t in range(STEPS)]
    for one, all_ in (
        (line(depth, shift[:, 0], ALIKE, ones), line(depth, shift[:, 0], ALIKE)),
        (line(depth, shift[:, 0], UNLIKE, ones), line(depth, shift[:, 0], UNLIKE)),
        (plane(depth, shift, ALIKE, blocks=ones), plane(depth, shift, ALIKE)),
        (plane(depth, shift, ALIKE, 1.3, blocks=ones), plane(depth, shift, ALIKE, 1.3)),
    ):
        for a, b in zip(one, all_, strict=True):
            np.testing.assert_array_equal(a, b)


def test_the_source_runs_without_a_compiler(monkeypatch):
    """As it must in a browser; equal but for the order of sums."""
    monkeypatch.setattr(jit, "_numba", lambda: None)
    plain = []
    for module in (slip_kernels, slip_plane):
        place = importlib.util.spec_from_file_location("interpreted", module.__file__)
        plain.append(importlib.util.module_from_spec(place))
        place.loader.exec_module(plain[-1])
    depth, shift = history(9, 12)
    for a, b in (
        (line(depth, shift[:, 0], UNLIKE, march=plain[0].march_line), line(depth, shift[:, 0], UNLIKE)),
        (line(depth, shift[:, 0], ALIKE, march=plain[0].march_line), line(depth, shift[:, 0], ALIKE)),
        (plane(depth, shift, ALIKE, march=plain[1].march_plane), plane(depth, shift, ALIKE)),
        (plane(depth, shift, ALIKE, 1.4, march=plain[1].march_plane), plane(depth, shift, ALIKE, 1.4)),
    ):
        for interpreted, machine in zip(a, b, strict=True):
            np.testing.assert_allclose(interpreted, machine, atol=1e-13)


def test_a_prescribed_force_is_met():
    depth, _ = history(10)
    depth = np.maximum(depth, 0.05)
    most = np.array([STIFFNESS @ (UNLIKE * np.maximum(d - GAP, 0.0)) for d in depth[1:]])
    target = most * np.random.default_rng(0).uniform(-0.999, 0.999, STEPS)
    u, shift = np.zeros(COUNT), np.zeros(STEPS + 1)
    force, stored, lost = np.zeros((3, STEPS))
    assert pull_line(u, GAP, STIFFNESS, UNLIKE, depth, target, shift, force, stored, lost) == STEPS
    np.testing.assert_allclose(force, target, rtol=1e-11, atol=1e-12)
    for given_, again in zip((force, stored, lost), line(depth, shift, UNLIKE)[1:], strict=True):
        np.testing.assert_allclose(again, given_, atol=1e-13)


def test_a_force_beyond_friction_is_refused_where_it_is():
    target = np.array([0.1, 0.3, 1.01, 0.0])
    u, shift = np.zeros(1), np.zeros(5)
    force, stored, lost = np.zeros((3, 4))
    one = np.ones(1)
    assert pull_line(u, np.zeros(1), one, one, np.ones(5), target, shift, force, stored, lost) == 2
    np.testing.assert_allclose(force[:2], target[:2], rtol=1e-14)


def test_a_spring_that_holds_on_drops_when_it_slips():
    """Static bound 1.5, kinetic 1: it holds to 1.5, drops to 1, slides on, and sticks again when the motion turns."""
    u, slips = np.zeros((2, 1)), np.zeros(1, dtype=bool)
    shift = np.zeros((7, 2))
    shift[:, 0] = [0.0, 1.4, 1.6, 2.0, 1.0, -0.4, -0.6]
    force, stored, lost = np.zeros((6, 2)), np.zeros(6), np.zeros(6)
    march_plane(u, slips, np.zeros(1), np.ones(1), np.ones((7, 1)), 1.5, np.ones(7), shift, force, stored, lost)
    np.testing.assert_allclose(force[:, 0], [1.4, 1.0, 1.0, 0.0, -1.4, -1.0], rtol=1e-14, atol=1e-14)
    drop = 0.5 * (1.5**2 - 1.0)
    np.testing.assert_allclose(lost, [0.0, drop + 0.1, 0.4, 0.0, 0.0, drop + 0.1], rtol=1e-13, atol=1e-14)
