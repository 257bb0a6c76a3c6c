"""Height maps with friction on layers that relax each by a law of its own: limits, one law, round contacts."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.values.errors import InvalidInput

MU, DEPTH, SHIFT = 0.3, 0.01, 8e-4
BALL = wk.Paraboloid(1.0)


def solid(tau=1.0):
    return wk.StandardSolid(0.1, 0.15, tau, poisson=0.3)


def film(tau=1.0, young=1.0, second=None):
    layers = [wk.ViscoelasticLayer(solid(tau), 0.05)]
    return wk.ViscoelasticCoatedHalfSpace(layers, wk.Elastic(young, 0.3), second or wk.Rigid())


def ball(count=33):
    return wk.SampledProfile([0.25, 0.25], BALL, (count, count))


def pushed(medium, path, topography=None, **more):
    return wk.SurfaceTangential(topography or ball(), medium, wk.Coulomb(MU), path, **more).solve()


@pytest.mark.parametrize(("tau", "limit"), [(1e7, "glassy"), (1e-6, "relaxed")])
@pytest.mark.parametrize("by_load", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_fast_and_slow_paths_are_those_of_the_elastic_layers(tau, limit, by_load):
    part = np.array([0.0, 0.0, 0.5, 1.0, -0.3])
    normal = wk.Force(1e-3 * np.array([0.5, 1.0, 1.0, 1.1, 0.9])) if by_load else wk.Depth(DEPTH * np.ones(5))
    lateral = wk.ShearForce(1.2e-4 * part) if by_load else wk.Shift(SHIFT * part)
    path, twist = wk.Path(np.arange(5.0), normal, lateral), wk.Angle(0.01 * part)
    medium = film(tau)
    ours, true = (pushed(one, path, twist=twist) for one in (medium, getattr(medium, limit)))
    for name in ("depth", "force", "shift", "shear_force", "torque", "friction_loss", "stored_energy"):
        mine, its = (np.asarray(getattr(one, name))[1:] for one in (ours, true))
        np.testing.assert_allclose(mine, its, rtol=0.0, atol=2e-4 * np.max(np.abs(its)), err_msg=name)


def test_where_all_parts_relax_alike_the_course_is_that_of_the_modulus():
    """On a half-space of the same solid held forces fall as G(t), to the square of the steps."""
    layers = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(solid(), 0.05)], solid())
    part = wk.Elastic(0.26, 0.3)
    alike = wk.RelaxingInProportion(wk.CoatedHalfSpace([wk.Layer(part, 0.05)], part), solid(), 0.1)
    fall, apart = (0.1 + 0.15 * np.exp(-1.0)) / 0.25, []
    for count in (6, 11):
        path = wk.Path(np.linspace(0.0, 1.0, count), wk.Depth(DEPTH), wk.Shift(SHIFT))
        ours, true = (pushed(medium, path) for medium in (layers, alike))
        np.testing.assert_allclose(ours.force[0], true.force[0], rtol=1e-5)
        np.testing.assert_allclose(ours.shear_force[0, 0], true.shear_force[0, 0], rtol=1e-5)
        np.testing.assert_allclose(ours.friction_loss[0], true.friction_loss[0], rtol=1e-4)
        fallen = np.array([ours.force[-1] / ours.force[0], ours.shear_force[-1, 0] / ours.shear_force[0, 0]])
        apart.append(np.abs(fallen / fall - 1.0))
    assert np.all(apart[1] < 0.35 * apart[0])
    assert np.all(apart[1] < 3e-4)
    whole = ours.stored_energy + ours.bulk_loss
    np.testing.assert_allclose(whole, whole[0], rtol=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize("young", [2.6, 0.026])
def test_a_ball_is_pushed_as_cells_of_a_round_contact_are(young):
    """Pixels know no line loads and no Abel transform, cells no pixels; Poisson's ratio turns tractions a little."""
    time = np.linspace(0.0, 2.0, 21)
    medium = film(0.7, young)
    shift = 1.5e-3 * np.sin(2.0 * time)
    path = wk.Path(time, wk.Depth(DEPTH * np.ones(21)), wk.Shift(shift))
    ours = pushed(medium, path, ball(65))
    true = wk.Tangential(wk.Foundation(BALL, medium), wk.Coulomb(MU), path).solve()
    assert ours.force == pytest.approx(true.force, rel=5e-3)
    most = np.max(np.abs(true.shear_force))
    assert ours.shear_force[:, 0] == pytest.approx(true.shear_force, abs=0.02 * most)
    elastic = wk.Tangential(wk.Foundation(BALL, medium.relaxed), wk.Coulomb(MU), path).solve()
    assert np.max(np.abs(elastic.shear_force - true.shear_force)) > 0.05 * most


@pytest.mark.slow
def test_periodic_maps_lose_no_energy_and_feel_their_base():
    x = np.linspace(0.0, 2.0 * np.pi, 32, endpoint=False)
    waves = wk.Topography(0.01 * np.cos(x)[:, None] * np.cos(x)[None, :], [0.5, 0.5], periodic=True)
    time = np.linspace(0.0, 1.0, 41)
    path = wk.Path(time, wk.Depth(0.004 * np.ones(41)), wk.Shift(2e-4 * np.ones(41)))
    held = [pushed(film(0.5, young), path, waves) for young in (1.0, 0.1)]
    for one in held:
        whole = one.stored_energy + one.bulk_loss
        np.testing.assert_allclose(whole, whole[0], rtol=2e-3)
    assert held[0].shear_force[-1, 0] > 1.05 * held[1].shear_force[-1, 0]


def test_the_shear_of_a_gel_is_refused_with_two_elastic_films():
    with pytest.raises(InvalidInput, match="drained Poisson's ratio"):
        pushed(wk.PoroelasticFilm(0.1, 0.3, 1.0, 0.05), wk.Path([0.0, 1.0], wk.Depth(DEPTH), wk.Shift([0.0, SHIFT])))
