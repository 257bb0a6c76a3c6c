"""Tractions on layers: waves by a transfer matrix of its own, and point forces by Hankel quadrature."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.linalg import expm
from scipy.special import jv

import winkler as wk
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.problems.rough.compliance import compliance_of

TOP, BASE, OTHER = (5.0, 0.3), (1.0, 0.4), (3.0, 0.2)
THICKNESS = 0.1
COATED = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(*TOP), THICKNESS)], on=wk.Elastic(*BASE), second=wk.Elastic(*OTHER))


def shear_of(solid):
    return solid[0] / (2.0 * (1.0 + solid[1]))


def along(q):
    """Displacement along a wave under a unit traction along it, times q, of both bodies; du/dz = A u in the layer."""

    def rate(young, nu):
        shear = young / (2.0 * (1.0 + nu))
        n, m = nu / (1.0 - nu), (1.0 - 2.0 * nu) / (2.0 * shear * (1.0 - nu))
        return np.array([[0, q, 1 / shear, 0], [-n * q, 0, 0, m], [2 * shear * q**2 / (1 - nu), 0, 0, n * q],
                         [0, 0, -q, 0]])  # fmt: skip

    down = expm(rate(*TOP) * THICKNESS)
    end = (rate(*BASE) + q * np.eye(4)) @ (rate(*BASE) + q * np.eye(4))  # what decays is annihilated
    rows = (end @ down)[[0, 1]]
    moved = np.linalg.solve(rows[:, :2], -rows[:, 2])[0]
    return q * abs(moved) + (1.0 - OTHER[1]) / shear_of(OTHER)


def across(q):
    """The same across the wave: two shear waves that grow and decay in the layer."""
    top, base, fall = shear_of(TOP), shear_of(BASE), np.tanh(q * THICKNESS)
    return (top + base * fall) / (base + top * fall) / top + 1.0 / shear_of(OTHER)


@pytest.mark.parametrize("count", [1, 3, 7])
def test_waves_along_and_across_are_those_of_the_transfer_matrix(count):
    n, side = 48, 0.7
    pixel = (side / n, side / n)
    grid = TractionGrid.of((n, n), pixel, compliance_of(COATED), periodic=True)
    q = 2.0 * np.pi * count / side
    wave = np.cos(q * np.arange(n) * pixel[0])[:, None] * np.ones(n)
    none = np.zeros((n, n))
    scale = COATED.modulus / q  # the tractions are over E*
    lengthwise, crosswise = grid.sheared(np.stack((wave, none))), grid.sheared(np.stack((none, wave)))
    assert lengthwise[0] == pytest.approx(scale * along(q) * wave, abs=1e-10)
    assert crosswise[1] == pytest.approx(scale * across(q) * wave, abs=1e-10)
    assert abs(lengthwise[1]).max() < 1e-12
    oblique = grid.sheared(np.stack((wave.T, none)))
    assert oblique[0] == pytest.approx(scale * across(q) * wave.T, abs=1e-10)


@pytest.mark.parametrize("place", [(0, 0), (3, 1), (14, 20), (60, 7)])
def test_small_pixels_are_point_forces(place):
    """Mean and half difference beyond short waves, by quadrature against J_0 and J_2 at the distance of the pixel."""
    pixel = 0.1 * THICKNESS
    compliance = compliance_of(COATED)
    xx, xy, yy = compliance.layers.pixels((64, 32), (pixel, pixel))
    r, angle = pixel * np.hypot(*place), np.arctan2(place[1], place[0])
    scale = 0.25 * COATED.modulus

    def integral(order, sign):
        ends = sum((1.0 - nu + sign) / shear_of((young, nu)) for young, nu in (TOP, OTHER))  # of short waves

        def part(q):
            return scale * (along(q) + sign * across(q) - ends) * jv(order, q * r)

        return quad(part, 1e-9, 25.0 / THICKNESS, limit=400, epsabs=1e-11)[0] / np.pi

    even, turning = integral(0, 1.0), -integral(2, -1.0)
    area = pixel**2
    big = abs(xx[0, 0])
    assert xx[place] == pytest.approx(area * (even + turning * np.cos(2 * angle)), abs=1e-3 * big)
    assert xy[place] == pytest.approx(area * turning * np.sin(2 * angle), abs=1e-3 * big)
    assert yy[place] == pytest.approx(area * (even - turning * np.cos(2 * angle)), abs=1e-3 * big)


@pytest.mark.parametrize("periodic", [False, True])
def test_layers_of_the_same_solid_change_nothing(periodic):
    body, other = wk.Elastic(1.0, 0.3), wk.Elastic(2.0, 0.1)
    same = wk.CoatedHalfSpace([wk.Layer(body, 0.02), wk.Layer(body, 0.1)], on=body, second=other)
    traction = np.random.default_rng(2).standard_normal((2, 20, 12))
    plain = compliance_of(wk.HalfSpace(body, other))._replace(coupling=0.0)
    grids = (TractionGrid.of((20, 12), (0.05, 0.03), one, periodic=periodic) for one in (plain, compliance_of(same)))
    expected, found = (grid.sheared(traction) for grid in grids)
    assert found == pytest.approx(expected, abs=1e-12 * abs(expected).max())


def test_a_film_on_a_rigid_base_gives_way_under_an_even_traction():
    film = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1.0, 0.4), 0.05)], on=wk.Rigid())
    grid = TractionGrid.of((8, 8), (0.1, 0.1), compliance_of(film), periodic=True)
    even = np.stack((np.ones((8, 8)), np.zeros((8, 8))))
    assert grid.sheared(even)[0] == pytest.approx(film.modulus * 0.05 / shear_of((1.0, 0.4)), rel=1e-12)


def test_waves_on_a_graded_body_are_those_of_many_layers():
    """Exponential grading against 200 layers, along and across the wave; second order in their thickness."""
    grading = wk.ExponentialGrading(1.0, 5.0, depth_scale=0.1, poisson=0.3)
    edges = np.linspace(0.0, 1.0, 201) ** 1.5
    middles = 0.5 * (edges[1:] + edges[:-1])
    layers = [
        wk.Layer(wk.Elastic(float(young), 0.3), float(step))
        for young, step in zip(grading.young_at(middles), np.diff(edges), strict=True)
    ]
    stack = wk.CoatedHalfSpace(layers, on=wk.Elastic(float(grading.young_at(np.array(1.0))), 0.3))
    waves, found = np.array([1.0, 5.0, 20.0, 80.0]), []
    for medium in (wk.DepthGradedHalfSpace(grading), stack):
        compliance = compliance_of(medium)
        even, turning = compliance.layers.waves(waves)
        lengthwise = (compliance.even + even - turning) / medium.modulus
        crosswise = (compliance.even + compliance.along + even + turning) / medium.modulus
        found.append(np.stack((lengthwise, crosswise)))
    assert found[0] == pytest.approx(found[1], rel=1e-3)
