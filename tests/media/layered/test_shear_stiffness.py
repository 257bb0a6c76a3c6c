"""k_x and k_phi of flat punches on layers and gradings: another route, closed limits, and how they belong together."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from layer_waves import Stack, shear_stiffness, twist_stiffness
from scipy.integrate import quad
from scipy.special import spherical_jn

import winkler as wk
from winkler.materials.depth_grading import ExponentialGrading
from winkler.materials.graded import PowerLawGraded
from winkler.materials.layered import Layer
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.media.layered.pair_response import Mode

STEEL = wk.Elastic(young=210e9, poisson=0.3)


def medium_of(layers, on):
    """The same stack for the package: (shear, poisson, thickness), (shear, poisson) or None."""
    solid = [wk.Elastic(2.0 * shear * (1.0 + poisson), poisson) for shear, poisson, _ in layers]
    base = wk.Rigid() if on is None else wk.Elastic(2.0 * on[0] * (1.0 + on[1]), on[1])
    return CoatedHalfSpace([Layer(each, row[2]) for each, row in zip(solid, layers, strict=True)], on=base)


STACKS = {
    "hard 100": ([(100.0, 0.2, 1.0)], (1.0, 0.3)),
    "hard 10": ([(10.0, 0.0, 1.0)], (1.0, 0.4)),
    "soft 100": ([(0.01, 0.45, 1.0)], (1.0, 0.2)),
    "rubber": ([(1.0, 0.5, 1.0)], None),
    "three": ([(3.0, 0.2, 1.0), (0.2, 0.45, 0.5), (6.0, 0.3, 0.7)], (1.0, 0.3)),
}


@pytest.mark.few(1)
@pytest.mark.parametrize("name", STACKS)
def test_stiffness_by_least_energy_with_tractions_of_both_directions(name):
    """The coupled problem, solved without the rule 1/k_x = (1/k_L + 1/k_T)/2; thin and thick, to 1e-8."""
    layers, on = STACKS[name]
    medium, stack = medium_of(layers, on), Stack(layers, on, longest_disc=4.0)
    for a in (0.05, 0.7, 4.0):
        place = np.array([a])
        assert medium.punch_shear_stiffness(place)[0] == pytest.approx(shear_stiffness(stack, a), rel=1e-8)
        assert medium.punch_torsional_stiffness(place)[0] == pytest.approx(twist_stiffness(stack, a), rel=1e-8)


@pytest.mark.parametrize("second", [wk.Rigid(), wk.Elastic(70e9, 0.2)])
def test_layers_of_one_solid_are_a_half_space_to_rounding(second):
    coated = CoatedHalfSpace([Layer(STEEL, 1e-3), Layer(STEEL, 5e-4)], on=STEEL, second=second)
    plain = wk.HalfSpace.between(STEEL, second)
    a = np.array([1e-6, 4e-4, 2e-3])
    np.testing.assert_allclose(coated.punch_shear_stiffness(a), plain.punch_shear_stiffness(a), rtol=2e-14)
    np.testing.assert_allclose(coated.punch_torsional_stiffness(a), plain.punch_torsional_stiffness(a), rtol=2e-14)
    np.testing.assert_allclose(coated.tangential_stiffness(a), plain.tangential_stiffness(a), rtol=2e-14)


def test_a_half_space_has_mindlins_ratio_and_the_torque_of_reissner_and_sagoci():
    plain, a = wk.HalfSpace.between(STEEL), np.array([2e-3])
    ratio = plain.punch_shear_stiffness(a) / plain.punch_stiffness(a)
    np.testing.assert_allclose(ratio, 2.0 * (1.0 - 0.3) / (2.0 - 0.3), rtol=1e-15)
    np.testing.assert_allclose(plain.punch_torsional_stiffness(a), 16.0 / 3.0 * STEEL.shear * a**3, rtol=1e-15)


def test_springs_are_half_the_slope_of_the_stiffness():
    medium = medium_of(*STACKS["three"])
    a = np.array([0.1, 0.9])
    nodes, weights = np.polynomial.legendre.leggauss(60)
    for radius in a:
        x = 0.5 * radius * (nodes + 1.0)
        summed = radius * float(weights @ medium.tangential_stiffness(x))
        assert summed == pytest.approx(float(medium.punch_shear_stiffness(np.array([radius]))[0]), rel=1e-8)


@pytest.mark.slow
def test_a_sheet_on_a_rigid_base_is_a_stack_of_springs():
    """Far wider than thick: k_x -> pi G a^2 / h, k_phi -> pi G a^4 / (2 h); edges add terms of the order of h/a."""
    medium = medium_of([(1.0, 0.3, 1.0)], None)
    a = np.array([7.0, 14.0])
    shear = medium.punch_shear_stiffness(a) / (np.pi * a**2) - 1.0
    twist = medium.punch_torsional_stiffness(a) / (0.5 * np.pi * a**4) - 1.0
    for excess in (shear, twist):
        assert 0.0 < excess[1] < 0.4
        assert excess[1] / excess[0] == pytest.approx(0.5, rel=0.08)


def test_first_order_in_the_contrast():
    """Gao, Chiu, Lee (1992): with the traction of the half-space, waves across the layer see 2 d exp(-2 xi h)."""
    contrast, h, a = 1e-6, 1.0, 1.3
    medium = medium_of([(1.0 + contrast, 0.3, h)], (1.0, 0.3))
    change = medium.punch_torsional_stiffness(np.array([a]))[0] / (16.0 / 3.0 * (1.0 + contrast) * a**3) - 1.0
    shared = quad(lambda s: math.exp(-2.0 * s * h / a) * spherical_jn(1, s) ** 2, 0.0, np.inf)[0] / (np.pi / 6.0)
    assert change == pytest.approx(-contrast * shared, rel=1e-5)


def test_the_second_body_adds_its_compliance_to_both_waves():
    layers, second = [Layer(wk.Elastic(5.0, 0.2), 0.4)], wk.Elastic(2.0, 0.35)
    base, xi = wk.Elastic(1.0, 0.3), np.array([0.1, 1.0, 4.0])
    for mode, added in ((Mode.ALONG, (1.0 - 0.35) / second.shear), (Mode.ACROSS, 1.0 / second.shear)):
        alone, pair = (wk.CoatedHalfSpace(layers, base, body).responding(mode) for body in (wk.Rigid(), second))
        both = [2.0 / each.modulus * (1.0 + each.excess(xi)) for each in (alone, pair)]
        np.testing.assert_allclose(both[1] - both[0], added, rtol=1e-13)
        own, unit = pair.own
        np.testing.assert_allclose(own.excess(xi * unit), pair.excess(xi), rtol=1e-12)


@pytest.mark.slow
def test_a_graded_body_lies_between_its_surface_and_its_depth():
    medium = DepthGradedHalfSpace(ExponentialGrading(1e9, 3e9, depth_scale=1e-3, poisson=0.3), tolerance=1e-3)
    a = np.array([1e-4, 1e-3])
    for found, scale in (
        (medium.punch_shear_stiffness(a), 8.0 * a / (2.0 - 0.3)),
        (medium.punch_torsional_stiffness(a), 16.0 / 3.0 * a**3),
    ):
        shear = found / scale
        assert 1e9 / 2.6 < shear[0] < shear[1] < 3e9 / 2.6
    assert 2.0 * medium.torsional_modulus == medium.across_response.modulus


@pytest.mark.slow
def test_a_graded_body_is_a_stack_of_thin_layers():
    """Layers half as thick are off by a quarter: what is left of both is extrapolated."""
    grading, a = ExponentialGrading(1.0, 3.0, depth_scale=1.0, poisson=0.3), np.array([0.8])

    def stack(count: int) -> CoatedHalfSpace:
        edges = np.concatenate([np.linspace(0.0, 1.0, 2 * count + 1), np.linspace(1.0, 6.0, 3 * count + 1)[1:]])
        layers = [
            Layer(wk.Elastic(float(grading.young_at(np.array(0.5 * (low + high)))), 0.3), float(high - low))
            for low, high in zip(edges[:-1], edges[1:], strict=True)
        ]
        return CoatedHalfSpace(layers, on=wk.Elastic(3.0, 0.3))

    graded, thick, thin = DepthGradedHalfSpace(grading, tolerance=1e-3), stack(5), stack(10)
    for name in ("punch_shear_stiffness", "punch_torsional_stiffness"):
        coarse, fine = (getattr(each, name)(a)[0] for each in (thick, thin))
        assert getattr(graded, name)(a)[0] == pytest.approx((4.0 * fine - coarse) / 3.0, rel=2e-3)


@pytest.mark.parametrize("k", [-0.4, 0.0, 0.3, 0.8])
def test_torsional_stiffness_of_a_power_law_by_its_energy(k):
    """T ~ xi^(-(1+k)/2) J_((3+k)/2)(xi a); the compliance of SH waves from their Bessel function, by 30 digits."""
    soil, a = PowerLawGraded(young=2.0, depth_scale=0.7, exponent=k, poisson=0.3), 1.3
    shear = soil.young / 2.6
    with mp.workdps(30):
        s, z = mp.mpf(1 - k) / 2, mp.mpf(10) ** -26
        top = mp.mpf(2) ** (s - 1) * mp.gamma(s)  # z^s K_s(z) at the surface
        bent = z ** (s + k) * mp.besselk(1 - s, z)  # -z^k times its slope
        wave = float(top / bent) * 0.7**k / shear
    order = 0.5 * (3.0 + k)
    torque = 4.0 * math.pi * (0.5 * a) ** order / math.gamma(order + 1.0)
    want = torque**2 * (3.0 + k) / (2.0 * math.pi * wave)
    found = GradedHalfSpace.between(soil).punch_torsional_stiffness(np.array([a]))[0]
    assert found == pytest.approx(want, rel=1e-10)


def test_stiffnesses_of_a_power_law_tend_to_those_of_a_half_space():
    a, plain = np.array([0.2, 3.0]), wk.HalfSpace.between(wk.Elastic(2.0, 0.3))
    graded = GradedHalfSpace.between(PowerLawGraded(young=2.0, depth_scale=0.7, exponent=0.0, poisson=0.3))
    for name in ("punch_shear_stiffness", "punch_torsional_stiffness"):
        np.testing.assert_allclose(getattr(graded, name)(a), getattr(plain, name)(a), rtol=1e-14)
    two = GradedHalfSpace.between(*[PowerLawGraded(2.0, 0.7, exponent=0.4, poisson=0.3)] * 2)
    one = GradedHalfSpace.between(PowerLawGraded(2.0, 0.7, exponent=0.4, poisson=0.3))
    assert 2.0 * two.torsional_modulus == pytest.approx(one.torsional_modulus, rel=1e-15)
    x = np.array([0.5])
    assert 2.0 * one.tangential_stiffness(x) * x / 1.4 == pytest.approx(one.punch_shear_stiffness(x), rel=1e-14)
