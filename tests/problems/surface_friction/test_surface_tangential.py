"""Stick and slip of height maps: Cattaneo and Mindlin, memory of round bodies, CONTACT, dissimilar bodies, energy."""

from __future__ import annotations

import math
import tomllib

import numpy as np
import pytest
from scipy.special import ellipk

import winkler as wk
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Standing, worst

SIDE, BALL, CONTACT, MU = 0.25, 1.0, 0.1, 0.3
DEPTH = CONTACT**2 / BALL
DULL = wk.HalfSpace.between(wk.Elastic(1.0, 0.0), wk.Elastic(1.0, 0.0))
FORCE = 4.0 / 3.0 * DULL.modulus * CONTACT**3 / BALL
FAR = MU * DEPTH * DULL.modulus / DULL.shear_modulus
"""Shift at which all of the ball slides."""


def ball(count: int = 65, radius: float = BALL) -> wk.SampledProfile:
    return wk.SampledProfile([SIDE, SIDE], wk.Paraboloid(radius), (count, count))


@pytest.mark.slow
def test_cattaneo_and_mindlin():
    """On 129 x 129 pixels, from a tenth of the friction on to nearly all of it."""
    part = np.array([0.1, 0.5, 0.875, 0.99])
    path = wk.Path.through(wk.Force(FORCE), wk.ShearForce(part * MU * FORCE))
    problem = wk.SurfaceTangential(ball(129), DULL, wk.Coulomb(MU), path)
    states = list(problem.steps())
    pushed = problem.gathered(states)
    np.testing.assert_allclose(pushed.shift[:, 0], FAR * (1.0 - (1.0 - part) ** (2.0 / 3.0)), rtol=1e-4)
    np.testing.assert_allclose(pushed.stick_share, (1.0 - part) ** (2.0 / 3.0), atol=5e-3)
    np.testing.assert_allclose(pushed.shear_force, np.stack((part, 0.0 * part), 1) * MU * FORCE, atol=1e-9 * FORCE)
    c = CONTACT * (1.0 - part[2]) ** (1.0 / 3.0)  # the traction is a pressure less a smaller one
    r = np.abs((np.arange(129) - 64.0) * SIDE / 129)
    expected = (
        MU
        * 2.0
        * DULL.modulus
        / (np.pi * BALL)
        * (np.sqrt(np.maximum(CONTACT**2 - r**2, 0.0)) - np.sqrt(np.maximum(c**2 - r**2, 0.0)))
    )
    inside = r < 0.97 * CONTACT
    np.testing.assert_allclose(states[2].traction[0][64][inside], expected[inside], atol=1e-2 * np.max(expected))


def test_an_ellipse():
    """x^2/4 + y^2/2: F = 1.6014550 d^(3/2), and without Poisson's ratio the shift is mu d (1 - (1 - part)^(2/3))."""
    side, depth, part = 0.55, 0.02, np.array([0.3, 0.8])
    force = 1.6014550 * DULL.modulus * depth**1.5
    topography = wk.SampledProfile([side, side], wk.CurvedBodies(2.0, 1.0), (129, 129))
    path = wk.Path.through(wk.Force(force), wk.ShearForce(np.outer(part, [0.6, 0.8]) * MU * force))
    pushed = wk.SurfaceTangential(topography, DULL, wk.Coulomb(MU), path).solve()
    shift = MU * depth * (1.0 - (1.0 - part) ** (2.0 / 3.0))
    np.testing.assert_allclose(pushed.shift, np.outer(shift, [0.6, 0.8]), rtol=2e-4)
    assert pushed.depth[0] == pytest.approx(depth, rel=1e-4)


@pytest.mark.parametrize("along", [0, 1])
def test_an_ellipse_sticks_as_stiffly_along_either_axis(along):
    """The traction F / (2 pi a b) / sqrt(1 - ...) moves all of it alike, here integrated over directions."""
    nu, part = 0.3, 0.1
    pair = wk.HalfSpace.between(wk.Elastic(1.0, nu), wk.Elastic(1.0, nu))
    bodies, force = wk.CurvedBodies(2.0, 1.0), 0.004
    topography = wk.SampledProfile([0.5, 0.4], bodies, (129, 105))
    push = np.zeros((1, 2))
    push[0, along] = part * MU * force
    path = wk.Path.through(wk.Force([force]), wk.ShearForce(push))
    pushed = wk.SurfaceTangential(topography, pair, wk.Coulomb(MU), path).solve()
    axes = bodies.semi_axes(pair.modulus, force)
    turn = np.linspace(0.0, 2.0 * np.pi, 400, endpoint=False)
    reach = 1.0 / np.hypot(np.cos(turn) / axes[0], np.sin(turn) / axes[1])
    aligned = (np.cos(turn), np.sin(turn))[along] ** 2
    compliance = np.mean((1.0 + nu / (1.0 - nu) * aligned) * reach) / (2.0 * axes[0] * axes[1] * pair.modulus)
    shift = compliance * 1.5 * MU * force * (1.0 - (1.0 - part) ** (2.0 / 3.0))
    assert pushed.shift[0, along] == pytest.approx(shift, rel=5e-4)


@pytest.mark.slow
def test_a_normal_load_that_changes_too():
    turn = np.linspace(0.0, 2.0 * np.pi, 21)
    path = wk.Path.through(wk.Depth(DEPTH * (0.7 + 0.3 * np.sin(turn))), wk.Shift(0.6 * FAR * np.sin(2.0 * turn + 0.5)))
    found = wk.SurfaceTangential(ball(), DULL, wk.Coulomb(MU), path).solve()
    exact = wk.Tangential(wk.Foundation(wk.Paraboloid(BALL), DULL), wk.Coulomb(MU), path).solve()
    np.testing.assert_allclose(found.shear_force[:, 0], exact.shear_force, atol=1e-3 * MU * FORCE)
    assert found.dissipation[-1] == pytest.approx(exact.dissipation[-1], rel=1.5e-2)


def test_the_ball_of_contact(shared_data):
    """The same grid: what CONTACT prints, with its four digits."""
    file = shared_data / "reference" / "contact" / "cattaneo_ball.toml"
    given = tomllib.loads(file.read_text(encoding="utf-8"))
    inputs, (_, case) = given["inputs"], given["case"]
    shear, nu, force = inputs["shear_modulus_Pa"], inputs["poisson"], inputs["normal_force_N"]
    body = wk.Elastic(2.0 * shear * (1.0 + nu), nu)
    side = 19 * 0.13333e-3
    topography = wk.SampledProfile([side, side], wk.Paraboloid(inputs["curvature_radius_m"]), (19, 19))
    push = -inputs["force_x_ratio"] * inputs["friction"] * force
    path = wk.Path.through(wk.Force(force), wk.ShearForce([push]))
    problem = wk.SurfaceTangential(topography, wk.HalfSpace(body, body), wk.Coulomb(inputs["friction"]), path)
    pushed = problem.solve()
    assert pushed.shift[0, 0] == pytest.approx(case["shift_x_m"], rel=1e-4)
    assert pushed.dissipation[0] == pytest.approx(-case["friction_work_J"], rel=3e-4)
    assert np.count_nonzero(pushed.last.slipping) == case["elements_slip"]
    assert np.count_nonzero(pushed.last.pressure > 0.0) == case["elements"]
    assert np.max(pushed.last.pressure) == pytest.approx(case["peak_pressure_Pa"], rel=2e-4)
    assert pushed.stored_energy[0] == pytest.approx(
        case["elastic_energy_J"] - given["case"][0]["elastic_energy_J"], rel=1e-3
    )
    table = np.genfromtxt(file.with_name("cattaneo_ball_tractions.csv"), delimiter=",", skip_header=2)
    i, j = (np.rint(table[:, k] / 0.13333e-3 + 9).astype(int) for k in (0, 1))
    size = np.hypot(*pushed.last.traction)[i, j]
    np.testing.assert_allclose(size, table[:, 5], rtol=0.0, atol=5.05e3)  # three digits of up to 1.76 MPa


def test_energy_is_never_created():
    """F du of the load at the end of a step is at least what is stored and lost: of any motion, twist included."""
    rng = np.random.default_rng(5)
    rough = wk.RandomTopography(
        [1.0, 1.0],
        wk.SelfAffine(hurst=0.8, rms_height=0.02, longest=1.0, shortest=0.1),
        (32, 32),
        seed=3,
        periodic=False,
    )
    pair = wk.HalfSpace.between(wk.Elastic(1.0, 0.4), wk.Elastic(1.0, 0.4))
    shift, angle = 0.02 * rng.standard_normal((12, 2)), 0.05 * rng.standard_normal(12)
    path = wk.Path.through(wk.Force(0.01), wk.Shift(shift))
    done = wk.SurfaceTangential(rough, pair, wk.Coulomb(0.5), path, wk.Angle(angle)).solve()
    np.testing.assert_allclose(done.shift, shift, atol=1e-15)
    np.testing.assert_allclose(done.angle, angle, atol=1e-15)
    moved, turned = np.diff(done.shift, axis=0), np.diff(done.angle)
    spent = np.sum(done.shear_force[1:] * moved, 1) + done.torque[1:] * turned
    lost = np.diff(done.dissipation)
    assert np.all(lost >= 0.0)
    assert np.all(spent - np.diff(done.stored_energy) - lost >= -1e-7 * np.max(done.stored_energy))
    assert float(np.sum(done.last.friction_work)) / 1024 == pytest.approx(done.dissipation[-1], rel=1e-9)


def test_a_flat_disc_that_sticks_is_stiffer_on_dissimilar_bodies():
    """By artanh(beta) / beta (Mossakovskii); on pixels an error that falls with their size."""
    medium, count, side = wk.HalfSpace.between(wk.Elastic(1.0, 0.0)), 65, 2.2
    x = (np.arange(count) - 0.5 * (count - 1)) * side / count
    disc = wk.Topography(np.where(np.hypot(x[:, None], x) <= 1.0, 0.0, -1.0), [side, side])
    path = wk.Path.through(wk.Depth([1e-3]), wk.Shift(0.0))
    stuck, free = (wk.SurfaceTangential(disc, medium, wk.Coulomb(mu), path).solve() for mu in (100.0, 1e-6))
    assert stuck.stick_share[0] == 1.0
    beta = medium.mismatch
    assert stuck.force[0] / free.force[0] == pytest.approx(math.atanh(beta) / beta, rel=1.5e-3)


@pytest.mark.slow
def test_a_ball_that_slips_while_it_is_pressed(monkeypatch):
    """Goodman's and Spence's stick radius: without what tractions do to the pressure, as both assume."""
    monkeypatch.setattr(TractionGrid, "sunk", lambda self, traction: np.zeros(self.grid.shape))
    medium = wk.HalfSpace.between(wk.Elastic(1.0, 0.3))
    force = FORCE * medium.modulus / DULL.modulus
    shares = []
    for count in (40, 80):
        path = wk.Path.through(wk.Force(force * np.geomspace(5e-3, 1.0, count)), wk.ShearForce(0.0))
        pressed = wk.SurfaceTangential(ball(), medium, wk.Coulomb(0.2), path).solve()
        shares.append(math.sqrt(np.mean(pressed.stick_share[-5:])))
    c = 2.0 * shares[1] - shares[0]  # of first order in the steps
    left, right = math.log((1.0 + c) / (1.0 - c)) / (2.0 * c), 0.2 / medium.mismatch * ellipk(1.0 - c * c)
    assert left == pytest.approx(right, rel=2e-2)


@pytest.mark.slow
def test_dissimilar_bodies_are_solved_together():
    medium = wk.HalfSpace.between(wk.Elastic(1.0, 0.2))
    force = FORCE * medium.modulus / DULL.modulus
    path = wk.Path.through(wk.Force(force * np.linspace(0.2, 1.0, 5)), wk.ShearForce(0.0))
    pressed = wk.SurfaceTangential(ball(33), medium, wk.Coulomb(MU), path).solve()
    free = wk.SurfaceTangential(ball(33), medium, wk.Coulomb(1e-6), path).solve()
    assert np.all(pressed.depth < free.depth)
    assert 0.3 < pressed.stick_share[-1] < 0.9
    np.testing.assert_allclose(pressed.shear_force, 0.0, atol=1e-9 * force)
    x, traction = np.arange(33) - 16.0, pressed.last.traction[0]
    assert np.sum(traction * x[:, None]) > 0.0  # the soft surface is drawn inwards, and held
    notes = [note for note in pressed.validity if note.assumption is wk.Assumption.UNCOUPLED]
    assert "dissimilar" in notes[0].statement


@pytest.mark.parametrize("left", [0.1, 0.3, 0.5])
def test_what_is_let_go_together_is_gone(left):
    """What is left in contact never slipped, and comes back: no shear force, no traction, no shift."""
    path = wk.Path.through(wk.Force([FORCE, FORCE, left * FORCE]), wk.ShearForce([0.0, 0.3 * MU * FORCE, 0.0]))
    states = list(wk.SurfaceTangential(ball(33), DULL, wk.Coulomb(MU), path).steps())
    traction = [np.max(np.hypot(*state.traction)) for state in states]
    assert traction[1] > 0.1 * MU * states[1].peak_pressure
    assert traction[2] < 1e-6 * traction[1]
    assert abs(states[2].shift[0]) < 1e-6 * states[1].shift[0]


def test_apart_and_together_again():
    path = wk.Path.through(wk.Depth([DEPTH, -DEPTH, DEPTH]), wk.Shift([0.3 * FAR, 0.3 * FAR, 0.3 * FAR]))
    found = wk.SurfaceTangential(ball(33), DULL, wk.Coulomb(MU), path).solve()
    assert found.shear_force[0, 0] > 0.0
    np.testing.assert_allclose(found.shear_force[1:], 0.0, atol=1e-12 * FORCE)
    np.testing.assert_array_equal(found.area[1], 0.0)
    assert found.depth[1] == -DEPTH
    assert worst(found.validity) is not Standing.OUTSIDE


def test_a_periodic_map_bears_its_shear_force():
    spectrum = wk.SelfAffine(hurst=0.8, rms_height=0.02, longest=1.0, shortest=0.1)
    rough = wk.RandomTopography([1.0, 1.0], spectrum, (32, 32), seed=1)
    push = wk.ShearForce([[0.0, 0.0], [0.002, 0.001], [-0.001, 0.002]])
    path = wk.Path.through(wk.Force(0.02), push)
    found = wk.SurfaceTangential(rough, DULL, wk.Coulomb(MU), path).solve()
    np.testing.assert_allclose(found.shear_force, push.shear_force, atol=1e-9)
    assert np.all(np.hypot(*found.last.traction) <= MU * found.last.pressure * (1.0 + 1e-9))


WAVY = wk.RandomTopography([1.0, 1.0], wk.SelfAffine(hurst=0.8, rms_height=0.02, longest=1.0, shortest=0.2), (16, 16))


@pytest.mark.parametrize(("change", "error", "sentence"), [
    ({"path": wk.Path.through(wk.Force(FORCE), wk.ShearForce([0.0, MU * FORCE]))}, OutsideValidity,
     "at index 1 of the path a shear force of 0.0002 N is prescribed, but the friction limit is 0.0002 N"),
    ({"path": wk.Path.through(wk.Depth([DEPTH, 0.0]), wk.ShearForce(1e-6))}, OutsideValidity,
     "the friction limit is 0 N"),
    ({"path": wk.Path.through(wk.Depth(DEPTH), wk.Torque([1.0]))}, OutsideValidity, "a torque of 1 N m"),
    ({"path": wk.Path.through(wk.Depth(DEPTH), wk.Angle([1.0])), "twist": wk.Angle(1.0)}, InvalidInput,
     "a twist beside"),
    ({"twist": wk.Angle([1.0, 2.0, 3.0])}, InvalidInput, r"shape \(3,\) for a path of 2 points"),
    ({"topography": WAVY, "twist": wk.Torque(0.0)}, InvalidInput, "no middle for a rotation"),
    ({"topography": wk.Topography([[0.0, np.nan], [1.0, 2.0]], [1.0, 1.0])}, InvalidInput,
     "1 of 4 heights are missing"),
    ({"law": wk.Coulomb(math.inf)}, InvalidInput, "positive, finite coefficient"),
    ({"twist": wk.Torque(0.9e-5)}, NotConverged, "If friction carries the forces together, use shorter steps"),
])  # fmt: skip
def test_what_it_refuses(change, error, sentence):
    stated = {
        "topography": ball(17),
        "medium": DULL,
        "law": wk.Coulomb(MU),
        "path": wk.Path.through(wk.Force(FORCE), wk.ShearForce([0.0, 0.8 * MU * FORCE])),
    }
    with pytest.raises(error, match=sentence):
        wk.SurfaceTangential(**(stated | change)).solve()
