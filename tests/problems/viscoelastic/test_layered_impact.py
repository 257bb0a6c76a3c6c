"""Impacts on layers that relax each by a law of its own, and on films that liquid leaves."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq, nnls

import winkler as wk
from winkler.materials.spring_and_dashpot import StandardSolid

H, BALL = 1e-3, wk.Paraboloid(1e-2)
BASE = wk.Elastic(1e5, 0.3)
GEL = StandardSolid(relaxed_shear=1e3, shear=4e3, relaxation_time=2e-3)


def layered(solid=GEL, on=BASE, thickness=H):
    return wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(solid, thickness)], on=on)


def struck(medium, profile=BALL, **more):
    given = {"mass": 1e-3, "velocity": 0.05, "count": 100} | more
    return wk.ViscoelasticImpact(wk.Foundation(profile, medium), **given).solve()


def elastic_duration(medium, profile, deepest, mass=1e-3, velocity=0.05):
    """Return how long a body touches an elastic one, from forces at depths [m]: twice the time to the deepest point."""
    depths = deepest * np.linspace(0.0, 1.0, 100) ** 2
    forces = wk.Indentation(wk.Foundation(profile, medium), wk.Depth(depths)).solve().force
    energy = CubicSpline(depths, forces).antiderivative()
    end = brentq(lambda depth: 0.5 * mass * velocity**2 - energy(depth), 0.0, deepest, xtol=1e-16)
    nodes, weights = np.polynomial.legendre.leggauss(60)
    u = 0.5 * (nodes + 1.0)  # depth = end (1 - u^2), which takes the root at the end away
    speed = np.sqrt(np.maximum(velocity**2 - 2.0 * energy(end * (1.0 - u * u)) / mass, 0.0))
    return 2.0 * float(weights @ (end * u / speed))


def test_equal_layers_are_their_half_space():
    """Springs that are independent of one another, in a compiled kernel, solve the other one."""
    one, other = struck(layered(on=GEL), count=200), struck(wk.ViscoelasticHalfSpace(GEL), count=400)
    assert one.restitution == pytest.approx(other.restitution, abs=1e-5)
    assert one.duration == pytest.approx(other.duration, rel=1e-4)
    assert one.depth.max() == pytest.approx(other.depth.max(), rel=1e-4)


@pytest.mark.few(2, slow=4)
@pytest.mark.parametrize(("time", "shear"), [(1e6, 5e3), (1e-9, 1e3)])
@pytest.mark.parametrize(("base", "radius"), [(3e3, 1e-2), (3e5, 1e-2), (3e2, 1.0)])
def test_slow_and_fast_layers_are_elastic(time, shear, base, radius):
    """A layer that has no time to relax, and one that has all: the elastic impact of flat punches on the same stack."""
    on, ball = wk.Elastic(base, 0.3), wk.Paraboloid(radius)
    solid = dataclasses.replace(GEL, relaxation_time=time)
    found = struck(layered(solid, on), ball)
    assert radius < 1.0 or found.radius.max() > 8.0 * H
    elastic = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(2.0 * (1.0 + GEL.poisson) * shear, GEL.poisson), H)], on=on)
    assert found.restitution == pytest.approx(1.0, abs=1e-4)
    assert found.duration == pytest.approx(elastic_duration(elastic, ball, 1.1 * found.depth.max()), rel=2e-4)


def springs_and_dashpots(stiffness, rates):
    """Return K and amplitudes of a sum of relaxing springs with given rates that has a stiffness at real s."""
    s = np.geomspace(1e-3 * rates[0], 1e3 * rates[-1], 60)
    wanted = stiffness(s)
    columns = np.column_stack([np.ones(s.size), *(s / (s + rate) for rate in rates)])
    found, residual = nnls(columns / wanted[:, None], np.ones(s.size))
    assert residual < 1e-5 * np.sqrt(s.size)
    return found


@pytest.mark.few(2, slow=3)
@pytest.mark.parametrize(("wide", "contrast"), [(0.3, 0.1), (3.0, 10.0), (0.3, 10.0), (3.0, 0.1), (10.0, 0.1)])
def test_a_punch_strikes_springs_and_dashpots(wide, contrast):
    """By the correspondence at real s, of elastic stacks solved by flat punches: an oscillator with dashpots.

    A punch ten times as wide as a stiff layer is thick is pulled in its middle, on elastic layers, too.
    """
    base, radius, velocity = wk.Elastic(3e3 / contrast, 0.3), wide * H, 1e-3

    def stiffness(s):
        def one(rate):
            shear = float(np.real(GEL.series.at_rate(np.array([rate]))[0]))
            layer = wk.Layer(wk.Elastic(2.0 * (1.0 + GEL.poisson) * shear, GEL.poisson), H)
            return float(wk.CoatedHalfSpace([layer], on=base).punch_stiffness(np.array(radius)))

        return np.array([one(rate) for rate in s.tolist()])

    rates = np.geomspace(0.2, 1.0, 24) / GEL.relaxation_time  # from retardation to relaxation of the solid
    mass = float(stiffness(np.array([1e9]))[0]) * (0.1 * GEL.relaxation_time) ** 2
    elastic, *parts = springs_and_dashpots(stiffness, rates)
    parts = np.array(parts)

    def moving(_, y):
        depth, speed, crept = y[0], y[1], y[2:]
        return [speed, -(elastic * depth + parts @ (depth - crept)) / mass, *(rates * (depth - crept))]

    found = struck(layered(on=base), wk.FlatPunch(radius), mass=mass, velocity=velocity, count=200)
    whole = found.radius > 0.999 * radius  # before the edge lets go
    assert found.velocity[whole][-1] < -0.5 * velocity
    start, times = np.array([0.0, velocity, *np.zeros(parts.size)]), found.time[whole]
    path = solve_ivp(moving, (0.0, times[-1]), start, "LSODA", t_eval=times, rtol=1e-9, atol=1e-14)
    assert found.velocity[whole] == pytest.approx(path.y[1], abs=3e-4 * velocity)
    assert found.depth[whole] == pytest.approx(path.y[0], abs=3e-4 * path.y[0].max())
    lost = 0.5 * mass * (velocity**2 - path.y[1, -1] ** 2)
    assert lost > 0.003 * mass * velocity**2


def test_a_vanishing_layer_leaves_its_base():
    """What a layer adds to the duration falls like its thickness, towards the elastic impact on the base."""
    base = wk.Elastic(2e4, 0.3)
    wanted = elastic_duration(wk.HalfSpace(base), BALL, 1e-3)
    longer = [struck(layered(on=base, thickness=h)).duration / wanted - 1.0 for h in (4e-5, 2e-5, 1e-5)]
    assert abs(longer[0]) < 0.1
    assert np.array(longer[:-1]) / longer[1:] == pytest.approx(2.0, rel=0.1)


def test_the_base_is_felt():
    soft, stiff = (struck(layered(on=wk.Elastic(base, 0.3))) for base in (1e4, 1e6))
    assert stiff.duration < 0.9 * soft.duration


def test_cells_and_energy():
    """Errors fall with the cells, by what is left of each; what the body loses is stored or lost in the layers."""
    coarse, fine, one = (struck(layered(), count=count, tolerance=1e-6) for count in (20, 80, 320))
    wrong = [abs(each.restitution - one.restitution) for each in (coarse, fine)]
    assert wrong[1] < 0.25 * wrong[0] < 1e-3
    assert one.kinetic_energy[0] - one.kinetic_energy[-1] == pytest.approx(one.dissipation, rel=1e-5)


def test_a_film_that_liquid_leaves():
    """No time for the liquid: an incompressible film; a film that drains at once is the network; between, a loss."""
    found = {}
    for diffusivity in (1e-16, 1e-6, 1.0):
        gel = wk.PoroelasticFilm(shear=5e3, poisson=0.3, diffusivity=diffusivity, thickness=H)
        found[diffusivity] = struck(gel, wk.Paraboloid(1e-3), mass=1e-5)
    film = {0.5: found[1e-16], 0.3: found[1.0]}
    for poisson, one in film.items():
        layer = wk.Layer(wk.Elastic(2.0 * (1.0 + poisson) * 5e3, poisson), H)
        elastic, ball = wk.CoatedHalfSpace([layer], on=wk.Rigid()), wk.Paraboloid(1e-3)
        wanted = elastic_duration(elastic, ball, 1.1 * one.depth.max(), mass=1e-5)
        assert one.restitution == pytest.approx(1.0, abs=2e-3)
        assert one.duration == pytest.approx(wanted, rel=2e-3)
    assert found[1e-6].restitution < 0.97


def test_layers_know_their_notes_and_limits():
    solved = struck(layered(), mass=1e-4, velocity=0.01, count=50)
    assert any("Half as many cells" in str(note) for note in solved.validity)
    gel = wk.PoroelasticFilm(shear=5e3, poisson=0.3, diffusivity=1e-9, thickness=H)
    with pytest.raises(wk.OutsideValidity, match=r"grows beyond 0\.01 m"):
        struck(gel, wk.Sphere(1e-2), mass=0.03, velocity=1.0, count=20)
    with pytest.raises(wk.InvalidInput, match="2000 cells"):
        struck(layered(), count=3000)
