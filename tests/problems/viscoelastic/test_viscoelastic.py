"""Viscoelastic contacts: closed forms, Ting, the Lee-Radok integral in three dimensions, brute force, and energy."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad
from scipy.optimize import brentq

import winkler as wk
from winkler.loading.loads import Depth, Force
from winkler.loading.path import Path
from winkler.materials.fractional import PowerLawSolid
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.materials.viscoelastic import GeneralisedKelvin, Prony
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.values.errors import InvalidInput, OutsideValidity

MAXWELL = Maxwell(0.25, 0.3)
STANDARD = StandardSolid(0.05, 0.2, 0.3)
VOIGT = KelvinVoigt(0.25, 0.075)
"""Each with E* = 1 Pa, of the glassy solid or, Kelvin-Voigt, the relaxed one; tau = 0.3 s."""


def bed(solid, profile=None) -> wk.Foundation:
    return wk.Foundation(wk.Paraboloid(1.0) if profile is None else profile, ViscoelasticHalfSpace(solid))


def pressed(solid, time, load, profile=None, **more):
    return ViscoelasticIndentation(bed(solid, profile), Path(time, load), **more).solve()


TURN = np.array([0.0, 0.5, 1.0, 1.1, 1.2, 1.4, 1.7])
TRIANGLE = np.where(TURN < 1.0, TURN, 2.0 - TURN)


@pytest.mark.parametrize(
    ("solid", "forces", "radii"),
    [
        (MAXWELL, [0.0, 0.26465, 0.48812, 0.18571, 0.00120, 0.0, 0.0], [0.92138, 0.33849, 0.0]),
        (STANDARD, [0.0, 0.30600, 0.65716, 0.37607, 0.18017, 0.00082, 0.0], [0.93127, 0.80255, 0.14335]),
    ],
)
def test_triangles(solid, forces, radii):
    result = pressed(solid, TURN, Depth(TRIANGLE), count=2000)
    assert result.force == pytest.approx(forces, abs=5.1e-6)
    assert result.radius[3:6] == pytest.approx(radii, abs=5.1e-6)


def test_the_error_falls_with_the_square_of_the_springs():
    t = np.linspace(0.0, 1.3, 131)
    depths = Depth(np.where(t < 1.0, t, 2.0 - t))
    best = pressed(MAXWELL, t, depths, count=6400).force
    errors = np.array([np.abs(pressed(MAXWELL, t, depths, count=n).force - best).max() for n in (100, 200, 400, 800)])
    assert np.all(errors[:-1] > 3.5 * errors[1:])
    assert errors[-1] < 1e-6


def ting(series, t_max, t):
    """Return t1, when the contact was last as wide during loading: the integral of E(t - s) d'(s) from t1 to t is 0."""

    def weight(t1):
        rising = quad(lambda s: float(series.at(np.array(t - s))), t1, t_max, epsabs=1e-13)[0]
        falling = quad(lambda s: float(series.at(np.array(t - s))), t_max, t, epsabs=1e-13)[0]
        return rising - falling

    return brentq(weight, 0.0, t_max, xtol=1e-12)


@pytest.mark.few(3)
@pytest.mark.parametrize(
    "solid", [MAXWELL, STANDARD, Prony(0.05, [0.1, 0.1], [0.05, 1.0])], ids=["Maxwell", "standard", "two times"]
)
@pytest.mark.parametrize("shape", [wk.Paraboloid(1.0), wk.Cone(1.2)], ids=["ball", "cone"])
def test_ting(solid, shape):
    """During unloading the contact is as wide as it was at t1, and the force is that of the path up to t1."""
    where = np.array([1.02, 1.05, 1.1])
    result = pressed(
        solid, np.array([0.0, 1.0, *where]), Depth(np.array([0.0, 1.0, *(2.0 - where)])), shape, count=3000
    )
    series = ViscoelasticHalfSpace(solid).relaxation
    elastic = wk.Foundation(shape, wk.HalfSpace(wk.Elastic(1.0, 0.0)))
    for i, t in enumerate(where, start=2):
        t1 = ting(series, 1.0, t)
        widest = wk.Indentation(elastic, Depth(t1)).solve()
        assert result.radius[i] == pytest.approx(widest.radius, rel=3e-5)

        def rate(s):
            return wk.Indentation(elastic, Depth(float(s))).solve().stiffness

        force = quad(lambda s, t=t: float(series.at(np.array(t - s))) * rate(s), 0.0, t1, epsabs=1e-9)[0]
        assert result.force[i] == pytest.approx(force, rel=2e-6)


def test_ting_of_a_power_law():
    alpha = 0.3
    solid = PowerLawSolid(1.0, 1.0, alpha, shortest=1e-5, longest=10.0, tolerance=1e-6)
    t = np.array([0.0, 0.5, 1.0, 1.1, 1.2])
    result = pressed(solid, t, Depth(np.where(t < 1.0, t, 2.0 - t)), count=1500)
    glassy = 4.0  # E* of the shear 1, incompressible
    loading = 2.0 * glassy * t[:3] ** (1.5 - alpha) * float(mp.beta(1.0 - alpha, 1.5))
    assert result.force[:3] == pytest.approx(loading, rel=2e-5)
    t1 = t[3:] - 2.0 ** (1.0 / (1.0 - alpha)) * (t[3:] - 1.0)
    assert result.radius[3:] == pytest.approx(np.sqrt(t1), rel=2e-5)


def test_kelvin_voigt_ball():
    t = np.array([0.0, 0.3, 0.7, 1.0, 1.2, 1.5, 1.65, 1.75])
    d = np.where(t <= 1.0, t, 2.0 - t)
    result = pressed(VOIGT, t, Depth(d), count=2000)
    tau = 0.3
    force = 4.0 / 3.0 * d[1:4] ** 1.5 + 2.0 * tau * np.sqrt(d[1:4])
    assert result.force[1:4] == pytest.approx(force, rel=2e-6)
    left = np.maximum(d[4:] - tau, 0.0)
    assert result.force[4:] == pytest.approx(4.0 / 3.0 * left**1.5, abs=2e-6)
    assert result.radius[4:] == pytest.approx(np.sqrt(left), abs=2e-5)


CREEP = {
    "Kelvin-Voigt": (VOIGT, lambda t: -np.expm1(-t / 0.3)),
    "Maxwell": (MAXWELL, lambda t: 1.0 + t / 0.3),
    "standard": (STANDARD, lambda t: 5.0 - 4.0 * np.exp(-t * 0.2 / 0.3)),
}


@pytest.mark.parametrize("name", CREEP)
def test_creep_under_a_constant_force(name):
    solid, creep = CREEP[name]
    t = np.array([0.0, 0.1, 0.5, 2.0])
    result = pressed(solid, t, Force(0.01), count=1000)
    assert result.radius[1:] == pytest.approx((0.0075 * creep(t[1:])) ** (1.0 / 3.0), rel=3e-6)
    assert result.depth[1:] == pytest.approx((0.0075 * creep(t[1:])) ** (2.0 / 3.0), rel=6e-6)


def test_steps_of_any_length_agree():
    """The motion within a step is exact: more points in between change nothing."""
    corners = np.array([0.0, 1.0, 1.5, 2.5])
    depths = np.array([0.0, 1.0, 0.55, 1.2])
    solid = Prony(0.05, [0.1, 0.05, 0.05], [1e-4, 0.1, 3.0])
    coarse = pressed(solid, corners, Depth(depths))
    fine = np.unique(np.concatenate([np.linspace(0.0, 2.5, 1777), corners]))
    many = pressed(solid, fine, Depth(np.interp(fine, corners, depths)))
    at = np.searchsorted(fine, corners)
    assert many.force[at] == pytest.approx(coarse.force, rel=1e-11, abs=1e-14)
    assert many.stored_energy[at] == pytest.approx(coarse.stored_energy, rel=1e-11, abs=1e-14)
    assert many.dissipation[at] == pytest.approx(coarse.dissipation, rel=1e-10, abs=1e-13)


def test_limits_are_elastic():
    t = np.array([0.0, 1.0, 2.0])
    elastic = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.0))), Depth(0.5)).solve()
    depth = Depth(np.array([0.0, 1.0, 0.5]))
    fast = pressed(StandardSolid(0.05, 0.2, 1e9), t, depth)
    slow = pressed(StandardSolid(0.25, 3.0, 1e-9), t, depth)
    for result in (fast, slow):
        assert result.force[2] == pytest.approx(elastic.force, rel=1e-5)
        assert result.radius[2] == pytest.approx(elastic.radius, rel=1e-5)
        assert abs(result.dissipation[2]) < 1e-6


def test_an_elastic_partner():
    """A stiff partner changes nothing, a soft one decides; in between bodies of one load add their creep."""
    t = np.array([0.0, 1.0])
    alone = pressed(STANDARD, t, Force(0.01)).depth
    for young, other in ((1e9, alone), (1e-4, None)):
        pair = wk.Foundation(wk.Paraboloid(1.0), ViscoelasticHalfSpace(STANDARD, wk.Elastic(young, 0.0)))
        result = ViscoelasticIndentation(pair, Path(t, Force(0.01))).solve().depth
        if other is None:
            other = np.full(2, (0.0075 / young) ** (2.0 / 3.0))
        assert result == pytest.approx(other, rel=2e-4)
    relaxation = ViscoelasticHalfSpace(MAXWELL, wk.Elastic(1.0, 0.0)).relaxation
    # a Maxwell solid behind a spring is a Maxwell solid of half the modulus and twice the time
    assert relaxation.at(np.array([0.0, 0.6])) == pytest.approx([0.5, 0.5 / math.e], rel=1e-12)


def hereditary(series, gaps, weights, times, depths):
    """March springs by their hereditary integral itself, step by step, first order: forces, and which are pressed."""
    moved = np.zeros((times.size, gaps.size))
    place, forces, held = np.zeros(gaps.size), [0.0], [np.zeros(gaps.size, dtype=bool)]
    glassy = float(series.at(np.array(0.0)))
    for n in range(1, times.size):
        before = (
            series.at(times[n] - 0.5 * (times[1:n] + times[: n - 1])) @ moved[1:n] if n > 1 else np.zeros(gaps.size)
        )
        free = place - before / glassy
        touch = depths[n] - gaps > free
        moved[n] = np.where(touch, depths[n] - gaps, free) - place
        place = place + moved[n]
        forces.append(float(weights @ np.where(touch, before + glassy * moved[n], 0.0)))
        held.append(touch)
    return np.array(forces), np.array(held)


@pytest.mark.parametrize(
    "solid", [MAXWELL, STANDARD, GeneralisedKelvin(1.0, [2.0, 5.0], [0.05, 0.7])], ids=["Maxwell", "standard", "Kelvin"]
)
def test_losing_touch_and_touching_again(solid):
    """The hereditary integral, extrapolated to steps of no length."""
    corners, depths = np.array([0.0, 0.4, 0.6, 0.8, 1.3]), np.array([0.0, 0.5, -0.3, 0.1, 0.6])
    marks = np.array([0.3, 0.44, 0.8, 1.0, 1.3])
    problem = ViscoelasticIndentation(
        bed(solid),
        Path(np.sort(np.append(corners, marks)), Depth(np.interp(np.sort(np.append(corners, marks)), corners, depths))),
        count=12,
    )
    states = {round(state.time, 6): state for state in problem.steps()}
    elastic = wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.0)))
    springs = wk.Springs.of(elastic, math.sqrt(0.6), 12)
    series = problem.bed.medium.relaxation
    solutions = []
    for steps in (1300, 2600):
        times = np.linspace(0.0, 1.3, steps + 1)
        forces, _ = hereditary(series, springs.gap, springs.stiffness, times, np.interp(times, corners, depths))
        solutions.append(forces[np.round(marks / 1.3 * steps).astype(int)])
    extrapolated = 2.0 * solutions[1] - solutions[0]
    result = np.array([states[round(mark, 6)].force for mark in marks])
    assert np.abs(extrapolated - solutions[1]).max() < 5e-3
    assert result == pytest.approx(extrapolated, abs=1.5e-4)


def lee_radok_pressure(solid, r, times, depths):
    """The pressure of a ball, from the elastic one by the hereditary integral in three dimensions; growing contact."""
    series = ViscoelasticHalfSpace(solid).relaxation

    def elastic(t):
        a2 = float(np.interp(t, times, depths))
        return 2.0 / math.pi * math.sqrt(max(a2 - r * r, 0.0))

    t_end = times[-1]
    first = float(np.interp(r * r, depths, times))
    # by parts: no derivative of the elastic pressure is needed
    slope = quad(
        lambda s: float(-(series.moduli / series.times * np.exp(-(t_end - s) / series.times)).sum()) * elastic(s),
        first, t_end, epsabs=1e-10, limit=200, points=[t for t in times[1:-1] if t > first],
    )[0]  # fmt: skip
    return series.glassy * elastic(t_end) + slope


@settings(max_examples=8, deadline=None)
@given(st.lists(st.tuples(st.floats(0.05, 1.0), st.floats(0.02, 0.5)), min_size=2, max_size=4))
def test_pressures_are_those_of_lee_and_radok(steps):
    times = np.concatenate([[0.0], np.cumsum([dt for dt, _ in steps])])
    depths = np.concatenate([[0.0], np.cumsum([change for _, change in steps])])
    solid = Prony(0.05, [0.1, 0.05], [0.1, 1.0])
    *_, last = ViscoelasticIndentation(bed(solid), Path(times, Depth(depths)), count=1500).steps()
    radius = math.sqrt(depths[-1])
    # the error falls with the power 3/2 of the distance of the springs over that from the edge
    for part, tolerance in ((0.0, 3e-5), (0.3, 3e-5), (0.7, 3e-5), (0.95, 5e-4)):
        exact = lee_radok_pressure(solid, part * radius, times, depths)
        assert float(last.pressure(part * radius)) == pytest.approx(exact, rel=tolerance)


def test_pressures_converge_at_the_edge():
    times, depths = np.array([0.0, 1.0, 2.0]), np.array([0.0, 0.5, 1.0])
    solid = Prony(0.05, [0.1, 0.05], [0.1, 1.0])
    places = np.linspace(0.93, 0.97, 15)  # where a place lies between two springs decides a lot
    exact = np.array([lee_radok_pressure(solid, r, times, depths) for r in places])
    errors = []
    for count in (500, 2000, 8000):
        *_, last = ViscoelasticIndentation(bed(solid), Path(times, Depth(depths)), count=count).steps()
        errors.append(np.abs(last.pressure(places) / exact - 1.0).max())
    assert errors[0] > 6.0 * errors[1] > 36.0 * errors[2]
    assert errors[2] < 3e-5


paths = st.lists(st.tuples(st.floats(0.01, 2.0), st.floats(-0.5, 1.0)), min_size=3, max_size=8)


@settings(max_examples=40, deadline=None)
@given(paths, st.sampled_from([MAXWELL, STANDARD, VOIGT, Prony(0.01, [0.1, 0.2], [0.01, 5.0], 0.02)]))
def test_energy_is_never_made(points, solid):
    times = np.concatenate([[0.0], np.cumsum([dt for dt, _ in points])])
    depths = np.concatenate([[0.0], [d for _, d in points]])
    if np.max(depths) <= 1e-6:
        depths[1] = 0.3
    found = pressed(solid, times, Depth(depths), count=60)
    assert np.all(np.diff(found.dissipation) > -1e-12)
    assert np.all(found.stored_energy >= 0.0)
    assert np.all(found.force >= -1e-12)


@settings(max_examples=12, deadline=None)
@given(
    st.lists(st.tuples(st.floats(0.05, 2.0), st.floats(0.0, 1.0)), min_size=2, max_size=5),
    st.sampled_from([MAXWELL, STANDARD, VOIGT, Prony(0.01, [0.1, 0.2], [0.01, 5.0], 0.02)]),
)
def test_forces_come_back_from_the_depths_they_made(points, solid):
    """A history of forces, marched, gives depths and energies; no energy is created, and none is lost."""
    times = np.concatenate([[0.0], np.cumsum([dt for dt, _ in points])])
    forces = np.concatenate([[0.0], [0.01 + force for _, force in points]])
    found = pressed(solid, times, Force(forces), count=80, tolerance=1e-4)
    assert np.all(np.diff(found.dissipation) > -1e-9)
    assert found.depth[-1] <= (0.75 * np.max(forces) * 1.001 * creep_of(solid, times[-1])) ** (2.0 / 3.0)


def creep_of(solid, time):
    return float(ViscoelasticHalfSpace(solid).creep.at(np.array(time)))


def test_forces_that_depths_make_make_these_depths():
    """A path of depths, with unloading, and the path of its forces."""
    t = np.linspace(0.0, 1.1, 221)
    depths = np.where(t < 0.7, t, 1.4 - t)
    for solid in (MAXWELL, STANDARD):
        forces = pressed(solid, t, Depth(depths), count=400).force
        remaining = forces > 0.02 * forces.max()
        remaining[0] = True
        last = int(np.flatnonzero(remaining)[-1]) + 1
        back = pressed(solid, t[:last], Force(forces[:last]), count=400)
        # forces are taken as straight between the points, depths were
        assert back.depth == pytest.approx(depths[:last], abs=3e-4)


def test_histories_superpose_while_the_contact_grows():
    """Twice the profile's force for twice the modulus; and the flat punch is linear in its history."""
    t = np.linspace(0.0, 1.0, 9)
    first, second = 0.1 + 0.2 * np.sin(t) ** 2, 0.3 * t
    punch = wk.FlatPunch(0.2)
    one, two, both = (pressed(STANDARD, t, Depth(d), punch).force for d in (first, second, first + second))
    assert one + two == pytest.approx(both, rel=1e-12)


def test_no_step_is_too_long():
    """A step of 1e4 of the shortest time and a thousandth of the longest one."""
    solid = Prony(0.05, [0.1, 0.1], [1e-4, 1e3])
    result = pressed(solid, np.array([0.0, 1.0, 2.0]), Depth(np.array([0.0, 0.25, 0.2499])))
    series = ViscoelasticHalfSpace(solid).relaxation
    exact = quad(
        lambda s: float(series.at(np.array(1.0 - s))) * 2.0 * math.sqrt(0.25 * s) * 0.25,
        0,
        1,
        points=[0.999],
        limit=500,
    )
    assert result.force[1] == pytest.approx(exact[0], rel=1e-5)


def test_a_released_body_rests_on_the_surface():
    t = np.array([0.0, 1.0, 1.0, 3.0, 10.0])
    result = pressed(STANDARD, t, Force(np.array([0.01, 0.01, 0.0, 0.0, 0.0])), tolerance=1e-5)
    assert np.all(result.depth[2:] > 0.0)
    assert np.all(np.diff(result.depth[1:]) < 0.0)
    assert result.depth[-1] < 0.02 * result.depth[1]


@pytest.mark.parametrize(
    ("make", "error", "message"),
    [
        (lambda: ViscoelasticIndentation(wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.3))), PATH),
         InvalidInput, "ViscoelasticHalfSpace"),
        (lambda: ViscoelasticIndentation(bed(MAXWELL), Depth(1.0)), InvalidInput, "the path is a Depth"),
        (lambda: pressed(MAXWELL, [0.0, 1.0], Force([1.0, -1.0])), InvalidInput, "tensile"),
        (lambda: pressed(MAXWELL, [0.0, 1.0], Depth([0.0, 1.0]), count=1), InvalidInput, "count is 1"),
        (lambda: pressed(MAXWELL, [0.0, 1.0], Depth([0.0, 1.0]), tolerance=2.0), InvalidInput, "tolerance is 2.0"),
        (lambda: pressed(VOIGT, [0.0, 1.0], Depth([0.5, 1.0])), OutsideValidity, "infinite force"),
        (lambda: pressed(VOIGT, [0.0, 1.0], Depth([-0.5, -0.1])), OutsideValidity, "never touch"),
        (lambda: ViscoelasticHalfSpace(wk.Elastic(1.0, 0.3)), InvalidInput, "neither"),
        (lambda: ViscoelasticHalfSpace(3.0), InvalidInput, "first is a float"),
        (lambda: wk.Indentation(bed(MAXWELL), Depth(1.0)).solve(), OutsideValidity, "changes in time"),
    ],
)  # fmt: skip
def test_what_is_refused(make, error, message):
    with pytest.raises(error, match=message):
        make()


PATH = Path([0.0, 1.0], Depth([0.0, 1.0]))


def test_notes_name_the_span():
    solid = PowerLawSolid(1.0, 1.0, 0.3, shortest=1e-3, longest=10.0)
    result = pressed(solid, [0.0, 1.0], Depth([0.0, 0.01]))
    assert any("0.001 s and 10 s" in note.statement for note in result.validity)
    assert any("linear viscoelastic" in note.statement.lower() for note in result.validity)
    # the elastic body that stands for the other has no notes of its own
    assert not any("dissimilar" in note.statement for note in result.validity)


def swung(points, tolerance=1e-7, solid=MAXWELL):
    t = np.linspace(0.0, 2.0, points)
    return pressed(solid, t, Force(0.01 * np.sin(np.pi * t) ** 2), tolerance=tolerance)


@pytest.mark.parametrize("points", [9, 33, 300, 1000])
def test_the_depth_under_a_rising_force_is_that_of_lee_and_radok(points):
    """While the contact grows d^(3/2) is the integral of 3/4 J dF over sqrt(R): J = 1 + t/tau of a Maxwell solid."""
    found = swung(points)
    t = found.time[found.time <= 0.5]
    force = 0.01 * np.sin(np.pi * t) ** 2
    impulse = np.append(0.0, np.cumsum(0.5 * (force[1:] + force[:-1]) * np.diff(t)))
    exact = (0.75 * (force + impulse / 0.3)) ** (2.0 / 3.0)
    assert np.abs(found.depth[: t.size] - exact).max() <= 2e-5 * exact.max()  # of 500 springs


@pytest.mark.parametrize("solid", [MAXWELL, STANDARD, VOIGT, Prony(0.05, [0.1, 0.1], [1e-3, 10.0])])
@pytest.mark.parametrize("points", [9, 600])
def test_under_forces_no_step_is_wrong_by_more_than_allowed(solid, points):
    """Whether a step is compared with its halves or judged by how its rate changes: errors add up to the tolerance."""
    tolerance = 1e-6
    found, best = swung(points, tolerance, solid), swung(points, 1e-9 if points < 100 else 1e-8, solid)
    steps = max(points, 100)
    for name in ("depth", "work", "dissipation"):
        one, two = getattr(found, name), getattr(best, name)
        assert np.abs(one - two).max() <= steps * tolerance * np.abs(two).max(), name


def test_under_forces_a_path_is_the_same_in_blocks_and_point_by_point():
    found = swung(600)
    states = list(found.problem.steps())
    for name in ("depth", "radius", "work", "stored_energy", "dissipation"):
        assert np.array_equal(getattr(found, name), [getattr(state, name) for state in states])
