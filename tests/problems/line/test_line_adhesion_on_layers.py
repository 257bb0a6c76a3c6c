"""Lines that stick on layers: independent numbers, half-planes as limits, the substrate, energy, pull-off, ghosts."""

from __future__ import annotations

import functools

import numpy as np
import pytest
from layer_waves import excesses
from strips_of_layers import Kernel, attracted, released

import winkler as wk

NU = 0.3
SHEAR = 0.5 * (1.0 - NU)
"""E* = 1 of the layer under a rigid body."""
CYLINDER = wk.Paraboloid(1.0)
WORK, STRENGTH = 0.05, 0.3


def solid(share=1.0):
    return wk.Elastic(2.0 * SHEAR * (1.0 + NU) * share, NU)


def coated(contrast, thickness=1.0, base=None):
    medium = wk.CoatedHalfSpace([wk.Layer(solid(), thickness)], base or solid(contrast))
    return wk.LayeredLineFoundation(CYLINDER, medium)


def stuck(bed, load, law=None):
    return wk.LineAdhesion(bed, law or wk.ShortRange(WORK), load).solve()


@functools.cache
def kernel(contrast, widest):
    return Kernel(lambda k: excesses([(SHEAR, NU, 1.0)], (contrast * SHEAR, NU), k)[0], widest)


def same(x):
    return x


@pytest.mark.few(3)
@pytest.mark.parametrize("a", [0.3, 3.0, 10.0])
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_the_edge_releases_the_work_of_adhesion_by_another_derivation(contrast, a):
    """The pull of the edges is 0.65 to 1.7 times that of the half-plane of the layer, and the energy the same."""
    contact = stuck(coated(contrast), wk.HalfWidth(a))
    intensity = released(kernel(contrast, a), a, contact.force_per_length, same)
    assert 0.5 * intensity**2 == pytest.approx(WORK, rel=1e-9)
    assert contact.stress_intensity == pytest.approx(intensity, rel=1e-9)
    assert contact.energy_release_rate == pytest.approx(WORK, rel=1e-13)


@pytest.mark.few(2, slow=2)
@pytest.mark.parametrize("a", [0.3, 3.0, 10.0])
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_an_attraction_ends_where_the_surfaces_stand_apart_by_its_range(contrast, a):
    contact = stuck(coated(contrast), wk.HalfWidth(a), wk.Dugdale(WORK, strength=STRENGTH))
    load, gap = attracted(kernel(contrast, 12.0), a, contact.outer_half_width, STRENGTH, same)
    assert gap == pytest.approx(WORK / STRENGTH, rel=1e-6)
    assert contact.force_per_length == pytest.approx(load, rel=1e-8, abs=1e-8)
    assert contact.pressure(0.5 * (a + contact.outer_half_width)) == pytest.approx(-STRENGTH, rel=1e-12)


@pytest.mark.parametrize("softer", [0.0, 3.0])
def test_a_film_that_slides_releases_it_too(softer):
    def slid(k):
        s, c, e = -0.5 * np.expm1(-2.0 * k), 0.5 * (1.0 + np.exp(-2.0 * k)), np.exp(-2.0 * k)  # over exp(k)
        both = s * c + k * e
        return (s * s + softer * both) / (both + softer * (s * s - k * k * e)) - 1.0

    film = wk.SlidingFilm([wk.Layer(solid(), 1.0)], solid(1.0 / softer) if softer else wk.Rigid())
    contact = stuck(wk.LayeredLineFoundation(CYLINDER, film), wk.HalfWidth(2.0))
    intensity = released(Kernel(slid, 2.0), 2.0, contact.force_per_length, same)
    assert 0.5 * intensity**2 == pytest.approx(WORK, rel=1e-9)


@pytest.mark.parametrize("law", [wk.ShortRange(WORK), wk.Dugdale(WORK, strength=STRENGTH)])
def test_layers_of_one_solid_stick_as_a_half_plane(law):
    plain = stuck(wk.LineFoundation(CYLINDER, wk.HalfSpace(solid())), wk.HalfWidth(0.8), law)
    layered = stuck(coated(1.0, 0.4), wk.HalfWidth(0.8), law)
    for name in ("force_per_length", "edge_load", "outer_half_width", "stress_intensity", "energy_release_rate"):
        assert getattr(layered, name) == pytest.approx(getattr(plain, name), rel=1e-11), name
    x = np.array([0.1, 0.5, 0.82, 1.5])
    np.testing.assert_allclose(layered.pressure(x), plain.pressure(x), atol=1e-11)
    np.testing.assert_allclose(layered.separation(x), plain.separation(x), atol=1e-11)
    places = np.array([0.1, 0.7]), np.array([0.3, 0.9])
    np.testing.assert_allclose(layered.stresses(*places).von_mises, plain.stresses(*places).von_mises, atol=1e-10)
    assert layered.approach(first=5.0) == pytest.approx(plain.approach(5.0), rel=1e-10)


@pytest.mark.slow
def test_under_a_thin_layer_the_base_decides():
    """The load goes to that on the base as h ln h, though the stress intensity is that of the layer."""
    base = stuck(wk.LineFoundation(CYLINDER, wk.HalfSpace(solid(10.0))), wk.HalfWidth(1.0)).force_per_length
    missed = [stuck(coated(10.0, h), wk.HalfWidth(1.0)).force_per_length / base - 1.0 for h in (0.005, 0.0025)]
    assert abs(missed[1]) < 0.05
    assert 1.6 < missed[0] / missed[1] < 2.0


def test_what_the_edge_releases_is_what_the_compliance_loses():
    """2 G = -(P - P0)^2 C'(a) / 2; depths come from another integral than the pressures."""
    bed = coated(1.0, base=wk.Rigid())
    widths = 0.7 * (1.0 + 1e-3 * np.array([-2.0, -1.0, 1.0, 2.0]))

    def compliance(a):
        pulled = stuck(bed, wk.HalfWidth(a))
        pressed = wk.LineIndentation(bed, wk.HalfWidth(a)).solve()
        return (pulled.depth - pressed.depth) / (pulled.force_per_length - pressed.force_per_length)

    growth = compliance(widths) @ np.array([1.0, -8.0, 8.0, -1.0]) / (12e-3 * 0.7)
    edge = stuck(bed, wk.HalfWidth(0.7)).edge_load
    assert -0.25 * edge**2 * growth == pytest.approx(WORK, rel=1e-7)


@pytest.mark.slow
@pytest.mark.parametrize("law", [wk.ShortRange(WORK), wk.Dugdale(WORK, strength=STRENGTH)])
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_it_comes_apart_where_the_force_is_least(contrast, law):
    bed = coated(contrast)
    contact = stuck(bed, wk.LineForce(0.1), law)
    a = contact.pull_off_half_width
    near = stuck(bed, wk.HalfWidth(a * np.array([0.97, 1.0, 1.03])), law).force_per_length
    assert near[1] == pytest.approx(contact.pull_off_force_per_length, rel=1e-10)
    assert np.all(near[[0, 2]] > near[1])
    assert (near[2] - near[1]) == pytest.approx(near[0] - near[1], rel=0.15)
    assert stuck(bed, wk.HalfWidth(contact.half_width), law).force_per_length == pytest.approx(0.1, rel=1e-9)


def test_notes_speak_of_layers():
    text = " ".join(map(str, stuck(coated(10.0), wk.HalfWidth(0.5)).validity))
    assert "half-planes" not in text
    assert "layers in plane strain" in text
    assert "do not overlap" in text
