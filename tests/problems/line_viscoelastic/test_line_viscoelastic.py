"""Line contacts of bodies that relax against closed forms, boundary elements, and superposition in time."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
from relaxing_half_plane import RelaxingHalfPlane

import winkler as wk

SOLID = wk.StandardSolid(relaxed_shear=0.05, shear=0.2, relaxation_time=0.5)
HISTORY = wk.LineForcePath([0.0, 1.0, 2.0, 2.5, 3.5], [0.0, 1e-3, 1e-3, 0.25e-3, 1.3e-3], count=40)

COARSE = wk.LineForcePath(HISTORY.time, HISTORY.force_per_length, count=8)


def bed_of(profile, *bodies) -> wk.LineFoundation:
    return wk.LineFoundation(profile, wk.ViscoelasticHalfSpace(*(bodies or (SOLID,))))


def solved(profile, path, *bodies, **options) -> wk.LineViscoelasticSolution:
    return wk.LineViscoelasticIndentation(bed_of(profile, *bodies), path, **options).solve()


@pytest.mark.slow
def test_a_history_agrees_with_boundary_elements_that_step_through_time():
    contact = solved(wk.Paraboloid(1.0), HISTORY)
    creep, errors = contact.problem.bed.medium.creep, []
    body = RelaxingHalfPlane(
        lambda x: 0.5 * x**2,
        1.05 * contact.half_width.max(),
        120,
        (creep.glassy, creep.compliances[0], creep.times[0]),
    )
    finer = wk.LineForcePath(HISTORY.time, HISTORY.force_per_length, count=80)
    for index in range(1, finer.moments.size):
        elements = body.step(finer.across[index], finer.moments[index] - finer.moments[index - 1])
        if index % 2 == 0:
            state = contact.at(index // 2)
            strips = state.pressure(body.x)
            inside = body.x < 0.95 * state.half_width
            if np.count_nonzero(inside) > 20:  # of a narrow strip the elements are too few
                errors.append(np.max(np.abs(elements - strips)[inside]) / strips.max())
            assert abs(np.count_nonzero(elements) * body.width - state.half_width) < 1.01 * body.width
    assert len(errors) > 130
    assert max(errors) < 5e-3
    assert np.mean(errors) < 1e-3


def test_a_step_of_load_creeps_as_lee_and_radok_say():
    """a^2 = 4 R P C(t)/pi, p = (1/pi) Int E(t - s) d p(a(s)), at 30 digits."""
    with mp.workdps(30):
        end, part, tau, force = mp.mpf("0.2"), mp.mpf("0.8"), mp.mpf("0.5"), mp.mpf("1e-3")

        def crept(t):
            return force * (1 / end - part / (end * (end + part)) * mp.e ** (-t * end / (tau * (end + part))))

        wide = mp.sqrt(4 * crept(3) / mp.pi)
        place = wide * mp.mpf("0.3")
        first = mp.sqrt(4 * crept(0) / mp.pi)

        def elastic(s):
            return mp.sqrt(4 * crept(s) / mp.pi - place**2) / 2

        modulus = [end + part * mp.e ** (-(3 - s) / tau) for s in (0,)]
        widened = mp.quad(lambda s: (end + part * mp.e ** (-(3 - s) / tau)) * mp.diff(elastic, s), [0, 1, 3])
        pressure = modulus[0] * mp.sqrt(first**2 - place**2) / 2 + widened
    step = wk.LineForcePath([0.0, 0.5, 3.0], 1e-3)
    contact = solved(wk.Paraboloid(1.0), step)
    assert contact.half_width[-1] == pytest.approx(float(wide), rel=1e-12)
    assert contact.at(-1).pressure(-float(place)) == pytest.approx(float(pressure), rel=2e-6)
    assert contact.half_width[0] == pytest.approx(float(first), rel=1e-12)


def test_a_dashpot_alongside_lets_go_where_the_elastic_part_bears_the_force():
    """E*(t) = 1 + delta(t): the strip widens while its force per length grows with time, then w(a) = P.

    While it widens the pressure is the elastic one and its rate, which is infinite at the edge.
    """
    rate = 1e-4 * np.pi
    contact = solved(
        wk.Paraboloid(1.0), wk.LineForcePath([0.0, 1.0, 2.0], [0.0, rate, 0.0], count=8), wk.KelvinVoigt(0.25, 0.25)
    )
    assert np.all(np.isinf(contact.peak_pressure[1:9]))
    narrowing = (contact.force_per_length < contact.crept_load) & (contact.half_width > 0.0)
    assert np.count_nonzero(narrowing) >= 4
    expected = np.sqrt(4.0 / np.pi * contact.force_per_length[narrowing])
    np.testing.assert_allclose(contact.half_width[narrowing], expected, rtol=1e-9)
    turn = contact.at(8)
    a, x = turn.half_width, 0.5 * turn.half_width
    root = np.sqrt(a**2 - x**2)
    growth = 4.0 / np.pi * rate * -np.expm1(-1.0)
    assert a == pytest.approx(np.sqrt(4.0 / np.pi * rate * np.exp(-1.0)), rel=1e-9)
    assert turn.pressure(x) == pytest.approx(0.5 * root + 0.25 * growth / root, rel=1e-5)


@pytest.mark.few(1, slow=2)
@pytest.mark.parametrize(
    "profile",
    [
        wk.Paraboloid(1.0),
        wk.Cone(1.52),
        wk.RoundedPunch(0.02, 0.5),
        wk.Formula("r**2/2 + r**4"),
        wk.FlatPunch(0.05),
    ],
    ids=["cylinder", "wedge", "rounded punch", "formula", "flat punch"],
)
def test_pressures_bear_the_force(profile):
    contact = solved(profile, COARSE, count=300)
    for index in (4, 16, 22, 24, -1):
        state = contact.at(index)
        angle = (np.arange(4000) + 0.5) * 0.5 * np.pi / 4000  # midpoints, near to no infinite pressure
        x = state.half_width * np.sin(angle)
        force = 2.0 * np.sum(state.pressure(x) * state.half_width * np.cos(angle)) * 0.5 * np.pi / 4000
        assert force == pytest.approx(state.force_per_length, rel=2e-4)


def test_a_body_that_hardly_relaxes_is_elastic():
    solid = wk.StandardSolid(relaxed_shear=0.25, shear=1e-12, relaxation_time=1.0)
    for profile in (wk.Paraboloid(1.0), wk.Cone(1.52)):
        contact = solved(profile, COARSE, solid)
        elastic = wk.LineFoundation(profile, wk.HalfSpace(wk.Elastic(0.75, 0.5)))
        same = wk.LineIndentation(elastic, wk.LineForce(COARSE.across[1:])).solve()
        np.testing.assert_allclose(contact.half_width[1:], same.half_width, rtol=2e-5)
        last, x = same.at(-1), 0.4 * same.half_width[-1]
        assert contact.at(-1).pressure(x) == pytest.approx(float(last.pressure(x)), rel=1e-5)
        assert contact.at(-1).approach(1.0) == pytest.approx(last.approach(1.0), rel=1e-5)
        assert contact.at(-1).approach(wk.PlateBase(1.0)) == pytest.approx(last.approach(wk.PlateBase(1.0)), rel=1e-5)


@pytest.mark.slow
def test_the_approach_is_the_hereditary_integral_of_what_the_pressures_give():
    """u = Int C(t - s) dA(s), A the approach of an elastic body of E* = 1 under the pressures themselves."""
    depth, poisson, n = 0.7, 0.5, 400
    path = wk.LineForcePath([0.0, 1.0, 2.0, 3.0], [0.0, 1e-3, 0.0, 0.0], count=80)
    contact = solved(wk.Paraboloid(1.0), path)
    angle = (np.arange(n) + 0.5) * 0.5 * np.pi / n

    def elastic(state):
        """Points on the axis under line loads (Flamant): 1/(pi E*) [2 ln(r/s) - d^2/r^2/(1 - nu)], r^2 = s^2 + d^2."""
        x = state.half_width * np.sin(angle)
        load = 2.0 * state.pressure(x) * state.half_width * np.cos(angle) * 0.5 * np.pi / n
        r2 = x**2 + depth**2
        return np.sum(load * (np.log(r2 / x**2) - depth**2 / r2 / (1.0 - poisson))) / np.pi if load.any() else 0.0

    near = np.array([elastic(state) for state in contact.states])
    middles = 0.5 * (path.moments[1:] + path.moments[:-1])
    creep = contact.problem.bed.medium.creep
    for index in (40, 80, 130, 160, 240):
        expected = np.sum(creep.at(path.moments[index] - middles[:index]) * np.diff(near[: index + 1]))
        assert contact.at(index).approach(depth) == pytest.approx(expected, rel=2e-3), index
    assert contact.half_width[-1] == 0.0
    assert contact.approach(depth)[-1] > 0.0


@pytest.mark.slow
def test_two_bodies_share_the_approach():
    """The elastic one moves as under its present pressure; two alike move half of what one and a rigid one do."""
    alike = solved(wk.Paraboloid(1.0), COARSE, SOLID, SOLID)
    single = solved(wk.Paraboloid(1.0), COARSE, wk.StandardSolid(0.025, 0.1, 0.5))
    np.testing.assert_allclose(alike.approach(1.0, 1.0), single.approach(1.0), rtol=1e-9)
    stiff = wk.Elastic(1e9, 0.3)
    np.testing.assert_allclose(
        solved(wk.Paraboloid(1.0), COARSE, SOLID, stiff).approach(1.0, 1.0),
        solved(wk.Paraboloid(1.0), COARSE).approach(1.0),
        rtol=1e-6,
        atol=1e-12,
    )
    other = wk.StandardSolid(0.05, 0.2, 5.0)
    with pytest.raises(wk.OutsideValidity, match="different relaxation functions"):
        solved(wk.Paraboloid(1.0), COARSE, SOLID, other).approach(1.0, 1.0)


@pytest.mark.slow
def test_what_a_cycle_loses():
    """Slow and fast cycles lose little, those of about the relaxation time most, per work that is spent."""
    shares = []
    for period in (1e-3, 2.5, 1e4):
        path = wk.LineForcePath([0.0, 0.5 * period, period], [0.2e-3, 1e-3, 0.2e-3], cycles=3, count=40)
        work = solved(wk.Paraboloid(1.0), path).work_per_length(1.0)
        shares.append((work[-1] - work[-81]) / (work[-41] - work[-81]))
    assert shares[1] > 0.1
    assert abs(shares[2]) < 2e-3
    for elastic in (wk.StandardSolid(relaxed_shear=0.25, shear=1e-12, relaxation_time=1.0),):
        work = solved(wk.Paraboloid(1.0), path, elastic).work_per_length(1.0)
        assert abs(work[-1] - work[-81]) < 1e-6 * work[-1]


@pytest.mark.slow
def test_the_error_falls_with_the_square_of_the_distance_of_springs():
    path = wk.LineForcePath([0.0, 1.0, 1.6], [0.0, 1e-3, 0.4e-3])
    fine = solved(wk.Paraboloid(1.0), path, count=6000, tolerance=1e-10)
    errors = [
        abs(
            solved(wk.Paraboloid(1.0), path, count=count, tolerance=1e-10).at(-1).pressure(0.0)
            / fine.at(-1).pressure(0.0)
            - 1.0
        )
        for count in (50, 200)
    ]
    assert errors[1] < errors[0] / 8.0
    assert errors[1] < 1e-5


def test_paths():
    path = wk.LineForcePath([1.0, 1.0, 2.0], [0.0, 2.0, 0.0], cycles=2, count=2)
    np.testing.assert_array_equal(path.moments, [1.0, 1.0, 1.5, 2.0, 2.0, 2.5, 3.0])
    np.testing.assert_array_equal(path.across, [0.0, 2.0, 1.0, 0.0, 2.0, 1.0, 0.0])
    with pytest.raises(wk.InvalidInput, match="one number for each"):
        wk.LineForcePath([0.0, 1.0], [0.0, 1.0, 2.0])
    with pytest.raises(wk.InvalidInput, match="never fall"):
        wk.LineForcePath([1.0, 0.0], 1.0)
    with pytest.raises(wk.InvalidInput):
        wk.LineForcePath([0.0, 1.0], [0.0, -1.0])


@pytest.mark.slow
def test_refusals():
    with pytest.raises(wk.InvalidInput, match="LineIndentation for bodies that do not relax"):
        wk.LineViscoelasticIndentation(
            wk.LineFoundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.3))), HISTORY
        )
    with pytest.raises(wk.OutsideValidity, match="press the bodies together"):
        solved(wk.Paraboloid(1.0), wk.LineForcePath([0.0, 1.0], 0.0))
    with pytest.raises(wk.OutsideValidity, match="lets the load fall again"):
        solved(wk.Wavy(1e-3, 1.0), wk.LineForcePath([0.0, 1.0], [0.0, 0.02]))
    contact = solved(wk.Paraboloid(1.0), HISTORY)
    with pytest.raises(wk.InvalidInput, match="no depth of its own"):
        contact.approach()
    for place in ("far", np.nan):
        with pytest.raises(wk.InvalidInput, match="LineViscoelasticState.pressure: x"):
            contact.at(20).pressure(place)
    with pytest.raises(wk.OutsideValidity, match="more than 0.2"):
        contact.approach(wk.PlateBase(0.05))


@pytest.mark.slow
def test_a_broad_spectrum_needs_few_springs():
    solid = wk.PowerLawSolid(shear=1e6, time_scale=1.0, exponent=0.3, shortest=1e-4, longest=1e3)
    path = wk.LineForcePath([0.0, 1.0, 1.5, 2.5], [0.0, 1e3, 1e3, 0.0], count=4)
    rough, fine = (
        solved(wk.Paraboloid(0.01), path, solid, **each) for each in ({}, {"count": 1500, "tolerance": 1e-8})
    )
    np.testing.assert_allclose(rough.half_width[:-1], fine.half_width[:-1], rtol=1e-4, atol=1e-9)
    assert rough.half_width[-1] == 0.0
