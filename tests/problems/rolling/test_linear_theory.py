"""Kalker's linear theory: closed forms, his printed table, CONTACT's grids extrapolated, the boundary elements."""

from __future__ import annotations

import csv
import math

import numpy as np
import pytest

import winkler as wk
from winkler.numerics.surfaces.rolled_surface import roll
from winkler.numerics.surfaces.traction_grid import Compliance, TractionGrid
from winkler.problems.rolling import linear_theory
from winkler.problems.rolling.kalker import ACROSS, ALONG
from winkler.values.errors import NotConverged, OutsideValidity

WORDS = ("longitudinal", "lateral", "spin", "turning")


def coefficients(ratio: float, nu: float) -> np.ndarray:
    found = wk.linear_creep_coefficients(ratio, nu)
    return np.array([getattr(found, word) for word in WORDS])


def test_a_circle_without_poisson_s_ratio():
    """Directions are parted: sum k_j U_j(y) = -2 sqrt(1 - y^2) on the leading edge, F = 2 k_0, M = 4/3."""
    found = wk.linear_creep_coefficients(1.0, 0.0)
    assert found.longitudinal == pytest.approx(32.0 / (3.0 * math.pi), rel=1e-8)
    assert found.lateral == pytest.approx(32.0 / (3.0 * math.pi), rel=1e-8)
    assert found.spin == pytest.approx(4.0 / 3.0, rel=1e-12)
    assert found.error < 1e-5


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("ratio", "nu"), [(0.1, 0.0), (0.5, 0.25), (1.0, 0.5), (3.0, 0.3), (10.0, 0.0)])
def test_the_error_is_an_upper_one(ratio, nu, monkeypatch):
    """Beside four times as many polynomials."""
    found = wk.linear_creep_coefficients(ratio, nu)
    monkeypatch.setattr(linear_theory, "FIRST_DEGREE", 64)
    linear_theory._solved.cache_clear()
    better = coefficients(ratio, nu)
    linear_theory._solved.cache_clear()
    assert np.max(np.abs([getattr(found, word) for word in WORDS] / better - 1.0)) <= found.error <= 1e-5


@pytest.mark.parametrize("row", [pytest.param(k, marks=() if k in (1, 4, 9) else pytest.mark.slow) for k in range(10)])
def test_beside_the_printed_table(row):
    """Kalker's numbers of 1967, rounded to three digits, are off by at most 0.8 % from b/a = 0.2 on, 1.3 % at 0.1."""
    slender = (row + 1) / 10.0
    for ratio, table in ((slender, ACROSS), (1.0 / slender, ALONG)):
        for column, nu in enumerate((0.0, 0.25, 0.5)):
            printed = table[row, [column, 3 + column, 6 + column]]
            np.testing.assert_allclose(coefficients(ratio, nu)[:3], printed, rtol=8.5e-3 if row else 1.3e-2)


@pytest.mark.parametrize("nu", [0.0, 0.25, 0.3, 0.5])
def test_beside_contact_on_circles(shared_data, nu):
    """Straight lines through 24 to 144 elements: within 0.2 %; c33, whose grids scatter by 0.5 %, within 0.7 %."""
    with (shared_data / "reference" / "creep_coefficients_circle.csv").open() as file:
        rows = [row for row in csv.DictReader(file) if float(row["nu"]) == nu]
    element = [1.0 / float(row["n"]) for row in rows]
    limits = [np.polyfit(element, [float(row[name]) for row in rows], 1)[1] for name in ("C11", "C22", "C23", "C33")]
    assert np.all(np.abs(coefficients(1.0, nu) / limits - 1.0) < [2e-3, 2e-3, 2e-3, 7e-3])


@pytest.mark.slow
@pytest.mark.parametrize("nu", [0.0, 0.25, 0.5])
def test_narrow_along_rolling(nu):
    """Kalker's limit g = a/b -> 0, strips in plane strain: the next terms are of the order of g squared times logs."""
    g = 0.02
    limits = np.array(
        [
            math.pi**2 / (4.0 * (1.0 - nu)),
            math.pi**2 / 4.0,
            math.pi
            * math.sqrt(g)
            / (3.0 * (1.0 - nu))
            * (1.0 + nu * (0.5 * math.log(16.0 / g**2) + math.log(4.0) - 5.0)),
            math.pi**2 / (16.0 * (1.0 - nu) * g),
        ]
    )
    assert np.all(np.abs(coefficients(g, nu) / limits - 1.0) < [3e-3, 3e-3, 4e-3, 8e-3])


@pytest.mark.slow
@pytest.mark.parametrize("nu", [0.0, 0.25, 0.5])
def test_long_along_rolling(nu):
    """Kalker's limit g = b/a -> 0; the second power of 1/log(16/g^2) is left out of the forces."""
    g, log = 0.02, math.log(16.0 / 0.02**2)
    scales = np.array([log - 2.0 * nu, (1.0 - nu) * log + 2.0 * nu])
    forces = 2.0 * math.pi / (g * scales) * (1.0 + np.array([1.0, 1.0 - nu]) * (3.0 - math.log(4.0)) / scales)
    spin = 2.0 * math.pi / (3.0 * g**1.5 * ((1.0 - nu) * log - 2.0 + 4.0 * nu))
    found = coefficients(50.0, nu)
    assert found[:2] == pytest.approx(forces, rel=4.0 / log**2)
    assert found[2] == pytest.approx(spin, rel=3e-3)


@pytest.mark.long
def test_beside_boundary_elements_of_randomly_placed_pixels():
    """Grids of 20, 40 and 80 pixels, scaled to the area of their pixels, extrapolated: forces within 0.05 %."""
    ratio, nu = 0.6, 0.28
    a, b, means = math.sqrt(ratio), 1.0 / math.sqrt(ratio), []
    offsets = np.random.default_rng(1).uniform(-0.5, 0.5, (3, 16, 2))
    for count, places in zip((20, 40, 80), offsets, strict=True):
        pixel = 2.0 * a / count, 2.0 * b / count
        grid = TractionGrid.of((count + 4, count + 4), pixel, Compliance(1.0, nu / (1.0 - nu)), periodic=False)
        found = []
        for place in places:
            rows = np.arange(count + 4) - 0.5 * (count + 3)
            x, y = np.meshgrid((rows + place[0]) * pixel[0], (rows + place[1]) * pixel[1], indexing="ij")
            bound = np.where((x / a) ** 2 + (y / b) ** 2 < 1.0, 1e9, 0.0)
            area = pixel[0] * pixel[1] * np.count_nonzero(bound) / math.pi
            matrix = np.zeros((3, 3))
            for i, (xi, eta, phi) in enumerate(np.eye(3)):
                rigid = pixel[0] * np.stack((xi - phi * y, eta + phi * x))
                traction = roll(grid, bound, rigid, np.zeros_like(rigid), tolerance=1e-10).traction
                matrix[i] = *traction.sum((1, 2)), np.sum(x * traction[1] - y * traction[0])
            c = [matrix[0, 0] / area, matrix[1, 1] / area, matrix[2, 1] / area**1.5, matrix[2, 2] / area**2]
            found.append(np.array(c) * pixel[0] * pixel[1] / (1.0 - nu))
        means.append(np.mean(found, axis=0))
    limit = 2.0 * means[2] - means[1]
    assert np.all(np.abs(limit / coefficients(ratio, nu) - 1.0) < [5e-4, 5e-4, 2e-3, 4e-3])


@pytest.mark.parametrize(("ratio", "nu", "sentence"), [
    (0.01, 0.3, "ratio of the semi-axes, .* is 0.01; give one from 0.02 to 50"),
    (math.nan, 0.3, "ratio of the semi-axes, .* is nan"),
    (1.0, 0.6, "Poisson's ratio is 0.6; give one above -1 and up to 0.5"),
    (1.0, -1.0, "Poisson's ratio is -1"),
])  # fmt: skip
def test_what_it_refuses(ratio, nu, sentence):
    with pytest.raises(OutsideValidity, match=sentence):
        wk.linear_creep_coefficients(ratio, nu)


def test_too_few_polynomials(monkeypatch):
    monkeypatch.setattr(linear_theory, "LAST_DEGREE", 32)
    linear_theory._solved.cache_clear()
    with pytest.raises(NotConverged, match="at a ratio of the semi-axes of 0.02 .* of degree 32; .* nearer to one"):
        wk.linear_creep_coefficients(0.02, 0.5)
    linear_theory._solved.cache_clear()
