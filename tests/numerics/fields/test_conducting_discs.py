"""Discs that conduct: through a film, into a rod, side by side, and the field of one alone."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
from scipy.special import ellipe, ellipk, gamma, jn_zeros, jv

from winkler.numerics.fields.disc_charges import currents
from winkler.numerics.fields.disc_field import disc_potential, disc_slopes
from winkler.numerics.fields.filmed_disc import UNIFORM_FLUX_RATIO, spreading
from winkler.numerics.fields.flux_tube import relief


def uniform_disc(r, radius):
    """Voltage of a unit uniform flux over a disc, at the surface, with 1 / distance as kernel."""
    r = np.asarray(r, dtype=float)
    with np.errstate(divide="ignore", invalid="ignore"):
        inside = 4.0 * radius * ellipe(np.minimum(1.0, (r / radius) ** 2))
        m = np.minimum(1.0, (radius / np.maximum(r, 1e-300)) ** 2)
        outside = 4.0 * r * (ellipe(m) - (1.0 - m) * np.where(m < 1.0, ellipk(m), 0.0))
    return np.where(r <= radius, inside, outside)


@pytest.mark.parametrize("beta", [0.1, 1.0, 10.0])
def test_a_film_spreads_the_current_as_rings_do(beta):
    """Three-dimensional brute force: rings of even flux, one voltage behind the film."""
    edges = np.sin(0.5 * np.pi * np.linspace(0.0, 1.0, 301))
    middle = 0.5 * (edges[1:] + edges[:-1])
    columns = [
        uniform_disc(middle, outer) - (uniform_disc(middle, inner) if inner else 0.0)
        for inner, outer in zip(edges[:-1], edges[1:], strict=True)
    ]
    # (rho_1 + rho_2) / (2 pi) is one: a disc of one voltage has the resistance pi / 2
    matrix = np.array(columns).T + np.eye(middle.size) * beta * np.pi
    flux = np.linalg.solve(matrix, np.ones(middle.size))
    resistance = 1.0 / np.sum(flux * np.pi * np.diff(edges**2))
    assert (resistance - beta) / (0.5 * np.pi) == pytest.approx(float(spreading(np.array(beta))), abs=2e-4)


def test_a_film_moves_between_one_voltage_and_uniform_flux():
    beta = np.geomspace(1e-6, 1e8, 200)
    found = spreading(beta)
    assert np.all(np.diff(found) >= 0.0)
    assert spreading(np.array(0.0)) == 1.0
    assert found[0] == pytest.approx(1.0, abs=1e-5)
    assert found[-1] == pytest.approx(UNIFORM_FLUX_RATIO, rel=1e-9)
    # uniform flux over a disc: mean voltage 8 q a / (3 pi lambda) of two bodies
    assert float(32 / (3 * mp.pi**2)) == UNIFORM_FLUX_RATIO


@pytest.mark.parametrize("ratio", [0.05, 0.3, 0.6, 0.85])
def test_a_rod_constricts_as_little_as_the_best_flux_allows(ratio):
    """Galerkin's method over the eigenfunctions of the rod: an upper bound that settles."""
    zeros = jn_zeros(1, 6000)
    x = zeros * ratio
    fluxes = [2.0 ** (k - 0.5) * gamma(k + 0.5) * jv(k + 0.5, x) / x ** (k + 0.5) * ratio**2 for k in range(6)]
    whole = np.array([2.0 * np.pi * ratio**2 / (2.0 * k + 1.0) for k in range(6)])
    energy = np.array(
        [[np.sum(4.0 * np.pi * one * other / (zeros * jv(0, zeros) ** 2)) for other in fluxes] for one in fluxes]
    )
    energy[0, 0] += np.pi * ratio**2 / (zeros[-1] + 0.5 * np.pi)  # the sum beyond: sin^2 has the mean 1/2
    resistance = 1.0 / (whole @ np.linalg.solve(energy, whole))
    assert 4.0 * ratio * resistance == pytest.approx(float(relief(np.array(ratio))), rel=1e-6)


def test_a_rod_relieves_a_narrow_contact_as_roess_stated():
    """The first coefficient of the series in a/b is 1.40925."""
    ratio = np.array([0.0, 1e-4])
    found = relief(ratio)
    assert found[0] == pytest.approx(1.0, abs=1e-13)
    assert (1.0 - found[1]) / 1e-4 == pytest.approx(1.40925, abs=1e-5)
    assert np.all(np.diff(relief(np.linspace(0.0, 0.9, 300))) < 0.0)
    assert np.all(np.abs(relief(np.linspace(0.0, 0.5, 50)) / (1.0 - np.linspace(0.0, 0.5, 50)) ** 1.5 - 1.0) < 0.05)


def test_two_discs_far_apart_share_as_point_charges_of_finite_size():
    """The mean of 1 / distance over two flux distributions is (1 + (a^2 + b^2) / (6 s^2)) / s, up to s^-5."""
    a, b = 1.0, 0.5
    for s in (20.0, 40.0):
        mutual = (1.0 + (a * a + b * b) / (6.0 * s * s)) / s
        matrix = np.array([[np.pi / (2.0 * a), mutual], [mutual, np.pi / (2.0 * b)]])
        expected = np.linalg.solve(matrix, np.ones(2))
        found, _ = currents(np.array([0.0, s]), np.zeros(2), np.array([a, b]), 4)
        assert found == pytest.approx(expected, rel=1.2 / s**4)


def test_discs_settle_geometrically():
    x, y, radii = np.array([0.0, 1.0, 0.4]), np.array([0.0, 0.0, 0.8]), np.array([0.4, 0.35, 0.3])
    finest = np.sum(currents(x, y, radii, 10)[0])
    error = [abs(np.sum(currents(x, y, radii, degree)[0]) / finest - 1.0) for degree in (2, 4, 6)]
    stated = [abs(np.subtract(*map(np.sum, currents(x, y, radii, degree)))) / finest for degree in (2, 4, 6)]
    assert error[1] < 0.2 * error[0]
    assert error[2] < 0.2 * error[1]
    assert np.all(np.array(error) < stated)


def test_one_disc_has_its_capacity():
    assert currents(np.zeros(1), np.zeros(1), np.array([3.0]), 6)[0] == pytest.approx([6.0 / np.pi], rel=1e-13)


@pytest.mark.parametrize(("r", "z"), [(0.0, 0.3), (0.7, 1e-3), (0.999, 1e-6), (1.5, 0.2), (30.0, 4.0)])
def test_the_field_of_a_disc_to_all_digits(r, z):
    with mp.workdps(30):

        def theta(r, z):
            l2 = (mp.sqrt((r - 1) ** 2 + z**2) + mp.sqrt((r + 1) ** 2 + z**2)) / 2
            return 2 / mp.pi * mp.asin(1 / l2)

        place = (mp.mpf(r), mp.mpf(z))
        expected = theta(*place)
        down = mp.diff(lambda depth: theta(place[0], depth), place[1], h=mp.mpf("1e-12") * 1)
        out = mp.diff(lambda path: theta(path, place[1]), place[0], h=mp.mpf("1e-12")) if r else mp.mpf(0)
    found = disc_slopes(np.array([r]), np.array([z]), 1.0)
    assert disc_potential(np.array([r]), np.array([z]), 1.0)[0] == pytest.approx(float(expected), rel=1e-14)
    assert found[0][0] == pytest.approx(float(out), rel=1e-6, abs=1e-12)
    assert found[1][0] == pytest.approx(float(down), rel=1e-6)
