"""Torsion on stacks of transversely isotropic layers, on layers that slide, and on bodies graded in depth."""

from __future__ import annotations

import functools

import numpy as np
import pytest
from layer_waves import Stack, sliding_disc, twist_stiffness
from scipy.optimize import brentq
from scipy.special import digamma

import winkler as wk
from winkler.foundation.bed import PressedSprings
from winkler.materials.depth_grading import ExponentialGrading

MU, BALL = 0.3, wk.Paraboloid(1.0)
WEAVE = wk.TransverselyIsotropic(10.0, 4.0, 3.0, 6.0, 2.0)
GLASS, SOFT = wk.Elastic(2.5, 0.25), wk.Elastic(0.5, 0.4)


def twisted(medium, radius, parts=(0.0, 0.8, -0.6, 0.3)):
    """Twist a ball by parts of mu F a over the stiffness of a stuck contact."""
    bed = wk.Foundation(BALL, medium)
    pressed = wk.Indentation(bed, wk.Radius(radius)).solve()
    unit = MU * float(pressed.force) * radius / float(medium.punch_torsional_stiffness(np.array(radius)))
    load = wk.Depth(np.full(len(parts), float(pressed.depth)))
    path = wk.Path(np.arange(float(len(parts))), load, wk.Angle(unit * np.array(parts)))
    return wk.Torsion(bed, wk.Coulomb(MU), path)


def same(found, wanted, rel):
    for name in ("torque", "torque_limit", "stick_radius", "dissipation", "stored_energy"):
        assert getattr(found, name) == pytest.approx(getattr(wanted, name), rel=rel, abs=1e-300), name


def test_a_transversely_isotropic_layer_of_the_same_solid_is_the_half_space_of_sqrt_c44_c66():
    stack = wk.StackedHalfSpace([wk.StackLayer(WEAVE, 0.02, True)], on=WEAVE)
    shear = np.sqrt(WEAVE.c44 * 0.5 * (WEAVE.c11 - WEAVE.c12))
    poisson = 1.0 - 2.0 * shear / stack.modulus
    alike = wk.HalfSpace.between(wk.Elastic(2.0 * shear * (1.0 + poisson), poisson))
    same(twisted(stack, 0.05).solve(), twisted(alike, 0.05).solve(), 1e-11)


@pytest.mark.slow
def test_isotropic_layers_twist_as_those_of_a_coated_half_space():
    layers = [wk.Layer(GLASS, 0.02), wk.Layer(SOFT, 0.03)]
    coated, stack = wk.CoatedHalfSpace(layers, on=GLASS), wk.StackedHalfSpace(layers, on=GLASS)
    same(twisted(stack, 0.05).solve(), twisted(coated, 0.05).solve(), 1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("a", [0.1, 5.0])
def test_a_layer_that_slides_is_a_sheet_held_far_away(a):
    """The kernel of a free plate is a digamma function, but for a constant; wide discs turn the sheet at their rim."""
    film = wk.SlidingFilm([wk.Layer(GLASS, 1.0)], on=SOFT)  # G = 1, h = 1
    nodes, weights = np.polynomial.legendre.leggauss(120)
    x, weights = 0.5 * a * (nodes + 1.0), 0.5 * a * weights

    def kernel(x):
        return -2.0 / np.pi * np.real(digamma(1.0 + 0.5j * x))

    matrix = 0.5 * (kernel(x[:, None] - x) - kernel(x[:, None] + x))
    theta = np.linalg.solve(np.eye(x.size) + matrix * weights, x)
    assert float(film.punch_torsional_stiffness(np.array(a))) == pytest.approx(16.0 * (weights * x) @ theta, rel=1e-12)
    halves = [wk.StackLayer(GLASS, 0.5, True), wk.StackLayer(GLASS, 0.5, False), wk.StackLayer(SOFT, 3.0, True)]
    stack = wk.StackedHalfSpace(halves, on=GLASS)
    assert stack.punch_torsional_stiffness(np.array(a)) == pytest.approx(16.0 * (weights * x) @ theta, rel=1e-12)
    wide = float(film.punch_torsional_stiffness(np.array(1000.0)))
    assert wide == pytest.approx(4.0 * np.pi * 1000.0**2, rel=2e-3)


@pytest.mark.parametrize("stiffer", [1e-3, 1e3])
def test_a_sheet_of_two_layers_by_least_energy(stiffer):
    lower = wk.StackLayer(wk.Elastic(2.5 * stiffer, 0.25), 0.03, False)
    film = wk.StackedHalfSpace([wk.StackLayer(GLASS, 0.02, True), lower], on=SOFT)
    nearly_free = Stack([(1.0, 0.25, 0.02), (stiffer, 0.25, 0.03)], (1e-12, 0.25), longest_disc=0.04)
    found = float(film.punch_torsional_stiffness(np.array(0.04)))
    assert found == pytest.approx(twist_stiffness(nearly_free, 0.04), rel=1e-9)


@pytest.mark.slow
def test_partial_slip_on_a_sheet_by_least_energy_inside_the_stick_zone():
    film = wk.SlidingFilm([wk.Layer(GLASS, 0.02)], on=SOFT)
    problem = twisted(film, 0.04, (0.0, 0.8))
    solution = problem.solve()
    found, a = solution.at(1), float(solution.radius[1])
    place = 0.5 + 0.5 * np.polynomial.chebyshev.chebpts1(60)
    values = film.pressure(PressedSprings(problem.bed, found.depth, a), a * np.sqrt(place))
    fit = np.polynomial.Chebyshev.fit(place, values / np.sqrt(1.0 - place), 59, domain=[0.0, 1.0])

    def pressure(r):
        inner = np.minimum((r / a) ** 2, 1.0)
        return np.sqrt(1.0 - inner) * fit(inner)

    nearly_free = Stack([(1.0, 0.25, 0.02)], (1e-7, 0.25), longest_disc=a)
    motion, load = sliding_disc(nearly_free, pressure, a, found.stick_radius, 1)
    assert 0.2 < found.stick_radius / a < 0.95
    assert (found.angle, found.torque) == pytest.approx((MU * motion, MU * load), rel=5e-6)
    assert any("Layer 1 slides without friction" in note.statement for note in solution.validity)


@functools.cache
def on_graded():
    medium = wk.DepthGradedHalfSpace(ExponentialGrading(1.0, 3.0, depth_scale=0.05, poisson=0.3), tolerance=1e-5)
    return twisted(medium, 0.05, (0.0, 0.8)).solve()


@pytest.mark.long
def test_a_body_graded_in_depth_twists_as_ever_thinner_layers():
    """Layers converge in proportion to the square of their thickness; what is left is the logarithm of the kernel."""
    found = on_graded()
    known = []
    for count in (20, 40):
        depth = np.concatenate([[0.0], np.geomspace(5e-4, 0.7, count)])
        young = 3.0 - 2.0 * np.exp(-0.5 * (depth[1:] + depth[:-1]) / 0.05)
        layers = [wk.Layer(wk.Elastic(e, 0.3), h) for e, h in zip(young, np.diff(depth), strict=True)]
        medium = wk.CoatedHalfSpace(layers, on=wk.Elastic(3.0, 0.3))
        bed = wk.Foundation(BALL, medium)
        depth = float(wk.Indentation(bed, wk.Radius(0.05)).solve().depth)
        path = wk.Path([0.0, 1.0], wk.Depth(depth), wk.Angle(found.angle))
        known.append(float(wk.Torsion(bed, wk.Coulomb(MU), path).solve().torque[1]))
    assert abs(found.torque[1] / known[1] - 1.0) < 0.3 * abs(found.torque[1] / known[0] - 1.0)
    assert found.torque[1] == pytest.approx((4.0 * known[1] - known[0]) / 3.0, rel=3e-4)


class GradedWaves(Stack):
    """Shear across waves in 4000 thin layers of a body that stiffens from a modulus of 1 by exp(-20 z)."""

    def __init__(self, deep, poisson, disc):
        nodes, weights = np.polynomial.legendre.leggauss(16)
        step, most = 6.0 / disc, 2e4
        edges = np.concatenate([[0.0], step * 2.0 ** -np.arange(14.0, 0.0, -1.0), np.arange(step, most + step, step)])
        self.xi = (edges[:-1, None] + np.diff(edges)[:, None] * 0.5 * (nodes + 1.0)).ravel()
        self.weights = (0.5 * np.diff(edges)[:, None] * weights).ravel()
        depth = np.concatenate([[0.0], np.geomspace(1e-7, 3.0, 4000)])
        shear = (deep + (1.0 - deep) * np.exp(-10.0 * (depth[1:] + depth[:-1]))) / (2.0 + 2.0 * poisson)
        stiff = np.full(self.xi.size, shear[-1])
        for own, thickness in zip(shear[::-1], np.diff(depth)[::-1], strict=True):
            fall = np.tanh(self.xi * thickness)
            stiff = own * (stiff + own * fall) / (own + stiff * fall)
        self.across, self.short = 1.0 / stiff, (0.0, 2.0 + 2.0 * poisson)


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize(("deep", "off"), [(3.0, 2e-5), (30.0, 2e-4)])
def test_the_torque_on_a_graded_body_is_known_as_far_as_the_manual_says(deep, off):
    """At the same angle, by least energy inside the stick zone and thin layers of waves."""
    a, grading = 0.05, ExponentialGrading(1.0, deep, depth_scale=0.05, poisson=0.3)
    problem = twisted(wk.DepthGradedHalfSpace(grading), a, (0.0, 0.8))
    found = problem.solve().at(1)
    place = 0.5 + 0.5 * np.polynomial.chebyshev.chebpts1(60)
    springs = PressedSprings(problem.bed, found.depth, a)
    values = problem.bed.medium.pressure(springs, a * np.sqrt(place))
    fit = np.polynomial.Chebyshev.fit(place, values / np.sqrt(1.0 - place), 59, domain=[0.0, 1.0])

    def pressure(r):
        inner = np.minimum((r / a) ** 2, 1.0)
        return MU * np.sqrt(1.0 - inner) * fit(inner)

    waves = GradedWaves(deep, 0.3, a)
    assert float(problem.bed.medium.punch_torsional_stiffness(np.array(a))) == pytest.approx(
        twist_stiffness(waves, a), rel=1e-5
    )
    stick = brentq(lambda c: sliding_disc(waves, pressure, a, c, 1)[0] - found.angle, 0.03, 0.036, xtol=1e-9)
    assert found.torque == pytest.approx(sliding_disc(waves, pressure, a, stick, 1)[1], rel=off)
    assert found.stick_radius == pytest.approx(stick, rel=20.0 * off)


@pytest.mark.slow
def test_rings_on_a_graded_body_bear_their_own_pressure():
    found = on_graded()
    problem = found.problem
    state, a = found.at(1), float(found.radius[1])
    springs = PressedSprings(problem.bed, state.depth, a)
    r = np.linspace(state.stick_radius * 1.02, 0.99 * a, 9)
    assert state.traction(r) == pytest.approx(MU * problem.bed.medium.pressure(springs, r), rel=2e-4)
    inside = np.linspace(0.1, 0.97, 9) * state.stick_radius
    assert np.all(state.traction(inside) < MU * problem.bed.medium.pressure(springs, inside))
    nodes, weights = np.polynomial.legendre.leggauss(120)
    angle = 0.25 * np.pi * (nodes + 1.0)
    place = a * np.sin(angle)
    arms = 0.25 * np.pi * weights * a * np.cos(angle) * 2.0 * np.pi * place**2
    whole = MU * float(arms @ problem.bed.medium.pressure(springs, place))
    assert found.torque_limit[1] == pytest.approx(whole, rel=5e-5)
    assert any("differs from that of a flat punch by" in note.statement for note in found.validity)
