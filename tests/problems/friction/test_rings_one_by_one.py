"""Rings that slide under changing loads against springs one by one: even places, small even steps, extrapolated."""

from __future__ import annotations

import json

import numpy as np
import pytest
from rings_one_by_one import FOUND, ends, extrapolated, golden, missed, scales

import winkler as wk
from winkler.foundation.torsion_bound import PressedState, twist_bound
from winkler.problems.normal.solve_contact import at_depth
from winkler.problems.ring_slip.push_bound import push_bound
from winkler.problems.ring_slip.ring_path import ANGLE_TOLERANCE

STEEL, SOFT = wk.Elastic(210e9, 0.3), wk.Elastic(20e9, 0.4)
COATED = wk.CoatedHalfSpace([wk.Layer(SOFT, 1e-4)], on=STEEL)
HARD = wk.CoatedHalfSpace([wk.Layer(STEEL, 1e-4)], on=SOFT)
MU, DEPTH = 0.3, 1e-6


def path_of(bed, lateral):
    """Return a path on which both loads change, and some springs slide back."""
    depth = DEPTH * np.array([0.5, 1.0, 0.6, 0.9])
    force = wk.Indentation(bed, wk.Depth(depth)).solve().force
    radius = float(np.max(at_depth(bed, depth)[1]))
    most = 0.3 * MU * float(np.min(force))
    along = {
        wk.ShearForce: wk.ShearForce(most * np.array([0.0, 1.8, -1.2, 2.0])),
        wk.Torque: wk.Torque(0.5 * most * radius * np.array([0.0, 1.8, -1.2, 1.5])),
        wk.Shift: wk.Shift(MU * DEPTH * np.array([0.0, 0.8, -0.5, 1.0])),
    }[lateral]
    return wk.Path(np.arange(4.0), wk.Force(force), along)


@pytest.mark.slow
@pytest.mark.parametrize("medium", [COATED, HARD])
@pytest.mark.parametrize("lateral", [wk.ShearForce, wk.Shift])
def test_a_push_under_a_changing_load(medium, lateral):
    bed = wk.Foundation(wk.Paraboloid(10e-3), medium)
    path = path_of(bed, lateral)
    found = wk.Tangential(bed, wk.Coulomb(MU), path).solve()
    agrees(bed, push_bound, path, medium.shear_modulus, found, found.shift, found.shear_force)


@pytest.mark.slow
@pytest.mark.parametrize("medium", [COATED, wk.HalfSpace(STEEL)])
def test_a_twist_under_a_changing_load(medium):
    bed = wk.Foundation(wk.Paraboloid(10e-3), medium)
    path = path_of(bed, wk.Torque)
    found = wk.Torsion(bed, wk.Coulomb(MU), path).solve()
    agrees(bed, twist_bound, path, 8.0 * bed.medium.torsional_modulus, found, found.angle, found.torque)


def agrees(bed, bound_of, path, unit, found, motion, load):
    """Compare with the limit of springs one by one, to the stated part of what friction bears."""
    motions, loads, _, lost = extrapolated(bed, bound_of, wk.Coulomb(MU), path, unit).T
    widest = int(np.argmax(found.radius))
    across = found.force if isinstance(path.normal, wk.Force) else found.depth
    bound = bound_of(bed, MU, float(found.radius[widest]), isinstance(path.normal, wk.Force))
    bears = bound.most(PressedState(float(across[widest]), float(found.radius[widest]), 0.0))
    give = bears / bound.inertia(float(found.radius[widest])) / unit
    assert np.max(np.abs(motion - motions)) < ANGLE_TOLERANCE * give
    assert np.max(np.abs(load - loads)) < ANGLE_TOLERANCE * bears
    assert np.max(np.abs(found.dissipation - lost)) < ANGLE_TOLERANCE * 0.5 * bears * give
    assert np.max(found.dissipation) > 0.02 * np.max(found.stored_energy)


def test_golden_numbers_of_rings_are_the_limits_of_springs_one_by_one():
    """All 140: the evidence is stored by `rings_one_by_one.py`, in which limits move by less than the stated error."""
    groups, found = golden(), json.loads(FOUND.read_text())
    assert found.keys() == groups.keys()
    wrong, seen = [], 0
    for name, group in groups.items():
        rows = zip(group["rows"], group["error"], found[name], strict=True)
        for seed, (row, error, (_, coarse, fine)) in enumerate(rows):
            coarse, fine = np.array(coarse), np.array(fine)
            seen += 1
            if not missed(ends(dict(zip(group["names"], row, strict=True))), error, coarse, fine) <= 1.0:
                wrong.append((name, seed))
            if np.any(np.abs(fine - coarse) > error * scales(fine)[:4]):
                wrong.append((name, seed, "not settled"))
    assert seen == 140
    assert not wrong
