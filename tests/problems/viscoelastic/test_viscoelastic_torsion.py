"""Torsion of bodies that relax: correspondence, harmonic loss, elastic limits, hereditary sums elsewhere."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import ellipk

import winkler as wk
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Angle, Depth, Force, ShearForce, Shift, Torque
from winkler.loading.path import Path
from winkler.materials.layered import Layer
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.materials.viscoelastic import Prony
from winkler.media.relaxing.proportional import RelaxingInProportion
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.values.errors import OutsideValidity

STANDARD = StandardSolid(0.05, 0.2, 0.2)
MU = 0.3
TIME = np.linspace(0.0, 1.0, 21)
PRESS = Depth(0.01 * np.sin(np.pi * TIME) ** 2)
SOFT, HARD = wk.Elastic(1.0, 0.3), wk.Elastic(5.0, 0.4)


def twisted(solid, path, profile=None, mu=MU, **more):
    bed = wk.Foundation(profile or wk.Paraboloid(1.0), ViscoelasticHalfSpace(solid))
    return wk.Torsion(bed, Coulomb(mu), path, **{"tolerance": 1e-6, **more}).solve()


@pytest.mark.parametrize(
    ("solid", "creep"),
    [
        (Maxwell(shear=0.25, relaxation_time=0.5), lambda t: (1.0 + t / 0.5) / 0.25),
        # J = 1/G_inf - G_1/(G_inf (G_inf + G_1)) exp(-t G_inf/(tau (G_inf + G_1)))
        (STANDARD, lambda t: 20.0 - 16.0 * np.exp(-t)),
    ],
)
def test_a_bonded_punch_creeps_by_its_compliance(solid, creep):
    """The angle is 3 M J(t) / (16 a^3) [Reissner and Sagoci, with the correspondence principle]."""
    time, a, torque = np.array([0.0, 0.1, 0.5, 2.0]), 0.1, 1e-6
    path = Path(time, Force(0.01), Torque(torque))
    punch = twisted(solid, path, wk.FlatPunch(a), math.inf, count=50)
    assert punch.angle == pytest.approx(3.0 * torque * creep(time) / (16.0 * a**3), rel=1e-4)


def test_a_bonded_punch_relaxes_by_its_modulus():
    time = np.array([0.0, 0.05, 0.2, 1.0])
    punch = twisted(STANDARD, Path(time, Force(0.01), Angle(1e-3)), wk.FlatPunch(0.1), math.inf, count=50)
    shear = 0.05 + 0.2 * np.exp(-time / 0.2)
    assert punch.torque == pytest.approx(16.0 / 3.0 * shear * 0.1**3 * 1e-3, rel=1e-12)
    assert punch.friction_loss == pytest.approx(np.zeros(4), abs=0.0)


def cycles(count, per, rest=10.0, frequency=1.5):
    """Some seconds at rest, then cycles."""
    time = np.arange(count * per + 1) / per / frequency
    return np.append(0.0, rest + time), np.append(0.0, np.sin(2.0 * np.pi * frequency * time))


@pytest.mark.slow
@pytest.mark.parametrize("solid", [STANDARD, Prony(0.05, [0.2, 0.3], [0.01, 0.5])])
def test_a_stuck_twist_loses_pi_torque_squared_times_the_loss_compliance(solid):
    a, torque, per = 0.1, 1e-6, 200
    time, wave = cycles(60, per, rest=300.0)
    punch = twisted(solid, Path(time, Force(0.01), Torque(torque * wave)), wk.FlatPunch(a), math.inf, count=50)
    modulus = complex(solid.series.dynamic(np.array(2.0 * np.pi * 1.5)))
    lossy = -(3.0 / (16.0 * a**3) / modulus).imag
    assert punch.loss_per_cycle == pytest.approx(math.pi * torque**2 * lossy, rel=1e-3, abs=0.0)
    assert punch.friction_loss[-1] == 0.0
    # the path has straight pieces, 2 pi/200 long, whose loss is off by the square of that
    stored = 3.0 / (16.0 * a**3) / modulus
    assert 1.0 / punch.secant_stiffness == pytest.approx(abs(stored), rel=1e-3)


@pytest.mark.few(2, slow=2)
@pytest.mark.parametrize("profile", [wk.Paraboloid(1.0), wk.Cone(half_angle=1.4)])
@pytest.mark.parametrize(("tau", "shear"), [(1e-7, 0.05), (1e7, 0.25)])
def test_fast_and_slow_it_is_the_elastic_twist_at_second_order(profile, tau, shear):
    path = Path(TIME, PRESS, Angle(0.05 * np.sin(4.0 * np.pi * TIME)))
    elastic = wk.Foundation(profile, wk.HalfSpace(wk.Elastic(3.0 * shear, 0.5)))
    true = wk.Torsion(elastic, Coulomb(MU), path).solve()
    errors = []
    for count in (100, 400):
        ours = twisted(StandardSolid(0.05, 0.2, tau), path, profile, count=count)
        errors.append(np.max(np.abs(ours.torque - true.torque)) / np.max(true.torque))
        assert ours.dissipation == pytest.approx(true.dissipation, abs=3e-4 * true.dissipation[-1])
    assert errors[1] < 2e-5
    assert errors[0] > 7.0 * errors[1]
    assert ours.torque_limit == pytest.approx(true.torque_limit, abs=6e-5 * np.max(true.torque_limit))
    assert ours.stick_radius == pytest.approx(true.stick_radius, abs=3e-3 * np.max(true.radius))


MEDIA = {
    "power law": wk.GradedHalfSpace.between(wk.PowerLawGraded(young=1.0, depth_scale=1.0, exponent=0.3, poisson=0.3)),
    "hard coating": wk.CoatedHalfSpace([Layer(HARD, 0.1)], on=SOFT),
    "soft coating": wk.CoatedHalfSpace([Layer(SOFT, 0.1)], on=HARD),
}


@pytest.mark.parametrize("kind", [wk.Torsion, wk.Tangential])
@pytest.mark.parametrize("name", MEDIA)
def test_layers_and_power_laws_have_their_elastic_limits(kind, name):
    """Springs one by one against the rings, or springs by gap, of the elastic body."""
    wave = np.sin(4.0 * np.pi * TIME)
    path = Path(TIME, PRESS, Angle(0.05 * wave) if kind is wk.Torsion else Shift(0.003 * wave))
    true = kind(wk.Foundation(wk.Paraboloid(1.0), MEDIA[name]), Coulomb(MU), path).solve()
    for tau, factor in ((1e7, 1.0), (1e-7, 0.2)):
        medium = RelaxingInProportion(MEDIA[name], StandardSolid(0.05, 0.2, tau), shear=0.25)
        ours = kind(wk.Foundation(wk.Paraboloid(1.0), medium), Coulomb(MU), path, count=200, tolerance=1e-6).solve()
        word = "torque" if kind is wk.Torsion else "shear_force"
        expected = factor * getattr(true, word)
        assert getattr(ours, word) == pytest.approx(expected, abs=6e-5 * np.max(expected))
        assert ours.dissipation == pytest.approx(factor * true.dissipation, abs=2e-4 * factor * true.dissipation[-1])


def test_a_thin_soft_coating_relaxes_otherwise_than_its_base_alone():
    """The substrate is felt: equal layers would not show it."""
    path = Path(TIME, PRESS, Angle(0.05 * np.sin(4.0 * np.pi * TIME)))
    torques = []
    for medium in (MEDIA["soft coating"], wk.HalfSpace(HARD)):
        relaxing = RelaxingInProportion(medium, STANDARD, shear=0.25)
        bed = wk.Foundation(wk.Paraboloid(1.0), relaxing)
        torques.append(np.max(wk.Torsion(bed, Coulomb(MU), path, count=100).solve().torque))
    assert torques[0] < 0.8 * torques[1]


def test_hereditary_sums_at_other_places_agree():
    """A ball pressed until it has relaxed, then twisted to and fro: Gauss points, and sums over all earlier moments."""
    depth, amplitude, per = 0.01, 0.05, 200
    time, wave = cycles(2, per)
    ours = twisted(STANDARD, Path(time, Depth(depth), Angle(amplitude * wave)), count=800)
    a, late = math.sqrt(depth), time[1:]
    nodes, weights = np.polynomial.legendre.leggauss(200)
    x, dx = 0.5 * a * (1.0 + nodes), 0.5 * a * weights
    # b = 4 mu E*/pi int_x^a 2 K(1 - x^2/t^2) dt, E* = 4 G of the relaxed body [theory of the elastic twist]
    s, ds = np.polynomial.legendre.leggauss(400)
    half = 0.5 * (a - x)[:, None]
    t = x[:, None] + half * (1.0 + s)
    bound = 8.0 * MU * 4.0 * 0.05 / math.pi * np.sum(half * ds * ellipk(1.0 - (x[:, None] / t) ** 2), axis=1)
    step = late[1] - late[0]
    # the mean over a step of 8 G at a distance of k steps
    k = np.arange(late.size)
    tail = 0.2 * 0.2 / step * (np.exp(-np.maximum(k - 1, 0) * step / 0.2) - np.exp(-k * step / 0.2))
    kernel = 8.0 * (0.05 + tail)
    turned, torque, lost = np.zeros((late.size, x.size)), np.zeros(late.size), np.zeros(late.size)
    h_before = np.zeros(x.size)
    for n in range(1, late.size):
        move = amplitude * (wave[1:][n] - wave[1:][n - 1])
        past = kernel[n - np.arange(1, n) + 1] @ turned[1:n] if n > 1 else np.zeros(x.size)
        h = np.clip(past + kernel[1] * move, -bound, bound)
        turned[n] = (h - past) / kernel[1]
        lost[n] = lost[n - 1] + 2.0 * np.sum(
            dx * x**2 * 0.5 * np.abs(h + np.sign(h) * np.abs(h_before)) * np.abs(move - turned[n])
        )
        torque[n], h_before = 2.0 * np.sum(dx * x**2 * h), h
    assert ours.torque[1:] == pytest.approx(torque, abs=2e-4 * np.max(torque))
    assert ours.friction_loss[-1] == pytest.approx(lost[-1], rel=5e-3)
    assert 0.2 < ours.stick_radius[1 + per // 4] / a < 0.9


def test_more_springs_and_shorter_steps_settle():
    path = Path(TIME, Force(1e-3 * (1.0 + 0.5 * np.sin(2.0 * np.pi * TIME))), Angle(0.03 * np.sin(4.0 * np.pi * TIME)))
    torque = [twisted(STANDARD, path, count=count).torque for count in (50, 100, 200, 400)]
    steps = [np.max(np.abs(one - two)) for one, two in zip(torque[:-1], torque[1:], strict=True)]
    assert steps[1] < 0.4 * steps[0]
    assert steps[2] < 0.4 * steps[1]
    loose, strict = (twisted(STANDARD, path, tolerance=tolerance, count=100) for tolerance in (1e-4, 1e-7))
    most = float(np.max(strict.torque_limit))
    assert np.max(np.abs(loose.torque - strict.torque)) < 1e-3 * most


def test_a_prescribed_torque_gives_back_the_angle():
    time = np.linspace(0.0, 1.0, 161)
    path = Path(time, Depth(0.01), Angle(0.02 * np.sin(4.0 * np.pi * time)))
    given = twisted(STANDARD, path, count=100, tolerance=1e-7)
    back = twisted(STANDARD, Path(time, Depth(0.01), Torque(given.torque)), count=100, tolerance=1e-7)
    assert back.angle == pytest.approx(given.angle, abs=1e-3 * 0.02)  # torques are straight between points here


def test_energies_balance_and_mirrored_paths_are_mirrored():
    wave = 0.05 * np.sin(4.0 * np.pi * TIME)
    ours, other = (twisted(STANDARD, Path(TIME, PRESS, Angle(sign * wave)), count=100) for sign in (1.0, -1.0))
    assert other.torque == pytest.approx(-ours.torque, abs=1e-12)
    missed = ours.work - ours.stored_energy - ours.dissipation
    assert missed == pytest.approx(0.0, abs=1e-12 * np.max(ours.work))
    assert ours.dissipation == pytest.approx(ours.friction_loss + ours.bulk_loss, rel=1e-12)


def test_what_elastic_bodies_do_not_lose_is_refused():
    path = Path([0.0, 1.0], Depth(0.01), Angle([0.0, 0.01]))
    elastic = wk.Torsion(wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(HARD)), Coulomb(MU), path).solve()
    with pytest.raises(OutsideValidity, match="bulk_loss"):
        _ = elastic.bulk_loss


def test_a_kelvin_voigt_ball_sticks_and_shears_with_its_dashpot():
    solid = KelvinVoigt(0.25, 0.05)
    time = np.array([0.0, 1.0, 1.5, 2.0])
    path = Path(time, Depth(0.01), Angle([0.0, 0.0, 0.01, 0.02]))
    ours = twisted(solid, Path(time, Depth([0.0, 0.01, 0.01, 0.01]), path.lateral), None, math.inf, count=2000)
    # after the ball has come to rest: M = 16/3 a^3 (G phi + eta phi'), eta = G tau
    viscosity = solid.series.viscosity
    expected = 16.0 / 3.0 * 0.1**3 * (0.25 * 0.02 + viscosity * 0.02)
    assert ours.torque[-1] == pytest.approx(expected, rel=1.2e-3)  # the last spring, at the edge, bears nothing


def test_a_push_on_relaxing_layers_balances():
    medium = RelaxingInProportion(MEDIA["soft coating"], STANDARD, shear=0.25)
    path = Path(TIME, Force(1e-3), ShearForce(0.5 * MU * 1e-3 * np.sin(np.pi * TIME) ** 3))
    ours = wk.Tangential(wk.Foundation(wk.Paraboloid(1.0), medium), Coulomb(MU), path, count=100).solve()
    assert ours.work - ours.stored_energy - ours.dissipation == pytest.approx(0.0, abs=1e-12 * np.max(ours.work))
    assert [note for note in ours.validity if "parallel to the motion and axisymmetric" in note.statement]
