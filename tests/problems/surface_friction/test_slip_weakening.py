"""Friction of maps that falls with slip: closed forms, rings of another discretisation, energy, refused jumps."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from scipy.special import ellipe, ellipk

import winkler as wk
from winkler.values.errors import InvalidInput, OutsideValidity

SIDE, BALL, CONTACT, STATIC, KINETIC = 0.25, 1.0, 0.1, 0.3, 0.15
DEPTH = CONTACT**2 / BALL
DULL = wk.HalfSpace.between(wk.Elastic(1.0, 0.0), wk.Elastic(1.0, 0.0))
"""Without Poisson's ratio tractions along the surface act as pressures do: mu p moves all of it by mu d."""
FORCE = 4.0 / 3.0 * DULL.modulus * CONTACT**3 / BALL
FAR = STATIC * DEPTH
"""Shift at which all slides under the static coefficient."""
LAWS = (wk.LinearSlipWeakening, wk.ExponentialSlipWeakening)


def ball(count: int = 33) -> wk.SampledProfile:
    return wk.SampledProfile([SIDE, SIDE], wk.Paraboloid(BALL), (count, count))


def pushed(law, lateral, count: int = 33, normal=wk.Force(FORCE), **more) -> wk.SurfaceTangentialSolution:  # noqa: B008
    return wk.SurfaceTangential(ball(count), DULL, law, wk.Path.through(normal, lateral), **more).solve()


def test_coefficients():
    slip = np.array([0.0, 1e-6, 2e-6, 8e-6])
    linear, bent = (law(0.6, 0.2, distance=2e-6) for law in LAWS)
    np.testing.assert_allclose(linear.after_slip(slip), [0.6, 0.4, 0.2, 0.2])
    np.testing.assert_allclose(bent.after_slip(slip), 0.2 + 0.4 * np.exp(-slip / 2e-6))
    for law in (linear, bent):  # what is lost is the integral, how it falls the derivative
        fine = np.linspace(0.0, 8e-6, 80_001)
        mu = law.after_slip(fine)
        lost = np.concatenate(([0.0], np.cumsum(0.5 * (mu[1:] + mu[:-1]) * np.diff(fine))))
        np.testing.assert_allclose(law.lost(fine), lost, atol=1e-9 * lost[-1])
        np.testing.assert_allclose(law.fall(fine[5:15_000]), -np.gradient(mu, fine)[5:15_000], rtol=1e-4)


@pytest.mark.parametrize("law", LAWS)
def test_a_coefficient_that_does_not_fall_is_that_of_coulomb(law):
    lateral = wk.Shift(FAR * np.array([0.3, 0.9, -0.4, 0.1]))
    found, coulomb = pushed(law(STATIC, STATIC, 1e-6), lateral), pushed(wk.Coulomb(STATIC), lateral)
    for name in ("shear_force", "shift", "stored_energy", "stick_share"):
        np.testing.assert_array_equal(getattr(found, name), getattr(coulomb, name))
    np.testing.assert_allclose(found.dissipation, coulomb.dissipation, rtol=1e-7)


def wave_slip(law, height, mean, shift, count: int = 128) -> tuple[np.ndarray, np.ndarray]:
    """Return pressure and slip of a wave of length 1 in full contact that slides by a shift, on Fourier's series."""
    x = np.arange(count) / count
    pressure = mean + np.pi * DULL.modulus * height * np.cos(2.0 * np.pi * x)  # Westergaard
    wave = 2.0 * np.pi * np.abs(np.fft.fftfreq(count, 1.0 / count))
    response = 2.0 / DULL.modulus * np.divide(1.0, wave, out=np.zeros(count), where=wave > 0.0)
    matrix = np.real(np.fft.ifft(response[:, None] * np.fft.fft(np.eye(count), axis=0), axis=0))
    rate = (law.static_coefficient - law.kinetic_coefficient) / law.distance  # s = U - G (mu_s - rate s) p
    slip = np.linalg.solve(np.eye(count) - rate * matrix * pressure, shift - law.static_coefficient * matrix @ pressure)
    assert 0.0 < np.min(slip) < np.max(slip) < law.distance
    return pressure, slip


@pytest.mark.parametrize("points", [2, 6])
@pytest.mark.parametrize("direction", [[1.0, 0.0], [0.0, 1.0]])
def test_a_wave_slides_and_weakens(points, direction):
    """Linear weakening makes equations linear where all slips; in whatever steps, along and across the wave."""
    height, mean = 1e-3, 5e-3
    law = wk.LinearSlipWeakening(STATIC, KINETIC, 1.5e-3)
    pressure, slip = wave_slip(law, height, mean, 8e-4)
    x = (np.arange(64) + 0.5) / 64
    wave = wk.Topography(np.repeat(height * np.cos(2.0 * np.pi * x)[:, None], 4, 1), [1.0, 1.0 / 16], periodic=True)
    shift = np.outer(np.linspace(0.0, 8e-4, points), direction)
    path = wk.Path.through(wk.Force(mean / 16), wk.Shift(shift))
    done = wk.SurfaceTangential(wave, DULL, law, path).solve()
    np.testing.assert_allclose(
        done.last.pressure[:, 0], np.interp(x, np.arange(128) / 128, pressure, period=1.0), rtol=2e-3
    )
    rate = (STATIC - KINETIC) / law.distance
    force = float(np.mean((STATIC - rate * slip) * pressure)) / 16
    np.testing.assert_allclose(done.shear_force[-1], force * np.array(direction), rtol=2e-4, atol=1e-9 * force)
    lost = float(np.mean((STATIC * slip - 0.5 * rate * slip**2) * pressure)) / 16
    assert done.dissipation[-1] == pytest.approx(lost, rel=5e-4)
    assert np.ptp(done.last.slip_path) == pytest.approx(np.ptp(slip), rel=1e-2)


@pytest.mark.parametrize("law", LAWS)
def test_far_off_the_kinetic_coefficient_is_left(law):
    done = pushed(law(STATIC, KINETIC, FAR), wk.Shift(FAR * np.array([0.0, 1.0, 40.0])))
    assert done.shear_force[-1, 0] == pytest.approx(KINETIC * FORCE, rel=1e-6)


def ring_forces(law, shifts, rings: int = 120) -> tuple[np.ndarray, np.ndarray]:
    """Return the shear force, and the slip at the edge, of a ball of rings under growing shifts."""
    edges = CONTACT * np.sqrt(np.linspace(0.0, 1.0, rings + 1))
    middle = np.sqrt(0.5 * (edges[1:] ** 2 + edges[:-1] ** 2))

    def sunk(radius):  # under a unit of pressure on a disc (Johnson, 3.4.2)
        inner, outer = np.minimum(middle / radius, 1.0), np.minimum(radius / middle, 1.0)
        within = radius * ellipe(inner**2)
        beyond = middle * (ellipe(outer**2) - (1.0 - outer**2) * ellipk(np.minimum(outer, 1.0 - 1e-15) ** 2))
        return 4.0 / (np.pi * DULL.modulus) * np.where(middle < radius, within, beyond)

    matrix = np.stack([sunk(edges[k + 1]) - (sunk(edges[k]) if k else 0.0) for k in range(rings)], 1)
    area = np.pi * np.diff(edges**2)
    pressure = 2.0 * DULL.modulus / (np.pi * BALL) * np.sqrt(CONTACT**2 - middle**2)
    forces, at_edge, slip = [], [], np.zeros(rings)
    for shift in shifts:
        for _ in range(400):  # the core that sticks, then the coefficients of what slips outside of it
            bound = law.after_slip(slip) * pressure
            for core in range(rings + 1):
                q = bound.copy()
                if core:
                    right = shift - matrix[:core, core:] @ bound[core:]
                    q[:core] = np.linalg.solve(matrix[:core, :core], right)
                if core == rings or np.min(shift - matrix[core:] @ q) > 0.0:
                    break
            new = np.where(np.arange(rings) < core, 0.0, shift - matrix @ q)
            settled = np.max(np.abs(new - slip)) < 1e-9 * FAR
            slip = new
            if settled:
                break
        forces.append(float(np.sum(area * q)))
        at_edge.append(slip[-1])
    return np.array(forces), np.array(at_edge)


@pytest.mark.few(1)
@pytest.mark.parametrize("law", LAWS)
def test_partial_slip_as_on_rings(law):
    """A ring slips, the more the farther out: by dense equations of 120 rings."""
    weak = law(STATIC, KINETIC, 0.8 * FAR)
    shifts = FAR * np.array([0.3, 0.6, 0.8, 0.9])
    forces, at_edge = ring_forces(weak, shifts)
    done = pushed(weak, wk.Shift(shifts), 65)
    assert 0.0 < done.stick_share[-1] < 0.2
    np.testing.assert_allclose(done.shear_force[:, 0], forces, rtol=3e-3)
    assert np.all(np.diff(done.shear_force[:, 0]) > 0.0)
    assert np.max(done.last.slip_path) == pytest.approx(at_edge[-1], rel=3e-2)


@pytest.mark.slow
def test_more_steps_meet_the_work():
    """The work of the force, by trapezoids, becomes what is stored and lost, with the square of the steps."""
    law, missing = wk.ExponentialSlipWeakening(STATIC, KINETIC, FAR), []
    for points in (6, 12, 24):
        turn = np.linspace(0.0, 1.5 * np.pi, points + 1)
        done = pushed(law, wk.Shift(0.9 * FAR * np.sin(turn)), 17)
        force = done.shear_force[:, 0]
        work = float(np.sum(0.5 * (force[1:] + force[:-1]) * np.diff(done.shift[:, 0])))
        missing.append(abs(work - done.stored_energy[-1] - done.dissipation[-1]) / work)
    assert missing[2] < 6e-3
    assert missing[0] > 3.0 * missing[1] > 9.0 * missing[2]


@pytest.mark.few(1)
@pytest.mark.parametrize("law", LAWS)
def test_energy_is_lost_and_slip_is_not_forgotten(law):
    rng = np.random.default_rng(8)
    pair = wk.HalfSpace.between(wk.Elastic(1.0, 0.4), wk.Elastic(1.0, 0.4))
    weak = law(STATIC, KINETIC, 2.0 * FAR)
    shift, angle = 0.7 * FAR * rng.standard_normal((10, 2)), 0.01 * rng.standard_normal(10)
    path = wk.Path.through(wk.Force(FORCE), wk.Shift(shift))
    problem = wk.SurfaceTangential(ball(25), pair, weak, path, wk.Angle(angle))
    states = list(problem.steps())
    assert np.all(np.diff([state.dissipation for state in states]) >= 0.0)
    assert np.all(np.diff([state.slip_path for state in states], axis=0) >= 0.0)
    for state in states:
        size, bound = np.hypot(*state.traction), weak.after_slip(state.slip_path) * state.pressure
        assert np.all(size <= bound + 1e-7 * np.max(bound))
        np.testing.assert_allclose(size[state.slipping], bound[state.slipping], atol=1e-7 * np.max(bound))
        assert state.misfit <= 1e-8


def test_apart_it_does_not_heal():
    weak = wk.LinearSlipWeakening(STATIC, KINETIC, FAR)
    path = wk.Path.through(
        wk.Depth(DEPTH * np.array([1.0, 1.0, -1.0, 1.0])), wk.Shift(FAR * np.array([0, 40.0, 0, 40.0]))
    )
    states = list(wk.SurfaceTangential(ball(25), DULL, weak, path).steps())
    np.testing.assert_array_equal(states[2].slip_path, states[1].slip_path)
    assert states[3].shear_force[0] == pytest.approx(KINETIC * states[3].force, rel=1e-6)


@pytest.mark.slow
def test_dissimilar_bodies_weaken_too():
    """Pressed and slid: where all has slipped far the kinetic coefficient is left, whatever the coupling."""
    medium = wk.HalfSpace.between(wk.Elastic(1.0, 0.2))
    weak = wk.ExponentialSlipWeakening(STATIC, KINETIC, FAR)
    path = wk.Path.through(wk.Force(FORCE), wk.Shift(FAR * np.array([0.2, 0.5, 1.0, 30.0])))
    done = wk.SurfaceTangential(ball(25), medium, weak, path).solve()
    assert done.shear_force[-1, 0] == pytest.approx(KINETIC * FORCE, rel=1e-4)
    assert done.shear_force[1, 0] > done.shear_force[0, 0] > 0.0


SHARP, GENTLE = (wk.LinearSlipWeakening(STATIC, KINETIC, part * FAR) for part in (0.3, 1.0))


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(
    ("law", "lateral", "sentence"),
    [
        (
            SHARP,
            wk.Shift(FAR * np.append(np.linspace(0.2, 0.7, 8), np.linspace(0.72, 0.8, 17))),
            r"at index \d+ of the path the slip runs away: friction falls faster than the bodies unload",
        ),
        (SHARP, wk.Shift(FAR * np.array([0.0, 0.4, 0.8])), r"a jump may pass unseen; use about \d+ times as many"),
        (
            GENTLE,
            wk.ShearForce(0.98 * STATIC * FORCE * np.array([0.0, 0.7, 0.9, 1.0])),
            "a shear force of .* N is prescribed, but the friction limit is",
        ),
    ],
)
def test_jumps_are_refused(law, lateral, sentence):
    with pytest.raises(OutsideValidity, match=sentence):
        pushed(law, lateral, 33)


@pytest.mark.parametrize("law", [wk.StaticKinetic(0.4, 0.3), wk.FallingFriction(0.4, 0.3, 1.0)])
def test_friction_without_a_distance_is_refused(law):
    path = wk.Path.through(wk.Force(FORCE), wk.Shift([0.0]))
    with pytest.raises(InvalidInput, match="or a LinearSlipWeakening or ExponentialSlipWeakening, whose coefficient"):
        wk.SurfaceTangential(ball(25), DULL, law, path)


@pytest.mark.parametrize("law", LAWS)
def test_what_a_law_refuses(law):
    with pytest.raises(InvalidInput, match="kinetic coefficient 0.5 is above the static one, 0.3"):
        law(0.3, 0.5, 1e-6)
    with pytest.raises(InvalidInput, match=f"{law.__name__}: distance is 0"):
        law(0.3, 0.2, 0.0)
    assert dataclasses.replace(law(0.3, 0.2, 1e-6), distance=2e-6).distance == 2e-6
