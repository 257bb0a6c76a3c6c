"""Stresses below maps of loads agree with point forces, with closed forms, and with each other."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from winkler.media.interior.half_ellipsoid import greatest_in_half_ellipsoid, half_ellipsoid_stresses
from winkler.media.interior.map_field import MapField
from winkler.media.interior.map_peak import greatest_below
from winkler.media.interior.periodic_map_field import PeriodicMapField
from winkler.media.interior.tensor import von_mises

sys.path.insert(0, str(Path(__file__).parents[2] / "reference"))
from ledger_solutions import boussinesq, cerruti

PIXEL, SHAPE, NU = (0.7, 1.1), (7, 5), 0.28
EXCHANGED = [1, 0, 2, 3, 5, 4, 7, 6, 8]
RANDOM = np.random.default_rng(5)


def random_map(*shape):
    loads = np.zeros((3, *shape))
    loads[:, 1:-1, 1:] = RANDOM.normal(size=(3, shape[0] - 2, shape[1] - 1))
    return loads


def middles(shape, pixel):
    return np.meshgrid(*((np.arange(n) + 0.5) * size for n, size in zip(shape, pixel, strict=True)), indexing="ij")


def hill(count, ratio):
    """A half-ellipsoid of semi-axes 1 and `ratio` as means over the pixels of a square of 2.2."""
    fine = (np.arange(8 * count) + 0.5) * 2.2 / (8 * count) - 1.1
    height = np.sqrt(np.maximum(1.0 - fine[:, None] ** 2 - (fine / ratio) ** 2, 0.0))
    return height.reshape(count, 8, count, 8).mean(axis=(1, 3))


@pytest.mark.parametrize("place", [(2.0, 3.1, 0.5), (4.9, 0.2, 1.3), (9.0, -2.0, 4.0)])
def test_stresses_are_sums_of_point_forces(place):
    """Boussinesq's and Cerruti's forces, by Gauss' rule over each pixel."""
    loads = random_map(*SHAPE)
    node, weight = np.polynomial.legendre.leggauss(24)
    x = (np.arange(SHAPE[0])[:, None] + 0.5 * (node + 1.0)).ravel() * PIXEL[0]
    y = (np.arange(SHAPE[1])[:, None] + 0.5 * (node + 1.0)).ravel() * PIXEL[1]
    measure = 0.25 * PIXEL[0] * PIXEL[1] * np.outer(np.tile(weight, SHAPE[0]), np.tile(weight, SHAPE[1]))
    fine = np.repeat(np.repeat(loads, node.size, axis=1), node.size, axis=2) * measure
    away = place[0] - x[:, None], place[1] - y[None, :]
    pressed = boussinesq(*away, place[2], NU)
    along = cerruti(*away, place[2], NU)
    across = cerruti(*away[::-1], place[2], NU)[EXCHANGED[:6]]
    expected = np.einsum("kij,ij->k", pressed, fine[0]) + np.einsum("kij,ij->k", along, fine[1])
    expected += np.einsum("kij,ij->k", across, fine[2])
    found = MapField(loads, PIXEL, NU).at_places(np.array([place]))[:6, 0]
    np.testing.assert_allclose(found, expected, atol=1e-9 * np.abs(expected).max())


def test_contact_gives_the_same_digits_below_a_square(shared_data):
    """CONTACT's closed integrals for one element under pressure and shear, six digits printed."""
    field = MapField(np.array([1.0, 0.999, 0.0])[:, None, None], (1.0, 1.0), 0.28)
    for name in ("axis", "plane"):
        file = shared_data / "reference" / "contact" / f"subsurface_square_{name}.csv"
        lines = [line for line in file.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
        table = np.genfromtxt(lines, delimiter=",", names=True)
        places = np.stack([table["x"] + 0.4999, table["y"] + 0.4998, table["z"]], axis=1)
        found = field.at_places(places) / np.array([1, 1, 1, 1, 1, 1, 2, 2, 2])[:, None]  # G = 1
        names = [*(f"stress_{part}" for part in ("xx", "yy", "zz", "xy", "xz", "yz")), "ux", "uy", "uz"]
        for part, own in zip(names, found, strict=True):
            np.testing.assert_allclose(own, table[part], rtol=1.1e-5, atol=1.1e-6, err_msg=part)


def test_depths_lines_and_places_agree():
    loads = random_map(*SHAPE)
    x, y = middles(SHAPE, PIXEL)
    for field in (MapField(loads, PIXEL, NU), PeriodicMapField(loads, PIXEL, NU)):
        for z in (0.0, 0.3, 2.0):
            at = np.stack([x.ravel(), y.ravel(), np.full(x.size, z)], axis=1)
            summed = field.at_places(at).reshape(9, *SHAPE)
            np.testing.assert_allclose(field.at_depth(z), summed, atol=1e-12)
            np.testing.assert_allclose(field.across(y[0, 2], z), summed[:, :, 2], atol=1e-12)
            turned = field.exchanged().at_depth(z)[EXCHANGED].transpose(0, 2, 1)
            np.testing.assert_allclose(turned, summed, atol=1e-12)


def test_a_map_repeated_often_is_periodic():
    """Waves of pressure and traction, 9 by 9 periods that stand alone against one that is repeated."""
    count, times = 12, 9
    x, y = middles((count * 4, count * 4), (0.25 / count, 0.25 / count))
    waves = [np.cos(2 * np.pi * x * k + a) * np.cos(2 * np.pi * y + 2 * a) for k, a in ((1, 0.3), (2, 1.0), (1, 2.0))]
    alone = MapField(np.tile(waves, (1, times, times)), (0.25 / count, 0.25 / count), NU)
    periodic = PeriodicMapField(np.array(waves), (0.25 / count, 0.25 / count), NU)
    places = np.array([[4.2, 4.3, 0.15], [4.77, 4.5, 0.3], [4.05, 4.61, 0.2]])
    found, expected = alone.at_places(places), periodic.at_places(places)
    np.testing.assert_allclose(found[:6], expected[:6], atol=2e-3)
    np.testing.assert_allclose(found[6:], expected[6:], atol=2e-3)


def test_each_plane_bears_the_load():
    """Minus the integral of sigma_zz over a plane is the force, those of sigma_xz and sigma_yz the tractions'."""
    loads = np.zeros((3, 60, 60))
    loads[:, 28:32, 29:32] = RANDOM.normal(size=(3, 4, 3)) + 1.0
    field = MapField(loads, (0.5, 0.5), NU)
    assert field.at_depth(0.8)[2].sum() == pytest.approx(-loads[0].sum(), rel=1e-3)
    periodic = PeriodicMapField(loads, (0.5, 0.5), NU).at_depth(0.8)
    np.testing.assert_allclose([periodic[part].sum() for part in (2, 4, 5)], -loads.sum(axis=(1, 2)), rtol=1e-11)


@pytest.mark.parametrize(("ratio", "traction"), [(1.0, (0.0, 0.0)), (0.4, (0.2, 0.1))])
def test_a_half_ellipsoid_is_approached_with_the_square_of_the_pixel(ratio, traction):
    places = np.array([[0.3, 0.1, 0.4], [0.9, 0.2, 0.3], [1.3, 0.5, 0.6]])
    expected = np.array(half_ellipsoid_stresses(*places.T, (1.0, ratio), 0.3, traction))
    errors = []
    for count in (32, 64, 128):
        pressure = hill(count, ratio)
        field = MapField(np.stack([pressure, *(part * pressure for part in traction)]), (2.2 / count,) * 2, 0.3)
        errors.append(np.abs(field.at_places(places + np.array([1.1, 1.1, 0.0]))[:6] - expected).max())
    assert errors[2] < 2e-4
    assert errors[0] / errors[1] > 3.0
    assert errors[1] / errors[2] > 3.0


@pytest.mark.few(1)
@pytest.mark.parametrize(("ratio", "traction"), [(1.0, (0.0, 0.0)), (0.4, (0.0, 0.0)), (0.4, (0.2, 0.0))])
def test_the_greatest_stress_is_that_of_the_half_ellipsoid(ratio, traction):
    expected = greatest_in_half_ellipsoid(von_mises, ratio, 0.3, traction)
    pressure = hill(64, ratio)
    field = MapField(np.stack([pressure, *(part * pressure for part in traction)]), (2.2 / 64,) * 2, 0.3)
    (found,) = greatest_below(field, climbed=True).greatest
    assert found.value == pytest.approx(expected.value, rel=1.5e-3)
    np.testing.assert_allclose(
        [found.x - 1.1, found.y - 1.1, found.z], [expected.x, ratio * expected.y, ratio * expected.z], atol=1e-3
    )


@pytest.mark.slow
def test_a_large_map_is_searched_on_means():
    """A ball of 180 pixels across: the greatest stress is Hertz's 0.620 p0 at 0.481 radii for nu = 0.3."""
    x = (np.arange(198) + 0.5) / 90.0 - 1.1
    pressure = np.sqrt(np.maximum(1.0 - x[:, None] ** 2 - x**2, 0.0))
    field = MapField(np.stack([pressure, 0.0 * pressure, 0.0 * pressure]), (1 / 90.0,) * 2, 0.3)
    (found,) = greatest_below(field, climbed=True).greatest
    expected = greatest_in_half_ellipsoid(von_mises, 1.0, 0.3)
    assert found.value == pytest.approx(expected.value, rel=1e-4)
    assert found.z == pytest.approx(expected.z, rel=1e-3)
