"""Tables of the load profile agree with its integrals."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest

import winkler as wk
from winkler.profiles.line_transform import line_load, line_load_slope

QUARTIC = wk.Formula("r**2/0.02 + r**4/8e-6")
PROFILES = [wk.Sphere(0.01), wk.Ellipsoid(0.01, 0.02), wk.Hyperboloid(0.01, 1.0), QUARTIC]


@pytest.mark.few(2)
@pytest.mark.parametrize("profile", PROFILES, ids=lambda profile: type(profile).__name__)
@pytest.mark.parametrize("function", [line_load, line_load_slope])
def test_many_places_agree_with_single_ones(function, profile):
    """Few places are integrals, many come from tables: from the apex up to the wall of a sphere."""
    top = min(profile.reach, 0.02)
    a = top * np.concatenate([np.geomspace(1e-9, 0.8, 40), 1.0 - np.geomspace(1e-5, 0.2, 20)])
    single = np.concatenate([function(profile, a[start : start + 4]) for start in range(0, 60, 4)])
    np.testing.assert_allclose(function(profile, a), single, rtol=2e-13)
    square = a.reshape(6, 10)
    np.testing.assert_array_equal(function(profile, square), function(profile, a).reshape(6, 10))
    with_apex = function(profile, np.append(0.0, a))
    assert with_apex[0] == 0.0
    np.testing.assert_array_equal(with_apex[1:], function(profile, a))


def test_many_places_of_a_sphere():
    """w is the integral of x f'(x)/sqrt(a^2 - x^2), f' = x/sqrt(R^2 - x^2), at 30 digits."""
    places = 0.01 * np.linspace(0.02, 0.99, 50)
    found = line_load(wk.Sphere(0.01), places)
    for index in (0, 20, 45, 49):
        with mp.workdps(30):
            a, radius = mp.mpf(float(places[index])), mp.mpf(0.01)
            integral = mp.quad(
                lambda angle, a=a, radius=radius: (
                    (a * mp.sin(angle)) ** 2 / mp.sqrt(radius**2 - (a * mp.sin(angle)) ** 2)
                ),
                [0, mp.pi / 4, mp.pi / 2],
            )
        assert found[index] == pytest.approx(float(integral), rel=1e-13)


def test_a_load_profile_that_changes_its_sign_is_integrated():
    """A trough in the profile: w' is negative there, and has no logarithm."""
    dent = wk.Formula("r**2/0.02 - 0.6*r**4/1e-6 + r**6/8e-12", reach=6e-3)
    a = np.linspace(1e-4, 5e-3, 60)
    single = np.concatenate([line_load_slope(dent, a[start : start + 4]) for start in range(0, 60, 4)])
    scale = np.max(np.abs(single))
    np.testing.assert_allclose(line_load_slope(dent, a), single, rtol=0.0, atol=1e-13 * scale)
