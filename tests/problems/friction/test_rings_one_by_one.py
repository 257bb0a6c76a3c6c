"""Rings that slide under changing loads against springs one by one: even places, small even steps, extrapolated."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.foundation.torsion_bound import PressedState, twist_bound
from winkler.problems.normal.solve_contact import at_depth, at_force
from winkler.problems.ring_slip.push_bound import push_bound
from winkler.problems.ring_slip.ring_path import ANGLE_TOLERANCE

STEEL, SOFT = wk.Elastic(210e9, 0.3), wk.Elastic(20e9, 0.4)
COATED = wk.CoatedHalfSpace([wk.Layer(SOFT, 1e-4)], on=STEEL)
HARD = wk.CoatedHalfSpace([wk.Layer(STEEL, 1e-4)], on=SOFT)
MU, DEPTH = 0.3, 1e-6


def stepped(bed, bound_of, path, unit, places, steps):
    """Return motion [Pa], load [N or N m] and twice the loss at the points of a path.

    Of the engine only the bound of a press and the weights of springs are used, read at even places.  In each step
    springs move along, and those beyond the bound return to it.
    """
    forced, moved = isinstance(path.normal, wk.Force), isinstance(path.lateral, wk.Shift | wk.Angle)
    parts = np.arange(1, steps + 1) / steps
    levels, targets = (
        np.concatenate([each[:1], (each[:-1, None] + np.diff(each)[:, None] * parts).ravel()])
        for each in (path.across, path.along * (unit if moved else 1.0))
    )
    radii = (at_force if forced else at_depth)(bed, levels)[1]
    bound = bound_of(bed, MU, float(np.max(radii)), forced)
    width = float(np.max(radii)) / places
    x = width * (np.arange(places) + 0.5)
    panel = bound.panels.panel(x)
    reading = bound.panels.reading(x, panel)

    def read(values):
        return np.sum(reading * values[panel], axis=-1)

    weight, touch = 2.0 * width * read(bound.weight), read(bound.clock)
    bears, limit, before, motion, lost = np.zeros(places), np.zeros(places), levels[0], 0.0, 0.0
    points = []
    for level, radius, target in zip(levels, radii, targets, strict=True):
        press = PressedState(float(level), float(radius), 0.0)
        allowed = np.where(x < radius, np.maximum(read(bound.at(press)), 0.0), 0.0)
        share = np.clip((level - touch) / (level - before), 0.0, 1.0) if level > before else np.ones(places)
        low, high, move = -np.inf, np.inf, target - motion if moved else 0.0
        while True:
            free = bears + move * share
            after = np.clip(free, -allowed, allowed)
            missed = weight @ after - target
            if moved or abs(missed) <= 1e-13 * np.max(np.abs(path.along)):
                break
            low, high = (move, high) if missed < 0.0 else (low, move)
            ahead = move - missed / (weight @ np.where(np.abs(free) < allowed, share, 0.0) or weight.sum())
            move = ahead if low < ahead < high else 0.5 * (low + high)
        lost += weight @ (np.abs(free - after) * np.where(limit > 0.0, 0.5 * (limit + allowed), allowed))
        bears, limit, before, motion = after, allowed, level, motion + move
        points.append((motion, weight @ bears, lost))
    return np.array(points)[::steps]


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
    coarse, fine, dense = (stepped(bed, bound_of, path, unit, *each) for each in ((600, 50), (600, 100), (1200, 100)))
    motions, loads, lost = (fine + (fine - coarse) / 3.0 + (dense - fine) * 4.0 / 3.0).T / [[unit], [1.0], [unit]]
    widest = int(np.argmax(found.radius))
    across = found.force if isinstance(path.normal, wk.Force) else found.depth
    bound = bound_of(bed, MU, float(found.radius[widest]), isinstance(path.normal, wk.Force))
    bears = bound.most(PressedState(float(across[widest]), float(found.radius[widest]), 0.0))
    give = bears / bound.inertia(float(found.radius[widest])) / unit
    assert np.max(np.abs(motion - motions)) < ANGLE_TOLERANCE * give
    assert np.max(np.abs(load - loads)) < ANGLE_TOLERANCE * bears
    assert np.max(np.abs(found.dissipation - lost)) < ANGLE_TOLERANCE * 0.5 * bears * give
    assert np.max(found.dissipation) > 0.02 * np.max(found.stored_energy)
