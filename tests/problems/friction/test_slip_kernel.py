"""Long paths by a kernel: the numbers of the same functions as they are written, on shapes and paths of every kind."""

from __future__ import annotations

import numpy as np
import pytest
from test_slip_memory import displaced

import winkler as wk
from winkler.problems.friction import tangential_march

MU, DEPTH, POINTS = 0.3, 2e-6, 60
STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
SHAPES = {
    "ball": wk.Paraboloid(10e-3),
    "flat": wk.FlatPunch(1e-4),
    "cone": wk.Cone(0.02),
    "truncated cone": wk.TruncatedCone(1.5, 1e-4),
    "capped ball": wk.CappedParaboloid(10e-3, 20e-3, 1e-4),
    "pinned at a rim": wk.CappedCylinder(1.5e-4, wk.Paraboloid(10e-3)),
}
CONTROLS = [(by_force, by_load) for by_force in (False, True) for by_load in (False, True)]


def pushed(shape, by_force, by_load, seed, law=None):
    """Return a path on which the bodies also come close to parting, and, by depth and shift, part."""
    rng = np.random.default_rng(seed)
    bed = wk.Foundation(SHAPES[shape], STEEL)
    depth = DEPTH * rng.uniform(0.3, 1.0, POINTS)
    depth[7] = 1e-5 * DEPTH
    if not (by_force or by_load):
        depth[20:22] = -0.2 * DEPTH, 0.0
    force = np.asarray(wk.Indentation(bed, wk.Depth(depth)).solve().force)
    normal = wk.Force(force) if by_force else wk.Depth(depth)
    far = MU * DEPTH * STEEL.modulus / STEEL.shear_modulus
    swing = rng.uniform(-1.0, 1.0, POINTS)
    least = np.minimum(force, np.minimum(np.roll(force, 1), np.roll(force, -1)))
    lateral = wk.ShearForce(0.9 * MU * least * swing) if by_load else wk.Shift(far * swing)
    return wk.Tangential(bed, law or wk.Coulomb(MU), wk.Path(np.arange(POINTS) * 1.0, normal, lateral))


def both(problem, monkeypatch):
    plain = problem.solve()
    monkeypatch.setattr(tangential_march, "LONG", 2)
    return plain, problem.solve()


@pytest.mark.parametrize(("by_force", "by_load"), CONTROLS)
@pytest.mark.parametrize("shape", ["ball", *(pytest.param(each, marks=pytest.mark.slow) for each in [*SHAPES][1:])])
def test_a_kernel_gives_the_numbers_of_its_source(shape, by_force, by_load, monkeypatch):
    for seed in range(3):
        plain, fast = both(pushed(shape, by_force, by_load, seed), monkeypatch)
        most = np.max(np.abs(plain.shift)), MU * np.max(plain.force)
        for name, scale in zip(
            ("shift", "shear_force", "dissipation", "work", "stored_energy"),
            (*most, *3 * [most[0] * most[1]]),
            strict=True,
        ):
            np.testing.assert_allclose(getattr(fast, name), getattr(plain, name), rtol=0.0, atol=2e-11 * scale)
        gap = DEPTH * np.linspace(0.005, 0.995, 40)
        for ours, theirs in zip(fast.states, plain.states, strict=True):
            moved = displaced(ours.memory, gap) - displaced(theirs.memory, gap)
            assert np.max(np.abs(moved)) <= 1e-10 * most[0]


def test_a_long_path_is_refused_at_its_step_with_the_sentence_of_a_short_one(monkeypatch):
    time = np.arange(POINTS) * 1.0
    shear = np.full(POINTS, 10.0)
    shear[40] = 1000.0
    force = 1000.0 + 100.0 * np.sin(time)
    problem = wk.Tangential(
        wk.Foundation(SHAPES["ball"], STEEL), wk.Coulomb(MU), wk.Path(time, wk.Force(force), wk.ShearForce(shear))
    )
    said = []
    for long in (5000, 2):
        monkeypatch.setattr(tangential_march, "LONG", long)
        states = []
        with pytest.raises(wk.OutsideValidity, match="at index 40 of the path a shear force of 1000 N") as refused:
            states.extend(problem.steps())
        said.append(str(refused.value))
    assert said[0] == said[1]


def test_ten_thousand_turning_points_need_little_memory():
    rng = np.random.default_rng(5)
    count = 2000
    force = 1000.0 * (1.0 + 0.2 * rng.uniform(-1.0, 1.0, count))
    path = wk.Path(np.arange(count) * 1.0, wk.Force(force), wk.ShearForce(200.0 * rng.uniform(-1.0, 1.0, count)))
    states = wk.Tangential(wk.Foundation(SHAPES["ball"], STEEL), wk.Coulomb(MU), path).solve().states
    shared = {id(state.memory.pieces): state.memory.pieces for state in states}
    assert len(shared) < count / 50
    assert sum(pieces.columns.used[0] for pieces in shared.values()) <= 6 * count
