"""Fits with pyramids: curves by published constants, by boundary elements of the test, sticky and relaxing models."""

import math

import numpy as np
import pytest
from relaxing_curves import FIRST
from synthetic import noise

import winkler as wk

PATH = "bed.medium.first.young"
YOUNG, POISSON, TANGENT = 1e4, 0.5, math.tan(math.radians(35.0))
MODULUS = YOUNG / (1.0 - POISSON**2)
FREE = [PATH, "contact_point", "baseline"]
# F / (E* tan(theta) d^2) of four faces: ContactMechanics (shared data), and of three: the boundary elements of
# tests/profiles/pyramids
PUBLISHED = {3: 0.88241, 4: 0.737617}


def bed(tip, young=3e4):
    return wk.Foundation(tip, wk.HalfSpace.between(wk.Elastic(young, POISSON)))


def curve(force, seed=1, level=3e-11):
    position = np.linspace(-1e-6, 1e-6, 600)
    random = np.random.default_rng(seed)
    return wk.ForceCurve(position + 2e-6, force(np.maximum(position, 0.0)) + level * noise(random, 600, 0.0))


@pytest.mark.parametrize("sides", [3, 4])
def test_curves_of_pyramids(sides):
    measured = curve(lambda d: PUBLISHED[sides] * MODULUS * TANGENT * d**2)
    found = wk.fit(measured, wk.Indentation(bed(wk.Pyramid(sides, math.radians(35.0))), wk.Depth(0.0)), free=FREE)
    assert abs(found.value(PATH) - YOUNG) < 3.5 * found.error(PATH)
    clean = curve(lambda d: PUBLISHED[sides] * MODULUS * TANGENT * d**2, level=1e-14)
    exact = wk.fit(clean, wk.Indentation(bed(wk.Pyramid(sides, math.radians(35.0))), wk.Depth(0.0)), free=FREE)
    assert exact.value(PATH) == pytest.approx(YOUNG, rel=3e-5)  # a bias of 0.003 %
    assert any("pyramid" in note.statement for note in exact.validity)


@pytest.mark.parametrize(("sides", "bias"), [(3, 0.0778), (4, 0.0268)])
def test_equal_area_cones_are_biased(sides, bias):
    """What the cone of equal cross-section, which was all there was, makes of the same curve."""
    clean = curve(lambda d: PUBLISHED[sides] * MODULUS * TANGENT * d**2, level=1e-14)
    cone = wk.Cone(math.atan(math.sqrt(sides * math.tan(math.pi / sides) / math.pi) * TANGENT))
    found = wk.fit(clean, wk.Indentation(bed(cone), wk.Depth(0.0)), free=FREE)
    assert found.value(PATH) / YOUNG - 1.0 == pytest.approx(bias, abs=2e-4)


# F / (E* R^2 / tan^3) of rounded pyramids at depths in R / tan^2, by boundary elements, extrapolated
ROUNDED = {
    3: [(0.2, 0.119257), (0.5, 0.478583), (0.946709, 1.340148), (1.792326, 4.000148), (3.39346, 12.589222),
        (6.424926, 41.364378), (12.164400, 140.404760), (23.031077, 487.302798)],
    4: [(0.2, 0.119257), (0.5, 0.471404), (0.935058, 1.223715), (1.748703, 3.388638), (3.270243, 10.087790),
        (6.115803, 31.824635), (11.437238, 104.582556), (21.389032, 352.818801)],
}  # fmt: skip


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("sides", [3, 4])
def test_blunt_pyramids_by_boundary_elements(sides):
    """Modulus and radius of the apex together, from a spline through the forces of the elements."""
    from scipy.interpolate import CubicSpline

    depth, force = np.array(ROUNDED[sides]).T
    radius = 0.04e-6
    unit = radius / TANGENT**2
    smooth = CubicSpline(np.log(depth), np.log(force))

    def blunt(d):
        scaled = np.maximum(d / unit, 1e-12)
        hertz = 4.0 / 3.0 * scaled**1.5
        return (
            MODULUS
            * unit
            * radius
            / TANGENT
            * np.where(scaled < 0.2, hertz, np.exp(smooth(np.log(np.clip(scaled, 0.2, 23.0)))))
        )

    measured = curve(blunt, level=1e-13)
    assert 10.0 < 1e-6 / unit < 23.0
    tip = wk.RoundedPyramid(sides, math.radians(35.0), 0.1e-6)
    apex = "bed.profile.curvature_radius"
    found = wk.fit(measured, wk.Indentation(bed(tip), wk.Depth(0.0)), free=[*FREE, apex])
    assert found.value(PATH) == pytest.approx(YOUNG, rel=1e-3)
    assert found.value(apex) == pytest.approx(radius, rel=0.02)


@pytest.mark.slow
def test_sticky_pyramids_are_fitted_as_cones():
    """JKR's cone, closed form: the pyramid's equivalent cone, and its modulus and work come back."""
    theta = math.atan(0.5 * math.pi * PUBLISHED[4] * TANGENT)
    slope, work = 1.0 / math.tan(theta), 1e-4
    radius = np.linspace(0.02e-6, 1.4e-6, 4000)
    pull = np.sqrt(2.0 * math.pi * radius * work / MODULUS)
    depth = 0.5 * math.pi * slope * radius - pull
    force = 0.5 * math.pi * MODULUS * slope * radius**2 - 2.0 * MODULUS * radius * pull
    position = np.linspace(-1e-6, 1e-6, 400)
    first = int(np.argmin(depth))
    there = np.where(position > 0.0, np.interp(position, depth[first:], force[first:]), 0.0)
    back = np.where(position > depth[first], np.interp(position, depth[first:], force[first:]), 0.0)
    random = np.random.default_rng(2)
    measured = wk.ForceCurve(
        np.r_[position, position[::-1]] + 2e-6, np.r_[there, back[::-1]] + 1e-12 * random.standard_normal(800)
    )
    from winkler.problems.adhesion.indentation import AdhesiveIndentation

    model = AdhesiveIndentation(bed(wk.Pyramid(4, math.radians(35.0))), wk.ShortRange(2e-4), wk.Depth(0.0))
    found = wk.fit(measured, model, free=[*FREE, "law.work"])
    assert found.value(PATH) == pytest.approx(YOUNG, rel=1e-3)
    assert found.value("law.work") == pytest.approx(work, rel=5e-3)


def test_relaxing_bodies_under_pyramids():
    """A standard solid, held: F = C tan(theta) E*(t) d^2 after a fast approach; Boltzmann's integral in closed form."""
    time = np.linspace(-0.2, 2.0, 160)
    rise, depth, glassy, relaxed, tau = 0.5, 1e-6, 4e3, 1e3, 0.4
    moved = depth / rise * np.clip(time, 0.0, rise)

    # F = C tan * 4 G(t - s) d(d^2), d = v s: the integral of s and of s exp(-(t - s) / tau) up to the end of the rise
    end = np.clip(time, 0.0, rise)
    fading = tau * (end - tau) * np.exp((end - time) / tau) + tau**2 * np.exp(-np.maximum(time, 0.0) / tau)
    speed = depth / rise
    hard = 2.0 * speed**2 * (relaxed * end**2 / 2.0 + (glassy - relaxed) * fading)
    force = np.where(time > 0.0, PUBLISHED[3] * TANGENT * 4.0 * hard, 0.0)
    random = np.random.default_rng(3)
    measured = wk.ForceCurve(
        np.where(time < 0.0, depth / rise * time, moved) + 2e-6, force + 1e-12 * random.standard_normal(160), time=time
    )
    solid = wk.Prony(2e3, [2e3], [1.0])
    tip = wk.Foundation(wk.Pyramid(3, math.radians(35.0)), wk.ViscoelasticHalfSpace(solid))
    model = wk.ViscoelasticIndentation(tip, wk.Path([0.0], wk.Depth(0.0)))
    free = [f"{FIRST}relaxed_shear", f"{FIRST}shears", f"{FIRST}relaxation_times", "contact_point", "baseline"]
    found = wk.fit(measured, model, free=free)
    assert found.value(f"{FIRST}relaxed_shear") == pytest.approx(relaxed, rel=1e-3)
    assert any("The pyramid of 3 faces" in note.statement for note in found.validity)
