"""Temperatures of contacts of any outline: CONTACT, closed forms, energy, and what is refused."""

from __future__ import annotations

import csv
import dataclasses
import math
import tomllib

import numpy as np
import pytest
from scipy.integrate import quad

import winkler as wk
from winkler.numerics.surfaces import shared_heat
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Standing, worst

STEEL = wk.ThermalConductor.of(conductivity=50.0, density=7850.0, heat_capacity=450.0)
STEELS = wk.HeatConductors(STEEL, STEEL)


def elastic(shear: float, poisson: float) -> wk.HalfSpace:
    body = wk.Elastic(2.0 * shear * (1.0 + poisson), poisson)
    return wk.HalfSpace(body, body)


def tables(shared_data, name):
    folder = shared_data / "reference" / "contact"
    if not folder.exists():
        pytest.skip("reference data are not here")
    return folder, tomllib.loads((folder / name).read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def wheel(shared_data):
    """CONTACT's wheel that slides, on pixels of its size, and its answers."""
    _, table = tables(shared_data, "temperature_wheel.toml")
    given = table["inputs"]
    radii = [0.5 / given[f"gap_coefficient_{name}_1_per_m"] for name in "AB"]
    rough = wk.SampledProfile([14e-3, 23e-3], wk.CurvedBodies(*radii), (70, 46))
    medium = elastic(given["shear_modulus_Pa"], given["poisson"])

    def warm(creepage: float, hot: float) -> wk.SurfaceFrictionHeatingSolution:
        rolling = wk.SurfaceRolling(
            rough,
            medium,
            wk.Force(given["normal_force_N"]),
            wk.Coulomb(given["friction"]),
            wk.Creepage(creepage),
            speed=given["speed_m_per_s"],
        )
        return wk.SurfaceFrictionHeating(rolling, STEELS, second_bulk_temperature=hot).solve()

    return warm, table


def test_wheel_that_slides(wheel):
    """The closed form of conduction into the depth to 2 %, CONTACT to 12 % and its friction power to 0.3 %."""
    warm, table = wheel
    slides, printed = warm(-table["case"][0]["creep_x"], 0.0), table["case"][0]
    expected = table["closed_form"]["peak_temperature_case_1_degC"]
    assert math.isclose(slides.max_temperature, expected, rel_tol=0.02)
    assert math.isclose(slides.max_temperature, printed["peak_temperature_degC"], rel_tol=0.12)
    assert math.isclose(slides.heat_rate, -printed["friction_power_W"], rel_tol=3e-3)
    assert math.isclose(slides.heat_rate, slides.creep_power, rel_tol=1e-4)
    a = table["inputs"]["semi_axis_a_m"]
    assert abs(slides.x + 0.652 * a) < 0.06 * a  # towards the trailing edge; elastic slip pushes it further back
    assert abs(slides.y) < 1e-12
    assert math.isclose(slides.first_peclet, 0.5 * 30.0 * a / STEEL.diffusivity, rel_tol=0.03)
    assert slides.first_share == pytest.approx(0.5, abs=1e-12)


def test_hot_wheel_on_a_cold_rail(wheel):
    """In fast rolling the contact has the mean of both; heat flows as in two touching half-spaces."""
    warm, table = wheel
    rolls = warm(0.0, 150.0)
    assert math.isclose(rolls.max_temperature, table["closed_form"]["peak_temperature_case_2_degC"], rel_tol=1e-6)
    assert math.isclose(rolls.mean_temperature, 75.0, rel_tol=1e-8)
    assert rolls.mismatch < 1e-6
    assert rolls.heat_rate == 0.0
    assert rolls.first_share == pytest.approx(0.5)
    given = table["inputs"]
    a, b = given["semi_axis_a_m"], given["semi_axis_b_m"]
    flow = 75.0 * 50.0 * math.sqrt(30.0 / (math.pi * STEEL.diffusivity))
    along = quad(lambda s: 2.0 * b * 2.0 * math.sqrt(2.0 * a * math.sqrt(1.0 - s * s)), 0.0, 1.0)[0]
    assert math.isclose(rolls.exchanged_heat_rate, flow * along, rel_tol=5e-3)


def test_creep_curve_with_temperatures(shared_data):
    """CONTACT to 15 %; to 0.1 % where all slides, once the half of its own element is added that it counts too much.

    Where not all slides it differs then by as much as its friction power, which is too low, or less.  In sliding,
    temperature grows by the same for each creepage: the rest is the slip of the strain that friction makes.
    """
    folder, table = tables(shared_data, "creep_curve_temperature.toml")
    given = table["inputs"]
    rows = (folder / table["data"]).read_text(encoding="utf-8").splitlines()
    printed = {float(row["creep_x"]): row for row in csv.DictReader(row for row in rows if not row.startswith("#"))}
    creeps = np.array([8e-4, 1.2e-3, 2e-3, 3.2e-3, 1e-2, 0.15, 0.2, 0.25])
    medium, pixel = elastic(given["shear_modulus_Pa"], given["poisson"]), 0.3152e-3
    rough = wk.SampledProfile([44 * pixel, 88 * pixel], wk.CurvedBodies(0.625, 1.77672), (44, 44))
    problem = wk.SurfaceFrictionHeating(
        wk.SurfaceRolling(
            rough,
            medium,
            wk.Force(given["normal_force_N"]),
            wk.Coulomb(given["friction"]),
            wk.Creepage(creeps),
            speed=given["speed_m_per_s"],
        ),
        STEELS,
    )
    states = list(problem.steps())
    curve = problem.gathered(states)
    peak = np.array([float(printed[creep]["peak_temperature_degC"]) for creep in creeps])
    assert np.all(np.abs(curve.max_temperature / peak - 1.0) < 0.15)
    effusivity = 50.0 / math.sqrt(STEEL.diffusivity)
    own = math.sqrt(0.5 * pixel / (math.pi * given["speed_m_per_s"])) / effusivity
    like = [np.max(state.first_temperature + own * state.flux) for state in states]
    power = np.array([-float(printed[creep]["friction_power_W"]) for creep in creeps])
    assert np.all(np.abs(np.array(like) / peak - 1.0) < np.abs(curve.heat_rate / power - 1.0) + 1e-3)
    assert np.all(np.abs(np.array(like[-3:]) / peak[-3:] - 1.0) < 1e-3)
    rate = np.diff(curve.max_temperature[-3:])
    assert math.isclose(rate[0], rate[1], rel_tol=1e-5)
    assert np.allclose(curve.heat_rate, curve.creep_power, rtol=2e-3, atol=0.0)
    assert np.allclose(curve.first_share, 0.5, atol=1e-12)
    assert problem.gathered(states[:3]).max_temperature.tolist() == curve.max_temperature[:3].tolist()


def test_power_of_lateral_creepage_and_spin():
    """Forces times creepages and moment times spin, to 1 % on forty pixels."""
    rough = wk.SampledProfile([0.3e-3, 0.3e-3], wk.Paraboloid(10e-3), (45, 45))
    rolling = wk.SurfaceRolling(
        rough, elastic(82e9, 0.28), wk.Force(30.0), wk.Coulomb(0.3), wk.Creepage(1e-3, -2e-3, 10.0), speed=5.0
    )
    warm = wk.SurfaceFrictionHeating(rolling, STEELS).solve()
    assert math.isclose(warm.heat_rate, warm.creep_power, rel_tol=0.01)


def ball(count: int = 48, friction: float = 0.2) -> wk.SurfaceLoad:
    """A map of Hertz' pressure on a circle of 1 mm, which a body that rests holds back."""
    rim = (np.arange(count) + 0.5) / count * 2.2 - 1.1
    pressure = 300e6 * np.sqrt(np.maximum(1.0 - rim[:, None] ** 2 - rim**2, 0.0))
    return wk.SurfaceLoad(pressure, [2.2e-3, 2.2e-3], x_traction=-friction * pressure, corner=[-1.1e-3, -1.1e-3])


def test_both_at_rest_have_the_closed_form_of_hertz():
    """3 Q / (8 (lambda_1 + lambda_2) a), shared as the conductivities; slower than 1e-9 of diffusion."""
    load, pair = ball(), wk.HeatConductors(STEEL, wk.ThermalConductor(20.0, 3e-6))
    warm = wk.SurfaceFrictionHeating(load, pair, first_speed=1e-9).solve()
    assert math.isclose(warm.max_temperature, 3.0 * warm.heat_rate / (8.0 * 70.0 * 1e-3), rel_tol=2e-3)
    assert math.isclose(warm.first_share, 50.0 / 70.0, rel_tol=1e-6)
    assert math.isclose(warm.heat_rate, 0.2e-9 * load.force, rel_tol=1e-12)
    assert warm.x == warm.y == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize(("first", "second", "part"), [(5.0, 4.0, 2e-3), (0.5, 0.4, 2e-3), (1.0, 0.0, 0.05)])
def test_hertz_against_one_share_for_the_whole_contact(first, second, part):
    """Bodies that move alike need no more than one share; one at rest differs by a few per cent (Blok's rule)."""
    load = ball(64)
    warm = wk.SurfaceFrictionHeating(load, STEELS, first, second).solve()
    medium = elastic(82e9, 0.3)
    radius = (1e-3) ** 3 * 4.0 * medium.modulus / (3.0 * load.force)
    pressed = wk.EllipticIndentation(wk.CurvedBodies(radius, radius), medium, wk.Force(load.force))
    rule = wk.FrictionHeating(pressed, wk.Coulomb(0.2), STEELS, first, second).solve()
    assert math.isclose(warm.heat_rate, rule.heat_rate, rel_tol=1e-12)
    assert math.isclose(warm.max_temperature, rule.flash_temperature, rel_tol=part)
    assert math.isclose(warm.first_share, rule.first_share, rel_tol=part)
    assert math.isclose(warm.first_peclet, rule.first_peclet, rel_tol=0.03)


@pytest.mark.few(1)
@pytest.mark.parametrize("young", [2100e9, 21e9])
def test_ellipses_on_layers_heat_by_the_pixels_of_their_pressure(young):
    """Against an insulator both share in the same way: continuity in every pixel, and one share for the contact."""
    solid, insulated = wk.Elastic(210e9, 0.3), wk.HeatConductors(STEEL, wk.ThermalConductor(1e-4, 12e-6))
    bodies, load, friction = wk.CurvedBodies(5e-3, 15e-3), wk.Force(200.0), 0.1
    coat = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, 0.3), 5e-5)], on=solid, second=solid)
    pressed = wk.EllipticIndentation(bodies, coat, load).solve()
    sides = 2.2 * np.array([pressed.longitudinal_semi_axis, pressed.lateral_semi_axis])
    x, y = ((np.arange(64) + 0.5) / 64 * side - 0.5 * side for side in sides)
    pressure = pressed.pressure(x[:, None], y[None, :])
    maps = wk.SurfaceLoad(pressure, sides, x_traction=-friction * pressure)
    warm = wk.SurfaceFrictionHeating(maps, insulated, 2.0).solve()
    once = wk.FrictionHeating(pressed.problem, wk.Coulomb(friction), insulated, 2.0).solve()
    assert warm.heat_rate == pytest.approx(once.heat_rate, rel=2e-3)
    assert warm.max_temperature == pytest.approx(once.flash_temperature, rel=3e-3)
    place = warm.x - 0.5 * sides[0], warm.y - 0.5 * sides[1]
    assert place == pytest.approx((once.first.warmest.x, once.first.warmest.y), abs=0.6 * sides[1] / 64)
    half = wk.HalfSpace.between(solid, solid)
    bare = wk.EllipticIndentation(bodies, half, load)
    bare = wk.FrictionHeating(bare, wk.Coulomb(friction), insulated, 2.0).solve()
    assert (once.flash_temperature > 1.05 * bare.flash_temperature) == (young > solid.young)


def test_a_round_spot_conducts_as_the_constriction_of_a_disc():
    """4 a lambda D with 1 / lambda = 1 / lambda_1 + 1 / lambda_2, for bodies at rest."""
    rim = (np.arange(96) + 0.5) / 96 * 2.1 - 1.05
    spot = np.where(rim[:, None] ** 2 + rim**2 < 1.0, 1e6, 0.0)
    pair = wk.HeatConductors(STEEL, wk.ThermalConductor(75.0, 3e-6))
    load = wk.SurfaceLoad(spot, [2.1e-3, 2.1e-3])
    warm = wk.SurfaceFrictionHeating(load, pair, 0.0, 0.0, 20.0, 30.0).solve()
    assert math.isclose(warm.exchanged_heat_rate, 4.0 * 1e-3 * 30.0 * 10.0, rel_tol=5e-3)
    assert math.isclose(warm.mean_temperature, 26.0, rel_tol=1e-6)


def test_mirrored_motion_and_exchanged_bodies_mirror_and_exchange():
    other = wk.ThermalConductor(20.0, 3e-6)
    load = ball(33)
    one = wk.SurfaceFrictionHeating(load, wk.HeatConductors(STEEL, other), 0.3, 0.1, 5.0, 0.0).solve()
    mirrored = dataclasses.replace(load, x_traction=-load.x_traction)
    back = wk.SurfaceFrictionHeating(mirrored, wk.HeatConductors(STEEL, other), -0.3, -0.1, 5.0, 0.0).solve()
    assert np.allclose(back.last.first_temperature[::-1], one.last.first_temperature, atol=1e-6)
    turned = wk.SurfaceFrictionHeating(mirrored, wk.HeatConductors(other, STEEL), 0.1, 0.3, 0.0, 5.0).solve()
    assert math.isclose(turned.max_temperature, one.max_temperature, rel_tol=1e-8)
    assert math.isclose(turned.first_share, 1.0 - one.first_share, rel_tol=1e-6)
    assert math.isclose(turned.exchanged_heat_rate, -one.exchanged_heat_rate, rel_tol=1e-6)
    apart = one.last.first_temperature - one.last.second_temperature
    assert np.max(np.abs(apart[load.pressure > 0.0])) == one.mismatch < 1e-6
    assert math.isclose(np.sum(one.last.first_flux) * np.prod(load.pixel),
                        one.first_share * one.heat_rate + one.exchanged_heat_rate, rel_tol=1e-9)  # fmt: skip


def test_two_spots_as_hot_as_each_other_are_hottest_within_one():
    pressure = np.zeros((20, 21))
    pressure[8:12, 2:6] = pressure[8:12, 15:19] = 1e8
    load = wk.SurfaceLoad(pressure, [2e-3, 2.1e-3], x_traction=-0.2 * pressure)
    warm = wk.SurfaceFrictionHeating(load, STEELS, 1.0).solve()
    middles = [load.places[1][part].mean() for part in (slice(2, 6), slice(15, 19))]
    assert min(abs(warm.y - middle) for middle in middles) < 0.6 * load.pixel[1]
    assert warm.x > load.places[0][10]  # the first body carries heat towards +x


def test_refusals(monkeypatch):
    load = ball(9)
    rough = wk.SampledProfile([0.3e-3, 0.3e-3], wk.Paraboloid(10e-3), (15, 15))
    rolling = wk.SurfaceRolling(
        rough, elastic(82e9, 0.28), wk.Force(30.0), wk.Coulomb(0.3), wk.Creepage(1e-3), 1e-7, 5.0
    )
    for changed, words in (
        ({"first_speed": -1.0}, "change the sign"),
        ({"contact": dataclasses.replace(load, periodic=True)}, "and is periodic"),
        ({"contact": wk.SurfaceLoad([[1e6, 2e6]], [1e-3, 1e-3])}, "two pixels"),
        ({"contact": wk.SurfaceLoad(-load.pressure, [1e-3, 1e-3])}, "nothing touches"),
        ({"conductors": wk.HeatConductors(STEEL, STEEL, wk.ThermalInterface(1e4))}, "leave the interface out"),
        ({"first_bulk_temperature": math.nan}, "first_bulk_temperature"),
        ({"contact": rolling}, "leave both out"),
        ({"contact": dataclasses.replace(rolling, speed=0.0), "first_speed": 0.0}, "give SurfaceRolling a speed"),
    ):
        given = {"contact": load, "conductors": STEELS, "first_speed": 1.0}
        with pytest.raises(InvalidInput, match=words):
            wk.SurfaceFrictionHeating(**(given | changed))
    with pytest.raises(OutsideValidity, match="Peclet"):
        wk.SurfaceFrictionHeating(load, STEELS, 1e9).solve()
    monkeypatch.setattr(shared_heat, "MOST_ROUNDS", 1)
    monkeypatch.setattr(shared_heat, "ROUND", 1)
    with pytest.raises(NotConverged, match="SurfaceFrictionHeating: the temperatures"):
        wk.SurfaceFrictionHeating(load, STEELS, 1.0).solve()


def test_a_contact_of_few_pixels_and_hot_bodies_say_so():
    coarse = wk.SurfaceFrictionHeating(ball(4), STEELS, 20.0).solve()
    notes = {note.assumption: note.standing for note in coarse.validity}
    assert notes[Assumption.RESOLUTION] is not Standing.ASYMPTOTIC
    fine = wk.SurfaceFrictionHeating(ball(64), STEELS, 20.0).solve()
    notes = {note.assumption: note.standing for note in fine.validity}
    assert notes[Assumption.RESOLUTION] is Standing.ASYMPTOTIC
    assert notes[Assumption.TEMPERATURE] is not Standing.ASYMPTOTIC
    assert fine.grid_error < 0.005


@pytest.mark.parametrize(
    ("speeds", "rise"),
    [((1.0, 0.0), 0.28359), ((0.0, 1.0), 4e-4 / math.pi * math.log(1.0 + math.sqrt(2.0)) * 3e5 / 50.0)],
    ids=["moves", "rests"],
)
def test_a_square_against_a_near_insulator_takes_all_the_heat(speeds, rise):
    """.28359 K by moving point sources, .6733 K by Carslaw and Jaeger; .2876 K came out, "exact" with 0.02 K left."""
    pressure = np.full((64, 64), 1e6)
    load = wk.SurfaceLoad(pressure, [2e-4, 2e-4], x_traction=0.3 * pressure * (speeds[1] - speeds[0]))
    pair = wk.HeatConductors(wk.ThermalConductor(50.0, 1e-5), wk.ThermalConductor(1e-6, 1e-5))
    warm = wk.SurfaceFrictionHeating(load, pair, first_speed=speeds[0], second_speed=speeds[1]).solve()
    assert warm.max_temperature == pytest.approx(rise, rel=3e-4)
    assert warm.mismatch < 1e-6 * rise
    assert warm.last.first_temperature.max() == pytest.approx(
        warm.last.second_temperature[pressure > 0.0].max(), rel=1e-6
    )
    assert worst(warm.validity) in (Standing.EXACT, Standing.ASYMPTOTIC)


def test_what_is_left_counts_against_the_rise():
    """The standing follows from the difference of temperatures over the rise, whatever both are in kelvin."""
    pressure = np.full((8, 8), 1e6)
    load = wk.SurfaceLoad(pressure, [2e-4, 2e-4], x_traction=-0.3 * pressure)
    warm = wk.SurfaceFrictionHeating(load, STEELS, first_speed=1.0).solve()
    for part, standing in ((1e-6, Standing.EXACT), (0.07, Standing.APPROXIMATE), (0.2, Standing.OUTSIDE)):
        last = dataclasses.replace(warm.last, mismatch=part * warm.max_temperature)
        (note,) = [
            note
            for note in dataclasses.replace(warm, last=last).validity
            if "one temperature in every" in note.statement
        ]
        assert note.standing is standing


IRON, COPPER = wk.ThermalConductor(45.0, 12e-6), wk.ThermalConductor(200.0, 90e-6)
PAIR = wk.HeatConductors(IRON, COPPER)
NO_POISSON = wk.Elastic(210e9, 0.0)


def to_and_fro(amplitude: float, count: int) -> wk.Path:
    return wk.Path.oscillation(force=100.0, amplitude=amplitude, cycles=2, count=count)


STEADY = to_and_fro(1e-6, 80)


def fretting_ball(path: wk.Path, medium=None, pixels: int = 64) -> tuple:
    """A ball on pixels and the round contact, which has slip along the motion alone without Poisson's ratio."""
    medium = wk.HalfSpace(NO_POISSON, NO_POISSON) if medium is None else medium
    bed = wk.Foundation(wk.Paraboloid(10e-3), medium)
    side = 2.4 * float(wk.Indentation(bed, wk.Force(float(np.max(path.across)))).solve().radius)
    ball = wk.SampledProfile([side, side], wk.Paraboloid(10e-3), (pixels, pixels))
    return wk.SurfaceTangential(ball, medium, wk.Coulomb(0.5), path), wk.Tangential(bed, wk.Coulomb(0.5), path)


def varying() -> wk.Path:
    turn = 2.0 * np.pi * np.linspace(0.0, 2.0, 161)
    return wk.Path(turn, wk.Force(100.0 + 30.0 * np.sin(turn + 0.7)), wk.Shift(2e-6 * np.sin(turn)))


@pytest.mark.parametrize(
    ("path", "rings"),
    [(to_and_fro(1e-6, 16), to_and_fro(1e-6, 160)), (to_and_fro(6e-6, 16), to_and_fro(6e-6, 160)), (varying(),) * 2],
    ids=["partial slip", "sliding", "load varies"],
)
def test_a_ball_that_frets_is_as_warm_as_the_round_one(path, rings):
    """On 64 pixels: heat 0.2 %, greatest and mean temperature 0.5 %; the round one goes by rings, not by pixels."""
    (mapped, _), (_, whole) = fretting_ball(path), fretting_ball(rings)
    warm = wk.SurfaceFrictionHeating(mapped, PAIR, frequency=100.0).solve()
    ring = wk.FrettingHeat(whole, 100.0, PAIR).solve()
    assert warm.heat_rate == pytest.approx(ring.heat_rate, rel=2e-3)
    assert warm.max_temperature == pytest.approx(ring.max_temperature, rel=5e-3)
    assert warm.mean_temperature == pytest.approx(ring.mean_temperature, rel=5e-3)
    assert warm.first_share == pytest.approx(ring.first_share, rel=1e-9)
    assert warm.swing == pytest.approx(ring.swing, rel=1e-2)
    assert warm.first_peclet == warm.second_peclet == 0.0


@pytest.mark.slow
def test_the_heat_of_a_fretting_ball_converges_to_the_rings():
    """A narrow ring slips: where it is two pixels wide the heat is good to a per cent, and the note knows it."""
    path = to_and_fro(0.3e-6, 20)
    misses, standing = [], []
    for pixels in (24, 48, 96):
        mapped, whole = fretting_ball(path, pixels=pixels)
        warm = wk.SurfaceFrictionHeating(mapped, PAIR, frequency=100.0).solve()
        misses.append(abs(warm.heat_rate / (100.0 * whole.solve().loss_per_cycle) - 1.0))
        (note,) = [note for note in warm.validity if "pixels slip" in note.statement]
        standing.append(note.standing)
    assert misses[0] > misses[1] > misses[2]
    assert misses[1] < 0.01
    assert misses[2] < 0.003
    assert standing[0] is Standing.APPROXIMATE
    assert standing[2] is Standing.ASYMPTOTIC


@pytest.mark.slow
def test_a_ball_that_frets_on_a_layer_is_as_warm_as_the_round_one():
    """Rings on the layer's own kernels; maps neglect the normal displacements by tractions, as the rings do."""
    layer = wk.Layer(wk.Elastic(400e9, 0.0), 50e-6)
    mapped, whole = fretting_ball(STEADY, wk.CoatedHalfSpace([layer], NO_POISSON, wk.Elastic(1e15, 0.0)))
    warm = wk.SurfaceFrictionHeating(mapped, PAIR, frequency=100.0).solve()
    ring = wk.FrettingHeat(whole, 100.0, PAIR).solve()
    assert warm.heat_rate == pytest.approx(ring.heat_rate, rel=0.01)
    assert warm.max_temperature == pytest.approx(ring.max_temperature, rel=0.01)


def test_the_heat_of_fretting_is_the_loss_of_a_cycle():
    """An oval that is pushed askew and turned: flux times time is what the forces spend on the way, to a per cent."""
    oval = wk.SampledProfile([0.5e-3, 0.7e-3], wk.CurvedBodies(8e-3, 16e-3), (24, 32))
    way = 1.5e-6 * np.sin(2.0 * np.pi * np.linspace(0.0, 2.0, 121))
    shift = np.stack([0.3 * way, way], axis=1)
    path = wk.Path(np.arange(121.0), wk.Force(60.0), wk.Shift(shift))
    steel = wk.HalfSpace(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
    fretted = wk.SurfaceTangential(oval, steel, wk.Coulomb(0.5), path, twist=wk.Angle(2e3 * way))
    warm = wk.SurfaceFrictionHeating(fretted, PAIR, frequency=40.0).solve()
    march = warm.contact
    assert warm.heat_rate == pytest.approx(40.0 * march.loss_per_cycle, rel=1e-9)
    assert warm.creep_power == pytest.approx(warm.heat_rate, rel=1e-9)
    force = np.column_stack([march.shear_force, march.torque])[60:]
    turned = np.column_stack([march.shift, march.angle])[60:]
    spent = float(np.sum(0.5 * (force[1:] + force[:-1]) * np.diff(turned, axis=0)))
    assert warm.heat_rate == pytest.approx(40.0 * spent, rel=0.01)
    hot, cold = (
        wk.SurfaceFrictionHeating(fretted, PAIR, second_bulk_temperature=8.0, frequency=rate).solve().last
        for rate in (80.0, 1e-9)
    )
    risen = hot.first_temperature - cold.first_temperature
    np.testing.assert_allclose(risen, 2.0 * warm.last.first_temperature, atol=1e-5 * warm.max_temperature)


def test_fretting_maps_that_are_refused():
    mapped, _ = fretting_ball(STEADY, pixels=16)
    load = ball(9)
    rubber = wk.StandardSolid(1e9, 1e9, 1.0, poisson=0.5)
    waves = wk.Topography(1e-6 * np.cos(2.0 * np.pi * np.add.outer(np.arange(8), np.arange(8)) / 8), [1e-3] * 2, True)
    for changed, words in (
        ({"frequency": 0.0}, "give the cycles per second"),
        ({"contact": load}, "leave it out"),
        ({"first_speed": 1.0}, "fret are at rest"),
        ({"contact": dataclasses.replace(mapped, path=wk.Path.through(wk.Force(100.0), wk.Shift([0.0, 1e-6])))},
         "does not come back"),
        ({"contact": dataclasses.replace(mapped, topography=waves)}, "and is periodic"),
    ):  # fmt: skip
        given = {"contact": mapped, "conductors": STEELS, "frequency": 100.0}
        with pytest.raises(InvalidInput, match=words):
            wk.SurfaceFrictionHeating(**(given | changed))
    layers = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(rubber, 1e-4)], NO_POISSON)
    for relaxing in (wk.ViscoelasticHalfSpace(rubber), layers):
        with pytest.raises(OutsideValidity, match="so no single value exists"):
            wk.SurfaceFrictionHeating(dataclasses.replace(mapped, medium=relaxing), STEELS, frequency=1.0)
    once = dataclasses.replace(mapped, path=wk.Path.oscillation(force=100.0, amplitude=1e-6, count=20))
    with pytest.raises(OutsideValidity, match="append cycles"):
        wk.SurfaceFrictionHeating(once, STEELS, frequency=1.0).solve()
    held = dataclasses.replace(mapped, path=wk.Path.through(wk.Force([100.0, 90.0, 100.0, 90.0, 100.0]), wk.Shift(0.0)))
    with pytest.raises(OutsideValidity, match="nothing slips"):
        wk.SurfaceFrictionHeating(held, STEELS, frequency=1.0).solve()


def test_without_a_diffusivity_the_swing_is_the_mean():
    """The mean needs conductivities alone; the penetration depth is then left out of the note."""
    mapped, _ = fretting_ball(to_and_fro(1e-6, 8), pixels=16)
    only = wk.ThermalConductor(45.0)
    warm = wk.SurfaceFrictionHeating(mapped, wk.HeatConductors(only, only), frequency=1e6).solve()
    known = wk.SurfaceFrictionHeating(mapped, wk.HeatConductors(IRON, IRON), frequency=1e6).solve()
    assert warm.max_temperature == pytest.approx(known.max_temperature, rel=1e-9)
    assert warm.swing == warm.max_temperature > 5.0 * known.swing
    assert [sum("penetration depth" in note.statement for note in each.validity) for each in (warm, known)] == [0, 1]
