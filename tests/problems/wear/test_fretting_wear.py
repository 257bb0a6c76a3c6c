"""Fretting wear: limits, energies, volumes, and marches that are stopped, hurried or driven too far."""

import dataclasses
import math

import mpmath
import numpy as np
import pytest

import winkler as wk

BALL, DEPTH, MU = 1.0, 0.01, 0.5
A0 = math.sqrt(BALL * DEPTH)
MEDIUM = wk.HalfSpace(wk.Elastic(young=1.0, poisson=0.3))
BED = wk.Foundation(wk.Paraboloid(BALL), MEDIUM)
RATIO = MEDIUM.modulus / MEDIUM.shear_modulus
HALF = wk.Shift(MU * RATIO * DEPTH * 0.75)
"""Sticks within half of the contact."""
LATE = 1e5
"""Cycles after which nothing changes any more."""


def fretting(**changes):
    given = {
        "bed": BED,
        "wear": wk.Archard(0.1),
        "law": wk.Coulomb(MU),
        "normal": wk.Depth(DEPTH),
        "amplitude": HALF,
        "cycles": np.array([0.0, LATE]),
        "count": 80,
    }
    return wk.FrettingWear(**(given | changes))


def limiting(bed=BED, amplitude=HALF):
    return wk.LimitingProfile(bed, wk.Coulomb(MU), wk.Depth(DEPTH), amplitude).solve()


def trapezoid(state, of):
    """Integrate over the surface straight in r, unlike the march, which is straight in r^2."""
    return float(np.trapezoid(2.0 * np.pi * state.radii * of, state.radii))


@pytest.mark.slow
def test_the_march_ends_in_the_limiting_profile_the_closer_the_finer_the_grid():
    limit = limiting()
    misses = []
    for count in (50, 100, 200):
        last = fretting(count=count).solve().states[-1]
        misses.append(abs(last.worn_volume / limit.worn_volume - 1.0))
        assert last.force == pytest.approx(limit.force, rel=20.0 / count**2)
        apart = trapezoid(last, np.abs(last.worn - limit.worn(last.radii)))
        assert apart < 2.0 / count * limit.worn_volume
    assert misses[-1] < 3e-3
    orders = np.log2(np.array(misses[:-1]) / misses[1:])
    assert np.all(orders > 1.3)


@pytest.mark.slow
def test_the_march_ends_within_one_percent_of_the_limiting_profile():
    limit, worn = limiting(), fretting().solve()
    assert worn.worn_volume[-1] == pytest.approx(limit.worn_volume, rel=0.01)
    assert worn.force[-1] == pytest.approx(limit.force, rel=0.002)
    assert worn.stick_radius[-1] == pytest.approx(0.5 * A0, rel=1e-6)
    last = worn.states[-1]
    assert abs(worn.radius[-1] - limit.radius) < np.max(np.diff(last.radii))
    assert np.all(last.worn[last.radii <= 0.5 * A0] == 0.0)


@pytest.mark.slow
def test_the_limit_holds_in_a_graded_medium():
    soil = wk.PowerLawGraded(young=1.0, depth_scale=0.1, exponent=0.3, poisson=0.3)
    graded = wk.GradedHalfSpace.between(soil)
    bed = wk.Foundation(wk.Paraboloid(BALL), graded)
    amplitude = wk.Shift(0.7 * MU * graded.modulus / graded.shear_modulus * DEPTH)
    worn, limit = fretting(bed=bed, amplitude=amplitude).solve(), limiting(bed, amplitude)
    assert worn.worn_volume[-1] == pytest.approx(limit.worn_volume, rel=0.01)
    assert worn.force[-1] == pytest.approx(limit.force, rel=0.005)


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("rate", [1e-12, pytest.param(1e3, marks=pytest.mark.slow), 1e12])
def test_no_rate_is_too_great_for_the_march(rate):
    # the same wear in as many fewer cycles, also where the first cycle takes everything
    cycles = np.array([0.0, LATE * 0.1 / rate])
    worn = fretting(wear=wk.Archard(rate), cycles=cycles, count=40).solve()
    slow = fretting(count=40).solve()
    assert np.all(np.isfinite(worn.states[-1].pressure))
    assert worn.worn_volume[-1] == pytest.approx(slow.worn_volume[-1], rel=1e-5)


def test_the_energy_of_a_cycle_is_that_of_the_springs():
    begin = next(fretting(count=400).steps())
    damping = wk.FrictionDamping(BED, wk.Coulomb(MU), wk.Depth(DEPTH), HALF).solve()
    assert begin.loss_per_cycle == pytest.approx(damping.loss_per_cycle, rel=2e-4)
    assert begin.shear_force == pytest.approx(damping.shear_force, rel=1e-5)
    assert begin.stick_radius == pytest.approx(0.5 * A0, rel=1e-9)


def test_what_a_cycle_wears_off_is_its_energy_times_the_rate_over_friction():
    few = fretting(cycles=np.array([0.0, 0.05]), count=200).solve()
    expected = 0.1 / MU * few.loss_per_cycle[0] * 0.05
    assert few.worn_volume[-1] == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize("part", [0.3, 0.9])
def test_a_shear_force_swings_as_far_as_its_shift(part):
    most = MU * 4.0 / 3.0 * MEDIUM.modulus * A0 * DEPTH
    begin = next(fretting(amplitude=wk.ShearForce(part * most), count=200).steps())
    # Cattaneo, Mindlin
    core = (1.0 - part) ** (1.0 / 3.0)
    assert begin.stick_radius / A0 == pytest.approx(core, rel=1e-3)
    assert begin.shift == pytest.approx(MU * RATIO * DEPTH * (1.0 - core**2), rel=1e-4)
    assert begin.shear_force == pytest.approx(part * most, rel=1e-6)


def test_gross_slip_wears_off_rate_times_force_times_slip():
    # far beyond the shift at which all slides each cycle slips four times the amplitude, less what is elastic
    far, force, cycles = 10.0 * MU * RATIO * DEPTH, 1e-3, 0.05
    misses = []
    for count in (100, 200, 400):
        worn = fretting(amplitude=wk.Shift(far), normal=wk.Force(force), cycles=np.array([0.0, cycles]), count=count)
        last = worn.solve().states[-1]
        assert last.stick_radius == 0.0
        elastic = 1.0 - trapezoid(last, last.pressure * (far - last.slip)) / (force * far)
        volume = 0.1 * force * 4.0 * far * cycles
        assert 0.9 < elastic < 1.0
        assert last.worn_volume / volume == pytest.approx(elastic, rel=2e-3)
        misses.append(abs(trapezoid(last, last.worn) / last.worn_volume - 1.0))
    assert misses[-1] < 1e-4
    assert np.all(np.log2(np.array(misses[:-1]) / misses[1:]) > 1.5)


def test_a_march_that_was_stopped_goes_on_with_the_same_numbers():
    problem = fretting(cycles=np.array([0.0, 1.0, 10.0, 100.0, 1000.0]), count=60)
    whole = list(problem.steps())
    for stopped in (0, 2):
        rest = list(problem.steps(start=whole[stopped]))
        assert rest == whole[stopped + 1 :]
    assert list(problem.steps(start=whole[-1])) == []


@pytest.mark.slow
def test_under_a_force_the_core_takes_over_what_the_ring_lets_go():
    worn = fretting(normal=wk.Force(1e-3), amplitude=wk.Shift(1e-3), cycles=np.geomspace(1.0, 1e5, 6)).solve()
    np.testing.assert_allclose(worn.force, 1e-3, rtol=1e-9)
    assert np.all(np.diff(worn.depth) > 0.0)
    assert np.all(np.diff(worn.worn_volume) > 0.0)
    last = worn.states[-1]
    core = last.radii < worn.stick_radius[-1]
    assert trapezoid(last, np.where(core, last.pressure, 0.0)) > 0.9 * 1e-3


def test_a_contact_that_wears_through_its_core_slides_away_and_keeps_what_was():
    most = MU * 4.0 / 3.0 * MEDIUM.modulus * A0 * DEPTH
    problem = fretting(amplitude=wk.ShearForce(0.8 * most), cycles=np.geomspace(1.0, 1e4, 30), count=40)
    remaining = []

    def march():
        for state in problem.steps():
            remaining.append(state)

    with pytest.raises(wk.OutsideValidity, match=r"after .* cycles friction carries .* slide away"):
        march()
    assert len(remaining) > 5
    assert remaining[-1].stick_radius < 0.6 * remaining[0].stick_radius
    assert remaining[-1].force < remaining[0].force


def test_both_bodies_lose_their_share():
    alone = fretting(wear=wk.Archard(0.4), cycles=100.0, count=40).solve()
    both = fretting(wear=wk.PairWear(wk.Archard(0.1), wk.Archard(0.3)), cycles=100.0, count=40).solve()
    np.testing.assert_allclose(both.worn_volume, alone.worn_volume, rtol=1e-4)
    np.testing.assert_allclose(both.second_volume, 3.0 * both.first_volume, rtol=1e-9)
    np.testing.assert_allclose(both.first_volume + both.second_volume, both.worn_volume, rtol=1e-12)
    assert np.all(alone.second_volume == 0.0)


@dataclasses.dataclass(frozen=True)
class Squared:
    """Worn as the square of the pressure."""

    def depth_per_slip(self, pressure):
        return pressure**2


@pytest.mark.slow
def test_the_limit_does_not_depend_on_the_law_of_wear():
    limit, worn = limiting(), fretting(wear=Squared(), cycles=np.array([0.0, 1e9])).solve()
    assert worn.worn_volume[-1] == pytest.approx(limit.worn_volume, rel=0.02)


def test_a_law_that_returns_nonsense_is_refused():
    @dataclasses.dataclass(frozen=True)
    class Negative:
        def depth_per_slip(self, pressure):
            return -pressure

    with pytest.raises(wk.InvalidInput, match="depth_per_slip must return"):
        fretting(wear=Negative()).solve()


def test_what_sticks_does_not_wear():
    worn = fretting(amplitude=wk.Shift(1e-13), cycles=np.array([0.0, 10.0])).solve()
    assert worn.worn_volume[-1] < 1e-6 * A0**2 * DEPTH


def test_one_number_of_cycles_gives_states_that_crowd_at_the_beginning():
    worn = fretting(cycles=100.0, count=20).solve()
    assert worn.cycles[0] == 0.0
    assert worn.cycles[-1] == 100.0
    assert np.all(np.diff(worn.cycles, 2) > 0.0)
    assert any("Debris" in note.statement for note in worn.validity)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"cycles": 0.0}, "cycles is 0.0"),
        ({"cycles": np.array([1.0, 1.0])}, "rise from zero"),
        ({"cycles": np.array([-1.0, 1.0])}, "rise from zero"),
        ({"normal": wk.Force(np.array([1.0, 2.0]))}, "one positive number"),
        ({"normal": wk.Depth(-1.0)}, "one positive number"),
        ({"amplitude": wk.Shift(0.0)}, "one positive number"),
        ({"amplitude": wk.Angle(1.0)}, "give Shift"),
        ({"law": wk.Coulomb(math.inf)}, "positive, finite coefficient"),
        ({"wear": 1e-14}, "give Archard"),
        ({"count": 3}, "from 20 to"),
        ({"tolerance": 1.0}, "between 1e-9"),
        ({"bed": "ball"}, "give Foundation"),
    ],
)
def test_wrong_arguments_are_refused(changes, message):
    with pytest.raises(wk.InvalidInput, match=message):
        fretting(**changes)


@pytest.mark.parametrize(("part", "count", "standing"), [
    (0.5, 80, wk.Standing.ASYMPTOTIC),
    (1e-2, 100, wk.Standing.APPROXIMATE),
    (1e-3, 100, wk.Standing.OUTSIDE),
    (1e-3, 800, wk.Standing.ASYMPTOTIC),
])  # fmt: skip
def test_how_well_a_grid_resolves_a_small_swing_is_stated(part, count, standing):
    """By the loss of Mindlin and Deresiewicz (1953)."""
    force = 4.0 / 3.0 * MEDIUM.modulus * A0**3 / BALL
    swing = wk.ShearForce(part * MU * force)
    run = fretting(normal=wk.Force(force), amplitude=swing, cycles=np.array([1e-9]), count=count).solve()
    with mpmath.workdps(30):
        left = 1 - mpmath.mpf(part)
        bracket = 1 - left ** (5 / mpmath.mpf(3)) - 5 * mpmath.mpf(part) / 6 * (1 + left ** (2 / mpmath.mpf(3)))
        loss = float(18 * bracket / 5) * (MU * force) ** 2 / (A0 * MEDIUM.shear_modulus)
    error = run.loss_per_cycle[0] / loss - 1.0
    (note,) = (note for note in run.validity if "In a cycle before wear" in note.statement)
    more = "more" if error > 0.0 else "less"
    assert f"the grid dissipates {100.0 * abs(error):.2g} per cent {more} than" in note.statement
    assert note.standing is standing
    assert ("use more cells" in note.statement) == (abs(error) > 0.01)


@pytest.mark.parametrize("share", [1e-12, 1e-15, 1e-18])
def test_a_swing_whose_loss_is_rounding_is_stated_on_a_processor_of_any_rounding(share):
    force = 4.0 / 3.0 * MEDIUM.modulus * A0**3 / BALL
    run = fretting(normal=wk.Force(force), amplitude=wk.ShearForce(share * MU * force), cycles=np.array([1e-9]))
    (note,) = (note for note in run.solve().validity if "slip and wear are of the order of rounding" in note.statement)
    assert note.standing is wk.Standing.OUTSIDE


def test_a_small_swing_whose_loss_is_known_is_not_called_rounding():
    force = 4.0 / 3.0 * MEDIUM.modulus * A0**3 / BALL
    run = fretting(normal=wk.Force(force), amplitude=wk.ShearForce(1e-3 * MU * force), cycles=np.array([1e-9]))
    assert not any("of the order of rounding" in note.statement for note in run.solve().validity)
