"""Rounded punches and cut, worn or sharpened paraboloids against quadrature of T1 at 30 digits."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from shape_solutions import assert_curvature, assert_starts_at_zero, assert_transforms

import winkler as wk

B, R = 2e-4, 3e-3
X = B * np.array([1e-3, 0.5, 1.0 - 1e-9, 1.0 + 1e-9, 1.0 + 1e-5, 1.01, 1.5, 10.0])


def test_rounded_punch():
    big, b = mp.mpf(R), mp.mpf(B)

    def slope(r):
        return max(r - b, mp.mpf(0)) / big

    assert_transforms(wk.RoundedPunch(B, R), slope, X, (B,))
    assert_curvature(wk.RoundedPunch(B, R), slope, X[[0, 1, 5, 6]])
    assert_starts_at_zero(wk.RoundedPunch(B, R))


def test_truncated_paraboloid():
    profile = wk.TruncatedParaboloid(R, B)
    assert_transforms(profile, lambda r: r / mp.mpf(R) if r > B else mp.mpf(0), X, (B,))
    assert profile.kinks == ((B, pytest.approx(B / R)),)


@pytest.mark.few(1)
@pytest.mark.parametrize("cap", [1e-4, 0.5 * R, R, 7.0 * R, 1e9])
def test_capped_paraboloid(cap):
    profile = wk.CappedParaboloid(R, cap, B)
    assert_transforms(profile, lambda r: r / mp.mpf(R if r > B else cap), X, (B,))
    assert profile.kinks == ((B, pytest.approx(B / R - B / cap)),)
    assert profile.rising == (cap >= R)


def test_limits():
    """A flatter and flatter cap cuts the tip off; an equal one is no cap; a vanishing one leaves the paraboloid."""
    flattest = wk.CappedParaboloid(R, 1e30, B)
    np.testing.assert_allclose(flattest.gap(X), wk.TruncatedParaboloid(R, B).gap(X), rtol=1e-14, atol=1e-30)
    np.testing.assert_allclose(wk.CappedParaboloid(R, R, B).gap(X), wk.Paraboloid(R).gap(X), rtol=1e-15)
    tiny = wk.TruncatedParaboloid(R, 1e-12)
    np.testing.assert_allclose(tiny.gap(X[1:]), wk.Paraboloid(R).gap(X[1:]), rtol=1e-13)
    small = wk.RoundedPunch(1e-15, R)
    np.testing.assert_allclose(small.gap(X[1:]), wk.Paraboloid(R).gap(X[1:]), rtol=1e-10)


def test_theory_sheet_numbers():
    """R = 1, b = 0.2, a = 0.5, and the cone of slope 0.1 with the same flat."""
    a = np.array([0.5])
    for profile, depth, force in (
        (wk.RoundedPunch(0.2, 1.0), 0.113200836675051, 0.0886784482022164),
        (wk.TruncatedCone(math.atan(10.0), 0.2), 0.0579639740363704, 0.0381471384080969),
    ):
        assert profile.gap(a)[0] == pytest.approx(depth, rel=1e-13)
        assert 2.0 * (0.5 * profile.gap(a) - profile.gap_integral(a))[0] == pytest.approx(force, rel=1e-13)


@pytest.mark.parametrize("bad", [0.0, -1.0, math.nan, math.inf])
@pytest.mark.parametrize(
    ("cls", "words"),
    [
        (wk.RoundedPunch, ("flat_radius", "edge_radius")),
        (wk.TruncatedParaboloid, ("curvature_radius", "flat_radius")),
        (wk.CappedParaboloid, ("curvature_radius", "cap_curvature_radius", "cap_radius")),
    ],
)
def test_bad_lengths(cls, words, bad):
    for word in words:
        numbers = dict.fromkeys(words, 1.0) | {word: bad}
        with pytest.raises(
            wk.InvalidInput,
            match=rf"^{cls.__name__}: {word} is .*; it must be a positive, finite "
            r"number in m\.$",
        ):
            cls(**numbers)
