"""Wavy bodies on layers: full contact in closed form, another discretisation, half-planes and one strip as limits."""

from __future__ import annotations

import numpy as np
import pytest
from layer_waves import excesses

import winkler as wk

NU = 0.3
SHEAR = 0.5 * (1.0 - NU)
"""E* = 1 of the layer under a rigid body."""
WAVE = wk.Wavy(1e-3, 1.0)


def solid(share=1.0):
    return wk.Elastic(2.0 * SHEAR * (1.0 + NU) * share, NU)


def coated(contrast, thickness, profile=WAVE):
    medium = wk.CoatedHalfSpace([wk.Layer(solid(), thickness)], solid(contrast))
    return wk.LayeredLineFoundation(profile, medium)


def excess(contrast, thickness, orders):
    return excesses([(SHEAR, NU, thickness)], (contrast * SHEAR, NU), 2.0 * np.pi * np.arange(1.0, orders + 1.0))[0]


def pressed(bed, load):
    return wk.PeriodicIndentation(bed, 1.0, load).solve()


@pytest.mark.parametrize("thickness", [0.03, 0.3])
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_a_wave_in_full_contact_is_one_wave_of_pressure(contrast, thickness):
    """p = mean + pi E* h / (lambda (1 + M)) cos: the layers answer each wave by itself."""
    one = np.pi * 1e-3 / (1.0 + excess(contrast, thickness, 1)[0])
    closed = pressed(coated(contrast, thickness), wk.NominalPressure(2.0 * one))
    assert closed.closure_pressure == pytest.approx(one, rel=1e-9)
    x = np.array([0.0, 0.1, 0.37, 0.5])
    np.testing.assert_allclose(closed.pressure(x), 2.0 * one + one * np.cos(2.0 * np.pi * x), rtol=1e-9)
    assert closed.half_width == 0.5


def by_collocation(contrast, thickness, half_width, slope, count=100):
    """Load of a strip, after Erdogan and Gupta, with the cotangent and the waves that the layers add."""
    orders = int(22.0 / (2.0 * np.pi * thickness)) + 1
    k, added = 2.0 * np.pi * np.arange(1, orders + 1), excess(contrast, thickness, orders)
    angle = np.pi * np.arange(1, count + 1) / (count + 1)
    s, shares = half_width * np.cos(angle), half_width * np.pi * np.sin(angle) ** 2 / (count + 1)
    x = half_width * np.cos(np.pi * (np.arange(1, count + 2) - 0.5) / (count + 1))
    apart = x[:, None] - s
    smooth = 2.0 * np.pi * np.sum(added * np.sin(k * apart[..., None]), axis=-1)
    kernel = (np.pi / np.tan(np.pi * apart) + smooth) * shares
    return float(shares @ np.linalg.lstsq(kernel, 0.5 * np.pi * slope(x), rcond=None)[0])


@pytest.mark.parametrize(("half_width", "thickness"), [(0.03, 0.1), (0.3, 0.1), (0.3, 0.03)])
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_strips_by_another_discretisation(contrast, half_width, thickness):
    found = pressed(coated(contrast, thickness), wk.HalfWidth(half_width))
    load = by_collocation(contrast, thickness, half_width, lambda x: 2e-3 * np.pi * np.sin(2.0 * np.pi * x))
    assert found.force_per_length == pytest.approx(load, rel=1e-9)
    back = pressed(coated(contrast, thickness), wk.LineForce(load))
    assert back.half_width == pytest.approx(half_width, rel=1e-9)


def test_ridges_of_a_roller_by_another_discretisation():
    roller = pressed(coated(10.0, 0.1, wk.Paraboloid(30.0)), wk.HalfWidth(0.2))
    assert roller.force_per_length == pytest.approx(by_collocation(10.0, 0.1, 0.2, lambda x: x / 30.0), rel=1e-9)


@pytest.mark.parametrize("load", [wk.HalfWidth(0.2), wk.NominalPressure(5e-3)])
def test_layers_of_one_solid_are_a_half_plane(load):
    plain = pressed(wk.LineFoundation(WAVE, wk.HalfSpace(solid())), load)
    layered = pressed(coated(1.0, 0.1), load)
    for name in ("force_per_length", "half_width", "peak_pressure", "closure_pressure"):
        assert getattr(layered, name) == pytest.approx(getattr(plain, name), rel=1e-10), name
    x, z = np.array([0.0, 0.1, 0.22, 0.4]), np.array([0.05, 0.2, 0.0, 0.7])
    np.testing.assert_allclose(layered.separation(x), plain.separation(x), atol=1e-13)
    np.testing.assert_allclose(layered.stresses(x, z).von_mises, plain.stresses(x, z).von_mises, atol=1e-7)


def test_far_apart_each_strip_stands_alone():
    bed = coated(10.0, 0.01, wk.Paraboloid(30.0))
    alone = wk.LineIndentation(bed, wk.HalfWidth(0.01)).solve().force_per_length
    missed = [
        wk.PeriodicIndentation(bed, pitch, wk.HalfWidth(0.01)).solve().force_per_length / alone - 1.0
        for pitch in (0.5, 1.0)
    ]
    assert missed[0] / missed[1] == pytest.approx(4.0, rel=0.05)
    assert abs(missed[1]) < 1e-3


def test_stresses_are_in_equilibrium_with_the_load_and_pass_interfaces():
    found = pressed(coated(10.0, 0.1), wk.HalfWidth(0.2))
    x = (np.arange(64) + 0.5) / 64
    for depth in (0.05, 0.4):
        across = found.stresses(x, np.full(64, depth))
        assert -np.mean(across.zz_stress) == pytest.approx(found.nominal_pressure, rel=1e-6)
    above, below = (found.stresses(x, np.full(64, depth)) for depth in (0.1, np.nextafter(0.1, 1.0)))
    np.testing.assert_allclose(below.zz_stress, above.zz_stress, atol=1e-9)
    np.testing.assert_allclose(below.xz_stress, above.xz_stress, atol=1e-9)


def test_notes_speak_of_layers():
    text = " ".join(map(str, pressed(coated(10.0, 0.1), wk.NominalPressure(1e-4)).validity))
    assert "half-planes" not in text
    assert "Linear elastic layers" in text
