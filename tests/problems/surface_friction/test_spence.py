"""A ball that is pressed on a dissimilar body: Spence's stick radius, pressures and tractions acting on each other.

While the load grows the contact stays similar to itself.  What a little more load adds is then the contact of a flat
punch (Spence): where it sticks nothing is added to the displacement along the surface, and where it slips the traction
is mu p; the stick radius is that with which what is added has no singularity at its end.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

import winkler as wk

POISSON = 0.3
BETA = (1.0 - 2.0 * POISSON) / (2.0 * (1.0 - POISSON))
SHEAR = 0.5 * (1.0 - POISSON)
"""With E* = 1 of a body against a rigid one."""
RINGS = 60
EDGES = np.sin(np.linspace(0.0, 0.5 * np.pi, RINGS + 1))
MIDDLES = np.sin(0.5 * np.pi * (np.arange(RINGS) + 0.5) / RINGS)
AREAS = np.pi * np.diff(EDGES**2)


def sunk(radius: float) -> np.ndarray:
    """Return how deep a unit of pressure on a disc presses the rings (Johnson, 3.4.2)."""
    inner, outer = np.minimum(MIDDLES / radius, 1.0), np.minimum(radius / MIDDLES, 1.0 - 1e-15)
    beyond = MIDDLES * (ellipe(outer**2) - (1.0 - outer**2) * ellipk(outer**2))
    return 4.0 / np.pi * np.where(radius > MIDDLES, radius * ellipe(inner**2), beyond)


def pulled() -> np.ndarray:
    """Return how far radial tractions on each ring move the others: int J1(kr) J1(ks) dk is 2 (K - E) / (pi r)."""
    x, weights = np.polynomial.legendre.leggauss(12)
    place = 0.5 * (x + 1.0)
    matrix = np.zeros((RINGS, RINGS))
    for j in range(RINGS):
        for i in range(RINGS):
            own = i == j  # a logarithm, at the middle: approached with the cube of the place
            starts, ends = ([MIDDLES[i]] * 2, EDGES[j : j + 2]) if own else (EDGES[j : j + 1], EDGES[j + 1 : j + 2])
            for start, end in zip(starts, ends, strict=True):
                s = start + (end - start) * place ** (3 if own else 1)
                step = 0.5 * weights * abs(end - start) * (3.0 * place**2 if own else 1.0)
                low, high = np.minimum(MIDDLES[i], s), np.maximum(MIDDLES[i], s)
                square = (low / high) ** 2
                matrix[i, j] += np.sum(2.0 / (np.pi * low) * (ellipk(square) - ellipe(square)) * s * step)
    return matrix * (1.0 - POISSON) / SHEAR


def system() -> np.ndarray:
    """Return displacements, down and outwards, under pressures and outward tractions on the rings."""
    normal = np.stack([sunk(EDGES[k + 1]) - (sunk(EDGES[k]) if k else 0.0) for k in range(RINGS)], 1)
    inside = 0.5 * np.maximum(np.minimum(MIDDLES[:, None], EDGES[1:]) ** 2 - EDGES[:-1] ** 2, 0.0)
    drawn = -(1.0 - 2.0 * POISSON) / (2.0 * SHEAR) * inside / MIDDLES[:, None]
    lifted = (drawn * AREAS[:, None]).T / AREAS[:, None]  # Betti
    return np.block([[normal, lifted], [drawn, pulled()]])


@pytest.fixture(scope="module")
def compliance() -> np.ndarray:
    return system()


def friction_of(compliance: np.ndarray, sticking: int, *, coupled: bool) -> float:
    """Return the coefficient with which so many rings stick; uncoupled, tractions do not change the pressures."""

    def singular(mu: float) -> float:
        matrix = compliance.copy()
        if not coupled:
            matrix[:RINGS, RINGS:] = 0.0
        for i in range(sticking, RINGS):
            matrix[RINGS + i] = 0.0
            matrix[RINGS + i, [RINGS + i, i]] = 1.0, -mu
        both = np.linalg.solve(matrix, np.repeat([1.0, 0.0], RINGS))
        spare = (mu * both[:RINGS] - both[RINGS:])[sticking - 6 : sticking - 1]
        deep = np.sqrt(EDGES[sticking] ** 2 - MIDDLES[sticking - 6 : sticking - 1] ** 2)
        terms = np.stack([np.ones_like(deep), deep**2, deep**3], 1)
        return float(np.linalg.lstsq(terms, spare * deep, rcond=None)[0][0])

    return float(brentq(singular, 0.05, 0.6))


def test_the_rings_stick_as_mossakovskii_and_spence_have_it(compliance):
    both = np.linalg.solve(compliance, np.repeat([1.0, 0.0], RINGS))
    free = np.linalg.solve(compliance[:RINGS, :RINGS], np.ones(RINGS))
    assert both[:RINGS] @ AREAS / (free @ AREAS) == pytest.approx(math.atanh(BETA) / BETA, rel=1e-4)
    for sticking in (21, 30, 39):  # a/2c ln((a + c)/(a - c)) = mu/beta K'(c/a)
        c = EDGES[sticking]
        left = math.log((1.0 + c) / (1.0 - c)) / (2.0 * c)
        mu = friction_of(compliance, sticking, coupled=False)
        assert mu == pytest.approx(BETA * left / ellipk(1.0 - c * c), rel=2e-3)
        assert friction_of(compliance, sticking, coupled=True) > 1.03 * mu


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("sticking", [21, 30])
def test_a_ball_pressed_in_steps(compliance, sticking):
    """65 x 65 pixels, forces in equal ratios: the stick radius errs in proportion to the steps."""
    medium, mu = wk.HalfSpace.between(wk.Elastic(1.0, POISSON)), friction_of(compliance, sticking, coupled=True)
    force = 4.0 / 3.0 * medium.modulus * 0.1**3
    ball = wk.SampledProfile([0.25, 0.25], wk.Paraboloid(1.0), (65, 65))
    radii = []
    for count in (20, 40, 80):
        path = wk.Path.through(wk.Force(force * np.geomspace(5e-3, 1.0, count)), wk.ShearForce(0.0))
        pressed = wk.SurfaceTangential(ball, medium, wk.Coulomb(mu), path).solve()
        radii.append(math.sqrt(np.mean(pressed.stick_share[-5:])))
    expected = EDGES[sticking]
    assert np.all(np.diff(np.abs(np.array(radii) - expected)) < 0.0)
    assert radii[2] == pytest.approx(expected, rel=1e-2)
    assert 2.0 * radii[2] - radii[1] == pytest.approx(expected, rel=1.5e-2)
