"""Torsion against Lubkin's tables, closed forms, and springs that are moved one by one."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad
from scipy.special import ellipe, ellipkm1

from winkler.foundation.bed import PressedSprings
from winkler.foundation.foundation import Foundation
from winkler.foundation.plane import PlaneFoundation
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Angle, Depth, Force, Shift, Torque
from winkler.loading.path import Path
from winkler.loading.path_steps import Ramp, Start
from winkler.loading.program import Program
from winkler.materials.elastic import Elastic, TransverselyIsotropic
from winkler.materials.graded import PowerLawGraded
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.halfspace import HalfSpace
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.media.twisting.kernels import twisted_medium
from winkler.problems.friction.torsion import Torsion
from winkler.profiles.conical import Cone, TruncatedCone
from winkler.profiles.flat import FlatPunch
from winkler.profiles.measured import Measured
from winkler.profiles.power import Paraboloid
from winkler.reference.torsion import (
    ball_twist,
    ball_twist_limit,
    punch_twist,
    rigid_twist_torque,
    small_ball_twist,
)
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Standing

MEDIUM = HalfSpace(Elastic(1.0, 0.3), Elastic(2.5, 0.2))
G = MEDIUM.torsional_modulus
MU, A, R = 0.4, 0.02, 1.0
BALL = Foundation(Paraboloid(R), MEDIUM)
F = 4.0 / 3.0 * MEDIUM.modulus * A**3 / R
TWIST, MOMENT = MU * F / (G * A**2), MU * F * A
LUBKIN = [
    (0.99, 0.00375944587, 0.0197513720),
    (0.9, 0.0385138791, 0.1763453815),
    (0.8, 0.0794192099, 0.3105272952),
    (0.7, 0.1234362505, 0.4097384796),
    (0.6, 0.1716373462, 0.4804799793),
    (0.5, 0.2257118580, 0.5285759656),
    (0.4, 0.2885338883, 0.5591932999),
    (0.3, 0.3655699474, 0.5768680426),
    (0.2, 0.4692548849, 0.5855425693),
    (0.1, 0.6397178390, 0.5886198851),
    (0.01, 1.1915886244, 0.5890481981),
]


def twisted(bed, normal, lateral, mu=MU):
    steps = np.asarray(next(iter(vars(lateral).values()))).size
    return Torsion(bed, Coulomb(mu), Path(np.arange(steps), normal, lateral)).solve()


def test_the_torsional_modulus_adds_compliances():
    one, two = Elastic(1.0, 0.3).shear, Elastic(2.5, 0.2).shear
    assert pytest.approx(one * two / (one + two), rel=1e-15) == G


@pytest.mark.parametrize(("core", "angle", "torque"), LUBKIN)
def test_lubkin_table(core, angle, torque):
    solution = twisted(BALL, Depth(A**2 / R), Angle([angle * TWIST]))
    # the angles are given to ten digits, which the torque feels
    assert solution.torque[0] / MOMENT == pytest.approx(torque, abs=1.5e-10)
    assert solution.stick_radius[0] / A == pytest.approx(core, rel=3e-10)
    assert float(ball_twist(core)) == pytest.approx(angle, abs=5.1e-11)


@pytest.mark.parametrize(("core", "angle", "torque"), LUBKIN[:9])
def test_a_torque_finds_lubkins_angle(core, angle, torque):
    solution = twisted(BALL, Force(F), Torque([torque * MOMENT]))
    assert solution.angle[0] / TWIST == pytest.approx(angle, rel=3e-8)
    assert solution.torque[0] == pytest.approx(torque * MOMENT, abs=1e-12 * MOMENT)
    assert solution.stick_radius[0] / A == pytest.approx(core, rel=3e-8)


def test_deresiewicz_holds_for_small_torques():
    off = [float(small_ball_twist(torque)) / angle - 1.0 for core, angle, torque in LUBKIN if core in (0.99, 0.6)]
    assert abs(off[0]) < 1e-4
    assert off[1] == pytest.approx(-0.15, abs=0.01)
    solution = twisted(BALL, Force(F), Torque([0.01 * MOMENT]))
    assert solution.angle[0] / TWIST == pytest.approx(float(small_ball_twist(0.01)), rel=1e-4)


@pytest.mark.parametrize(
    ("profile", "factor"), [(Paraboloid(R), 3.0 / 16.0), (FlatPunch(0.01), 0.25), (Cone(half_angle=1.5), 1.0 / 6.0)]
)
def test_greatest_torque(profile, factor):
    solution = twisted(Foundation(profile, MEDIUM), Force(1e-5), Angle([0.0]))
    assert solution.torque_limit[0] == pytest.approx(factor * math.pi * MU * 1e-5 * solution.radius[0], rel=1e-12)
    if factor == 3.0 / 16.0:
        limit = ball_twist_limit(friction=MU, force=1e-5, radius=float(solution.radius[0]))
        assert solution.torque_limit[0] == pytest.approx(limit, rel=1e-12)


@pytest.mark.parametrize("profile", [TruncatedCone(half_angle=1.5, flat_radius=0.004), Paraboloid(R)])
@pytest.mark.parametrize("kind", ["shape", "plane"])
def test_greatest_torque_is_the_moment_of_the_pressure(profile, kind):
    bed = Foundation(profile, MEDIUM) if kind == "shape" else PlaneFoundation(profile, MEDIUM)
    state = twisted(bed, Depth(1e-3), Angle([0.0])).at(0)
    x = 0.5 * (1.0 + np.polynomial.legendre.leggauss(400)[0])
    weights = 0.5 * np.polynomial.legendre.leggauss(400)[1]
    flat = 0.004 if isinstance(profile, TruncatedCone) else 0.0
    moment = 0.0
    for low, high in (
        (0.0, flat),
        (flat, state.radius),
    ):
        # p r^2 dr has roots and logarithms at either end of each part
        r = low + (high - low) * x**3 * (10.0 - 15.0 * x + 6.0 * x * x)
        jacobian = (high - low) * 30.0 * x**2 * (1.0 - x) ** 2
        if high > low:
            p = MEDIUM.pressure(PressedSprings(bed, state.depth, state.radius), r)
            moment += 2.0 * math.pi * MU * float(np.sum(weights * jacobian * p * r * r))
    assert state.torque_limit == pytest.approx(moment, rel=1e-7)


def test_a_measured_ball_bears_what_a_ball_bears():
    r = np.linspace(0.0, 2.0 * A, 60)
    bed = Foundation(Measured(r, r**2 / (2.0 * R)), MEDIUM)
    measured, ball = (twisted(each, Force(F), Angle([0.3 * TWIST])) for each in (bed, BALL))
    assert measured.torque_limit == pytest.approx(ball.torque_limit, rel=1e-6)
    assert measured.torque == pytest.approx(ball.torque, rel=1e-6)
    assert measured.stick_radius == pytest.approx(ball.stick_radius, rel=1e-5)


def test_cone_half_slipped():
    bed, depth = Foundation(Cone(half_angle=1.5), MEDIUM), 1e-3
    contact = twisted(bed, Depth(depth), Angle([0.0]))
    force, a = contact.force[0], contact.radius[0]
    solution = twisted(bed, Depth(depth), Angle([0.2048898680 * MU * force / (G * a * a)]))
    assert solution.stick_radius[0] / a == pytest.approx(0.5, rel=2e-9)
    assert solution.torque[0] / (MU * force * a) == pytest.approx(0.4364065089, abs=2e-10)


def test_flat_punch_slips_beyond_an_angle_of_its_own():
    a, force = 0.01, 1e-4
    unit = MU * force / (G * a * a)
    bed = Foundation(FlatPunch(a), MEDIUM)
    solution = twisted(
        bed, Force(force), Angle(np.array([0.1249, float(punch_twist(0.999)), float(punch_twist(0.3))]) * unit)
    )
    assert solution.stick_radius / a == pytest.approx([1.0, 0.999, 0.3], rel=1e-10)
    stuck = float(rigid_twist_torque(a, 0.1249 * unit, shear_modulus=G))
    assert solution.torque[0] == pytest.approx(stuck, rel=1e-12)
    assert solution.dissipation[0] == 0.0
    assert solution.stored_energy[0] == pytest.approx(0.5 * stuck * 0.1249 * unit, rel=1e-12)


def test_masing_and_wiping_out():
    top = 0.3 * TWIST
    back = np.array([0.2, 0.0, -0.15]) * TWIST
    solution = twisted(BALL, Force(F), Angle([top, *back, top, 0.4 * TWIST]))
    half = twisted(BALL, Force(F), Angle((top - back) / 2.0))
    for i in range(3):
        single = twisted(BALL, Force(F), Angle([(top - back[i]) / 2.0]))
        assert solution.torque[1 + i] == pytest.approx(solution.torque[0] - 2.0 * single.torque[0], abs=1e-12 * MOMENT)
    assert half.torque[0] > 0.0
    assert solution.torque[4] == pytest.approx(solution.torque[0], rel=1e-12)  # the loop has closed
    first = twisted(BALL, Force(F), Angle([0.4 * TWIST]))
    assert solution.torque[5] == pytest.approx(first.torque[0], rel=1e-12)  # and is forgotten
    assert len(solution.at(5).springs.memory.pieces) == 2
    assert solution.nested.all()


def test_loss_per_cycle_is_the_area_of_the_loop():
    nodes, weights = np.polynomial.legendre.leggauss(30)
    top = 0.25 * TWIST
    # on each branch the torque starts like the power 3/2 of the twist: a cube in between lets the rule converge
    share = (0.5 * (1.0 + nodes)) ** 3
    jacobian = 0.5 * weights * 3.0 * (0.5 * (1.0 + nodes)) ** 2
    down, up = top - 2.0 * top * share, -top + 2.0 * top * share
    solution = twisted(BALL, Force(F), Angle([top, *down, -top, *up, top]))
    area = -2.0 * top * np.sum(jacobian * solution.torque[1:31]) + 2.0 * top * np.sum(jacobian * solution.torque[32:62])
    assert solution.dissipation[-1] - solution.dissipation[0] == pytest.approx(area, rel=1e-7)
    assert solution.stored_energy[-1] == pytest.approx(solution.stored_energy[0], rel=1e-12)


def bound_of_ball(x, a, mu):
    """Lubkin's 4 mu p0 [K - E], over x."""
    inside = x < a
    share = np.where(inside, (x / a) ** 2, 1.0)
    return np.where(
        inside, 8.0 * mu * MEDIUM.modulus * a / (math.pi * R) * (ellipkm1(share) - ellipe(1.0 - share)), 0.0
    )


def springs_one_by_one(depths, angles, count, parts):
    """Move springs at midpoints along straight lines in many small parts; return torques, stored and lost energies."""
    widest = math.sqrt(max(depths) * R)
    x = (np.arange(count) + 0.5) * widest / count
    h, depth, angle, lost = np.zeros(count), 0.0, 0.0, 0.0
    solutions = []
    for to_depth, to_angle in [(depths[0], 0.0), *zip(depths, angles, strict=True)]:
        track = zip(
            np.linspace(depth, to_depth, parts + 1)[1:], np.linspace(angle, to_angle, parts + 1)[1:], strict=True
        )
        for d, phi in track:
            before = bound_of_ball(x, math.sqrt(max(depth, 0.0) * R) or 1e-30, MU)
            after = bound_of_ball(x, math.sqrt(max(d, 0.0) * R) or 1e-30, MU)
            gap = x * x / R
            share = np.clip((d - gap) / (d - depth), 0.0, 1.0) if d > depth else np.ones(count)
            trial = np.where(gap < max(d, depth), h + 8.0 * G * (phi - angle) * np.where(gap < depth, 1.0, share), 0.0)
            now = np.clip(trial, -after, after)
            lost += float(np.sum(0.5 * (np.minimum(np.abs(trial), before) + after) * np.abs(trial - now) * x * x))
            h, depth, angle = now, d, phi
        size = widest / count
        solutions.append(
            (2.0 * np.sum(x * x * h) * size, np.sum(x * x * h * h) * size / (8.0 * G), lost * size / (4.0 * G))
        )
    return np.array(solutions[1:]).T


HISTORY = (
    np.array([1.0, 1.5, 1.2, 0.7, 1.1, 1.6]) * A**2 / R,
    np.array([0.2, 0.3, 0.35, 0.38, 0.1, -0.3]) * TWIST,
)


@pytest.mark.slow
def test_any_history_is_what_springs_one_by_one_do():
    solution = twisted(BALL, Depth(HISTORY[0]), Angle(HISTORY[1]))
    torque, stored, lost = springs_one_by_one(*HISTORY, count=2500, parts=150)
    assert solution.torque == pytest.approx(torque, abs=2e-6 * MOMENT)
    assert solution.stored_energy == pytest.approx(stored, rel=1e-4)
    assert solution.dissipation == pytest.approx(lost, rel=3e-3)
    assert solution.nested.all()


@pytest.mark.slow
def test_springs_one_by_one_approach_it_with_the_square_of_their_number():
    exact = twisted(BALL, Depth(HISTORY[0]), Angle(HISTORY[1])).torque
    off = [np.linalg.norm(springs_one_by_one(*HISTORY, count=n, parts=1)[0] - exact) for n in (200, 800)]
    assert off[1] < off[0] / 8.0  # one move per line is exact, and midpoint springs are of second order at kinks


@pytest.mark.slow
def test_one_move_along_a_line_is_as_good_as_many():
    depths, angles = HISTORY
    times = np.linspace(0.0, 5.0, 101)
    fine = twisted(BALL, Depth(np.interp(times, range(6), depths)), Angle(np.interp(times, range(6), angles)))
    coarse = twisted(BALL, Depth(depths), Angle(angles))
    assert fine.torque[::20] == pytest.approx(coarse.torque, abs=1e-12 * MOMENT)
    assert fine.dissipation[::20] == pytest.approx(coarse.dissipation, rel=1e-6)


def test_growing_load_sticks_until_the_edge_is_wide_enough():
    """In proportion to the depth a twist slides first where a = mu E* / (4 G_t dphi/dd)."""
    rate = 0.25 * MU * MEDIUM.modulus / (G * A)
    depths = np.array([0.25, 0.98, 1.44]) * A**2 / R
    solution = twisted(BALL, Depth([0.0, *depths]), Angle([0.0, *(rate * depths)]))
    assert solution.dissipation[:3].tolist() == [0.0, 0.0, 0.0]
    assert solution.stick_radius[1:3] == pytest.approx(solution.radius[1:3], rel=1e-12)
    assert solution.dissipation[3] > 0.0
    assert solution.stick_radius[3] < solution.radius[3]
    # stuck from first touch on: h = 8 G rate (d - g), M = 2 int x^2 h
    a = solution.radius[2]
    assert solution.torque[2] == pytest.approx(16.0 * G * rate / R * (a**5 / 3.0 - a**5 / 5.0), rel=1e-11)


def test_loss_and_regain_of_contact():
    depths = np.array([1.0, -0.5, 1.0]) * A**2 / R
    solution = twisted(BALL, Depth(depths), Angle([0.2 * TWIST, 0.2 * TWIST, 0.2 * TWIST]))
    assert solution.torque[1:] == pytest.approx([0.0, 0.0], abs=1e-12 * MOMENT)
    assert solution.radius[1] == 0.0
    # what was stored is lost
    assert solution.dissipation[1] == pytest.approx(solution.stored_energy[0] + solution.dissipation[0], rel=1e-9)


def test_without_slip_springs_lose_what_they_store_when_they_part():
    depth, rise = A**2 / R, 0.01
    solution = twisted(BALL, Depth([depth, depth / 4.0]), Angle([rise, rise]), mu=math.inf)
    assert solution.torque == pytest.approx(16.0 / 3.0 * G * np.array([A, A / 2]) ** 3 * rise, rel=1e-12)
    lost = 0.5 * 16.0 / 3.0 * G * A**3 * (1.0 - 1.0 / 8.0) * rise**2
    assert solution.dissipation[1] == pytest.approx(lost, rel=1e-12)


def test_without_friction_nothing_is_borne():
    solution = twisted(BALL, Force(F), Angle([0.1, -0.1]), mu=0.0)
    assert solution.torque.tolist() == [0.0, 0.0]
    assert solution.dissipation.tolist() == [0.0, 0.0]
    assert solution.stick_radius.tolist() == [0.0, 0.0]


@pytest.mark.slow
def test_a_torque_under_a_changing_load():
    """Under a growing force the torque stays below the first limit; the path to it is cut until the angle settles."""
    solution = twisted(BALL, Force(np.array([1.0, 2.0]) * F), Torque(np.array([0.3, 0.7]) * MOMENT))
    times = np.linspace(0.0, 1.0, 9)
    fine = twisted(BALL, Force(F * (1.0 + times)), Torque(MOMENT * (0.3 + 0.4 * times)))
    assert solution.angle[-1] == pytest.approx(fine.angle[-1], abs=3e-4 * TWIST)
    assert solution.torque == pytest.approx(np.array([0.3, 0.7]) * MOMENT, rel=1e-10)


def test_a_falling_load_and_a_twist_that_turns_back_are_marked():
    depths = np.array([1.0, 0.8]) * A**2 / R
    solution = twisted(BALL, Depth(depths), Angle(np.array([0.3, 0.246]) * TWIST))
    assert solution.nested.tolist() == [True, False]
    assert any(
        note.standing is Standing.APPROXIMATE and "during reversal" in note.statement for note in solution.validity
    )


@pytest.mark.slow
def test_solve_gathers_the_steps():
    problem = Torsion(BALL, Coulomb(MU), Path(np.arange(6), Depth(HISTORY[0]), Angle(HISTORY[1])))
    solution = problem.solve()
    assert tuple(problem.steps()) == solution.states
    assert [state.torque for state in solution.states] == solution.torque.tolist()
    assert solution.at(-1) == solution.states[-1]
    with pytest.raises(InvalidInput, match="no point 6"):
        solution.at(6)


DEPTHS = st.floats(-0.2, 1.5)


@pytest.mark.slow
@settings(max_examples=5, deadline=None, derandomize=True)
@given(
    st.lists(st.tuples(DEPTHS, st.floats(-0.6, 0.6)), min_size=2, max_size=3),
)
def test_no_energy_comes_from_nowhere(points):
    depths, angles = np.array(points).T
    solution = twisted(BALL, Depth(depths * A**2 / R), Angle(angles * TWIST))
    steps = np.diff(np.concatenate([[0.0], solution.dissipation]))
    assert np.all(steps >= 0.0)
    assert np.all(np.abs(solution.torque) <= solution.torque_limit * (1.0 + 1e-12))
    there_and_apart = twisted(
        BALL, Depth([*(depths * A**2 / R), -1e-6]), Angle([*(angles * TWIST), angles[-1] * TWIST])
    )
    assert there_and_apart.stored_energy[-1] == 0.0


def test_the_surface_sticks_and_slides_where_stated():
    state = twisted(BALL, Force(F), Angle([0.3 * TWIST])).at(0)
    inner, ring = np.linspace(0.0, 0.95, 9) * state.stick_radius, np.linspace(1.02 * state.stick_radius, 0.98 * A, 9)
    assert state.turning(inner) == pytest.approx(state.angle * inner, rel=1e-8, abs=1e-14 * A)
    pressure = 2.0 * MEDIUM.modulus * A / (math.pi * R) * np.sqrt(1.0 - (ring / A) ** 2)
    assert state.traction(ring) == pytest.approx(MU * pressure, rel=1e-8)
    held = state.traction(inner)
    assert np.all(held <= MU * 2.0 * MEDIUM.modulus * A / (math.pi * R) * np.sqrt(1.0 - (inner / A) ** 2))
    assert np.all(state.turning(ring) < state.angle * ring)
    torque = 2.0 * math.pi * quad(lambda r: r * r * float(state.traction(np.array([r]))[0]), 0.0, state.stick_radius)[0]
    torque += 2.0 * math.pi * quad(lambda r: r * r * float(state.traction(np.array([r]))[0]), state.stick_radius, A)[0]
    assert torque == pytest.approx(state.torque, rel=1e-6)
    assert state.traction(np.array([2.0 * A]))[0] == 0.0


def test_a_truncated_cone_slides_with_its_pressure():
    """Where the profile has an edge the load of the springs has a kink, and the traction a peak."""
    bed = Foundation(TruncatedCone(half_angle=1.5, flat_radius=0.004), MEDIUM)
    contact = twisted(bed, Depth(1e-3), Angle([0.0])).at(0)
    unit = MU * contact.force / (G * contact.radius**2)
    state = twisted(bed, Depth(1e-3), Angle([0.6 * unit])).at(0)
    assert state.stick_radius < 0.004
    ring = np.array([0.0041, 0.0055, 0.9 * state.radius])
    pressure = MEDIUM.pressure(PressedSprings(bed, state.depth, state.radius), ring)
    assert state.traction(ring) == pytest.approx(MU * pressure, rel=1e-7)


def test_below_the_surface_by_direct_quadrature():
    state = twisted(BALL, Force(F), Angle([0.3 * TWIST])).at(0)
    shear = MEDIUM.first.shear
    core = state.stick_radius

    def load(t):
        stuck = 8.0 * G * state.angle * t
        return stuck if t < core else t * float(bound_of_ball(np.array([t]), A, MU)[0])

    for r, z in ((0.5 * A, 0.3 * A), (1.3 * A, 0.2 * A), (0.005 * A, 0.5 * A)):

        def radius(t, r=r, z=z):
            return np.sqrt(r * r + (z + 1j * t) ** 2)

        kernels = (
            lambda t: ((z + 1j * t) / radius(t)).imag / (2.0 * math.pi * r * shear),  # noqa: B023
            lambda t: (1.0 / radius(t) ** 3).imag * r / (2.0 * math.pi),  # noqa: B023
            lambda t: (-2.0 * (z + 1j * t) / radius(t) / r**2 - (z + 1j * t) / radius(t) ** 3).imag / (2.0 * math.pi),  # noqa: B023
        )
        below = state.below(r, z)
        for result, kernel in zip(below, kernels, strict=True):
            halves = ((0.0, core), (core, A))
            direct = sum(quad(lambda t: load(t) * kernel(t), *ends, epsrel=1e-10)[0] for ends in halves)  # noqa: B023
            scale = abs(direct) + 1e-4 * abs(float(below.axial_twist_stress))
            assert float(result) == pytest.approx(direct, abs=1e-7 * scale)


def test_below_the_surface_meets_the_surface():
    state = twisted(BALL, Force(F), Angle([0.3 * TWIST])).at(0)
    r = np.array([0.3, 0.8]) * A
    below = state.below(r, 1e-5 * A)
    assert -below.axial_twist_stress == pytest.approx(state.traction(r), rel=1e-3)
    first, second = MEDIUM.first.shear, MEDIUM.second.shear
    assert below.hoop_displacement * (1.0 + first / second) == pytest.approx(state.turning(r), rel=1e-3)
    above = state.below(r, -1e-5 * A)
    assert above.hoop_displacement == pytest.approx(-below.hoop_displacement * first / second, rel=1e-9)
    assert above.axial_twist_stress == pytest.approx(below.axial_twist_stress, rel=1e-9)


def test_a_transversely_isotropic_body_meets_a_twist_with_its_own_modulus():
    body = TransverselyIsotropic(c11=10.0, c12=4.0, c13=3.5, c33=12.0, c44=3.0)
    medium = TransverselyIsotropicHalfSpace(body)
    assert medium.torsional_modulus == pytest.approx(3.0, rel=1e-15)  # C66 = 3 = C44
    soft = TransverselyIsotropicHalfSpace(TransverselyIsotropic(c11=5.0, c12=2.0, c13=2.2, c33=20.0, c44=1.2))
    assert soft.torsional_modulus == pytest.approx(math.sqrt(1.5 * 1.2), rel=1e-15)
    solution = twisted(Foundation(FlatPunch(0.01), soft), Force(1.0), Angle([1e-3]), mu=math.inf)
    assert solution.torque[0] == pytest.approx(16.0 / 3.0 * math.sqrt(1.8) * 1e-6 * 1e-3, rel=1e-12)


def test_what_is_refused():
    with pytest.raises(InvalidInput, match="prescribes a Shift"):
        Torsion(BALL, Coulomb(MU), Path([0.0], Force(F), Shift(0.0)))
    with pytest.raises(InvalidInput, match="give Coulomb"):
        Torsion(BALL, 0.3, Path([0.0], Force(F), Angle(0.0)))
    with pytest.raises(OutsideValidity, match="a Paraboloid; slip annuli of a twisted contact are implemented for"):
        twisted_medium(Paraboloid(R))
    gibson = Foundation(Paraboloid(R), GradedHalfSpace(PowerLawGraded(1.0, 1.0, exponent=1.0, poisson=0.5)))
    with pytest.raises(OutsideValidity, match="does not resist a twist"):
        Torsion(gibson, Coulomb(MU), Path([0.0], Force(F), Angle(0.0))).solve()


def test_a_punch_that_sticks_all_over_has_reissners_traction():
    """tau = (4 G_t phi / pi) r / sqrt(a^2 - r^2), near the axis too."""
    bed = Foundation(FlatPunch(radius=0.002), MEDIUM)
    angle = 1e-6
    state = Torsion(bed, Coulomb(0.4), Path([0.0, 1.0], Force(100.0), Angle([0.0, angle]))).solve().at(1)
    r = np.array([1e-9, 1e-5, 0.0005, 0.0015, 0.00199])
    exact = 4.0 / np.pi * MEDIUM.torsional_modulus * angle * r / np.sqrt(0.002**2 - r**2)
    np.testing.assert_allclose(state.traction(r), exact, rtol=1e-10)


@pytest.mark.slow
def test_what_slides_inside_of_what_sticks_is_noted_with_its_excess():
    """Twisted almost to the limit, then half unloaded and half turned back: about 5 % at r = 0.63 a."""
    bed = Foundation(Paraboloid(0.01), MEDIUM)
    limit = Torsion(bed, Coulomb(0.4), Path([0.0], Force(10.0), Torque(0.0))).solve().torque_limit[0]
    held = Torsion(bed, Coulomb(0.4), Path([0.0, 1.0], Force(10.0), Torque([0.0, 0.9 * limit]))).solve()
    turn = held.angle[1]
    back = Path([0.0, 1.0, 2.0], Force([10.0, 10.0, 5.0]), Angle([0.0, turn, 0.5 * turn]))
    statements = [note.statement for note in Torsion(bed, Coulomb(0.4), back).solve().validity]
    assert any("From index 2 on" in one and re.search(r"by up to (4\.[5-9]|5\.[0-4])%", one) for one in statements)
    steady = Path([0.0, 1.0, 2.0], Force([10.0, 10.0, 5.0]), Angle([0.0, turn, 0.0]))
    assert not any(
        "sticking springs outside" in note.statement for note in Torsion(bed, Coulomb(0.4), steady).solve().validity
    )


def test_a_program_without_a_stated_start_begins_untwisted():
    """Rubber fingertip, 3 pi/16 mu F a = 5.712 mN m."""
    bed = Foundation(Paraboloid(10e-3), HalfSpace.between(Elastic(2e6, 0.49)))
    path = Program([Start(Force(5.0)), Ramp(lateral=Angle(2.0), count=10)])
    answer = Torsion(bed, Coulomb(0.8), path).solve()
    assert answer.torque[0] == 0.0
    assert answer.torque[-1] == pytest.approx(5.712e-3, rel=1e-4)
