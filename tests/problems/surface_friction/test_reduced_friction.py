"""Springs of height maps under friction, and the error that they state, against other runs of the boundary elements."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

import winkler as wk
from winkler.problems.surface_friction.reduced import SHARES, ReducedFriction
from winkler.profiles.rough.random_rough import random_topography
from winkler.values.errors import InvalidInput

MU = 0.3
OTHER_SHARES = np.array([0.0, 0.4, 0.7, 0.85, 0.35, -0.3, -0.8])
"""None of those at which the error was measured."""


def pair(poisson):
    body = wk.Elastic(1.0, poisson)
    return wk.HalfSpace.between(body, body)


def square(count):
    x = (np.arange(count) - (count - 1) / 2) / count
    return x[:, None], x[None, :]


def ball(count=41):
    x, y = square(count)
    return wk.Topography(-0.5 * (x**2 + y**2), [1.0, 1.0])


def maps(count):
    x, y = square(count)
    spots = np.min([(x - a) ** 2 + (y - b) ** 2 for a in (-0.3, 0.0, 0.3) for b in (-0.3, 0.0, 0.3)], axis=0)
    rough = random_topography(wk.SelfAffine(0.8, 0.03, 1.0, 0.1), (count, count), [1.0, 1.0], seed=2).heights
    return {
        "ball": (wk.Topography(-0.5 * (x**2 + y**2), [1.0, 1.0]), 0.05),
        "ellipse": (wk.Topography(-0.2 * x**2 - 1.0 * y**2, [1.0, 1.0]), 0.04),
        "square of nine balls": (wk.Topography(-0.5 * spots, [1.0, 1.0]), 0.006),
        "rough": (wk.Topography(rough, [1.0, 1.0]), 0.08),
    }


def differences(found, shares):
    """Return the greatest differences of shift and loss in a loop of other shear forces, over the greatest stated."""
    problem, worst = found.problem, []
    loops = (found.along.shift_x, found.along.dissipation), (found.across.shift_y, found.across.dissipation)
    for axis, bed in enumerate((found.bed, found.bed.turned)):
        forces = np.zeros((shares.size, 2))
        forces[:, axis] = shares * MU * found.force
        depth = wk.Depth(problem.depth)
        path = wk.Path.through(depth, wk.ShearForce(forces))
        exact = wk.SurfaceTangential(problem.topography, problem.medium, problem.law, path).solve()
        springs = wk.Tangential(bed, problem.law, wk.Path.through(depth, wk.ShearForce(forces[:, axis]))).solve()
        apart = springs.shift - exact.shift[:, axis], springs.dissipation - exact.dissipation
        worst.append([np.max(np.abs(a)) / np.max(np.abs(most)) for a, most in zip(apart, loops[axis], strict=True)])
    return np.max(worst, axis=0)


@pytest.mark.parametrize(
    ("name", "count", "poisson"),
    [
        pytest.param("ball", 41, 0.3, marks=pytest.mark.long),
        pytest.param("ellipse", 41, 0.3, marks=pytest.mark.slow),
        pytest.param("ellipse", 63, 0.5, marks=pytest.mark.long),
        pytest.param("square of nine balls", 63, 0.3, marks=pytest.mark.long),
        pytest.param("rough", 63, 0.3, marks=pytest.mark.slow),
        pytest.param("rough", 95, 0.5, marks=pytest.mark.long),
    ],
)
def test_the_error_is_as_stated_at_other_shear_forces(name, count, poisson):
    topography, depth = maps(count)[name]
    found = ReducedFriction(topography, pair(poisson), wk.Coulomb(MU), depth).solve()
    shift, loss = differences(found, OTHER_SHARES)
    assert 0.0 < shift <= found.shift_error
    assert 0.0 < loss <= found.loss_error


@pytest.fixture(scope="module")
def found():
    return ReducedFriction(ball(), pair(0.3), wk.Coulomb(MU), 0.05).solve()


def test_the_error_is_that_of_the_same_loop(found):
    """Recomputed from the problems themselves."""
    share = np.array(SHARES) * float(found.shear_force[4] / 0.9) / (MU * found.force)
    stated = np.array([found.shift_error, found.loss_error]) - np.array([1.0, 3.0]) * found.reduction.misfit
    assert 1.1 * differences(found, share) == pytest.approx(stated, rel=1e-4)
    assert share[4] == pytest.approx(0.9, rel=1e-2)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ellipse", pytest.param("ball", marks=pytest.mark.slow)])
def test_without_poissons_ratio_the_springs_are_right(name):
    """Cattaneo, Mindlin, Ciavarella, Jaeger: without Poisson's ratio bodies slip along the shear, of any shape."""
    topography, depth = maps(41)[name]
    found = ReducedFriction(topography, pair(0.0), wk.Coulomb(MU), depth).solve()
    assert found.shift_error < 2e-3
    assert found.loss_error < 5e-3


def test_the_note_states_the_error_wherever_the_springs_are_used(found):
    path = wk.Path.through(wk.Depth(0.03), wk.Shift([0.0, 1e-3]))
    for bed in (found.bed, found.bed.turned):
        notes = [note.statement for note in wk.Tangential(bed, wk.Coulomb(MU), path).solve().validity]
        (stated,) = (note for note in notes if "Ciavarella" in note)
        said = re.search(r"differ by at most (\S+) % of their maximum, the dissipated energy by (\S+) %", stated)
        shift, loss = (float(part) / 100.0 for part in said.groups())
        assert found.shift_error <= shift * (1.0 + 1e-12) <= 1.1 * found.shift_error
        assert found.loss_error <= loss * (1.0 + 1e-12) <= 1.1 * found.loss_error
    unmeasured = wk.Tangential(found.reduction.bed, wk.Coulomb(MU), path).solve().validity
    assert any("Use ReducedFriction to compute" in note.statement for note in unmeasured)


@pytest.mark.slow
def test_dissimilar_bodies_are_far_off_and_say_so():
    """Springs know nothing of what pressures do along the surface: on a rigid body 5 % and more."""
    found = ReducedFriction(ball(33), wk.HalfSpace(wk.Elastic(1.0, 0.1)), wk.Coulomb(MU), 0.06).solve()
    assert found.shift_error > 0.05
    assert any("compared with boundary elements, in a loop" in note.statement for note in found.validity)


@pytest.mark.parametrize("coefficient", [0.0, math.inf])
def test_friction_that_does_not_slip_or_does_not_bear_is_refused(coefficient):
    with pytest.raises(InvalidInput, match="coefficient"):
        ReducedFriction(ball(), pair(0.3), wk.Coulomb(coefficient), 0.05)


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("angle", [0.0, 35.0])
def test_a_depth_that_changes_triples_the_error_of_losses_at_most(angle):
    x, y = square(47)
    along, across = (
        np.cos(np.radians(angle - turn)) * x + np.sin(np.radians(angle - turn)) * y for turn in (0.0, -90.0)
    )
    tip, most = wk.Topography(-0.25 * along**2 - 1.2 * across**2, [1.0, 1.0]), 0.04
    found = ReducedFriction(tip, pair(0.5), wk.Coulomb(MU), most).solve()
    turns, steps = np.arange(7.0), np.linspace(0.0, 6.0, 97)
    depth = np.interp(steps, turns, most * np.array([0.6, 0.8, 1.0, 0.9, 0.75, 0.9, 1.0]))
    force = MU * found.force * np.interp(steps, turns, [0.0, 0.34, 0.78, 0.16, -0.37, -0.7, -0.1])
    for axis, bed in enumerate((found.bed, found.bed.turned)):
        forces = np.zeros((97, 2))
        forces[:, axis] = force
        path = wk.Path.through(wk.Depth(depth), wk.ShearForce(forces))
        exact = wk.SurfaceTangential(tip, found.problem.medium, wk.Coulomb(MU), path).solve()
        springs = wk.Tangential(bed, wk.Coulomb(MU), wk.Path.through(wk.Depth(depth), wk.ShearForce(force))).solve()
        shift, loss = exact.shift[:, axis], exact.dissipation
        assert np.max(np.abs(springs.shift - shift)) <= found.shift_error * np.max(np.abs(shift))
        assert np.max(np.abs(springs.dissipation - loss)) <= 3.0 * found.loss_error * np.max(loss)
