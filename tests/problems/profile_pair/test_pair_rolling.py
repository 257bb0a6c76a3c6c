"""Profiles that roll with friction: CONTACT's wheels and grooves, closed forms, balance of forces, refusals."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

import winkler as wk
from winkler.problems.profile_pair.pressed_pair import pressed_pair

STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.28), wk.Elastic(210e9, 0.28))
Y = np.linspace(-2e-3, 2e-3, 41)
FLAT, BALL = wk.CrossProfile(Y, 0.0 * Y), wk.CrossProfile(Y, 10e-3 - np.sqrt(10e-3**2 - Y**2))
MU = wk.Coulomb(0.3)


def on_flat(**more):
    """A ball of 10 mm on a flat under 100 N."""
    return wk.ProfilePair(FLAT, BALL, STEEL, wk.Force(100.0), second_radius=10e-3, **more)


def table(file):
    lines = [line for line in file.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    return np.genfromtxt(lines, delimiter=",", names=True)


@pytest.fixture(scope="module")
def manchester(shared_data):
    """Return what places the mirror image of a left wheel of CONTACT, and its answer."""
    folder = shared_data / "reference" / "contact" / "manchester"
    rail, wheel = (
        wk.CrossProfile(points["y_m"], -points["z_m"])
        for points in (table(folder / "rail_uic60.csv"), table(folder / "wheel_s1002.csv"))
    )
    answers = table(folder / "left_wheel.csv")
    steel = wk.Elastic(2.0 * 82e9 * 1.28, 0.28)

    def placed(case):
        row = answers[case]
        yaw, roll = -row["yaw_rad"], -row["roll_rad"]
        lateral = -row["y_wheelset_m"] + 0.75 * math.cos(yaw) - 0.46 * math.sin(roll) - 0.7605326
        turned = -2.0 / row["pitch_speed_rad_per_s"]
        return wk.ProfilePair(
            rail, wheel, wk.HalfSpace(steel, steel), wk.Force(1e4), lateral, yaw, roll, second_radius=0.46,
            rolled_radius=turned, pixels=64,
        ), row  # fmt: skip

    return placed


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("case", [1, 2, 3, 4, 5])
def test_forces_of_a_wheel_are_those_of_contact(manchester, case):
    """Five positions, placed by the profiles alone; friction of the mirror image changes its sign across.

    CONTACT states 1 % of mu F for forces, and that force times creepage is better than the power that it prints.
    """
    pair, row = manchester(case)
    found = wk.ProfilePairRolling(pair, MU).solve()
    (patch,) = found.patches
    most = 0.3 * row["normal_force_N"]
    assert patch.patch.force == pytest.approx(row["normal_force_N"], rel=2e-3)
    assert patch.longitudinal_force == pytest.approx(row["force_x_N"], abs=0.005 * most)
    assert patch.lateral_force == pytest.approx(-row["force_s_N"], abs=0.005 * most)
    assert found.x_force == pytest.approx(-row["force_x_track_N"], abs=0.005 * most)
    assert found.y_force == pytest.approx(row["force_y_track_N"], abs=0.006 * most)
    assert found.z_force == pytest.approx(1e4, rel=1e-4)
    assert patch.creepage.longitudinal == pytest.approx(-row["creep_x"], rel=4e-3)
    assert patch.creepage.lateral == pytest.approx(row["creep_y"], rel=3e-3)
    lost = row["force_x_N"] * -row["creep_x"] - row["force_s_N"] * row["creep_y"]
    lost -= row["moment_n_Nm"] * row["spin_1_per_m"]
    assert found.loss_per_distance == pytest.approx(lost, rel=0.01)
    assert patch.stick_share == row["stick_share"] == 0.0
    assert found.saturation[0] == pytest.approx(1.0, abs=3e-3)


@pytest.mark.slow
def test_a_wheel_that_rolls_freely_is_that_of_contact(manchester):
    """The first position.  CONTACT takes slip of a plane; on the arc radii of wheel and rail differ by 0.1 mm.

    So its slip is put on the pressures that the profiles give; the same on the arc pushes by a few per cent of mu F.
    """
    pair, row = manchester(0)
    (region,) = pressed_pair(pair).windows.regions
    gaps = region.gaps
    nx, ny = gaps.gap.shape
    heights = wk.Topography(-gaps.gap, np.array([nx, ny]) * gaps.pixel, periodic=False)
    to_middle = float(np.interp(-row["contact_y_rail_m"], gaps.y, np.arange(ny))) - 0.5 * (ny - 1)
    spin = row["spin_1_per_m"]
    plane = wk.Creepage(-row["creep_x"] + spin * to_middle * gaps.pixel[1], row["creep_y"], spin)
    found = wk.SurfaceRolling(heights, pair.medium, wk.Force(9997.0), MU, plane).solve()
    most = 0.3 * row["normal_force_N"]
    assert found.longitudinal_force == pytest.approx(row["force_x_N"], abs=0.01 * most)
    assert found.lateral_force == pytest.approx(-row["force_s_N"], abs=0.02 * 253.6)
    rolled = wk.ProfilePairRolling(pair, MU).solve()
    assert rolled.lateral_force[0] == pytest.approx(-row["force_s_N"], abs=0.005 * most)
    assert abs(rolled.longitudinal_force[0]) < 0.06 * most
    assert rolled.stick_share[0] == pytest.approx(row["stick_share"], abs=0.04)


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize(
    ("radius", "creep", "power", "sticks"),
    [
        (10.25e-3, 2.809e-4, 8.395e-2, 862 / 1187),
        pytest.param(10.05e-3, 9.767e-4, 6.444e-1, 635 / 1843, marks=pytest.mark.slow),
    ],
)
def test_a_groove_that_rolls_freely_is_that_of_contact(radius, creep, power, sticks):
    """Slip of Heathcote.  CONTACT's creepage stands at the mean place of the overlap, on a grid of 0.25 mm.

    Its power is that of the slip in each element, which a grid makes too small.
    """
    turn = np.linspace(-1.2, 1.2, 161)
    groove, tread = (wk.CrossProfile(r * np.sin(turn), r * (1.0 - np.cos(turn))) for r in (radius, 10e-3))
    steel = wk.Elastic(2.0 * 80e9 * 1.28, 0.28)
    pair = wk.ProfilePair(groove, tread, wk.HalfSpace(steel, steel), wk.Force(1e4), second_radius=0.42, pixels=64)
    gaps = pressed_pair(pair).windows.regions[0].gaps
    higher = float(np.mean(np.broadcast_to(gaps.z, gaps.gap.shape)[gaps.gap < 0.0]))
    bottom = creep - higher / 0.42
    steps = bottom * np.array([1.2, 0.8])
    sides = [
        wk.ProfilePairRolling(dataclasses.replace(pair, rolled_radius=0.42 / (1.0 - xi)), MU).solve() for xi in steps
    ]
    forces = [float(side.longitudinal_force[0]) for side in sides]
    free = float(np.interp(0.0, forces, steps))
    assert free == pytest.approx(bottom, abs=0.06 * creep)
    found = wk.ProfilePairRolling(dataclasses.replace(pair, rolled_radius=0.42 / (1.0 - free)), MU).solve()
    assert abs(found.longitudinal_force[0]) < 0.02 * 3e3
    assert abs(found.lateral_force[0]) < 1e-3 * 3e3
    (patch,) = found.patches
    pixel = float(np.prod(patch.surface_load.pixel))
    slipped = pixel * float(np.sum(patch.traction * patch.creep))
    assert 0.42 * slipped == pytest.approx(power, rel=0.06)
    assert found.loss_per_distance > 1.02 * slipped
    assert found.stick_share[0] == pytest.approx(sticks, abs=0.03)


def test_a_ball_rolls_as_its_height_map():
    """With a drift across, a turn and a braked axle, against boundary elements of the paraboloid."""
    pair = dataclasses.replace(on_flat(rolled_radius=10.0008e-3, pixels=64), load=wk.Force(0.1))
    found = wk.ProfilePairRolling(pair, MU, lateral_drift=4e-5, yaw_rate=2.0).solve()
    (patch,) = found.patches
    (creep,) = (each.creepage for each in found.patches)
    assert [creep.lateral, creep.spin] == pytest.approx([4e-5, 2.0], rel=2e-3)
    rough = wk.SampledProfile([0.06e-3, 0.06e-3], wk.Paraboloid(10e-3), (65, 65))
    alike = wk.SurfaceRolling(rough, STEEL, wk.Force(0.1), MU, creep).solve()
    for name in ("longitudinal_force", "lateral_force"):
        assert getattr(patch, name) == pytest.approx(getattr(alike, name), abs=0.006 * 0.03)
    assert found.loss_per_distance == pytest.approx(alike.loss_per_distance, rel=0.03)
    assert patch.stick_share == pytest.approx(alike.stick_share, abs=0.04)


def on_layers(medium, **more):
    """A ball that drifts and is braked on a flat under 0.1 N, with a contact of about 10 micrometres."""
    pair = dataclasses.replace(on_flat(rolled_radius=10.003e-3, pixels=32), load=wk.Force(0.1), medium=medium)
    return wk.ProfilePairRolling(dataclasses.replace(pair, **more), MU, lateral_drift=2e-4).solve()


@pytest.mark.few(2)
@pytest.mark.parametrize("thickness", [10e-6, 3e-6, 30e-6])
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_a_ball_rolls_on_a_coating_as_its_height_map(contrast, thickness):
    """Radii of ball and flat differ by 1e-6 across the patch, so that its creepage is that of its middle."""
    coat = wk.CoatedHalfSpace(
        [wk.Layer(wk.Elastic(contrast * 210e9, 0.3), thickness)], on=STEEL.first, second=STEEL.first
    )
    found = on_layers(coat)
    (patch,) = found.patches
    side = 1.2 * patch.patch.longitudinal_length
    rough = wk.SampledProfile([side, side], wk.Paraboloid(10e-3), (41, 41))
    alike = wk.SurfaceRolling(rough, coat, wk.Force(0.1), MU, patch.creepage).solve()
    for name in ("longitudinal_force", "lateral_force"):
        assert getattr(patch, name) == pytest.approx(getattr(alike, name), abs=0.01 * 0.03), name
    assert found.loss_per_distance == pytest.approx(alike.loss_per_distance, rel=0.02)
    assert patch.stick_share == pytest.approx(alike.stick_share, abs=0.04)
    assert patch.patch.peak_pressure == pytest.approx(alike.last.pressure.max(), rel=3e-3)


@pytest.mark.slow
def test_layers_of_the_same_solid_roll_as_profiles_on_a_half_space():
    solid = STEEL.first
    want = on_layers(STEEL)
    coats = wk.CoatedHalfSpace([wk.Layer(solid, 2e-6), wk.Layer(solid, 5e-6)], on=solid, second=solid)
    grading = wk.DepthGradedHalfSpace(wk.ExponentialGrading(210e9, 210e9 * (1.0 + 1e-9), 1e-5, 0.28), second=solid)
    for medium, rel in ((coats, 1e-6), (grading, 1e-5)):
        found = on_layers(medium)
        for name in ("x_force", "y_force", "z_force", "depth", "loss_per_distance"):
            assert getattr(found, name) == pytest.approx(getattr(want, name), rel=rel, abs=1e-9), name
    with pytest.raises(
        wk.OutsideValidity, match="the stress below the surface of a height map on a DepthGradedHalfSpace"
    ):
        found.patches[0].stresses(0.0, 0.0, 1e-6)


@pytest.mark.slow
def test_what_lies_below_the_layer_of_rolling_profiles_is_felt():
    """At a/h = 3 the base counts, and thin layers tend to it in proportion to their thickness."""
    solid, soft = STEEL.first, wk.Elastic(21e9, 0.28)
    steel, weak, *thin = (
        on_layers(wk.CoatedHalfSpace([wk.Layer(soft, h)], on=base, second=solid))
        for base, h in ((solid, 3e-6), (soft, 3e-6), (solid, 2e-8), (solid, 1e-8))
    )
    assert weak.depth > 2.0 * steel.depth
    assert abs(weak.y_force) < 0.96 * abs(steel.y_force)
    bare = on_layers(STEEL)
    for name in ("x_force", "y_force", "depth"):
        thick, half = (getattr(each, name) - getattr(bare, name) for each in thin)
        assert thick / half == pytest.approx(2.0, rel=0.1), name


@pytest.mark.parametrize(
    ("medium", "why"),
    [
        (wk.SlidingFilm([wk.Layer(STEEL.first, 1e-6)], on=STEEL.first), "of a SlidingFilm that slides carries no"),
        (wk.GradedHalfSpace.between(wk.PowerLawGraded(210e9, 1e-3, 1.0, 0.5)), "no tangential stiffness"),
    ],
)
def test_profiles_do_not_roll_on_what_bears_no_tractions(medium, why):
    with pytest.raises(wk.OutsideValidity, match=why):
        wk.ProfilePairRolling(dataclasses.replace(on_flat(), medium=medium), MU)


@pytest.mark.parametrize("drift", [0.05, -0.05])
def test_a_ball_that_slides_on_a_slope(drift):
    """Coulomb: F_N (cos - mu sin) bears the force where it is pushed up the slope, F_N (cos + mu sin) where down."""
    y = np.linspace(-20e-3, 20e-3, 21)
    ball = wk.CrossProfile(y, 0.1 - np.sqrt(0.01 - y**2))
    cosine = 1.0 / math.hypot(1.0, 0.1)
    pair = wk.ProfilePair(
        wk.CrossProfile(y, 0.1 * y),
        ball,
        STEEL,
        wk.Force(1e3),
        second_radius=0.1,
        rolled_radius=0.1 * cosine,
        pixels=48,
    )
    found = wk.ProfilePairRolling(pair, MU, lateral_drift=drift).solve()
    sign = math.copysign(1.0, drift)
    normal = 1e3 / (cosine - 0.3 * sign * 0.1 * cosine)
    assert found.force[0] == pytest.approx(normal, rel=2e-5)
    assert found.lateral_force[0] == pytest.approx(0.3 * sign * normal, rel=1e-4)
    assert found.y_force == pytest.approx(-(0.1 + 0.3 * sign) * cosine * normal, rel=1e-4)
    assert found.z_force == pytest.approx(1e3, rel=1e-6)
    assert found.stick_share[0] == 0.0


def test_a_turn_about_the_direction_along_moves_the_bottom_aside():
    """The zero of the profile lies 5 mm above the bottom; with its side at +y going down that moves towards -y."""
    pair = dataclasses.replace(on_flat(pixels=32), second=wk.CrossProfile(Y, BALL.z - 5e-3), second_radius=5e-3)
    pair = dataclasses.replace(pair, rolled_radius=10e-3)
    found = wk.ProfilePairRolling(pair, MU, roll_rate=0.1).solve()
    assert found.lateral_creepage[0] == pytest.approx(-0.1 * 5e-3, rel=1e-2)


@pytest.mark.slow
def test_two_patches_bear_together():
    """Two hills 30 mm apart: each drags as a ball of its own would, and their sums are those of the pair."""
    y = np.linspace(-30e-3, 30e-3, 241)
    hills = wk.CrossProfile(y, 100e-3 - np.sqrt(100e-3**2 - (np.abs(y) - 15e-3) ** 2))
    flat = wk.CrossProfile(y, 0.0 * y)
    pair = wk.ProfilePair(
        flat, hills, STEEL, wk.Force(200.0), second_radius=0.1, rolled_radius=0.10002, pixels=48, lateral=0.0
    )
    found = wk.ProfilePairRolling(pair, MU).solve()
    assert len(found.patches) == found.windows == 2
    assert found.longitudinal_force[0] == pytest.approx(found.longitudinal_force[1], rel=1e-3)
    assert found.x_force == pytest.approx(-float(np.sum(found.longitudinal_force)), rel=1e-12)
    assert found.place.tolist() == sorted(found.place, key=lambda place: -found.force[list(found.place).index(place)])
    single = dataclasses.replace(on_flat(), first=flat, load=wk.Force(100.0), second_radius=0.1, pixels=48)
    ball = wk.CrossProfile(y, 100e-3 - np.sqrt(100e-3**2 - y**2))
    alone = wk.ProfilePairRolling(dataclasses.replace(single, second=ball, rolled_radius=0.10002), MU).solve()
    assert found.longitudinal_force[0] == pytest.approx(alone.longitudinal_force[0], rel=5e-3)


@pytest.mark.slow
def test_notes_state_creepage_and_yield():
    strong = wk.HalfSpace.between(wk.Elastic(210e9, 0.28, strength=0.8e9), wk.Elastic(210e9, 0.28, strength=0.8e9))
    braked = dataclasses.replace(on_flat(rolled_radius=12e-3, pixels=32), medium=strong)
    found = wk.ProfilePairRolling(braked, MU).solve()
    small = [note for note in found.validity if note.assumption is wk.Assumption.SMALL_SLOPES]
    (note,) = small
    assert note.standing is wk.Standing.OUTSIDE
    assert note.statement.count(".") - note.statement.count(". ") >= 1
    assert "here they reach 18 per cent, and its limit is 10 per cent" in note.statement
    gentle = wk.ProfilePairRolling(on_flat(pixels=32), MU).solve()
    (note,) = (note for note in gentle.validity if note.assumption is wk.Assumption.SMALL_SLOPES)
    assert note.standing is wk.Standing.ASYMPTOTIC
    (worn,) = (note for note in found.validity if note.assumption is wk.Assumption.ELASTIC)
    assert worn.standing is wk.Standing.OUTSIDE


def test_refusals():
    far = dataclasses.replace(on_flat(), lateral=0.1)
    with pytest.raises(
        wk.InvalidInput, match=r"^ProfilePair: the profiles do not meet: .*; give another lateral position\.$"
    ):
        wk.ProfilePairRolling(far, MU).solve()
    narrow = wk.CrossProfile(0.02 * Y, 0.0 * Y)
    cut = dataclasses.replace(on_flat(pixels=32), first=narrow)
    with pytest.raises(
        wk.OutsideValidity, match=r"^ProfilePairRolling: the contact is cut by the end of a profile, .*\.$"
    ):
        wk.ProfilePairRolling(cut, MU).solve()
    with pytest.raises(wk.InvalidInput, match="positive, finite coefficient"):
        wk.ProfilePairRolling(on_flat(), wk.Coulomb(0.0))
    with pytest.raises(wk.InvalidInput, match="lateral_drift"):
        wk.ProfilePairRolling(on_flat(), MU, lateral_drift=0.7)
    y = np.linspace(-20e-3, 20e-3, 41)
    steep = wk.CrossProfile(y, 1.5 * y)
    ball = wk.CrossProfile(1.4 * y, 0.03 - np.sqrt(0.03**2 - (1.4 * y) ** 2))
    wall = wk.ProfilePair(
        steep,
        ball,
        STEEL,
        wk.Force(10.0),
        -0.025,
        second_radius=0.03,
        rolled_radius=0.03 / math.hypot(1.0, 1.5),
        pixels=32,
    )
    with pytest.raises(wk.OutsideValidity, match="friction carries .* almost all"):
        wk.ProfilePairRolling(wall, wk.Coulomb(0.6), lateral_drift=0.4).solve()


@pytest.mark.slow
def test_friction_that_falls_with_the_velocity_of_slip():
    """In full slip F_x = mu(V xi) F_N: what displacements add to the slip vanishes on average (Betti)."""
    falling = wk.FallingFriction(0.4, 0.16, velocity=1.0)
    pair = on_flat(rolled_radius=10.5e-3, pixels=32)
    slid = wk.ProfilePairRolling(pair, falling, speed=20.0).solve()
    xi = float(slid.longitudinal_creepage[0])
    assert slid.stick_share[0] == 0.0
    most = slid.force[0] * (0.16 + 0.24 * math.exp(-20.0 * abs(xi)))
    assert abs(slid.longitudinal_force[0]) == pytest.approx(most, rel=2e-3)
    assert any("friction that falls with the velocity" in note.statement for note in slid.validity)
    partly = on_flat(rolled_radius=10.02e-3, pixels=32)
    coulomb = wk.ProfilePairRolling(partly, wk.Coulomb(0.4)).solve()
    level = wk.ProfilePairRolling(partly, wk.FallingFriction(0.4, 0.4, 1.0), speed=20.0).solve()
    np.testing.assert_array_equal(level.longitudinal_force, coulomb.longitudinal_force)
    weaker = wk.ProfilePairRolling(partly, falling, speed=20.0).solve()
    assert 0.0 < weaker.stick_share[0] < coulomb.stick_share[0]
    assert abs(weaker.longitudinal_force[0]) < abs(coulomb.longitudinal_force[0])
    with pytest.raises(wk.InvalidInput, match="no speed is given; give the speed of rolling in m/s, or Coulomb"):
        wk.ProfilePairRolling(partly, falling)
    with pytest.raises(wk.OutsideValidity, match="stick zone is not determined: give a lower speed"):
        wk.ProfilePairRolling(partly, falling, speed=1e6).solve()


@pytest.mark.slow
def test_few_pixels_state_an_error():
    """With 16 pixels along a side there is no coarser grid: the error came out as zero."""
    y = np.linspace(-4e-3, 4e-3, 81)
    flat, barrel = wk.CrossProfile(y, 0.0 * y), wk.CrossProfile(y, y**2 / 30e-3)
    steel = wk.HalfSpace.between(wk.Elastic(210e9, 0.28), wk.Elastic(210e9, 0.28))
    rough, fine = (
        wk.ProfilePairRolling(
            wk.ProfilePair(
                flat, barrel, steel, wk.Force(100.0), second_radius=20e-3, rolled_radius=20.02e-3, pixels=pixels
            ),
            MU,
        ).solve()
        for pixels in (16, 64)
    )
    assert 0.0 < abs(rough.x_force - fine.x_force) / 30.0 <= rough.grid_error
