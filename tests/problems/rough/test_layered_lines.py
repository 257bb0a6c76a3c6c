"""Lines of springs on layers: limits of thin, thick and no layers, smooth bodies by rings, and boundary elements."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.problems.rough.layered_lines import slope_modulus
from winkler.profiles.rough.random_rough import random_topography
from winkler.values.errors import OutsideValidity

BASE = wk.Elastic(1.0, 0.3)
SPECTRUM = wk.SelfAffine(hurst=0.8, rms_height=0.003, longest=1.0, shortest=1.0 / 12.0)
LOAD = wk.Force(np.array([1e-5, 1e-3, 1e-2]))


def coated(young, thickness, poisson=0.3):
    return wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, poisson), thickness)], on=BASE)


def lines(medium, spectrum=SPECTRUM):
    return wk.RoughContact(spectrum, medium, 1.0, LOAD, realisations=8, count=512).solve()


@pytest.mark.few(1)
@pytest.mark.parametrize(("young", "thickness", "alone"), [(1.0, 0.1, 1.0), (4.0, 300.0, 4.0), (1.5, 3e-4, 1.0)])
def test_no_layer_a_thick_and_a_thin_one_are_half_spaces(young, thickness, alone):
    found, plain = lines(coated(young, thickness)), lines(wk.HalfSpace(wk.Elastic(alone, 0.3)))
    for name in ("stiffness", "depth", "area", "mean_gap"):
        assert getattr(found, name) == pytest.approx(getattr(plain, name), rel=1e-2), name


def test_a_body_that_is_hardly_rough_bears_as_by_rings():
    medium = coated(5.0, 0.1)
    bed = wk.Foundation(wk.Paraboloid(1.0), medium)
    faint = wk.SelfAffine(hurst=0.8, rms_height=1e-9, longest=0.5, shortest=0.05)
    rough = wk.RoughIndentation(faint, bed, 0.8, wk.Force(0.02), realisations=2, count=4096).solve()
    smooth = wk.Indentation(bed, wk.Force(0.02)).solve()
    assert rough.depth == pytest.approx(smooth.depth, rel=1e-4)
    assert rough.stiffness == pytest.approx(smooth.stiffness, rel=1e-3)
    assert rough.area == pytest.approx(np.pi * smooth.radius**2, rel=1e-2)  # it touches everywhere inside


def test_waves_meet_their_own_modulus():
    """Of one short and one long wave of equal slope: the short one feels the layer, the long one the base."""
    waves = wk.SelfAffine(hurst=0.5, rms_height=1e-3, longest=1.01, shortest=1.0)
    slope = waves.rms_slope
    assert slope_modulus(coated(4.0, 30.0), waves) == pytest.approx(4.0 / 0.91 * slope, rel=1e-3)
    assert slope_modulus(coated(4.0, 1e-5), waves) == pytest.approx(1.0 / 0.91 * slope, rel=1e-3)
    soil = wk.GradedHalfSpace.between(wk.PowerLawGraded(young=1.0, depth_scale=1.0, exponent=0.4, poisson=0.3))
    finer = wk.SelfAffine(hurst=0.5, rms_height=1e-3, longest=0.101, shortest=0.1)
    ratio = slope_modulus(soil, finer) / finer.rms_slope / (slope_modulus(soil, waves) / slope)
    assert ratio == pytest.approx(10.0**-0.4, rel=1e-3)  # E ~ z^0.4, and waves reach as deep as they are long


def test_layers_say_their_band_and_conduct_nothing():
    found = lines(coated(4.0, 0.1))
    assert "0.7 to 1.35 times those of boundary elements" in " ".join(str(note) for note in found.validity)
    metal = wk.ElectricalConductor(1.7e-8)
    with pytest.raises(OutsideValidity, match="stiffness does not tell the conductance"):
        found.conductance(wk.ElectricalConductors(metal, metal))


@pytest.mark.slow
@pytest.mark.parametrize(("young", "thickness"), [(4.0, 0.02), (4.0, 0.3), (0.25, 0.08), (20.0, 0.05)])
def test_medians_are_within_the_band_of_boundary_elements(young, thickness):
    medium, load = coated(young, thickness), wk.Force(np.array([1e-5, 1e-4, 1e-3, 5e-3]))
    stiffness, depth = [], []
    for seed in range(4):
        heights = random_topography(SPECTRUM, (64, 64), [1.0, 1.0], seed).heights
        pressed = wk.SurfaceContact(wk.Topography(heights, [1.0, 1.0]), medium, load, tolerance=1e-4).solve()
        stiffness.append(pressed.stiffness)
        depth.append(pressed.depth)
    found = wk.RoughContact(SPECTRUM, medium, 1.0, load, realisations=50, count=1024).solve()
    for name, many, low, high in (("stiffness", stiffness, 0.7, 1.35), ("depth", depth, 0.8, 1.25)):
        share = getattr(found, name) / np.median(many, axis=0)
        assert np.all((low < share) & (share < high)), (name, share)
