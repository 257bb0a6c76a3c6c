"""Profiles pressed on each other: Hertz, CONTACT's grooves and wheels, several patches, creepages, refusals."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

import winkler as wk
from winkler.problems.profile_pair.creepages import creepage_at
from winkler.problems.profile_pair.placing import lower_body, upper_body

STEEL = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace(STEEL, STEEL)
Y = np.linspace(-20e-3, 20e-3, 81)
FLAT = wk.CrossProfile(Y, 0.0 * Y)


def arc(radius, y=Y):
    """A profile that bends down (positive radius) or up."""
    return wk.CrossProfile(y, math.copysign(1.0, radius) * (np.sqrt(radius**2 - y**2) - abs(radius)))


def table(file):
    lines = [line for line in file.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    return np.genfromtxt(lines, delimiter=",", names=True)


@pytest.fixture(scope="module")
def manchester(shared_data):
    """Rail, wheel and CONTACT's answers."""
    folder = shared_data / "reference" / "contact" / "manchester"
    rail, wheel = (
        wk.CrossProfile(points["y_m"], -points["z_m"])
        for points in (table(folder / "rail_uic60.csv"), table(folder / "wheel_s1002.csv"))
    )
    return rail, wheel, table(folder / "left_wheel.csv")


def placed(manchester, case, **more):
    """The mirror image of a left wheel: y, yaw and roll change their signs."""
    rail, wheel, answers = manchester
    row = answers[case]
    y, yaw, roll = -row["y_wheelset_m"], -row["yaw_rad"], -row["roll_rad"]
    lateral = y + 0.75 * math.cos(yaw) - 0.46 * math.sin(roll) - 0.7605326
    steel = wk.Elastic(2.0 * 82e9 * 1.28, 0.28)
    return (
        wk.ProfilePair(
            rail, wheel, wk.HalfSpace(steel, steel), wk.Force(1e4), lateral, yaw, roll, second_radius=0.46,
            rolled_radius=-2.0 / row["pitch_speed_rad_per_s"], **more,
        ),
        row,
    )  # fmt: skip


def test_a_ball_is_that_of_hertz():
    """Depth 0.16 mm, radius 0.1 m, against the closed form of ball_by_profile in the reference data."""
    steel = wk.Elastic(2.0 * 82e9 * 1.28, 0.28)
    found = wk.ProfilePair(FLAT, arc(-0.1), wk.HalfSpace(steel, steel), wk.Depth(1.6e-4), second_radius=0.1).solve()
    assert found.force == pytest.approx(97185.185, rel=5e-4)
    assert found.peak_pressure == pytest.approx(2900156740.8, rel=1e-3)
    assert found.area == pytest.approx(math.pi * 0.004**2, rel=0.01)
    assert [found.angle, found.lateral_force / found.force, found.place] == pytest.approx([0.0, 0.0, 0.0], abs=1e-6)


@pytest.mark.parametrize("angle", [0.3, -0.5])
def test_crossed_cylinders_are_an_ellipse_of_hertz(angle):
    """Two straight cylinders at an angle, by yaw, against the closed form."""
    found = wk.ProfilePair(arc(0.3), arc(-0.2), PAIR, wk.Force(1e3), yaw=angle, pixels=64).solve()
    bodies = wk.CurvedPair(math.inf, 0.3, math.inf, 0.2, angle)
    hertz = wk.EllipticIndentation(bodies, PAIR, wk.Force(1e3)).solve()
    assert found.depth == pytest.approx(hertz.depth, rel=1e-3)
    assert found.peak_pressure == pytest.approx(hertz.peak_pressure, rel=2e-3)


def test_a_yawed_roller_on_a_roller_is_an_ellipse_too():
    bodies = wk.CurvedPair(0.05, 0.3, 0.04, 0.2, 0.2)
    hertz = wk.EllipticIndentation(bodies, PAIR, wk.Force(1e3)).solve()
    found = wk.ProfilePair(
        arc(0.3), arc(-0.2), PAIR, wk.Force(1e3), yaw=0.2, first_radius=0.05, second_radius=0.04, pixels=64
    ).solve()
    assert found.depth == pytest.approx(hertz.depth, rel=2e-3)
    assert found.peak_pressure == pytest.approx(hertz.peak_pressure, rel=4e-3)


@pytest.mark.parametrize(("radius", "peak", "width"), [(10.25e-3, 5.302e8, 0.00575), (10.05e-3, 3.487e8, 0.01125)])
def test_a_deep_groove_is_that_of_contact(radius, peak, width):
    """groove_conformal: with friction there, which the pressures hardly feel; one element there is 0.25 mm wide."""
    turn = np.linspace(-1.2, 1.2, 161)
    groove, tread = (wk.CrossProfile(r * np.sin(turn), r * (1.0 - np.cos(turn))) for r in (radius, 0.01))
    steel = wk.Elastic(2.0 * 80e9 * 1.28, 0.28)
    found = wk.ProfilePair(groove, tread, wk.HalfSpace(steel, steel), wk.Force(1e4), second_radius=0.42).solve()
    assert found.peak_pressure == pytest.approx(peak, rel=0.013)
    assert found.patches[0].lateral_length == pytest.approx(width, abs=0.25e-3)
    assert found.patches[0].turned == pytest.approx(width / radius, rel=0.05)


@pytest.mark.few(3)
@pytest.mark.parametrize("case", range(6))
def test_a_wheel_on_a_rail_is_that_of_contact(manchester, case):
    """Six positions of the Manchester benchmark, placed by the profiles alone; CONTACT has friction too."""
    problem, row = placed(manchester, case, pixels=64)
    found = problem.solve()
    (patch,) = found.patches
    assert found.depth == pytest.approx(row["approach_m"], rel=4e-3)
    assert found.peak_pressure == pytest.approx(row["peak_pressure_Pa"], rel=5e-3)
    assert patch.force == pytest.approx(row["normal_force_N"], rel=6e-3)
    assert patch.area == pytest.approx(row["area_m2"], rel=0.03)
    assert patch.y == pytest.approx(-row["contact_y_rail_m"], abs=0.03 * row["width_s_m"])
    assert patch.angle == pytest.approx(row["contact_angle_rad"], abs=2e-3)
    assert patch.longitudinal_length == pytest.approx(row["length_x_m"], abs=0.3e-3)


@pytest.mark.parametrize("case", range(6))
def test_creepages_are_those_of_contact(manchester, case):
    """At CONTACT's place of contact, an average over the overlap: of the wheel over the rail, in the mirror image."""
    problem, row = placed(manchester, case)
    lower = lower_body(problem.first, math.inf)
    touch = problem.placing
    height = -float(np.nanmin(touch.gap)) - row["approach_m"]
    upper = upper_body(problem.second, 0.46, problem.lateral, problem.yaw, problem.roll).raised(height)
    y = -row["contact_y_rail_m"]
    x = float(np.interp(y, touch.y, touch.x))
    place = np.array([x, y, float(problem.first.height(np.array(y)))])
    found = creepage_at(lower, upper, place, -row["approach_m"], problem.rolled_radius)
    assert found.longitudinal == pytest.approx(-row["creep_x"], rel=4e-3, abs=2e-6)
    assert found.lateral == pytest.approx(row["creep_y"], rel=3e-3, abs=1e-9)
    assert found.spin == pytest.approx(row["spin_1_per_m"], rel=6e-3)


@pytest.mark.slow
def test_two_patches_bear_half_each():
    """Two arcs, far apart, on a flat: each is a ball under half of the load, which the other one sinks a little."""
    y = np.linspace(-30e-3, 30e-3, 241)
    hills = wk.CrossProfile(y, 100e-3 - np.sqrt(100e-3**2 - (np.abs(y) - 15e-3) ** 2))
    found = wk.ProfilePair(wk.CrossProfile(y, 0.0 * y), hills, PAIR, wk.Force(200.0), second_radius=0.1).solve()
    ball = wk.Indentation(wk.Foundation(wk.Paraboloid(0.1), PAIR), wk.Force(100.0)).solve()
    assert [patch.y for patch in found.patches] == pytest.approx([-15e-3, 15e-3], abs=1e-6) or [
        patch.y for patch in found.patches
    ] == pytest.approx([15e-3, -15e-3], abs=1e-6)
    assert [patch.force for patch in found.patches] == pytest.approx([100.0, 100.0], rel=1e-4)
    sunk = 100.0 / (math.pi * PAIR.modulus * 30e-3)  # by the force of the other ball
    assert sunk > 5e-3 * ball.depth
    assert found.depth == pytest.approx(ball.depth + sunk, rel=5e-4)
    assert found.windows == 2
    apart = [note for note in found.validity if note.assumption is wk.Assumption.SINGLE_CONTACT]
    assert len(apart) == 1


def test_near_patches_know_of_each_other():
    """Two hills 2 mm apart, in one window, sink each other: deeper than a hill of its own under half of the load."""
    y = np.linspace(-10e-3, 10e-3, 161)
    hills = wk.CrossProfile(y, 20e-6 * (1.0 - np.cos(2.0 * np.pi * (y - 1e-3) / 2e-3)) * (np.abs(y) < 2e-3)
                            + 40e-6 * (np.abs(y) >= 2e-3))  # fmt: skip
    found = wk.ProfilePair(wk.CrossProfile(y, 0.0 * y), hills, PAIR, wk.Force(500.0), second_radius=0.05).solve()
    assert len(found.patches) == 2
    assert found.windows == 1
    assert [patch.force for patch in found.patches] == pytest.approx([250.0, 250.0], rel=0.02)


def test_straight_lines_between_points_press_harder(manchester):
    """The profiles as polygons: the edges raise the peak; the splines do not."""
    problem, row = placed(manchester, 0, pixels=64)

    def joined(profile):
        first, last = profile.ends
        y = np.linspace(first + 1e-3, last - 1e-3, 20_001)
        return wk.CrossProfile(y, np.interp(y, profile.y, profile.z))

    wheel = wk.CrossProfile(problem.second.y[60:], problem.second.z[60:])
    order = np.argsort(problem.first.y)
    rail = wk.CrossProfile(problem.first.y[order][150:-150], problem.first.z[order][150:-150])
    polygons = wk.ProfilePair(
        joined(rail), joined(wheel), problem.medium, problem.load, problem.lateral, second_radius=0.46, pixels=128
    )
    assert polygons.solve().peak_pressure > 1.12 * row["peak_pressure_Pa"]


@pytest.mark.slow
def test_forces_of_a_slope_and_stresses_below():
    """A ball on an inclined plane: the force stands on the plane; the patch has the stresses below it."""
    slope = wk.CrossProfile(Y, 0.1 * Y)
    strong = wk.Elastic(210e9, 0.3, strength=1e9)
    ball = arc(-0.1)
    found = wk.ProfilePair(slope, ball, wk.HalfSpace(strong, STEEL), wk.Force(500.0), second_radius=0.1).solve()
    (patch,) = found.patches
    assert patch.angle == pytest.approx(math.atan(0.1), rel=1e-4)
    assert patch.force == pytest.approx(500.0 / math.cos(math.atan(0.1)), rel=1e-4)
    assert found.lateral_force == pytest.approx(-0.1 * 500.0, rel=1e-4)
    spot = patch.greatest_stress()
    assert spot.value == pytest.approx(0.620 * patch.peak_pressure, rel=4e-3)
    assert [spot.x, spot.y] == pytest.approx([0.0, 0.0], abs=0.02 * patch.longitudinal_length)
    assert any("strength of the first body" in note.statement for note in found.validity)


def test_rolling_without_slip_has_no_creepage():
    ball = wk.ProfilePair(FLAT, arc(-0.1), PAIR, wk.Force(1e3), second_radius=0.1).solve()
    assert abs(ball.longitudinal_creepage) < 1e-4  # the drop over the radius
    braked = wk.ProfilePair(FLAT, arc(-0.1), PAIR, wk.Force(1e3), second_radius=0.1, rolled_radius=0.101).solve()
    assert braked.longitudinal_creepage == pytest.approx(0.01 / 1.005, rel=2e-2)


def test_smoothing_takes_the_scatter_of_points_away():
    rng = np.random.default_rng(3)
    y = np.linspace(-20e-3, 20e-3, 401)
    exact = np.sqrt(0.3**2 - y**2) - 0.3
    rough = exact + 2e-6 * rng.normal(size=y.size)
    smooth = wk.CrossProfile(y, rough, smoothing=2e-6)
    middle = np.linspace(-15e-3, 15e-3, 31)
    assert np.max(np.abs(smooth.height(middle) - (np.sqrt(0.3**2 - middle**2) - 0.3))) < 1.5e-6
    assert float(smooth.curvature(np.array(0.0))) == pytest.approx(-1.0 / 0.3, rel=0.3)


def test_refusals():
    with pytest.raises(wk.InvalidInput, match="do not meet"):
        wk.ProfilePair(FLAT, arc(-0.1), PAIR, wk.Force(1.0), 0.1, second_radius=0.1).solve()
    with pytest.raises(wk.InvalidInput, match="first touch at the end"):
        wk.ProfilePair(FLAT, arc(-0.1), PAIR, wk.Force(1.0), 0.0, 0.0, 0.4, second_radius=0.1).solve()
    with pytest.raises(wk.InvalidInput, match="straight along the same direction"):
        wk.ProfilePair(FLAT, arc(-0.1), PAIR, wk.Force(1.0)).solve()
    with pytest.raises(wk.InvalidInput, match="one positive number"):
        wk.ProfilePair(FLAT, arc(-0.1), PAIR, wk.Force([1.0, 2.0]), second_radius=0.1)
    with pytest.raises(wk.InvalidInput, match="two rows of at least 5"):
        wk.CrossProfile(Y, Y[:-1])
    with pytest.raises(wk.InvalidInput, match="steeper than 80 degrees"):
        wk.CrossProfile(1e-3 * Y, Y)
    narrow = wk.CrossProfile(Y[36:45], 0.0 * Y[36:45])
    found = wk.ProfilePair(narrow, arc(-0.1), PAIR, wk.Force(50e3), second_radius=0.1, pixels=32).solve()
    assert found.cut
    assert any(note.standing is wk.Standing.OUTSIDE for note in found.validity)


RATIOS = [(0.1, 3.0), (10.0, 0.3), (0.1, 0.3), (0.1, 10.0), (10.0, 3.0), (10.0, 10.0)]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("contrast", "ratio"), [pytest.param(*pair, marks=[pytest.mark.slow] if n else []) for n, pair in enumerate(RATIOS)]
)
def test_a_ball_on_a_coating_is_that_of_the_round_engine(contrast, ratio):
    """Another derivation (springs of flat punches); the base is felt: its half-space gives other pressures."""
    y = np.linspace(-2e-3, 2e-3, 81)
    ball = wk.CrossProfile(y, 10e-3 - np.sqrt(10e-3**2 - y**2))
    coat = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(contrast * 210e9, 0.25), 100e-6 / ratio)], on=STEEL)
    true = wk.Indentation(wk.Foundation(wk.Sphere(10e-3), coat), wk.Radius(100e-6)).solve()
    pair = wk.ProfilePair(wk.CrossProfile(y, 0.0 * y), ball, coat, wk.Force(float(true.force)), second_radius=10e-3)
    found = pair.solve()
    assert found.depth == pytest.approx(true.depth, rel=1e-4)
    assert found.peak_pressure == pytest.approx(true.peak_pressure, rel=min(found.grid_error, 3e-3))
    assert "layers" in found.validity[0].statement
    assert abs(dataclasses.replace(pair, medium=PAIR).solve().peak_pressure / found.peak_pressure - 1.0) > 0.02


@pytest.mark.slow
def test_places_far_from_each_other_sink_each_other_through_the_base():
    """Two arcs on a soft coating: each is a ball under half of the load, which the other one sinks as on bare steel."""
    y = np.linspace(-30e-3, 30e-3, 241)
    hills = wk.CrossProfile(y, 100e-3 - np.sqrt(100e-3**2 - (np.abs(y) - 15e-3) ** 2))
    coat = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(21e9, 0.3), 50e-6)], on=STEEL)
    found = wk.ProfilePair(wk.CrossProfile(y, 0.0 * y), hills, coat, wk.Force(200.0), second_radius=0.1).solve()
    ball = wk.Indentation(wk.Foundation(wk.Paraboloid(0.1), coat), wk.Force(100.0)).solve()
    sunk = 100.0 / (math.pi * wk.HalfSpace(STEEL).modulus * 30e-3)
    assert sunk > 2e-3 * ball.depth
    assert found.depth == pytest.approx(ball.depth + sunk, rel=5e-4)
    assert found.windows == 2
