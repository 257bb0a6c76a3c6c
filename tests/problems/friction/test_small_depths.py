"""A contact that has nearly parted bears what one bears that was never pressed deeper: springs by gap, and rings."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

STEEL, SOFT = wk.Elastic(210e9, 0.3), wk.Elastic(20e9, 0.4)
HALF, COATED = wk.HalfSpace(STEEL), wk.CoatedHalfSpace([wk.Layer(SOFT, 1e-4)], on=STEEL)
GRADED = wk.GradedHalfSpace(wk.PowerLawGraded(1e9, 1e-3, 0.4, 0.3), wk.Rigid())
LAW, DEPTH = wk.Coulomb(0.3), 1e-6
PARTS = np.array([1e-6, 1e-10, 1e-14, 1e-20, 1e-40])


BY_GAP = [
    wk.Foundation(profile, medium)
    for profile, medium in (
        (wk.Paraboloid(1e-2), HALF),
        (wk.Cone(0.1), HALF),
        (wk.FlatPunch(1e-3), HALF),
        (wk.TruncatedCone(1e-4, 0.1), HALF),
        (wk.PowerLaw(1e3, 4.0), HALF),
        (wk.Paraboloid(1e-2), GRADED),
    )
]


@pytest.mark.parametrize("bed", BY_GAP, ids=lambda bed: f"{type(bed.profile).__name__}-{type(bed.medium).__name__}")
def test_all_springs_by_gap_slide_under_what_friction_bears(bed):
    depths = DEPTH * np.array([1.0, *PARTS])
    for shifts in (DEPTH * np.array([0.01, *(1.0 + np.arange(PARTS.size))]), np.full(depths.size, 0.01 * DEPTH)):
        pushed = wk.Tangential(bed, LAW, wk.Path.through(wk.Depth(depths), wk.Shift(shifts))).solve()
        assert pushed.shear_force[1:] == pytest.approx(0.3 * pushed.force[1:], rel=1e-12, abs=0.0)


@pytest.mark.parametrize("bed", BY_GAP, ids=lambda bed: f"{type(bed.profile).__name__}-{type(bed.medium).__name__}")
def test_springs_by_gap_that_part_in_steps_obey_ciavarella_and_jaeger(bed):
    """Pressed from apart at each small depth anew, the stick zone is the contact of F - F_x / mu."""
    for part in PARTS:
        depth = DEPTH * part
        whole = wk.Indentation(bed, wk.Depth(depth)).solve()
        shear = 0.5 * 0.3 * float(whole.force)
        lateral = wk.ShearForce([0.0, 0.0, 0.0, shear])
        path = wk.Path.through(wk.Depth([DEPTH, 0.0, depth, depth]), lateral)
        pushed = wk.Tangential(bed, LAW, path).solve()
        inner = wk.Indentation(bed, wk.Force(0.5 * float(whole.force))).solve()
        ratio = pushed.states[-1].mindlin_ratio
        assert pushed.shear_force[-1] == pytest.approx(shear, rel=1e-9)
        assert pushed.shift[-1] - pushed.shift[-2] == pytest.approx(
            0.3 / ratio * (depth - float(inner.depth)), rel=1e-9, abs=0.0
        )


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
