"""Rows of slip against each other on random histories: springs by gap, springs one by one, rings of equal layers."""

from __future__ import annotations

import collections

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
    rings = wk.Tangential(wk.Foundation(BALL, LAYERS), wk.Coulomb(MU), path).solve()
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
    march = SpringMarch if kind == "springs" else wk.Tangential
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
    one, two = (wk.Tangential(bed, wk.Coulomb(MU), each).solve() for each in (path, split))
    for name, scale in scales(one).items():
        apart = np.max(np.abs(getattr(one, name) - getattr(two, name)[::3])) / scale
        assert apart < 10 * CURVED_STEP_TOLERANCE, name


RELAXING = wk.ViscoelasticHalfSpace(wk.Prony(20e9, [60e9], [1.0]))
FORCE = 0.3
STEADY = FORCE * np.ones(6)
VARYING = FORCE * np.array([1.0, 1.2, 0.9, 1.1, 0.8, 1.0])
BEYOND, AT = np.array([0.0, 0.5, -0.4, 0.3, 1.5, 0.2]), 4
"""Parts of what friction bears; the last but one is more than all of it."""


def round_path(force, shape=1.0, lateral=wk.ShearForce, arm=1.0):
    return wk.Path(np.arange(6.0), wk.Force(force), lateral(np.multiply.outer(MU * force * BEYOND * arm, shape)))


def tangential(medium, force, shape=1.0, method=wk.Method.AUTO):
    return wk.Tangential(wk.Foundation(BALL, medium), wk.Coulomb(MU), round_path(force, shape), method, count=60)


def on_a_map(force):
    heights = wk.SampledProfile([4e-5, 4e-5], BALL, (17, 17))
    return wk.SurfaceTangential(heights, HALF, wk.Coulomb(MU), round_path(force))


def on_a_line(force, method):
    path = wk.LinePath(1e5 * force, 1e5 * MU * force * BEYOND)
    return wk.LineTangential(wk.LineFoundation(BALL, HALF), wk.Coulomb(MU), path, method)


REFUSED = {
    "by gap, steady": lambda: tangential(HALF, STEADY),
    "by gap": lambda: tangential(HALF, VARYING),
    "springs": lambda: tangential(HALF, VARYING, method=wk.Method.SPRINGS),
    "springs in the plane": lambda: tangential(HALF, VARYING, [0.6, 0.8]),
    "rings, steady": lambda: tangential(LAYERS, STEADY),
    "rings": lambda: tangential(LAYERS, VARYING),
    "relaxing springs": lambda: tangential(RELAXING, VARYING),
    "twist": lambda: wk.Torsion(
        wk.Foundation(BALL, HALF), wk.Coulomb(MU), round_path(STEADY, lateral=wk.Torque, arm=1.2e-5)
    ),
    "earlier strips": lambda: on_a_line(VARYING, wk.Method.AUTO),
    "elements of a line": lambda: on_a_line(VARYING, wk.Method.ELEMENTS),
    "a map": lambda: on_a_map(VARYING),
}


@pytest.mark.few(4)
@pytest.mark.parametrize("row", REFUSED)
def test_more_than_friction_bears_is_refused_at_its_point_and_what_came_before_stands(row):
    problem, kept = REFUSED[row](), []
    with pytest.raises(wk.OutsideValidity, match=rf"^{type(problem).__name__}: at index {AT} of the path"):
        collections.deque(map(kept.append, problem.steps()), maxlen=0)
    assert len(kept) == AT
    before = problem.gathered(kept)
    borne = problem.path.along[:AT]
    found = before.torque if row == "twist" else getattr(before, "shear_force", None)
    if found is None:
        found = before.shear_force_per_length
    borne = borne.reshape(AT, -1)
    found = np.reshape(found, (AT, -1))[:, : borne.shape[1]]
    np.testing.assert_allclose(found, borne, rtol=1e-7, atol=1e-7 * np.max(np.abs(borne)))
    assert all(note.statement for note in before.validity)
