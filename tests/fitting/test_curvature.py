"""Intervals of curved models: the ends of the profile likelihood where the quadratic interval is wrong."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from synthetic import hertz, noise

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.fitting.intervals import profile_interval

PATH, R = "bed.medium.first.young", 5e-6


def shallow(level, count=200):
    """Mostly free travel, and a last tenth in contact."""
    position = np.linspace(-9e-7, 1e-7, count)
    force = hertz(position, 1e4 / 0.75, R) + level * noise(np.random.default_rng(7), count)
    bed = wk.Foundation(wk.Paraboloid(R), wk.HalfSpace.between(wk.Elastic(3e4, 0.5)))
    return fit(
        ForceCurve(position, force), wk.Indentation(bed, wk.Depth(0.0)), free=[PATH, "contact_point", "baseline"]
    )


def test_a_precise_curve_is_as_good_as_linear():
    found = shallow(1e-12)
    assert np.all(found.stretches == 1.0)
    error = found.quantile(0.95, PATH) * found.error(PATH) / found.value(PATH)
    assert found.interval(PATH) == pytest.approx(found.value(PATH) * np.exp([-error, error]), rel=1e-12)


def test_a_noisy_curve_has_an_uneven_interval():
    """A modulus known to a quarter: profiles, in which all others are fitted again, end where the interval does."""
    found = shallow(3e-10)
    assert np.all(found.stretches[:2, 0] > 1.1 * found.stretches[:2, 1] - 0.05)
    assert found.stretches[1, 0] > 1.2
    plain = dataclasses.replace(found, stretches=np.ones((3, 2)))
    for name in (PATH, "contact_point"):
        profile = np.array(profile_interval(found, name))
        ends, quadratic = np.array(found.interval(name)), np.array(plain.interval(name))
        width = float(np.diff(profile)[0])
        assert np.abs(ends - profile).max() < 0.05 * width
        assert np.abs(ends - profile).sum() < 1.1 * np.abs(quadratic - profile).sum()


def test_a_stretch_is_that_of_the_reference_width():
    """At two standard errors the stated stretch; less for narrower intervals, more for wider ones."""
    found = shallow(1e-12)
    bent = dataclasses.replace(found, stretches=np.array([[0.8, 1.5], [1.0, 1.0], [1.0, 1.0]]))
    value, error = found.value(PATH), found.error(PATH) / found.value(PATH)
    for confidence in (0.5, 0.95, 0.999):
        width = found.quantile(confidence, PATH)
        ends = np.log(np.array(bent.interval(PATH, confidence)) / value) / error / width
        power = min(width / 2.0, 1.5)  # not extrapolated beyond three standard errors
        np.testing.assert_allclose(ends, [-(0.8**power), 1.5**power], rtol=1e-6)
