"""The plane profile of a measured bed under another medium."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.foundation.measured import MeasuredBed
from winkler.foundation.measured_profile import MeasuredPlaneProfile
from winkler.foundation.plane import PlaneFoundation
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace

UNIT = HalfSpace(Elastic(1.0, 0.0))
RADII = np.geomspace(0.05, 0.5, 9)


@pytest.mark.parametrize("power", [1.3, 2.0, 4.0])
def test_a_power_is_met_with_its_derivatives(power):
    profile = MeasuredPlaneProfile(MeasuredBed(RADII, 2.0 * RADII, RADII**power))
    x = np.array([0.01, 0.07, 0.2, 0.49])
    assert profile.height(x) == pytest.approx(x**power, rel=1e-10)
    assert profile.slope(x) == pytest.approx(power * x ** (power - 1.0), rel=1e-10)
    assert profile.curvature(x) == pytest.approx(power * (power - 1.0) * x ** (power - 2.0), rel=1e-8)
    assert profile.reach == 0.5
    assert profile.rising


def test_nothing_bends_under_a_flat_end():
    bed = MeasuredBed(RADII, 2.0 * RADII, (RADII - RADII[0]) ** 2)
    assert bed.gap_bend(np.array([0.04, 0.3])) == pytest.approx([0.0, 2.0], rel=1e-6)


def test_the_bed_bears_on_the_half_space_what_was_measured():
    bed = MeasuredBed(RADII, 2.0 * RADII, RADII**2)
    again = PlaneFoundation(MeasuredPlaneProfile(bed), UNIT)
    radius = np.array([0.1, 0.3, 0.5])
    assert again.gap_load(radius) == pytest.approx(2.0 * radius**3 / 3.0, rel=1e-6)
    assert again.notes[-2:] == bed.notes
