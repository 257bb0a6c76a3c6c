"""Depth and shift that oscillate on coatings: limits of a steady depth, of a half-space, and without slip."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk

STEEL, CARBON = wk.Elastic(210e9, 0.3), wk.Elastic(600e9, 0.2)
COATED = wk.Foundation(wk.Paraboloid(10e-3), wk.CoatedHalfSpace([wk.Layer(CARBON, thickness=100e-6)], on=STEEL))
DEPTH, LAW = 2e-6, wk.Coulomb(0.3)


@pytest.mark.slow
def test_at_a_steady_depth_it_is_the_damping_of_friction():
    aside = np.array([0.2e-6, 2e-6])
    cycle = wk.BimodalDamping(COATED, LAW, DEPTH, 0.0, aside, 0.4).solve()
    steady = wk.FrictionDamping(COATED, LAW, wk.Depth(DEPTH), wk.Shift(aside)).solve()
    np.testing.assert_allclose(cycle.loss_per_cycle, steady.loss_per_cycle, rtol=3e-4)


@pytest.mark.slow
@pytest.mark.parametrize(("down", "cycles"), [(0.6e-6, (1, 1)), (3e-6, (1, 1)), (0.6e-6, (2, 3))])
def test_a_layer_that_hardly_differs_is_a_half_space(down, cycles):
    near = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(210e9 * (1.0 + 1e-5), 0.3), thickness=20e-6)], on=STEEL)
    given = (LAW, DEPTH, down, 0.3e-6, 0.7, *cycles)
    found, exact = (
        wk.BimodalDamping(wk.Foundation(wk.Paraboloid(10e-3), medium), *given).solve().loss_per_cycle
        for medium in (near, wk.HalfSpace(STEEL))
    )
    assert found == pytest.approx(exact, rel=2e-4)


def test_without_slip_small_swings_lose_what_leaves_the_contact():
    """W = 8/3 (dk_x/dd) A_x^2 A_z sin^2, with k_x of tractions in both directions."""
    down, aside = 1e-10, 1e-8
    radius = float(wk.Indentation(COATED, wk.Depth(DEPTH)).solve().radius)
    around = radius * (1.0 + np.array([-1e-3, 1e-3]))
    rise = np.diff(COATED.medium.punch_shear_stiffness(around))[0] / np.diff(COATED.gap(around))[0]
    found = wk.BimodalDamping(COATED, wk.Coulomb(math.inf), DEPTH, down, aside, 0.9).solve()
    wanted = 8.0 / 3.0 * rise * aside**2 * down * math.sin(0.9) ** 2
    assert found.loss_per_cycle == pytest.approx(wanted, rel=1e-4)
    slid = wk.BimodalDamping(COATED, wk.Coulomb(30.0), DEPTH, DEPTH, 1e-7, 0.9).solve().loss_per_cycle
    stuck = wk.BimodalDamping(COATED, wk.Coulomb(math.inf), DEPTH, DEPTH, 1e-7, 0.9).solve().loss_per_cycle
    assert slid == pytest.approx(stuck, rel=1e-2)


def test_too_many_oscillations_are_refused():
    with pytest.raises(wk.OutsideValidity, match="at most 50"):
        wk.BimodalDamping(COATED, LAW, DEPTH, 1e-7, 1e-7, 0.0, 1, 51).solve()
