"""Rows of slip against each other on random histories: springs by gap, springs one by one, rings of equal layers."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.problems.friction.spring_march import SpringMarch
from winkler.problems.row import CURVED_STEP_TOLERANCE

STEEL = wk.Elastic(210e9, 0.3)
HALF = wk.HalfSpace(STEEL)
LAYERS = wk.CoatedHalfSpace([wk.Layer(STEEL, 1e-4)], on=STEEL)
BALL = wk.Paraboloid(10e-3)
MU, DEPTH = 0.3, 1e-6
RATIO = HALF.shear_modulus / HALF.modulus
POINTS = 6
SEEDS = [0, *(pytest.param(seed, marks=pytest.mark.slow if seed < 4 else pytest.mark.long) for seed in range(1, 20))]


def path_of(seed, normal, lateral, points=POINTS):
    """Return a random history that friction bears; both loads change between all of its points."""
    rng = np.random.default_rng(seed)
    depth = DEPTH * rng.uniform(0.3, 1.0, points)
    force = np.asarray(wk.Indentation(wk.Foundation(BALL, HALF), wk.Depth(depth)).solve().force)
    share = np.append(0.0, rng.uniform(-0.8, 0.8, points - 1))
    across = wk.Depth(depth) if normal is wk.Depth else wk.Force(force)
    along = wk.Shift(share * MU * DEPTH / RATIO) if lateral is wk.Shift else wk.ShearForce(share * MU * force.min())
    return wk.Path(np.arange(points), across, along)


def scales(march):
    """Return what counts as much: of shift, shear force and energy."""
    force = MU * float(np.max(march.force))
    return {"shift": MU * DEPTH / RATIO, "shear_force": force, "dissipation": force * MU * DEPTH / RATIO}


def missed(one, other):
    return {
        name: float(np.max(np.abs(getattr(one, name) - getattr(other, name)))) / scale
        for name, scale in scales(other).items()
    }


SLOW = pytest.mark.slow
CONTROLS = [
    (wk.Depth, wk.Shift),
    pytest.param(wk.Depth, wk.ShearForce, marks=SLOW),
    pytest.param(wk.Force, wk.Shift, marks=SLOW),
    pytest.param(wk.Force, wk.ShearForce, marks=SLOW),
]
RINGS = pytest.param("rings", marks=SLOW)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(("normal", "lateral"), CONTROLS)
def test_rings_of_equal_layers_as_springs_by_gap(seed, normal, lateral):
    path = path_of(seed, normal, lateral)
    exact = wk.Tangential(wk.Foundation(BALL, HALF), wk.Coulomb(MU), path).solve()
    rings = wk.CoatedTangential(wk.Foundation(BALL, LAYERS), wk.Coulomb(MU), path).solve()
    assert max(missed(rings, exact).values()) < POINTS * CURVED_STEP_TOLERANCE


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_springs_one_by_one_as_springs_by_gap(seed):
    path = path_of(seed, wk.Depth, wk.Shift, 12)
    bed = wk.Foundation(BALL, HALF)
    exact = wk.Tangential(bed, wk.Coulomb(MU), path).solve()
    springs = SpringMarch(bed, wk.Coulomb(MU), path, 400).solve()
    assert max(missed(springs, exact).values()) < 2e-5  # 12 points of some 1 / 400^2 each


@pytest.mark.parametrize("seed", SEEDS[:6])
@pytest.mark.parametrize("kind", ["gap", RINGS, "springs"])
def test_a_history_to_the_other_side_bears_and_loses_the_same(seed, kind):
    path = path_of(seed, wk.Force, wk.Shift)
    other = wk.Path(path.time, path.normal, wk.Shift(-path.along))
    bed = wk.Foundation(BALL, LAYERS if kind == "rings" else HALF)
    march = {"gap": wk.Tangential, "rings": wk.CoatedTangential, "springs": SpringMarch}[kind]
    one, two = (march(bed, wk.Coulomb(MU), each).solve() for each in (path, other))
    np.testing.assert_allclose(two.shear_force, -one.shear_force, rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(two.dissipation, one.dissipation, rtol=1e-12)


@pytest.mark.parametrize("seed", SEEDS[:8])
@pytest.mark.parametrize("kind", ["gap", RINGS])
def test_points_in_between_change_nothing_beyond_the_stated_error(seed, kind):
    path = path_of(seed, wk.Force, wk.ShearForce, 4)
    fine = np.linspace(0.0, 3.0, 10)
    split = wk.Path(
        fine,
        wk.Force(np.interp(fine, path.time, path.across)),
        wk.ShearForce(np.interp(fine, path.time, path.along)),
    )
    bed = wk.Foundation(BALL, LAYERS if kind == "rings" else HALF)
    march = wk.CoatedTangential if kind == "rings" else wk.Tangential
    one, two = (march(bed, wk.Coulomb(MU), each).solve() for each in (path, split))
    for name, scale in scales(one).items():
        apart = np.max(np.abs(getattr(one, name) - getattr(two, name)[::3])) / scale
        assert apart < 10 * CURVED_STEP_TOLERANCE, name
