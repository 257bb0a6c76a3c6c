"""Rings of a contact that has nearly parted bear what those of one bear that was never pressed deeper."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

STEEL, SOFT = wk.Elastic(210e9, 0.3), wk.Elastic(20e9, 0.4)
HALF, COATED = wk.HalfSpace(STEEL), wk.CoatedHalfSpace([wk.Layer(SOFT, 1e-4)], on=STEEL)
GRADED = wk.GradedHalfSpace(wk.PowerLawGraded(1e9, 1e-3, 0.4, 0.3), wk.Rigid())
LAW, DEPTH = wk.Coulomb(0.3), 1e-6
PARTS = np.array([1e-6, 1e-10, 1e-14, 1e-20, 1e-40])


def test_all_rings_slide_under_what_friction_bears():
    bed = wk.Foundation(wk.Paraboloid(1e-2), COATED)
    depths = DEPTH * np.array([1.0, *PARTS])
    shifts = DEPTH * np.array([0.01, *(1.0 + np.arange(PARTS.size))])
    pushed = wk.Tangential(bed, LAW, wk.Path.through(wk.Depth(depths), wk.Shift(shifts))).solve()
    felt = pushed.radius > 0.5**24 * pushed.radius[0]
    assert pushed.shear_force[felt][1:] == pytest.approx(0.3 * pushed.force[felt][1:], rel=1e-8, abs=0.0)
    assert np.all(pushed.shear_force[~felt] == 0.0)


@pytest.mark.slow
@pytest.mark.parametrize("medium", [HALF, COATED, GRADED])
def test_the_greatest_torque_is_that_of_a_path_that_went_no_deeper(medium):
    bed = wk.Foundation(wk.Paraboloid(1e-2), medium)
    depths = DEPTH * np.array([1.0, *PARTS])
    twisted = wk.Torsion(bed, LAW, wk.Path.through(wk.Depth(depths), wk.Angle(1e-3 * np.arange(depths.size)))).solve()
    alone = [
        wk.Torsion(bed, LAW, wk.Path([0.0], wk.Depth([depth]), wk.Angle([0.0]))).solve().torque_limit[0]
        for depth in depths
    ]
    assert twisted.torque_limit == pytest.approx(alone, rel=1e-7, abs=0.0)
    assert np.all(np.abs(twisted.torque) <= twisted.torque_limit * (1.0 + 1e-12))
