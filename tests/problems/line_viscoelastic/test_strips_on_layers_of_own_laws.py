"""Line contacts on layers that relax each by a law of its own, and on films that liquid leaves."""

from __future__ import annotations

import functools
import math

import numpy as np
import pytest
from scipy.linalg import expm, null_space

import winkler as wk

GEL = wk.StandardSolid(relaxed_shear=0.2, shear=0.8, relaxation_time=0.5, poisson=0.4)
NU, NU_BASE = 0.4, 0.3
ROUND = wk.Paraboloid(1.0)
HISTORY = [0.0, 1.0, 2.0, 2.5, 3.5], [0.0, 1.0, 1.0, 0.25, 1.3]


def rubber(factor):
    return wk.StandardSolid(0.2 * factor, 0.8 * factor, 0.5, poisson=NU)


def solved(medium, path, **options):
    return wk.LineViscoelasticIndentation(wk.LayeredLineFoundation(ROUND, medium), path, **options).solve()


@pytest.mark.parametrize("factor", [0.1, pytest.param(10.0, marks=pytest.mark.slow)])
def test_layers_that_happen_to_relax_alike_are_those_in_proportion(factor):
    """Hats of pressure against the flat strips of the elastic layers, each with its share."""
    alike = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(2.8 * factor, NU), 0.03)], on=wk.Elastic(2.8, NU))
    shares = wk.RelaxingInProportion(alike, GEL, shear=1.0)
    own = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(rubber(factor), 0.03)], on=rubber(1.0))
    path = wk.LineForcePath(HISTORY[0], 1e-3 * factor**0.5 * np.array(HISTORY[1]), count=4)
    one = solved(shares, path, count=200)
    errors = []
    for count in (60, 240):
        other = solved(own, path, count=count)
        assert other.half_width[1:] == pytest.approx(one.half_width[1:], rel=200.0 / count**2 + 1e-3)
        middle = np.array([[float(s.pressure(0.0)) for s in found.states[1:]] for found in (one, other)])
        errors.append(np.max(np.abs(middle[1] / middle[0] - 1.0)))
    assert errors[1] < 0.3 * errors[0]
    assert errors[1] < 3e-4


@pytest.mark.parametrize("base", [wk.Elastic(30.0, NU_BASE), wk.Elastic(0.3, NU_BASE), wk.Rigid()])
@pytest.mark.parametrize("force", [1e-6, 1e-4, 1e-2])
def test_at_first_and_after_all_time_the_strip_is_that_of_elastic_layers(base, force):
    """a/h from .1 to 18, by the strip equation of elastic layers."""
    medium = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(GEL, 0.01)], on=base)
    found = solved(medium, wk.LineForcePath([0.0, 1e6], force), count=400)
    for i, stack in enumerate((medium.glassy, medium.relaxed)):
        elastic = wk.LineIndentation(wk.LayeredLineFoundation(ROUND, stack), wk.LineForce(force)).solve()
        assert found.half_width[i] == pytest.approx(elastic.half_width, rel=5e-5)
        assert found.peak_pressure[i] == pytest.approx(elastic.peak_pressure, rel=5e-5)
        x = elastic.half_width * np.linspace(0.0, 0.9, 7)
        inside = wk.LineIndentation(wk.LayeredLineFoundation(ROUND, stack), wk.LineForce(force)).solve().pressure(x)
        assert found.states[i].pressure(x) == pytest.approx(inside, rel=2e-3)


@pytest.mark.parametrize("force", [1e-5, 1e-3])
def test_a_drained_film_begins_incompressible_and_ends_as_its_network(force):
    film = wk.PoroelasticFilm(shear=0.5, poisson=0.2, diffusivity=1e-4, thickness=0.02)
    found = solved(film, wk.LineForcePath([0.0, 1e3 * film.diffusion_time], force), count=200)
    for i, stack in enumerate((film.glassy, film.relaxed)):
        elastic = wk.LineIndentation(wk.LayeredLineFoundation(ROUND, stack), wk.LineForce(force)).solve()
        assert found.half_width[i] == pytest.approx(elastic.half_width, rel=5e-5)


THICKNESS = 0.03
STEHFEST = 12
DEGREE = 36
"""Of polynomials of the modulus, whose errors the weights of Stehfest make 1e5 times greater."""


@functools.cache
def stehfest():
    """Weights of Gaver and Stehfest."""
    half, found = STEHFEST // 2, []
    for k in range(1, STEHFEST + 1):
        terms = (
            j**half * math.factorial(2 * j)
            / (math.factorial(half - j) * math.factorial(j) * math.factorial(j - 1) * math.factorial(k - j)
               * math.factorial(2 * j - k))
            for j in range((k + 1) // 2, min(k, half) + 1)
        )  # fmt: skip
        found.append((-1) ** (k + half) * sum(terms))
    return np.array(found)


def rates(shear, poisson):
    """d/dx of (U, W, tau, sigma), x = k z, tractions over k."""
    lame = 2.0 * shear * poisson / (1.0 - 2.0 * poisson)
    a = np.array([[0.0, 1.0, 1.0 / shear, 0.0], [-lame, 0.0, 0.0, 1.0], [0.0] * 4, [0.0, 0.0, -1.0, 0.0]])
    a[1] /= lame + 2.0 * shear
    a[2] = lame * a[1] + np.array([lame + 2.0 * shear, 0.0, 0.0, 0.0])
    return a


class FilmOnElasticBase:
    """Elements of even pressure on a film that relaxes by itself: each step adds what its kernel makes of it."""

    def __init__(self, base, end, count, dt, steps):
        shears = 0.6 - 0.4 * np.cos(np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))
        node, weight = np.polynomial.legendre.leggauss(6)
        edges = np.append(0.0, np.geomspace(1e-4, 25.0, 60)) / THICKNESS
        k = (edges[:-1, None] + 0.5 * np.diff(edges)[:, None] * (node + 1.0)).ravel()
        weights = (0.5 * np.diff(edges)[:, None] * weight).ravel()
        deep = rates(base, NU_BASE) + np.eye(4)
        below = null_space(deep @ deep, rcond=1e-7)
        known = np.empty((shears.size, k.size))
        for row, shear in zip(known, shears, strict=True):
            across = expm(-(k * THICKNESS)[:, None, None] * rates(shear, NU)) @ below
            row[:] = -0.5 * (across[:, :2] @ np.linalg.inv(across[:, 2:]))[:, 1, 1] - 0.5 * (1.0 - NU) / shear
        basis = np.polynomial.chebyshev.chebvander((shears - 0.6) / 0.4, DEGREE)
        series = np.linalg.solve(basis, known)
        self.edges = np.linspace(0.0, end, count + 1)
        self.x, self.width = 0.5 * (self.edges[1:] + self.edges[:-1]), end / count
        far = self.edges[None, :] - self.x[:, None]
        near = far * np.log(np.abs(far)) - far
        mirrored = self.edges[None, :] + self.x[:, None]
        logs = np.diff(near, axis=1) + np.diff(mirrored * np.log(mirrored) - mirrored, axis=1)
        waves = np.cos(np.outer(self.x, k))
        whole = np.sin(np.outer(self.edges, k)) / k
        under, afar = np.diff(whole, axis=0), self.width * np.cos(k * end)
        self.kernels = []
        for time in (np.arange(steps) + 0.5) * dt:
            s = np.arange(1, STEHFEST + 1) * math.log(2.0) / time
            moduli = 0.2 + 0.8 * s / (s + 2.0)
            share = stehfest() / np.arange(1, STEHFEST + 1)  # of the transform over s, times ln 2 / time
            varying = share @ np.polynomial.chebyshev.chebvander((moduli - 0.6) / 0.4, DEGREE) @ series
            local = float(share @ (0.5 * (1.0 - NU) / moduli))
            each = 2.0 * varying / k * weights
            added = (waves * each) @ under.T - each @ afar
            self.kernels.append((-2.0 * local * logs + 2.0 * added) / np.pi)
        self.past = []

    def step(self, force):
        """Go on to a force per length: return the pressures, which change in the middle of the step."""
        own = self.kernels[0]
        before = self.past[-1] if self.past else np.zeros(self.x.size)
        changes = np.diff(np.array([np.zeros(self.x.size), *self.past]), axis=0)
        sunk = -own @ before
        for i, change in enumerate(changes):
            sunk = sunk + self.kernels[len(changes) - i] @ change
        touching = before > 0.0 if before.any() else self.x < 0.2 * self.edges[-1]
        for _ in range(200):
            (inside,) = np.nonzero(touching)
            system = np.zeros((inside.size + 1, inside.size + 1))
            system[:-1, :-1], system[:-1, -1] = own[np.ix_(inside, inside)], -1.0
            system[-1, :-1] = 2.0 * self.width
            found = np.linalg.solve(system, np.append((-0.5 * self.x**2 - sunk)[inside], force))
            pressure = np.zeros(self.x.size)
            pressure[inside] = found[:-1]
            gap = own @ pressure + sunk + 0.5 * self.x**2 - found[-1]
            changed = (touching & (pressure >= 0.0)) | (~touching & (gap < -1e-13))
            if np.array_equal(changed, touching):
                break
            touching = changed
        else:
            raise AssertionError("the contact does not settle")
        self.past.append(pressure)
        return pressure


@pytest.mark.slow
@pytest.mark.parametrize("base", [0.1, 10.0])
def test_a_film_on_a_body_that_does_not_relax_agrees_with_elements_and_another_inverse(base):
    """Waves by matrix exponentials, their creep after Gaver and Stehfest, time by sums: a/h about 1 and 3.

    The film has the shear modulus 1, later .2; the base does not relax: a strip in proportion would keep its shape.
    """
    on = wk.Elastic(2.0 * (1.0 + NU_BASE) * base, NU_BASE)
    medium = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(GEL, THICKNESS)], on=on)
    level, dt = (4e-3 if base > 1.0 else 1e-3), 0.025
    times, forces = np.array(HISTORY[0]), level * np.array(HISTORY[1])
    found = solved(medium, wk.LineForcePath(times, forces, count=10), count=200)
    body = FilmOnElasticBase(base, 1.05 * found.half_width.max(), 90, dt, 141)
    errors, middles = [], []
    for moment in np.arange(1, 141) * dt:
        pressure = body.step(float(np.interp(moment, times, forces)))
        at = np.flatnonzero(np.abs(found.time - moment) < 1e-9)
        if at.size:
            state = found.states[int(at[0])]
            inside = body.x < 0.9 * state.half_width
            errors.append(np.max(np.abs(pressure - state.pressure(body.x))[inside]) / pressure.max())
            middles.append(pressure[0] / float(state.pressure(body.x[0])) - 1.0)
            assert abs(np.count_nonzero(pressure) * body.width - state.half_width) < 1.5 * body.width
    assert len(errors) > 10
    # where an edge runs over elements faster than one a step, the sums keep kinks that finer steps do not have
    assert max(errors[2:]) < 4e-3
    assert np.max(np.abs(middles[9:])) < 6e-4  # from 1 s on: the sums begin with a jump


def test_what_layers_of_own_laws_do_not_know_is_said():
    medium = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(GEL, 0.02)], on=wk.Elastic(3.0, NU_BASE))
    found = solved(medium, wk.LineForcePath([0.0, 1.0, 2.0], [0.0, 1e-3, 0.2e-3]), count=40)
    notes = [note.statement for note in found.validity]
    assert any(note.startswith("Perfectly bonded, isotropic, linear viscoelastic layers") for note in notes)
    assert any("Half as many cells" in note for note in notes)
    with pytest.raises(wk.OutsideValidity, match="its own relaxation function"):
        found.approach(1.0)
    with pytest.raises(wk.OutsideValidity, match="press the bodies together"):
        solved(medium, wk.LineForcePath([0.0, 1.0], 0.0))
    short = wk.LineForcePath([0.0, 1.0], [0.0, 1e-3])
    with pytest.raises(wk.InvalidInput, match="at most 2000 cells"):
        solved(medium, short, count=5000)


def test_the_mean_of_a_logarithm_under_two_hats_is_that_of_quadrature():
    from winkler.numerics.transforms.wave_creep import _logarithms

    node, weight = np.polynomial.legendre.leggauss(40)
    for distance in (3, 15, 16, 40):
        # the convolution of two hats, a cubic between whole numbers
        total = 0.0
        for low in range(-2, 2):
            y = low + 0.5 * (node + 1.0)
            far = np.abs(y)
            spline = np.where(far < 1.0, 2.0 / 3.0 - far**2 + 0.5 * far**3, (2.0 - far) ** 3 / 6.0)
            total += 0.5 * float(weight @ (spline * np.log(distance + y)))
        assert _logarithms(np.arange(distance + 1))[-1] == pytest.approx(total, rel=1e-11)
