"""A film that slides on its base: against elasticity in one wave, a Galerkin solution, and limits of thin and thick."""

from __future__ import annotations

import math

import numpy as np
import pytest
from sliding_solution import ball, compliance, excess, punch, young_of

import winkler as wk
from winkler.values.errors import InvalidInput, OutsideValidity

STIFF = wk.Elastic(200e9, 0.3)


def film(poisson=0.5, thickness=1.0, on=None):
    return wk.SlidingFilm([wk.Layer(young_of(1.0, poisson), thickness)], on=wk.Rigid() if on is None else on)


@pytest.mark.parametrize(
    "poisson, base", [(0.3, None), (0.49, None), (0.45, (2.0, 0.2)), (-0.2, (0.1, 0.4)), (0.2, (1e-3, 0.49))]
)
def test_its_compliance_is_that_of_elasticity(poisson, base):
    """Navier's equations in the layer, no shear on both faces; on a rigid base, a stiffer one, and softer ones."""
    on = wk.Rigid() if base is None else wk.Elastic(2.0 * base[0] * (1.0 + base[1]), base[1])
    medium = wk.SlidingFilm([wk.Layer(wk.Elastic(2.0 * (1.0 + poisson), poisson), 1.0)], on=on)
    wave = np.array([0.02, 0.3, 0.49, 0.51, 2.0, 5.0])
    found = 2.0 * medium.response.whole(wave) / (medium.modulus * wave)
    assert found == pytest.approx([compliance(one, poisson=poisson, base=base) for one in wave], rel=1e-11)


def test_bending_of_a_thin_stiff_film_does_not_cancel():
    """A plate floats on its base: 1 / C = k E*_b / 2 + k^4 E* h^3 / 12 for waves far longer than h."""
    medium = wk.SlidingFilm([wk.Layer(young_of(1e9, 0.3), 1e-3)], on=young_of(1.0, 0.2))
    wave = np.array([1e-2, 1.0, 4.0])
    wanted = 1.0 / (0.5 * wave + wave**4 * 1e9 * 1e-9 / 12.0)
    assert 2.0 * medium.response.whole(wave) / (1e9 * wave) == pytest.approx(wanted, rel=2e-5)


@pytest.mark.parametrize("ratio", [0.1, 1.0, 8.0])
def test_punch_and_ball_agree_with_a_galerkin_solution(ratio):
    medium = film(thickness=2e-6)
    a, radius = ratio * 2e-6, 1e-3
    assert float(medium.punch_stiffness(np.array(a))) == pytest.approx(2.0 * a * punch(ratio), rel=1e-10)
    depth, force = ball(ratio, 2e-6, radius)
    found = wk.Indentation(wk.Foundation(wk.Paraboloid(radius), medium), wk.Depth(depth)).solve()
    assert float(found.force) == pytest.approx(force, rel=1e-10)
    assert float(found.radius) == pytest.approx(a, rel=1e-8)


@pytest.mark.slow
def test_thin_films_are_springs_and_thick_ones_half_spaces():
    """Wide contacts: p = E* u / h, F = pi E* R d^2 / h.  Narrow ones: d is less by 1.1676 F / (pi E* h)."""
    thin = wk.Foundation(wk.Paraboloid(1e4), film(0.3))
    force = float(wk.Indentation(thin, wk.Depth(0.5)).solve().force)
    assert force == pytest.approx(math.pi * 1e4 * 0.5**2, rel=2e-5)
    nodes, weights = np.polynomial.legendre.leggauss(200)
    lost = -float(10.0 * weights @ excess(10.0 * (nodes + 1.0)))
    radius, depth = 1.0, 1e-6
    hertz = 4.0 / 3.0 * math.sqrt(radius) * depth**1.5
    found = float(wk.Indentation(wk.Foundation(wk.Paraboloid(radius), film()), wk.Depth(depth)).solve().force)
    chi = math.sqrt(radius * depth)
    assert (found / hertz - 1.0) / chi == pytest.approx(2.0 * lost / math.pi, rel=2e-3)
    assert 2.0 * lost / math.pi == pytest.approx(0.7433, abs=1e-4)


def test_poisson_counts_by_e_star_alone_and_an_incompressible_film_is_soft():
    bonded = wk.CoatedHalfSpace([wk.Layer(young_of(1.0, 0.5), 1.0)], on=wk.Rigid())
    radius = np.array([0.01, 5.0])
    assert film(0.5).punch_stiffness(radius) == pytest.approx(film(-0.3).punch_stiffness(radius), rel=1e-13)
    ratio = bonded.punch_stiffness(radius) / film(0.5).punch_stiffness(radius)
    assert ratio[0] == pytest.approx(1.0, abs=0.01)
    assert ratio[1] > 5.0


def test_what_it_does_not_bear_is_refused_by_name():
    layer = wk.Layer(STIFF, 1e-6)
    with pytest.raises(InvalidInput, match=r"SlidingFilm: layers has 2 layers; give one Layer"):
        wk.SlidingFilm([layer, layer], on=STIFF)
    medium = wk.SlidingFilm([layer], on=STIFF)
    with pytest.raises(OutsideValidity, match="SlidingFilm: layer 1 slides on its base.*slide away"):
        medium.tangential_stiffness(np.array([1e-6]))
    pressed = wk.Indentation(wk.Foundation(wk.Paraboloid(1e-5), medium), wk.Depth(1e-8))
    assert any("does not lift off" in note.statement for note in pressed.solve().validity)
