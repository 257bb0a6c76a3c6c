"""True areas: Hertz, Westergaard, grids of four pixels a wave, patches and distributions."""

from __future__ import annotations

import math

import numpy as np
import pytest

from winkler.loading.loads import Depth, Force
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.problems.pressed_maps.true_area import TrueArea
from winkler.problems.rough.surface_contact import SurfaceContact
from winkler.profiles.rough.random_rough import random_topography
from winkler.profiles.rough.spectrum import SelfAffine
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption

UNIT = HalfSpace(Elastic(1.0, 0.0))


@pytest.mark.parametrize(("across", "close"), [(8, 0.05), (16, 0.01), (32, 0.01)])
def test_hertz(across, close):
    """A ball whose contact is so many pixels wide, off the middle of the pixels."""
    count, radius = 4 * across, 10.0
    x = (np.arange(count) - 0.5 * count + 0.63) / count
    a = 0.5 * across / count
    force = 4.0 / 3.0 * a**3 / radius
    ball = Topography(-(x[:, None] ** 2 + x**2) / (2.0 * radius), [1.0, 1.0])
    found = TrueArea(SurfaceContact(ball, UNIT, Force(force))).solve()
    peak = 1.5 * force / (math.pi * a**2)
    assert found.area == pytest.approx(math.pi * a**2, rel=close)
    assert found.peak_pressure == pytest.approx(peak, rel=0.01)
    assert 0.0 < found.area_error < 0.1 * found.area
    assert found.patch_count == 1.0
    assert found.largest_patch == pytest.approx(found.area, rel=1e-12)
    # of Hertz's pressure the share (1 - (p / p0)^2) of the contact lies above p
    np.testing.assert_allclose(found.pressure_quantiles([0.25, 0.5]) / peak, np.sqrt([0.25, 0.5]), atol=0.8 / across)


def test_westergaards_wave_across_the_pixels():
    """a / wavelength = 2 / pi asin sqrt(p / p*), and the pressure rises to 2 sqrt(p p*) (Johnson 1985, 13.2)."""
    x, wave = np.arange(128) / 128, math.hypot(7, 4)
    heights = 0.01 * np.cos(2.0 * np.pi * (7.0 * x[:, None] + 4.0 * x))
    shares = np.array([0.1, 0.3, 0.8])
    full = np.pi * 0.01 * wave
    contact = SurfaceContact(Topography(heights, [1.0, 1.0], periodic=True), UNIT, Force(shares * full))
    found = TrueArea(contact).solve()
    np.testing.assert_allclose(found.area, 2.0 / np.pi * np.arcsin(np.sqrt(shares)), rtol=0.02)
    np.testing.assert_allclose(found.peak_pressure, 2.0 * full * np.sqrt(shares), rtol=0.012)
    assert found.patch_count.tolist() == [1.0, 1.0, 1.0]  # seven by four crests are one stripe round the torus
    assert np.all(np.abs(found.area - 2.0 / np.pi * np.arcsin(np.sqrt(shares))) <= found.area_error)


def refined(heights, times):
    """The same waves on a finer grid."""
    count = heights.shape[0]
    waves = np.fft.fftshift(np.fft.fft2(heights))
    edge = (times - 1) * count // 2
    return np.fft.ifft2(np.fft.ifftshift(np.pad(waves, edge))).real * times**2


@pytest.mark.slow
def test_four_pixels_a_wave():
    """The shortest wave has four pixels; beside the counted pixels of a grid eight times as fine, extrapolated.

    Counted pixels err in proportion to the pixel (first order), so that 2 A(1/8) - A(1/4) is free of it.
    """
    count = 96
    surface = random_topography(SelfAffine(0.8, 1e-2, 1.0, 4.001 / count), (count, count), [1.0, 1.0], seed=1)
    loads = np.array([0.1, 0.3]) * surface.rms_slope

    def counted(times):
        heights = refined(surface.heights, times)
        fine = Topography(heights, [1.0, 1.0], periodic=True)
        return np.array(
            [np.mean(SurfaceContact(fine, UNIT, Force(load)).solve().last.pressure > 0.0) for load in loads.tolist()]
        )

    found = TrueArea(SurfaceContact(surface, UNIT, Force(loads))).solve()
    fine, medium = counted(8), counted(4)
    np.testing.assert_allclose(found.area, 2.0 * fine - medium, rtol=0.01)
    assert np.all(counted(1) > 1.04 * fine)  # what was taken off


def test_patches_and_distributions():
    """Nine balls of three heights under a small load."""
    x = np.arange(90) % 30 - 14.5
    ball = np.minimum(x[:, None] ** 2 + x**2, 150.0) / 2000.0
    steps = np.kron(np.array([[0.0, 0.01, 0.02]] * 3), np.ones((30, 30)))
    surface = Topography(-ball - steps, [90.0, 90.0])
    found = TrueArea(SurfaceContact(surface, UNIT, Depth([0.008, 0.05]))).solve()
    areas = found.patches()
    assert found.patch_count.tolist() == [3.0, 9.0]
    assert areas.size == 9
    assert np.all(np.diff(areas) <= 0.0)
    assert areas.sum() == pytest.approx(found.area[1], rel=1e-12)
    assert found.largest_patch[1] == areas[0]
    closed = np.mean(found.contact.last.pressure > 0.0)
    gaps = found.gap_quantiles([0.0, 0.9 * closed, 1.0])
    assert gaps[0] == gaps[1] == 0.0
    assert gaps[2] == found.contact.last.separation.max()
    statements = [note.statement for note in found.validity if note.assumption is Assumption.RESOLUTION]
    assert any("every second point" in statement for statement in statements)
    assert not any("pixels wide" in statement for statement in statements)


def test_periodic_patches_are_joined_across_the_border():
    x = np.arange(64) / 64
    crossing = Topography(
        0.01 * (np.cos(2.0 * np.pi * x)[:, None] + np.cos(2.0 * np.pi * x)), [1.0, 1.0], periodic=True
    )
    assert TrueArea(SurfaceContact(crossing, UNIT, Force(1e-3))).solve().patch_count == 1.0


def test_maps_without_a_second_grid_are_refused():
    small = Topography(np.eye(6), [1.0, 1.0])
    with pytest.raises(InvalidInput, match="every second point"):
        TrueArea(SurfaceContact(small, UNIT, Force(1.0)))
    odd = Topography(np.random.default_rng(0).random((9, 10)), [1.0, 1.0], periodic=True)
    with pytest.raises(InvalidInput, match="even numbers"):
        TrueArea(SurfaceContact(odd, UNIT, Force(1.0)))
