"""Wear of line contacts: against boundary elements, closed forms, volumes and energies; and what is refused."""

import itertools
import math

import mpmath
import numpy as np
import pytest
from half_plane_wear import WornCylinder

import winkler as wk
from winkler.io.wear_states import read_wear, write_wear

UNIT = wk.HalfSpace.between(wk.Elastic(2.0, 0.0), wk.Elastic(2.0, 0.0))
"""E* = 1."""
CYLINDER = wk.LineFoundation(wk.Paraboloid(1.0), UNIT)
MU, A = 0.5, 0.1
FORCE = 0.25 * math.pi * A**2
SWING = 0.75 * MU * FORCE
"""Sticks within half of the contact."""
LATE = 1e5
"""Cycles after which nothing changes any more, at the rate 0.1."""
STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
ROLLER = wk.LineFoundation(wk.Paraboloid(10e-3), STEEL)


def fretting(**changes):
    given = {
        "bed": CYLINDER,
        "wear": wk.Archard(0.1),
        "law": wk.Coulomb(MU),
        "normal": wk.LineForce(FORCE),
        "amplitude": wk.LineShearForce(SWING),
        "cycles": np.array([0.0, LATE]),
        "count": 80,
    }
    return wk.LineFrettingWear(**(given | changes))


def limiting(bed=CYLINDER, force=FORCE, swing=SWING):
    return wk.LineLimitingProfile(bed, wk.Coulomb(MU), wk.LineForce(force), wk.LineShearForce(swing)).solve()


def sliding(distance, **changes):
    given = {"bed": ROLLER, "wear": wk.Archard(1e-14), "normal": wk.LineForce(10e3), "distance": distance, "count": 80}
    return wk.LineSlidingWear(**(given | changes)).solve()


def trapezoid(state, of):
    """Integrate over both sides straight in x, unlike the march, which is straight in x^2."""
    return 2.0 * float(np.trapezoid(of, state.places))


@pytest.mark.slow
@pytest.mark.parametrize("counts", [(28, 56, 112), pytest.param((56, 112, 224), marks=pytest.mark.slow)])
def test_fretting_is_that_of_boundary_elements(counts):
    amount = 30.0
    run = fretting(wear=wk.Archard(1.0), cycles=np.array([0.0, amount]), count=400, tolerance=1e-5).solve()
    last = run.states[-1]
    misses, stresses = [], []
    for count in counts:
        elements = WornCylinder(np.linspace(0.0, 0.14, count + 1), FORCE, MU)
        worn, pressure = elements.fret(SWING, amount, 120)
        misses.append(abs(2.0 * elements.h @ worn / last.worn_volume_per_length - 1.0))
        # the edge of the core, where the pressure grows without end, aside
        inside = elements.x < 0.4 * A
        there = np.interp(elements.x**2, last.places**2, last.pressure)
        stresses.append(np.max(np.abs(pressure - there)[inside]) / pressure[0])
    assert np.all(np.log2(np.array(misses[:-1]) / misses[1:]) > 1.0)
    assert misses[-1] < 0.4 / counts[-1]
    assert stresses[-1] < 0.3 / counts[-1]
    assert stresses[-1] < 0.5 * stresses[0]


@pytest.mark.slow
def test_sliding_is_that_of_boundary_elements():
    given = {"bed": CYLINDER, "wear": wk.Archard(1.0), "normal": wk.LineForce(FORCE), "tolerance": 1e-5}
    run = sliding(np.array([0.0, 0.1]), **given, count=400)
    last = run.states[-1]
    misses = []
    for count in (40, 80, 160):
        elements = WornCylinder(np.linspace(0.0, 0.2, count + 1), FORCE, MU)
        worn, _ = elements.slide(0.1, 100)
        there = np.interp(elements.x**2, last.places**2, last.worn)
        misses.append(np.max(np.abs(worn - there)) / last.worn_depth)
    assert np.all(np.log2(np.array(misses[:-1]) / misses[1:]) > 1.0)
    assert misses[-1] < 5e-4


@pytest.mark.slow
def test_the_march_ends_in_the_limiting_profile_the_closer_the_finer_the_grid():
    limit = limiting()
    misses = []
    for count in (40, 80, 160):
        last = fretting(count=count).solve().states[-1]
        misses.append(abs(last.worn_volume_per_length / limit.worn_volume_per_length - 1.0))
        assert trapezoid(last, np.abs(last.worn - limit.worn(last.places))) < 2.0 / count * limit.worn_volume_per_length
        assert last.half_width == pytest.approx(limit.half_width, abs=1.5 * np.max(np.diff(last.places)))
        np.testing.assert_allclose(last.pressure[last.places < 0.4 * A], limit.pressure(
            last.places[last.places < 0.4 * A]), rtol=1.0 / count)  # fmt: skip
    assert misses[-1] < 6e-3
    # of first order, on grids four times as fine
    assert misses[1] < misses[0]
    assert misses[-1] < 0.25 * misses[0]


@pytest.mark.slow
def test_what_sticks_stays_and_does_not_wear():
    run = fretting(cycles=np.array([0.0, 30.0, 300.0, LATE])).solve()
    np.testing.assert_allclose(run.stick_half_width, 0.5 * A, rtol=1e-12)
    for state in run.states:
        assert np.all(state.worn[state.places <= 0.5 * A] == 0.0)
    np.testing.assert_allclose(run.force_per_length, FORCE, rtol=1e-13)


@pytest.mark.parametrize(
    "profile", [wk.RoundedPunch(0.5, 1.0), wk.PowerLaw(1.0, 4.0), wk.Cone(1.4)], ids=["rounded", "quartic", "wedge"]
)
def test_the_limiting_surface_lies_under_its_pressure(profile):
    bed = wk.LineFoundation(profile, UNIT)
    force = float(bed.load_profile(np.array([0.7]))[0])
    limit = limiting(bed, force, 0.6 * MU * force)
    c = limit.stick_half_width
    # s = c sin(t): what the pressure displaces, by midpoints; the whole pressure is the force
    t = np.pi * ((np.arange(4000) + 0.5) / 4000 - 0.5)
    s, share = c * np.sin(t), c * np.cos(t) * np.pi / 4000
    borne = limit.pressure(s) * share
    assert np.sum(borne) == pytest.approx(force, rel=1e-4)  # the wedge's is infinite in its middle
    x = c + (limit.half_width - c) * np.array([0.2, 0.6, 1.0])
    sunk = -2.0 / np.pi * (np.log(np.abs(x[:, None] - s)) - np.log(1.2 * c - s)) @ borne
    raised = limit.height(np.minimum(x, limit.half_width * (1 - 1e-12)))
    base = limit.height(1.2 * c) if 1.2 * c < limit.half_width else None
    if base is None:
        pytest.fail("the place of comparison is not worn")
    np.testing.assert_allclose(raised - base, -sunk, rtol=2e-4, atol=2e-5 * float(np.max(raised)))


class Squared:
    def depth_per_slip(self, pressure):
        return pressure**2


@pytest.mark.slow
@pytest.mark.parametrize(
    "law", [wk.Archard(0.1), pytest.param(Squared(), marks=pytest.mark.slow)], ids=["archard", "own"]
)
def test_the_limit_is_that_of_the_march_on_a_rounded_pad_and_for_a_law_of_its_own(law):
    bed = wk.LineFoundation(wk.RoundedPunch(0.05, 1.0), UNIT)
    limit = limiting(bed)
    last = fretting(bed=bed, wear=law, cycles=np.array([0.0, 1e7]), count=60).solve().states[-1]
    assert last.worn_volume_per_length == pytest.approx(limit.worn_volume_per_length, rel=0.03)
    assert last.stick_half_width == pytest.approx(limit.stick_half_width, rel=1e-9)


def test_the_first_cycle_loses_what_the_contact_without_wear_loses():
    path = wk.LinePath(FORCE, [0.0, SWING, -SWING, SWING])
    loop = wk.LineTangential(CYLINDER, wk.Coulomb(MU), path).solve()
    expected = loop.dissipation_per_length[3] - loop.dissipation_per_length[1]
    misses = [abs(next(fretting(count=n).steps()).dissipation_per_length / expected - 1.0) for n in (100, 200, 400)]
    assert misses[-1] < 1e-4
    assert np.all(np.log2(np.array(misses[:-1]) / misses[1:]) > 1.3)


def test_what_a_cycle_wears_off_is_its_energy_times_the_rate_over_friction():
    few = fretting(cycles=np.array([0.0, 0.05]), count=200).solve()
    expected = 0.1 / MU * few.dissipation_per_length[0] * 0.05
    assert few.worn_volume_per_length[-1] == pytest.approx(expected, rel=1e-3)
    last = few.states[-1]
    assert trapezoid(last, last.worn) == pytest.approx(last.worn_volume_per_length, rel=2e-3)


@pytest.mark.slow
def test_a_roller_wears_to_a_flat_over_any_distance():
    distance = np.array([1.0, 1e2, 1e4, 1e5])
    run = sliding(distance)
    lost = 1e-14 * 10e3 * distance
    np.testing.assert_allclose(run.worn_volume_per_length[:2], lost[:2], rtol=1e-9)
    # Where a grid is made wider the new edge may touch for one jump beside a gap that pulls, whose negative pressure
    # does not wear; whether it does is decided by rounding.  The jump is within the tolerance of the depth (1e-3).
    np.testing.assert_allclose(run.worn_volume_per_length, lost, rtol=2e-5)
    flat = np.cbrt(1.5 * 10e-3 * 1e-14 * 10e3 * distance[1:])
    for state, half in zip(run.states[1:], flat, strict=True):
        assert state.half_width == pytest.approx(half, abs=1.5 * state.places[1])


def test_that_jumps_and_edges_are_coarse_is_stated():
    unworn, worn = sliding(np.array([0.0, 1e-30])), sliding(np.array([0.0, 1e-3]), count=20)
    words = [" ".join(note.statement for note in run.validity) for run in (unworn, worn)]
    assert "greatest worn depth together" in words[1]
    share = f"{np.max(worn.states[-1].pressure) / worn.mean_pressure[-1]:.3g} of the mean"
    assert share in words[1]
    assert "of the mean" not in words[0]


def test_nothing_is_said_of_histories_that_are_not_followed():
    words = " ".join(note.statement for note in limiting().validity)
    assert "Every history" not in words
    assert "for a worn profile too" in words


@pytest.mark.slow
@pytest.mark.parametrize(
    ("problem", "bed", "load"),
    [
        (wk.LineSlidingWear, ROLLER, wk.LineForce(100e3)),
        pytest.param(
            wk.SlidingWear, wk.Foundation(wk.Paraboloid(10e-3), STEEL), wk.Force(100.0), marks=pytest.mark.slow
        ),
    ],
    ids=["line", "round"],
)
def test_after_a_long_distance_the_pressure_is_even_up_to_the_edge(problem, bed, load):
    run = problem(bed, wk.Archard(1e-14), load, np.array([1e4]), count=60).solve()
    last = run.states[-1]
    pressure = last.pressure / last.mean_pressure
    assert np.max(pressure) < 1.1
    np.testing.assert_allclose(pressure[last.nodes < 0.9 * last.edge], 1.0, atol=0.06)


def test_a_flat_pad_wears_until_its_pressure_is_even():
    half, force = 1e-3, 1e5
    pad = wk.LineFoundation(wk.FlatPunch(half), STEEL)
    first, last = sliding(np.array([0.0, 20.0]), bed=pad, normal=wk.LineForce(force)).states
    assert first.pressure[0] == pytest.approx(force / (math.pi * half), rel=1e-3)  # Sadowsky
    np.testing.assert_allclose(last.pressure, force / (2.0 * half), rtol=1e-4)
    bulge = 2.0 * force / (math.pi * STEEL.modulus) * math.log(2.0)
    assert last.worn[-1] - last.worn[0] == pytest.approx(bulge, rel=2e-3)


def test_both_bodies_lose_their_share():
    run = fretting(wear=wk.PairWear(wk.Archard(0.025), wk.Archard(0.075)), cycles=np.array([0.0, 100.0])).solve()
    one = fretting(cycles=np.array([0.0, 100.0])).solve()
    assert run.worn_volume_per_length[-1] == pytest.approx(one.worn_volume_per_length[-1], rel=1e-3)
    assert run.first_volume_per_length[-1] == pytest.approx(0.25 * run.worn_volume_per_length[-1], rel=1e-9)


def slid(cycles):
    return wk.LineSlidingWear(CYLINDER, wk.Archard(0.1), wk.LineForce(FORCE), cycles, count=60)


@pytest.mark.parametrize("made", [lambda cycles: fretting(cycles=cycles), slid], ids=["fretting", "sliding"])
def test_a_march_that_was_stopped_and_kept_goes_on_with_the_same_numbers(made, tmp_path):
    problem = made(np.array([0.0, 0.3, 3.0, 10.0]))
    whole = list(problem.steps())
    kept = read_wear(write_wear(whole[:3], tmp_path / "states.npz"), problem.bed)
    assert list(kept) == whole[:3]
    assert list(problem.steps(start=kept[-1])) == whole[3:]


def test_a_pad_whose_rim_sticks_does_not_wear():
    pad = wk.LineFoundation(wk.FlatPunch(0.1), UNIT)
    run = fretting(bed=pad).solve()
    assert run.worn_volume_per_length[-1] == 0.0
    assert run.stick_half_width[-1] == 0.1
    with pytest.raises(wk.OutsideValidity, match="nothing wears"):
        limiting(pad)


def test_where_the_profile_ends_is_said():
    x = np.linspace(0.0, 0.115, 60)
    short = wk.LineFoundation(wk.Measured(x, 0.5 * x**2), UNIT)
    for problem in (fretting(bed=short), limiting):
        with pytest.raises(wk.OutsideValidity, match="as far as the profile is known"):
            problem(short) if problem is limiting else problem.solve()
    with pytest.raises(wk.OutsideValidity, match="as far as the profile is known"):
        wk.LineSlidingWear(short, wk.Archard(0.1), wk.LineForce(FORCE), np.array([0.0, 1.0]), count=20).solve()


def test_waves_that_would_touch_beside_are_refused():
    waves = wk.LineFoundation(wk.Wavy(1e-3, 1.0), UNIT)
    problem = wk.LineSlidingWear(waves, wk.Archard(1.0), wk.LineForce(1e-3), np.array([0.0, 10.0]), count=40)
    with pytest.raises(wk.OutsideValidity, match="several strips"):
        problem.solve()


@pytest.mark.parametrize(
    ("changes", "error", "words"),
    [
        ({"amplitude": wk.LineShearForce(MU * FORCE)}, wk.OutsideValidity, "slide away"),
        ({"amplitude": wk.LineShearForce([1.0, 2.0])}, wk.InvalidInput, "one positive number"),
        ({"amplitude": wk.LineShearForce(-1.0)}, wk.InvalidInput, "one positive number"),
        ({"amplitude": wk.Shift(1e-6)}, wk.InvalidInput, "amplitude"),
        ({"normal": wk.LineForce(0.0)}, wk.InvalidInput, "one positive number"),
        ({"normal": wk.Force(1.0)}, wk.InvalidInput, "normal"),
        ({"cycles": [3.0, 1.0]}, wk.InvalidInput, "rise"),
        ({"bed": wk.Foundation(wk.Paraboloid(1.0), UNIT)}, wk.InvalidInput, "bed"),
        ({"law": wk.Coulomb(math.inf)}, wk.InvalidInput, "coefficient"),
    ],
)
def test_a_wrong_question_is_refused_in_one_sentence(changes, error, words):
    with pytest.raises(error, match=words):
        fretting(**changes).solve()


@pytest.mark.parametrize("sought", ["pressure", "worn", "height"])
@pytest.mark.parametrize("x", ["far", math.nan])
def test_places_that_are_none_are_refused(sought, x):
    with pytest.raises(wk.InvalidInput, match=f"LineLimitingSolution.{sought}: x"):
        getattr(limiting(), sought)(x)


@pytest.mark.parametrize(
    "profile",
    [wk.Sphere(1.0), wk.Cone(1.4), wk.RoundedPunch(0.05, 1.0), wk.TruncatedCone(1.4, 0.05), wk.Paraboloid(1.0)],
)
def test_the_distance_beside_a_strip_is_the_integral_of_its_slope(profile):
    bed, c = wk.LineFoundation(profile, UNIT), 0.1
    x = np.array([0.5, 1.0, 1.0001, 1.3, 2.5]) * c
    expected = [0.0, *np.cumsum([_opened(bed, c, *ends) for ends in itertools.pairwise(x[1:])])]
    np.testing.assert_allclose(bed.separation(x[1:], c, 0.0), expected, rtol=1e-11, atol=1e-17)
    assert float(bed.separation(x[:1], c, 0.0)[0]) == 0.0


def _opened(bed, c, low, high):
    """The slope of the distance, summed; above a edge or kink it begins like a root."""
    marks = [low, *(b for b, _ in bed.kinks if low < b < high), high]
    node, weight = np.polynomial.legendre.leggauss(40)
    t = 0.5 * (node + 1.0)
    return sum(
        float(np.sum(bed.opening(a + (b - a) * t**2, c) * t * weight)) * (b - a) for a, b in itertools.pairwise(marks)
    )


@pytest.mark.parametrize(("part", "count", "standing"), [
    (0.5, 80, wk.Standing.ASYMPTOTIC),
    (1e-3, 100, wk.Standing.APPROXIMATE),
    (1e-4, 100, wk.Standing.OUTSIDE),
    (1e-4, 800, wk.Standing.ASYMPTOTIC),
])  # fmt: skip
def test_how_well_a_grid_resolves_a_small_swing_is_stated(part, count, standing):
    """By Hertz's pressure and mu times the distance that a narrower cylinder leaves open, place by place."""
    swing = wk.LineShearForce(part * MU * FORCE)
    run = fretting(amplitude=swing, cycles=np.array([1e-9]), count=count).solve()
    with mpmath.workdps(30):
        c = mpmath.sqrt(1 - mpmath.mpf(part))  # of the half-width

        def rate(x):
            return mpmath.sqrt(1 - x**2) * (x / c * mpmath.sqrt((x / c) ** 2 - 1) - mpmath.acosh(x / c))

        # four amplitudes a cycle, two sides, p_0 = 2 P/(pi a), h = c^2/(2R) (...)
        loss = float(8 * mpmath.quad(rate, [c, (1 + c) / 2, 1]) * c**2 / 2) * A**2 * MU**2 * 2.0 * FORCE / math.pi
    error = run.dissipation_per_length[0] / loss - 1.0
    (note,) = (note for note in run.validity if "In a cycle before wear" in note.statement)
    more = "more" if error > 0.0 else "less"
    assert f"the grid dissipates {100.0 * abs(error):.2g} per cent {more} than" in note.statement
    assert note.standing is standing
