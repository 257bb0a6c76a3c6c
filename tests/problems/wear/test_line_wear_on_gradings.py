"""Lines that wear on gradings: other routes, half-planes as limits, the depth, layers, refinement, ghosts."""

from __future__ import annotations

import functools

import numpy as np
import pytest
from graded_ghost import Ghost
from half_plane_wear import WornCylinder
from scipy.interpolate import CubicSpline
from slip_of_gradings import SlippingOnGrading, compliance
from wear_on_layers import WornOnLayers

import winkler as wk

MU, NU = 0.4, 0.3
YOUNG = 1.0 - NU**2
"""E* = 1 of the surface under a rigid body."""
CYLINDER = wk.Paraboloid(1.0)
LONGEST = 3e2
"""Wave numbers of the elements, over the inverse of the depth scale: M / k^2 is nothing beyond."""


def young(contrast):
    return lambda z: YOUNG * (contrast + (1.0 - contrast) * np.exp(-z))


def graded(contrast, scale=1.0):
    grading = wk.ExponentialGrading(YOUNG, contrast * YOUNG, depth_scale=scale, poisson=NU)
    return wk.LayeredLineFoundation(CYLINDER, wk.DepthGradedHalfSpace(grading))


def plain(share=1.0):
    return wk.LineFoundation(CYLINDER, wk.HalfSpace(wk.Elastic(share * YOUNG, NU)))


def force(bed, half_width=1.0):
    return bed.medium.modulus * float(bed.load_profile(np.array([half_width]))[0])


def fretting(bed, load, swing, cycles, **given):
    rig = {"wear": wk.Archard(1.0), "count": 60} | given
    return wk.LineFrettingWear(
        bed, law=wk.Coulomb(MU), normal=wk.LineForce(load), amplitude=wk.LineShearForce(swing), cycles=cycles, **rig
    )


def limiting(bed, load, swing):
    return wk.LineLimitingProfile(bed, wk.Coulomb(MU), wk.LineForce(load), wk.LineShearForce(swing)).solve()


def sliding(bed, load, distance, **given):
    return wk.LineSlidingWear(
        bed, normal=wk.LineForce(load), distance=distance, **({"wear": wk.Archard(1.0), "count": 60} | given)
    )


@functools.cache
def by_equations(contrast, a):
    """With more places of the equation where the depth is stiff and far away."""
    return SlippingOnGrading(young(contrast), NU, 25.0, a, 0.7 * a, 160 if contrast * a < 4.0 else 640)


class WornOnGrading(WornOnLayers):
    """Elements on a grading, with the wave compliances from Riccati's equation."""

    def __init__(self, contrast, edges, load, half_width):
        WornCylinder.__init__(self, edges, load, MU)
        self.touching = self.x < half_width
        places = np.append(0.0, np.geomspace(1e-2, LONGEST, 60))
        found = [compliance(young(contrast), NU, 25.0, max(k, 1e-6)) for k in places]
        step = min(0.1, 1.0 / edges[-1])
        ends = np.concatenate([[0.0], step * 2.0 ** -np.arange(9.0, 0.0, -1.0), np.arange(step, LONGEST, 4.0 * step)])
        node, weight = np.polynomial.legendre.leggauss(12)
        k = (ends[:-1, None] + np.diff(ends)[:, None] * 0.5 * (node + 1.0)).ravel()
        weights = (0.5 * np.diff(ends)[:, None] * weight).ravel()
        shares = -0.5 * np.array([[y[1, 1], y[0, 0]] for y in found]) - 1.0
        normal, along = (
            CubicSpline(np.log1p(1e2 * places), (1.0 + places) * share)(np.log1p(1e2 * k)) / (1.0 + k)
            for share in shares.T
        )
        own = self.compliance
        self.compliance, self.along = (own + self.added(excess * weights, k, edges) for excess in (normal, along))


CASES = {(0.1, 0.3): 1.0, (0.1, 3.0): 50.0, (0.1, 10.0): 300.0, (10.0, 0.3): 1.0, (10.0, 3.0): 5.0}
"""Contrast and a over the depth scale, and cycles in which about half of what can wear does."""


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("contrast", "a"), CASES)
def test_before_wear_a_cylinder_slips_as_singular_integral_equations_say(contrast, a):
    expected = by_equations(contrast, a)
    losses = []
    for count in (50, 200):
        worn = fretting(graded(contrast), expected.load, MU * expected.shear, [0.0, 1e-9], count=count).solve()
        losses.append(abs(worn.dissipation_per_length[0] / (4.0 * MU**2 * expected.loss()) - 1.0))
    assert worn.half_width[0] == pytest.approx(a, rel=1e-4)
    assert worn.stick_half_width[0] == pytest.approx(0.7 * a, rel=1e-3)
    assert losses[0] < 1e-2
    assert losses[1] < min(2e-3, 0.6 * losses[0])


@pytest.mark.slow
@pytest.mark.parametrize(("contrast", "a"), [(0.1, 0.3), (10.0, 3.0)])
def test_before_wear_the_pressure_is_that_of_an_indentation_up_to_the_middle(contrast, a):
    """The logarithm of the kernel, summed coarsely, had left a peak in the innermost cells at any count."""
    bed = graded(contrast)
    load = force(bed, a)
    fresh = fretting(bed, load, 0.6 * MU * load, [0.0, 1e-9], count=200).solve().states[-1]
    expected = wk.LineIndentation(bed, wk.LineForce(load)).solve().pressure(fresh.places)
    inside = fresh.places < 0.9 * a
    np.testing.assert_allclose(fresh.pressure[inside], expected[inside], atol=1e-3 * expected[0])


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("contrast", "a"), CASES)
def test_fretting_and_sliding_are_those_of_boundary_elements(contrast, a):
    load, amount = by_equations(contrast, a).load, CASES[contrast, a] / a**2
    finer = 2 if contrast * a > 10.0 else 1  # both converge slowly where the surface is soft and the depth stiff
    rig = fretting(graded(contrast), load, 0.6 * MU * load, [0.0, amount], count=200 * finer, tolerance=1e-4)
    last = rig.solve().states[-1]
    elements = WornOnGrading(contrast, np.linspace(0.0, 1.3 * a, 57 * finer), load, a)
    worn, pressure = elements.fret(0.6 * MU * load, amount, 40)
    inside = elements.x < 0.4 * a
    there = np.interp(elements.x**2, last.places**2, last.pressure)
    assert 2.0 * elements.h @ worn == pytest.approx(last.worn_volume_per_length, rel=1.5e-2)
    np.testing.assert_allclose(pressure[inside], there[inside], atol=3e-3 * pressure[0])
    amount = 0.2 * a * a / load * a
    last = sliding(graded(contrast), load, [0.0, amount], count=200, tolerance=1e-4).solve().states[-1]
    assert last.half_width > 1.05 * a
    elements = WornOnGrading(contrast, np.linspace(0.0, 2.0 * a, 51), load, a)
    worn, _ = elements.slide(amount, 40)
    there = np.interp(elements.x**2, last.places**2, last.worn)
    np.testing.assert_allclose(worn, there, atol=5e-3 * last.worn_depth)


def worn_alike(bed):
    load = force(bed)
    frets = fretting(bed, load, 0.6 * MU * load, [0.0, 1.0]).solve()
    limit = limiting(bed, load, 0.6 * MU * load)
    return np.array([frets.worn_volume_per_length[-1], limit.worn_volume_per_length, limit.half_width])


@pytest.mark.slow
def test_a_body_that_does_not_change_wears_as_a_half_plane():
    np.testing.assert_allclose(worn_alike(graded(1.0)), worn_alike(plain()), rtol=2e-6)


@pytest.mark.slow
def test_the_depth_is_felt_and_a_grading_of_no_family_wears_with_the_same_numbers():
    """At a / h = 3, under equal forces: without the depth all would wear as on the surface's own half-plane."""
    bed = graded(0.1)
    load = force(bed, 3.0)
    ghost = wk.LayeredLineFoundation(CYLINDER, Ghost(bed.medium))
    soft, own, same = (limiting(one, load, 0.6 * MU * load) for one in (bed, plain(), ghost))
    assert soft.worn_volume_per_length > 2.0 * own.worn_volume_per_length
    assert same.worn_volume_per_length == soft.worn_volume_per_length


@pytest.mark.slow
def test_a_strip_too_wide_for_its_punches_is_refused():
    bed = graded(0.1, 1e-3)
    load = force(bed, 1.0)
    with pytest.raises(wk.NotConverged, match="128 times at most"):
        sliding(bed, load, [0.0, 1e-3]).solve()
