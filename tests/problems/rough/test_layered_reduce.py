"""Springs of height maps on layers and gradings: against rings of bodies of revolution and Booker's closed form."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.problems.rough.reduce import Reduction
from winkler.values.errors import InvalidInput, OutsideValidity

STIFF = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(5.0, 0.3), 0.1)], on=wk.Elastic(1.0, 0.4), second=wk.Elastic(3.0, 0.2))
RUBBER = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1.0, 0.5), 0.2)], on=wk.Rigid())
SOIL = wk.GradedHalfSpace.between(wk.PowerLawGraded(young=1.0, depth_scale=0.3, exponent=0.5, poisson=0.3))
DEPTHS = wk.Depth(np.array([0.01, 0.02, 0.035]))


def ball(count=61):
    """A map whose middle pixel is the apex, 1 m round."""
    x = (np.arange(count) - (count - 1) / 2) / count
    return wk.Topography(-0.5 * (x[:, None] ** 2 + x**2), [1.0, 1.0])


@pytest.mark.few(1)
@pytest.mark.parametrize("medium", [STIFF, RUBBER, SOIL], ids=["stiff", "rubber", "soil"])
def test_springs_of_a_ball_are_those_of_its_medium(medium):
    reduced = Reduction(ball(), medium, 0.04, tolerance=3e-3).solve()
    own = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), medium), DEPTHS).solve()
    found = wk.Indentation(reduced.bed, DEPTHS).solve()
    assert found.force == pytest.approx(own.force, abs=reduced.misfit * own.force[-1] + 1e-3 * own.force[-1])
    assert found.stiffness == pytest.approx(own.stiffness, rel=2e-2)
    assert found.radius == pytest.approx(own.radius, rel=2e-2)  # of discs with the same stiffness on the same layers


@pytest.mark.parametrize("exponent", [-0.4, 0.3, 0.9])
def test_a_ball_on_a_power_law_bears_what_booker_says(exponent):
    """F = 4 E* a^(3+k) / ((1+k)^2 (3+k) R c_0^k) under d = a^2 / ((1+k) R), and its stiffness."""
    count, side, a, c0, k = 128, 0.8, 0.3, 0.4, exponent
    medium = wk.GradedHalfSpace.between(wk.PowerLawGraded(young=1.0, depth_scale=c0, exponent=k, poisson=0.3))
    x = (np.arange(count) - (count - 1) / 2) * side / count
    heights = 0.5 * (x[:, None] ** 2 + x**2)
    depth = a**2 / (1.0 + k) - heights.min()
    contact = wk.SurfaceContact(wk.Topography(-heights, [side, side]), medium, wk.Depth(depth)).solve()
    modulus = medium.modulus / c0**k
    assert contact.force == pytest.approx(4.0 * modulus * a ** (3.0 + k) / ((1.0 + k) ** 2 * (3.0 + k)), rel=1e-4)
    assert contact.stiffness == pytest.approx(2.0 * modulus * a ** (1.0 + k) / (1.0 + k), rel=5e-3)


def test_a_wave_on_a_power_law_closes_under_its_closed_form():
    """A wave that touches everywhere bears p = E* q h / (2 (1 + M)): the Fourier transform of r^-(1+k)."""
    k, c0, count, height = 0.4, 0.2, 64, 0.01
    medium = wk.GradedHalfSpace.between(wk.PowerLawGraded(young=1.0, depth_scale=c0, exponent=k, poisson=0.3))
    wave = height * np.cos(2.0 * np.pi * 2 * np.arange(count) / count)[:, None] * np.ones(count)
    rough = wk.Topography(wave, [1.0, 1.0], periodic=True)
    pressed = wk.SurfaceContact(rough, medium, wk.Force(1.0), tolerance=1e-11).solve()
    # the integral of r^-k J_0(q r) is (q/2)^k Gamma((1-k)/2) / (q Gamma((1+k)/2)): Abramowitz and Stegun 11.4.16
    q = 4.0 * math.pi
    moment = (0.5 * q) ** k * math.gamma(0.5 * (1.0 - k)) / (q * math.gamma(0.5 * (1.0 + k)))
    softness = 2.0 * math.cos(0.5 * math.pi * k) * c0**k * moment / medium.modulus
    assert pressed.last.pressure - 1.0 == pytest.approx(wave / softness, abs=1e-7 * height / softness)


@pytest.mark.slow
def test_springs_on_layers_are_sheared_and_moved_with_friction():
    """Their error is that against boundary elements on the same layers."""
    stiff = wk.ReducedFriction(ball(63), STIFF, wk.Coulomb(0.3), 0.04, tolerance=0.01).solve()
    assert 0.01 < stiff.shift_error < 0.1
    assert stiff.bed.shift_error == stiff.shift_error


def test_springs_on_layers_conduct_nothing_and_fit_no_other_body():
    reduced = Reduction(ball(51), STIFF, 0.04, tolerance=0.01).solve()
    assert not reduced.bed.homogeneous
    copper = wk.ElectricalConductor(1.7e-8)
    with pytest.raises(OutsideValidity, match="on layers do not determine its conductance"):
        wk.Constriction(wk.Indentation(reduced.bed, wk.Depth(0.02)), wk.ElectricalConductors(copper, copper)).solve()
    with pytest.raises(InvalidInput, match="whose layers no other medium has"):
        reduced.on(wk.HalfSpace(wk.Elastic(1.0, 0.3)))
    assert "discs with the same stiffness on the same layers" in " ".join(str(note) for note in reduced.validity)
    bed = wk.ReducedBed(ball(51), STIFF, 0.04, 0.01)
    assert wk.Indentation(bed, wk.Depth(0.02)).solve().force > 0.0


def test_gibsons_solid_is_refused():
    soil = wk.GradedHalfSpace.between(wk.PowerLawGraded(young=1.0, depth_scale=1.0, exponent=1.0, poisson=0.5))
    with pytest.raises(OutsideValidity, match="give an exponent below 1"):
        wk.SurfaceContact(ball(21), soil, wk.Force(0.01))
