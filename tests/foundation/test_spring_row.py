"""Springs: a bed sampled at places."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

MEDIUM = wk.HalfSpace.between(wk.Elastic(2.0, 0.3), wk.Elastic(5.0, 0.2))
BED = wk.Foundation(wk.Paraboloid(1.0), MEDIUM)


def test_cells_of_equal_width():
    springs = wk.Springs.of(BED, 0.5, 10)
    np.testing.assert_allclose(springs.position, 0.05 * (np.arange(10) + 0.5), rtol=1e-14)
    np.testing.assert_allclose(springs.width, 0.05, rtol=1e-14)
    np.testing.assert_array_equal(springs.gap, BED.gap(springs.position))
    np.testing.assert_array_equal(springs.normal_stiffness, MEDIUM.modulus)
    np.testing.assert_array_equal(springs.tangential_stiffness, MEDIUM.shear_modulus)


def test_line_load():
    springs = wk.Springs.of(BED, 0.5, 10)
    load = springs.line_load(0.04)
    np.testing.assert_allclose(load, MEDIUM.modulus * np.maximum(0.04 - springs.position**2, 0.0), rtol=1e-14)
    assert not np.any(springs.line_load(0.0))
    assert not np.any(springs.line_load(-1.0))


@pytest.mark.parametrize("depth", [0.0, -1.0])
def test_no_contact(depth):
    assert wk.Springs.of(BED, 0.5, 10).force(depth) == 0.0


def test_a_flat_punch_is_exact():
    springs = wk.Springs.of(wk.Foundation(wk.FlatPunch(0.5), MEDIUM), 0.5, 7)
    assert springs.force(0.1) == pytest.approx(2.0 * MEDIUM.modulus * 0.5 * 0.1, rel=1e-14)


def test_a_wedge_is_exact():
    """A piecewise linear g, cut anywhere in a cell."""
    springs = wk.Springs.of(wk.Foundation(wk.Cone(1.2), MEDIUM), 1.0, 20)
    bed = wk.Foundation(wk.Cone(1.2), MEDIUM)
    for radius in (0.201, 0.5, 0.5249, 0.777):
        contact = wk.Indentation(bed, wk.Radius(radius)).solve()
        assert springs.force(contact.depth) == pytest.approx(contact.force, rel=1e-12)


def test_the_force_between_the_springs():
    """Wherever the edge falls in a cell; a spring that comes in makes a step of second order at most."""
    depths = np.linspace(0.02, 0.2, 2000)
    exact = 4.0 / 3.0 * MEDIUM.modulus * depths**1.5
    springs = wk.Springs.of(BED, 0.5, 50)
    forces = np.array([springs.force(d) for d in depths])
    assert np.max(np.abs(forces / exact - 1.0)) < 3e-3
    assert np.min(np.diff(forces)) > -1e-4 * exact[-1]


@pytest.mark.parametrize(("reach", "count"), [(0.0, 10), (-1.0, 10), (0.5, 0), (float("nan"), 5)])
def test_bad_numbers(reach, count):
    with pytest.raises(wk.InvalidInput, match=r"^Springs: reach is .* m and count .*; both must be positive\.$"):
        wk.Springs.of(BED, reach, count)


def test_beyond_the_bed():
    for profile in (wk.Sphere(0.4), wk.FlatPunch(0.4)):
        with pytest.raises(wk.OutsideValidity, match=r"the reach of 0.5 m is beyond the bed's, 0.4 m; give less\.$"):
            wk.Springs.of(wk.Foundation(profile, MEDIUM), 0.5, 10)
