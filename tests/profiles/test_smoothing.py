"""Noise: what smoothing leaves of it, against what least squares must leave; and that it is stated."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import BSpline

import winkler as wk

UNIT = wk.HalfSpace.between(wk.Elastic(1.0, 0.0))
REACH = 1.0
SEEDS = range(12)


def noisy(twin, count, noise, seed, spacing="random"):
    generator = np.random.default_rng(seed)
    r = generator.uniform(0.0, REACH, count) if spacing == "random" else np.linspace(0.0, REACH, count)
    r[0] = 0.0
    return wk.Measured(r, twin.height(r) + noise * generator.normal(size=count))


def expected_scatter_of_force(profile, radius, noise):
    """Standard deviation of F at fixed depth, by the covariance of least squares on the same knots.

    A small change of the shape moves the force by dF = -2 E* Int_0^a df r / sqrt(a^2 - r^2) dr, linear in the spline's
    coefficients, whose covariance is noise^2 (X'X)^-1.  No random numbers, none of the package's algebra.
    """
    knots = np.concatenate([np.zeros(3), profile.curve.knots, np.full(3, profile.curve.knots[-1])])
    design = BSpline.design_matrix(profile.radii, knots, 3).toarray()
    angle = (np.arange(4000) + 0.5) / 4000.0 * 0.5 * np.pi
    r = radius * np.sin(angle)
    basis = BSpline(knots, np.eye(design.shape[1]), 3)
    weight = r * (0.5 * np.pi / angle.size)
    response = weight @ (basis(r) - basis(0.0))
    covariance = np.linalg.inv(design.T @ design)
    return 2.0 * noise * float(np.sqrt(response @ covariance @ response))


def compared(twin, radius):
    a = np.array([radius])
    depth = float(twin.gap(a)[0])
    return depth, 2.0 * (radius * depth - float(twin.gap_integral(a)[0]))


@pytest.mark.few(1)
@pytest.mark.parametrize(("count", "noise"), [(200, 1e-3), (1000, 1e-3), (1000, 1e-2)])
def test_a_shape_the_spline_can_hold(count, noise):
    """Paraboloid: the error of F(d) is within 3.5 standard deviations of least squares for every seed."""
    twin, ratios, pieces = wk.Paraboloid(1.0), [], []
    for seed in SEEDS:
        profile = noisy(twin, count, noise, seed)
        pieces.append(profile.curve.pieces)
        for radius in (0.3, 0.6, 0.9):
            depth, force = compared(twin, radius)
            got = wk.Indentation(wk.Foundation(profile, UNIT), wk.Depth(depth)).solve().force
            ratios.append((got - force) / expected_scatter_of_force(profile, radius, noise))
    ratios = np.array(ratios)
    assert np.max(np.abs(ratios)) < 3.5
    assert 0.1 < np.sqrt(np.mean(ratios**2)) < 1.3
    assert np.median(pieces) == 1.0  # as stiff as the data require


@pytest.mark.few(1)
@pytest.mark.parametrize(
    ("twin", "count", "noise"),
    [(wk.Sphere(1.2), 400, 1e-3), (wk.Hyperboloid(0.2, 1.2), 2000, 1e-4), (wk.RoundedCone(0.3, 1.2), 2000, 1e-3)],
)
def test_a_shape_the_spline_must_follow(twin, count, noise):
    """Bias and scatter together stay within 6 standard deviations of the least-squares scatter."""
    ratios = []
    for seed in range(6):
        profile = noisy(twin, count, noise, seed)
        for radius in (0.4, 0.8):
            depth, force = compared(twin, radius)
            got = wk.Indentation(wk.Foundation(profile, UNIT), wk.Depth(depth)).solve().force
            ratios.append((got - force) / expected_scatter_of_force(profile, radius, noise))
    assert np.max(np.abs(ratios)) < 6.0


@pytest.mark.slow
def test_more_points_help():
    """Ten thousand points beat a hundred by about the root of their number."""
    twin = wk.Sphere(1.2)
    depth, force = compared(twin, 0.5)

    def error(count):
        profiles = [noisy(twin, count, 1e-3, seed) for seed in range(6)]
        forces = [wk.Indentation(wk.Foundation(p, UNIT), wk.Depth(depth)).solve().force for p in profiles]
        return float(np.sqrt(np.mean((np.array(forces) / force - 1.0) ** 2)))

    few, many = error(100), error(10_000)
    assert many < 0.4 * few
    assert many < 5e-3


def test_the_smoothing_is_stated():
    profile = noisy(wk.Paraboloid(1.0), 500, 2e-3, 0)
    (note,) = profile.notes
    assert note.standing is wk.Standing.APPROXIMATE
    assert "The 500 points were smoothed by a cubic spline of" in note.statement
    assert "generalised cross-validation" in note.source
    # the stated scatter is that of the noise
    stated = float(note.statement.split("about it by ")[1].split(" m ")[0])
    assert stated == pytest.approx(2e-3, rel=0.1)
    bed = wk.Foundation(profile, UNIT)
    assert note in wk.Indentation(bed, wk.Depth(0.1)).solve().validity


def test_few_noisy_points_are_not_interpolated():
    """A spline through noise would fall between points; the smoothed one rises."""
    profile = noisy(wk.Paraboloid(1.0), 120, 3e-3, 1, spacing="even")
    assert not profile.curve.through
    assert profile.rising
    x = np.array([0.5])
    assert profile.gap(x)[0] == pytest.approx(0.25, rel=0.05)


def test_noise_does_not_count_as_falling():
    """Near a flat apex noisy heights fall here and there; within the scatter that is no reason to refuse."""
    for seed in SEEDS:
        profile = noisy(wk.PowerLaw(1.0, 4.0), 300, 3e-3, seed)
        depth, force = compared(wk.PowerLaw(1.0, 4.0), 0.9)
        got = wk.Indentation(wk.Foundation(profile, UNIT), wk.Depth(depth)).solve().force
        assert got == pytest.approx(force, rel=0.03)
