"""Displacements of pixels on layers, against Hankel's integral over Burmister's closed form, point by point."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import j0

import winkler as wk
from winkler.numerics.pixels.layered import LayeredSurface
from winkler.numerics.surfaces.surface_grid import SurfaceGrid
from winkler.numerics.transforms.cosine_transform import in_own_lengths


def surface(young, poisson, thickness, on):
    medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, poisson), thickness)], on=on)
    return LayeredSurface(*in_own_lengths(medium.response))


def burmister(x, poisson, base_poisson, ratio):
    """M of one layer at x = xi h; ratio is G of the layer over that of the base (Burmister 1945)."""
    fade = np.exp(-2.0 * x)
    near = 1.0 - 4.0 * (1.0 - poisson) / (1.0 + ratio * (3.0 - 4.0 * base_poisson))
    far = (ratio - 1.0) / (ratio + 3.0 - 4.0 * poisson)
    above = 1.0 + 4.0 * x * far * fade - near * far * fade**2
    return above / (1.0 - (near + far + 4.0 * far * x**2) * fade + near * far * fade**2) - 1.0


def hankel(excess, thickness, r, wide):
    """(1 / pi) times the integral of M J0(xi r), by panels of at most a tenth of 1 / r and of 1 / h."""
    step = min(2.0 / wide, 0.5 / thickness)
    ends = np.unique(np.r_[0.0, np.geomspace(1e-9 * step, step, 60), np.arange(step, 20.0 / thickness + step, step)])
    node, weight = np.polynomial.legendre.leggauss(12)
    half = 0.5 * np.diff(ends)[:, None]
    xi = (0.5 * (ends[1:] + ends[:-1])[:, None] + half * node).ravel()
    return j0(np.multiply.outer(r, xi)) @ (excess(xi * thickness) * (half * weight).ravel()) / np.pi


PLACES = [(0, 0), (1, 0), (0, 1), (2, 3), (6, 7), (9, 2), (11, 25), (39, 29)]


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(
    ("ratio", "poisson", "thickness"), [(5.0, 0.3, 0.6), (1e-3, 0.5, 4.0), (1e3, 0.2, 1.5), (0.2, 0.0, 300.0)]
)
def test_pixels_on_a_layer(ratio, poisson, thickness):
    """Pixels 1 x 0.7, near and far, layers thin and thick against them and against the grid."""
    base = wk.Elastic(2.0 * 1.25, 0.25)  # G = 1
    found = surface(2.0 * ratio * (1.0 + poisson), poisson, thickness, base).pixels((40, 30), (1.0, 0.7))
    node, weight = np.polynomial.legendre.leggauss(14)
    for i, j in PLACES:
        r = np.hypot(i + 0.5 * node[:, None], 0.7 * (j + 0.5 * node))
        k = hankel(lambda x: burmister(x, poisson, 0.25, ratio), thickness, r, 60.0)
        want = 0.25 * 0.7 * np.sum(weight[:, None] * weight * k)
        assert found[i, j] == pytest.approx(want, rel=3e-10, abs=1e-13 * abs(found[0, 0]))


@pytest.mark.parametrize("thickness", [1e-2, 1e-4, 1e-6])
def test_a_film_much_thinner_than_the_pixels_is_compressed_below_them_alone(thickness):
    """u = p h (1 + nu) (1 - 2 nu) / (E (1 - nu)) under the pixel, to what cancels against Love's displacement."""
    film = surface(1.0, 0.3, thickness, wk.Rigid())
    pressure = np.zeros((24, 20))
    pressure[7, 9] = 1.0
    moved = SurfaceGrid.of(pressure.shape, (1.0, 1.3), periodic=False, layers=film).displaced(pressure)
    want = np.zeros(pressure.shape)
    want[7, 9] = thickness * 0.4 / (0.7 * 0.7)  # times E* = 1 / 0.91, (1 + nu) / 0.91 = 1 / 0.7
    np.testing.assert_allclose(moved, want, rtol=0.0, atol=1e-12)


def test_a_layer_of_the_same_solid_has_no_kernel():
    same = surface(3.0, 0.2, 0.1, wk.Elastic(3.0, 0.2)).pixels((30, 30), (1.0, 1.0))
    assert np.max(np.abs(same)) < 1e-13


def test_a_grid_of_another_unit_is_the_same():
    film = surface(5.0, 0.4, 2e-6, wk.Elastic(1.0, 0.3))
    small = film.pixels((20, 20), (1e-6, 2e-6))
    scaled = film.in_units_of(1e-6).pixels((20, 20), (1.0, 2.0))
    np.testing.assert_allclose(small, 1e-6 * scaled, rtol=1e-12)


def test_a_part_of_a_grid_has_the_pixels_of_the_whole():
    """Contacts are solved in boxes around them, whose kernels reach less far."""
    film = surface(1e-2, 0.45, 0.3, wk.Elastic(1.0, 0.3))
    whole, part = film.pixels((200, 90), (1.0, 1.0)), film.pixels((31, 60), (1.0, 1.0))
    np.testing.assert_allclose(part, whole[:31, :60], rtol=0.0, atol=1e-10 * abs(whole[0, 0]))
