"""Height maps pressed into layers: against bodies of revolution, waves by a transfer matrix, and active sets."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

import winkler as wk
from winkler.values.errors import OutsideValidity

BASE = wk.Elastic(1.0, 0.3)
STIFF = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(5.0, 0.3), 0.1)], on=BASE)
SOFT = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(5.0, 0.3), 0.1), wk.Layer(wk.Elastic(0.2, 0.45), 0.05)], on=BASE,
                          second=wk.Elastic(3.0, 0.2))  # fmt: skip
RUBBER = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1.0, 0.5), 0.2)], on=wk.Rigid())
GRADED = wk.DepthGradedHalfSpace(wk.ExponentialGrading(1.0, 5.0, depth_scale=0.1, poisson=0.3))
SIDE = 0.8


def transfer(q, layers, base):
    """Displacement per pressure under a wave cos(q x), by mpmath: du/dz = A u from equilibrium, layer by layer."""
    with mp.workdps(60):
        q = mp.mpf(q)

        def slope(young, poisson):
            nu = mp.mpf(poisson)
            shear = mp.mpf(young) / (2 * (1 + nu))
            n, m = nu / (1 - nu), (1 - 2 * nu) / (2 * shear * (1 - nu))
            return mp.matrix([
                [0, q, 1 / shear, 0], [-n * q, 0, 0, m], [2 * shear * q**2 / (1 - nu), 0, 0, n * q], [0, 0, -q, 0]
            ])  # fmt: skip

        down = mp.eye(4)
        for young, nu, thickness in layers:
            down = mp.expm(slope(young, nu) * mp.mpf(thickness)) * down
        end = mp.eye(4) if base is None else (slope(*base) + q * mp.eye(4)) ** 2  # what decays is annihilated
        rows = end * down
        return float(mp.lu_solve(rows[0:2, 0:2], mp.matrix([rows[0, 3], rows[1, 3]]))[1])


def ball(count, shape):
    """A map of a body of revolution whose apex is between pixels, its profile, and the height of the highest pixel."""
    x = (np.arange(count) - (count - 1) / 2) * SIDE / count
    r = np.hypot(x[:, None], x)
    heights = 0.5 * r**2 if shape == "ball" else 0.3 * r
    profile = wk.Paraboloid(1.0) if shape == "ball" else wk.Cone(math.atan(1.0 / 0.3))
    return wk.Topography(-heights, [SIDE, SIDE]), profile, float(heights.min())


def forces(count, shape, medium):
    """Error of the force of the map against that of the springs of the medium; the springs, and the map's pressure."""
    rough, profile, lift = ball(count, shape)
    line = wk.Indentation(wk.Foundation(profile, medium), wk.Radius(0.3)).solve()
    contact = wk.SurfaceContact(rough, medium, wk.Depth(float(line.depth) - lift)).solve()
    return contact.force / line.force - 1.0, line, contact.last.pressure[count // 2, count // 2]


def beside(line, count):
    """Pressure of the body of revolution in the pixels next to its apex."""
    return float(wk.restore(line, np.array([SIDE / count / math.sqrt(2.0)])).pressure[0])


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("medium", [STIFF, SOFT, RUBBER], ids=["stiff", "two", "rubber"])
def test_a_ball_bears_what_its_springs_bear(medium):
    force, line, middle = forces(96, "ball", medium)
    assert abs(force) < 2e-4
    assert middle == pytest.approx(beside(line, 96), rel=2e-3)


@pytest.mark.slow
def test_a_ball_on_a_graded_body_bears_what_its_springs_bear():
    assert abs(forces(96, "ball", GRADED)[0]) < 2e-4


def test_a_cone_bears_what_its_springs_bear():
    assert abs(forces(96, "cone", STIFF)[0]) < 1e-3


@pytest.mark.slow
def test_the_force_converges_with_second_order():
    """Pixels meet the edge by chance: the mean over some contacts of the squared error."""
    errors = []
    for count in (32, 64, 128):
        found = []
        for radius in (0.28, 0.29, 0.30, 0.31):
            rough, profile, lift = ball(count, "ball")
            line = wk.Indentation(wk.Foundation(profile, RUBBER), wk.Radius(radius)).solve()
            contact = wk.SurfaceContact(rough, RUBBER, wk.Depth(float(line.depth) - lift)).solve()
            found.append(contact.force / line.force - 1.0)
        errors.append(math.sqrt(np.mean(np.square(found))))
    assert -np.polyfit(np.log((32, 64, 128)), np.log(errors), 1)[0] > 1.6


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("shape", ["ball", "cone"])
@pytest.mark.parametrize("medium", [STIFF, SOFT, RUBBER, GRADED], ids=["stiff", "two", "rubber", "graded"])
def test_512_pixels_are_within_a_ten_thousandth(medium, shape):
    force, line, middle = forces(512, shape, medium)
    assert abs(force) < 1e-4
    if shape == "ball" and medium is not GRADED:  # the pressure of a cone is not finite in the middle
        assert middle == pytest.approx(beside(line, 512), rel=1e-4)


def test_the_stiffness_is_the_slope_of_the_force():
    rough, _, _ = ball(96, "ball")
    depth = 0.05
    found = wk.SurfaceContact(rough, STIFF, wk.Depth(depth * np.array([0.99, 1.0, 1.01]))).solve()
    slope = (found.force[2] - found.force[0]) / (0.02 * depth)
    assert found.stiffness[1] == pytest.approx(slope, rel=3e-3)


@pytest.mark.parametrize("periodic", [False, True])
def test_a_layer_of_the_same_solid_changes_nothing(periodic):
    rng = np.random.default_rng(3)
    rough = wk.Topography(rng.standard_normal((40, 24)), [1.0, 0.7], periodic=periodic)
    same = wk.CoatedHalfSpace([wk.Layer(BASE, 0.02), wk.Layer(BASE, 0.3)], on=BASE)
    plain, coated = (
        wk.SurfaceContact(rough, medium, wk.Force(0.5), tolerance=1e-11).solve()
        for medium in (wk.HalfSpace(BASE), same)
    )
    assert coated.depth == pytest.approx(plain.depth, rel=1e-10)
    assert coated.stiffness == pytest.approx(plain.stiffness, rel=1e-10)
    np.testing.assert_allclose(coated.last.pressure, plain.last.pressure, atol=1e-9 * plain.last.pressure.max())


STACKS = [
    ([(5.0, 0.3, 0.1), (0.2, 0.45, 0.05)], (1.0, 0.3)),
    ([(1.0, 0.5, 0.02)], None),
    ([(1e3, 0.2, 1e-3), (1e-3, 0.5, 0.05)], (1.0, 0.1)),
    ([(2.0, 0.25, 30.0)], None),
]


def stacked(layers, base):
    stack = [wk.Layer(wk.Elastic(young, nu), thickness) for young, nu, thickness in layers]
    return wk.CoatedHalfSpace(stack, on=wk.Elastic(*base) if base else wk.Rigid())


@pytest.mark.parametrize(("layers", "base"), STACKS)
@pytest.mark.parametrize("waves", [1, 3])
def test_a_wave_that_is_pressed_flat(layers, base, waves):
    """Heights a cos(q x) are closed by p = mean + (a / C) cos(q x), C by the transfer matrix."""
    n, q, height = 24, 2.0 * math.pi * waves, 1e-3
    x = np.arange(n) / n
    rough = wk.Topography(height * np.cos(q * x)[:, None] + np.zeros(8), [1.0, 1.0 / 3.0], periodic=True)
    closing = height / transfer(q, layers, base)
    found = wk.SurfaceContact(rough, stacked(layers, base), wk.Force(1.02 * closing / 3.0), tolerance=1e-10).solve()
    want = closing * (1.02 + np.cos(q * x))
    np.testing.assert_allclose(found.last.pressure[:, 3], want, atol=1e-7 * closing)


def active_set(compliance, heights, load):
    """Pressures and depth of a contact of few points: p >= 0, gap >= 0, one of them zero, sum of p the load."""
    on = heights <= np.quantile(heights, 0.5)
    for _ in range(200):
        k = int(on.sum())
        matrix = np.block([[compliance[np.ix_(on, on)], -np.ones((k, 1))], [np.ones((1, k)), np.zeros((1, 1))]])
        solved = np.linalg.solve(matrix, np.append(-heights[on], load))
        p = np.zeros(heights.size)
        p[on], depth = solved[:-1], solved[-1]
        gap = compliance @ p + heights - depth
        if p.min() >= 0.0 and gap[~on].min(initial=0.0) >= -1e-13:
            return p, depth
        on = (on & (p > 0.0)) | (~on & (gap < -1e-13))
    raise AssertionError("the active set went in circles")


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("layers", "base"), STACKS[:3])
def test_a_wave_in_partial_contact(layers, base):
    """Westergaard's wave on layers: against a dense active set with compliances by the transfer matrix."""
    n, height = 48, 1e-3
    x = np.arange(n) / n
    below = height * (1.0 - np.cos(2.0 * math.pi * x))
    compliances = [0.0] + [transfer(2.0 * math.pi * k, layers, base) for k in range(1, n // 2 + 1)]
    row = np.fft.irfft(compliances, n)
    matrix = np.array([np.roll(row, i) for i in range(n)])
    mean = 0.3 * height / compliances[1]
    p, depth = active_set(matrix, below, n * mean)
    uniform = sum(h * (1 + nu) * (1 - 2 * nu) / (e * (1 - nu)) for e, nu, h in layers) if base is None else 0.0
    rough = wk.Topography(-below[:, None] + np.zeros(16), [1.0, 1.0 / 3.0], periodic=True)
    found = wk.SurfaceContact(rough, stacked(layers, base), wk.Force(mean / 3.0), tolerance=1e-9).solve()
    assert found.depth == pytest.approx(depth + mean * uniform, rel=1e-6)
    np.testing.assert_allclose(found.last.pressure[:, 5], p, atol=1e-5 * p.max())


def test_a_film_on_a_rigid_base_is_compressed_beyond_closing():
    """All of it touches: the depth is the height of the plane through the mean and the compression; k = A / C(0)."""
    rng = np.random.default_rng(5)
    heights = 1e-4 * rng.standard_normal((12, 12))
    rough = wk.Topography(heights, [1.0, 1.0], periodic=True)
    film = stacked([(1.0, 0.3, 0.2)], None)
    per_pressure = 0.2 * 1.3 * 0.4 / 0.7
    found = wk.SurfaceContact(rough, film, wk.Depth(0.05), tolerance=1e-10).solve()
    mean_gap = heights.max() - heights.mean()
    assert found.force == pytest.approx((0.05 - mean_gap) / per_pressure, rel=1e-8)
    assert found.stiffness == pytest.approx(1.0 / per_pressure, rel=1e-6)
    with pytest.raises(OutsideValidity, match="closes the periodic map"):
        wk.SurfaceContact(rough, stacked([(1.0, 0.5, 0.2)], None), wk.Depth(0.05))


def test_stresses_in_layers_are_known_below_maps():
    rough, _, _ = ball(24, "ball")
    strong = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(5.0, 0.3, strength=1.0), 0.1)], on=BASE)
    contact = wk.SurfaceContact(rough, strong, wk.Depth(0.01)).solve()
    assert 0.0 < contact.stresses(0.0, 0.0, 0.02).von_mises <= contact.greatest_stress().value
    assert any("strength of the layer 1" in note.statement for note in contact.validity)


def test_films_that_the_pixels_do_not_follow_are_refused():
    rough, _, _ = ball(24, "ball")
    with pytest.raises(OutsideValidity, match="too coarse. Under a wave of 16 of them"):
        wk.SurfaceContact(rough, stacked([(1.0, 0.5, 1e-3)], None), wk.Depth(0.01)).solve()
    wide = stacked([(1.0, 0.49, 0.03)], None)
    assert any("nearly incompressible" in note.statement for note in
               wk.SurfaceContact(rough, wide, wk.Depth(0.01)).solve().validity)  # fmt: skip


def test_a_plate_far_stiffer_than_its_base_bends_as_under_a_point():
    """w = 2 F / (3 sqrt(3) E l) with l^3 = 2 D / E: S. Timoshenko and S. Woinowsky-Krieger, Theory of Plates and Shells
    (1959), 61; E is that of a half-space whose surface a bonded plate keeps from stretching."""
    rough, _, _ = ball(32, "ball")
    young, thickness = 1e10, 1e-2
    stiff = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, 0.3), thickness)], on=BASE)
    base = 4.0 * (1.0 - 0.3) / ((1.0 + 0.3) * (3.0 - 4.0 * 0.3))
    length = (2.0 * young * thickness**3 / (12.0 * (1.0 - 0.3**2)) / base) ** (1.0 / 3.0)
    pressed = wk.SurfaceContact(rough, stiff, wk.Depth(0.1)).solve()
    assert pressed.force == pytest.approx(1.5 * np.sqrt(3.0) * base * length * 0.1, rel=1e-3)
