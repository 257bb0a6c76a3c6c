"""Impacts and cycles on coatings beside rings that slide each by itself, as the notes on validity state."""

from __future__ import annotations

import math

import free_rings
import layer_waves
import numpy as np
import pytest

import winkler as wk
from winkler.problems.impact import ring_march
from winkler.problems.impact.motion import ImpactProblem
from winkler.problems.normal.force_curve import normal_curve
from winkler.problems.ring_slip.ring_table import ring_table

MU, WIDE, MASS, COUNT = 0.3, 0.02, 1.0, 50


class Pressed:
    """A ball on a layer of the shear modulus 1 and a base of another one; nu = 0.3."""

    def __init__(self, softer, wide):
        layer, on = (1.0, 0.3, WIDE / wide), (1.0 / softer, 0.3)
        solids = [wk.Elastic(2.6 * shear, 0.3) for shear in (1.0, on[0])]
        medium = wk.CoatedHalfSpace([wk.Layer(solids[0], thickness=layer[2])], on=solids[1])
        self.bed = wk.Foundation(wk.Paraboloid(1.0), medium)
        self.depth = float(self.bed.gap(np.array([WIDE]))[0])
        self.edges = np.linspace(0.0, 1.03 * WIDE, COUNT + 1)
        self.shear, self.area = free_rings.matrix(
            lambda xi: 0.5 * sum(layer_waves.compliances([layer], on, xi)), layer[2], self.edges
        )
        self.normal, _ = free_rings.matrix(lambda xi: free_rings.normal_compliance(layer, on, xi), layer[2], self.edges)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(
    ("softer", "wide", "slow", "heavy", "off"),
    [
        (100.0, 2.0, 0.3, 2.5, 0.035),
        (100.0, 3.0, 0.1, 3.5, 0.035),
        (10.0, 3.0, 0.6, 2.0, 0.028),
        (0.1, 1.0, 0.8, 3.5, 0.002),
    ],
)
def test_an_impact(softer, wide, slow, heavy, off, monkeypatch):
    """Velocities are off by a part of the coefficient times that of approach, however slow the motion is."""
    monkeypatch.setattr(ring_march, "STEPS", 150)
    pressed, mobility = Pressed(softer, wide), heavy / MASS
    curve = normal_curve(pressed.bed, pressed.depth)
    speed = math.sqrt(2.0 * curve.at(pressed.depth)[2] / MASS)
    sliding = slow * MU * speed
    motion = ImpactProblem(curve, pressed.depth, MASS, mobility, speed, sliding, 1.0, MU)
    thrown = ring_march.march_rings(motion, ring_table("Impact", pressed.bed, MU, WIDE, 150))
    count = thrown.time.size - 1
    half = free_rings.pressures(pressed.normal, pressed.edges, 1.0, thrown.depth[: count // 2 + 1])
    limits = MU * np.concatenate([half, half[-2::-1]])
    step, traction, velocity = float(thrown.time[1]), np.zeros(COUNT), sliding
    for i in range(count):
        force = following = float(pressed.area @ traction)
        for _ in range(2):
            shift = step * (velocity - 0.25 * mobility * step * (force + following))
            new, _ = free_rings.pushed(pressed.shear, traction, limits[i + 1], shift)
            following = float(pressed.area @ new)
        velocity -= 0.5 * mobility * step * (force + following)
        traction = new
    assert abs(thrown.sliding[-1] - velocity) < off * MU * speed


@pytest.mark.slow
@pytest.mark.parametrize(
    ("softer", "wide", "part", "phase", "off"),
    [(100.0, 3.0, 0.3, 0.0, 0.055), (10.0, 3.0, 1.5, 0.7, 0.012), (0.1, 1.0, 0.7, 0.7, 0.002)],
)
def test_a_cycle_of_depth_and_shift(softer, wide, part, phase, off):
    pressed = Pressed(softer, wide)
    depth = pressed.depth / 1.5
    force = MU * float(wk.Indentation(pressed.bed, wk.Depth(depth)).solve().force)
    aside = part * force / float(pressed.bed.medium.punch_shear_stiffness(np.array([WIDE]))[0])
    found = wk.BimodalDamping(pressed.bed, wk.Coulomb(MU), depth, 0.5 * depth, aside, phase).solve().loss_per_cycle
    angle = np.linspace(0.0, 2.0 * np.pi, 361)
    half = free_rings.pressures(pressed.normal, pressed.edges, 1.0, depth * (1.0 + 0.5 * np.cos(angle[:181])))
    limits, moved = MU * np.concatenate([half, half[-2::-1]]), aside * np.cos(angle + phase)
    traction, losses = np.zeros(COUNT), []
    for _ in range(2):
        lost = 0.0
        for i in range(360):
            new, slid = free_rings.pushed(pressed.shear, traction, limits[i + 1], moved[i + 1] - moved[i])
            lost += float(pressed.area @ (0.5 * (traction + new) * slid))
            traction = new
        losses.append(lost)
    assert abs(found - losses[1]) < off * force * aside
