"""Seed Eqs. (1) and (2): displacements by superposed point forces agree with the closed forms to 1e-10."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import beta, ellipe

from winkler.reference import cone, hertz, power, punch, truncated
from winkler.reference.point_forces import displacement, point_force_displacement

R = np.array([0.0, 1e-9, 1e-3, 0.3, 0.5, 0.7, 0.999, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.001, 1.5, 10.0, 100.0])
A, MODULUS = 0.3, 2.5

PAIRS = {
    "hertz": (
        lambda s: hertz.hertz_pressure(s, A, curvature_radius=0.8, modulus=MODULUS),
        lambda r: hertz.hertz_displacement(r, A, curvature_radius=0.8),
    ),
    "cone": (
        lambda s: cone.cone_pressure(s, A, half_angle=1.2, modulus=MODULUS),
        lambda r: cone.cone_displacement(r, A, half_angle=1.2),
    ),
    "flat punch": (
        lambda s: punch.flat_punch_pressure(s, A, depth=0.02, modulus=MODULUS),
        lambda r: punch.flat_punch_displacement(r, A, depth=0.02),
    ),
    "power law": (
        lambda s: power.power_law_pressure(s, A, coefficient=0.4, exponent=3.7, modulus=MODULUS),
        lambda r: power.power_law_displacement(r, A, coefficient=0.4, exponent=3.7),
    ),
    "pinned": (
        lambda s: (
            hertz.hertz_pressure(s, A, curvature_radius=0.8, modulus=MODULUS)
            + punch.flat_punch_pressure(s, A, depth=0.02, modulus=MODULUS)
        ),
        lambda r: (
            hertz.hertz_displacement(r, A, curvature_radius=0.8) + punch.flat_punch_displacement(r, A, depth=0.02)
        ),
    ),
}


@pytest.mark.parametrize("name", PAIRS)
def test_superposition_gives_the_closed_form(name):
    pressure, expected = PAIRS[name]
    np.testing.assert_allclose(displacement(pressure, A, A * R, MODULUS), expected(A * R), rtol=1e-11)


def test_a_kinked_shape_needs_its_break():
    numbers = {"curvature_radius": 0.8, "flat_radius": 0.1}

    def pressure(s):
        return truncated.truncated_paraboloid_pressure(s, A, modulus=MODULUS, **numbers)

    expected = truncated.truncated_paraboloid_displacement(A * R, A, **numbers)
    np.testing.assert_allclose(displacement(pressure, A, A * R, MODULUS, breaks=[0.1]), expected, rtol=1e-10)
    without = displacement(pressure, A, A * R, MODULUS)
    assert np.max(np.abs(without / expected - 1.0)) > 1e-6


def test_a_pressure_written_carelessly():
    """1/sqrt(a^2 - s^2) loses its digits near the edge when s is rounded; the result retains ten."""
    given = displacement(lambda s: 1.0 / np.pi / np.sqrt(1.0 - s**2), 1.0, R, 1.0)
    np.testing.assert_allclose(given, punch.flat_punch_displacement(R, 1.0, depth=1.0), rtol=1e-10)


@pytest.mark.parametrize(("edge", "tolerance"), [(0.0, 1e-12), (-0.5, 1e-10)])
def test_uniform_pressure(edge, tolerance):
    """Love: u = (4 p a/(pi E*)) E(r^2/a^2) inside."""
    r = A * R[R <= 1.0]
    given = displacement(lambda s: np.full_like(s, 3.0), A, r, MODULUS, edge=edge)
    np.testing.assert_allclose(given, 12.0 * A / (np.pi * MODULUS) * ellipe((r / A) ** 2), rtol=tolerance)


@pytest.mark.parametrize("edge", [-0.7, -0.3, 0.3])
def test_any_power_at_the_edge(edge):
    """At the centre u = (2/E*) Int p ds, a beta function."""
    given = displacement(lambda s: ((1.0 - s) * (1.0 + s)) ** edge, 1.0, 0.0, MODULUS, edge=edge)
    assert float(given) == pytest.approx(beta(0.5, edge + 1.0) / MODULUS, rel=1e-11)


def test_far_away_the_disc_is_a_point():
    force = 4.0 * MODULUS * A**3 / (3.0 * 0.8)
    far = displacement(PAIRS["hertz"][0], A, np.array([1e4 * A]), MODULUS)
    np.testing.assert_allclose(far, point_force_displacement(force, 1e4 * A, modulus=MODULUS), rtol=1e-8)


def test_shape_of_the_answer():
    assert displacement(PAIRS["hertz"][0], A, 0.1, MODULUS).shape == ()
    assert displacement(PAIRS["hertz"][0], A, [[0.1, 0.2]], MODULUS).shape == (1, 2)
