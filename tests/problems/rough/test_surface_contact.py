"""Height maps under load: Hertz, flat edges, arrays of loads, what is noted and what is refused."""

from __future__ import annotations

import csv
import math

import numpy as np
import pytest

from winkler.loading.loads import Depth, Force, Radius
from winkler.materials.elastic import Elastic, TransverselyIsotropic
from winkler.media.halfspace import HalfSpace
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.problems.rough import map_memory
from winkler.problems.rough.surface_contact import SurfaceContact
from winkler.profiles.rough.random_rough import random_topography
from winkler.profiles.rough.spectrum import SelfAffine
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Standing

STEEL = HalfSpace(Elastic(210e9, 0.3))
UNIT = HalfSpace(Elastic(1.0, 0.0))
COUNT, SIDE, BALL = 97, 1e-3, 10e-3
ROUGH = random_topography(SelfAffine(0.8, 1e-7, 1e-3, 3e-5), (64, 64), [1e-3, 1e-3], seed=1)


def ball(curvature=(BALL, BALL)):
    x = (np.arange(COUNT) - (COUNT - 1) / 2) * SIDE / COUNT
    return Topography(-(x[:, None] ** 2) / (2 * curvature[0]) - x**2 / (2 * curvature[1]), [SIDE, SIDE])


def test_hertz_by_force():
    contact = SurfaceContact(ball(), STEEL, Force(300.0)).solve()
    radius = (0.75 * 300.0 * BALL / STEEL.modulus) ** (1 / 3)
    assert contact.force == pytest.approx(300.0, rel=1e-12)
    assert contact.depth == pytest.approx(radius**2 / BALL, rel=3e-4)
    assert contact.stiffness == pytest.approx(2.0 * STEEL.modulus * radius, rel=1e-2)
    assert contact.area == pytest.approx(math.pi * radius**2, rel=1e-2)
    assert contact.last.pressure.max() == pytest.approx(1.5 * 300.0 / (math.pi * radius**2), rel=2e-3)
    assert max(contact.penetration, contact.misfit) <= 1e-6


@pytest.mark.parametrize(("a", "b", "same"), [(0.4, 0.6, 1.0276201), (0.25, 0.75, 1.2132707)])
def test_ellipses(a, b, same):
    """F = 4/3 E* R_eq^(1/2) d^(3/2), theory 1.3."""
    depth = 5e-6
    contact = SurfaceContact(ball((0.5 * 5e-3 / a, 0.5 * 5e-3 / b)), STEEL, Depth(depth)).solve()
    exact = 4.0 / 3.0 * STEEL.modulus * math.sqrt(same * 5e-3) * depth**1.5
    assert contact.force == pytest.approx(exact, rel=2e-3)


@pytest.mark.parametrize("loads", [Force([50.0, 100.0, 110.0, 105.0]), Depth([2e-6, 2.2e-6, 2.1e-6, 6e-6])])
def test_many_loads_are_the_loads_one_by_one(loads):
    """Near ones are begun from the one before, with a flat punch added; far ones anew."""
    together = SurfaceContact(ball(), STEEL, loads).solve()
    given = loads.force if isinstance(loads, Force) else loads.depth
    for i, load in enumerate(given):
        alone = SurfaceContact(ball(), STEEL, type(loads)(load)).solve()
        assert together.depth[i] == pytest.approx(alone.depth, rel=1e-6)
        assert together.force[i] == pytest.approx(alone.force, rel=1e-6)
        assert together.area[i] == pytest.approx(alone.area, rel=1e-3)
        assert together.stiffness[i] == pytest.approx(alone.stiffness, rel=1e-4)


def test_pressures_and_gaps_are_those_of_every_pair_of_pixels():
    """Love's displacements summed one by one, on pixels that are not square."""
    count, length = (14, 18), np.array([1e-3, 2e-3])
    x, y = (length[i] * (np.arange(n) + 0.5) / n for i, n in enumerate(count))
    heights = 1e-6 * np.random.default_rng(3).random(count)
    state = SurfaceContact(Topography(heights, length), STEEL, Force(40.0), tolerance=1e-9).solve().last
    dx, dy = (x[:, None] - x), (y[:, None] - y)
    half = 0.5 * length / count
    u = np.zeros(count)
    for sx in (1.0, -1.0):
        for sy in (1.0, -1.0):
            a, b = dx + sx * half[0], dy + sy * half[1]
            corner = a[:, None, :, None] * np.arcsinh(b[None, :, None, :] / np.abs(a[:, None, :, None]))
            corner += b[None, :, None, :] * np.arcsinh(a[:, None, :, None] / np.abs(b[None, :, None, :]))
            u += sx * sy * np.einsum("ikjl,jl->ik", corner, state.pressure)
    gap = u / (np.pi * STEEL.modulus) + heights.max() - heights - state.depth
    assert np.all(state.pressure >= 0.0)
    assert gap.min() >= -1e-9 * state.depth
    assert np.sum(state.pressure * np.abs(gap)) <= 1e-9 * np.sum(state.pressure) * state.depth
    assert np.allclose(state.separation, np.maximum(gap, 0.0), atol=1e-14)
    assert state.force == pytest.approx(np.sum(state.pressure) * 4.0 * half[0] * half[1], rel=1e-12)


def test_the_stiffness_of_two_spots_is_that_of_the_flat_punch_of_their_area():
    """Theory 1.3: dF/dd of a contact with two asperities, by differences, is the stiffness of their flat punch."""
    x = (np.arange(128) - 63.5) / 128.0
    heights = -np.minimum((x[:, None] - 0.2) ** 2, (x[:, None] + 0.2) ** 2) / 2.0 - x**2 / 2.0
    step = 1e-4
    result = SurfaceContact(
        Topography(heights, [1.0, 1.0]), UNIT, Depth(0.008 * np.array([1.0 - step, 1.0, 1.0 + step])), tolerance=1e-10
    ).solve()
    slope = (result.force[2] - result.force[0]) / (result.depth[2] - result.depth[0])
    assert result.stiffness[1] == pytest.approx(slope, rel=6e-5)


def test_the_edge_is_taken_off_the_area():
    """Counted pixels are too many by some of those along the edge, in the mean over how they meet it."""
    counted, corrected = [], []
    for load in (150.0, 180.0, 220.0, 260.0, 300.0):
        contact = SurfaceContact(ball(), STEEL, Force(load)).solve()
        exact = math.pi * (0.75 * load * BALL / STEEL.modulus) ** (2 / 3)
        patch = (SIDE / COUNT) ** 2
        counted.append(np.count_nonzero(contact.last.pressure) * patch / exact - 1.0)
        corrected.append(contact.area / exact - 1.0)
    assert np.mean(counted) > 0.01
    assert abs(np.mean(corrected)) < 0.5 * np.mean(counted)


@pytest.mark.parametrize("across", [3, 4, 6, 8, 12])
def test_the_area_lies_within_its_error_on_coarse_grids(across):
    """Hertz: a circle `across` pixels wide, wherever its middle lies in a pixel."""
    rng, count = np.random.default_rng(across), 2 * across + 6
    for _ in range(12):
        radius, (x, y) = 0.5 * across * rng.uniform(0.9, 1.1), np.arange(count) - 0.5 * count + rng.random((2, 1))
        curvature, exact = 100.0 * radius, math.pi * radius**2
        result = SurfaceContact(
            Topography(-(x[:, None] ** 2 + y**2) / (2.0 * curvature), [float(count)] * 2),
            UNIT,
            Force(4.0 / 3.0 * radius**3 / curvature),
        ).solve()
        assert abs(result.area - exact) < result.area_error
        peak = 2.0 * radius / (math.pi * curvature)
        assert abs(result.last.pressure.max() / peak - 1.0) < 6.0 * (result.area_error / result.area) ** 2


@pytest.mark.parametrize("count", [8, 16, 32])
def test_the_error_of_the_area_of_waves_along_the_grid(count):
    """Westergaard, sin^2(pi a/L) = p/p*: all edges are straight and move together, the worst case of pixels."""
    full, inside, low, errors = math.pi * 1e-3, [], [], []
    for share in np.linspace(0.1, 0.8, 8):
        for shift in (0.0, 0.25, 0.5):
            wave = 1e-3 * np.cos(2.0 * np.pi * (np.arange(count) + shift) / count)
            rough = Topography(np.tile(wave[:, None], 4), [1.0, 4.0 / count], True)
            result = SurfaceContact(rough, UNIT, Force(share * full * rough.area)).solve()
            exact = 2.0 / math.pi * math.asin(math.sqrt(share)) * rough.area
            inside.append(abs(result.area - exact) / result.area_error)
            errors.append(result.area / exact - 1.0)
            peak = 2.0 * math.sqrt(share) * full
            low.append((1.0 - result.last.pressure.max() / peak) / (6.0 * (result.area_error / result.area) ** 2))
    assert np.median(inside) < 1.0
    assert np.max(inside) < 2.5  # half a pixel, and a little
    assert np.mean(np.array(low) < 1.0) > 0.9
    assert abs(np.mean(errors)) < 1.0 / count


def test_what_is_soft_enough_flows():
    """Far beyond the hardness the contact is the force over the hardness."""
    for topography in (ball(), ROUGH):
        force = 0.3 * 1e6 * topography.area
        contact = SurfaceContact(topography, STEEL, Force(force), hardness=1e6).solve()
        assert contact.force == pytest.approx(force, rel=1e-12)
        assert np.count_nonzero(contact.last.pressure) / contact.last.pressure.size == pytest.approx(0.3, abs=0.01)


def test_a_transversely_isotropic_body_is_one_of_its_modulus():
    crystal = TransverselyIsotropicHalfSpace(TransverselyIsotropic(10e9, 4e9, 3.5e9, 12e9, 3e9))
    depth = Depth(2e-6)
    one, other = (SurfaceContact(ball(), medium, depth).solve() for medium in (STEEL, crystal))
    assert other.force / one.force == pytest.approx(9.558861079e9 / STEEL.modulus, rel=1e-9)


def table(path, **wanted):
    with path.open() as file:
        return [row for row in csv.DictReader(file) if all(row[key] == word for key, word in wanted.items())]


@pytest.mark.parametrize(
    ("shape", "heights"),
    [
        ("ellipsoid_R2", lambda x, y: x**2 / 4.0 + y**2 / 2.0),
        ("square_pyramid", lambda x, y: np.maximum(np.abs(x), np.abs(y))),
    ],
)
def test_self_similar_shapes_of_another_code(shared_data, shape, heights):
    """Forces that ContactMechanics extrapolated to ever finer grids; the apex lies in the middle of a pixel."""
    for row in table(shared_data / "reference" / "shapes_force_depth.csv", shape=shape)[1::3]:
        depth = float(row["d"])
        side = 2.2 * depth**0.5 if shape == "ellipsoid_R2" else 1.6 * depth
        x = (np.arange(161) - 80.0) / 161.0 * 2.0 * side
        h = -heights(x[:, None], x[None, :])
        contact = SurfaceContact(Topography(h, [2.0 * side, 2.0 * side]), UNIT, Depth(depth)).solve()
        assert contact.force == pytest.approx(float(row["F_Richardson(p=2)"]), rel=1.5e-3)


def less_edge(row, corrected):
    """Return the share of pixels that touch less 0.9 of what the table takes off, which is Yastrebov's whole number."""
    counted = float(row["area_frac"])
    return counted - 0.9 * (counted - float(row[corrected]))


FREE = ["0.0005", "0.001", "0.002", "0.005", "0.01", "0.02", "0.05", "0.1", "0.2"]
CLOSING = ["0.002", "0.005", "0.01", "0.02", "0.05", "0.1", "0.2", "0.4"]


@pytest.mark.slow
@pytest.mark.parametrize("loads", [["0.005"], pytest.param(FREE, marks=pytest.mark.slow)], ids=["one", "all"])
def test_a_rough_stamp_of_another_code(shared_data, loads):
    """Tamaas on 512 x 512 pixels: depth, area with the edge taken off, stiffness by its differences."""
    heights = np.load(shared_data / "reference" / "rough_seed1_512.npy")
    rows = {row["F/(E*L^2)"]: row for row in table(shared_data / "reference" / "rough_free.csv", n="512")}
    contact = SurfaceContact(Topography(heights, [1.0, 1.0]), UNIT, Force([float(load) for load in loads])).solve()
    for i, load in enumerate(loads):
        assert contact.depth[i] == pytest.approx(float(rows[load]["d_from_highest_point/L"]), rel=1e-7)
        assert contact.stiffness[i] == pytest.approx(float(rows[load]["k=dF/dd/(E*L)"]), rel=2e-3)
        assert contact.area[i] == pytest.approx(less_edge(rows[load], "area_frac_corr"), rel=3e-3)


@pytest.mark.parametrize("loads", [["0.05"], pytest.param(CLOSING, marks=pytest.mark.slow)], ids=["one", "all"])
def test_a_rough_surface_for_ever_of_another_code(shared_data, loads):
    """Tamaas again, periodic; its gap of pixels that touch is not quite zero under the greatest load."""
    heights = np.load(shared_data / "reference" / "rough_seed1_512.npy")
    path = shared_data / "reference" / "rough_periodic.csv"
    rows = {row["p/(E*rms_slope)"]: row for row in table(path, n="512", bc="periodic", seed="1", tol="1e-09")}
    surface = Topography(heights, [1.0, 1.0], periodic=True)
    contact = SurfaceContact(surface, UNIT, Force([float(load) for load in loads])).solve()
    for i, load in enumerate(loads):
        assert contact.mean_gap[i] == pytest.approx(float(rows[load]["mean_gap/L"]), rel=3e-7)
        assert contact.stiffness[i] == pytest.approx(float(rows[load]["stiffness_dp/dgap(E*/L)"]), rel=1e-3)
        assert contact.area[i] == pytest.approx(less_edge(rows[load], "area_frac_corrected"), rel=1e-4)


def test_few_pixels_and_steep_heights_are_noted():
    few = SurfaceContact(ball(), STEEL, Force(1.0)).solve()
    message = next(note for note in few.validity if "pixels wide" in note.statement)
    assert message.standing is Standing.APPROXIMATE
    assert f"an error of about {100.0 * few.area_error / few.area:.2g} per cent" in message.statement
    fewer = SurfaceContact(ball(), STEEL, Force(1e-4)).solve()
    assert next(note for note in fewer.validity if "pixels wide" in note.statement).standing is Standing.OUTSIDE
    steep = SurfaceContact(Topography(10.0 * ball().heights, [SIDE, SIDE]), STEEL, Force(1.0)).solve()
    message = {note.standing for note in steep.validity if "mean square slope" in note.statement}
    assert message == {Standing.APPROXIMATE}


def test_a_wave_of_westergaard():
    """K. L. Johnson, Contact Mechanics, section 13.2: p* = pi E* h / L, p(0) = 2 (p p*)^(1/2), sin^2(pi a/L) = p/p*."""
    wave, pressure = 1e-3 * np.cos(2.0 * np.pi * np.arange(256) / 256), 8e-4
    full = math.pi * 1e-3
    contact = SurfaceContact(
        Topography(np.tile(wave[:, None], 4), [1.0, 0.1], periodic=True), UNIT, Force(0.1 * pressure)
    )
    state = contact.solve().last
    assert state.pressure.max() == pytest.approx(2.0 * math.sqrt(pressure * full), rel=1e-4)
    wide = 2.0 / math.pi * math.asin(math.sqrt(pressure / full))
    assert np.mean(state.pressure > 0.0) == pytest.approx(wide, abs=1.0 / 256)
    closed = SurfaceContact(contact.topography, UNIT, Force(0.1 * 1.01 * full)).solve()
    assert closed.last.pressure.min() == pytest.approx(0.01 * full, rel=1e-3)
    assert math.isinf(closed.stiffness)


def test_a_periodic_surface_closes():
    loads = np.array([1.0, 100.0, 20000.0])
    contact = SurfaceContact(ROUGH, STEEL, Force(loads)).solve()
    assert np.all(np.diff(contact.mean_gap) < 0.0)
    assert contact.mean_gap + contact.depth == pytest.approx(np.full(3, np.mean(ROUGH.gaps)), rel=1e-9)
    assert "repeats without end" in " ".join(note.statement for note in contact.validity)
    closed = SurfaceContact(ROUGH, STEEL, Force(1e7)).solve()
    assert closed.stiffness == math.inf
    assert closed.area == pytest.approx(ROUGH.area, rel=1e-12)
    assert closed.mean_gap == pytest.approx(0.0, abs=1e-12)


def test_hardness_is_not_exceeded():
    soft = SurfaceContact(ball(), STEEL, Force(300.0)).solve()
    hard = SurfaceContact(ball(), STEEL, Force(300.0), hardness=1e9).solve()
    assert soft.last.pressure.max() > 1.2e9
    assert hard.last.pressure.max() <= 1e9 * (1.0 + 1e-12)
    assert hard.area > soft.area
    assert "limited to the hardness" in " ".join(note.statement for note in hard.validity)


def test_steps_are_the_solution():
    contact = SurfaceContact(ball(), STEEL, Depth([1e-6, 2e-6]))
    states = list(contact.steps())
    assert contact.solve().force.tolist() == [state.force for state in states]


@pytest.mark.parametrize(
    ("numbers", "error", "sentence"),
    [
        ({"topography": "map"}, InvalidInput, "topography is a str"),
        ({"medium": "steel"}, InvalidInput, "medium is a str"),
        ({"load": Radius(1e-4)}, InvalidInput, "load is a Radius"),
        ({"load": Force([1.0, -1.0])}, InvalidInput, "a force of -1 N at index 1 does not press"),
        ({"hardness": 0.0}, InvalidInput, "hardness is 0.0"),
        ({"tolerance": 1.0}, InvalidInput, "tolerance is 1.0"),
        ({"hardness": 1.0}, OutsideValidity, "more than hardness times the area"),
        ({"topography": ROUGH, "load": Depth(1.0)}, OutsideValidity, "closes the periodic map"),
        (
            {"topography": Topography(np.where(np.eye(8) > 0, np.nan, 0.0), [1.0, 1.0])},
            InvalidInput,
            "8 of 64 heights are missing; fill them",
        ),
        ({"topography": Topography(np.zeros((8, 8)), [1.0, 1.0], periodic=True)}, InvalidInput, "is flat and touches"),
    ],
)
def test_wrong_questions_are_refused(numbers, error, sentence):
    prescribed = {"topography": ball(), "medium": STEEL, "load": Force(300.0)} | numbers
    with pytest.raises(error, match=sentence):
        SurfaceContact(**prescribed)


def test_a_map_larger_than_the_memory_is_refused(monkeypatch):
    monkeypatch.setattr(map_memory, "bytes_needed", lambda shape, periodic: 2**60)
    with pytest.raises(InvalidInput, match=r"takes 1.07e\+09 GiB of memory, this machine has"):
        SurfaceContact(ball(), STEEL, Force(1.0))


def test_a_nearly_closed_surface_has_a_stiffness():
    """Two crossed waves close under F = pi E* h / L per area, p = 2 pi h E* / (2 L): all but a few pixels touch."""
    n = 256
    wave = 1e-3 * np.cos(2.0 * np.pi * np.arange(n) / n)
    crossed = Topography(wave[:, None] + wave, [1.0, 1.0], True)
    contact = SurfaceContact(crossed, UNIT, Force(0.00628)).solve()
    assert contact.depth == pytest.approx(2e-3, rel=1e-6)  # the mean planes have approached by the height of both waves
    assert contact.area == pytest.approx(1.0, abs=1e-3)
    assert 1e3 < contact.stiffness < np.inf


@pytest.mark.parametrize("period", [2, 4])
def test_gratings_that_a_coarser_grid_does_not_see(period):
    """Strips of half the width: under a small force only they touch, and bear all alike but at their edges."""
    ridges = np.where(np.arange(128) % period < period // 2, 0.0, -1e-2)
    contact = SurfaceContact(Topography(ridges[:, None] + np.zeros(128), [1.0, 1.0], True), UNIT, Force(1e-3)).solve()
    assert contact.force == pytest.approx(1e-3, rel=1e-9)
    np.testing.assert_array_equal(contact.last.pressure > 0.0, np.broadcast_to(ridges[:, None] == 0.0, (128, 128)))


def test_the_border_of_a_stamp_is_no_edge_that_pixels_blur():
    half = np.zeros((96, 96))
    half[48:] = -1.0
    contact = SurfaceContact(Topography(half, [1.0, 1.0]), UNIT, Depth(1e-3)).solve()
    assert contact.area == pytest.approx(0.5, abs=2e-3)  # the inner edge is corrected by an eighth of a pixel


def test_mistaken_units_are_noted():
    steep = SurfaceContact(
        Topography(5.0 * np.random.default_rng(0).normal(size=(32, 32)), [1.0, 1.0]), UNIT, Depth(1.0)
    )
    assert "are heights and lengths both in m?" in " ".join(str(note) for note in steep.solve().validity)
