"""Dissimilar bodies that roll: free creepage, Bentall and Johnson's roller, and a check with own influence numbers."""

from __future__ import annotations

import tomllib

import numpy as np
import pytest
from scipy.optimize import brentq

import winkler as wk
from winkler.problems.surface_friction import by_turns
from winkler.values.errors import NotConverged

STEEL, ALUMINIUM, RUBBER = wk.Elastic(2.0 * 1.28, 0.28), wk.Elastic(0.7, 0.33), wk.Elastic(0.01, 0.4)


def ball(medium, force, radius, count, wide=2.4):
    a = (0.75 * force * radius / medium.modulus) ** (1.0 / 3.0)
    return a, wk.SampledProfile([wide * a, wide * a], wk.Paraboloid(radius), (count, count))


def free_creepage() -> float:
    """xi R / (beta a) of a ball without friction to speak of, from the closed form of what pressures draw along.

    Under the pressures of Hertz places at r <= a are drawn by 2 beta p_0 a^2/(3 E* r) [1 - (1 - r^2/a^2)^(3/2)] towards
    the middle (K. L. Johnson, Contact Mechanics, eq. 3.41b); all slips, and the traction along the slip has no sum.
    """
    nodes, weights = np.polynomial.legendre.leggauss(200)
    angle = 0.25 * np.pi * (nodes + 1.0)
    r, around = np.meshgrid(np.sin(angle), 2.0 * np.pi * (np.arange(400) + 0.5) / 400, indexing="ij")
    weight = weights[:, None] * r * np.cos(angle)[:, None] ** 2
    drawn = (1.0 - (1.0 - r**2) ** 1.5) / r**2
    steeper = 3.0 * np.sqrt(1.0 - r**2) / r - 2.0 * drawn / r
    x, y = r * np.cos(around), r * np.sin(around)
    along, across = -(drawn + steeper * x * x / r), -steeper * x * y / r

    def force(xi):
        return np.sum(weight * (xi + along) / np.hypot(xi + along, across))

    return brentq(force, 0.1, 3.0, xtol=1e-12) * 2.0 / 3.0 * 2.0 / np.pi


def test_a_ball_creeps_without_a_force():
    medium, force, radius = wk.HalfSpace.between(STEEL, ALUMINIUM), 1e-6, 1.0
    a, shape = ball(medium, force, radius, 48)
    done = wk.SurfaceRolling(shape, medium, wk.Force(force), wk.Coulomb(1e-4), wk.CreepForce()).solve()
    assert done.longitudinal_creepage == pytest.approx(free_creepage() * medium.mismatch * a / radius, rel=2e-3)
    assert abs(done.longitudinal_force) <= 1e-7 * 1e-4 * force
    assert done.stick_share == 0.0
    # the other way round the other body is drawn
    turned = wk.HalfSpace.between(ALUMINIUM, STEEL)
    again = wk.SurfaceRolling(shape, turned, wk.Force(force), wk.Coulomb(1e-4), wk.CreepForce()).solve()
    assert again.longitudinal_creepage == pytest.approx(-done.longitudinal_creepage, rel=1e-4)


@pytest.mark.slow
def test_a_long_roller_of_bentall_and_johnson(shared_data):
    """Freely rolling with friction 0.05, as CONTACT has it in plane strain; the ends bear five per cent of the load."""
    file = shared_data / "reference" / "contact" / "bentall_line.toml"
    given = tomllib.loads(file.read_text(encoding="utf-8"))
    inputs, case = given["inputs"], given["case"][1]
    bodies = (
        wk.Elastic(2.0 * inputs[f"shear_modulus_{n}_Pa"] * (1.0 + inputs[f"poisson_{n}"]), inputs[f"poisson_{n}"])
        for n in (1, 2)
    )
    medium = wk.HalfSpace.between(*bodies)
    radius = 1.0 / (1.0 / inputs["curvature_radius_1_m"] + 1.0 / inputs["curvature_radius_2_m"])
    a, long, (nx, ny) = given["closed_form"]["half_width_m"], 1280 * 1e-4, (48, 65)
    lengths = [3.2 * a, 1.12 * long]
    x, y = ((np.arange(n) - 0.5 * (n - 1)) * side / n for n, side in zip((nx, ny), lengths, strict=True))
    ends = np.abs(y) > 0.5 * long
    heights = -(x[:, None] ** 2) / (2.0 * radius) - 0.1 * ends * (np.abs(y) - 0.5 * long)
    force = inputs["force_per_length_N_per_m"] * np.count_nonzero(~ends) * lengths[1] / ny
    roller = wk.Topography(heights, lengths)
    done = wk.SurfaceRolling(
        roller, medium, wk.Force(force), wk.Coulomb(case["friction"]), wk.ShearForce(0.0)
    ).solve()  # fmt: skip
    assert done.longitudinal_creepage == pytest.approx(case["creep_x"], rel=1e-2)
    middle = done.last.pressure[:, ny // 2] > 0.0
    stuck = np.count_nonzero(middle & ~done.last.slipping[:, ny // 2]) / np.count_nonzero(middle)
    assert stuck == pytest.approx(case["elements_stick"] / case["elements"], abs=0.1)


def influence(shape, pixel, kernel):
    """Return the integrals of a kernel over all pixels at the middles of all, by quadrature of our own.

    The kernels are of degree -1: over the own pixel the radius is integrated in closed form, and the angle numerically.
    """
    nodes, weights = np.polynomial.legendre.leggauss(24)
    i, j = np.meshgrid(np.arange(-shape[0] + 1, shape[0]), np.arange(-shape[1] + 1, shape[1]), indexing="ij")
    u, v = np.meshgrid(nodes, nodes, indexing="ij")
    x = (i[..., None, None] + 0.5 * u) * pixel[0]
    y = (j[..., None, None] + 0.5 * v) * pixel[1]
    table = 0.25 * pixel[0] * pixel[1] * np.sum(weights[:, None] * weights * kernel(x, y), axis=(-2, -1))
    corner = np.arctan2(pixel[1], pixel[0])
    own = 0.0
    for begin, end in ((-corner, corner), (corner, np.pi - corner)):
        for turn in (0.0, np.pi):
            angle = 0.5 * (end - begin) * nodes + 0.5 * (end + begin) + turn
            far = np.minimum(
                0.5 * pixel[0] / np.maximum(np.abs(np.cos(angle)), 1e-300),
                0.5 * pixel[1] / np.maximum(np.abs(np.sin(angle)), 1e-300),
            )
            own += 0.5 * (end - begin) * float(np.sum(weights * kernel(np.cos(angle), np.sin(angle)) * far))
    table[shape[0] - 1, shape[1] - 1] = own
    at = np.indices(shape).reshape(2, -1)
    return table[
        at[0][:, None] - at[0][None] + shape[0] - 1, at[1][:, None] - at[1][None] + shape[1] - 1
    ]  # fmt: skip


@pytest.mark.few(1)
@pytest.mark.parametrize("drive", [
    wk.CreepForce(2e-8, -1e-8, wk.Spin(3.0)), wk.CreepForce(0.0, 0.0, wk.Torque(0.0)), wk.Creepage(2e-3, 1e-3),
])  # fmt: skip
def test_contact_and_friction_by_own_influence_numbers(drive):
    """Gaps close, slip opposes what it is rubbed by, and both are coupled: Boussinesq and Cerruti by quadrature."""
    medium, force, mu = wk.HalfSpace.between(STEEL, RUBBER), 2e-7, 0.25
    _, shape = ball(medium, force, 1.0, 14)
    done = wk.SurfaceRolling(shape, medium, wk.Force(force), wk.Coulomb(mu), drive).solve()
    e, beta, n = medium.modulus, medium.mismatch, (14, 14)
    # of each body (1 - nu)/(2 pi G) [(1 - nu) ... ]: a and b of displacements along the surface, times E*
    even = sum((1.0 - one.poisson) / one.shear for one in (STEEL, RUBBER)) * e / 2.0
    more = sum(one.poisson / one.shear for one in (STEEL, RUBBER)) * e / 2.0

    def of(kernel):
        return influence(n, shape.pixel, kernel) / np.pi / e

    def r(x, y):
        return np.hypot(x, y)

    normal = of(lambda x, y: 1.0 / r(x, y))
    xx, yy = (
        of(lambda x, y: even / r(x, y) + more * x * x / r(x, y) ** 3),
        of(lambda x, y: even / r(x, y) + more * y * y / r(x, y) ** 3),
    )
    xy = of(lambda x, y: more * x * y / r(x, y) ** 3)
    by_x, by_y = of(lambda x, y: beta * x / r(x, y) ** 2), of(lambda x, y: beta * y / r(x, y) ** 2)
    p, (qx, qy) = done.last.pressure.ravel(), done.last.traction.reshape(2, -1)
    gap = shape.gaps.ravel() + normal @ p + by_x @ qx + by_y @ qy - done.depth
    assert np.min(gap) >= -2e-5 * done.depth
    assert np.sum(p * np.abs(gap)) <= 2e-5 * np.sum(p) * done.depth
    u = np.stack((xx @ qx + xy @ qy - by_x @ p, xy @ qx + yy @ qy - by_y @ p)).reshape(2, *n)
    x, y = (
        (np.arange(14) - 6.5)[:, None] * shape.pixel[0] + 0.0 * done.last.pressure,
        (np.arange(14) - 6.5) * shape.pixel[1] + 0.0 * done.last.pressure,
    )
    slip = np.stack((
        done.longitudinal_creepage - done.spin_creepage * y,
        done.lateral_creepage + done.spin_creepage * (x + 0.25 * shape.pixel[0]),
    ))  # fmt: skip
    slip[:, :-1] += (u[:, 1:] - u[:, :-1]) / shape.pixel[0]
    bound = mu * done.last.pressure
    rubbed = bound * np.hypot(slip[0], slip[1])
    wrong = rubbed - np.sum(done.last.traction * slip, 0)
    assert np.sum(np.abs(wrong)) <= 1e-4 * np.sum(rubbed)
    assert np.all(np.hypot(*done.last.traction) <= bound * (1.0 + 1e-9))


@pytest.mark.slow
def test_friction_takes_the_work_of_creepage_and_of_the_resistance_to_rolling():
    medium, force = wk.HalfSpace.between(STEEL, RUBBER), 2e-7
    left = []
    for count in (24, 48):
        _, shape = ball(medium, force, 1.0, count)
        drive = wk.CreepForce(0.6 * 0.3 * force)
        done = wk.SurfaceRolling(shape, medium, wk.Force(force), wk.Coulomb(0.3), drive).solve()
        taken = float(np.sum(done.last.traction * done.last.creep)) * shape.pixel[0] * shape.pixel[1]
        left.append(1.0 - taken / float(done.loss_per_distance))
        # the pressures that oppose rolling stand ahead of the middle: they climb the gap
        climbed = np.sum(done.last.pressure * np.gradient(shape.gaps, shape.pixel[0], axis=0))
        assert done.rolling_resistance == pytest.approx(climbed * shape.pixel[0] * shape.pixel[1], rel=3e-2)
    assert 0.0 < left[1] < 0.6 * left[0] < 0.1


@pytest.mark.slow
@pytest.mark.parametrize("drive", [
    wk.ShearForce(8e-8), pytest.param(wk.Creepage(1e-3, 5e-4), marks=pytest.mark.slow),
])  # fmt: skip
def test_from_rest_to_steady_rolling_of_dissimilar_bodies(drive):
    medium, force = wk.HalfSpace.between(STEEL, ALUMINIUM), 1e-6
    a, shape = ball(medium, force, 1.0, 20)
    stated = (shape, medium, wk.Force(force), wk.Coulomb(0.2))
    begun = wk.SurfaceRollingStart(*stated, drive, distance=4.0 * a).solve()
    steady = wk.SurfaceRolling(*stated, drive).solve()
    for name, scale in {"creepage": 0.2 * a, "force": 0.2 * force}.items():
        for along in ("longitudinal", "lateral"):
            found, expected = getattr(begun, f"{along}_{name}")[-1], getattr(steady, f"{along}_{name}")
            assert found == pytest.approx(expected, abs=2e-2 * scale)


def test_at_rest_it_is_what_pressing_and_pushing_make():
    medium, force = wk.HalfSpace.between(STEEL, ALUMINIUM), 1e-6
    _, shape = ball(medium, force, 1.0, 20)
    stated = (shape, medium, wk.Force(force), wk.Coulomb(0.2))
    pushed = wk.SurfaceTangential(
        shape, medium, wk.Coulomb(0.2), wk.Path.through(wk.Force([force]), wk.ShearForce([0.4 * 0.2 * force]))
    ).solve()
    rest = wk.SurfaceRollingStart(*stated, wk.ShearForce(0.4 * 0.2 * force), distance=shape.pixel[0]).solve()
    assert rest.longitudinal_force[0] == pytest.approx(0.4 * 0.2 * force, rel=1e-7)
    assert rest.stick_share[0] == pytest.approx(pushed.stick_share[-1], abs=1e-12)


def test_similar_bodies_of_different_stiffness_are_not_coupled():
    """Dundurs' constant is zero of two incompressible bodies: the result is that of two alike of the same stiffness."""
    soft, hard = wk.Elastic(1.0, 0.5), wk.Elastic(3.0, 0.5)
    both = wk.Elastic(1.5, 0.5)
    done = [
        wk.SurfaceRolling(
            ball(medium, 1e-6, 1.0, 24)[1], medium, wk.Force(1e-6), wk.Coulomb(0.3), wk.Creepage(1e-3)
        ).solve()
        for medium in (wk.HalfSpace.between(soft, hard), wk.HalfSpace.between(both, both))
    ]
    assert done[0].rolling_resistance == 0.0
    assert done[0].longitudinal_force == pytest.approx(done[1].longitudinal_force, rel=1e-12)


def test_what_is_said_of_the_coupling(monkeypatch):
    medium = wk.HalfSpace.between(STEEL, ALUMINIUM)
    _, shape = ball(medium, 1e-6, 1.0, 24)
    problem = wk.SurfaceRolling(shape, medium, wk.Force(1e-6), wk.Coulomb(0.3), wk.Creepage(1e-3))
    (note,) = (note for note in problem.solve().validity if note.assumption is wk.Assumption.UNCOUPLED)
    assert "both effects are included" in note.statement
    monkeypatch.setattr(by_turns, "MOST_TURNS", 1)
    with pytest.raises(NotConverged, match="pressures and tractions of dissimilar bodies still miss each other"):
        problem.solve()


@pytest.mark.few(0, slow=3)
@pytest.mark.parametrize("seed", range(20))
def test_random_dissimilar_bodies(seed):
    """Any two materials, frictions from a hundredth to two, under loads, depths, forces and moments: all is met."""
    rng = np.random.default_rng(seed)
    for number in range(3):
        second = wk.Rigid() if rng.uniform() < 0.5 else wk.Elastic(10.0 ** rng.uniform(0.0, 2.0), 0.3)
        medium = wk.HalfSpace.between(wk.Elastic(1.0, rng.choice([0.0, 0.3, 0.45])), second)
        mu, a = 10.0 ** rng.uniform(-2.0, 0.3), 1e-2
        shape = wk.SampledProfile([3.0 * a, 3.0 * a], wk.Paraboloid(1.0), (24, 24))
        normal = wk.Depth(a * a) if number == 2 else wk.Force(4.0 / 3.0 * medium.modulus * a**3)
        push, towards = rng.uniform(0.0, 0.85) * mu * 4.0 / 3.0 * medium.modulus * a**3, rng.uniform(0.0, 2.0 * np.pi)
        twist = wk.Torque(0.0) if number else wk.Spin(10.0 ** rng.uniform(-3.0, 1.0))
        drive = wk.CreepForce(push * np.cos(towards), push * np.sin(towards), twist)
        done = wk.SurfaceRolling(shape, medium, normal, wk.Coulomb(mu), drive).solve()
        assert done.misfit <= 1e-7
        most = mu * done.force
        assert done.longitudinal_force == pytest.approx(drive.longitudinal, abs=1e-7 * most)
        assert done.lateral_force == pytest.approx(drive.lateral, abs=1e-7 * most)
        assert np.all(np.hypot(*done.last.traction) <= mu * done.last.pressure * (1.0 + 1e-9))
        assert np.sum(done.last.traction * done.last.creep) >= 0.0
