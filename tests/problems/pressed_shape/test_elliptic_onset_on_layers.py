"""Onset of yield below ellipses on layers: the ball, the half-space, and matrix exponentials."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq

import winkler as wk
from problems.layer_waves import base, crossed
from winkler.media.layered.map_interior import MapInLayers
from winkler.problems.normal.elliptic import pressed_ellipse

SOLID = wk.Elastic(1.0, 0.3, strength=1e-3)
SLENDER = wk.CurvedBodies(30.0, 10.0)


def disc(second):
    dlc, chromium = wk.Elastic(180e9, 0.22, strength=8e9), wk.Elastic(279e9, 0.21, strength=1.5e9)
    layers = [wk.Layer(dlc, 2e-6), wk.Layer(chromium, 0.5e-6)]
    return wk.CoatedHalfSpace(layers, on=wk.Elastic(210e9, 0.3, strength=2e9), second=second)


@pytest.mark.slow
def test_a_ball_on_a_coated_disc_yields_as_by_the_round_engine():
    """YieldOnset has 21.3746 N of the steel and 45.428 N of the chromium: springs and Hankel integrals, no pixels."""
    ball = wk.CurvedBodies(1.5e-3, 1.5e-3)
    found = wk.EllipticYieldOnset(ball, disc(wk.Elastic(310e9, 0.27))).solve()
    assert [one.name for one in found.onsets] == ["layer 1", "layer 2", "body under the layers"]
    assert found.onsets[2].force == pytest.approx(21.3746, rel=found.grid_error)
    assert found.onsets[1].force == pytest.approx(45.428, rel=found.grid_error)
    assert found.onsets[2].z == pytest.approx(27.49e-6, rel=0.01)
    assert found.force == found.onsets[2].force
    assert found.grid_error < 0.01


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize(("thickness", "mu", "angle"), [(0.02, 0.0, 0.0), (0.01, 0.2, 0.6), (0.05, 0.1, 1.5)])
def test_equal_layers_yield_as_the_half_space_at_rest_and_dragged(thickness, mu, angle):
    """The layers' share of the field is that of the base: the first part to yield is where the half-space does."""
    layers = wk.CoatedHalfSpace([wk.Layer(SOLID, thickness)], on=SOLID)
    law = wk.Coulomb(mu)
    true = wk.EllipticYieldOnset(SLENDER, wk.HalfSpace(SOLID), law, angle).solve()
    found = wk.EllipticYieldOnset(SLENDER, layers, law, angle).solve()
    assert found.force == pytest.approx(true.force, rel=max(3e-3, found.grid_error))
    assert found.z == pytest.approx(true.z, rel=0.03)


@pytest.mark.parametrize("contrast", [0.1, pytest.param(10.0, marks=pytest.mark.slow)])
def test_stresses_in_layers_are_those_of_matrix_exponentials(contrast):
    """At one place in the base and one in the lower half of the layer, by a sum over waves in all directions."""
    h, poisson = 0.05, 0.2
    layers = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(contrast, poisson), h)], on=wk.Elastic(1.0, 0.3))
    _, fine = pressed_ellipse(SLENDER, layers, wk.Force(1e-4 * contrast**0.5), 64)
    inside = MapInLayers(layers, np.multiply.outer([1.0, 0.0, 0.0], fine.pressure), fine.pixel)
    nodes, weights = np.polynomial.legendre.leggauss(24)
    b = float(fine.y[-1])
    edges = np.concatenate([[0.0], np.geomspace(0.02, 40.0, 14)]) / b
    k = (edges[:-1, None] + 0.5 * np.diff(edges)[:, None] * (nodes + 1.0)).ravel()
    dk = (0.5 * np.diff(edges)[:, None] * weights).ravel()
    turn = 0.25 * math.pi * (np.polynomial.legendre.leggauss(80)[0] + 1.0)
    dturn = 0.25 * math.pi * np.polynomial.legendre.leggauss(80)[1]
    c, s = np.cos(turn), np.sin(turn)
    kx, ky = np.outer(k, c), np.outer(k, s)
    half = fine.x.size // 2
    along, aside = (np.cos(np.multiply.outer(q, row[half:])) for q, row in ((kx, fine.x), (ky, fine.y)))
    borne = 4.0 * math.prod(fine.pixel) * np.einsum("kti,ij,ktj->kt", along, fine.pressure[half:, half:], aside)
    shear = 0.5 * contrast / (1.0 + poisson)
    scale = np.array([1.0, 1.0, shear, shear])[:, None]
    on = base((0.5 / 1.3, 0.3))
    at_top = scale * (crossed(poisson, np.minimum(k * h, 20.0)) @ (on / scale))
    amounts = np.linalg.solve(at_top[:, 2:], np.broadcast_to([[0.0], [-1.0]], (k.size, 2, 1)))
    i, j = half + 6, half + 9
    x, y = fine.x[i], fine.y[j]
    for z, solid, own in ((0.8 * h, (shear, poisson), True), (1.6 * h, (0.5 / 1.3, 0.3), False)):
        if own:
            state = scale * (crossed(poisson, np.minimum(k * (h - z), 20.0)) @ (on / scale)) @ amounts
        else:
            inner = np.array([1.0, 1.0, 0.5 / 1.3, 0.5 / 1.3])[:, None]
            state = inner * (crossed(0.3, -np.minimum(k * (z - h), 8.0)) @ (on / inner)) @ amounts
        u, _, t, down = state[:, :, 0].T
        main = (2.0 * solid[0] * u + solid[1] * down) / (1.0 - solid[1])
        other = main - 2.0 * solid[0] * u
        share = np.outer(k * dk, dturn) * borne / math.pi**2
        even = share * np.cos(kx * x) * np.cos(ky * y)
        expected = [
            np.sum(even * (main[:, None] * c**2 + other[:, None] * s**2)),
            np.sum(even * (main[:, None] * s**2 + other[:, None] * c**2)),
            np.sum(even * down[:, None]),
            np.sum(-share * np.sin(kx * x) * np.sin(ky * y) * (main - other)[:, None] * c * s),
            np.sum(share * np.sin(kx * x) * np.cos(ky * y) * t[:, None] * c),
            np.sum(share * np.cos(kx * x) * np.sin(ky * y) * t[:, None] * s),
        ]
        assert inside.at_depth(z, 6)[:, i, j] == pytest.approx(expected, abs=1e-3 * fine.peak_pressure)


def bodies_of_ratio(ratio):
    """R_y = 1, and R_x of an ellipse on half-spaces so many times as long as wide."""
    other = brentq(lambda x: np.divide(*wk.CurvedBodies(x, 1.0).semi_axes(1.0, 1.0)) - ratio, 1.0, 100.0)
    return wk.CurvedBodies(other, 1.0)


def pressure_at_yield_of_a_line(medium):
    foundation = wk.LineFoundation if isinstance(medium, wk.HalfSpace) else wk.LayeredLineFoundation
    bed = foundation(wk.Paraboloid(1.0), medium)
    half_width = wk.LineYieldOnset(bed).solve().half_width
    return float(wk.LineIndentation(bed, wk.HalfWidth(half_width)).solve().peak_pressure)


@pytest.mark.slow
def test_long_ellipses_on_layers_tend_to_the_line_as_on_the_base():
    r"""The middle of a long ellipse is a line under the same greatest pressure, but for what the far loads strain.

    They shear the surface by e = (1 - 2 nu) q/(pi G a), with q the load per length in the middle, nu and G of the base:
    the line load q (1 - x^2/a^2) moves it along by the integral of -(1 - 2 nu) q/(4 pi G (x - x')), whose slope is -e.
    A bonded layer takes e along and -e across.  So p_0 at yield of a base below a layer, over that of the line, is to
    first order in b/a the same as without the layer; what is left is of the order of (b/a)^2, with a logarithm.
    """
    solid = wk.HalfSpace(SOLID)
    layers = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(0.25, 0.25), 3e-3)], on=SOLID)
    line, plain_line = pressure_at_yield_of_a_line(layers), pressure_at_yield_of_a_line(solid)
    assert line / plain_line > 1.04  # the layer is felt by more than what is left
    left = []
    for ratio in (2.0, 4.0):
        found = wk.EllipticYieldOnset(bodies_of_ratio(ratio), layers).solve()
        slender = found.lateral_semi_axis / found.longitudinal_semi_axis
        plain = wk.EllipticYieldOnset(bodies_of_ratio(1.0 / slender), solid).solve()
        assert plain.peak_pressure / plain_line < 1.0 - 0.2 * slender * (1.0 - slender)
        left.append(abs(found.peak_pressure / line / (plain.peak_pressure / plain_line) - 1.0))
        assert left[-1] < 0.05 * slender**2 + found.grid_error / 3.0
    assert left[1] < 0.4 * left[0]  # (1.84/3.44)^2 is 0.29


def test_what_is_refused():
    with pytest.raises(wk.InvalidInput, match="strength"):
        wk.EllipticYieldOnset(
            SLENDER, wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1.0, 0.3), 0.1)], on=wk.Elastic(1.0, 0.2))
        )
    film = wk.SlidingFilm([wk.Layer(SOLID, 0.1)], on=SOLID)
    with pytest.raises(wk.OutsideValidity, match="slides"):
        wk.EllipticYieldOnset(SLENDER, film, wk.Coulomb(0.1))
    coat = wk.CoatedHalfSpace([wk.Layer(SOLID, 0.1)], on=SOLID)
    with pytest.raises(wk.OutsideValidity, match="LineYieldOnset"):
        wk.EllipticYieldOnset(wk.CurvedBodies(600.0, 10.0), coat).solve()
