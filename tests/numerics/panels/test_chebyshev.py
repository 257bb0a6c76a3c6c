"""Functions on panels: evaluation, derivative, integral, and when they are refused."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.values.errors import NotConverged

X = np.linspace(0.0, 3.0, 1001)


def test_panels_are_what_they_say():
    """T0 + 2 T1 on (0, 1), T2 on (1, 3)."""
    panels = Panels(np.array([0.0, 1.0, 3.0]), np.array([[1.0, 2.0, 0.0], [0.0, 0.0, 1.0]]))
    t = np.where(X < 1.0, 2.0 * X - 1.0, X - 2.0)
    np.testing.assert_allclose(panels(X), np.where(X < 1.0, 1.0 + 2.0 * t, 2.0 * t**2 - 1.0), atol=1e-15)
    np.testing.assert_allclose(panels.derivative(X), np.where(X < 1.0, 4.0, 4.0 * t), atol=1e-14)
    assert panels(np.array([[0.25], [2.0]])).shape == (2, 1)
    assert float(panels(np.array(2.0))) == pytest.approx(-1.0)


def test_the_integral_is_continuous_and_starts_at_zero():
    panels = Panels(np.array([0.0, 1.0, 3.0]), np.array([[1.0, 2.0, 0.0], [0.0, 0.0, 1.0]]))
    total = panels.integral
    t = X - 2.0
    expected = np.where(X < 1.0, 2.0 * X**2 - X, 1.0 + 2.0 / 3.0 * t**3 - t + 2.0 / 3.0 - 1.0)
    np.testing.assert_allclose(total(X), expected, atol=1e-15)
    assert float(total(np.array(0.0))) == pytest.approx(0.0, abs=1e-16)
    np.testing.assert_allclose(total.derivative(X), panels(X), atol=1e-14)


@pytest.mark.parametrize(
    "function",
    [np.sin, np.exp, lambda x: np.cos(40.0 * x), lambda x: x**2.5, lambda x: 1.0 / (0.01 + (x - 1.234) ** 2)],
)
def test_fitted_to_the_tolerance(function):
    scale = np.max(np.abs(function(X)))
    panels = fit_panels(function, np.array([0.0, 3.0]), 1e-11 * scale)
    assert np.max(np.abs(panels(X) - function(X))) <= 3e-11 * scale


def test_a_looser_tolerance_needs_fewer_panels_and_keeps_it():
    counts = []
    for tolerance in (1e-3, 1e-7, 1e-12):
        panels = fit_panels(lambda x: np.cos(60.0 * x), np.array([0.0, 3.0]), tolerance)
        assert np.max(np.abs(panels(X) - np.cos(60.0 * X))) < 3.0 * tolerance
        counts.append(panels.edges.size)
    assert counts == sorted(counts)
    assert counts[0] < counts[-1]


def test_a_jump_inside_a_panel_is_narrowed_down():
    panels = fit_panels(lambda x: np.where(x < 1.0, 0.0, 1.0), np.array([0.0, 3.0]), 1e-10)
    away = np.abs(X - 1.0) > 1e-6
    np.testing.assert_allclose(panels(X)[away], np.where(X < 1.0, 0.0, 1.0)[away], atol=1e-10)


def test_a_function_too_rough_is_refused():
    generator = np.random.default_rng(0)
    with pytest.raises(NotConverged, match="more than 4096 panels"):
        fit_panels(lambda x: generator.normal(size=x.shape), np.array([0.0, 3.0]), 1e-9)
