"""Height maps pressed into a half-space, against closed forms and other codes."""

from __future__ import annotations

import csv
import tracemalloc

import numpy as np
import pytest

from winkler.numerics.surfaces import pressed_box, pressed_grid
from winkler.numerics.surfaces.pressed_box import ByDepth, ByLoad
from winkler.numerics.surfaces.pressed_grid import press
from winkler.numerics.surfaces.punched_grid import punch
from winkler.numerics.surfaces.surface_grid import SurfaceGrid, bytes_needed
from winkler.values.errors import NotConverged


def ball(count, radius=0.36):
    """Return a paraboloid of unit radius of curvature, whose apex is the middle of a pixel, and depth and force."""
    x = (np.arange(count) - (count - 1) / 2) / count
    return (x[:, None] ** 2 + x**2) / 2.0, (1.0 / count, 1.0 / count), radius**2, 4.0 / 3.0 * radius**3


def test_displacements_are_the_sum_over_all_pixels():
    """Against Love's solution summed one by one, on pixels that are not square."""
    rng = np.random.default_rng(1)
    p, (dx, dy) = rng.random((5, 4)), (0.3, 0.7)
    u = SurfaceGrid.of((5, 4), (dx, dy), periodic=False).displaced(p)

    def love(x, y):
        a, b = dx / 2, dy / 2
        total = 0.0
        for sx in (x + a, x - a):
            for sy in (y + b, y - b):
                sign = 1.0 if (sx == x + a) == (sy == y + b) else -1.0
                total += sign * (sx * np.arcsinh(sy / abs(sx)) + sy * np.arcsinh(sx / abs(sy)))
        return total / np.pi

    for i in range(5):
        for j in range(4):
            expected = sum(p[k, m] * love((i - k) * dx, (j - m) * dy) for k in range(5) for m in range(4))
            assert u[i, j] == pytest.approx(expected, rel=1e-12)


def test_a_periodic_wave_of_pressure_makes_a_wave():
    """Johnson, Contact Mechanics, section 13.2: u = 2 p / (E* q)."""
    x = np.arange(32) / 32.0
    wave = np.cos(2.0 * np.pi * 3.0 * x)[:, None] + np.zeros(16)
    u = SurfaceGrid.of((32, 16), (1.0 / 32, 1.0 / 16), periodic=True).displaced(5.0 + wave)
    assert np.allclose(u, 2.0 / (2.0 * np.pi * 3.0) * wave, atol=1e-14)


@pytest.mark.slow
def test_the_force_of_hertz_is_met_with_second_order():
    counts = np.array([33, 65, 129, 257])
    errors = []
    for count in counts:
        found = []
        for radius in (0.28, 0.30, 0.32, 0.34, 0.36, 0.38):  # pixels meet the edge by chance: the mean over some
            heights, pixel, depth, force = ball(count, radius)
            contact = press(heights, pixel, ByDepth(depth), periodic=False, tolerance=1e-8)
            found.append(contact.pressure.sum() * pixel[0] * pixel[1] / force - 1.0)
        errors.append(np.sqrt(np.mean(np.square(found))))
    slope = -np.polyfit(np.log(counts), np.log(errors), 1)[0]
    assert slope > 1.8
    assert errors[-1] < 2e-5


def test_a_force_finds_the_depth_and_the_pressure_of_hertz():
    heights, pixel, depth, force = ball(129)
    contact = press(heights, pixel, ByLoad(force / pixel[0] ** 2), periodic=False)
    assert contact.depth == pytest.approx(depth, rel=1e-4)
    r2 = 2.0 * heights
    inside = r2 < (0.8 * 0.36) ** 2
    assert np.allclose(contact.pressure[inside], 2.0 / np.pi * np.sqrt(0.36**2 - r2[inside]), rtol=2e-3)
    assert max(contact.penetration, contact.work) <= 1e-6


def test_what_is_certified_is_true():
    heights, pixel, depth, _ = ball(65)
    contact = press(heights, pixel, ByDepth(depth), periodic=False, tolerance=1e-5)
    gap = SurfaceGrid.of((65, 65), pixel, periodic=False).displaced(contact.pressure) + heights - depth
    assert np.min(contact.pressure) >= 0.0
    assert -np.min(gap) / depth <= 1e-5
    assert np.sum(contact.pressure * np.abs(gap)) / (np.sum(contact.pressure) * depth) <= 1e-5
    assert contact.gap == pytest.approx(gap, abs=1e-12)


def test_iterations_hardly_grow_with_the_grid():
    counts = [press(*ball(n)[:2], ByDepth(0.36**2), periodic=False).iterations for n in (65, 129, 257)]
    assert max(counts) <= 16


def test_a_square_punch():
    """k = 1.15229 E* L (boundary elements extrapolated, theory 1.3); edges converge slowly."""
    stiffness = []
    for count in (32, 64, 128):
        p = punch(np.ones((count, count), dtype=bool), (1.0 / count, 1.0 / count), periodic=False, tolerance=1e-9)
        stiffness.append(p.sum() / count**2)
    steps = np.diff(stiffness)
    assert stiffness[-1] + steps[-1] == pytest.approx(1.15229, rel=5e-4)  # of first order: the error halves
    assert 1.7 < steps[0] / steps[1] < 2.3


def test_a_punch_is_the_slope_of_the_force():
    heights, pixel, depth, _ = ball(129)
    forces = [
        press(heights, pixel, ByDepth(depth + step), periodic=False, tolerance=1e-10).pressure.sum() * pixel[0] ** 2
        for step in (-1e-3, 1e-3)
    ]
    contact = press(heights, pixel, ByDepth(depth), periodic=False)
    stiffness = punch(contact.pressure > 0.0, pixel, periodic=False).sum() * pixel[0] ** 2
    assert stiffness == pytest.approx((forces[1] - forces[0]) / 2e-3, rel=1e-3)


def test_hardness_is_not_exceeded():
    heights, pixel, _, force = ball(65)
    load, hardness = force / pixel[0] ** 2, 0.15
    soft = press(heights, pixel, ByLoad(load), periodic=False)
    hard = press(heights, pixel, ByLoad(load), periodic=False, ceiling=hardness)
    assert soft.pressure.max() > 1.3 * hardness
    assert hard.pressure.max() <= hardness
    assert hard.pressure.sum() == pytest.approx(load, rel=1e-6)
    assert hard.depth > soft.depth


def test_a_contact_nearby_is_a_good_beginning():
    heights, pixel, depth, _ = ball(129)
    near = press(heights, pixel, ByDepth(0.95 * depth), periodic=False)
    warm = press(heights, pixel, ByDepth(depth), periodic=False, start=near.pressure)
    cold = press(heights, pixel, ByDepth(depth), periodic=False)
    assert warm.pressure.sum() == pytest.approx(cold.pressure.sum(), rel=1e-5)


def test_what_does_not_converge_says_so(monkeypatch):
    monkeypatch.setattr(pressed_box, "MOST_ITERATIONS", 3)
    heights, pixel, depth, _ = ball(65)
    with pytest.raises(NotConverged, match="65 x 65 pixels still overlaps by"):
        press(heights, pixel, ByDepth(depth), periodic=False, tolerance=1e-10, start=np.zeros((65, 65)))


def any_task(seed):
    """Return heights, pixel, drive, border and hardness of any kind."""
    rng = np.random.default_rng(seed)
    shape = tuple(rng.integers(2, 70, 2))
    x, y = np.linspace(-1.0, 1.0, shape[0])[:, None], np.linspace(-1.0, 1.0, shape[1])
    kinds = [
        rng.random(shape),
        x**2 + y**2,
        np.round(3.0 * rng.random(shape)),
        np.minimum((x - 0.5) ** 2, (x + 0.5) ** 2) + y**2,
    ]
    h = kinds[seed % 4] * 10.0 ** rng.uniform(-9.0, 1.0)
    h = h - h.min() + (0.0 if np.ptp(h) else np.eye(*shape) * 1e-6)
    long = 10.0 ** rng.uniform(-9.0, 0.0)
    pixel = long, long * 10.0 ** rng.uniform(-1.0, 1.0)
    usual = np.ptp(h) / np.sqrt(h.size * pixel[0] * pixel[1])
    ceiling = usual * 10.0 ** rng.uniform(-2.0, 1.5) if seed % 3 == 0 else np.inf
    most = min(10.0 ** rng.uniform(-4.0, 2.0) * usual, rng.uniform(0.01, 0.99) * ceiling)
    drive = ByLoad(most * h.size) if rng.integers(2) else ByDepth(rng.uniform(0.001, 0.95) * np.mean(h))
    return h, pixel, drive, bool(rng.integers(2)), ceiling


@pytest.mark.few(1, slow=2)
@pytest.mark.parametrize(("first", "tolerance"), [(0, 1e-7), (20, 1e-7), (40, 1e-7), (60, 1e-6), (80, 1e-6)])
def test_whatever_is_pressed_is_solved(first, tolerance):
    """Random sizes, shapes, units, loads and hardnesses: every result is checked again; 1e-6 begins in single ones."""
    for seed in range(first, first + 20):
        h, pixel, drive, periodic, ceiling = any_task(seed)
        found = press(h, pixel, drive, periodic=periodic, ceiling=ceiling, tolerance=tolerance)
        p, most = found.pressure, ceiling * (1.0 + 1e-12)
        gap = SurfaceGrid.of(h.shape, pixel, periodic=periodic).displaced(p) + h - found.depth
        soft = p < ceiling * (1.0 - 1e-12)
        assert p.min() >= 0.0, seed
        assert p.max() <= most, seed
        assert np.min(gap, where=soft, initial=0.0) >= -1.1 * tolerance * found.depth, seed
        work = np.sum(p * np.where(soft, np.abs(gap), np.maximum(gap, 0.0)))
        assert work <= 1.1 * tolerance * np.sum(p) * found.depth, seed
        if isinstance(drive, ByLoad):
            assert np.sum(p) == pytest.approx(drive.load, rel=1e-10), seed
        else:
            assert found.depth == pytest.approx(drive.depth, rel=1e-12), seed


def test_the_box_around_the_contact_changes_nothing(monkeypatch):
    """A contact in a corner, small against the map, solved on all of it."""
    x = np.arange(96) / 96.0
    heights = ((x[:, None] - 0.15) ** 2 + (x - 0.8) ** 2) / 2.0
    heights -= heights.min()
    small = press(heights, (1 / 96, 1 / 96), ByDepth(0.01), periodic=False, tolerance=1e-9)
    monkeypatch.setattr(pressed_grid, "box_around", lambda there: (slice(None), slice(None)))
    whole = press(heights, (1 / 96, 1 / 96), ByDepth(0.01), periodic=False, tolerance=1e-9)
    assert np.allclose(small.pressure, whole.pressure, atol=1e-6 * whole.pressure.max())
    assert small.pressure.sum() == pytest.approx(whole.pressure.sum(), rel=1e-8)


@pytest.mark.slow
@pytest.mark.parametrize("periodic", [False, True])
def test_memory_is_counted(periodic):
    """What numpy held at most, of a rough contact all over the map, is less than what is stated, and not much less."""
    heights = np.random.default_rng(4).random((300, 300))
    heights -= heights.min()
    drive = ByDepth(0.4)
    tracemalloc.start()
    try:
        press(heights, (1 / 300, 1 / 300), drive, periodic=periodic)
        most = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert 0.4 * bytes_needed((300, 300), periodic) < most < bytes_needed((300, 300), periodic)


def rows(path, **wanted):
    with path.open() as file:
        return [row for row in csv.DictReader(file) if all(row[key] == word for key, word in wanted.items())]


@pytest.mark.parametrize(
    ("shape", "heights"),
    [
        ("flat_ended_pyramid", lambda x, y: np.maximum(np.maximum(np.abs(x), np.abs(y)) - 0.5, 0.0)),
        ("two_spheres", lambda x, y: np.minimum((x - 0.8) ** 2, (x + 0.8) ** 2) / 2 + y**2 / 2),
    ],
)
def test_shapes_of_another_code(shared_data, shape, heights):
    """ContactMechanics on the same grid of 128^2 pixels, to its own tolerance."""
    for row in rows(shared_data / "reference" / "shapes_not_self_similar.csv", shape=shape)[::2]:
        side, depth = float(row["L"]), float(row["d"])
        x = (np.arange(128) + 0.5) / 128 * side - side / 2
        h = heights(x[:, None], x[None, :])
        contact = press(h, (side / 128, side / 128), ByDepth(depth), periodic=False)
        force = contact.pressure.sum() * (side / 128) ** 2
        assert force == pytest.approx(float(row["F_Richardson(256,512;p=2)"]), rel=6e-3)


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_what_no_numbers_hold_is_not_taken_for_solved():
    """Under 1e-14 a single pixel touches; gaps over depths of 1e-18 and less cancel all digits."""
    heights = np.add.outer((np.arange(40.0) - 20.0) ** 2, (np.arange(40.0) - 20.0) ** 2)
    pressed = press(heights, (1.0, 1.0), ByLoad(1e-14), periodic=False)
    assert np.count_nonzero(pressed.pressure) == 1
    assert np.sum(pressed.pressure) == pytest.approx(1e-14, rel=1e-12)
    for load in (1e-30, 1e-200):
        with pytest.raises(ArithmeticError):
            press(heights, (1.0, 1.0), ByLoad(load), periodic=False)
