"""Laws of coated and depth-graded media: what holds on every stack; few examples, because each is made anew."""

from __future__ import annotations

import dataclasses
import functools
import math
from collections.abc import Iterable

import numpy as np
import pytest
from contacts import along, examples
from hypothesis import given
from hypothesis import strategies as st
from media_cases import LAYERED, SMOOTHLY, Sample, elastic, number
from test_law_values import assert_a_value

import winkler as wk
from winkler.study.language.build import build, unbuild

BALL, CONE, EDGE = wk.Paraboloid(2.0), wk.Cone(1.2), wk.TruncatedCone(1.2, flat_radius=0.4)
SMALL_STEPS = np.arange(-3.0, 4.0) * 1e-3
SLOPE = np.array([-1.0, 9.0, -45.0, 0.0, 45.0, -9.0, 1.0]) / 60e-3
"""Of a function at these steps, times the step; of sixth order."""
GAUSS = np.polynomial.legendre.leggauss(24)


def over_stacks(count: int, quick: Iterable[str] = LAYERED):
    """Turn a law of a sample and a contact radius into a test of every kind of stack, slow but for the `quick` ones."""

    def decorate(law):
        every = [*LAYERED, *SMOOTHLY]
        kinds = [pytest.param(kind, marks=[] if kind in quick else [pytest.mark.slow]) for kind in every]

        @pytest.mark.parametrize("kind", kinds)
        @functools.wraps(law, assigned=("__module__", "__name__", "__qualname__", "__doc__"))
        def test(kind: str) -> None:
            media = {**LAYERED, **SMOOTHLY}[kind]
            examples(count if kind in LAYERED else 1)(given(media, number(0.3, 3.0))(law))()

        del test.__wrapped__
        return test

    return decorate


def springs(medium, a: np.ndarray) -> np.ndarray:
    """All properties of the springs, at several radii."""
    return np.array(
        [
            medium.punch_stiffness(a),
            medium.normal_stiffness(a),
            medium.gap(BALL, a),
            medium.gap_slope(BALL, a),
            medium.gap_load(BALL, a),
        ]
    )


@over_stacks(1)
def test_springs_scale(sample: Sample, radius: float):
    """Lengths times s, moduli times m."""
    s, m = 3e-6, 7e10
    a = radius * np.array([0.1, 1.0])
    ball = wk.Paraboloid(2.0 * s)
    small, large = springs(sample.make(1.0, 1.0), a), sample.make(s, m)
    found = [large.punch_stiffness(s * a), large.normal_stiffness(s * a)]
    found += [large.gap(ball, s * a), large.gap_slope(ball, s * a), large.gap_load(ball, s * a)]
    scales = np.array([s * m, m, s, 1.0, s * s * m])
    np.testing.assert_allclose(np.array(found) / scales[:, None], small, rtol=1e-10)


@over_stacks(2)
def test_the_two_stiffnesses_belong_together(sample: Sample, radius: float):
    """k = 2 E* Int phi dx and k' = 2 E* phi(a; a)^2 are computed apart: the springs from 0 to a carry the punch."""
    medium = sample.make(1.0, 1.0)
    ends = radius * np.array([0.0, 0.01, 0.1, 0.3, 0.6, 1.0])
    nodes, weights = GAUSS
    x = (0.5 * (ends[1:] + ends[:-1])[:, None] + 0.5 * np.diff(ends)[:, None] * nodes).ravel()
    weight = (0.5 * np.diff(ends)[:, None] * weights).ravel()
    punch = float(medium.punch_stiffness(np.array(radius)))
    assert 2.0 * float(weight @ medium.normal_stiffness(x)) == pytest.approx(punch, rel=1e-10)


@pytest.mark.few(1, slow=2)
@over_stacks(1, quick=("film", "three_layers"))
def test_force_energy_and_stiffness_belong_together(sample: Sample, radius: float):
    """F = dU/dd and k = dF/dd."""
    medium = sample.make(1.0, 1.0)
    for shape in (BALL, CONE):
        bed = wk.Foundation(shape, medium)
        depth = float(bed.gap(np.array([radius]))[0])
        curve = wk.Indentation(bed, wk.Depth(depth * (1.0 + SMALL_STEPS))).solve()
        assert SLOPE @ curve.energy / depth == pytest.approx(curve.force[3], rel=1e-8)
        assert SLOPE @ curve.force / depth == pytest.approx(curve.stiffness[3], rel=1e-8)
        # k is the slope of F, and its own slope is that of the springs: dk/dd = 2 c_N / g'
        steeper = 2.0 * bed.normal_stiffness(curve.radius[3:4]) / bed.gap_slope(curve.radius[3:4])
        assert SLOPE @ curve.stiffness / depth == pytest.approx(float(steeper[0]), rel=1e-7)


@pytest.mark.few(1)
@over_stacks(1, quick=("film", "three_layers"))
def test_depth_to_force_to_radius_to_depth(sample: Sample, radius: float):
    medium = sample.make(1.0, 1.0)
    for shape in (BALL, EDGE):
        bed = wk.Foundation(shape, medium)
        depth = bed.gap(np.array([radius + 0.4, radius + 0.1]))
        first = wk.Indentation(bed, wk.Depth(depth)).solve()
        second = wk.Indentation(bed, wk.Force(first.force)).solve()
        third = wk.Indentation(bed, wk.Radius(second.radius)).solve()
        np.testing.assert_allclose(second.depth, depth, rtol=1e-10)
        np.testing.assert_allclose(third.depth, depth, rtol=1e-10)
        np.testing.assert_allclose(third.force, first.force, rtol=1e-10)


@over_stacks(1, quick=("film", "three_layers"))
def test_pressure_and_surface(sample: Sample, radius: float):
    """The pressure carries the force, the surface lies on the body inside and stays clear of it outside."""
    bed = wk.Foundation(BALL, sample.make(1.0, 1.0))
    contact = wk.Indentation(bed, wk.Radius(radius)).solve()
    r, weight = along(bed, radius, angular=True)
    assert float(2.0 * np.pi * (wk.restore(contact, r).pressure * r) @ weight) == pytest.approx(contact.force, rel=1e-8)
    r = radius * np.array([0.0, 0.3, 0.8, 0.999, 1.001, 1.2, 3.0])
    fields = wk.restore(contact, r)
    fit = contact.depth - bed.height(r[:4])
    np.testing.assert_allclose(fields.displacement[:4], fit, rtol=0, atol=1e-8 * contact.depth)
    assert np.all(fields.gap[4:] > 0.0)


@pytest.mark.few(1)
@pytest.mark.parametrize("kind", LAYERED)
@examples(1)
@given(data=st.data())
def test_a_counterpart_a_billion_times_stiffer_is_rigid(kind, data):
    """And one that is only stiff deforms by its own compliance, in series with a punch of the stack."""
    stack = data.draw(LAYERED[kind]).make(1.0, 1.0)
    a = np.array([0.3, 2.0])
    rigid, stiff, soft = (
        springs(dataclasses.replace(stack, second=body), a)
        for body in (wk.Rigid(), wk.Elastic(1e9, 0.3), wk.Elastic(1e5, 0.3))
    )
    np.testing.assert_allclose(stiff, rigid, rtol=1e-7)
    assert np.all(soft[:2] < rigid[:2])
    # to first order the counterpart moves by Int p^2-weighted 2/(E xi): between the mean and the edge of the pressure
    lost = (1.0 / soft[0] - 1.0 / rigid[0]) * 2.0 * a * 1e5 / 0.91
    assert np.all((lost > 0.9) & (lost < 1.5))


@examples(2)
@given(body=elastic, other=elastic, heights=st.lists(number(0.4, 2.0), min_size=1, max_size=3))
def test_equal_layers_are_no_layers(body, other, heights):
    solid, second = body(1.0), other(1.0)
    medium = wk.CoatedHalfSpace([wk.Layer(solid, h) for h in heights], solid, second)
    a = np.array([0.05, 0.7, 2.0])
    np.testing.assert_allclose(springs(medium, a), springs(wk.HalfSpace(solid, second), a), rtol=1e-10)


@pytest.mark.few(1)
@pytest.mark.parametrize("young", [0.2, 5.0])
@pytest.mark.parametrize("poisson", [0.0, 0.5])
def test_a_coating_goes_over_into_its_substrate_and_a_thick_one_into_itself(young, poisson):
    """The limit is approached in first order in h/a (what the film adds), and in a/h (what the base adds)."""
    punch = np.array(1.0)

    def stiffness(thickness: float) -> float:
        layer = wk.Layer(wk.Elastic(young, poisson), thickness)
        return float(wk.CoatedHalfSpace([layer], wk.Elastic(1.0, 0.3)).punch_stiffness(punch))

    own, base = (2.0 * e / (1.0 - nu**2) for e, nu in ((young, poisson), (1.0, 0.3)))
    thick = np.array([own / stiffness(h) - 1.0 for h in (50.0, 100.0)])  # the next term is of third order
    assert thick[0] / thick[1] == pytest.approx(2.0, rel=2e-3)
    assert 1e-3 < np.max(np.abs(thick)) < 0.1
    thin = np.array([stiffness(h) / base - 1.0 for h in (0.1, 0.05)])
    assert np.max(np.abs(thin)) < 0.3
    if poisson == 0.0:  # a soft film that cannot be squeezed out first makes the punch stiffer, then softer
        assert 1.5 < thin[0] / thin[1] < 2.0  # of first order with a logarithm


def sampled(k: float, poisson: float, reach: tuple[float, float], count: int) -> wk.CoatedHalfSpace:
    """E = z^k by layers that grow with the depth, each with the modulus of its geometric middle."""
    edges = np.geomspace(*reach, count + 1)
    middles = np.sqrt(edges[1:] * edges[:-1])
    thicknesses = np.diff(np.concatenate([[0.0], edges[1:]]))
    solids = [wk.Elastic(float(z**k), poisson) for z in middles]
    layers = [wk.Layer(solid, float(h)) for solid, h in zip(solids, thicknesses, strict=True)]
    return wk.CoatedHalfSpace(layers, wk.Elastic(float(edges[-1] ** k), poisson))


@pytest.mark.few(1)
@pytest.mark.parametrize(("k", "poisson"), [(0.3, 0.3), (-0.2, 0.4), (0.6, 0.5)])
def test_many_thin_layers_are_the_power_law_they_sample(k, poisson):
    """Of second order: twice as many layers leave a quarter of the difference of every wave's compliance.

    C = c xi^(k-1), and of the graded medium's own stiffness c follows: c = pi 2^(1-k) / (E* Gamma((1+k)/2)^2).
    """
    graded = wk.GradedHalfSpace(wk.PowerLawGraded(1.0, 1.0, k, poisson))
    xi = np.array([0.5, 1.0, 1.3, 2.0])
    exact = math.pi * 2.0 ** (1.0 - k) / (graded.modulus * math.gamma(0.5 * (1.0 + k)) ** 2) * xi ** (k - 1.0)
    missed = []
    for count in (80, 160, 320):
        response = sampled(k, poisson, (1e-9, 1e5), count).response
        missed.append(2.0 / (response.modulus * xi) * (1.0 + response.excess(xi)) / exact - 1.0)
    assert np.max(np.abs(missed[2])) < 4e-5
    np.testing.assert_allclose(missed[1] / missed[2], 4.0, rtol=0.07)


@pytest.mark.slow
def test_a_punch_on_many_thin_layers_is_a_punch_on_the_power_law():
    a = np.array([0.5, 1.0])
    exact = wk.GradedHalfSpace(wk.PowerLawGraded(1.0, 1.0, 0.3, 0.3)).punch_stiffness(a)
    missed = sampled(0.3, 0.3, (1e-5, 1e4), 24).punch_stiffness(a) / exact - 1.0
    assert np.max(np.abs(missed)) < 5e-3


@over_stacks(2)
def test_media_are_values_and_come_back_from_a_study(sample: Sample, radius: float):
    medium = sample.make(1.0, 1.0)
    assert_a_value(medium, sample.make(1.0, 1.0), sample.make(1.0, 2.0))
    assert build(unbuild(medium), "medium") == medium
