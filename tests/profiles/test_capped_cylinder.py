"""A cylinder whose end has the shape of another profile presses as that profile, below its rim."""

import math

import numpy as np
import pytest

import winkler as wk

CAP = wk.Sphere(0.1)
CAPPED = wk.CappedCylinder(1e-3, CAP)
STEEL = wk.Elastic(210e9, 0.3)


def test_below_the_rim_it_is_its_cap_on_a_graded_body():
    graded = wk.GradedHalfSpace(wk.PowerLawGraded(1e9, 1e-3, 0.3, 0.3))
    depth = wk.Depth(np.array([0.1e-6, 1e-6]))
    capped, bare = (wk.Indentation(wk.Foundation(shape, graded), depth).solve().force for shape in (CAPPED, CAP))
    np.testing.assert_allclose(capped, bare, rtol=1e-12)


@pytest.mark.slow
def test_below_the_rim_it_is_its_cap_in_a_row():
    medium = wk.HalfSpace.between(STEEL, STEEL)
    widths = wk.HalfWidth(np.array([0.2e-3, 0.9e-3]))
    capped, bare = (
        wk.PeriodicIndentation(wk.LineFoundation(shape, medium), 2e-3, widths).solve().nominal_pressure
        for shape in (CAPPED, CAP)
    )
    np.testing.assert_allclose(capped, bare, rtol=1e-12)


class Curveless:
    """A profile of one's own, which need not have a curvature where its transform is given."""

    reach = rim = size = math.inf
    kinks = notes = ()
    rising = True

    def height(self, r):
        return r**2 / 0.2

    def slope(self, r):
        return r / 0.1

    def gap(self, x):
        return x**2 / 0.1

    def gap_slope(self, x):
        return x / 0.05

    def gap_integral(self, x):
        return x**3 / 0.3


def test_a_cap_without_a_curvature_is_refused_by_name():
    capped = wk.CappedCylinder(1e-3, Curveless())
    assert capped.gap(np.array([1e-3])) == pytest.approx(1e-5, rel=1e-12)
    with pytest.raises(wk.OutsideValidity, match="the cap, Curveless, has no curvature"):
        capped.curvature(np.array([1e-4]))
