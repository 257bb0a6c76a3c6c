"""Relaxing springs dragged with friction against springs one by one, from event to event in closed form."""

from __future__ import annotations

import json

import numpy as np
import pytest
from relaxing_one_by_one import FOUND, NAMES, STEPS, extrapolated, followed, golden, histories

import winkler as wk

MU, DEPTH, COUNT, TOLERANCE = 0.3, 1e-6, 30, 1e-6
RUBBER = wk.StandardSolid(relaxed_shear=1e6, shear=4e6, relaxation_time=0.3, poisson=0.4)
BED = wk.Foundation(wk.Paraboloid(10e-3), wk.ViscoelasticHalfSpace(RUBBER))
DEPTHS, WALK = DEPTH * np.array([0.5, 1.0, 0.3, 0.8]), np.array([0.0, 1.0, -0.7, 0.9])
FORCES = np.array([3e-4, 5e-4, 2e-4, 4e-4])


def dragged(across, along):
    """Return a push on rubber that relaxes on the way."""
    return wk.Tangential(BED, wk.Coulomb(MU), wk.Path.through(across, along), count=COUNT, tolerance=TOLERANCE)


def agrees(problem, found):
    """Compare what both end at: loads over what friction can bear, energies over the work."""
    solved, found = problem.solve(), dict(zip(NAMES, found, strict=True))
    scales = {name: float(np.max(np.abs(getattr(solved, name)))) for name in NAMES}
    energies = dict.fromkeys(("stored_energy", "friction_loss", "bulk_loss", "work", "dissipation"), scales["work"])
    scales |= energies | {"shear_force": MU * scales["force"], "stick_radius": scales["radius"]}
    apart = {name: abs(getattr(solved, name)[-1] - found[name]) / scales[name] for name in NAMES}
    assert max(apart.values()) < 100.0 * TOLERANCE, apart
    assert found["friction_loss"] > 5e-3 * found["work"]
    assert found["bulk_loss"] > 1e-2 * found["work"]


def test_a_push_by_depth_and_shift():
    problem = dragged(wk.Depth(DEPTHS), wk.Shift(0.6 * DEPTH * WALK))
    [few], [found] = (followed([problem], steps) for steps in (4, 16))
    unquadrated = [NAMES.index(name) for name in ("force", "radius", "shear_force", "stored_energy")]
    np.testing.assert_allclose(few[unquadrated], found[unquadrated], rtol=1e-11)
    kept, work, lost = (found[NAMES.index(name)] for name in ("stored_energy", "work", "dissipation"))
    assert abs(kept + lost - work) < 1e-10 * work
    agrees(problem, found)


@pytest.mark.slow
@pytest.mark.parametrize("along", [wk.Shift(0.6 * DEPTH * WALK), wk.ShearForce(0.95 * MU * FORCES * np.sign(WALK))])
def test_a_push_by_forces(along):
    problem = dragged(wk.Force(FORCES), along)
    agrees(problem, extrapolated([problem], 40)[1][0])


def test_golden_numbers_of_relaxing_springs_are_the_limits_of_springs_one_by_one():
    """All 80: the evidence is stored by `relaxing_one_by_one.py`; its last limits differ by less than the error."""
    groups, found = golden(), json.loads(FOUND.read_text())
    assert found.keys() == groups.keys()
    wrong, seen = [], 0
    for name, group in groups.items():
        [error] = group["error"]
        for seed, (row, coarse, fine) in enumerate(zip(group["rows"], *found[name], strict=True)):
            ends = dict(zip(group["names"], row, strict=True))
            seen += 1
            for quantity in ends.keys() - {"time"}:
                [end], place = ends[quantity], NAMES.index(quantity)
                if not abs(end - fine[place]) <= 1e-14 * abs(end):
                    wrong.append((name, seed, quantity))
                if not abs(fine[place] - coarse[place]) <= error * abs(end):
                    wrong.append((name, seed, quantity, "not settled"))
    assert seen == 80
    assert not wrong


@pytest.mark.long
@pytest.mark.parametrize("name", golden())
def test_the_stored_limits_are_found_again(name):
    again = extrapolated(histories(name), STEPS // 4)[1]
    _, fine = np.array(json.loads(FOUND.read_text())[name])
    energies = [NAMES.index(each) for each in ("stored_energy", "friction_loss", "bulk_loss", "work", "dissipation")]
    apart, scales = np.abs(again - fine), np.abs(fine)
    scales[:, energies] = scales[:, [NAMES.index("work")]]
    apart = np.delete(apart / np.where(scales > 0.0, scales, 1.0), NAMES.index("stick_radius"), axis=1)
    assert np.max(apart) < 1e-4
