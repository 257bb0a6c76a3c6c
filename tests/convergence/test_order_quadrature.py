"""Gauss' rules on analytic integrands: digits grow in proportion to the number of points, at the rate of theory.

With the nearest singularity z of the integrand on the Bernstein ellipse rho = |z + sqrt(z^2 - 1)| (interval [-1, 1])
the error falls like rho^(-2n).  `settled` climbs its rungs by this rate, and by that of the double-exponential rule
where the end of the interval is singular.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.numerics.integrals.adaptive_quadrature import RULE_LADDER, settled
from winkler.numerics.integrals.quadrature import gauss_legendre, tanh_sinh

FOUR = tuple(
    np.concatenate(parts)
    for parts in zip(*(((k + gauss_legendre(48)[0]) / 4.0, gauss_legendre(48)[1] / 4.0) for k in range(4)), strict=True)
)
"""Nodes and weights of four panels of 48 points."""


def bernstein(place: complex) -> float:
    """Return rho of a singularity at `place`, for the interval from 0 to 1."""
    z = 2.0 * complex(place) - 1.0
    root = np.sqrt(z * z - 1.0)
    return float(max(abs(z + root), abs(z - root)))


def rate(counts, errors) -> float:
    """Return rho of error ~ rho^(-2 n)."""
    return math.exp(-0.5 * np.polyfit(np.asarray(counts, dtype=float), np.log(errors), 1)[0])


@pytest.mark.parametrize("pole", [1.05, 1.3, -0.2])
def test_gauss_converges_at_the_rate_of_the_nearest_pole(pole):
    exact = math.log(abs((1.0 - pole) / pole))
    counts = [n for n in range(4, 26, 2) if bernstein(pole) ** (-2 * n) > 1e-13]
    errors = []
    for n in counts:
        nodes, weights = gauss_legendre(n)
        errors.append(abs(weights @ (1.0 / (nodes - pole)) - exact) / abs(exact))
    assert rate(counts, errors) == pytest.approx(bernstein(pole), rel=0.03)


@pytest.mark.parametrize("part", [0.5, 0.9, 0.98])
def test_the_transform_of_a_sphere_converges_geometrically(part):
    """g(x)/x = Int f'(x sin t) dt has branch points where sin t = R/x: t = pi/2 +- i arcosh(R/x)."""
    exact = math.atanh(part)
    rho = bernstein(1.0 + 2.0j / math.pi * math.acosh(1.0 / part))
    counts = [n for n in range(3, 60, 2) if rho ** (-2 * n) > 1e-13]
    errors = []
    for n in counts:
        nodes, weights = gauss_legendre(n)
        slope = wk.Sphere(1.0).slope(part * np.sin(0.5 * math.pi * nodes))
        errors.append(abs(0.5 * math.pi * slope @ weights - exact))
    assert rate(counts, errors) == pytest.approx(rho, rel=0.05)


def rungs(integrand, count: int = 1) -> tuple[np.ndarray, list[int]]:
    """Return the settled integrals and the numbers of points that were tried."""
    tried = []

    def watched(nodes, index):
        tried.append(len(nodes))
        return integrand(nodes, index)

    return settled(watched, count, "test"), tried


@pytest.mark.parametrize(
    ("pole", "last"),
    [(-3.0, 24), (-0.3, 48), (-0.05, 96)],
)
def test_the_ladder_is_climbed_as_far_as_the_pole_demands(pole, last):
    result, tried = rungs(lambda nodes, index: np.tile(1.0 / (nodes - pole), (len(index), 1)))
    assert result[0] == pytest.approx(math.log((1.0 - pole) / -pole), rel=1e-12)
    assert tried == [points for _, points in RULE_LADDER][: len(tried)]
    assert tried[-1] == last
    # the rung before the last already had all digits: that is how the last one knew
    assert bernstein(pole) ** (-2 * tried[-2]) < 1e-12
    if len(tried) > 2:
        assert bernstein(pole) ** (-2 * tried[-3]) > 1e-15


@pytest.mark.parametrize("pole", [-0.02, -0.005, -0.001])
def test_a_pole_close_to_the_end_is_left_to_the_double_exponential_rule(pole):
    result, tried = rungs(lambda nodes, index: np.tile(1.0 / (nodes - pole), (len(index), 1)))
    assert result[0] == pytest.approx(math.log((1.0 - pole) / -pole), rel=1e-14)
    assert RULE_LADDER[len(tried) - 1][0] == "double exponential"


def test_two_rules_that_share_their_error_are_no_two_witnesses():
    """Four panels of 48 points and one of 96 err alike at an end like t^p: by c 96^(-2 p - 2), to leading order."""
    powers = np.linspace(1.01, 3.99, 300)
    found, _ = rungs(lambda nodes, index: nodes ** powers[index, None], powers.size)
    np.testing.assert_allclose(found, 1.0 / (1.0 + powers), rtol=3e-14)
    shared = []
    for power in (1.4, 1.6):
        one, parts = (weights @ nodes**power * (1.0 + power) - 1.0 for nodes, weights in (gauss_legendre(96), FOUR))
        shared.append(parts / one)
    np.testing.assert_allclose(shared, 1.0, rtol=0.05)


@pytest.mark.parametrize("power", [0.5, -0.5, 0.1, -0.25])
def test_a_singular_end_is_left_to_the_double_exponential_rule(power):
    result, tried = rungs(lambda nodes, index: np.tile(nodes**power, (len(index), 1)))
    assert result[0] == pytest.approx(1.0 / (1.0 + power), rel=1e-11)
    assert RULE_LADDER[len(tried) - 1][0] == "double exponential"
    # Gauss' rule alone would converge with the power 2 (1 + power) only
    counts = np.array([12, 24, 48, 96])
    errors = [abs(gauss_legendre(n)[1] @ gauss_legendre(n)[0] ** power - 1.0 / (1.0 + power)) for n in counts]
    assert -np.polyfit(np.log(counts), np.log(errors), 1)[0] == pytest.approx(2.0 * (1.0 + power), rel=0.05)


@pytest.mark.parametrize(("function", "exact"), [(np.sqrt, 2.0 / 3.0), (np.log, -1.0), (lambda t: t**-0.5, 2.0)])
def test_the_double_exponential_rule_gains_digits_in_proportion_to_its_points(function, exact):
    """The window is fixed, so that the trapezoidal rule squares its error when the step is halved."""
    digits = []
    for count in (11, 21, 31):
        nodes, _, weights = tanh_sinh(count)
        digits.append(-math.log10(abs(weights @ function(nodes) - exact)))
    assert digits[0] > 2.0
    assert digits[1] > 1.9 * digits[0]
    assert digits[2] > 2.8 * digits[0]


def test_every_integral_of_many_climbs_on_its_own():
    poles = np.array([-3.0, -0.3, -0.05])
    open_ = []

    def integrand(nodes, index):
        open_.append(len(index))
        return 1.0 / (nodes - poles[index, None])

    result = settled(integrand, 3, "test")
    np.testing.assert_allclose(result, np.log((1.0 - poles) / -poles), rtol=1e-12)
    assert open_ == [3, 3, 2, 1]
