"""Flow factors of rigid gaps: grooves in closed form, Patir and Cheng's formula, and the distance that closes a map."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.problems.pressed_maps.flow_factors import flow_factors

Z = np.cos(2.0 * np.pi * (np.arange(96) + 0.5) / 96)


@pytest.mark.parametrize("periodic", [True, False])
def test_grooves(periodic):
    """Along grooves of amplitude A at H = h / A: 1 + 3 / (2 H^2); across (1 - 1/H^2)^(5/2) / (1 + 1/(2 H^2))."""
    grooves = wk.Topography(Z + np.zeros((24, 1)), [2.0, 3.0], periodic=periodic)
    found = flow_factors(grooves, [1.5, 2.0, 4.0])
    h = found.separation
    np.testing.assert_allclose(found.flow_factor, 1.0 + 1.5 / h**2, rtol=1e-10)
    np.testing.assert_allclose(
        found.lateral_flow_factor, (1.0 - 1.0 / h**2) ** 2.5 / (1.0 + 0.5 / h**2), rtol=1e-3 if periodic else 0.02
    )
    np.testing.assert_allclose(found.mean_gap, h, rtol=1e-12)
    assert found.lateral_closing_separation == pytest.approx(Z.max(), rel=1e-12)
    assert found.closing_separation == pytest.approx(Z.min(), rel=1e-12)


@pytest.mark.slow
def test_patir_and_cheng():
    """phi = 1 - 0.9 exp(-0.56 H) of isotropic Gaussian heights, and Tripp's 1 - 3 / (2 H^2) where they are small.

    N. Patir, H. S. Cheng, J. Lubr. Technol. 100 (1978) 12-17; J. H. Tripp, J. Lubr. Technol. 105 (1983) 458-465.
    """
    ratios = np.array([3.0, 6.0])
    factors = []
    for seed in range(3):
        spectrum = wk.SelfAffine(hurst=0.8, rms_height=1e-6, longest=1.2e-4, shortest=6e-5)
        rough = wk.random_topography(spectrum, (64, 64), [1e-3, 1e-3], seed=seed)
        found = flow_factors(rough, ratios * rough.rms_height)
        factors += [found.flow_factor, found.lateral_flow_factor]
        assert abs(found.closing_separation) < 0.25 * rough.rms_height  # half of it is open: self-dual
        assert np.all(np.diff(found.overlap_share) <= 0.0)
    np.testing.assert_allclose(np.mean(factors, axis=0), 1.0 - 0.9 * np.exp(-0.56 * ratios), atol=0.03)
    fine = wk.random_topography(spectrum, (160, 160), [1e-3, 1e-3], seed=0)
    found = flow_factors(fine, 12.0 * fine.rms_height)
    both = 0.5 * (found.flow_factor[0] + found.lateral_flow_factor[0])
    assert both == pytest.approx(1.0 - 1.5 / 144.0, abs=5e-4)


def test_a_dam_with_a_notch():
    """A wall along y, one high, with a notch of 0.4: the way along x closes when the mean planes come so near."""
    z = np.zeros((16, 16))
    z[8, :] = 1.0
    z[8, 5] = 0.4
    dam = wk.Topography(z, [1.0, 1.0])
    found = flow_factors(dam, [0.3, 0.45])
    mean = float(np.mean(z))
    assert found.closing_separation == pytest.approx(0.4 - mean, rel=1e-12)
    assert found.flow_factor[0] == 0.0
    assert found.flow_factor[1] > 0.0
    assert math.isclose(found.overlap_share[1], 15 / 256)


def test_bad_separations():
    rough = wk.Topography(Z + np.zeros((24, 1)), [2.0, 3.0])
    for wrong in (0.0, [1.0, np.nan], "far", [[1.0]]):
        with pytest.raises(wk.InvalidInput, match="separations must be positive numbers in m"):
            flow_factors(rough, wrong)
    with pytest.raises(wk.InvalidInput, match="1 heights are missing"):
        flow_factors(_holed(rough), [1.0])


def _holed(rough):
    heights = rough.heights.copy()
    heights[3, 3] = np.nan
    return wk.Topography(heights, rough.lengths)
