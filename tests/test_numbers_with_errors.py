"""Numbers of the package uncertainties: refused where their error would be lost, carried through, and out of a fit."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

uncertainties = pytest.importorskip("uncertainties")


def force(young, depth, curvature_radius=10e-3):
    bed = wk.Foundation(wk.Paraboloid(curvature_radius), wk.HalfSpace(wk.Elastic(young, 0.3)))
    return wk.Indentation(bed, wk.Depth(depth)).solve().force


def test_errors_pass_through_a_contact():
    """Hertz: F is in proportion to E R^(1/2) d^(3/2), and relative errors add as squares."""
    young, radius = uncertainties.ufloat(210e9, 5e9), uncertainties.ufloat(10e-3, 1e-4)
    depth = uncertainties.ufloat(1e-6, 1e-8)
    found = uncertainties.wrap(force)(young, depth, radius)
    parts = np.array([5.0 / 210.0, 1.5 * 0.01, 0.5 * 0.01])
    assert found.nominal_value == force(210e9, 1e-6)
    assert found.std_dev / found.nominal_value == pytest.approx(np.sqrt(np.sum(parts**2)), rel=1e-6)
    assert (found / young).std_dev / (found / young).nominal_value == pytest.approx(np.hypot(*parts[1:]), rel=1e-6)


def test_where_the_error_would_be_lost_it_is_refused():
    with pytest.raises(
        wk.InvalidInput, match=r"young is .*, whose uncertainty would be lost; give .* uncertainties.wrap"
    ):
        force(uncertainties.ufloat(210e9, 5e9), 1e-6)


def test_a_fit_gives_numbers_with_errors_and_correlations():
    """The error of a force that the fit predicts, by the covariance of its numbers: gradient, matrix, gradient."""
    depth = np.linspace(-2e-7, 1e-6, 200)
    true = np.where(depth > 0.0, force(20e3, np.maximum(depth, 1e-12)), 0.0)
    noise = 2e-3 * true.max() * np.random.default_rng(1).normal(size=depth.size)
    curve = wk.ForceCurve(depth, true + noise)
    bed = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace(wk.Elastic(10e3, 0.3)))
    found = wk.fit(curve, wk.Indentation(bed, wk.Depth(0.0)), free=("bed.medium.first.young", "contact_point"))
    pairs = list(zip(found.values, found.standard_errors, strict=True))
    young, touch = uncertainties.correlated_values_norm(pairs, found.correlation)
    assert young.nominal_value == found.values[0]
    assert young.std_dev == pytest.approx(found.standard_errors[0], rel=1e-12)
    assert uncertainties.correlation_matrix([young, touch])[0, 1] == pytest.approx(found.correlation[0, 1], rel=1e-9)
    ahead = uncertainties.wrap(force)(young, 5e-7 - touch)
    gradient = ahead.nominal_value * np.array([1.0 / young.nominal_value, -1.5 / (5e-7 - touch.nominal_value)])
    covariance = found.correlation * np.outer(found.standard_errors, found.standard_errors)
    assert ahead.std_dev == pytest.approx(np.sqrt(gradient @ covariance @ gradient), rel=1e-5)
