"""Bulk stress beside any line contact: edges that slip back, other profiles, out of phase, normal forces that vary."""

from __future__ import annotations

import numpy as np
import pytest
from half_plane_march import HalfPlaneMarch
from scipy.optimize import fsolve

import winkler as wk
from winkler.problems.line_friction.marched_states import LineMarchedState
from winkler.problems.line_friction.states import LineTangentialState

UNIT = wk.HalfSpace.between(wk.Elastic(2.0, 0.0), wk.Elastic(2.0, 0.0))
"""E* = 1; the strain of the first surface is half of the bulk stress."""
MU = 0.4
CYLINDER = wk.LineFoundation(wk.Paraboloid(1.0), UNIT)
ROUNDED = wk.LineFoundation(wk.RoundedPunch(flat_radius=0.5, edge_radius=1.0), UNIT)
WIDTH = np.sqrt(4.0 / np.pi)


def problem(bed, path):
    return wk.LineTangential(bed, wk.Coulomb(MU), path)


def marched(bed, path):
    """Return the solution by the march, also where sums of earlier contacts hold."""
    return wk.LineTangential(bed, wk.Coulomb(MU), path, wk.Method.ELEMENTS).solve()


def over(low, high, count):
    """Return Gauss-Legendre places and weights from low to high, with roots at both ends mapped away."""
    node, weight = np.polynomial.legendre.leggauss(count)
    half = 0.5 * (high - low)
    places = 0.5 * (low + high) + half * np.sin(0.5 * np.pi * node)
    return places, 0.5 * np.pi * half * np.cos(0.5 * np.pi * node) * weight


STEADY = wk.LinePath(1.0, [0.0, 0.25, -0.2, 0.1])
VARYING = wk.LinePath([1.0, 1.0, 1.4, 0.8, 1.2], [0.0, 0.25, 0.1, -0.1, 0.15])


@pytest.mark.parametrize(
    ("bed", "path", "most"),
    [
        (CYLINDER, STEADY, 5e-5),
        *(
            pytest.param(*row, marks=pytest.mark.slow)
            for row in ((CYLINDER, VARYING, 1.5e-4), (ROUNDED, STEADY, 1.5e-4), (ROUNDED, VARYING, 1e-4))
        ),
    ],
)
def test_without_a_bulk_stress_the_march_is_the_sum_of_earlier_contacts(bed, path, most):
    """Loss, shift and slip (root of the mean square) are compared; the sums are exact."""
    exact, near = problem(bed, path).solve(), marched(bed, path)
    lossy = exact.dissipation_per_length > 0.0
    lost = near.dissipation_per_length[lossy] / exact.dissipation_per_length[lossy] - 1.0
    assert np.max(np.abs(lost)) < most
    assert near.slip_shift == pytest.approx(exact.slip_shift, abs=most * np.max(np.abs(exact.slip_shift)))
    assert near.stick_half_width == pytest.approx(exact.stick_half_width, abs=1.2e-3)
    share = np.linspace(-0.96, 0.96, 49)
    pairs = [[one.slip(one.half_width * share) for one in pair] for pair in zip(exact.states, near.states, strict=True)]
    off = np.array([one - other for one, other in pairs])
    assert np.sqrt(np.mean(off**2)) < 1.2e-4 * np.max(np.abs(pairs))


@pytest.mark.slow
def test_in_phase_the_march_finds_the_strips_of_nowell_and_hills():
    path = wk.LinePath(1.0, [0.0, 0.25, -0.25, 0.1], bulk_stress=0.28)
    exact, near = problem(CYLINDER, path).solve(), marched(CYLINDER, path)
    assert isinstance(exact.at(0), LineTangentialState)
    assert near.dissipation_per_length[1:] == pytest.approx(exact.dissipation_per_length[1:], rel=1e-4)
    assert near.stick_middle == pytest.approx(exact.stick_middle, abs=6e-4)
    assert near.stick_half_width == pytest.approx(exact.stick_half_width, abs=6e-4)


@pytest.mark.few(1)
@pytest.mark.parametrize("bulk", [0.1, 0.3])
def test_what_sticks_under_other_profiles_is_a_tilted_contact(bulk):
    """f = x^4, in phase: on m - c < x < m + c the mean of f' is strain/mu, and its first harmonic bears P - Q/mu."""
    shear, tilt, kept = 0.2, 0.5 * bulk / MU, 1.0 - 0.2 / MU
    middle, half = fsolve(
        lambda v: [
            4.0 * (v[0] ** 3 + 1.5 * v[0] * v[1] ** 2) - tilt,
            2.0 * np.pi * v[1] ** 2 * (1.5 * v[0] ** 2 + 0.375 * v[1] ** 2) - kept,
        ],
        [0.1, 0.6],
    )
    bed = wk.LineFoundation(wk.PowerLaw(coefficient=1.0, exponent=4.0), UNIT)
    state = problem(bed, wk.LinePath(1.0, [0.0, shear], bulk_stress=bulk)).solve().at(-1)
    assert abs(middle) + half < state.half_width  # no edge slips back
    assert state.stick_middle == pytest.approx(middle, abs=1e-3)
    assert state.stick_half_width == pytest.approx(half, abs=1e-3)


@pytest.mark.parametrize(
    ("shears", "bulks"),
    [
        pytest.param([0.0, 0.25, -0.25, 0.1], [0.0, 0.6, -0.6, 0.24], marks=pytest.mark.slow),  # an edge slips back
        ([0.0, 0.0, 0.2, 0.2, -0.3], [0.0, 0.4, 0.4, -0.3, 0.1]),  # one after the other
    ],
)
def test_edges_that_slip_back_are_those_of_other_elements(shears, bulks):
    """The reference is code of the tests, on elements of other widths and with other steps."""
    state = problem(CYLINDER, wk.LinePath(1.0, shears, bulk_stress=bulks)).solve().at(-1)
    march, parts = HalfPlaneMarch(WIDTH * np.sin(0.5 * np.pi * np.linspace(-1.0, 1.0, 301)), MU, 1.0), 10
    for shear, after, bulk, stress in zip(shears, shears[1:], bulks, bulks[1:], strict=False):
        for part in (np.arange(parts) + 1.0) / parts:
            march.go(1.0, shear + part * (after - shear), 0.5 * (bulk + part * (stress - bulk)), part < 1.5 / parts)
    x = 0.96 * WIDTH * np.linspace(-1.0, 1.0, 25)
    ahead = state.slip(x)
    assert np.interp(x, march.x, march.ahead) - np.interp(0.0, march.x, march.ahead) == pytest.approx(
        ahead - state.slip(0.0), abs=1e-3 * np.ptp(ahead)
    )
    assert state.dissipation_per_length == pytest.approx(march.lost, rel=1e-3)


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_steady_state_sticks_as_andresen_and_others_say(sign):
    """All of P, Q and the bulk stress oscillate: the means of P less dQ/(2 mu) bears what sticks, tilted by d sigma."""
    forces, shears = [1.0, *[1.1, 0.9] * 2], [0.0, *[0.05 + sign * 0.15, 0.05 - sign * 0.15] * 2]
    bulks = [0.0, *[0.25, 0.15] * 2]
    solution = problem(CYLINDER, wk.LinePath(forces, shears, bulk_stress=bulks)).solve()
    left = np.max((solution.stick_middle - solution.stick_half_width)[-2:])
    right = np.min((solution.stick_middle + solution.stick_half_width)[-2:])
    assert 0.5 * (right - left) == pytest.approx(np.sqrt(4.0 / np.pi * (1.0 - 0.3 / (2.0 * MU))), rel=5e-3)
    assert 0.5 * (right + left) == pytest.approx(sign * 0.5 * 0.1 / (2.0 * MU), rel=0.05)


HISTORIES = [("cylinder", CYLINDER, 0.2, 4), ("rounded punch", ROUNDED, 0.2, 5)]
HISTORIES += [("wedge", wk.LineFoundation(wk.Cone(1.5), UNIT), 0.01, 4)]


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize(("bed", "stress", "points"), [pytest.param(*row[1:], id=row[0]) for row in HISTORIES])
def test_no_history_creates_energy(bed, stress, points):
    for seed in range(3):
        random = np.random.default_rng(seed)
        forces = random.uniform(0.5, 1.0, points)
        shears, bulks = MU * forces * random.uniform(-1.0, 1.0, points), random.normal(0.0, stress, points)
        path = wk.LinePath(forces, shears, bulk_stress=bulks)
        solution = problem(bed, path).solve()
        assert np.all(np.diff(solution.dissipation_per_length) >= 0.0)
        state, x = solution.at(-1), np.linspace(-0.99, 0.99, 40) * solution.half_width[-1]
        assert isinstance(state, LineMarchedState)
        assert np.all(np.abs(state.traction(x)) <= MU * state.pressure(x) * (1.0 + 1e-9))


@pytest.mark.slow
def test_forces_and_bulk_stress_do_the_work_that_is_lost():
    """Over a closed cycle out of phase: the integral of Q over the shift, and of the tractions over the strain."""
    turn = np.linspace(0.0, 4.0 * np.pi, 161)
    path = wk.LinePath(1.0, 0.2 * np.sin(turn), bulk_stress=0.3 * np.sin(turn + 1.0))
    solution = problem(CYLINDER, path).solve()
    places, weights = over(-WIDTH, WIDTH, 200)
    moments = np.array([weights @ (state.traction(places) * places) for state in solution.states[80:]])
    work = np.trapezoid(solution.shear_force_per_length[80:], solution.slip_shift[80:])
    work -= np.trapezoid(moments, 0.5 * solution.bulk_stress[80:])
    lost = solution.dissipation_per_length[-1] - solution.dissipation_per_length[80]
    assert work == pytest.approx(lost, rel=3e-3)
    spread = solution.friction_work(places)
    assert weights @ spread == pytest.approx(solution.dissipation_per_length[-1], rel=2e-3)


@pytest.mark.few(1)
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_stresses_below_a_marched_contact_are_those_of_line_loads(side):
    """Flamant's radial stresses summed over pressure and traction; the bulk stress beside them."""
    state = problem(CYLINDER, wk.LinePath(1.0, [0.0, 0.25], bulk_stress=[0.0, 0.6])).solve().at(-1)
    assert isinstance(state, LineMarchedState)
    s, weight = over(-state.half_width, state.half_width, 500)
    p, q = state.pressure(s) * weight, side * state.traction(s) * weight
    for x, z in ((0.3, 0.2), (-0.9, 0.1), (2.0, 0.5), (60.0, 30.0)):
        radius = (x - s) ** 2 + z * z
        load = (-2.0 / np.pi) * (p * z + q * (x - s)) / radius**2
        fields = state.stresses(x, side * z)
        bulk = 0.6 if side > 0.0 else 0.0
        size = 1e-3 * np.abs(p @ np.ones(s.size)) / (abs(x) + z)
        assert fields.xx_stress - bulk == pytest.approx(np.sum(load * (x - s) ** 2), abs=size)
        assert fields.zz_stress == pytest.approx(np.sum(load * z * z), abs=size)
        assert fields.xz_stress == pytest.approx(np.sum(load * (x - s) * z), abs=size)


def test_a_bulk_stress_that_lets_hardly_anything_stick_is_refused():
    with pytest.raises(wk.OutsideValidity, match="makes all of the contact slip outwards or inwards"):
        problem(CYLINDER, wk.LinePath(1.0, 0.0, bulk_stress=[0.0, 6.0])).solve()


def test_an_array_states_the_bulk_stress_at_every_point():
    path = wk.LinePath(1.0, [0.0, 0.2, -0.1], bulk_stress=[0.0, 0.1, -0.05], count=2)
    assert path.bulk == pytest.approx([0.0, 0.05, 0.1, 0.025, -0.05])
    assert path.in_phase
    assert isinstance(problem(CYLINDER, path).solve().at(-1), LineTangentialState)
    assert not wk.LinePath(1.0, [0.0, 0.2], bulk_stress=[0.1, 0.1]).in_phase
    with pytest.raises(wk.InvalidInput, match=r"and the bulk stress \(2,\); give one number for each point"):
        wk.LinePath(1.0, [0.0, 0.2, 0.1], bulk_stress=[0.0, 0.1])
